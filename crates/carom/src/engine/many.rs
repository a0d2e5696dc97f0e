//! Many balls: who is near whom, what comes first, and what a ball meets among those near.

use super::ball::{Ball, Rest};
use super::calendar::Calendar;
use super::discs::Discs;
use super::grid::{Grid, MOST_ROUNDS, Side, Window};
use super::queue::{Pending, Target};
use super::simd::{Candidates, Nearest, Nearness, Question, Touch, first_meeting, first_meetings};
use crate::detect::squared_tolerance;
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::memory::fetch;
use crate::scalar::Scalar;
use crate::scenario::System;

/// From so many balls on they do not fit into fast memory: what is needed next is fetched before.
const FETCHED_FROM: usize = 40_000;

/// What there is for many balls.
#[derive(Clone, Debug)]
pub(super) struct Many<S> {
    pub(super) grid: Grid,
    pub(super) calendar: Calendar<S>,
    near: Nearness<S>,
    is_fetched: bool,
}

impl<S: Scalar> Many<S> {
    /// For the balls of a system; `None` where the table is too small for cells.
    pub(super) fn new(system: &System<S>) -> Option<Self> {
        let radii = || system.discs.iter().map(|disc| disc.radius);
        let largest = radii().fold(S::ZERO, |most, radius| if radius > most { radius } else { most });
        let smallest = radii().fold(largest, |least, radius| if radius < least { radius } else { least });
        let count = system.discs.len();
        let grid = Grid::new(&system.bounds, largest + largest, count, system.periodic)?;
        let of_two = |radius| squared_tolerance(&system.tolerance, radius + radius);
        let near = Nearness {
            period: system.is_periodic().then(|| system.extent()),
            tolerance: system.tolerance,
            most: of_two(largest),
            least: of_two(smallest),
        };
        Some(Self { grid, calendar: Calendar::new(count), near, is_fetched: count >= FETCHED_FROM })
    }

    /// Puts the balls where their flights have brought them by a time.
    pub(super) fn put(&mut self, balls: &mut [Ball<S>], rest: &mut [Rest<S>], time: S) {
        self.grid.clear();
        self.calendar.clear();
        self.place_all(balls, rest, time);
    }

    fn place_all(&mut self, balls: &mut [Ball<S>], rest: &mut [Rest<S>], time: S) {
        for (ball, rest) in balls.iter_mut().zip(rest) {
            let flight = Flight { acceleration: rest.acceleration, ..ball.straight_flight() };
            let State { position, velocity } = flight.state_after(time - ball.start);
            let falls = |velocity: S, pull: S| velocity * pull > S::ZERO;
            let Vec2 { x, y } = velocity;
            rest.is_falling = [falls(x, rest.acceleration.x), falls(y, rest.acceleration.y)];
            self.grid.place(ball, position);
        }
    }
}

impl<S: Scalar> Discs<S> {
    /// The ball whose event comes first, and that event, if it is no later than `limit`; lets balls come into other cells on
    /// the way.
    #[inline(always)]
    pub(super) fn first_of_many(&mut self, limit: S) -> Option<(usize, Pending<S>)> {
        loop {
            let many = self.many.as_mut()?;
            let (ball, time) = many.calendar.first()?;
            if many.is_fetched {
                self.fetch_ahead();
            }
            if time > limit {
                return None;
            }
            let calendar = &self.many.as_ref()?.calendar;
            let meeting = *calendar.awaited(ball);
            let Some(side) = calendar.leaves(ball) else { return Some((ball, meeting)) };
            self.cross(ball, side, meeting, time);
        }
    }

    /// A ball comes into the next cell: only what is in those that have come near can be new to it.
    #[inline(always)]
    fn cross(&mut self, ball: usize, side: Side, meeting: Pending<S>, time: S) {
        let Some(Many { grid, .. }) = &mut self.many else { return };
        let count = self.balls.len();
        let line = &mut self.balls[ball];
        grid.cross(line, side);
        let [across, along] = line.rounds.map(i16::unsigned_abs);
        if across.max(along) >= MOST_ROUNDS.unsigned_abs() {
            self.begin_round(ball, time);
            return;
        }
        let finer = grid.finer(count);
        if !self.is_plain || finer.is_some() {
            Grid::note_fall(&mut self.rest[ball], side);
            if let Some(finer) = finer {
                self.move_to(finer, time);
            }
            self.predict_near(ball, Target::Nothing);
            return;
        }
        let (window, own) = (grid.ahead(line.cell, side), self.balls[ball]);
        match self.meeting_in(&window, &own, Touch::Parting, meeting) {
            Some(next) => self.schedule_among_many(ball, next),
            None => {
                self.predict_near(ball, Target::Nothing);
            }
        }
    }

