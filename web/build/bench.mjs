/**
 * What the page costs in Chromium, as JSON: `node build/bench.mjs` after `make page`.
 *
 * The engine is timed warm, in batches, as the browser's clock is coarse; a frame by what the page itself computes and
 * draws in it; the rest from the address being opened, with nothing cached.
 */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { deflateRawSync } from "node:zlib";
import { address, browser, end, ROOT } from "./served.mjs";

const SCENARIOS = join(ROOT, "../scenarios");
const GAS = { format: 1, collisions: 300_000, gas: { n: 10_000, packing_fraction: 0.3, seed: 1 } };
const ENDLESS = { format: 1, collisions: 1000, gas: { n: 1_000_000, packing_fraction: 0.4, seed: 1 } };

/** What the engine is timed with; its batches are long enough for the clock. */
const cases = JSON.parse(process.argv[2] ?? "[]");

const median = (numbers) => numbers.toSorted((a, b) => a - b)[numbers.length >> 1];
const linkTo = (scenario) => {
  const text = `${JSON.stringify({ format: 1, physics_version: 2, digest: null })}\n${JSON.stringify(scenario)}`;
  return `#scenario=${deflateRawSync(text).toString("base64url")}`;
};

/** A new page with nothing cached. */
async function newPage() {
  const context = await browser.newContext({ locale: "en-GB", viewport: { width: 1280, height: 800 } });
  return context.newPage();
}

/** Seconds of a run with everything kept, for each case. */
async function engine() {
  const page = await newPage();
  await page.route("**/engine/*", (route) => {
    const name = new URL(route.request().url()).pathname.split("/").at(-1);
    if (name === "empty.html") return route.fulfill({ contentType: "text/html", body: "" });
    return route.fulfill({ path: join(ROOT, "engine", name) });
  });
  await page.goto(`${address}engine/empty.html`);
  const texts = cases.map(({ scenario, values }) => ({
    text: readFileSync(join(SCENARIOS, `${scenario}.toml`), "utf8"),
    values: JSON.stringify(values),
  }));
  const seconds = await page.evaluate(async (texts) => {
    const { default: init, run_at_once, Scenario } = await import("/engine/carom_wasm.js");
    await init({ module_or_path: "/engine/carom_wasm_bg.wasm" });
    const never = () => false;
    const batch = (scenario, runs) => {
      const start = performance.now();
      for (let k = 0; k < runs; k++) run_at_once(scenario, never).free();
      return (performance.now() - start) / 1000;
    };
    return texts.map(({ text, values }) => {
      const scenario = Scenario.parse(text, "toml").with_values(values);
      let runs = 1;
      while (batch(scenario, runs) < 0.2) runs *= 2;
      const times = Array.from({ length: 9 }, () => batch(scenario, runs) / runs);
      return times.toSorted((a, b) => a - b)[4];
    });
  }, texts);
  await page.context().close();
  return seconds;
}

/** Milliseconds of the page's own in a frame, while a gas of ten thousand discs plays. */
async function frame() {
  const page = await newPage();
  await page.addInitScript(() => {
    window.own = new Map();
    const ask = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (draw) =>
      ask((now) => {
        const start = performance.now();
        draw(now);
        window.own.set(now, (window.own.get(now) ?? 0) + performance.now() - start);
      });
  });
  await page.goto(address + linkTo(GAS));
  await page.getByRole("tab", { name: "Files" }).click();
  const events = page.getByRole("button", { name: "Events CSV" }).and(page.locator(":enabled"));
  await events.waitFor({ timeout: 60_000 });
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForTimeout(1000);
  await page.evaluate(() => window.own.clear());
  await page.waitForTimeout(5000);
  const own = await page.evaluate(() => [...window.own.values()]);
  await page.context().close();
  return median(own);
}

/** Milliseconds from opening an address to seeing something. */
async function until(fragment, seen) {
  const times = [];
  for (let k = 0; k < 5; k++) {
    const page = await newPage();
    const start = performance.now();
    await page.goto(address + fragment);
    await seen(page);
    times.push(performance.now() - start);
    await page.context().close();
  }
  return median(times);
}

const measured = {
  engine_s: await engine(),
  frame_ms: await frame(),
  gallery_ms: await until("", (page) => page.locator("[data-scenario=midterm]").waitFor()),
  table_ms: await until("#midterm", (page) => page.getByText("0 of 5", { exact: true }).waitFor()),
  refusal_ms: await until(linkTo(ENDLESS), (page) => page.getByText("takes too long").waitFor()),
};
await end();
console.log(JSON.stringify(measured));
