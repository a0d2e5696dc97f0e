/** The aim on the table: the way of the struck ball to its first contact, the ghost ball there, and the stick. */

import { pixelsOf } from "../../table/draw";
import type { Layer } from "../../table/layers";
import { trail } from "../../table/trails";
import type { View } from "../../table/view";
import { forecast, isAiming } from "./state";

/** So many flights of the struck ball are drawn. */
const FLIGHTS = 400;

/** The first way of a ball that is hit is drawn so long, in parts of the table's size; that of the struck ball shorter. */
const HIT_WAY = 0.16;
const OWN_WAY = 0.08;

/** How far the stick is drawn back, in parts of the table's size for each time that its speed needs for that size. */
const DRAWN_BACK = 0.012;

/** Pixels that the stick is thick at least, on each side of its axis. */
const THINNEST = 1.6;

export const aimLine: Layer = (pen, { view, bodies, palette }) => {
  const found = forecast.value;
  if (!isAiming.value || !found) return;
  const { shown, contact, drawn, shot } = found;
  const end = contact?.time ?? shown.summary.endTime;
  const points = trail(shown.film, shot.ball, end, FLIGHTS);
  pen.save();
  pen.lineWidth = 1.75;
  pen.lineJoin = "round";
  pen.strokeStyle = palette.ink;
  pen.setLineDash([7, 5]);
  pen.beginPath();
  for (let k = 0; k + 1 < points.length; k += 2) {
    pen.lineTo(view.x(points[k] as number), view.y(points[k + 1] as number));
  }
  pen.stroke();
  pen.setLineDash([]);
  const moment = shown.film.at(end);
  const place = (ball: number) => [moment.x[ball] as number, moment.y[ball] as number] as const;
  const radius = pixelsOf(bodies[shot.ball]?.radius ?? 0, view);
  ring(pen, view, place(shot.ball), radius);
  if (contact) {
    const velocity = (ball: number) => [moment.vx[ball] as number, moment.vy[ball] as number] as const;
    pen.lineWidth = 2.5;
    way(pen, view, place(contact.other), velocity(contact.other), HIT_WAY * drawn.table.size);
    pen.lineWidth = 1.25;
    way(pen, view, place(shot.ball), velocity(shot.ball), OWN_WAY * drawn.table.size);
  }
  pen.restore();
};

type Pair = readonly [number, number];

function ring(pen: CanvasRenderingContext2D, view: View, [x, y]: Pair, pixels: number) {
  if (Number.isNaN(x)) return;
  pen.beginPath();
  pen.arc(view.x(x), view.y(y), pixels, 0, 2 * Math.PI);
  pen.stroke();
}

/** A line from a place in the direction of a velocity. */
function way(pen: CanvasRenderingContext2D, view: View, [x, y]: Pair, [vx, vy]: Pair, length: number) {
  const speed = Math.hypot(vx, vy);
  if (!(speed > 0)) return;
  pen.beginPath();
  pen.moveTo(view.x(x), view.y(y));
  pen.lineTo(view.x(x + (vx / speed) * length), view.y(y + (vy / speed) * length));
  pen.stroke();
}

/** The parts of the stick from the butt to the tip: from where to where over its length, and their colours. */
const PARTS = [
  [0.6, 1, "#5b3a21"],
  [0, 0.6, "#d9b27c"],
  [0, 0.012, "#3d6fa8"],
] as const;
const EDGE = "#2b1c10";

/** The stick as it is seen from above, drawn back the further the harder it strikes. */
export const stick: Layer = (pen, { view }) => {
  const found = forecast.value;
  if (!isAiming.value || !found) return;
  const { cue, shot, drawn } = found;
  const at = axisOf(found);
  const gap =
    0.4 * (drawn.balls[shot.ball]?.radius ?? 0) + DRAWN_BACK * Math.min(shot.speed, 4 * drawn.table.size);
  const thickness = (part: number) => cue.shaft_radius + (cue.butt_radius - cue.shaft_radius) * part;
  const corner = (part: number, side: 1 | -1): Pair => {
    const [x, y] = at(gap + part * cue.length, side * Math.max(thickness(part), THINNEST / view.scale));
    return [view.x(x), view.y(y)];
  };
  pen.save();
  pen.lineWidth = 1;
  pen.lineJoin = "round";
  pen.strokeStyle = EDGE;
  for (const [from, to, colour] of PARTS) {
    pen.beginPath();
    for (const [x, y] of [corner(from, 1), corner(to, 1), corner(to, -1), corner(from, -1)]) pen.lineTo(x, y);
    pen.closePath();
    pen.fillStyle = colour;
    pen.fill();
    pen.stroke();
  }
  pen.restore();
};

/** Gives the place that is so far along the stick behind where its tip would touch, and so far to the left of its axis. */
function axisOf({ shot, drawn }: NonNullable<typeof forecast.value>) {
  const { radius = 0, position: [x = 0, y = 0] = [] } = drawn.balls[shot.ball] ?? {};
  const [[dx, dy], [cos, sin]] = [shot.direction, shot.elevation];
  const behind = Math.sqrt(1 - shot.left ** 2 - shot.top ** 2) * cos - shot.top * sin;
  return (back: number, left: number): Pair => {
    const [along, aside] = [-behind * radius - back * cos, shot.left * radius + left];
    return [x + dx * along - dy * aside, y + dy * along + dx * aside];
  };
}
