/** Files that the page gives, and files that are brought to it. */

import { readFile } from "node:fs/promises";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { exact } from "../src/panels/files/csv";
import { open, useBrowser } from "./browser";
import { drop } from "./drop";

useBrowser();

async function openFiles(name: string): Promise<Page> {
  const page = await open(`#${name}`);
  await page.getByRole("tab", { name: "Files" }).click();
  await page.getByRole("button", { name: "Run JSON" }).and(page.locator(":enabled")).waitFor();
  return page;
}

/** The file that a button gives: its name and what is in it. */
async function saved(page: Page, name: string): Promise<[string, Buffer]> {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name, exact: true }).click(),
  ]);
  return [download.suggestedFilename(), await readFile(await download.path())];
}

const first = (file: Buffer, count: number) => file.toString().split("\n").slice(0, count);

test("numbers are written as C's %.17g writes them, ties to even too", () => {
  const written = {
    "2.9802322387695312e-08": 2 ** -25,
    "8.9406967163085938e-08": 3 * 2 ** -25,
    "-0.10000000000000001": -0.1,
    "10000000000000000": 1e16,
    "1e+17": 1e17,
    "0.0001": 1e-4,
    "1.0000000000000001e-05": 1e-5,
    "4.9406564584124654e-324": 5e-324,
    "1.0000000000000001e+300": 1e300,
    "-0": -0,
    nan: Number.NaN,
  };
  for (const [text, value] of Object.entries(written)) expect(exact(value)).toBe(text);
});

test("events and trajectories have the columns, words and digits that Python writes", async () => {
  const page = await openFiles("midterm");
  const [eventsName, events] = await saved(page, "Events CSV");
  expect(eventsName).toBe("midterm_events.csv");
  expect(first(events, 3)).toEqual([
    "index,time,kind,ball_a,ball_b,cushion,x,y,normal_x,normal_y,closing_speed,impulse,cluster,pocket",
    "0,0.27500000000000002,ball_cushion,red,,right,1,1.2000000000000002,-1,0,3,5.4000000000000004,,",
    "1,0.50156249999999991,ball_cushion,red,,top,0.38125000000000009,2,0,-1,3.2000000000000002,5.7600000000000007,,",
  ]);
  await page.getByLabel("Times in the trajectory").fill("11");
  const [, trajectory] = await saved(page, "Trajectory CSV");
  expect(first(trajectory, 3)).toEqual([
    "time,red.x,red.y,red.vx,red.vy,blue.x,blue.y,blue.vx,blue.vy",
    "0,0.10000000000000001,0.10000000000000001,3,4,0.5,1,0,0",
    "0.5,0.38500000000000001,1.9200000000000002,-2.4000000000000004,3.2000000000000002,0.5,1,0,0",
  ]);
  expect(trajectory.toString().trimEnd().split("\n")).toHaveLength(12);
  await page.getByLabel("Times in the trajectory").fill("1.5");
  expect(await page.getByRole("button", { name: "Trajectory CSV" }).isDisabled()).toBe(true);
});

test("a ball on a cloth has its spin and motion, and is nowhere once it is in a pocket", async () => {
  const page = await openFiles("eight_ball_break");
  const [, events] = await saved(page, "Events CSV");
  expect(events.toString()).toContain(
    ",ball_pocket,15,,,1.2522619894011315,2.5350596192009496,0,0,0,0,,rt\n",
  );
  const [, trajectory] = await saved(page, "Trajectory CSV");
  const [header, start] = first(trajectory, 2);
  expect(header).toMatch(
    /^time,cue\.x,cue\.y,cue\.z,cue\.vx,cue\.vy,cue\.vz,cue\.wx,cue\.wy,cue\.wz,cue\.motion,/,
  );
  expect(start).toContain(",sliding,");
  expect(trajectory.toString()).toContain("nan,nan,nan,nan,nan,nan,nan,nan,nan,pocketed");
});

test("the scenario and the run come back from their files, and pictures are pictures", async () => {
  const page = await openFiles("pinball");
  const [tomlName, toml] = await saved(page, "Scenario TOML");
  expect(tomlName).toBe("pinball.toml");
  const [, json] = await saved(page, "Run JSON");
  const link = await page.getByLabel("Link", { exact: true }).inputValue();
  for (const [name, file] of Object.entries({ "mine.toml": toml, "mine.json": json })) {
    await page.getByRole("button", { name: "Gallery" }).click();
    await drop(page, name, file.toString());
    await expect.poll(() => page.getByLabel("Link", { exact: true }).inputValue()).toBe(link);
  }
  const [, png] = await saved(page, "Picture PNG");
  expect(png.subarray(1, 4).toString()).toBe("PNG");
  const [, svg] = await saved(page, "Drawing SVG");
  expect(svg.toString()).toMatch(/^<svg .*<path .*<text .*>gold<.*<\/svg>$/s);
  const [, width, height] = /^<svg [^>]*width="(\d+)" height="(\d+)"/.exec(svg.toString()) ?? [];
  expect(svg.toString()).toMatch(new RegExp(`^<svg [^>]*viewBox="0 0 ${width} ${height}"`));
});

test("one's own trajectory lies over the run, with its largest distance", async () => {
  const page = await openFiles("midterm");
  const [, trajectory] = await saved(page, "Trajectory CSV");
  await drop(page, "same.csv", trajectory.toString());
  const rows = page.locator("table.own tbody tr");
  await expect
    .poll(() => rows.allInnerTexts())
    .toEqual([expect.stringMatching(/red\s+0\s/), expect.stringMatching(/blue\s+0\s/)]);
  await drop(page, "mine.csv", "t;x;y\n0;0,1;0,1\n0,1;0,4;0,53\n7;1;1\n");
  await expect.poll(() => rows.allInnerTexts()).toEqual([expect.stringMatching(/red\s+0\.03\s+0\.1/)]);
  await page.getByText("It names no ball").waitFor();
  await page.getByText("1 of its rows are not within the time of the run.").waitFor();
  await page.getByRole("button", { name: "0.1", exact: true }).click();
  await expect.poll(() => page.locator(".clock").textContent()).toBe("0.1 of 5");
  await page.getByRole("button", { name: "Remove" }).click();
  expect(await rows.count()).toBe(0);
});

test("what of a trajectory is not understood is told with its line and column", async () => {
  const page = await openFiles("midterm");
  const complaint = page.getByRole("tabpanel").locator(".message li");
  await drop(page, "a.csv", "time,red.x,red.y\n0,0.1,0.1\n0.1,abc,0.5\n0.2,0.7\n");
  await expect
    .poll(() => complaint.allInnerTexts())
    .toEqual(["Line 3, red.x: “abc” is not a number.", "Line 4: 2 columns, and 3 are wanted."]);
  await drop(page, "b.csv", "when,red.x,red.y\n0,0.1,0.1\n");
  await expect.poll(() => complaint.allInnerTexts()).toEqual([expect.stringContaining("when, red.x, red.y")]);
  await drop(page, "c.csv", "time,red_x,blue_x,blue_y\n0,0.1,0.1,1\n");
  await expect.poll(() => complaint.allInnerTexts()).toEqual([expect.stringContaining("column red_x")]);
});
