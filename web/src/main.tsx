/** Puts the page together. */

import { effect } from "@preact/signals";
import { render } from "preact";
import { followAddress } from "./sharing/address";
import { receive } from "./sharing/receive";
import { App, headline } from "./studio/App";
import { isEmbedded, openFramed } from "./studio/embed";
import { fetchRest } from "./studio/later";
import { begin } from "./studio/store";
import { language, word } from "./words";
import "./style/base.css";
import "./style/studio.css";
import "./style/gallery.css";

effect(() => {
  document.documentElement.lang = language.value;
  const [open, page] = [headline(), word("title")];
  document.title = open === page ? page : `${open} · ${page}`;
});

const root = document.getElementById("studio");
if (root) render(<App />, root);
void begin().then(fetchRest);
if (isEmbedded) void openFramed();
else {
  followAddress();
  receive();
}
