/** The balls now, where they are to be drawn. */

import type { Film, Moment } from "../engine/film";
import { run, time } from "../studio/store";
import { periods, wrapped } from "./periodic";

let moment: Moment | undefined;
let source: Film | undefined;

/** The balls now; on a periodic table they are brought into it. The next call may write into the same arrays. */
export function now(): Moment | null {
  const [film, at] = [run.value?.film, time.value];
  if (!film) return null;
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
