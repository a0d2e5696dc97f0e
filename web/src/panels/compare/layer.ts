/** The other run on the table: rings where its balls are, their ways dashed, and the place where the runs part. */

import { run, time } from "../../studio/store";
import { pixelsOf } from "../../table/draw";
import type { Layer } from "../../table/layers";
import { trail } from "../../table/trails";
import { compared, other } from "./state";

/** So many flights of each ball have a trail. */
const TRAIL_FLIGHTS = 2000;

export const otherRun: Layer = (pen, { view, bodies }) => {
  const shown = other.value;
  if (!shown || shown.film.ballCount !== bodies.length) return;
  const at = Math.min(time.value, shown.summary.endTime);
  const moment = shown.film.at(at);
  pen.save();
  pen.setLineDash([5, 4]);
  bodies.forEach(({ radius, colour }, ball) => {
    const points = trail(shown.film, ball, at, Math.ceil(TRAIL_FLIGHTS / bodies.length));
    pen.beginPath();
    for (let k = 0; k + 1 < points.length; k += 2) {
      pen.lineTo(view.x(points[k] as number), view.y(points[k + 1] as number));
    }
    pen.strokeStyle = colour;
    pen.lineWidth = 1.25;
    pen.stroke();
    if (Number.isNaN(moment.x[ball])) return;
    pen.beginPath();
    const centre = [view.x(moment.x[ball] as number), view.y(moment.y[ball] as number)] as const;
    pen.arc(...centre, pixelsOf(radius, view), 0, 2 * Math.PI);
    pen.lineWidth = 2.5;
    pen.stroke();
  });
  pen.restore();
};

/** A cross where the ball that parts first is at that moment, once the time has come there. */
export const partingPlace: Layer = (pen, { view, palette }) => {
  const parting = compared.value?.parting;
  const film = run.value?.film;
  if (!parting || !film || time.value < parting.time) return;
  const moment = film.at(parting.time);
  const [x, y] = [view.x(moment.x[parting.ball] as number), view.y(moment.y[parting.ball] as number)];
  pen.save();
  pen.strokeStyle = palette.contact;
  pen.lineWidth = 2.5;
  pen.beginPath();
  for (const [dx, dy] of [
    [6, 6],
    [6, -6],
  ] as const) {
    pen.moveTo(x - dx, y - dy);
    pen.lineTo(x + dx, y + dy);
  }
  pen.stroke();
  pen.restore();
};
