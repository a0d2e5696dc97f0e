"""The command line: ``carom``, or ``python -m carom``."""

from __future__ import annotations

import _thread
import errno
import io
import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sys import UnraisableHookArgs

INTERRUPTED = 130
PIPE_CLOSED = 141


def main() -> None:
    """Run the command line, and end the process.

    Its exit code is 0 (fine), 1 (a problem), 2 (usage), 130 (interrupted) or 141 (who read the output closed it).
    """
    _print_utf8()
    try:
        with ending_with_the_pipe():
            _run()
    except KeyboardInterrupt:
        _end_interrupted()
    except SystemExit as ended:
        if ended.code == PIPE_CLOSED:
            _drop_output()
        if ended.code != INTERRUPTED:
            raise
        _end_interrupted()


def _run() -> None:
    try:
        with _none_swallowed():
            from carom.cli.app import app

            app(prog_name="carom")
    finally:
        # Here, since what cannot be written at the interpreter's end is an error message and an exit code of 120.
        if sys.stdout is not None:
            sys.stdout.flush()


@contextmanager
def ending_with_the_pipe() -> Iterator[None]:
    """End quietly, as other tools do, when what reads the output has closed it."""
    try:
        yield
    except OSError as error:
        if not is_closed_pipe(error):
            raise
        raise SystemExit(PIPE_CLOSED) from None


def is_closed_pipe(error: OSError) -> bool:
    """Tell a closed pipe from other troubles; Windows calls it an invalid argument, of no file."""
    on_windows = sys.platform == "win32" and error.errno == errno.EINVAL and error.filename is None
    return isinstance(error, BrokenPipeError) or on_windows


def _drop_output() -> None:
    """Let what is still in the buffers go nowhere when the interpreter ends."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.__stdout__, sys.__stderr__):
        if stream is not None:
            os.dup2(nowhere, stream.fileno())


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
