/** The part of JSON Schema that the engine describes scenarios with, and which control suits which part of it. */

export interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  type?: string;
  const?: string;
  description?: string;
  default?: unknown;
  properties?: Record<string, Schema>;
  required?: string[];
  additionalProperties?: boolean | Schema;
  items?: Schema;
  minItems?: number;
  maxItems?: number;
  oneOf?: Schema[];
  anyOf?: Schema[];
  minimum?: number;
  exclusiveMinimum?: number;
  maximum?: number;
  exclusiveMaximum?: number;
}

/** What people fill in: `row` is a few numbers, `flags` some of several words, `map` keys of one's own. */
export type Kind =
  | "number"
  | "boolean"
  | "text"
  | "colour"
  | "choice"
  | "row"
  | "flags"
  | "list"
  | "map"
  | "object"
  | "variants";

const COLOUR = "#/$defs/Color";

/** A part of a schema with what it refers to put in; its own description goes before that of the other. */
export function plain(schema: Schema, root: Schema): Schema {
  if (!schema.$ref) return schema;
  const { $ref, ...own } = schema;
  const referred = root.$defs?.[$ref.replace("#/$defs/", "")] ?? {};
  return { ...plain(referred, root), ...own, ...($ref === COLOUR ? { $ref } : {}) };
}

export function kindOf(schema: Schema, root: Schema): Kind {
  if (schema.$ref === COLOUR) return "colour";
  const { type } = schema;
  const variants = variantsOf(schema);
  if (variants.length > 0) return variants.every(isWord) ? "choice" : "variants";
  if (type === "number" || type === "integer") return "number";
  if (type === "boolean") return "boolean";
  if (type === "array") return kindOfList(plain(schema.items ?? {}, root), schema);
  if (type === "object") return typeof schema.additionalProperties === "object" ? "map" : "object";
  return "text";
}

function kindOfList(items: Schema, { minItems, maxItems }: Schema): Kind {
  if (items.type === "number" && minItems && maxItems) return "row";
  return variantsOf(items).length > 0 && variantsOf(items).every(isWord) ? "flags" : "list";
}

const isWord = (schema: Schema) => schema.const !== undefined && schema.type === "string";

/** The forms that a value can have. */
export const variantsOf = ({ oneOf, anyOf }: Schema): Schema[] => oneOf ?? anyOf ?? [];

/** The key whose word tells the variants apart, such as `law`; null where it is the keys themselves that do. */
export function tagOf(schema: Schema): string | null {
  for (const { properties = {} } of variantsOf(schema)) {
    for (const [key, { const: word }] of Object.entries(properties)) if (word !== undefined) return key;
  }
  return null;
}

/** A name for a variant: its word, or else the first key that it needs, or what type it has. */
export function nameOf(variant: Schema, root: Schema): string {
  const { type, properties = {}, required = [] } = plain(variant, root);
  const word = Object.values(properties).find((property) => property.const !== undefined)?.const;
  return word ?? required[0] ?? type ?? "";
}

/** Which of the variants a value is of; −1 is none. */
export function variantOf(schema: Schema, value: unknown, root: Schema): number {
  return variantsOf(schema).findIndex((variant) => isOf(plain(variant, root), value));
}

function isOf({ type, properties = {}, required = [] }: Schema, value: unknown): boolean {
  if (type !== "object") return typeof value === (type === "integer" ? "number" : type);
  if (typeof value !== "object" || value === null) return false;
  const keys = value as Record<string, unknown>;
  const words = Object.entries(properties).filter(([, property]) => property.const !== undefined);
  if (words.length > 0) return words.every(([key, property]) => keys[key] === property.const);
  return required.every((key) => key in keys);
}

/** What applies where a key is absent, where the schema says it in one word. */
export function absentWord({ default: value, description = "" }: Schema): string | null {
  if (value !== undefined) return String(value);
  return /absent: ([\w-]+(?:\.\d+)?)(?: flight)?[.,;]/.exec(description)?.[1] ?? null;
}
