/** The ready-made scenarios, from the folder that all parts of Carom use. */

const texts = import.meta.glob("../../../scenarios/*.toml", {
  query: "?raw",
  import: "default",
  eager: true,
});

/** The texts of the scenarios, TOML, by their names. */
export const SCENARIOS: Record<string, string> = Object.fromEntries(
  Object.entries(texts).map(([path, text]) => [path.replace(/^.*\/|\.toml$/g, ""), text as string]),
);

/** The one that the page offers first. */
export const FIRST = "midterm";
