/** From shot to shot: shoot, go on from where the balls lie, take a shot back. */

import { computed, effect, signal } from "@preact/signals";
import { Problems } from "../../engine/client";
import {
  canRedo,
  canUndo,
  drawing,
  endTime,
  engine,
  pause,
  play,
  replace,
  run,
  say,
  seek,
  settled,
  speed,
  time,
  undo,
  written,
} from "../../studio/store";
import { ballColours } from "../../table/colours";
import { begin, settle, stroke } from "./state";
import { freshStroke, type Shot, shotOf } from "./stroke";

/** Whether the shot on the table has been played to its end. */
export const isOver = computed(
  () => (run.value?.isWhole ?? false) && time.value > 0 && time.value >= endTime.value,
);

/** Whether there is a shot that can be taken back: this one if it has begun, or else the one before. */
export const canTakeBack = computed(() => time.value > 0 || canUndo.value);

/** Plays the shot from its beginning, as fast as life. */
export async function shoot() {
  if (!(await settle())) return;
  if (run.peek()?.summary.status === "miscue") return say("cueMiscued");
  seek(0);
  speed.value = 1;
  play();
}

/** Goes back to before this shot, or where it has not begun to before the one that led here. */
export async function takeBack() {
  if (time.peek() === 0) return undo();
  pause();
  seek(0);
}

/** A scenario as far as it is looked at here. */
interface Written {
  balls: { id: string; position?: number[]; velocity?: number[] }[];
  shot?: Shot;
}

/** Puts the scenario on the table that goes on from where the balls lie at the end of the shot. */
export async function nextShot() {
  const [drawn, before] = [drawing.peek(), stroke.peek()];
  if (!drawn || !before || !run.peek()?.isWhole) return;
  const isLeft = drawn.balls.some((_, ball) => !run.peek()?.film.isOut(ball, endTime.peek()));
  if (!isLeft) return say("cueNothingLeft");
  await settled(async () => {
    const next = JSON.parse(await engine.ask("finalScenario", { slot: "main" })) as Written;
    if (next.balls.some(({ velocity }) => velocity?.some((part) => part !== 0))) return say("cueStillRolls");
    const isBack = !next.balls.some(({ id }) => id === before.ball) && (await putBack(next, before.ball));
    const { drawing: there } = await engine.ask("check", { text: JSON.stringify(next), format: "json" });
    const fresh = freshStroke(there, before.ball);
    // After a break the next shot is not as hard.
    const speed = Math.min(before.speed, fresh.speed);
    const like = (written.peek()["shot"] ?? {}) as Shot;
    next.shot = shotOf({ ...fresh, speed }, like);
    if (!(await replace(JSON.stringify(next)))) return;
    begin();
    if (isBack) say("cueBallBack", { id: before.ball });
  });
}

/** So many rows and columns of places are tried for a ball that comes back. */
const PLACES = 12;

/** Puts a ball back where it was before the shot, or as near as it can lie; says whether it found a place. */
async function putBack(next: Written, id: string): Promise<boolean> {
  const { json } = await engine.ask("expanded", { json: JSON.stringify(written.peek()) });
  const ball = (JSON.parse(json) as Written).balls.find((other) => other.id === id);
  if (!ball) return false;
  const others = next.balls;
  for (const position of placesFrom(ball.position ?? [0, 0])) {
    next.balls = [{ ...ball, position }, ...others];
    if (await isSound(next)) return true;
  }
  next.balls = others;
  return false;
}

/** A place, and then those of a grid over the table, the nearest first. */
function placesFrom([x = 0, y = 0]: number[]): number[][] {
  const [left, bottom, right, top] = drawing.peek()?.table.bounds ?? [0, 0, 1, 1];
  const along = Array.from({ length: PLACES }, (_, k) => (k + 0.5) / PLACES);
  const grid = along.flatMap((u) =>
    along.map((v) => [left + u * (right - left), bottom + v * (top - bottom)]),
  );
  const far = ([px = 0, py = 0]: number[]) => Math.hypot(px - x, py - y);
  return [[x, y], ...grid.sort((a, b) => far(a) - far(b))];
}

async function isSound(values: Written): Promise<boolean> {
  try {
    await engine.ask("check", { text: JSON.stringify(values), format: "json" });
    return true;
  } catch (error) {
    if (error instanceof Problems) return false;
    throw error;
  }
}

/** Every ball that has been on the table since it was opened, with its colour. */
const seen = signal<ReadonlyMap<string, string>>(new Map());

effect(() => {
  const balls = drawing.value?.balls ?? [];
  const colours = ballColours(balls);
  const isNew = !canUndo.value && !canRedo.value;
  const known = isNew ? [] : [...seen.peek()];
  seen.value = new Map([...balls.map(({ id }, ball) => [id, colours[ball] as string] as const), ...known]);
});

/** The balls that are no more on the table now, with their colours. */
export const gone = computed<[string, string][]>(() => {
  const [balls, film] = [drawing.value?.balls ?? [], run.value?.film];
  const isThere = (id: string) => {
    const ball = balls.findIndex((other) => other.id === id);
    return ball >= 0 && !film?.isOut(ball, time.value);
  };
  return [...seen.value].filter(([id]) => !isThere(id));
});
