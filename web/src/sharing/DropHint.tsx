/** Shown over the page while a file is held over it. */

import { word } from "../words";
import { isHeld } from "./receive";

export function DropHint() {
  return isHeld.value ? <div class="drop-hint">{word("dropHere")}</div> : null;
}
