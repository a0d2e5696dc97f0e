/** Files and texts that are dropped, pasted or chosen: scenarios, saved runs, links, and one's own trajectory. */

import { signal } from "@preact/signals";
import { takeTrajectory } from "../own/own";
import { openPanel } from "../studio/App";
import { forgetMessages, openText, say, scenario } from "../studio/store";
import { word } from "../words";
import { openFragment } from "./address";
import { LONGEST_LINK, MARK } from "./link";
import { memberText } from "./member";

/** Larger files are not read. */
const LARGEST_FILE = 64 * 2 ** 20;

/** Whether something is held over the page that could be dropped. */
export const isHeld = signal(false);

/** Takes what is pasted or dropped anywhere on the page. */
export function receive() {
  document.addEventListener("paste", (event) => {
    if (isField(event.target) || !event.clipboardData) return;
    event.preventDefault();
    void take(event.clipboardData);
  });
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    isHeld.value = true;
  });
  document.addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) isHeld.value = false;
  });
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    isHeld.value = false;
    if (event.dataTransfer) void take(event.dataTransfer);
  });
}

const isField = (target: EventTarget | null) =>
  target instanceof Element && target.closest("input, textarea, select, [contenteditable]") !== null;

async function take(data: DataTransfer) {
  const file = data.files[0];
  await (file ? takeFile(file) : takeText(data.getData("text/plain"), ""));
}

export async function takeFile(file: File) {
  forgetMessages();
  if (file.size > LARGEST_FILE) return say("fileTooLarge", { name: file.name });
  const text = new TextDecoder("utf-8").decode(await file.arrayBuffer());
  if (/[\0\uFFFD]/.test(text)) return say("fileNoText", { name: file.name });
  await takeText(text, file.name);
}

/** Opens a text: a link, a scenario, a saved run, or the table of a trajectory. */
export async function takeText(text: string, name: string) {
  const trimmed = text.trim();
  if (trimmed === "") return;
  forgetMessages();
  const link = linkIn(trimmed);
  if (link !== null) return void (await openFragment(link));
  const kind = kindOf(trimmed, name);
  if (kind === "csv") return takeTable(text, name);
  const json = kind === "json" ? (memberText(trimmed, "scenario") ?? trimmed) : null;
  await (json === null ? openText(text, "toml") : openText(json, "json"));
}

function takeTable(text: string, name: string) {
  if (!scenario.peek()) return say("trajectoryNeedsScenario");
  openPanel.value = "files";
  takeTrajectory(text, name || word("ownPasted"));
}

function linkIn(text: string): string | null {
  const at = text.search(new RegExp(`#${MARK}|^${MARK}`));
  const isLink = at >= 0 && (at < 2000 || text.length > LONGEST_LINK) && !/\s/.test(text);
  return isLink ? text.slice(text.indexOf(MARK, at)) : null;
}

export type Kind = "toml" | "json" | "csv";

/** What a text is: by the name of its file, or else by how it looks. */
export function kindOf(text: string, name: string): Kind {
  const ending = /\.(toml|json|csv|tsv)$/i.exec(name)?.[1]?.toLowerCase();
  if (ending) return ending === "tsv" ? "csv" : (ending as Kind);
  if (/^\s*[{[]\s*["{}\]]/.test(text)) return "json";
  const isToml = /^\s*(\[\[?[\w."-]+\]\]?\s*$|[\w."-]+\s*=)/m.test(text);
  return !isToml && /^[^\n]*[,;\t ][^\n]*\n./.test(text) ? "csv" : "toml";
}
