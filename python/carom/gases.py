"""Gases: many hard discs in a box."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from carom.options import check_counts
from carom.scenario import Scenario

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from carom.physics import Physics
    from carom.table import Axis

GasStart = Literal["automatic", "square", "hexagonal", "random", "compressed"]
"""Where the discs of a gas start."""
GasVelocities = Literal["maxwell", "equal_speed"]
"""How the velocities of a gas are drawn."""


def gas(
    n: int,
    packing_fraction: float,
    *,
    periodic: Sequence[Axis] | None = None,
    aspect: float | None = None,
    start: GasStart | None = None,
    velocities: GasVelocities | None = None,
    temperature: float | None = None,
    seed: int | None = None,
    species: Sequence[Mapping[str, Any]] | None = None,
    sizes: Mapping[str, Any] | None = None,
    collisions: int | None = None,
    duration: float | None = None,
    physics: Physics | Mapping[str, Any] | None = None,
    **more: Any,
) -> Scenario:
    """Give a gas of hard discs in a box of its own.

    Lengths are in units of sigma, the mean diameter of the discs, masses in units of m, the mass of a disc, and
    energies in units of kT at temperature 1: so sigma = m = kT = 1, and times are in units of sigma √(m/kT).

    Parameters
    ----------
    n : int
        How many discs.
    packing_fraction : float
        The part of the box that discs cover, above 0 and below 1.
    periodic : sequence of "x" and "y", optional
        Axes along which the box repeats itself, instead of having walls; absent: both. None of them is ``()``.
    aspect : float, optional
        Length over width of the box; absent: 1, and for a lattice what suits it best.
    start : str, optional
        ``square``, ``hexagonal``, ``random``, ``compressed`` or ``automatic``, which takes what suits the density;
        absent: automatic.
    velocities : str, optional
        ``maxwell``, as in equilibrium, or ``equal_speed``: all discs equally fast, in random directions whose
        momenta sum to zero; absent: maxwell.
    temperature : float, optional
        kT of the velocities; absent: 1.
    seed : int, optional
        What all that is random is drawn from; absent: 0.
    species : sequence of mappings, optional
        Kinds of discs, mixed at random: each with a ``diameter`` in sigma, a ``mass`` in m (absent: 1), and a
        ``fraction`` of all discs or a ``number`` of them; absent: all discs are equal.
    sizes : mapping, optional
        In place of `species` a distribution of diameters with mean 1, as a scenario file has it in ``gas.sizes``.
    collisions : int, optional
        End a run after this many collisions.
    duration : float, optional
        End a run at this time.
    physics : Physics, optional
        The laws; absent: elastic collisions.
    **more
        Any other key of a scenario file: `title`, `max_events`, `record`, `units`. A run of a gas keeps no events
        unless `record` says so.

    Returns
    -------
    Scenario
        The gas. Its discs have the ids "0", "1", ...

    Raises
    ------
    ScenarioError
        When there is no such gas: one too dense for its start, for instance.
    TypeError
        When both `species` and `sizes` are given, or a count is no int.

    Examples
    --------
    >>> import carom
    >>> gas = carom.gas(n=1000, packing_fraction=0.3, collisions=100_000, seed=7)
    >>> len(gas.balls), gas.balls[0].radius
    (1000, 0.5)
    >>> mixture = [{"fraction": 0.5, "diameter": 1.0}, {"fraction": 0.5, "diameter": 1.4}]
    >>> carom.gas(100, 0.5, species=mixture, duration=10).run().status
    'time_limit'
    """
    if species is not None and sizes is not None:
        raise TypeError("gas: give either species or sizes")
    recipe = {
        "n": n,
        "packing_fraction": packing_fraction,
        "periodic": None if periodic is None else list(periodic),
        "aspect": aspect,
        "start": start,
        "velocities": velocities,
        "temperature": temperature,
        "seed": seed,
        "sizes": sizes if species is None else {"species": species},
    }
    keys = {"gas": _given(recipe), "collisions": collisions, "duration": duration, "physics": physics, **more}
    check_counts(keys)
    return Scenario.from_dict(_given(keys))


def _given(keys: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in keys.items() if value is not None}
