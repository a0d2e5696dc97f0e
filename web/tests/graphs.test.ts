/** Graphs that follow the time of the table, and lead to another. */

import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, openScenario, useBrowser } from "./browser";

useBrowser();

async function graphsOf(name: string): Promise<Page> {
  const page = await open();
  await openScenario(page, name);
  await page.getByRole("tab", { name: "Graphs" }).click();
  await page.locator(".plot canvas").first().waitFor();
  return page;
}

/** The value that a legend shows of a line. */
const shown = (page: Page, graph: string, line: string) =>
  page
    .getByRole("figure", { name: graph, exact: true })
    .getByRole("button", { name: line })
    .locator("output")
    .textContent()
    .then(Number);

const clock = async (page: Page) =>
  Number.parseFloat((await page.locator(".clock").textContent())?.split(" ")[0] ?? "");

test("a click in a graph goes to its time, and the legend, the line and the values follow", async () => {
  const page = await graphsOf("midterm");
  // The red ball of mass 1 has the speed 5 at the start.
  expect(await shown(page, "Energy", "kinetic")).toBe(12.5);
  expect(await shown(page, "Momentum along x", "red")).toBe(3);
  const plot = page.locator(".plot .u-over").first();
  const { width = 0 } = (await plot.boundingBox()) ?? {};
  await plot.click({ position: { x: width / 2, y: 50 } });
  await expect.poll(() => clock(page)).toBeCloseTo(2.5, 1);
  expect(await shown(page, "Energy", "kinetic")).toBeLessThan(1);
  const place = await page
    .locator(".plot .now")
    .first()
    .evaluate((line) => new DOMMatrix(getComputedStyle(line).transform).e);
  expect(Math.abs(place - width / 2)).toBeLessThan(2);
  const rows = page.locator(".readings tbody tr");
  await expect.poll(() => page.getByText(/^Values at time 2\.[45]/).count()).toBe(1);
  expect(await rows.count()).toBe(2);
});

test("the energies of the balls sum up to the engine's, with their spin", async () => {
  const page = await graphsOf("two_ball_shot");
  await page.getByRole("button", { name: "Next event" }).click();
  await expect.poll(() => page.getByText(/^Values at time 0\.33/).count()).toBe(1);
  const last = (selector: string) => page.locator(`.readings ${selector} tr td:last-child`).allTextContents();
  await expect.poll(async () => (await last("tfoot")).length).toBe(1);
  const single = (await last("tbody")).map(Number);
  expect(single.reduce((sum, energy) => sum + energy)).toBeCloseTo(Number((await last("tfoot"))[0]), 3);
});

test("a line and a graph can be switched off", async () => {
  const page = await graphsOf("midterm");
  const speed = page.getByRole("figure", { name: "Speed", exact: true });
  expect(await speed.count()).toBe(0);
  await page.getByRole("button", { name: "Speed", exact: true }).click();
  await speed.locator("canvas").waitFor();
  const red = speed.getByRole("button", { name: "red" });
  await red.click();
  expect(await red.getAttribute("aria-pressed")).toBe("false");
});

test("balls out of play are listed, and what is drawn can be chosen", async () => {
  const page = await graphsOf("two_ball_shot");
  await page.getByRole("button", { name: "To the end" }).click();
  await expect.poll(() => page.locator(".out li").allTextContents()).toEqual(["cue", "1"]);
  const paths = page.getByRole("button", { name: "Paths" });
  const picture = () => page.locator("canvas.table").evaluate((c) => (c as HTMLCanvasElement).toDataURL());
  const before = await picture();
  await paths.click();
  await expect.poll(async () => (await picture()) === before).toBe(false);
  await paths.click();
  await expect.poll(async () => (await picture()) === before).toBe(true);
});
