//! Rows that start again as they stand, without a scenario being made: shots, and laws of collision. Each has the bits of the
//! run that its numbers give by themselves, whatever the row before it was.

use carom::ensemble::{Design, Distribution, Ending, Ensemble, Inputs, Outcome, Source};
use carom::run::{Dynamics, Event, Kind, OnCloth, Plane, Run, Status};
use carom::scenario::Scenario;
use carom::simulate::{Simulated, simulate_until};

const JUMP: &str = include_str!("../../../../scenarios/jump_shot.toml");
const BREAK: &str = include_str!("../../../../scenarios/nine_ball_break.toml");
const MIDTERM: &str = include_str!("../../../../scenarios/midterm.toml");

/// A stroke in plain words at a ball that is not the first, with the offset of the tip's centre; on a table without pockets.
const PLAIN: &str = "
    [table]
    shape = 'rectangle'
    width = 1
    length = 2
    [physics]
    flight = { law = 'cloth' }
    ball_ball = { law = 'frictional', normal = 0.95, friction = 0.06 }
    ball_cushion = { law = 'han_2005', normal = 0.85, friction = 0.2 }
    cushions = { top = { law = 'restitution', normal = 0.5 } }
    [ball_defaults]
    radius = 0.03
    [[balls]]
    id = 'red'
    position = [0.5, 1.2]
    [[balls]]
    id = 'white'
    position = [0.5, 0.4]
    [shot]
    cue_ball = 'white'
    cue_speed = 2
    direction_deg = 85
    elevation_deg = 5
    left = 0.1
    top = 0.2
    offset_of = 'tip_center'
";

/// Without gravity how long a hop along a round cushion lasts depends on the speed of the stroke.
const WEIGHTLESS: &str = "
    duration = 3
    [table]
    shape = 'circle'
    radius = 0.5
    [physics]
    flight = { law = 'cloth', gravity = 0 }
    ball_cushion = { law = 'restitution', normal = 0.5 }
    [[balls]]
    id = 'cue'
    radius = 0.03
    position = [0.3, 0]
    [shot]
    V0 = 1
    phi_deg = 90
";

fn normal(mean: f64, standard_deviation: f64) -> Source {
    Source::Drawn(Distribution::Normal { mean, standard_deviation })
}

fn uniform(low: f64, high: f64) -> Source {
    Source::Drawn(Distribution::Uniform { low, high })
}

fn ensemble(text: &str, sources: &[(&str, Source)], rows: Option<u64>, outcomes: &[Outcome]) -> Ensemble {
    let sources = sources.iter().map(|(path, source)| ((*path).to_owned(), source.clone())).collect();
    let inputs = Inputs::new(sources, rows, Design::Independent, 4).unwrap();
    Ensemble::new(&Scenario::from_toml(text).unwrap(), inputs, outcomes).unwrap()
}

/// What a dynamics has in the columns of a ball, in the order of its numbers.
trait Shown: Simulated {
    const PARTS: &'static [&'static str];

    /// The numbers of a state that are shown; not a number for a ball out of play.
    fn shown(state: &Self::State) -> Vec<f64>;
}

impl Shown for Plane {
    const PARTS: &'static [&'static str] = &["x", "y", "vx", "vy"];

    fn shown(state: &Self::State) -> Vec<f64> {
        <Self as Dynamics<f64>>::numbers(state).collect()
    }
}

impl Shown for OnCloth {
    const PARTS: &'static [&'static str] = &["x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"];

    fn shown(state: &Self::State) -> Vec<f64> {
        let numbers = <Self as Dynamics<f64>>::numbers(state).skip(1);
        numbers.map(|number| if state.motion.is_out() { f64::NAN } else { number }).collect()
    }
}

fn outcomes(is_on_cloth: bool) -> Vec<Outcome> {
    let of_cloth = [Outcome::FinalSpin, Outcome::Pockets];
    Outcome::ALL.into_iter().filter(|outcome| is_on_cloth || !of_cloth.contains(outcome)).collect()
}