    /// Puts all balls into the cells of another grid. What they meet stays as it is.
    #[cold]
    fn move_to(&mut self, grid: Grid, time: S) {
        let Some(many) = &mut self.many else { return };
        many.grid = grid;
        many.place_all(&mut self.balls, &mut self.rest, time);
        for ball in 0..self.balls.len() {
            let Some(Many { calendar, .. }) = &self.many else { return };
            self.schedule_among_many(ball, *calendar.awaited(ball));
        }
    }

    /// A flight that has gone round the table so often that this is no longer counted begins anew.
    #[cold]
    fn begin_round(&mut self, ball: usize, time: S) {
        let (flight, held_by) = (self.flight(ball), self.rest[ball].track.held_by);
        let State { position, velocity } = self.state_after(&flight, time - flight.start);
        let position = self.system.wrapped(position, self.balls[ball].rounds);
        self.begin_flight(ball, Flight { start: time, position, velocity, ..flight });
        self.rest[ball].track.held_by = held_by;
        self.predict(ball);
    }

    /// Schedules a ball's next event, or that it leaves its cell before.
    #[inline(always)]
    pub(super) fn schedule_among_many(&mut self, ball: usize, next: Pending<S>) {
        let Some(Many { grid, calendar, .. }) = &mut self.many else { return };
        self.diagnostics.predictions += 1;
        let line = &self.balls[ball];
        if !self.is_plain {
            let (offset, side) = grid.way_out_in_field(line, &self.rest[ball]);
            return calendar.set(ball, next, line.start.to_f64() + offset, side);
        }
        let (offset, side) = grid.way_out(line);
        calendar.set(ball, next, line.start.to_f64() + offset, side);
    }

    /// The line of a ball that begins a straight flight.
    #[inline(always)]
    pub(super) fn line_of(&self, ball: usize, flight: &Flight<S>) -> Ball<S> {
        let Flight { start, position, velocity, .. } = *flight;
        Ball { start, position, velocity, rounds: [0; 2], ..self.balls[ball] }
    }

    /// What a ball in straight flight meets among those near, if that comes before `next`; `None` where something else than
    /// `struck` is in touch.
    #[inline(always)]
    pub(super) fn meeting_near(&self, own: &Ball<S>, struck: Target, next: Pending<S>) -> Option<Pending<S>> {
        let window = self.many.as_ref()?.grid.around(own.cell);
        self.meeting_in(&window, own, Touch::of(struck, own), next)
    }

    /// The same of two balls, which are not in each other's way.
    #[inline(always)]
    pub(super) fn meetings_near(
        &self,
        [a, b]: [&Ball<S>; 2],
        struck: [Target; 2],
        next: [Pending<S>; 2],
    ) -> Option<[Pending<S>; 2]> {
        let many @ Many { grid, .. } = self.many.as_ref()?;
        let (window_a, window_b) = (grid.around(a.cell), grid.around(b.cell));
        let mut asked_a = self.question(many, a, Touch::of(struck[0], a), next[0]);
        let mut asked_b = self.question(many, b, Touch::of(struck[1], b), next[1]);
        let is_clear = if grid.list(&window_a, &mut asked_a.candidates)
            & grid.list(&window_b, &mut asked_b.candidates)
        {
            first_meetings(&mut asked_a, &mut asked_b)
        } else {
            self.ask_in_parts(&window_a, &mut asked_a) & self.ask_in_parts(&window_b, &mut asked_b)
        };
        is_clear.then(|| [self.answer(&asked_a, next[0]), self.answer(&asked_b, next[1])])
    }

    /// What a ball meets in some cells.
    #[inline(always)]
    fn meeting_in(
        &self,
        window: &Window,
        own: &Ball<S>,
        touch: Touch,
        next: Pending<S>,
    ) -> Option<Pending<S>> {
        let many @ Many { grid, .. } = self.many.as_ref()?;
        let mut asked = self.question(many, own, touch, next);
        let is_clear = if grid.list(window, &mut asked.candidates) {
            first_meeting(&mut asked)
        } else {
            self.ask_in_parts(window, &mut asked)
        };
        is_clear.then(|| self.answer(&asked, next))
    }

