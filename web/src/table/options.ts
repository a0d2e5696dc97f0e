/** What of the balls is drawn beside themselves. */

import { computed, signal } from "@preact/signals";
import { drawing } from "../studio/store";

export const options = signal({ trails: true, arrows: true, contacts: true, spin: true });

/** Arrows are as long as the way of so much time: the fastest ball of the start gets a fifth of the table. */
export const arrowSeconds = computed(() => {
  const drawn = drawing.value;
  if (!drawn) return 0;
  const speeds = drawn.balls.map(({ velocity }) => Math.hypot(...velocity));
  const fastest = speeds.reduce((most, speed) => Math.max(most, speed), 0);
  return fastest > 0 ? (0.2 * drawn.table.size) / fastest : 0.1;
});
