/** The largest distance between the balls of two runs over time, on a logarithmic axis. */

import { useSignal } from "@preact/signals";
import { useEffect, useId, useMemo, useRef } from "preact/hooks";
import { endTime, seek, time } from "../../studio/store";
import { number, powerOfTen, word } from "../../words";
import type { Difference } from "./difference";
import { compared } from "./state";

/** Pixels above and to the right of the graph; the numbers of the axes have so many heights of their letters. */
const [TOP, RIGHT] = [10, 6];
const [LEFT, BOTTOM] = [3.8, 2];
/** Distances below are those of rounding. */
const LEAST = 1e-17;

/** The pixels of the graph, and of its letters. */
interface Room {
  width: number;
  height: number;
  letters: number;
}

export function DifferenceGraph() {
  const found = compared.value;
  if (!found?.distances.some((distance) => distance > 0)) return <p>{word("noDifference")}</p>;
  return (
    <figure class="difference">
      <figcaption>{word("differenceTitle")}</figcaption>
      <Plot found={found} />
    </figure>
  );
}

function Plot({ found }: { found: Difference }) {
  const title = useId();
  const picture = useRef<SVGSVGElement>(null);
  const room = useSignal<Room>({ width: 340, height: 200, letters: 12 });
  const { width, height, letters } = room.value;
  const shape = useMemo(() => shapeOf(found, room.value), [found, room.value]);

  useEffect(() => {
    const element = picture.current;
    if (!element) return;
    const observer = new ResizeObserver(([entry]) => {
      if (!entry || entry.contentRect.width === 0) return;
      const { width, height } = entry.contentRect;
      room.value = { width, height, letters: Number.parseFloat(getComputedStyle(element).fontSize) };
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  const { left, end, x, y } = shape;
  const upright = (at: number) => `M${x(at)} ${TOP}V${height - BOTTOM * letters}`;
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: the time line does the same for the keyboard
    <svg
      ref={picture}
      viewBox={`0 0 ${width} ${height}`}
      role="img"
      aria-labelledby={title}
      onClick={(event) => {
        const along = event.clientX - event.currentTarget.getBoundingClientRect().left - left;
        seek((along / (width - left - RIGHT)) * end);
      }}
    >
      <title id={title}>{word("differenceTitle")}</title>
      {powersOf(shape).map((power) => (
        <g key={power}>
          <path class="grid" d={`M${left} ${y(10 ** power)}H${width - RIGHT}`} />
          <text x={left - 6} y={y(10 ** power) + 0.35 * letters} text-anchor="end">
            {powerOfTen(power)}
          </text>
        </g>
      ))}
      {[0, 0.5, 1].map((part) => (
        <text key={part} x={x(part * end)} y={height - 6} text-anchor={part === 1 ? "end" : "middle"}>
          {number(part * end, 3)}
        </text>
      ))}
      {found.parting && <path class="parting" d={upright(found.parting.time)} />}
      <path class="curve" d={curveOf(found, shape)} />
      <path class="now" d={upright(Math.min(time.value, endTime.value, end))} />
    </svg>
  );
}

/** The powers of ten that the axis reaches over, and where times and distances are. */
interface Shape {
  low: number;
  high: number;
  left: number;
  end: number;
  x: (time: number) => number;
  y: (distance: number) => number;
}

function shapeOf({ times, distances }: Difference, { width, height, letters }: Room): Shape {
  const positive = distances.filter((distance) => distance > 0);
  const least = positive.reduce((a, b) => Math.min(a, b));
  const low = Math.floor(Math.log10(Math.max(least, LEAST)));
  const high = Math.max(Math.ceil(Math.log10(positive.reduce((a, b) => Math.max(a, b)))), low + 1);
  const [left, end] = [LEFT * letters, times.at(-1) || 1];
  const tall = height - TOP - BOTTOM * letters;
  return {
    low,
    high,
    left,
    end,
    x: (time) => left + ((width - left - RIGHT) * time) / end,
    y: (distance) => TOP + (tall * (high - Math.max(Math.log10(distance), low))) / (high - low),
  };
}

/** The powers of ten with a line. */
function powersOf({ low, high }: Shape): number[] {
  const every = Math.ceil((high - low) / 5);
  return Array.from({ length: Math.floor((high - low) / every) + 1 }, (_, k) => low + k * every);
}

function curveOf({ times, distances }: Difference, { x, y }: Shape): string {
  let path = "";
  distances.forEach((distance, k) => {
    path += `${k === 0 ? "M" : "L"}${x(times[k] as number).toFixed(1)} ${y(distance || 1e-300).toFixed(1)}`;
  });
  return path;
}
