/** The ways that balls have gone up to a time, as points for a polyline: exact at each event, fine between. */

import type { Film } from "../engine/film";

/** So many points at most lie on a curved flight. */
const BEND = 12;

/** The way of a ball up to a time, from the last `most` of its flights: x and y in turn. */
export function trail(film: Film, ball: number, time: number, most: number): Float64Array {
  const { width, firstRows, numbers } = film.data;
  const [first, after] = [firstRows[ball] as number, firstRows[ball + 1] as number];
  const n = (row: number, place: number) => numbers[row * width + place] as number;
  const [v, a] = film.isOnCloth ? [4, 7] : [3, 5];
  const points: number[] = [];
  let end = first;
  while (end < after && n(end, 0) <= time) end++;
  for (let row = Math.max(first, end - most); row < end; row++) {
    const until = Math.min(row + 1 < after ? n(row + 1, 0) : time, time) - n(row, 0);
    const isStraight = n(row, a) === 0 && n(row, a + 1) === 0;
    const count = isStraight ? 1 : BEND;
    for (let k = row === first || points.length === 0 ? 0 : 1; k <= count; k++) {
      const s = (until * k) / count;
      points.push(
        n(row, 1) + (n(row, v) + n(row, a) * s * 0.5) * s,
        n(row, 2) + (n(row, v + 1) + n(row, a + 1) * s * 0.5) * s,
      );
    }
  }
  return Float64Array.from(points.filter((value) => !Number.isNaN(value)));
}
