//! The ways that balls go: how long they are, and how near two balls come to each other.

use crate::geometry::Vec3;
use crate::roots::{Polynomial, closing_crossings};
use crate::run::Dynamics;
use crate::scalar::ln;

/// Nodes and weights of Gauss and Legendre's rule with eight points, on the right half of [−1, 1].
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_361_96),
    (0.525_532_409_916_329, 0.313_706_645_877_887_27),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// A change of the speed by less than this part of it is summed by Gauss' rule, to which such a speed is all but straight;
/// the closed form would be a difference of large numbers.
const HARDLY: f64 = 0.1;

/// A ball's present flight.
#[derive(Clone, Copy, Debug)]
struct Leg {
    start: f64,
    position: Vec3<f64>,
    velocity: Vec3<f64>,
    acceleration: Vec3<f64>,
}

/// The ways of all balls so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Ways {
    legs: Vec<Leg>,
    lengths: Vec<f64>,
    pairs: Vec<Nearness>,
}

/// How near two balls have come to each other, up to a time.
#[derive(Clone, Copy, Debug)]
struct Nearness {
    balls: [usize; 2],
    squared: f64,
    until: f64,
}

impl Ways {
    /// Balls at the beginning, of which these pairs are watched.
    pub(super) fn clear(&mut self, balls: usize, pairs: &[[usize; 2]]) {
        let nowhere = Vec3::from_f64([f64::NAN; 3]);
        let leg = Leg { start: 0.0, position: nowhere, velocity: Vec3::ZERO, acceleration: Vec3::ZERO };
        self.legs.clear();
        self.legs.resize(balls, leg);
        self.lengths.clear();
        self.lengths.resize(balls, 0.0);
        self.pairs.clear();
        let pair = |&balls| Nearness { balls, squared: f64::INFINITY, until: 0.0 };
        self.pairs.extend(pairs.iter().map(pair));
    }

    /// A ball begins a new flight.
    pub(super) fn begin<D: Dynamics<f64>>(&mut self, ball: usize, flight: &D::Flight) {
        let start = D::start(flight);
        self.end(ball, start);
        let [position, velocity, acceleration] = D::course(flight);
        self.legs[ball] = Leg { start, position, velocity, acceleration };
    }

    /// The run ends.
    pub(super) fn end_all(&mut self, time: f64) {
        (0..self.legs.len()).for_each(|ball| self.end(ball, time));
    }

    /// A ball's flight ends.
    fn end(&mut self, ball: usize, time: f64) {
        let leg = self.legs[ball];
        self.lengths[ball] += leg.length(time - leg.start);
        for pair in self.pairs.iter_mut().filter(|pair| pair.balls.contains(&ball)) {
            // A row may lack a ball that others have.
            if let [Some(a), Some(b)] = pair.balls.map(|ball| self.legs.get(ball)) {
                let nearest = a.from(pair.until).nearest_squared(&b.from(pair.until), time - pair.until);
                pair.squared = pair.squared.min(nearest);
            }
            pair.until = time;
        }
    }

    /// How long the way of each ball is.
    pub(super) fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// How near the centres of the pair at a place have come to each other.
    pub(super) fn nearest(&self, pair: usize) -> f64 {
        let squared = self.pairs[pair].squared;
        if squared < f64::INFINITY { squared.sqrt() } else { f64::NAN }
    }
}

impl Leg {
    /// The same flight seen from a later start.
    fn from(self, start: f64) -> Self {
        let (elapsed, Self { position, velocity, acceleration, .. }) = (start - self.start, self);
        let position = position + (velocity + acceleration * (0.5 * elapsed)) * elapsed;
        Self { start, position, velocity: velocity + acceleration * elapsed, acceleration }
    }

    /// The way that is gone in a time: ∫ |v + a t| dt.
    fn length(&self, time: f64) -> f64 {
        let (pull, change) = (self.acceleration.norm_squared(), self.acceleration.dot(self.velocity));
        let speed_squared = self.velocity.norm_squared();
        if time <= 0.0 || pull == 0.0 {
            return speed_squared.sqrt() * time.max(0.0);
        }
        if pull * time * time < HARDLY * HARDLY * speed_squared {
            let speed = |t: f64| (self.velocity + self.acceleration * t).norm();
            let pair = |(node, weight): &(f64, f64)| {
                weight * (speed(0.5 * time * (1.0 - node)) + speed(0.5 * time * (1.0 + node)))
            };
            return 0.5 * time * GAUSS.iter().map(pair).sum::<f64>();
        }
        // √a² ∫ √(u² + d) du, u counted from where the speed is least.
        let from = change / pull;
        let least = (speed_squared / pull - from * from).max(0.0);
        let primitive = |u: f64| 0.5 * (u * (u * u + least).sqrt() + least * arsinh(u, least.sqrt()));
        pull.sqrt() * (primitive(from + time) - primitive(from))
    }

