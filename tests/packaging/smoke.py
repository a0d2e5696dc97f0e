"""Try an installed package: smoke.py, run by the Python that it is installed for, from any folder.

It needs nothing but the base install. It works in a folder of its own, with a home that nothing can be written to,
and ends with an AssertionError where something is wrong.
"""

import importlib.util
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import time
import urllib.request
from importlib.metadata import version
from pathlib import Path

DIGESTS = Path(__file__).parents[2] / "reference" / "digests.json"
FIGURES = ("filmstrip", "paths", "energy", "speed", "momentum")
HEAVY = ("numpy", "matplotlib", "PIL", "typer", "rich", "jinja2", "carom._engine")
PLOTTING = ("matplotlib", "PIL")


def main() -> None:
    """Try the import, the library and the commands, and say in one line where that was."""
    # A file is a home in which not even root can write.
    os.environ.update(dict.fromkeys(("HOME", "USERPROFILE"), __file__))
    os.environ.pop("PYTHONPATH", None)
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        milliseconds = check_import()
        digests = check_library()
        check_commands()
        check_studio()
        check_extras()
        os.chdir(before)
    where = f"{platform.system()} {platform.machine()}, Python {platform.python_version()}, numpy {version('numpy')}"
    print(f"carom {version('carom')} on {where}: {digests} golden digests, import in {milliseconds:.1f} ms")


def check_import() -> float:
    """Import the package as it was installed; that loads nothing heavy. Gives the time in milliseconds."""
    began = time.perf_counter()
    import carom

    took = time.perf_counter() - began
    assert not [name for name in HEAVY if name in sys.modules]
    installed = Path(carom.__file__).parent
    assert installed.parent == Path(sysconfig.get_path("platlib")), installed
    assert (installed / "py.typed").exists()
    assert (installed / "_engine.pyi").exists()
    assert carom.__version__ == version("carom")
    return 1000 * took


def check_library() -> int:
    """Run every ready-made scenario without a plotting library. Gives the number of golden digests compared."""
    import carom

    golden = json.loads(DIGESTS.read_text(encoding="utf-8"))["digests"]
    assert carom.scenarios() == sorted(golden)
    for name in carom.scenarios():
        assert carom.load(name).run().digest == golden[name]["state"], name
    run = carom.load("midterm").run()
    assert run.verify(), run.verify()
    run.save("run.json")
    assert carom.load_run("run.json") == run
    run.trajectory([0.0, 0.5]).to_csv("trajectory.csv")
    run.player("player.html")
    assert str(run.digest) in Path("player.html").read_text(encoding="utf-8")
    assert not [name for name in PLOTTING if name in sys.modules]
    return len(golden)


def check_commands() -> None:
    """Give the command its tasks, as `carom` and as `python -m carom`."""
    import carom

    program = shutil.which("carom", path=sysconfig.get_path("scripts"))
    assert program
    for words in ("--version", "--cite", "--help"):
        assert printed(program, words) == printed(sys.executable, "-m", "carom", words)
    assert printed(program, "--version") == f"carom {carom.__version__}\n"
    assert printed(program, "--cite") == f"{carom.citation()}\n"
    out = Path("deep") / "out"
    printed(program, "run", "midterm", "--format", "png,svg,pdf", "--out", out)
    figures = {f"{name}.{kind}" for name in FIGURES for kind in ("png", "svg", "pdf")}
    data = {"run.json", "events.csv", "trajectory.csv", "animation.gif", "report.html"}
    assert {path.name for path in out.iterdir()} == figures | data
    assert all(path.stat().st_size > 0 for path in out.iterdir())
    printed(program, "verify", out / "run.json")
    printed(program, "scenarios", "--copy", "stadium", "mine.toml")
    printed(program, "check", "mine.toml")
    assert json.loads(printed(program, "schema"))["title"]
    wrong = command(program, "check", "midtrem")
    assert (wrong.returncode, wrong.stderr.count("\n")) == (1, 1), wrong.stderr


def check_studio() -> None:
    """Serve the page, and load it with all that it names."""
    process = [sys.executable, "-m", "carom", "studio", "midterm", "--no-browser"]
    with subprocess.Popen(process, stdout=subprocess.PIPE, text=True, encoding="utf-8") as served:
        try:
            assert served.stdout
            address = served.stdout.readline().split()[-1].partition("#")[0]
            page = loaded(address)
            parts = re.findall(r'(?:src|href)="\./([^"]+)"', page)
            assert len(parts) >= 2, page
            assert all(loaded(address + part) for part in parts)
        finally:
            served.terminate()


def loaded(address: str) -> str:
    """Give what a server sends."""
    directly = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    with directly.open(address, timeout=20) as answer:
        return str(answer.read().decode("utf-8"))


def check_extras() -> None:
    """Ask for a film that the base install cannot make: one line says what is missing."""
    if importlib.util.find_spec("imageio_ffmpeg"):
        return
    done = command(sys.executable, "-m", "carom", "run", "midterm", "--animation", "mp4", "--out", "film")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == "error: imageio_ffmpeg is not installed: needs carom[movie]\n"
    assert not Path("film").exists()


def printed(*words: str | Path) -> str:
    """Give what a command prints when all is well."""
    done = command(*words)
    assert done.returncode == 0, done.stderr
    return done.stdout


def command(*words: str | Path) -> subprocess.CompletedProcess[str]:
    """Run a command in a process of its own."""
    return subprocess.run([*map(str, words)], capture_output=True, text=True, encoding="utf-8", check=False)


if __name__ == "__main__":
    main()
