/** Pictures of an event: the balls around the contact with their velocities, whole or in parts. */

import type { Moment } from "../../engine/film";
import type { Drawing } from "../../engine/protocol";
import { speedOf } from "../../studio/motion";
import type { Palette } from "../../table/colours";
import { drawArrow, drawBalls, drawTable, type Pen } from "../../table/draw";
import type { View } from "../../table/view";
import { type Encounter, parts, placeIn } from "./encounter";

/** The fastest ball's arrow in sizes of the event. */
const ARROW = 1.1;
/** How visible balls are below the parts of their velocities, and balls that take no part. */
const BEHIND = 0.4;
const FAINT = 0.3;

export interface Ground {
  pen: Pen;
  width: number;
  height: number;
  drawn: Drawing;
  colours: string[];
  palette: Palette;
}

type Vector = [number, number];

/** The balls at a moment with the velocities that they have. */
export function drawMoment(ground: Ground, encounter: Encounter, moment: Moment) {
  const { pen, palette } = ground;
  const { earlier, incoming, outgoing, later } = encounter;
  const view = around(ground, encounter, [earlier, incoming, outgoing, later]);
  drawGround(ground, encounter, moment, view, 1);
  const seconds = arrowSeconds(encounter);
  for (const ball of encounter.balls) {
    const velocity: Vector = [moment.vx[ball] as number, moment.vy[ball] as number];
    arrow(pen, view, placeIn(encounter, moment, ball), velocity, seconds, palette.arrow, 2);
  }
}

/** The contact with its normal and tangent, and each velocity with its parts along them. */
export function drawParts(ground: Ground, encounter: Encounter, moment: Moment, normal: Vector) {
  const { pen, palette } = ground;
  const view = around(ground, encounter, [encounter.incoming, encounter.outgoing]);
  drawGround(ground, encounter, moment, view, BEHIND);
  drawLines(ground, encounter, view, normal);
  const seconds = arrowSeconds(encounter);
  const tangent: Vector = [-normal[1], normal[0]];
  for (const ball of encounter.balls.slice(0, 2)) {
    const velocity: Vector = [moment.vx[ball] as number, moment.vy[ball] as number];
    const place = placeIn(encounter, moment, ball);
    const [along, across] = parts(...velocity, normal);
    pen.save();
    pen.globalAlpha = 0.45;
    arrow(pen, view, place, velocity, seconds, palette.arrow, 1.5);
    pen.restore();
    arrow(pen, view, place, [across * tangent[0], across * tangent[1]], seconds, palette.bounce, 2);
    arrow(pen, view, place, [along * normal[0], along * normal[1]], seconds, palette.contact, 2.5);
  }
}

/** One view for the pictures of some moments, with the contact in the middle. */
function around({ width, height, drawn }: Ground, encounter: Encounter, moments: Moment[]): View {
  const { point, size, balls } = encounter;
  const seconds = arrowSeconds(encounter);
  const reach = (moment: Moment) => (ball: number) => {
    const [x, y] = placeIn(encounter, moment, ball);
    const [tipX, tipY] = [x + (moment.vx[ball] ?? 0) * seconds, y + (moment.vy[ball] ?? 0) * seconds];
    const ends = [x, tipX].map((end) => Math.abs(end - point[0]));
    const heights = [y, tipY].map((end) => Math.abs(end - point[1]));
    return Math.max(...ends, ...heights) + (drawn.balls[ball]?.radius ?? 0);
  };
  const reaches = moments.flatMap((moment) => balls.slice(0, 2).map(reach(moment)));
  const half = Math.min(Math.max(size, ...reaches.filter(Number.isFinite)) * 1.08, 4.5 * size);
  const scale = Math.min(width, height) / (2 * half);
  return {
    scale,
    x: (x) => width / 2 + (x - point[0]) * scale,
    y: (y) => height / 2 - (y - point[1]) * scale,
    place: (px, py) => [point[0] + (px - width / 2) / scale, point[1] - (py - height / 2) / scale],
  };
}

function arrowSeconds({ size, balls, earlier, incoming, outgoing, later }: Encounter): number {
  const speeds = [earlier, incoming, outgoing, later].flatMap((moment) =>
    balls.map((ball) => speedOf(moment, ball) || 0),
  );
  const fastest = Math.max(...speeds);
  return fastest > 0 ? (ARROW * size) / fastest : 0;
}

/** The table, and all balls near; those that take no part are faint. */
function drawGround(ground: Ground, encounter: Encounter, moment: Moment, view: View, strength: number) {
  const { pen, width, height, drawn, colours, palette } = ground;
  pen.clearRect(0, 0, width, height);
  if (encounter.open.x || encounter.open.y) {
    pen.fillStyle = palette.cloth;
    pen.fillRect(0, 0, width, height);
  }
  drawTable(pen, drawn.table, view, palette);
  const isNear = ([x, y]: Vector, radius: number) =>
    Math.abs(view.x(x) - width / 2) < width / 2 + radius * view.scale &&
    Math.abs(view.y(y) - height / 2) < height / 2 + radius * view.scale;
  for (const takesPart of [false, true]) {
    const near = drawn.balls
      .map(({ radius }, ball) => ({ radius, ball, place: placeIn(encounter, moment, ball) }))
      .filter(({ ball }) => encounter.balls.includes(ball) === takesPart)
      .filter(({ place, radius }) => isNear(place, radius));
    const [xs, ys] = [0, 1].map((axis) => Float64Array.from(near, ({ place }) => place[axis] as number));
    const bodies = near.map(({ radius, ball }) => ({ radius, colour: colours[ball] as string }));
    pen.save();
    pen.globalAlpha = takesPart ? strength : FAINT;
    drawBalls(pen, bodies, { x: xs as Float64Array, y: ys as Float64Array }, view, palette);
    pen.restore();
  }
}

/** The normal and the tangent through the contact, with their letters. */
function drawLines({ pen, width, palette }: Ground, { point }: Encounter, view: View, normal: Vector) {
  const [x, y] = [view.x(point[0]), view.y(point[1])];
  const lines = [
    { way: [normal[0], -normal[1]], dash: [7, 4], letter: "n", colour: palette.contact },
    { way: [-normal[1], -normal[0]], dash: [2, 4], letter: "t", colour: palette.bounce },
  ] as const;
  pen.save();
  pen.lineWidth = 1.25;
  pen.font = "italic 600 13px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (const { way, dash, letter, colour } of lines) {
    const reach = width / 2 - 14;
    pen.strokeStyle = pen.fillStyle = colour;
    pen.setLineDash([...dash]);
    pen.beginPath();
    pen.moveTo(x - way[0] * width, y - way[1] * width);
    pen.lineTo(x + way[0] * width, y + way[1] * width);
    pen.stroke();
    pen.fillText(letter, x + way[0] * reach + way[1] * 10, y + way[1] * reach - way[0] * 10);
  }
  pen.restore();
}

function arrow(pen: Pen, view: View, at: Vector, v: Vector, seconds: number, colour: string, width: number) {
  if (!Number.isFinite(at[0])) return;
  const from = [view.x(at[0]), view.y(at[1])] as const;
  drawArrow(pen, from, [view.x(at[0] + v[0] * seconds), view.y(at[1] + v[1] * seconds)], colour, width);
}
