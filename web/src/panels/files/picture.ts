/** The table at the present time as a picture, drawn by the layers that draw it on the page. */

import { drawing } from "../../studio/store";
import { isDark } from "../../studio/theme";
import { DARK, LIGHT } from "../../table/colours";
import type { Pen } from "../../table/draw";
import { layers } from "../../table/layers";
import { sceneOf } from "../../table/Table";
import { aspect } from "../../table/view";
import { withTexts } from "./svgText";

/** Pixels of the longer side, with the margin around the table; a picture of pixels has so many for each of them. */
const LONG = 1000;
const SHORTEST = 160;
const MARGIN = 28;
const DENSITY = 2;

/** The ground behind the table, as on the page. */
const ground = () => (isDark.peek() ? "#12181a" : "#f6f7f6");

export async function pngPicture(): Promise<Blob> {
  const [width, height] = size();
  const canvas = document.createElement("canvas");
  canvas.width = width * DENSITY;
  canvas.height = height * DENSITY;
  const pen = canvas.getContext("2d");
  if (!pen) throw new Error("a canvas without a context");
  pen.scale(DENSITY, DENSITY);
  paint(pen, width, height);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no picture"))), "image/png");
  });
}

export async function svgPicture(): Promise<Blob> {
  const { Context } = await import("svgcanvas");
  const [width, height] = size();
  const pen = withTexts(new Context({ width, height }));
  // With it a drawing that is made smaller or larger is scaled, and not cut off.
  pen.getSvg().setAttribute("viewBox", `0 0 ${width} ${height}`);
  paint(pen as unknown as Pen, width, height);
  return new Blob([pen.getSerializedSvg()], { type: "image/svg+xml" });
}

/** Width and height: the longer side of the table is given. */
function size(): [number, number] {
  const drawn = drawing.peek();
  const ratio = drawn ? aspect(drawn.table) : 1;
  const inner = LONG - 2 * MARGIN;
  const [width, height] = ratio >= 1 ? [inner, inner / ratio] : [inner * ratio, inner];
  return [width, height].map((side) => Math.round(Math.max(side + 2 * MARGIN, SHORTEST))) as [number, number];
}

function paint(pen: Pen, width: number, height: number) {
  const drawn = drawing.peek();
  if (!drawn) return;
  pen.fillStyle = ground();
  pen.fillRect(0, 0, width, height);
  const scene = sceneOf(drawn, width, height, isDark.peek() ? DARK : LIGHT);
  for (const layer of layers) layer(pen, scene);
}
