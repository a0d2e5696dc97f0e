/** Says whether a scenario from a link gives the same bits here. */

import { signal } from "@preact/signals";
import { Close } from "../studio/App";
import { opened, scenario, vocabulary } from "../studio/store";
import { word } from "../words";
import type { Word } from "../words/en";
import { type Verdict, verdict } from "./verdict";

const SAID: Record<Verdict, Word> = {
  same: "linkSame",
  different: "linkDifferent",
  otherPhysics: "linkOtherPhysics",
};

/** The opening whose verdict was closed. */
const closed = signal(-1);

export function LinkVerdict() {
  const found = verdict.value;
  if (!found || closed.value === opened.value) return null;
  const versions = {
    there: scenario.value?.link?.physicsVersion ?? "",
    here: vocabulary.value?.physics_version ?? "",
  };
  return (
    <div class={found === "different" ? "message wrong" : "message"}>
      <span>{word(SAID[found], versions)}</span>
      <Close
        onClick={() => {
          closed.value = opened.value;
        }}
      />
    </div>
  );
}
