/** Numbers and vectors of lessons as people read them. */

import { number } from "../words";

/** Smaller ones are written with a power of ten. */
const SMALL = 1e-3;
const SUPERSCRIPTS: Record<string, string> = {
  "-": "⁻",
  ...Object.fromEntries([..."⁰¹²³⁴⁵⁶⁷⁸⁹"].map((sign, digit) => [digit, sign])),
};

/** A number; a small one as 1.3 × 10⁻⁵. */
export function small(value: number, digits = 3): string {
  if (value === 0 || Math.abs(value) >= SMALL) return number(value, digits);
  const power = Math.floor(Math.log10(Math.abs(value)));
  return `${number(value / 10 ** power, digits)} × ${powerOfTen(power)}`;
}

export const powerOfTen = (power: number) =>
  `10${[...String(power)].map((sign) => SUPERSCRIPTS[sign]).join("")}`;

/** What is smaller than this share of its fellows is a rounding error, and shown as zero. */
const NOTHING = 1e-12;

/** The components that a table shows: one, or two in brackets. */
export function vector([x, y]: readonly [number, number], isAlongX: boolean, scale: number): string {
  const digits = isAlongX ? 4 : 3;
  const shown = (value: number) => signed(Math.abs(value) < NOTHING * scale ? 0 : value, digits);
  return isAlongX ? shown(x) : `(${shown(x)}; ${shown(y)})`;
}

/** With a minus sign as long as a plus. */
export const signed = (value: number, digits = 4) => number(value, digits).replace("-", "−");
