/** The lesson that is open, and how far it has come. */

import { batch, computed, effect, signal } from "@preact/signals";
import { Film } from "../engine/film";
import type { Checked, Drawing, Values } from "../engine/protocol";
import { SCENARIOS } from "../studio/scenarios";
import {
  beginOpening,
  closeScenario,
  drawing,
  engine,
  isPlaying,
  MOST_EVENTS,
  openText,
  pause,
  run,
  type Shown,
  scenario,
  seek,
  settled,
  speed,
  time,
} from "../studio/store";
import { type Instant, instants, justBefore } from "./instants";
import type { Course, Lesson, Outcome, Part } from "./types";

export const lesson = signal<Lesson | null>(null);
/** The part that is open; after the last one comes the summary. */
export const place = signal(0);
export const part = computed<Part | null>(() => lesson.value?.parts[place.value] ?? null);

/** The predictions, and what the runs gave where it has been seen, part by part. */
export const predictions = signal<(number | null)[]>([]);
export const results = signal<(number | null)[]>([]);
export const prediction = computed(() => predictions.value[place.value] ?? null);
export const result = computed(() => results.value[place.value] ?? null);

/** Whether a prediction is wanted before the table may move. */
export const isLocked = computed(() => part.value !== null && prediction.value === null);

/** The direction that is being drawn, in degrees. */
export const drawn = signal<number | null>(null);

/** The run that is drawn over the first. */
export const other = signal<Shown | null>(null);
/** What the run of this part gives. */
const outcome = signal<Outcome | null>(null);

/** Energy and momentum of all balls before and after each collision; see `totals` of the engine. */
export const totals = signal<Float64Array>(new Float64Array());
export const TOTALS_WIDTH = 4;

/** The collisions of this part that are explained. */
export const collisions = computed<Instant[]>(() =>
  run.value && part.value ? instants(run.value.events, part.value.watched) : [],
);
/** The collisions up to now. */
export const past = computed(() => collisions.value.filter((instant) => instant.time <= time.value));

/** The id of a ball. */
export const idOf = (ball: number) => drawing.value?.balls[ball]?.id ?? "";

/** Whether it pauses at collisions. */
export const isPausing = signal(true);

export function openLesson(chosen: Lesson) {
  batch(() => {
    lesson.value = chosen;
    predictions.value = [];
    results.value = [];
    isPausing.value = true;
  });
  return openPart(0);
}

/** Whether nothing was opened since this part was. */
let isMine = () => false;

export async function openPart(next: number) {
  batch(() => {
    pause();
    place.value = next;
    other.value = null;
    outcome.value = null;
    drawn.value = null;
    totals.value = new Float64Array();
  });
  const opened = part.peek();
  if (!opened) return;
  const isWanted = beginOpening();
  isMine = isWanted;
  const isOpen = await settled(async () => {
    await openText(await textOf(opened), "json", null, undefined, isWanted);
    if (!isWanted()) return;
    speed.value = opened.speed;
    await compute(opened);
  });
  if (!isOpen && isWanted()) closeLesson();
}

/** The table of a part as it is at the start. */
export const drawingOf = async (part: Part): Promise<Drawing> => (await checkedOf(part)).drawing;

async function checkedOf({ scenario: name, values = {} }: Part): Promise<Checked> {
  const asked = { text: SCENARIOS[name] ?? "", format: "toml", values } as const;
  return engine.ask("check", asked);
}

const textOf = async (part: Part): Promise<string> => (await checkedOf(part)).json;

/** The runs of a part beside the one on the table, and the answer to its question. */
async function compute(opened: Part) {
  const [main, shown] = [run.peek(), drawing.peek()];
  if (!main || !shown || part.peek() !== opened) return;
  const runOf = (values: Values) => computeOther(opened, values);
  const second = opened.other ? await runOf(opened.other.values) : null;
  const course: Course = { drawing: shown, main, other: second, runOf };
  const found = await opened.question.answer(course);
  const times = collisions.peek().flatMap((instant) => [justBefore(instant.time), instant.time]);
  const sums = await engine.ask("totals", { slot: "main", times: Float64Array.from(times) });
  if (part.peek() !== opened) return;
  batch(() => {
    other.value = second;
    outcome.value = found;
    totals.value = sums;
  });
}

async function computeOther(opened: Part, values: Values): Promise<Shown> {
  const text = await textOf({ ...opened, values: { ...opened.values, ...values } });
  const data = await engine.ask("run", { slot: "lesson", json: text, mostEvents: MOST_EVENTS });
  return { ...data, film: new Film(data.film), isWhole: true };
}

export function closeLesson() {
  lesson.value = null;
  closeScenario();
}

/** Sets the prediction of this part, which unlocks the table. */
export function predict(value: number) {
  predictions.value = withValue(predictions.peek(), value);
}

/** Goes to where the answer can be seen. */
export function skipToAnswer() {
  pause();
  seek(outcome.peek()?.time ?? 0);
}

function withValue(list: (number | null)[], value: number): (number | null)[] {
  const longer = [...list];
  longer[place.peek()] = value;
  return longer;
}

// What a run gives is shown from the moment on at which it can be seen.
effect(() => {
  const found = outcome.value;
  if (!found || isLocked.value || time.value < found.time || result.peek() !== null) return;
  results.value = withValue(results.peek(), found.value);
});

// While it plays it stops at each collision that is to be explained.
let before = 0;
effect(() => {
  const now = time.value;
  const stops = isPausing.value ? collisions.peek().slice(0, part.peek()?.pauses) : [];
  const stop = isPlaying.peek() ? stops.find(({ time }) => time > before && time <= now) : undefined;
  before = stop?.time ?? now;
  if (!stop || !lesson.peek()) return;
  pause();
  seek(stop.time);
});

// Another scenario on the table ends the lesson, and its second run goes with it.
effect(() => {
  if (scenario.value && lesson.peek() && !isMine()) lesson.value = null;
});
effect(() => {
  if (!lesson.value) other.value = null;
});
