/** Drawing that follows signals, once a frame at most. */

import { effect } from "@preact/signals";

/** Milliseconds that the last frames took to draw, for those who measure. */
export const frameTimes: number[] = [];

/** Draws now, and in the next frame after anything that was read has changed; gives what ends that. */
export function onEachFrame(draw: () => void): () => void {
  let frame = 0;
  let dispose = () => {};
  const go = () => {
    dispose();
    let isFirst = true;
    dispose = effect(() => {
      if (isFirst) {
        isFirst = false;
        const began = performance.now();
        draw();
        frameTimes.push(performance.now() - began);
        if (frameTimes.length > 600) frameTimes.shift();
      } else {
        cancelAnimationFrame(frame);
        frame = requestAnimationFrame(go);
      }
    });
  };
  go();
  return () => {
    cancelAnimationFrame(frame);
    dispose();
  };
}
