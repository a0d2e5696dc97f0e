/** The player of a recorded run: a file that plays without engine and network. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import axe from "axe-core";
import { afterAll, expect, test } from "vitest";
import { openAddress, useBrowser } from "./browser";

useBrowser();

const folder = mkdtempSync(join(tmpdir(), "player-"));
afterAll(() => rmSync(folder, { recursive: true }));

const bytes = (array: Float64Array | Int32Array | Uint32Array) =>
  Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64");

const NAME = "</script><img src=x onerror=alert(1)>";

/** A ball that goes to and fro between two walls, and one at rest: a bounce each second. */
function recorded(bounces: number) {
  const rows = Array.from({ length: bounces + 1 }, (_, k) => [k, k % 2, 0.5, k % 2 ? -1 : 1, 0, 0, 0]);
  const codes = (value: number) => bytes(new Int32Array(bounces).fill(value));
  const each = (value: (k: number) => number) =>
    bytes(Float64Array.from({ length: bounces }, (_, k) => value(k)));
  const ball = { radius: 0.1, mass: 1, position: [0, 0.5], velocity: [1, 0], color: null };
  return {
    version: "1",
    physicsVersion: 1,
    kinds: ["ball_ball", "ball_cushion"],
    motions: [],
    scenario: JSON.stringify({ title: NAME }),
    drawing: {
      table: { size: 1, bounds: [0, 0, 1, 1], pieces: [], pockets: [] },
      balls: [
        { ...ball, id: NAME },
        { ...ball, id: "still", position: [0.5, 0.8], velocity: [0, 0] },
      ],
      units: {},
      isOnCloth: false,
    },
    summary: {
      status: "time_limit",
      endTime: bounces + 0.5,
      digest: "sha256:00",
      ballIds: [NAME, "still"],
      diagnostics: { events: {} },
      references: [],
    },
    film: {
      width: 7,
      firstRows: bytes(Uint32Array.of(0, rows.length, rows.length + 1)),
      numbers: bytes(Float64Array.from([...rows.flat(), 0, 0.5, 0.8, 0, 0, 0, 0])),
    },
    events: {
      quantities: {
        time: each((k) => k + 1),
        x: each((k) => (k + 1) % 2),
        y: each(() => 0.5),
        normalX: each((k) => (k % 2 ? 1 : -1)),
        normalY: each(() => 0),
        closingSpeed: each(() => 1),
        impulse: each(() => 2),
      },
      codes: {
        kind: codes(1),
        ballA: codes(0),
        ballB: codes(-1),
        cushion: codes(0),
        pocket: codes(-1),
        cluster: codes(-1),
      },
    },
    cushionIds: ["wall"],
    pocketIds: [],
  };
}

async function openPlayer(bounces: number) {
  const template = readFileSync(join(import.meta.dirname, "../dist-player/player.html"), "utf-8");
  const text = JSON.stringify(recorded(bounces)).replaceAll("<", "\\u003c");
  const place = /(<script type="application\/json" id="run">)[^<]*/;
  const file = join(folder, `${bounces}.html`);
  writeFileSync(
    file,
    template.replace(place, (_, start) => start + text),
  );
  return openAddress(pathToFileURL(file).href, { offline: true });
}

test("a run plays, is scrubbed, and goes from event to event", async () => {
  const page = await openPlayer(7);
  const clock = page.locator(".clock");
  expect(await clock.textContent()).toBe("0 of 7.5");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => clock.textContent()).not.toBe("0 of 7.5");
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await page.getByRole("slider", { name: "Time", exact: true }).fill("4000");
  expect(await clock.textContent()).toBe("3 of 7.5");
  await page.getByRole("button", { name: "Next event" }).click();
  expect(await clock.textContent()).toBe("4 of 7.5");
  await page.getByRole("button", { name: "Previous event" }).click();
  expect(await clock.textContent()).toBe("3 of 7.5");
  await page.locator("#event-5").click();
  expect(await clock.textContent()).toBe("6 of 7.5");
});

test("what is written in a scenario is shown as text", async () => {
  const page = await openPlayer(3);
  expect(await page.getByRole("heading", { level: 1 }).textContent()).toBe(NAME);
  expect(await page.locator(".who").first().textContent()).toBe(` ${NAME}→ wall`);
  expect(await page.locator("img").count()).toBe(0);
});

test("a list of fifty thousand events shows the one that the time is at", async () => {
  const page = await openPlayer(50_000);
  await page.getByRole("button", { name: "To the end" }).click();
  const current = page.locator("[aria-selected=true]");
  await expect.poll(() => current.textContent()).toContain("50,000");
  expect(await page.getByRole("row").count()).toBeLessThan(60);
});

test("it is accessible, light and dark, and fits a phone", async () => {
  const page = await openPlayer(30);
  await page.setViewportSize({ width: 360, height: 640 });
  await page.evaluate(axe.source);
  for (const theme of ["light", "dark"]) {
    expect(await page.evaluate(() => document.documentElement.dataset["theme"])).toBe(theme);
    const found = await page.evaluate(() => (window as unknown as { axe: typeof axe }).axe.run());
    expect(found.violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([]);
    await page.getByRole("button", { name: "Light or dark" }).click();
  }
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
});
