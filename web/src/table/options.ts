/** What of the balls is drawn beside themselves. */

import { computed, signal } from "@preact/signals";
import type { Film } from "../engine/film";
import { drawing, run } from "../studio/store";

export const options = signal({ trails: true, arrows: true, contacts: true, spin: true, ids: true });

/** Whether the table shows what would come of a stroke in place of how the balls move. */
export const isAhead = signal(false);

/** Arrows are as long as the way of so much time: the fastest ball gets this share of the table. */
export const LONGEST_ARROW = 0.2;
/** So long, in parts of the table's size, the longest arrow may become or remain before the scale is another one. */
const [TOO_SHORT, TOO_LONG] = [0.05, 0.6];

let kept = 0;

/**
 * The time whose way arrows show: by the fastest ball of the start, or of the run where none moves at the start. While speeds
 * are changed the scale stays as long as it suits, so that an arrow keeps the length that it was dragged to.
 */
export const arrowSeconds = computed(() => {
  const drawn = drawing.value;
  if (!drawn) return 0;
  const { size } = drawn.table;
  const speeds = drawn.balls.map(({ velocity }) => Math.hypot(...velocity));
  const atStart = speeds.reduce((most, speed) => Math.max(most, speed), 0);
  const film = run.value?.film;
  const fastest = atStart > 0 || !film ? atStart : fastestOf(film);
  const longest = (fastest * kept) / size;
  if (fastest > 0 && !(longest >= TOO_SHORT && longest <= TOO_LONG)) kept = (LONGEST_ARROW * size) / fastest;
  return kept || 0.1;
});

function fastestOf({ data: { numbers, width }, isOnCloth }: Film): number {
  const v = isOnCloth ? 4 : 3;
  let most = 0;
  for (let row = 0; row < numbers.length; row += width) {
    const speed = Math.hypot(numbers[row + v] as number, numbers[row + v + 1] as number);
    if (speed > most) most = speed;
  }
  return most;
}
