//! Scenes that the tests aim in.

use carom::aim::Scene;
use carom::random::Random;
use carom::scenario::Scenario;

/// Radius of the balls of a pool table.
pub const POOL: f64 = 0.028_575;

/// A scenario from TOML.
pub fn scenario(text: &str) -> Scenario {
    Scenario::from_toml(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A ball of a scenario file.
pub fn ball(id: &str, [x, y]: [f64; 2], more: &str) -> String {
    format!("[[balls]]\nid = '{id}'\nposition = [{x:?}, {y:?}]\n{more}\n")
}

/// A pool table of nine feet with dead cushions, on which balls roll far and nothing is lost where they meet; with these
/// balls and a shot.
pub fn on_pool_table(balls: &str, shot: &str) -> String {
    format!(
        "record = 'events'\nmax_events = 400\ntable.preset = 'pool_9ft'\nphysics.ball_ball.law = 'elastic'\n\
         physics.ball_cushion = {{ law = 'restitution', normal = 0.1, tangential = 1 }}\nphysics.flight = {{ law = 'cloth', air = false }}\n\
         ball_defaults.rolling_friction = 1e-9\ncue.end_mass = 0\n{balls}\n{shot}"
    )
}

/// A wide rectangle of discs, with these balls.
pub fn discs(balls: &str) -> Scene {
    let text = format!("duration = 1\ntable = {{ shape = 'rectangle', width = 10, length = 10 }}\n{balls}");
    Scene::new(&scenario(&text), None).unwrap()
}

/// The places of so many balls of a pool table of nine feet, anywhere between the noses without overlap.
pub fn places(random: &mut Random, count: usize) -> Vec<[f64; 2]> {
    let mut places: Vec<[f64; 2]> = Vec::new();
    while places.len() < count {
        let free = |size: f64, unit: f64| POOL + (size - 2.0 * POOL) * unit;
        let [x, y] = [free(1.27, random.unit()), free(2.54, random.unit())];
        let is_apart = |other: &[f64; 2]| (x - other[0]).hypot(y - other[1]) > 2.0 * POOL;
        if places.iter().all(is_apart) {
            places.push([x, y]);
        }
    }
    places
}

/// A layout of the cue ball and the balls 1, 2, ..., every other one of which is smaller.
pub fn random_balls(seed: u64, count: usize) -> String {
    let places = places(&mut Random::new(seed, "aim"), count);
    let id = |k: usize| if k == 0 { "cue".to_owned() } else { k.to_string() };
    places
        .into_iter()
        .enumerate()
        .map(|(k, place)| ball(&id(k), place, if k % 2 == 0 { "" } else { "radius = 0.025" }))
        .collect()
}
