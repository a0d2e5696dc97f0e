/** The panel with the balls: which there are, and all numbers of the chosen one. */

import { computed, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { StartingBall } from "../../engine/protocol";
import { chosen, drawing, scenario, written } from "../../studio/store";
import "../../style/setup.css";
import { Note, NumberBox, Row } from "../../form/controls";
import { attempt, effective, loadSchema, placeOf, schema } from "../../form/editing";
import { Field, Fields } from "../../form/Field";
import { keyLabel } from "../../form/labels";
import { type Step, valueAt } from "../../form/paths";
import { plain, type Schema } from "../../form/schema";
import {
  addBall,
  canChange,
  LIST,
  removeBall,
  stepsOf,
  withSpeed,
  withVelocity,
  writtenBalls,
} from "../../studio/balls";
import { ballColours } from "../../table/colours";
import { Dot } from "../../table/Dot";
import { number, word } from "../../words";
import { PlainBalls } from "./PlainBalls";

/** From so many balls on they are looked for by their ids. */
const MANY = 30;
/** So many are listed at most. */
const MOST_LISTED = 60;

/** What the ids of the listed balls contain. */
const sought = signal("");
const colours = computed(() => ballColours(drawing.value?.balls ?? []));

export function Balls() {
  useEffect(() => void loadSchema(), []);
  const drawn = drawing.value;
  if (!schema.value || !scenario.value || !drawn) return <p class="faint">{word("loading")}</p>;
  const ball = chosen.value === null ? undefined : drawn.balls[chosen.value];
  return (
    <form class="setup" noValidate autocomplete="off" onSubmit={(event) => event.preventDefault()}>
      <PlainBalls />
      <List balls={drawn.balls} />
      <Note place={LIST} schema={{}} isLeaf={false} />
      {canChange() && (
        <div class="buttons">
          <button type="button" onClick={addBall}>
            {word("addBall")}
          </button>
          {ball && chosen.value !== null && chosen.value < writtenBalls().length && (
            <button type="button" onClick={() => removeBall(chosen.peek() ?? 0)}>
              {word("removeBall", { id: ball.id })}
            </button>
          )}
        </div>
      )}
      {ball && chosen.value !== null && canChange() ? (
        <Numbers key={ball.id} ball={chosen.value} start={ball} />
      ) : (
        <p class="faint">{word(canChange() ? "chooseBall" : "gasBalls")}</p>
      )}
    </form>
  );
}

function List({ balls }: { balls: StartingBall[] }) {
  const found = balls
    .map(({ id }, ball) => ({ id, ball }))
    .filter(({ id, ball }) => id.includes(sought.value) || ball === chosen.value);
  const listed = found.slice(0, MOST_LISTED);
  return (
    <>
      {balls.length > MANY && (
        <label class="line">
          {word("seekBall")}
          <input
            type="search"
            value={sought.value}
            onInput={(event) => {
              sought.value = event.currentTarget.value;
            }}
          />
        </label>
      )}
      <ul class="balls" aria-label={word("balls")}>
        {listed.map(({ id, ball }) => (
          <li key={id}>
            <button
              type="button"
              aria-pressed={ball === chosen.value}
              onClick={() => {
                chosen.value = ball === chosen.peek() ? null : ball;
              }}
            >
              <Dot colour={colours.value[ball] ?? ""} />
              {id}
            </button>
          </li>
        ))}
      </ul>
      {found.length > listed.length && (
        <p class="faint">{word("moreBalls", { count: number(found.length - listed.length, 6) })}</p>
      )}
    </>
  );
}

/** The keys of a ball that have fields as all others; on a cloth there are more. */
const FIRST = ["radius", "mass", "color"];
const ON_CLOTH = ["spin", "sliding_friction", "rolling_friction", "spin_decay"];

/** All that a ball starts with. */
function Numbers({ ball, start }: { ball: number; start: StartingBall }) {
  const root = schema.value;
  if (!root) return null;
  const part = plain({ $ref: "#/$defs/Ball" }, root);
  const steps = stepsOf(ball);
  const common = { ...(effective.value["ball_defaults"] ?? {}), ...(written.value["ball_defaults"] ?? {}) };
  const applies = { ...common, ...start, color: undefined, spin: start.spin?.map(tidyZero) };
  const isFlat = (valueAt(written.value, [...steps, "velocity"]) as number[] | undefined)?.length !== 3;
  return (
    <section class="ball" aria-label={word("ballTitle", { id: start.id })}>
      <h2>{word("ballTitle", { id: start.id })}</h2>
      <Named steps={steps} start={start} schema={part.properties?.["id"] ?? {}} />
      <Field
        schema={part.properties?.["position"] ?? {}}
        steps={[...steps, "position"]}
        isNeeded={ball < writtenBalls().length}
        applies={start.position}
      />
      <Velocity {...{ ball, steps, start }} schema={part.properties?.["velocity"] ?? {}} />
      {isFlat && (
        <>
          <Polar {...{ ball, steps, start }} name="speed" schema={part.properties?.["speed"] ?? {}} />
          <Polar
            {...{ ball, steps, start }}
            name="direction_deg"
            schema={part.properties?.["direction_deg"] ?? {}}
          />
        </>
      )}
      <Fields schema={part} {...{ steps, applies }} only={FIRST} />
      {drawing.value?.isOnCloth && <Fields schema={part} {...{ steps, applies }} only={ON_CLOTH} />}
    </section>
  );
}

/** Without the sign of a zero. */
const tidyZero = (value: number) => value + 0;

/** The ball's id, under which it stays chosen; a ball of the rack has that of its game. */
function Named({ steps, start, schema }: { steps: readonly Step[]; start: StartingBall; schema: Schema }) {
  if (typeof steps[1] === "string") return null;
  return <Field schema={schema} steps={[...steps, "id"]} isNeeded applies={start.id} />;
}

interface BallProps {
  ball: number;
  steps: readonly Step[];
  start: StartingBall;
  schema: Schema;
}

/** The components of the velocity, which take the place of speed and direction. */
function Velocity({ ball, steps, start, schema }: BallProps) {
  const place = placeOf([...steps, "velocity"]);
  const value = valueAt(written.value, [...steps, "velocity"]) as number[] | undefined;
  const count = drawing.value?.isOnCloth ? 3 : 2;
  const names = ["x", "y", "z"].slice(0, count);
  const set = (at: number, typed: number | undefined, text: string) => {
    const all: (number | null)[] = names.map(
      (_, k) => (k === at ? typed : (value?.[k] ?? start.velocity[k])) ?? 0,
    );
    const isFlat = count === 3 && all[2] === 0;
    void attempt(`${place}[${at}]`, text, withVelocity(ball, isFlat ? all.slice(0, 2) : all));
  };
  return (
    <Row
      {...{ place, schema }}
      label={keyLabel("velocity")}
      isGroup
      onUnset={value && (() => void attempt(place, "", withVelocity(ball, null)))}
    >
      {names.map((name, k) => (
        <NumberBox
          key={name}
          place={`${place}[${k}]`}
          schema={{ type: "number", description: "" }}
          value={value?.[k] ?? shortened(start.velocity[k] ?? 0)}
          name={`${keyLabel("velocity")} ${name}`}
          onValue={(typed, text) => set(k, typed, text)}
        />
      ))}
    </Row>
  );
}

/** Speed or direction, which take the place of the components. */
function Polar({ ball, steps, start, schema, name }: BallProps & { name: "speed" | "direction_deg" }) {
  const place = placeOf([...steps, name]);
  const [x = 0, y = 0] = start.velocity;
  const shown = name === "speed" ? Math.hypot(x, y) : (Math.atan2(y, x) * 180) / Math.PI;
  return (
    <Row {...{ place, schema }} label={keyLabel(name)}>
      <NumberBox
        {...{ place, schema }}
        value={valueAt(written.value, [...steps, name]) ?? shortened(shown)}
        onValue={(typed, text) => {
          if (typed !== undefined) void attempt(place, text, withSpeed(ball, name, typed));
          else void attempt(place, text, withVelocity(ball, null));
        }}
      />
    </Row>
  );
}

/** A number that follows from others, as far as it is read. */
const shortened = (value: number) => Number(value.toPrecision(7)) + 0;
