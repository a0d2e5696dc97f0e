#!/usr/bin/env bash
# Installs each package found in a folder into an environment of its own and tries it: check.sh PYTHON FOLDER
set -eu
python=$(realpath -s "$1")
dist=$(realpath "$2")
smoke=$(realpath "$(dirname "$0")/smoke.py")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
for package in "$dist"/carom-*.whl "$dist"/carom-*.tar.gz; do
    "$python" -m venv --clear "$work/environment"
    "$work/environment/bin/pip" install --quiet "$package"
    printf '%s: ' "$(basename "$package")"
    "$work/environment/bin/python" "$smoke"
done
