//! Rows of an ensemble that start again as they stand ask for no memory.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
// An allocator cannot be written without; this one hands everything on to the system's.
#![allow(unsafe_code)]

use carom::ensemble::{Design, Distribution, Ensemble, Inputs, Outcome, Source};
use carom::scenario::Scenario;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicU64, Ordering};

struct Counting;

static ALLOCATIONS: AtomicU64 = AtomicU64::new(0);

// SAFETY: all is done by the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: as for this function.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as for this function.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// How often memory is asked for in so many rows, on one thread.
fn allocations(ensemble: &Ensemble, rows: u64) -> u64 {
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    ensemble.run(0..rows, Some(1), &mut |_| false).unwrap();
    ALLOCATIONS.load(Ordering::Relaxed) - before
}

/// How much oftener in 2000 rows than in 1000. What is asked for besides is for the lists of parts of the table.
fn in_a_thousand_more(text: &str, sources: &[(&str, f64, f64)], outcomes: &[Outcome]) -> u64 {
    let source = |&(path, low, high): &(&str, f64, f64)| {
        (path.to_owned(), Source::Drawn(Distribution::Uniform { low, high }))
    };
    let sources = sources.iter().map(source).collect();
    let inputs = Inputs::new(sources, Some(2000), Design::Independent, 0).unwrap();
    let ensemble = Ensemble::new(&Scenario::from_toml(text).unwrap(), inputs, outcomes).unwrap();
    allocations(&ensemble, 2000).saturating_sub(allocations(&ensemble, 1000))
}

/// One test, since all of a process count together.
#[test]
fn a_thousand_more_rows_ask_for_no_more_memory() {
    let midterm = include_str!("../../../scenarios/midterm.toml");
    let shot = include_str!("../../../scenarios/two_ball_shot.toml");
    let nine_balls = include_str!("../../../scenarios/nine_ball_break.toml");
    let all = Outcome::ALL;
    let of_discs = [Outcome::FinalPosition, Outcome::Events, Outcome::Distance];
    let velocities = [("balls.red.speed", 1.0, 9.0), ("balls.red.direction_deg", 0.0, 90.0)];
    let laws = [("physics.ball_cushion.factor", 0.5, 1.0)];
    let strokes = [("shot.V0", 1.0, 3.0), ("shot.a", -0.3, 0.3), ("shot.theta_deg", 0.0, 5.0)];
    let breaks = [("shot.V0", 7.0, 9.0), ("shot.phi_deg", 96.0, 97.0), ("shot.b", 0.0, 0.2)];
    let more = [
        ("velocities", in_a_thousand_more(midterm, &velocities, &of_discs)),
        ("laws", in_a_thousand_more(midterm, &laws, &of_discs)),
        ("strokes", in_a_thousand_more(shot, &strokes, &all)),
        ("breaks", in_a_thousand_more(nine_balls, &breaks, &all)),
    ];
    assert!(more.iter().all(|(_, count)| *count < 200), "{more:?}");
}
