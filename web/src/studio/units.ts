/** Names of the units of what is shown, put together from those that the scenario gives. */

import { drawing } from "./store";

export type Quantity = "time" | "length" | "speed" | "momentum" | "energy" | "spin";

/** Powers of mass, length and time. */
const POWERS: Record<Quantity, [number, number, number]> = {
  time: [0, 0, 1],
  length: [0, 1, 0],
  speed: [0, 1, -1],
  momentum: [1, 1, -1],
  energy: [1, 2, -2],
  spin: [0, 0, -1],
};

const RAISED: Record<number, string> = { 2: "²" };

/** The unit of a quantity; empty where the scenario does not name all that it is made of. */
function unitOf(quantity: Quantity): string {
  const units = drawing.value?.units ?? {};
  const names = [units["mass"], units["length"], units["time"]];
  if (quantity === "energy" && names.join() === "kg,m,s") return "J";
  const powers = POWERS[quantity];
  if (powers.some((power, k) => power !== 0 && !names[k])) return "";
  const product = (sign: number) =>
    names.flatMap((name, k) => {
      const power = sign * (powers[k] as number);
      return power > 0 ? [`${name}${RAISED[power] ?? ""}`] : [];
    });
  const [over, under] = [product(1).join("·"), product(-1).join("·")];
  return under ? `${over || "1"}/${under}` : over;
}

/** A name with its unit: "speed (m/s)". */
export function withUnit(name: string, quantity: Quantity): string {
  const unit = unitOf(quantity);
  return unit ? `${name} (${unit})` : name;
}
