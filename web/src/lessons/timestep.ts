/** What a time step costs: the exercise in steps, over the exact run. */

import type { Shown } from "../studio/store";
import { distance, instants, isOfTwoBalls } from "./instants";
import type { Course, Lesson } from "./types";

const RED = 0;
const BLUE = 1;
const COARSE = 0.03;
const FINE = 0.003;

const inSteps = (dt: number) => ({ method: { kind: "stepped", dt } });

function meeting({ events }: Shown): number {
  return instants(events).find(({ first }) => isOfTwoBalls(events, first))?.time ?? Number.NaN;
}

function apartAtTheEnd({ main }: Course, stepped: Shown | null): number {
  return stepped ? distance([main, BLUE], [stepped, BLUE], main.summary.endTime) : Number.NaN;
}

export const timestep: Lesson = {
  id: "timestep",
  title: "timestepTitle",
  line: "timestepLine",
  summary: ["timestepSummary1", "timestepSummary2", "timestepSummary3"],
  parts: [
    {
      title: "timestepPart1",
      intro: "timestepIntro1",
      scenario: "midterm",
      other: { values: inSteps(COARSE), name: "lessonInSteps" },
      speed: 0.4,
      explanation: "delay",
      watched: RED,
      question: {
        kind: "choice",
        text: "timestepQuestion1",
        choices: ["timestepEarlier", "timestepSame", "timestepLater"],
        answer: ({ main, other }) => {
          const [exact, stepped] = [meeting(main), other ? meeting(other) : Number.NaN];
          return { value: Math.sign(stepped - exact) + 1, time: Math.max(exact, stepped) };
        },
      },
      takeaway: "timestepTakeaway1",
    },
    {
      title: "timestepPart2",
      intro: "timestepIntro2",
      scenario: "midterm",
      other: { values: inSteps(COARSE), name: "lessonInSteps" },
      speed: 0.6,
      explanation: "delay",
      watched: BLUE,
      question: {
        kind: "number",
        text: "timestepQuestion2",
        unit: "unitTableWidths",
        tolerance: 0.25,
        answer: (course) => ({
          value: apartAtTheEnd(course, course.other),
          time: course.main.summary.endTime,
        }),
      },
      takeaway: "timestepTakeaway2",
    },
    {
      title: "timestepPart3",
      intro: "timestepIntro3",
      scenario: "midterm",
      other: { values: inSteps(FINE), name: "lessonInSteps" },
      speed: 0.6,
      explanation: "delay",
      watched: BLUE,
      question: {
        kind: "choice",
        text: "timestepQuestion3",
        choices: ["timestepNoGain", "timestepTenfold", "timestepHundredfold"],
        answer: async (course) => {
          const coarse = apartAtTheEnd(course, await course.runOf(inSteps(COARSE)));
          const gain = coarse / apartAtTheEnd(course, course.other);
          return { value: nearestPower(gain, 2), time: course.main.summary.endTime };
        },
      },
      takeaway: "timestepTakeaway3",
    },
  ],
};

/** Which of 1, 10, 100 … is nearest, on a scale of powers. */
const nearestPower = (factor: number, most: number) =>
  Math.min(Math.max(Math.round(Math.log10(factor)), 0), most);
