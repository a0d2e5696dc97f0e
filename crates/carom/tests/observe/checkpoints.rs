//! Observed runs that hand out snapshots and events, and are broken off, written down and gone on with.

use carom::geometry::Vec2;
use carom::observe::{Observables, Request, Results};
use carom::random::Random;
use carom::run::{Digest, Event, Kind, PHYSICS_VERSION, VERSION};
use carom::scenario::Scenario;
use carom::simulate::{
    Checkpoint, CheckpointError, ObservedError, ObservedRun, Pause, Plan, Sampling, Snapshots, Window,
    simulate,
};
use serde_json::{Value, json};

/// What a run gave, to the last bit.
#[derive(Clone, Debug, PartialEq)]
struct Outcome {
    digest: Option<Digest>,
    status: &'static str,
    results: String,
    frames: Vec<Frame>,
    events: Vec<(u64, Event<f64>)>,
    kept: Vec<Event<f64>>,
}

#[derive(Clone, Debug, PartialEq)]
struct Frame {
    time: f64,
    collisions: u64,
    positions: Vec<Vec2<f64>>,
    velocities: Vec<Vec2<f64>>,
}

/// Files that a run writes: what was handed out and not yet gone on from may be cut off again.
#[derive(Default)]
struct Files {
    frames: Vec<Frame>,
    /// With their numbers.
    events: Vec<(u64, Event<f64>)>,
}

impl Files {
    fn take(&mut self, pause: Pause, run: &mut ObservedRun) {
        match pause {
            Pause::Snapshot => {
                let collisions = run.progress().collisions;
                let snapshot = run.snapshot();
                let (positions, velocities) = (snapshot.positions.to_vec(), snapshot.velocities.to_vec());
                self.frames.push(Frame { time: snapshot.time, collisions, positions, velocities });
            }
            Pause::Events => {
                let (events, first) = run.events();
                self.events.extend((first..).zip(events.iter().copied()));
            }
            Pause::Progress | Pause::Ended => {}
        }
    }

    fn cut(&mut self, checkpoint: &Checkpoint) {
        let (frames, events) = checkpoint.handed_out();
        assert!(self.frames.len() as u64 >= frames && self.events.len() as u64 >= events);
        self.frames.truncate(frames as usize);
        self.events.truncate(events as usize);
    }
}

fn gas(more: &Value) -> Scenario {
    super::observed_runs::gas(100, 0.45, more)
}

/// The same with walls across, in which discs of two masses start on a lattice: many contacts at one instant.
fn clustered(more: &Value) -> Scenario {
    let ball = |k: usize| {
        let place = [0.5 + (k % 8) as f64, 0.5 + (k / 8) as f64 * 1.2];
        json!({ "id": format!("d{k}"), "radius": 0.5, "mass": 1 + k % 2, "position": place,
            "velocity": [0.0, if k / 8 == 3 { -1.5 } else { 0.25 * (k % 3) as f64 }] })
    };
    let mut values = json!({
        "table": { "shape": "rectangle", "width": 8.5, "length": 9.6, "periodic": ["y"] },
        "balls": (0..64).map(ball).collect::<Vec<_>>(),
        "record": "none",
    });
    for (key, value) in more.as_object().unwrap() {
        values[key] = value.clone();
    }
    Scenario::from_json(&values.to_string()).unwrap()
}

fn observables() -> Observables {
    let names = ["pressure", "free_path", "diffusion", "psi6", "kinetic_energy"];
    let near = Request::new("radial_distribution").with("range", 3.0);
    Observables::new(&[&names.map(Request::new)[..], &[near]].concat()).unwrap()
}

fn plan() -> Plan {
    Plan {
        sampling: Sampling { equilibrate: 7.0, interval: None },
        snapshots: Snapshots::EveryTime(0.3),
        window: Some(Window { from: 0.0, to: 1e9 }),
    }
}

fn text(results: &[Results]) -> String {
    format!("{results:?}")
}

fn outcome(run: ObservedRun, files: Files) -> Outcome {
    let (run, observables) = run.finish().unwrap();
    let results = text(&observables.results());
    let (digest, status, kept) = (run.digest(), run.status.name(), run.log.events);
    Outcome { digest, status, results, frames: files.frames, events: files.events, kept }
}

