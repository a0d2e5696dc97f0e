/** A table is set up: by forms, by dragging and by keyboard; and what the engine refuses is told and not done. */

import type { Page } from "playwright-core";
import { beforeAll, expect, test } from "vitest";
import { open, useBrowser } from "./browser";

useBrowser();

let page: Page;

beforeAll(async () => {
  page = await open();
});

async function fresh(name: string, panel: "Setup" | "Balls") {
  const gallery = page.getByRole("button", { name: "Gallery" });
  if ((await gallery.count()) > 0) await gallery.click();
  await page.locator(`[data-scenario="${name}"]`).first().click();
  await page.getByRole("tab", { name: panel }).click();
}

const box = (name: string) => page.getByRole("spinbutton", { name, exact: true });

/** Where a place of the midterm's table, 1 by 2, lies on the page. */
async function at(x: number, y: number): Promise<[number, number]> {
  const canvas = await page.locator("canvas.table").boundingBox();
  if (!canvas) throw new Error("no table");
  const scale = Math.min((canvas.width - 56) / 1, (canvas.height - 56) / 2);
  return [canvas.x + canvas.width / 2 + (x - 0.5) * scale, canvas.y + canvas.height / 2 - (y - 1) * scale];
}

async function drag(from: [number, number], to: [number, number]) {
  await page.mouse.move(...(await at(...from)));
  await page.mouse.down();
  await page.mouse.move(...(await at(...to)), { steps: 4 });
}

/** The position of the chosen ball as its form has it. */
const position = async () =>
  Promise.all(["x", "y"].map(async (axis) => Number(await box(`Position ${axis}`).inputValue())));

test("a number that is typed changes the run, and undo takes it back", async () => {
  await fresh("midterm", "Setup");
  const clock = page.locator(".clock");
  await box("Duration").fill("7");
  await box("Duration").press("Enter");
  await expect.poll(() => clock.textContent()).toBe("0 of 7");
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => clock.textContent()).toBe("0 of 5");
  await page.locator("canvas.table").focus();
  await page.keyboard.press("Control+Shift+Z");
  await expect.poll(() => clock.textContent()).toBe("0 of 7");
  await page.keyboard.press("Control+z");
  await expect.poll(() => clock.textContent()).toBe("0 of 5");
});

test("an invalid number stays with the reason, and nothing changes", async () => {
  await fresh("midterm", "Setup");
  const factor = box("Factor");
  await factor.fill("1.5");
  await factor.press("Enter");
  await page.getByText("must be between 0 and 1, got 1.5").waitFor();
  expect(await factor.getAttribute("aria-invalid")).toBe("true");
  expect(await page.getByRole("button", { name: "Undo" }).isDisabled()).toBe(true);
  await factor.press("Escape");
  expect(await factor.inputValue()).toBe("0.8");
  expect(await factor.getAttribute("aria-invalid")).toBe("false");
});

test("another shape of the table takes the balls along, and a preset its laws", async () => {
  await fresh("midterm", "Setup");
  await page.getByRole("combobox", { name: "Shape" }).selectOption({ label: "Circle" });
  await expect.poll(() => box("Radius").first().inputValue()).not.toBe("");
  await page.getByText("The balls were moved to fit the new table.").waitFor();
  await page.getByRole("combobox", { name: "Shape" }).selectOption({ label: "Ready-made" });
  await expect.poll(() => box("Gravity").getAttribute("placeholder")).toBe("default: 9.81");
});

test("a ball and its arrow are dragged, at the start", async () => {
  await fresh("midterm", "Balls");
  await page.getByRole("button", { name: "Next event" }).click();
  await drag([0.5, 1], [0.7, 1.5]);
  await page.getByText("Balls are set up at the start").waitFor();
  await page.mouse.up();
  await expect.poll(() => page.getByRole("button", { name: "Undo" }).isEnabled()).toBe(true);
  const [x = 0, y = 0] = await position();
  expect(Math.hypot(x - 0.7, y - 1.5)).toBeLessThan(0.01);
  // The fastest ball's arrow is a fifth of the table's size.
  await page.getByRole("button", { name: "red", exact: true }).click();
  await expect.poll(() => box("Velocity x").inputValue()).toBe("3");
  const seconds = (0.2 * 2) / 5;
  await drag([0.1 + 3 * seconds, 0.1 + 4 * seconds], [0.1 + 5 * seconds, 0.1 + seconds]);
  await page.mouse.up();
  await expect.poll(async () => Math.abs(Number(await box("Velocity x").inputValue()) - 5)).toBeLessThan(0.1);
  expect(Math.abs(Number(await box("Velocity y").inputValue()) - 1)).toBeLessThan(0.1);
});

test("a ball that is dragged onto another one goes back, and the reason is told", async () => {
  await fresh("midterm", "Balls");
  await drag([0.1, 0.1], [0.5, 0.95]);
  await page.locator(".reason", { hasText: 'overlaps ball "red"' }).waitFor();
  await page.mouse.up();
  await page.locator(".message", { hasText: "red stays as it was" }).waitFor();
  expect(await position()).toEqual([0.1, 0.1]);
  expect(await page.getByRole("button", { name: "Undo" }).isDisabled()).toBe(true);
});

test("a ball is chosen and moved by keyboard", async () => {
  await fresh("midterm", "Balls");
  await page.locator("canvas.table").focus();
  for (const key of ["Enter", "Tab", "ArrowRight"]) await page.keyboard.press(key);
  const step = 0.01 * 2;
  await expect.poll(async () => (await position())[0]).toBeCloseTo(0.5 + step, 9);
  await page.keyboard.press("Shift+ArrowUp");
  await expect.poll(async () => (await position())[1]).toBeCloseTo(1 + step / 10, 9);
  await page.keyboard.press("Escape");
  expect(await page.getByRole("heading", { name: "Ball blue" }).count()).toBe(0);
});

test("balls are added and removed, and a rack becomes plain balls", async () => {
  await fresh("midterm", "Balls");
  const list = page.getByRole("list", { name: "Balls" }).getByRole("listitem");
  await page.getByRole("button", { name: "Add a ball" }).click();
  await page.getByRole("heading", { name: "Ball ball3" }).waitFor();
  expect(await list.count()).toBe(3);
  await page.getByRole("button", { name: "Remove ball3" }).click();
  await expect.poll(() => list.count()).toBe(2);
  await fresh("nine_ball_break", "Balls");
  await page.getByRole("button", { name: "8", exact: true }).click();
  expect(await page.getByRole("button", { name: "Remove 8" }).count()).toBe(0);
  await page.getByRole("button", { name: "Turn into plain balls" }).click();
  await page.getByRole("button", { name: "Remove 8" }).click();
  await expect.poll(() => list.count()).toBe(9);
});