/// How many rows ended, and how many did not begin, for each of which that is checked against its own run.
#[derive(Debug, Default)]
struct Seen {
    rejected: usize,
    miscues: usize,
    pocketed: usize,
    airborne: usize,
}

/// Runs all rows in turn on one thread, and each by itself.
fn check_rows<D: Shown>(ensemble: &Ensemble) -> Seen {
    let rows = ensemble.inputs().rows();
    let table = ensemble.run(0..rows, Some(1), &mut |_| false).unwrap();
    let mut seen = Seen::default();
    for row in 0..rows as usize {
        let of = |name: &str| {
            let place = ensemble.columns().iter().position(|column| column.name == name);
            table.columns[place.unwrap_or_else(|| panic!("no column {name}"))][row].to_bits()
        };
        let scenario = match ensemble.scenario(row as u64) {
            Ok(scenario) => scenario,
            Err(error) => {
                seen.rejected += 1;
                assert_eq!(table.endings[row], Ending::Rejected, "{row}");
                assert!(table.problems.contains(&(row as u64, error.to_string())), "{row}: {error}");
                assert!(table.columns.iter().all(|column| column[row].is_nan()), "{row}");
                continue;
            }
        };
        let run: Run<f64, D> = simulate_until(&scenario, None, &mut || false).unwrap();
        assert_eq!(table.endings[row], Ending::Ended(run.status), "{row}");
        assert_eq!(of("end_time"), run.end_time.to_bits(), "{row}");
        let time = |event: Option<&Event<f64>>| event.map_or(f64::NAN, |event| event.time).to_bits();
        assert_eq!(of("first_event"), time(run.log.events.first()), "{row}");
        assert_eq!(of("last_event"), time(run.log.events.last()), "{row}");
        for kind in Kind::ALL.into_iter().filter(|kind| kind.happens(scenario.has_cloth())) {
            let count = run.log.events.iter().filter(|event| event.kind == kind).count();
            assert_eq!(of(&format!("events.{}", kind.name())), (count as f64).to_bits(), "{row}: {kind:?}");
        }
        let ends = run.final_state();
        for (id, end) in D::ball_ids(&run.system).iter().zip(&ends) {
            let found: Vec<u64> = D::PARTS.iter().map(|part| of(&format!("{id}.{part}"))).collect();
            let expected: Vec<u64> = D::shown(end).into_iter().map(f64::to_bits).collect();
            assert_eq!(found, expected, "{row}: {id}");
        }
        let of_kind = |kind: Kind| run.log.events.iter().filter(move |event| event.kind == kind);
        for event in of_kind(Kind::BallPocket) {
            let name = format!("{}.pocket", D::ball_ids(&run.system)[event.ball_a as usize]);
            assert!(f64::from_bits(of(&name)) >= 0.0, "{row}: {name}");
            seen.pocketed += 1;
        }
        seen.miscues += usize::from(run.status == Status::Miscue);
        seen.airborne += of_kind(Kind::BallCloth).count();
    }
    seen
}

#[test]
fn a_break_under_noise_is_a_break_by_itself() {
    let sources = [
        ("shot.V0", normal(8.0, 0.5)),
        ("shot.phi_deg", normal(96.3, 0.5)),
        ("shot.theta_deg", uniform(0.0, 3.0)),
        ("shot.a", normal(0.0, 0.05)),
        ("shot.b", normal(0.1, 0.05)),
    ];
    let mut outcomes = outcomes(true);
    outcomes.push(Outcome::ClosestApproach(["cue".into(), "9".into()]));
    let seen = check_rows::<OnCloth>(&ensemble(BREAK, &sources, Some(150), &outcomes));
    assert!(seen.pocketed > 50 && seen.rejected == 0, "{seen:?}");
}

