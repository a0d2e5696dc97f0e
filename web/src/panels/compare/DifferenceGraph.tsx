/** The largest distance between the balls of two runs over time, on a logarithmic axis. */

import { useComputed } from "@preact/signals";
import { useId } from "preact/hooks";
import { endTime, seek, time } from "../../studio/store";
import { number, powerOfTen, word } from "../../words";
import { compared } from "./state";

/** Width and height in the units of the drawing, and the room for the numbers of the axes. */
const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP] = [340, 200, 46, 24, 10];

export function DifferenceGraph() {
  const title = useId();
  const shape = useComputed(() => {
    const found = compared.value;
    if (!found) return null;
    const positive = found.distances.filter((distance) => distance > 0);
    if (positive.length === 0) return null;
    const low = Math.floor(
      Math.log10(
        Math.max(
          positive.reduce((a, b) => Math.min(a, b)),
          1e-17,
        ),
      ),
    );
    const high = Math.max(Math.ceil(Math.log10(positive.reduce((a, b) => Math.max(a, b)))), low + 1);
    const end = found.times.at(-1) || 1;
    const x = (at: number) => LEFT + ((WIDTH - LEFT - 6) * at) / end;
    const y = (distance: number) =>
      TOP + ((HEIGHT - TOP - BOTTOM) * (high - Math.max(Math.log10(distance), low))) / (high - low);
    let path = "";
    found.distances.forEach((distance, k) => {
      path += `${k === 0 ? "M" : "L"}${x(found.times[k] as number).toFixed(1)} ${y(distance || 1e-300).toFixed(1)}`;
    });
    return { path, low, high, end, x, y, parting: found.parting?.time ?? null };
  });
  const drawn = shape.value;
  if (!drawn) return <p>{word("noDifference")}</p>;
  const every = Math.ceil((drawn.high - drawn.low) / 5);
  const powers = [];
  for (let power = drawn.low; power <= drawn.high; power += every) powers.push(power);
  return (
    <figure class="difference">
      <figcaption>{word("differenceTitle")}</figcaption>
      {/* biome-ignore lint/a11y/useKeyWithClickEvents: the time line does the same for the keyboard */}
      <svg
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        role="img"
        aria-labelledby={title}
        onClick={(event) => {
          const box = event.currentTarget.getBoundingClientRect();
          const along = ((event.clientX - box.left) / box.width) * WIDTH - LEFT;
          seek((along / (WIDTH - LEFT - 6)) * drawn.end);
        }}
      >
        <title id={title}>{word("differenceTitle")}</title>
        {powers.map((power) => (
          <g key={power}>
            <path class="grid" d={`M${LEFT} ${drawn.y(10 ** power)}H${WIDTH - 6}`} />
            <text x={LEFT - 6} y={drawn.y(10 ** power) + 4} text-anchor="end">
              {powerOfTen(power)}
            </text>
          </g>
        ))}
        {[0, 0.5, 1].map((part) => (
          <text
            key={part}
            x={drawn.x(part * drawn.end)}
            y={HEIGHT - 6}
            text-anchor={part === 1 ? "end" : "middle"}
          >
            {number(part * drawn.end, 3)}
          </text>
        ))}
        {drawn.parting !== null && (
          <path class="parting" d={`M${drawn.x(drawn.parting)} ${TOP}V${HEIGHT - BOTTOM}`} />
        )}
        <path class="curve" d={drawn.path} />
        <path
          class="now"
          d={`M${drawn.x(Math.min(time.value, endTime.value, drawn.end))} ${TOP}V${HEIGHT - BOTTOM}`}
        />
      </svg>
    </figure>
  );
}
