/** Links and texts that mean harm: a clear message within two seconds, and a page that goes on. */

import { deflateRawSync } from "node:zlib";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";
import { open, useBrowser } from "./browser";
import { drop } from "./drop";
import { linkTo, packed, TWO_BALLS } from "./links";

useBrowser();

/** Milliseconds in which there is a message: two seconds, and as many for a machine that is busy with something else. */
const SOON = 4000;

let page: Page;
beforeAll(async () => {
  page = await open("#midterm");
});
afterAll(() => page.close());

/** Opens a link on a page with a scenario, and gives the message that comes. */
async function messageFor(fragment: string): Promise<string> {
  await expect.poll(() => page.locator(".clock").textContent()).toBe("0 of 5");
  await page.evaluate((hash) => {
    location.hash = hash;
  }, fragment);
  const message = page.locator(".stage .message").first();
  await message.waitFor({ timeout: SOON });
  return (await message.textContent()) ?? "";
}

/** Back to a scenario that is known, by way of another one: so it is seen when it is there. */
async function goBack() {
  for (const [name, title] of [
    ["head_on_unequal", "Head-on"],
    ["midterm", "Two balls"],
  ] as const) {
    await page.evaluate((hash) => {
      location.hash = hash;
    }, name);
    await expect.poll(() => page.locator("h1").textContent()).toContain(title);
  }
}

/** The page plays on. */
async function expectUsable() {
  await goBack();
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => page.locator(".clock").textContent()).not.toBe("0 of 5");
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await page.getByRole("button", { name: "To the start" }).click();
}

const gas = (n: number, rest: object = {}) =>
  linkTo({ format: 1, collisions: 1000, gas: { n, packing_fraction: 0.4, seed: 1, ...rest } });

const BROKEN = {
  letters: "#scenario=%%%",
  deflate: "#scenario=AAAA",
  "not JSON": packed("hello\nworld"),
  "no scenario": linkTo([1, 2]),
  "a deep one": packed(`{"format":1,"physics_version":2}\n${"[".repeat(1e6)}`),
  "another format": packed('{"format":2,"physics_version":2}\n{}'),
  "no known name": "#constructor",
};

test("a broken link is refused", async () => {
  for (const [what, fragment] of Object.entries(BROKEN)) {
    expect(await messageFor(fragment), what).toMatch(/link|not a scenario/);
    await goBack();
  }
  await expectUsable();
});

test("a scenario that inflates without end is refused", async () => {
  const bomb = `#scenario=${deflateRawSync(Buffer.alloc(200_000_000)).toString("base64url")}`;
  expect(await messageFor(bomb)).toContain("larger than the page takes");
  await expectUsable();
});

test("a link longer than two million letters is refused", async () => {
  await page.getByRole("tab", { name: "Files" }).click();
  await page.getByLabel("Or paste the text of a file, or a link:").evaluate((field: HTMLTextAreaElement) => {
    field.value = `#scenario=${"A".repeat(2_100_000)}`;
    field.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await page.getByRole("button", { name: "Open this text" }).click();
  await page.getByText("The link is longer than the page takes.").waitFor({ timeout: SOON });
  await page.getByRole("button", { name: "Close", exact: true }).click();
  await page.getByLabel("Or paste the text of a file, or a link:").fill("");
});

test("what takes minutes to set up is broken off, and the scenario before stays", async () => {
  expect(await messageFor(gas(1_000_000))).toContain("takes too long");
  await expectUsable();
  expect(await messageFor(gas(60_000, { packing_fraction: 0.1 }))).toMatch(/60,000 balls|takes too long/);
  await expectUsable();
});

test("a page that is opened with a link that takes minutes goes on to the gallery", async () => {
  const other = await open(gas(1_000_000));
  await other.getByText("takes too long").waitFor({ timeout: SOON });
  await other.locator("[data-scenario=stadium]").click();
  await other.getByRole("tab", { name: "Files" }).click();
  await other.getByRole("button", { name: "Events CSV" }).and(other.locator(":enabled")).waitFor();
  await other.close();
});

test("endless runs are shown as far as the page goes", async () => {
  const method = { kind: "stepped", dt: 1e-9 };
  expect(await messageFor(linkTo({ ...TWO_BALLS, record: "none", method }))).toMatch(
    /is shown up to|takes too long/,
  );
  await expectUsable();
  expect(await messageFor(linkTo({ ...TWO_BALLS, method: { ...method, dt: 1e-12 } }))).toContain("method.dt");
  await expectUsable();
});

test("a long run can be broken off, and is shown as far as it came", async () => {
  const long = {
    format: 1,
    duration: 1e9,
    max_events: 1e15,
    gas: { n: 1000, packing_fraction: 0.5, seed: 1 },
  };
  await page.evaluate((hash) => {
    location.hash = hash;
  }, linkTo(long));
  await page.getByRole("button", { name: "Cancel" }).click({ timeout: SOON });
  await page.getByText("Broken off: this run is shown up to").waitFor({ timeout: SOON });
  await page.getByRole("button", { name: "Events CSV" }).and(page.locator(":enabled")).waitFor();
  await expectUsable();
});

test("no text becomes part of the page", async () => {
  const evil = "<img src=x onerror=document.title=1>";
  const balls = TWO_BALLS.balls.map((ball, k) => ({ ...ball, id: `${evil}${k}` }));
  await page.evaluate(
    (hash) => {
      location.hash = hash;
    },
    linkTo({ ...TWO_BALLS, title: evil, balls }),
  );
  await expect.poll(() => page.locator("h1").textContent()).toBe(evil);
  const brought = {
    [`${evil}.json`]: JSON.stringify({ [evil]: 1 }),
    [`${evil}.csv`]: `time,${evil}0.x,${evil}0.y,${evil}\n0,0.1,0.1,0\n`,
    [`${evil}2.csv`]: `time,${evil}0.x,${evil}0.y\n0,0.1,${evil}\n`,
  };
  for (const [name, text] of Object.entries(brought)) {
    await drop(page, name, text);
    await page.locator(".message", { hasText: evil }).first().waitFor();
  }
  for (const tab of await page.getByRole("tab").all()) await tab.click();
  expect(await page.locator("img").count()).toBe(0);
  expect(await page.title()).not.toBe("1");
});
