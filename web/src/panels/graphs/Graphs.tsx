/** The panel of graphs: energy, momentum, speed and distance against time, and the numbers of the moment. */

import { signal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { drawing, run } from "../../studio/store";
import { ballColours } from "../../table/colours";
import { word } from "../../words";
import type { Word } from "../../words/en";
import { Chart, type Line } from "./Chart";
import { type Curve, curves, followTotals, MOST_CURVES, type Totals, totals } from "./samples";
import { Values } from "./Values";
import { Vectors } from "./Vectors";
import "../../style/graphs.css";

const GRAPHS = ["energy", "momentum", "vectors", "speed", "distance", "values"] as const;
type Graph = (typeof GRAPHS)[number];

const NAMES: Record<Graph, Word> = {
  energy: "energy",
  momentum: "momentum",
  vectors: "momentumVectors",
  speed: "speedOfBalls",
  distance: "distance",
  values: "valuesNow",
};

/** What there is of single balls only. */
const OF_BALLS = new Set<Graph>(["speed", "distance"]);

/** The graphs that are shown. */
const shown = signal<ReadonlySet<Graph>>(new Set<Graph>(["energy", "momentum", "vectors", "values"]));

export function Graphs() {
  useEffect(followTotals, []);
  const found = totals.value;
  const film = run.value?.film;
  const isFresh = found !== null && found.of === run.value;
  const single = useMemo(() => (film && isFresh ? curves(film, found.times) : []), [film, isFresh, found]);
  const count = drawing.value?.balls.length ?? 0;
  return (
    <div class="graphs">
      <fieldset class="choices">
        <legend class="unseen">{word("graphs")}</legend>
        {GRAPHS.filter((graph) => count <= MOST_CURVES || !OF_BALLS.has(graph)).map((graph) => (
          <button
            type="button"
            class="chip"
            key={graph}
            aria-pressed={shown.value.has(graph)}
            onClick={() => switchOver(graph)}
          >
            {word(NAMES[graph])}
          </button>
        ))}
      </fieldset>
      {count > MOST_CURVES && <p class="hint">{word("onlyTotals", { most: MOST_CURVES })}</p>}
      {found && isFresh ? (
        <Charts found={found} single={single} />
      ) : (
        <p class="hint" role="status">
          {word("graphsWait")}
        </p>
      )}
      {shown.value.has("values") && <Values />}
    </div>
  );
}

function switchOver(graph: Graph) {
  const graphs = new Set(shown.peek());
  if (!graphs.delete(graph)) graphs.add(graph);
  shown.value = graphs;
}

function Charts({ found, single }: { found: Totals; single: Curve[] }) {
  const balls = drawing.value?.balls ?? [];
  const colours = useMemo(() => ballColours(balls), [balls]);
  const perBall = (values: (curve: Curve, ball: number) => Float64Array): Line[] =>
    single.map((curve, ball) => ({
      name: balls[ball]?.id ?? "",
      colour: colours[ball] as string,
      values: values(curve, ball),
    }));
  const momentum = (axis: "x" | "y") =>
    perBall((curve, ball) => {
      const mass = balls[ball]?.mass ?? 0;
      return (axis === "x" ? curve.vx : curve.vy).map((velocity) => mass * velocity);
    });
  const { times } = found;
  const least = useMemo(() => 0.02 * largestMomentum(found, balls), [found]);
  const words = [word("totalOf"), word("kinetic"), word("potential")].join();
  const lines = useMemo(
    () => ({
      energy: energyLines(found),
      x: [{ name: word("totalOf"), values: found.px }, ...momentum("x")],
      y: [{ name: word("totalOf"), values: found.py }, ...momentum("y")],
      speed: perBall(({ speed }) => speed),
      distance: perBall(({ distance }) => distance),
    }),
    [found, single, words],
  );
  const has = (graph: Graph) => shown.value.has(graph);
  return (
    <>
      {has("energy") && <Chart name={word("energy")} quantity="energy" times={times} lines={lines.energy} />}
      {has("momentum") && (
        <Chart name={word("momentumX")} quantity="momentum" times={times} lines={lines.x} least={least} />
      )}
      {has("momentum") && (
        <Chart name={word("momentumY")} quantity="momentum" times={times} lines={lines.y} least={least} />
      )}
      {has("vectors") && <Vectors found={found} single={single} />}
      {has("speed") && single.length > 0 && (
        <Chart name={word("speedOfBalls")} quantity="speed" times={times} lines={lines.speed} />
      )}
      {has("distance") && single.length > 0 && (
        <Chart name={word("distance")} quantity="length" times={times} lines={lines.distance} />
      )}
    </>
  );
}

/** No momentum of balls of so much mass and energy is larger than this. */
function largestMomentum({ kinetic }: Totals, balls: { mass: number }[]): number {
  const mass = balls.reduce((sum, ball) => sum + ball.mass, 0);
  return Math.sqrt(2 * mass * kinetic.reduce((most, energy) => Math.max(most, energy), 0));
}

/** Without a field or height there is kinetic energy only. */
function energyLines({ kinetic, potential }: Totals): Line[] {
  if (potential.every((value) => value === 0)) return [{ name: word("kinetic"), values: kinetic }];
  const sum = kinetic.map((value, k) => value + (potential[k] as number));
  return [
    { name: word("totalOf"), values: sum },
    { name: word("kinetic"), colour: "#2b6cb0", values: kinetic },
    { name: word("potential"), colour: "#c8402f", values: potential, isDashed: true },
  ];
}
