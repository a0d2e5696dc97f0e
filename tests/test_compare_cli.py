"""``carom compare``: what it prints and writes, its exit codes, and which flags belong together."""

import json
from pathlib import Path

import course_scheme as course
import pytest
from test_cli import fine, names_in, rows_of, shell

import carom

NAMES = ("--columns", "t,xr,yr,xb,yb")
NUDGE = "balls.red.velocity[0]=3.1"


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    return course.write(tmp_path / "mine.csv", course.simulate())


# Two runs


def test_two_scenarios_are_compared() -> None:
    printed = fine("compare", "midterm", "midterm_stepped")
    verdict, events, *rest = printed.splitlines()
    assert verdict.startswith("the events differ; the largest distance is 0.4")
    assert "blue meets the left cushion at t = 3.68773 in midterm, the top cushion" in events
    assert "- method.kind: absent | stepped" in rest
    head = rest.index("ball\tlargest\tat\tover_1e-12\tover_1e-09\tover_1e-06\tover_0.001")
    assert [line.split("\t")[0] for line in rest[head + 1 :]] == ["red", "blue"]


def test_a_scenario_is_compared_with_its_variant() -> None:
    found = json.loads(fine("compare", "midterm", "--set-b", NUDGE, "--json"))
    assert found["changes"] == [{"value": "balls.red.velocity[0]", "a": 3.0, "b": 3.1}]
    assert found["first_difference"]["a"]["time"] == pytest.approx(1.78509, abs=1e-5)
    assert found["first_difference"]["ball"] == "red"
    assert found["same_bits"] is False
    two = json.loads(fine("compare", "midterm", "--set-a", NUDGE, "--set", "duration=2", "--json"))
    assert two["end_time"] == 2.0
    assert (two["changes"][0]["a"], two["changes"][0]["b"]) == (3.1, 3.0)


def test_saved_runs_are_told_from_scenarios_by_their_content(tmp_path: Path, run: carom.Run) -> None:
    run.save(tmp_path / "run.json")
    carom.load("midterm").save(tmp_path / "scenario.json")
    found = json.loads(fine("compare", tmp_path / "run.json", tmp_path / "scenario.json", "--json"))
    assert found["same_bits"] is True
    assert (found["a"], found["b"]) == ("run.json", "scenario.json")


def test_a_tolerance_decides_on_the_exit_code() -> None:
    words = ("compare", "midterm", "--set-b", "balls.red.velocity[0]=3.000001", "--duration", "1")
    assert shell(*words).code == 0
    assert "tolerance 0.1: never farther apart" in fine(*words, "--tolerance", "0.1")
    done = shell(*words, "--tolerance", "1e-9")
    assert (done.code, done.stderr) == (1, "")
    assert "tolerance 1e-09: farther apart from t = " in done.stdout
    assert json.loads(shell(*words, "--tolerance", "1e-9", "--json").stdout)["within"] is False


def test_two_runs_write_tables_and_figures(tmp_path: Path) -> None:
    out = tmp_path / "out"
    words = ("compare", "midterm", "midterm_stepped", "--out", out)
    printed = fine(*words, "--format", "svg")
    assert names_in(out) == {"comparison.csv", "balls.csv", "changes.csv", "distance.svg", "overlay.svg"}
    assert f"written to {out}: comparison.csv balls.csv" in printed
    rows = rows_of(out / "comparison.csv")
    assert float(rows[-1]["time"]) == 5.0
    comparison = carom.compare(carom.load("midterm"), carom.load("midterm_stepped"))
    assert [float(row["red.distance"]) for row in rows] == comparison.table["red.distance"].tolist()
    assert shell(*words).code == 2
    fine("compare", "midterm", "--dt", "0.03", "--out", out, "--overwrite")
    assert names_in(out) == {"comparison.csv", "errors.png"}


# A trajectory


def test_a_teacher_grades_three_files(tmp_path: Path) -> None:
    right = course.simulate()
    course.write(tmp_path / "anna.csv", right)
    course.write(tmp_path / "ben.csv", course.simulate(mistake="swapped"))
    course.write(tmp_path / "cleo.csv", course.without(right, 40))
    graded = {
        name: shell("compare", "midterm_stepped", "--with", tmp_path / f"{name}.csv", *NAMES)
        for name in ("anna", "ben", "cleo")
    }
    assert {name: done.code for name, done in graded.items()} == {"anna": 0, "ben": 1, "cleo": 1}
    assert all(done.stderr == "" for done in graded.values())
    assert graded["anna"].stdout.startswith("agrees: 168 rows of red, blue")
    assert "the normal with its components exchanged" in graded["ben"].stdout
    assert "the first row that differs is line 34, t = 0.96" in graded["ben"].stdout
    assert "a row is missing between line 41 and line 42" in graded["cleo"].stdout


