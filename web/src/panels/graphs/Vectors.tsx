/** The momenta of the moment as arrows: those of the balls from tip to tail, and their sum from the start to the end. */

import { useSignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { drawing, run, time } from "../../studio/store";
import { isDark } from "../../studio/theme";
import { withUnit } from "../../studio/units";
import { ballColours, DARK, LIGHT } from "../../table/colours";
import { drawArrow } from "../../table/draw";
import { onEachFrame } from "../../table/frames";
import { number, word } from "../../words";
import { lineColour } from "./Chart";
import type { Curve, Totals } from "./samples";

/** Pixels around the arrows. */
const MARGIN = 16;

/** The box that the arrows need over the whole run: least and greatest x, and y. */
type Box = [number, number, number, number];

export function Vectors({ found, single }: { found: Totals; single: Curve[] }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = useSignal<[number, number]>([0, 0]);
  const balls = drawing.value?.balls ?? [];
  const masses = balls.map(({ mass }) => mass);
  const box = useMemo(() => boxOf(found, single, masses), [found, single]);
  const isNight = isDark.value;
  const [width, height] = size.value;

  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const observer = new ResizeObserver(([entry]) => {
      if (entry) size.value = [entry.contentRect.width, entry.contentRect.height];
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  useEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen || width === 0) return;
    const density = window.devicePixelRatio || 1;
    pen.canvas.width = Math.round(width * density);
    pen.canvas.height = Math.round(height * density);
    pen.setTransform(density, 0, 0, density, 0, 0);
    const colours = ballColours(balls).map(lineColour);
    const show = scaled(box, width, height);
    return onEachFrame(() => {
      pen.clearRect(0, 0, width, height);
      drawAxes(pen, show, width, height, isNight ? DARK.faint : LIGHT.faint);
      const arrows = single.length > 0 ? momenta(masses) : [];
      const end = chain(pen, show, arrows, colours);
      const sum = single.length > 0 ? end : totalNow(found);
      drawArrow(pen, show(0, 0), show(...sum), isNight ? DARK.ink : LIGHT.ink, 3);
    });
  }, [box, width, height, isNight, balls, single]);

  const [x, y] = totalNow(found);
  const sum = word("momentumSum", { x: number(x, 3), y: number(y, 3), size: number(Math.hypot(x, y), 3) });
  return (
    <figure class="graph">
      <figcaption>{withUnit(word("momentumVectors"), "momentum")}</figcaption>
      <canvas class="vectors" ref={canvas} role="img" aria-label={`${word("momentumVectors")}: ${sum}`} />
      <p class="hint">{sum}</p>
    </figure>
  );
}

/** The momentum of each ball now. */
function momenta(masses: number[]): [number, number][] {
  const moment = run.value?.film.at(time.value);
  if (!moment) return [];
  return masses.map((mass, ball) => [mass * (moment.vx[ball] as number), mass * (moment.vy[ball] as number)]);
}

/** The sum now: that of the last sample. Between events it changes with a field only, and samples are dense. */
function totalNow({ times, px, py }: Totals): [number, number] {
  let [low, high] = [0, times.length];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((times[middle] as number) <= time.value) low = middle;
    else high = middle;
  }
  return [px[low] as number, py[low] as number];
}

/** Draws the arrows tip to tail; gives where the last one ends. */
function chain(
  pen: CanvasRenderingContext2D,
  show: Show,
  arrows: [number, number][],
  colours: string[],
): [number, number] {
  let at: [number, number] = [0, 0];
  arrows.forEach(([px, py], ball) => {
    const next: [number, number] = [at[0] + px, at[1] + py];
    drawArrow(pen, show(...at), show(...next), colours[ball] as string, 2.5);
    at = next;
  });
  return at;
}

function boxOf({ px, py, times }: Totals, single: Curve[], masses: number[]): Box {
  const box: Box = [0, 0, 0, 0];
  for (let k = 0; k < times.length; k++) {
    if (single.length === 0) include(box, px[k] as number, py[k] as number);
    let [x, y] = [0, 0];
    for (const [ball, { vx, vy }] of single.entries()) {
      x += (masses[ball] as number) * (vx[k] as number);
      y += (masses[ball] as number) * (vy[k] as number);
      include(box, x, y);
    }
  }
  return box;
}

function include(box: Box, x: number, y: number) {
  if (x < box[0]) box[0] = x;
  if (x > box[1]) box[1] = x;
  if (y < box[2]) box[2] = y;
  if (y > box[3]) box[3] = y;
}

type Show = (x: number, y: number) => [number, number];

/** One scale for the whole run, so that arrows of different moments can be compared. */
function scaled([left, right, bottom, top]: Box, width: number, height: number): Show {
  const [wide, high] = [right - left || 1, top - bottom || 1];
  const scale = Math.min((width - 2 * MARGIN) / wide, (height - 2 * MARGIN) / high);
  const [midX, midY] = [(left + right) / 2, (bottom + top) / 2];
  return (x, y) => [width / 2 + (x - midX) * scale, height / 2 - (y - midY) * scale];
}

function drawAxes(pen: CanvasRenderingContext2D, show: Show, width: number, height: number, colour: string) {
  const [x, y] = show(0, 0);
  pen.save();
  pen.strokeStyle = colour;
  pen.globalAlpha = 0.5;
  pen.beginPath();
  pen.moveTo(0, y);
  pen.lineTo(width, y);
  pen.moveTo(x, 0);
  pen.lineTo(x, height);
  pen.stroke();
  pen.restore();
}
