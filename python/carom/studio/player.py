"""A recorded run as a page of its own that plays it."""

from __future__ import annotations

import html
import json
import os
import re
from base64 import b64encode
from typing import TYPE_CHECKING, Any

import numpy as np

from carom import _engine
from carom.errors import RunError
from carom.files import write_text
from carom.studio.built import MissingPageError, player_template

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from carom.run import Run

LARGEST = 256_000_000
"""So many letters a page has at most: browsers do not open much more."""
LARGEST_IN_NOTEBOOK = 1_000_000
"""So many letters a player in a notebook has at most, or the notebook's file would grow too large."""

PLACE = re.compile(r'(<script type="application/json" id="run">).*?(?=</script>)', re.DOTALL)
QUANTITIES = {
    "time": "time",
    "x": "x",
    "y": "y",
    "normal_x": "normalX",
    "normal_y": "normalY",
    "closing_speed": "closingSpeed",
    "impulse": "impulse",
}
CODES = {
    "kind": "kind",
    "ball_a": "ballA",
    "ball_b": "ballB",
    "cushion": "cushion",
    "pocket": "pocket",
    "cluster": "cluster",
}


class Player:
    """A page that plays a recorded run: the table, a time line and the events. It needs no network and no Carom.

    Attributes
    ----------
    html : str
        The page.
    """

    def __init__(self, page: str) -> None:
        self.html = page

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the page to `path`."""
        write_text(path, self.html)

    def __repr__(self) -> str:
        return f"Player, {len(self.html)} letters of HTML: save(path) writes it"

    def _repr_html_(self) -> str:
        return frame_of(self)


def player_of(run: Run) -> Player:
    """Make the player of a run; see `Run.player`."""
    size = estimated_size(run)
    if size > LARGEST:
        raise RunError(f"the player would have {megabytes(size)}, and browsers open {megabytes(LARGEST)}")
    # In a script no end of an element may stand; in JSON the two spellings are the same.
    text = json.dumps(_values(run), separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    return Player(PLACE.sub(lambda found: found[1] + text, player_template(), count=1))


def frame_of(player: Player) -> str:
    """Give a player as a frame for a notebook; what is in it cannot reach what is around it."""
    style = "width:100%;height:32em;border:1px solid rgba(128,128,128,0.35);border-radius:6px"
    page = html.escape(player.html)
    return f'<iframe sandbox="allow-scripts" title="The run" style="{style}" srcdoc="{page}"></iframe>'


def frame_or_reason(run: Run) -> tuple[str, str]:
    """Give the frame of a run's player, or why a notebook shows none: one of them is empty."""
    if run.record != "all":
        return "", 'none, as the run kept no flights; record="all" keeps them'
    size = estimated_size(run)
    if size > LARGEST_IN_NOTEBOOK:
        return "", f'too large to be shown here, {megabytes(size)}; run.player("run.html") writes it as a page'
    try:
        return frame_of(player_of(run)), ""
    except MissingPageError as error:
        return "", f"none: {error}"


def estimated_size(run: Run) -> int:
    """Say about how many letters the player of a run has, its template aside, without making it."""
    numbers, balls = 17 if run.is_on_cloth else 7, len(run.ball_ids)
    events: int = sum(run.diagnostics["events"].values())
    method = run.scenario.to_dict().get("method", {})
    rows = balls + 2 * events
    if method.get("kind") == "stepped":
        rows += int(balls * run.end_time / method["dt"])
    # Four letters for three bytes; 300 letters of a ball's JSON.
    return (rows * numbers * 8 + events * 80) * 4 // 3 + balls * 300


def megabytes(size: int) -> str:
    """Give a number of letters in words.

    Examples
    --------
    >>> megabytes(1_234_567), megabytes(256_000_000)
    ('1.2 MB', '256 MB')
    """
    return f"{size / 1e6:.3g} MB" if size >= 1e7 else f"{size / 1e6:.1f} MB"


def _values(run: Run) -> dict[str, Any]:
    """Give what the page is told of a run; `web/src/player/recorded.ts` reads it."""
    first_rows, numbers = run._native.film()
    scenario, columns = run._native.scenario(), run._native.events()
    events: dict[str, Any] = {**columns}
    return {
        "version": _engine.__version__,
        "physicsVersion": run.physics_version,
        "kinds": _engine.EVENT_KINDS,
        "motions": _engine.MOTIONS,
        "scenario": scenario.to_json(),
        "drawing": {
            "table": json.loads(scenario.outline()),
            "balls": json.loads(scenario.balls()),
            "units": json.loads(scenario.units()),
            "isOnCloth": run.is_on_cloth,
        },
        "summary": {
            "status": run.status,
            "endTime": run.end_time,
            "digest": run.digest,
            "ballIds": run.ball_ids,
            "diagnostics": run.diagnostics,
            "references": [],
        },
        "film": {
            "width": numbers.shape[1],
            "firstRows": _base64(first_rows, "<u4"),
            "numbers": _base64(numbers, "<f8"),
        },
        "events": {
            "quantities": {word: _base64(events[name], "<f8") for name, word in QUANTITIES.items()},
            "codes": {word: _base64(events[name], "<i4") for name, word in CODES.items()},
        },
        "cushionIds": run.cushion_ids,
        "pocketIds": run.pocket_ids,
    }


def _base64(values: NDArray[Any], form: str) -> str:
    return b64encode(np.ascontiguousarray(values, dtype=form).tobytes()).decode("ascii")
