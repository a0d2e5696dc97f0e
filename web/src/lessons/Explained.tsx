/** What happened in a collision, with the numbers of this very event. */

import type { ComponentType } from "preact";
import { drawing, run } from "../studio/store";
import { number, word } from "../words";
import { signed, small, vector } from "./format";
import { distance, type Instant, isOfTwoBalls, justBefore } from "./instants";
import { collisions, idOf, other, part, past, TOTALS_WIDTH, totals } from "./state";
import type { Explanation } from "./types";

const EXPLAINED: Record<Explanation, ComponentType<{ instant: Instant }>> = {
  momentum: Momenta,
  velocity: Velocities,
  delay: Delays,
  distance: Distances,
};

export function Explained({ instant }: { instant: Instant }) {
  const Told = EXPLAINED[part.value?.explanation ?? "momentum"];
  return (
    <div class="explained">
      <h3>{word("collisionOf", { place: instant.place, time: number(instant.time) })}</h3>
      <p>{happened(instant)}</p>
      <Told instant={instant} />
    </div>
  );
}

/** Who met whom, and how hard. */
function happened({ first, after }: Instant): string {
  const events = run.value?.events;
  if (!events) return "";
  const told: string[] = [];
  for (let event = first; event < after; event++) {
    const [a, b] = [idOf(events.ballA[event] as number), idOf(events.ballB[event] as number)];
    const cushion = events.cushionIds[events.cushion[event] as number] ?? "";
    const values = { a, b, cushion, impulse: number(events.impulse[event] as number) };
    told.push(word(isOfTwoBalls(events, event) ? "twoMet" : "cushionHit", values));
  }
  return told.join(" ");
}

/** The balls that took part. */
function takingPart({ first, after }: Instant): number[] {
  const events = run.value?.events;
  if (!events) return [];
  const balls = new Set<number>();
  for (let event = first; event < after; event++) {
    for (const ball of [events.ballA[event] as number, events.ballB[event] as number]) {
      if (ball >= 0) balls.add(ball);
    }
  }
  return [...balls].sort((a, b) => a - b);
}

/** A quantity before and after, ball by ball. */
function Table(props: {
  caption: string;
  rows: [string, string, string][];
  sums: [string, string, string][];
}) {
  return (
    <table class="numbers">
      <caption>{props.caption}</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">{word("lessonBefore")}</th>
          <th scope="col">{word("lessonAfter")}</th>
        </tr>
      </thead>
      <tbody>
        {props.rows.map(([name, ...cells]) => (
          <Row key={name} name={name} cells={cells} />
        ))}
      </tbody>
      <tfoot>
        {props.sums.map(([name, ...cells]) => (
          <Row key={name} name={name} cells={cells} />
        ))}
      </tfoot>
    </table>
  );
}

function Row({ name, cells }: { name: string; cells: string[] }) {
  return (
    <tr>
      <th scope="row">{name}</th>
      {cells.map((cell, k) => (
        <td key={k}>{cell}</td>
      ))}
    </tr>
  );
}

/** Rows of mass × velocity, or of velocity alone. */
function rows(instant: Instant, isMomentum: boolean): [string, string, string][] {
  const [film, balls] = [run.value?.film, drawing.value?.balls];
  if (!film || !balls) return [];
  const told = (ball: number, time: number) => {
    const { vx, vy } = film.at(time);
    const mass = isMomentum ? (balls[ball]?.mass ?? 1) : 1;
    return [mass * (vx[ball] as number), mass * (vy[ball] as number)] as const;
  };
  return takingPart(instant).map((ball) => {
    const [was, is] = [told(ball, justBefore(instant.time)), told(ball, instant.time)];
    const scale = Math.hypot(...was) + Math.hypot(...is);
    return [idOf(ball), vector(was, isAlongX(), scale), vector(is, isAlongX(), scale)];
  });
}

/** Whether all that moves moves along x. */
function isAlongX(): boolean {
  return drawing.value?.balls.every(({ velocity, position }, _, [first]) => {
    return velocity[1] === 0 && position[1] === first?.position[1];
  }) as boolean;
}

