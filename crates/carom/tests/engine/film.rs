//! What a film says of a moment has the bits of the run's own state.

use crate::kit::random::Random;
use carom::run::{Dynamics, Film, Run};
use carom::scenario::Scenario;
use carom::scenario::schema::Record;
use carom::simulate::AnyRun;
use carom::with_any;

/// The places at a time as one who draws computes them.
fn places(film: &Film, components: usize, time: f64) -> Vec<f64> {
    let row_of = |ball: usize| {
        let rows = film.first_rows[ball] as usize..film.first_rows[ball + 1] as usize;
        let rows = rows.map(|row| &film.numbers[row * film.width..][..film.width]);
        rows.take_while(|row| row[0] <= time).last().unwrap()
    };
    let place = |row: &[f64], axis: usize| {
        let [x, v, a] = [0, 1, 2].map(|part| row[1 + part * components + axis]);
        let s = time - row[0];
        x + (v + a * (s * 0.5)) * s
    };
    (0..film.first_rows.len() - 1)
        .flat_map(|ball| (0..components).map(move |axis| place(row_of(ball), axis)).collect::<Vec<_>>())
        .collect()
}

fn assert_film_of<D: Dynamics<f64>>(name: &str, run: &Run<f64, D>, in_space: bool, random: &mut Random) {
    let (film, components) = (run.film().unwrap(), if in_space { 3 } else { 2 });
    let skipped = usize::from(in_space);
    for k in 0..20 {
        let time = if k == 0 { run.end_time } else { random.between(0.0, run.end_time) };
        let states = run.state(time).unwrap();
        let own = states.iter().flat_map(|state| D::numbers(state).skip(skipped).take(components));
        for (film, own) in places(&film, components, time).into_iter().zip(own) {
            let is_same = film.to_bits() == own.to_bits() || film.is_nan() || film == own;
            assert!(is_same, "{name} at {time}: {film} in the film, {own} in the run");
        }
    }
}

#[test]
fn film_has_the_places_of_every_ready_made_scenario() {
    let mut random = Random::new(11);
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios");
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        let scenario = Scenario::from_toml(&std::fs::read_to_string(&path).unwrap()).unwrap();
        let scenario = Scenario { record: Some(Record::All), ..scenario };
        let run = AnyRun::simulate(&scenario, None, &mut || false).unwrap();
        let name = path.file_stem().unwrap().to_string_lossy();
        with_any!(&run, run => assert_film_of(&name, run, scenario.has_cloth(), &mut random));
    }
}

#[test]
fn a_run_without_flights_has_no_film() {
    let scenario = crate::kit::bundled("midterm");
    let run = carom::simulate::simulate(&Scenario { record: Some(Record::Events), ..scenario }).unwrap();
    assert!(run.film().unwrap_err().to_string().contains("record = \"all\""));
}
