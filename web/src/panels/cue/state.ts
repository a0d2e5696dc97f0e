/** The stroke that is aimed, and what the engine says of it before it is made. */

import { computed, effect, signal } from "@preact/signals";
import { Problems } from "../../engine/client";
import type { Drawing, Obstruction, Problem } from "../../engine/protocol";
import {
  change,
  compute,
  drawing,
  engine,
  isPlaying,
  type Open,
  type Shown,
  scenario,
  settled,
  time,
  vocabulary,
  written,
} from "../../studio/store";
import { isAhead } from "../../table/options";
import { freshStroke, type Shot, type Stroke, shotOf, strokeOf } from "./stroke";

/** Milliseconds after which an aim that is left alone becomes part of the scenario. */
const QUIET = 250;

/** Whether the panel is open. */
export const isOpen = signal(false);

/** The stroke that is aimed and not yet part of the scenario; null is none. */
const aimed = signal<Stroke | null>(null);

const shot = computed<Shot | undefined>(() => written.value["shot"] as Shot | undefined);

/** The stroke as it stands: the one that is aimed, that of the scenario, or one to begin with. */
export const stroke = computed<Stroke | null>(() => {
  const drawn = drawing.value;
  if (!drawn?.isOnCloth) return null;
  return aimed.value ?? (shot.value ? strokeOf(shot.value) : freshStroke(drawn));
});

/** What comes of a stroke up to the first contact of two balls. */
export interface Prediction {
  stroke: Stroke;
  problems: Problem[];
  drawing: Drawing | null;
  shown: Shown | null;
  obstructions: Obstruction[];
}

export const prediction = signal<Prediction | null>(null);

/** Whether the table shows where the stroke would go. */
export const isAiming = computed(() => isOpen.value && time.value === 0 && !isPlaying.value);

effect(() => {
  isAhead.value = isAiming.value;
});

/** The first contact of the struck ball with another, as it is predicted. */
interface Contact {
  time: number;
  ball: number;
  other: number;
}

/** The cue, the shot, and where it leads; null where the engine takes no such stroke. */
export const forecast = computed(() => {
  const { drawing: drawn, shown } = prediction.value ?? {};
  const cue = drawn?.cue;
  if (!drawn || !shown || !cue?.shot) return null;
  const isMiscue = shown.summary.status === "miscue";
  return { drawn, shown, cue, shot: cue.shot, isMiscue, contact: firstContact(shown, cue.shot.ball) };
});

function firstContact({ events }: Shown, ball: number): Contact | null {
  const code = vocabulary.value?.kinds.indexOf("ball_ball");
  const k = events.kind.findIndex((kind, at) => {
    return kind === code && (events.ballA[at] === ball || events.ballB[at] === ball);
  });
  if (k < 0) return null;
  const [a, b] = [events.ballA[k] as number, events.ballB[k] as number];
  return { time: events.time[k] as number, ball, other: a === ball ? b : a };
}

let timer: ReturnType<typeof setTimeout> | undefined;

/** Aims otherwise. */
export function aim(changes: Partial<Stroke>) {
  const before = stroke.peek();
  if (!before) return;
  aimed.value = { ...before, ...changes };
  clearTimeout(timer);
  timer = setTimeout(commit, QUIET);
}

/** The scenario that was made by aiming: what is aimed next takes its place, so that taking back goes shot by shot. */
let aimedFrom: Open | null = null;

/** Makes the stroke as it stands part of the scenario, also where none has been aimed yet; says whether it is. */
export function settle(): Promise<boolean> {
  if (!shot.peek()) aim({});
  return commit();
}

/** Has what is aimed next take the place of the scenario as it is. */
export function begin() {
  aimedFrom = scenario.peek();
}

let isCommitting = false;
let committed: Promise<boolean> = Promise.resolve(true);

/** Makes the stroke that is aimed part of the scenario; says whether the scenario has the stroke now. */
export function commit(): Promise<boolean> {
  clearTimeout(timer);
  committed = committed.then(commitNow);
  return committed;
}

async function commitNow(): Promise<boolean> {
  const [wanted, open] = [aimed.peek(), scenario.peek()];
  if (!wanted || !open) return open !== null;
  const values = { shot: shotOf(wanted, shot.peek() ?? {}) };
  // What is refused is said beside the numbers, and stays there to be mended.
  if (!(await isTaken(open, values))) return false;
  if (scenario.peek() !== open) return false;
  isCommitting = true;
  const isIn = await change(values, open === aimedFrom);
  isCommitting = false;
  if (!isIn) return false;
  begin();
  if (aimed.peek() === wanted) aimed.value = null;
  return true;
}

async function isTaken(open: Open, values: { shot: Shot }): Promise<boolean> {
  try {
    await engine.ask("check", { text: open.json, format: "json", values });
    return true;
  } catch (error) {
    if (error instanceof Problems) return false;
    return settled(() => Promise.reject(error));
  }
}

// Another scenario has another stroke.
effect(() => {
  if (scenario.value && isCommitting) return;
  clearTimeout(timer);
  aimed.value = null;
});

effect(() => {
  if (!isOpen.value || !stroke.value) prediction.value = null;
  else void predict();
});

let isAsking = false;

/** Asks for the stroke as it stands until that has been answered: one question at a time, and the newest counts. */
async function predict() {
  if (isAsking) return;
  isAsking = true;
  let asked: Stroke | null = null;
  while (isOpen.peek() && stroke.peek() && asked !== stroke.peek()) {
    const wanted = stroke.peek() as Stroke;
    asked = wanted;
    await settled(async () => {
      const found = await predicted(wanted);
      if (isOpen.peek() && stroke.peek()) prediction.value = found;
    });
  }
  isAsking = false;
}

async function predicted(wanted: Stroke): Promise<Prediction> {
  const values = { shot: shotOf(wanted, shot.peek() ?? {}) };
  try {
    const text = scenario.peek()?.json ?? "{}";
    const { json, drawing } = await engine.ask("check", { text, format: "json", values });
    const obstructions = await engine.ask("obstructions", { json });
    const shown = await compute("aim", json, "ball_ball");
    return { stroke: wanted, problems: [], drawing, shown, obstructions };
  } catch (error) {
    if (!(error instanceof Problems)) throw error;
    return { stroke: wanted, problems: error.problems, drawing: null, shown: null, obstructions: [] };
  }
}
