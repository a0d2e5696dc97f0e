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
  startHere: "Start here",
  startHint: "Press play below the table. Drag the time line to any moment.",
  openTable: "Open the table",
  lessons: "Lessons",
  lessonsLead: "Predict first, then play, and see what happens at each collision.",
  groupCollisions: "Collisions",
  groupCue: "Cue sports",
  groupChaos: "Order and chaos",
  groupGases: "Many balls: gases",
  groupMore: "More tables",
  colophon: "Everything is computed in this page: no server takes part, and nothing leaves this machine.",

  shortcuts: "Keyboard shortcuts",
  keyPlay: "Play or pause",
  keyPrevious: "Previous event",
  keyNext: "Next event",
  keyStart: "To the start",
  keyEnd: "To the end",
  keyHelp: "This list",
  keySpace: "Space",
  keyHome: "Home",
  keyEndKey: "End",
  panels: "Panels",

  lesson: "Lesson",
  partOf: "Lesson · part {part} of {parts}",
  lessonSteps: "Steps of the lesson",
  lessonBack: "Back",
  nextPart: "Next part",
  toSummary: "Summary",
  toGallery: "Back to the gallery",
  lessonSummary: "What to keep",
  lessonPredictions: "Predictions and runs",
  printSheet: "Print the sheet",
  predictFirst: "Predict first",
  lessonPrediction: "Prediction",
  lessonDirection: "Direction",
  drawDirection: "Drag on the table, away from the ball, or type an angle: 0° points right, 90° up.",
  lessonUnlock: "That is my prediction",
  lessonLocked: "Make a prediction to unlock play.",
  lessonTheRun: "The run",
  lessonNotYet: "not there yet",
  lessonNoAnswer: "nothing",
  skipToAnswer: "Skip to the answer",
  wellPredicted: "Well predicted.",
  lessonOtherwise: "It went otherwise.",
  lessonLookAgain: "Go back and forth over that moment to see why.",
  unitCollisions: "collisions",
  unitHits: "hits",
  unitTableWidths: "table widths",
  lessonSoFar: "Collisions so far: {count} of {all}",
  pauseAtEach: "Pause at each collision",
  pauseAtFirst: "Pause at the first {count} collisions",
  lessonGoOn: "Go on",
  collisionOf: "Collision {place}, at time {time}",
  twoMet: "{a} and {b} meet; a push of {impulse} goes from one to the other.",
  cushionHit: "{a} hits the cushion “{cushion}”, which gives it a push of {impulse}.",
  lessonBefore: "Before",
  lessonAfter: "After",
  momentumCaption: "Momentum: mass × velocity",
  velocityCaption: "Velocity",
  allMomentum: "All momentum",
  allEnergy: "All energy",
  ballsKeep: "What one ball loses the other gains: the sum stays.",
  cushionKeeps: "The cushion is fixed to the table, which takes the rest of the momentum.",
  delayCaption: "When each hit comes",
  lessonHit: "Hit",
  lessonExact: "Exact",
  lessonInSteps: "In steps",
  lessonLater: "Later by",
  lessonApartNow: "The two {ball} balls are {distance} apart now.",
  lessonApart: "The two are {distance} apart.",
  timesAsFar: "That is {factor} times as far as at the hit before.",
  chartCaption: "Distance of the two, from hit to hit",
  hitsAxis: "{count} hits",
  sheetName: "Name: ______________________   Date: ______________",
  sheetDraw: "Draw the direction into the picture.",
  sheetPrediction: "My prediction:",
  sheetRun: "What the run gives:",
  sheetExplain: "What happened, and why?",
  sheetWhy: "What do the parts have in common?",

  timestepTitle: "What a time step costs",
  timestepLine: "A computer that looks only every few hundredths of a second sees each hit too late.",
  timestepSummary1:
    "With a fixed time step a ball that hits something loses the rest of its step: every hit comes late.",
  timestepSummary2: "A late hit is a hit somewhere else. The next one is off by more, and paths part.",
  timestepSummary3:
    "A step ten times as fine costs ten times the work, and brings about ten times less error: never none. From event to event there is no step and no such error.",
  timestepPart1: "When do they meet?",
  timestepIntro1:
    "Red runs by way of three cushions into blue. The exact run jumps from hit to hit; the dashed one looks every 0.03 time units, and a ball that hits a cushion stays there until the next look.",
  timestepQuestion1: "When do red and blue meet in the run in steps, beside the exact one?",
  timestepEarlier: "earlier",
  timestepSame: "at the same time",
  timestepLater: "later",
  timestepTakeaway1:
    "Each hit loses the rest of a step, half of one on average. Three cushions and the meeting itself have cost about two steps in all.",
  timestepPart2: "How far apart at the end?",
  timestepIntro2:
    "Blue rests until red arrives. In steps, red arrives late and meets it in a slightly different place.",
  timestepQuestion2:
    "How far apart are the two blue balls after 5 time units? A ball is 0.15 table widths wide.",
  timestepTakeaway2:
    "More than the width of a ball. The other direction after the meeting adds to the time that is lost.",
  timestepPart3: "A finer step",
  timestepIntro3: "Now the step is 0.003, ten times as fine, with ten times the work.",
  timestepQuestion3: "How much nearer is the blue ball to the exact one at the end?",
  timestepNoGain: "hardly nearer",
  timestepTenfold: "about ten times nearer",
  timestepHundredfold: "about a hundred times nearer",
  timestepTakeaway3:
    "About ten times, not exactly: the method is of first order, and where within a step a hit falls is chance.",

  momentumTitle: "Momentum in one and two dimensions",
  momentumLine: "What a ball loses another one gains: along a line, to both sides, and at an angle.",
  momentumSummary1:
    "In a collision of two balls the sum of their momenta stays, in each direction by itself.",
  momentumSummary2:
    "Smooth balls push each other along the line of their centres and in no other direction: a ball that was at rest leaves along it.",
  momentumSummary3: "A cushion changes the momentum of a ball: what is missing went into the table.",
  momentumPart1: "Head-on",
  momentumIntro1:
    "A light ball and a heavy one, three times its mass, run against each other at the same speed.",
  momentumQuestion1: "What does the heavy ball do when they have met?",
  momentumGoesOn: "It goes on, slower.",
  momentumStops: "It stops.",
  momentumTurns: "It turns back.",
  momentumTakeaway1:
    "It stops dead: the light ball takes all of the momentum that is left, and leaves at twice its speed.",
  momentumPart2: "One into two",
  momentumIntro2: "A ball runs exactly between two others that touch each other.",
  momentumQuestion2: "In which direction does the upper ball leave?",
  momentumTakeaway2:
    "At 30°, along the line of centres. The first ball comes back a little: the two take more forward momentum than it had.",
  momentumPart3: "At an angle",
  momentumIntro3: "Red comes off three cushions, then it meets blue, which is at rest.",
  momentumQuestion3: "In which direction does blue leave when red has hit it?",
  momentumTakeaway3:
    "Along the line of centres at the moment of contact, whatever the direction that red came from.",

  piTitle: "Counting π",
  piLine: "Two balls and a cushion know the digits of π. How many collisions will there be?",
  piSummary1:
    "With mass ratios of 1, 100 and 10 000 there are 3, 31 and 314 collisions: the first digits of π.",
  piSummary2:
    "Energy stays, so in a plane of scaled velocities the two move on a circle; each collision turns them by the same angle. They go on until they are half way round.",
  piSummary3: "A hundred times the mass makes the angle ten times smaller: one more digit.",
  piPart1: "Equal masses",
  piIntro1:
    "The ball on the right runs into one at rest, which then runs into the cushion on the left. Both have the same mass. Collisions of the balls and hits on the cushion count alike.",
  piQuestion1: "How many collisions will there be in all?",
  piTakeaway1:
    "Three: ball on ball, ball on cushion, and ball on ball again. The second ball stands still, the first one runs back as it came.",
  piPart2: "A hundred times as heavy",
  piIntro2: "The ball on the right is now a hundred times as heavy.",
  piQuestion2: "How many collisions will there be now?",
  piTakeaway2:
    "31. The light ball runs to and fro between the cushion and the heavy ball, until that one has turned back and is faster.",
  piPart3: "Ten thousand times as heavy",
  piIntro3: "Once more a hundred times as heavy as before.",
  piQuestion3: "How many collisions will there be this time?",
  piTakeaway3: "314. Each factor of a hundred in the mass brings one more digit of π.",

  butterflyTitle: "The butterfly",
  butterflyLine: "Two starts that no eye can tell apart. How long do they stay together?",
  butterflySummary1:
    "On a regular table a small difference grows by the same amount at each hit; on a chaotic one it is multiplied at each hit.",
  butterflySummary2: "To start a thousand times more precisely buys about six more hits, no more.",
  butterflySummary3:
    "Chaos is not chance: the same start always gives the same run. Almost the same start does not.",
  butterflyPart1: "In a circle",
  butterflyIntro1:
    "Two points start at one place, in directions a millionth of a degree apart. The table is a circle.",
  butterflyQuestion1: "How far apart are the two after some 30 hits each?",
  butterflyTogether: "no eye could tell them apart",
  butterflySomewhat: "one can see two points",
  butterflyParted: "they are in different parts of the table",
  butterflyTakeaway1: "Still together: at each hit the difference grows by about the same small amount.",
  butterflyPart2: "In a stadium",
  butterflyIntro2:
    "The same two starts, but the table is a stadium: two half circles and two straight sides.",
  butterflyQuestion2: "After how many hits are the two more than 0.5 apart, a quarter of the table's height?",
  butterflyTakeaway2:
    "From a hundred-millionth to half a length in 17 hits: the difference about triples at each.",
  butterflyPart3: "A thousand times closer",
  butterflyIntro3: "The directions now differ by a thousandth of what they did: a billionth of a degree.",
  butterflyQuestion3: "After how many hits are the two more than 0.5 apart this time?",
  butterflyTakeaway3: "Only six hits more. A thousand is about three to the power of six.",

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
