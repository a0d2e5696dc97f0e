import { defineConfig, type UserConfig } from "vite";
import { inOneFile } from "./build/inOneFile";
import { onlyWordsOf } from "./build/onlyWordsOf";
import { withoutScenarios } from "./build/withoutScenarios";

/** What all builds have in common. */
const common: UserConfig = {
  base: "./",
  worker: { format: "es" },
  build: { target: "es2022", modulePreload: false },
  // The ready-made scenarios lie beside the page.
  server: { fs: { allow: [".."] } },
};

/** Everything in one HTML file: nothing is loaded, so nothing may be. */
const oneFile: UserConfig["build"] = {
  ...common.build,
  assetsInlineLimit: Number.POSITIVE_INFINITY,
  cssCodeSplit: false,
  rolldownOptions: { output: { codeSplitting: false } },
};

const builds: Record<string, UserConfig> = {
  /** The whole page, to be opened from disk; a worker that is no module starts from there everywhere. */
  single: {
    ...common,
    worker: { format: "iife" },
    resolve: {
      alias: [{ find: /^\.\/spawn$/, replacement: `${import.meta.dirname}/src/engine/spawnInline.ts` }],
    },
    plugins: [inOneFile("carom-studio.html", ["../THIRD-PARTY.txt"])],
    build: { ...oneFile, emptyOutDir: false },
  },
  /** What plays one recorded run, without the engine: Python puts the run in. */
  player: {
    ...common,
    resolve: {
      alias: [{ find: /^\.\/spawn$/, replacement: `${import.meta.dirname}/src/player/noWorker.ts` }],
    },
    plugins: [withoutScenarios(), onlyWordsOf("src/player/main.tsx"), inOneFile("player.html")],
    build: {
      ...oneFile,
      outDir: "dist-player",
      rolldownOptions: { ...oneFile?.rolldownOptions, input: "player.html" },
    },
  },
};

export default defineConfig(({ mode }) => builds[mode] ?? common);
