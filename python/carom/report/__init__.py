"""Runs and scenarios as pages: the report of a run, and what a notebook shows.

A page is one file of its own: it loads nothing and runs no script, what is written in a scenario is shown as text, and
the same run gives the same bytes.
"""

from carom.report.card import run_card, scenario_card, table_card
from carom.report.page import report_html, write_report
from carom.report.pictures import Picture, drawn, figures_of

__all__ = ["Picture", "drawn", "figures_of", "report_html", "run_card", "scenario_card", "table_card", "write_report"]
