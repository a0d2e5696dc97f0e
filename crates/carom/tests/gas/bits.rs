//! The same bits on every platform.

use super::kit::{bidisperse, made, recipe};
use carom::gas::{Arrangement, Distribution, Masses, Recipe, Sizes, Start};

/// FNV-1a over the little-endian bytes of every number, −0 as +0.
fn digest(start: &Start) -> u64 {
    let vectors = start.positions.iter().chain(&start.velocities).flat_map(|vector| vector.to_f64());
    let scalars = start.size.iter().chain(&start.radii).chain(&start.masses).copied();
    vectors
        .chain(scalars)
        .flat_map(|number| (number + 0.0).to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
}

#[test]
fn bits_are_the_same_everywhere() {
    use Arrangement::{Compressed, Hexagonal, Random, Square};
    let walls = [false, false];
    let log_normal = Sizes::Distribution {
        diameters: Distribution::LogNormal { polydispersity: 0.2, truncation: 3.0 },
        masses: Masses::Area,
    };
    let expected =
        [0x8716_7441_996a_09df, 0x5317_9030_a3e3_ab17, 0xb4ee_fcda_1b2b_4f04, 0xd5bc_057e_1e9e_649a];
    let found = [
        recipe(101, 0.6, Square),
        Recipe { periodic: walls, ..recipe(101, 0.6, Hexagonal) },
        Recipe { sizes: bidisperse(), ..recipe(100, 0.4, Random) },
        Recipe { sizes: log_normal, periodic: walls, ..recipe(100, 0.7, Compressed) },
    ]
    .map(|recipe| digest(&made(&recipe)));
    assert_eq!(found, expected, "{found:#018x?}");
}
