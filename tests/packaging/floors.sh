#!/usr/bin/env bash
# Runs the package's tests with the oldest Python packages it says it works with: floors.sh PYTHON FOLDER
set -eu
python=$1
dist=$(realpath "$2")
tests=$(realpath "$(dirname "$0")/..")
"$python" -c 'import ensurepip, venv' || {
    echo "floors: $python does not run; name a Python 3.10 with make floors FLOOR_PYTHON=/path/to/python3.10" >&2
    exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$python" -m venv "$work/environment"
"$work/environment/bin/pip" install --quiet --constraint "$tests/packaging/floors.txt" \
    "$(echo "$dist"/carom-*.whl)[data]" pytest hypothesis mpmath jsonschema
cp -r "$tests" "$work/tests"
cp -r "$tests/../pyproject.toml" "$tests/../reference" "$work"
cd "$work"
"$work/environment/bin/python" -m pytest tests -W default
