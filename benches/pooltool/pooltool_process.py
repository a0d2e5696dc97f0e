"""pooltool in a process of its own: its own Python, and an empty home, as it reads and writes settings there."""

import contextlib
import json
import os
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
PYTHON = HERE.parents[1] / ".venv-pooltool" / "bin" / "python"


class Pooltool:
    """A running pooltool; `with` ends it."""

    def __init__(self, home, **environment):
        self._process = subprocess.Popen(
            [PYTHON, HERE / "run_pooltool.py"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "HOME": str(home), **environment},
        )

    def ask(self, do, shot, **more):
        """Ask for something, in the words of `run_pooltool`."""
        print(json.dumps({"do": do, "shot": shot, **more}), file=self._process.stdin, flush=True)
        line = self._process.stdout.readline()
        if not line:
            raise RuntimeError(f"pooltool ended with {self._process.wait()} at {shot['name']}")
        return json.loads(line)

    def close(self):
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()


@contextlib.contextmanager
def started(**environment):
    """Start pooltool for a while."""
    with tempfile.TemporaryDirectory() as home, contextlib.closing(Pooltool(home, **environment)) as pooltool:
        yield pooltool


def cold(shot):
    """Seconds of pooltool's import and first shot where nothing has been compiled yet, as after an installation."""
    with tempfile.TemporaryDirectory() as cache, started(NUMBA_CACHE_DIR=cache) as pooltool:
        return pooltool.ask("cold", shot)


def warm(shot):
    """The same in a new process that finds what was compiled."""
    with started() as pooltool:
        return pooltool.ask("cold", shot)
