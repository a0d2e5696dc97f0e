/** The butterfly: two almost equal starts, on a regular and on a chaotic table. */

import { distance, instants } from "./instants";
import type { Course, Lesson, Outcome } from "./types";

const ONE = 0;
const TWO = 1;

/** So far apart the two have parted: a quarter of the table's height. */
const PARTED = 0.5;

/** The hit after which the two are apart. */
function parting({ main }: Course): Outcome {
  const hits = instants(main.events, ONE);
  const hit = hits.find(({ time }) => distance([main, ONE], [main, TWO], time) > PARTED);
  return { value: hit?.place ?? Number.NaN, time: hit?.time ?? main.summary.endTime };
}

/** Whether the two are still together at the end (0), or somewhat apart (1), or have parted (2). */
function atTheEnd({ main }: Course): Outcome {
  const time = main.summary.endTime;
  const apart = distance([main, ONE], [main, TWO], time);
  return { value: apart > PARTED ? 2 : apart > PARTED / 100 ? 1 : 0, time };
}

export const butterfly: Lesson = {
  id: "butterfly",
  title: "butterflyTitle",
  line: "butterflyLine",
  summary: ["butterflySummary1", "butterflySummary2", "butterflySummary3"],
  parts: [
    {
      title: "butterflyPart1",
      intro: "butterflyIntro1",
      scenario: "stadium",
      values: { table: { shape: "circle", radius: 1 }, collisions: 60 },
      speed: 4,
      pauses: 3,
      watched: ONE,
      explanation: "distance",
      question: {
        kind: "choice",
        text: "butterflyQuestion1",
        choices: ["butterflyTogether", "butterflySomewhat", "butterflyParted"],
        answer: atTheEnd,
      },
      takeaway: "butterflyTakeaway1",
    },
    {
      title: "butterflyPart2",
      intro: "butterflyIntro2",
      scenario: "stadium",
      values: { collisions: 60 },
      speed: 4,
      pauses: 5,
      watched: ONE,
      explanation: "distance",
      question: {
        kind: "number",
        text: "butterflyQuestion2",
        unit: "unitHits",
        tolerance: 0.15,
        answer: parting,
      },
      takeaway: "butterflyTakeaway2",
    },
    {
      title: "butterflyPart3",
      intro: "butterflyIntro3",
      scenario: "stadium",
      values: { "balls.two.direction_deg": 50.000000001, collisions: 60 },
      speed: 4,
      pauses: 3,
      watched: ONE,
      explanation: "distance",
      question: {
        kind: "number",
        text: "butterflyQuestion3",
        unit: "unitHits",
        tolerance: 0.15,
        answer: parting,
      },
      takeaway: "butterflyTakeaway3",
    },
  ],
};
