/** From the gallery to a table and through its time without a mouse. */

import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, openScenario, useBrowser } from "./browser";

useBrowser();

/** Presses the tabulator until something has the focus; says after how many times. */
async function tabTo(page: Page, selector: string, most = 60): Promise<number> {
  for (let times = 1; times <= most; times++) {
    await page.keyboard.press("Tab");
    if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) return times;
  }
  throw new Error(`the tabulator does not lead to ${selector}`);
}

const clock = (page: Page) => page.locator(".clock").textContent();

test("from load to gallery to a table, play, and scrub", async () => {
  const page = await open();
  await page.locator(".first").waitFor();
  expect(await tabTo(page, "[data-scenario]")).toBeLessThan(6);
  await page.keyboard.press("Enter");
  await expect.poll(() => clock(page)).toBe("0 of 5");
  await tabTo(page, ".transport button.main");
  expect(await page.evaluate(() => getComputedStyle(document.activeElement as Element).outlineStyle)).toBe(
    "solid",
  );
  await page.keyboard.press("Space");
  await expect.poll(() => clock(page)).not.toBe("0 of 5");
  await page.keyboard.press("Space");
  await tabTo(page, ".transport .line input");
  await page.keyboard.press("End");
  await expect.poll(() => clock(page)).toBe("5 of 5");
  for (let times = 0; times < 10; times++) await page.keyboard.press("ArrowLeft");
  await expect.poll(() => clock(page)).toBe("4.995 of 5");
});

test("keys go through the time, and a list of them is one key away", async () => {
  const page = await open();
  await openScenario(page, "midterm");
  await page.locator("h1").click();
  const presses: [string, string][] = [
    [".", "0.275 of 5"],
    ["ArrowRight", "0.5016 of 5"],
    [",", "0.275 of 5"],
    ["End", "5 of 5"],
    ["Home", "0 of 5"],
  ];
  for (const [key, time] of presses) {
    await page.keyboard.press(key);
    await expect.poll(() => clock(page)).toBe(time);
  }
  await page.keyboard.press("?");
  await page.getByRole("dialog", { name: "Keyboard shortcuts" }).waitFor();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Escape");
  expect(await page.getByRole("dialog").count()).toBe(0);
  expect(await clock(page)).toBe("0 of 5");
});

test("keys that a list of choices has for itself do not move the time", async () => {
  const page = await open();
  await openScenario(page, "midterm");
  await page.getByLabel("Language").focus();
  await page.keyboard.press(".");
  await page.keyboard.press("Home");
  expect(await clock(page)).toBe("0 of 5");
});

test("the arrow keys go from tab to tab", async () => {
  const page = await open();
  await openScenario(page, "midterm");
  const tabs = page.getByRole("tab");
  await tabs.first().focus();
  await page.keyboard.press("ArrowRight");
  expect(await tabs.nth(1).getAttribute("aria-selected")).toBe("true");
  expect(await page.evaluate(() => document.activeElement?.id)).toBe(await tabs.nth(1).getAttribute("id"));
});
