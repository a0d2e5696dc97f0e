/** A picture of a ready-made scenario, drawn when it comes into view. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { DARK, LIGHT } from "../table/colours";
import { isDark } from "./theme";
import { drawPicture, type Picture, pictureOf } from "./thumbnails";

export function Thumbnail({ name }: { name: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const picture = useSignal<Picture | null>(null);
  const palette = isDark.value ? DARK : LIGHT;

  useEffect(() => {
    const element = canvas.current;
    if (!element) return;
    let isGone = false;
    const observer = new IntersectionObserver(([entry]) => {
      if (!entry?.isIntersecting) return;
      observer.disconnect();
      // A picture that cannot be had leaves its place empty; opening the scenario tells why.
      pictureOf(name).then(
        (found) => {
          if (!isGone) picture.value = found;
        },
        () => {},
      );
    });
    observer.observe(element);
    return () => {
      isGone = true;
      observer.disconnect();
    };
  }, [name]);

  useEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen || !picture.value) return;
    const { clientWidth, clientHeight } = pen.canvas;
    const density = Math.max(window.devicePixelRatio, 2);
    pen.canvas.width = clientWidth * density;
    pen.canvas.height = clientHeight * density;
    pen.setTransform(density, 0, 0, density, 0, 0);
    drawPicture(pen, picture.value, [clientWidth, clientHeight], palette);
  }, [picture.value, palette]);

  return (
    <span class="thumbnail" aria-hidden="true">
      <canvas ref={canvas} data-drawn={picture.value !== null} />
    </span>
  );
}
