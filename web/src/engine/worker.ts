/** The worker: it has the engine, and answers the page's questions. */

import init, {
  Computation,
  type Run,
  run_at_once,
  Scenario,
  schema,
  vocabulary,
} from "../../engine/carom_wasm.js";
import wasm from "../../engine/carom_wasm_bg.wasm?url";
import type { EventColumns, FilmData, Problem, Questions, Reply, Request, RunData, Slot } from "./protocol";

/** Milliseconds of computing between two looks at what else was asked. */
const SLICE = 12;

/** Steps of the engine between two looks at the clock; few, as a step of thousands of balls is long. */
const STEPS = 500;

/** A part of a run is shown after so many milliseconds, and then each time its events have doubled. */
const FIRST_PART = 60;

/** So many milliseconds a stepped run may take. */
const LONGEST_STEPPED = 4000;

const runs = new Map<Slot, Run>();
const cancelled = new Set<number>();
const underWay = new Map<Slot, number>();

const answers: { [Q in keyof Questions]: (asked: Questions[Q]["asked"], id: number) => unknown } = {
  vocabulary: () => JSON.parse(vocabulary()),
  schema: () => JSON.parse(schema()),
  check: ({ text, format, values }) => {
    const scenario = Scenario.parse(text, format);
    return described(values ? scenario.with_values(JSON.stringify(values)) : scenario);
  },
  expanded: ({ json }) => described(Scenario.parse(json, "json").expanded()),
  toml: ({ json }) => Scenario.parse(json, "json").to_toml(),
  run: ({ slot, json, until, mostEvents }, id) => computed(slot, json, until, mostEvents, id),
  cancel: ({ slot }) => {
    const id = underWay.get(slot);
    if (id !== undefined) cancelled.add(id);
    return null;
  },
  totals: ({ slot, times }) => kept(slot).totals(times),
  runJson: ({ slot }) => kept(slot).to_json(),
};

function described(scenario: Scenario) {
  return { json: scenario.to_json(), drawing: JSON.parse(scenario.drawing()) };
}

function kept(slot: Slot): Run {
  const run = runs.get(slot);
  if (!run) throw JSON.stringify({ problems: [{ place: "run", message: `there is no run "${slot}"` }] });
  return run;
}

/** Computes a run, a slice at a time; what was asked meanwhile is answered in between. */
async function computed(slot: Slot, json: string, until: string | undefined, mostEvents: number, id: number) {
  const earlier = underWay.get(slot);
  if (earlier !== undefined) cancelled.add(earlier);
  underWay.set(slot, id);
  const scenario = Scenario.parse(json, "json");
  const method = (JSON.parse(json) as { method?: { kind?: string } }).method?.kind ?? "exact";
  const { run, isCut } =
    method === "exact" ? await inSlices(scenario, until, mostEvents, id) : atOnce(scenario);
  if (underWay.get(slot) === id) underWay.delete(slot);
  runs.get(slot)?.free();
  runs.set(slot, run);
  return dataOf(run, isCut);
}

async function inSlices(scenario: Scenario, until: string | undefined, mostEvents: number, id: number) {
  const computation = new Computation(scenario, until);
  const began = performance.now();
  let [nextLook, shown, goesOn, isCut] = [began + SLICE, 0, true, false];
  while (goesOn && !isCut) {
    goesOn = computation.advance(STEPS);
    isCut = goesOn && computation.events() >= mostEvents;
    const now = performance.now();
    if (now < nextLook) continue;
    if (goesOn && now - began > FIRST_PART && computation.events() > 2 * shown) {
      shown = computation.events();
      const part = computation.run();
      send({ id, part: dataOf(part, false) });
      part.free();
    } else {
      send({ id, time: computation.time(), events: computation.events() });
    }
    await nextTurn();
    if (cancelled.delete(id)) {
      computation.free();
      throw new Cancelled();
    }
    nextLook = performance.now() + SLICE;
  }
  cancelled.delete(id);
  return { run: computation.finish(), isCut };
}

class Cancelled extends Error {}

function atOnce(scenario: Scenario) {
  const end = performance.now() + LONGEST_STEPPED;
  let isCut = false;
  const run = run_at_once(scenario, () => {
    isCut ||= performance.now() > end;
    return isCut;
  });
  return { run, isCut };
}

function dataOf(run: Run, isCut: boolean): RunData {
  return {
    summary: JSON.parse(run.summary()),
    film: run.film() as unknown as FilmData,
    events: run.events() as unknown as EventColumns,
    isCut,
  };
}

/** Lets the messages that have come be answered. */
const nextTurn = () =>
  new Promise<void>((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });

function send(reply: Reply) {
  const arrays: Transferable[] = [];
  const data = "part" in reply ? reply.part : "answer" in reply ? reply.answer : null;
  for (const part of [data, ...Object.values(data ?? {})]) {
    for (const value of [part, ...(part && typeof part === "object" ? Object.values(part) : [])]) {
      if (ArrayBuffer.isView(value) && value.byteLength > 0) arrays.push(value.buffer as ArrayBuffer);
    }
  }
  self.postMessage(reply, { transfer: [...new Set(arrays)] });
}

/** The problems that an exception tells of: those of the engine are JSON texts. */
function problemsOf(error: unknown): Problem[] {
  if (typeof error === "string") return (JSON.parse(error) as { problems: Problem[] }).problems;
  throw error;
}

const ready = init({ module_or_path: wasm });

self.onmessage = async ({ data: { id, question, asked } }: MessageEvent<Request>) => {
  await ready;
  try {
    const answer = await (answers[question] as (asked: unknown, id: number) => unknown)(asked, id);
    send({ id, answer });
  } catch (error) {
    if (error instanceof Cancelled) send({ id, problems: [] });
    else send({ id, problems: problemsOf(error) });
  }
};
