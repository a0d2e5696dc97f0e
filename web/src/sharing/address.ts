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

/** Milliseconds between two changes of the address, as browsers refuse to have it written all the time. */
const CALM = 300;

/** What the address is to say. */
interface Entry {
  open: Open | null;
  /** Whether it is no longer as it was opened. */
  isChanged: boolean;
  how: "pushState" | "replaceState";
}

/** Opens what the address names, now and whenever it changes, and puts into it what is opened or changed otherwise. */
export function followAddress() {
  window.addEventListener("hashchange", () => void openAddress());
  let known = opened.peek();
  effect(() => {
    const open = scenario.value;
    const isNew = opened.value !== known;
    known = opened.value;
    if (isNew) {
      putWaiting();
      put({ open, isChanged: false, how: "pushState" });
    } else if (open && !lesson.peek()) {
      putSoon({ open, isChanged: canUndo.peek(), how: "replaceState" });
    }
  });
  void openAddress();
}

/** A change that waits to be written. */
let waiting: Entry | null = null;
let timer: ReturnType<typeof setTimeout> | undefined;
let lastWritten = Number.NEGATIVE_INFINITY;

function putSoon(entry: Entry) {
  waiting = entry;
  clearTimeout(timer);
  timer = setTimeout(putWaiting, lastWritten + CALM - performance.now());
}

function putWaiting() {
  clearTimeout(timer);
  if (!waiting) return;
  put(waiting);
  waiting = null;
  lastWritten = performance.now();
}

const fragment = () => location.hash.slice(1);

/** The fragment that was dealt with last. Another one is new: the event that tells of it has yet to come. */
let seen = "";
/** How often someone else than the page has changed the address. */
let visits = 0;

async function openAddress() {
  forgetMessages();
  const named = fragment();
  seen = named;
  visits++;
  waiting = null;
  if (named === "" || named === FILE) {
    if (lesson.peek()) closeLesson();
    else if (scenario.peek()) closeScenario();
  } else {
    if (!(await openFragment(named))) say("linkUnknown");
    // Where nothing came of it, the address goes back to what is there.
    if (scenario.peek()) put({ open: scenario.peek(), isChanged: canUndo.peek(), how: "replaceState" });
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

let writing: Promise<unknown> = Promise.resolve();

/** Writes the address, one after the other; later, as what else follows the scenario, such as a lesson, has followed then. */
function put(entry: Entry) {
  const visit = visits;
  // One that a browser refuses is told of, and holds up no other.
  writing = writing.catch(() => {}).then(() => write(entry, visit));
}

/** Writes the address, unless someone else has changed it meanwhile. */
async function write({ open, isChanged, how }: Entry, visit: number) {
  const target = await fragmentFor(open, isChanged);
  if (visits !== visit || fragment() !== seen || target === seen) return;
  const { pathname, search } = location;
  history[how](null, "", target === "" ? pathname + search : `#${target}`);
  seen = fragment();
}

async function fragmentFor(open: Open | null, isChanged: boolean): Promise<string> {
  if (lesson.peek() && !isChanged) return LESSON + lesson.peek()?.id;
  if (!open) return "";
  const asOpened = open.name ?? open.link?.fragment;
  if (asOpened && !isChanged) return asOpened;
  const made = await fragmentOf(open.json, null, vocabulary.peek()?.physics_version ?? 0);
  return made.length <= LONGEST_ADDRESS ? made : FILE;
}
