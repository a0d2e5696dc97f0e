/** The page: the gallery, or a table with its panels. */

import { signal } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import type { CutBy } from "../engine/protocol";
import { closeLesson, lesson } from "../lessons/state";
import { panels } from "../panels";
import { DropHint } from "../sharing/DropHint";
import { LinkVerdict } from "../sharing/Verdict";
import { Plate } from "../table/Plate";
import { Table } from "../table/Table";
import { TableBar } from "../table/TableBar";
import { LANGUAGES, type Language, language, number, speak, word } from "../words";
import type { Word } from "../words/en";
import { described, translated } from "./describe";
import { isEmbedded } from "./embed";
import { Gallery } from "./Gallery";
import { History } from "./History";
import { Icon } from "./Icon";
import { later } from "./later";
import { isHelpShown, Shortcuts } from "./Shortcuts";
import {
  changesAreIn,
  closeScenario,
  endTime,
  notice,
  opened,
  problems,
  run,
  scenario,
  written,
} from "./store";
import { Transport } from "./Transport";
import { toggleTheme } from "./theme";

const Lesson = later(async () => (await import("../lessons/Lesson")).Lesson);

/** The panel that is open, by its id. */
export const openPanel = signal(panels[0]?.id ?? "");

export function App() {
  // What is opened is seen from its top, also from the middle of a long gallery.
  useLayoutEffect(() => window.scrollTo(0, 0), [opened.value]);
  if (isEmbedded) return <Frame />;
  return (
    <>
      <Header />
      {lesson.value ? <Lesson /> : scenario.value ? <Studio /> : <Gallery />}
      <Shortcuts />
      <DropHint />
    </>
  );
}

/** The page in a frame of another one: table and time, nothing else. */
function Frame() {
  return (
    <>
      <main class="studio framed">
        <h1 class="unseen">{headline()}</h1>
        <Stage />
      </main>
      <Shortcuts />
    </>
  );
}

/** A title of more letters is cut off: a foreign file may have millions. */
const LONGEST_TITLE = 300;

/** The name of what is open. */
export function headline(): string {
  if (lesson.value) return word(lesson.value.title);
  if (!scenario.value) return word("title");
  const { name } = scenario.value;
  return name
    ? described(name).title
    : translated(String(written.value["title"] ?? word("title")).slice(0, LONGEST_TITLE));
}

function Header() {
  const isOpen = scenario.value !== null || lesson.value !== null;
  return (
    <header class="bar">
      <Mark />
      {isOpen && (
        <button
          type="button"
          class="plain"
          onClick={async () => {
            await changesAreIn();
            if (lesson.peek()) closeLesson();
            else closeScenario();
          }}
        >
          <span aria-hidden="true">←</span> <span class="label">{word("gallery")}</span>
        </button>
      )}
      <h1>{headline()}</h1>
      {scenario.value && !lesson.value && <History />}
      <label class="language">
        <span class="unseen">{word("language")}</span>
        <select value={language.value} onChange={(event) => speak(event.currentTarget.value as Language)}>
          {Object.entries(LANGUAGES).map(([code, words]) => (
            <option key={code} value={code}>
              {words.languageName}
            </option>
          ))}
        </select>
      </label>
      <HeaderButton
        icon="keys"
        label={word("shortcuts")}
        onClick={() => {
          isHelpShown.value = true;
        }}
      />
      <HeaderButton icon="theme" label={word("theme")} onClick={toggleTheme} />
    </header>
  );
}

function HeaderButton({ icon, label, onClick }: { icon: string; label: string; onClick: () => void }) {
  return (
    <button type="button" class={`icon quiet ${icon}`} title={label} aria-label={label} onClick={onClick}>
      <Icon name={icon} />
    </button>
  );
}

