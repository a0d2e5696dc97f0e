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

  // The run
  run: "Run",
  eventsOfRun: "Events",
  audit: "What the run found out about itself",
  initialEnergy: "Energy at the start",
  finalEnergy: "Energy at the end",
  energyLoss: "Energy that the laws took",
  energyDrift: "Energy that is not accounted for",
  momentumError: "Largest error of momentum in a collision",
  deepestOverlap: "Deepest overlap of two balls",
  clusters: "Collisions of several balls at once",
  corrections: "Corrections made by the engine",
  sameBits: "Digest of the final state",
  noDigest: "none: a number in the final state is not a number",
  madeWith:
    "Carom {version}, physics version {physics}. Wherever this scenario is run, the digest is this one.",
  verifyWith: "On the shell: carom run {name}.",
  sources: "Sources of the laws that acted",
  inSteps: "It was computed in time steps.",
  status_time_limit: "The run came to its full time, {time}.",
  status_collision_limit: "The run ended with its last collision that was asked for, at {time}.",
  status_stopped: "The run was stopped at {time}.",
  status_at_rest: "Everything is at rest from {time} on.",
  status_collapsed: "The run ended at {time}: collisions followed each other without end.",
  status_event_limit: "The run ended at {time}, where its budget of events was used up.",
  status_interrupted: "The run was broken off at {time}.",
  status_miscue: "The tip slipped off the ball at {time}: a miscue.",
};

export type Words = typeof en;
export type Word = keyof Words;
