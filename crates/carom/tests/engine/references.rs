//! A run names the sources of the laws that acted in it, and of no others.

use crate::kit::bundled;
use crate::kit::scenes::{ball, rectangle, scenario};
use carom::law::{Reference, ball_ball, ball_cushion, cluster, collapse};
use carom::run::{Run, Steps};
use carom::scenario::schema::{BallBall, Cluster, Collapse, Record};
use carom::simulate::simulate;
use serde_json::{Value, json};

/// A ball that runs between the left and the right cushion, and another far from it.
fn run_of(physics: &Value, record: Record) -> Run<f64> {
    let balls = [ball(0.1, [0.5, 0.5], [1.0, 0.0]), ball(0.1, [1.0, 1.5], [0.0, 0.0])];
    let mut scenario = scenario(&rectangle(2.0, 2.0), physics, &balls);
    (scenario.duration, scenario.record) = (Some(5.0), Some(record));
    simulate(&scenario).unwrap()
}

fn lossy_cushions() -> Value {
    json!({ "ball_cushion": { "law": "damping", "factor": 0.9 } })
}

/// The laws of a run's sources, each once.
fn laws_of(run: &Run<f64>) -> Vec<&'static str> {
    let mut laws: Vec<_> = run.references().into_iter().map(|reference| reference.law).collect();
    laws.dedup();
    laws
}

#[test]
fn only_laws_that_acted_are_named() {
    assert_eq!(laws_of(&run_of(&lossy_cushions(), Record::All)), ["ball_cushion.restitution"]);
    assert_eq!(laws_of(&run_of(&json!({ "collapse": "tc" }), Record::All)), ["collapse.tc"]);
    let mut midterm = bundled("midterm");
    assert_eq!(laws_of(&simulate(&midterm).unwrap()), ["ball_cushion.restitution"]);
    midterm.physics.ball_ball = Some(BallBall::Restitution { normal: 0.9 });
    let both = ["ball_ball.restitution", "ball_cushion.restitution"];
    assert_eq!(laws_of(&simulate(&midterm).unwrap()), both);
    let stepped = ["ball_cushion.restitution", "method.stepped"];
    assert_eq!(laws_of(&simulate(&bundled("midterm_stepped")).unwrap()), stepped);
    let mut early = bundled("midterm");
    early.duration = Some(1e-3);
    assert_eq!(laws_of(&simulate(&early).unwrap()), [""; 0]);
}

#[test]
fn laws_without_loss_need_no_source() {
    assert_eq!(laws_of(&run_of(&json!({}), Record::All)), [""; 0]);
    assert_eq!(laws_of(&run_of(&json!({}), Record::None)), [""; 0]);
}

#[test]
fn a_cluster_law_is_named_where_balls_met_at_once() {
    let mut cradle = bundled("newtons_cradle");
    cradle.physics.collapse = Some(Collapse::Stop);
    assert!(laws_of(&simulate(&cradle).unwrap()).contains(&"cluster.reflections"));
    for (law, name) in [(Cluster::Pairwise, "cluster.pairwise"), (Cluster::Hertz, "cluster.hertz")] {
        cradle.physics.cluster = Some(law);
        assert!(laws_of(&simulate(&cradle).unwrap()).contains(&name));
    }
}

#[test]
fn a_run_without_events_names_the_laws_of_its_cushions() {
    assert_eq!(laws_of(&run_of(&lossy_cushions(), Record::None)), ["ball_cushion.restitution"]);
}

#[test]
fn every_law_says_where_it_comes_from() {
    let sources: [(&str, &[Reference]); 7] = [
        ("ball_ball", ball_ball::Law::<f64>::ELASTIC.references()),
        ("ball_cushion", ball_cushion::Law::<f64>::ELASTIC.references()),
        ("cluster", cluster::reflections::REFERENCES),
        ("cluster", cluster::hertz::REFERENCES),
        ("cluster", cluster::pairwise::REFERENCES),
        ("collapse", collapse::REFERENCES),
        ("method", Steps::<f64>::REFERENCES),
    ];
    for (kind, references) in sources {
        assert!(!references.is_empty(), "{kind}");
        for Reference { law, text, doi } in references {
            assert!(law.starts_with(kind) && text.len() > 20, "{law}: {text}");
            assert!(doi.is_none_or(|doi| doi.starts_with("10.")), "{law}: {doi:?}");
        }
    }
}