/** The mark: a ball off two cushions. */
function Mark() {
  return (
    <svg class="mark" viewBox="0 0 32 32" width="32" height="32" aria-hidden="true">
      <rect class="mark-cloth" width="32" height="32" rx="8" />
      <path class="mark-path" d="M7 25 17 6.5 26 22" />
      <circle class="mark-ball" cx="24.6" cy="22.5" r="4.2" />
    </svg>
  );
}

function Studio() {
  const shown = panels.filter(({ isShown }) => isShown?.() ?? true);
  const open = shown.find(({ id }) => id === openPanel.value) ?? shown[0];
  return (
    <main class="studio">
      <Stage />
      {open && (
        <aside class="side">
          <div role="tablist" class="tabs" aria-label={word("panels")} onKeyDown={turnTabs}>
            {shown.map(({ id, label }) => (
              <button
                type="button"
                role="tab"
                key={id}
                id={`tab-${id}`}
                aria-selected={id === open.id}
                aria-controls="panel"
                tabIndex={id === open.id ? 0 : -1}
                onClick={() => {
                  openPanel.value = id;
                  requestAnimationFrame(showPanel);
                }}
              >
                {word(label)}
              </button>
            ))}
          </div>
          {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls is reached by keyboard, also a panel of text */}
          <div role="tabpanel" id="panel" class="panel" aria-labelledby={`tab-${open.id}`} tabIndex={0}>
            <open.component />
          </div>
        </aside>
      )}
    </main>
  );
}

/** Where the panel is below the table, as on a phone, enough of both is brought into view. */
function showPanel() {
  const top = document.getElementById("panel")?.getBoundingClientRect().top ?? 0;
  if (top > window.innerHeight * 0.6) window.scrollBy(0, top - window.innerHeight * 0.45);
}

function Stage() {
  return (
    <div class="stage">
      <Plate>
        <Table />
      </Plate>
      <TableBar />
      <Messages />
      <Transport />
    </div>
  );
}

/** The arrow keys go from tab to tab. */
function turnTabs(event: KeyboardEvent & { currentTarget: HTMLElement }) {
  const turn = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  const tabs = [...event.currentTarget.querySelectorAll<HTMLElement>("[role=tab]")];
  const at = tabs.indexOf(document.activeElement as HTMLElement);
  if (!turn || at < 0) return;
  const next = tabs[(at + turn + tabs.length) % tabs.length];
  next?.click();
  next?.focus();
}
/** What is said of a run that was broken off. */
const CUT: Record<CutBy, Word> = {
  events: "cut",
  memory: "cutByMemory",
  time: "cutByTime",
  user: "cutByUser",
};

/** What is wrong, and what there is to say. */
export function Messages() {
  const by = run.value?.cutBy;
  const cut = by
    ? word(CUT[by], { events: number(run.value?.events.time.length ?? 0, 3), time: number(endTime.value) })
    : null;
  const messages = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (notice.value || problems.value.length > 0) messages.current?.scrollIntoView({ block: "nearest" });
  }, [notice.value, problems.value]);
  return (
    <div class="messages" aria-live="polite" ref={messages}>
      {problems.value.length > 0 && (
        <div class="message wrong">
          <strong>{word("problemsTitle")}</strong>
          <ul>
            {problems.value.map(({ place, message }) => (
              <li key={place + message}>
                <code>{place}</code>: {message}
              </li>
            ))}
          </ul>
          <Close
            onClick={() => {
              problems.value = [];
            }}
          />
        </div>
      )}
      {notice.value && (
        <div class="message">
          <span>{notice.value}</span>
          <Close
            onClick={() => {
              notice.value = null;
            }}
          />
        </div>
      )}
      {cut && <div class="message">{cut}</div>}
      <LinkVerdict />
    </div>
  );
}

export function Close({ onClick }: { onClick: () => void }) {
  return (
    <button type="button" class="icon" title={word("close")} aria-label={word("close")} onClick={onClick}>
      <Icon name="close" />
    </button>
  );
}
