/** An event with what was shortly before it and shortly after. */

import type { Film, Moment } from "../../engine/film";
import type { Drawing, EventColumns } from "../../engine/protocol";
import { justBefore, speedOf } from "../../studio/motion";
import type { Shown } from "../../studio/store";
import { openAxes, type Periods } from "../../table/periodic";

/** The pictures before and after are as far away as the fastest ball goes this many of the sizes of the event. */
const STEP = 1.2;
/** The size of an event of points, as a share of the table. */
const SIZE_OF_POINTS = 0.04;
/** So many balls of a cluster are told of. */
const MOST_BALLS = 8;

export interface Encounter {
  time: number;
  /** Those who take part: the balls of the event, and after them those of its cluster. */
  balls: number[];
  /** The sum of the radii: what lengths of the pictures are measured by. */
  size: number;
  point: [number, number];
  /** From the first ball to the second, or from the cushion into the table; null where nothing is struck. */
  normal: [number, number] | null;
  /** An earlier moment, that of the contact with what was before and with what is after, and a later one. */
  earlier: Moment;
  incoming: Moment;
  outgoing: Moment;
  later: Moment;
  open: Periods;
}

export function encounterOf({ film, events, summary }: Shown, drawn: Drawing, event: number): Encounter {
  const time = events.time[event] as number;
  const balls = participants(events, event);
  const radii = balls.slice(0, 2).map((ball) => drawn.balls[ball]?.radius ?? 0);
  const size =
    (radii.length === 1 ? 2 : 1) * radii.reduce((sum, radius) => sum + radius, 0) ||
    SIZE_OF_POINTS * drawn.table.size;
  const [incoming, outgoing] = [time > 0 ? film.at(justBefore(time)) : atStart(film, drawn), film.at(time)];
  const [earliest, latest] = roomFor(film, balls, time, summary.endTime);
  const step = (moment: Moment) =>
    (STEP * size) / Math.max(...balls.map((ball) => speedOf(moment, ball) || 0), 1e-9);
  const [nx, ny] = [events.normalX[event] as number, events.normalY[event] as number];
  const isStruck = (events.impulse[event] as number) !== 0 && Math.hypot(nx, ny) > 0.5;
  return {
    time,
    balls,
    size,
    point: [events.x[event] as number, events.y[event] as number],
    normal: isStruck ? [nx, ny] : null,
    earlier: film.at(Math.max(earliest, time - step(incoming))),
    incoming,
    outgoing,
    later: film.at(Math.min(latest, time + step(outgoing))),
    open: openAxes(drawn.table),
  };
}

/** The balls of an event, and those that were in its cluster. */
function participants({ ballA, ballB, cluster }: EventColumns, event: number): number[] {
  const balls = new Set<number>();
  const add = (row: number) => {
    for (const ball of [ballA[row] as number, ballB[row] as number]) if (ball >= 0) balls.add(ball);
  };
  add(event);
  const own = cluster[event] as number;
  if (own >= 0) {
    for (let row = event - 1; cluster[row] === own; row--) add(row);
    for (let row = event + 1; cluster[row] === own; row++) add(row);
  }
  return [...balls].slice(0, MOST_BALLS);
}

/** Between which times the balls do nothing else: since the event before of any of them, and until the next. */
function roomFor(film: Film, balls: number[], time: number, end: number): [number, number] {
  const { firstRows, numbers, width } = film.data;
  const starts = balls.map((ball) => numbers[film.row(ball, justBefore(time)) * width] as number);
  const nexts = balls.map((ball) => {
    const row = film.row(ball, time) + 1;
    return row < (firstRows[ball + 1] as number) ? justBefore(numbers[row * width] as number) : end;
  });
  return [Math.max(0, ...starts), Math.max(time, Math.min(end, ...nexts))];
}

/** The start of all, before what happens at time zero: the stroke of a cue, or contacts of balls that touch. */
function atStart(film: Film, { balls }: Drawing): Moment {
  const moment = film.at(0);
  for (const [ball, { velocity, spin }] of balls.entries()) {
    [moment.vx[ball], moment.vy[ball], moment.vz[ball]] = [
      velocity[0] ?? 0,
      velocity[1] ?? 0,
      velocity[2] ?? 0,
    ];
    [moment.wx[ball], moment.wy[ball], moment.wz[ball]] = [spin?.[0] ?? 0, spin?.[1] ?? 0, spin?.[2] ?? 0];
  }
  return moment;
}

/** Where a ball is in a picture of the event: on a table with open sides, the image of it that is nearest. */
export function placeIn({ point, open }: Encounter, moment: Moment, ball: number): [number, number] {
  const near = (place: number, middle: number, period: [number, number] | null) =>
    period ? place - Math.round((place - middle) / period[1]) * period[1] : place;
  return [near(moment.x[ball] as number, point[0], open.x), near(moment.y[ball] as number, point[1], open.y)];
}

/** A vector's parts along a normal and along the tangent, which is the normal turned left. */
export function parts(vx: number, vy: number, [nx, ny]: [number, number]): [number, number] {
  return [vx * nx + vy * ny, vy * nx - vx * ny];
}
