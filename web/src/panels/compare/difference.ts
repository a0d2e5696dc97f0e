/** How far two runs of the same balls are apart. */

import type { Film } from "../../engine/film";
import type { Shown } from "../../studio/store";

/** So many moments at most are compared, beside those of events. */
const MOMENTS = 600;
const MOST_EVENTS = 2000;

/** Halvings that find the moment of parting: each run is known at any time. */
const HALVINGS = 60;

export interface Difference {
  times: Float64Array;
  /** The largest distance between the two places of a ball, at each time. */
  distances: Float64Array;
  /** When a ball is first further from its other self than `apart`; null when never. */
  parting: { time: number; ball: number } | null;
}

/** Compares two runs as long as both last; they have parted where a ball is further than `apart` from its other self. */
export function difference(one: Shown, other: Shown, apart: number): Difference {
  const end = Math.min(one.summary.endTime, other.summary.endTime);
  const times = momentsOf([one, other], end);
  const distances = times.map((time) => distanceAt(one.film, other.film, time)[0]);
  const first = distances.findIndex((distance) => distance > apart);
  return {
    times,
    distances,
    parting: first < 0 ? null : partingBefore(one.film, other.film, times, first, apart),
  };
}

function momentsOf(runs: Shown[], end: number): Float64Array {
  const even = Array.from({ length: MOMENTS }, (_, k) => (k * end) / (MOMENTS - 1));
  const events = runs.flatMap(({ events }) => (events.time.length <= MOST_EVENTS ? [...events.time] : []));
  const times = new Set([...even, ...events].filter((time) => time <= end));
  return Float64Array.from(times).sort();
}

/** The largest distance between the two places of a ball, and which ball it is. */
function distanceAt(one: Film, other: Film, time: number): [number, number] {
  const [a, b] = [one.at(time), other.at(time)];
  let [largest, ball] = [0, 0];
  for (let k = 0; k < Math.min(one.ballCount, other.ballCount); k++) {
    const distance = Math.hypot(
      (a.x[k] as number) - (b.x[k] as number),
      (a.y[k] as number) - (b.y[k] as number),
    );
    if (distance > largest) [largest, ball] = [distance, k];
  }
  return [largest, ball];
}

function partingBefore(one: Film, other: Film, times: Float64Array, first: number, apart: number) {
  let [low, high] = [times[first - 1] ?? 0, times[first] as number];
  for (let k = 0; k < HALVINGS && low < high; k++) {
    const middle = low + (high - low) / 2;
    if (distanceAt(one, other, middle)[0] > apart) high = middle;
    else low = middle;
  }
  return { time: high, ball: distanceAt(one, other, high)[1] };
}
