//! What is kept of a run of an ensemble, as columns of numbers.

use super::ways::Ways;
use crate::flight::Motion;
use crate::observe::{NAMES, Observables, Request, Results};
use crate::run::{Diagnostics, Dynamics, Event, Kind, Observer};
use crate::scenario::schema::{Ball, Method};
use crate::scenario::{Key, Problem, Scenario, ScenarioError, Step, parse, suggestion};
use crate::simulate::{ObservedError, ObservedRun, Plan};

/// Something about a run: one column, or one for each ball and component.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// When it ended.
    EndTime,
    /// How many events there were of each kind that can happen.
    Events,
    /// When the first event was; none: not a number.
    FirstEvent,
    /// When the last event was; none: not a number.
    LastEvent,
    /// Where each ball was at the end; not a number for those out of play.
    FinalPosition,
    /// With what velocity.
    FinalVelocity,
    /// With what spin; on a cloth only.
    FinalSpin,
    /// In which pocket each ball is; on a cloth only.
    Pockets,
    /// How long the way of each ball was.
    Distance,
    /// How near the centres of two balls, by their names, came to each other while both were in play.
    ClosestApproach([String; 2]),
    /// What an observable found of a gas: its numbers, each with its standard error.
    Observed(&'static str),
}

/// What the numbers of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// A measured quantity.
    Quantity,
    /// A whole number.
    Count,
    /// The place of a pocket among those of the table; below zero: in none.
    Pocket,
}

/// A column of the table of an ensemble.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Its name, such as "red.x" or "events.ball_ball".
    pub name: String,
    /// What its numbers are.
    pub meaning: Meaning,
}

/// The columns of some outcomes, and how to fill a row of them.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    outcomes: Vec<Outcome>,
    /// What is observed, in the order of the outcomes.
    pub(super) observed: Vec<Request>,
    /// For each of these the names of its numbers.
    quantities: Vec<Vec<&'static str>>,
    /// The pairs whose closest approach is asked for, in the order of the outcomes.
    pub(super) pairs: Vec<[usize; 2]>,
    pub(super) columns: Vec<Column>,
    kinds: Vec<Kind>,
    /// Pockets are numbered after so many cushions.
    cushions: f64,
    is_on_cloth: bool,
}

/// What is kept of a run while it goes on.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    first_event: f64,
    last_event: f64,
    /// Of each ball, the number of the pocket that it dropped into.
    pockets: Vec<f64>,
    /// The ways of the balls, where an outcome needs them.
    ways: Option<Ways>,
    /// What was observed.
    pub(super) results: Vec<Results>,
    /// At the end, the length of each ball's way.
    lengths: Vec<f64>,
    /// At the end, of each ball: how it moves where there is a cloth, place, velocity, spin.
    numbers: Vec<f64>,
}

impl Outcome {
    /// Every outcome but those of pairs and those that are observed.
    pub const ALL: [Self; 9] = [
        Self::EndTime,
        Self::Events,
        Self::FirstEvent,
        Self::LastEvent,
        Self::FinalPosition,
        Self::FinalVelocity,
        Self::FinalSpin,
        Self::Pockets,
        Self::Distance,
    ];

    /// The word used on the shell and in Python; that of a pair is followed by the names of both balls, as in a path.
    pub fn name(&self) -> &'static str {
        match self {
            Self::EndTime => "end_time",
            Self::Events => "events",
            Self::FirstEvent => "first_event",
            Self::LastEvent => "last_event",
            Self::FinalPosition => "final_position",
            Self::FinalVelocity => "final_velocity",
            Self::FinalSpin => "final_spin",
            Self::Pockets => "pockets",
            Self::Distance => "distance",
            Self::ClosestApproach(_) => "closest_approach",
            Self::Observed(name) => name,
        }
    }

    /// The outcome of that name; "closest_approach.red.blue" is one of a pair.
    pub fn from_name(name: &str) -> Option<Self> {
        let simple = Self::ALL.into_iter().find(|outcome| outcome.name() == name);
        let observed = || NAMES.into_iter().find(|known| *known == name).map(Self::Observed);
        simple.or_else(observed).or_else(|| match &parse(name).ok()?[..] {
            [Step::Key(word), Step::Key(a), Step::Key(b)] if word == "closest_approach" => {
                Some(Self::ClosestApproach([a.clone(), b.clone()]))
            }
            _ => None,
        })
    }

    fn request(&self) -> Option<Request> {
        if let Self::Observed(name) = self { Some(Request::new(name)) } else { None }
    }

    fn needs_cloth(&self) -> bool {
        matches!(self, Self::FinalSpin | Self::Pockets)
    }

    /// Whether a run has to be followed event by event for it, which an observed one is not.
    fn needs_course(&self) -> bool {
        self.needs_ways() || matches!(self, Self::FirstEvent | Self::LastEvent)
    }

    fn needs_ways(&self) -> bool {
        matches!(self, Self::Distance | Self::ClosestApproach(_))
    }
}

