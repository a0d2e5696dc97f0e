/** What the page knows, and what can be done with it. Components read signals and call the functions below. */

import { batch, computed, effect, signal } from "@preact/signals";
import { Cancelled, Engine, EngineLost, Problems, TooManyBalls } from "../engine/client";
import { Film } from "../engine/film";
import type {
  Checked,
  CutBy,
  Drawing,
  EventColumns,
  Problem,
  Questions,
  RunData,
  Slot,
  Summary,
  Values,
  Vocabulary,
} from "../engine/protocol";
import { number, word } from "../words";
import type { Word } from "../words/en";
import { SCENARIOS } from "./scenarios";

/** The page keeps so many events of a run; a run of more is shown up to there, and the page says so. */
export const MOST_EVENTS = 1_000_000;

/** A run, or as much of it as there is yet. */
export interface Shown {
  summary: Summary;
  film: Film;
  events: EventColumns;
  cutBy: CutBy | null;
  /** Whether the run has ended. */
  isWhole: boolean;
}

/** A scenario with where it comes from: the name of a ready-made one, or null, and what the link said that it is from. */
export interface Open extends Checked {
  name: string | null;
  link?: Claim;
}

/** What a link says of the run where it was made. */
export interface Claim {
  /** The link's fragment. */
  fragment: string;
  /** The digest of the run; null where there was none. */
  digest: string | null;
  physicsVersion: number;
}

export const engine = new Engine();
export const vocabulary = signal<Vocabulary | null>(null);

/** The scenario on the table; null shows the gallery. */
export const scenario = signal<Open | null>(null);
export const drawing = computed<Drawing | null>(() => scenario.value?.drawing ?? null);
/** The scenario as an object, as it is written. */
export const written = computed<Record<string, unknown>>(() => JSON.parse(scenario.value?.json ?? "{}"));

/** The runs, by what they are for. */
export const runs = signal<Partial<Record<Slot, Shown>>>({});
export const run = computed<Shown | null>(() => runs.value.main ?? null);
export const endTime = computed(() => run.value?.summary.endTime ?? 0);

/** How far the run that is computed has come; null when none is. */
export const progress = signal<{ time: number; events: number } | null>(null);

/** What is wrong with what was asked last. */
export const problems = signal<Problem[]>([]);
/** A message to the user, or null. */
export const notice = signal<string | null>(null);

export const time = signal(0);
export const isPlaying = signal(false);
/** Table time for each second. */
export const speed = signal(1);
/** The ball that is chosen, by its place in the list; null is none. */
export const chosen = signal<number | null>(null);

/** Earlier scenarios, the last one first to come back to, and those that were taken back. */
const past = signal<Open[]>([]);
const future = signal<Open[]>([]);
export const canUndo = computed(() => past.value.length > 0);
export const canRedo = computed(() => future.value.length > 0);

/** Goes up whenever another scenario is opened, or the open one is closed. */
export const opened = signal(0);

/** What the page comes back to when the engine is lost: the scenario of the last run that came to its end. */
const GALLERY = { open: null as Open | null, past: [] as Open[], future: [] as Open[] };
let good = GALLERY;

/** The opening that was asked for last. */
let latestOpening = {};

/** Begins to open something; the answer says, also later, whether nothing else was opened or closed since. */
export function beginOpening(): () => boolean {
  // What is being typed belongs to the scenario that is there still.
  if (document.activeElement instanceof HTMLInputElement) document.activeElement.blur();
  latestOpening = {};
  return untilOpening();
}

/** Says, also later, whether nothing else was opened or closed since. */
export function untilOpening(): () => boolean {
  const self = latestOpening;
  return () => latestOpening === self;
}

/** How many changes are checked now. */
let checks = 0;

async function check(asked: Questions["check"]["asked"]): Promise<Checked> {
  checks++;
  try {
    return await engine.ask("check", asked);
  } finally {
    checks--;
  }
}

/** Waits until every change that was made is in the scenario, or refused. */
export async function changesAreIn() {
  while (checks > 0) await new Promise((resolve) => setTimeout(resolve));
}

/** Opens a ready-made scenario. */
export const openNamed = (name: string): Promise<boolean> => openText(SCENARIOS[name] ?? "", "toml", name);

