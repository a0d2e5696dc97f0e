/** The lessons: a prediction unlocks play, collisions are explained, and the run has the last word. */

import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, useBrowser } from "./browser";

useBrowser();

async function openLesson(id: string): Promise<Page> {
  const page = await open();
  await page.locator(`[data-lesson="${id}"]`).click();
  await page.locator(".question form").waitFor();
  return page;
}

/** Predicts: a choice by its words, or a number. */
async function predict(page: Page, prediction: string | number) {
  const question = page.locator(".question");
  if (typeof prediction === "string") await question.getByLabel(prediction, { exact: true }).check();
  else await question.getByRole("spinbutton").fill(String(prediction));
  await question.getByRole("button", { name: "That is my prediction" }).click();
}

const answers = (page: Page) => page.locator(".question dd").allTextContents();

async function skip(page: Page) {
  await page.getByRole("button", { name: "Skip to the answer" }).click();
  await expect.poll(async () => (await answers(page))[1]).not.toBe("not there yet");
  return (await answers(page))[1];
}

test("play is locked until a prediction is made, and pauses at each collision to explain it", async () => {
  const page = await openLesson("momentum");
  expect(await page.getByRole("button", { name: "Play", exact: true }).isDisabled()).toBe(true);
  await page.locator("h2").first().press(" ");
  expect(await page.locator(".clock").count()).toBe(0);
  await predict(page, "It turns back.");
  await page.locator(".transport").getByRole("button", { name: "Play", exact: true }).click();
  const told = page.locator(".explained");
  await told.waitFor();
  await expect.poll(() => page.locator(".clock").textContent()).toBe("0.56 of 6");
  const rows = await told
    .locator("tr")
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  expect(rows.slice(1)).toEqual([
    ["light", "1", "−2"],
    ["heavy", "−3", "0"],
    ["All momentum", "−2", "−2"],
    ["All energy", "2", "2"],
  ]);
  expect(await answers(page)).toEqual(["It turns back.", "It stops."]);
  await page.locator(".transport").getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => page.locator(".clock").textContent()).toBe("0.94 of 6");
});

test("a direction can be drawn on the table", async () => {
  const page = await openLesson("momentum");
  await predict(page, "It stops.");
  await skip(page);
  await page.getByRole("button", { name: "Next part" }).click();
  await page.locator(".glass.drawing").waitFor();
  const box = await page.locator(".glass").boundingBox();
  if (!box) throw new Error("there is no glass");
  // The upper ball stands at (1.5, 1.6) of 3 × 3: the middle, and a little above.
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const up = (0.1 / 3) * (Math.min(box.width, box.height) - 56);
  await page.mouse.move(x + 60, y - up - 60);
  await page.mouse.down();
  await page.mouse.move(x + 100, y - up - 100);
  await page.mouse.up();
  await expect.poll(() => page.getByRole("spinbutton").inputValue()).toBe("45");
  await page.getByRole("button", { name: "That is my prediction" }).click();
  expect(await skip(page)).toBe("30°");
});

test("a lesson ends with its predictions beside the runs, and prints a sheet without the answers", async () => {
  const page = await openLesson("pi");
  for (const [prediction, counted] of [
    [3, "3 collisions"],
    [30, "31 collisions"],
    [300, "314 collisions"],
  ] as const) {
    await predict(page, prediction);
    expect(await skip(page)).toBe(counted);
    await page.locator(".steps .primary").click();
  }
  const summary = await page.locator(".answers").textContent();
  for (const told of ["30 collisions", "31 collisions", "Well predicted."]) expect(summary).toContain(told);
  await page.emulateMedia({ media: "print" });
  expect(await page.locator("main").isVisible()).toBe(false);
  const sheet = page.locator(".sheet");
  expect(await sheet.isVisible()).toBe(true);
  expect(await sheet.locator("canvas").count()).toBe(3);
  expect(await sheet.textContent()).not.toContain("31");
});

test("the time step and the butterfly answer from their runs", async () => {
  const page = await openLesson("timestep");
  await predict(page, "earlier");
  expect(await skip(page)).toBe("later");
  expect(await page.locator(".collision .count").textContent()).toMatch(/^Collisions of red so far: 4 of 6$/);
  await page.getByRole("button", { name: "Next part" }).click();
  await predict(page, 0.1);
  expect(await skip(page)).toBe("0.2828 table widths");
  await page.getByRole("button", { name: "Gallery" }).click();
  await page.locator('[data-lesson="butterfly"]').click();
  await predict(page, "no eye could tell them apart");
  expect(await skip(page)).toBe("no eye could tell them apart");
  await page.getByRole("button", { name: "Next part" }).click();
  await predict(page, 60);
  expect(await skip(page)).toBe("17 hits");
});

test("what is asked for last is what is opened", async () => {
  const page = await open("#midterm");
  await page.locator(".clock").waitFor();
  await page.evaluate(() => {
    const then = (next: string) =>
      window.addEventListener("hashchange", () => setTimeout(() => (location.hash = next)), { once: true });
    then("lesson=butterfly");
    location.hash = "lesson=pi";
  });
  // The one that was asked for first has come in as well by then.
  await page.waitForTimeout(500);
  expect(await page.locator("header h1").textContent()).toBe("The butterfly");
  expect(await page.locator(".question form").count()).toBe(1);
});
