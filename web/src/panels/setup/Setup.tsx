/** The panel with the forms of a scenario: its table, its laws, its end, and what its balls have in common. */

import { useEffect } from "preact/hooks";
import { drawing, scenario, written } from "../../studio/store";
import "../../style/setup.css";
import { explains, loadSchema, schema } from "../../form/editing";
import { Field } from "../../form/Field";
import { keyLabel } from "../../form/labels";
import { word } from "../../words";
import type { Word } from "../../words/en";
import { PlainBalls } from "./PlainBalls";
import { reshape } from "./reshape";

/** The sections with their keys; a law of balls on a cloth is not looked for elsewhere. */
const SECTIONS: { title: Word; keys: string[]; isOpen?: boolean; isShown?: () => boolean }[] = [
  { title: "sectionGas", keys: ["gas"], isOpen: true, isShown: () => "gas" in written.value },
  { title: "sectionTable", keys: ["table"], isOpen: true, isShown: () => !("gas" in written.value) },
  { title: "sectionLaws", keys: ["physics"], isOpen: true },
  { title: "sectionRun", keys: ["duration", "collisions", "max_events", "method"], isOpen: true },
  { title: "sectionBalls", keys: ["ball_defaults"], isShown: () => !("gas" in written.value) },
  {
    title: "sectionRack",
    keys: ["rack"],
    isShown: () => "rack" in written.value || (drawing.value?.isOnCloth ?? false),
  },
  { title: "sectionText", keys: ["title", "description", "units"] },
];

export function Setup() {
  useEffect(() => void loadSchema(), []);
  if (!schema.value || !scenario.value) return <p class="faint">{word("loading")}</p>;
  return (
    <form class="setup" noValidate autocomplete="off" onSubmit={(event) => event.preventDefault()}>
      <label class="flag">
        <input
          type="checkbox"
          checked={explains.value}
          onChange={(event) => {
            explains.value = event.currentTarget.checked;
          }}
        />
        {word("explain")}
      </label>
      {SECTIONS.filter(({ isShown }) => isShown?.() ?? true).map(({ title, keys, isOpen }) => (
        <details key={title} open={isOpen}>
          <summary>{word(title)}</summary>
          {title === "sectionGas" && <PlainBalls />}
          {keys.map((key) => (
            <Key key={key} name={key} />
          ))}
        </details>
      ))}
    </form>
  );
}

/** The field of a key of the scenario. */
function Key({ name }: { name: string }) {
  const property = schema.value?.properties?.[name];
  if (!property) return null;
  const isTable = name === "table";
  return (
    <Field
      schema={property}
      steps={[name]}
      label={keyLabel(name)}
      isNeeded={isTable}
      {...(isTable ? { onForm: reshape } : {})}
    />
  );
}
