import type { Words } from "./en";
import type { Description } from "./index";

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
  graphs: "Diagramme",
  graphHint: "ein Klick oder Ziehen im Diagramm führt zu dieser Zeit, ebenso die Zeitleiste",
  graphsWait: "Die Diagramme erscheinen, sobald der Lauf berechnet ist.",
  onlyTotals: "Bei mehr als {most} Kugeln zeigen die Diagramme nur Summen.",
  energy: "Energie",
  kinetic: "kinetisch",
  potential: "potenziell",
  totalOf: "gesamt",
  momentum: "Impuls",
  momentumX: "Impuls in x-Richtung",
  momentumY: "Impuls in y-Richtung",
  momentumVectors: "Impulspfeile",
  momentumSum: "gesamt ({x}; {y}), Betrag {size}",
  speedOfBalls: "Geschwindigkeitsbetrag",
  distance: "Zurückgelegter Weg",
  valuesNow: "Werte jetzt",
  valuesAt: "Werte zur Zeit {time}",
  ball: "Kugel",
  speedShort: "|v|",
  momentumShort: "|p|",
  kineticShort: "kin. Energie",
  onlySomeRows: "Eine Zeile haben die ersten {most} Kugeln und die auf dem Tisch gewählte.",

  // Events
  events: "Ereignisse",
  event: "Ereignis",
  eventIndex: "Nr.",
  timeShort: "Zeit",
  closingSpeed: "Stoßtempo",
  impulse: "Kraftstoß",
  kind: "Art",
  allKinds: "alle",
  allBalls: "alle",
  noEvents: "In diesem Lauf geschieht nichts.",
  eventsShown: "{shown} von {all}",
  kind_ball_ball: "Kugeln stoßen zusammen",
  kind_ball_cushion: "Trifft die Bande",
  kind_hold: "Legt sich an die Bande",
  kind_release: "Löst sich von der Bande",
  kind_cue_ball: "Der Queue stößt",
  kind_miscue: "Der Queue rutscht ab",
  kind_slide_to_roll: "Beginnt zu rollen",
  kind_slide_to_spin: "Ausgeglitten, dreht sich noch",
  kind_slide_to_rest: "Gleitet aus",
  kind_roll_to_spin: "Ausgerollt, dreht sich noch",
  kind_roll_to_rest: "Rollt aus",
  kind_spin_to_rest: "Dreht sich aus",
  kind_ball_cloth: "Setzt auf dem Tuch auf",
  kind_ball_pocket: "Fällt in eine Tasche",
  kind_off_table: "Springt vom Tisch",
  stripHint: "Abspielen oder ein Ereignis wählen, um es vorher, währenddessen und nachher zu sehen.",
  stripLabel: "Das Ereignis vorher, währenddessen und nachher",
  eventAt: "Ereignis {index}: {kind}, Zeit {time}",
  before: "Vorher",
  during: "Beim Stoß",
  atEvent: "Im Augenblick",
  after: "Nachher",
  partsBefore: "Anteile vorher",
  partsAfter: "Anteile nachher",
  partsHint:
    "n ist die Normale des Stoßes, t die Tangente; der rote und der blaue Pfeil sind die Anteile der Geschwindigkeit in diesen Richtungen.",
  normalPart: "Geschwindigkeit entlang n",
  tangentPart: "Geschwindigkeit entlang t",
  changeOf: "Änderung",
  together: "zusammen",

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
  startHere: "Hier anfangen",
  startHint: "Unter dem Tisch auf Abspielen drücken. Die Zeitleiste lässt sich an jeden Moment ziehen.",
  openTable: "Tisch öffnen",
  lessons: "Lektionen",
  lessonsLead: "Erst vorhersagen, dann abspielen und bei jedem Stoß sehen, was geschieht.",
  groupCollisions: "Stöße",
  groupCue: "Billard",
  groupChaos: "Ordnung und Chaos",
  groupGases: "Viele Kugeln: Gase",
  groupMore: "Weitere Tische",
  colophon:
    "Alles wird in dieser Seite gerechnet: kein Server ist beteiligt, und nichts verlässt dieses Gerät.",

  shortcuts: "Tastenkürzel",
  keyPlay: "Abspielen oder anhalten",
  keyPrevious: "Voriges Ereignis",
  keyNext: "Nächstes Ereignis",
  keyStart: "Zum Anfang",
  keyEnd: "Zum Ende",
  keyHelp: "Diese Liste",
  keySpace: "Leertaste",
  keyHome: "Pos 1",
  keyEndKey: "Ende",
  panels: "Bereiche",

  lesson: "Lektion",
  partOf: "Lektion · Teil {part} von {parts}",
  lessonSteps: "Schritte der Lektion",
  lessonBack: "Zurück",
  nextPart: "Nächster Teil",
  toSummary: "Zusammenfassung",
  toGallery: "Zurück zur Galerie",
  lessonSummary: "Was bleibt",
  lessonPredictions: "Vorhersagen und Läufe",
  printSheet: "Arbeitsblatt drucken",
  predictFirst: "Erst vorhersagen",
  lessonPrediction: "Vorhersage",
  lessonDirection: "Richtung",
  drawDirection:
    "Auf dem Tisch von der Kugel weg ziehen oder einen Winkel eingeben: 0° zeigt nach rechts, 90° nach oben.",
  lessonUnlock: "Das ist meine Vorhersage",
  lessonLocked: "Eine Vorhersage gibt das Abspielen frei.",
  lessonTheRun: "Der Lauf",
  lessonNotYet: "noch nicht so weit",
  lessonNoAnswer: "nichts",
  skipToAnswer: "Zur Antwort springen",
  wellPredicted: "Gut vorhergesagt.",
  lessonOtherwise: "Es kam anders.",
  lessonLookAgain: "Um diesen Moment herum vor- und zurückgehen, um zu sehen, warum.",
  unitCollisions: "Stöße",
  unitHits: "Banden",
  unitTableWidths: "Tischbreiten",
  lessonSoFar: "Stöße bisher: {count} von {all}",
  pauseAtEach: "Bei jedem Stoß anhalten",
  pauseAtFirst: "Bei den ersten {count} Stößen anhalten",
  lessonGoOn: "Weiter",
  collisionOf: "Stoß {place} zur Zeit {time}",
  twoMet: "{a} und {b} treffen sich; ein Kraftstoß von {impulse} geht von der einen auf die andere über.",
  cushionHit: "{a} trifft die Bande „{cushion}“ und bekommt von ihr einen Kraftstoß von {impulse}.",
  lessonBefore: "Vorher",
  lessonAfter: "Nachher",
  momentumCaption: "Impuls: Masse × Geschwindigkeit",
  velocityCaption: "Geschwindigkeit",
  allMomentum: "Impuls aller",
  allEnergy: "Energie aller",
  ballsKeep: "Was die eine Kugel verliert, gewinnt die andere: Die Summe bleibt.",
  cushionKeeps: "Die Bande ist am Tisch fest, und der nimmt den Rest des Impulses auf.",
  delayCaption: "Wann jeder Stoß kommt",
  lessonHit: "Stoß",
  lessonExact: "Exakt",
  lessonInSteps: "In Schritten",
  lessonLater: "Später um",
  lessonApartNow: "Die beiden Kugeln „{ball}“ sind jetzt {distance} voneinander entfernt.",
  lessonApart: "Die beiden sind {distance} voneinander entfernt.",
  timesAsFar: "Das ist {factor}-mal so weit wie bei der Bande davor.",
  chartCaption: "Abstand der beiden von Bande zu Bande",
  hitsAxis: "{count} Banden",
  sheetName: "Name: ______________________   Datum: ______________",
  sheetDraw: "Die Richtung in das Bild einzeichnen.",
  sheetPrediction: "Meine Vorhersage:",
  sheetRun: "Was der Lauf ergibt:",
  sheetExplain: "Was ist geschehen, und warum?",
  sheetWhy: "Was haben die Teile gemeinsam?",

  timestepTitle: "Was ein Zeitschritt kostet",
  timestepLine: "Ein Rechner, der nur alle paar Hundertstel hinsieht, bemerkt jeden Stoß zu spät.",
  timestepSummary1:
    "Bei festem Zeitschritt verliert eine Kugel, die anstößt, den Rest ihres Schrittes: Jeder Stoß kommt zu spät.",
  timestepSummary2:
    "Ein später Stoß ist ein Stoß an anderer Stelle. Der nächste liegt noch weiter daneben, und die Wege trennen sich.",
  timestepSummary3:
    "Ein zehnmal so feiner Schritt kostet zehnmal so viel Arbeit und macht den Fehler etwa zehnmal kleiner, aber nie zu null. Von Ereignis zu Ereignis gibt es keinen Schritt und keinen solchen Fehler.",
  timestepPart1: "Wann treffen sie sich?",
  timestepIntro1:
    "Rot läuft über drei Banden auf Blau. Der exakte Lauf springt von Stoß zu Stoß; der gestrichelte sieht alle 0,03 Zeiteinheiten hin, und eine Kugel, die eine Bande trifft, bleibt bis zum nächsten Hinsehen dort.",
  timestepQuestion1: "Wann treffen sich Rot und Blau im Lauf in Schritten, verglichen mit dem exakten?",
  timestepEarlier: "früher",
  timestepSame: "zur gleichen Zeit",
  timestepLater: "später",
  timestepTakeaway1:
    "Jeder Stoß verliert den Rest eines Schrittes, im Mittel einen halben. Drei Banden und das Treffen selbst haben zusammen etwa zwei Schritte gekostet.",
  timestepPart2: "Wie weit auseinander am Ende?",
  timestepIntro2:
    "Blau ruht, bis Rot ankommt. In Schritten kommt Rot zu spät und trifft an etwas anderer Stelle.",
  timestepQuestion2:
    "Wie weit sind die beiden blauen Kugeln nach 5 Zeiteinheiten voneinander entfernt? Eine Kugel ist 0,15 Tischbreiten breit.",
  timestepTakeaway2:
    "Mehr als eine Kugelbreite. Zur verlorenen Zeit kommt die andere Richtung nach dem Treffen.",
  timestepPart3: "Ein feinerer Schritt",
  timestepIntro3: "Nun ist der Schritt 0,003: zehnmal so fein, mit zehnmal so viel Arbeit.",
  timestepQuestion3: "Wie viel näher ist die blaue Kugel am Ende der exakten?",
  timestepNoGain: "kaum näher",
  timestepTenfold: "etwa zehnmal näher",
  timestepHundredfold: "etwa hundertmal näher",
  timestepTakeaway3:
    "Etwa zehnmal, nicht genau: Das Verfahren ist von erster Ordnung, und wo innerhalb eines Schrittes ein Stoß liegt, ist Zufall.",

  momentumTitle: "Impuls in einer und zwei Dimensionen",
  momentumLine:
    "Was eine Kugel verliert, gewinnt eine andere: auf einer Linie, nach beiden Seiten und schräg.",
  momentumSummary1: "Beim Stoß zweier Kugeln bleibt die Summe ihrer Impulse, in jeder Richtung für sich.",
  momentumSummary2:
    "Glatte Kugeln drücken einander längs der Verbindungslinie ihrer Mittelpunkte und in keine andere Richtung: Eine Kugel, die ruhte, läuft auf ihr davon.",
  momentumSummary3: "Eine Bande ändert den Impuls einer Kugel: Was fehlt, ging in den Tisch.",
  momentumPart1: "Frontal",
  momentumIntro1:
    "Eine leichte und eine schwere Kugel von dreifacher Masse laufen gleich schnell aufeinander zu.",
  momentumQuestion1: "Was tut die schwere Kugel, nachdem sie sich getroffen haben?",
  momentumGoesOn: "Sie läuft weiter, langsamer.",
  momentumStops: "Sie bleibt stehen.",
  momentumTurns: "Sie kehrt um.",
  momentumTakeaway1:
    "Sie bleibt stehen: Die leichte nimmt allen Impuls mit, der übrig ist, und läuft doppelt so schnell davon, wie sie kam.",
  momentumPart2: "Eine auf zwei",
  momentumIntro2: "Eine Kugel läuft genau zwischen zwei andere, die einander berühren.",
  momentumQuestion2: "In welche Richtung läuft die obere Kugel davon?",
  momentumTakeaway2:
    "Unter 30°, längs der Verbindungslinie der Mittelpunkte. Die erste kommt ein wenig zurück: Die beiden nehmen mehr Impuls nach vorn mit, als sie hatte.",
  momentumPart3: "Schräg",
  momentumIntro3: "Rot kommt über drei Banden und trifft dann Blau, das ruht.",
  momentumQuestion3: "In welche Richtung läuft Blau davon, wenn Rot getroffen hat?",
  momentumTakeaway3: "Längs der Verbindungslinie der Mittelpunkte bei der Berührung, gleich woher Rot kam.",

  piTitle: "π abzählen",
  piLine: "Zwei Kugeln und eine Bande kennen die Ziffern von π. Wie viele Stöße werden es?",
  piSummary1:
    "Bei Massenverhältnissen von 1, 100 und 10 000 sind es 3, 31 und 314 Stöße: die ersten Ziffern von π.",
  piSummary2:
    "Die Energie bleibt, also bewegen sich die beiden in einer Ebene skalierter Geschwindigkeiten auf einem Kreis; jeder Stoß dreht sie um denselben Winkel. Es geht weiter, bis der halbe Kreis durchlaufen ist.",
  piSummary3: "Hundertfache Masse macht den Winkel zehnmal kleiner: eine Ziffer mehr.",
  piPart1: "Gleiche Massen",
  piIntro1:
    "Die rechte Kugel läuft auf eine ruhende, die dann auf die linke Bande läuft. Beide haben die gleiche Masse. Stöße der Kugeln und Banden zählen gleich.",
  piQuestion1: "Wie viele Stöße werden es insgesamt?",
  piTakeaway1:
    "Drei: Kugel auf Kugel, Kugel auf Bande und noch einmal Kugel auf Kugel. Die zweite steht still, die erste läuft zurück, wie sie kam.",
  piPart2: "Hundertmal so schwer",
  piIntro2: "Die rechte Kugel ist nun hundertmal so schwer.",
  piQuestion2: "Wie viele Stöße werden es jetzt?",
  piTakeaway2:
    "31. Die leichte Kugel läuft zwischen Bande und schwerer Kugel hin und her, bis diese umgekehrt und schneller ist.",
  piPart3: "Zehntausendmal so schwer",
  piIntro3: "Noch einmal hundertmal so schwer wie zuvor.",
  piQuestion3: "Wie viele Stöße werden es diesmal?",
  piTakeaway3: "314. Jeder Faktor hundert in der Masse bringt eine weitere Ziffer von π.",

  butterflyTitle: "Der Schmetterling",
  butterflyLine: "Zwei Starts, die kein Auge unterscheidet. Wie lange bleiben sie zusammen?",
  butterflySummary1:
    "Auf einem regelmäßigen Tisch wächst ein kleiner Unterschied mit jeder Bande um den gleichen Betrag; auf einem chaotischen wird er mit jeder Bande vervielfacht.",
  butterflySummary2: "Tausendmal genauer zu starten bringt etwa sechs Banden mehr, nicht mehr.",
  butterflySummary3:
    "Chaos ist kein Zufall: Der gleiche Start gibt immer den gleichen Lauf. Fast der gleiche Start nicht.",
  butterflyPart1: "Im Kreis",
  butterflyIntro1:
    "Zwei Punkte starten am selben Ort, in Richtungen, die sich um ein Millionstel Grad unterscheiden. Der Tisch ist ein Kreis.",
  butterflyQuestion1: "Wie weit sind die beiden nach je etwa 30 Banden voneinander entfernt?",
  butterflyTogether: "kein Auge kann sie unterscheiden",
  butterflySomewhat: "man sieht zwei Punkte",
  butterflyParted: "sie sind an verschiedenen Enden des Tisches",
  butterflyTakeaway1:
    "Noch immer zusammen: Mit jeder Bande wächst der Unterschied um etwa den gleichen kleinen Betrag.",
  butterflyPart2: "Im Stadion",
  butterflyIntro2:
    "Die gleichen beiden Starts, aber der Tisch ist ein Stadion: zwei Halbkreise und zwei gerade Seiten.",
  butterflyQuestion2:
    "Nach wie vielen Banden sind die beiden mehr als 0,5 voneinander entfernt, ein Viertel der Tischhöhe?",
  butterflyTakeaway2:
    "Von einem Hundertmillionstel auf eine halbe Länge in 17 Banden: Der Unterschied verdreifacht sich etwa bei jeder.",
  butterflyPart3: "Tausendmal näher",
  butterflyIntro3: "Die Richtungen unterscheiden sich nun um ein Tausendstel davon: ein Milliardstel Grad.",
  butterflyQuestion3: "Nach wie vielen Banden sind die beiden diesmal mehr als 0,5 voneinander entfernt?",
  butterflyTakeaway3: "Nur sechs Banden später. Tausend ist etwa drei hoch sechs.",

  // What the table shows
  shown: "Auf dem Tisch gezeigt",
  showArrows: "Geschwindigkeiten",
  showTrails: "Bahnen",
  showContacts: "Stöße",
  showSpin: "Drall",
  showIds: "Namen",
  key: "Legende",
  keyArrow: "Die Geschwindigkeit: je länger, desto schneller",
  keyContact: "Hier trafen sich Kugeln; die jüngsten Zeichen sind am deutlichsten",
  keyBounce: "Hier traf eine Kugel die Bande",
  keyRoll:
    "Wohin der Drall die Kugel treibt: entlang der Geschwindigkeit, wenn sie rollt, weiter bei Nachlauf, zurück bei Rücklauf",
  keyTurn: "Seitendrall: wie sie sich von oben gesehen dreht",
  keyLanding: "Hier setzte eine Kugel auf dem Tuch auf",
  outOfPlay: "Aus dem Spiel:",

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

  // A recorded run, played by itself
  recordedRun: "Ein aufgezeichneter Lauf",
};

