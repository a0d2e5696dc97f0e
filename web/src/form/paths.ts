/** Places in a scenario: the way through its keys and lists, and the paths that the engine writes for it. */

/** A key, the id of a member of a list, or a place in a list. */
export type Step = string | number;

const IS_WORD = /^[\p{Alphabetic}_][\p{Alphabetic}\p{N}_-]*$/u;

/** A path as the engine reads and writes it, such as `balls[0].velocity`. */
export function pathOf(steps: readonly Step[]): string {
  return steps
    .map((step, k) => {
      if (typeof step === "number") return `[${step}]`;
      return `${k > 0 ? "." : ""}${IS_WORD.test(step) ? step : `"${step}"`}`;
    })
    .join("");
}

/** What stands at a place; undefined is nothing. Members of a list are found by their ids, too. */
export function valueAt(whole: unknown, steps: readonly Step[]): unknown {
  return steps.reduce<unknown>((value, step) => {
    if (Array.isArray(value) && typeof step === "string") return value.find(({ id }) => id === step);
    return (value as Record<Step, unknown> | undefined)?.[step];
  }, whole);
}

/** The value with another one at a place inside it; undefined takes out what is there. */
export function withValue(whole: unknown, steps: readonly Step[], value: unknown): unknown {
  const [step, ...rest] = steps;
  if (step === undefined) return value;
  const inside = withValue((whole as Record<Step, unknown> | undefined)?.[step], rest, value);
  if (Array.isArray(whole)) return whole.with(Number(step), inside);
  const { [step]: _, ...others } = (whole ?? {}) as Record<Step, unknown>;
  return inside === undefined ? others : { ...(whole as object), [step]: inside };
}