#[test]
fn rows_do_not_depend_on_the_rows_before_them() {
    // Sound, miscue, missing the ball, backwards, below the cloth, too steep, no number, too small a number, sound again.
    let speeds = [3.0, 3.0, 3.0, -1.0, 3.0, 3.0, f64::NAN, 1e-80, 3.0, 1e-75, 0.0, 4.0];
    let elevations = [40.0, 40.0, 40.0, 40.0, -2.0, 91.0, 40.0, 40.0, 40.0, 30.0, 30.0, 0.0];
    let left = [0.0, 0.6, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.3];
    let top = [0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.3];
    let given = |numbers: &[f64]| Source::Given(numbers.iter().copied().cycle().take(48).collect());
    let sources = [
        ("shot.V0", given(&speeds)),
        ("shot.theta_deg", given(&elevations)),
        ("shot.a", given(&left)),
        ("shot.b", given(&top)),
    ];
    let seen = check_rows::<OnCloth>(&ensemble(JUMP, &sources, None, &outcomes(true)));
    assert!(seen.rejected == 4 * 6 && seen.miscues == 4 && seen.airborne > 4 * 3, "{seen:?}");
}

#[test]
fn jump_shots_of_all_kinds() {
    let sources = [
        ("shot.V0", normal(3.0, 2.0)),
        ("shot.phi_deg", uniform(-180.0, 180.0)),
        ("shot.theta_deg", uniform(-5.0, 95.0)),
        ("shot.a", normal(0.0, 0.3)),
        ("shot.b", normal(0.0, 0.3)),
    ];
    let seen = check_rows::<OnCloth>(&ensemble(JUMP, &sources, Some(400), &outcomes(true)));
    assert!(seen.rejected > 40 && seen.miscues > 40 && seen.airborne > 200 && seen.pocketed > 20, "{seen:?}");
}

#[test]
fn strokes_in_plain_words_and_laws_on_a_cloth() {
    let shot = [
        ("shot.cue_speed", normal(2.0, 1.0)),
        ("shot.direction_deg", normal(85.0, 20.0)),
        ("shot.elevation_deg", uniform(-1.0, 20.0)),
        ("shot.left", normal(0.0, 0.3)),
        ("shot.top", normal(0.0, 0.3)),
    ];
    let laws = [
        ("physics.ball_ball.normal", uniform(0.9, 1.02)),
        ("physics.ball_ball.friction", uniform(-0.01, 0.1)),
        ("physics.ball_ball.cling", uniform(0.5, 2.0)),
        ("physics.ball_cushion.normal", uniform(0.7, 0.9)),
        ("physics.ball_cushion.friction", uniform(0.1, 0.3)),
        ("physics.cushions.top.normal", uniform(0.2, 0.8)),
        ("physics.cushions.top.tangential", uniform(0.5, 1.0)),
    ];
    for sources in [&shot[..], &laws[..], &[shot.clone().to_vec(), laws.to_vec()].concat()] {
        let seen = check_rows::<OnCloth>(&ensemble(PLAIN, sources, Some(200), &outcomes(true)));
        assert!(seen.rejected > 5 && seen.rejected < 150, "{seen:?}");
    }
}

#[test]
fn without_gravity_the_times_of_hops_are_those_of_the_stroke() {
    let sources = [("shot.V0", uniform(0.2, 3.0))];
    check_rows::<OnCloth>(&ensemble(WEIGHTLESS, &sources, Some(20), &outcomes(true)));
}

#[test]
fn laws_of_discs() {
    let both = "
        physics.ball_ball.law = 'restitution'
        physics.ball_ball.normal = 0.9
        physics.cushions.left = { law = 'damping', factor = 0.5 }
    ";
    let text = MIDTERM.replace("[physics.ball_ball]\nlaw = \"elastic\"", "");
    let text = text.replacen("duration", &format!("{both}\nduration"), 1);
    let sources = [
        ("physics.ball_ball.normal", uniform(0.5, 1.05)),
        ("physics.ball_cushion.factor", uniform(0.5, 1.05)),
        ("physics.cushions.left.factor", uniform(-0.05, 1.0)),
        ("balls.red.speed", normal(5.0, 2.0)),
    ];
    let seen = check_rows::<Plane>(&ensemble(&text, &sources, Some(400), &outcomes(false)));
    assert!(seen.rejected > 40 && seen.rejected < 200, "{seen:?}");
}
