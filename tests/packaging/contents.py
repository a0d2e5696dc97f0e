"""Check what a built wheel and source archive hold, against what git holds: contents.py FOLDER."""

import re
import subprocess
import sys
import tarfile
import zipfile
from email.parser import HeaderParser
from pathlib import Path

ROOT = Path(__file__).parents[2]
LICENCES = ("LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt")
# What a source archive needs to build a wheel.
ROOT_FILES = {"Cargo.toml", "Cargo.lock", "pyproject.toml", "README.md", "CITATION.cff", *LICENCES}
FOLDERS = ("python/carom/", "scenarios/", "crates/carom/src/", "crates/carom-python/")
# The page of the studio is built, so git does not hold it: these, and whatever else of such a name the build gives.
PAGE_FILES = {"carom/studio/player.html", "carom/studio/page/index.html"}
PAGE_PARTS = re.compile(r"carom/studio/page/assets/[\w.-]+\.(js|css|wasm)")


def main() -> None:
    """Check every archive in the folder; ends the process with 1 if something is wrong."""
    folder = Path(sys.argv[1])
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
    tracked = set(listed.splitlines())
    wheels, archives = sorted(folder.glob("carom-*.whl")), sorted(folder.glob("carom-*.tar.gz"))
    problems = [f"{folder}: holds no wheel and no source archive"] if not wheels + archives else []
    for path in wheels:
        with zipfile.ZipFile(path) as wheel:
            problems += [f"{path.name}: {problem}" for problem in problems_of_wheel(wheel, tracked)]
    for path in archives:
        with tarfile.open(path) as archive:
            problems += [f"{path.name}: {problem}" for problem in problems_of_archive(archive, tracked)]
    if problems:
        sys.exit("\n".join(problems))
    print(f"contents: {len(wheels + archives)} packages hold what they should")


def problems_of_wheel(wheel: zipfile.ZipFile, tracked: set[str]) -> list[str]:
    """Compare a wheel with the package that git holds: the same files, and the engine."""
    names = set(wheel.namelist())
    (metadata,) = (name for name in names if name.endswith(".dist-info/METADATA"))
    info = metadata.removesuffix("/METADATA")
    engines = {name for name in names if name.startswith("carom/_engine.") and name.endswith((".so", ".pyd"))}
    package = {name.removeprefix("python/") for name in tracked if name.startswith("python/carom/")}
    licences = {f"{info}/licenses/{name}" for name in LICENCES}
    own = {f"{info}/{name}" for name in ("METADATA", "WHEEL", "RECORD", "entry_points.txt")}
    boms = {name for name in names if name.startswith(f"{info}/sboms/")}
    problems = [*differences(names, package | page(names) | engines | licences | own | boms), *lacks_of_page(names)]
    if len(engines) != 1 or not any("abi3" in name or name.endswith(".pyd") for name in engines):
        problems.append(f"holds {sorted(engines)}, and should hold one engine for every Python")
    said = HeaderParser().parsestr(wheel.read(metadata).decode("utf-8"))
    if not info.startswith(f"carom-{said['Version']}.") or said["License-Expression"] != "MIT OR Apache-2.0":
        problems.append("its metadata says another version or licence")
    if "-abi3-" not in wheel.read(f"{info}/WHEEL").decode("utf-8"):
        problems.append("it is not tagged abi3")
    return problems


def problems_of_archive(archive: tarfile.TarFile, tracked: set[str]) -> list[str]:
    """Compare a source archive with what git holds: all that a build needs, and nothing that git does not have."""
    held = {entry.name.partition("/")[2] for entry in archive.getmembers() if entry.isfile()}
    needed = ROOT_FILES | {name for name in tracked if name.startswith(FOLDERS)}
    packaged = {name.removeprefix("python/") for name in held}
    built = {f"python/{name}" for name in page(packaged)}
    return [*differences(held, needed | (held & tracked) | built | {"PKG-INFO"}), *lacks_of_page(packaged)]


def page(names: set[str]) -> set[str]:
    """Give the files of the built page: those that must be there, and the others among some names."""
    return PAGE_FILES | {name for name in names if PAGE_PARTS.fullmatch(name)}


def lacks_of_page(names: set[str]) -> list[str]:
    """Say what kinds of files the page lacks."""
    found = {match[1] for match in map(PAGE_PARTS.fullmatch, names) if match}
    return [f"lacks the page's {ending} files" for ending in ("css", "js", "wasm") if ending not in found]


def differences(held: set[str], wanted: set[str]) -> list[str]:
    """Say what an archive lacks and what it should not hold."""
    lacking = [f"lacks {name}" for name in sorted(wanted - held)]
    return lacking + [f"holds {name}, a stray file" for name in sorted(held - wanted)]


if __name__ == "__main__":
    main()
