/** What is drawn on the table, from the ground up. A layer reads signals and draws; it changes nothing. */

import { lessonBalls, lessonDirections } from "../lessons/layer";
import { lesson } from "../lessons/state";
import { ownTrajectory } from "../own/layer";
import { otherRun, partingPlace } from "../panels/compare/layer";
import { drawing } from "../studio/store";
import { balls, ids } from "./balls";
import { contacts } from "./contacts";
import { drawArrow, drawTable, type Pen } from "./draw";
import { now } from "./moment";
import { arrowSeconds, isAhead, options } from "./options";
import { spin } from "./spin";
import type { Scene } from "./Table";
import { trails } from "./trails";

export type Layer = (pen: Pen, scene: Scene) => void;

/** From so many balls on there are no arrows unless they are asked for. */
const MANY = 60;

const ground: Layer = (pen, { view, palette }) => {
  const drawn = drawing.value;
  if (drawn) drawTable(pen, drawn.table, view, palette);
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

/** A stroke that is not made yet has moved nothing. */
const unlessAhead =
  (layer: Layer): Layer =>
  (pen, scene) => {
    if (!isAhead.value) layer(pen, scene);
  };

export const layers: Layer[] = [
  ground,
  trails,
  contacts,
  lessonBalls,
  balls,
  besideLessons(otherRun),
  unlessAhead(arrows),
  unlessAhead(spin),
  besideLessons(partingPlace),
  besideLessons(ownTrajectory),
  lessonDirections,
  ids,
];