impl Layout {
    /// The columns of these outcomes of a scenario, whose system has so many cushions.
    pub(super) fn new(
        scenario: &Scenario,
        outcomes: &[Outcome],
        cushions: u32,
    ) -> Result<Self, ScenarioError> {
        let (scenario, is_on_cloth) = (scenario.expanded(), scenario.has_cloth());
        if let Some(outcome) = outcomes.iter().find(|outcome| outcome.needs_cloth() && !is_on_cloth) {
            let message = format!("{}: is for balls on a cloth, and these are discs", outcome.name());
            return Err(Problem::new("outcomes", message).into());
        }
        if let Some(outcome) = outcomes.iter().find(|outcome| outcome.needs_ways())
            && scenario.method != Method::Exact
        {
            let message = format!("{}: the stepped method has no flights; use the exact one", outcome.name());
            return Err(Problem::new("outcomes", message).into());
        }
        let kinds: Vec<Kind> = Kind::ALL.into_iter().filter(|kind| kind.happens(is_on_cloth)).collect();
        let axes: &[&str] = if is_on_cloth { &["x", "y", "z"] } else { &["x", "y"] };
        let vector = |prefix: &str| axes.iter().map(|axis| format!("{prefix}{axis}")).collect::<Vec<_>>();
        let of_balls = |suffixes: &[String]| -> Vec<String> {
            let of_ball =
                |ball: &Ball| suffixes.iter().map(|suffix| format!("{}.{suffix}", ball.id)).collect();
            scenario.balls.iter().flat_map::<Vec<String>, _>(of_ball).collect()
        };
        let observed: Vec<Request> = outcomes.iter().filter_map(Outcome::request).collect();
        let quantities =
            if observed.is_empty() { Vec::new() } else { quantities_of(&scenario, outcomes, &observed)? };
        let mut numbers = quantities.iter();
        let (mut columns, mut pairs) = (Vec::new(), Vec::new());
        for outcome in outcomes {
            let (names, meaning) = match outcome {
                Outcome::EndTime | Outcome::FirstEvent | Outcome::LastEvent => {
                    (vec![outcome.name().into()], Meaning::Quantity)
                }
                Outcome::Events => {
                    let name = |kind: &Kind| format!("events.{}", kind.name());
                    (kinds.iter().map(name).collect(), Meaning::Count)
                }
                Outcome::FinalPosition => (of_balls(&vector("")), Meaning::Quantity),
                Outcome::FinalVelocity => (of_balls(&vector("v")), Meaning::Quantity),
                Outcome::FinalSpin => (of_balls(&vector("w")), Meaning::Quantity),
                Outcome::Pockets => (of_balls(&["pocket".into()]), Meaning::Pocket),
                Outcome::Distance => (of_balls(&["distance".into()]), Meaning::Quantity),
                Outcome::ClosestApproach(balls) => {
                    pairs.push(pair_of(&scenario, balls)?);
                    let [a, b] = balls;
                    (vec![format!("closest_approach.{}.{}", Key(a), Key(b))], Meaning::Quantity)
                }
                Outcome::Observed(name) => {
                    let both = |number: &&str| [format!("{name}.{number}"), format!("{name}.{number}.error")];
                    (numbers.next().into_iter().flatten().flat_map(both).collect(), Meaning::Quantity)
                }
            };
            columns.extend(names.into_iter().map(|name| Column { name, meaning }));
        }
        Ok(Self {
            outcomes: outcomes.to_vec(),
            observed,
            quantities,
            pairs,
            columns,
            kinds,
            cushions: f64::from(cushions),
            is_on_cloth,
        })
    }

