/** Balls and the tips of their arrows are dragged, with a pointer or with keys. */

import { effect, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Point, Problem, Values } from "../engine/protocol";
import { problemsWith } from "../form/editing";
import { tidy } from "../form/fresh";
import { canChange, moved, withVelocity } from "../studio/balls";
import { isEmbedded } from "../studio/embed";
import { change, chosen, drawing, isPlaying, pause, say, seek, time, written } from "../studio/store";
import { pixelsOf } from "./draw";
import { now } from "./moment";
import { arrowSeconds, options } from "./options";
import type { View } from "./view";

/** A ball, or the tip of its arrow, on the way to another place. */
export interface Drag {
  kind: "ball" | "arrow";
  ball: number;
  /** Where it would come to lie, in the table's lengths. */
  place: Point;
  /** What is wrong with that place, as far as the engine has been asked. */
  problems: Problem[];
  /** Whether the page went to the start for it. */
  isFromLater: boolean;
}

/** What is dragged; null is nothing. */
export const drag = signal<Drag | null>(null);
/** Whether balls can be dragged: something else may need the pointer for itself. */
export const isDragOn = signal(!isEmbedded);
/** The view that the table is drawn with. */
export const shownView = signal<View | null>(null);

/** Pixels around something small in which a pointer still gets hold of it; a finger is broader. */
const REACH = { mouse: 10, pen: 14, touch: 24 };
/** A pointer that has moved by less than so many pixels since it was put down drags nothing. */
const STILL = 4;
/** From so many balls on there are no arrows. */
const MANY = 60;
/** Pixels from the rim of a ball at rest to the handle that an arrow can be drawn out of. */
const REST_HANDLE = 16;
/** An arrow that is shorter is none. */
const NO_ARROW = 6;

const startOf = (ball: number) => drawing.peek()?.balls[ball];

/** Whether a ball's velocity is its own to give: one that a cue strikes begins at rest. */
function canHaveArrow(ball: number): boolean {
  const shot = written.value["shot"] as { cue_ball?: string } | undefined;
  return shot === undefined || startOf(ball)?.id !== (shot.cue_ball ?? "cue");
}

/** The pixel of the handle at the tip of a ball's arrow at the start; null where there is none. */
export function tipOf(ball: number, view: View): Point | null {
  const start = drawing.value?.balls[ball];
  if (!start || !canHaveArrow(ball) || !canChange()) return null;
  const [[x = 0, y = 0], [vx = 0, vy = 0]] = [start.position, start.velocity];
  const seconds = arrowSeconds.value;
  if (Math.hypot(vx, vy) * seconds * view.scale >= NO_ARROW) {
    return [view.x(x + vx * seconds), view.y(y + vy * seconds)];
  }
  return [view.x(x) + pixelsOf(start.radius, view) + REST_HANDLE, view.y(y)];
}

/** What lies under a pixel. */
function under(px: number, py: number, reach: number): Pick<Drag, "kind" | "ball"> | null {
  const [view, drawn] = [shownView.peek(), drawing.peek()];
  if (!view || !drawn) return null;
  const tips = time.peek() === 0 && options.peek().arrows && drawn.balls.length <= MANY;
  const chosenFirst = [chosen.peek() ?? -1, ...(tips ? drawn.balls.keys() : [])];
  for (const ball of time.peek() === 0 ? chosenFirst : []) {
    const tip = tipOf(ball, view);
    if (tip && Math.hypot(px - tip[0], py - tip[1]) <= reach) return { kind: "arrow", ball };
  }
  const ball = ballUnder(px, py, reach, view);
  return ball === null ? null : { kind: "ball", ball };
}

/** The ball whose middle is nearest to a pixel, of those that are within reach. */
function ballUnder(px: number, py: number, reach: number, view: View): number | null {
  const [moment, drawn] = [now(), drawing.peek()];
  if (!moment || !drawn) return null;
  let [nearest, least] = [-1, Number.POSITIVE_INFINITY];
  for (let ball = 0; ball < moment.x.length; ball++) {
    const away = Math.hypot(px - view.x(moment.x[ball] as number), py - view.y(moment.y[ball] as number));
    const within = Math.max(pixelsOf(drawn.balls[ball]?.radius ?? 0, view), reach);
    if (away <= within && away < least) [nearest, least] = [ball, away];
  }
  return nearest < 0 ? null : nearest;
}

/** The values that what is dragged would have. */
function valuesOf({ kind, ball, place }: Drag): Values {
  if (kind === "ball") return moved(ball, place);
  const [x = 0, y = 0] = startOf(ball)?.position ?? [];
  const [dx, dy] = [place[0] - x, place[1] - y];
  const seconds = arrowSeconds.peek();
  if (Math.hypot(dx, dy) * (shownView.peek()?.scale ?? 1) < NO_ARROW) return withVelocity(ball, [0, 0]);
  const largest = (drawing.peek()?.table.size ?? 1) / seconds;
  return withVelocity(ball, [tidy(dx / seconds, largest), tidy(dy / seconds, largest)]);
}

