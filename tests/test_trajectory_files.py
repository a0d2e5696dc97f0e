"""Files of one's own trajectory: how columns are named, what is read though it is odd, and what is wrong where."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import course_scheme as course
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom import Scenario, TrajectoryError, compare_trajectory

COLUMNS = "t,xr,yr,xb,yb"


def problems_of(scenario: Scenario, path: Path, text: str | bytes, **options: Any) -> list[tuple[str, str]]:
    """Give the problems of a file, with ``mine`` for its name."""
    path = path / "mine.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(TrajectoryError) as error:
        compare_trajectory(scenario, path, **options)
    return [(place.replace(str(path), "mine"), message) for place, message in error.value.problems]


# How columns are named


def test_carom_s_own_tables_need_no_names(midterm: Scenario, scheme: Scenario, tmp_path: Path) -> None:
    run = scheme.run()
    assert run.steps is not None
    for name, table in (("trajectory", run.trajectory(run.sample_times(0.01))), ("steps", run.steps)):
        table.to_csv(tmp_path / f"{name}.csv")
        comparison = compare_trajectory(scheme, tmp_path / f"{name}.csv")
        assert comparison
        assert any(note.startswith("columns not compared: ") and "red.vx" in note for note in comparison.notes)


def test_some_balls_may_be_left_out(right: list[course.Row], scheme: Scenario, tmp_path: Path) -> None:
    path = course.write(tmp_path / "mine.csv", right)
    comparison = compare_trajectory(scheme, path, columns="time=t, blue.y=yb, blue.x=xb")
    assert comparison
    assert comparison.balls == ["blue"]
    assert comparison.columns == {"time": "t", "blue.x": "xb", "blue.y": "yb"}
    assert comparison.notes[1:] == ["columns not compared: xr, yr", "balls not compared: red"]


def test_without_a_header_columns_are_named_by_place(scheme: Scenario, right: list[course.Row], tmp_path: Path) -> None:
    path = tmp_path / "mine.csv"
    course.write(path, [(*row, 7.0) for row in right], header="")  # type: ignore[misc]
    comparison = compare_trajectory(scheme, path, columns=f"{COLUMNS},")
    assert comparison
    assert comparison.columns["blue.x"] == "4"
    assert "as there is no header" in comparison.notes[0]
    assert compare_trajectory(scheme, path, columns={"time": "1", "blue.x": "4", "blue.y": "5"})


@given(
    order=st.permutations(range(7)),
    names=st.lists(
        st.text(st.characters(exclude_characters='"#%=,;\r\n\x00', exclude_categories=("Cs", "Cc", "Z")), min_size=1),
        min_size=7,
        max_size=7,
        unique=True,
    ).filter(lambda names: not all(re.fullmatch(r"[-+.\dEeinfatyINFATY]*", name) for name in names)),
    delimiter=st.sampled_from(",;\t"),
    explicit=st.booleans(),
    end=st.sampled_from(["\n", "\r\n"]),
)
def test_any_order_and_names_of_columns_give_the_same(
    order: list[int],
    names: list[str],
    delimiter: str,
    explicit: bool,
    end: str,
    tmp_path_factory: pytest.TempPathFactory,
) -> None:
    scenario = carom.load("midterm")
    run = scenario.run()
    table = run.trajectory(np.linspace(0.0, 5.0, 12)).to_dict()
    roles = ["time", "red.x", "red.y", "blue.x", "blue.y", "red.vx", "blue.vx"]
    written = {names[place]: table[roles[place]] for place in order}
    path = tmp_path_factory.mktemp("any") / "mine.csv"
    rows = zip(*written.values(), strict=True)
    lines = [delimiter.join(written), *(delimiter.join(map(repr, map(float, row))) for row in rows)]
    path.write_text(end.join(lines), encoding="utf-8", newline="")
    wanted = dict(zip(roles[:5], names[:5], strict=True))
    comparison = compare_trajectory(scenario, path, columns=wanted if explicit else names[:5], delimiter=delimiter)
    assert comparison
    assert comparison.largest == 0.0
    assert comparison.columns == wanted


@pytest.mark.parametrize(
    ("columns", "words"),
    [
        ("t,xr,yr", "3 names, and 5 are needed, for time, red.x, red.y, blue.x, blue.y"),
        ("time=t,red.x=xr", "red.x is named, and red.y is not"),
        ("red.x=xr,red.y=yr", "the column of the time is not named"),
        ("time=t", "no ball is named"),
        ("time=t,rde.x=xr,red.y=yr", "nothing is called 'rde.x'; the nearest is 'red.x'"),
        ("time=t,red.x=xr,red.x=xr", "red.x is given twice"),
        ("time=t,xr,yr", "'xr' is not WHAT=NAME"),
        ("t,xr,yr,xb,yB", "no column 'yB'; the nearest is 'yb'"),
        ("t,xr,yr,xr,yr", "column 'xr' is to be both red.x and blue.x"),
        ("t,xr,yr,xb,z", "columns: t, xr, yr, xb, yb"),
        (None, "none of the columns time, red.x, red.y, blue.x, blue.y is in it"),
    ],
)
def test_columns_named_wrongly_are_errors(
    scheme: Scenario, right: list[course.Row], tmp_path: Path, columns: str | None, words: str
) -> None:
    course.write(tmp_path / "mine.csv", right)
    with pytest.raises(TrajectoryError, match=re.escape(words)):
        compare_trajectory(scheme, tmp_path / "mine.csv", columns=columns)


def test_no_header_and_no_names_is_an_error(scheme: Scenario, right: list[course.Row], tmp_path: Path) -> None:
    text = "\n".join(",".join(map(repr, row)) for row in right)
    (problem,) = problems_of(scheme, tmp_path, f"# t xr yr xb yb\n{text}")
    assert problem[1].startswith("no header: name its 5 columns in order with --columns, for time, red.x")
    assert problem[1].endswith("(its comment says: # t xr yr xb yb)")
    (problem,) = problems_of(scheme, tmp_path, text, columns="t,x,y")
    assert problem == (
        "--columns",
        problem[1],
    )
    assert problem[1].startswith("3 names for the 5 columns of")


# Files that are odd but sound


@pytest.mark.parametrize(
    "change",
    [
        lambda text: "\ufeff" + text,
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text + "\n\n   \n",
        lambda text: "\n\n" + text.replace("\n", "\n\n"),
        lambda text: re.sub(r"([^,\n]+)", r'"\1"', text),
        lambda text: text.replace(",", " , "),
        lambda text: "# made by me\n% and by MATLAB\n" + text,
        lambda text: text.rstrip("\n"),
    ],
    ids=["mark", "crlf", "blank end", "blank lines", "quotes", "spaces", "comments", "no last end"],
)
def test_odd_files_are_read(
    scheme: Scenario, right: list[course.Row], tmp_path: Path, change: Callable[[str], str]
) -> None:
    path = course.write(tmp_path / "mine.csv", right)
    path.write_text(change(path.read_text(encoding="utf-8")), encoding="utf-8", newline="")
    assert compare_trajectory(scheme, path, columns=COLUMNS)


def test_lines_are_counted_with_the_empty_ones(scheme: Scenario, right: list[course.Row], tmp_path: Path) -> None:
    rows = list(right)
    rows[3] = (rows[3][0], 0.5, *rows[3][2:])
    path = course.write(tmp_path / "mine.csv", rows)
    path.write_text("# note\n\n" + path.read_text(encoding="utf-8").replace("\n", "\n\n"), encoding="utf-8")
    first = compare_trajectory(scheme, path, columns=COLUMNS).first_difference
    assert first is not None
    assert path.read_text(encoding="utf-8").splitlines()[int(first.where.split()[1]) - 1].split(",")[1] == "0.5"


@pytest.mark.parametrize("delimiter", [";", "\t", " "])
def test_delimiters_are_as_told(scheme: Scenario, right: list[course.Row], tmp_path: Path, delimiter: str) -> None:
    path = course.write(tmp_path / "mine.csv", right, COLUMNS.replace(",", delimiter), delimiter)
    assert compare_trajectory(scheme, path, columns=COLUMNS, delimiter=delimiter)
    if delimiter != " ":
        return
    np.savetxt(path, right)
    assert compare_trajectory(scheme, path, columns=COLUMNS, delimiter=" ")


# Files that are wrong


HEAD = "t,xr,yr,xb,yb\n0,0.1,0.1,0.5,1\n"


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("", [("mine", "holds no line of a table")]),
        ("# only this\n", [("mine", "holds no line of a table")]),
        ("t,xr,yr,xb,yb\n", [("mine", "a header and no rows")]),
        (HEAD + "0.03,abc,0.2,0.5,1\n", [("mine, line 3, xr", "'abc' is not a number")]),
        (HEAD + "0.03,0.1,0.2,0.5,\n", [("mine, line 3, yb", "is empty")]),
        (HEAD + "0.03,0.1,0.2,0.5\n", [("mine, line 3", "4 columns, and the header has 5")]),
        (HEAD + "\n0.03,0.1,0.2,0.5,1,9\n", [("mine, line 4", "6 columns, and the header has 5")]),
        (HEAD.replace("0.1,0.1", "0.1,nan"), [("mine, line 2, yr", "must be finite, got nan")]),
        (HEAD.replace("0.1,0.1", "0.1,1e999"), [("mine, line 2, yr", "must be finite, got inf")]),
        (HEAD + "nan,0.1,0.1,0.5,1\n", [("mine, line 3, t", "must be finite, got nan")]),
        ("sep=;\n" + HEAD, [("mine, line 1", "its first line says that ';' is the delimiter, not ','")]),
        (HEAD + "0.0,0.1,0.2,0.5,1\n", [("mine, line 3", "times must ascend: 0 stands twice")]),
        (HEAD + "2,0.1,0.2,0.5,1\n1,0,0,0,0\n", [("mine, line 4", "times must ascend: 1 comes after 2")]),
        (HEAD.replace("\n0", "\n-1"), [("mine, line 2", "the time is negative: -1")]),
        (HEAD + "# end\n", [("mine, line 3", "1 columns, and the header has 5")]),
        (
            HEAD.replace("yr", "xr"),
            [("mine", "2 columns are called 'xr'"), ("mine", "no column 'yr'; the nearest is 'yb'")],
        ),
        (HEAD + "1_0,0.1,0.2,0.5,1\n", [("mine, line 3, t", "'1_0' is not a number")]),
        (
            "t,xr,yr,xb,yb\n" + "0,03,0,1,0,1,0,5,1,0\n",
            [("mine, line 2", "10 columns, and the header has 5; are these")],
        ),
        (b"t,xr,yr,xb,yb\n0,0,0,0,\xff\n", [("mine", "not a text in UTF-8 (line 2, byte 0xff); save it as")]),
        (
            b"t,xr,yr,xb,yb\n" + b"0,0,0,0,0\n" * 9000 + b"\xff",
            [("mine", "not a text in UTF-8 (line 9002, byte 0xff)")],
        ),
        (HEAD.encode("utf-16"), [("mine", 'a text in UTF-16; save it as "CSV UTF-8"')]),
    ],
)
def test_a_wrong_file_is_an_error_with_its_place(
    scheme: Scenario, tmp_path: Path, text: str | bytes, wanted: list[tuple[str, str]]
) -> None:
    found = problems_of(scheme, tmp_path, text, columns=COLUMNS)
    for (place, message), (wanted_place, wanted_message) in zip(found, wanted, strict=False):
        assert place == wanted_place
        assert message.startswith(wanted_message)
    assert len(found) >= len(wanted)


def test_many_problems_are_counted(scheme: Scenario, tmp_path: Path) -> None:
    lines = [f"{t},x,0.2,0.5,1" for t in range(1, 101)]
    found = problems_of(scheme, tmp_path, HEAD + "\n".join(lines), columns=COLUMNS)
    assert [place for place, _ in found] == [*(f"mine, line {line}, xr" for line in range(3, 8)), "mine"]
    assert found[-1][1] == "and 95 more values that are no numbers"
    text = HEAD + "\n".join("nan,0.1,0.2,0.5,1" for _ in range(100))
    assert problems_of(scheme, tmp_path, text, columns=COLUMNS)[-1][1] == "and 95 more values that are not finite"


def test_another_delimiter_is_named(scheme: Scenario, tmp_path: Path) -> None:
    for delimiter, name in ((";", "';'"), ("\t", "tab"), (" ", "space")):
        text = HEAD.replace(",", delimiter)
        found = problems_of(scheme, tmp_path, text, columns=COLUMNS)
        assert f"it has 1 column; with {name} as delimiter it has 5: --delimiter {name}" in found[-1][1]
        without = problems_of(scheme, tmp_path, text.split("\n")[1], columns=COLUMNS)
        assert f"--delimiter {name}" in without[-1][1]


def test_decimal_commas_are_named(scheme: Scenario, tmp_path: Path) -> None:
    text = "t;xr;yr;xb;yb\n0;0,1;0,1;0,5;1\n"
    found = problems_of(scheme, tmp_path, text, columns=COLUMNS, delimiter=";")
    assert found[0] == (
        "mine, line 2, xr",
        "'0,1' has a decimal comma: --decimal , reads it (Python: decimal=',')",
    )


@pytest.mark.parametrize("header", ["t;xr;yr;xb;yb", ""])
@pytest.mark.parametrize("before", ["", "sep=;\n", "# from Excel\n"])
def test_decimal_commas_are_read(
    scheme: Scenario, right: list[course.Row], tmp_path: Path, header: str, before: str
) -> None:
    path = course.write(tmp_path / "mine.csv", right, header, ";")
    path.write_text(before + path.read_text(encoding="utf-8").replace(".", ","), encoding="utf-8-sig")
    assert compare_trajectory(scheme, path, columns=COLUMNS, delimiter=";", decimal=",")
    path.write_text(path.read_text(encoding="utf-8-sig") + "5,1;x;0;0;0\n", encoding="utf-8")
    with pytest.raises(TrajectoryError, match="'x' is not a number"):
        compare_trajectory(scheme, path, columns=COLUMNS, delimiter=";", decimal=",")


def test_the_decimal_mark_is_a_point_or_a_comma_and_not_the_delimiter(scheme: Scenario, tmp_path: Path) -> None:
    for decimal in (",", "x", ""):
        with pytest.raises(ValueError, match="decimal: must be"):
            compare_trajectory(scheme, tmp_path, decimal=decimal)


def test_as_many_other_names_are_told_in_order(scheme: Scenario, tmp_path: Path) -> None:
    text = HEAD.replace("t,xr,yr,xb,yb", "time in s,x red,y red,x blue,y blue")
    found = problems_of(scheme, tmp_path, text, columns=COLUMNS)
    assert found[-1][1].endswith('--columns "time in s,x red,y red,x blue,y blue"')
    fewer = problems_of(scheme, tmp_path, text.replace(",y blue", ""), columns=COLUMNS)
    assert "in that order" not in fewer[-1][1]


def test_times_after_the_end_are_an_error_that_says_how_to_go_on(midterm: Scenario, tmp_path: Path) -> None:
    text = HEAD.replace("t,xr,yr,xb,yb", "time,red.x,red.y,blue.x,blue.y") + "6,0,0,0,0\n7,0,0,0,0\n"
    found = problems_of(midterm, tmp_path, text)
    assert found[0] == ("mine, line 3", "t = 6 is after the run's end")
    assert found[-1] == ("mine", "the run ends at t = 5; --duration sets another end, or compares a part")


def test_what_is_no_file_is_an_error(midterm: Scenario, tmp_path: Path) -> None:
    for path, words in ((tmp_path / "none.csv", "no such file"), (tmp_path, "not a file")):
        with pytest.raises(TrajectoryError, match=words):
            compare_trajectory(midterm, path)