/**
 * Opens a scenario unless something else is opened meanwhile; says whether it is one. The problems are told if not, and
 * what was there before stays.
 */
export async function openText(
  text: string,
  format: "toml" | "json",
  name: string | null = null,
  link?: Claim,
  isWanted = beginOpening(),
): Promise<boolean> {
  return settled(async () => {
    const checked = await engine.ask("check", { text, format });
    if (!isWanted()) return;
    past.value = future.value = [];
    await put({ ...checked, name, ...(link ? { link } : {}) }, true);
  });
}

/**
 * Puts values into the scenario; says whether that is one. The problems are told if not, and nothing changes. A change
 * that goes on with the one before is taken back together with it.
 */
export async function change(values: Values, goesOn = false): Promise<boolean> {
  const [before, isStill] = [scenario.peek(), untilOpening()];
  if (!before) return false;
  return settled(async () => {
    const checked = await check({ text: before.json, format: "json", values });
    if (!isStill()) return;
    if (!goesOn) past.value = [...past.peek(), before];
    future.value = [];
    await put({ ...checked, name: before.name }, false);
  });
}

/** Puts another scenario in the place of this one, as one step that can be taken back. */
export async function replace(json: string): Promise<boolean> {
  const [before, isStill] = [scenario.peek(), untilOpening()];
  return settled(async () => {
    const checked = await check({ text: json, format: "json" });
    if (!isStill()) return;
    if (before) past.value = [...past.peek(), before];
    future.value = [];
    await put({ ...checked, name: before?.name ?? null }, false);
  });
}

/** Asks what is wrong with values without putting them in; an empty list when nothing is. */
export async function wrongWith(values: Values): Promise<Problem[]> {
  try {
    await check({ text: scenario.peek()?.json ?? "{}", format: "json", values });
    return [];
  } catch (error) {
    if (error instanceof Problems) return error.problems;
    throw error;
  }
}

export const undo = () => swap(past, future);
export const redo = () => swap(future, past);

async function swap(from: typeof past, to: typeof past) {
  const [target, now] = [from.peek().at(-1), scenario.peek()];
  if (!target || !now) return;
  from.value = from.peek().slice(0, -1);
  to.value = [...to.peek(), now];
  await settled(() => put(target, false));
}

export function closeScenario() {
  beginOpening();
  for (const slot of latestRun.keys()) {
    latestRun.delete(slot);
    void engine.ask("cancel", { slot }).catch(() => {});
  }
  good = GALLERY;
  batch(() => {
    pause();
    scenario.value = null;
    runs.value = {};
    progress.value = null;
    problems.value = [];
    notice.value = null;
    opened.value++;
  });
}

async function put(open: Open, isNew: boolean) {
  batch(() => {
    scenario.value = open;
    problems.value = [];
    notice.value = null;
    isPlaying.value = false;
    runs.value = {};
    time.value = 0;
    if (isNew) {
      chosen.value = null;
      speed.value = 1;
      opened.value++;
    }
  });
  await compute("main", open.json);
}

/** The run of each slot that was asked for last: what comes in of an earlier one is too late. */
const latestRun = new Map<Slot, object>();

/** Computes a run and keeps it; parts of long ones are shown while they go on. */
export async function compute(slot: Slot, json: string, until?: string): Promise<Shown | null> {
  const isStepped = (JSON.parse(json) as { method?: { kind?: string } }).method?.kind === "stepped";
  const self = {};
  latestRun.set(slot, self);
  const isLatest = () => latestRun.get(slot) === self;
  const show = (data: RunData, isWhole: boolean): Shown | null => {
    if (!isLatest()) return null;
    const shown = { ...data, film: new Film(data.film, isStepped), isWhole };
    runs.value = { ...runs.peek(), [slot]: shown };
    return shown;
  };
  const asked = { slot, json, mostEvents: MOST_EVENTS, ...(until === undefined ? {} : { until }) };
  try {
    const data = await engine.ask("run", asked, {
      onPart: (part) => show(part, false),
      onProgress: (time, events) => {
        if (slot === "main" && isLatest()) progress.value = { time, events };
      },
    });
    const shown = show(data, true);
    if (slot === "main" && shown) {
      good = { open: scenario.peek(), past: past.peek(), future: future.peek() };
    }
    return shown;
  } catch (error) {
    if (error instanceof Cancelled) return null;
    throw error;
  } finally {
    if (slot === "main" && isLatest()) progress.value = null;
  }
}

