#!/usr/bin/env bash
# Installs what was built into fresh environments and tries it there: check.sh FOLDER
#
#   the wheel            on every Python found, or on those that PYTHONS="python3.10 /path/to/python3.13" names,
#                        with the newest packages that pip finds
#   the wheel            on Python 3.10, if that is the first of them, with the oldest packages of floors.txt
#   the source archive   on the last of them
set -eu
dist=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# The first Python of a version that runs and can make environments: on the path, or where pyenv keeps them.
find_python() {
    for python in "python3.$1" "${PYENV_ROOT:-$HOME/.pyenv}/versions/3.$1".*/"bin/python3.$1"; do
        "$python" -c 'import ensurepip, venv, sys; print(sys.executable)' 2>/dev/null && return
    done
    echo "check: found no Python 3.$1" >&2
}

# try PYTHON PACKAGE [PIP'S OPTIONS]...
try() {
    "$1" -m venv --clear "$work/environment"
    "$work/environment/bin/python" -m pip install --quiet --disable-pip-version-check "${@:3}" "$2"
    echo "$(basename "$2") ${*:3}"
    printf '  '
    "$work/environment/bin/python" "$here/smoke.py"
}

read -r -a pythons <<<"${PYTHONS:-$(for minor in 10 11 12 13 14; do find_python $minor; done | tr '\n' ' ')}"
[ ${#pythons[@]} -gt 0 ] || { echo 'check: found no Python; name some with PYTHONS="python3.10 ..."' >&2; exit 1; }
wheel=$(echo "$dist"/carom-*.whl)
archive=$(echo "$dist"/carom-*.tar.gz)
for python in "${pythons[@]}"; do
    try "$python" "$wheel"
done
if "${pythons[0]}" -c 'import sys; sys.exit(sys.version_info[:2] != (3, 10))'; then
    try "${pythons[0]}" "$wheel" --constraint "$here/floors.txt"
else
    echo "check: did not try the oldest packages, which are made for Python 3.10" >&2
fi
try "${pythons[${#pythons[@]} - 1]}" "$archive" # bash 3.2, which macOS has, counts from the front only
