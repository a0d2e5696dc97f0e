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
import type {
  CutBy,
  EventColumns,
  FilmData,
  Problem,
  Questions,
  Reply,
  Request,
  RunData,
  Slot,
} from "./protocol";

/** Milliseconds of computing between two looks at what else was asked. */
const SLICE = 12;

/** Steps of the engine between two looks at the clock; few, as a step of thousands of balls is long. */
const STEPS = 500;

/** A part of a run is shown after so many milliseconds, and then each time its events have doubled. */
const FIRST_PART = 60;

/** So many milliseconds a stepped run may take: nothing can be asked meanwhile, so it cannot be taken back either. */
const LONGEST_STEPPED = 1000;

/** So many bytes of memory a run may take beyond what the engine had; steps are copied slowly, so they get less. */
const MOST_MEMORY = 2 ** 29;
const MOST_MEMORY_STEPPED = 2 ** 26;

/** A page can draw so many balls. */
const MOST_BALLS = 50_000;

const runs = new Map<Slot, Run>();
const cancelled = new Set<number>();
const stopped = new Set<number>();
const underWay = new Map<Slot, number>();

const answers: { [Q in keyof Questions]: (asked: Questions[Q]["asked"], id: number) => unknown } = {
  vocabulary: () => JSON.parse(vocabulary()),
  schema: () => JSON.parse(schema()),
  check: ({ text, format, values }) => {
    const scenario = read(text, format);
    return described(values ? scenario.with_values(JSON.stringify(values)) : scenario);
  },
  expanded: ({ json }) => described(read(json, "json").expanded()),
  toml: ({ json }) => read(json, "json").to_toml(),
  run: ({ slot, json, until, mostEvents }, id) => computed(slot, json, until, mostEvents, id),
  cancel: ({ slot }) => {
    const id = underWay.get(slot);
    if (id !== undefined) cancelled.add(id);
    return null;
  },
  stop: ({ slot }) => {
    const id = underWay.get(slot);
    if (id !== undefined) stopped.add(id);
    return null;
  },
  totals: ({ slot, times }) => kept(slot).totals(times),
  obstructions: ({ json }) => JSON.parse(read(json, "json").obstructions()),
  finalScenario: ({ slot }) => kept(slot).final_scenario().to_json(),
  runJson: ({ slot }) => kept(slot).to_json(),
};

/** So many scenarios are kept as they were read. */
const KEPT = 3;

/** The scenarios that were asked about last, by their JSON texts: to read one of 10 000 balls takes most of a second. */
const scenarios = new Map<string, Scenario>();

function read(text: string, format: "toml" | "json"): Scenario {
  if (format === "toml") return Scenario.parse(text, format);
  const scenario = scenarios.get(text) ?? Scenario.parse(text, format);
  keep(text, scenario);
  return scenario;
}

function keep(text: string, scenario: Scenario) {
  scenarios.delete(text);
  scenarios.set(text, scenario);
  if (scenarios.size <= KEPT) return;
  const [oldest] = scenarios.keys();
  if (oldest !== undefined) scenarios.delete(oldest);
}

function described(scenario: Scenario) {
  const drawing = JSON.parse(scenario.drawing());
  if (drawing.balls.length > MOST_BALLS) throw new TooManyBalls(drawing.balls.length);
  const json = scenario.to_json();
  keep(json, scenario);
  return { json, drawing };
}

class TooManyBalls extends Error {
  constructor(readonly count: number) {
    super();
  }
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
  const scenario = read(json, "json");
  const method = (JSON.parse(json) as { method?: { kind?: string } }).method?.kind ?? "exact";
  const { run, cutBy } = await (method === "exact"
    ? inSlices(scenario, until, mostEvents, id)
    : atOnce(scenario)
  ).finally(() => {
    if (underWay.get(slot) === id) underWay.delete(slot);
  });
  runs.get(slot)?.free();
  runs.set(slot, run);
  return dataOf(run, cutBy, id);
}

async function inSlices(scenario: Scenario, until: string | undefined, mostEvents: number, id: number) {
  const computation = new Computation(scenario, until);
  const [began, memory] = [performance.now(), memoryTaken()];
  let [nextLook, shown, goesOn, cutBy] = [began + SLICE, 0, true, null as CutBy | null];
  while (goesOn && cutBy === null) {
    goesOn = computation.advance(STEPS);
    if (goesOn && computation.events() >= mostEvents) cutBy = "events";
    else if (goesOn && memoryTaken() - memory > MOST_MEMORY) cutBy = "memory";
    const now = performance.now();
    if (now < nextLook) continue;
    if (goesOn && now - began > FIRST_PART && computation.events() > 2 * shown) {
      shown = computation.events();
      const part = computation.run();
      send({ id, part: dataOf(part, null, id) });
      part.free();
    } else {
      send({ id, time: computation.time(), events: computation.events() });
    }
    await nextTurn();
    if (cancelled.delete(id)) {
      computation.free();
      throw new Cancelled();
    }
    if (stopped.delete(id) && goesOn) cutBy = "user";
    nextLook = performance.now() + SLICE;
  }
  cancelled.delete(id);
  return { run: computation.finish(), cutBy };
}

class Cancelled extends Error {}

async function atOnce(scenario: Scenario) {
  const [end, memory] = [performance.now() + LONGEST_STEPPED, memoryTaken()];
  let cutBy: CutBy | null = null;
  const run = run_at_once(scenario, () => {
    if (performance.now() > end) cutBy = "time";
    else if (memoryTaken() - memory > MOST_MEMORY_STEPPED) cutBy = "memory";
    return cutBy !== null;
  });
  return { run, cutBy: cutBy as CutBy | null };
}

/** To copy a long run takes a while too: so there are signs of life in between. */
function dataOf(run: Run, cutBy: CutBy | null, id: number): RunData {
  const part = <Part>(made: Part): Part => {
    send({ id, isAlive: true });
    return made;
  };
  return {
    summary: part(JSON.parse(run.summary())),
    film: part(run.film() as unknown as FilmData),
    events: part(run.events() as unknown as EventColumns),
    cutBy,
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

/** What an exception is to the page: those of the engine are JSON texts with problems, others mean that it is broken. */
function replyTo(id: number, error: unknown): Reply {
  if (error instanceof Cancelled) return { id, problems: [] };
  if (error instanceof TooManyBalls) return { id, tooManyBalls: error.count };
  if (typeof error === "string")
    return { id, problems: (JSON.parse(error) as { problems: Problem[] }).problems };
  return { id, isBroken: true };
}

const ready = init({ module_or_path: wasm });
let memory: WebAssembly.Memory;
void ready.then((exports) => {
  memory = exports.memory;
  send({ isReady: true });
});

/** Bytes of the engine's memory, which never shrinks. */
const memoryTaken = () => memory.buffer.byteLength;

self.onmessage = async ({ data: { id, question, asked } }: MessageEvent<Request>) => {
  try {
    await ready;
    const answer = (answers[question] as (asked: unknown, id: number) => unknown)(asked, id);
    // What is there at once is sent at once: the next question may keep the worker for good.
    send({ id, answer: answer instanceof Promise ? await answer : answer });
  } catch (error) {
    send(replyTo(id, error));
  }
};
