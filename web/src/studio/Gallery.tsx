/** The start page: the exercise first, then the lessons, then the ready-made scenarios in groups. */

import { lessons } from "../lessons";
import { openLesson } from "../lessons/state";
import { FileButton } from "../panels/files/Bring";
import { word } from "../words";
import type { Word } from "../words/en";
import { Messages } from "./App";
import { described } from "./describe";
import { Icon } from "./Icon";
import { FIRST, SCENARIOS } from "./scenarios";
import { openNamed } from "./store";
import { Thumbnail } from "./Thumbnail";

const GROUPS: { title: Word; names: string[] }[] = [
  {
    title: "groupCollisions",
    names: [
      "midterm_stepped",
      "head_on_unequal",
      "one_into_two",
      "newtons_cradle",
      "counting_pi",
      "triangle_break",
      "damped_drop",
      "tilted",
    ],
  },
  {
    title: "groupCue",
    names: [
      "eight_ball_break",
      "nine_ball_break",
      "snooker_break",
      "two_ball_shot",
      "three_cushion",
      "masse",
      "jump_shot",
    ],
  },
  { title: "groupChaos", names: ["circle", "stadium", "sinai", "mushroom", "l_shape", "pinball"] },
  { title: "groupGases", names: ["fifty_random", "equal_speeds", "gas", "u_divider"] },
];

/** The groups of those that there are; a scenario that none names stands in the last one. */
function groups(names: string[]): { title: Word; names: string[] }[] {
  const placed = new Set([FIRST, ...GROUPS.flatMap((group) => group.names)]);
  const rest = { title: "groupMore" as const, names: names.filter((name) => !placed.has(name)) };
  const known = new Set(names);
  return [...GROUPS, rest]
    .map((group) => ({ ...group, names: group.names.filter((name) => known.has(name)) }))
    .filter((group) => group.names.length > 0);
}

export function Gallery() {
  return (
    <main class="gallery">
      <Messages />
      <First />
      <section aria-labelledby="lessons">
        <h2 id="lessons">{word("lessons")}</h2>
        <p class="lead">{word("lessonsLead")}</p>
        <ul class="lessons">
          {lessons.map((lesson, k) => (
            <li key={lesson.id}>
              <button
                type="button"
                class="card lesson-card"
                data-lesson={lesson.id}
                onClick={() => openLesson(lesson)}
              >
                <span class="numeral" aria-hidden="true">
                  {k + 1}
                </span>
                <span class="card-title">{word(lesson.title)}</span>
                <span class="card-line">{word(lesson.line)}</span>
              </button>
            </li>
          ))}
        </ul>
      </section>
      {groups(Object.keys(SCENARIOS)).map(({ title, names }) => (
        <section key={title} aria-labelledby={title}>
          <h2 id={title}>{word(title)}</h2>
          <ul class="cards">
            {names.map((name) => (
              <li key={name}>
                <Card name={name} />
              </li>
            ))}
          </ul>
        </section>
      ))}
      <p class="bring">
        <FileButton /> {word("dropHint")}
      </p>
      <p class="colophon">{word("colophon")}</p>
    </main>
  );
}

/** The exercise, large: what a first visitor should press. */
function First() {
  const { title, line } = described(FIRST);
  return (
    <section class="first" aria-labelledby="first">
      <p class="tagline">{word("tagline")}</p>
      <div class="first-text">
        <p class="kicker">{word("startHere")}</p>
        <h2 id="first">{title}</h2>
        <p>{line}</p>
        <button type="button" class="primary large" data-scenario={FIRST} onClick={() => openNamed(FIRST)}>
          <Icon name="play" /> {word("openTable")}
        </button>
        <p class="hint">{word("startHint")}</p>
      </div>
      <Thumbnail name={FIRST} />
    </section>
  );
}

function Card({ name }: { name: string }) {
  const { title, line } = described(name);
  return (
    <button type="button" class="card" data-scenario={name} onClick={() => openNamed(name)}>
      <Thumbnail name={name} />
      <span class="card-title">{title}</span>
      <span class="card-line">{line}</span>
    </button>
  );
}
