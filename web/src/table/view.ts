/** From the lengths of a table to the pixels of a canvas, at true scale. */

import type { Outline } from "../engine/protocol";

export interface View {
  /** Pixels for each length of the table. */
  scale: number;
  x: (x: number) => number;
  y: (y: number) => number;
  /** Back from pixels. */
  place: (px: number, py: number) => [number, number];
}

/** The view that shows a whole table with a margin in pixels around it; it is laid across where that is larger. */
export function fitted({ bounds }: Outline, width: number, height: number, margin: number): View {
  const [left, bottom, right, top] = bounds;
  const room = [Math.max(width - 2 * margin, 1), Math.max(height - 2 * margin, 1)] as const;
  const scale = Math.min(room[0] / (right - left || 1), room[1] / (top - bottom || 1));
  const [middleX, middleY] = [(left + right) / 2, (bottom + top) / 2];
  return {
    scale,
    x: (x) => width / 2 + (x - middleX) * scale,
    y: (y) => height / 2 - (y - middleY) * scale,
    place: (px, py) => [middleX + (px - width / 2) / scale, middleY - (py - height / 2) / scale],
  };
}

/** The width that a canvas of a height should have for a table, at least and at most some pixels. */
export function aspect({ bounds }: Outline): number {
  const [left, bottom, right, top] = bounds;
  return (right - left || 1) / (top - bottom || 1);
}
