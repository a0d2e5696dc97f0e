//! The sources of the laws that a run used.

use super::{Dynamics, Kind, OnCloth, Run, Steps};
use crate::law::{Reference, ball_cushion, cloth, cluster, collapse, cue_ball};
use crate::scalar::Scalar;
use crate::scenario::schema::Cluster;

/// The source of the motion on a cloth: sliding, rolling, spinning.
const FLIGHT_ON_CLOTH: &[Reference] = &[Reference {
    law: "flight.cloth",
    text: "W. Leckie, M. Greenspan, An event-based pool physics simulator, Advances in Computer Games 2005, Lecture Notes in Computer Science 4250 (2006) 247–262",
    doi: Some("10.1007/11922155_19"),
}];

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
            sources.push(references_of(self.system.cluster));
        }
        if self.steps.is_some() {
            sources.push(Steps::<S>::REFERENCES);
        } else if self.system.collapse_is_elastic && self.diagnostics.collisions() > 0 {
            sources.push(collapse::REFERENCES);
        }
        without_repetition(sources)
    }

    /// The laws of the cushions that were hit.
    fn cushion_laws(&self) -> impl Iterator<Item = &ball_cushion::Law<S>> {
        let laws = &self.system.cushion_laws;
        laws.iter().zip(self.hit_cushions(laws.len())).filter_map(|(law, is_hit)| is_hit.then_some(law))
    }
}

impl<S: Scalar> Run<S, OnCloth> {
    /// The sources of the laws that acted in the run, in the order of the laws' rooms; as for discs, a law that takes no
    /// energy names none.
    pub fn references(&self) -> Vec<&'static Reference> {
        let (system, counts) = (&self.system, &self.diagnostics.events);
        let mut sources = vec![FLIGHT_ON_CLOTH];
        if counts[Kind::BallCloth as usize] > 0 {
            sources.push(cloth::REFERENCES);
        }
        if counts[Kind::CueBall as usize] > 0 {
            sources.push(cue_ball::REFERENCES);
        }
        if counts[Kind::BallBall as usize] > 0 && !system.ball_ball.is_lossless() {
            sources.push(system.ball_ball.references());
        }
        let laws = system.cushion_laws.iter().zip(self.hit_cushions(system.cushion_laws.len()));
        let lossy = laws.filter(|(law, is_hit)| *is_hit && !law.is_lossless());
        sources.extend(lossy.map(|(law, _)| law.references()));
        if self.diagnostics.clusters > 0 {
            sources.push(references_of(system.cluster));
        }
        without_repetition(sources)
    }
}

impl<S: Scalar, D: Dynamics<S>> Run<S, D> {
    /// Which cushions were hit; all, if any was and the run kept no events.
    fn hit_cushions(&self, count: usize) -> Vec<bool> {
        let any = self.diagnostics.events[Kind::BallCushion as usize] > 0;
        let mut is_hit = vec![any && !self.log.keeps_events; count];
        for event in self.log.events.iter().filter(|event| event.kind == Kind::BallCushion) {
            if let Some(cushion) = event.cushion {
                is_hit[cushion as usize] = true;
            }
        }
        is_hit
    }
}

fn references_of(cluster: Cluster) -> &'static [Reference] {
    match cluster {
        Cluster::Reflections => cluster::reflections::REFERENCES,
        Cluster::Hertz => cluster::hertz::REFERENCES,
        Cluster::Pairwise => cluster::pairwise::REFERENCES,
    }
}

fn without_repetition(sources: Vec<&'static [Reference]>) -> Vec<&'static Reference> {
    let mut found = Vec::new();
    for reference in sources.into_iter().flatten() {
        if !found.contains(&reference) {
            found.push(reference);
        }
    }
    found
}
