/** The numbers that are written in a scenario, by their paths. */

/** Keys whose numbers cannot be varied by a little. */
const WHOLE = new Set(["format", "max_events", "collisions", "seed", "n", "steps"]);

/** Each number with its path, such as `balls.red.velocity[0]`, in the order in which they are written. */
export function numbersIn(written: unknown, path = ""): [string, number][] {
  if (typeof written === "number") return [[path, written]];
  if (Array.isArray(written)) {
    return written.flatMap((item, place) => numbersIn(item, path + placeOf(item, place)));
  }
  if (typeof written !== "object" || written === null) return [];
  return Object.entries(written).flatMap(([key, value]) =>
    WHOLE.has(key) || key === "color" ? [] : numbersIn(value, path ? `${path}.${key}` : key),
  );
}

function placeOf(item: unknown, place: number): string {
  const id = typeof item === "object" && item !== null && "id" in item ? item.id : undefined;
  if (typeof id !== "string" || /["\\]/.test(id)) return `[${place}]`;
  return /^[A-Za-z_]\w*$/.test(id) ? `.${id}` : `."${id}"`;
}
