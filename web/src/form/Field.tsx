/** A field of a scenario, made from the part of the schema that describes it. */

import { drawing, vocabulary, written } from "../studio/store";
import { ballColours } from "../table/colours";
import { word } from "../words";
import { hexadecimal } from "./colour";
import { Choice, defaultText, isWrongAt, Note, NumberBox, Row, Small, TextBox } from "./controls";
import { attempt, attemptFirst, effective, placeOf, refusals, schema as rootSchema, set } from "./editing";
import { fresh } from "./fresh";
import { choiceLabel, keyLabel } from "./labels";
import { ListField, MapField } from "./lists";
import { pathOf, type Step, valueAt } from "./paths";
import { movedEnd, type Piece, turned } from "./pieces";
import { surroundings } from "./room";
import { absentWord, kindOf, nameOf, plain, type Schema, tagOf, variantOf, variantsOf } from "./schema";
import { movedShare } from "./shares";

export interface FieldProps {
  schema: Schema;
  steps: readonly Step[];
  label?: string;
  /** Whether it cannot be left out. */
  isNeeded?: boolean;
  /** What applies where nothing is written, if that is known. */
  applies?: unknown;
  /** What is done with another form of the value, in place of putting it in. */
  onForm?: (value: unknown, text: string, place: string) => void;
}

/** What the fields of all kinds go by. */
export interface Part extends FieldProps {
  root: Schema;
  label: string;
  place: string;
  key: string;
  value: unknown;
  onUnset: (() => void) | undefined;
}

export function Field(props: FieldProps) {
  const root = rootSchema.value;
  if (!root) return null;
  const { steps, isNeeded = false } = props;
  const schema = plain(props.schema, root);
  const key = String(steps.findLast((step) => typeof step === "string") ?? "");
  const value = valueAt(written.value, steps);
  const applies = props.applies ?? valueAt(effective.value, steps);
  const onUnset = isNeeded || value === undefined ? undefined : () => void set(steps, undefined);
  const label = props.label ?? keyLabel(key);
  const part: Part = { ...props, root, schema, key, value, applies, onUnset, label, place: placeOf(steps) };
  return FIELDS[kindOf(schema, root)](part);
}

const FIELDS: Record<ReturnType<typeof kindOf>, (part: Part) => preact.JSX.Element> = {
  number: NumberField,
  boolean: BooleanField,
  text: TextField,
  colour: ColourField,
  choice: ChoiceField,
  row: RowField,
  flags: FlagsField,
  list: ListField,
  map: MapField,
  object: ObjectField,
  variants: VariantsField,
};

function NumberField({ place, label, schema, steps, value, applies, onUnset }: Part) {
  const change = (typed: number | undefined, text: string) => {
    const shares = movedShare(steps, typed);
    void (shares ? attempt(place, text, shares) : set(steps, typed, text));
  };
  return (
    <Row {...{ place, label, schema, onUnset }}>
      <NumberBox {...{ place, schema, value, applies }} onValue={change} />
    </Row>
  );
}

function BooleanField({ place, label, schema, steps, value, applies, onUnset }: Part) {
  const named = (text: string) => word(text === "true" ? "yes" : "no");
  return (
    <Row {...{ place, label, schema, onUnset }}>
      <Choice
        place={place}
        value={value === undefined ? "" : String(value)}
        choices={[
          { value: "", label: defaultText(schema, applies, named) },
          { value: "true", label: word("yes") },
          { value: "false", label: word("no") },
        ]}
        onValue={(chosen) => set(steps, chosen === "" ? undefined : chosen === "true", chosen)}
      />
    </Row>
  );
}

function TextField({ place, label, schema, steps, value, applies, isNeeded, onUnset }: Part) {
  return (
    <Row {...{ place, label, schema, onUnset }}>
      <TextBox
        place={place}
        value={String(value ?? "")}
        placeholder={isNeeded ? "" : String(applies ?? "")}
        onValue={(text) => set(steps, text === "" && !isNeeded ? undefined : text, text)}
      />
    </Row>
  );
}

/** A colour: its name or number, and beside it the picker of the browser. */
function ColourField({ place, label, schema, steps, value, applies, onUnset }: Part) {
  const ball = steps[0] === "balls" ? Number(/\d+/.exec(place)?.[0] ?? -1) : -1;
  const shown = ballColours(drawing.value?.balls ?? [])[ball] ?? "#888888";
  const text = Array.isArray(value) ? JSON.stringify(value) : String(value ?? "");
  return (
    <Row {...{ place, label, schema, onUnset }}>
      <input
        type="color"
        class="swatch"
        aria-label={word("pickColour", { name: label })}
        value={hexadecimal(shown)}
        onChange={(event) => set(steps, event.currentTarget.value)}
      />
      <TextBox
        place={place}
        value={text}
        placeholder={defaultText({}, applies)}
        onValue={(typed) => set(steps, typed === "" ? undefined : colourOf(typed), typed)}
      />
    </Row>
  );
}

