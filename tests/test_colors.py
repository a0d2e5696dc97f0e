"""Colours of balls may be written as CSS writes them."""

import pytest

import carom


def test_names_of_colours_ignore_case(midterm: carom.Scenario) -> None:
    from matplotlib.colors import to_rgba

    for color in ("RebeccaPurple", "DARKRED", "#AaBbCc"):
        variant = midterm.with_values({"balls.red.color": color})
        assert variant.to_dict()["balls"][0]["color"] == color
        assert to_rgba(color) == to_rgba(color.lower())
    with pytest.raises(carom.ScenarioError, match="did you mean rebeccapurple"):
        midterm.with_values({"balls.red.color": "RebecaPurple"})
