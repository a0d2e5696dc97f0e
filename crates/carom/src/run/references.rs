//! The sources of the laws that a run used.

use super::{Kind, Run, Steps};
use crate::law::{Reference, ball_cushion, cluster, collapse};
use crate::scalar::Scalar;
use crate::scenario::schema::Cluster;

impl<S: Scalar> Run<S> {
    /// The sources of the laws that acted in the run, in the order of the laws' rooms.
    ///
    /// A law that takes no energy, in which both parts of a velocity keep their size, is any textbook's and names none.
    /// A run that kept no events does not know which cushions were hit: then the laws of all of them count, if any was.
    pub fn references(&self) -> Vec<&'static Reference> {
        let mut sources = Vec::new();
        if self.diagnostics.events[Kind::BallBall as usize] > 0 && !self.system.ball_ball.is_lossless() {
            sources.push(self.system.ball_ball.references());
        }
        let lossy = self.cushion_laws().filter(|law| !law.is_lossless());
        sources.extend(lossy.map(ball_cushion::Law::references));
        if self.diagnostics.cluster_passes > 0 {
            sources.push(match self.system.cluster {
                Cluster::Reflections => cluster::reflections::REFERENCES,
                Cluster::Hertz => cluster::hertz::REFERENCES,
                Cluster::Pairwise => cluster::pairwise::REFERENCES,
            });
        }
        if self.steps.is_some() {
            sources.push(Steps::<S>::REFERENCES);
        } else if self.system.collapse_is_elastic && self.diagnostics.collisions() > 0 {
            sources.push(collapse::REFERENCES);
        }
        let mut found = Vec::new();
        for reference in sources.into_iter().flatten() {
            if !found.contains(&reference) {
                found.push(reference);
            }
        }
        found
    }

    /// The laws of the cushions that were hit.
    fn cushion_laws(&self) -> impl Iterator<Item = &ball_cushion::Law<S>> {
        let laws = &self.system.cushion_laws;
        let any = self.diagnostics.events[Kind::BallCushion as usize] > 0;
        let mut is_hit = vec![any && !self.log.keeps_events; laws.len()];
        for event in self.log.events.iter().filter(|event| event.kind == Kind::BallCushion) {
            if let Some(cushion) = event.cushion {
                is_hit[cushion as usize] = true;
            }
        }
        laws.iter().zip(is_hit).filter_map(|(law, is_hit)| is_hit.then_some(law))
    }
}
