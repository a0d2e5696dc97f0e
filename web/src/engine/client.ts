/** The page's side of the engine: questions as promises, with a watch over the worker. */

import type { Problem, Question, Questions, Reply, RunData } from "./protocol";
import { spawn } from "./spawn";

/** After so many milliseconds without a sign of life the worker is ended and started anew. */
const PATIENCE = 1100;

/** While the engine is loaded for the first time it may take longer. */
const PATIENCE_AT_FIRST = 20_000;

/** What the engine finds wrong with a scenario. */
export class Problems extends Error {
  constructor(readonly problems: Problem[]) {
    super(problems.map(({ place, message }) => `${place}: ${message}`).join("\n"));
  }
}

/** The engine gave no sign of life for too long, or broke down; it has been started anew, without its runs. */
export class EngineLost extends Error {
  constructor(readonly reason: "stuck" | "broken") {
    super(reason);
  }
}

/** The scenario has more balls than the page shows. */
export class TooManyBalls extends Error {
  constructor(readonly count: number) {
    super();
  }
}

/** The question was taken back: another run of the same slot was asked for. */
export class Cancelled extends Error {}

interface Pending {
  resolve: (answer: never) => void;
  reject: (error: Error) => void;
  onPart: ((part: RunData) => void) | undefined;
  onProgress: ((time: number, events: number) => void) | undefined;
}

interface Watch {
  onPart?: (part: RunData) => void;
  onProgress?: (time: number, events: number) => void;
}

/** An engine in a worker of its own. */
export class Engine {
  /** Called when the engine was lost and started anew. */
  onLost: (reason: EngineLost["reason"]) => void = () => {};
  #worker!: Worker;
  #pending = new Map<number, Pending>();
  #next = 1;
  #watchdog: ReturnType<typeof setTimeout> | undefined;
  #isAwake = false;

  constructor() {
    this.#start();
  }

  /** Asks a question. */
  ask<Q extends Question>(
    question: Q,
    asked: Questions[Q]["asked"],
    { onPart, onProgress }: Watch = {},
  ): Promise<Questions[Q]["answer"]> {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve, reject, onPart, onProgress });
      this.#worker.postMessage({ id, question, asked });
      if (this.#pending.size === 1) this.#watch();
    });
  }

  #start() {
    this.#isAwake = false;
    this.#worker = spawn();
    this.#worker.onmessage = ({ data }: MessageEvent<Reply>) => this.#hear(data);
    this.#worker.onerror = () => this.#restart("broken");
    this.#worker.addEventListener("messageerror", () => this.#restart("broken"));
  }

  #hear(reply: Reply) {
    this.#isAwake = true;
    if (!("isReady" in reply)) this.#answer(reply);
    this.#watch();
  }

  #answer(reply: Exclude<Reply, { isReady: true }>) {
    const pending = this.#pending.get(reply.id);
    if (!pending || "isAlive" in reply) return;
    if ("isBroken" in reply) this.#restart("broken");
    else if ("part" in reply) pending.onPart?.(reply.part);
    else if ("time" in reply) pending.onProgress?.(reply.time, reply.events);
    else {
      this.#pending.delete(reply.id);
      if ("answer" in reply) pending.resolve(reply.answer as never);
      else if ("tooManyBalls" in reply) pending.reject(new TooManyBalls(reply.tooManyBalls));
      else pending.reject(reply.problems.length > 0 ? new Problems(reply.problems) : new Cancelled());
    }
  }

  #watch() {
    clearTimeout(this.#watchdog);
    if (this.#pending.size === 0) return;
    const patience = this.#isAwake ? PATIENCE : PATIENCE_AT_FIRST;
    this.#watchdog = setTimeout(() => this.#restart("stuck"), patience);
  }

  #restart(reason: "stuck" | "broken") {
    this.#worker.terminate();
    clearTimeout(this.#watchdog);
    const lost = [...this.#pending.values()];
    this.#pending.clear();
    this.#start();
    for (const { reject } of lost) reject(new EngineLost(reason));
    this.onLost(reason);
  }
}
