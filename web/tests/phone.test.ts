/** The page on a phone of 360 pixels, and on a very large screen. */

import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, openScenario, useBrowser } from "./browser";

useBrowser();

const PHONE = { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true };

/** Whether nothing sticks out at the side. */
const fits = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth);

/** The smaller side of the smallest button of the bar below the table. */
const smallest = (page: Page) =>
  page.locator(".transport button").evaluateAll((buttons) =>
    Math.min(
      ...buttons.flatMap((button) => {
        const { width, height } = button.getBoundingClientRect();
        return [width, height];
      }),
    ),
  );

test("gallery, table and lesson fit a phone, and the time stays under the thumb", async () => {
  const page = await open("", PHONE);
  await page.locator(".first").waitFor();
  expect(await fits(page)).toBe(true);
  await openScenario(page, "midterm");
  const tabs = page.getByRole("tab");
  for (let k = 0; k < (await tabs.count()); k++) {
    await tabs.nth(k).click();
    expect(await fits(page), (await tabs.nth(k).textContent()) ?? "").toBe(true);
  }
  await page.evaluate(() => window.scrollTo(0, document.body.scrollHeight));
  const bar = await page.locator(".transport").boundingBox();
  expect(bar && Math.round(bar.y + bar.height)).toBe(740);
  expect(await smallest(page)).toBeGreaterThanOrEqual(44);
  await page.getByRole("button", { name: "Gallery" }).click();
  await page.locator('[data-lesson="timestep"]').click();
  await page.locator(".question form").waitFor();
  expect(await fits(page)).toBe(true);
});

test("the table has most of a large screen", async () => {
  const page = await open("", { viewport: { width: 3840, height: 2160 } });
  await openScenario(page, "midterm");
  expect(await fits(page)).toBe(true);
  const table = await page.locator("canvas.table").boundingBox();
  expect(table?.width).toBeGreaterThan(2400);
  expect(table?.height).toBeGreaterThan(1700);
});
