/** The panels beside the table, in the order of their tabs. A new one is a file and a line here. */

import type { ComponentType } from "preact";
import { later } from "../studio/later";
import { drawing } from "../studio/store";
import type { Word } from "../words/en";

export interface Panel {
  id: string;
  label: Word;
  component: ComponentType;
  /** Whether the panel has anything to show for what is on the table; absent: always. */
  isShown?: () => boolean;
}

export const panels: Panel[] = [
  {
    id: "cue",
    label: "cue",
    component: later(async () => (await import("./cue/Cue")).Cue),
    isShown: () => drawing.value?.isOnCloth ?? false,
  },
  { id: "setup", label: "setup", component: later(async () => (await import("./setup/Setup")).Setup) },
  { id: "balls", label: "balls", component: later(async () => (await import("./setup/Balls")).Balls) },
  { id: "graphs", label: "graphs", component: later(async () => (await import("./graphs/Graphs")).Graphs) },
  { id: "events", label: "events", component: later(async () => (await import("./events/Events")).Events) },
  {
    id: "compare",
    label: "compare",
    component: later(async () => (await import("./compare/Compare")).Compare),
  },
  { id: "run", label: "run", component: later(async () => (await import("./RunPanel")).RunPanel) },
  { id: "files", label: "files", component: later(async () => (await import("./files/Files")).Files) },
];
