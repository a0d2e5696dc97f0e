/** The built page, served, and a Chromium to open it in: for the pictures and for the timings. */

import { join } from "node:path";
import { chromium } from "playwright-core";
import { preview } from "vite";

export const ROOT = join(import.meta.dirname, "..");

const server = await preview({ root: ROOT, configFile: false, preview: { host: "127.0.0.1" } });
export const address = server.resolvedUrls.local[0];

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });

export async function end() {
  await browser.close();
  await server.close();
}
