//! When something thrown leaves a strip across the pull of a field.
//!
//! In one strip it may be twice, on its way up and on its way down. Which of them it is, is told by whether it has already
//! left a strip the way it is pulled: so the answer depends on the flight and the strip alone, and not on when it is asked.

/// One coordinate of a flight in a field.
#[derive(Clone, Copy, Debug)]
pub struct Throw {
    pub velocity: f64,
    /// Not zero.
    pub pull: f64,
    /// It has already gone the way it is pulled, so it does not turn any more.
    pub is_falling: bool,
}

impl Throw {
    /// When it leaves the strip whose ends are so far above where it began, from then on, and whether through the upper end.
    pub fn leaves(self, to_lower: f64, to_upper: f64) -> (f64, bool) {
        let Self { velocity, pull, is_falling } = self;
        let is_pulled_up = pull > 0.0;
        let (to_top, to_bottom) = if is_pulled_up { (-to_lower, to_upper) } else { (to_upper, -to_lower) };
        let (speed_down, pull) = if is_pulled_up { (velocity, pull) } else { (-velocity, -pull) };
        let rise = if speed_down < 0.0 && !is_falling { rise(to_top, -speed_down, pull) } else { None };
        match rise {
            Some(time) => (time, !is_pulled_up),
            None => (fall(to_bottom, speed_down, pull), is_pulled_up),
        }
    }
}

/// When something thrown up has risen so far, if it does.
fn rise(height: f64, speed: f64, pull: f64) -> Option<f64> {
    let square = speed * speed - 2.0 * pull * height;
    (square > 0.0).then(|| 2.0 * height / (speed + square.sqrt()))
}

/// When something has fallen so far, which may have been thrown up or down. Where it turns is never passed, but by rounding.
fn fall(depth: f64, speed_down: f64, pull: f64) -> f64 {
    if depth == f64::INFINITY {
        return depth;
    }
    let square = speed_down * speed_down + 2.0 * pull * depth;
    let speed_there = if square > 0.0 { square.sqrt() } else { 0.0 };
    if speed_down > 0.0 {
        2.0 * depth / (speed_down + speed_there)
    } else {
        (speed_there - speed_down) / pull
    }
}

#[cfg(test)]
mod tests {
    use super::Throw;

    fn assert_leaves(found: (f64, bool), time: f64, is_up: bool) {
        assert!((found.0 - time).abs() < 1e-14 && found.1 == is_up, "{found:?} is not ({time}, {is_up})");
    }

    /// Thrown with 3 against a pull of 1, it rises to 4.5 and is at 4 after 2 and after 4.
    #[test]
    fn a_throw_leaves_a_strip_on_its_way_up_and_comes_back() {
        for pull in [-1.0, 1.0] {
            let throw = Throw { velocity: -3.0 * pull, pull, is_falling: false };
            let down = Throw { is_falling: true, ..throw };
            let of = |throw: Throw, [bottom, top]: [f64; 2]| {
                if pull < 0.0 { throw.leaves(bottom, top) } else { throw.leaves(-top, -bottom) }
            };
            let is_up = pull < 0.0;
            assert_leaves(of(throw, [-1.0, 4.0]), 2.0, is_up);
            assert_leaves(of(throw, [4.0, 8.0]), 4.0, !is_up);
            assert_leaves(of(down, [2.5, 4.0]), 5.0, !is_up);
            assert_leaves(of(down, [0.0, 2.5]), 6.0, !is_up);
            assert_eq!(of(down, [f64::NEG_INFINITY, 0.0]), (f64::INFINITY, !is_up));
            assert_leaves(of(throw, [0.0, f64::INFINITY]), 6.0, !is_up);
        }
    }

    #[test]
    fn a_drop_leaves_through_the_bottom() {
        let drop = Throw { velocity: 0.0, pull: -2.0, is_falling: false };
        assert_leaves(drop.leaves(-4.0, 1.0), 2.0, false);
        assert_leaves(Throw { velocity: -3.0, ..drop }.leaves(-4.0, 1.0), 1.0, false);
    }

    /// A speed that hardly changes: the formula must not lose it in a difference of large numbers.
    #[test]
    fn a_weak_pull_hardly_bends_a_throw() {
        let throw = Throw { velocity: 2.0, pull: -1e-12, is_falling: false };
        assert_leaves(throw.leaves(-1.0, 1.0), 0.5 + 0.25 * 1e-12 / 4.0, true);
    }
}
