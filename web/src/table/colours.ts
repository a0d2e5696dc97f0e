/** Colours of what is drawn on the table, light and dark. */

import type { StartingBall } from "../engine/protocol";

export interface Palette {
  cloth: string;
  cushion: string;
  nose: string;
  open: string;
  pocket: string;
  mark: string;
  ink: string;
  faint: string;
  edge: string;
  arrow: string;
  contact: string;
  bounce: string;
  spin: string;
}

export const LIGHT: Palette = {
  cloth: "#edf3ee",
  cushion: "#8a9a91",
  nose: "#3f4d46",
  open: "#9fb0a5",
  pocket: "#363c40",
  mark: "#9fb0a5",
  ink: "#22292f",
  faint: "#7a858c",
  edge: "#1d2327",
  arrow: "#22292f",
  contact: "#b3261e",
  bounce: "#1d5fa8",
  spin: "#a3219c",
};

export const DARK: Palette = {
  cloth: "#1d2b26",
  cushion: "#5d7167",
  nose: "#9fb3a8",
  open: "#5d7167",
  pocket: "#0c0f11",
  mark: "#4d6056",
  ink: "#e6ecef",
  faint: "#93a0a7",
  edge: "#0c0f11",
  arrow: "#e6ecef",
  contact: "#ff8a7f",
  bounce: "#86bdf5",
  spin: "#f49bf0",
};

/** Colours that can be told apart with the common forms of colour blindness; as in `python/carom/colours.py`. */
const BALLS = ["#c8402f", "#2b6cb0", "#e3a21a", "#1f9d7c", "#8e5bb5", "#66b7e0", "#8c5a2b", "#d377a8"];

/** A ball whose id is a colour word is drawn in that colour. */
const COLOUR_WORDS: Record<string, string> = {
  red: "#c8402f",
  blue: "#2b6cb0",
  yellow: "#edc23b",
  green: "#1f9d7c",
  orange: "#e07f24",
  purple: "#8e5bb5",
  pink: "#d377a8",
  brown: "#8c5a2b",
  black: "#2b2f33",
  white: "#fbfaf4",
  grey: "#8b939a",
  gray: "#8b939a",
  cue: "#fbfaf4",
};

/** The colour of each ball: its own, or its id where that is a colour, or else the next one that is free. */
export function ballColours(balls: { id: string; color: StartingBall["color"] }[]): string[] {
  const fixed = balls.map(({ id, color }) => (color === null ? COLOUR_WORDS[id.toLowerCase()] : css(color)));
  const left = BALLS.filter((colour) => !fixed.includes(colour));
  const free = left.length > 0 ? left : BALLS;
  let used = 0;
  return fixed.map((colour) => colour ?? (free[used++ % free.length] as string));
}

const css = (colour: string | number[]): string =>
  typeof colour === "string" ? colour : `rgb(${colour.map((part) => Math.round(255 * part)).join(" ")})`;
