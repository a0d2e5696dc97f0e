"""Times the page in Chromium, and the native engine beside it on the same machine.

    make bench-page

The engine in the page and native, warm and in alternation, with everything kept; then a frame of a gas of ten
thousand discs, and how soon an opened address shows something. Medians are printed; of the engine, the ratio is what to
quote.
"""

import json
import statistics
import subprocess
import time

import carom

ROUNDS = 3
LONG = {"physics.ball_cushion.factor": 1, "duration": None, "collisions": 20_000}
CASES = {
    "the exercise": {"scenario": "midterm", "values": {}},
    "20 000 collisions of it": {"scenario": "midterm", "values": LONG},
    "a nine-ball break": {"scenario": "nine_ball_break", "values": {}},
}


def native(case):
    """Seconds of a recorded run from Python, in batches as long as those of the page."""
    scenario = carom.load(case["scenario"]).with_values(case["values"])
    runs = 1
    while batch(scenario, runs) < 0.2:
        runs *= 2
    return statistics.median(batch(scenario, runs) / runs for _ in range(9))


def batch(scenario, runs):
    start = time.perf_counter()
    for _ in range(runs):
        scenario._native.run("{}")  # as the page calls it, without what Python makes of a run
    return time.perf_counter() - start


def in_page():
    command = ["node", "build/bench.mjs", json.dumps(list(CASES.values()))]
    return json.loads(subprocess.run(command, cwd="web", check=True, capture_output=True, text=True).stdout)


def main():
    rounds = [(in_page(), [native(case) for case in CASES.values()]) for _ in range(ROUNDS)]
    for k, name in enumerate(CASES):
        page = statistics.median(measured["engine_s"][k] for measured, _ in rounds) * 1e6
        package = statistics.median(seconds[k] for _, seconds in rounds) * 1e6
        print(f"{name}: {page:.1f} µs in the page, {package:.1f} µs native: {package / page:.2f} of its speed")
    for key, name in {
        "frame_ms": "a frame of 10 000 discs, the page's own part",
        "gallery_ms": "an address opened until the gallery is there",
        "table_ms": "until a table with its run is there",
        "refusal_ms": "until a link that takes minutes is refused",
    }.items():
        print(f"{name}: {statistics.median(measured[key] for measured, _ in rounds):.1f} ms")


if __name__ == "__main__":
    main()
