//! Large gases, and what they cost: `cargo test --release -p carom --test gas -- --ignored --nocapture`.

use super::kit::{bidisperse, check, recipe};
use carom::gas::{Arrangement, Recipe, make};
use std::time::Instant;

fn report(recipe: &Recipe) {
    let begin = Instant::now();
    let start = make(recipe).unwrap_or_else(|error| panic!("{recipe:?}: {error}"));
    let seconds = begin.elapsed().as_secs_f64();
    check(recipe, &start);
    let Recipe { count, packing_fraction, start, .. } = recipe;
    println!("{count:8} at {packing_fraction} {start:?}: {seconds:.2} s");
}

#[test]
#[ignore = "takes a minute"]
fn what_ten_thousand_discs_cost() {
    use Arrangement::{Compressed, Hexagonal, Random, Square};
    for (fraction, start) in [(0.7, Square), (0.9, Hexagonal), (0.4, Random), (0.5, Random)] {
        report(&recipe(10_000, fraction, start));
    }
    for fraction in [0.5, 0.6, 0.7, 0.72, 0.8, 0.84] {
        report(&recipe(10_000, fraction, Compressed));
    }
    for fraction in [0.72, 0.8, 0.82, 0.84] {
        report(&Recipe { sizes: bidisperse(), ..recipe(10_000, fraction, Compressed) });
    }
}

#[test]
#[ignore = "takes minutes"]
fn a_million_discs_have_their_places() {
    use Arrangement::{Compressed, Hexagonal, Random, Square};
    for (fraction, start) in
        [(0.7, Square), (0.9, Hexagonal), (0.4, Random), (0.5, Random), (0.5, Compressed)]
    {
        let recipe = recipe(1_000_000, fraction, start);
        report(&recipe);
    }
}
