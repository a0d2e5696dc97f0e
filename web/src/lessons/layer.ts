/** What a lesson draws on the table: the balls of its second run, and directions, the predicted and the real one. */

import { drawing } from "../studio/store";
import { drawArrow, type Pen, pixelsOf } from "../table/draw";
import { drawOtherRun } from "../table/otherRun";
import type { Scene } from "../table/Table";
import { drawn, isLocked, other, part, prediction, result } from "./state";

/** The second run, below the first. */
export function lessonBalls(pen: Pen, scene: Scene) {
  if (other.value && !isLocked.value) drawOtherRun(pen, scene, other.value);
}

/** Pixels of an arrow beyond the rim of its ball. */
const ARROW = 110;

/** The direction that is predicted, dashed, and the one that the run gave. */
export function lessonDirections(pen: Pen, { view, palette }: Scene) {
  const question = part.value?.question;
  if (question?.kind !== "direction") return;
  const start = drawing.value?.balls[question.ball];
  if (!start) return;
  const [x, y] = [view.x(start.position[0] as number), view.y(start.position[1] as number)];
  const arrow = (degrees: number, colour: string, dash: number[]) => {
    const length = pixelsOf(start.radius, view) + ARROW;
    const angle = (degrees * Math.PI) / 180;
    pen.setLineDash(dash);
    drawArrow(pen, [x, y], [x + length * Math.cos(angle), y - length * Math.sin(angle)], colour, 3);
  };
  const [guess, real] = [prediction.value ?? drawn.value, result.value];
  pen.save();
  if (guess !== null) arrow(guess, palette.contact, [7, 6]);
  if (real !== null) arrow(real, palette.ink, []);
  pen.restore();
}
