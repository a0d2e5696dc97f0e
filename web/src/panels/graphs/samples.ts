/** The times at which graphs are drawn, and what there is to draw at them. */

import { signal } from "@preact/signals";
import { EngineLost, Problems } from "../../engine/client";
import type { Film } from "../../engine/film";
import { justBefore, speedOf } from "../../studio/motion";
import { engine, run, type Shown } from "../../studio/store";

/** Times that lie evenly. */
const EVEN = 500;
/** So many events have samples just before and at them; with more, the graph is of even samples only. */
const MOST_EVENTS = 1500;
const EVEN_OF_MANY = 2500;
/** So many states of balls are asked for at most, and at once. */
const MOST_STATES = 2_000_000;
const STATES_AT_ONCE = 60_000;
/** Up to so many balls have curves of their own. */
export const MOST_CURVES = 24;

/** The sums over all balls at some times. */
export interface Totals {
  /** The run that they are of. */
  of: Shown;
  times: Float64Array;
  kinetic: Float64Array;
  potential: Float64Array;
  px: Float64Array;
  py: Float64Array;
}

export const totals = signal<Totals | null>(null);

/** Even times from zero to the end, and the times of events twice, so that what jumps there is upright. */
export function sampleTimes(events: Float64Array, end: number, balls: number): Float64Array {
  const most = Math.floor(MOST_STATES / Math.max(balls, 1));
  const hasEvents = events.length <= MOST_EVENTS && EVEN + 2 * events.length <= most;
  const even = Math.max(Math.min(hasEvents ? EVEN : EVEN_OF_MANY, most), 50);
  const times = Array.from({ length: even + 1 }, (_, k) => (k / even) * end);
  if (hasEvents) for (const time of events) times.push(justBefore(time), time);
  return Float64Array.from(new Set(times)).sort();
}

/** Asks for the sums of a run whenever there is a whole one; gives what ends that. */
export function followTotals(): () => void {
  return run.subscribe((shown) => {
    if (!shown?.isWhole) totals.value = null;
    else if (totals.peek()?.of !== shown) void load(shown);
  });
}

async function load(shown: Shown) {
  const times = sampleTimes(shown.events.time, shown.summary.endTime, shown.film.ballCount);
  const column = () => new Float64Array(times.length);
  const found: Totals = {
    of: shown,
    times,
    kinetic: column(),
    potential: column(),
    px: column(),
    py: column(),
  };
  const count = Math.max(1, Math.floor(STATES_AT_ONCE / shown.film.ballCount));
  for (let from = 0; from < times.length; from += count) {
    const rows = await totalsAt(shown, times.slice(from, from + count));
    if (!rows) return;
    rows.forEach(([kinetic, potential, px, py], k) => {
      found.kinetic[from + k] = kinetic as number;
      found.potential[from + k] = potential as number;
      found.px[from + k] = px as number;
      found.py[from + k] = py as number;
    });
  }
  totals.value = found;
}

/** Kinetic and potential energy and momentum at some times; null where the run is not the one on the table any more. */
export async function totalsAt(shown: Shown, times: Float64Array): Promise<number[][] | null> {
  const count = times.length;
  try {
    const numbers = await engine.ask("totals", { slot: "main", times });
    const width = numbers.length / count;
    if (run.peek() !== shown) return null;
    return Array.from({ length: count }, (_, k) => [...numbers.slice(k * width, (k + 1) * width)]);
  } catch (error) {
    if (error instanceof Problems || error instanceof EngineLost) return null;
    throw error;
  }
}

/** What a ball has at each of some times. */
export interface Curve {
  vx: Float64Array;
  vy: Float64Array;
  speed: Float64Array;
  distance: Float64Array;
}

/** The curves of each ball; none where there are many. */
export function curves(film: Film, times: Float64Array): Curve[] {
  if (film.ballCount > MOST_CURVES) return [];
  const column = () => new Float64Array(times.length);
  const all = Array.from({ length: film.ballCount }, (_, ball) => ({
    vx: column(),
    vy: column(),
    speed: column(),
    distance: distances(film, ball, times),
  }));
  let moment: ReturnType<Film["at"]> | undefined;
  times.forEach((time, k) => {
    moment = film.at(time, moment);
    for (const [ball, { vx, vy, speed }] of all.entries()) {
      vx[k] = moment.vx[ball] as number;
      vy[k] = moment.vy[ball] as number;
      speed[k] = speedOf(moment, ball);
    }
  });
  return all;
}

/** How far a ball has gone at each of some times, in order, flight by flight. */
function distances(film: Film, ball: number, times: Float64Array): Float64Array {
  const { width, firstRows, numbers } = film.data;
  const after = firstRows[ball + 1] as number;
  const start = (row: number) => (row < after ? (numbers[row * width] as number) : Number.POSITIVE_INFINITY);
  let [row, gone] = [firstRows[ball] as number, 0];
  return times.map((time) => {
    for (; start(row + 1) <= time; row++) gone += flightLength(film, row, start(row + 1) - start(row));
    return gone + flightLength(film, row, time - start(row));
  });
}

/** Places and weights of Gauss's rule on the interval from 0 to 1. */
const GAUSS = [
  [0.5 - Math.sqrt(0.15), 5 / 18],
  [0.5, 8 / 18],
  [0.5 + Math.sqrt(0.15), 5 / 18],
] as const;

/** The length of a flight in its first so many seconds: exact where it is straight, else a sum over short pieces. */
function flightLength({ data: { numbers, width }, isOnCloth }: Film, row: number, time: number): number {
  const at = row * width;
  const size = isOnCloth ? 3 : 2;
  const v = Array.from(numbers.subarray(at + 1 + size, at + 1 + 2 * size));
  const a = Array.from(numbers.subarray(at + 1 + 2 * size, at + 1 + 3 * size));
  if (!Number.isFinite(numbers[at + 1] as number)) return 0;
  const dot = (one: number[], other: number[]) =>
    one.reduce((sum, part, k) => sum + part * (other[k] as number), 0);
  const speed = (s: number) => Math.hypot(...v.map((part, k) => part + (a[k] as number) * s));
  const square = dot(a, a);
  if (square === 0) return speed(0) * time;
  // The speed has a corner, or nearly, where the ball turns round.
  const turn = Math.min(Math.max(-dot(v, a) / square, 0), time);
  const stretch = (from: number, to: number) =>
    GAUSS.reduce((sum, [place, weight]) => sum + weight * speed(from + place * (to - from)), 0) * (to - from);
  const pieces = [0, 0.25, 0.5, 0.75];
  return pieces.reduce((sum, piece) => {
    const [begin, end] = [piece, piece + 0.25];
    return (
      sum +
      stretch(begin * turn, end * turn) +
      stretch(turn + begin * (time - turn), turn + end * (time - turn))
    );
  }, 0);
}
