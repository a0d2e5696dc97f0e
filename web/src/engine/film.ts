/** The course of a run, from which the state at any time is told. */

import type { FilmData } from "./protocol";

/** The places of the motions of balls on a cloth in the engine's list of them. */
const POCKETED = 5;

/** The balls at one moment: a number for each ball. A ball that is out of play is nowhere: its place is not a number. */
export interface Moment {
  time: number;
  x: Float64Array;
  y: Float64Array;
  z: Float64Array;
  vx: Float64Array;
  vy: Float64Array;
  vz: Float64Array;
  /** Spin, on a cloth. */
  wx: Float64Array;
  wy: Float64Array;
  wz: Float64Array;
}

/** Where what stands in a row; z and spin are there on a cloth only. */
const DISC = { x: 1, v: 3, a: 5, w: -1 };
const SPHERE = { x: 1, v: 4, a: 7, w: 10 };
const SPHERE_WIDTH = 17;

export class Film {
  readonly ballCount: number;
  readonly isOnCloth: boolean;
  /** The row that each ball was last found on: the next one is near as a rule. */
  readonly #rows: Uint32Array;

  /** A run in steps has flights in which a ball waits for the end of the step, with the velocity of the next. */
  constructor(
    readonly data: FilmData,
    readonly isStepped = false,
  ) {
    this.ballCount = data.firstRows.length - 1;
    this.isOnCloth = data.width === SPHERE_WIDTH;
    this.#rows = data.firstRows.slice(0, this.ballCount);
  }

  /** The balls at a time, in arrays of an earlier moment if one is handed over. */
  at(time: number, into: Moment = newMoment(this.ballCount)): Moment {
    into.time = time;
    for (let ball = 0; ball < this.ballCount; ball++) {
      this.#put(ball, time, this.row(ball, time), into);
    }
    return into;
  }

  /** The times at which the flights of a ball begin. */
  starts(ball: number): Float64Array {
    const { width, firstRows, numbers } = this.data;
    const [first, after] = [firstRows[ball] as number, firstRows[ball + 1] as number];
    return Float64Array.from({ length: after - first }, (_, k) => numbers[(first + k) * width] as number);
  }

  /** The code of how a ball on a cloth moves at a time. */
  motion(ball: number, time: number): number {
    const { width, numbers } = this.data;
    return this.isOnCloth ? (numbers[(this.row(ball, time) + 1) * width - 1] as number) : -1;
  }

  /** Whether a ball on a cloth is out of play at a time. */
  isOut(ball: number, time: number): boolean {
    return this.motion(ball, time) >= POCKETED;
  }

  /** The row of the flight that a ball is on; at an event's own time the one that begins there. */
  row(ball: number, time: number): number {
    const { width, firstRows, numbers } = this.data;
    const [first, after] = [firstRows[ball] as number, firstRows[ball + 1] as number];
    const isAfter = (row: number) => row >= after || (numbers[row * width] as number) > time;
    let row = this.#rows[ball] as number;
    if (!(isAfter(row + 1) && (row === first || !isAfter(row)))) {
      let [low, high] = [first, after];
      while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (isAfter(middle)) high = middle;
        else low = middle;
      }
      row = low;
      this.#rows[ball] = row;
    }
    return row;
  }

  /** The operations of `flight/mod.rs` in their order, so that the places have the bits of the engine. */
  #put(ball: number, time: number, row: number, into: Moment) {
    const { width, numbers } = this.data;
    const at = row * width;
    const { x, v, a, w } = this.isOnCloth ? SPHERE : DISC;
    const n = (place: number) => numbers[at + place] as number;
    const s = time - n(0);
    const half = s * 0.5;
    into.x[ball] = n(x) + (n(v) + n(a) * half) * s;
    into.y[ball] = n(x + 1) + (n(v + 1) + n(a + 1) * half) * s;
    into.vx[ball] = n(v) + n(a) * s;
    into.vy[ball] = n(v + 1) + n(a + 1) * s;
    if (this.isStepped) this.#waits(ball, row, into);
    if (w < 0) return;
    into.z[ball] = n(x + 2) + (n(v + 2) + n(a + 2) * half) * s;
    into.vz[ball] = n(v + 2) + n(a + 2) * s;
    into.wx[ball] = n(w) + n(w + 3) * s;
    into.wy[ball] = n(w + 1) + n(w + 4) * s;
    const wz = n(w + 2) + n(w + 5) * s;
    // The spin about the vertical ends when it is zero.
    into.wz[ball] = wz * n(w + 2) <= 0 ? 0 : wz;
  }

  /** Gives a ball that waits for the end of its step the velocity that it will go on with. */
  #waits(ball: number, row: number, into: Moment) {
    if (into.vx[ball] !== 0 || into.vy[ball] !== 0 || row + 1 >= (this.data.firstRows[ball + 1] as number))
      return;
    const next = (row + 1) * this.data.width;
    into.vx[ball] = this.data.numbers[next + DISC.v] as number;
    into.vy[ball] = this.data.numbers[next + DISC.v + 1] as number;
  }
}

function newMoment(count: number): Moment {
  const array = () => new Float64Array(count);
  const [x, y, z, vx, vy, vz, wx, wy, wz] = [
    array(),
    array(),
    array(),
    array(),
    array(),
    array(),
    array(),
    array(),
    array(),
  ];
  return { time: 0, x, y, z, vx, vy, vz, wx, wy, wz };
}