    #[inline(always)]
    fn question<'a>(
        &'a self,
        many: &'a Many<S>,
        own: &'a Ball<S>,
        touch: Touch,
        next: Pending<S>,
    ) -> Question<'a, S> {
        let nearest = Nearest { time: next.time, offset: next.offset, other: known(next) };
        let candidates = Candidates::none(own.number);
        Question { balls: &self.balls, own, touch, near: &many.near, candidates, nearest }
    }

    /// What a question has found, where `next` was known before.
    #[inline(always)]
    fn answer(&self, asked: &Question<S>, next: Pending<S>) -> Pending<S> {
        let Nearest { time, offset, other } = asked.nearest;
        // The same ball may be met sooner than was thought before it changed its course.
        if other == known(next) && time == next.time {
            return next;
        }
        let target = Target::Ball(other as u32, self.balls[other as usize].changes);
        Pending { time, offset, target }
    }

    /// Asks the balls of some cells where they are too many to be listed at once.
    #[cold]
    #[inline(never)]
    fn ask_in_parts(&self, window: &Window, asked: &mut Question<S>) -> bool {
        let Some(Many { grid, .. }) = &self.many else { return true };
        let mut is_clear = true;
        asked.candidates.clear(true);
        grid.each_four(window, |four, round| {
            if !asked.candidates.has_room_for(4) {
                is_clear &= first_meeting(asked);
                asked.candidates.clear(true);
            }
            asked.candidates.add_cell(core::slice::from_ref(four), round);
        });
        is_clear & first_meeting(asked)
    }

    /// How often the table lies between where another ball's flight says that it is, and where a ball sees it in a cell that
    /// is `round` times round.
    #[inline(always)]
    pub(super) fn rounds_between(&self, own: &Ball<S>, other: u32, round: [i16; 2]) -> [i32; 2] {
        own.rounds_to(&self.balls[other as usize], round)
    }

    /// Hands over the balls near a ball, itself too, each with the shift by which it is seen elsewhere, if any.
    pub(super) fn each_near(&self, ball: usize, mut meet: impl FnMut(usize, Option<Vec2<S>>)) {
        let Some(Many { grid, .. }) = &self.many else {
            (0..self.balls.len()).for_each(|other| meet(other, None));
            return;
        };
        let own = &self.balls[ball];
        grid.each_four(&grid.around(own.cell), |four, round| {
            for &number in four.numbers() {
                let rounds = self.rounds_between(own, number, round);
                let shift = (rounds != [0; 2]).then(|| self.system.shift(rounds));
                meet(number as usize, shift);
            }
        });
    }

    /// Fetches the memory of what comes soon.
    #[inline(always)]
    fn fetch_ahead(&self) {
        let Some(Many { grid, calendar, .. }) = &self.many else { return };
        if let Some(ball) = calendar.coming(12) {
            self.fetch_ball(ball);
        }
        // Whom a ball meets, unless it leaves its cell before.
        let partner = |ball| match calendar.awaited(ball).target {
            Target::Ball(other, _) if calendar.leaves(ball).is_none() => Some(other as usize),
            _ => None,
        };
        // Where in the grid a ball is by then.
        let soon_in = |ball: usize| grid.beyond(self.balls[ball].cell, calendar.leaves(ball));
        let fetch_near = |cell| grid.each_near_in_memory(cell, |near| fetch(&self.balls, near as usize));
        if let Some(other) = calendar.coming(9).and_then(partner) {
            self.fetch_ball(other);
        }
        if let Some(ball) = calendar.coming(6) {
            grid.fetch_around(soon_in(ball));
            if let Some(other) = partner(ball) {
                grid.fetch_around(grid.cell(self.balls[other].cell));
            }
        }
        if let Some(ball) = calendar.coming(3) {
            fetch_near(soon_in(ball));
            if let Some(other) = partner(ball) {
                fetch_near(grid.cell(self.balls[other].cell));
            }
        }
    }

    /// Fetches what a collision reads of a ball.
    #[inline(always)]
    fn fetch_ball(&self, ball: usize) {
        if let Some(Many { calendar, .. }) = &self.many {
            calendar.fetch(ball);
        }
        fetch(&self.balls, ball);
        if !self.are_alike {
            fetch(&self.system.discs, ball);
        }
    }
}

/// The other ball of a meeting that is known, below zero if there is none.
#[inline(always)]
fn known<S>(next: Pending<S>) -> i64 {
    if let Target::Ball(other, _) = next.target { i64::from(other) } else { -1 }
}

impl Touch {
    /// After a ball's contact with `struck`.
    #[inline(always)]
    fn of<S>(struck: Target, own: &Ball<S>) -> Self {
        match struck {
            Target::Ball(other, _) => Self::Struck(other),
            Target::Cushion(_) => Self::Struck(own.number),
            Target::Nothing | Target::Release(_) => Self::Parting,
        }
    }
}
