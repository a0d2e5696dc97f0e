//! What is refused, and what is said.

use super::kit::draws;
use carom::ensemble::{Design, Distribution, Draws, MOST_DIMENSIONS, MOST_ROWS};

fn said(draws: Result<Draws, impl ToString>) -> String {
    draws.err().map(|error| error.to_string()).unwrap_or_default()
}

#[test]
fn rows_outside_their_range() {
    for design in Design::ALL {
        for rows in [0, MOST_ROWS + 1, u64::MAX] {
            let expected = format!("rows: must be from 1 to 4503599627370496, got {rows}");
            assert_eq!(said(Draws::new(design, 1, rows, &["a"])), expected);
        }
    }
}

#[test]
fn more_paths_than_sobols_sequence_has_dimensions() {
    let names: Vec<String> = (0..=MOST_DIMENSIONS).map(|place| format!("balls[{place}].radius")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let error = said(Draws::new(Design::Sobol, 1, 8, &names));
    assert!(error.starts_with("sobol: must vary 32 paths at most, got 33"), "{error}");
    assert!(Draws::new(Design::Sobol, 1, 8, &names[1..]).is_ok());
    for design in [Design::Independent, Design::LatinHypercube] {
        assert!(Draws::new(design, 1, 8, &names).is_ok());
    }
}

#[test]
fn a_path_twice() {
    for design in Design::ALL {
        assert_eq!(said(Draws::new(design, 1, 8, &["a", "b", "a"])), "a: is varied twice");
    }
}

#[test]
fn rows_and_dimensions_that_there_are_not_have_no_number() {
    for design in Design::ALL {
        let draws = draws(design, 1, 10);
        assert!(draws.unit(9, 3).is_finite());
        assert!(draws.unit(10, 3).is_nan() && draws.unit(u64::MAX, 0).is_nan() && draws.unit(9, 4).is_nan());
    }
}

#[test]
fn designs_have_names() {
    assert_eq!(Design::ALL.map(Design::name), ["independent", "latin_hypercube", "sobol"]);
    assert_eq!(Design::ALL.map(|design| Design::from_name(design.name())), Design::ALL.map(Some));
    assert_eq!(Design::from_name("Sobol"), None);
}

#[test]
fn numbers_of_a_distribution_outside_their_range() {
    let uniform = |low, high| Distribution::Uniform { low, high };
    let normal = |mean, standard_deviation| Distribution::Normal { mean, standard_deviation };
    let cases = [
        (uniform(f64::NAN, 1.0), "low: must be from -1e300 to 1e300, got NaN"),
        (uniform(0.0, f64::INFINITY), "high: must be from -1e300 to 1e300, got inf"),
        (uniform(1.5, 1.5), "high: must be above low, 1.5, got 1.5"),
        (uniform(2.0, -1.0), "high: must be above low, 2, got -1"),
        (normal(f64::NEG_INFINITY, 1.0), "mean: must be from -1e300 to 1e300, got -inf"),
        (normal(0.0, f64::NAN), "standard_deviation: must be from -1e300 to 1e300, got NaN"),
        (normal(0.0, 0.0), "standard_deviation: must be above 0, got 0"),
        (normal(0.0, -0.5), "standard_deviation: must be above 0, got -0.5"),
    ];
    for (distribution, expected) in cases {
        assert_eq!(distribution.check().unwrap_err().to_string(), expected);
    }
    for distribution in [uniform(-1.0, 1.0), uniform(-1e300, 1e300), normal(3.0, 1e-9), normal(1e300, 1e300)]
    {
        assert_eq!(distribution.check(), Ok(()));
    }
}
