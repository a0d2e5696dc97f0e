//! debug
use carom::run::OnCloth;
use carom::scenario::Scenario;
use carom::simulate::start;
fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap();
    let scenario = Scenario::from_json(&text).unwrap();
    let (mut sim, mut log) = start::<OnCloth>(&scenario, None);
    while sim.step(&mut log).unwrap() {}
    println!("{:?} {} events {:?}", sim.status(), log.events.len(), sim.diagnostics());
    let n = log.events.len().saturating_sub(60);
    for e in &log.events[n..] {
        println!(
            "{:.12} {} {} {:?} v={:e} J={:e} cl={:?}",
            e.time,
            e.kind.name(),
            e.ball_a,
            e.ball_b,
            e.closing_speed,
            e.impulse,
            e.cluster
        );
    }
}