/** Title and a sentence for each ready-made scenario, by its name. */
export const scenarios: Record<string, Description> = {
  circle: {
    title: "Eine Kugel im Kreis",
    line: "Der Einfallswinkel ist bei jeder Bande gleich: Alle Sehnen berühren einen inneren Kreis.",
  },
  counting_pi: {
    title: "π abzählen",
    line: "Eine schwere Kugel treibt eine leichte gegen die Bande; die Zahl der Stöße zeigt Ziffern von π.",
  },
  damped_drop: {
    title: "Eine fallende Kugel",
    line: "Die Kugel kehrt jedes Mal auf das 0,64-Fache der Höhe zurück: unendlich viele Sprünge in endlicher Zeit.",
  },
  eight_ball_break: {
    title: "Eight-Ball: der Anstoß",
    line: "Ein harter Anstoß auf fünfzehn Kugeln, die ein Tausendstel Durchmesser voneinander trennt.",
  },
  equal_speeds: {
    title: "Fünfzig gleich schnelle Scheiben",
    line: "Nach wenigen Stößen sind die Geschwindigkeiten verteilt, wie Maxwells Gesetz es sagt.",
  },
  fifty_random: {
    title: "Fünfzig Kugeln",
    line: "Ungleich große Kugeln gleicher Dichte: Nach einer Weile haben im Mittel alle die gleiche Energie.",
  },
  gas: {
    title: "Fünfzig Scheiben in einem Kasten ohne Wände",
    line: "Was auf einer Seite hinausläuft, kommt auf der anderen herein: Scheiben treffen nur Scheiben.",
  },
  head_on_unequal: {
    title: "Frontal: leicht gegen schwer",
    line: "Gleich schnell aufeinander zu: Die schwere bleibt stehen, die leichte läuft doppelt so schnell davon.",
  },
  jump_shot: {
    title: "Ein Sprungstoß",
    line: "Das Queue stößt steil herab: Die weiße Kugel springt über die Acht und trifft die Eins.",
  },
  l_shape: {
    title: "Ein L-förmiger Tisch",
    line: "Die Ecke in der Mitte ragt in den Tisch und wird wie ein Pfosten getroffen.",
  },
  masse: {
    title: "Ein Massé",
    line: "Das steil gehaltene Queue stößt links der Mitte: Die Kugel läuft im Bogen um die Acht.",
  },
  midterm: {
    title: "Zwei Kugeln auf einem Tisch L × 2L",
    line: "Die klassische Aufgabe eines ersten Programmierkurses: Rot läuft auf Blau, und jede Bande dämpft die Geschwindigkeit mit 0,8.",
  },
  midterm_stepped: {
    title: "Dieselben zwei Kugeln, in Zeitschritten",
    line: "Tisch und Kugeln der Aufgabe, mit dem festen Zeitschritt der Kursaufgabe gerechnet.",
  },
  mushroom: {
    title: "Der Pilz",
    line: "Eine halbe Scheibe auf einem Stiel: regelmäßige und chaotische Bewegung, die sich nie mischen.",
  },
  newtons_cradle: {
    title: "Newtons Wiege auf einem Tisch",
    line: "Eine Kugel läuft auf fünf, die sich berühren: Nur die letzte läuft davon.",
  },
  nine_ball_break: {
    title: "Nine-Ball: der Anstoß",
    line: "Ein harter Anstoß auf neun Kugeln, etwas rechts der Mitte: Die Neun fällt.",
  },
  one_into_two: {
    title: "Eine auf zwei",
    line: "Eine Kugel trifft genau zwischen zwei, die einander berühren: Die Antwort ist symmetrisch.",
  },
  pinball: {
    title: "Flipper",
    line: "Kugeln fallen durch Pfeiler, einen Keil und eine schräge Wand, jede Bande mit eigenem Gesetz.",
  },
  sinai: {
    title: "Das Sinai-Billard",
    line: "Ein Punkt im Quadrat mit einer Scheibe in der Mitte, die benachbarte Wege auseinandertreibt.",
  },
  snooker_break: {
    title: "Snooker: ein sicherer Anstoß",
    line: "Die übliche Eröffnung: mit rechtem Effet dünn an die letzte Rote und über Banden zurück.",
  },
  stadium: {
    title: "Zwei Punkte im Stadion",
    line: "Zwei Starts, ein Millionstel Grad auseinander: Ihr Abstand verdreifacht sich etwa mit jeder Bande.",
  },
  three_cushion: {
    title: "Dreiband: ein Standardstoß",
    line: "Weiß trifft mit linkem Effet Rot und läuft über drei Banden zu Gelb.",
  },
  tilted: {
    title: "Ein geneigter Tisch",
    line: "Die Kugel hüpft an den Banden in immer kleineren Sprüngen und kommt in der Ecke zur Ruhe.",
  },
  triangle_break: {
    title: "Der Anstoß",
    line: "Fünfzehn Kugeln in dichtem Dreieck, genau frontal getroffen, ohne Reibung.",
  },
  two_ball_shot: {
    title: "Der Stoß mit zwei Kugeln von pooltool",
    line: "Das Beispiel aus pooltools Handbuch: Die Eins fällt oben rechts, die Weiße oben links.",
  },
  u_divider: {
    title: "Ein U-förmiger Tisch",
    line: "Eine dünne Wand teilt den Tisch; der Weg hinüber führt um ihr Ende herum.",
  },
};
