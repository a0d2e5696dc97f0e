//! The contacts of a cluster: what its balls touch.

use super::{Contact, Member, by_place, is_same_direction};
use crate::detect::cushion_gap;
use crate::engine::Discs;
use crate::geometry::Vec2;
use crate::model::Face;
use crate::scalar::Scalar;

/// Between balls of one cluster, a gap up to this many contact tolerances counts as a contact: so a ball aimed at the
/// middle of a touching pair, and off by a hair, still strikes both at once.
const HAIR: f64 = 1e4;

impl<S: Scalar> Discs<S> {
    /// All contacts of the members, in order of place.
    pub(super) fn contacts(&self, members: &[Member<S>]) -> Vec<Contact<S>> {
        let mut contacts = Vec::new();
        for (first, a) in members.iter().enumerate() {
            for (second, b) in members.iter().enumerate().skip(first + 1) {
                if self.ball_gap(a.ball, a.position, b.ball, b.position) <= S::from_f64(HAIR) {
                    let normal = self.system.shortest(b.position - a.position).unit();
                    let point = a.position + normal * self.balls[a.ball].radius;
                    contacts.push(Contact { members: (first, Some(second)), cushion: None, point, normal });
                }
            }
            self.add_cushions(first, a, &mut contacts);
        }
        contacts.sort_by(|a, b| by_place(a.point, b.point).then(by_place(a.normal, b.normal)));
        contacts
    }

    fn add_cushions(&self, place: usize, member: &Member<S>, contacts: &mut Vec<Contact<S>>) {
        let radius = self.balls[member.ball].radius;
        let tolerance = self.system.tolerance.of(radius);
        let first = contacts.len();
        for (number, cushion) in self.system.faces.all.iter().enumerate() {
            let Some(gap) = cushion_gap(member.position, radius, cushion, &self.system.tolerance) else {
                continue;
            };
            if gap.abs() > tolerance || self.is_other_side(member, number as u32) {
                continue;
            }
            let normal = -cushion.normal_at(member.position).0;
            let point = cushion.foot(member.position);
            let contact = Contact { members: (place, None), cushion: Some(number as u32), point, normal };
            // Where two pieces of one smooth boundary meet, the ball touches once: the one that begins further left.
            match contacts[first..].iter_mut().find(|c| is_same_direction(c.normal, normal)) {
                Some(same) if self.begins_before(contact.cushion, same.cushion) => *same = contact,
                Some(_) => {}
                None => contacts.push(contact),
            }
        }
    }

    fn begins_before(&self, a: Option<u32>, b: Option<u32>) -> bool {
        let begin = |cushion: u32| match &self.system.faces.all[cushion as usize] {
            Face::Line(line) => line.start,
            Face::Round(round) => round.arc.center + round.arc.from * round.arc.radius,
        };
        matches!((a, b), (Some(a), Some(b)) if by_place(begin(a), begin(b)).is_lt())
    }

    /// Whether a cushion is the other face of a thin wall that a point is at, since the point came from across it.
    fn is_other_side(&self, member: &Member<S>, cushion: u32) -> bool {
        let back = self.system.backs[cushion as usize];
        if back.is_none() || self.balls[member.ball].radius > S::ZERO {
            return false;
        }
        let track = &self.rest[member.ball].track;
        let has_stayed = member.elapsed == S::ZERO && track.arrival != Vec2::ZERO;
        let arrival = if has_stayed { track.arrival } else { member.before };
        (has_stayed && track.last_cushion == back) || self.is_across(cushion, arrival, member.position)
    }
}
