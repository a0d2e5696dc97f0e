/** Tables as CSV, with the columns, words and digits that Python's `to_csv` writes. */

import type { Moment } from "../../engine/film";
import type { EventColumns } from "../../engine/protocol";
import type { Shown } from "../../studio/store";

/** A number with 17 significant digits, which read back to the same bits; as C and Python write `%.17g`. */
export function exact(value: number): string {
  if (Number.isNaN(value)) return "nan";
  if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
  if (value === 0) return Object.is(value, -0) ? "-0" : "0";
  const [mantissa, exponent] = halfToEven(value).split("e") as [string, string];
  const digits = mantissa.replace("-", "").replace(".", "").replace(/0+$/, "");
  return (value < 0 ? "-" : "") + placed(digits, Number(exponent));
}

/** The same in the form 1.2e+3; of two that are equally near, the one whose last digit is even, as C has it. */
function halfToEven(value: number): string {
  const text = value.toExponential(16);
  const longer = value.toExponential(60).split("e")[0] as string;
  const isHalf = /^50*$/.test(longer.replace("-", "").slice(18));
  if (!isHalf) return text;
  const down = longer.slice(0, longer.startsWith("-") ? 19 : 18);
  return Number(down.at(-1)) % 2 === 0 ? `${down}e${text.split("e")[1]}` : text;
}

function placed(digits: string, exponent: number): string {
  if (exponent < -4 || exponent >= 17) {
    const mantissa = digits.length > 1 ? `${digits[0]}.${digits.slice(1)}` : digits;
    return `${mantissa}e${exponent < 0 ? "-" : "+"}${String(Math.abs(exponent)).padStart(2, "0")}`;
  }
  if (exponent < 0) return `0.${"0".repeat(-exponent - 1)}${digits}`;
  const whole = digits.slice(0, exponent + 1).padEnd(exponent + 1, "0");
  const rest = digits.slice(exponent + 1);
  return rest === "" ? whole : `${whole}.${rest}`;
}

/** A field, in quotes where it needs them. */
const field = (text: string) => (/[",\r\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);

const line = (fields: string[]) => `${fields.join(",")}\n`;

const EVENT_COLUMNS = [
  "index",
  "time",
  "kind",
  "ball_a",
  "ball_b",
  "cushion",
  "x",
  "y",
  "normal_x",
  "normal_y",
  "closing_speed",
  "impulse",
  "cluster",
  "pocket",
];

/** The events of a run; `kinds` are the words of their kinds. The text comes in parts. */
export function* eventsCsv({ events, summary: { ballIds } }: Shown, kinds: string[]): Generator<string> {
  yield line(EVENT_COLUMNS);
  const word = (words: string[], code: number | undefined) => field(words[code ?? -1] ?? "");
  for (let row = 0; row < events.time.length; row++) {
    const number = (name: keyof EventColumns) => exact((events[name] as Float64Array)[row] as number);
    const cluster = events.cluster[row] as number;
    yield line([
      String(row),
      number("time"),
      word(kinds, events.kind[row]),
      word(ballIds, events.ballA[row]),
      word(ballIds, events.ballB[row]),
      word(events.cushionIds, events.cushion[row]),
      ...(["x", "y", "normalX", "normalY", "closingSpeed", "impulse"] as const).map(number),
      cluster < 0 ? "" : String(cluster),
      word(events.pocketIds, events.pocket[row]),
    ]);
  }
}

const DISC = ["x", "y", "vx", "vy"] as const;
const SPHERE = ["x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"] as const;

/** The motion of all balls at so many times from the start to the end; `motions` are the words of how they move. */
export function* trajectoryCsv(shown: Shown, samples: number, motions: string[]): Generator<string> {
  const { film, summary } = shown;
  const names = film.isOnCloth ? [...SPHERE, "motion"] : DISC;
  yield line(["time", ...summary.ballIds.flatMap((id) => names.map((name) => field(`${id}.${name}`)))]);
  let balls: Moment | undefined;
  for (const time of sampleTimes(samples, summary.endTime)) {
    const moment = film.at(time, balls);
    balls = moment;
    const texts = summary.ballIds.flatMap((_, ball) => {
      const numbers = numbersOf(shown, moment, ball);
      return film.isOnCloth ? [...numbers, motions[film.motion(ball, time)] ?? ""] : numbers;
    });
    yield line([exact(time), ...texts]);
  }
}

/** The numbers of a ball; of one that is out of play there are none. */
function numbersOf({ film }: Shown, moment: Moment, ball: number): string[] {
  const numbers = (film.isOnCloth ? SPHERE : DISC).map((name) => moment[name][ball] as number);
  if (Number.isNaN(numbers[0])) return numbers.map(() => exact(Number.NaN));
  return numbers.map(exact);
}

/** As NumPy's `linspace` has them. */
function sampleTimes(samples: number, end: number): number[] {
  const step = end / Math.max(samples - 1, 1);
  return Array.from({ length: samples }, (_, k) => (k > 0 && k === samples - 1 ? end : k * step));
}
