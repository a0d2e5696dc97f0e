/** Which column of one's own trajectory is what: its time, and x and y of the balls. */

import type { Lines, Misreading } from "./csv";

export interface Assignment {
  time: number;
  /** The columns of each ball that is there; a ball of −1 is one that has no name in the file. */
  balls: { ball: number; x: number; y: number }[];
  leftOut: string[];
}

/** A name without a unit behind it, in small letters. */
const plain = (name: string) =>
  name
    .replace(/\s*[[(/].*$/, "")
    .trim()
    .toLowerCase();

/** Finds the columns, or says what is missing. */
export function assign(lines: Lines, ids: string[]): Assignment | Misreading {
  return lines.hasHeader ? byName(lines.names, ids) : byPlace(lines.names.length, ids.length);
}

function byName(names: string[], ids: string[]): Assignment | Misreading {
  const plainNames = names.map(plain);
  const find = (wanted: string[]) =>
    wanted.map((name) => plainNames.indexOf(name)).find((at) => at >= 0) ?? -1;
  const columns = names.slice(0, 12).join(", ");
  const time = find(["time", "t", "zeit"]);
  if (time < 0) return { key: "ownNoTime", values: { columns } };
  const isFromZero = find(["x0", "x_0"]) >= 0;
  const place = (axis: "x" | "y", id: string, ball: number) => {
    const number = ball + (isFromZero ? 0 : 1);
    return find([...spellings(axis, id.toLowerCase()), ...spellings(axis, String(number))]);
  };
  const found = ids.map((id, ball) => ({ ball, x: place("x", id, ball), y: place("y", id, ball) }));
  const alone = { ball: ids.length === 1 ? 0 : -1, x: find(["x"]), y: find(["y"]) };
  const there = [...found, alone].filter(({ x, y }) => x >= 0 || y >= 0);
  const half = there.find(({ x, y }) => x < 0 || y < 0);
  if (half) return { key: "ownHalf", values: { column: names[Math.max(half.x, half.y)] as string } };
  if (there.length === 0) return { key: "ownNoBall", values: { columns, id: ids[0] ?? "" } };
  // x and y without a name beside those of named balls would be a second trajectory of one of them.
  const balls = there.length > 1 ? there.filter((each) => each !== alone) : there;
  const taken = new Set([time, ...balls.flatMap(({ x, y }) => [x, y])]);
  return { time, balls, leftOut: names.filter((_, column) => !taken.has(column)) };
}

const spellings = (axis: string, name: string) => [
  `${name}.${axis}`,
  `${name}_${axis}`,
  `${name} ${axis}`,
  `${axis}_${name}`,
  `${axis}.${name}`,
  `${axis} ${name}`,
  `${axis}${name}`,
];

/** Without a header: the time, then x and y of each ball in the order of the scenario. */
function byPlace(width: number, ballCount: number): Assignment | Misreading {
  const count = (width - 1) / 2;
  if (!Number.isInteger(count) || count < 1 || count > ballCount) {
    return { key: "ownNoHeader", values: { found: width } };
  }
  const isAlone = count === 1 && ballCount > 1;
  const balls = Array.from({ length: count }, (_, k) => ({
    ball: isAlone ? -1 : k,
    x: 2 * k + 1,
    y: 2 * k + 2,
  }));
  return { time: 0, balls, leftOut: [] };
}
