/** What a lesson draws on the table: the balls of its second run, and directions, the predicted and the real one. */

import { drawing, time } from "../studio/store";
import { drawArrow, type Pen, pixelsOf } from "../table/draw";
import type { Scene } from "../table/Table";
import { trail } from "../table/trails";
import { drawn, isLocked, other, part, prediction, result } from "./state";

/** So many flights of each ball have a trail. */
const TRAIL_FLIGHTS = 400;

/** The second run: dashed, so that it is told from the first without its colour. */
export function lessonBalls(pen: Pen, { view, bodies, palette }: Scene) {
  const film = other.value?.film;
  if (!film || isLocked.value) return;
  const state = film.at(Math.min(time.value, other.value?.summary.endTime ?? 0));
  pen.save();
  pen.lineWidth = 1.5;
  bodies.forEach(({ radius, colour }, ball) => {
    const points = trail(film, ball, time.value, TRAIL_FLIGHTS);
    pen.setLineDash([2, 4]);
    pen.strokeStyle = colour;
    pen.beginPath();
    for (let k = 0; k + 1 < points.length; k += 2) {
      pen.lineTo(view.x(points[k] as number), view.y(points[k + 1] as number));
    }
    pen.stroke();
    pen.setLineDash([5, 4]);
    pen.beginPath();
    const [x, y] = [view.x(state.x[ball] as number), view.y(state.y[ball] as number)];
    pen.arc(x, y, pixelsOf(radius, view), 0, 2 * Math.PI);
    pen.globalAlpha = 0.25;
    pen.fillStyle = colour;
    pen.fill();
    pen.globalAlpha = 1;
    pen.strokeStyle = palette.ink;
    pen.stroke();
  });
  pen.restore();
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
