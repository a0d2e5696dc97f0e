/** The place of the table on the page: as large as there is room, on a phone no higher than the table's shape asks. */

import type { ComponentChildren } from "preact";
import { drawing } from "../studio/store";
import { aspect } from "./view";

export function Plate({ children, label }: { children: ComponentChildren; label?: string }) {
  const drawn = drawing.value;
  const role = label === undefined ? {} : { role: "img" as const, "aria-label": label };
  return (
    <div class="plate" style={{ "--aspect": drawn ? aspect(drawn.table) : 1 }} {...role}>
      {children}
    </div>
  );
}
