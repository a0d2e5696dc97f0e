/** The link that has the whole scenario in it. */

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { fragmentOf, LONGEST_LINK } from "../../sharing/link";
import { run, scenario, vocabulary } from "../../studio/store";
import { number, word } from "../../words";

/** Longer links are cut by some programs for mail and chat. */
const LONG = 8000;

export function Share() {
  const field = useRef<HTMLInputElement>(null);
  const link = useLink();
  const state = useSignal<"new" | "copied" | "selected">("new");
  useEffect(() => {
    state.value = "new";
  }, [link]);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(link);
      state.value = "copied";
    } catch {
      field.current?.focus();
      field.current?.select();
      state.value = "selected";
    }
  };
  const isTooLong = link.length > LONGEST_LINK;
  return (
    <section>
      <h2>{word("share")}</h2>
      <p class="hint">{word("shareHint")}</p>
      {isTooLong ? (
        <p class="hint">{word("shareTooLong")}</p>
      ) : (
        <div class="row">
          <input
            ref={field}
            type="text"
            class="wide"
            readOnly
            value={link}
            aria-label={word("link")}
            onFocus={(event) => event.currentTarget.select()}
          />
          <button type="button" class="primary" disabled={link === ""} onClick={copy}>
            {word("copyLink")}
          </button>
        </div>
      )}
      <p class="hint" role="status">
        {state.value === "copied" && word("linkCopied")}
        {state.value === "selected" && word("linkSelected")}
        {state.value === "new" &&
          !isTooLong &&
          link.length > LONG &&
          word("linkLong", { length: number(link.length, 2) })}
      </p>
    </section>
  );
}

/** The link to what is on the table; empty until it is made. */
function useLink(): string {
  const link = useSignal("");
  const [open, shown, known] = [scenario.value, run.value, vocabulary.value];
  const digest = shown?.isWhole && shown.cutBy === null ? shown.summary.digest : null;
  useEffect(() => {
    let isLate = false;
    const make = async () => {
      if (!open || !known) return "";
      const fragment = await fragmentOf(open.json, digest, known.physics_version);
      return `${location.href.replace(/#.*$/, "")}#${fragment}`;
    };
    void make().then((made) => {
      if (!isLate) link.value = made;
    });
    return () => {
      isLate = true;
    };
  }, [open, digest, known]);
  return link.value;
}
