/** Keys for the time, and the list of them. They are silent while a field or a list has the focus. */

import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { isLocked } from "../lessons/state";
import { word } from "../words";
import type { Word } from "../words/en";
import { Icon } from "./Icon";
import { nextEvent, pause, previousEvent, scenario, seek, toggle } from "./store";

interface Shortcut {
  /** The values of `KeyboardEvent.key`. */
  keys: string[];
  /** What is written on the keys, where that is a word. */
  names?: Word[];
  does: Word;
  act: () => void;
}

/** Whether the list of keys is shown. */
export const isHelpShown = signal(false);

const SHORTCUTS: Shortcut[] = [
  { keys: [" "], names: ["keySpace"], does: "keyPlay", act: toggle },
  { keys: ["ArrowLeft", ","], does: "keyPrevious", act: previousEvent },
  { keys: ["ArrowRight", "."], does: "keyNext", act: nextEvent },
  { keys: ["Home"], names: ["keyHome"], does: "keyStart", act: () => go(0) },
  { keys: ["End"], names: ["keyEndKey"], does: "keyEnd", act: () => go(Number.POSITIVE_INFINITY) },
];

function go(target: number) {
  pause();
  seek(target);
}

/** What uses keys itself: fields and lists. */
const USES_KEYS = "input, select, textarea, [contenteditable], [role=slider], [role=application], dialog";
/** What the arrow keys turn. */
const IS_TURNED = "[role=tab]";
/** What the space bar presses; a tab that is open already cannot be pressed. */
const IS_PRESSED = "button:not([aria-selected=true]), a, summary, [role=button]";

function onShortcut(event: KeyboardEvent) {
  const { target } = event;
  if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
  if (target instanceof Element && target.closest(USES_KEYS)) return;
  if (event.key.startsWith("Arrow") && target instanceof Element && target.closest(IS_TURNED)) return;
  if (event.key === "?") {
    isHelpShown.value = true;
    return;
  }
  if (!scenario.peek() || isLocked.peek()) return;
  if (event.key === " " && target instanceof Element && target.closest(IS_PRESSED)) return;
  const shortcut = SHORTCUTS.find(({ keys }) => keys.includes(event.key));
  if (!shortcut) return;
  event.preventDefault();
  shortcut.act();
}

/** Listens to the keys, and shows their list when asked. */
export function Shortcuts() {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    window.addEventListener("keydown", onShortcut);
    return () => window.removeEventListener("keydown", onShortcut);
  }, []);
  useEffect(() => {
    if (isHelpShown.value) dialog.current?.showModal();
  }, [isHelpShown.value]);
  return (
    <dialog
      ref={dialog}
      class="keys"
      aria-labelledby="keys"
      onClose={() => {
        isHelpShown.value = false;
      }}
    >
      {isHelpShown.value && (
        <>
          <header class="row">
            <h2 id="keys">{word("shortcuts")}</h2>
            <button
              type="button"
              class="icon"
              title={word("close")}
              aria-label={word("close")}
              onClick={() => dialog.current?.close()}
            >
              <Icon name="close" />
            </button>
          </header>
          <dl>
            {SHORTCUTS.map((shortcut) => (
              <div key={shortcut.does}>
                <dt>
                  {shortcut.keys.map((key, k) => (
                    <kbd key={key}>{shortcut.names?.[k] ? word(shortcut.names[k]) : (SIGNS[key] ?? key)}</kbd>
                  ))}
                </dt>
                <dd>{word(shortcut.does)}</dd>
              </div>
            ))}
            <div>
              <dt>
                <kbd>?</kbd>
              </dt>
              <dd>{word("keyHelp")}</dd>
            </div>
          </dl>
        </>
      )}
    </dialog>
  );
}

const SIGNS: Record<string, string> = { ArrowLeft: "←", ArrowRight: "→" };
