/** A step of the build that leaves out the ready-made scenarios where none is opened. */

import type { Plugin } from "vite";

export const withoutScenarios = (): Plugin => ({
  name: "without-scenarios",
  enforce: "pre",
  load: (id) => (/\/scenarios\/\w+\.toml/.test(id) ? 'export default "";' : null),
});