def test_a_student_is_told_his_reading(tmp_path: Path) -> None:
    path = course.write(tmp_path / "mine.csv", course.simulate(restart=True, normal="contact"))
    words = ("compare", "midterm", "--dt", "0.03", "--with", path, *NAMES)
    done = shell(*words)
    assert done.code == 1
    assert "it agrees with another reading of the method, after_hit = restart, normal = contact" in done.stdout
    found = json.loads(shell(*words, "--json").stdout)
    (reading,) = [row for row in found["readings"] if row["agrees"]]
    assert (reading["after_hit"], reading["normal"], reading["last_step"]) == ("restart", "contact", "short")
    told = ("--set", "method.after_hit=restart", "--set", "method.normal=contact")
    fine("compare", "midterm_stepped", *told, "--with", path, *NAMES)


def test_the_method_may_be_told(mine: Path) -> None:
    words = ("compare", "midterm", "--with", mine, *NAMES)
    done = shell(*words)
    assert done.code == 1
    assert "--method stepped --dt 0.03 compares it with the fixed-step method" in done.stdout
    fine(*words, "--method", "stepped", "--dt", "0.03")
    fine(*words, "--dt", "0.03")
    assert shell("compare", "midterm_stepped", "--method", "exact", "--with", mine, *NAMES).code == 1


def test_json_holds_the_verdict_and_its_reasons(tmp_path: Path) -> None:
    path = course.write(tmp_path / "mine.csv", course.simulate(mistake="missed"))
    done = shell("compare", "midterm_stepped", "--with", path, *NAMES, "--json")
    assert done.code == 1
    found = json.loads(done.stdout)
    assert found["agrees"] is False
    assert found["first_difference"]["where"] == "line 33"
    assert found["columns"] == {"time": "t", "red.x": "xr", "red.y": "yr", "blue.x": "xb", "blue.y": "yb"}
    assert found["reasons"][-1] == "in the file both balls go straight on: this collision is missing"
    assert [row["ball"] for row in found["balls"]] == ["red", "blue"]
    assert len(found["readings"]) == 8


def test_a_trajectory_writes_tables_and_figures(tmp_path: Path) -> None:
    path = course.write(tmp_path / "mine.csv", course.simulate(mistake="whole"))
    out = tmp_path / "out"
    done = shell("compare", "midterm_stepped", "--with", path, *NAMES, "--out", out, "--format", "svg")
    assert (done.code, done.stderr) == (1, "")
    assert names_in(out) == {"comparison.csv", "balls.csv", "readings.csv", "distance.svg", "overlay.svg"}
    assert len(rows_of(out / "comparison.csv")) == 168
    assert [row["agrees"] for row in rows_of(out / "readings.csv")] == ["False"] * 8


def test_a_file_that_cannot_be_read_is_one_line_for_each_problem(tmp_path: Path) -> None:
    path = tmp_path / "mine.csv"
    path.write_text("t,xr,yr,xb,yb\n0,a,0,0,0\n1,0,0,0\n", encoding="utf-8")
    done = shell("compare", "midterm", "--with", path, *NAMES)
    assert (done.code, done.stdout) == (2, "")
    assert done.stderr.splitlines() == [
        f"error: {path}, line 3: 4 columns, and the header has 5",
        f"error: {path}, line 2, xr: 'a' is not a number",
    ]


@pytest.mark.parametrize(("word", "delimiter"), [(";", ";"), ("tab", "\t"), ("\\t", "\t"), ("space", "  ")])
def test_delimiters_have_names(tmp_path: Path, word: str, delimiter: str) -> None:
    header = "t,xr,yr,xb,yb".replace(",", delimiter)
    path = course.write(tmp_path / "mine.csv", course.simulate(), header, delimiter)
    fine("compare", "midterm_stepped", "--with", path, *NAMES, "--delimiter", word)


def test_a_file_of_german_excel_is_read(tmp_path: Path) -> None:
    path = course.write(tmp_path / "mine.csv", course.simulate(), "Zeit;x rot;y rot;x blau;y blau", ";")
    path.write_text("sep=;\n" + path.read_text(encoding="utf-8").replace(".", ","), encoding="utf-8-sig")
    words = ("compare", "midterm_stepped", "--with", path)
    assert "--delimiter ';'" in shell(*words, *NAMES).stderr
    assert '--columns "Zeit,x rot,y rot,x blau,y blau"' in shell(*words, *NAMES, "--delimiter", ";").stderr
    words = (*words, "--delimiter", ";", "--columns", "Zeit,x rot,y rot,x blau,y blau")
    assert "--decimal ," in shell(*words).stderr
    fine(*words, "--decimal", ",")


