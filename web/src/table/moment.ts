/** The balls now, where they are to be drawn. */

import { computed } from "@preact/signals";
import type { Film, Moment } from "../engine/film";
import type { StartingBall } from "../engine/protocol";
import { drawing, run, time } from "../studio/store";
import { periods, wrapped } from "./periodic";

let moment: Moment | undefined;
let source: Film | undefined;

/** The balls at the start, until there is a run. */
const atStart = computed<Moment | null>(() => {
  const balls = drawing.value?.balls;
  if (!balls) return null;
  const column = (vector: (ball: StartingBall) => number[], axis: number) =>
    Float64Array.from(balls, (ball) => vector(ball)[axis] ?? 0);
  const [place, velocity, spin] = [
    (ball: StartingBall) => ball.position,
    (ball: StartingBall) => ball.velocity,
    (ball: StartingBall) => ball.spin ?? [],
  ];
  return {
    time: 0,
    ...{ x: column(place, 0), y: column(place, 1), z: column(place, 2) },
    ...{ vx: column(velocity, 0), vy: column(velocity, 1), vz: column(velocity, 2) },
    ...{ wx: column(spin, 0), wy: column(spin, 1), wz: column(spin, 2) },
  };
});

/** The balls now; on a periodic table they are brought into it. The next call may write into the same arrays. */
export function now(): Moment | null {
  const [film, at] = [run.value?.film, time.value];
  if (!film) return atStart.value;
  if (moment && source === film && moment.time === at) return moment;
  moment = film.at(at, source === film ? moment : undefined);
  source = film;
  const { x, y } = periods.value;
  if (x) moment.x.forEach(bring(moment.x, x));
  if (y) moment.y.forEach(bring(moment.y, y));
  return moment;
}

const bring = (places: Float64Array, period: [number, number]) => (place: number, ball: number) => {
  places[ball] = wrapped(place, period);
};
