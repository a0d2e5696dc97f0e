/** The event log: it leads to its events, by mouse and by keys, and can be filtered. */

import axe from "axe-core";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, openScenario, useBrowser } from "./browser";

useBrowser();

async function eventsOf(name: string): Promise<Page> {
  const page = await open();
  await openScenario(page, name);
  await page.getByRole("tab", { name: "Events" }).click();
  await page.locator(".rows .log-row").first().waitFor();
  return page;
}

const clock = (page: Page) => page.locator(".clock").textContent();
const now = (page: Page) => page.locator(".rows .log-row.now").getByRole("gridcell").first().textContent();

test("a click and the keys go to events, and the strip shows what they change", async () => {
  const page = await eventsOf("midterm");
  await page.getByRole("row", { name: "Balls collide" }).first().click();
  expect(await clock(page)).toBe("0.8647 of 5");
  await page.getByRole("heading", { name: "Event 3: Balls collide at time 0.86473" }).waitFor();
  const group = page.locator(".encounter tbody", { hasText: "px" });
  // The momentum of two balls of equal mass passes from one to the other; their sum stays.
  const cells = (row: string) => group.getByRole("row", { name: row }).getByRole("cell").allTextContents();
  const [red, blue] = [await cells("red"), await cells("blue")];
  expect(Number(red[2])).toBe(-Number(blue[2]));
  expect((await cells("together"))[2]).toBe("0");
  expect(await page.locator(".strip canvas").count()).toBe(5);
  await page.locator(".log").focus();
  await page.keyboard.press("ArrowDown");
  await expect.poll(() => now(page)).toBe("4");
  await page.keyboard.press("End");
  await expect.poll(() => now(page)).toBe("11");
});

test("only the events of a kind and a ball are listed when asked for", async () => {
  const page = await eventsOf("midterm");
  await page.getByLabel("Kind").selectOption({ label: "Balls collide" });
  const kinds = await page.locator(".rows .kind").allTextContents();
  expect(new Set(kinds)).toEqual(new Set(["Balls collide"]));
  await page.getByLabel("Kind").selectOption({ label: "all" });
  await page.getByRole("combobox", { name: "Ball" }).selectOption({ label: "blue" });
  for (const who of await page.locator(".rows .who").allTextContents()) expect(who).toContain("blue");
});

test("of a long log only what is in view is there, and the row of the moment stays in view", async () => {
  const page = await eventsOf("gas");
  await page.getByRole("button", { name: "To the end" }).click();
  await expect.poll(() => now(page)).toBe("1999");
  expect(await page.locator(".rows .log-row").count()).toBeLessThan(40);
  const [list, row] = await Promise.all([
    page.locator(".log").boundingBox(),
    page.locator(".rows .log-row.now").boundingBox(),
  ]);
  expect(row && list && row.y + row.height <= list.y + list.height + 1).toBe(true);
});

/** What is cut off in the list, and what sticks out of its row. */
const cutOff = (page: Page) =>
  page.locator(".log-row").evaluateAll((rows) =>
    rows.flatMap((row) => {
      const outer = row.getBoundingClientRect();
      const isCut = (part: Element) => {
        const { width, right, bottom } = part.getBoundingClientRect();
        const isOutside = width > 0 && (right > outer.right || bottom > outer.bottom + 0.5);
        return isOutside || part.scrollWidth > part.clientWidth;
      };
      const parts = [row, ...row.querySelectorAll("[role], .kind, .who")];
      return parts.filter(isCut).map(({ textContent }) => textContent);
    }),
  );

test("all words of the list can be read at every width, in both languages", async () => {
  for (const [locale, tab] of [
    ["en-GB", "Events"],
    ["de-DE", "Ereignisse"],
  ] as const) {
    const page = await open("#snooker_break", { locale });
    await page.getByRole("tab", { name: tab }).click();
    for (const [width, height] of [
      [360, 740],
      [840, 600],
      [1000, 700],
      [1280, 800],
      [1920, 1080],
      [3840, 2160],
    ] as const) {
      await page.setViewportSize({ width, height });
      for (const scroll of [0, 600, 3000]) {
        await page.locator(".log").evaluate((log, top) => log.scrollTo(0, top), scroll);
        expect(await cutOff(page), `${locale}, ${width} pixels`).toEqual([]);
      }
    }
  }
});

test("graphs and events are accessible", async () => {
  const page = await eventsOf("midterm");
  await page.getByRole("button", { name: "Next event" }).click();
  for (const panel of ["Events", "Graphs"]) {
    await page.getByRole("tab", { name: panel }).click();
    await page.locator(".panel canvas").first().waitFor();
    await page.evaluate(axe.source);
    const violations = await page.evaluate(async () => {
      const page = window as unknown as { axe: typeof axe };
      return (await page.axe.run()).violations.map(({ id, nodes }) => [id, ...nodes.map(({ html }) => html)]);
    });
    expect(violations).toEqual([]);
  }
});
