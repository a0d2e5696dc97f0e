/**
 * The address bar: its fragment says what is open. `#midterm` is a ready-made scenario, `#scenario=…` is one that is in
 * the link itself, `#lesson=…` is a lesson, and nothing is the gallery.
 */

import { effect } from "@preact/signals";
import { lessons } from "../lessons";
import { closeLesson, lesson, openLesson } from "../lessons/state";
import { SCENARIOS } from "../studio/scenarios";
import {
  canUndo,
  closeScenario,
  forgetMessages,
  type Open,
  opened,
  openNamed,
  openText,
  say,
  scenario,
  vocabulary,
} from "../studio/store";
import { BadLink, fragmentOf, MARK, readFragment } from "./link";

/** A scenario of a file is put into the address up to so many characters: then a reload keeps it. */
const LONGEST_ADDRESS = 30_000;

/** What stands in the address for a larger one. */
const FILE = "file";

/** What the fragment of a lesson begins with. */
const LESSON = "lesson=";

/** Milliseconds without a change after which the address follows it: browsers refuse to have it written all the time. */
const CALM = 300;

/** Opens what the address names, now and whenever it changes, and puts into it what is opened or changed otherwise. */
export function followAddress() {
  window.addEventListener("hashchange", () => void openAddress());
  let known = opened.peek();
  let waiting: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const open = scenario.value;
    const isNew = opened.value !== known;
    known = opened.value;
    clearTimeout(waiting);
    const at = seen;
    if (isNew) void putAddress(open, at, "pushState");
    else if (open) waiting = setTimeout(() => void putAddress(open, at, "replaceState"), CALM);
  });
  void openAddress();
}

const fragment = () => location.hash.slice(1);

/** The fragment that was dealt with last. Another one is new: the event that tells of it has yet to come. */
let seen = "";

async function openAddress() {
  forgetMessages();
  const named = fragment();
  seen = named;
  if (named === "" || named === FILE) {
    if (lesson.peek()) closeLesson();
    else if (scenario.peek()) closeScenario();
  } else if (!(await openFragment(named))) {
    say("linkUnknown");
  }
}

/** Opens what a fragment names; false where it names nothing that there is. */
export async function openFragment(named: string): Promise<boolean> {
  if (named.startsWith(MARK)) {
    await openLink(named);
    return true;
  }
  const asked = lessons.find(({ id }) => named === LESSON + id);
  if (asked) {
    await openLesson(asked);
    return true;
  }
  if (!Object.hasOwn(SCENARIOS, named)) return false;
  await openNamed(named);
  return true;
}

async function openLink(named: string) {
  try {
    const { json, claim } = await readFragment(named);
    await openText(json, "json", null, claim);
  } catch (error) {
    if (!(error instanceof BadLink)) throw error;
    say(error.reason);
  }
}

/** Writes the address of a scenario, unless there is another scenario or another address meanwhile. */
async function putAddress(open: Open | null, at: string, write: "pushState" | "replaceState") {
  // What else follows the scenario, such as a lesson that ends with it, has followed then.
  await Promise.resolve();
  const target = await fragmentFor(open);
  if (scenario.peek() !== open || seen !== at || fragment() !== at || target === at) return;
  const { pathname, search } = location;
  history[write](null, "", target === "" ? pathname + search : `#${target}`);
  seen = fragment();
}

async function fragmentFor(open: Open | null): Promise<string> {
  if (lesson.peek()) return LESSON + lesson.peek()?.id;
  if (!open) return "";
  const asOpened = open.name ?? open.link?.fragment;
  if (asOpened && !canUndo.peek()) return asOpened;
  const made = await fragmentOf(open.json, null, vocabulary.peek()?.physics_version ?? 0);
  return made.length <= LONGEST_ADDRESS ? made : FILE;
}
