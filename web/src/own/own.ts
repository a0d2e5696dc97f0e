/** One's own trajectory: read from a table, laid over the run and held against it. */

import { computed, effect, signal } from "@preact/signals";
import type { Moment } from "../engine/film";
import { drawing, opened, run, say, time } from "../studio/store";
import { number } from "../words";
import { assign } from "./assignment";
import { linesOf, type Misreading, MOST_ROWS, numbersOf } from "./csv";

/** A ball's way in the file. */
export interface Way {
  ball: number;
  x: Float64Array;
  y: Float64Array;
}

export interface Trajectory {
  name: string;
  times: Float64Array;
  ways: Way[];
  /** The names of the columns that are not looked at. */
  leftOut: string[];
  /** Whether the file does not say which ball it is, so that the nearest one at its first time was taken. */
  isNearest: boolean;
}

/** How far a way is from the run at the same times. */
export interface Difference {
  ball: number;
  /** Null where no row is within the run. */
  largest: number | null;
  at: number;
}

/** The trajectory that lies over the run, or null. */
export const own = signal<Trajectory | null>(null);

/** What of a file was not understood, or null. */
export const misread = signal<{ name: string; misreadings: Misreading[] } | null>(null);

/** A time may be past the end by this part of it, as a clock that was added up is. */
const CLOCK = 1e-9;

/** How many rows are after the run's end. */
export const lateRows = computed(() => {
  const [trajectory, shown] = [own.value, run.value];
  if (!trajectory || !shown) return 0;
  return trajectory.times.filter((at) => !isWithin(at)).length;
});

const isWithin = (at: number) => {
  const summary = run.value?.summary;
  if (!summary || at < 0) return false;
  return summary.status === "at_rest" || at <= summary.endTime * (1 + CLOCK);
};

export const differences = computed<Difference[]>(() => {
  const [trajectory, film] = [own.value, run.value?.film];
  if (!trajectory || !film) return [];
  const found = trajectory.ways.map(({ ball }): Difference => ({ ball, largest: null, at: 0 }));
  let moment: Moment | undefined;
  trajectory.times.forEach((at, row) => {
    if (!isWithin(at)) return;
    const balls = film.at(at, moment);
    moment = balls;
    trajectory.ways.forEach(({ ball, x, y }, k) => {
      const [dx, dy] = [
        (x[row] as number) - (balls.x[ball] as number),
        (y[row] as number) - (balls.y[ball] as number),
      ];
      const distance = Math.hypot(dx, dy);
      const difference = found[k] as Difference;
      if (distance > (difference.largest ?? -1)) Object.assign(difference, { largest: distance, at });
    });
  });
  return found;
});

/** Reads a trajectory and lays it over the run, or says what of it is not understood. */
export function takeTrajectory(text: string, name: string) {
  const outcome = readTrajectory(text, name);
  if (Array.isArray(outcome)) {
    misread.value = { name, misreadings: outcome };
    say("ownMisread", { name });
    return;
  }
  misread.value = null;
  own.value = outcome;
  const ids = run.peek()?.summary.ballIds ?? [];
  const farthest = [...differences.peek()].sort((a, b) => (b.largest ?? -1) - (a.largest ?? -1))[0];
  if (!farthest || farthest.largest === null) return say("ownTaken", { name });
  const told = {
    ball: ids[farthest.ball] ?? "",
    distance: number(farthest.largest),
    time: number(farthest.at),
  };
  say("ownCompared", { name, ...told });
}

export function forgetTrajectory() {
  own.value = misread.value = null;
}

function readTrajectory(text: string, name: string): Trajectory | Misreading[] {
  const lines = linesOf(text);
  if (!lines || lines.rows.length === 0) return [{ key: "ownNoRows" }];
  if (lines.rows.length > MOST_ROWS) return [{ key: "ownTooManyRows", values: { most: number(MOST_ROWS) } }];
  const balls = drawing.peek()?.balls ?? [];
  const assignment = assign(
    lines,
    balls.map(({ id }) => id),
  );
  if ("key" in assignment) return [assignment];
  const columns = [assignment.time, ...assignment.balls.flatMap(({ x, y }) => [x, y])];
  const { numbers, misreadings } = numbersOf(lines, columns);
  if (misreadings.length > 0) return misreadings;
  const [times, ...places] = numbers as [Float64Array, ...Float64Array[]];
  const endless = times.findIndex((at) => !Number.isFinite(at));
  if (endless >= 0) return [{ key: "ownTime", line: lines.rows[endless]?.line ?? 0 }];
  const ways = assignment.balls.map(({ ball }, k) => {
    const [x, y] = [places[2 * k] as Float64Array, places[2 * k + 1] as Float64Array];
    return { ball: ball < 0 ? nearest(times[0] as number, x[0] as number, y[0] as number) : ball, x, y };
  });
  const isNearest = assignment.balls.some(({ ball }) => ball < 0);
  return { name, times, ways, leftOut: assignment.leftOut, isNearest };
}

/** The ball of the run that is nearest to a place at a time. */
function nearest(at: number, x: number, y: number): number {
  const moment = run.peek()?.film.at(at);
  if (!moment) return 0;
  const distances = Array.from(moment.x, (bx, ball) => Math.hypot(bx - x, (moment.y[ball] as number) - y));
  return distances.reduce((best, each, ball) => (each < (distances[best] as number) ? ball : best), 0);
}

/** The rows that lie around a time: the last at or before it, or −1. Of times that go back and forth any such. */
export function rowAt(times: Float64Array, at = time.value): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((times[middle] as number) > at) high = middle;
    else low = middle + 1;
  }
  return low - 1;
}

// Another scenario has other balls.
effect(() => {
  if (opened.value > 0) forgetTrajectory();
});
