//! Racks: which balls, where, in which order, and what a scenario may change about them.

use crate::common::problems;
use carom::scenario::Scenario;
use carom::scenario::schema::{Ball, Preset};
use serde_json::json;
use std::collections::BTreeMap;

const GAMES: [(&str, Preset, usize); 7] = [
    ("eight_ball", Preset::Pool9ft, 16),
    ("nine_ball", Preset::Pool9ft, 10),
    ("ten_ball", Preset::Pool9ft, 11),
    ("straight_pool", Preset::Pool9ft, 16),
    ("snooker", Preset::Snooker12ft, 22),
    ("three_cushion", Preset::Carom10ft, 3),
    ("english_pool", Preset::EnglishPool, 16),
];

fn racked(game: &str, preset: Preset, rest: &str) -> Vec<Ball> {
    let text = format!("table.preset = '{}'\nrack.game = '{game}'\n{rest}", preset.name());
    let scenario = Scenario::from_toml(&text).unwrap_or_else(|error| panic!("{game}: {error}"));
    scenario.expanded().into_owned().balls
}

fn place(balls: &[Ball], id: &str) -> [f64; 2] {
    balls.iter().find(|ball| ball.id == id).unwrap_or_else(|| panic!("no ball {id}")).position.unwrap().plan
}

