/** Parts of the page that the start does not wait for: they are fetched when they are shown, or else once it is idle. */

import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { say } from "./store";

/** What is tried in vain here is fetched again, and told of, where it is needed. */
const inVain = () => {};

/** What fetches each part. */
const parts: (() => void)[] = [
  () => void import("uplot").catch(inVain),
  () => void import("svgcanvas").catch(inVain),
];

/** A component that is nothing until it has been fetched. */
export function later(fetched: () => Promise<ComponentType>): ComponentType {
  const component = signal<ComponentType | null>(null);
  let isAskedFor = false;
  const ask = () => {
    if (isAskedFor) return;
    isAskedFor = true;
    fetched().then(
      (found) => {
        component.value = found;
      },
      () => {
        isAskedFor = false;
        say("notFetched");
      },
    );
  };
  parts.push(ask);
  return () => {
    const Found = component.value;
    if (!Found) ask();
    return Found ? <Found /> : null;
  };
}

/** Fetches what has not been yet, so that the page needs no network from then on. */
export function fetchRest() {
  const idle = window.requestIdleCallback ?? ((action: () => void) => setTimeout(action, 1000));
  idle(() => {
    for (const fetchPart of parts) fetchPart();
  });
}