    /// The least squared distance from another, which starts at the same time, within a time.
    fn nearest_squared(&self, other: &Self, within: f64) -> f64 {
        let away = other.position - self.position;
        if !away.is_finite() || within < 0.0 {
            return f64::INFINITY;
        }
        let velocity = other.velocity - self.velocity;
        let half_pull = (other.acceleration - self.acceleration) * 0.5;
        let squared = Polynomial::new([
            away.norm_squared(),
            2.0 * away.dot(velocity),
            velocity.norm_squared() + 2.0 * away.dot(half_pull),
            2.0 * velocity.dot(half_pull),
            half_pull.norm_squared(),
        ]);
        // Where the distance is least, that by which it falls closes.
        let falls = Polynomial::new(squared.derivative().coefficients.map(|coefficient: f64| -coefficient));
        let turns = closing_crossings(&falls, 0.0).take_while(|turn| *turn < within);
        let at = |time: f64| (away + (velocity + half_pull * time) * time).norm_squared();
        turns.map(at).fold(at(0.0).min(at(within)), f64::min)
    }
}

/// arsinh(u / w), 0 where w is.
fn arsinh(u: f64, w: f64) -> f64 {
    if w == 0.0 {
        return 0.0;
    }
    let x = u.abs() / w;
    let value = ln(x + (x * x + 1.0).sqrt());
    if u < 0.0 { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::{Leg, Vec3};
    use crate::scalar::direction;

    fn leg(position: [f64; 3], velocity: [f64; 3], acceleration: [f64; 3]) -> Leg {
        let [position, velocity, acceleration] = [position, velocity, acceleration].map(Vec3::from_f64);
        Leg { start: 0.0, position, velocity, acceleration }
    }

    /// The length of very many short straight pieces.
    fn summed(leg: &Leg, time: f64) -> f64 {
        let pieces = 200_000;
        let place = |k: i32| leg.from(time * f64::from(k) / f64::from(pieces)).position;
        (0..pieces).map(|k| (place(k + 1) - place(k)).norm()).sum()
    }

    #[test]
    fn the_length_of_a_way_is_that_of_its_pieces() {
        let pulls = [
            [0.0; 3],
            [0.0, -9.8, 0.0],
            [1e-3, 2e-3, 0.0],
            [-3.0, -4.0, 0.0],
            [1e-9, 0.0, 0.0],
            [0.0, 0.0, -9.8],
        ];
        for pull in pulls {
            for velocity in [[3.0, 4.0, 0.0], [0.0, 0.0, 0.0], [-1.0, 1e-3, 2.0]] {
                for time in [0.0, 0.3, 1.0, 2.5] {
                    let leg = leg([1.0, 2.0, 0.0], velocity, pull);
                    let (found, expected) = (leg.length(time), summed(&leg, time));
                    assert!(
                        (found - expected).abs() <= 1e-8 * expected + 1e-15,
                        "{leg:?} {time}: {found} {expected}"
                    );
                }
            }
        }
        // A throw straight up and down again: 2 · v²/2g.
        let throw = leg([0.0; 3], [0.0, 3.0, 0.0], [0.0, -1.0, 0.0]);
        assert!((throw.length(6.0) - 9.0).abs() < 1e-14);
    }

    /// Both ways of the length, at the change of speed where one takes over from the other.
    #[test]
    fn the_two_formulas_meet() {
        for angle in 0..20 {
            let (x, y) = direction(18.0 * f64::from(angle));
            let flight = leg([0.0; 3], [2.0, 0.0, 0.0], [x, y, 0.0]);
            let (below, above) = (flight.length(0.2 - 1e-12), flight.length(0.2 + 1e-12));
            assert!((above - below).abs() < 1e-11, "{angle}: {below} {above}");
        }
    }

    #[test]
    fn the_least_distance_is_found_inside_and_at_the_ends() {
        let still = leg([0.0; 3], [0.0; 3], [0.0; 3]);
        let passing = leg([-2.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]);
        assert_eq!(still.nearest_squared(&passing, 10.0), 1.0);
        assert_eq!(still.nearest_squared(&passing, 1.0), 2.0);
        // Thrown towards it from above, twice near: y = 2 − 3 t + t², least at 3/2 with −1/4, zero at 1.
        let thrown = leg([0.0, 2.0, 0.0], [0.0, -3.0, 0.0], [0.0, 2.0, 0.0]);
        assert!(still.nearest_squared(&thrown, 5.0) < 1e-20);
        let beside = leg([0.0, 2.0, 0.5], [0.0, -3.0, 0.0], [0.0, 2.0, 0.0]);
        assert!((still.nearest_squared(&beside, 5.0) - 0.25).abs() < 1e-14);
        assert!((still.nearest_squared(&beside, 0.5) - (0.75 * 0.75 + 0.25)).abs() < 1e-14);
    }
}
