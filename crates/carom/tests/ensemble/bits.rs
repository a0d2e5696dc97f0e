//! Every number is a function of what it is drawn for.

use super::kit::{NAMES, draws};
use carom::ensemble::{Design, Distribution, Draws, MOST_ROWS};

#[test]
fn bits_are_the_same_everywhere() {
    let normal = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };
    let expected = [
        [0x3fbc_1769_c95f_a038, 0x3fee_46e4_7f4a_13b1, 0x3fcb_81dd_bb62_d3a0],
        [0x3fee_67b5_0c55_34ed, 0x3fe5_522a_2b9a_8b25, 0x3ff9_197a_6f02_f1d2],
        [0x3fbe_c244_30f4_1848, 0x3fe0_e725_fb20_49f5, 0xbfe3_d851_b1ee_438b],
    ];
    let found = Design::ALL.map(|design| {
        let draws = draws(design, 7, 1001);
        [draws.unit(0, 0), draws.unit(1000, 1), normal.at(draws.unit(77, 3))].map(f64::to_bits)
    });
    assert_eq!(found, expected, "{found:#018x?}");
}

#[test]
fn rows_drawn_alone_are_those_of_the_whole() {
    for design in Design::ALL {
        let whole = draws(design, 3, 1000);
        for rows in [990..1000, 0..5, 400..403] {
            let alone = draws(design, 3, 1000);
            for row in rows.rev() {
                for dimension in (0..NAMES.len()).rev() {
                    assert_eq!(alone.unit(row, dimension), whole.unit(row, dimension), "{design:?}");
                }
            }
        }
    }
}

#[test]
fn numbers_are_strictly_between_zero_and_one() {
    for design in Design::ALL {
        for rows in [1, 2, 3, 1000, (1 << 32) + 1, MOST_ROWS - 1, MOST_ROWS] {
            let draws = draws(design, 5, rows);
            for row in (0..rows.min(500)).flat_map(|row| [row, rows - 1 - row]) {
                let unit = draws.unit(row, 0);
                assert!(0.0 < unit && unit < 1.0, "{design:?}, row {row} of {rows}: {unit}");
            }
        }
    }
}

#[test]
fn seeds_and_paths_draw_different_numbers() {
    for design in Design::ALL {
        let [one, other] = [1, 2].map(|seed| draws(design, seed, 50));
        for row in 0..50 {
            assert_ne!(one.unit(row, 0), other.unit(row, 0), "{design:?}");
            assert_ne!(one.unit(row, 0), one.unit(row, 1), "{design:?}");
        }
    }
}

#[test]
fn more_rows_keep_those_that_were_there() {
    for design in [Design::Independent, Design::Sobol] {
        let [few, many] = [100, 1_000_000].map(|rows| draws(design, 9, rows));
        assert!((0..100).all(|row| few.unit(row, 2) == many.unit(row, 2)), "{design:?}");
    }
}

#[test]
fn another_path_keeps_the_numbers_of_those_before_it() {
    for design in Design::ALL {
        let [few, many] = [&NAMES[..2], &NAMES].map(|names| Draws::new(design, 9, 100, names).unwrap());
        assert!((0..100).all(|row| few.unit(row, 1) == many.unit(row, 1)), "{design:?}");
    }
    for design in [Design::Independent, Design::LatinHypercube] {
        let turned: Vec<&str> = NAMES.into_iter().rev().collect();
        let [one, other] = [&NAMES[..], &turned].map(|names| Draws::new(design, 9, 100, names).unwrap());
        assert!((0..100).all(|row| one.unit(row, 0) == other.unit(row, 3)), "{design:?}");
    }
}
