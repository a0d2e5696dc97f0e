/** Runs laid over each other: what a time step costs, and a twin. */

import { expect, test } from "vitest";
import { open, useBrowser } from "./browser";

useBrowser();

/** The time at which the runs are said to part; null when they are said not to. */
const partingTime = /part at time ([\d.]+)/;

test("the exact run and the one in steps part later the smaller the step", async () => {
  const page = await open();
  await page.locator('[data-scenario="midterm"]').click();
  await page.getByRole("tab", { name: "Compare" }).click();
  await page.getByLabel("The same in time steps").check();
  const panel = page.getByRole("tabpanel");
  const parting = async () => Number(partingTime.exec((await panel.textContent()) ?? "")?.[1] ?? "NaN");
  await expect.poll(parting).toBeGreaterThan(0);
  const coarse = await parting();
  await page.getByRole("slider", { name: "Time step" }).fill("-2.5");
  await expect.poll(parting).toBeGreaterThan(coarse);
  await page.getByRole("button", { name: "Go there" }).click();
  await expect.poll(() => page.locator(".clock").textContent()).not.toBe("0 of 5");
  await page.getByRole("slider", { name: "Time step" }).fill("-4");
  await expect.poll(() => panel.textContent()).toContain("do not part");
});

test("a twin that starts in another place at once is parted at once, a near one later", async () => {
  const page = await open();
  await page.locator('[data-scenario="stadium"]').click();
  await page.getByRole("tab", { name: "Compare" }).click();
  await page.getByLabel("A twin").check();
  const panel = page.getByRole("tabpanel");
  const parting = async () => Number(partingTime.exec((await panel.textContent()) ?? "")?.[1] ?? "NaN");
  await page.getByRole("slider", { name: "The nudge" }).fill("-1");
  await expect.poll(parting).toBeGreaterThanOrEqual(0);
  const far = await parting();
  await page.getByRole("slider", { name: "The nudge" }).fill("-9");
  await expect.poll(parting).toBeGreaterThan(far);
});

test("the letters of the graph are as large at every width", async () => {
  const page = await open("#stadium");
  await page.getByRole("tab", { name: "Compare" }).click();
  await page.getByLabel("A twin").check();
  const graph = page.locator(".difference svg");
  await graph.waitFor();
  for (const [width, height] of [
    [360, 740],
    [740, 360],
    [3840, 2160],
  ] as const) {
    await page.setViewportSize({ width, height });
    const scale = () =>
      graph.evaluate((svg: SVGSVGElement) => svg.getBoundingClientRect().width / svg.viewBox.baseVal.width);
    await expect.poll(scale).toBeCloseTo(1, 2);
  }
});

test("what the method of steps cannot do is said", async () => {
  const page = await open();
  await page.locator('[data-scenario="stadium"]').click();
  await page.getByRole("tab", { name: "Compare" }).click();
  await page.getByLabel("The same in time steps").check();
  await expect.poll(() => page.getByRole("alert").first().textContent()).toContain("method.kind");
});

test("another scenario begins with nothing laid over it", async () => {
  const page = await open("#stadium");
  await page.getByRole("tab", { name: "Compare" }).click();
  await page.getByLabel("A twin").check();
  await page.getByText("part at time").waitFor();
  await page.evaluate(() => {
    location.hash = "midterm";
  });
  await expect.poll(() => page.locator(".clock").textContent()).toBe("0 of 5");
  expect(await page.getByLabel("Nothing").isChecked()).toBe(true);
});
