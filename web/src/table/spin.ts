/**
 * Spin of balls on a cloth. A dotted arrow from the ball shows the way its spin drives it: where it would go at the speed
 * with which its lowest point turns back. It lies on the arrow of the velocity while the ball rolls, is longer with top
 * spin, and points backwards with back spin. An arrow round the ball shows the spin about the vertical; it goes nearly round
 * where a point on the ball's equator is as fast as the fastest ball.
 */

import { drawing, run } from "../studio/store";
import type { Pen } from "./draw";
import { drawArrow, pixelsOf } from "./draw";
import type { Layer } from "./layers";
import { now } from "./moment";
import { arrowSeconds, LONGEST_ARROW, options } from "./options";

/** Pixels between a ball and the arrow round it. */
const GAP = 4;
/** An arrow round a ball goes no further than this, in radians, so that its ends can be told apart. */
const LONGEST = 5.2;
/** A shorter one is not seen. */
const SHORTEST = 0.3;

export const spin: Layer = (pen, { view, bodies, palette }) => {
  const state = now();
  if (!state || !options.value.spin || !run.value?.film.isOnCloth) return;
  const seconds = arrowSeconds.value;
  const longest = LONGEST_ARROW * (drawing.value?.table.size ?? 1);
  bodies.forEach(({ radius }, ball) => {
    const [x, y] = [state.x[ball] as number, state.y[ball] as number];
    if (Number.isNaN(x)) return;
    const reach = radius * seconds;
    const from = [view.x(x), view.y(y)] as const;
    const to = [
      view.x(x + (state.wy[ball] as number) * reach),
      view.y(y - (state.wx[ball] as number) * reach),
    ] as const;
    pen.save();
    pen.setLineDash([1, 4]);
    drawArrow(pen, from, to, palette.spin, 2.5);
    pen.restore();
    const angle = (LONGEST * reach * (state.wz[ball] as number)) / longest;
    drawTurn(pen, from, pixelsOf(radius, view) + GAP, angle, palette.spin);
  });
};

/** An arrow round a ball, counter-clockwise for a positive angle, with its middle at the top. */
function drawTurn(
  pen: Pen,
  [x, y]: readonly [number, number],
  radius: number,
  angle: number,
  colour: string,
) {
  if (Math.abs(angle) < SHORTEST) return;
  const half = Math.min(Math.abs(angle), LONGEST) / 2;
  const sense = angle > 0 ? -1 : 1;
  const end = -Math.PI / 2 + sense * half;
  pen.save();
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = 2;
  pen.beginPath();
  pen.arc(x, y, radius, -Math.PI / 2 - sense * half, end, sense < 0);
  pen.stroke();
  const [tipX, tipY] = [x + radius * Math.cos(end), y + radius * Math.sin(end)];
  const [alongX, alongY] = [-sense * Math.sin(end), sense * Math.cos(end)];
  pen.beginPath();
  pen.moveTo(tipX + 5 * alongX, tipY + 5 * alongY);
  pen.lineTo(tipX - alongX + 3.5 * alongY, tipY - alongY - 3.5 * alongX);
  pen.lineTo(tipX - alongX - 3.5 * alongY, tipY - alongY + 3.5 * alongX);
  pen.closePath();
  pen.fill();
  pen.restore();
}
