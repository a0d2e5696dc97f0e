/** The question of a part: the form for the prediction, and then the prediction beside what the run gives. */

import { useSignal } from "@preact/signals";
import { Icon } from "../studio/Icon";
import { isPlaying, time, toggle } from "../studio/store";
import { word } from "../words";
import { signed } from "./format";
import { drawn, part, place, predict, prediction, result, skipToAnswer } from "./state";
import { isGood, type Question } from "./types";

export function Prediction() {
  const question = part.value?.question;
  if (!question) return null;
  return (
    <section class="question" aria-labelledby="question">
      <h3 id="question">{word("predictFirst")}</h3>
      <p>{word(question.text)}</p>
      {prediction.value === null ? (
        <Form key={place.value} question={question} />
      ) : (
        <Told question={question} />
      )}
    </section>
  );
}

function Form({ question }: { question: Question }) {
  const given = useSignal<number | null>(null);
  const value = question.kind === "direction" ? drawn.value : given.value;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        if (value !== null) predict(value);
      }}
    >
      {question.kind === "choice" && (
        <fieldset>
          <legend class="unseen">{word(question.text)}</legend>
          {question.choices.map((choice, k) => (
            <label class="choice" key={choice}>
              <input
                type="radio"
                name="prediction"
                checked={given.value === k}
                onChange={() => {
                  given.value = k;
                }}
              />
              <span>{word(choice)}</span>
            </label>
          ))}
        </fieldset>
      )}
      {question.kind === "number" && (
        <NumberField
          label={word("lessonPrediction")}
          unit={word(question.unit)}
          value={given.value}
          onInput={(typed) => {
            given.value = typed;
          }}
        />
      )}
      {question.kind === "direction" && (
        <>
          <p class="hint">{word("drawDirection")}</p>
          <NumberField
            label={word("lessonDirection")}
            unit="°"
            value={drawn.value}
            onInput={(typed) => {
              drawn.value = typed;
            }}
          />
        </>
      )}
      <button type="submit" class="primary" disabled={value === null}>
        {word("lessonUnlock")}
      </button>
    </form>
  );
}

function NumberField(props: {
  label: string;
  unit: string;
  value: number | null;
  onInput: (value: number | null) => void;
}) {
  return (
    <label class="amount">
      <span>{props.label}</span>
      <input
        type="number"
        step="any"
        value={props.value ?? ""}
        onInput={(event) => {
          const typed = event.currentTarget.valueAsNumber;
          props.onInput(Number.isFinite(typed) ? typed : null);
        }}
      />
      <span>{props.unit}</span>
    </label>
  );
}

/** A prediction or a result in words. */
function answerText(question: Question, value: number): string {
  if (question.kind === "choice") return word(question.choices[value] ?? "lessonNoAnswer");
  if (!Number.isFinite(value)) return word("lessonNoAnswer");
  if (question.kind === "direction") return `${signed(value)}°`;
  return `${signed(value)} ${word(question.unit)}`;
}

/** A prediction beside what the run gives, and how good it was. */
export function Beside(props: { question: Question; guess: number; real: number | null }) {
  const { question, guess, real } = props;
  const isWell = real !== null && isGood(question, guess, real);
  return (
    <>
      <dl class="beside">
        <div>
          <dt>{word("lessonPrediction")}</dt>
          <dd class="guess">{answerText(question, guess)}</dd>
        </div>
        <div>
          <dt>{word("lessonTheRun")}</dt>
          <dd aria-live="polite">{real === null ? word("lessonNotYet") : answerText(question, real)}</dd>
        </div>
      </dl>
      {real !== null && (
        <p class={isWell ? "verdict good" : "verdict"}>
          {word(isWell ? "wellPredicted" : "lessonOtherwise")}
        </p>
      )}
    </>
  );
}

/** What was predicted; then how to come to the answer, or how to look at it again. */
function Told({ question }: { question: Question }) {
  const [guess, real] = [prediction.value as number, result.value];
  return (
    <>
      <Beside question={question} guess={guess} real={real} />
      {real === null ? (
        <div class="row">
          <button type="button" class="primary" onClick={toggle}>
            <Icon name={isPlaying.value ? "pause" : "play"} />
            {word(isPlaying.value ? "pause" : time.value > 0 ? "lessonGoOn" : "play")}
          </button>
          <button type="button" class="plain" onClick={skipToAnswer}>
            {word("skipToAnswer")}
          </button>
        </div>
      ) : (
        !isGood(question, guess, real) && <p>{word("lessonLookAgain")}</p>
      )}
    </>
  );
}
