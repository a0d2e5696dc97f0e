"""Links that hold a scenario in their fragment: what stands after ``#`` is not sent to any server."""

from __future__ import annotations

import json
import zlib
from base64 import urlsafe_b64encode
from typing import TYPE_CHECKING

from carom import _engine

if TYPE_CHECKING:
    from carom.scenario import Scenario

FORMAT = 1
MARK = "#scenario="


def fragment_of(scenario: Scenario, digest: str | None = None) -> str:
    """Give the fragment of a link that opens a scenario in the studio, ``#`` included.

    After its mark it is, as base64 for links, the raw deflate of two lines: what the link is from, and the scenario
    with every digit that it has, both as JSON. `web/src/sharing/link.ts` reads and writes the same.

    Parameters
    ----------
    scenario : Scenario
        The scenario.
    digest : str, optional
        The digest of its run; the page then says whether it got the same bits.
    """
    head = {"format": FORMAT, "physics_version": _engine.PHYSICS_VERSION, "digest": digest}
    text = f"{json.dumps(head, separators=(',', ':'))}\n{scenario.to_json()}"
    packer = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    packed = packer.compress(text.encode("utf-8")) + packer.flush()
    return MARK + urlsafe_b64encode(packed).decode("ascii").rstrip("=")
