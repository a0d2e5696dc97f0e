/** The panel that lays another run over the one on the table, and says how far they are apart. */

import { drawing, run, seek } from "../../studio/store";
import { number, powerOfTen, word } from "../../words";
import { DifferenceGraph } from "./DifferenceGraph";
import {
  apart,
  compared,
  isStepped,
  nudged,
  nudgePower,
  numbers,
  type Overlay,
  other,
  overlay,
  refusals,
  step,
  stepPower,
} from "./state";
import "../../style/compare.css";

const OVERLAYS: Overlay[] = ["none", "stepped", "twin"];

export function Compare() {
  return (
    <div class="compare">
      <fieldset>
        <legend>{word("overlay")}</legend>
        {OVERLAYS.map((kind) => (
          <label key={kind}>
            <input
              type="radio"
              name="overlay"
              checked={overlay.value === kind}
              onChange={() => {
                overlay.value = kind;
              }}
            />
            {word(kind === "none" ? "overlayNone" : kind === "twin" ? "overlayTwin" : steppedLabel())}
          </label>
        ))}
      </fieldset>
      {overlay.value === "stepped" && !isStepped.value && <StepSlider />}
      {overlay.value === "twin" && <Nudge />}
      {refusals.value.map(({ place, message }) => (
        <p class="refusal" role="alert" key={place}>
          <code>{place}</code>: {message}
        </p>
      ))}
      <Parting />
      {compared.value && <DifferenceGraph />}
      <Audit />
    </div>
  );
}

const steppedLabel = () => (isStepped.value ? "overlayExact" : "overlayStepped");

function StepSlider() {
  return (
    <label class="field">
      <span>
        {word("timeStep")}: {number(step.value, 3)}
      </span>
      <input
        type="range"
        min={-4}
        max={0}
        step={0.05}
        value={stepPower.value}
        aria-valuetext={number(step.value, 3)}
        onInput={(event) => {
          stepPower.value = Number(event.currentTarget.value);
        }}
      />
    </label>
  );
}

function Nudge() {
  return (
    <>
      <label class="field">
        <span>{word("nudgedNumber")}</span>
        <select
          value={nudged.value}
          onChange={(event) => {
            nudged.value = event.currentTarget.value;
          }}
        >
          {numbers.value.map(([path, value]) => (
            <option key={path} value={path}>
              {path} = {value}
            </option>
          ))}
        </select>
      </label>
      <label class="field">
        <span>
          {word("nudge")}: {powerOfTen(nudgePower.value)}
        </span>
        <input
          type="range"
          min={-15}
          max={-1}
          step={1}
          value={nudgePower.value}
          aria-valuetext={powerOfTen(nudgePower.value)}
          onInput={(event) => {
            nudgePower.value = Number(event.currentTarget.value);
          }}
        />
      </label>
    </>
  );
}

/** When the runs part, with a way to go there. */
function Parting() {
  const found = compared.value;
  if (!found) return null;
  const { parting } = found;
  if (!parting) return <p>{word("neverParted", { apart: number(apart.value, 3) })}</p>;
  const ball = drawing.value?.balls[parting.ball]?.id ?? "";
  return (
    <p class="parting">
      {word("parted", { ball, time: number(parting.time, 6), apart: number(apart.value, 3) })}{" "}
      <button type="button" onClick={() => seek(parting.time)}>
        {word("goThere")}
      </button>
    </p>
  );
}

/** What both runs say of themselves. */
function Audit() {
  const [one, two] = [run.value, other.value];
  if (!one || !two) return null;
  const rows = [
    ["auditEnd", one.summary.endTime, two.summary.endTime],
    ["auditContacts", contacts(one), contacts(two)],
    ["auditEnergy", diagnosed(one, "final_energy"), diagnosed(two, "final_energy")],
    ["auditOverlap", diagnosed(one, "deepest_overlap"), diagnosed(two, "deepest_overlap")],
    ["auditLost", diagnosed(one, "lost_time"), diagnosed(two, "lost_time")],
  ] as const;
  return (
    <table class="audit">
      <thead>
        <tr>
          <td />
          <th scope="col">{word("thisRun")}</th>
          <th scope="col">{word("otherRun")}</th>
        </tr>
      </thead>
      <tbody>
        {rows.map(([label, a, b]) => (
          <tr key={label}>
            <th scope="row">{word(label)}</th>
            <td>{number(a)}</td>
            <td>{number(b)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

type Audited = NonNullable<typeof run.value>;

const diagnosed = ({ summary }: Audited, key: string) => Number(summary.diagnostics[key] ?? 0);

const contacts = ({ summary: { diagnostics } }: Audited) =>
  (diagnostics.events["ball_ball"] ?? 0) + (diagnostics.events["ball_cushion"] ?? 0);
