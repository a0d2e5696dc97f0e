/** The table on the page: a canvas at true scale that follows the time. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Drawing } from "../engine/protocol";
import { aimLine, stick } from "../panels/cue/layer";
import { drawing, run, scenario, time } from "../studio/store";
import { isDark } from "../studio/theme";
import { number, word } from "../words";
import { balls } from "./balls";
import { ballColours, DARK, LIGHT, type Palette } from "./colours";
import { DragReason } from "./DragReason";
import { isDragOn, shownView, useDragging } from "./drag";
import type { Body } from "./draw";
import { onEachFrame } from "./frames";
import { handles } from "./handles";
import { onTableKey, onTableKeyUp } from "./keys";
import { type Layer, layers } from "./layers";
import { fitted, type View } from "./view";

/** Pixels around the table. */
export const MARGIN = 28;

/** What the layers of the table are drawn from. */
export interface Scene {
  view: View;
  bodies: Body[];
  palette: Palette;
}

/** The scene of a table that fills so many pixels. */
export function sceneOf(drawn: Drawing, width: number, height: number, palette: Palette): Scene {
  const colours = ballColours(drawn.balls);
  return {
    view: fitted(drawn.table, width, height, MARGIN),
    bodies: drawn.balls.map(({ radius }, ball) => ({ radius, colour: colours[ball] as string })),
    palette,
  };
}

/** The layers of a table on which balls are dragged and strokes aimed. */
const layersToSet = (): Layer[] => [
  ...layers.flatMap((layer) => (layer === balls ? [aimLine, balls] : [layer])),
  handles,
  stick,
];

export function Table() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = useSignal<[number, number]>([0, 0]);

  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const observer = new ResizeObserver(([entry]) => {
      if (entry) size.value = [entry.contentRect.width, entry.contentRect.height];
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  useDragging(canvas);

  const drawn = drawing.value;
  const [width, height] = size.value;
  const palette = isDark.value ? DARK : LIGHT;
  // What the layers read while they draw brings the next frame.
  useEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen || !drawn || width === 0) return;
    const density = window.devicePixelRatio || 1;
    pen.canvas.width = Math.round(width * density);
    pen.canvas.height = Math.round(height * density);
    const scene = sceneOf(drawn, width, height, palette);
    shownView.value = scene.view;
    pen.setTransform(density, 0, 0, density, 0, 0);
    return onEachFrame(() => {
      pen.clearRect(0, 0, width, height);
      for (const layer of layersToSet()) layer(pen, scene);
    });
  }, [drawn, width, height, palette, scenario.value]);

  const label = word("tableLabel", { balls: drawn?.balls.length ?? 0, time: number(time.value) });
  return (
    <div class="board">
      <canvas
        class="table"
        ref={canvas}
        aria-label={run.value ? label : ""}
        {...(isDragOn.value
          ? { role: "application", tabIndex: 0, "aria-describedby": "table-help" }
          : { role: "img" })}
        onKeyDown={onTableKey}
        onKeyUp={onTableKeyUp}
      />
      <DragReason />
    </div>
  );
}
