/** The start page: the ready-made scenarios. */

import { word } from "../words";
import { Messages } from "./App";
import { SCENARIOS } from "./scenarios";
import { openNamed } from "./store";

export function Gallery() {
  return (
    <main class="gallery">
      <p class="tagline">{word("tagline")}</p>
      <Messages />
      <ul class="cards">
        {Object.keys(SCENARIOS).map((name) => (
          <li key={name}>
            <button type="button" class="card" data-scenario={name} onClick={() => openNamed(name)}>
              {name}
            </button>
          </li>
        ))}
      </ul>
    </main>
  );
}
