"""What a notebook shows of scenarios, runs and tables."""

import re
from base64 import b64decode

import pytest
from test_report import HTML_TEXTS, Page, named

import carom


def picture_of(html: str) -> bytes:
    (picture,) = Page(html).all("img")
    assert picture["alt"]
    return b64decode(picture["src"].removeprefix("data:image/png;base64,"))


def without_player(html: str) -> str:
    """What is shown around the player, which is a page of its own."""
    return re.sub(r'<iframe [^>]*srcdoc="[^"]*"', "<iframe", html)


def crowd(count: int) -> carom.Scenario:
    balls = [
        carom.Ball(f"b{k}", radius=0.3, position=(1 + k % 100, 1 + k // 100), velocity=(1, 0.3)) for k in range(count)
    ]
    return carom.Scenario(carom.Table.rectangle(width=102, length=52), balls, duration=0.1)


@pytest.mark.parametrize("name", carom.scenarios())
def test_every_ready_made_scenario_and_its_run_are_shown(name: str) -> None:
    scenario = carom.load(name)
    for shown in (scenario, scenario.run(collisions=30, max_events=60)):
        html = shown._repr_html_()
        assert picture_of(html).startswith(b"\x89PNG")
        assert scenario.title in Page(html).text


def test_a_scenario_is_shown_with_what_it_says(midterm: carom.Scenario) -> None:
    text = Page(midterm._repr_html_()).text
    for words in ("2 (red, blue)", "damping, factor 0.8", "rectangle, width 1.0, length 2.0", "exact"):
        assert words in text


def test_a_run_is_shown_with_how_it_ended(run: carom.Run) -> None:
    text = Page(run._repr_html_()).text
    for words in ("5 (time_limit)", "12 (1 ball_ball and 11 ball_cushion)", str(run.digest)):
        assert words in text


def test_a_run_without_flights_is_shown_as_it_started(midterm: carom.Scenario, run: carom.Run) -> None:
    start = picture_of(midterm._repr_html_())
    for record in ("events", "none"):
        assert picture_of(midterm.run(record=record)._repr_html_()) == start
    assert picture_of(run._repr_html_()) != start


def test_a_crowd_is_shown_in_little() -> None:
    scenario = crowd(5000)
    for shown in (scenario, scenario.run()):
        html = without_player(shown._repr_html_())
        assert len(html) < 300_000
        assert "5 000" in Page(html).all("img")[0]["alt"].replace("\N{NO-BREAK SPACE}", " ")


@pytest.mark.parametrize("text", HTML_TEXTS)
def test_what_is_shown_is_text(midterm: carom.Scenario, text: str) -> None:
    plain, odd = named(midterm, "plain"), named(midterm, text)
    for like, shown, word in (
        (plain, odd, text),
        (plain.run(), odd.run(), text),
        (plain.run().events, odd.run().events, odd.ball_ids[0]),
    ):
        found = Page(shown._repr_html_())
        assert [tag for tag, _ in found.tags] == [tag for tag, _ in Page(like._repr_html_()).tags]
        assert word in found.text


def test_styles_stay_with_what_is_shown(midterm: carom.Scenario, run: carom.Run) -> None:
    for shown in (midterm, run, run.events):
        html = without_player(shown._repr_html_())
        assert not {"style", "script", "link"} & {tag for tag, _ in Page(html).tags}
        # What is black or white by itself cannot be read on a page of that colour.
        assert not re.search(r"[;\"]color:(?!inherit)", html)


def test_a_table_shows_its_first_rows_and_counts_the_others(run: carom.Run) -> None:
    text = Page(run.events._repr_html_()).text
    assert "EventTable, 12 rows" in text
    assert "0.86473 ball_ball red blue" in text
    assert "more" not in text
    long = Page(run.trajectory(run.sample_times(0.1))._repr_html_()).text
    assert "and 31 more rows" in long


def test_a_figure_is_the_value_of_a_cell(run: carom.Run) -> None:
    figure = carom.figures.figure_of(run.plot_paths())
    assert figure._repr_png_().startswith(b"\x89PNG")  # type: ignore[attr-defined]
