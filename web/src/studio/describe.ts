/** Title and description of the ready-made scenarios: from their files in English, else from the words. */

import { type Description, language, SCENARIO_WORDS } from "../words";
import { SCENARIOS } from "./scenarios";

/** The description of a ready-made scenario in the chosen language. */
export function described(name: string): Description {
  return SCENARIO_WORDS[language.value][name] ?? asWritten(SCENARIOS[name] ?? "", name);
}

/** What stands in the file; it need not be checked for that, so the gallery does not wait for the engine. */
function asWritten(toml: string, name: string): Description {
  const title = /^title = "(.*)"$/m.exec(toml)?.[1] ?? name;
  const description = /^description = """\n?([\s\S]*?)"""/m.exec(toml)?.[1] ?? "";
  const text = description
    .replace(/\\\n\s*/g, "")
    .replace(/\s+/g, " ")
    .trim();
  return { title, line: /^.*?[.!?](?=\s|$)/.exec(text)?.[0] ?? text };
}