fn whole(scenario: &Scenario, plan: &Plan) -> Outcome {
    let mut files = Files::default();
    let mut run = ObservedRun::new(scenario, None, observables(), plan.clone()).unwrap();
    loop {
        let pause = run.advance().unwrap();
        files.take(pause, &mut run);
        if pause == Pause::Ended {
            return outcome(run, files);
        }
    }
}

/// The same run, thrown away at random pauses and gone on with from the last checkpoint.
fn in_pieces(scenario: &Scenario, plan: &Plan, seed: u64) -> Outcome {
    let mut random = Random::new(seed, "pieces");
    let mut files = Files::default();
    let mut run = ObservedRun::new(scenario, None, observables(), plan.clone()).unwrap();
    let mut saved = run.checkpoint("").unwrap();
    loop {
        let pause = run.advance().unwrap();
        let is_written = random.unit() < 0.7;
        if is_written {
            files.take(pause, &mut run);
        }
        if random.unit() < 0.4 {
            saved = run.checkpoint("").unwrap();
        } else if pause == Pause::Ended {
            return outcome(run, files);
        }
        // What was not written is lost with the process.
        if !is_written || random.unit() < 0.3 {
            let checkpoint = Checkpoint::from_bytes(&saved).unwrap();
            files.cut(&checkpoint);
            run = ObservedRun::resume(checkpoint, &[]).unwrap();
        }
    }
}

#[test]
fn a_run_in_pieces_is_the_run_at_once() {
    let scenarios = [
        gas(&json!({ "collisions": 30_000 })),
        gas(&json!({ "duration": 20.0, "record": "events" })),
        clustered(&json!({ "collisions": 20_000 })),
    ];
    let ways = [
        plan(),
        Plan { snapshots: Snapshots::EveryCollisions(777), ..plan() },
        Plan {
            sampling: Sampling { equilibrate: 0.0, interval: Some(0.17) },
            snapshots: Snapshots::At(vec![0.0, 0.17, 1.0, 5.5]),
            window: Some(Window { from: 1.0, to: 2.5 }),
        },
    ];
    for scenario in &scenarios {
        let alone = simulate(scenario).unwrap();
        for plan in &ways {
            let at_once = whole(scenario, plan);
            assert_eq!(at_once.digest, alone.digest());
            assert_eq!(at_once.kept, alone.log.events);
            assert!(at_once.frames.len() > 3 && !at_once.events.is_empty());
            for seed in 1..4 {
                assert_eq!(in_pieces(scenario, plan, seed), at_once, "seed {seed}, {plan:?}");
            }
        }
    }
}

#[test]
fn looking_often_changes_no_sample() {
    let scenario = clustered(&json!({ "collisions": 20_000 }));
    let often = Plan { snapshots: Snapshots::EveryTime(0.01), ..plan() };
    let never = Plan { snapshots: Snapshots::Never, window: None, ..plan() };
    let (one, other) = (whole(&scenario, &often), whole(&scenario, &never));
    assert_eq!((one.digest, one.results), (other.digest, other.results));
}

#[test]
fn snapshots_are_the_states_of_the_run_at_their_times() {
    let scenario = gas(&json!({ "duration": 4.0, "record": "all" }));
    let run = simulate(&scenario).unwrap();
    let found =
        whole(&scenario, &Plan { sampling: Sampling { equilibrate: 0.0, interval: Some(0.5) }, ..plan() });
    let times: Vec<f64> = found.frames.iter().map(|frame| frame.time).collect();
    assert_eq!(times, (0..14).map(|k| 0.3 * f64::from(k)).collect::<Vec<_>>());
    for frame in &found.frames {
        let states = run.state(frame.time).unwrap();
        let before = run.log.events.iter().filter(|event| event.time <= frame.time);
        assert_eq!(frame.collisions, before.count() as u64);
        for (state, position) in states.iter().zip(&frame.positions) {
            assert!((state.position - *position).norm() < 1e-12);
        }
        assert!(states.iter().map(|state| state.velocity).eq(frame.velocities.iter().copied()));
    }
    assert_eq!(found.events, (0..).zip(run.log.events).collect::<Vec<_>>());
}

#[test]
fn snapshots_come_after_so_many_collisions_the_first_and_the_last_too() {
    let plan = Plan { snapshots: Snapshots::EveryCollisions(1000), ..plan() };
    let found = whole(&gas(&json!({ "collisions": 9000 })), &plan);
    let counts: Vec<u64> = found.frames.iter().map(|frame| frame.collisions).collect();
    assert_eq!(counts, (0..10).map(|k| 1000 * k).collect::<Vec<_>>());
}

