//! The random start: discs come one after another, each to where it finds room (random sequential placement).
//!
//! Large discs come first, which leaves the small ones the gaps. Equal discs jam at a packing fraction of 0.547, and the
//! last ones before that take ever longer; so there is an end at 0.5.

use super::cells::Cells;
use super::space::Space;
use crate::geometry::Vec2;
use crate::random::Random;

/// The packing fraction up to which this is tried.
pub(super) const MOST: f64 = 0.5;

/// A filling of the box is given up when a disc has found no room this many times: near the end at 0.5 it takes some
/// thousand trials.
const TRIALS: usize = 100_000;

/// Small boxes may jam early, by chance; then all begins anew, this many times.
const FILLINGS: usize = 30;

/// Places for discs of these radii, or how many could be placed at most.
pub(super) fn places(space: Space, radii: &[f64], random: &mut Random) -> Result<Vec<Vec2<f64>>, usize> {
    let mut order: Vec<usize> = (0..radii.len()).collect();
    order.sort_by(|a, b| radii[*b].total_cmp(&radii[*a]));
    let mut most = 0;
    for _ in 0..FILLINGS {
        match fill(space, radii, &order, random) {
            Ok(places) => return Ok(places),
            Err(placed) => most = most.max(placed),
        }
    }
    Err(most)
}

/// One filling of the box, or how many discs found a place.
fn fill(space: Space, radii: &[f64], order: &[usize], random: &mut Random) -> Result<Vec<Vec2<f64>>, usize> {
    let largest = order.first().map_or(0.0, |disc| radii[*disc]);
    let mut cells = Cells::new(space, 2.0 * largest, radii.len());
    let mut places = vec![Vec2::ZERO; radii.len()];
    for (placed, disc) in order.iter().enumerate() {
        let radius = radii[*disc];
        let is_free = |place: &Vec2<f64>| {
            !cells.any_near(cells.cell_of(*place), |other, shift| {
                let reach = radius + radii[other];
                (places[other] + shift - *place).norm_squared() < reach * reach
            })
        };
        let place = (0..TRIALS).map(|_| anywhere(space, radius, random)).find(is_free).ok_or(placed)?;
        cells.enter(*disc, cells.cell_of(place));
        places[*disc] = place;
    }
    Ok(places)
}

/// A place for a disc, each equally likely.
fn anywhere(space: Space, radius: f64, random: &mut Random) -> Vec2<f64> {
    let [x, y] = [0, 1].map(|axis| {
        let margin = if space.periodic[axis] { 0.0 } else { radius };
        margin + random.unit() * (space.size[axis] - 2.0 * margin)
    });
    Vec2::new(x, y)
}
