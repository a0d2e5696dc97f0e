/** The chosen ball, the handle of its arrow, and what is dragged. */

import { chosen, drawing, run, time } from "../studio/store";
import { type Drag, drag, tipOf } from "./drag";
import type { Body, Pen } from "./draw";
import { drawArrow, pixelsOf } from "./draw";
import { now } from "./moment";
import { arrowSeconds } from "./options";
import type { Scene } from "./Table";
import type { View } from "./view";

const FULL = 2 * Math.PI;

export function handles(pen: Pen, scene: Scene) {
  const [ball, dragged] = [chosen.value, drag.value];
  pen.save();
  if (dragged) ghost(pen, scene, dragged);
  else if (ball !== null && run.value) ring(pen, scene, ball);
  pen.restore();
}

/** A ring around the chosen ball, and at the start the handle of its arrow. */
function ring(pen: Pen, { view, bodies, palette }: Scene, ball: number) {
  const [moment, body] = [now(), bodies[ball]];
  if (!moment || !body || Number.isNaN(moment.x[ball])) return;
  const [px, py] = [view.x(moment.x[ball] as number), view.y(moment.y[ball] as number)];
  circle(pen, px, py, pixelsOf(body.radius, view) + 4);
  pen.lineWidth = 2;
  pen.strokeStyle = palette.ink;
  pen.stroke();
  const tip = time.value === 0 ? tipOf(ball, view) : null;
  if (!tip) return;
  circle(pen, tip[0], tip[1], 8);
  pen.globalAlpha = 0.25;
  pen.fillStyle = palette.ink;
  pen.fill();
  pen.globalAlpha = 1;
  pen.lineWidth = 1.25;
  pen.stroke();
}

/** What is dragged where it would lie: hollow and crossed out where the engine refuses it. */
function ghost(pen: Pen, scene: Scene, dragged: Drag) {
  const start = drawing.value?.balls[dragged.ball];
  const body = scene.bodies[dragged.ball];
  if (!start || !body) return;
  const { view, palette } = scene;
  const [x = 0, y = 0] = start.position;
  const isWrong = dragged.problems.length > 0;
  const colour = isWrong ? palette.contact : palette.ink;
  const tip: [number, number] = [view.x(dragged.place[0]), view.y(dragged.place[1])];
  if (dragged.kind === "arrow") {
    drawArrow(pen, [view.x(x), view.y(y)], tip, colour, 3);
    circle(pen, tip[0], tip[1], 6);
    stroked(pen, colour, false);
    return;
  }
  veil(pen, scene, [view.x(x), view.y(y)], body);
  ghostBall(pen, body, tip, view, colour, isWrong);
  const seconds = arrowSeconds.value;
  const [vx = 0, vy = 0] = start.velocity;
  drawArrow(pen, tip, [tip[0] + vx * seconds * view.scale, tip[1] - vy * seconds * view.scale], colour);
}

function ghostBall(
  pen: Pen,
  { radius, colour: fill }: Body,
  [px, py]: readonly [number, number],
  view: View,
  colour: string,
  isWrong: boolean,
) {
  const pixels = pixelsOf(radius, view);
  circle(pen, px, py, pixels);
  pen.globalAlpha = isWrong ? 0.35 : 0.9;
  pen.fillStyle = fill;
  pen.fill();
  pen.globalAlpha = 1;
  stroked(pen, colour, isWrong);
  if (!isWrong) return;
  const half = Math.max(pixels, 6) * 0.55;
  pen.beginPath();
  pen.moveTo(px - half, py - half);
  pen.lineTo(px + half, py + half);
  pen.moveTo(px + half, py - half);
  pen.lineTo(px - half, py + half);
  pen.setLineDash([]);
  pen.stroke();
}

/** Where the ball lies still, it is paler. */
function veil(pen: Pen, { view, palette }: Scene, [px, py]: readonly [number, number], { radius }: Body) {
  circle(pen, px, py, pixelsOf(radius, view) + 1);
  pen.globalAlpha = 0.6;
  pen.fillStyle = palette.cloth;
  pen.fill();
  pen.globalAlpha = 1;
}

function stroked(pen: Pen, colour: string, isDashed: boolean) {
  pen.strokeStyle = colour;
  pen.lineWidth = 2;
  pen.setLineDash(isDashed ? [5, 4] : []);
  pen.stroke();
}

function circle(pen: Pen, px: number, py: number, pixels: number) {
  pen.beginPath();
  pen.arc(px, py, pixels, 0, FULL);
}
