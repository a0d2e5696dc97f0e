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
  compare: "Vergleichen",
  overlay: "Über diesen Lauf gelegt",
  overlayNone: "Nichts",
  overlayStepped: "Dasselbe in Zeitschritten",
  overlayExact: "Der exakte Lauf",
  overlayTwin: "Ein Zwilling mit einer leicht geänderten Zahl",
  timeStep: "Zeitschritt Δt",
  nudgedNumber: "Die geänderte Zahl",
  nudge: "Die Änderung",
  parted:
    "Die Läufe trennen sich zur Zeit {time}: Von da an ist {ball} mehr als {apart} vom anderen Selbst entfernt.",
  neverParted:
    "Die Läufe trennen sich nicht: Keine Kugel ist je mehr als {apart} von ihrem anderen Selbst entfernt.",
  goThere: "Dorthin",
  noDifference: "Die beiden Läufe sind gleich.",
  differenceTitle: "Größter Abstand zwischen einer Kugel und ihrem anderen Selbst über der Zeit",
  thisRun: "Dieser Lauf",
  otherRun: "Der andere",
  auditEnd: "Endzeit",
  auditContacts: "Stöße",
  auditEnergy: "Energie am Ende",
  auditOverlap: "Tiefste Überlappung",
  auditLost: "Verlorene Zeit",

  // The cue
  // (end of: The cue)

  // The gallery and its lessons
  // (end of: The gallery and its lessons)

  // What the table shows
  // (end of: What the table shows)

  // The run
  run: "Lauf",
  eventsOfRun: "Ereignisse",
  audit: "Was der Lauf über sich selbst herausfand",
  initialEnergy: "Energie am Anfang",
  finalEnergy: "Energie am Ende",
  energyLoss: "Energie, die die Gesetze nahmen",
  energyDrift: "Energie ohne Nachweis",
  momentumError: "Größter Impulsfehler bei einem Stoß",
  deepestOverlap: "Tiefste Überlappung zweier Kugeln",
  clusters: "Stöße mehrerer Kugeln zugleich",
  corrections: "Korrekturen durch den Rechenkern",
  sameBits: "Prüfsumme des Endzustands",
  noDigest: "keine: Eine Zahl im Endzustand ist keine Zahl",
  madeWith:
    "Carom {version}, Physikversion {physics}. Wo immer dieses Szenario läuft, ist die Prüfsumme diese.",
  verifyWith: "In der Kommandozeile: carom run {name}.",
  sources: "Quellen der Gesetze, die wirkten",
  inSteps: "Er wurde in Zeitschritten berechnet.",
  status_time_limit: "Der Lauf kam bis zu seiner vollen Zeit, {time}.",
  status_collision_limit: "Der Lauf endete mit dem letzten verlangten Stoß, bei {time}.",
  status_stopped: "Der Lauf wurde bei {time} angehalten.",
  status_at_rest: "Ab {time} ruht alles.",
  status_collapsed: "Der Lauf endete bei {time}: Stöße folgten einander ohne Ende.",
  status_event_limit: "Der Lauf endete bei {time}, wo sein Vorrat an Ereignissen verbraucht war.",
  status_interrupted: "Der Lauf wurde bei {time} abgebrochen.",
  status_miscue: "Die Pomeranze rutschte bei {time} ab: ein Fehlstoß.",
};
