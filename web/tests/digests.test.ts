/** The page computes the same bits as every other build. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { open, useBrowser } from "./browser";

useBrowser();

const golden = JSON.parse(
  readFileSync(join(import.meta.dirname, "../../reference/digests.json"), "utf8"),
) as {
  digests: Record<string, { state: string }>;
};

test("every ready-made scenario ends on its golden digest", { timeout: 120_000 }, async () => {
  const page = await open();
  const found: Record<string, string | null> = {};
  for (const name of Object.keys(golden.digests)) {
    await page.locator(`[data-scenario="${name}"]`).click();
    await page.getByRole("tab", { name: "Run", exact: true }).click();
    await expect.poll(() => page.locator(".digest").count()).toBe(1);
    const digest = page.locator(".digest");
    // A long run is shown before it is whole.
    await expect.poll(() => digest.textContent(), { timeout: 20_000 }).toBe(golden.digests[name]?.state);
    found[name] = await digest.textContent();
    await page.getByRole("button", { name: "Gallery" }).click();
  }
  expect(Object.keys(found).length).toBeGreaterThan(20);
});
