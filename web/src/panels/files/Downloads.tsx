/** The buttons that save files. */

import { useSignal } from "@preact/signals";
import { useId } from "preact/hooks";
import { run, settled } from "../../studio/store";
import { word } from "../../words";
import type { Word } from "../../words/en";
import {
  type Download,
  eventsFile,
  pngFile,
  runFile,
  save,
  scenarioFile,
  svgFile,
  trajectoryFile,
} from "./downloads";

const MOST_SAMPLES = 100_000;

export function Downloads() {
  const samples = useSignal("501");
  const count = Number(samples.value);
  const isRight = Number.isInteger(count) && count >= 2 && count <= MOST_SAMPLES;
  const [id, wrong] = [useId(), useId()];
  return (
    <section>
      <h2>{word("download")}</h2>
      <ul class="downloads">
        <Item label="downloadScenario" format="TOML" download={scenarioFile} />
        <Item label="downloadRun" format="JSON" download={runFile} />
        <Item label="downloadEvents" format="CSV" download={eventsFile} />
        <Item label="downloadTrajectory" format="CSV" download={trajectoryFile(count)} isRight={isRight} />
        <Item label="downloadPicture" format="PNG" download={pngFile} />
        <Item label="downloadDrawing" format="SVG" download={svgFile} />
      </ul>
      <div class="row samples">
        <label for={id}>{word("samples")}</label>
        <input
          id={id}
          type="text"
          inputMode="numeric"
          value={samples.value}
          aria-invalid={!isRight}
          aria-describedby={wrong}
          onInput={(event) => {
            samples.value = event.currentTarget.value.trim();
          }}
        />
      </div>
      <p id={wrong} class="hint wrong-text">
        {!isRight && word("samplesWrong")}
      </p>
    </section>
  );
}

interface ItemProps {
  label: Word;
  format: string;
  download: Download;
  isRight?: boolean;
}

function Item({ label, format, download, isRight = true }: ItemProps) {
  const isThere = isRight && (!download.needsRun || (run.value?.isWhole ?? false));
  return (
    <li>
      <button type="button" disabled={!isThere} onClick={() => settled(() => save(download))}>
        <span>{word(label)}</span> <span class="format">{format}</span>
      </button>
    </li>
  );
}
