"""How to cite Carom: as text and as BibTeX."""

from __future__ import annotations

from carom._engine import __version__

TITLE = "Carom: an event-driven engine for billiards and hard discs"
AUTHOR = "The Carom authors"


def citation() -> str:
    """Say how to cite Carom: a line of text and a BibTeX entry, both with the version that runs.

    Examples
    --------
    >>> print(citation())  # doctest: +ELLIPSIS
    The Carom authors. Carom: an event-driven engine for billiards and hard discs. Version ... Computer software.
    <BLANKLINE>
    @software{carom,
      author  = {{The Carom authors}},
      title   = {{Carom: an event-driven engine for billiards and hard discs}},
      version = {...},
    }
    """
    return (
        f"{AUTHOR}. {TITLE}. Version {__version__}. Computer software.\n"
        "\n"
        "@software{carom,\n"
        f"  author  = {{{{{AUTHOR}}}}},\n"
        f"  title   = {{{{{TITLE}}}}},\n"
        f"  version = {{{__version__}}},\n"
        "}"
    )
