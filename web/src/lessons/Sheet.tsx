/** The sheet of a lesson on paper: its questions, a picture of each table, and room for answers. */

import { useEffect, useRef } from "preact/hooks";
import type { Drawing } from "../engine/protocol";
import { ballColours, LIGHT } from "../table/colours";
import { drawArrow, drawBalls, drawTable } from "../table/draw";
import { aspect, fitted } from "../table/view";
import { word } from "../words";
import { drawingOf } from "./state";
import type { Lesson, Part } from "./types";

/** Pixels of a picture; paper has about four for each on the screen. */
const LONGER = 300;
const DENSITY = 4;
const MARGIN = 6;
/** Lines for an answer. */
const ROOM = 3;

export function Sheet({ lesson }: { lesson: Lesson }) {
  return (
    <section class="sheet" aria-hidden="true">
      <header>
        <p>{word("title")}</p>
        <p>{word("sheetName")}</p>
      </header>
      <h1>{word(lesson.title)}</h1>
      <p>{word(lesson.line)}</p>
      {lesson.parts.map((part, k) => (
        <article key={part.title}>
          <h2>
            {k + 1}. {word(part.title)}
          </h2>
          <div class="sheet-part">
            <Picture part={part} />
            <div>
              <p>{word(part.intro)}</p>
              <p>
                <strong>{word(part.question.text)}</strong>
              </p>
              <Room part={part} />
            </div>
          </div>
        </article>
      ))}
      <h2>{word("sheetWhy")}</h2>
      <Lines count={ROOM + 1} />
    </section>
  );
}

function Room({ part: { question } }: { part: Part }) {
  return (
    <>
      {question.kind === "choice" && (
        <ul class="boxes">
          {question.choices.map((choice) => (
            <li key={choice}>{word(choice)}</li>
          ))}
        </ul>
      )}
      {question.kind === "direction" && <p>{word("sheetDraw")}</p>}
      <p class="blank">{word("sheetPrediction")}</p>
      <p class="blank">{word("sheetRun")}</p>
      <p>{word("sheetExplain")}</p>
      <Lines count={ROOM} />
    </>
  );
}

function Lines({ count }: { count: number }) {
  return (
    <>
      {Array.from({ length: count }, (_, k) => (
        <div class="ruled" key={k} />
      ))}
    </>
  );
}

/** The table at the start, with the velocities but not the paths: those are the answers. */
function Picture({ part }: { part: Part }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    // Where the engine fails the page says so; the sheet then has an empty picture.
    drawingOf(part).then(
      (drawing) => {
        if (canvas.current) draw(canvas.current, drawing);
      },
      () => {},
    );
  }, [part]);
  return <canvas ref={canvas} width={LONGER} height={LONGER} />;
}

function draw(canvas: HTMLCanvasElement, { table, balls }: Drawing) {
  const shape = aspect(table);
  const [width, height] = shape > 1 ? [LONGER, LONGER / shape] : [LONGER * shape, LONGER];
  canvas.width = (width + 2 * MARGIN) * DENSITY;
  canvas.height = (height + 2 * MARGIN) * DENSITY;
  const pen = canvas.getContext("2d");
  if (!pen) return;
  pen.scale(DENSITY, DENSITY);
  const view = fitted(table, width + 2 * MARGIN, height + 2 * MARGIN, MARGIN);
  const colours = ballColours(balls);
  const at = (component: number) => Float64Array.from(balls, ({ position }) => position[component] as number);
  const [x, y] = [at(0), at(1)];
  drawTable(pen, table, view, LIGHT);
  const bodies = balls.map(({ radius }, ball) => ({ radius, colour: colours[ball] as string }));
  drawBalls(pen, bodies, { x, y }, view, LIGHT);
  const fastest = Math.max(...balls.map(({ velocity }) => Math.hypot(...velocity)));
  balls.forEach(({ position, velocity }) => {
    const [px, py, vx, vy] = [...position.slice(0, 2), ...velocity.slice(0, 2)] as [
      number,
      number,
      number,
      number,
    ];
    const seconds = (0.2 * table.size) / fastest;
    drawArrow(
      pen,
      [view.x(px), view.y(py)],
      [view.x(px + vx * seconds), view.y(py + vy * seconds)],
      LIGHT.ink,
    );
  });
}
