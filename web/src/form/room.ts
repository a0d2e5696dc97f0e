/** Where there may be room on the table. */

import type { Drawing, Point } from "../engine/protocol";
import { drawing } from "../studio/store";
import { type Surroundings, tidy } from "./fresh";
import type { Schema } from "./schema";

/** Places all over the table without a ball nearer than a radius, spread so that the first ones are far apart. */
export function* freePlaces({ table, balls }: Drawing, radius: number, most = 400): Generator<Point> {
  const [left, bottom, right, top] = table.bounds;
  for (let k = 1; k <= most; k++) {
    const x = tidy(left + (right - left) * halton(k, 2), table.size);
    const y = tidy(bottom + (top - bottom) * halton(k, 3), table.size);
    const isFree = balls.every(({ position, radius: other }) => {
      const [ballX = 0, ballY = 0] = position;
      return Math.hypot(x - ballX, y - ballY) > radius + other;
    });
    if (isFree) yield [x, y];
  }
}

/** A number of the sequence of Halton: the digits of a whole one, mirrored at the point. */
function halton(whole: number, base: number): number {
  let [value, place] = [0, 1 / base];
  for (let rest = whole; rest > 0; rest = Math.floor(rest / base)) {
    value += (rest % base) * place;
    place /= base;
  }
  return value;
}

/** What new values should suit, at each of some free places in turn. */
export function* surroundings(root: Schema, count = 0): Generator<Surroundings> {
  const drawn = drawing.peek();
  if (!drawn) return;
  const diameter =
    2 * drawn.balls.reduce((most, { radius }) => Math.max(most, radius), 0) || drawn.table.size / 40;
  const around = { root, outline: drawn.table, diameter, count };
  for (const place of freePlaces(drawn, drawn.table.size / 20, 40)) yield { ...around, place };
  yield { ...around, place: [0, 0] };
}
