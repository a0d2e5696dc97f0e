"""Try an installed package from outside its sources: scenario, run, files, figures and the command."""

import subprocess
import sys
import tempfile
from pathlib import Path

import carom


def main() -> None:
    """Run the exercise and write everything there is to write."""
    scenario = carom.load("midterm")
    run = scenario.run()
    assert run.verify(), run.verify()
    with tempfile.TemporaryDirectory() as folder:
        run.save(Path(folder) / "run.json")
        assert carom.load_run(Path(folder) / "run.json") == run
        command = [sys.executable, "-m", "carom", "run", "midterm", "--out", str(Path(folder) / "out")]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        assert any((Path(folder) / "out").iterdir())
    print(carom.__version__, len(carom.scenarios()), "scenarios", run.digest)


if __name__ == "__main__":
    main()
