"""Check the licences of all that Carom ships or asks pip to install; write THIRD-PARTY.txt.

The wheel holds Rust crates, linked into the compiled module and into the engine of the page: `cargo tree` lists them,
without what only builds or tests, for every target. The page holds packages of npm: its lock file lists them. Their
licences go into THIRD-PARTY.txt, which the wheel, the source archive and the page as one file carry. The Python
packages of the base install and of the extras are not shipped, but whoever installs Carom gets them.

    python licences.py           complain about a licence that is not allowed, or a stale THIRD-PARTY.txt
    python licences.py --write   write THIRD-PARTY.txt anew
"""

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import Distribution, distribution
from pathlib import Path
from textwrap import fill

from license_expression import AND, ExpressionError, LicenseExpression, get_spdx_licensing
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[2]
WEB = ROOT / "web"
NOTICE = ROOT / "THIRD-PARTY.txt"

ALLOWED = {
    "0BSD", "Apache-2.0", "BSD-2-Clause", "BSD-3-Clause", "CC0-1.0", "HPND", "ISC", "MIT", "MIT-CMU", "PSF-2.0",
    "Unicode-3.0", "Unlicense", "Zlib",
}  # fmt: skip

# What older metadata says in words of its own.
SPDX = {
    "Apache Software License": "Apache-2.0",
    "BSD": "BSD-3-Clause",  # of partd, whose file has three clauses
    "BSD License": "BSD-3-Clause",
    "Historical Permission Notice and Disclaimer (HPND)": "HPND",
    "ISC License (ISCL)": "ISC",
    "MIT License": "MIT",
    "Python Software Foundation License": "PSF-2.0",
}

# Python packages that hold more than their metadata says, and why Carom asks for them all the same.
EXCEPTIONS = {
    "imageio-ffmpeg": "BSD-2-Clause, but it brings a build of ffmpeg under GPL-3.0-or-later. Only who asks for "
    "carom[movie] gets it; Carom neither ships nor links it, it starts it as a program.",
}

HEAD = """\
Carom's compiled module and the engine of its page hold the Rust crates listed here, and the Rust standard
library, which is MIT OR Apache-2.0 and lists its own parts in the file COPYRIGHT-library.html of each Rust
release. The page holds the packages of npm that are listed after them.

This file is written by `make third-party`; a check holds it to Cargo.lock and web/package-lock.json.
"""

LICENSING = get_spdx_licensing()


@dataclass(frozen=True, order=True)
class Part:
    """A Rust crate or a package of npm that is shipped, and the licence files in its source."""

    name: str
    version: str
    licence: str
    texts: tuple[tuple[str, str], ...]


def main() -> None:
    """Check, or write with --write; ends the process with 1 if something is wrong."""
    crates, modules = sorted(shipped_crates()), sorted(shipped_modules())
    packages = {name: licence_of(distribution(name)) for name in sorted(packages_of(Requirement("carom[all]")))}
    notice = notice_of(crates, modules)
    if sys.argv[1:] == ["--write"]:
        NOTICE.write_text(notice, encoding="utf-8", newline="\n")
    problems = [*problems_of_parts(crates + modules), *problems_of_packages(packages)]
    if not NOTICE.exists() or NOTICE.read_text(encoding="utf-8") != notice:
        problems.append(f"{NOTICE.name} is stale: make third-party writes it anew")
    if problems:
        sys.exit("\n".join(problems))
    counted = f"{len(crates)} crates, {len(modules)} packages of npm and {len(packages)} Python packages"
    print(f"licences: {counted}, all allowed but for")
    print("\n".join(f"  {name}: {why}" for name, why in EXCEPTIONS.items()))


def problems_of_parts(parts: list[Part]) -> Iterator[str]:
    """Name what may not be shipped, or not without a text that it does not have."""
    for part in parts:
        if not is_allowed(part.licence):
            yield f"{part.name} {part.version}: {part.licence} is not allowed"
        if not part.texts:
            yield f"{part.name} {part.version}: its source has no licence text"


def problems_of_packages(packages: dict[str, str]) -> Iterator[str]:
    """Name the Python packages whose licences are not allowed, and exceptions that are none any more."""
    for name, licence in packages.items():
        if name not in EXCEPTIONS and not is_allowed(licence):
            yield f"Python package {name}: {licence} is not allowed"
    yield from (f"Python package {name}: an exception, but not needed" for name in EXCEPTIONS.keys() - packages.keys())