/** Three numbers are typed in brackets, as they stand in files. */
function colourOf(text: string): unknown {
  try {
    return text.startsWith("[") ? JSON.parse(text) : text;
  } catch {
    return text;
  }
}

function ChoiceField({ place, label, schema, steps, value, applies, isNeeded, onUnset, key }: Part) {
  const titles = key === "preset" ? new Map(vocabulary.value?.presets) : new Map<string, string>();
  const named = (name: string) => titles.get(name) ?? choiceLabel(name);
  const choices = variantsOf(schema).map(({ const: name = "" }) => ({ value: name, label: named(name) }));
  const none = { value: "", label: defaultText(schema, applies, named) };
  return (
    <Row {...{ place, label, schema, onUnset }}>
      <Choice
        place={place}
        value={String(value ?? "")}
        choices={isNeeded ? choices : [none, ...choices]}
        onValue={(chosen) => set(steps, chosen === "" ? undefined : chosen, chosen)}
      />
    </Row>
  );
}

/** Names for the numbers of a row; others have none. */
const AXES = ["x", "y", "z"];

function RowField({ place, label, schema, root, steps, value, applies, onUnset }: Part) {
  const { minItems = 2, maxItems = minItems } = schema;
  const numbers = (Array.isArray(value) ? value : []) as unknown[];
  const others = (Array.isArray(applies) ? applies : []) as unknown[];
  const count = Math.max(drawing.value?.isOnCloth ? maxItems : minItems, numbers.length);
  const change = (at: number, typed: number | undefined, text: string) => {
    const before = (k: number) => numbers[k] ?? (k < minItems ? others[k] : null);
    const all = Array.from({ length: count }, (_, k) => (k === at ? typed : before(k)) ?? null);
    while (all.length > minItems && all.at(-1) === null) all.pop();
    const isEmpty = all.every((number) => number === null);
    const values = movedEnd(steps, all) ?? { [pathOf(steps)]: isEmpty ? null : all };
    void attempt(`${place}[${at}]`, text, values);
  };
  return (
    <Row {...{ place, label, schema, onUnset }} isGroup>
      {Array.from({ length: count }, (_, k) => (
        <NumberBox
          key={AXES[k]}
          place={`${place}[${k}]`}
          schema={plain(schema.items ?? {}, root)}
          value={numbers[k]}
          applies={others[k]}
          name={`${label} ${AXES[k]}`}
          isShort
          isWrong={isWrongAt(place, false) || isWrongAt(`${place}[${k}]`, false)}
          onValue={(typed, text) => change(k, typed, text)}
        />
      ))}
    </Row>
  );
}

function FlagsField({ place, label, schema, root, steps, value, applies, onUnset }: Part) {
  const choices = variantsOf(plain(schema.items ?? {}, root)).map((variant) => variant.const ?? "");
  const without = absentWord(schema) === "both" ? choices : [];
  const chosen = new Set((value ?? applies ?? without) as string[]);
  return (
    <Row {...{ place, label, schema, onUnset }} isGroup>
      {choices.map((choice) => (
        <label key={choice} class="flag">
          <input
            type="checkbox"
            checked={chosen.has(choice)}
            aria-invalid={isWrongAt(place, true)}
            onChange={({ currentTarget }) => {
              const next = choices.filter((other) =>
                other === choice ? currentTarget.checked : chosen.has(other),
              );
              void set(steps, next).then((isIn) => {
                if (!isIn) currentTarget.checked = chosen.has(choice);
              });
            }}
          />
          {choiceLabel(choice)}
        </label>
      ))}
    </Row>
  );
}

function ObjectField(part: Part) {
  const { place, label, schema, onUnset } = part;
  return (
    <fieldset class={label ? "nested" : "flat"}>
      {label && (
        <legend>
          {label}
          {onUnset && <Small sign="×" label={word("removeOf", { name: label })} onClick={onUnset} />}
        </legend>
      )}
      <Note place={place} schema={schema} isLeaf={false} />
      <Fields schema={schema} steps={part.steps} applies={part.applies} />
    </fieldset>
  );
}

