import { defineConfig } from "vite";

export default defineConfig({
  base: "./",
  worker: { format: "es" },
  build: { target: "es2022", modulePreload: false },
  // The ready-made scenarios lie beside the page.
  server: { fs: { allow: [".."] } },
});
