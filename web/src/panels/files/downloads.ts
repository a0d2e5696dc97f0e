/** Files to save: the scenario, the run, its events and its trajectory, and pictures. */

import { engine, run, scenario, vocabulary, written } from "../../studio/store";
import { eventsCsv, trajectoryCsv } from "./csv";
import { pngPicture, svgPicture } from "./picture";

/** A file that can be made of what is open. */
export interface Download {
  /** What follows the name of the scenario in that of the file. */
  ending: string;
  make: () => Promise<Blob>;
  /** Whether it is made of a run that has come to its end. */
  needsRun: boolean;
}

const CSV = "text/csv";

export const scenarioFile: Download = {
  ending: ".toml",
  make: async () => new Blob([await engine.ask("toml", { json: openJson() })], { type: "application/toml" }),
  needsRun: false,
};

export const runFile: Download = {
  ending: "_run.json",
  make: async () => new Blob([await engine.ask("runJson", { slot: "main" })], { type: "application/json" }),
  needsRun: true,
};

export const eventsFile: Download = {
  ending: "_events.csv",
  make: async () => table((shown) => eventsCsv(shown, vocabulary.peek()?.kinds ?? [])),
  needsRun: true,
};

export const trajectoryFile = (samples: number): Download => ({
  ending: "_trajectory.csv",
  make: async () => table((shown) => trajectoryCsv(shown, samples, vocabulary.peek()?.motions ?? [])),
  needsRun: true,
});

export const pngFile: Download = { ending: ".png", make: pngPicture, needsRun: false };
export const svgFile: Download = { ending: ".svg", make: svgPicture, needsRun: false };

const openJson = () => scenario.peek()?.json ?? "{}";

/** Lines are put together to texts of so many: a file has too many to be kept one by one, and too much for one text. */
const LINES = 5000;

function table(lines: (shown: NonNullable<ReturnType<typeof run.peek>>) => Iterable<string>): Blob {
  const shown = run.peek();
  const parts: string[] = [];
  let part: string[] = [];
  for (const line of shown ? lines(shown) : []) {
    part.push(line);
    if (part.length < LINES) continue;
    parts.push(part.join(""));
    part = [];
  }
  return new Blob([...parts, part.join("")], { type: CSV });
}

/** Makes a file and hands it to the browser to save. */
export async function save({ ending, make }: Download) {
  const name = fileName() + ending;
  const address = URL.createObjectURL(await make());
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // The browser reads it after the click.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

const LONGEST_NAME = 60;

/** The name of a ready-made scenario, or one made of the title: letters and digits of any language. */
function fileName(): string {
  const named = scenario.peek()?.name;
  if (named) return named;
  const title = String(written.peek()["title"] ?? "");
  const words = title.toLowerCase().match(/[\p{L}\p{N}]+/gu) ?? [];
  return words.join("_").slice(0, LONGEST_NAME) || "scenario";
}