    /// Fills a row with what is known at the end of a run.
    pub(super) fn fill(&self, out: &mut [f64], end_time: f64, diagnostics: &Diagnostics, kept: &Kept) {
        let mut out = out.iter_mut();
        let mut put = |number: f64| {
            if let Some(place) = out.next() {
                *place = number;
            }
        };
        let mut pair = 0..;
        let mut observed = self.quantities.iter().zip(&kept.results);
        for outcome in &self.outcomes {
            match outcome {
                Outcome::EndTime => put(end_time),
                Outcome::Events => {
                    self.kinds.iter().for_each(|kind| put(diagnostics.events[*kind as usize] as f64));
                }
                Outcome::FirstEvent => put(kept.first_event),
                Outcome::LastEvent => put(kept.last_event),
                Outcome::FinalPosition => self.vectors(0, kept, &mut put),
                Outcome::FinalVelocity => self.vectors(1, kept, &mut put),
                Outcome::FinalSpin => self.vectors(2, kept, &mut put),
                Outcome::Pockets => {
                    kept.pockets.iter().for_each(|pocket| put((pocket - self.cushions).max(-1.0)));
                }
                Outcome::Distance => kept.lengths.iter().for_each(|length| put(*length)),
                Outcome::ClosestApproach(_) => {
                    let nearest = |ways: &Ways| pair.next().map_or(f64::NAN, |pair| ways.nearest(pair));
                    put(kept.ways.as_ref().map_or(f64::NAN, nearest));
                }
                Outcome::Observed(_) => {
                    if let Some((names, results)) = observed.next() {
                        for quantity in names.iter().map(|name| results.quantity(name)) {
                            put(quantity.and_then(|quantity| quantity.value).unwrap_or(f64::NAN));
                            put(quantity.and_then(|quantity| quantity.error).unwrap_or(f64::NAN));
                        }
                    }
                }
            }
        }
    }

    /// What has to be kept for these outcomes.
    pub(super) fn kept(&self) -> Kept {
        let needs_ways = self.outcomes.iter().any(Outcome::needs_ways);
        Kept {
            first_event: f64::NAN,
            last_event: f64::NAN,
            pockets: Vec::new(),
            ways: needs_ways.then(Ways::default),
            results: Vec::new(),
            lengths: Vec::new(),
            numbers: Vec::new(),
        }
    }

    /// The vectors of all balls that come at this place among those of a state.
    fn vectors(&self, place: usize, kept: &Kept, put: &mut impl FnMut(f64)) {
        if self.is_on_cloth {
            for ball in kept.numbers.chunks_exact(10) {
                let is_out = Motion::ALL.get(ball[0] as usize).is_some_and(|motion| motion.is_out());
                let vector = &ball[1 + 3 * place..4 + 3 * place];
                vector.iter().for_each(|&number| put(if is_out { f64::NAN } else { number }));
            }
        } else {
            for ball in kept.numbers.chunks_exact(4) {
                ball[2 * place..2 * place + 2].iter().for_each(|&number| put(number));
            }
        }
    }
}

impl Kept {
    /// Nothing again, of so many balls, of which these pairs are watched.
    pub(super) fn clear(&mut self, balls: usize, pairs: &[[usize; 2]]) {
        (self.first_event, self.last_event) = (f64::NAN, f64::NAN);
        self.pockets.clear();
        self.pockets.resize(balls, f64::NEG_INFINITY);
        if let Some(ways) = &mut self.ways {
            ways.clear(balls, pairs);
        }
    }

