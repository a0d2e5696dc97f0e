/** All words of the page, in English. Numbers and names are put in where {braces} are. */
export const en = {
  // The page
  title: "Carom Studio",
  tagline: "How balls move on a table: exact, and the same everywhere",
  language: "Language",
  languageName: "English",
  theme: "Light or dark",
  gallery: "Gallery",
  loading: "Loading the engine …",
  close: "Close",
  cancel: "Cancel",

  // Time
  play: "Play",
  pause: "Pause",
  timeline: "Time",
  speed: "Speed",
  speedOf: "{speed} times as fast as life",
  nextEvent: "Next event",
  previousEvent: "Previous event",
  toStart: "To the start",
  toEnd: "To the end",
  timeOf: "{time} of {end}",
  computing: "Computing: {events} events, time {time}",

  // What is wrong
  problemsTitle: "This is not a scenario yet",
  engineStuck:
    "This takes too long to set up in the page, so it was broken off. The scenario before is still there.",
  engineBroken: "The engine broke down and was started anew. The scenario before is still there.",
  cut: "The page keeps {events} events of a run: this one is shown up to {time}.",

  // The table
  tableLabel: "The table with {balls} balls at time {time}",

  // Setting up: tables, laws, balls, dragging
  // (end of: Setting up: tables, laws, balls, dragging)

  // Graphs
  // (end of: Graphs)

  // Events
  // (end of: Events)

  // Files, links, downloads
  // (end of: Files, links, downloads)

  // Comparing: time steps and twins
  compare: "Compare",
  overlay: "Laid over this run",
  overlayNone: "Nothing",
  overlayStepped: "The same in time steps",
  overlayExact: "The exact run",
  overlayTwin: "A twin with one number nudged",
  timeStep: "Time step Δt",
  nudgedNumber: "The nudged number",
  nudge: "The nudge",
  parted: "The runs part at time {time}: from then on {ball} is more than {apart} from its other self.",
  neverParted: "The runs do not part: no ball is ever more than {apart} from its other self.",
  goThere: "Go there",
  noDifference: "The two runs are the same.",
  differenceTitle: "Largest distance between a ball and its other self, over time",
  thisRun: "This run",
  otherRun: "The other",
  auditEnd: "End time",
  auditContacts: "Collisions",
  auditEnergy: "Energy at the end",
  auditOverlap: "Deepest overlap",
  auditLost: "Time lost",

  // The cue
  // (end of: The cue)

  // The gallery and its lessons
  // (end of: The gallery and its lessons)

  // What the table shows
  // (end of: What the table shows)
};

export type Words = typeof en;
export type Word = keyof Words;
