/** Puts the page together. */

import { effect } from "@preact/signals";
import { render } from "preact";
import { App } from "./studio/App";
import { begin } from "./studio/store";
import { language } from "./words";
import "./style/base.css";
import "./style/studio.css";

effect(() => {
  document.documentElement.lang = language.value;
});

const root = document.getElementById("studio");
if (root) render(<App />, root);
void begin();