    /// Keeps the states at the end.
    pub(super) fn keep_end<D: Dynamics<f64>>(&mut self, time: f64, states: impl Iterator<Item = D::State>) {
        self.numbers.clear();
        for state in states {
            self.numbers.extend(D::numbers(&state));
        }
        if let Some(ways) = &mut self.ways {
            ways.end_all(time);
            self.lengths.clear();
            self.lengths.extend_from_slice(ways.lengths());
        }
    }

    /// Puts the balls, whose names are `own`, into the order of `ids`; of one that is not there nothing is known.
    pub(super) fn reorder(&mut self, own: &[String], ids: &[String]) {
        if own == ids {
            return;
        }
        let width = self.numbers.len() / own.len().max(1);
        let (mut numbers, mut pockets, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        for id in ids {
            let place = own.iter().position(|own| own == id);
            match place {
                Some(place) => numbers.extend(&self.numbers[place * width..(place + 1) * width]),
                None => numbers.resize(numbers.len() + width, f64::NAN),
            }
            pockets.push(place.map_or(f64::NEG_INFINITY, |place| self.pockets[place]));
            lengths.push(place.and_then(|place| self.lengths.get(place)).copied().unwrap_or(f64::NAN));
        }
        (self.numbers, self.pockets, self.lengths) = (numbers, pockets, lengths);
    }

    /// Takes in what happened.
    pub(super) fn note(&mut self, event: &Event<f64>) {
        if self.first_event.is_nan() {
            self.first_event = event.time;
        }
        self.last_event = event.time;
        if let (Kind::BallPocket, Some(pocket)) = (event.kind, event.cushion) {
            self.pockets[event.ball_a as usize] = f64::from(pocket);
        }
    }
}

/// The names of the numbers that some observables give of a gas, which one look at its start tells.
fn quantities_of(
    scenario: &Scenario,
    outcomes: &[Outcome],
    requests: &[Request],
) -> Result<Vec<Vec<&'static str>>, ScenarioError> {
    let problem = |message: String| ScenarioError::from(Problem::new("outcomes", message));
    if let Some(outcome) = outcomes.iter().find(|outcome| outcome.needs_course()) {
        let message =
            format!("{}: goes with nothing that is observed, such as {}", outcome.name(), requests[0].name);
        return Err(problem(message));
    }
    let look = || -> Result<Vec<Results>, ObservedError> {
        let mut observables = Observables::new(requests)?;
        let nothing = Observables::new(&[])?;
        let mut run = ObservedRun::new(scenario, None, nothing, Plan::default())?;
        observables.sample(&run.snapshot())?;
        Ok(observables.results())
    };
    let results = look().map_err(|error| problem(error.to_string()))?;
    Ok(results.iter().map(|found| found.quantities.iter().map(|number| number.name).collect()).collect())
}

/// The places of two balls.
fn pair_of(scenario: &Scenario, balls: &[String; 2]) -> Result<[usize; 2], ScenarioError> {
    let refuse =
        |message: String| Err(Problem::new("outcomes", format!("closest_approach: {message}")).into());
    if scenario.table.periodic() != [false; 2] {
        return refuse("is not for tables with periodic sides".into());
    }
    let ids: Vec<&str> = scenario.balls.iter().map(|ball| ball.id.as_str()).collect();
    let place = |id: &String| ids.iter().position(|known| known == id);
    match [place(&balls[0]), place(&balls[1])] {
        [Some(a), Some(b)] if a != b => Ok([a, b]),
        [Some(_), Some(_)] => refuse(format!("names {:?} twice", balls[0])),
        [None, _] => refuse(format!("there is no ball {:?}{}", balls[0], suggestion(&balls[0], &ids))),
        [_, None] => refuse(format!("there is no ball {:?}{}", balls[1], suggestion(&balls[1], &ids))),
    }
}

impl<D: Dynamics<f64>> Observer<f64, D> for Kept {
    #[inline(always)]
    fn event(&mut self, event: &Event<f64>) {
        self.note(event);
    }

    #[inline(always)]
    fn flight(&mut self, ball: usize, flight: &D::Flight) {
        if let Some(ways) = &mut self.ways {
            ways.begin::<D>(ball, flight);
        }
    }
}
