//! The balls of a cluster, and where they are when it is struck.

use super::{Member, Struck, by_place};
use crate::detect::{Surroundings, detect_ball_ball, detect_ball_cushion};
use crate::engine::Discs;
use crate::geometry::Vec2;
use crate::model::Face;
use crate::scalar::Scalar;

impl<S: Scalar> Discs<S> {
    /// The balls that touch each other or the struck ones.
    pub(super) fn gather(&self, struck: &[Struck<S>], time: S) -> Vec<Member<S>> {
        let mut members: Vec<Member<S>> = struck.iter().map(|&s| Member::new(&self.system, s)).collect();
        let mut next = 0;
        while next < members.len() {
            self.each_near(members[next].ball, |ball, _| {
                if members.iter().any(|m| m.ball == ball) {
                    return;
                }
                let elapsed = time - self.balls[ball].start;
                let member = Member::new(&self.system, self.struck(ball, elapsed));
                if self.ball_gap(members[next].ball, members[next].position, ball, member.position) <= S::ONE
                {
                    members.push(member);
                }
            });
            next += 1;
        }
        members
    }

    /// Puts the members where their contacts are, and in order of place.
    ///
    /// A contact's own offset is not rounded as the time is. Where several contacts come at this very time, a ball takes
    /// the least of their offsets, so that it does not matter which of them was struck.
    pub(super) fn place(&self, members: &mut [Member<S>], time: S) {
        let elapsed: Vec<S> = members
            .iter()
            .map(|member| {
                let others = members.iter().filter_map(|other| self.meeting(member, other, time));
                let cushions = self.system.faces.all.iter().enumerate();
                let cushions = cushions.filter_map(|(k, face)| self.cushion_meeting(member, k, face, time));
                others.chain(cushions).reduce(|a, b| if b < a { b } else { a }).unwrap_or(member.elapsed)
            })
            .collect();
        for (member, elapsed) in members.iter_mut().zip(elapsed) {
            *member = Member::new(&self.system, member.as_struck(elapsed));
        }
        members.sort_by(|a, b| by_place(a.position, b.position));
    }

    /// The time from the start of a member's flight to its contact with another, if that comes at `time`.
    fn meeting(&self, member: &Member<S>, other: &Member<S>, time: S) -> Option<S> {
        let radii = self.balls[member.ball].radius + self.balls[other.ball].radius;
        if member.ball == other.ball || radii == S::ZERO {
            return None;
        }
        let (a, b) = (&member.flight, &other.flight);
        let start = a.later_start(b);
        let (tolerance, mut seen) = (&self.system.tolerance, Surroundings::CLEAR);
        let shift = self.shift_between(member, other);
        let offset = detect_ball_ball([a, b], shift, radii, tolerance, false, &mut seen)?;
        (start + offset == time).then_some(start - a.start + offset)
    }

    /// By how much a member sees another elsewhere than that one's flight says.
    fn shift_between(&self, member: &Member<S>, other: &Member<S>) -> Option<Vec2<S>> {
        let image = self.system.nearest_image(other.position - member.position);
        let along =
            |axis: usize| image[axis] + i32::from(member.rounds[axis]) - i32::from(other.rounds[axis]);
        let rounds = [along(0), along(1)];
        (rounds != [0; 2]).then(|| self.system.shift(rounds))
    }

    /// The same for a cushion.
    fn cushion_meeting(&self, member: &Member<S>, number: usize, face: &Face<S>, time: S) -> Option<S> {
        if member.held_by.contains(&Some(number as u32)) {
            return None;
        }
        let radius = self.balls[member.ball].radius;
        let (tolerance, mut seen) = (self.system.tolerance.of(radius), Surroundings::CLEAR);
        let offset = detect_ball_cushion(&member.flight, radius, face, tolerance, false, &mut seen)?;
        (member.flight.start + offset == time).then_some(offset)
    }

    /// The gap between two balls in contact tolerances; infinite for two points.
    pub(super) fn ball_gap(&self, a: usize, position_a: Vec2<S>, b: usize, position_b: Vec2<S>) -> S {
        let radii = self.balls[a].radius + self.balls[b].radius;
        if radii == S::ZERO {
            return S::INFINITY;
        }
        (self.system.shortest(position_b - position_a).norm() - radii) / self.system.tolerance.of(radii)
    }
}
