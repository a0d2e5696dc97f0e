"""Checks a built site: every internal link leads somewhere, and nothing is fetched from elsewhere."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

FETCHED = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src")}


@dataclass
class Page(HTMLParser):
    """The links and the anchors of one page."""

    text: str
    links: list[tuple[str, str, str]] = field(default_factory=list)
    anchors: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        super().__init__()
        self.feed(self.text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note a link, and a place that links lead to."""
        for name, value in attrs:
            if name in ("href", "src") and value:
                self.links.append((tag, name, value))
            if name in ("id", "name") and value:
                self.anchors.add(value)


def problems(site: Path) -> list[str]:
    """Give every dead link of a site, and everything that a browser would fetch from elsewhere."""
    pages = {path.resolve(): Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html")}
    found = []
    for path, page in pages.items():
        for tag, name, value in page.links:
            wrong = _wrong(path, (tag, name), value, pages)
            if wrong:
                found.append(f"{path.relative_to(site.resolve())}: {value}: {wrong}")
    return sorted(set(found))


def _wrong(path: Path, kind: tuple[str, str], value: str, pages: dict[Path, Page]) -> str | None:
    link = urlsplit(value)
    if link.scheme or link.netloc:
        return "is fetched from elsewhere" if kind in FETCHED and link.scheme != "data" else None
    target = (path.parent / unquote(link.path)).resolve() if link.path else path
    if not target.is_file():
        return "no such file"
    if link.fragment and target in pages and unquote(link.fragment) not in pages[target].anchors | {"top"}:
        return "no such place on the page"
    return None


def main() -> None:
    """Print what is wrong with the site named on the command line; exit 1 where something is."""
    site = Path(sys.argv[1])
    found = problems(site)
    print("\n".join(found) or f"{site}: {len(list(site.rglob('*.html')))} pages, no dead link")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