#[test]
fn a_window_has_the_events_of_its_time_with_their_numbers() {
    let scenario = gas(&json!({ "duration": 4.0, "record": "events" }));
    let sampling = Sampling { equilibrate: 0.0, interval: Some(0.5) };
    let found = whole(&scenario, &Plan { window: Some(Window { from: 1.0, to: 2.0 }), sampling, ..plan() });
    let kept = simulate(&scenario).unwrap().log.events;
    let within: Vec<_> =
        (0..).zip(kept).filter(|(_, event)| event.time >= 1.0 && event.time <= 2.0).collect();
    assert!(within.len() > 100);
    assert_eq!(found.events, within);
}

#[test]
fn a_run_that_ended_goes_on_to_a_later_end() {
    for (short, long) in [
        (json!({ "collisions": 12_345 }), json!({ "collisions": 30_000 })),
        (json!({ "duration": 6.5 }), json!({ "duration": 15.0 })),
        (json!({ "duration": 0.5 }), json!({ "duration": 15.0 })),
    ] {
        for plan in [plan(), Plan { snapshots: Snapshots::EveryCollisions(500), ..plan() }] {
            let mut files = Files::default();
            let mut run = ObservedRun::new(&gas(&short), None, observables(), plan.clone()).unwrap();
            while {
                let pause = run.advance().unwrap();
                files.take(pause, &mut run);
                pause != Pause::Ended
            } {}
            let saved = run.checkpoint("a note").unwrap();
            let checkpoint = Checkpoint::from_bytes(&saved).unwrap();
            assert_eq!(checkpoint.note(), "a note");
            files.cut(&checkpoint);
            let values: Vec<_> =
                long.as_object().unwrap().iter().map(|(key, value)| (key.clone(), value.clone())).collect();
            let mut run = ObservedRun::resume(checkpoint, &values).unwrap();
            while {
                let pause = run.advance().unwrap();
                files.take(pause, &mut run);
                pause != Pause::Ended
            } {}
            assert_eq!(outcome(run, files), whole(&gas(&long), &plan), "{short} {long}");

            // Without a later end it has ended still, once more in the same way.
            let mut again = ObservedRun::resume(Checkpoint::from_bytes(&saved).unwrap(), &[]).unwrap();
            assert_eq!(again.advance().unwrap(), Pause::Ended);
            assert_eq!(again.simulation().time(), Checkpoint::from_bytes(&saved).unwrap().time());
        }
    }
}

#[test]
fn the_first_event_of_a_kind_ends_a_run_that_goes_on_too() {
    let scenario = clustered(&json!({ "duration": 50.0, "record": "events" }));
    let plan = Plan { window: None, ..plan() };
    let mut run = ObservedRun::new(&scenario, Some(Kind::BallCushion), observables(), plan).unwrap();
    run.advance().unwrap();
    let checkpoint = Checkpoint::from_bytes(&run.checkpoint("").unwrap()).unwrap();
    let mut run = ObservedRun::resume(checkpoint, &[]).unwrap();
    while run.advance().unwrap() != Pause::Ended {}
    let events = match run.finish() {
        Ok((run, _)) => run.log.events,
        Err(ObservedError::TooShort { status, .. }) => return assert_eq!(status.name(), "stopped"),
        Err(error) => panic!("{error}"),
    };
    assert_eq!(events.iter().filter(|event| event.kind == Kind::BallCushion).count(), 1);
}

#[test]
fn without_observables_there_are_no_samples_and_a_run_may_be_short() {
    let nothing = Observables::new(&[]).unwrap();
    let plan = Plan { snapshots: Snapshots::At(vec![0.01]), ..Plan::default() };
    let mut run = ObservedRun::new(&gas(&json!({ "collisions": 50 })), None, nothing, plan).unwrap();
    assert_eq!(run.advance().unwrap(), Pause::Snapshot);
    assert_eq!(run.snapshot().time, 0.01);
    assert_eq!(run.advance().unwrap(), Pause::Ended);
    assert_eq!(run.progress().samples, 0);
    assert!(run.finish().is_ok());
}

