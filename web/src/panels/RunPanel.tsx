/** The panel of what the run says of itself: how it ended, its digest, its audit, and the sources of its laws. */

import { canUndo, drawing, run, scenario, vocabulary } from "../studio/store";
import { number, word } from "../words";
import type { Word } from "../words/en";
import { wordOfKind } from "./events/log";
import "../style/run.css";

/** A source of a law, as the engine names it. */
interface Reference {
  law: string;
  text: string;
  doi: string | null;
}

/** What the engine found out about a run that is worth a line, in order. */
const AUDIT: [string, Word][] = [
  ["initial_energy", "initialEnergy"],
  ["final_energy", "finalEnergy"],
  ["energy_loss", "energyLoss"],
  ["energy_drift", "energyDrift"],
  ["momentum_error", "momentumError"],
  ["deepest_overlap", "deepestOverlap"],
  ["clusters", "clusters"],
  ["corrections", "corrections"],
];

export function RunPanel() {
  const shown = run.value;
  if (!shown) return null;
  const { status, endTime, digest, diagnostics, references } = shown.summary;
  const happened = Object.entries(diagnostics.events).filter(([, count]) => count > 0);
  return (
    <div class="run">
      <p>
        {word(`status_${status}` as Word, { time: number(endTime, 8) })}
        {!drawing.value?.isOnCloth && diagnostics["lost_time"] ? ` ${word("inSteps")}` : ""}
      </p>
      <h2>{word("eventsOfRun")}</h2>
      <dl>
        {happened.map(([kind, count]) => (
          <Line key={kind} label={wordOfKind(kind)} value={number(count, 7)} />
        ))}
      </dl>
      <h2>{word("audit")}</h2>
      <dl>
        {AUDIT.map(([key, label]) => (
          <Line key={key} label={word(label)} value={number(Number(diagnostics[key] ?? 0), 6)} />
        ))}
      </dl>
      <h2>{word("sameBits")}</h2>
      <p class="digest">
        <code>{digest ?? word("noDigest")}</code>
      </p>
      <p class="faint">
        {word("madeWith", {
          version: vocabulary.value?.version ?? "",
          physics: vocabulary.value?.physics_version ?? "",
        })}{" "}
        {scenario.value?.name && !canUndo.value && word("verifyWith", { name: scenario.value.name })}
      </p>
      <h2>{word("sources")}</h2>
      <ul class="sources">
        {(references as Reference[]).map(({ law, text, doi }) => (
          <li key={law + text}>
            <code>{law}</code>: {text}
            {doi && <span class="faint"> doi:{doi}</span>}
          </li>
        ))}
      </ul>
    </div>
  );
}

function Line({ label, value }: { label: string; value: string }) {
  return (
    <>
      <dt>{label}</dt>
      <dd>{value}</dd>
    </>
  );
}