/** The fields of all keys of a set of keys but those that tell its form. */
export function Fields(props: {
  schema: Schema;
  steps: readonly Step[];
  applies?: unknown;
  only?: string[];
  /** A key that what stands around names already. */
  named?: string | undefined;
}) {
  const { schema, steps, applies, only, named } = props;
  const isOnCloth = drawing.value?.isOnCloth ?? false;
  const keys = Object.entries(schema.properties ?? {}).filter(([key, inside]) => {
    if (inside.const !== undefined || (only && !only.includes(key))) return false;
    const needsCloth = /On a cloth only|with the cloth|which the cloth/.test(inside.description ?? "");
    return isOnCloth || !needsCloth || valueAt(written.value, [...steps, key]) !== undefined;
  });
  return (
    <>
      {keys.map(([key, inside]) => (
        <Field
          key={key}
          schema={inside}
          steps={[...steps, key]}
          isNeeded={schema.required?.includes(key) ?? false}
          applies={valueAt(applies, [key])}
          {...(key === named ? { label: "" } : {})}
        />
      ))}
    </>
  );
}

/** A value that can have several forms: which one, and then the fields of that. */
function VariantsField(part: Part) {
  const { label, schema, root, steps, value, applies, place, key } = part;
  const tag = tagOf(schema);
  // A section of its own has a title already.
  const isWhole = part.onForm !== undefined;
  const form = formOf(part, value ?? applies);
  const isNumber = form !== undefined && form.type !== "object";
  const formPlace = `${place}.${tag ?? "form"}`;
  return (
    <fieldset class="forms" aria-label={label}>
      <Row
        place={isNumber ? place : formPlace}
        label={isWhole ? keyLabel(tag ?? key) : label}
        schema={form?.description ? form : schema}
        onUnset={part.onUnset}
      >
        <FormChoice
          {...part}
          place={formPlace}
          name={isNumber ? word("formOf", { name: label }) : undefined}
        />
        {isNumber && (
          <NumberBox
            {...{ place, schema: form, value, applies }}
            onValue={(typed, text) => set(steps, typed, text)}
          />
        )}
      </Row>
      {!isNumber && !(formPlace in refusals.value) && <Note place={place} schema={{}} isLeaf={false} />}
      {form && !isNumber && (
        <div class={isWhole ? "" : "inner"}>
          <Fields schema={form} {...{ steps, applies }} named={tag ? undefined : namesItself(form, root)} />
        </div>
      )}
    </fieldset>
  );
}

/** The key that a form is known by, where that has parts, such as `circle`. */
function namesItself(form: Schema, root: Schema): string | undefined {
  const key = nameOf(form, root);
  const property = form.properties?.[key];
  return property && ["object", "list"].includes(kindOf(plain(property, root), root)) ? key : undefined;
}

function formOf({ schema, root }: Part, value: unknown): Schema | undefined {
  const form = variantsOf(schema)[variantOf(schema, value, root)];
  return form && plain(form, root);
}

/** Which of its forms a value has. */
function FormChoice(part: Part & { name: string | undefined }) {
  const { schema, root, steps, value, applies, isNeeded, place, name, onForm } = part;
  const none = () => {
    const form = formOf(part, applies);
    return { value: "", label: defaultText(schema, form && nameOf(form, root), choiceLabel) };
  };
  const forms = variantsOf(schema).map((form, k) => ({
    value: String(k),
    label: choiceLabel(nameOf(form, root)),
  }));
  const choose = (chosen: string) => {
    const form = variantsOf(schema)[Number(chosen)];
    if (chosen === "") void attempt(place, chosen, { [pathOf(steps)]: null });
    else if (form && onForm) onForm(made(part, form).next().value, chosen, place);
    else if (form) void attemptFirst(place, chosen, changes(steps, made(part, form)));
  };
  return (
    <Choice
      place={place}
      name={name}
      value={value === undefined && !isNeeded ? "" : String(variantOf(schema, value ?? applies, root))}
      choices={isNeeded ? forms : [none(), ...forms]}
      onValue={choose}
    />
  );
}

function* changes(steps: readonly Step[], values: Iterable<unknown>) {
  for (const value of values) yield { [pathOf(steps)]: value };
}

/** Values of another form that keep what they can of the old one; where they need room, at one free place after the other. */
function* made({ root, steps, value, key }: Part, form: Schema): Generator<unknown> {
  const old = valueAt(effective.value, steps) ?? value;
  const into = nameOf(form, root);
  if (into === "line" || into === "arc") return yield turned(old as Piece, into);
  let last = "";
  for (const around of surroundings(root)) {
    const next = fresh(form, old, key, around);
    if (JSON.stringify(next) === last) return;
    last = JSON.stringify(next);
    yield next;
  }
}
