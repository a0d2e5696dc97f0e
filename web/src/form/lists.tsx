/** Fields of lists, and of values by keys. */

import type { Values } from "../engine/protocol";
import { drawing } from "../studio/store";
import { word } from "../words";
import { Note, Small } from "./controls";
import { attemptFirst, set } from "./editing";
import { Field, type Part } from "./Field";
import { fresh } from "./fresh";
import { pathOf, type Step } from "./paths";
import { type Piece, split, without } from "./pieces";
import { surroundings } from "./room";
import { kindOf, nameOf, plain, type Schema, variantsOf } from "./schema";
import { hasShares, withNewcomer, withoutShare } from "./shares";

/** A list with another member, at one free place after the other. */
function* longer(steps: readonly Step[], list: unknown[], items: Schema, root: Schema): Generator<Values> {
  if (hasShares(list)) return yield { [pathOf(steps)]: withNewcomer(list) };
  for (const around of surroundings(root, list.length + 1)) {
    yield { [pathOf(steps)]: [...list, fresh(items, undefined, "", around)] };
  }
}

export function ListField({ place, label, schema, root, steps, value, onUnset }: Part) {
  const items = plain(schema.items ?? {}, root);
  const list = (value ?? []) as unknown[];
  const isRows = kindOf(items, root) === "row";
  const isPath = variantsOf(items).some((variant) => nameOf(variant, root) === "line");
  const remove = (k: number) => {
    if (list.length === 1 && onUnset) onUnset();
    else if (isPath) void set(steps, without(list as Piece[], k));
    else void set(steps, hasShares(list) ? withoutShare(list, k) : list.toSpliced(k, 1));
  };
  return (
    <fieldset class={label ? "nested" : "flat"}>
      {label && <legend>{label}</legend>}
      <Note place={place} schema={schema} isLeaf={false} />
      {list.map((member, k) => (
        <div class="member" key={k}>
          <Field
            schema={items}
            steps={[...steps, k]}
            label={isRows ? word("pointOf", { k: k + 1 }) : String(k + 1)}
            isNeeded
          />
          {isPath && (member as Piece).line && (
            <Small
              sign="÷"
              label={word("split", { name: `${label} ${k + 1}` })}
              onClick={() => void set(steps, split(list as Piece[], k))}
            />
          )}
          {!isRows && (
            <Small
              sign="×"
              label={word("removeOf", { name: `${label} ${k + 1}` })}
              onClick={() => remove(k)}
            />
          )}
        </div>
      ))}
      {!isRows && !isPath && (
        <button type="button" onClick={() => attemptFirst(place, "", longer(steps, list, items, root))}>
          {word("add")}
        </button>
      )}
    </fieldset>
  );
}

/** Values by keys that are cushions of the table. */
export function MapField({ place, label, schema, root, steps, value }: Part) {
  const items = schema.additionalProperties as Schema;
  const keys = Object.keys((value ?? {}) as object);
  const left = (drawing.value?.table.pieces ?? []).map(({ id }) => id).filter((id) => !keys.includes(id));
  const isFirst = keys.length === 0;
  return (
    <fieldset class="nested">
      <legend>{label}</legend>
      <Note place={place} schema={schema} isLeaf={false} />
      {keys.map((key) => (
        <Field key={key} schema={items} steps={[...steps, key]} label={key} />
      ))}
      <select
        aria-label={word("addTo", { name: label })}
        value=""
        onChange={(event) => {
          const key = event.currentTarget.value;
          const [around] = surroundings(root);
          if (!around || key === "") return;
          const law = fresh(items, undefined, key, around);
          void (isFirst ? set(steps, { [key]: law }) : set([...steps, key], law));
        }}
      >
        <option value="">{word("add")}</option>
        {left.map((id) => (
          <option key={id} value={id}>
            {id}
          </option>
        ))}
      </select>
    </fieldset>
  );
}
