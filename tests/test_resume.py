"""A longer run asks for an end as any run does."""

import pytest

import carom


@pytest.mark.parametrize("method", [carom.Exact(), carom.Stepped(dt=0.03)], ids=["exact", "stepped"])
def test_resume_without_an_end_says_what_a_scenario_without_one_says(
    midterm: carom.Scenario, method: carom.Exact | carom.Stepped
) -> None:
    part = midterm.run(method=method)
    with pytest.raises(carom.ScenarioError, match="duration: missing"):
        part.resume()


def test_resume_without_an_end_goes_on_where_all_comes_to_rest() -> None:
    drop = carom.load("damped_drop")
    assert drop.run(collisions=3).resume().digest == drop.run(duration=None).digest
