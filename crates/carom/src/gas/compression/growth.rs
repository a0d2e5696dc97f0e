//! Discs in a box that move, collide and grow, event by event.
//!
//! At time t every radius is its final one times a + g t. So two discs whose final radii sum to σ touch when
//!
//! ```text
//! |Δx + w t|² = σ² (a + g t)²
//! ```
//!
//! which is a quadratic gap like that of discs which keep their size. At a contact the edges approach at σ g − w·n, with n
//! from the first disc to the second, and part at the same speed: elastic, as seen from the growing edges (B. Lubachevsky,
//! F. Stillinger, *Geometric properties of random disk packings*, Journal of Statistical Physics 60 (1990) 561–583). All
//! discs have equal masses here, whatever theirs will be: the motion only finds them places.

use super::super::cells::{Cell, Cells};
use super::super::space::Space;
use super::queue::Queue;
use crate::geometry::Vec2;
use crate::roots::Quadratic;

/// A disc on its flight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Disc {
    /// Where it was at the start of its flight.
    pub position: Vec2<f64>,
    /// How fast it is.
    pub velocity: Vec2<f64>,
    /// When its flight started.
    since: f64,
    /// Its final radius.
    pub radius: f64,
    /// Which disc of the gas it is.
    pub id: u32,
    /// How often its flight was changed.
    changes: u32,
    cell: Cell,
}

/// What a disc's next event is.
#[derive(Clone, Copy, Debug)]
enum Target {
    Nothing,
    /// It meets another disc, which had so many changes when this was predicted.
    Disc(u32, u32),
    /// It meets a wall across this axis.
    Wall(usize),
    /// It crosses into the next cell along this axis, up or down.
    Cell(usize, i32),
}

/// A disc's next event.
#[derive(Clone, Copy, Debug)]
struct Next {
    time: f64,
    target: Target,
}

/// Discs that grow.
#[derive(Debug)]
pub(super) struct Growth {
    space: Space,
    cells: Cells,
    discs: Vec<Disc>,
    next: Vec<Next>,
    queue: Queue,
    /// Radii over final radii at time zero.
    scale: f64,
    /// By how much that grows in a unit of time.
    rate: f64,
    now: f64,
    collisions: usize,
}

/// What growing came to.
#[derive(Debug)]
pub(super) struct Grown {
    pub discs: Vec<Disc>,
    /// Radii over final radii.
    pub scale: f64,
    /// How long it took.
    pub time: f64,
    pub collisions: usize,
}

impl Disc {
    /// A disc at time zero.
    pub fn new(id: usize, position: Vec2<f64>, velocity: Vec2<f64>, radius: f64) -> Self {
        Self { position, velocity, since: 0.0, radius, id: id as u32, changes: 0, cell: [0, 0] }
    }

    #[inline(always)]
    fn at(&self, time: f64) -> Vec2<f64> {
        self.position + self.velocity * (time - self.since)
    }
}

impl Next {
    #[inline(always)]
    fn earlier(self, time: f64, target: Target) -> Self {
        if time < self.time { Self { time, target } } else { self }
    }
}

impl Growth {
    /// Discs at time zero, with radii `scale` times the final ones, the largest of which has this diameter.
    pub fn new(space: Space, discs: Vec<Disc>, diameter: f64, scale: f64, rate: f64) -> Self {
        let (cells, discs) = sorted(Cells::new(space, diameter, discs.len()), discs);
        let (next, queue) = (Vec::with_capacity(discs.len()), Queue::new(discs.len()));
        let mut growth = Self { space, cells, discs, next, queue, scale, rate, now: 0.0, collisions: 0 };
        for disc in 0..growth.discs.len() {
            let next = growth.predict(disc);
            growth.next.push(next);
            growth.queue.set(disc, next.time);
        }
        growth
    }

    /// Lets the discs grow up to a scale, but not longer than for so many collisions.
    pub fn grow(mut self, scale: f64, collisions: usize) -> Grown {
        let end = (scale - self.scale) / self.rate;
        while self.collisions < collisions {
            let (time, disc) = self.queue.first();
            if time >= end {
                self.now = end;
                return self.grown(scale);
            }
            self.now = time;
            self.happen(disc);
        }
        let scale = self.scale_now();
        self.grown(scale)
    }

    fn grown(mut self, scale: f64) -> Grown {
        for disc in &mut self.discs {
            (disc.position, disc.since) = (self.space.wrapped(disc.at(self.now)), 0.0);
        }
        Grown { discs: self.discs, scale, time: self.now, collisions: self.collisions }
    }

    #[inline(always)]
    fn scale_now(&self) -> f64 {
        self.scale + self.rate * self.now
    }

    /// A disc's next event comes true.
    fn happen(&mut self, disc: usize) {
        match self.next[disc].target {
            Target::Disc(other, changes) if self.discs[other as usize].changes == changes => {
                self.collide(disc, other as usize);
                self.look_ahead(other as usize);
            }
            Target::Wall(axis) => self.bounce(disc, axis),
            Target::Cell(axis, step) => self.cross(disc, axis, step),
            // The other disc went elsewhere.
            Target::Disc(..) | Target::Nothing => {}
        }
        self.look_ahead(disc);
    }

