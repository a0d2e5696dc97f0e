/** The other run on the table, and the place where the runs part. */

import { run, time } from "../../studio/store";
import type { Layer } from "../../table/layers";
import { drawOtherRun } from "../../table/otherRun";
import { onTable, periods } from "../../table/periodic";
import { compared, other } from "./state";

export const otherRun: Layer = (pen, scene) => {
  if (other.value) drawOtherRun(pen, scene, other.value);
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
