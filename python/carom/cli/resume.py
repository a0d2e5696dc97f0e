"""``carom resume``: go on with a run that ended early, or to a later end."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from carom.cli import options
from carom.cli.measuring import bar, count, finish, interruptible, waiting
from carom.cli.output import reporting
from carom.recording import CHECKPOINT


@reporting()
def resume(
    folder: Annotated[
        Path, typer.Argument(metavar="DIR", help="The folder that carom gas wrote into.", show_default=False)
    ],
    collisions: Annotated[
        int | None,
        typer.Option(parser=count, metavar="N", help="End after N collisions in all.  [default: as it was begun]"),
    ] = None,
    duration: Annotated[
        float | None, typer.Option(metavar="T", min=0.0, help="End at this time.  [default: as it was begun]")
    ] = None,
    checkpoint_every: Annotated[
        float | None,
        typer.Option(metavar="SECONDS", min=0.0, help="Write a checkpoint so often.  [default: as it was begun]"),
    ] = None,
    formats: options.Formats = None,
    no_figures: Annotated[bool, typer.Option("--no-figures", help="Write no figures.")] = False,
    as_json: options.Json = False,
) -> None:
    """Go on with a run from its checkpoint: to its end if it was broken off or killed, or to a later end.

    The bits, what is measured, and the files of snapshots and events are those of a run that was never broken off. With
    --collisions or --duration that end takes the place of the one it had. Results in DIR are replaced.
    """
    from carom.observing import driven, reopened

    kinds = [] if no_figures else options.read_formats(formats)
    ends = {"collisions": collisions, "duration": duration}
    with waiting("reading the checkpoint"):
        native, recorder = reopened(folder / CHECKPOINT, ends, checkpoint_every)
    with interruptible() as interrupted, bar(*native.ends(), native.progress()[1]) as told:
        run = driven(native, recorder, lambda *now: told(*now) or interrupted())
    finish(run, folder, recorder.files(), kinds, as_json=as_json)
