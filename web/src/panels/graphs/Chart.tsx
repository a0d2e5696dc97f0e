/** A graph against time whose cursor is the time of the table: a click or a drag in it seeks. */

import { type Signal, useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { pause, run, seek, time } from "../../studio/store";
import { isDark } from "../../studio/theme";
import { type Quantity, withUnit } from "../../studio/units";
import { DARK, LIGHT } from "../../table/colours";
import { visible } from "../../table/contrast";
import { language, number, word } from "../../words";

/** A line of a graph. */
export interface Line {
  name: string;
  /** Absent: that of letters. */
  colour?: string;
  values: Float64Array;
  isDashed?: boolean;
}

interface Props {
  name: string;
  quantity: Quantity;
  times: Float64Array;
  lines: Line[];
  /** The axis reaches at least so far: what is smaller by much is rounding, and looks like it. */
  least?: number;
}

const HEIGHT = 190;
/** So many ticks of events at most. */
const MOST_TICKS = 400;
const SURFACES = { light: "#ffffff", dark: "#1a2225" };

export function Chart({ name, quantity, times, lines, least = 0 }: Props) {
  const hidden = useSignal<ReadonlySet<string>>(new Set());
  const title = withUnit(name, quantity);
  return (
    <figure class="graph" aria-label={title}>
      <figcaption>{title}</figcaption>
      <Plot title={title} times={times} lines={lines} least={least} hidden={hidden} />
      <Legend times={times} lines={lines} hidden={hidden} />
    </figure>
  );
}

interface PlotProps {
  title: string;
  times: Float64Array;
  lines: Line[];
  least: number;
  hidden: Signal<ReadonlySet<string>>;
}

function Plot({ title, times, lines, least, hidden }: PlotProps) {
  const place = useRef<HTMLDivElement>(null);
  const isNight = isDark.value;
  const tongue = language.value;
  useEffect(() => {
    const element = place.current;
    if (!element || times.length === 0) return;
    let [isOver, end] = [false, () => {}];
    void import("uplot").then(({ default: Kind }) => {
      if (!isOver)
        end = show(
          new Kind(settings(element, lines, least), dataOf(times, lines), element),
          element,
          lines,
          hidden,
        );
    });
    return () => {
      isOver = true;
      end();
    };
  }, [times, lines, isNight, tongue]);
  return <div class="plot" ref={place} role="img" aria-label={`${title}: ${word("graphHint")}`} />;
}

const dataOf = (times: Float64Array, lines: Line[]): UPlot.AlignedData => [
  times,
  ...lines.map(({ values }) => values),
];

/** Ties a plot to its room, the time and the legend; gives what ends that. */
function show(plot: UPlot, element: HTMLElement, lines: Line[], hidden: PlotProps["hidden"]): () => void {
  const cursor = document.createElement("div");
  cursor.className = "now";
  plot.over.append(cursor);
  const put = () => {
    const left = plot.valToPos(time.peek(), "x");
    cursor.style.transform = `translateX(${Number.isFinite(left) ? left : -9}px)`;
  };
  const observer = new ResizeObserver(([entry]) => {
    if (entry && entry.contentRect.width > 0) {
      plot.setSize({ width: entry.contentRect.width, height: HEIGHT });
      put();
    }
  });
  observer.observe(element);
  seekOn(plot);
  const ends = [
    time.subscribe(put),
    hidden.subscribe((names) => {
      lines.forEach((line, k) => {
        plot.setSeries(k + 1, { show: !names.has(line.name) });
      });
    }),
    () => observer.disconnect(),
    () => plot.destroy(),
  ];
  return () => {
    for (const end of ends) end();
  };
}

/** The plot's listeners go with its elements. */
function seekOn(plot: UPlot) {
  const go = (event: PointerEvent) => {
    if (event.buttons === 0) return;
    pause();
    seek(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
  };
  const begin = (event: PointerEvent) => {
    plot.over.setPointerCapture(event.pointerId);
    go(event);
  };
  plot.over.addEventListener("pointerdown", begin);
  plot.over.addEventListener("pointermove", go);
}

function settings(element: HTMLElement, lines: Line[], least: number): UPlot.Options {
  const palette = isDark.peek() ? DARK : LIGHT;
  const axis = (): UPlot.Axis => ({
    stroke: palette.ink,
    font: "12px system-ui, sans-serif",
    grid: { stroke: `${palette.faint}40`, width: 1 },
    ticks: { stroke: `${palette.faint}40`, width: 1, size: 4 },
    values: (_, ticks) => ticks.map((tick) => number(tick)),
  });
  const series = lines.map(
    ({ colour, isDashed }): UPlot.Series => ({
      stroke: lineColour(colour),
      width: colour ? 1.75 : 2.25,
      points: { show: false },
      pxAlign: 0,
      ...(isDashed ? { dash: [5, 4] } : {}),
    }),
  );
  return {
    width: Math.max(element.clientWidth, 100),
    height: HEIGHT,
    padding: [8, 10, 0, 0],
    legend: { show: false },
    cursor: { show: false },
    scales: {
      x: { time: false, range: (_, low, high) => [low, high] },
      y: { range: (_, low, high) => reach(low, high, least) },
    },
    axes: [
      { ...axis(), size: 26, space: 60 },
      { ...axis(), size: 54, space: 28 },
    ],
    series: [{}, ...series],
    hooks: { draw: [drawTicks] },
  };
}

/** The ends of an axis with zero on it and some room. */
function reach(low: number | null, high: number | null, least: number): [number, number] {
  const [bottom, top] = [Math.min(low ?? 0, 0), Math.max(high ?? 0, 0)];
  if (Math.max(-bottom, top) <= least) return [-least, least || 1];
  const room = 0.06 * (top - bottom);
  return [bottom < 0 ? bottom - room : 0, top > 0 ? top + room : 0];
}

/** The colour of a line on the panel; without one it is that of letters. */
export function lineColour(colour: string | undefined): string {
  const palette = isDark.value ? DARK : LIGHT;
  if (!colour) return palette.ink;
  return visible(colour, isDark.value ? SURFACES.dark : SURFACES.light, palette.ink, 2.2);
}

/** Ticks at events, at the lower edge. */
function drawTicks(plot: UPlot) {
  const times = run.peek()?.events.time;
  if (!times || times.length > MOST_TICKS) return;
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.strokeStyle = isDark.peek() ? DARK.faint : LIGHT.faint;
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  for (const at of times) {
    const x = Math.round(plot.valToPos(at, "x", true)) + 0.5;
    ctx.moveTo(x, bbox.top + bbox.height);
    ctx.lineTo(x, bbox.top + bbox.height - 7 * devicePixelRatio);
  }
  ctx.stroke();
  ctx.restore();
}

/** The lines by name, each a button that hides it, with its value now. */
function Legend({ times, lines, hidden }: Pick<PlotProps, "times" | "lines" | "hidden">) {
  return (
    <ul class="graph-legend">
      {lines.map((line) => (
        <li key={line.name}>
          <button
            type="button"
            class="chip"
            aria-pressed={!hidden.value.has(line.name)}
            onClick={() => switchOver(hidden, line.name)}
          >
            <svg viewBox="0 0 18 8" width="18" height="8" aria-hidden="true">
              <path
                d="M1 4H17"
                fill="none"
                stroke={lineColour(line.colour)}
                stroke-width="3"
                stroke-dasharray={line.isDashed ? "5 3" : undefined}
              />
            </svg>
            {line.name}
            <Value line={line} times={times} />
          </button>
        </li>
      ))}
    </ul>
  );
}

function switchOver(hidden: PlotProps["hidden"], name: string) {
  const names = new Set(hidden.peek());
  if (!names.delete(name)) names.add(name);
  hidden.value = names;
}

function Value({ line, times }: { line: Line; times: Float64Array }) {
  const source = useSignal(line);
  source.value = line;
  const text = useComputed(() => number(valueAt(times, source.value.values, time.value), 3));
  return <output>{text}</output>;
}

/** The value at a time, on the straight line between the samples beside it. */
function valueAt(times: Float64Array, values: Float64Array, at: number): number {
  let [low, high] = [0, times.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((times[middle] as number) <= at) low = middle;
    else high = middle;
  }
  const [before, after] = [values[low] as number, values[low + 1] ?? (values[low] as number)];
  const span = (times[low + 1] ?? Number.POSITIVE_INFINITY) - (times[low] as number);
  return before + (after - before) * Math.max(0, (at - (times[low] as number)) / span);
}
