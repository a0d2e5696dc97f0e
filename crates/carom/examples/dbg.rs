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
    let n = log.events.len().saturating_sub(4);
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
        for b in [Some(e.ball_a), e.ball_b].into_iter().flatten() {
            let f: Vec<_> = log.flights.iter().filter(|(k, _)| *k == b).collect();
            let l = f.len();
            for k in [l - 2, l - 1] {
                println!("   {b} {:?}", f[k].1);
            }
        }
    }
}
