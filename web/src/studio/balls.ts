/** Changes of single balls. */

import { effect } from "@preact/signals";
import type { StartingBall, Values } from "../engine/protocol";
import { attempt, attemptFirst } from "../form/editing";
import { pathOf, type Step, valueAt } from "../form/paths";
import { freePlaces } from "../form/room";
import { chosen, drawing, written } from "./store";

type Keys = Record<string, unknown>;

/** The balls that are written one by one. */
export const writtenBalls = (): Keys[] => (written.value["balls"] ?? []) as Keys[];

/** The way to a ball in the scenario: a ball of the rack that is not written has no place in the list, but an id. */
export function stepsOf(ball: number): readonly Step[] {
  const id = drawing.value?.balls[ball]?.id ?? "";
  return ball < writtenBalls().length ? ["balls", ball] : ["balls", id];
}

/** Whether single balls can be changed: those of a gas cannot. */
export const canChange = () => !("gas" in written.value);

/** The values that put a ball at a place; a height above the cloth stays. */
export function moved(ball: number, [x, y]: readonly [number, number]): Values {
  const steps = [...stepsOf(ball), "position"];
  const [, , ...height] = (valueAt(written.peek(), steps) ?? []) as number[];
  return { [pathOf(steps)]: [x, y, ...height] };
}

/** The values that give a ball a velocity in place of what it had. */
export function withVelocity(ball: number, velocity: readonly (number | null)[] | null): Values {
  const steps = stepsOf(ball);
  return {
    [pathOf([...steps, "speed"])]: null,
    [pathOf([...steps, "direction_deg"])]: null,
    [pathOf([...steps, "velocity"])]: velocity,
  };
}

/** The values that give a ball a speed or a direction; where it has neither, it comes with the other one. */
export function withSpeed(ball: number, key: "speed" | "direction_deg", value: number): Values {
  const steps = stepsOf(ball);
  const has = (name: string) => valueAt(written.peek(), [...steps, name]) !== undefined;
  const other = key === "speed" ? "direction_deg" : "speed";
  const isComplete = has("speed") || has("velocity");
  return {
    [pathOf([...steps, key])]: value,
    ...(isComplete ? {} : { [pathOf([...steps, other])]: 0 }),
  };
}

/** Chooses the ball with an id. */
export function choose(id: string | undefined) {
  const at = drawing.peek()?.balls.findIndex((ball) => ball.id === id) ?? -1;
  chosen.value = at < 0 ? null : at;
}

let chosenId: string | undefined;
effect(() => {
  const ball = chosen.value ?? -1;
  chosenId = drawing.peek()?.balls[ball]?.id;
});
// The chosen ball stays chosen in a changed scenario, where it may have another place in the list.
effect(() => {
  const at = drawing.value?.balls.findIndex(({ id }) => id === chosenId) ?? -1;
  if (chosen.peek() !== null) chosen.value = at < 0 ? null : at;
});

/** The place under which the list of balls tells what is wrong with it. */
export const LIST = "balls";

/** Adds a ball where there is room. */
export async function addBall() {
  const drawn = drawing.peek();
  if (!drawn) return;
  const model = drawn.balls[chosen.peek() ?? 0] ?? drawn.balls[0];
  const radius = model?.radius ?? drawn.table.size / 40;
  const id = newId(drawn.balls);
  const defaults = (written.peek()["ball_defaults"] ?? {}) as Keys;
  const needsRadius =
    defaults["radius"] === undefined && !("preset" in ((written.peek()["table"] ?? {}) as Keys));
  const balls = (written.peek()["balls"] ?? []) as Keys[];
  const ball = { id, ...(needsRadius ? { radius } : {}) };
  const candidates = function* () {
    for (const position of freePlaces(drawn, radius)) yield { balls: [...balls, { ...ball, position }] };
  };
  if (await attemptFirst(LIST, "", candidates())) choose(id);
}

function newId(balls: StartingBall[]): string {
  const ids = new Set(balls.map(({ id }) => id));
  let number = balls.length + 1;
  while (ids.has(`ball${number}`)) number++;
  return `ball${number}`;
}

/** Takes a written ball away. */
export async function removeBall(ball: number) {
  const balls = writtenBalls().toSpliced(ball, 1);
  if (await attempt(LIST, "", { balls })) {
    const count = drawing.peek()?.balls.length ?? 0;
    chosen.value = count === 0 ? null : Math.min(ball, count - 1);
  }
}
