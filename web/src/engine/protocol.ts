/** What the page asks of the worker that computes, and what it is told. */

/** A line or an arc of a table, in the table's lengths and in degrees. */
export type Piece = { id: string; part: "boundary" | "obstacle" | "periodic" } & (
  | { kind: "line"; start: Point; end: Point }
  | { kind: "arc"; center: Point; radius: number; from_deg: number; to_deg: number }
);

export type Point = [number, number];

/** What there is to draw of a table. */
export interface Outline {
  size: number;
  bounds: [number, number, number, number];
  pieces: Piece[];
  pockets: { id: string; center: Point; radius: number }[];
}

/** A ball at the start, before a cue strikes; vectors have two components, on a cloth three. */
export interface StartingBall {
  id: string;
  radius: number;
  mass: number;
  position: number[];
  velocity: number[];
  spin?: number[];
  /** As it is written: a CSS name, a hexadecimal colour, or red, green and blue from 0 to 1. */
  color: string | number[] | null;
}

/** A cue, and the shot it makes, if there is one; see `crates/carom/src/scenario/outline.rs`. */
export interface CueDrawn {
  tip_radius: number;
  /** The offset of the contact, over the ball's radius, up to which the tip holds. */
  miscue_offset: number;
  length: number;
  shaft_radius: number;
  butt_radius: number;
  shot: {
    ball: number;
    speed: number;
    direction: Point;
    /** Cosine and sine. */
    elevation: [number, number];
    /** Offsets of the contact over the ball's radius, and what those that are written are taken times. */
    left: number;
    top: number;
    offset_scale: number;
  } | null;
}

/** Something that the stick meets, and the elevation from which it clears that, if any. */
export interface Obstruction {
  kind: "ball" | "cushion" | "cloth";
  id: string | null;
  clear_from_deg: number | null;
}

/** What there is to draw of a scenario. */
export interface Drawing {
  table: Outline;
  balls: StartingBall[];
  /** Null where there is no cloth. */
  cue: CueDrawn | null;
  units: Record<string, string>;
  isOnCloth: boolean;
}

/** A scenario that the engine has found right: what is written of it, as JSON text, and what there is to draw. */
export interface Checked {
  json: string;
  drawing: Drawing;
}

/** One thing that is wrong, and where. */
export interface Problem {
  place: string;
  message: string;
}

/** The course of each ball as rows of numbers; see `crates/carom/src/run/film.rs`. */
export interface FilmData {
  width: number;
  firstRows: Uint32Array;
  numbers: Float64Array;
}

/** The events of a run as columns; balls, cushions, pockets and kinds are codes, −1 is none. */
export interface EventColumns {
  time: Float64Array;
  kind: Int32Array;
  ballA: Int32Array;
  ballB: Int32Array;
  cushion: Int32Array;
  pocket: Int32Array;
  x: Float64Array;
  y: Float64Array;
  normalX: Float64Array;
  normalY: Float64Array;
  closingSpeed: Float64Array;
  impulse: Float64Array;
  cluster: Int32Array;
  cushionIds: string[];
  pocketIds: string[];
}

/** How a run ended, and what it found out about itself. */
export interface Summary {
  status: string;
  endTime: number;
  /** Null where a number in the final state is none. */
  digest: string | null;
  ballIds: string[];
  diagnostics: Record<string, unknown> & { events: Record<string, number> };
  references: unknown[];
}

/** A run, or as much of it as there is. */
export interface RunData {
  summary: Summary;
  film: FilmData;
  events: EventColumns;
  /** Why the run was broken off before its end; null where it was not. */
  cutBy: CutBy | null;
}

/** Why a run was broken off: it has too many events, takes too much memory or time, or the user wanted no more. */
export type CutBy = "events" | "memory" | "time" | "user";

/** The words and numbers that the page and the engine have in common. */
export interface Vocabulary {
  version: string;
  physics_version: number;
  kinds: string[];
  motions: string[];
  presets: [string, string][];
}

/** Runs that are kept in the worker, by what they are for. */
export type Slot = "main" | "stepped" | "twin" | "aim" | "lesson" | "picture";

/** Values of a scenario by their paths, such as `balls.red.speed`. */
export type Values = Record<string, unknown>;

/** The questions: what is handed over, and what comes back. */
export interface Questions {
  vocabulary: { asked: Record<never, never>; answer: Vocabulary };
  schema: { asked: Record<never, never>; answer: Record<string, unknown> };
  check: { asked: { text: string; format: "toml" | "json"; values?: Values }; answer: Checked };
  expanded: { asked: { json: string }; answer: Checked };
  toml: { asked: { json: string }; answer: string };
  run: { asked: { slot: Slot; json: string; until?: string; mostEvents: number }; answer: RunData };
  cancel: { asked: { slot: Slot }; answer: null };
  /** Ends a run where it is; what there is of it is its answer. */
  stop: { asked: { slot: Slot }; answer: null };
  totals: { asked: { slot: Slot; times: Float64Array }; answer: Float64Array };
  obstructions: { asked: { json: string }; answer: Obstruction[] };
  finalScenario: { asked: { slot: Slot }; answer: string };
  runJson: { asked: { slot: Slot }; answer: string };
}

export type Question = keyof Questions;

export type Request = {
  [Q in Question]: { id: number; question: Q; asked: Questions[Q]["asked"] };
}[Question];

export type Reply =
  | { id: number; answer: unknown }
  | { id: number; problems: Problem[] }
  /** So many balls are more than the page shows. */
  | { id: number; tooManyBalls: number }
  /** The engine broke down, as for want of memory. */
  | { id: number; isBroken: true }
  /** The engine is loaded. */
  | { isReady: true }
  /** What there is of a run that still goes on. */
  | { id: number; part: RunData }
  /** A sign of life, with how far a run has come. */
  | { id: number; time: number; events: number }
  | { id: number; isAlive: true };