@pytest.mark.parametrize(
    "words",
    [
        ("midtrem", "--with", "mine.csv"),
        ("midterm", "--with", "none.csv"),
        ("midterm", "--with", "mine.csv"),
        ("midterm", "midtrem"),
        ("midterm", "--dt", "x"),
    ],
)
def test_what_could_not_be_compared_is_told_from_what_differs(
    words: tuple[str, ...], mine: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(mine.parent)
    done = shell("compare", *words)
    assert (done.code, done.stdout) == (2, "")
    assert "error" in done.stderr.lower()


def test_a_reading_that_lacks_something_says_so(tmp_path: Path) -> None:
    path = course.write(tmp_path / "mine.csv", course.simulate(restart=True, full=True))
    words = ("compare", "midterm_stepped", "--with", path, *NAMES)
    done = shell(*words)
    note = "after_hit = restart, normal = before, last_step = short has all its rows within the tolerance, but does not"
    assert f"{note} agree: 1 row is after the run's end at t = 5" in done.stdout
    assert "why" not in done.stdout
    why = {row["why"] for row in json.loads(shell(*words, "--json").stdout)["readings"]}
    assert len(why) == 2
    assert any(each.startswith("1 row is after the run's end") for each in why)


def test_a_saved_run_is_compared_with_a_file(tmp_path: Path, mine: Path, stepped: carom.Run) -> None:
    stepped.save(tmp_path / "run.json")
    fine("compare", tmp_path / "run.json", "--with", mine, *NAMES)
    fine("compare", tmp_path / "run.json", "--with", mine, *NAMES, "--duration", "3")


# Usage


@pytest.mark.parametrize(
    ("words", "flag", "why"),
    [
        (("midterm", "midterm", "--dt", "0.1"), "--dt", "two runs are compared as they are"),
        (("midterm", "midterm", "--columns", "t"), "--columns", "two runs"),
        (("midterm", "--columns", "t"), "--columns", "belongs to --with FILE"),
        (("midterm", "--tolerance", "1"), "--tolerance", "it belongs to B or --with FILE"),
        (("midterm", "--method", "exact"), "--method", "belongs to --with FILE"),
        (("midterm", "midterm", "--with", "x.csv"), "B", "--with compares FILE with A alone"),
        (("midterm", "--set-b", "duration=1", "--with", "x.csv"), "--set-b", "--with compares FILE with A alone"),
        (("midterm", "--with", "x.csv", "--dt", "0.1,0.2"), "--dt", "one time step"),
        (("midterm", "--with", "x.csv", "--method", "exact", "--dt", "0.1"), "--dt", "belongs to --method stepped"),
        (("midterm", "--with", "x.csv", "--delimiter", "ab"), "--delimiter", "one character, tab or space"),
        (("midterm", "--with", "x.csv", "--decimal", "x"), "--decimal", "neither . nor ,"),
        (("midterm", "--with", "x.csv", "--decimal", ","), "--decimal", "the delimiter already"),
        (("midterm", "midterm", "--decimal", ","), "--decimal", "two runs"),
        (("midterm", "--with", "x.csv", "--tolerance", "-1"), "--tolerance", "must be zero or positive and finite"),
        (("midterm", "midterm", "--tolerance", "nan"), "--tolerance", "must be zero or positive and finite"),
        (("midterm", "--with", "x.csv", "--tolerance", "inf"), "--tolerance", "must be zero or positive and finite"),
        (("run.json",), "A", "is a saved run"),
        (("run.json", "midterm", "--set", "duration=1"), "--set", "a saved run, which stays as it is"),
        (("midterm", "run.json", "--set-b", "duration=1"), "--set-b", "a saved run, which stays as it is"),
        (("midterm", "run.json", "--duration", "1"), "--duration", "a saved run, which stays as it is"),
        (("run.json", "--with", "x.csv", "--dt", "0.1"), "--dt", "a saved run, which stays as it is"),
        (("midterm", "midterm", "--out", ""), "--out", "needs the name of a folder"),
    ],
)
def test_flags_that_do_not_belong_together_are_refused(
    words: tuple[str, ...], flag: str, why: str, tmp_path: Path, run: carom.Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    run.save("run.json")
    done = shell("compare", *words)
    assert (done.code, done.stdout) == (2, "")
    assert f"Invalid value for {flag}" in done.stderr.replace("'", "")
    assert why in done.stderr
    assert names_in(tmp_path) == {"run.json"}


def test_on_a_terminal_long_sentences_are_wrapped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from carom.cli.output import print_paragraphs

    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    printed: list[str] = []
    monkeypatch.setattr("builtins.print", printed.append)
    print_paragraphs([("- ", "word " * 30)])
    assert max(map(len, printed)) <= 60
    assert printed[0].startswith("- word")
    assert printed[1].startswith("  word")
