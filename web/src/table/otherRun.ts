/** A second run on the table: its balls as dashed rings, and their ways dashed. */

import { drawing, type Shown, time } from "../studio/store";
import { inkOn } from "./contrast";
import { type Body, type Pen, pixelsOf } from "./draw";
import { clipToTable, onTable, periods } from "./periodic";
import type { Scene } from "./Table";
import { drawWay } from "./trails";

/** So many flights of all balls together have a trail. */
const FLIGHTS = 2000;
/** Pixels of the line of a ring, which is thinner on a small ball, and of the edge of a ball inside of which it stays. */
const [THIN, THICK, EDGE] = [1, 2.5, 0.5];
/** A dash is so many times as long as the line is wide. */
const DASH = 1.8;

/** Draws the balls of a run at the time of the table, or at its own end, and the ways that they have come. */
export function drawOtherRun(pen: Pen, scene: Scene, { film, summary }: Shown) {
  const [drawn, open] = [drawing.value, periods.value];
  const { view, bodies } = scene;
  if (!drawn || film.ballCount !== bodies.length) return;
  const at = Math.min(time.value, summary.endTime);
  const moment = film.at(at);
  pen.save();
  if (open.x || open.y) clipToTable(pen, drawn.table, view);
  bodies.forEach((body, ball) => {
    pen.setLineDash([5, 4]);
    drawWay(pen, scene, film, ball, at, Math.ceil(FLIGHTS / bodies.length));
    if (Number.isNaN(moment.x[ball])) return;
    const [x, y] = onTable(moment.x[ball] as number, moment.y[ball] as number, open);
    drawGhost(pen, view.x(x), view.y(y), pixelsOf(body.radius, view), body);
  });
  pen.restore();
}

/** A ball that lets through what is below it, with a ring that is seen on the cloth and on a ball of its colour. */
function drawGhost(pen: Pen, x: number, y: number, pixels: number, { colour }: Body) {
  const width = Math.min(Math.max(0.18 * pixels, THIN), THICK);
  const radius = pixels - EDGE - width / 2;
  const half = Math.PI * radius;
  const dash = half / Math.max(Math.round(half / (DASH * width)), 3);
  pen.setLineDash([]);
  pen.lineCap = "butt";
  pen.lineWidth = width;
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.globalAlpha = 0.25;
  pen.fillStyle = colour;
  pen.fill();
  pen.globalAlpha = 1;
  pen.strokeStyle = inkOn(colour);
  pen.stroke();
  pen.setLineDash([dash, dash]);
  pen.strokeStyle = colour;
  pen.stroke();
}
