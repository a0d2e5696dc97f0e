/** Counting π by collisions. */

import type { Word } from "../words/en";
import { instants } from "./instants";
import type { Lesson, Part } from "./types";

interface Words {
  title: Word;
  intro: Word;
  question: Word;
  takeaway: Word;
}

/** The number of collisions for a mass of the heavy ball. */
const counted = (mass: number, { title, intro, question, takeaway }: Words, how: Partial<Part>): Part => ({
  title,
  intro,
  scenario: "counting_pi",
  values: { "balls.heavy.mass": mass },
  speed: 0.5,
  explanation: "velocity",
  question: {
    kind: "number",
    text: question,
    unit: "unitCollisions",
    tolerance: 0,
    answer: ({ main: { events } }) => {
      const all = instants(events);
      return { value: all.length, time: all.at(-1)?.time ?? 0 };
    },
  },
  takeaway,
  ...how,
});

export const pi: Lesson = {
  id: "pi",
  title: "piTitle",
  line: "piLine",
  summary: ["piSummary1", "piSummary2", "piSummary3"],
  parts: [
    counted(
      1,
      { title: "piPart1", intro: "piIntro1", question: "piQuestion1", takeaway: "piTakeaway1" },
      { speed: 0.8 },
    ),
    counted(
      100,
      { title: "piPart2", intro: "piIntro2", question: "piQuestion2", takeaway: "piTakeaway2" },
      { speed: 0.4, pauses: 5 },
    ),
    counted(
      10_000,
      { title: "piPart3", intro: "piIntro3", question: "piQuestion3", takeaway: "piTakeaway3" },
      { speed: 0.7, pauses: 3 },
    ),
  ],
};
