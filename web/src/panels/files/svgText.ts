/** Texts in pictures: svgcanvas reads a font by way of an inline style, which the page's policy forbids. */

import type { Context } from "svgcanvas";

const FONT = /^(?:(\d+|bold|normal) )?([\d.]+px) (.+)$/;
const ANCHORS: Record<string, string> = { center: "middle", right: "end", end: "end" };
const BASELINES: Record<string, string> = { middle: "central", top: "hanging", hanging: "hanging" };

/** Has texts put in without an inline style. */
export function withTexts(pen: Context): Context {
  pen.__applyText = (text, x, y, action) => {
    const [, weight = "normal", size = "10px", family = "sans-serif"] = FONT.exec(pen.font) ?? [];
    const parent = pen.__closestGroupOrSvg();
    const attributes = {
      "font-family": family,
      "font-size": size,
      "font-weight": weight,
      "text-anchor": ANCHORS[pen.textAlign] ?? "start",
      "dominant-baseline": BASELINES[pen.textBaseline] ?? "alphabetic",
      x,
      y,
    };
    const element = pen.__createElement("text", attributes, true);
    element.textContent = text;
    pen.__currentElement = element;
    pen.__applyTransformation(element);
    pen.__applyStyleToCurrentElement(action);
    parent.appendChild(element);
  };
  return pen;
}
