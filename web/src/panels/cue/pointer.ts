/** Aiming on the table: dragging turns the stroke about the cue ball, a click points it at a place. */

import type { Point } from "../../engine/protocol";
import { chosen } from "../../studio/store";
import { shownView } from "../../table/drag";
import { aim, commit, forecast, isAiming, stroke } from "./state";
import { degrees, turned } from "./stroke";

/** With Shift a drag turns by so much of what it does without. */
const FINE = 0.1;
/** A pointer that has moved by less than so many pixels since it was put down points at a place. */
const STILL = 4;

interface Hold {
  pointer: number;
  from: Point;
  /** The direction of the pointer from the cue ball, and the one that it has turned the stroke to, in degrees. */
  at: number;
  direction: number;
  isTurning: boolean;
}

/** An arrow key on the table turns by so many degrees, and by so many with Shift. */
const STEP = 0.5;
const FINE_STEP = 0.01;

/**
 * Has the pointers and the keys of the table aim; gives what ends that. The struck ball itself can still be dragged, the
 * others stay where they lie.
 */
export function aimOn(canvas: HTMLCanvasElement): () => void {
  const ends = new AbortController();
  // Before those who drag balls hear of it.
  const on = <K extends keyof HTMLElementEventMap>(name: K, then: (event: HTMLElementEventMap[K]) => void) =>
    canvas.addEventListener(name, then as EventListener, { signal: ends.signal, capture: true });
  let hold: Hold | null = null;
  on("pointerdown", (event) => {
    hold = grasped(event);
    if (!hold) return;
    canvas.setPointerCapture(event.pointerId);
    event.stopImmediatePropagation();
  });
  on("pointermove", (event) => {
    if (hold?.pointer === event.pointerId) hold = follow(hold, event);
    canvas.classList.toggle("aiming", isAiming.peek() && (hold !== null || !isOnBall(event)));
  });
  on("pointerup", (event) => {
    if (hold?.pointer !== event.pointerId) return;
    if (!hold.isTurning) aim({ direction: directionOf(event) });
    hold = null;
    void commit();
  });
  on("pointercancel", () => {
    hold = null;
  });
  on("keydown", turnByKey);
  return () => {
    ends.abort();
    canvas.classList.remove("aiming");
  };
}

function grasped(event: PointerEvent): Hold | null {
  const now = stroke.peek();
  if (!isAiming.peek() || !now || !event.isPrimary || event.button !== 0 || isOnBall(event)) return null;
  const from: Point = [event.offsetX, event.offsetY];
  const { direction } = now;
  return { pointer: event.pointerId, from, at: directionOf(event), direction, isTurning: false };
}

/** The arrow keys turn the stroke unless a ball is chosen, which they move. */
function turnByKey(event: KeyboardEvent) {
  const turn = { ArrowLeft: 1, ArrowRight: -1 }[event.key];
  const now = stroke.peek();
  if (!turn || !now || !isAiming.peek() || chosen.peek() !== null) return;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  event.stopImmediatePropagation();
  aim({ direction: turned(now.direction + turn * (event.shiftKey ? FINE_STEP : STEP)) });
}

function follow(hold: Hold, event: PointerEvent): Hold {
  const moved = Math.hypot(event.offsetX - hold.from[0], event.offsetY - hold.from[1]);
  if (!hold.isTurning && moved < STILL) return hold;
  const at = directionOf(event);
  const turn = ((((at - hold.at) % 360) + 540) % 360) - 180;
  const direction = hold.direction + turn * (event.shiftKey ? FINE : 1);
  aim({ direction: turned(direction) });
  return { ...hold, at, direction, isTurning: true };
}

/** Where the struck ball is, in pixels, and how large. */
function ballOnCanvas(): { x: number; y: number; radius: number } | null {
  const [view, found] = [shownView.peek(), forecast.peek()];
  const ball = found?.drawn.balls[found.shot.ball];
  if (!view || !ball) return null;
  const [x = 0, y = 0] = ball.position;
  return { x: view.x(x), y: view.y(y), radius: ball.radius * view.scale };
}

function directionOf({ offsetX, offsetY }: PointerEvent): number {
  const ball = ballOnCanvas();
  return ball ? degrees(offsetX - ball.x, ball.y - offsetY) : 0;
}

/** The struck ball itself gives no direction. */
function isOnBall({ offsetX, offsetY }: PointerEvent): boolean {
  const ball = ballOnCanvas();
  return ball !== null && Math.hypot(offsetX - ball.x, offsetY - ball.y) <= ball.radius;
}
