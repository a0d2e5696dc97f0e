/** Links: what is shared opens again with the same bits, and the address follows what is open. */

import { inflateRawSync } from "node:zlib";
import type { Page } from "playwright-core";
import { expect, test } from "vitest";
import { open, useBrowser } from "./browser";
import { linkTo, TWO_BALLS } from "./links";

useBrowser();

const clock = (page: Page) => page.locator(".clock");
const fragment = (page: Page) => page.evaluate(() => location.hash);
const heading = (page: Page) => page.locator(".bar h1").textContent();

/** The fragment of the link in the panel, once it holds the digest of the run. */
async function linkOf(page: Page): Promise<string> {
  await page.getByRole("tab", { name: "Files" }).click();
  await page.getByRole("button", { name: "Events CSV" }).and(page.locator(":enabled")).waitFor();
  await page.getByRole("button", { name: "Copy link" }).click();
  await page.getByText("The link is copied.").waitFor();
  const link = await page.getByLabel("Link", { exact: true }).inputValue();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(link);
  return link.slice(link.indexOf("#"));
}

test("a shared scenario opens with all its digits, and has the same bits", async () => {
  const permissions = { permissions: ["clipboard-read", "clipboard-write"] };
  const seed = "9007199254740993";
  const text = `{ "format": 1, "collisions": 50, "gas": { "n": 20, "packing_fraction": 0.2, "seed": ${seed} } }`;
  const sender = await open("", permissions);
  await sender.locator(".cards").first().waitFor();
  await sender.evaluate((pasted) => {
    const data = new DataTransfer();
    data.setData("text/plain", pasted);
    document.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data }));
  }, text);
  await clock(sender).waitFor();
  const link = await linkOf(sender);
  const receiver = await open(link, permissions);
  await receiver.getByText("Same bits as where the link was made.").waitFor();
  expect(await linkOf(receiver)).toBe(link);
  const packed = Buffer.from(link.slice("#scenario=".length), "base64url");
  expect(inflateRawSync(packed).toString()).toContain(seed);
});

test("a link says when bits differ, makes no claim across versions of the physics, and none without a digest", async () => {
  const page = await open(linkTo(TWO_BALLS, "sha256:00"));
  await page.getByText("This run differs from the one where the link was made.").waitFor();
  const other = await open(linkTo(TWO_BALLS, "sha256:00", 1));
  await other.getByText("made with version 1 of the physics").waitFor();
  expect(await other.getByText("differs").count()).toBe(0);
  const silent = await open(linkTo(TWO_BALLS));
  await clock(silent).waitFor();
  expect(await silent.locator(".message").count()).toBe(0);
});

test("the address names what is open, and going back closes it", async () => {
  const page = await open("#midterm");
  await expect.poll(() => heading(page)).toContain("Two balls");
  await page.getByRole("button", { name: "Gallery" }).click();
  await expect.poll(() => fragment(page)).toBe("");
  await page.goBack();
  await expect.poll(() => heading(page)).toContain("Two balls");
  await page.goForward();
  await page.locator("[data-scenario=stadium]").click();
  await expect.poll(() => fragment(page)).toBe("#stadium");
  await clock(page).waitFor();
  await page.goBack();
  await page.locator(".cards").first().waitFor();
  expect(await fragment(page)).toBe("");
});

test("a change is in the address, so that a reload keeps it, and undo takes it back there too", async () => {
  const page = await open();
  await page.locator("[data-scenario=midterm]").click();
  const duration = page.getByRole("spinbutton", { name: "Duration", exact: true });
  const setTo = async (end: string) => {
    await page.getByRole("tab", { name: "Setup" }).click();
    await duration.fill(end);
    await duration.press("Enter");
    await expect.poll(() => clock(page).textContent()).toBe(`0 of ${end}`);
  };
  await setTo("7");
  await expect.poll(() => fragment(page)).toMatch(/^#scenario=/);
  const changed = await fragment(page);
  await page.reload();
  await expect.poll(() => clock(page).textContent()).toBe("0 of 7");
  await page.getByLabel("Language").selectOption("de");
  expect(await heading(page)).toContain("Zwei Kugeln");
  await page.getByLabel("Sprache").selectOption("en");
  await setTo("8");
  await expect.poll(() => fragment(page)).not.toBe(changed);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => fragment(page)).toBe(changed);
  await page.goBack();
  await page.locator(".cards").first().waitFor();
  expect(await fragment(page)).toBe("");
});

test("what is typed and not entered stays out of the scenario that is opened over it", async () => {
  const page = await open("#eight_ball_break");
  await clock(page).waitFor();
  const [whole, address] = [await clock(page).textContent(), await fragment(page)];
  await page.evaluate(() => {
    location.hash = "midterm";
  });
  await expect.poll(() => clock(page).textContent()).toBe("0 of 5");
  await page.getByRole("tab", { name: "Setup" }).click();
  const duration = page.getByRole("spinbutton", { name: "Duration", exact: true });
  await duration.click();
  await page.keyboard.press("Control+A");
  await page.keyboard.type("3");
  await page.goBack();
  await expect.poll(() => heading(page)).toContain("Eight-ball");
  await page.getByRole("tab", { name: "Files" }).click();
  await page.getByRole("button", { name: "Events CSV" }).and(page.locator(":enabled")).waitFor();
  expect(await clock(page).textContent()).toBe(whole);
  expect(await fragment(page)).toBe(address);
});

test("what is typed before the gallery is opened is kept in the address that Back leads to", async () => {
  const page = await open("#midterm");
  await clock(page).waitFor();
  await page.getByRole("tab", { name: "Setup" }).click();
  await page.getByRole("spinbutton", { name: "Duration", exact: true }).fill("3");
  await page.getByRole("button", { name: "Gallery" }).click();
  await page.locator(".cards").first().waitFor();
  await expect.poll(() => fragment(page)).toBe("");
  await page.goBack();
  await expect.poll(() => clock(page).textContent()).toBe("0 of 3");
});

test("where nothing comes of a link the address goes back to what is there", async () => {
  const page = await open("#midterm");
  await clock(page).waitFor();
  await page.evaluate(() => {
    location.hash = "scenario=abc";
  });
  await page.locator(".stage .message").first().waitFor();
  await expect.poll(() => fragment(page)).toBe("#midterm");
});

test("a lesson has an address, and going back leaves it", async () => {
  const page = await open();
  await page.locator("[data-lesson]").first().click();
  await expect.poll(() => fragment(page)).toMatch(/^#lesson=/);
  const title = await heading(page);
  const other = await open(await fragment(page));
  await expect.poll(() => heading(other)).toBe(title);
  await page.goBack();
  await page.locator(".cards").first().waitFor();
  await expect.poll(() => heading(page)).toBe("Carom Studio");
});

test("without a clipboard the link is selected instead", async () => {
  const page = await open("#midterm");
  await page.getByRole("tab", { name: "Files" }).click();
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new Error("denied"));
  });
  await page.getByRole("button", { name: "Copy link" }).and(page.locator(":enabled")).click();
  await page.getByText("The link is selected").waitFor();
  const selected = await page.evaluate(() => String(getSelection()));
  expect(selected).toContain("#scenario=");
});
