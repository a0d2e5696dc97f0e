/** The event log: what of it is shown, which row is the one of the moment, and how to go to another. */

import { computed, signal } from "@preact/signals";
import type { EventColumns } from "../../engine/protocol";
import { firstEventAfter, pause, run, seek, time, vocabulary } from "../../studio/store";
import { word } from "../../words";
import { en, type Word } from "../../words/en";

/** The kind and the ball of the rows that are shown, by their codes; null is all. */
export const kindShown = signal<number | null>(null);
export const ballShown = signal<number | null>(null);

/** The row that was gone to last. */
const visited = signal<number | null>(null);

/** The places in the log of the rows that are shown; null is all of them. */
const shownRows = computed<Int32Array | null>(() => {
  const [events, kind, ball] = [run.value?.events, kindShown.value, ballShown.value];
  if (!events || (kind === null && ball === null)) return null;
  const rows: number[] = [];
  for (let event = 0; event < events.time.length; event++) {
    if (kind !== null && events.kind[event] !== kind) continue;
    if (ball !== null && events.ballA[event] !== ball && events.ballB[event] !== ball) continue;
    rows.push(event);
  }
  return Int32Array.from(rows);
});

export const rowCount = computed(() => shownRows.value?.length ?? run.value?.events.time.length ?? 0);

/** The place in the log of a row. */
export const eventOf = (row: number): number => shownRows.value?.[row] ?? row;

/** The last row that has happened; −1 before the first. Of those at this very moment it is the one that was gone to. */
export const rowNow = computed<number>(() => {
  const [events, rows, gone, at] = [run.value?.events, shownRows.value, visited.value, time.value];
  if (!events) return -1;
  const isHere = gone !== null && events.time[gone] === at;
  const event = isHere ? gone : firstEventAfter(at) - 1;
  return rows ? lastUpTo(rows, event) : event;
});

export const eventNow = computed(() => (rowNow.value < 0 ? -1 : eventOf(rowNow.value)));

function lastUpTo(rows: Int32Array, event: number): number {
  let [low, high] = [0, rows.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((rows[middle] as number) > event) high = middle;
    else low = middle + 1;
  }
  return low - 1;
}

/** Goes to the moment of a row. */
export function goTo(row: number) {
  const events = run.peek()?.events;
  const event = eventOf(Math.min(Math.max(row, 0), rowCount.peek() - 1));
  const at = events?.time[event];
  if (at === undefined) return;
  pause();
  visited.value = event;
  seek(at);
}

/** The words for a kind by its code. */
export const kindWord = (code: number): string => wordOfKind(vocabulary.value?.kinds[code] ?? "");

/** The words for a kind by its name; one that has none is named as the engine does. */
export function wordOfKind(kind: string): string {
  const key = `kind_${kind}`;
  return key in en ? word(key as Word) : kind;
}

/** The kinds that occur. */
export function kindsIn({ kind }: EventColumns): number[] {
  return [...new Set(kind)].sort((a, b) => a - b);
}

/** The cushion or the pocket of an event; empty without. */
export function placeOf({ cushion, pocket, cushionIds, pocketIds }: EventColumns, event: number): string {
  return cushionIds[cushion[event] as number] ?? pocketIds[pocket[event] as number] ?? "";
}
