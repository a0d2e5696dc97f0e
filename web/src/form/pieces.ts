/** The pieces of a closed path: what is changed in one of them goes on in its neighbours, so that the path stays closed. */

import type { Values } from "../engine/protocol";
import { written } from "../studio/store";
import { pathOf, type Step, valueAt, withValue } from "./paths";

type Pair = [number, number];

/** A piece as it is written. */
export interface Piece {
  id?: string;
  line?: [Pair, Pair];
  arc?: { center: Pair; radius: number; from_deg: number; to_deg: number };
}

/** Where a piece begins and ends. */
function ends({ line, arc }: Piece): [Pair, Pair] {
  if (line) return line;
  if (!arc)
    return [
      [0, 0],
      [0, 0],
    ];
  const { center, radius, from_deg, to_deg } = arc;
  return [from_deg, to_deg].map((degrees): Pair => {
    const angle = (degrees * Math.PI) / 180;
    return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
  }) as [Pair, Pair];
}

/** The change that moves an end of a line, with the line that begins or ends there; null for other places. */
export function movedEnd(steps: readonly Step[], point: unknown): Values | null {
  const [at, key, end] = steps.slice(-3);
  const around = steps.slice(0, -3);
  const list = valueAt(written.peek(), around) as Piece[] | undefined;
  if (typeof at !== "number" || key !== "line" || typeof end !== "number" || !Array.isArray(list))
    return null;
  const neighbour = (at + (end === 0 ? list.length - 1 : 1)) % list.length;
  const [before, other] = [valueAt(list, [at, key, end]), valueAt(list, [neighbour, key, 1 - end])];
  if (String(before) !== String(other)) return null;
  const moved = withValue(list, [at, key, end], point);
  return { [pathOf(around)]: withValue(moved, [neighbour, key, 1 - end], point) };
}

/** The path with a line parted in its middle. */
export function split(list: Piece[], at: number): Piece[] {
  const { line, ...others } = list[at] ?? {};
  if (!line) return list;
  const middle: Pair = [(line[0][0] + line[1][0]) / 2, (line[0][1] + line[1][1]) / 2];
  return list.toSpliced(at, 1, { ...others, line: [line[0], middle] }, { line: [middle, line[1]] });
}

/** The path without a piece: a line beside it goes on to its other end. */
export function without(list: Piece[], at: number): Piece[] {
  const [start, end] = ends(list[at] ?? {});
  const [before, after] = [(at + list.length - 1) % list.length, (at + 1) % list.length];
  let joined = list;
  if (list[after]?.line) joined = withValue(list, [after, "line", 0], start) as Piece[];
  else if (list[before]?.line) joined = withValue(list, [before, "line", 1], end) as Piece[];
  return joined.toSpliced(at, 1);
}

/** A line as the half circle over it, which widens the table, and an arc as the line between its ends. */
export function turned(piece: Piece, into: string): Piece {
  const { line, arc, ...others } = piece;
  const [start, end] = ends(piece);
  if (into === "line") return { ...others, line: [start, end] };
  const center: Pair = [(start[0] + end[0]) / 2, (start[1] + end[1]) / 2];
  const [dx, dy] = [start[0] - center[0], start[1] - center[1]];
  const from_deg = (Math.atan2(dy, dx) * 180) / Math.PI;
  return { ...others, arc: { center, radius: Math.hypot(dx, dy), from_deg, to_deg: from_deg + 180 } };
}
