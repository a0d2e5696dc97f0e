/** Play, pause, and go from event to event. */

import { expect, test } from "vitest";
import { open, useBrowser } from "./browser";

useBrowser();

test("a scenario plays, and stands still when paused", async () => {
  const page = await open();
  await page.locator('[data-scenario="midterm"]').click();
  const clock = page.locator(".clock");
  await expect.poll(() => clock.textContent()).toBe("0 of 5");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => clock.textContent()).not.toBe("0 of 5");
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  const still = await clock.textContent();
  await page.waitForTimeout(200);
  expect(await clock.textContent()).toBe(still);
});
