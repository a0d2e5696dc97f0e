/** Marks at the places of contacts: a cross where balls met, a tick at a cushion, a ring where a ball fell on the cloth. */

import type { EventColumns } from "../engine/protocol";
import { firstEventAfter, run, time, vocabulary } from "../studio/store";
import type { Palette } from "./colours";
import type { Pen } from "./draw";
import type { Layer } from "./layers";
import { options } from "./options";
import { onTable, periods } from "./periodic";
import type { View } from "./view";

/** So many of the last contacts are marked. */
const MARKS = 150;
/** So many events are looked through for them. */
const LOOKED = 3000;
/** How visible the oldest mark is. */
const FAINTEST = 0.12;

const MARKED: Record<string, Mark> = {
  ball_ball: drawCross,
  ball_cushion: drawTick,
  ball_cloth: drawRing,
  hold: drawTick,
};

interface Place {
  x: number;
  y: number;
  normal: [number, number];
}

type Mark = (pen: Pen, place: Place, palette: Palette) => void;

export const contacts: Layer = (pen, { view, palette }) => {
  const events = run.value?.events;
  if (!events || !options.value.contacts) return;
  pen.save();
  pen.lineCap = "round";
  lastContacts(events, firstEventAfter(time.value)).forEach(([event, mark], age, all) => {
    pen.globalAlpha = Math.max(FAINTEST, 0.9 * (1 - age / Math.min(MARKS, all.length + 12)));
    mark(pen, placeOf(events, event, view), palette);
  });
  pen.restore();
};

/** The last contacts before a place in the log, the latest first. */
function lastContacts(events: EventColumns, before: number): [number, Mark][] {
  const marks = (vocabulary.value?.kinds ?? []).map((kind) => MARKED[kind]);
  const found: [number, Mark][] = [];
  for (let event = before - 1; event >= Math.max(0, before - LOOKED) && found.length < MARKS; event--) {
    const mark = marks[events.kind[event] as number];
    if (mark) found.push([event, mark]);
  }
  return found;
}

function placeOf(events: EventColumns, event: number, view: View): Place {
  const n = (column: Float64Array) => column[event] as number;
  const [x, y] = onTable(n(events.x), n(events.y), periods.value);
  return { x: view.x(x), y: view.y(y), normal: [n(events.normalX), -n(events.normalY)] };
}

function drawCross(pen: Pen, { x, y }: Place, { contact }: Palette) {
  pen.strokeStyle = contact;
  pen.lineWidth = 1.75;
  pen.beginPath();
  pen.moveTo(x - 3.5, y - 3.5);
  pen.lineTo(x + 3.5, y + 3.5);
  pen.moveTo(x - 3.5, y + 3.5);
  pen.lineTo(x + 3.5, y - 3.5);
  pen.stroke();
}

/** From the cushion outwards, so that it does not hide the ball. */
function drawTick(pen: Pen, { x, y, normal: [nx, ny] }: Place, { bounce }: Palette) {
  pen.strokeStyle = bounce;
  pen.lineWidth = 2.5;
  pen.beginPath();
  pen.moveTo(x + 2 * nx, y + 2 * ny);
  pen.lineTo(x - 8 * nx, y - 8 * ny);
  pen.stroke();
}

function drawRing(pen: Pen, { x, y }: Place, { bounce }: Palette) {
  pen.strokeStyle = bounce;
  pen.lineWidth = 1.5;
  pen.beginPath();
  pen.arc(x, y, 3.5, 0, 2 * Math.PI);
  pen.stroke();
}
