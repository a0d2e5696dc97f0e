/** Momentum and energy of single balls; sums over all of them come from the engine. */

import type { Moment } from "../engine/film";
import type { StartingBall } from "../engine/protocol";

/** The moment of inertia of a solid ball is this times m r². */
const INERTIA = 0.4;

export const speedOf = ({ vx, vy, vz }: Moment, ball: number): number =>
  Math.hypot(vx[ball] as number, vy[ball] as number, vz[ball] as number);

/** Of the motion, and on a cloth of the spin. */
export function kineticEnergy({ mass, radius }: StartingBall, moment: Moment, ball: number): number {
  const { wx, wy, wz } = moment;
  const spin = Math.hypot(wx[ball] as number, wy[ball] as number, wz[ball] as number);
  return 0.5 * mass * (speedOf(moment, ball) ** 2 + INERTIA * (radius * spin) ** 2);
}

const bits = new DataView(new ArrayBuffer(8));

/** The last time before a positive one: that of the state just before an event. */
export function justBefore(time: number): number {
  if (!(time > 0)) return 0;
  bits.setFloat64(0, time);
  bits.setBigUint64(0, bits.getBigUint64(0) - 1n);
  return bits.getFloat64(0);
}
