"""The player of a run: one page that holds the run's own numbers, shows texts as texts, and stands in a notebook."""

import json
import re
import shutil
import subprocess
from base64 import b64decode
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_report import HTML_TEXTS, named

import carom
from carom.studio import built
from carom.studio import player as players

TEMPLATE = """<!doctype html><title>Carom</title>
<script type="application/json" id="run">
  null
</script>
<script>play()</script>
"""


@pytest.fixture(autouse=True)
def template(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A template in the place of the built one, which an installation may lack."""
    path = tmp_path / "player.html"
    path.write_text(TEMPLATE, encoding="utf-8")
    monkeypatch.setattr(built, "PLAYER", path)


def values_in(page: str) -> dict[str, Any]:
    (text,) = re.findall(r'<script type="application/json" id="run">(.*?)</script>', page, re.DOTALL)
    values: dict[str, Any] = json.loads(text)
    return values


def array(text: str, form: str) -> np.ndarray[Any, Any]:
    return np.frombuffer(b64decode(text), dtype=form)


def test_a_player_holds_every_flight_and_every_event(run: carom.Run, tmp_path: Path) -> None:
    player = run.player(tmp_path / "run.html")
    assert (tmp_path / "run.html").read_text(encoding="utf-8") == player.html == run.player().html
    values = values_in(player.html)
    film, events = values["film"], values["events"]
    rows = array(film["numbers"], "<f8").reshape(-1, film["width"])
    first = array(film["firstRows"], "<u4")
    assert (film["width"], first[-1]) == (7, len(rows))
    time = 1.2345
    for ball, place in enumerate(run.positions(time)):
        of_ball = rows[first[ball] : first[ball + 1]]
        t0, x, y, vx, vy, ax, ay = of_ball[np.searchsorted(of_ball[:, 0], time, side="right") - 1]
        s = time - t0
        assert [x + (vx + ax * (s * 0.5)) * s, y + (vy + ay * (s * 0.5)) * s] == list(place)
    assert np.array_equal(array(events["quantities"]["time"], "<f8"), run.events["time"])
    kinds = [values["kinds"][kind] for kind in array(events["codes"]["kind"], "<i4")]
    assert kinds == list(run.events["kind"])
    assert values["drawing"]["table"] == run.scenario.outline()
    assert json.loads(values["scenario"]) == run.scenario.to_dict()
    assert (values["summary"]["digest"], values["summary"]["endTime"]) == (run.digest, run.end_time)


@pytest.mark.parametrize("name", ["midterm_stepped", "nine_ball_break", "gas"])
def test_stepped_runs_shots_and_gases_have_players(name: str) -> None:
    run = carom.load(name).run(record="all", max_events=100)
    values = values_in(run.player().html)
    assert len(array(values["film"]["firstRows"], "<u4")) == len(run.ball_ids) + 1


def test_the_size_is_foreseen(run: carom.Run) -> None:
    for ran in (
        run,
        carom.load("fifty_random").run(record="all", max_events=3000),
        carom.load("midterm_stepped").run(),
    ):
        assert len(ran.player().html) / 2 < players.estimated_size(ran) < 2 * len(ran.player().html)


@pytest.mark.parametrize("text", HTML_TEXTS)
def test_texts_do_not_leave_their_place(midterm: carom.Scenario, text: str) -> None:
    run = named(midterm, text).run()
    page = run.player().html
    assert page.count("<") == TEMPLATE.count("<")
    assert json.loads(values_in(page)["scenario"])["title"] == text
    frame = Attributes(run._repr_html_()).of("iframe")
    assert frame is not None
    assert frame["srcdoc"] == page


def test_what_kept_no_flights_has_no_player(midterm: carom.Scenario) -> None:
    run = midterm.run(record="events")
    with pytest.raises(carom.RunError, match="record"):
        run.player()
    assert Attributes(run._repr_html_()).of("iframe") is None
    assert "record=&#34;all&#34;" in run._repr_html_()


def test_what_is_too_large_is_said(run: carom.Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(players, "LARGEST_IN_NOTEBOOK", 1000)
    html = run._repr_html_()
    assert Attributes(html).of("iframe") is None
    assert "too large to be shown here" in html
    monkeypatch.setattr(players, "LARGEST", 1000)
    with pytest.raises(carom.RunError, match="browsers open"):
        run.player()


def test_without_the_page_it_is_said(run: carom.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(built, "PLAYER", tmp_path / "none.html")
    with pytest.raises(carom.MissingPageError, match="make package-page"):
        run.player()
    assert "make package-page" in run._repr_html_()


class Attributes(HTMLParser):
    """The attributes of the first element of each kind."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.found: dict[str, dict[str, str | None]] = {}
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        self.found.setdefault(tag, dict(attrs))

    def of(self, tag: str) -> dict[str, str | None] | None:
        return self.found.get(tag)


def test_a_notebook_shows_it_in_a_frame_of_its_own(run: carom.Run) -> None:
    for shown in (run, run.player()):
        frame = Attributes(shown._repr_html_()).of("iframe")
        assert frame is not None
        assert frame["sandbox"] == "allow-scripts"
        assert frame["srcdoc"] == run.player().html


@pytest.mark.skipif(not shutil.which("chromium"), reason="needs Chromium")
def test_a_browser_plays_what_python_wrote(run: carom.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(built, "PLAYER", built.HERE / "player.html")
    if not built.PLAYER.exists():
        pytest.skip("the page is not built")
    run.player(tmp_path / "run.html")
    options = ["--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={tmp_path / 'profile'}", "--dump-dom"]
    address = (tmp_path / "run.html").as_uri()
    done = subprocess.run(
        ["chromium", *options, address], capture_output=True, encoding="utf-8", check=True, timeout=60
    )
    for words in ("→ right", "0 of 5"):
        assert words in done.stdout
