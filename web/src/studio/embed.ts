/** The page in a frame of another one: `?embed` leaves the table and the bar below it; the fragment says what is on it. */

import { openFragment } from "../sharing/address";
import { FIRST } from "./scenarios";
import { openNamed } from "./store";

export const isEmbedded = new URLSearchParams(window.location.search).has("embed");

/** Opens the scenario that the address of a frame names or holds; the exercise if it does neither. */
export async function openFramed() {
  const isOpen = await openFragment(window.location.hash.slice(1));
  if (!isOpen) await openNamed(FIRST);
}
