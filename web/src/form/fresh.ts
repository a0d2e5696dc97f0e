/** Values to begin with, where something is chosen that has parts of its own. */

import type { Outline, Point } from "../engine/protocol";
import { kindOf, plain, type Schema, variantOf, variantsOf } from "./schema";

/** What new values should suit. */
export interface Surroundings {
  root: Schema;
  outline: Outline;
  /** A place where there may be room. */
  place: Point;
  /** That of the largest ball. */
  diameter: number;
  /** For an id that is new. */
  count: number;
}

/** Where a number has no default: what is common, or what suits the size of the table. */
const STARTS: Record<string, (around: Surroundings) => unknown> = {
  width: ({ outline: { bounds } }) => bounds[2] - bounds[0],
  length: ({ outline: { bounds } }) => bounds[3] - bounds[1],
  radius: ({ outline }) => tidy(outline.size / 20, outline.size),
  center: ({ place }) => place,
  wall: ({ place: [x, y], outline: { size } }) => [
    [x, y],
    [tidy(x + size / 10, size), y],
  ],
  path: (around) => triangle(around),
  line: ({ place: [x, y], outline: { size } }) => [
    [x, y],
    [tidy(x + size / 10, size), y],
  ],
  pieces: ({ outline }) => outline.pieces.filter(({ part }) => part === "boundary").map(written),
  cushion_width: ({ diameter }) => tidy(diameter, diameter),
  from_deg: () => 0,
  to_deg: () => 90,
  normal: () => 0.9,
  factor: () => 0.8,
  friction: () => 0.2,
  acceleration: () => [0, -1],
  a: () => 0.01,
  b: () => 0.108,
  c: () => 1.088,
  by_speed: () => [0.9, 0, 0],
  up_to: () => 10,
  by_incidence: () => [0.2, 0],
  dt: () => 0.01,
  half_width: () => 0.2,
  polydispersity: () => 0.1,
  species: () => [
    { fraction: 0.5, diameter: 0.8 },
    { fraction: 0.5, diameter: 1.2 },
  ],
};

/** The mouths of a table with pockets, over the diameter of a ball: as on a pool table. */
const MOUTHS: Record<string, Record<string, number>> = {
  corner: { width: 2.03, depth: 0.8, radius: 1.09, jaw_radius: 0.37 },
  side: { width: 2.25, depth: 1.42, radius: 1.34, jaw_radius: 0.14 },
};
const FACINGS: Record<string, number> = { corner: 7, side: 14 };

/** A length rounded to what is clear on a table of a size. */
export function tidy(length: number, size: number): number {
  const digits = Math.max(0, 3 - Math.floor(Math.log10(size || 1)));
  return Number(length.toFixed(Math.min(digits, 12)));
}

/** A value of a schema; what an old one has that suits it is kept. */
export function fresh(given: Schema, old: unknown, key: string, around: Surroundings): unknown {
  const schema = plain(given, around.root);
  if (schema.const !== undefined) return schema.const;
  const start = () => STARTS[key]?.(around);
  switch (kindOf(schema, around.root)) {
    case "number":
      return typeof old === "number" ? old : (schema.default ?? start() ?? Math.max(schema.minimum ?? 1, 1));
    case "boolean":
      return old ?? schema.default ?? false;
    case "choice":
      return (
        variantsOf(schema).find(({ const: word }) => word === old)?.const ?? variantsOf(schema)[0]?.const
      );
    case "variants":
      return freshVariant(schema, old, key, around);
    case "object":
      return key in MOUTHS && typeof old !== "object" ? mouth(key, around) : keys(schema, old, around);
    case "row":
      return Array.isArray(old) ? old : (start() ?? new Array(schema.minItems ?? 2).fill(0));
    case "list":
      return Array.isArray(old) ? old : (start() ?? listOf(schema, around));
    case "map":
      return old ?? {};
    case "flags":
      return old ?? [];
    case "colour":
    case "text":
      return typeof old === "string" ? old : `${key}${around.count}`;
  }
}

function freshVariant(schema: Schema, old: unknown, key: string, around: Surroundings): unknown {
  const variant = variantsOf(schema)[Math.max(variantOf(schema, old, around.root), 0)];
  return variant && fresh(variant, old, key, around);
}

/** All keys that are needed, and of the others those that were there. */
function keys(schema: Schema, old: unknown, around: Surroundings) {
  const before = (old ?? {}) as Record<string, unknown>;
  const entries = Object.entries(schema.properties ?? {})
    .filter(([key]) => schema.required?.includes(key) || before[key] !== undefined)
    .map(([key, inside]) => [key, fresh(inside, before[key], key, around)]);
  return Object.fromEntries(entries);
}

function listOf({ minItems = 0, items = {} }: Schema, around: Surroundings): unknown[] {
  return Array.from({ length: minItems }, () => fresh(items, undefined, "", around));
}

function mouth(key: string, { diameter }: Surroundings) {
  const lengths = Object.entries(MOUTHS[key] ?? {}).map(([name, part]) => [
    name,
    tidy(part * diameter, diameter),
  ]);
  return { ...Object.fromEntries(lengths), angle_deg: FACINGS[key] };
}

/** Three lines, clockwise. */
function triangle({ place: [x, y], outline: { size } }: Surroundings) {
  const half = size / 20;
  const corners = [
    [x - half, y - half],
    [x, y + half],
    [x + half, y - half],
  ].map((corner) => corner.map((length) => tidy(length, size)));
  return corners.map((corner, k) => ({ line: [corner, corners[(k + 1) % 3]] }));
}

/** A piece of an outline as it is written in a scenario. */
function written(piece: Outline["pieces"][number]) {
  if (piece.kind === "line") return { id: piece.id, line: [piece.start, piece.end] };
  const { id, center, radius, from_deg, to_deg } = piece;
  return { id, arc: { center, radius, from_deg, to_deg } };
}
