/** The other run on the table: rings where its balls are, their ways dashed, and the place where the runs part. */

import { drawing, run, time } from "../../studio/store";
import { visible } from "../../table/contrast";
import { pixelsOf } from "../../table/draw";
import type { Layer } from "../../table/layers";
import { clipToTable, onTable, periods } from "../../table/periodic";
import { drawWay } from "../../table/trails";
import { compared, other } from "./state";

/** So many flights of each ball have a trail. */
const TRAIL_FLIGHTS = 2000;

export const otherRun: Layer = (pen, scene) => {
  const [shown, drawn, open] = [other.value, drawing.value, periods.value];
  const { view, bodies, palette } = scene;
  if (!shown || !drawn || shown.film.ballCount !== bodies.length) return;
  const at = Math.min(time.value, shown.summary.endTime);
  const moment = shown.film.at(at);
  pen.save();
  if (open.x || open.y) clipToTable(pen, drawn.table, view);
  pen.setLineDash([5, 4]);
  bodies.forEach(({ radius, colour }, ball) => {
    drawWay(pen, scene, shown.film, ball, at, Math.ceil(TRAIL_FLIGHTS / bodies.length));
    if (Number.isNaN(moment.x[ball])) return;
    pen.beginPath();
    const [x, y] = onTable(moment.x[ball] as number, moment.y[ball] as number, open);
    pen.strokeStyle = visible(colour, palette.cloth, palette.ink);
    pen.arc(view.x(x), view.y(y), pixelsOf(radius, view), 0, 2 * Math.PI);
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
  const place = [moment.x[parting.ball] as number, moment.y[parting.ball] as number] as const;
  const [tableX, tableY] = onTable(...place, periods.value);
  const [x, y] = [view.x(tableX), view.y(tableY)];
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
