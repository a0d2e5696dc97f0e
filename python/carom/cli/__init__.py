"""The command line: ``carom``, or ``python -m carom``."""

from __future__ import annotations

import _thread
import io
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sys import UnraisableHookArgs

INTERRUPTED = 130


def main() -> None:
    """Run the command line; ends the process with 0 (fine), 1 (a problem), 2 (usage) or 130 (interrupted)."""
    _print_utf8()
    try:
        with _none_swallowed():
            from carom.cli.app import app

            app(prog_name="carom")
    except KeyboardInterrupt:
        _end_interrupted()
    except SystemExit as ended:
        if ended.code != INTERRUPTED:
            raise
        _end_interrupted()


def _print_utf8() -> None:
    """Give files and pipes UTF-8 on every system; a name that a code page lacks would end the command."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and not stream.isatty():
            stream.reconfigure(encoding="utf-8")


def _end_interrupted() -> None:
    """Say that the command was interrupted; what it writes is in its place complete, or not at all."""
    print("interrupted: nothing is half written", file=sys.stderr)
    raise SystemExit(INTERRUPTED) from None


@contextmanager
def _none_swallowed() -> Iterator[None]:
    """Repeat a Ctrl-C that came where Python drops exceptions: in a finalizer, or in the midst of an import."""
    before = sys.unraisablehook

    def hook(dropped: UnraisableHookArgs) -> None:
        if issubclass(dropped.exc_type, KeyboardInterrupt):
            _thread.start_new_thread(_interrupt_soon, (_thread.get_ident(),))
        else:
            before(dropped)

    sys.unraisablehook = hook
    try:
        yield
    finally:
        sys.unraisablehook = before


def _interrupt_soon(thread: int) -> None:
    import signal

    time.sleep(0.01)
    if sys.platform == "win32":
        _thread.interrupt_main()
    else:
        signal.pthread_kill(thread, signal.SIGINT)  # unlike the other, it also ends a sleep
