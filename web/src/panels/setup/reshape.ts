/** Another table below the balls: they, and the laws, are made to suit it where they do not. */

import type { Outline, Problem, Values } from "../../engine/protocol";
import { effective, problemsWith, refuse } from "../../form/editing";
import { tidy } from "../../form/fresh";
import { change, drawing, engine, notice, written } from "../../studio/store";
import { word } from "../../words";
import type { Word } from "../../words/en";

type Keys = Record<string, unknown>;

/** How much of the room of the new table the balls may need; the first that goes is taken. */
const SHRINKS = [1, 0.85, 0.7, 0.5];

interface Candidate {
  values: Values;
  /** What else is changed. */
  told: Word[];
}

/** Puts another table into the scenario; what was chosen stays with the reason where that cannot be. */
export async function reshape(table: unknown, text: string, place: string) {
  let first: Problem[] | null = null;
  for await (const { values, told } of candidates(sized(table as Keys))) {
    const problems = await problemsWith(values);
    if (problems === null) return;
    if (problems.length === 0) {
      if ((await change(values)) && told.length > 0) {
        notice.value = told.map((sentence) => word(sentence)).join(" ");
      }
      return;
    }
    first ??= problems;
  }
  refuse(place, text, first ?? []);
}

/** A new circle is as large as what was there. */
function sized(table: Keys): Keys {
  const bounds = drawing.peek()?.table.bounds;
  if (table["shape"] !== "circle" || !bounds) return table;
  const [left, bottom, right, top] = bounds;
  const radius = Math.max(right - left, top - bottom) / 2;
  return { ...table, radius: tidy(radius, radius) };
}

async function* candidates(table: Keys): AsyncGenerator<Candidate> {
  const isPreset = "preset" in table;
  const laws = isPreset ? withPresetLaws() : withOldLaws(table);
  const told: Word[] = isPreset && hasOwnLaws() ? ["presetLawsApply"] : [];
  yield { values: { table, ...laws }, told };
  const bounds = await boundsOf(table);
  if (!bounds) return;
  for (const shrink of SHRINKS) {
    yield {
      values: { table, ...laws, balls: fittedBalls(bounds, shrink, isPreset) },
      told: [...told, "ballsMoved"],
    };
  }
}

const hasOwnLaws = () => ["physics", "ball_defaults"].some((key) => key in written.peek());

/** A preset comes with its laws and balls. */
const withPresetLaws = (): Values => ({
  physics: null,
  ball_defaults: null,
  units: null,
  ...("cue" in written.peek() ? { cue: null } : {}),
});

/** What a preset gave stays when its table goes; pockets need a cloth. */
function withOldLaws({ shape }: Keys): Values {
  const { physics, ball_defaults, units, cue } = effective.peek() as Keys;
  const kept = Object.entries({ physics, ball_defaults, units, cue }).filter(
    ([, value]) => value !== undefined,
  );
  const values: Values = Object.fromEntries(kept);
  if (shape === "pocket_table" && !drawing.peek()?.isOnCloth) values["physics.flight"] = { law: "cloth" };
  return values;
}

/** The bounds of a table, which the engine tells with a point on it. */
async function boundsOf(table: Keys): Promise<Outline["bounds"] | null> {
  const drawn = drawing.peek();
  if (table["shape"] === "path" && drawn) return drawn.table.bounds;
  const around = table["shape"] === "circle" ? [0, 0] : [0.3, 0.3];
  const physics = table["shape"] === "pocket_table" ? { flight: { law: "cloth" } } : {};
  const ball = { id: "point", position: around, ...("preset" in table ? {} : { radius: 1e-9 }) };
  const text = JSON.stringify({ table: { ...table, obstacles: [] }, physics, balls: [ball], duration: 0 });
  try {
    return (await engine.ask("check", { text, format: "json" })).drawing.table.bounds;
  } catch {
    return null;
  }
}

/** The balls with their places carried over from the old table's bounds to the new one's. */
function fittedBalls(bounds: Outline["bounds"], shrink: number, isPreset: boolean): Keys[] {
  const drawn = drawing.peek();
  if (!drawn) return [];
  const [left, bottom, right, top] = drawn.table.bounds;
  const [newLeft, newBottom, newRight, newTop] = bounds;
  const size = newTop - newBottom;
  const carried = (part: number, from: number, to: number) =>
    tidy((from + to) / 2 + (part - 0.5) * shrink * (to - from), size);
  return ((written.peek()["balls"] ?? []) as Keys[]).map((ball) => {
    const [x, y, ...height] = (ball["position"] ?? []) as number[];
    const { radius, mass, ...others } = ball;
    const own = isPreset ? others : ball;
    if (x === undefined || y === undefined) return own;
    const place = [
      carried((x - left) / (right - left), newLeft, newRight),
      carried((y - bottom) / (top - bottom), newBottom, newTop),
    ];
    return { ...own, position: [...place, ...(isPreset ? [] : height)] };
  });
}
