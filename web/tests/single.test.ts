/** The page as one file, opened from disk where there is no network. */

import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { expect, test } from "vitest";
import { openAddress, openScenario, useBrowser } from "./browser";

useBrowser();

const FILE = pathToFileURL(join(import.meta.dirname, "../dist/carom-studio.html")).href;

test("the file opens from disk with the network off, computes and plays", async () => {
  const page = await openAddress("about:blank", { offline: true });
  const asked: string[] = [];
  page.on("request", (request) => asked.push(request.url().slice(0, 40)));
  await page.goto(FILE);
  await openScenario(page, "midterm");
  const clock = page.locator(".clock");
  await expect.poll(() => clock.textContent()).toBe("0 of 5");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await expect.poll(() => clock.textContent()).not.toBe("0 of 5");
  // Panels that are files of their own elsewhere are in it, too.
  for (const tab of await page.getByRole("tab").all()) await tab.click();
  await page.getByRole("tab", { name: "Graphs" }).click();
  await page.locator(".uplot canvas").first().waitFor();
  expect(asked.filter((url) => !/^(data|blob):/.test(url))).toEqual([FILE.slice(0, 40)]);
});

test("the file refuses what is not in it", async () => {
  const page = await openAddress("about:blank", { offline: true });
  await page.goto(FILE);
  page.removeAllListeners("console");
  const refused = page.evaluate(
    () =>
      new Promise<string>((resolve) => {
        document.addEventListener("securitypolicyviolation", (event) => resolve(event.violatedDirective));
        const script = document.createElement("script");
        script.textContent = "document.title = 'injected'";
        document.body.append(script);
      }),
  );
  await expect(refused).resolves.toBe("script-src-elem");
  expect(await page.title()).not.toBe("injected");
});
