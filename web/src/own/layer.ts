/** Draws one's own trajectory over the run: a dashed line, its points, and where the balls would be now. */

import { time } from "../studio/store";
import { type Pen, pixelsOf } from "../table/draw";
import type { Layer } from "../table/layers";
import type { View } from "../table/view";
import { own, rowAt, type Way } from "./own";

/** So many points of each line are drawn, and so many are marked. */
const MOST_POINTS = 4000;
const MOST_MARKS = 200;

export const ownTrajectory: Layer = (pen, { view, bodies, palette }) => {
  const trajectory = own.value;
  if (!trajectory) return;
  pen.save();
  pen.lineJoin = "round";
  for (const way of trajectory.ways) {
    const body = bodies[way.ball];
    if (!body) continue;
    pen.strokeStyle = palette.ink;
    pen.fillStyle = body.colour;
    drawLine(pen, view, way);
    drawMarks(pen, view, way);
    drawGhost(pen, view, trajectory.times, way, pixelsOf(body.radius, view));
  }
  pen.restore();
};

function drawLine(pen: Pen, view: View, { x, y }: Way) {
  pen.beginPath();
  const step = Math.ceil(x.length / MOST_POINTS);
  let isNew = true;
  for (let row = 0; row < x.length; row += step) {
    const [px, py] = [view.x(x[row] as number), view.y(y[row] as number)];
    if (Number.isFinite(px) && Number.isFinite(py)) {
      if (isNew) pen.moveTo(px, py);
      else pen.lineTo(px, py);
      isNew = false;
    } else isNew = true;
  }
  pen.setLineDash([5, 4]);
  pen.lineWidth = 1.25;
  pen.stroke();
  pen.setLineDash([]);
}

function drawMarks(pen: Pen, view: View, { x, y }: Way) {
  const step = Math.ceil(x.length / MOST_MARKS);
  pen.lineWidth = 1;
  for (let row = 0; row < x.length; row += step) {
    const [px, py] = [view.x(x[row] as number), view.y(y[row] as number)];
    if (!Number.isFinite(px) || !Number.isFinite(py)) continue;
    pen.beginPath();
    pen.arc(px, py, 2.5, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  }
}

/** The ball's outline where it is now: on the straight line between two rows. */
function drawGhost(pen: Pen, view: View, times: Float64Array, { x, y }: Way, pixels: number) {
  const row = rowAt(times);
  if (row < 0) return;
  const next = Math.min(row + 1, times.length - 1);
  const span = (times[next] as number) - (times[row] as number);
  const part = span > 0 ? (time.value - (times[row] as number)) / span : 0;
  const between = (of: Float64Array) =>
    (of[row] as number) + part * ((of[next] as number) - (of[row] as number));
  const [px, py] = [view.x(between(x)), view.y(between(y))];
  if (!Number.isFinite(px) || !Number.isFinite(py)) return;
  pen.beginPath();
  pen.arc(px, py, pixels, 0, 2 * Math.PI);
  pen.setLineDash([3, 3]);
  pen.lineWidth = 1.5;
  pen.stroke();
  pen.setLineDash([]);
}
