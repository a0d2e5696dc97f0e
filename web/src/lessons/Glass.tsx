/** Lies over the table in a lesson: the balls stay where they are, and directions are drawn. */

import { drawing } from "../studio/store";
import { MARGIN } from "../table/Table";
import { fitted } from "../table/view";
import { drawn, isLocked, part } from "./state";

export function Glass() {
  const question = part.value?.question;
  const isDrawing = isLocked.value && question?.kind === "direction";
  const ball = question?.kind === "direction" ? question.ball : 0;
  const aim = (event: PointerEvent & { currentTarget: HTMLElement }) => {
    const [shown, box] = [drawing.peek(), event.currentTarget.getBoundingClientRect()];
    const position = shown?.balls[ball]?.position;
    if (!isDrawing || !shown || !position || event.buttons === 0) return;
    const view = fitted(shown.table, box.width, box.height, MARGIN);
    const [x, y] = view.place(event.clientX - box.left, event.clientY - box.top);
    const angle = Math.atan2(y - (position[1] as number), x - (position[0] as number));
    drawn.value = Math.round((angle * 180) / Math.PI);
  };
  return (
    <div
      class={isDrawing ? "glass drawing" : "glass"}
      aria-hidden="true"
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        aim(event);
      }}
      onPointerMove={aim}
    />
  );
}
