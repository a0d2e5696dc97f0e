/** The words of the page in the language that is chosen. */

import { signal } from "@preact/signals";
import { de } from "./de";
import { en, type Word, type Words } from "./en";

export const LANGUAGES = { en, de } satisfies Record<string, Words>;
export type Language = keyof typeof LANGUAGES;

export const language = signal<Language>(navigator.language.startsWith("de") ? "de" : "en");

/** The word in the chosen language, with values put in where {braces} are. */
export function word(key: Word, values: Record<string, string | number> = {}): string {
  return LANGUAGES[language.value][key].replace(/\{(\w+)\}/g, (_, name: string) =>
    String(values[name] ?? ""),
  );
}

/** A number as people read it, with so many significant digits; very small and very large ones with a power of ten. */
export function number(value: number, digits = 4): string {
  const size = Math.abs(value);
  const notation = size !== 0 && (size < 1e-4 || size >= 1e9) ? "scientific" : "standard";
  return new Intl.NumberFormat(language.value, { maximumSignificantDigits: digits, notation }).format(value);
}
