/** What is drawn on the table, from the ground up. A layer reads signals and draws; it changes nothing. */

import type { Moment } from "../engine/film";
import { lessonBalls, lessonDirections } from "../lessons/layer";
import { lesson } from "../lessons/state";
import { otherRun, partingPlace } from "../panels/compare/layer";
import { drawing, run, time } from "../studio/store";
import { drawArrow, drawBalls, drawTable, type Pen } from "./draw";
import { arrowSeconds, options } from "./options";
import type { Scene } from "./Table";
import { trail } from "./trails";

export type Layer = (pen: Pen, scene: Scene) => void;

/** So many flights of each ball have a trail; less where there are many balls. */
const TRAIL_FLIGHTS = 4000;
/** From so many balls on there are no arrows unless they are asked for. */
const MANY = 60;

let moment: Moment | undefined;

/** The balls now. */
export function now(): Moment | null {
  const film = run.value?.film;
  if (!film) return null;
  moment = film.at(time.value, moment?.x.length === film.ballCount ? moment : undefined);
  return moment;
}

const ground: Layer = (pen, { view, palette }) => {
  const drawn = drawing.value;
  if (drawn) drawTable(pen, drawn.table, view, palette);
};

const trails: Layer = (pen, { view, bodies }) => {
  const film = run.value?.film;
  if (!film || !options.value.trails || bodies.length > MANY) return;
  pen.save();
  pen.lineWidth = 1.25;
  pen.lineJoin = "round";
  bodies.forEach(({ colour }, ball) => {
    const points = trail(film, ball, time.value, Math.ceil(TRAIL_FLIGHTS / bodies.length));
    pen.beginPath();
    for (let k = 0; k + 1 < points.length; k += 2) {
      pen.lineTo(view.x(points[k] as number), view.y(points[k + 1] as number));
    }
    pen.strokeStyle = colour;
    pen.globalAlpha = 0.65;
    pen.stroke();
  });
  pen.restore();
};

const balls: Layer = (pen, { view, bodies, palette }) => {
  const state = now();
  if (state) drawBalls(pen, bodies, state, view, palette);
};

const arrows: Layer = (pen, { view, bodies, palette }) => {
  const state = now();
  if (!state || !options.value.arrows || bodies.length > MANY) return;
  const seconds = arrowSeconds.value;
  bodies.forEach((_, ball) => {
    const [x, y] = [state.x[ball] as number, state.y[ball] as number];
    if (Number.isNaN(x)) return;
    const [vx, vy] = [state.vx[ball] as number, state.vy[ball] as number];
    const from = [view.x(x), view.y(y)] as const;
    drawArrow(pen, from, [view.x(x + vx * seconds), view.y(y + vy * seconds)], palette.arrow);
  });
};

/** What panels draw is not wanted in a lesson, which has its own. */
const besideLessons =
  (layer: Layer): Layer =>
  (pen, scene) => {
    if (!lesson.value) layer(pen, scene);
  };

export const layers: Layer[] = [
  ground,
  trails,
  lessonBalls,
  balls,
  besideLessons(otherRun),
  arrows,
  besideLessons(partingPlace),
  lessonDirections,
];
