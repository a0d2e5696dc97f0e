//! What is kept of a run of an ensemble, as columns of numbers.

use crate::flight::Motion;
use crate::run::{Diagnostics, Dynamics, Event, Kind, Observer};
use crate::scenario::{Problem, Scenario, ScenarioError};

/// Something about a run: one column, or one for each ball and component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    /// At the end, of each ball: how it moves where there is a cloth, place, velocity, spin.
    numbers: Vec<f64>,
}

impl Outcome {
    /// Every outcome.
    pub const ALL: [Self; 8] = [
        Self::EndTime,
        Self::Events,
        Self::FirstEvent,
        Self::LastEvent,
        Self::FinalPosition,
        Self::FinalVelocity,
        Self::FinalSpin,
        Self::Pockets,
    ];

    /// The word used on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::EndTime => "end_time",
            Self::Events => "events",
            Self::FirstEvent => "first_event",
            Self::LastEvent => "last_event",
            Self::FinalPosition => "final_position",
            Self::FinalVelocity => "final_velocity",
            Self::FinalSpin => "final_spin",
            Self::Pockets => "pockets",
        }
    }

    /// The outcome of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|outcome| outcome.name() == name)
    }

    fn needs_cloth(self) -> bool {
        matches!(self, Self::FinalSpin | Self::Pockets)
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
        let kinds: Vec<Kind> = Kind::ALL.into_iter().filter(|kind| kind.happens(is_on_cloth)).collect();
        let axes: &[&str] = if is_on_cloth { &["x", "y", "z"] } else { &["x", "y"] };
        let mut columns = Vec::new();
        for outcome in outcomes {
            let mut add = |name: String, meaning| columns.push(Column { name, meaning });
            let of_balls = |prefix: &'static str| {
                let ids = scenario.balls.iter().map(|ball| &ball.id);
                ids.flat_map(move |id| axes.iter().map(move |axis| format!("{id}.{prefix}{axis}")))
            };
            match outcome {
                Outcome::EndTime | Outcome::FirstEvent | Outcome::LastEvent => {
                    add(outcome.name().into(), Meaning::Quantity);
                }
                Outcome::Events => {
                    kinds.iter().for_each(|kind| add(format!("events.{}", kind.name()), Meaning::Count));
                }
                Outcome::FinalPosition => of_balls("").for_each(|name| add(name, Meaning::Quantity)),
                Outcome::FinalVelocity => of_balls("v").for_each(|name| add(name, Meaning::Quantity)),
                Outcome::FinalSpin => of_balls("w").for_each(|name| add(name, Meaning::Quantity)),
                Outcome::Pockets => {
                    let ids = scenario.balls.iter().map(|ball| &ball.id);
                    ids.for_each(|id| add(format!("{id}.pocket"), Meaning::Pocket));
                }
            }
        }
        Ok(Self { outcomes: outcomes.to_vec(), columns, kinds, cushions: f64::from(cushions), is_on_cloth })
    }

    /// Fills a row with what is known at the end of a run.
    pub(super) fn fill(&self, out: &mut [f64], end_time: f64, diagnostics: &Diagnostics, kept: &Kept) {
        let mut out = out.iter_mut();
        let mut put = |number: f64| {
            if let Some(place) = out.next() {
                *place = number;
            }
        };
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
            }
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
    /// Nothing yet.
    pub(super) fn new() -> Self {
        Self { first_event: f64::NAN, last_event: f64::NAN, pockets: Vec::new(), numbers: Vec::new() }
    }

    /// Nothing again, of so many balls.
    pub(super) fn clear(&mut self, balls: usize) {
        (self.first_event, self.last_event) = (f64::NAN, f64::NAN);
        self.pockets.clear();
        self.pockets.resize(balls, f64::NEG_INFINITY);
    }

    /// Keeps the states at the end.
    pub(super) fn keep_end<D: Dynamics<f64>>(&mut self, states: impl Iterator<Item = D::State>) {
        self.numbers.clear();
        for state in states {
            self.numbers.extend(D::numbers(&state));
        }
    }

    /// Puts the balls, whose names are `own`, into the order of `ids`; of one that is not there nothing is known.
    pub(super) fn reorder(&mut self, own: &[String], ids: &[String]) {
        if own == ids {
            return;
        }
        let width = self.numbers.len() / own.len().max(1);
        let (mut numbers, mut pockets) = (Vec::new(), Vec::new());
        for id in ids {
            let place = own.iter().position(|own| own == id);
            match place {
                Some(place) => numbers.extend(&self.numbers[place * width..(place + 1) * width]),
                None => numbers.resize(numbers.len() + width, f64::NAN),
            }
            pockets.push(place.map_or(f64::NEG_INFINITY, |place| self.pockets[place]));
        }
        (self.numbers, self.pockets) = (numbers, pockets);
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

impl<D: Dynamics<f64>> Observer<f64, D> for Kept {
    #[inline(always)]
    fn event(&mut self, event: &Event<f64>) {
        self.note(event);
    }

    #[inline(always)]
    fn flight(&mut self, _: usize, _: &D::Flight) {}
}
