/** A step of the build that leaves out the words which a part of the page does not say. */

import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { type Plugin, transformWithOxc } from "vite";

/** Keeps the words that stand as a text in the modules which the one of a path imports in turn. */
export function onlyWordsOf(entry: string): Plugin {
  return {
    name: "only-words-of",
    async load(id) {
      const language = /\/src\/words\/(en|de)\.ts$/.exec(id)?.[1];
      if (!language) return null;
      const { code } = await transformWithOxc(readFileSync(id, "utf-8"), id);
      const { [language]: words, ...others } = (await import(
        `data:text/javascript,${encodeURIComponent(code)}`
      )) as Record<string, Record<string, string>>;
      const source = sourcesOf(entry).join("\n");
      const prefixes = [...source.matchAll(/`(\w+)\$\{/g)].map(([, prefix]) => prefix as string);
      const isSaid = (key: string) =>
        source.includes(`"${key}"`) ||
        source.includes(`.${key}`) ||
        prefixes.some((prefix) => key.startsWith(prefix));
      const said = Object.fromEntries(Object.entries(words ?? {}).filter(([key]) => isSaid(key)));
      // What stands beside them is said of ready-made scenarios.
      const empty = Object.keys(others).map((name) => `export const ${name} = {};`);
      return [`export const ${language} = ${JSON.stringify(said)};`, ...empty].join("\n");
    },
  };
}

/** The texts of a module and of those that it imports in turn for more than types, the words themselves apart. */
function sourcesOf(entry: string): string[] {
  const [waiting, texts] = [[entry], new Map<string, string>()];
  for (let file = waiting.pop(); file; file = waiting.pop()) {
    if (texts.has(file)) continue;
    const text = readFileSync(file, "utf-8");
    texts.set(file, text);
    for (const [, path] of text.matchAll(/^(?:import|export) (?!type )[^"]*?"(\.[^"]+)"/gm)) {
      const place = join(dirname(file), path as string);
      const found = [`${place}.ts`, `${place}.tsx`, `${place}/index.ts`].find(existsSync);
      if (found && !/\/words\/(en|de)\.ts$/.test(found)) waiting.push(found);
    }
  }
  return [...texts.values()];
}
