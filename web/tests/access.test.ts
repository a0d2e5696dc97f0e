/** No violations of the rules of axe, wherever the page can be. */

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, openScenario, useBrowser } from "./browser";

useBrowser();

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Without transitions, so that no colour is caught on its way. */
const STILL = { reducedMotion: "reduce" } as const;

interface Found {
  violations: { id: string; help: string; nodes: { html: string; failureSummary?: string }[] }[];
}

/** What axe finds, as lines to read. */
async function violations(page: Page): Promise<string[]> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(AXE);
  const found = (await page.evaluate("axe.run()")) as Found;
  return found.violations.flatMap(({ id, help, nodes }) =>
    nodes.map(({ html, failureSummary }) => `${id}: ${help}\n${html}\n${failureSummary}`),
  );
}

for (const colorScheme of ["light", "dark"] as const) {
  test(`the gallery, and a table with each of its panels (${colorScheme})`, async () => {
    const page = await open("", { colorScheme, ...STILL });
    await page.locator(".first").waitFor();
    expect(await violations(page)).toEqual([]);
    await openScenario(page, "midterm");
    const tabs = page.getByRole("tab");
    for (let k = 0; k < (await tabs.count()); k++) {
      await tabs.nth(k).click();
      expect(await violations(page), (await tabs.nth(k).textContent()) ?? "").toEqual([]);
    }
  });

  test(`a lesson: its question, a collision and the answer (${colorScheme})`, async () => {
    const page = await open("", { colorScheme, ...STILL });
    await page.locator('[data-lesson="momentum"]').click();
    await page.locator(".question form").waitFor();
    expect(await violations(page)).toEqual([]);
    await page.getByLabel("It stops.").check();
    await page.getByRole("button", { name: "That is my prediction" }).click();
    await page.getByRole("button", { name: "Skip to the answer" }).click();
    await page.locator(".explained").waitFor();
    expect(await violations(page)).toEqual([]);
    await page.keyboard.press("?");
    await page.getByRole("dialog").waitFor();
    expect(await violations(page)).toEqual([]);
  });
}

test("on a phone, and in a frame", async () => {
  const options = { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true, ...STILL };
  const page = await open("", options);
  await openScenario(page, "midterm");
  expect(await violations(page)).toEqual([]);
  const frame = await open("?embed#midterm", options);
  await expect.poll(() => frame.locator(".clock").textContent()).toBe("0 of 5");
  expect(await violations(frame)).toEqual([]);
});
