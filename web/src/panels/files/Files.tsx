/** Files and links: what can be taken away from the page, and what can be brought to it. */

import { FromFile, FromText } from "./Bring";
import { Downloads } from "./Downloads";
import { Own } from "./Own";
import { Share } from "./Share";
import "../../style/files.css";

export function Files() {
  return (
    <div class="files">
      <Share />
      <Downloads />
      <section>
        <FromFile />
        <FromText />
      </section>
      <Own />
    </div>
  );
}