/** Energy and momentum of all balls, from the engine. */
function sums({ place }: Instant): [string, string, string][] {
  const at = (row: number) => totals.value.subarray(row * TOTALS_WIDTH, (row + 1) * TOTALS_WIDTH);
  const [was, is] = [at(2 * place - 2), at(2 * place - 1)];
  if (is.length === 0) return [];
  const momentum = (row: Float64Array) => [row[2] as number, row[3] as number] as const;
  // A sum that is nothing is so beside the momenta that are in it: of the order of √(2 m E).
  const scale = Math.sqrt(2 * (was[0] as number) * heaviest());
  const energy = (row: Float64Array) => number(row[0] as number);
  return [
    [word("allMomentum"), vector(momentum(was), isAlongX(), scale), vector(momentum(is), isAlongX(), scale)],
    [word("allEnergy"), energy(was), energy(is)],
  ];
}

const heaviest = () => drawing.value?.balls.reduce((most, { mass }) => Math.max(most, mass), 0) ?? 0;

function Momenta({ instant }: { instant: Instant }) {
  const events = run.value?.events;
  const isCushion = events && !isOfTwoBalls(events, instant.first);
  return (
    <>
      <Table caption={word("momentumCaption")} rows={rows(instant, true)} sums={sums(instant)} />
      <p>{word(isCushion ? "cushionKeeps" : "ballsKeep")}</p>
    </>
  );
}

function Velocities({ instant }: { instant: Instant }) {
  const energy = sums(instant).slice(1);
  return <Table caption={word("velocityCaption")} rows={rows(instant, false)} sums={energy} />;
}

/** When each hit up to now came in the two runs. */
function Delays() {
  const [main, second] = [run.value, other.value];
  const ball = part.value?.watched ?? 0;
  const now = past.value.at(-1);
  if (!main || !second || !now) return null;
  return (
    <>
      <table class="numbers">
        <caption>{word("delayCaption")}</caption>
        <thead>
          <tr>
            <th scope="col">{word("lessonHit")}</th>
            <th scope="col">{word("lessonExact")}</th>
            <th scope="col">{word("lessonInSteps")}</th>
            <th scope="col">{word("lessonLater")}</th>
          </tr>
        </thead>
        <tbody>
          {past.value.map(({ first, place, time }) => {
            const stepped = counterpart(first);
            return (
              <Row
                key={place}
                name={partner(first, ball)}
                cells={[
                  number(time),
                  stepped === null ? "–" : number(stepped),
                  stepped === null ? "–" : lag(stepped, time),
                ]}
              />
            );
          })}
        </tbody>
      </table>
      <p>
        {word("lessonApartNow", {
          ball: idOf(ball),
          distance: small(distance([main, ball], [second, ball], now.time)),
        })}
      </p>
    </>
  );
}

/** How much later something came; a rounding error is none. */
const lag = (stepped: number, exact: number) =>
  signed(Math.abs(stepped - exact) < 1e-12 * exact ? 0 : stepped - exact, 2);

/** What a ball meets in an event: a cushion or another ball. */
function partner(event: number, ball: number): string {
  const events = run.value?.events;
  if (!events) return "";
  const cushion = events.cushionIds[events.cushion[event] as number];
  const [a, b] = [events.ballA[event] as number, events.ballB[event] as number];
  return cushion ?? idOf(a === ball ? b : a);
}

/** When the event happens in the other run: the one of the same balls and cushion, the same time over. */
function counterpart(event: number): number | null {
  const [events, others] = [run.value?.events, other.value?.events];
  if (!events || !others) return null;
  const signature = (of: typeof events, k: number) =>
    [of.kind[k], of.ballA[k], of.ballB[k], of.cushionIds[of.cushion[k] as number]].join();
  const mine = signature(events, event);
  let turn = 0;
  for (let k = 0; k <= event; k++) if (signature(events, k) === mine) turn++;
  for (let k = 0; k < others.time.length; k++) {
    if (signature(others, k) === mine && --turn === 0) return others.time[k] as number;
  }
  return null;
}

function Distances({ instant }: { instant: Instant }) {
  const main = run.value;
  if (!main) return null;
  const at = (time: number) => distance([main, 0], [main, 1], time);
  const previous = collisions.value[instant.place - 2];
  const now = at(instant.time);
  return (
    <p>
      {word("lessonApart", { distance: small(now) })}{" "}
      {previous && word("timesAsFar", { factor: number(now / at(previous.time), 3) })}
    </p>
  );
}