fn distance([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    ((ax - bx) * (ax - bx) + (ay - by) * (ay - by)).sqrt()
}

/// The ids of all balls but the first, in the order of the rack's places.
fn order(game: &str, seed: u64) -> Vec<String> {
    let balls = racked(game, Preset::Pool9ft, &format!("rack.seed = {seed}"));
    balls.into_iter().skip(1).map(|ball| ball.id).collect()
}

#[test]
fn a_shot_at_a_ball_that_the_rack_does_not_have_is_told_its_cue_ball() {
    let text = "table.preset = 'snooker_12ft'\nrack.game = 'snooker'\nshot = { V0 = 1, phi_deg = 90 }";
    assert_eq!(
        problems(text),
        ["shot.cue_ball: there is no ball \"cue\"; the cue ball of the rack is \"white\""]
    );
    for (game, preset, _) in GAMES {
        let text = format!("table.preset = '{}'\nrack.game = '{game}'", preset.name());
        let scenario = Scenario::from_toml(&text).unwrap();
        let cue_ball = scenario.rack.as_ref().unwrap().game.cue_ball();
        assert!(scenario.expanded().balls.iter().any(|ball| ball.id == cue_ball), "{game}");
    }
}

/// Pairs of balls whose centres are nearer than half as much again as they are when they touch, and how far apart.
fn neighbours(balls: &[Ball], radius: f64) -> Vec<f64> {
    let mut found = Vec::new();
    for (index, a) in balls.iter().enumerate() {
        for b in &balls[index + 1..] {
            let apart = distance(a.position.unwrap().plan, b.position.unwrap().plan);
            if apart < 3.0 * radius {
                found.push(apart);
            }
        }
    }
    found
}

#[test]
fn every_game_has_its_balls_once_with_a_colour_and_a_place() {
    for (game, preset, count) in GAMES {
        let balls = racked(game, preset, "");
        assert_eq!(balls.len(), count, "{game}");
        let ids: BTreeMap<&str, ()> = balls.iter().map(|ball| (ball.id.as_str(), ())).collect();
        assert_eq!(ids.len(), count, "{game} has an id twice");
        assert!(balls.iter().all(|ball| ball.color.is_some() && ball.position.is_some()));
    }
    let snooker = racked("snooker", Preset::Snooker12ft, "");
    let ids: Vec<&str> = snooker.iter().map(|ball| ball.id.as_str()).collect();
    assert_eq!(ids[..9], ["white", "yellow", "green", "brown", "blue", "pink", "black", "red_01", "red_02"]);
}

#[test]
fn neighbours_of_a_frozen_rack_touch_and_no_pair_is_nearer() {
    // A triangle of n rows has 3 n(n − 1)/2 contacts, the diamond of nine-ball 16.
    let contacts = [("eight_ball", 30), ("nine_ball", 16), ("ten_ball", 18), ("straight_pool", 30)];
    for (game, expected) in contacts {
        let radius = 0.028575;
        let found = neighbours(&racked(game, Preset::Pool9ft, ""), radius);
        assert_eq!(found.len(), expected, "{game}");
        // A few roundings of the coordinates, of at most 2.6; the check's own tolerance is 6e-12.
        assert!(found.iter().all(|apart| (apart - 2.0 * radius).abs() < 4e-15), "{game}: {found:?}");
    }
    let apart = neighbours(&racked("nine_ball", Preset::Pool9ft, "rack.spacing = 0.01"), 0.028575);
    assert!(apart.iter().all(|apart| (apart - 2.0 * 0.028575 * 1.01).abs() < 4e-15), "{apart:?}");
}

#[test]
fn the_order_is_free_where_the_game_leaves_it_free_and_follows_from_the_seed() {
    for game in ["eight_ball", "nine_ball", "ten_ball", "straight_pool"] {
        assert_eq!(order(game, 5), order(game, 5));
        let all: BTreeMap<Vec<String>, ()> = (0..10).map(|seed| (order(game, seed), ())).collect();
        assert_eq!(all.len(), 10, "{game}: each seed gives an order of its own");
    }
    let is_stripe = |id: &String| id.parse::<u32>().unwrap() > 8;
    for seed in 0..30 {
        let eight = order("eight_ball", seed);
        assert_eq!(eight[4], "8");
        assert_ne!(is_stripe(&eight[10]), is_stripe(&eight[14]), "{eight:?}");
        let nine = order("nine_ball", seed);
        assert_eq!((nine[0].as_str(), nine[4].as_str()), ("1", "9"));
        let ten = order("ten_ball", seed);
        assert_eq!((ten[0].as_str(), ten[4].as_str()), ("1", "10"));
    }
    assert!((0..20).any(|seed| is_stripe(&order("eight_ball", seed)[10])));
    assert!((0..20).any(|seed| !is_stripe(&order("eight_ball", seed)[10])));
    // The same everywhere and for ever: a seed is written into files and links.
    assert_eq!(order("nine_ball", 7).join(" "), NINE_BALL_OF_SEED_7);
}

const NINE_BALL_OF_SEED_7: &str = "1 2 5 4 9 8 6 7 3";

#[test]
fn the_order_depends_on_nothing_but_the_seed() {
    let order = |rest: &str, preset| {
        let balls = racked("straight_pool", preset, rest);
        balls.into_iter().map(|ball| ball.id).collect::<Vec<_>>()
    };
    let plain = order("rack.seed = 3", Preset::Pool9ft);
    let loose = "rack.seed = 3\nrack.spacing = 0.02\nrack.jitter = 0.01";
    assert_eq!(plain, order(loose, Preset::Pool7ft));
    assert_ne!(plain, order("rack.seed = 4", Preset::Pool9ft));
}

#[test]
fn jitter_moves_each_ball_by_up_to_its_part_of_the_radius() {
    let radius = 0.028575;
    let placed = |rest: &str| racked("eight_ball", Preset::Pool9ft, rest);
    let still = placed("rack.spacing = 0.05");
    let moved = placed("rack.spacing = 0.05\nrack.jitter = 0.05");
    let by: Vec<f64> = still
        .iter()
        .zip(&moved)
        .map(|(a, b)| distance(a.position.unwrap().plan, b.position.unwrap().plan))
        .collect();
    assert_eq!(by[0], 0.0, "the cue ball stays");
    assert!(by[1..].iter().all(|by| *by > 0.0 && *by <= 0.05 * radius), "{by:?}");
    assert!(by[1..].iter().any(|by| *by > 0.025 * radius));
    let again = placed("rack.spacing = 0.05\nrack.jitter = 0.05");
    assert_eq!(moved, again);
    assert_ne!(moved, placed("rack.spacing = 0.05\nrack.jitter = 0.05\nrack.seed = 1"));
}

#[test]
fn balls_stand_on_the_spots_of_their_games() {
    let pool = racked("nine_ball", Preset::Pool9ft, "");
    assert_eq!((place(&pool, "cue"), place(&pool, "1")), ([0.635, 0.635], [0.635, 1.905]));
    let snooker = racked("snooker", Preset::Snooker12ft, "");
    let close = |found: [f64; 2], expected: [f64; 2]| assert!(distance(found, expected) < 1e-12, "{found:?}");
    close(place(&snooker, "brown"), [0.889, 0.737]);
    close(place(&snooker, "yellow"), [0.889 + 0.292, 0.737]);
    close(place(&snooker, "green"), [0.889 - 0.292, 0.737]);
    close(place(&snooker, "black"), [0.889, 3.569 - 0.324]);
    close(place(&snooker, "blue"), [0.889, 3.569 / 2.0]);
    let gap = distance(place(&snooker, "pink"), place(&snooker, "red_01")) - 0.0525;
    assert!(gap > 0.001 && gap < 0.002, "the reds do not touch the pink: {gap}");
    let carom = racked("three_cushion", Preset::Carom10ft, "");
    close(place(&carom, "white"), [0.71 + 0.1825, 0.71]);
    let english = racked("english_pool", Preset::EnglishPool, "");
    close(place(&english, "8"), [0.4572, 0.75 * 1.8288]);
    assert_eq!((english[0].radius, english[0].mass), (Some(0.0238), Some(0.094)));
    assert!(english[1..].iter().all(|ball| ball.radius.is_none()));
}

#[test]
fn an_entry_of_balls_changes_a_ball_of_the_rack_or_adds_one() {
    let text = "table.preset = 'pool_9ft'\nrack.game = 'nine_ball'\n[[balls]]\nid = 'extra'\nposition = [0.2, 0.2]\n\
                [[balls]]\nid = '9'\ncolor = 'red'\nmass = 0.2\n";
    let scenario = Scenario::from_toml(text).unwrap();
    let expanded = scenario.expanded();
    let ids: Vec<&str> = expanded.balls.iter().map(|ball| ball.id.as_str()).collect();
    assert_eq!(ids[..4], ["extra", "9", "cue", "1"]);
    assert_eq!(ids.len(), 11);
    let plain = racked("nine_ball", Preset::Pool9ft, "");
    assert_eq!(place(&expanded.balls, "9"), place(&plain, "9"));
    assert_eq!((expanded.balls[1].mass, expanded.balls[2].mass), (Some(0.2), None));
    assert_eq!(scenario.place("balls.9.mass".replace('9', "\"9\"").as_str()).unwrap(), "balls[1].mass");
    // A ball that the rack alone has is found, and an entry is written for it when it is changed.
    assert_eq!(scenario.place("balls.cue.position[0]").unwrap(), "balls[2].position[0]");
    let moved = scenario.with_values(&[("balls.cue.position", json!([0.5, 0.3]))]).unwrap();
    assert_eq!(moved.balls[2].id, "cue");
    assert_eq!(place(&moved.expanded().balls, "cue"), [0.5, 0.3]);
    let other = scenario.with_values(&[("rack.seed", json!(11)), ("rack.spacing", json!(0.001))]).unwrap();
    assert_ne!(other.expanded().balls, expanded.balls);
    let first = Scenario::from_toml("table.preset = 'pool_9ft'\nrack.game = 'nine_ball'").unwrap();
    let changed =
        first.with_values(&[("balls.cue.color", json!("red")), ("balls.cue.mass", json!(0.1))]).unwrap();
    assert_eq!((changed.balls.len(), changed.expanded().balls.len()), (1, 10));
}

#[test]
fn racks_that_cannot_be_set_up_say_why() {
    let with = |table: &str, rest: &str| {
        problems(&format!(
            "physics.flight.law = 'cloth'\nrack.game = 'nine_ball'\n{rest}\n[table]\n{table}\n"
        ))
    };
    let square = "shape = 'rectangle'\nwidth = 1\nlength = 2";
    assert_eq!(with(square, "ball_defaults.radius = 0.03"), [""; 0]);
    assert_eq!(
        with(square, ""),
        ["ball_defaults.radius: missing: a rack needs the radius of its balls, here or from a preset"]
    );
    assert_eq!(
        with("shape = 'circle'\nradius = 1", "ball_defaults.radius = 0.03"),
        [
            "rack.game: has its places on a rectangular table: give table.shape = rectangle or pocket_table, or a preset"
        ]
    );
    let found = with("shape = 'rectangle'\nwidth = 0.2\nlength = 2", "ball_defaults.radius = 0.05");
    assert!(found[0].starts_with("rack: ball \"") && found[0].contains("reaches past cushion"), "{found:?}");
    let found = with(square, "ball_defaults.radius = 0.03\nrack.jitter = 0.5");
    assert!(found[0].starts_with("rack: ball \"") && found[0].contains("overlaps ball"), "{found:?}");
    let found = with(square, "ball_defaults.radius = 0.03\nballs = [{ id = 'x', position = [0.5, 1.48] }]");
    assert_eq!(found, ["rack: ball \"1\" overlaps ball \"x\" by 0.04"]);
    assert_eq!(
        with(square, "ball_defaults.radius = 0.03\nballs = [{ id = 'x' }]"),
        ["balls[0].position: missing: give ball \"x\" a position, [x, y]; the rack has no such ball"]
    );
    let found =
        with(square, "ball_defaults.radius = 0.03\nrack.gme = 1\nrack.seed = -1\nrack.spacing = -0.1");
    assert_eq!(
        found,
        [
            "rack.gme: unknown key; did you mean game? known: game, seed, spacing, jitter",
            "rack.seed: must be zero or positive, got -1",
            "rack.spacing: must be zero or positive and finite, got -0.1"
        ]
    );
    assert!(problems("table.preset = 'pool_9ft'\nrack.game = 'nineball'")[0].starts_with(
        "rack.game: unknown value \"nineball\"; did you mean nine_ball? known: eight_ball, nine_ball, "
    ));
    assert_eq!(problems("table.preset = 'pool_9ft'"), ["balls: missing: give at least one ball, or a rack"]);
}
