/** Links as the page makes them, and as it should not get them. */

import { deflateRawSync } from "node:zlib";

/** The fragment of a text. */
export const packed = (text: string | Buffer) => `#scenario=${deflateRawSync(text).toString("base64url")}`;

/** The fragment of a scenario, made where a run had that digest with that physics. */
export function linkTo(scenario: unknown, digest: string | null = null, physicsVersion = 2): string {
  const head = { format: 1, physics_version: physicsVersion, digest };
  return packed(`${JSON.stringify(head)}\n${JSON.stringify(scenario)}`);
}

export const TWO_BALLS = {
  format: 1,
  duration: 5,
  table: { shape: "rectangle", width: 1, length: 2 },
  balls: [
    { id: "red", radius: 0.075, position: [0.1, 0.1], velocity: [3, 4] },
    { id: "blue", radius: 0.075, position: [0.5, 1.0] },
  ],
};
