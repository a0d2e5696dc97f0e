//! debug
use carom::run::OnCloth;
use carom::scenario::Scenario;
use carom::simulate::start;
fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap();
    let scenario = Scenario::from_json(&text).unwrap();
    let (mut sim, mut log) = start::<OnCloth>(&scenario, None);
    let mut gain = 0.0;
    loop {
        let n = log.events.len();
        let before = sim.state();
        let go = sim.step(&mut log).unwrap();
        let g = sim.diagnostics().energy_gain;
        if g > gain * 1.0001 && g > 1e-12 {
            gain = g;
            println!("gain {g:e} of {}", sim.diagnostics().initial_energy);
            for e in &log.events[n..] {
                println!("  {e:?}");
                for b in [Some(e.ball_a), e.ball_b].into_iter().flatten() {
                    println!(
                        "   {b} before {:?}\n     after {:?}",
                        before[b as usize],
                        sim.state()[b as usize]
                    );
                }
            }
        }
        if !go {
            break;
        }
    }
}
