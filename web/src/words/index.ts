/** The words of the page in the language that is chosen. */

import { signal } from "@preact/signals";
import { remember, remembered } from "../studio/visit";
import { de, scenarios } from "./de";
import { en, type Word, type Words } from "./en";

export const LANGUAGES = { en, de } satisfies Record<string, Words>;
export type Language = keyof typeof LANGUAGES;

/** What is said of a ready-made scenario: its title, and one sentence. */
export interface Description {
  title: string;
  line: string;
}

/** The words of the ready-made scenarios, by their names; those in English stand in their files. */
export const SCENARIO_WORDS: Record<Language, Record<string, Description>> = { en: {}, de: scenarios };

const isLanguage = (code: string | null): code is Language => code !== null && code in LANGUAGES;

const saidBefore = remembered("language");
const preferred = navigator.language.slice(0, 2);

export const language = signal<Language>(
  isLanguage(saidBefore) ? saidBefore : isLanguage(preferred) ? preferred : "en",
);

export function speak(code: Language) {
  language.value = code;
  remember("language", code);
}

/** The word in the chosen language, with values put in where {braces} are. */
export function word(key: Word, values: Record<string, string | number> = {}): string {
  return LANGUAGES[language.value][key].replace(/\{(\w+)\}/g, (_, name: string) =>
    String(values[name] ?? ""),
  );
}

const formats = new Map<string, Intl.NumberFormat>();

/** A number as people read it, with so many significant digits; very small and very large ones with a power of ten. */
export function number(value: number, digits = 4): string {
  const size = Math.abs(value);
  const notation = size !== 0 && (size < 1e-4 || size >= 1e9) ? "scientific" : "standard";
  const key = language.value + notation + digits;
  let format = formats.get(key);
  if (!format) {
    format = new Intl.NumberFormat(language.value, { maximumSignificantDigits: digits, notation });
    formats.set(key, format);
  }
  return format.format(value).replace(/E(.+)$/, (_, power: string) => ` × ${powerOfTen(power)}`);
}

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A power of ten as it is written by hand. */
export const powerOfTen = (power: number | string) =>
  `10${String(power)
    .replace("-", "⁻")
    .replace(/\d/g, (digit) => RAISED.charAt(Number(digit)))}`;
