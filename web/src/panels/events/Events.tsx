/** The panel of events: the log with its filters, and the event of the moment before, during and after. */

import { useMemo } from "preact/hooks";
import { drawing, run } from "../../studio/store";
import { number, word } from "../../words";
import { List } from "./List";
import { ballShown, kindShown, kindsIn, kindWord, rowCount } from "./log";
import { Strip } from "./Strip";
import "../../style/events.css";

/** With more balls than this, one is named by its id and not chosen from a list. */
const MOST_CHOICES = 200;

export function Events() {
  const events = run.value?.events;
  if (!events) return null;
  if (events.time.length === 0) return <p class="hint">{word("noEvents")}</p>;
  return (
    <div class="events">
      <div class="filters">
        <KindFilter />
        <BallFilter />
        <output class="hint">
          {word("eventsShown", {
            shown: number(rowCount.value, 7),
            all: number(events.time.length, 7),
          })}
        </output>
      </div>
      <List />
      <Strip />
    </div>
  );
}

function KindFilter() {
  const events = run.value?.events;
  const kinds = useMemo(() => (events ? kindsIn(events) : []), [events]);
  return (
    <label>
      <span>{word("kind")}</span>
      <select
        value={kindShown.value ?? ""}
        onChange={({ currentTarget: { value } }) => {
          kindShown.value = value === "" ? null : Number(value);
        }}
      >
        <option value="">{word("allKinds")}</option>
        {kinds.map((code) => (
          <option key={code} value={code}>
            {kindWord(code)}
          </option>
        ))}
      </select>
    </label>
  );
}

function BallFilter() {
  const balls = drawing.value?.balls ?? [];
  const pick = (ball: number) => {
    ballShown.value = ball < 0 ? null : ball;
  };
  if (balls.length > MOST_CHOICES) {
    return (
      <label>
        <span>{word("ball")}</span>
        <input
          type="text"
          size={6}
          placeholder={word("allBalls")}
          onInput={({ currentTarget: { value } }) => pick(balls.findIndex(({ id }) => id === value.trim()))}
        />
      </label>
    );
  }
  return (
    <label>
      <span>{word("ball")}</span>
      <select
        value={ballShown.value ?? -1}
        onChange={({ currentTarget: { value } }) => {
          pick(Number(value));
        }}
      >
        <option value={-1}>{word("allBalls")}</option>
        {balls.map(({ id }, ball) => (
          <option key={id} value={ball}>
            {id}
          </option>
        ))}
      </select>
    </label>
  );
}
