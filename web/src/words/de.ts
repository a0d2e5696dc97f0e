import type { Words } from "./en";

/** All words of the page, in German. */
export const de: Words = {
  // The page
  title: "Carom Studio",
  tagline: "Wie sich Kugeln auf einem Tisch bewegen: exakt und überall gleich",
  language: "Sprache",
  languageName: "Deutsch",
  theme: "Hell oder dunkel",
  gallery: "Galerie",
  loading: "Der Rechenkern wird geladen …",
  close: "Schließen",
  cancel: "Abbrechen",

  // Time
  play: "Abspielen",
  pause: "Anhalten",
  timeline: "Zeit",
  speed: "Tempo",
  speedOf: "{speed}-mal so schnell wie in Wirklichkeit",
  nextEvent: "Nächstes Ereignis",
  previousEvent: "Voriges Ereignis",
  toStart: "Zum Anfang",
  toEnd: "Zum Ende",
  timeOf: "{time} von {end}",
  computing: "Es wird gerechnet: {events} Ereignisse, Zeit {time}",

  // What is wrong
  problemsTitle: "Das ist noch kein Szenario",
  engineStuck:
    "Das aufzubauen dauert auf dieser Seite zu lange, deshalb wurde es abgebrochen. Das vorige Szenario ist noch da.",
  engineBroken: "Der Rechenkern ist ausgefallen und neu gestartet. Das vorige Szenario ist noch da.",
  cut: "Die Seite behält {events} Ereignisse eines Laufs: Dieser wird bis {time} gezeigt.",

  // The table
  tableLabel: "Der Tisch mit {balls} Kugeln zur Zeit {time}",

  // Setting up: tables, laws, balls, dragging
  // (end of: Setting up: tables, laws, balls, dragging)

  // Graphs
  // (end of: Graphs)

  // Events
  // (end of: Events)

  // Files, links, downloads
  // (end of: Files, links, downloads)

  // Comparing: time steps and twins
  // (end of: Comparing: time steps and twins)

  // The cue
  // (end of: The cue)

  // The gallery and its lessons
  // (end of: The gallery and its lessons)

  // What the table shows
  // (end of: What the table shows)
};
