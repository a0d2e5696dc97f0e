"""What Sphinx does beside its own work: generated pages and parts, pictures, and formulas as MathML."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

from docutils import nodes
from docutils.utils.math import MathError, latex2mathml
from sphinx.util import logging

import carom
from carom_docs import api, pictures
from carom_docs.blocks import files_beside
from carom_docs.parts import with_parts

if TYPE_CHECKING:
    from sphinx.application import Sphinx

logger = logging.getLogger(__name__)

ARRAY = re.compile(r"~?numpy\.ndarray\[tuple\[.*?, \.\.\.\], ~?numpy\.dtype\[~?([\w.]+?\.)?(\w+)\]\]")
"""How Sphinx writes an array's type."""


def setup(app: Sphinx) -> dict[str, bool]:
    """Register everything with Sphinx."""
    app.connect("builder-inited", _generate)
    app.connect("source-read", _fill_in)
    app.connect("autodoc-process-signature", _shorten)
    app.connect("autodoc-process-bases", _leave_out_private)
    app.add_html_math_renderer("mathml", inline_renderers=(_inline, None), block_renderers=(_display, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _generate(app: Sphinx) -> None:
    folder = Path(app.srcdir)
    api.write(folder / "reference" / "api")
    pictures.write(folder / "pictures")


def _fill_in(app: Sphinx, name: str, source: list[str]) -> None:
    page = Path(app.env.doc2path(name))
    source[0] = with_downloads(page, with_parts(source[0]))


def with_downloads(page: Path, text: str) -> str:
    """Let links to files beside the site download them; to a reader of the source they are links."""
    for file in files_beside(page):
        link = re.escape(Path(os.path.relpath(file, page.parent)).as_posix())
        text = re.sub(rf"\[`?([^\]`]+)`?\]\(({link})\)", r"{download}`\1 <\2>`", text)
    return text


def _shorten(
    app: Sphinx, what: str, name: str, value: Any, options: Any, given: str | None, back: str | None
) -> tuple[str | None, str | None]:
    """Write arrays as the source does, and give no signature to a class that only the package itself makes."""
    if what == "class" and re.search(r"[(, ](native|_\w+):", given or ""):
        return "", None
    return _with_arrays(given), _with_arrays(back)


def _leave_out_private(app: Sphinx, name: str, value: Any, options: Any, bases: list[type]) -> None:
    """Name public bases only: in place of one that is not, its own."""
    bases[:] = [public for base in bases for public in _public(base)]


def _public(base: type) -> list[type]:
    if not base.__module__.startswith("carom") or getattr(carom, base.__name__, None) is base:
        return [base]
    return [public for one in base.__bases__ for public in _public(one)]


def _with_arrays(signature: str | None) -> str | None:
    return signature and ARRAY.sub(r"NDArray[\2]", signature)


def _inline(translator: Any, node: nodes.math) -> None:
    _append(translator, node, as_block=False)


def _display(translator: Any, node: nodes.math_block) -> None:
    _append(translator, node, as_block=True)


def _append(translator: Any, node: nodes.Element, *, as_block: bool) -> None:
    try:
        translator.body.append(latex2mathml.tex2mathml(node.astext(), as_block=as_block))
    except MathError as error:
        logger.warning("%s In: %s", error, node.astext(), location=node)
    raise nodes.SkipNode
