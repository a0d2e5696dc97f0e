/** Title and description of the ready-made scenarios: from their files in English, else from the words. */

import { type Description, language, SCENARIO_WORDS } from "../words";
import { SCENARIOS } from "./scenarios";

/** The description of a ready-made scenario in the chosen language. */
export function described(name: string): Description {
  return SCENARIO_WORDS[language.value][name] ?? asWritten(SCENARIOS[name] ?? "", name);
}

/** The title of a scenario in the language of the page, where it is that of a ready-made one. */
export function translated(title: string): string {
  const name = Object.keys(SCENARIOS).find((name) => titleOf(SCENARIOS[name] ?? "") === title);
  return name ? described(name).title : title;
}

const titleOf = (toml: string) => /^title = "(.*)"$/m.exec(toml)?.[1];

/** What stands in the file; it need not be checked for that, so the gallery does not wait for the engine. */
function asWritten(toml: string, name: string): Description {
  const title = titleOf(toml) ?? name;
  const description = /^description = """\n?([\s\S]*?)"""/m.exec(toml)?.[1] ?? "";
  const text = description
    .replace(/\\\n\s*/g, "")
    .replace(/\s+/g, " ")
    .trim();
  return { title, line: /^.*?[.!?](?=\s|$)/.exec(text)?.[0] ?? text };
}
