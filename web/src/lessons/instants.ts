/** The collisions of a run, those of one moment together. */

import type { EventColumns } from "../engine/protocol";
import type { Shown } from "../studio/store";

/** The events from `first` up to `after`, all at one time. */
export interface Instant {
  time: number;
  first: number;
  after: number;
  /** Its place among the collisions, from 1 on. */
  place: number;
}

/** The places in `Vocabulary.kinds` of what counts as a collision. */
const BALL_BALL = 0;
const BALL_CUSHION = 1;

const isCollision = ({ kind }: EventColumns, event: number) =>
  kind[event] === BALL_BALL || kind[event] === BALL_CUSHION;

export const isOfTwoBalls = ({ kind }: EventColumns, event: number) => kind[event] === BALL_BALL;

/** The collisions of a run, or those that one ball takes part in. */
export function instants(events: EventColumns, ball?: number): Instant[] {
  const found: Instant[] = [];
  for (let event = 0; event < events.time.length; event++) {
    const [time, a, b] = [events.time[event] as number, events.ballA[event], events.ballB[event]];
    if (!isCollision(events, event) || (ball !== undefined && a !== ball && b !== ball)) continue;
    const before = found.at(-1);
    if (before?.time === time) before.after = event + 1;
    else found.push({ time, first: event, after: event + 1, place: found.length + 1 });
  }
  return found;
}

/** The last moment before a time. */
export const justBefore = (time: number) => time * (1 - Number.EPSILON);

/** How far apart two balls are at a time, of one run or of two. */
export function distance([a, ballA]: [Shown, number], [b, ballB]: [Shown, number], time: number): number {
  const [one, two] = [a.film.at(time), b.film.at(time)];
  const along = (of: "x" | "y") => (one[of][ballA] as number) - (two[of][ballB] as number);
  return Math.hypot(along("x"), along("y"));
}