/** Ends the run that is computed where it is, and keeps what there is of it. */
export const stopComputing = () => settled(() => engine.ask("stop", { slot: "main" }));

/** Does what may fail; tells what is wrong if it does, and whether it went well. */
export async function settled(action: () => Promise<unknown>): Promise<boolean> {
  try {
    await action();
    return true;
  } catch (error) {
    if (error instanceof Problems) problems.value = readable(error.problems);
    else if (error instanceof TooManyBalls) say("tooManyBalls", { count: number(error.count) });
    else if (!(error instanceof EngineLost)) throw error;
    return false;
  }
}

/** So many problems are told, with so many letters each: of a foreign file there may be any number of any length. */
const MOST_PROBLEMS = 20;
const LONGEST_PROBLEM = 400;

function readable(found: Problem[]): Problem[] {
  const short = (text: string) =>
    text.length > LONGEST_PROBLEM ? `${text.slice(0, LONGEST_PROBLEM)} …` : text;
  const told = found
    .slice(0, MOST_PROBLEMS)
    .map(({ place, message }) => ({ place: short(place), message: short(message) }));
  const left = found.length - told.length;
  return left > 0 ? [...told, { place: "…", message: word("moreProblems", { count: number(left) }) }] : told;
}

let isComingBack = false;

/** The engine's runs are lost with it: the last good scenario comes back, and is computed anew. */
engine.onLost = async (reason) => {
  beginOpening();
  progress.value = null;
  const { open, past: before, future: after } = good;
  if (open && !isComingBack) {
    isComingBack = true;
    batch(() => {
      pause();
      [scenario.value, past.value, future.value] = [open, before, after];
    });
    await compute("main", open.json).catch(() => {});
    isComingBack = false;
  } else if (scenario.peek()) {
    closeScenario();
  }
  const lost = word(reason === "stuck" ? "engineStuck" : "engineBroken");
  notice.value = scenario.peek() ? `${lost} ${word("stillThere")}` : lost;
};

export function forgetMessages() {
  problems.value = [];
  notice.value = null;
}

export function say(key: Word, values: Record<string, string | number> = {}) {
  notice.value = word(key, values);
}

// Time.

/** The last time that there is something to show of. */
const latest = () => endTime.peek();

export function seek(target: number) {
  time.value = Math.min(Math.max(target, 0), latest());
}

export function play() {
  if (time.peek() >= latest() && run.peek()?.isWhole) time.value = 0;
  isPlaying.value = true;
}

export function pause() {
  isPlaying.value = false;
}

export const toggle = () => (isPlaying.peek() ? pause() : play());

/** The place of the first event after a time, or at it and after. */
export function firstEventAfter(moment: number, isIncluded = false): number {
  const times = run.peek()?.events.time ?? new Float64Array();
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    const at = times[middle] as number;
    if (isIncluded ? at >= moment : at > moment) high = middle;
    else low = middle + 1;
  }
  return low;
}

export function nextEvent() {
  pause();
  const times = run.peek()?.events.time;
  seek(times?.[firstEventAfter(time.peek())] ?? latest());
}

export function previousEvent() {
  pause();
  const times = run.peek()?.events.time;
  seek(times?.[firstEventAfter(time.peek(), true) - 1] ?? 0);
}

// The clock of the film: it goes while the page plays, and waits where the run has not come so far yet.
effect(() => {
  if (!isPlaying.value) return;
  let before = performance.now();
  let frame = requestAnimationFrame(function tick(now: number) {
    // The first frame may have begun before it was asked for; time does not go back for that.
    const target = time.peek() + (Math.max(now - before, 0) / 1000) * speed.peek();
    before = now;
    seek(target);
    if (target >= latest() && (run.peek()?.isWhole ?? true)) pause();
    else if (isPlaying.peek()) frame = requestAnimationFrame(tick);
  });
  return () => cancelAnimationFrame(frame);
});

/** Loads the engine and what page and engine have in common. */
export async function begin() {
  await settled(async () => {
    vocabulary.value = await engine.ask("vocabulary", {});
  });
}
