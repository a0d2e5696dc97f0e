/** A step of the build that puts script and style into the HTML file, which then needs no other. */

import { createHash } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

/** Turns what is built into one file of a name; it carries the licences in `notices`, or those of its packages. */
export function inOneFile(name: string, notices?: string[]): Plugin {
  return {
    name: "in-one-file",
    generateBundle: {
      // Vite itself writes into the script until here.
      order: "post",
      handler(_, bundle) {
        const [page, script, style] = [".html", ".js", ".css"].map((ending) => {
          const found = Object.values(bundle).filter(({ fileName }) => fileName.endsWith(ending));
          if (found.length !== 1) this.error(`one file has one ${ending} in it, not ${found.length}`);
          return found[0];
        });
        if (page?.type !== "asset" || script?.type !== "chunk" || style?.type !== "asset") {
          return this.error("the parts of the page are not what they were");
        }
        const texts = notices ?? licencesOf(script.moduleIds);
        const html = put(String(page.source), script.code, String(style.source), texts);
        for (const file of Object.keys(bundle)) delete bundle[file];
        this.emitFile({ type: "asset", fileName: name, source: html });
      },
    },
  };
}

function put(page: string, script: string, style: string, notices: string[]): string {
  // No end of an element may stand in a script; in JavaScript the two spellings are the same.
  const code = `\n${script.replace(/<(?=\/script|!--|script)/gi, "\\x3C")}`;
  const policy = [
    "default-src 'none'",
    `script-src '${hash(code)}' 'wasm-unsafe-eval'`,
    "worker-src blob:",
    `style-src '${hash(style)}'`,
    "img-src data: blob:",
    // The engine lies in the page as such an address; nothing goes over a network.
    "connect-src data:",
    "base-uri 'none'",
    "form-action 'none'",
  ];
  const parts: [RegExp, string][] = [
    [/<script type="module"[^>]*><\/script>/, `<script type="module">${code}</script>`],
    [/<link rel="stylesheet"[^>]*>/, `<style>${style}</style>`],
    [/(?<=Content-Security-Policy"\s+content=")[^"]*/, policy.join("; ")],
    [
      /(?=<\/body>)/,
      `<!--\n${notices
        .map(read)
        .join("\n")
        .replace(/--(!?)>/g, "- -$1>")}-->\n`,
    ],
  ];
  return parts.reduce((html, [place, text]) => {
    if (!place.test(html)) throw new Error(`the page has no ${place}`);
    return html.replace(place, () => text);
  }, page);
}

const hash = (text: string) => `sha256-${createHash("sha256").update(text).digest("base64")}`;

const read = (file: string) => readFileSync(file, "utf-8");

/** The licence files of the packages that some modules are of. */
function licencesOf(modules: string[]): string[] {
  const folders = modules.map((id) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(id)?.[0]);
  return [...new Set(folders)].flatMap((folder) => {
    const file = folder && join(folder, "LICENSE");
    if (folder && !(file && existsSync(file))) throw new Error(`${folder} has no LICENSE`);
    return file ? [file] : [];
  });
}
