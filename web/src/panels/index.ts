/** The panels beside the table, in the order of their tabs. A new one is a file and a line here. */

import type { ComponentType } from "preact";
import { drawing } from "../studio/store";
import type { Word } from "../words/en";
import { Compare } from "./compare/Compare";
import { Cue } from "./cue/Cue";
import { Events } from "./events/Events";
import { Files } from "./files/Files";
import { Graphs } from "./graphs/Graphs";
import { RunPanel } from "./RunPanel";
import { Balls } from "./setup/Balls";
import { Setup } from "./setup/Setup";

export interface Panel {
  id: string;
  label: Word;
  component: ComponentType;
  /** Whether the panel has anything to show for what is on the table; absent: always. */
  isShown?: () => boolean;
}

export const panels: Panel[] = [
  { id: "cue", label: "cue", component: Cue, isShown: () => drawing.value?.isOnCloth ?? false },
  { id: "setup", label: "setup", component: Setup },
  { id: "balls", label: "balls", component: Balls },
  { id: "graphs", label: "graphs", component: Graphs },
  { id: "events", label: "events", component: Events },
  { id: "compare", label: "compare", component: Compare },
  { id: "run", label: "run", component: RunPanel },
  { id: "files", label: "files", component: Files },
];
