/** Colours as the browser's picker has them. */

/** A colour of CSS as #rrggbb. */
export function hexadecimal(colour: string): string {
  const pen = document.createElement("canvas").getContext("2d");
  if (!pen) return "#888888";
  pen.fillStyle = colour;
  return pen.fillStyle;
}
