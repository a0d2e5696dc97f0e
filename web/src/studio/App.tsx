/** The page: the gallery, or a table with its panels. */

import { signal } from "@preact/signals";
import { panels } from "../panels";
import { Table } from "../table/Table";
import { LANGUAGES, type Language, language, number, word } from "../words";
import { Gallery } from "./Gallery";
import { Icon } from "./Icon";
import { closeScenario, endTime, notice, problems, run, scenario, written } from "./store";
import { Transport } from "./Transport";
import { toggleTheme } from "./theme";

/** The panel that is open, by its id. */
export const openPanel = signal(panels[0]?.id ?? "");

export function App() {
  return (
    <>
      <Header />
      {scenario.value ? <Studio /> : <Gallery />}
    </>
  );
}

function Header() {
  const title = scenario.value ? String(written.value["title"] ?? word("title")) : word("title");
  return (
    <header class="bar">
      {scenario.value && (
        <button type="button" class="plain" onClick={closeScenario}>
          ← {word("gallery")}
        </button>
      )}
      <h1>{title}</h1>
      <label class="language">
        <span class="unseen">{word("language")}</span>
        <select
          value={language.value}
          onChange={(event) => {
            language.value = event.currentTarget.value as Language;
          }}
        >
          {Object.entries(LANGUAGES).map(([code, words]) => (
            <option key={code} value={code}>
              {words.languageName}
            </option>
          ))}
        </select>
      </label>
      <button
        type="button"
        class="icon"
        title={word("theme")}
        aria-label={word("theme")}
        onClick={toggleTheme}
      >
        <Icon name="theme" />
      </button>
    </header>
  );
}

function Studio() {
  const shown = panels.filter(({ isShown }) => isShown?.() ?? true);
  const open = shown.find(({ id }) => id === openPanel.value) ?? shown[0];
  return (
    <main class="studio">
      <div class="stage">
        <Table />
        <Messages />
        <Transport />
      </div>
      {open && (
        <aside class="side">
          <div role="tablist" class="tabs">
            {shown.map(({ id, label }) => (
              <button
                type="button"
                role="tab"
                key={id}
                id={`tab-${id}`}
                aria-selected={id === open.id}
                aria-controls="panel"
                onClick={() => {
                  openPanel.value = id;
                }}
              >
                {word(label)}
              </button>
            ))}
          </div>
          <div role="tabpanel" id="panel" class="panel" aria-labelledby={`tab-${open.id}`}>
            <open.component />
          </div>
        </aside>
      )}
    </main>
  );
}

/** What is wrong, and what there is to say. */
export function Messages() {
  const cut = run.value?.isCut
    ? word("cut", { events: number(run.value.events.time.length, 3), time: number(endTime.value) })
    : null;
  return (
    <div class="messages" aria-live="polite">
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
          {notice.value}
          <Close
            onClick={() => {
              notice.value = null;
            }}
          />
        </div>
      )}
      {cut && <div class="message">{cut}</div>}
    </div>
  );
}

function Close({ onClick }: { onClick: () => void }) {
  return (
    <button type="button" class="icon" title={word("close")} aria-label={word("close")} onClick={onClick}>
      <Icon name="close" />
    </button>
  );
}
