/** The event of the moment before, during and after, with its parts along the normal and the tangent, and its numbers. */

import { useEffect, useMemo, useRef } from "preact/hooks";
import type { Moment } from "../../engine/film";
import { kineticEnergy, speedOf } from "../../studio/motion";
import { drawing, run } from "../../studio/store";
import { isDark } from "../../studio/theme";
import { type Quantity, withUnit } from "../../studio/units";
import { ballColours, DARK, LIGHT } from "../../table/colours";
import { Dot } from "../../table/Dot";
import { number, word } from "../../words";
import { type Encounter, encounterOf, parts } from "./encounter";
import { eventNow, kindWord } from "./log";
import { drawMoment, drawParts, type Ground } from "./pictures";

export function Strip() {
  const [shown, drawn, event] = [run.value, drawing.value, eventNow.value];
  const encounter = useMemo(
    () => (shown && drawn && event >= 0 ? encounterOf(shown, drawn, event) : null),
    [shown, drawn, event],
  );
  if (!shown || !drawn || !encounter) return <p class="hint">{word("stripHint")}</p>;
  const { normal, earlier, incoming, outgoing, later, time } = encounter;
  const kind = kindWord(shown.events.kind[event] as number);
  return (
    <section class="strip" aria-label={word("stripLabel")}>
      <h2>{word("eventAt", { index: event, kind, time: number(time, 5) })}</h2>
      <div class="pictures three">
        <Picture name={word("before")} encounter={encounter} moment={earlier} />
        <Picture name={word(normal ? "during" : "atEvent")} encounter={encounter} moment={incoming} />
        <Picture name={word("after")} encounter={encounter} moment={later} />
      </div>
      {normal && (
        <div class="pictures two">
          <Picture name={word("partsBefore")} encounter={encounter} moment={incoming} normal={normal} />
          <Picture name={word("partsAfter")} encounter={encounter} moment={outgoing} normal={normal} />
        </div>
      )}
      {normal && <p class="hint">{word("partsHint")}</p>}
      <Numbers encounter={encounter} />
    </section>
  );
}

interface PictureProps {
  name: string;
  encounter: Encounter;
  moment: Moment;
  /** Where it is given, the parts of the velocities are drawn. */
  normal?: [number, number];
}

function Picture({ name, encounter, moment, normal }: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const drawn = drawing.value;
  const palette = isDark.value ? DARK : LIGHT;
  useEffect(() => {
    const element = canvas.current;
    const pen = element?.getContext("2d");
    if (!element || !pen || !drawn) return;
    const colours = ballColours(drawn.balls);
    const observer = new ResizeObserver(() => {
      const [width, height, density] = [element.clientWidth, element.clientHeight, devicePixelRatio || 1];
      element.width = Math.round(width * density);
      element.height = Math.round(height * density);
      pen.setTransform(density, 0, 0, density, 0, 0);
      const ground: Ground = { pen, width, height, drawn, colours, palette };
      if (normal) drawParts(ground, encounter, moment, normal);
      else drawMoment(ground, encounter, moment);
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [encounter, moment, normal, palette, drawn]);
  const text = `${name} (${number(moment.time, 5)})`;
  return (
    <figure>
      <canvas ref={canvas} role="img" aria-label={text} />
      <figcaption>{name}</figcaption>
    </figure>
  );
}

/** A quantity of a ball at a moment. */
interface Row {
  name: string;
  quantity: Quantity;
  of: (moment: Moment, ball: number) => number;
  /** Whether there is a sum of it. */
  isSummed?: boolean;
}

function rowsFor({ normal }: Encounter): Row[] {
  const balls = drawing.value?.balls ?? [];
  const mass = (ball: number) => balls[ball]?.mass ?? 0;
  const vx = (moment: Moment, ball: number) => moment.vx[ball] as number;
  const vy = (moment: Moment, ball: number) => moment.vy[ball] as number;
  const part = (which: 0 | 1) => (moment: Moment, ball: number) =>
    normal ? parts(vx(moment, ball), vy(moment, ball), normal)[which] : 0;
  const energy = (moment: Moment, ball: number) => {
    const body = balls[ball];
    return body ? kineticEnergy(body, moment, ball) : 0;
  };
  return [
    { name: "vx", quantity: "speed", of: vx },
    { name: "vy", quantity: "speed", of: vy },
    { name: word("speedShort"), quantity: "speed", of: speedOf },
    ...(normal
      ? [
          { name: word("normalPart"), quantity: "speed", of: part(0) } as const,
          { name: word("tangentPart"), quantity: "speed", of: part(1) } as const,
        ]
      : []),
    { name: "px", quantity: "momentum", isSummed: true, of: (m, ball) => mass(ball) * vx(m, ball) },
    { name: "py", quantity: "momentum", isSummed: true, of: (m, ball) => mass(ball) * vy(m, ball) },
    { name: word("kineticShort"), quantity: "energy", isSummed: true, of: energy },
  ];
}

function Numbers({ encounter }: { encounter: Encounter }) {
  return (
    <table class="readings encounter">
      <thead>
        <tr>
          <th scope="col">{word("ball")}</th>
          <th scope="col">{word("before")}</th>
          <th scope="col">{word("after")}</th>
          <th scope="col">{word("changeOf")}</th>
        </tr>
      </thead>
      {rowsFor(encounter).map((row) => (
        <Group key={row.name} row={row} encounter={encounter} />
      ))}
    </table>
  );
}

/** A quantity: a line for each ball, and one for all together. */
function Group({ row, encounter }: { row: Row; encounter: Encounter }) {
  const { balls, incoming, outgoing } = encounter;
  const drawn = drawing.value?.balls ?? [];
  const colours = useMemo(() => ballColours(drawn), [drawn]);
  const sum = (moment: Moment) => balls.reduce((all, ball) => all + row.of(moment, ball), 0);
  return (
    <tbody>
      <tr>
        <th scope="rowgroup" colSpan={4}>
          {withUnit(row.name, row.quantity)}
        </th>
      </tr>
      {balls.map((ball) => (
        <Line key={ball} before={row.of(incoming, ball)} after={row.of(outgoing, ball)}>
          <Dot colour={colours[ball] ?? ""} /> {drawn[ball]?.id}
        </Line>
      ))}
      {row.isSummed && balls.length > 1 && (
        <Line before={sum(incoming)} after={sum(outgoing)}>
          {word("together")}
        </Line>
      )}
    </tbody>
  );
}

interface LineProps {
  before: number;
  after: number;
  children: preact.ComponentChildren;
}

/** So small a share of a change is what rounding leaves of none. */
const ROUNDING = 1e-13;

function Line({ before, after, children }: LineProps) {
  const change = after - before;
  const isNone = Math.abs(change) <= ROUNDING * Math.max(Math.abs(before), Math.abs(after));
  return (
    <tr>
      <th scope="row">{children}</th>
      <td>{number(before)}</td>
      <td>{number(after)}</td>
      <td>{isNone ? "0" : number(change)}</td>
    </tr>
  );
}
