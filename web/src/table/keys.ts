/** The table by keyboard: a ball is chosen and moved. */

import { chosen, drawing } from "../studio/store";
import { carry, drag, drop, giveUp, isDragOn, lift } from "./drag";

const DIRECTIONS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Parts of the table's size that an arrow key moves a ball by. */
const STEP = 0.01;
const FINE_STEP = 0.001;

/** Enter chooses a ball and Tab the next one, arrows move it while they are held, and Escape lets go of it. */
export function onTableKey(event: KeyboardEvent) {
  if (!isDragOn.peek() || event.ctrlKey || event.metaKey || event.altKey) return;
  if (!handle(event)) return;
  event.preventDefault();
  event.stopPropagation();
}

function handle(event: KeyboardEvent): boolean {
  const direction = DIRECTIONS[event.key];
  if (direction) return move(direction, event.shiftKey ? FINE_STEP : STEP);
  switch (event.key) {
    case "Enter":
      return chosen.peek() === null && chooseFrom(-1, 1);
    case "Tab":
      return chosen.peek() !== null && chooseFrom(chosen.peek() ?? -1, event.shiftKey ? -1 : 1);
    case "PageDown":
      return chooseFrom(chosen.peek() ?? -1, 1);
    case "PageUp":
      return chooseFrom(chosen.peek() ?? 1, -1);
    case "Escape":
      return letGo();
    default:
      return false;
  }
}

/** Chooses the ball so many places further on; false at the ends of the list, where Tab goes on to what follows. */
function chooseFrom(ball: number, step: number): boolean {
  const next = ball + step;
  if (next < 0 || next >= (drawing.peek()?.balls.length ?? 0)) return false;
  chosen.value = next;
  return true;
}

function letGo(): boolean {
  const isAny = drag.peek() !== null || chosen.peek() !== null;
  if (drag.peek()) giveUp();
  else chosen.value = null;
  return isAny;
}

function move([dx, dy]: [number, number], part: number): boolean {
  const ball = chosen.peek();
  if (ball === null) return chooseFrom(-1, 1);
  const drawn = drawing.peek();
  const [x = 0, y = 0] = drag.peek()?.place ?? drawn?.balls[ball]?.position ?? [];
  const step = part * (drawn?.table.size ?? 1);
  if (!drag.peek() && !lift("ball", ball, [x, y])) return true;
  carry([rounded(x + dx * step), rounded(y + dy * step)]);
  return true;
}

/** Without the last digits, which sums of steps leave over. */
const rounded = (length: number) => Number(length.toPrecision(10));

/** The keys are let go: what they moved is dropped. */
export function onTableKeyUp(event: KeyboardEvent) {
  if (event.key in DIRECTIONS && drag.peek()) void drop();
}
