/** A stroke of the cue: its numbers, whichever of the two words for each the scenario is written in. */

import type { Drawing } from "../../engine/protocol";

export interface Stroke {
  /** The id of the ball that is struck. */
  ball: string;
  speed: number;
  /** In degrees from the x axis towards the y axis, as seen from above. */
  direction: number;
  elevation: number;
  /** Offsets from the middle of the ball over its radius, as the shooter sees it. */
  left: number;
  top: number;
}

/** A shot as it is written. */
export type Shot = Record<string, unknown>;

type Quantity = Exclude<keyof Stroke, "ball">;

const WORDS: Record<Quantity, [string, string]> = {
  speed: ["V0", "cue_speed"],
  direction: ["phi_deg", "direction_deg"],
  elevation: ["theta_deg", "elevation_deg"],
  left: ["a", "left"],
  top: ["b", "top"],
};
const QUANTITIES = Object.keys(WORDS) as Quantity[];
const NEEDED: Quantity[] = ["speed", "direction"];

export function strokeOf(shot: Shot): Stroke {
  const given = (quantity: Quantity) => Number(WORDS[quantity].map((key) => shot[key]).find(isThere) ?? 0);
  return {
    ball: String(shot["cue_ball"] ?? "cue"),
    speed: given("speed"),
    direction: given("direction"),
    elevation: given("elevation"),
    left: given("left"),
    top: given("top"),
  };
}

const isThere = (value: unknown) => value !== undefined;

/** A stroke as it is written in the words of another shot, or in plain ones. */
export function shotOf(stroke: Stroke, like: Shot): Shot {
  const shot: Shot = { ...like };
  const style = "V0" in like ? 0 : 1;
  for (const quantity of QUANTITIES) {
    const key = WORDS[quantity].find((word) => word in like) ?? (WORDS[quantity][style] as string);
    if (key in like || stroke[quantity] !== 0 || NEEDED.includes(quantity)) shot[key] = stroke[quantity];
  }
  if (stroke.ball === "cue") delete shot["cue_ball"];
  else shot["cue_ball"] = stroke.ball;
  return shot;
}

/** A stroke for a table where nobody has shot yet: at the nearest ball, neither hard nor soft. */
export function freshStroke(drawing: Drawing, ball = likelyCueBall(drawing)): Stroke {
  const speed = Number((0.7 * drawing.table.size).toPrecision(1));
  return { ball, speed, direction: towardsNearest(drawing, ball), elevation: 0, left: 0, top: 0 };
}

function likelyCueBall({ balls }: Drawing): string {
  const known = balls.find(({ id }) => ["cue", "white"].includes(id));
  const resting = balls.find(({ velocity }) => velocity.every((component) => component === 0));
  return (known ?? resting ?? balls[0])?.id ?? "cue";
}

function towardsNearest({ balls }: Drawing, id: string): number {
  const [x = 0, y = 0] = balls.find((ball) => ball.id === id)?.position ?? [];
  const ways = balls
    .filter((ball) => ball.id !== id)
    .map(({ position }) => [(position[0] ?? 0) - x, (position[1] ?? 0) - y] as const)
    .sort((a, b) => Math.hypot(...a) - Math.hypot(...b));
  return ways[0] ? degrees(...ways[0]) : 90;
}

/** The direction of a way, in hundredths of a degree from 0 up to 360. */
export const degrees = (dx: number, dy: number): number => turned((Math.atan2(dy, dx) * 180) / Math.PI);

/** A direction as it is written: in hundredths of a degree, from 0 up to 360. */
export function turned(direction: number): number {
  const hundredths = Math.round(direction * 100) % 36_000;
  return (hundredths < 0 ? hundredths + 36_000 : hundredths) / 100;
}
