/** What is laid over the run: the same scenario in steps, or with one number nudged. */

import { computed, effect, signal } from "@preact/signals";
import { Problems } from "../../engine/client";
import type { Problem, Slot, Values } from "../../engine/protocol";
import { compute, drawing, engine, opened, run, runs, scenario, settled, written } from "../../studio/store";
import { difference } from "./difference";
import { numbersIn } from "./numbers";

export type Overlay = "none" | "stepped" | "twin";

export const overlay = signal<Overlay>("none");
/** The power of ten of the time step. */
export const stepPower = signal(-1.5);
export const step = computed(() => 10 ** stepPower.value);
/** The number that is nudged, by its path. */
export const nudged = signal("");
/** The power of ten of the nudge. */
export const nudgePower = signal(-6);
/** What is wrong with the scenario that would be laid over. */
export const refusals = signal<Problem[]>([]);

/** The numbers that can be nudged. */
export const numbers = computed(() => numbersIn(written.value));

/** Whether the run on the table is the one in steps, so that the exact one is laid over it. */
export const isStepped = computed(() => methodOf(written.value) === "stepped");

const slot = computed<Slot | null>(() => (overlay.value === "none" ? null : overlay.value));
export const other = computed(() => (slot.value ? (runs.value[slot.value] ?? null) : null));

/** Balls have parted that are further from their other selves than a tenth of the smallest radius. */
const APART = 0.1;
export const apart = computed(() => {
  const radii = (drawing.value?.balls ?? []).map(({ radius }) => radius).filter((radius) => radius > 0);
  return radii.length > 0 ? APART * Math.min(...radii) : 1e-3 * (drawing.value?.table.size ?? 1);
});

export const compared = computed(() => {
  const [one, two] = [run.value, other.value];
  return one?.isWhole && two ? difference(one, two, apart.value) : null;
});

function methodOf(values: Record<string, unknown>): string {
  return (values["method"] as { kind?: string } | undefined)?.kind ?? "exact";
}

/** What the scenario that is laid over has otherwise. */
function changes(): Values | null {
  if (overlay.value === "stepped") {
    return { method: isStepped.value ? { kind: "exact" } : { kind: "stepped", dt: step.value } };
  }
  const found = numbers.value.find(([path]) => path === nudged.value);
  if (overlay.value !== "twin" || !found) return null;
  return { [found[0]]: found[1] + 10 ** nudgePower.value };
}

// The overlay follows the scenario and what is said of it here.
effect(() => {
  const [open, values, into] = [scenario.value, changes(), slot.value];
  refusals.value = [];
  if (open && values && into) void lay(open.json, values, into);
});

// A number that the scenario does not have cannot be nudged.
effect(() => {
  const paths = numbers.value.map(([path]) => path);
  if (!paths.includes(nudged.value)) {
    nudged.value = paths.find((path) => /direction|velocity|phi/.test(path)) ?? paths[0] ?? "";
  }
});

async function lay(json: string, values: Values, into: Slot) {
  await settled(async () => {
    try {
      const checked = await engine.ask("check", { text: json, format: "json", values });
      await compute(into, checked.json);
    } catch (error) {
      if (!(error instanceof Problems)) throw error;
      refusals.value = error.problems;
      runs.value = { ...runs.peek(), [into]: undefined };
    }
  });
}

// Another scenario begins with nothing laid over it.
effect(() => {
  if (opened.value > 0) overlay.value = "none";
});