#[test]
fn plans_that_are_none_are_refused() {
    let place =
        |plan: Plan| match ObservedRun::new(&gas(&json!({ "duration": 1.0 })), None, observables(), plan) {
            Err(ObservedError::Unfit(problem)) => problem.place,
            _ => panic!("accepted"),
        };
    let with = |snapshots: Snapshots| place(Plan { snapshots, ..plan() });
    for interval in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(with(Snapshots::EveryTime(interval)), "snapshots.every_time");
    }
    assert_eq!(with(Snapshots::EveryCollisions(0)), "snapshots.every_collisions");
    for times in [vec![], vec![-1.0], vec![1.0, 1.0], vec![2.0, 1.0], vec![f64::NAN]] {
        assert_eq!(with(Snapshots::At(times)), "snapshots.at");
    }
    for (from, to) in [(2.0, 1.0), (-1.0, 1.0), (f64::NAN, 1.0), (0.0, f64::NAN)] {
        assert_eq!(place(Plan { window: Some(Window { from, to }), ..plan() }), "events.window");
    }
}

fn saved() -> Vec<u8> {
    let mut run =
        ObservedRun::new(&gas(&json!({ "collisions": 200_000 })), None, observables(), plan()).unwrap();
    for _ in 0..20 {
        run.advance().unwrap();
    }
    run.checkpoint("a note").unwrap()
}

fn refusal(bytes: &[u8]) -> CheckpointError {
    match Checkpoint::from_bytes(bytes) {
        Err(error) => error,
        Ok(_) => panic!("accepted"),
    }
}

/// Puts other bytes into the header, with a checksum that fits, as another version would.
fn of_another_version(place: usize, value: u32) -> Vec<u8> {
    use sha2::{Digest as _, Sha256};
    let mut bytes = saved();
    bytes[place..place + 4].copy_from_slice(&value.to_le_bytes());
    bytes[16..21].copy_from_slice(b"7.8.9");
    let sum: [u8; 32] = Sha256::new().chain_update(&bytes[..48]).chain_update(&bytes[80..]).finalize().into();
    bytes[48..80].copy_from_slice(&sum);
    bytes
}

#[test]
fn a_checkpoint_with_a_flipped_bit_or_cut_short_is_refused() {
    let bytes = saved();
    assert!(Checkpoint::from_bytes(&bytes).is_ok());
    let mut random = Random::new(11, "bits");
    let places = (0..80).chain((0..400).map(|_| (random.unit() * bytes.len() as f64) as usize));
    for place in places.collect::<Vec<_>>() {
        let mut flipped = bytes.clone();
        flipped[place] ^= 1 << (place % 8);
        let error = refusal(&flipped);
        match place {
            0..8 => assert!(matches!(error, CheckpointError::Foreign), "{error}"),
            40..48 => assert!(
                matches!(error, CheckpointError::CutShort { .. } | CheckpointError::TooLong { .. }),
                "{error}"
            ),
            _ => assert!(matches!(error, CheckpointError::Damaged), "{place}: {error}"),
        }
    }
    for length in [8, 79, 80, 81, bytes.len() / 2, bytes.len() - 1] {
        let error = refusal(&bytes[..length]);
        assert!(error.to_string().contains(&format!("cut short: it has {length} of")), "{error}");
    }
    assert!(matches!(refusal(b""), CheckpointError::Foreign));
    assert!(matches!(refusal(b"{\"format\": 1}"), CheckpointError::Foreign));
    assert!(matches!(refusal(&[&bytes[..], &[0]].concat()), CheckpointError::TooLong { .. }));
}

#[test]
fn another_version_is_named() {
    let format = refusal(&of_another_version(8, 99)).to_string();
    assert!(format.contains("in format 99, written by carom 7.8.9"), "{format}");
    assert!(format.contains(&format!("this is carom {VERSION}, which reads format ")), "{format}");
    let physics = refusal(&of_another_version(12, PHYSICS_VERSION + 1)).to_string();
    assert!(
        physics.contains(&format!("physics version {} of carom 7.8.9", PHYSICS_VERSION + 1)),
        "{physics}"
    );
    assert!(physics.contains(&format!("this is version {PHYSICS_VERSION}")), "{physics}");
}

#[test]
fn new_ends_that_do_not_fit_are_refused() {
    let resumed = |key: &str, value: Value| {
        let checkpoint = Checkpoint::from_bytes(&saved()).unwrap();
        ObservedRun::resume(checkpoint, &[(key.to_owned(), value)]).err().unwrap().to_string()
    };
    assert!(resumed("duration", json!(0.1)).contains("duration: the run has come to"));
    assert!(resumed("duration", json!(-1.0)).contains("duration"));
    assert!(resumed("max_events", json!(10)).contains("duration: missing"));
}
