import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    include: ["tests/**/*.test.ts"],
    testTimeout: 30_000,
    hookTimeout: 60_000,
    maxWorkers: 2,
    // A browser on a busy machine may stumble once.
    retry: 1,
    // A busy machine may take its time.
    expect: { poll: { timeout: 8000 } },
  },
});
