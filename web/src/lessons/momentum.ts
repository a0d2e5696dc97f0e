/** Momentum in one and in two dimensions. */

import { instants, isOfTwoBalls, justBefore } from "./instants";
import type { Course, Lesson, Outcome } from "./types";

const HEAVY = 1;
const UPPER = 1;
const BLUE = 1;

/** The first time that two balls meet. */
function meeting({ main: { events } }: Course): number {
  return instants(events).find(({ first }) => isOfTwoBalls(events, first))?.time ?? Number.NaN;
}

/** In which direction a ball leaves the first meeting, in degrees. */
function leaves(course: Course, ball: number): Outcome {
  const time = meeting(course);
  const { vx, vy } = course.main.film.at(time);
  return { value: (Math.atan2(vy[ball] as number, vx[ball] as number) * 180) / Math.PI, time };
}

/** Slower than this share of its speed a ball stands still. */
const STILL = 1e-9;

/** Whether a ball goes on (0), stops (1) or turns back (2) at the first meeting. */
function goesOn(course: Course, ball: number): Outcome {
  const time = meeting(course);
  const before = course.main.film.at(justBefore(time)).vx[ball] as number;
  const share = (course.main.film.at(time).vx[ball] as number) / before;
  return { value: Math.abs(share) < STILL ? 1 : share > 0 ? 0 : 2, time };
}

export const momentum: Lesson = {
  id: "momentum",
  title: "momentumTitle",
  line: "momentumLine",
  summary: ["momentumSummary1", "momentumSummary2", "momentumSummary3"],
  parts: [
    {
      title: "momentumPart1",
      intro: "momentumIntro1",
      scenario: "head_on_unequal",
      speed: 0.5,
      explanation: "momentum",
      question: {
        kind: "choice",
        text: "momentumQuestion1",
        choices: ["momentumGoesOn", "momentumStops", "momentumTurns"],
        answer: (course) => goesOn(course, HEAVY),
      },
      takeaway: "momentumTakeaway1",
    },
    {
      title: "momentumPart2",
      intro: "momentumIntro2",
      scenario: "one_into_two",
      speed: 0.5,
      explanation: "momentum",
      question: {
        kind: "direction",
        text: "momentumQuestion2",
        ball: UPPER,
        answer: (course) => leaves(course, UPPER),
      },
      takeaway: "momentumTakeaway2",
    },
    {
      title: "momentumPart3",
      intro: "momentumIntro3",
      scenario: "midterm",
      speed: 0.3,
      explanation: "momentum",
      question: {
        kind: "direction",
        text: "momentumQuestion3",
        ball: BLUE,
        answer: (course) => leaves(course, BLUE),
      },
      takeaway: "momentumTakeaway3",
    },
  ],
};
