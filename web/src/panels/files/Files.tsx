/** Files and links: what can be taken away from the page, and what can be brought to it. */

import { misread, own } from "../../own/own";
import { FromFile, FromText } from "./Bring";
import { Downloads } from "./Downloads";
import { Own } from "./Own";
import { Share } from "./Share";
import "../../style/files.css";

export function Files() {
  const isOwnThere = own.value !== null || misread.value !== null;
  return (
    <div class="files">
      {isOwnThere && <Own />}
      <Share />
      <Downloads />
      <section>
        <FromFile />
        <FromText />
      </section>
      {!isOwnThere && <Own />}
    </div>
  );
}
