/** Pictures of the ready-made scenarios, computed one after the other while the page has nothing else to do. */

import { EngineLost } from "../engine/client";
import { Film } from "../engine/film";
import type { Drawing } from "../engine/protocol";
import { ballColours, type Palette } from "../table/colours";
import { drawBalls, drawTable, type Pen } from "../table/draw";
import { trail } from "../table/trails";
import { fitted } from "../table/view";
import { SCENARIOS } from "./scenarios";
import { engine } from "./store";

/** What a picture is drawn from. */
export interface Picture {
  drawing: Drawing;
  film: Film;
  end: number;
}

/** A picture shows so many events: more is a tangle. */
const MOST_EVENTS = 60;
const MARGIN = 10;
/** From so many balls on their paths are a tangle. */
const MANY = 30;

const pictures = new Map<string, Promise<Picture>>();
let last: Promise<unknown> = Promise.resolve();

/** The picture of a scenario; computed when its turn comes. */
export function pictureOf(name: string): Promise<Picture> {
  let picture = pictures.get(name);
  if (!picture) {
    // What made the engine give up was something else: so it is asked again.
    const again = (error: unknown) => (error instanceof EngineLost ? computed(name) : Promise.reject(error));
    picture = last.then(() => computed(name).catch(again));
    last = picture.catch(() => pictures.delete(name));
    pictures.set(name, picture);
  }
  return picture;
}

async function computed(name: string): Promise<Picture> {
  const { json, drawing } = await engine.ask("check", { text: SCENARIOS[name] ?? "", format: "toml" });
  const asked = { slot: "picture", json, mostEvents: MOST_EVENTS } as const;
  const { film, events, summary } = await engine.ask("run", asked);
  const end = events.time[MOST_EVENTS] ?? summary.endTime;
  return { drawing, film: new Film(film), end };
}

/** The table, the paths of the balls, and the balls where they start. */
export function drawPicture(pen: Pen, picture: Picture, size: [number, number], palette: Palette) {
  const { drawing, film, end } = picture;
  const view = fitted(drawing.table, ...size, MARGIN);
  const colours = ballColours(drawing.balls);
  const bodies = drawing.balls.map(({ radius }, ball) => ({ radius, colour: colours[ball] as string }));
  pen.clearRect(0, 0, ...size);
  drawTable(pen, drawing.table, view, palette);
  if (bodies.length <= MANY) {
    pen.lineWidth = 1.25;
    pen.lineJoin = "round";
    pen.globalAlpha = 0.75;
    bodies.forEach(({ colour }, ball) => {
      const points = trail(film, ball, end, MOST_EVENTS);
      pen.beginPath();
      for (let k = 0; k + 1 < points.length; k += 2) {
        pen.lineTo(view.x(points[k] as number), view.y(points[k + 1] as number));
      }
      pen.strokeStyle = colour;
      pen.stroke();
    });
    pen.globalAlpha = 1;
  }
  drawBalls(pen, bodies, film.at(0), view, palette);
}