    #[inline(always)]
    fn look_ahead(&mut self, disc: usize) {
        let next = self.predict(disc);
        self.next[disc] = next;
        self.queue.set(disc, next.time);
    }

    /// Starts a new flight where a disc is now.
    fn advance(&mut self, disc: usize) {
        let now = self.now;
        let disc = &mut self.discs[disc];
        (disc.position, disc.since) = (disc.at(now), now);
        disc.changes += 1;
    }

    fn collide(&mut self, a: usize, b: usize) {
        self.advance(a);
        self.advance(b);
        let [first, second] = [self.discs[a], self.discs[b]];
        let normal = self.space.separation(first.position, second.position).unit();
        let closing =
            (first.radius + second.radius) * self.rate - (second.velocity - first.velocity).dot(normal);
        self.discs[a].velocity = first.velocity - normal * closing;
        self.discs[b].velocity = second.velocity + normal * closing;
        self.collisions += 1;
    }

    fn bounce(&mut self, disc: usize, axis: usize) {
        self.advance(disc);
        let middle = 0.5 * self.space.size[axis];
        let disc = &mut self.discs[disc];
        let edge = 2.0 * disc.radius * self.rate;
        let reflect = |place: f64, speed: f64| if place < middle { edge - speed } else { -edge - speed };
        match axis {
            0 => disc.velocity.x = reflect(disc.position.x, disc.velocity.x),
            _ => disc.velocity.y = reflect(disc.position.y, disc.velocity.y),
        }
        self.collisions += 1;
    }

    /// Moves a disc into the next cell; its flight goes on.
    fn cross(&mut self, disc: usize, axis: usize, step: i32) {
        let cell = self.discs[disc].cell;
        let Some((index, shift)) = self.cells.beside(cell[axis], axis, step) else { return };
        self.cells.leave(disc, cell);
        let one = &mut self.discs[disc];
        one.cell[axis] = index;
        match axis {
            0 => one.position.x -= shift,
            _ => one.position.y -= shift,
        }
        let cell = one.cell;
        self.cells.enter(disc, cell);
    }

    /// A disc's next event.
    fn predict(&self, a: usize) -> Next {
        let disc = &self.discs[a];
        let (place, scale) = (disc.at(self.now), self.scale_now());
        let mut next = Next { time: f64::INFINITY, target: Target::Nothing };
        for (axis, place, speed) in [(0, place.x, disc.velocity.x), (1, place.y, disc.velocity.y)] {
            next = self.way_out(next, disc, axis, place, speed);
        }
        self.cells.any_near(disc.cell, |b, shift| {
            let other = &self.discs[b];
            let apart = other.at(self.now) + shift - place;
            let reach = disc.radius + other.radius;
            let meeting = meeting(apart, other.velocity - disc.velocity, reach * scale, reach * self.rate);
            if b != a && meeting < next.time - self.now {
                next = Next { time: self.now + meeting, target: Target::Disc(b as u32, other.changes) };
            }
            false
        });
        next
    }

    /// When a disc leaves its cell along an axis, or meets the wall there, if that comes before something else.
    #[inline(always)]
    fn way_out(&self, mut next: Next, disc: &Disc, axis: usize, place: f64, speed: f64) -> Next {
        let [below, above] = self.cells.sides(disc.cell, axis);
        let radius = disc.radius * self.scale_now();
        let growth = disc.radius * self.rate;
        // The way to each side, and how fast it gets shorter.
        let sides = [
            (place, below.map(|side| place - side), -speed, -1),
            (self.space.size[axis] - place, above.map(|side| side - place), speed, 1),
        ];
        for (to_wall, to_cell, speed, step) in sides {
            let (way, speed, target) = match to_cell {
                Some(way) => (way, speed, Target::Cell(axis, step)),
                None => (to_wall - radius, speed + growth, Target::Wall(axis)),
            };
            if speed > 0.0 {
                next = next.earlier(self.now + way.max(0.0) / speed, target);
            }
        }
        next
    }
}

/// How long until discs meet that are `apart`, move at `velocity` relative to each other, and touch at a distance `reach`
/// that grows at `rate`; infinite for never.
#[inline(always)]
fn meeting(apart: Vec2<f64>, velocity: Vec2<f64>, reach: f64, rate: f64) -> f64 {
    let gap = apart.norm_squared() - reach * reach;
    let half = apart.dot(velocity) - reach * rate;
    let bend = velocity.norm_squared() - rate * rate;
    if gap <= 0.0 && half < 0.0 {
        return 0.0;
    }
    // Below zero it is by rounding only.
    Quadratic::new([gap.max(0.0), 2.0 * half, bend]).closing_crossing().unwrap_or(f64::INFINITY)
}

/// Discs row by row of their cells, in these cells.
fn sorted(mut cells: Cells, mut discs: Vec<Disc>) -> (Cells, Vec<Disc>) {
    for disc in &mut discs {
        disc.cell = cells.cell_of(disc.position);
    }
    discs.sort_by_key(|disc| cells.number(disc.cell));
    for (number, disc) in discs.iter().enumerate() {
        cells.enter(number, disc.cell);
    }
    (cells, discs)
}
