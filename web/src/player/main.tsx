/** A page that plays one recorded run: the table, the time, the events. */

import { effect } from "@preact/signals";
import { render } from "preact";
import { List } from "../panels/events/List";
import { Icon } from "../studio/Icon";
import { run, vocabulary, written } from "../studio/store";
import { Transport } from "../studio/Transport";
import { toggleTheme } from "../studio/theme";
import { language, number, word } from "../words";
import type { Word } from "../words/en";
import { putOnTable } from "./recorded";
import { Stage } from "./Stage";
import "../style/base.css";
import "../style/studio.css";
import "../style/events.css";
import "./player.css";

const title = () => String(written.value["title"] ?? word("recordedRun"));

function Player() {
  return (
    <main class="player">
      <header class="bar">
        <h1>{title()}</h1>
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
      <Stage />
      <Transport />
      <section class="happened" aria-label={word("eventsOfRun")}>
        {(run.value?.events.time.length ?? 0) > 0 ? <List /> : <p class="hint">{word("noEvents")}</p>}
      </section>
      <Footer />
    </main>
  );
}

/** How the run ended, and what it can be known by. */
function Footer() {
  const summary = run.value?.summary;
  if (!summary) return null;
  return (
    <footer>
      <span>{word(`status_${summary.status}` as Word, { time: number(summary.endTime, 6) })}</span>
      <span>Carom {vocabulary.value?.version}</span>
      {summary.digest && <code>{summary.digest}</code>}
    </footer>
  );
}

putOnTable(document.getElementById("run")?.textContent ?? "");
effect(() => {
  document.documentElement.lang = language.value;
  document.title = title();
});

const root = document.getElementById("studio");
if (root) render(<Player />, root);
