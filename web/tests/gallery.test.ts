/** The start page: what there is to open, in both languages, and the page in a frame. */

import { readdirSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { scenarios } from "../src/words/de";
import { open, openScenario, useBrowser } from "./browser";

useBrowser();

const NAMES = readdirSync(join(import.meta.dirname, "../../scenarios"))
  .filter((file) => file.endsWith(".toml"))
  .map((file) => file.replace(".toml", ""));

test("every scenario has a title and a sentence in German, and no other has", () => {
  expect(Object.keys(scenarios).sort()).toEqual(NAMES.sort());
});

test("the gallery shows every scenario with its title, and draws its picture when it comes into view", async () => {
  const page = await open();
  const first = page.locator(".first");
  await expect.poll(() => first.locator("canvas").getAttribute("data-drawn")).toBe("true");
  const shown = await page
    .locator("[data-scenario]")
    .evaluateAll((cards) => cards.map((card) => (card as HTMLElement).dataset["scenario"]));
  expect(shown.sort()).toEqual(NAMES);
  await expect
    .poll(() => page.locator('[data-scenario="sinai"] .card-title').textContent())
    .toBe("The Sinai billiard");
  const far = page.locator('[data-scenario="gas"]');
  await far.scrollIntoViewIfNeeded();
  await expect.poll(() => far.locator("canvas").getAttribute("data-drawn")).toBe("true");
});

test("the language that is chosen is that of all the gallery, and stays for the visit", async () => {
  const page = await open();
  await page.getByLabel("Language").selectOption("de");
  await page.reload();
  expect(await page.locator('[data-scenario="sinai"] .card-title').textContent()).toBe("Das Sinai-Billard");
  expect(await page.locator('[data-lesson="pi"]').textContent()).toContain("π abzählen");
  await openScenario(page, "sinai");
  expect(await page.locator("h1").textContent()).toBe("Das Sinai-Billard");
});

test("in a frame there are the table and the time, and nothing that leads away", async () => {
  const page = await open("?embed#sinai");
  await expect.poll(() => page.locator(".clock").textContent()).toContain("of 59.63");
  expect(await page.locator("header, aside, .gallery").count()).toBe(0);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => page.locator(".clock").textContent()).not.toMatch(/^0 of/);
});
