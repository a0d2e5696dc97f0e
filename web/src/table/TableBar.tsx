/** Below the table: what is drawn of the balls, what the marks mean, and the balls that are out of play. */

import { useComputed } from "@preact/signals";
import { drawing, run, time } from "../studio/store";
import { isDark } from "../studio/theme";
import { word } from "../words";
import { ballColours, DARK, LIGHT } from "./colours";
import { Dot } from "./Dot";
import { options } from "./options";
import "../style/tablebar.css";

type Option = keyof typeof options.value;

const CHOICES = [
  { option: "arrows", label: "showArrows" },
  { option: "trails", label: "showTrails" },
  { option: "contacts", label: "showContacts" },
  { option: "spin", label: "showSpin" },
  { option: "ids", label: "showIds" },
] as const;

export function TableBar() {
  const isOnCloth = drawing.value?.isOnCloth ?? false;
  return (
    <div class="tablebar">
      <fieldset class="choices">
        <legend class="unseen">{word("shown")}</legend>
        {CHOICES.filter(({ option }) => option !== "spin" || isOnCloth).map(({ option, label }) => (
          <button
            type="button"
            class="chip"
            key={option}
            aria-pressed={options.value[option]}
            onClick={() => switchOver(option)}
          >
            {word(label)}
          </button>
        ))}
      </fieldset>
      <Key isOnCloth={isOnCloth} />
      <OutOfPlay />
    </div>
  );
}

function switchOver(option: Option) {
  options.value = { ...options.peek(), [option]: !options.peek()[option] };
}

/** What the marks mean. */
function Key({ isOnCloth }: { isOnCloth: boolean }) {
  const { arrow, contact, bounce, spin } = isDark.value ? DARK : LIGHT;
  const marks = [
    { path: "M3 10H22M17 6l6 4-6 4", colour: arrow, text: "keyArrow" },
    { path: "M9 6l8 8M9 14l8-8", colour: contact, text: "keyContact" },
    { path: "M13 4v12", colour: bounce, text: "keyBounce" },
  ] as const;
  const spins = [
    { path: "M3 10h1M7 10h1M11 10h1M15 10h1M17 6l6 4-6 4", colour: spin, text: "keyRoll" },
    { path: "M5 15A9 9 0 0 1 21 13M21 8v6h-6", colour: spin, text: "keyTurn" },
    { path: "M13 6a4 4 0 1 0 .1 0", colour: bounce, text: "keyLanding" },
  ] as const;
  return (
    <details class="key">
      <summary class="chip">{word("key")}</summary>
      <ul>
        {[...marks, ...(isOnCloth ? spins : [])].map(({ path, colour, text }) => (
          <li key={text}>
            <svg viewBox="0 0 26 20" width="26" height="20" aria-hidden="true">
              <path d={path} fill="none" stroke={colour} stroke-width="2.2" stroke-linecap="round" />
            </svg>
            {word(text)}
          </li>
        ))}
      </ul>
    </details>
  );
}

/** The balls that are in pockets or off the table, in the order in which they went. */
function OutOfPlay() {
  const out = useComputed(() => ballsOut(time.value).join());
  const balls = drawing.value?.balls ?? [];
  if (out.value === "") return null;
  const colours = ballColours(balls);
  return (
    <div class="out">
      <span id="out-of-play">{word("outOfPlay")}</span>
      <ul aria-labelledby="out-of-play">
        {out.value.split(",").map((ball) => (
          <li key={ball}>
            <Dot colour={colours[Number(ball)] ?? ""} />
            {balls[Number(ball)]?.id}
          </li>
        ))}
      </ul>
    </div>
  );
}

function ballsOut(at: number): number[] {
  const film = run.value?.film;
  if (!film?.isOnCloth) return [];
  const since = (ball: number) => film.data.numbers[film.row(ball, at) * film.data.width] as number;
  const out = Array.from({ length: film.ballCount }, (_, ball) => ball).filter((ball) =>
    film.isOut(ball, at),
  );
  return out.sort((a, b) => since(a) - since(b));
}
