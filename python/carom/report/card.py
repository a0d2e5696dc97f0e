"""What a notebook shows: of a scenario and of a run a small picture with facts beside it, of a table its head."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

from carom.report.page import template
from carom.report.pictures import data_uri
from carom.report.results import count_events, facts, verdict
from carom.report.rows import Row
from carom.report.text import column, counted
from carom.summary import facts_of_scenario

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from carom.columns import ColumnTable
    from carom.run import Run
    from carom.scenario import Scenario

WIDEST, HIGHEST = 2.6, 2.6  # inches
DPI = 160
CSS_DPI = 96
MOST_ROWS, MOST_COLUMNS = 20, 16
MOST_PATHS, MOST_PLACES = 200, 5e5


def scenario_card(scenario: Scenario) -> str:
    """Give a scenario as a piece of HTML: how it starts, and what it says."""
    ax = _small_axes(scenario)
    from carom import figures

    figures.plot_scenario(scenario, ax=ax)
    rows = [Row(name, value) for name, value in facts_of_scenario(scenario)]
    balls = counted(len(scenario.balls), "ball")
    return _card(scenario.title or "Scenario", scenario.description, rows, ax, f"The table from above with {balls}.")


def run_card(run: Run) -> str:
    """Give a run as a piece of HTML: its paths, or its start where they were not kept; how it ended; and its player."""
    from carom.studio.player import frame_or_reason

    scenario = run.scenario
    ax = _small_axes(scenario)
    from carom import figures

    if run.record == "all" and _few_paths(run):
        figures.plot_paths(run, ax=ax, numbers=False)
        alt = f"The table from above with the paths of {counted(len(run.ball_ids), 'ball')}."
    else:
        figures.plot_scenario(scenario, ax=ax)
        alt = f"The table from above with {counted(len(run.ball_ids), 'ball')} at the start."
    rows = [Row(row.name, f"{row.value} ({row.note})" if row.note else row.value) for row in facts(run)]
    rows += [Row("digest", run.digest)] if run.digest else []
    frame, reason = frame_or_reason(run)
    rows += [Row("player", reason)] if reason else []
    head = f"Run of {scenario.title}" if scenario.title else "Run"
    return f"{_card(head, verdict(run), rows, ax, alt)}{frame}\n"


def table_card(table: ColumnTable, head: str) -> str:
    """Give a table as a piece of HTML: its first rows, rounded."""
    columns = {name: table[name][:MOST_ROWS] for name in table.names[:MOST_COLUMNS]}
    numeric = [values.dtype.kind in "fiu" for values in columns.values()]
    texts = [column(values) if values.dtype.kind == "f" else _words(values) for values in columns.values()]
    return template("table.html").render(
        head=head,
        names=list(columns),
        numeric=numeric,
        rows=list(zip(*texts, strict=True)),
        more_rows=max(len(table) - MOST_ROWS, 0),
        more_columns=max(len(table.names) - MOST_COLUMNS, 0),
    )


def _words(values: NDArray[Any]) -> list[str]:
    return ["" if value is None else str(value) for value in values.tolist()]


def _few_paths(run: Run) -> bool:
    """Tell whether the paths are drawn in a moment."""
    balls = len(run.ball_ids)
    return balls <= MOST_PATHS and balls * (1000 + count_events(run)) <= MOST_PLACES


def _small_axes(scenario: Scenario) -> Axes:
    """Make an axes that fills a small figure, in the table's proportions."""
    from carom.figures.scene import Scene
    from carom.figures.style import new_figure
    from carom.figures.table import framed_ratio

    ratio = framed_ratio(Scene.of(scenario))
    width = min(WIDEST, HIGHEST / ratio)
    ax = new_figure(width, width * ratio).add_axes((0.0, 0.0, 1.0, 1.0))
    ax.set_axis_off()
    return ax


def _card(head: str, text: str, rows: list[Row], ax: Axes, alt: str) -> str:
    from carom.figures import figure_of

    figure = figure_of(ax)
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=DPI)
    width, height = (round(size * CSS_DPI) for size in figure.get_size_inches())
    return template("card.html").render(
        head=head, text=text, rows=rows, picture=data_uri(file.getvalue()), alt=alt, width=width, height=height
    )