let isAsking = false;

/** Asks what is wrong with where things are, one question at a time. */
async function judge() {
  if (isAsking) return;
  isAsking = true;
  let judged: Drag | null = null;
  while (drag.peek() && drag.peek()?.place !== judged?.place) {
    judged = drag.peek() as Drag;
    const problems = await problemsWith(valuesOf(judged));
    const at = drag.peek();
    if (problems === null) break;
    if (at) drag.value = { ...at, problems };
  }
  isAsking = false;
}

/** Begins to drag a ball or its arrow. At a later time the page goes to the start first. */
export function lift(kind: Drag["kind"], ball: number, place: Point): boolean {
  if (!canChange()) {
    say("gasBalls");
    return false;
  }
  const isFromLater = time.peek() > 0 || isPlaying.peek();
  if (isFromLater) {
    pause();
    seek(0);
  }
  drag.value = { kind, ball, place, problems: [], isFromLater };
  return true;
}

export function carry(place: Point) {
  const before = drag.peek();
  if (!before) return;
  drag.value = { ...before, place };
  void judge();
}

/** Lets go: what is dragged stays where it is, or goes back if the engine refuses the place. */
export async function drop() {
  const last = drag.peek();
  if (!last) return;
  const values = valuesOf(last);
  const problems = await problemsWith(values);
  const id = startOf(last.ball)?.id ?? "";
  if (problems?.length === 0 && (await change(values)) && last.isFromLater) say("wentToStart");
  drag.value = null;
  if (problems && problems.length > 0) say("dragRefused", { id, reason: reasonOf(problems) });
}

export function giveUp() {
  drag.value = null;
}

export const reasonOf = (problems: Problem[]) => problems.map(({ message }) => message).join("; ");

/** The place of a pixel, rounded to what is clear on the table. */
function placeAt(px: number, py: number): Point {
  const [x, y] = shownView.peek()?.place(px, py) ?? [0, 0];
  const size = drawing.peek()?.table.size ?? 1;
  return [tidy(x, size), tidy(y, size)];
}

/** What a pointer has hold of, from where it was put down. */
interface Hold extends Pick<Drag, "kind" | "ball"> {
  pointer: number;
  from: Point;
  /** From the pointer to the middle of what it holds, in pixels. */
  offset: Point;
  isMoving: boolean;
}

/** Has a canvas's pointers drag what lies under them. */
export function useDragging(canvas: { current: HTMLCanvasElement | null }) {
  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const ends = new AbortController();
    const on = <K extends keyof HTMLElementEventMap>(
      name: K,
      then: (event: HTMLElementEventMap[K]) => void,
    ) => element.addEventListener(name, then as EventListener, { signal: ends.signal });
    let hold: Hold | null = null;
    on("pointerdown", (event) => {
      if (!isDragOn.peek() || !event.isPrimary || event.button !== 0) return;
      hold = grasped(event);
      chosen.value = hold?.ball ?? null;
      if (hold) element.setPointerCapture(event.pointerId);
    });
    on("pointermove", (event) => {
      if (hold?.pointer === event.pointerId) hold = follow(hold, event);
      else if (!hold && isDragOn.peek()) element.classList.toggle("over", isOver(event));
    });
    on("pointerup", () => {
      if (hold?.isMoving) void drop();
      hold = null;
    });
    on("pointercancel", () => {
      giveUp();
      hold = null;
    });
    return () => ends.abort();
  }, [canvas]);
}

const reachOf = ({ pointerType }: PointerEvent) => REACH[pointerType as keyof typeof REACH] ?? REACH.mouse;

const isOver = (event: PointerEvent) => under(event.offsetX, event.offsetY, reachOf(event)) !== null;

function grasped(event: PointerEvent): Hold | null {
  const [px, py] = [event.offsetX, event.offsetY];
  const [found, view] = [under(px, py, reachOf(event)), shownView.peek()];
  if (!found || !view) return null;
  const moment = now();
  const middle: Point =
    found.kind === "arrow"
      ? (tipOf(found.ball, view) ?? [px, py])
      : [view.x(moment?.x[found.ball] ?? 0), view.y(moment?.y[found.ball] ?? 0)];
  const offset: Point = [middle[0] - px, middle[1] - py];
  return { ...found, pointer: event.pointerId, from: [px, py], offset, isMoving: false };
}

function follow(hold: Hold, event: PointerEvent): Hold | null {
  const [px, py] = [event.offsetX, event.offsetY];
  const place = placeAt(px + hold.offset[0], py + hold.offset[1]);
  if (!hold.isMoving) {
    if (Math.hypot(px - hold.from[0], py - hold.from[1]) < STILL) return hold;
    if (!lift(hold.kind, hold.ball, place)) return null;
  }
  carry(place);
  return { ...hold, isMoving: true };
}

// What is dragged belongs to the scenario that it was lifted in.
effect(() => {
  if (drawing.value) drag.value = null;
});
