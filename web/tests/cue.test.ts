/** Cue mode: aim, see where that leads, shoot, go on from where the balls lie, and take that back. */

import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, useBrowser } from "./browser";

useBrowser();

async function openCue(name: string): Promise<Page> {
  const page = await open();
  await page.locator(`[data-scenario="${name}"]`).click();
  await page.getByRole("tab", { name: "Cue" }).click();
  return page;
}

const leads = (page: Page) => page.locator(".cue .leads").textContent();
const pixels = (page: Page) =>
  page.locator("canvas.table").evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
const clock = (page: Page) => page.locator(".clock").textContent();
const toEnd = (page: Page) => page.getByRole("button", { name: "To the end" }).click();

test("the predicted line follows direction and speed, and a shot leads to the next and back", async () => {
  const page = await openCue("nine_ball_break");
  await expect.poll(() => leads(page)).toMatch(/^Hits 1 first, at 0\.\d+ s$/);
  const [before, drawn] = [await leads(page), await pixels(page)];
  const direction = page.getByRole("slider", { name: "Direction" });
  await direction.focus();
  await page.keyboard.press("ArrowRight");
  expect(await page.getByRole("spinbutton", { name: "Direction" }).inputValue()).toBe("96.8");
  await page.keyboard.press("Shift+ArrowLeft");
  expect(await page.getByRole("spinbutton", { name: "Direction" }).inputValue()).toBe("96.79");
  await expect.poll(() => pixels(page)).not.toBe(drawn);
  const speed = page.getByRole("spinbutton", { name: "Speed of the cue" });
  await speed.fill("5");
  await speed.press("Enter");
  await expect.poll(() => leads(page)).not.toBe(before);

  await page.getByRole("button", { name: "Shoot" }).click();
  await expect.poll(() => clock(page)).not.toMatch(/^0 of/);
  await toEnd(page);
  await expect.poll(() => page.locator(".cue .outcome").textContent()).toContain("First ball hit1");
  const lying = await pixels(page);
  await page.getByRole("button", { name: "Next shot" }).click();
  await expect.poll(() => clock(page)).toMatch(/^0 of/);
  await expect.poll(() => leads(page)).toMatch(/^Hits \d first/);
  expect(await pixels(page)).not.toBe(lying);

  await page.getByRole("button", { name: "Take back" }).click();
  await expect.poll(() => leads(page)).toMatch(/^Hits 1 first/);
  expect(await page.getByRole("spinbutton", { name: "Direction" }).inputValue()).toBe("96.79");
});

test("a cue ball that falls is out of play, and back for the next shot", async () => {
  const page = await openCue("nine_ball_break");
  for (const [name, value] of [
    ["Direction", "215.2"],
    ["Speed of the cue", "1.5"],
  ] as const) {
    await page.getByRole("spinbutton", { name }).fill(value);
    await page.keyboard.press("Enter");
  }
  await expect.poll(() => leads(page)).toMatch(/^Hits no ball, and falls into lb/);
  await page.getByRole("button", { name: "Shoot" }).click();
  await expect.poll(() => clock(page)).not.toMatch(/^0 of/);
  await toEnd(page);
  await expect.poll(() => page.locator(".cue .outcome").textContent()).toContain("Pocketedcue (lb)");
  expect(await page.locator(".cue .gone li").allTextContents()).toEqual(["cue"]);
  await page.getByRole("button", { name: "Next shot" }).click();
  await expect.poll(() => page.locator(".messages").textContent()).toMatch(/cue was out of play/);
  expect(await page.locator(".cue .gone").count()).toBe(0);
});

test("the next shot waits for balls that move when the run ends, and says so", async () => {
  const page = await openCue("eight_ball_break");
  await page.getByRole("tab", { name: "Setup" }).click();
  const duration = page.getByRole("spinbutton", { name: "Duration", exact: true });
  await duration.fill("1");
  await duration.press("Enter");
  await expect.poll(() => clock(page)).toBe("0 of 1");
  await toEnd(page);
  await page.getByRole("tab", { name: "Cue" }).click();
  await page.getByRole("button", { name: "Next shot" }).click();
  await expect.poll(() => page.locator(".messages").textContent()).toContain("Balls still move");
  expect(await clock(page)).toBe("1 of 1");
});

test("what the stick and the tip cannot do is said", async () => {
  const page = await openCue("nine_ball_break");
  await expect.poll(() => page.locator(".cue .obstructed").textContent()).toContain("cushion bottom");
  await page.locator(".cue .obstructed button").click();
  await expect.poll(() => page.locator(".cue .obstructed").count()).toBe(0);
  await page.getByRole("slider", { name: "Where the tip" }).focus();
  for (let k = 0; k < 13; k++) await page.keyboard.press("ArrowLeft");
  await expect.poll(() => leads(page)).toContain("miscue");
  await page.getByRole("button", { name: "Shoot" }).click();
  await expect.poll(() => page.locator(".messages").textContent()).toContain("the tip slipped off");
  await page.getByRole("spinbutton", { name: "Speed of the cue" }).fill("-1");
  await page.keyboard.press("Enter");
  await expect.poll(() => page.getByRole("alert").textContent()).toContain("shot.V0");
});

test("dragging on the table turns the aim, and a click points it", async () => {
  const page = await openCue("two_ball_shot");
  await expect.poll(() => leads(page)).toMatch(/^Hits 1/);
  const direction = page.getByRole("spinbutton", { name: "Direction" });
  const box = await page.locator("canvas.table").boundingBox();
  const at = (x: number, y: number) =>
    [(box?.x ?? 0) + x * (box?.width ?? 0), (box?.y ?? 0) + y * (box?.height ?? 0)] as const;
  await page.mouse.move(...at(0.6, 0.3));
  await page.mouse.down();
  await page.mouse.move(...at(0.6, 0.7), { steps: 5 });
  await page.mouse.up();
  const turned = Number(await direction.inputValue());
  expect(turned).toBeGreaterThan(320);
  expect(turned).toBeLessThan(350);
  await page.mouse.click(...at(0.5, 0.1));
  expect(await direction.inputValue()).toBe("90");
  await page.locator("canvas.table").press("ArrowLeft");
  expect(await direction.inputValue()).toBe("90.5");
});
