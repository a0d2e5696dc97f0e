/** Parts of the page that are fetched when they are first shown, so that the start waits for none of them. */

import { signal } from "@preact/signals";
import type { ComponentType } from "preact";

/** A component that is nothing until it has been fetched. */
export function later(fetched: () => Promise<ComponentType>): ComponentType {
  const component = signal<ComponentType | null>(null);
  let isAskedFor = false;
  return () => {
    if (!isAskedFor) {
      isAskedFor = true;
      void fetched().then((found) => {
        component.value = found;
      });
    }
    const Found = component.value;
    return Found ? <Found /> : null;
  };
}
