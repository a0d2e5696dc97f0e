/** The numbers of the moment: where each ball is, how fast, with what momentum and energy. */

import { signal, useComputed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { kineticEnergy, speedOf } from "../../studio/motion";
import { chosen, drawing, run, time } from "../../studio/store";
import { withUnit } from "../../studio/units";
import { ballColours } from "../../table/colours";
import { Dot } from "../../table/Dot";
import { number, word } from "../../words";
import { totalsAt } from "./samples";

/** So many balls at most have a row. */
const MOST_ROWS = 40;
/** Milliseconds between two readings: faster ones cannot be read. */
const PAUSE = 100;

/** The time that is read. */
const read = signal(0);
/** The sums at that time, from the engine. */
const sums = signal<number[] | null>(null);

function follow(): () => void {
  let [timer, isAsking]: [ReturnType<typeof setTimeout> | undefined, boolean] = [undefined, false];
  const look = async () => {
    timer = undefined;
    read.value = time.peek();
    const shown = run.peek();
    if (isAsking || !shown?.isWhole) return;
    isAsking = true;
    const rows = await totalsAt(shown, Float64Array.of(time.peek()));
    isAsking = false;
    sums.value = rows?.[0] ?? null;
    if (time.peek() !== read.peek()) later();
  };
  const later = () => {
    timer ??= setTimeout(look, PAUSE);
  };
  void look();
  const ends = [time.subscribe(later), run.subscribe(later)];
  return () => {
    clearTimeout(timer);
    for (const end of ends) end();
  };
}

export function Values() {
  useEffect(follow, []);
  const moment = useComputed(() => run.value?.film.at(read.value));
  const balls = drawing.value?.balls ?? [];
  const state = moment.value;
  if (!state) return null;
  const colours = ballColours(balls);
  const rows = balls.map((_, ball) => ball).slice(0, MOST_ROWS);
  const pick = chosen.value;
  if (pick !== null && pick >= MOST_ROWS) rows.push(pick);
  const isOnCloth = run.value?.film.isOnCloth ?? false;
  const columns = [
    { name: "x", quantity: "length", of: (ball: number) => state.x[ball] },
    { name: "y", quantity: "length", of: (ball: number) => state.y[ball] },
    ...(isOnCloth ? [{ name: "z", quantity: "length", of: (ball: number) => state.z[ball] } as const] : []),
    { name: "vx", quantity: "speed", of: (ball: number) => state.vx[ball] },
    { name: "vy", quantity: "speed", of: (ball: number) => state.vy[ball] },
    { name: word("speedShort"), quantity: "speed", of: (ball: number) => speedOf(state, ball) },
    {
      name: word("momentumShort"),
      quantity: "momentum",
      of: (ball: number) => (balls[ball]?.mass ?? 0) * speedOf(state, ball),
    },
    {
      name: word("kineticShort"),
      quantity: "energy",
      of: (ball: number) => balls[ball] && kineticEnergy(balls[ball], state, ball),
    },
  ] as const;
  return (
    <figure class="graph">
      <figcaption>{word("valuesAt", { time: number(read.value) })}</figcaption>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached with the keyboard */}
      <section class="wide" tabIndex={0} aria-label={word("valuesNow")}>
        <table class="readings">
          <thead>
            <tr>
              <th scope="col">{word("ball")}</th>
              {columns.map(({ name, quantity }) => (
                <th scope="col" key={name}>
                  {withUnit(name, quantity)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((ball) => (
              <tr key={ball}>
                <th scope="row">
                  <Dot colour={colours[ball] ?? ""} /> {balls[ball]?.id}
                </th>
                {columns.map(({ name, of }) => (
                  <td key={name}>{reading(of(ball))}</td>
                ))}
              </tr>
            ))}
          </tbody>
          <Sums width={columns.length} />
        </table>
      </section>
      {balls.length > MOST_ROWS && <p class="hint">{word("onlySomeRows", { most: MOST_ROWS })}</p>}
    </figure>
  );
}

/** The sums over all balls: the size of the whole momentum and the kinetic energy. */
function Sums({ width }: { width: number }) {
  const [kinetic, , px = 0, py = 0] = sums.value ?? [];
  if (kinetic === undefined) return null;
  return (
    <tfoot>
      <tr>
        <th scope="row">{word("totalOf")}</th>
        <td colSpan={width - 2} />
        <td>{reading(Math.hypot(px, py))}</td>
        <td>{reading(kinetic)}</td>
      </tr>
    </tfoot>
  );
}

/** A ball that is out of play is nowhere. */
const reading = (value: number | undefined) =>
  value === undefined || Number.isNaN(value) ? "–" : number(value);
