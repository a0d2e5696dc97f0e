"""``carom studio``: the table in the browser."""

from __future__ import annotations

import threading
from contextlib import suppress
from typing import TYPE_CHECKING, Annotated

import typer

from carom.cli import options
from carom.cli.output import reporting
from carom.errors import CaromError, ScenarioError

if TYPE_CHECKING:
    from carom.studio.server import Server

LONGEST = 1500
"""A longer link is not handed over to a browser as it is: some systems cut it off."""
LONGEST_AT_ALL = 200_000
"""A longer link is not followed by browsers."""


@reporting()
def studio(
    scenario: Annotated[
        str | None,
        typer.Argument(metavar="SCENARIO", help=f"Open it with this. {options.SCENARIO}", show_default=False),
    ] = None,
    port: Annotated[
        int, typer.Option(metavar="PORT", min=0, max=65535, help="Serve on this port; 0 is any free one.")
    ] = 0,
    no_browser: Annotated[bool, typer.Option("--no-browser", help="Open no browser, print the address only.")] = False,
) -> None:
    """Open the studio, the page with the table, in the browser.

    It is served from the installed package, to this machine alone, until Ctrl-C ends it. Nothing leaves the machine:
    the page computes by itself.
    """
    from carom.studio.server import SCENARIO

    fragment = "" if scenario is None else _fragment(scenario)
    # Ctrl-C is how it ends, so it is no interruption.
    with suppress(KeyboardInterrupt), _serving(port, fragment) as server:
        link = server.address + (fragment if len(fragment) <= LONGEST else SCENARIO[1:])
        print(f"Carom Studio: {link}\nCtrl-C ends it.", flush=True)
        if not no_browser:
            threading.Thread(target=_open, args=(link,), daemon=True).start()
        server.serve_forever()


def _serving(port: int, fragment: str) -> Server:
    """Start to listen; a port that is taken is named."""
    from carom.studio.server import Server

    try:
        return Server(port, fragment)
    except OSError as error:
        raise CaromError(f"--port: {port} cannot be had: {error.strerror}") from None


def _fragment(source: str) -> str:
    """Give what follows the page's address: the name of a ready-made scenario, or all of another one."""
    import carom
    from carom.studio import fragment_of

    scenario = carom.load(source)
    if source in carom.scenarios():
        return f"#{source}"
    fragment = fragment_of(scenario)
    if len(fragment) > LONGEST_AT_ALL:
        raise ScenarioError([(source, "is too large for a link: open the studio without it, and drop the file there")])
    return fragment


def _open(link: str) -> None:
    import webbrowser

    webbrowser.open(link)
