/** The page in a frame of another one: `?embed` leaves the table and the bar below it; the fragment names what is on it. */

import { FIRST, SCENARIOS } from "./scenarios";
import { openNamed } from "./store";

export const isEmbedded = new URLSearchParams(window.location.search).has("embed");

/** Opens the scenario that the address of a frame names; the exercise if it names none. */
export function openFramed() {
  const named = window.location.hash.slice(1);
  return openNamed(Object.hasOwn(SCENARIOS, named) ? named : FIRST);
}
