"""The API reference: a page for each module with public names, from ``carom.__all__`` and the docstrings."""

from __future__ import annotations

import inspect
import shutil
from importlib import import_module
from pathlib import Path
from types import ModuleType

import carom

ORDER = [
    "scenario",
    "table",
    "ball",
    "physics",
    "method",
    "run",
    "comparison",
    "events",
    "ensemble",
    "columns",
    "simulation",
    "errors",
    "library",
]
"""The modules that one reads first; any other one follows."""

CONSTANTS = {
    "PHYSICS_VERSION": "The version of the physics: raised by any change that moves a trajectory. Saved runs carry it.",
    "__version__": "The version of the package.",
}

TITLES = {"library": "Ready-made scenarios, schema, versions"}
"""Titles of pages that hold more than their module."""

FURTHER = {
    "aim": "carom.aim",
    "figures": "carom.figures",
    "animation": "carom.animation",
    "pooltool": "carom.pooltool",
}
"""Modules whose names are public although the package itself does not give them."""


def modules() -> dict[str, list[str]]:
    """Give the public names of the package by the module that they come from, in reading order."""
    found: dict[str, list[str]] = {}
    for name in carom.__all__:
        found.setdefault(_home(name), []).append(name)
    return dict(sorted(found.items(), key=lambda item: (_place(item[0]), item[0])))


def write(folder: Path) -> None:
    """Write the pages, and a page that lists all names, into `folder`, which is made anew."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    pages = {home: _package_page(home, names) for home, names in modules().items()}
    pages |= {home: _module_page(import_module(path)) for home, path in FURTHER.items()}
    for home, text in pages.items():
        (folder / f"{home}.md").write_text(text, encoding="utf-8")
    (folder / "index.md").write_text(_index(list(pages)), encoding="utf-8")


def _home(name: str) -> str:
    if name in CONSTANTS:
        return "library"
    home = str(getattr(carom, name).__module__).split(".")[1]
    return "library" if home == "_engine" else home


def _place(home: str) -> int:
    return ORDER.index(home) if home in ORDER else len(ORDER)


def _index(homes: list[str]) -> str:
    lines = [
        "# Python API",
        "",
        "What is listed here stays as it is; other names may change.",
        "",
    ]
    for home, names in modules().items():
        lines += [f"**[{_title(home)}]({home}.md)**", ""]
        lines += [f"- {{py:obj}}`carom.{name}`: {_first_sentence(name)}" for name in names]
        lines.append("")
    for home, path in FURTHER.items():
        lines += [f"**[{_title(home)}]({home}.md)**: `{path}`", ""]
    return "\n".join([*lines, "```{toctree}", ":hidden:", "", *homes, "```", ""])


def _first_sentence(name: str) -> str:
    text = CONSTANTS.get(name) or inspect.getdoc(getattr(carom, name)) or ""
    return " ".join(text.split("\n\n")[0].split()).replace("``", "`")


def _title(home: str) -> str:
    """Give what a module's docstring begins with, up to a colon or a comma: ``Runs``."""
    if home in TITLES:
        return TITLES[home]
    text = import_module(f"carom.{home}").__doc__ or home
    return text.splitlines()[0].split(":")[0].split(",")[0].rstrip(".")


def _package_page(home: str, names: list[str]) -> str:
    blocks = [_directive(name, getattr(carom, name)) for name in names]
    return _page(_title(home), "carom", blocks)


def _module_page(module: ModuleType) -> str:
    public = getattr(module, "__all__", None) or [
        name
        for name, value in vars(module).items()
        if not name.startswith("_") and inspect.isfunction(value) and value.__module__ == module.__name__
    ]
    things = [name for name in public if callable(getattr(module, name))]
    intro = f".. automodule:: {module.__name__}\n   :no-members:\n   :no-index:\n"
    blocks = [intro, *(_directive(name, getattr(module, name)) for name in things)]
    return _page(_title(module.__name__.rpartition(".")[2]), module.__name__, blocks)


def _directive(name: str, value: object) -> str:
    if name in CONSTANTS:
        return f".. py:data:: {name}\n   :value: {value!r}\n\n   {CONSTANTS[name]}\n"
    if isinstance(value, type) and issubclass(value, BaseException):
        return f".. autoexception:: {name}\n   :show-inheritance:\n"
    if isinstance(value, type):
        known = any(getattr(carom, base.__name__, None) is base for base in value.__bases__)
        bases = "   :show-inheritance:\n" if known else ""
        return f".. autoclass:: {name}\n   :members:\n{bases}"
    if inspect.isbuiltin(value):
        return f".. py:function:: {name}()\n\n   {inspect.getdoc(value)}\n"
    return f".. autofunction:: {name}\n"


def _page(title: str, module: str, blocks: list[str]) -> str:
    text = "\n".join(blocks)
    return f"# {title}\n\n```{{eval-rst}}\n.. currentmodule:: {module}\n\n{text}\n```\n"
