/** The bar below the table: play, pause, speed, and the time line with its events. */

import { useComputed } from "@preact/signals";
import { number, word } from "../words";
import { Icon } from "./Icon";
import {
  endTime,
  isPlaying,
  nextEvent,
  pause,
  previousEvent,
  progress,
  run,
  seek,
  speed,
  stopComputing,
  time,
  toggle,
} from "./store";

/** Steps of the slider for the speed: each is a tenth of a power of ten. */
const SPEEDS = { min: -30, max: 20 };

export function Transport() {
  const end = endTime.value;
  const slider = end > 0 ? Math.round((time.value / end) * 10_000) : 0;
  const values = { time: number(time.value), end: number(end) };
  return (
    <section class="transport" aria-label={word("timeline")}>
      <div class="buttons">
        <Button name="start" label={word("toStart")} onClick={() => seek(0)} />
        <Button name="previous" label={word("previousEvent")} onClick={previousEvent} />
        <Button
          name={isPlaying.value ? "pause" : "play"}
          label={word(isPlaying.value ? "pause" : "play")}
          onClick={toggle}
          isMain
        />
        <Button name="next" label={word("nextEvent")} onClick={nextEvent} />
        <Button name="end" label={word("toEnd")} onClick={() => seek(Number.POSITIVE_INFINITY)} />
      </div>
      <div class="line">
        <Ticks />
        <input
          type="range"
          min={0}
          max={10_000}
          value={slider}
          aria-label={word("timeline")}
          aria-valuetext={word("timeOf", values)}
          onInput={(event) => {
            pause();
            seek((Number(event.currentTarget.value) / 10_000) * end);
          }}
        />
      </div>
      <output class="clock">{word("timeOf", values)}</output>
      <label class="speed">
        <span>{word("speed")}</span>
        <input
          type="range"
          {...SPEEDS}
          aria-label={word("speed")}
          value={Math.round(Math.log10(speed.value) * 10)}
          aria-valuetext={word("speedOf", { speed: number(speed.value, 2) })}
          onInput={(event) => {
            speed.value = 10 ** (Number(event.currentTarget.value) / 10);
          }}
        />
        <output>×{number(speed.value, 2)}</output>
      </label>
      {progress.value && (
        <p class="progress" role="status">
          {word("computing", { events: number(progress.value.events, 3), time: number(progress.value.time) })}{" "}
          <button type="button" class="plain" onClick={stopComputing}>
            {word("cancel")}
          </button>
        </p>
      )}
    </section>
  );
}

function Button(props: { name: string; label: string; onClick: () => void; isMain?: boolean }) {
  const { name, label, onClick, isMain = false } = props;
  return (
    <button
      type="button"
      class={isMain ? "icon main" : "icon"}
      title={label}
      aria-label={label}
      onClick={onClick}
    >
      <Icon name={name} />
    </button>
  );
}

/** So many ticks at most are drawn: more could not be told apart. */
const MOST_TICKS = 400;

/** A tick for each event. */
function Ticks() {
  const path = useComputed(() => {
    const [times, end] = [run.value?.events.time, endTime.value];
    if (!times || times.length > MOST_TICKS || !(end > 0)) return "";
    return Array.from(times, (at) => `M${((at / end) * 1000).toFixed(2)} 0v8`).join("");
  });
  return (
    <svg class="ticks" viewBox="0 0 1000 8" preserveAspectRatio="none" aria-hidden="true">
      <path d={path.value} vector-effect="non-scaling-stroke" />
    </svg>
  );
}
