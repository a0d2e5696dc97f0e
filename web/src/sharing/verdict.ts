/** Whether a scenario that came with a link gives the bits that it gave where the link was made. */

import { computed } from "@preact/signals";
import { run, scenario, vocabulary } from "../studio/store";

export type Verdict = "same" | "different" | "otherPhysics";

/** Null where there is nothing to say: no link, no digest in it, no whole run here, or another scenario since. */
export const verdict = computed<Verdict | null>(() => {
  const claim = scenario.value?.link;
  if (!claim?.digest || !vocabulary.value) return null;
  if (claim.physicsVersion !== vocabulary.value.physics_version) return "otherPhysics";
  const shown = run.value;
  if (!shown?.isWhole || shown.cutBy !== null) return null;
  return shown.summary.digest === claim.digest ? "same" : "different";
});
