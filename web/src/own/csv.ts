/** Tables of numbers in text: comma, semicolon, tab or white space between the columns; with a header or without. */

import type { Word } from "../words/en";

/** What was not understood, and where: as words to be put in. */
export interface Misreading {
  line?: number;
  column?: string;
  key: Word;
  values?: Record<string, string | number>;
}

/** The lines of a table, before it is known what its columns are. */
export interface Lines {
  /** The names of the columns; of a table without a header their numbers from 1. */
  names: string[];
  hasHeader: boolean;
  delimiter: string;
  /** The lines below the header that are not empty, with their numbers in the file. */
  rows: { line: number; text: string }[];
}

export const MOST_ROWS = 200_000;
const MOST_LISTED = 5;

const NUMBER = /^[+-]?((\d+\.?\d*|\.\d+)(e[+-]?\d+)?|nan|inf|infinity)$/i;
/** A first line by which a program is told the delimiter. */
const SEPARATOR = /^sep=(.)$/i;

/** Finds header and rows; null where there is nothing but comments. */
export function linesOf(text: string): Lines | null {
  const lines = text.split(/\r\n|\n|\r/).map((line, k) => ({ line: k + 1, text: line }));
  const told = SEPARATOR.exec(lines[0]?.text ?? "")?.[1];
  const rest = lines.slice(told ? 1 : 0).filter((line) => line.text.trim() !== "");
  const top = rest.findIndex((line) => !/^\s*[#%]/.test(line.text));
  const first = rest[top];
  if (!first) return null;
  const delimiter = told ?? delimiterOf(first.text);
  const fields = split(first.text, delimiter);
  const hasHeader = !fields.every((field) => NUMBER.test(pointed(field, delimiter)));
  return {
    names: hasHeader ? fields : fields.map((_, k) => String(k + 1)),
    hasHeader,
    delimiter,
    rows: rest.slice(hasHeader ? top + 1 : top),
  };
}

const delimiterOf = (line: string): string => [";", "\t", ","].find((mark) => line.includes(mark)) ?? " ";

/** The fields of a line, without quotes and white space around them. */
export function split(line: string, delimiter: string): string[] {
  if (delimiter === " ") return line.trim().split(/\s+/).map(unquoted);
  const fields: string[] = [];
  let [start, isQuoted] = [0, false];
  for (let at = 0; at <= line.length; at++) {
    if (line[at] === '"') isQuoted = !isQuoted;
    if (at < line.length && (isQuoted || line[at] !== delimiter)) continue;
    fields.push(unquoted(line.slice(start, at).trim()));
    start = at + 1;
  }
  return fields;
}

const unquoted = (field: string) => (/^".*"$/s.test(field) ? field.slice(1, -1).replace(/""/g, '"') : field);

/** A number as it is written with a decimal point. */
const pointed = (field: string, delimiter: string) => (delimiter === "," ? field : field.replace(",", "."));

/** The numbers of some columns, one array for each; and what of them is not understood. */
export function numbersOf(
  { names, hasHeader, delimiter, rows }: Lines,
  columns: number[],
): { numbers: Float64Array[]; misreadings: Misreading[] } {
  const numbers = columns.map(() => new Float64Array(rows.length));
  const misreadings: Misreading[] = [];
  let more = 0;
  const note = (misreading: Misreading) => {
    if (misreadings.length < MOST_LISTED) misreadings.push(misreading);
    else more++;
  };
  for (const [row, { line, text }] of rows.entries()) {
    const fields = split(text, delimiter);
    if (fields.length !== names.length) {
      note(wrongWidth(line, fields.length, names.length));
      continue;
    }
    columns.forEach((column, k) => {
      const field = pointed(fields[column] as string, delimiter);
      (numbers[k] as Float64Array)[row] = numberOf(field);
      const name = hasHeader ? (names[column] as string) : String(column + 1);
      if (!NUMBER.test(field)) note({ line, column: name, ...noNumber(fields[column] as string) });
    });
  }
  if (more > 0) misreadings.push({ key: "ownMore", values: { count: more } });
  return { numbers, misreadings };
}

const numberOf = (field: string) =>
  /n/i.test(field) ? (/nan/i.test(field) ? Number.NaN : Number.POSITIVE_INFINITY) : Number(field);

const noNumber = (text: string): Pick<Misreading, "key" | "values"> =>
  text === "" ? { key: "ownEmptyField" } : { key: "ownNoNumber", values: { text: text.slice(0, 40) } };

const wrongWidth = (line: number, found: number, wanted: number): Misreading => ({
  line,
  key: found === 2 * wanted ? "ownDecimalCommas" : "ownWidth",
  values: { found, wanted },
});
