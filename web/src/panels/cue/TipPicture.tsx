/** The ball as the shooter sees it, with the tip of the cue on it, and the rim where the tip slips off. */

import type { CueDrawn } from "../../engine/protocol";
import { number, word } from "../../words";
import { aim } from "./state";
import type { Stroke } from "./stroke";

/** The tip goes no further out than this, over the ball's radius. */
const OUTERMOST = 0.98;
const STEP = 0.05;
const FINE_STEP = 0.01;

interface Props {
  stroke: Stroke;
  cue: CueDrawn;
  radius: number;
  /** Whether the tip slips off there. */
  isOff: boolean;
}

export function TipPicture({ stroke, cue, radius, isOff }: Props) {
  const scale = cue.shot?.offset_scale ?? 1;
  const [left, top] = [stroke.left * scale, stroke.top * scale];
  /** Puts the point of contact somewhere. */
  const put = (toLeft: number, toTop: number) => {
    const away = Math.hypot(toLeft, toTop);
    const part = (away > OUTERMOST ? OUTERMOST / away : 1) / scale;
    aim({ left: hundredths(toLeft * part), top: hundredths(toTop * part) });
  };
  const point = (event: PointerEvent & { currentTarget: HTMLElement }) => {
    const box = event.currentTarget.getBoundingClientRect();
    const along = (at: number, from: number, length: number) => ((at - from) / length - 0.5) * SIZE;
    put(-along(event.clientX, box.left, box.width), -along(event.clientY, box.top, box.height));
  };
  return (
    <div
      class={isOff ? "tip off" : "tip"}
      role="slider"
      tabIndex={0}
      aria-label={word("cueTip")}
      aria-valuemin={-1}
      aria-valuemax={1}
      aria-valuenow={stroke.left}
      aria-valuetext={tipWords(stroke)}
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        point(event);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) point(event);
      }}
      onKeyDown={(event) => {
        const step = event.shiftKey ? FINE_STEP : STEP;
        const ways: Record<string, [number, number]> = {
          ArrowLeft: [stroke.left + step, stroke.top],
          ArrowRight: [stroke.left - step, stroke.top],
          ArrowUp: [stroke.left, stroke.top + step],
          ArrowDown: [stroke.left, stroke.top - step],
          Home: [0, 0],
        };
        const way = ways[event.key];
        if (!way || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        put(way[0] * scale, way[1] * scale);
      }}
    >
      <svg viewBox={`${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`} aria-hidden="true">
        <circle class="ball" r={1} />
        <path class="slippery" d={ringOf(cue.miscue_offset)} />
        <path class="axes" d="M-1 0H1M0-1V1" />
        <circle class="dot" cx={-left} cy={-top} r={Math.max(cue.tip_radius / radius / 2, 0.1)} />
      </svg>
    </div>
  );
}

/** The picture is so wide, over the ball's radius. */
const SIZE = 2.2;

const hundredths = (value: number) => Math.round(value * 100) / 100;

/** What of the ball lies outside a circle. */
function ringOf(inner: number): string {
  if (inner >= 1) return "";
  const circle = (r: number) => `M${-r} 0A${r} ${r} 0 1 0 ${r} 0A${r} ${r} 0 1 0 ${-r} 0z`;
  return circle(1) + circle(inner);
}

/** Where the tip is, in words. */
export function tipWords({ left, top }: Stroke): string {
  if (left === 0 && top === 0) return word("cueMiddle");
  const parts = [
    left !== 0 && word(left > 0 ? "cueLeftBy" : "cueRightBy", { offset: number(Math.abs(left), 3) }),
    top !== 0 && word(top > 0 ? "cueTopBy" : "cueBottomBy", { offset: number(Math.abs(top), 3) }),
  ];
  return parts.filter(Boolean).join(", ");
}
