/** Tables with open sides: what leaves on one side comes in on the other. */

import { computed } from "@preact/signals";
import type { Outline } from "../engine/protocol";
import { drawing } from "../studio/store";
import type { Pen } from "./draw";
import type { View } from "./view";

/** Where an axis begins and how long it is; null where it has walls. */
export interface Periods {
  x: [number, number] | null;
  y: [number, number] | null;
}

/** The open axes of a table: an open side lies across its axis. */
export function openAxes({ pieces, bounds: [left, bottom, right, top] }: Outline): Periods {
  const open = pieces.flatMap((piece) => (piece.part === "periodic" && piece.kind === "line" ? [piece] : []));
  return {
    x: open.some(({ start, end }) => start[0] === end[0]) ? [left, right - left] : null,
    y: open.some(({ start, end }) => start[1] === end[1]) ? [bottom, top - bottom] : null,
  };
}

export const periods = computed<Periods>(() => {
  const drawn = drawing.value;
  return drawn ? openAxes(drawn.table) : { x: null, y: null };
});

/** A coordinate brought into the table. */
export const wrapped = (place: number, [low, length]: [number, number]): number =>
  place - Math.floor((place - low) / length) * length;

/** A place brought into the table. */
export function onTable(x: number, y: number, open: Periods): [number, number] {
  return [open.x ? wrapped(x, open.x) : x, open.y ? wrapped(y, open.y) : y];
}

/** The shifts at which something that reaches from `low` to `high` shows in the table. */
export function shifts(low: number, high: number, period: [number, number] | null): number[] {
  if (!period) return [0];
  const [start, length] = period;
  const [first, last] = [Math.floor((low - start) / length), Math.floor((high - start) / length)];
  return Array.from({ length: last - first + 1 }, (_, k) => -(first + k) * length);
}

/** Keeps the pen inside a table with open sides. */
export function clipToTable(pen: Pen, { bounds: [left, bottom, right, top] }: Outline, view: View) {
  pen.beginPath();
  pen.rect(view.x(left), view.y(top), (right - left) * view.scale, (top - bottom) * view.scale);
  pen.clip();
}
