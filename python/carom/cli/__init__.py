"""The command line: ``carom``, or ``python -m carom``."""

from __future__ import annotations


def main() -> None:
    """Run the command line; ends the process with 0 (fine), 1 (a problem), 2 (usage) or 130 (interrupted)."""
    try:
        from carom.cli.app import app

        app(prog_name="carom")
    except KeyboardInterrupt:
        from carom.cli.output import say_interrupted

        raise SystemExit(say_interrupted()) from None
