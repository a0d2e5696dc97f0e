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

test("once it is open the page needs no network", async () => {
  const page = await open("#midterm");
  await page.locator(".clock").waitFor();
  await page.waitForLoadState("networkidle");
  await page.context().setOffline(true);
  for (const panel of ["Balls", "Graphs", "Events", "Compare", "Run", "Files"]) {
    await page.getByRole("tab", { name: panel, exact: true }).click();
    await expect
      .poll(async () => (await page.getByRole("tabpanel").textContent())?.length)
      .toBeGreaterThan(20);
  }
  expect(await page.locator(".message").count()).toBe(0);
});
