"""Times Carom from Python, and python-billiards beside it in the same run on the same machine.

    make bench

A full recorded run of the course exercise, call included; then gases of 2, 20 and 200 elastic discs in a square, the
same start in both programs, in alternation. Medians are printed; the ratio is what to quote.
"""

import random
import statistics
import time

import billiards

import carom

REPEATS = 7


def timed(call):
    """Seconds that a call takes, and what it gives."""
    start = time.perf_counter()
    value = call()
    return time.perf_counter() - start, value


def exercise():
    """Microseconds of a recorded run of the midterm, call included."""
    scenario = carom.load("midterm")
    scenario.run()
    rounds = 2000
    samples = [timed(lambda: [scenario.run() for _ in range(rounds)])[0] / rounds for _ in range(REPEATS)]
    print(f"a recorded run of the midterm from Python: {statistics.median(samples) * 1e6:.1f} µs")


def gas(count):
    """Discs of unequal sizes on a loose grid in the unit square, with random velocities."""
    rng = random.Random(count)
    side = 1
    while side * side < count:
        side += 1
    balls = []
    for k in range(count):
        position = [(k % side + 0.5) / side, (k // side + 0.5) / side]
        velocity = [rng.uniform(-1, 1), rng.uniform(-1, 1)]
        balls.append((position, velocity, rng.uniform(0.15, 0.35) / side))
    return balls


def carom_gas(balls, end):
    """A run of Carom up to a time, every event and flight kept; gives the number of collisions."""
    scenario = carom.Scenario.from_dict(
        {
            "duration": end,
            "table": {"shape": "rectangle", "width": 1.0, "length": 1.0},
            "balls": [{"id": f"b{k}", "position": x, "velocity": v, "radius": r} for k, (x, v, r) in enumerate(balls)],
        }
    )
    return lambda: len(scenario.run().events)


def billiards_gas(balls, end):
    """The same in python-billiards, which keeps nothing."""
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    walls = [billiards.InfiniteWall(a, b) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]

    def run():
        table = billiards.Billiard(obstacles=walls)
        for position, velocity, radius in balls:
            table.add_ball(position, velocity, radius)
        return sum(len(bounces) for bounces in table.evolve(end))

    return run


def main():
    """Prints all figures."""
    exercise()
    print("discs  collisions  carom µs/collision  python-billiards µs/collision  ratio")
    for count, end in ((2, 400.0), (20, 20.0), (200, 1.0)):
        balls = gas(count)
        ours, theirs = carom_gas(balls, end), billiards_gas(balls, end)
        samples = [(timed(ours), timed(theirs)) for _ in range(REPEATS)]
        events = samples[0][0][1]
        mine = statistics.median(seconds for (seconds, _), _ in samples) / events * 1e6
        other = statistics.median(seconds / number for _, (seconds, number) in samples) * 1e6
        print(f"{count:5}  {events:10}  {mine:18.3f}  {other:29.1f}  {other / mine:5.0f}")


if __name__ == "__main__":
    main()
