/** Draws a table and its balls with the operations of a canvas, which a picture in SVG has as well. */

import type { Moment } from "../engine/film";
import type { Outline, Piece } from "../engine/protocol";
import type { Palette } from "./colours";
import type { View } from "./view";

/** What of a canvas's context is used; svgcanvas has it too. */
export type Pen = CanvasRenderingContext2D;

/** From so many balls on they are drawn without edges, in one stroke for each colour. */
const MANY = 400;

/** A ball as it is drawn. */
export interface Body {
  radius: number;
  colour: string;
}

/** The ground: cloth, cushions and pockets. */
export function drawTable(pen: Pen, outline: Outline, view: View, palette: Palette) {
  pen.save();
  drawCloth(pen, outline, view, palette);
  for (const { center, radius } of outline.pockets) {
    disc(pen, view, center[0], center[1], radius * view.scale);
    pen.fillStyle = palette.pocket;
    pen.fill();
  }
  pen.lineCap = "round";
  pen.lineJoin = "round";
  for (const part of ["periodic", "boundary", "obstacle"] as const) {
    pen.beginPath();
    for (const piece of outline.pieces) if (piece.part === part) follow(pen, view, piece, true);
    pen.lineWidth = part === "periodic" ? 1.5 : 2.5;
    pen.strokeStyle = part === "periodic" ? palette.open : palette.nose;
    pen.setLineDash(part === "periodic" ? [6, 5] : []);
    pen.stroke();
  }
  pen.restore();
}

function drawCloth(pen: Pen, outline: Outline, view: View, palette: Palette) {
  const boundary = outline.pieces.filter(({ part }) => part !== "obstacle");
  pen.beginPath();
  boundary.forEach((piece, k) => {
    follow(pen, view, piece, k === 0);
  });
  pen.closePath();
  pen.fillStyle = palette.cloth;
  pen.fill();
  // What is inside a closed obstacle is no room for balls.
  pen.beginPath();
  let end: readonly [number, number] | null = null;
  for (const piece of outline.pieces.filter(({ part }) => part === "obstacle")) {
    const [from, to] = ends(piece);
    follow(
      pen,
      view,
      piece,
      end === null || Math.hypot(from[0] - end[0], from[1] - end[1]) > 1e-6 * outline.size,
    );
    end = to;
  }
  pen.fillStyle = palette.cushion;
  pen.fill("evenodd");
}

/** Goes along a piece; `isNew` lifts the pen before. */
function follow(pen: Pen, view: View, piece: Piece, isNew: boolean) {
  const [[x, y], [endX, endY]] = ends(piece);
  if (isNew) pen.moveTo(view.x(x), view.y(y));
  if (piece.kind === "line") {
    pen.lineTo(view.x(endX), view.y(endY));
    return;
  }
  const [from, to] = [piece.from_deg, piece.to_deg].map((degrees) => (-degrees * Math.PI) / 180) as [
    number,
    number,
  ];
  pen.arc(view.x(piece.center[0]), view.y(piece.center[1]), piece.radius * view.scale, from, to, to < from);
}

function ends(piece: Piece): [readonly [number, number], readonly [number, number]] {
  if (piece.kind === "line") return [piece.start, piece.end];
  const { center, radius } = piece;
  const at = (degrees: number) => {
    const angle = (degrees * Math.PI) / 180;
    return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)] as const;
  };
  return [at(piece.from_deg), at(piece.to_deg)];
}

function disc(pen: Pen, view: View, x: number, y: number, pixels: number) {
  pen.beginPath();
  pen.arc(view.x(x), view.y(y), pixels, 0, 2 * Math.PI);
}

/** The pixels of a ball's radius; a point is drawn too. */
export const pixelsOf = (radius: number, view: View) => Math.max(radius * view.scale, 2.5);

/** Draws balls; some of many are drawn as those are, where it is said that there are so many. */
export function drawBalls(
  pen: Pen,
  bodies: Body[],
  { x, y }: Pick<Moment, "x" | "y">,
  view: View,
  palette: Palette,
  count = bodies.length,
) {
  pen.save();
  if (count >= MANY) drawMany(pen, bodies, x, y, view);
  else {
    pen.lineWidth = 1;
    pen.strokeStyle = palette.edge;
    bodies.forEach(({ radius, colour }, ball) => {
      if (Number.isNaN(x[ball])) return;
      disc(pen, view, x[ball] as number, y[ball] as number, pixelsOf(radius, view));
      pen.fillStyle = colour;
      pen.fill();
      pen.stroke();
    });
  }
  pen.restore();
}

/** A path for each colour: thousands of fills cost more than one of thousands of discs. */
function drawMany(pen: Pen, bodies: Body[], x: Float64Array, y: Float64Array, view: View) {
  const balls = new Map<string, number[]>();
  bodies.forEach(({ colour }, ball) => {
    const same = balls.get(colour);
    if (same) same.push(ball);
    else balls.set(colour, [ball]);
  });
  for (const [colour, same] of balls) {
    pen.beginPath();
    for (const ball of same) {
      if (Number.isNaN(x[ball])) continue;
      const [px, py] = [view.x(x[ball] as number), view.y(y[ball] as number)];
      const pixels = Math.max((bodies[ball] as Body).radius * view.scale, 0.75);
      pen.moveTo(px + pixels, py);
      pen.arc(px, py, pixels, 0, 2 * Math.PI);
    }
    pen.fillStyle = colour;
    pen.fill();
  }
}

/** An arrow from one pixel to another. */
export function drawArrow(
  pen: Pen,
  from: readonly [number, number],
  to: readonly [number, number],
  colour: string,
  width = 2,
) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 3) return;
  const [ux, uy, head] = [dx / length, dy / length, Math.min(4 * width, length * 0.6)];
  pen.save();
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = width;
  pen.lineCap = "round";
  pen.beginPath();
  pen.moveTo(from[0], from[1]);
  pen.lineTo(to[0] - ux * head * 0.8, to[1] - uy * head * 0.8);
  pen.stroke();
  pen.beginPath();
  pen.moveTo(to[0], to[1]);
  pen.lineTo(to[0] - ux * head - uy * head * 0.5, to[1] - uy * head + ux * head * 0.5);
  pen.lineTo(to[0] - ux * head + uy * head * 0.5, to[1] - uy * head - ux * head * 0.5);
  pen.closePath();
  pen.fill();
  pen.restore();
}
