/** What a lesson is made of. A lesson is data: words, scenarios, and what to ask of their runs. */

import type { Drawing, Values } from "../engine/protocol";
import type { Shown } from "../studio/store";
import type { Word } from "../words/en";

export interface Lesson {
  id: string;
  title: Word;
  /** One sentence for the gallery. */
  line: Word;
  parts: Part[];
  /** What is to be remembered, told at the end. */
  summary: Word[];
}

/** One table, and one question about it. */
export interface Part {
  title: Word;
  intro: Word;
  /** A ready-made scenario, and what is different about it here. */
  scenario: string;
  values?: Values;
  /** A second run that is drawn over the first. */
  other?: { values: Values; name: Word };
  /** Table time for each second. */
  speed: number;
  /** So many collisions at most are explained one by one while it plays; absent: all. */
  pauses?: number;
  /** Only the collisions of this ball are explained. */
  watched?: number;
  explanation: Explanation;
  question: Question;
  /** What there is to see in the answer. */
  takeaway: Word;
}

/** What is told of each collision. */
export type Explanation = "momentum" | "velocity" | "delay" | "distance";

/** The runs of a part. */
export interface Course {
  drawing: Drawing;
  main: Shown;
  other: Shown | null;
  /** The run of the part's scenario with other values. */
  runOf: (values: Values) => Promise<Shown>;
}

/** The answer that the run gives, and the time from which on it can be seen. */
export interface Outcome {
  value: number;
  time: number;
}

/** A prediction is a number: of the unit, of the choice in its list, or of degrees. */
export type Question = {
  text: Word;
  answer: (course: Course) => Outcome | Promise<Outcome>;
} & (
  | {
      kind: "number";
      unit: Word /** So far off a prediction is still good, as a share. */;
      tolerance: number;
    }
  | { kind: "choice"; choices: Word[] }
  | { kind: "direction" /** The ball whose direction is drawn. */; ball: number }
);

/** A drawn direction is good within so many degrees. */
const GOOD_DIRECTION = 5;

/** Whether a prediction is as good as can be asked. */
export function isGood(question: Question, prediction: number, value: number): boolean {
  if (question.kind === "choice") return prediction === value;
  if (question.kind === "number") return Math.abs(prediction - value) <= question.tolerance * Math.abs(value);
  const apart = Math.abs(prediction - value) % 360;
  return Math.min(apart, 360 - apart) <= GOOD_DIRECTION;
}
