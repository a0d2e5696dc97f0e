/** What is typed into forms: it becomes part of the scenario, or stays with the reason why it cannot. */

import { computed, effect, signal } from "@preact/signals";
import type { Problem, Values } from "../engine/protocol";
import {
  change,
  drawing,
  engine,
  scenario,
  settled,
  untilOpening,
  written,
  wrongWith,
} from "../studio/store";
import { pathOf, type Step, valueAt, withValue } from "./paths";
import type { Schema } from "./schema";

/** What was typed at a place and is no part of a scenario. */
interface Refusal {
  text: string;
  problems: Problem[];
}

/** The refusals by their places; they go when the scenario becomes another one. */
export const refusals = signal<Record<string, Refusal>>({});

/** Whether the fields are explained. */
export const explains = signal(false);

/** The schema of scenarios, when the engine has told it. */
export const schema = signal<Schema | null>(null);

/** The scenario with its preset written out: what applies where nothing is written. */
export const effective = signal<Record<string, unknown>>({});

const hasPreset = computed(() => valueAt(written.value, ["table", "preset"]) !== undefined);

effect(() => {
  const json = scenario.value?.json;
  refusals.value = {};
  effective.value = {};
  // Where there are no forms, nothing is asked.
  if (!json || !schema.value || !hasPreset.value) return;
  void engine.ask("expanded", { json }).then(
    ({ json: expanded }) => {
      if (scenario.peek()?.json === json) effective.value = JSON.parse(expanded);
    },
    // A lost engine is told of where something was changed.
    () => {},
  );
});

export async function loadSchema() {
  if (!schema.peek()) schema.value = (await engine.ask("schema", {})) as Schema;
}

/** The place of a value as problems name it: balls have numbers there. */
export function placeOf([first, second, ...rest]: readonly Step[]): string {
  if (first === "balls" && typeof second === "string") {
    return pathOf([first, drawing.value?.balls.findIndex(({ id }) => id === second) ?? -1, ...rest]);
  }
  return pathOf(second === undefined ? [first as Step] : [first as Step, second, ...rest]);
}

/** The problems of a scenario with some values, or null without an answer or where it is another one by then. */
export async function problemsWith(values: Values): Promise<Problem[] | null> {
  const isStill = untilOpening();
  let problems: Problem[] = [];
  const isAnswered = await settled(async () => {
    problems = await wrongWith(values);
  });
  return isAnswered && isStill() ? problems : null;
}

/** Puts values into the scenario, or keeps what was typed at a place with the problems. Says whether they are in. */
export async function attempt(place: string, text: string, values: Values): Promise<boolean> {
  const problems = await problemsWith(values);
  if (problems === null) return false;
  if (problems.length === 0) return change(values);
  refuse(place, text, problems);
  return false;
}

/** The same with the first of some values that makes a scenario; of those that do not, the last ones' problems are kept. */
export async function attemptFirst(
  place: string,
  text: string,
  candidates: Iterable<Values>,
): Promise<boolean> {
  let problems: Problem[] | null = [];
  for (const values of candidates) {
    problems = await problemsWith(values);
    if (problems === null) return false;
    if (problems.length === 0) return change(values);
  }
  refuse(place, text, problems);
  return false;
}

export function refuse(place: string, text: string, problems: Problem[]) {
  refusals.value = { ...refusals.peek(), [place]: { text, problems } };
}

/** Takes back what was typed and refused at a place. */
export function forget(place: string) {
  const { [place]: _, ...others } = refusals.peek();
  refusals.value = others;
}

/** Sets the value at a place; undefined takes it out. */
export function set(steps: readonly Step[], value: unknown, text = ""): Promise<boolean> {
  return attempt(placeOf(steps), text, valuesFor(steps, value));
}

/** The change that sets a value: a path cannot name a key with a quotation mark, so what is around it is set then. */
function valuesFor(steps: readonly Step[], value: unknown): Values {
  const quoted = steps.findIndex((step) => typeof step === "string" && step.includes('"'));
  if (quoted < 0) return { [pathOf(steps)]: value ?? null };
  const around = steps.slice(0, quoted);
  return { [pathOf(around)]: withValue(valueAt(written.peek(), around), steps.slice(quoted), value) };
}

/** Whether a place is another one or, for a field without parts of its own, inside it. */
const isAt = (named: string, place: string, isLeaf: boolean) =>
  named === place || (isLeaf && (named.startsWith(`${place}[`) || named.startsWith(`${place}.`)));

/** The problems to tell at a place: those of what was typed there, and those that name it. */
export function problemsAt(place: string, isLeaf: boolean): Problem[] {
  const problems = Object.entries(refusals.value).flatMap(([typedAt, { problems }]) =>
    isAt(typedAt, place, isLeaf)
      ? problems
      : problems.filter((problem) => isAt(problem.place, place, isLeaf)),
  );
  return problems.filter(
    ({ place, message }, k) =>
      problems.findIndex((other) => other.place === place && other.message === message) === k,
  );
}