def is_allowed(licence: str) -> bool:
    """Whether an SPDX expression can be met with allowed licences only.

    >>> [is_allowed(text) for text in ("MIT", "MIT/Apache-2.0", "GPL-3.0-only OR MIT", "(MIT OR MPL-2.0) AND Zlib")]
    [True, True, True, True]
    >>> [is_allowed(text) for text in ("GPL-3.0-only", "MIT AND LGPL-3.0-only", "MPL-2.0", "GPL WITH care", "", "none")]
    [False, False, False, False, False, False]
    """
    expression = parsed(licence)
    return expression is not None and _is_allowed(expression)


def _is_allowed(expression: LicenseExpression) -> bool:
    parts = getattr(expression, "args", ())
    if not parts:
        return str(expression) in ALLOWED
    return (all if isinstance(expression, AND) else any)(map(_is_allowed, parts))


def parsed(licence: str) -> LicenseExpression | None:
    """Read an SPDX expression; a slash, as older crates have it, stands for OR. None for what is none."""
    try:
        return LICENSING.parse(licence.replace("/", " OR "), validate=True, strict=True)
    except ExpressionError:
        return None


def shipped_crates() -> Iterator[Part]:
    """Find the crates of others that the compiled module and the page's engine are linked with, on any target."""
    tree = ["tree", "--package=carom-python", "--package=carom-wasm", "--edges=normal,no-proc-macro", "--target=all"]
    lines = _cargo(*tree, "--prefix=none", "--format={p}").splitlines()
    linked = {tuple(line.split()[:2]) for line in lines}
    for package in json.loads(_cargo("metadata", "--format-version=1"))["packages"]:
        if package["source"] and (package["name"], f"v{package['version']}") in linked:
            folder = Path(package["manifest_path"]).parent
            yield Part(package["name"], package["version"], package["license"] or "none", tuple(_texts_in(folder)))


def shipped_modules() -> Iterator[Part]:
    """Find the packages of npm that the page is built of; what only builds or tests it is none of them."""
    listed = json.loads((WEB / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    for place, package in listed.items():
        if place and not package.get("dev"):
            name = place.rpartition("node_modules/")[2]
            yield Part(name, package["version"], package.get("license", "none"), tuple(_texts_in(WEB / place)))


def _cargo(*words: str) -> str:
    command = ["cargo", words[0], "--locked", *words[1:]]
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout


def _texts_in(folder: Path) -> Iterator[tuple[str, str]]:
    for path in sorted(folder.iterdir()):
        if re.match(r"(?i)(licen[cs]e|copying|copyright|notice|unlicense)", path.name) and path.is_file():
            text = path.read_text(encoding="utf-8").strip("\n")
            yield path.name, "\n".join(line.rstrip() for line in text.splitlines())


def notice_of(crates: list[Part], modules: list[Part]) -> str:
    """Give the text of THIRD-PARTY.txt: the crates, the modules, then every licence text once, under its owners."""
    parts = crates + modules
    width = max(len(f"{part.name} {part.version}") for part in parts)
    listed = [
        "\n".join(f"{f'{part.name} {part.version}':{width}}  {part.licence}" for part in group) + "\n"
        for group in (crates, modules)
    ]
    owners: dict[str, list[str]] = {}
    texts: dict[str, str] = {}
    for part in parts:
        for name, text in part.texts:
            # Copies differ in how their lines are broken.
            key = " ".join(text.split())
            texts.setdefault(key, text)
            owners.setdefault(key, []).append(f"{part.name} ({name})")
    rule = "=" * 79
    blocks = [
        f"{rule}\n{fill(', '.join(owners[key]), 79, break_on_hyphens=False)}\n{rule}\n\n{text}\n"
        for key, text in texts.items()
    ]
    return "\n".join([HEAD, *listed, *blocks])


def packages_of(wanted: Requirement) -> set[str]:
    """Find what a requirement needs in turn, itself apart, by the metadata of what is installed here."""
    found: set[str] = set()
    waiting = [wanted]
    while waiting:
        requirement = waiting.pop()
        extras = requirement.extras or {""}
        for line in distribution(requirement.name).requires or []:
            needed = Requirement(line)
            applies = needed.marker is None or any(needed.marker.evaluate({"extra": extra}) for extra in extras)
            if applies and canonicalize_name(needed.name) not in found:
                found.add(canonicalize_name(needed.name))
                waiting.append(needed)
    return found


def licence_of(package: Distribution) -> str:
    """Give a Python package's licence as an SPDX expression, from the first field of its metadata that has one."""
    said = package.metadata
    classified = [line.split(" :: ")[-1] for line in said.get_all("Classifier", []) if line.startswith("License")]
    in_words = " AND ".join(SPDX.get(name, name) for name in classified if name != "OSI Approved")
    in_short = SPDX.get(said.get("License", ""), said.get("License"))
    for field in (said.get("License-Expression"), in_short, in_words):
        if field and parsed(field) is not None:
            return field
    return "a licence that its metadata does not tell"


if __name__ == "__main__":
    main()
