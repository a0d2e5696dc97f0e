/**
 * Takes the pictures of the studio for the docs: `make tour` writes them into docs/images/.
 */

import { join } from "node:path";
import { address, browser, end, ROOT } from "./served.mjs";

const IMAGES = join(ROOT, "../docs/images");
const DESK = { width: 1280, height: 800 };

const seek = async (page, part) => {
  await page.locator(".transport .line input").fill(String(Math.round(part * 10_000)));
};

/** Each view: its name, the scenario, and what is done before the picture is taken. */
const views = [
  ["gallery", "", async () => {}],
  [
    "events",
    "#midterm",
    async (page) => {
      await page.getByRole("tab", { name: "Events" }).click();
      for (let k = 0; k < 4; k++) await page.getByRole("button", { name: "Next event" }).click();
    },
  ],
  [
    "graphs",
    "#midterm",
    async (page) => {
      await page.getByRole("tab", { name: "Graphs" }).click();
      await seek(page, 0.35);
    },
  ],
  [
    "compare",
    "#midterm",
    async (page) => {
      await page.getByRole("tab", { name: "Compare" }).click();
      await page.getByLabel("The same in time steps").check();
      await seek(page, 0.3);
    },
  ],
  ["setup", "#sinai", async (page) => page.getByRole("tab", { name: "Setup" }).click()],
  ["cue", "#nine_ball_break", async (page) => page.getByRole("tab", { name: "Cue" }).click()],
  ["lesson", "#lesson=pi", async () => {}],
  ["phone", "#two_ball_shot", async (page) => seek(page, 0.5), { width: 390, height: 844 }, "dark"],
];

const chosen = process.argv.slice(2);
for (const [name, fragment, prepare, viewport = DESK, colorScheme = "light"] of views) {
  if (chosen.length > 0 && !chosen.includes(name)) continue;
  const page = await browser.newPage({ viewport, colorScheme, locale: "en-GB" });
  page.setDefaultTimeout(8000);
  await page.goto(address + fragment);
  await page.waitForTimeout(1500);
  await prepare(page);
  await page.waitForTimeout(800);
  await page.screenshot({ path: join(IMAGES, `studio-${name}.png`) });
  await page.close();
}
await end();
