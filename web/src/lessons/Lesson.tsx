/** A lesson: a table that plays once a prediction is made, and beside it what there is to ask and to see. */

import { useEffect, useRef } from "preact/hooks";
import { Messages } from "../studio/App";
import { Icon } from "../studio/Icon";
import { drawing, isPlaying, time } from "../studio/store";
import { Transport } from "../studio/Transport";
import { Plate } from "../table/Plate";
import { Table } from "../table/Table";
import { number, word } from "../words";
import { Chart } from "./Chart";
import { Explained } from "./Explained";
import { Glass } from "./Glass";
import { Beside, Prediction } from "./Prediction";
import { Sheet } from "./Sheet";
import {
  closeLesson,
  collisions,
  idOf,
  isLocked,
  isPausing,
  lesson,
  openPart,
  part,
  past,
  place,
  predictions,
  result,
  results,
} from "./state";
import type { Lesson as LessonData, Part } from "./types";
import "../style/lessons.css";

export function Lesson() {
  const open = lesson.value;
  if (!open) return null;
  return (
    <>
      <main class={part.value ? "studio lesson" : "lesson lesson-end"}>
        {part.value ? <Asked open={open} asked={part.value} /> : <Summary open={open} />}
      </main>
      <Sheet lesson={open} />
    </>
  );
}

function Asked({ open, asked }: { open: LessonData; asked: Part }) {
  return (
    <>
      <div class="stage">
        <Plate
          label={word("tableLabel", { balls: drawing.value?.balls.length ?? 0, time: number(time.value) })}
        >
          {/* The balls of a lesson stay where they are. */}
          <div class="still" inert>
            <Table />
          </div>
          <Glass />
        </Plate>
        <Messages />
        {isLocked.value ? <Lock /> : <Transport />}
      </div>
      <Guide open={open} asked={asked} />
    </>
  );
}

function Lock() {
  return (
    <section class="transport lock" aria-label={word("timeline")}>
      <button type="button" class="icon main" disabled aria-label={word("play")}>
        <Icon name="play" />
      </button>
      <p>{word("lessonLocked")}</p>
    </section>
  );
}

function Guide({ open, asked }: { open: LessonData; asked: Part }) {
  const title = useHeadFocus(place.value);
  const isLast = place.value === open.parts.length - 1;
  return (
    <aside class="side guide" aria-label={word("lesson")}>
      <p class="kicker">{word("partOf", { part: place.value + 1, parts: open.parts.length })}</p>
      <h2 ref={title} tabIndex={-1}>
        {word(asked.title)}
      </h2>
      {isLocked.value && <p>{word(asked.intro)}</p>}
      {asked.other && (
        <p class="legend">
          <Solid /> {word("lessonExact")} <Dashed /> {word(asked.other.name)}
        </p>
      )}
      <Prediction />
      {result.value !== null && <p class="takeaway">{word(asked.takeaway)}</p>}
      {!isLocked.value && <Collision asked={asked} />}
      <nav class="row steps" aria-label={word("lessonSteps")}>
        {place.value > 0 && (
          <button type="button" onClick={() => openPart(place.value - 1)}>
            {word("lessonBack")}
          </button>
        )}
        <button
          type="button"
          class={result.value === null ? "" : "primary"}
          disabled={result.value === null}
          onClick={() => openPart(place.value + 1)}
        >
          {word(isLast ? "toSummary" : "nextPart")}
        </button>
        <PrintButton />
      </nav>
    </aside>
  );
}

/** Brings the reader to the head of a part when it opens. */
function useHeadFocus(of: number) {
  const head = useRef<HTMLHeadingElement>(null);
  useEffect(() => head.current?.focus({ preventScroll: true }), [of]);
  return head;
}

/** The collision that it pauses at, or the last one before; and how many there were. */
function Collision({ asked }: { asked: Part }) {
  const last = isPlaying.value ? undefined : past.value.at(-1);
  const [count, all] = [past.value.length, collisions.value.length];
  const ball = asked.watched === undefined ? "" : idOf(asked.watched);
  return (
    <section class="collision" aria-labelledby="collisions">
      <h3 id="collisions" class="unseen">
        {word("unitCollisions")}
      </h3>
      <div aria-live="polite">{last && <Explained instant={last} />}</div>
      {asked.explanation === "distance" && <Chart />}
      <p class="count">{word(ball ? "lessonSoFarOf" : "lessonSoFar", { ball, count, all })}</p>
      <label class="choice">
        <input
          type="checkbox"
          checked={isPausing.value}
          onChange={(event) => {
            isPausing.value = event.currentTarget.checked;
          }}
        />
        <span>
          {asked.pauses === undefined
            ? word(ball ? "pauseAtEachOf" : "pauseAtEach", { ball })
            : word("pauseAtFirst", { count: asked.pauses })}
        </span>
      </label>
    </section>
  );
}

function Summary({ open }: { open: LessonData }) {
  const title = useHeadFocus(place.value);
  return (
    <article class="summary">
      <p class="kicker">{word("lessonSummary")}</p>
      <h2 ref={title} tabIndex={-1}>
        {word(open.title)}
      </h2>
      <ul class="learned">
        {open.summary.map((line) => (
          <li key={line}>{word(line)}</li>
        ))}
      </ul>
      <h3>{word("lessonPredictions")}</h3>
      <ol class="answers">
        {open.parts.map((asked, k) => (
          <Answer key={asked.title} asked={asked} guess={predictions.value[k]} real={results.value[k]} />
        ))}
      </ol>
      <nav class="row steps" aria-label={word("lessonSteps")}>
        <button type="button" onClick={() => openPart(open.parts.length - 1)}>
          {word("lessonBack")}
        </button>
        <PrintButton />
        <button type="button" class="primary" onClick={closeLesson}>
          {word("toGallery")}
        </button>
      </nav>
    </article>
  );
}

function Answer(props: { asked: Part; guess: number | null | undefined; real: number | null | undefined }) {
  const { question } = props.asked;
  const { guess, real } = props;
  if (typeof guess !== "number" || typeof real !== "number") return null;
  return (
    <li>
      <p>{word(question.text)}</p>
      <Beside question={question} guess={guess} real={real} />
    </li>
  );
}

function PrintButton() {
  return (
    <button type="button" onClick={() => window.print()}>
      {word("printSheet")}
    </button>
  );
}

const Solid = () => (
  <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
    <circle cx="8" cy="8" r="6" fill="currentColor" />
  </svg>
);

const Dashed = () => (
  <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
    <circle cx="8" cy="8" r="6" fill="none" stroke="currentColor" stroke-width="2" stroke-dasharray="3 2.5" />
  </svg>
);
