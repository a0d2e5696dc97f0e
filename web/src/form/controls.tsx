/** The parts that forms are put together from: rows with a name, an explanation and what is wrong, and their boxes. */

import type { ComponentChildren } from "preact";
import { word } from "../words";
import { explains, forget, problemsAt, refusals, refuse } from "./editing";
import { absentWord, type Schema } from "./schema";

/** The ids of the elements of a place. */
const idOf = (place: string) => `field-${withoutSpaces(place)}`;
const noteOf = (place: string) => `note-${withoutSpaces(place)}`;
const withoutSpaces = (place: string) => place.replace(/\s/g, "_");

/** What every control says of itself. */
export function attributes(place: string, isWrong = isWrongAt(place, false)) {
  return {
    id: idOf(place),
    "aria-invalid": isWrong ? ("true" as const) : ("false" as const),
    "aria-describedby": noteOf(place),
  };
}

export const isWrongAt = (place: string, isLeaf: boolean) => problemsAt(place, isLeaf).length > 0;

interface RowProps {
  place: string;
  label: string;
  schema: Schema;
  /** Set where there is something to unset. */
  onUnset?: (() => void) | undefined;
  /** Whether there are several controls, which a label cannot name. */
  isGroup?: boolean;
  children: ComponentChildren;
}

/** A line of a form. */
export function Row({ place, label, schema, onUnset, isGroup = false, children }: RowProps) {
  const cell = (
    <div class="cell">
      {children}
      {onUnset && <Unset label={label} onClick={onUnset} />}
    </div>
  );
  const note = <Note place={place} schema={schema} isLeaf />;
  if (isGroup) {
    return (
      <fieldset class="line" aria-describedby={noteOf(place)}>
        <legend>{label}</legend>
        {cell}
        {note}
      </fieldset>
    );
  }
  return (
    <div class="line" title={explains.value ? "" : (schema.description ?? "")}>
      <label for={idOf(place)}>{label}</label>
      {cell}
      {note}
    </div>
  );
}

const Unset = ({ label, onClick }: { label: string; onClick: () => void }) => (
  <Small sign="×" label={word("useDefault", { name: label })} onClick={onClick} />
);

/** A small button with a sign. */
export function Small({ sign, label, onClick }: { sign: string; label: string; onClick: () => void }) {
  return (
    <button type="button" class="small" title={label} aria-label={label} onClick={onClick}>
      {sign}
    </button>
  );
}

/** The explanation of a field, where it is asked for, and what is wrong with it. The engine speaks English. */
export function Note({ place, schema, isLeaf }: { place: string; schema: Schema; isLeaf: boolean }) {
  const problems = problemsAt(place, isLeaf);
  return (
    <div class="note" id={noteOf(place)} lang="en">
      {explains.value && schema.description && <Explanation text={schema.description} />}
      <div role="status">
        {problems.map((problem) => (
          <p class="wrong" key={problem.place + problem.message}>
            {problem.place !== place && <code>{problem.place}</code>} {problem.message}
          </p>
        ))}
      </div>
    </div>
  );
}

/** A text of the schema: what stands in back quotes is code. */
function Explanation({ text }: { text: string }) {
  return <p>{text.split("`").map((part, k) => (k % 2 === 1 ? <code key={part}>{part}</code> : part))}</p>;
}

/** What is shown where nothing is set. */
export function defaultText(
  schema: Schema,
  applies: unknown,
  named: (text: string) => string = String,
): string {
  const value = applies === undefined ? absentWord(schema) : String(applies);
  return value === null ? word("default") : word("defaultOf", { value: named(value) });
}

interface BoxProps {
  place: string;
  schema: Schema;
  value: unknown;
  applies?: unknown;
  /** Its name where it is one of several. */
  name?: string | undefined;
  isWrong?: boolean;
  /** Whether there is little room. */
  isShort?: boolean;
  /** What is typed; undefined where nothing is. */
  onValue: (value: number | undefined, text: string) => void;
}

/** A box for a number. */
export function NumberBox({ place, schema, value, applies, name, isWrong, isShort, onValue }: BoxProps) {
  const written = typeof value === "number" ? String(value) : "";
  const text = refusals.value[place]?.text ?? written;
  const limits = [schema.minimum ?? schema.exclusiveMinimum, schema.maximum ?? schema.exclusiveMaximum];
  return (
    <input
      type="number"
      {...attributes(place, isWrong ?? isWrongAt(place, true))}
      aria-label={name}
      value={text}
      min={limits[0]}
      max={limits[1]}
      step={stepOf(written, schema)}
      placeholder={isShort ? String(applies ?? "") : defaultText(schema, applies)}
      onKeyDown={(event) => {
        if (event.key === "Escape") forget(place);
      }}
      onChange={({ currentTarget: { value: typed, validity } }) => {
        if (validity.badInput || (typed !== "" && !Number.isFinite(Number(typed)))) {
          refuse(place, typed, [{ place, message: word("notANumber") }]);
        } else if (typed === written && place in refusals.peek()) forget(place);
        else onValue(typed === "" ? undefined : Number(typed), typed);
      }}
    />
  );
}

/** The arrow keys change the last digit that is written. */
function stepOf(text: string, { type, maximum }: Schema): number | "any" {
  if (type === "integer") return 1;
  if (text.includes("e")) return "any";
  const decimals = text.split(".")[1]?.length ?? 0;
  if (decimals > 0) return Number(`1e-${decimals}`);
  return maximum !== undefined && maximum <= 1 ? 0.1 : 1;
}

/** A box for a short text. */
export function TextBox(props: {
  place: string;
  value: string;
  placeholder?: string;
  onValue: (text: string) => void;
}) {
  const { place, value, placeholder = "", onValue } = props;
  return (
    <input
      type="text"
      {...attributes(place, isWrongAt(place, true))}
      value={refusals.value[place]?.text ?? value}
      placeholder={placeholder}
      onKeyDown={(event) => {
        if (event.key === "Escape") forget(place);
      }}
      onChange={({ currentTarget: { value: typed } }) =>
        typed === value ? forget(place) : onValue(typed.trim())
      }
    />
  );
}

/** A list of words to choose one from. */
export function Choice(props: {
  place: string;
  value: string;
  /** Its name where no label names it. */
  name?: string | undefined;
  choices: { value: string; label: string }[];
  onValue: (value: string) => void;
}) {
  const { place, value, name, choices, onValue } = props;
  return (
    <select
      {...attributes(place)}
      aria-label={name}
      value={refusals.value[place]?.text ?? value}
      onChange={({ currentTarget: { value: next } }) => (next === value ? forget(place) : onValue(next))}
    >
      {choices.map((choice) => (
        <option key={choice.value} value={choice.value}>
          {choice.label}
        </option>
      ))}
    </select>
  );
}
