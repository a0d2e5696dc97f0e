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
  page.locator(".transport button:visible").evaluateAll((buttons) =>
    Math.min(
      ...buttons.flatMap((button) => {
        const { width, height } = button.getBoundingClientRect();
        return [width, height];
      }),
    ),
  );

/** Pairs of parts of the bar below the table that lie over each other, and parts that stick out of it. */
const crowded = (page: Page) =>
  page.locator(".transport").evaluate((bar) => {
    const seen = (element: Element) => element.getClientRects().length > 0;
    const named = (element: Element) => element.getAttribute("aria-label") ?? element.className;
    const parts = [...bar.querySelectorAll("button, input, output")].filter(seen);
    const outer = bar.getBoundingClientRect();
    const boxes = parts.map((part) => ({ part: named(part), box: part.getBoundingClientRect() }));
    const outside = boxes.filter(({ box }) => box.left < outer.left || box.right > outer.right);
    const pairs = boxes.flatMap((one, k) =>
      boxes
        .slice(k + 1)
        .filter(({ box }) => {
          const across = Math.min(one.box.right, box.right) - Math.max(one.box.left, box.left);
          const down = Math.min(one.box.bottom, box.bottom) - Math.max(one.box.top, box.top);
          return across > 1 && down > 1;
        })
        .map(({ part }) => `${one.part} and ${part}`),
    );
    return [...outside.map(({ part }) => part), ...pairs];
  });

test("the parts of the bar below the table keep apart at every width", async () => {
  const page = await open("#eight_ball_break");
  await page.locator(".clock").waitFor();
  await page.getByRole("button", { name: "Next event" }).click();
  for (const [width, height] of [
    [360, 740],
    [390, 844],
    [520, 700],
    [640, 360],
    [740, 360],
    [840, 390],
    [1000, 700],
    [1090, 700],
    [1280, 800],
  ] as const) {
    await page.setViewportSize({ width, height });
    expect(await crowded(page), `${width} by ${height}`).toEqual([]);
    expect(await fits(page), `${width} by ${height}`).toBe(true);
  }
});

test("gallery, table and lesson fit a phone, and the time stays under the thumb", async () => {
  const page = await open("", PHONE);
  await page.locator(".first").waitFor();
  expect(await fits(page)).toBe(true);
  await openScenario(page, "pinball");
  expect(await page.evaluate(() => window.scrollY)).toBe(0);
  await page.getByRole("button", { name: "Gallery" }).click();
  await openScenario(page, "midterm");
  const tabs = page.getByRole("tab");
  for (let k = 0; k < (await tabs.count()); k++) {
    await tabs.nth(k).click();
    expect(await fits(page), (await tabs.nth(k).textContent()) ?? "").toBe(true);
    await expect
      .poll(() =>
        page
          .getByRole("tabpanel")
          .boundingBox()
          .then((box) => box?.y),
      )
      .toBeLessThan(500);
  }
  await page.evaluate(() => window.scrollTo(0, document.body.scrollHeight));
  const bar = await page.locator(".transport").boundingBox();
  expect(bar && Math.round(bar.y + bar.height)).toBe(740);
  expect(await smallest(page)).toBeGreaterThanOrEqual(44);
  expect(await crowded(page)).toEqual([]);
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
