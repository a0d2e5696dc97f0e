#!/usr/bin/env bash
# Runs the package's tests on the wheel with the oldest Python packages it says it works with: floors.sh PYTHON FOLDER
set -eu
python=$1
dist=$(realpath "$2")
root=$(realpath "$(dirname "$0")/../..")
"$python" -c 'import ensurepip, venv' || {
    echo "floors: $python does not run; name a Python 3.10 with make floors FLOOR_PYTHON=/path/to/python3.10" >&2
    exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$python" -m venv "$work"
"$work/bin/python" -m pip install --quiet --upgrade 'pip>=25.1'
cd "$root" # where the group of the tests is read from, and the files that they look at
"$work/bin/python" -m pip install --quiet --constraint tests/packaging/floors.txt \
    "$(echo "$dist"/carom-*.whl)[all]" --group test
"$work/bin/python" -m pip list
"$work/bin/python" -m pytest tests -W default -p no:cacheprovider
