/** The balls on the table: with their ids where there is room, shadows where they fly, copies where they cross over. */

import type { Moment } from "../engine/film";
import { drawing, run } from "../studio/store";
import { inkOn } from "./contrast";
import { type Body, drawBalls, type Pen, pixelsOf } from "./draw";
import type { Layer } from "./layers";
import { now } from "./moment";
import { options } from "./options";
import { clipToTable, type Periods, periods } from "./periodic";
import type { Scene } from "./Table";

/** From so many balls on they have no ids. */
const MANY = 400;
/** The smallest letters, in pixels. */
const SMALLEST = 7;
/** A ball that is as high as this many of its radii looks a third larger. */
const HIGH = 4;

export const balls: Layer = (pen, scene) => {
  const [state, drawn, open] = [now(), drawing.value, periods.value];
  if (!state || !drawn) return;
  const bodies = run.value?.film.isOnCloth ? lifted(pen, scene, state) : scene.bodies;
  pen.save();
  if (open.x || open.y) {
    clipToTable(pen, drawn.table, scene.view);
    drawCopies(pen, scene, state, open);
  }
  drawBalls(pen, bodies, state, scene.view, scene.palette);
  pen.restore();
};

/** The ids, over the arrows that begin in the middle of the balls. */
export const ids: Layer = (pen, scene) => {
  const [state, drawn, open] = [now(), drawing.value, periods.value];
  if (!state || !drawn || !options.value.ids || scene.bodies.length >= MANY) return;
  pen.save();
  if (open.x || open.y) clipToTable(pen, drawn.table, scene.view);
  drawIds(pen, scene, state);
  pen.restore();
};

/** Balls in the air are nearer to who looks down: they are larger, and their shadows fall beside them. */
function lifted(pen: Pen, { view, bodies }: Scene, { x, y, z }: Moment): Body[] {
  return bodies.map((body, ball) => {
    const height = ((z[ball] as number) - body.radius) / body.radius;
    if (!(height > 0.02)) return body;
    const away = Math.min(height, 3 * HIGH) * 0.3 * body.radius * view.scale;
    pen.save();
    pen.globalAlpha = 0.35;
    pen.fillStyle = "#000000";
    pen.beginPath();
    const [px, py] = [view.x(x[ball] as number) + away, view.y(y[ball] as number) + away];
    pen.arc(px, py, pixelsOf(body.radius, view), 0, 2 * Math.PI);
    pen.fill();
    pen.restore();
    return { ...body, radius: body.radius * (1 + Math.min(height / (3 * HIGH), 0.6)) };
  });
}

/** A ball that crosses an open side is seen on the other side as well. */
function drawCopies(pen: Pen, { view, bodies, palette }: Scene, { x, y }: Moment, open: Periods) {
  const [copies, xs, ys]: [Body[], number[], number[]] = [[], [], []];
  bodies.forEach((body, ball) => {
    const [px, py] = [x[ball] as number, y[ball] as number];
    if (isInside(px, body.radius, open.x) && isInside(py, body.radius, open.y)) return;
    for (const dx of crossings(px, body.radius, open.x)) {
      for (const dy of crossings(py, body.radius, open.y)) {
        if (dx === 0 && dy === 0) continue;
        copies.push(body);
        xs.push(px + dx);
        ys.push(py + dy);
      }
    }
  });
  drawBalls(
    pen,
    copies,
    { x: Float64Array.from(xs), y: Float64Array.from(ys) },
    view,
    palette,
    bodies.length,
  );
}

const isInside = (place: number, radius: number, period: [number, number] | null) =>
  !period || (place - radius >= period[0] && place + radius <= period[0] + period[1]);

function crossings(place: number, radius: number, period: [number, number] | null): number[] {
  if (!period) return [0];
  const [low, length] = period;
  if (place - radius < low) return [0, length];
  return place + radius > low + length ? [0, -length] : [0];
}

function drawIds(pen: Pen, { view, bodies }: Scene, { x, y }: Moment) {
  const balls = drawing.value?.balls ?? [];
  pen.lineJoin = "round";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  bodies.forEach(({ radius, colour }, ball) => {
    const room = 1.7 * radius * view.scale;
    const id = balls[ball]?.id ?? "";
    const letters = Math.min(room * 0.68, (1.6 * room) / Math.max(id.length, 1), 15);
    if (letters < SMALLEST || Number.isNaN(x[ball])) return;
    pen.font = `600 ${letters.toFixed(1)}px system-ui, sans-serif`;
    const at = [view.x(x[ball] as number), view.y(y[ball] as number) + letters * 0.06] as const;
    // A rim in the ball's colour keeps the letters off the arrow below them.
    pen.strokeStyle = colour;
    pen.lineWidth = letters * 0.3;
    pen.strokeText(id, ...at);
    pen.fillStyle = inkOn(colour);
    pen.fillText(id, ...at);
  });
}
