/** Light or dark: as the system has it, until the user says otherwise. */

import { computed, effect, signal } from "@preact/signals";
import { remember, remembered } from "./visit";

const system = window.matchMedia("(prefers-color-scheme: dark)");
const systemIsDark = signal(system.matches);
system.addEventListener("change", () => {
  systemIsDark.value = system.matches;
});

/** What the user has said; null is nothing. */
const said = signal<boolean | null>({ dark: true, light: false }[remembered("theme") ?? ""] ?? null);

export const isDark = computed(() => said.value ?? systemIsDark.value);

export function toggleTheme() {
  said.value = !isDark.peek();
  remember("theme", said.value ? "dark" : "light");
}

effect(() => {
  document.documentElement.dataset["theme"] = isDark.value ? "dark" : "light";
});
