/** A Chromium with the built page, for the tests. */

import { existsSync, readFileSync } from "node:fs";
import { createServer, type Server } from "node:http";
import { extname, join, normalize } from "node:path";
import { type Browser, type BrowserContextOptions, chromium, type Page } from "playwright-core";
import { afterAll, beforeAll } from "vitest";

const DIST = join(import.meta.dirname, "../dist");
const TYPES: Record<string, string> = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};

const ARGUMENTS = ["--no-sandbox", "--disable-gpu", "--disable-background-networking"];

let browser: Browser;
let server: Server;
let address: string;

/** Call in a test file: it starts the browser before its tests, and ends it after. */
export function useBrowser() {
  beforeAll(async () => {
    server = createServer((request, response) => {
      const path = normalize(new URL(request.url ?? "/", "http://page").pathname);
      const file = join(DIST, path === "/" ? "index.html" : path);
      if (!file.startsWith(DIST) || !existsSync(file)) return void response.writeHead(404).end();
      response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" });
      response.end(readFileSync(file));
    });
    await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
    const at = server.address();
    address = `http://127.0.0.1:${typeof at === "object" && at ? at.port : 0}/`;
    const executablePath = process.env["CHROMIUM"] ?? "/usr/bin/chromium";
    browser = await chromium.launch({ executablePath, args: ARGUMENTS });
  });
  afterAll(async () => {
    await browser.close();
    server.close();
  });
}

/** Opens the page anew; what it throws or complains of fails the test. */
export const open = (fragment = "", options: BrowserContextOptions = {}): Promise<Page> =>
  openAddress(address + fragment, options);

/** Opens any address in the same way. */
export async function openAddress(where: string, options: BrowserContextOptions = {}): Promise<Page> {
  const context = await browser.newContext({
    locale: "en-GB",
    viewport: { width: 1280, height: 800 },
    ...options,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(8000);
  page.on("pageerror", (error) => {
    throw error;
  });
  page.on("console", (message) => {
    if (message.type() === "error") throw new Error(message.text());
  });
  await page.goto(where);
  return page;
}

/** Opens a ready-made scenario from the gallery. */
export async function openScenario(page: Page, name: string) {
  await page.locator(`[data-scenario="${name}"]`).click();
  await page.locator(".clock").waitFor();
}
