//! The compressed start: discs placed at random while they are small, which move, collide and grow.
//!
//! The method is that of Lubachevsky and Stillinger. Growing discs hit each other ever harder, so after a few collisions
//! each their speeds are scaled back. The slower they grow, the better they find their order: up to a packing fraction of
//! 0.6 they may be fast, beyond it slow, and where they jam before the density asked for, all begins anew ten times as slowly.
//! So a density that cannot be reached takes long to be refused: a minute and more for ten thousand discs.

mod growth;
mod queue;

use super::cells::Cells;
use super::normal::normal_pair;
use super::random_placement;
use super::space::Space;
use crate::geometry::Vec2;
use crate::random::Random;
use growth::{Disc, Grown, Growth};

/// Packing fractions at which small discs are placed: the first that succeeds is where growth begins.
const LOOSE: [f64; 4] = [0.35, 0.2, 0.1, 0.01];

/// Growth of the discs' radii, over final radii and in units of thermal speed over mean diameter: up to a packing fraction,
/// the rate.
const RATES: [(f64, f64); 2] = [(0.6, 0.1), (1.0, 0.01)];

/// How fast discs grow in the trials after the first, over those rates.
const SLOW: f64 = 0.1;

/// Up to this many discs there are more slow trials: small boxes jam by chance, and cost next to nothing.
const FEW: usize = 100;

/// The slow trials of few discs, and of many.
const SLOW_TRIALS: [usize; 2] = [10, 1];

/// Collisions between two scalings of the speeds: of each disc, and of all at least.
const COLLISIONS: [usize; 2] = [2, 50];

/// Discs have jammed when the collisions of one in a unit of time, times what it is still to grow, are more than this, with
/// thermal speed, mean diameter and final size as units. Of discs that grow up it is about two at the end.
const JAMMED: f64 = 100.0;

/// Discs grow beyond their final size by this part of it, and so keep a distance that no rounding comes near.
const HAIR: f64 = 1e-10;

/// Discs that have not all the size they are to have.
struct Crowd<'a> {
    space: Space,
    radii: &'a [f64],
    diameter: f64,
    /// Mean of the diameters.
    mean: f64,
    /// The packing fraction at their final size.
    fraction: f64,
}

/// Places for discs of these radii, or how large they have become at most, over what they are to be.
pub(super) fn places(space: Space, radii: &[f64], fraction: f64, seed: u64) -> Result<Vec<Vec2<f64>>, f64> {
    let diameter = 2.0 * radii.iter().copied().fold(0.0, f64::max);
    let mean = 2.0 * super::sum::sum(radii.iter().copied()) / radii.len() as f64;
    let crowd = Crowd { space, radii, diameter, mean, fraction };
    let mut random = Random::new(seed, "gas.places");
    let mut largest = 0.0;
    let slow = SLOW_TRIALS[usize::from(radii.len() > FEW)];
    for slowness in core::iter::once(1.0).chain(core::iter::repeat_n(SLOW, slow)) {
        match crowd.loose(&mut random).and_then(|(discs, scale)| crowd.grown(discs, scale, slowness)) {
            Ok(places) => return Ok(places),
            Err(scale) => largest = scale.max(largest),
        }
    }
    Err(largest)
}

impl Crowd<'_> {
    /// Small discs at random places, with Maxwell's velocities, and their size over the final one.
    fn loose(&self, random: &mut Random) -> Result<(Vec<Disc>, f64), f64> {
        let mut scale = 0.0;
        for fraction in LOOSE {
            scale = (fraction / self.fraction).sqrt().min(1.0);
            let radii: Vec<f64> = self.radii.iter().map(|radius| radius * scale).collect();
            if let Ok(places) = random_placement::places(self.space, &radii, random) {
                let disc = |(id, (place, radius)): (usize, (&Vec2<f64>, &f64))| {
                    Disc::new(id, *place, Vec2::from_f64(normal_pair(random)), *radius)
                };
                let discs = places.iter().zip(self.radii).enumerate().map(disc).collect();
                return Ok((discs, scale));
            }
        }
        Err(scale)
    }

    /// Places of discs that have grown up.
    fn grown(&self, discs: Vec<Disc>, scale: f64, slowness: f64) -> Result<Vec<Vec2<f64>>, f64> {
        let end = 1.0 + HAIR;
        let [each, all] = COLLISIONS;
        let collisions = (each * discs.len()).max(all);
        let mut grown = Grown { discs, scale, time: 0.0, collisions: 0 };
        while grown.scale < end {
            scale_speeds(&mut grown.discs);
            let (upto, rate) = self.rate(grown.scale);
            let rate = rate * slowness / self.mean;
            let growth = Growth::new(self.space, grown.discs, self.diameter, grown.scale, rate);
            grown = growth.grow(upto.min(end), collisions);
            if self.has_jammed(&grown, end) {
                return Err(grown.scale);
            }
        }
        let mut places = vec![Vec2::ZERO; grown.discs.len()];
        grown.discs.iter().for_each(|disc| places[disc.id as usize] = disc.position);
        if self.is_free_of_overlaps(&places) { Ok(places) } else { Err(grown.scale) }
    }

    /// The size up to which there is a rate of growth, and that rate.
    fn rate(&self, scale: f64) -> (f64, f64) {
        let sizes = RATES.map(|(fraction, rate)| ((fraction / self.fraction).sqrt(), rate));
        sizes.into_iter().find(|(size, _)| scale < *size).unwrap_or((f64::INFINITY, RATES[1].1))
    }

    fn has_jammed(&self, grown: &Grown, end: f64) -> bool {
        let thermal = mean_square_speed(&grown.discs).sqrt();
        let per_disc = 2.0 * grown.collisions as f64 / grown.discs.len() as f64;
        per_disc * self.mean * (end - grown.scale) > JAMMED * thermal * grown.time
    }

    fn is_free_of_overlaps(&self, places: &[Vec2<f64>]) -> bool {
        let mut cells = Cells::new(self.space, self.diameter, places.len());
        places.iter().zip(self.radii).enumerate().all(|(disc, (place, radius))| {
            let cell = cells.cell_of(*place);
            let is_hit = cells.any_near(cell, |other, shift| {
                let reach = radius + self.radii[other];
                (places[other] + shift - *place).norm_squared() < reach * reach
            });
            cells.enter(disc, cell);
            !is_hit && self.is_within_walls(*place, *radius)
        })
    }

    fn is_within_walls(&self, place: Vec2<f64>, radius: f64) -> bool {
        let Space { size, periodic } = self.space;
        [(0, place.x), (1, place.y)]
            .into_iter()
            .all(|(axis, along)| periodic[axis] || (along >= radius && along <= size[axis] - radius))
    }
}

fn mean_square_speed(discs: &[Disc]) -> f64 {
    let squares = discs.iter().map(|disc| disc.velocity.norm_squared());
    squares.sum::<f64>() / (2.0 * discs.len() as f64)
}

/// Scales velocities so that each component has a mean square of one.
fn scale_speeds(discs: &mut [Disc]) {
    let factor = 1.0 / mean_square_speed(discs).sqrt();
    discs.iter_mut().for_each(|disc| disc.velocity = disc.velocity * factor);
}
