//! Periodic tables: what is where among the images of a table that repeats itself.
//!
//! A ball's flight begins in the first image, the table itself; how often the ball has gone round since the run began is
//! kept beside the flight, in whole numbers.

use super::System;
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::scalar::Scalar;

impl<S: Scalar> System<S> {
    /// Whether any axis is periodic.
    #[inline(always)]
    pub fn is_periodic(&self) -> bool {
        self.periodic[0] || self.periodic[1]
    }

    /// How large the table is; what an axis is long.
    #[inline(always)]
    pub fn extent(&self) -> Vec2<S> {
        self.bounds.max - self.bounds.min
    }

    /// The way that so many rounds are.
    #[inline(always)]
    pub fn shift(&self, rounds: [i32; 2]) -> Vec2<S> {
        let extent = self.extent();
        let [x, y] = rounds.map(|rounds| S::from_f64(f64::from(rounds)));
        Vec2::new(extent.x * x, extent.y * y)
    }

    /// The shifts by which a ball that lies so many rounds away is seen: once on a table that is not periodic, else also that
    /// many images to each side.
    pub fn each_image(&self, rounds: [i32; 2], images: i32, mut see: impl FnMut(Option<Vec2<S>>)) {
        if !self.is_periodic() {
            return see(None);
        }
        let reach = self.periodic.map(|is_periodic| if is_periodic { images } else { 0 });
        for y in -reach[1]..=reach[1] {
            for x in -reach[0]..=reach[0] {
                let seen = [rounds[0] + x, rounds[1] + y];
                see((seen != [0; 2]).then(|| self.shift(seen)));
            }
        }
    }

    /// A place without the rounds that led to it.
    #[inline(always)]
    pub fn wrapped(&self, position: Vec2<S>, rounds: [i16; 2]) -> Vec2<S> {
        if rounds == [0; 2] { position } else { position - self.shift(rounds.map(i32::from)) }
    }

    /// A flight with all the way that led to its start.
    pub fn unwrapped(&self, flight: &Flight<S>, image: [i32; 2]) -> Flight<S> {
        if image == [0; 2] {
            return *flight;
        }
        Flight { position: flight.position + self.shift(image), ..*flight }
    }

    /// The image, of those of a place that is so far away and of its neighbours, that is nearest: by how many rounds from it.
    #[inline(always)]
    pub fn nearest_image(&self, away: Vec2<S>) -> [i32; 2] {
        if !self.is_periodic() {
            return [0; 2];
        }
        let extent = self.extent();
        let along = |away: S, extent: S, is_periodic: bool| {
            let half = extent * S::from_f64(0.5);
            match () {
                () if !is_periodic => 0,
                () if away > half => -1,
                () if away < -half => 1,
                () => 0,
            }
        };
        [along(away.x, extent.x, self.periodic[0]), along(away.y, extent.y, self.periodic[1])]
    }

    /// The way to the nearest image of what is so far away.
    #[inline(always)]
    pub fn shortest(&self, away: Vec2<S>) -> Vec2<S> {
        let image = self.nearest_image(away);
        if image == [0; 2] { away } else { away + self.shift(image) }
    }
}
