/** How far apart two balls are, from hit to hit, on a scale of powers of ten. */

import { useComputed } from "@preact/signals";
import { run } from "../studio/store";
import { word } from "../words";
import { powerOfTen } from "./format";
import { distance } from "./instants";
import { collisions, past } from "./state";

const WIDTH = 320;
const HEIGHT = 140;
const LEFT = 34;
const BOTTOM = 22;

export function Chart() {
  const points = useComputed(() => {
    const main = run.value;
    if (!main) return [];
    return collisions.value.map(({ time }) => Math.log10(distance([main, 0], [main, 1], time)));
  });
  const [count, shown] = [points.value.length, past.value.length];
  if (count === 0) return null;
  const lowest = Math.floor(Math.min(...points.value));
  const highest = Math.max(Math.ceil(Math.max(...points.value)), lowest + 3);
  const x = (k: number) => LEFT + ((WIDTH - LEFT - 8) * (k + 1)) / count;
  const y = (power: number) => 8 + ((HEIGHT - BOTTOM - 8) * (highest - power)) / (highest - lowest);
  const powers = [lowest, Math.round((lowest + highest) / 2), highest];
  return (
    <figure class="chart">
      <figcaption>{word("chartCaption")}</figcaption>
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
        {powers.map((power) => (
          <g key={power}>
            <path class="grid" d={`M${LEFT} ${y(power)}H${WIDTH - 8}`} />
            <text x={LEFT - 6} y={y(power) + 4} text-anchor="end">
              {powerOfTen(power)}
            </text>
          </g>
        ))}
        <text x={WIDTH - 8} y={HEIGHT - 4} text-anchor="end">
          {word("hitsAxis", { count })}
        </text>
        <path
          class="course"
          d={points.value
            .slice(0, shown)
            .reduce((path, power, k) => `${path}${k ? "L" : "M"}${x(k)} ${y(power)}`, "")}
        />
        {points.value.slice(0, shown).map((power, k) => (
          <circle key={k} cx={x(k)} cy={y(power)} r={2.5} />
        ))}
      </svg>
    </figure>
  );
}
