/** Puts a recorded run on the table, as `python/carom/studio/player.py` writes it into the page. */

import { batch } from "@preact/signals";
import { Film } from "../engine/film";
import type { Drawing, EventColumns, Summary } from "../engine/protocol";
import { runs, scenario, speed, vocabulary } from "../studio/store";

/** A run as it is written; arrays are base64 texts of their little-endian bytes. */
interface Written {
  version: string;
  physicsVersion: number;
  kinds: string[];
  motions: string[];
  scenario: string;
  drawing: Drawing;
  summary: Summary;
  film: { width: number; firstRows: string; numbers: string };
  events: Record<"quantities" | "codes", Record<string, string>>;
  cushionIds: string[];
  pocketIds: string[];
}

/** A run lasts so many seconds at least and at most; one that does not by itself is played slower or faster. */
const [SHORTEST, USUAL, LONGEST] = [2, 10, 60];

export function putOnTable(text: string) {
  const written = JSON.parse(text) as Written;
  const { version, physicsVersion, kinds, motions, drawing, summary } = written;
  batch(() => {
    vocabulary.value = { version, physics_version: physicsVersion, kinds, motions, presets: [] };
    scenario.value = { json: written.scenario, drawing, name: null };
    runs.value = {
      main: {
        summary,
        film: filmOf(written.film),
        events: eventsOf(written),
        cutBy: null,
        isWhole: true,
      },
    };
    speed.value = speedOf(summary.endTime);
  });
}

function speedOf(end: number): number {
  return end === 0 || (end >= SHORTEST && end <= LONGEST) ? 1 : Number((end / USUAL).toPrecision(1));
}

function filmOf({ width, firstRows, numbers }: Written["film"]): Film {
  return new Film({
    width,
    firstRows: new Uint32Array(bytes(firstRows)),
    numbers: new Float64Array(bytes(numbers)),
  });
}

function eventsOf({ events: { quantities, codes }, cushionIds, pocketIds }: Written): EventColumns {
  const arrays = <T>(texts: Record<string, string>, make: (bytes: ArrayBuffer) => T) =>
    Object.fromEntries(Object.entries(texts).map(([name, text]) => [name, make(bytes(text))]));
  return {
    ...arrays(quantities, (bytes) => new Float64Array(bytes)),
    ...arrays(codes, (bytes) => new Int32Array(bytes)),
    cushionIds,
    pocketIds,
  } as EventColumns;
}

function bytes(base64: string): ArrayBuffer {
  const letters = atob(base64);
  const found = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k++) found[k] = letters.charCodeAt(k);
  return found.buffer;
}
