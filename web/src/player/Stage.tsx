/** The table of a player: the same layers, but nothing on it can be moved. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { drawing, time } from "../studio/store";
import { isDark } from "../studio/theme";
import { ballColours, DARK, LIGHT } from "../table/colours";
import { onEachFrame } from "../table/frames";
import { layers } from "../table/layers";
import type { Scene } from "../table/Table";
import { fitted } from "../table/view";
import { number, word } from "../words";

const MARGIN = 20;

export function Stage() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = useSignal<[number, number]>([0, 0]);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => {
      if (entry) size.value = [entry.contentRect.width, entry.contentRect.height];
    });
    if (canvas.current) observer.observe(canvas.current);
    return () => observer.disconnect();
  }, []);

  const drawn = drawing.value;
  const [width, height] = size.value;
  const palette = isDark.value ? DARK : LIGHT;
  useEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen || !drawn || width === 0) return;
    const density = window.devicePixelRatio || 1;
    pen.canvas.width = Math.round(width * density);
    pen.canvas.height = Math.round(height * density);
    pen.setTransform(density, 0, 0, density, 0, 0);
    const colours = ballColours(drawn.balls);
    const bodies = drawn.balls.map(({ radius }, ball) => ({ radius, colour: colours[ball] as string }));
    const scene: Scene = { view: fitted(drawn.table, width, height, MARGIN), bodies, palette };
    return onEachFrame(() => {
      pen.clearRect(0, 0, width, height);
      for (const layer of layers) layer(pen, scene);
    });
  }, [drawn, width, height, palette]);

  const label = word("tableLabel", { balls: drawn?.balls.length ?? 0, time: number(time.value) });
  return <canvas class="table" ref={canvas} role="img" aria-label={label} />;
}
