"""Gases and periodic tables, as Python makes them."""

import copy
import pickle
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest

import carom

mpl.use("Agg")


def test_a_gas_has_its_discs_in_a_box_of_that_packing_fraction() -> None:
    gas = carom.gas(n=300, packing_fraction=0.4, collisions=2000, seed=3)
    width, length = (gas.value(f"table.{side}") for side in ("width", "length"))
    assert len(gas.balls) == 300
    assert sum(np.pi * (ball.radius or 0.0) ** 2 for ball in gas.balls) == pytest.approx(0.4 * width * length)
    run = gas.run()
    assert (run.status, run.record) == ("collision_limit", "none")
    # kT = 1, and two degrees of freedom hold no heat since the gas does not drift.
    assert run.diagnostics["final_energy"] == pytest.approx(299)


def test_the_arguments_are_the_keys_of_a_scenario() -> None:
    gas = carom.gas(
        50,
        0.3,
        periodic=["x"],
        aspect=2,
        start="random",
        temperature=2,
        seed=5,
        sizes={"distribution": "uniform", "half_width": 0.1},
        duration=1,
        physics=carom.Physics(ball_ball=carom.Restitution(normal=0.9)),
        title="A gas",
        record="events",
    )
    assert gas.to_dict()["gas"] == {
        "n": 50,
        "packing_fraction": 0.3,
        "aspect": 2.0,
        "periodic": ["x"],
        "start": "random",
        "sizes": {"distribution": "uniform", "half_width": 0.1},
        "temperature": 2.0,
        "seed": 5,
    }
    assert (gas.title, gas.record, gas.run().record) == ("A gas", "events", "events")
    walls = carom.gas(50, 0.3, periodic=(), duration=1)
    assert walls.value("gas.periodic") == []
    assert "periodic" not in walls.expanded().to_dict()["table"]


def test_species_have_their_diameters_and_masses() -> None:
    species = [{"number": 20, "diameter": 1.0}, {"number": 30, "diameter": 1.5, "mass": 2.0}]
    gas = carom.gas(50, 0.3, species=species, duration=1)
    assert sorted((ball.radius, ball.mass) for ball in gas.balls) == [(0.5, 1.0)] * 20 + [(0.75, 2.0)] * 30
    with pytest.raises(TypeError, match="either species or sizes"):
        carom.gas(50, 0.3, species=species, sizes={"distribution": "uniform", "half_width": 0.1}, duration=1)


def test_what_cannot_be_is_told_at_its_key() -> None:
    with pytest.raises(carom.ScenarioError) as refused:
        carom.gas(100, 0.95, duration=1)
    ((place, message),) = refused.value.problems
    assert place == "gas.packing_fraction"
    assert "0.9069" in message
    with pytest.raises(carom.ScenarioError, match=r"gas\.n: expected a whole number, got 2\.5"):
        carom.gas(2.5, 0.3, duration=1)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="collisions: must be an int"):
        carom.gas(50, 0.3, collisions=1e3)  # type: ignore[arg-type]


def test_a_gas_is_a_value() -> None:
    gas = carom.gas(60, 0.3, duration=1)
    same = carom.gas(60, 0.3, duration=1)
    assert gas == same
    assert hash(gas) == hash(same)
    assert pickle.loads(pickle.dumps(gas)) == copy.deepcopy(gas) == gas
    assert gas.run().digest == pickle.loads(pickle.dumps(gas)).run().digest == gas.expanded().run().digest
    more = gas.with_values({"gas.n": 80})
    assert len(more.balls) == 80
    assert more != gas


def test_a_saved_run_of_a_gas_is_read_again(tmp_path: Path) -> None:
    run = carom.gas(60, 0.3, collisions=500, record="all").run()
    run.save(tmp_path / "gas.json")
    assert carom.load_run(tmp_path / "gas.json").digest == run.digest


def test_what_is_left_of_a_gas_goes_on_inside_its_box() -> None:
    run = carom.gas(60, 0.3, duration=20).run()
    rest = run.final_scenario()
    size = [rest.value(f"table.{side}") for side in ("width", "length")]
    places = np.array([ball.position for ball in rest.balls])
    assert rest.value("table.periodic") == ["x", "y"]
    assert np.all((places >= 0) & (places <= size))


def test_a_gas_can_be_drawn_and_told(tmp_path: Path) -> None:
    gas = carom.load("gas")
    axes = gas.plot()
    dashed = [patch for patch in axes.patches if patch.get_linestyle() != "solid" and not patch.get_fill()]
    assert len(dashed) == 1
    assert "gas: n 50, packing_fraction 0.3" in repr(gas)
    assert "packing_fraction" in gas._repr_html_()
    gas.run().report(tmp_path / "gas.html")
    assert "x and y" in (tmp_path / "gas.html").read_text(encoding="utf-8")


def test_sides_of_a_table_are_cushions_or_open() -> None:
    table = carom.Table.rectangle(width=1, length=2, periodic=("x",))
    scenario = carom.Scenario(table, [carom.Ball("a", radius=0.1, position=(0, 1), velocity=(1, 0))], duration=5)
    parts = {piece["id"]: piece["part"] for piece in scenario.outline()["pieces"]}
    assert parts == {"bottom": "boundary", "right": "periodic", "top": "boundary", "left": "periodic"}
    assert len(scenario.run().events) == 0
    with pytest.raises(carom.ScenarioError, match=r"physics\.cushions\.left: .*periodic"):
        scenario.with_values({"physics.cushions.left": {"law": "elastic"}})


def test_arrays_make_a_scenario() -> None:
    table = carom.Table.rectangle(width=2, length=2)
    places, motions = np.array([[0.5, 0.5], [1.5, 1.0]]), np.array([[1.0, 0.0], [0.0, -1.0]])
    scenario = carom.Scenario.from_arrays(table, places, motions, radii=[0.1, 0.2], masses=3, duration=1)
    first, second = scenario.balls
    assert (first.id, first.radius, first.mass, first.velocity) == ("0", 0.1, 3.0, [1.0, 0.0])
    assert (second.radius, second.mass) == (0.2, 3.0)
    named = carom.Scenario.from_arrays(table, places, radii=0.1, ids=["a", "b"], duration=1)
    assert named.ball_ids == ["a", "b"]


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"positions": [0.5, 0.5]}, r"positions: must have the shape \(n_balls, 2\), got \(2,\)"),
        ({"velocities": [[1, 0]] * 3}, r"velocities: must have the shape \(2, 2\), got \(3, 2\)"),
        ({"radii": [0.1] * 3}, r"radii: must have the shape \(2,\), got \(3,\)"),
        ({"ids": ["a"] * 3}, r"ids: must have the shape \(2,\), got \(3,\)"),
    ],
)
def test_arrays_of_another_shape_are_refused(wrong: dict[str, object], message: str) -> None:
    arrays = {"positions": [[0.5, 0.5], [1.5, 1.0]], "radii": 0.1, "duration": 1, **wrong}
    table = carom.Table.rectangle(width=2, length=2)
    with pytest.raises(ValueError, match=message):
        carom.Scenario.from_arrays(table, **arrays)  # type: ignore[arg-type]
