"""The ``console`` blocks of pages: commands, run by a shell in a terminal of its own, and what they print."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
BEGIN, END = "\036", "\037"
ESCAPES = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")
WIDTH, HEIGHT = 100, 50


@dataclass(frozen=True)
class Result:
    """A command, what the page shows of it, and what it did; `looked_at` says that the next command asks for $?."""

    command: str
    shown: str
    output: str
    status: int
    looked_at: bool

    @property
    def unseen_failure(self) -> bool:
        """Whether the command failed without the page saying so."""
        return self.status != 0 and not self.looked_at


def run(text: str) -> Iterator[Result]:
    """Run the commands of a block in one shell, and give what each did.

    Commands that install, build or serve are not run; that what they name exists is checked instead.
    """
    commands = [(command, shown) for command, shown in commands_in(text) if not only_checked(command)]
    if not commands:
        return
    parts = _in_terminal("\n".join(map(_watched, (command for command, _ in commands)))).split(BEGIN)[1:]
    for number, (command, shown) in enumerate(commands):
        output, _, status = parts[number].partition(END) if number < len(parts) else ("the shell ended", "", "1")
        looked_at = number + 1 < len(commands) and "$?" in commands[number + 1][0]
        yield Result(command, shown, output, int(status or 1), looked_at)


def commands_in(text: str) -> list[tuple[str, str]]:
    """Give the commands of a block, lines continued with ``>`` put together, each with the output shown below it."""
    found: list[tuple[list[str], list[str]]] = []
    for line in text.splitlines():
        if line.startswith("$ "):
            found.append(([line[2:]], []))
        elif not found:
            raise AssertionError(f"a console block begins with $ and a command, not with {line!r}")
        elif line.startswith("> ") and not found[-1][1]:
            found[-1][0].append(line[2:])
        else:
            found[-1][1].append(line)
    return [("\n".join(command), "\n".join(shown)) for command, shown in found]


def only_checked(command: str) -> bool:
    """Tell whether a command is not for a test to run; what it names has to exist."""
    words = shlex.split(command, comments=True)
    if words[0] == "make":
        targets = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
        unknown = [word for word in words[1:] if "=" not in word and word not in targets]
    elif {"pip", "install"} <= set(words):
        extras = re.findall(r"\[([a-z,]+)\]", command)
        project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
        named = [extra for group in extras for extra in group.split(",")]
        unknown = [extra for extra in named if not re.search(rf"^{extra} = \[", project, re.MULTILINE)]
    elif words[:2] == ["carom", "studio"]:
        _read_options(words[1], words[2:])
        unknown = []
    else:
        return words[0] in ("git", "cargo", "source") or {"-m", "venv"} <= set(words)
    if unknown:
        raise AssertionError(f"{command}: there is no {', '.join(unknown)}")
    return True


def _read_options(command: str, words: list[str]) -> None:
    """Read the options of a command as it does itself; wrong ones raise."""
    import typer

    from carom.cli.app import app

    group: Any = typer.main.get_command(app)
    group.commands[command].make_context(command, words)


def _watched(command: str) -> str:
    """Mark where a command's output begins and ends, and keep its status for the next one to ask for."""
    return f"printf '\\036'; (exit ${{status:-0}})\n{command}\nstatus=$?; printf '\\037%d' $status"


def _in_terminal(script: str) -> str:
    """Run a script in a terminal, so that commands print as a person sees them; give all that appears on it."""
    import fcntl
    import pty
    import struct
    import termios

    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", HEIGHT, WIDTH, 0, 0))
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    environment = {**os.environ, "PATH": path, "NO_COLOR": "1", "TERM": "xterm", "PYTHONWARNINGS": ""}
    environment.pop("COLUMNS", None)
    with subprocess.Popen(
        ["bash", "--norc", "-c", script], stdin=subprocess.DEVNULL, stdout=theirs, stderr=theirs, env=environment
    ):
        os.close(theirs)
        seen = b"".join(_until_closed(ours))
    os.close(ours)
    return ESCAPES.sub("", seen.decode()).replace("\r\n", "\n")


def _until_closed(terminal: int) -> Iterator[bytes]:
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:  # Linux says so when the last program has left the terminal
            return
        if not part:
            return
        yield part
