"""The report of a run: one page that needs nothing else, shows everything, and shows text as text."""

import re
from base64 import b64decode
from html.parser import HTMLParser
from pathlib import Path

import pytest

import carom
from carom.cli.options import command_line
from carom.report import report_html
from carom.report.parameters import MOST_BALLS
from carom.report.words import DIAGNOSTICS, KINDS, QUANTITIES, STATUSES

HTML_TEXTS = ["<img src=x onerror=alert(1)>", '"><script>alert(1)</script>', "'&amp;<b>", "</style></pre>{{ 7 * 7 }}"]
VOID = {"meta", "img", "br", "link", "input"}
CELLS = {"td", "th", "dt", "dd"}


class Page(HTMLParser):
    """A page taken apart: its tags in order, and its text."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=True)
        self.tags: list[tuple[str, dict[str, str]]] = []
        self.texts: list[str] = []
        self.open: list[str] = []
        self.feed(html)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, {name: value or "" for name, value in attrs}))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag
        self.texts.append(" " if tag in CELLS else "")

    def handle_data(self, data):
        self.texts.append(data)

    @property
    def text(self) -> str:
        """All text, its spaces made one."""
        return " ".join("".join(self.texts).split())

    def all(self, tag: str) -> list[dict[str, str]]:
        return [attributes for name, attributes in self.tags if name == tag]


@pytest.fixture(scope="module")
def html(run: carom.Run) -> str:
    return report_html(run)


@pytest.fixture(scope="module")
def page(html: str) -> Page:
    return Page(html)


def without_pictures(run: carom.Run) -> Page:
    return Page(report_html(run, pictures={}))


def named(midterm: carom.Scenario, text: str) -> carom.Scenario:
    """The midterm with a text as title, description and unit, and what of it an id may hold as two of them."""
    name = "".join(letter for letter in text if letter not in "\"'/")
    values = midterm.to_dict() | {"title": text, "description": text, "units": {"length": text}}
    values["balls"][0]["id"] = name
    values["table"]["obstacles"] = [{"circle": {"center": [0.8, 1.8], "radius": 0.05}, "id": name}]
    return carom.Scenario.from_dict(values)


# Self-contained


def test_a_report_loads_nothing_and_runs_nothing(html: str, page: Page) -> None:
    assert not page.all("script")
    assert not page.all("link")
    for _, attributes in page.tags:
        assert not [name for name in attributes if name.startswith("on")]
        for name in ("src", "href", "srcset", "action", "data", "poster", "background"):
            assert attributes.get(name, "#").startswith(("#", "data:image/png;base64,")), attributes
    style = re.search(r"<style>(.*?)</style>", html, re.DOTALL)
    assert style is not None
    assert "url(" not in style[1]
    assert "@import" not in style[1]


def test_the_browser_is_told_to_load_nothing(page: Page) -> None:
    (policy,) = [meta["content"] for meta in page.all("meta") if meta.get("http-equiv") == "Content-Security-Policy"]
    rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
    assert rules["default-src"] == "'none'"
    assert rules["img-src"] == "data:"
    assert "script-src" not in rules


def test_links_lead_to_places_of_the_page(page: Page) -> None:
    ids = [attributes["id"] for _, attributes in page.tags if "id" in attributes]
    assert len(ids) == len(set(ids))
    assert {link["href"].removeprefix("#") for link in page.all("a")} <= set(ids)


@pytest.mark.parametrize("text", HTML_TEXTS)
def test_what_a_scenario_says_is_shown_as_text(midterm: carom.Scenario, text: str) -> None:
    plain = without_pictures(named(midterm, "plain").run())
    found = without_pictures(named(midterm, text).run())
    assert [tag for tag, _ in found.tags] == [tag for tag, _ in plain.tags]
    assert [text in part for part in found.texts].count(True) >= 6
    assert found.text.count(named(midterm, text).ball_ids[0]) >= 4
    assert "49" not in [word.strip() for word in found.texts]


def test_events_have_the_index_of_the_file_and_their_place_is_explained(run: carom.Run, html: str, page: Page) -> None:
    rows = re.findall(r'<tr><td class="number">(\d+)</td>', html)
    assert [int(number) for number in rows] == run.events["index"].tolist()
    assert "the point of contact" in page.text


def test_a_name_that_is_too_long_for_a_line_is_folded(midterm: carom.Scenario) -> None:
    post = {"circle": {"center": [0.5, 1.7], "radius": 0.05}, "id": "post" * 27}
    html = report_html(midterm.with_values({"table.obstacles": [post]}).run(), pictures={})
    assert f'<th scope="row" class="long">{"post" * 27}</th>' in html
    assert re.search(r"th\.long {[^}]*overflow-wrap: anywhere", html)


def test_paper_leaves_the_scenario_out_and_shows_upright_pictures_large(html: str) -> None:
    paper = html[html.index("@media print") : html.index("</style>")]
    assert "details.scenario { display: none; }" in paper
    assert re.search(r"\.picture\.upright img {[^}]*height: 205mm", paper)
    assert re.search(r"\.lead[^{]*{ break-after: avoid", paper)


def test_a_command_is_shown_as_text(run: carom.Run) -> None:
    command = command_line("run", "midterm", {"--set": ['title="</pre><script>x']})
    found = Page(report_html(run, pictures={}, command=command))
    assert command in found.text
    assert not found.all("script")


# The same run, the same file


def test_the_same_run_gives_the_same_bytes(midterm: carom.Scenario, html: str, tmp_path: Path) -> None:
    again = midterm.run()
    again.report(tmp_path / "report.html")
    assert (tmp_path / "report.html").read_bytes() == html.encode()
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]


# What it holds


def test_a_report_holds_the_run(run: carom.Run, html: str, page: Page) -> None:
    assert page.text.count(str(run.digest)) == 2
    for words in (
        "Ran to its time limit, at t = 5",
        "12 events: 1 ball_ball and 11 ball_cushion",
        "damping, factor 0.8",
    ):
        assert words in page.text
    assert run.scenario.to_toml() in "".join(page.texts)
    assert f"carom {carom.__version__} physics_version {carom.PHYSICS_VERSION}" in page.text
    assert len(page.all("img")) == 5
    rows = re.findall(r"<tr><td class=\"number\">(\d+)</td><td class=\"number\">([\d.]+)</td><td>(\w+)</td>", html)
    assert [int(number) for number, _, _ in rows] == list(range(12))
    assert [float(time) for _, time, _ in rows] == [pytest.approx(time, abs=5e-6) for time in run.events["time"]]
    assert [kind for _, _, kind in rows] == run.events["kind"].tolist()


def test_pictures_are_whole_and_described(page: Page) -> None:
    for picture in page.all("img"):
        data = b64decode(picture["src"].partition(",")[2])
        assert data.startswith(b"\x89PNG")
        assert data.endswith(b"IEND\xaeB`\x82")
        assert len(picture["alt"]) > 20
        assert int(picture["width"]) > 100


def test_heads_of_tables_say_what_they_head(page: Page) -> None:
    assert {head.get("scope") for head in page.all("th")} == {"col", "row"}
    assert page.all("html") == [{"lang": "en"}]
    assert len(page.all("h1")) == 1


def test_what_python_says_to_reproduce_a_run_does(
    run: carom.Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    html = report_html(run, pictures={})
    lines = next(block for block in re.findall(r"<pre>(.*?)</pre>", html, re.DOTALL) if "import carom" in block)
    monkeypatch.chdir(tmp_path)
    run.scenario.save("scenario.toml")
    exec(lines.replace("&#34;", '"'))
    changed = run.scenario.with_values({"duration": 4})
    changed.save("scenario.toml")
    with pytest.raises(AssertionError):
        exec(lines.replace("&#34;", '"'))


def test_a_run_ended_from_outside_is_reproduced_from_its_file(midterm: carom.Scenario) -> None:
    found = without_pictures(midterm.run(until="ball_ball"))
    assert "carom run scenario.toml" not in found.text
    assert 'carom.load_run("run.json")' in found.text


def test_every_diagnostic_and_status_is_explained(run: carom.Run) -> None:
    names = set(run.diagnostics) - {"events"}
    assert names == set(DIAGNOSTICS)
    assert set(QUANTITIES) <= names
    on_cloth = carom.load("nine_ball_break").run()
    assert set(run.diagnostics["events"]) | set(on_cloth.diagnostics["events"]) == set(KINDS)
    assert set(STATUSES) == {
        "time_limit",
        "collision_limit",
        "stopped",
        "at_rest",
        "collapsed",
        "event_limit",
        "interrupted",
        "miscue",
    }


def test_the_citation_is_that_of_the_project() -> None:
    assert carom.citation().splitlines()[0] in report_html(carom.load("midterm").run(), pictures={})


# Runs of every sort


@pytest.mark.parametrize("name", carom.scenarios())
def test_every_ready_made_scenario_has_a_report(name: str) -> None:
    scenario = carom.load(name)
    found = without_pictures(scenario.run(collisions=40, max_events=80))
    assert scenario.title in found.text
    assert "This report was made without figures." in found.text


@pytest.mark.parametrize("record", ["events", "none"])
def test_a_run_that_kept_little_says_so(midterm: carom.Scenario, run: carom.Run, record: str) -> None:
    found = Page(report_html(midterm.run(record=record)))
    assert f'There are no figures: the run kept no motion (record = "{record}").' in found.text
    assert ("The run kept no events" in found.text) == (record == "none")
    assert str(run.digest) in found.text


def test_a_stepped_run_tells_of_its_steps(stepped: carom.Run, midterm: carom.Scenario) -> None:
    found = without_pictures(stepped)
    assert "steps 167" in found.text
    assert "steps with a hit 11" in found.text
    assert "lost time 0.149" in found.text
    assert "after hit wait A ball that hit something waits there" in found.text
    assert "steps with a hit" not in without_pictures(midterm.run(method=carom.Stepped(0.03), record="events")).text


def test_a_run_without_events_has_a_report(midterm: carom.Scenario) -> None:
    for duration in (0.1, 0.0):
        found = Page(report_html(midterm.run(duration=duration)))
        assert "Nothing was hit." in found.text
        assert "There were none." in found.text
        assert len(found.all("img")) == 4


def test_a_run_that_collapsed_is_marked() -> None:
    ball = carom.Ball("a", radius=0.1, position=(0.5, 0.1))
    values = {"law": "restitution", "normal": 0.5}
    table = carom.Table.rectangle(width=1, length=1)
    balls = [ball, carom.Ball("b", radius=0.1, position=(0.5, 0.3))]
    physics = {"flight": {"law": "field", "acceleration": [0, -1]}, "ball_ball": values, "ball_cushion": values}
    run = carom.Scenario(table, balls, physics=physics, duration=5).run()
    assert run.status == "collapsed"
    found = Page(report_html(run))
    assert "Ended early: contacts followed each other without end" in found.text
    assert [tag for tag in found.all("p") if tag.get("class") == "verdict early"]


def test_a_long_run_shows_its_first_events_and_says_so() -> None:
    run = carom.load("fifty_random").run(duration=5)
    assert len(run.events) > 1000
    html = report_html(run, pictures={}, files=["events.csv"])
    assert f"The first 1000 of {len(run.events)} events, rounded; events.csv" in Page(html).text
    assert len(re.findall(r"<tr><td class=\"number\">", html)) == 1000


def test_many_balls_are_cut_short_and_counted() -> None:
    balls = [carom.Ball(f"b{k}", radius=0.1, position=(1 + k % 20, 1 + k // 20)) for k in range(300)]
    run = carom.Scenario(carom.Table.rectangle(width=21, length=17), balls, duration=1).run()
    found = without_pictures(run)
    assert f"These are the first {MOST_BALLS} of 300 balls" in found.text
    assert 'id = "b299"' in found.text


def test_units_stand_at_the_numbers() -> None:
    found = without_pictures(carom.load("pinball").run())
    assert "8 s" in found.text.replace("\N{NO-BREAK SPACE}", " ")
    assert "closing_speed (m/s)" in found.text


@pytest.mark.parametrize("name", ["$\\frac$", "$x$", "_hidden", "a $"])
def test_ids_that_matplotlib_would_read_as_something_else_are_drawn(midterm: carom.Scenario, name: str) -> None:
    run = midterm.with_values({"balls.red.id": name}).run()
    assert len(Page(report_html(run)).all("img")) == 5
    legend = run.plot_energy().get_legend()
    assert legend is not None
    assert legend.get_texts()[0].get_text().strip("\N{ZERO WIDTH SPACE}").replace(r"\$", "$") == name
