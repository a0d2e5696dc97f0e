//! debug
use carom::run::OnCloth;
use carom::scenario::Scenario;
use carom::simulate::start;
fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap();
    let scenario = Scenario::from_json(&text).unwrap();
    let (mut sim, mut log) = start::<OnCloth>(&scenario, None);
    while sim.step(&mut log).unwrap() {}
    println!("{:?} {} events", sim.status(), log.events.len());
    let n = log.events.len().saturating_sub(24);
    for e in &log.events[n..] {
        println!(
            "{:.14} {} {} {:?} c{:?} v={:e} J={:e} cl={:?}",
            e.time,
            e.kind.name(),
            e.ball_a,
            e.ball_b,
            e.cushion,
            e.closing_speed,
            e.impulse,
            e.cluster
        );
    }
    for (k, s) in sim.state().iter().enumerate() {
        println!("{k} {:?} {:?} v={:?} w={:?}", s.motion, s.position, s.twist.velocity, s.twist.spin);
    }
}
