/** Colours that can be seen on a ground. */

type Rgb = [number, number, number];

const known = new Map<string, Rgb>();

/** Red, green and blue of a CSS colour, from 0 to 255; a word that is no colour counts as grey. */
export function rgb(colour: string): Rgb {
  let parts = known.get(colour);
  if (!parts) {
    const pen = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    if (!pen) return [128, 128, 128];
    pen.fillStyle = "#808080";
    pen.fillStyle = colour;
    pen.fillRect(0, 0, 1, 1);
    const [red, green, blue] = pen.getImageData(0, 0, 1, 1).data;
    parts = [red ?? 128, green ?? 128, blue ?? 128];
    known.set(colour, parts);
  }
  return parts;
}

/** The relative luminance of WCAG 2. */
function luminance(colour: Rgb): number {
  const [red, green, blue] = colour.map((part) => {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  }) as Rgb;
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

function contrast(a: Rgb, b: Rgb): number {
  const [low, high] = [luminance(a), luminance(b)].sort((one, other) => one - other) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

const answers = new Map<string, string>();

/** The colour, drawn towards the ink until a line of it can be seen on the ground. */
export function visible(colour: string, ground: string, ink: string, ratio = 2): string {
  const key = [colour, ground, ink, ratio].join();
  const before = answers.get(key);
  if (before) return before;
  const [from, on, to] = [rgb(colour), rgb(ground), rgb(ink)];
  let mixed = from;
  for (let share = 0; share <= 1 && contrast(mixed, on) < ratio; share += 0.1) {
    mixed = from.map((part, k) => Math.round(part + ((to[k] as number) - part) * share)) as Rgb;
  }
  const answer = `rgb(${mixed.join(" ")})`;
  answers.set(key, answer);
  return answer;
}

/** Black or white: the one that is read better on a colour. */
export const inkOn = (colour: string): string => (luminance(rgb(colour)) > 0.3 ? "#000000" : "#ffffff");
