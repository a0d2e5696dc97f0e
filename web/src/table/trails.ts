/** The ways that balls have gone. What is behind them is drawn once into a picture of its own, which grows. */

import type { Film } from "../engine/film";
import { drawing, run, time } from "../studio/store";
import { visible } from "./contrast";
import type { Pen } from "./draw";
import type { Layer } from "./layers";
import { options } from "./options";
import { clipToTable, type Periods, periods, shifts } from "./periodic";
import type { Scene } from "./Table";
import type { View } from "./view";

/** So many points at most lie on a curved flight. */
const BEND = 12;
/** So many flights of all balls together have a trail, at least; twice as many at most. */
const FLIGHTS = 400;
/** From so many balls on there are no trails. */
const MANY = 60;
const ALPHA = 0.65;

/** The picture of flights that are over, what it was drawn from, and how far it has come for each ball. */
interface Past {
  pen: Pen;
  film: Film;
  scene: Scene;
  firsts: number[];
  drawn: number[];
}

let past: Past | undefined;

export const trails: Layer = (pen, scene) => {
  const [film, drawn] = [run.value?.film, drawing.value];
  if (!film || !drawn || !options.value.trails || film.ballCount > MANY) return;
  const [at, open] = [time.value, periods.value];
  const rows = Array.from({ length: film.ballCount }, (_, ball) => film.row(ball, at));
  pen.save();
  if (open.x || open.y) clipToTable(pen, drawn.table, scene.view);
  pen.globalAlpha = ALPHA;
  // A picture in SVG is drawn once, and gets lines in place of pixels.
  const firsts = rows.map((row, ball) => firstRow(film, ball, row));
  const isOnScreen =
    typeof CanvasRenderingContext2D !== "undefined" && pen instanceof CanvasRenderingContext2D;
  if (isOnScreen) drawPast(pen, film, scene, firsts, rows);
  rows.forEach((row, ball) => {
    const from = isOnScreen ? row : (firsts[ball] as number);
    stroke(pen, scene, ball, way(film, ball, from, row, at), open);
  });
  pen.restore();
};

/** Draws the way of a ball of any run up to a time, on its last so many flights. */
export function drawWay(pen: Pen, scene: Scene, film: Film, ball: number, at: number, most: number) {
  stroke(pen, scene, ball, trail(film, ball, at, most), periods.value);
}

/** The way of a ball up to a time, on its last so many flights: x and y in turn. */
export function trail(film: Film, ball: number, at: number, most: number): number[] {
  const row = film.row(ball, at);
  return way(film, ball, Math.max(film.data.firstRows[ball] as number, row - most + 1), row, at);
}

/** The first flight that is shown: it depends on the time only, however the page has come to it. */
function firstRow(film: Film, ball: number, row: number): number {
  const first = film.data.firstRows[ball] as number;
  const block = Math.ceil(FLIGHTS / film.ballCount);
  return first + Math.max(0, Math.floor((row - first) / block) - 1) * block;
}

function drawPast(pen: Pen, film: Film, scene: Scene, firsts: number[], rows: number[]) {
  const goesOn =
    past?.film === film &&
    past.scene === scene &&
    past.firsts.every(
      (first, ball) => first === firsts[ball] && (past?.drawn[ball] as number) <= (rows[ball] as number),
    );
  if (!past || !goesOn) past = newPast(pen, film, scene, firsts);
  const { drawn } = past;
  for (let ball = 0; ball < rows.length; ball++) {
    const [from, to] = [drawn[ball] as number, rows[ball] as number];
    if (from < to) stroke(past.pen, scene, ball, way(film, ball, from, to - 1), periods.value);
    drawn[ball] = to;
  }
  pen.save();
  pen.setTransform(1, 0, 0, 1, 0, 0);
  pen.drawImage(past.pen.canvas, 0, 0);
  pen.restore();
}

function newPast(pen: Pen, film: Film, scene: Scene, firsts: number[]): Past {
  const canvas = past?.pen.canvas ?? document.createElement("canvas");
  // To set the size clears the picture.
  canvas.width = pen.canvas.width;
  canvas.height = pen.canvas.height;
  const own = canvas.getContext("2d") as Pen;
  own.setTransform(pen.getTransform());
  return { pen: own, film, scene, firsts, drawn: [...firsts] };
}

/** The way of a ball on some of its flights, the last one up to a time: x and y in turn. */
function way(film: Film, ball: number, from: number, to: number, until = Number.POSITIVE_INFINITY): number[] {
  const { width, numbers, firstRows } = film.data;
  const after = firstRows[ball + 1] as number;
  const n = (row: number, place: number) => numbers[row * width + place] as number;
  const [v, a] = film.isOnCloth ? [4, 7] : [3, 5];
  const points: number[] = [];
  for (let row = from; row <= to; row++) {
    const end = Math.min(row + 1 < after ? n(row + 1, 0) : until, until) - n(row, 0);
    const count = n(row, a) === 0 && n(row, a + 1) === 0 ? 1 : BEND;
    for (let k = points.length === 0 ? 0 : 1; k <= count; k++) {
      const s = (end * k) / count;
      const x = n(row, 1) + (n(row, v) + n(row, a) * s * 0.5) * s;
      const y = n(row, 2) + (n(row, v + 1) + n(row, a + 1) * s * 0.5) * s;
      if (!Number.isNaN(x)) points.push(x, y);
    }
  }
  return points;
}

function stroke(pen: Pen, { view, bodies, palette }: Scene, ball: number, points: number[], open: Periods) {
  pen.strokeStyle = visible(bodies[ball]?.colour ?? palette.ink, palette.cloth, palette.ink);
  pen.lineWidth = 1.25;
  pen.lineJoin = pen.lineCap = "round";
  pen.beginPath();
  if (open.x || open.y) folded(pen, view, points, open);
  else {
    for (let k = 0; k + 1 < points.length; k += 2) {
      pen.lineTo(view.x(points[k] as number), view.y(points[k + 1] as number));
    }
  }
  pen.stroke();
}

/** Each stretch as often as it shows in the table. */
function folded(pen: Pen, view: View, points: number[], open: Periods) {
  for (let k = 0; k + 3 < points.length; k += 2) {
    const [x0, y0, x1, y1] = points.slice(k, k + 4) as [number, number, number, number];
    for (const dx of shifts(Math.min(x0, x1), Math.max(x0, x1), open.x)) {
      for (const dy of shifts(Math.min(y0, y1), Math.max(y0, y1), open.y)) {
        pen.moveTo(view.x(x0 + dx), view.y(y0 + dy));
        pen.lineTo(view.x(x1 + dx), view.y(y1 + dy));
      }
    }
  }
}
