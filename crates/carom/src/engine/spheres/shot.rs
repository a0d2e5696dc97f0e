//! The cue strikes a ball.

use super::Spheres;
use super::ending::Cause;
use crate::engine::interface::Fault;
use crate::model::Twist;
use crate::run::{Event, Kind, Observer, OnCloth};
use crate::scalar::Scalar;

impl<S: Scalar> Spheres<S> {
    /// Strikes the ball that the scenario's shot names, at time zero.
    pub(super) fn shoot(&mut self, observer: &mut impl Observer<S, OnCloth>) {
        let Some(stroke) = self.system.stroke else { return };
        let ball = stroke.ball;
        let state = self.balls[ball].flight.state_after(S::ZERO);
        let sphere = self.balls[ball].sphere;
        let is_miscue = stroke.cue.is_miscue(&stroke.strike);
        let impact = stroke.cue.strike(&sphere, &stroke.strike);
        let point = (state.position + impact.point * sphere.radius).plan();
        let event = Event {
            kind: if is_miscue { Kind::Miscue } else { Kind::CueBall },
            point,
            normal: stroke.strike.direction,
            closing_speed: stroke.strike.speed,
            impulse: if is_miscue { S::ZERO } else { impact.impulse },
            ..self.event_at(ball, S::ZERO, Kind::CueBall, state.position)
        };
        if is_miscue {
            self.fault = Some(Fault::Miscue);
        } else {
            let after = impact.twist;
            self.balls[ball].flight =
                self.flight_after(ball, S::ZERO, state.position, &Twist::REST, after, Cause::Blow);
        }
        self.emit(&event, observer);
    }
}
