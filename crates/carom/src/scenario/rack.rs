//! Balls set up for a game: their names, colours and places.
//!
//! Lengths are fractions of the table, whose lower left corner is the origin; the foot of the table, where the balls are
//! racked, is at its upper end. Sources of the places: rules of play of the World Pool Association (foot spot at a
//! quarter of the length from the foot, head spot at a quarter from the head; the ball at the head of the triangle on the
//! foot spot), of the World Professional Billiards and Snooker Association (baulk line 737 mm from the baulk cushion, a D
//! of radius 292 mm, black 324 mm from the top cushion, on a table of 3569 by 1778 mm; blue in the middle, pink midway
//! between it and the top cushion; seen from baulk green lies left, yellow right), of the Union Mondiale de Billard (spots
//! at a quarter of the length; the shooter's ball 182.5 mm beside the one of the adversary) and of the World Eightball Pool
//! Federation (baulk line at a fifth of the length, the 8 on the spot at a quarter from the foot).

use super::schema::{Ball, BallDefaults, Color, Game, Rack, Table};
use crate::random::Random;

/// What stands between the pink and the head of the reds, which must not touch, over a ball's radius.
const GAP_BEHIND_PINK: f64 = 0.05;

/// A ball of a rack before it has its place: its id and its colour.
type Named = (String, &'static str);

/// A place of the triangle or diamond: its row, counted from the head, and how far it lies right of the middle, in
/// diameters.
type Seat = (f64, f64);

/// Where a rack stands: the size of the table, and the radius of its balls.
struct Ground {
    width: f64,
    length: f64,
    radius: f64,
}

/// The width and length of a table that a rack can stand on.
pub(super) fn ground_of(table: &Table) -> Option<[f64; 2]> {
    match table {
        Table::Rectangle { width, length, .. } | Table::PocketTable { width, length, .. } => {
            Some([*width, *length])
        }
        Table::Circle { .. } | Table::Path { .. } | Table::Preset(_) | Table::Absent => None,
    }
}

/// The balls of a rack, the cue ball first; none where the table or the radius, which a check asks for, is missing.
pub(super) fn racked(
    rack: &Rack,
    table: &Table,
    defaults: &BallDefaults,
    cue_ball: Option<&BallDefaults>,
) -> Vec<Ball> {
    let (Some([width, length]), Some(radius)) = (ground_of(table), defaults.radius) else {
        return Vec::new();
    };
    let ground = Ground { width, length, radius };
    let mut balls = match rack.game {
        Game::EightBall => pool(rack, &ground, &triangle(5), eight_ball(rack.seed)),
        Game::NineBall => pool(rack, &ground, &diamond(), nine_ball(rack.seed)),
        Game::TenBall => pool(rack, &ground, &triangle(4), ten_ball(rack.seed)),
        Game::StraightPool => pool(rack, &ground, &triangle(5), straight_pool(rack.seed)),
        Game::Snooker => snooker(rack, &ground),
        Game::ThreeCushion => three_cushion(&ground),
        Game::EnglishPool => english_pool(rack, &ground),
    };
    if let (Some(ball), Some(own)) = (balls.first_mut(), cue_ball) {
        (ball.radius, ball.mass) = (own.radius, own.mass);
    }
    balls
}

impl Ground {
    /// A ball at a fraction of width and length.
    fn ball(&self, id: &str, color: &'static str, x: f64, y: f64) -> Ball {
        ball((id.into(), color), [x * self.width, y * self.length])
    }

    /// Balls in their seats behind the head of a triangle or diamond, moved at random.
    fn seated(&self, rack: &Rack, head: [f64; 2], seats: &[Seat], named: Vec<Named>) -> Vec<Ball> {
        let step = 2.0 * self.radius * (1.0 + rack.spacing);
        let mut random = Random::new(rack.seed, "rack.jitter");
        let place = |(row, right): Seat| [head[0] + right * step, head[1] + row * step * (0.75f64).sqrt()];
        let mut moved = |[x, y]: [f64; 2]| {
            let [right, up] = random.in_disc().map(|part| part * self.radius * rack.jitter);
            [x + right, y + up]
        };
        seats.iter().zip(named).map(|(seat, named)| ball(named, moved(place(*seat)))).collect()
    }
}

fn ball((id, color): Named, position: [f64; 2]) -> Ball {
    Ball {
        id,
        radius: None,
        mass: None,
        sliding_friction: None,
        rolling_friction: None,
        spin_decay: None,
        position: Some(position.into()),
        velocity: None,
        spin: None,
        speed: None,
        direction_deg: None,
        color: Some(Color::Text(color.into())),
    }
}

/// The seats of a triangle, row by row from its head, each from left to right.
fn triangle(rows: usize) -> Vec<Seat> {
    (1..=rows).flat_map(|count| row(count - 1, count)).collect()
}

/// The seats of nine-ball's diamond.
fn diamond() -> Vec<Seat> {
    [1, 2, 3, 2, 1].into_iter().enumerate().flat_map(|(number, count)| row(number, count)).collect()
}

fn row(number: usize, count: usize) -> impl Iterator<Item = Seat> {
    (0..count).map(move |place| (number as f64, place as f64 - (count - 1) as f64 / 2.0))
}

/// The cue ball on the head spot, and the others with their head on the foot spot.
fn pool(rack: &Rack, ground: &Ground, seats: &[Seat], order: Vec<usize>) -> Vec<Ball> {
    let named = order.into_iter().map(numbered).collect();
    let mut balls = vec![ground.ball("cue", "ivory", 0.5, 0.25)];
    balls.extend(ground.seated(rack, [0.5 * ground.width, 0.75 * ground.length], seats, named));
    balls
}

/// A pool ball of a number; of the striped ones, from 9 on, a paler shade of the colour that they share with the solid.
fn numbered(number: usize) -> Named {
    const COLORS: [&str; 15] = [
        "gold",
        "mediumblue",
        "crimson",
        "purple",
        "darkorange",
        "forestgreen",
        "maroon",
        "black",
        "khaki",
        "cornflowerblue",
        "lightcoral",
        "plum",
        "sandybrown",
        "mediumseagreen",
        "rosybrown",
    ];
    (number.to_string(), COLORS[number - 1])
}

/// The numbers of some balls in random order.
fn shuffled(seed: u64, numbers: impl IntoIterator<Item = usize>) -> Vec<usize> {
    let mut numbers: Vec<usize> = numbers.into_iter().collect();
    Random::new(seed, "rack.order").shuffle(&mut numbers);
    numbers
}

/// The 8 in the middle of the third row, one ball of each kind in the rear corners: each such order equally likely.
fn eight_ball(seed: u64) -> Vec<usize> {
    let mut random = Random::new(seed, "rack.corners");
    let mut corners = [1 + random.below(7), 9 + random.below(7)];
    random.shuffle(&mut corners);
    let mut order = shuffled(seed, (1..=15).filter(|number| *number != 8 && !corners.contains(number)));
    order.insert(4, 8);
    order.insert(10, corners[0]);
    order.push(corners[1]);
    order
}

/// The 1 at the head, the 9 in the middle.
fn nine_ball(seed: u64) -> Vec<usize> {
    let mut order = shuffled(seed, 2..=8);
    order.insert(0, 1);
    order.insert(4, 9);
    order
}

/// The 1 at the head, the 10 in the middle of the third row.
fn ten_ball(seed: u64) -> Vec<usize> {
    let mut order = shuffled(seed, 2..=9);
    order.insert(0, 1);
    order.insert(4, 10);
    order
}

fn straight_pool(seed: u64) -> Vec<usize> {
    shuffled(seed, 1..=15)
}

fn snooker(rack: &Rack, ground: &Ground) -> Vec<Ball> {
    let (baulk, half_d, black) = (737.0 / 3569.0, 292.0 / 1778.0, 1.0 - 324.0 / 3569.0);
    let mut balls = vec![
        ground.ball("white", "ivory", 0.5 + half_d / 2.0, baulk),
        ground.ball("yellow", "gold", 0.5 + half_d, baulk),
        ground.ball("green", "green", 0.5 - half_d, baulk),
        ground.ball("brown", "saddlebrown", 0.5, baulk),
        ground.ball("blue", "mediumblue", 0.5, 0.5),
        ground.ball("pink", "hotpink", 0.5, 0.75),
        ground.ball("black", "black", 0.5, black),
    ];
    let behind = ground.radius * (2.0 * (1.0 + rack.spacing) + GAP_BEHIND_PINK);
    let head = [0.5 * ground.width, 0.75 * ground.length + behind];
    let reds = (1..=15).map(|number| (format!("red_{number:02}"), "crimson")).collect();
    balls.extend(ground.seated(rack, head, &triangle(5), reds));
    balls
}

fn three_cushion(ground: &Ground) -> Vec<Ball> {
    vec![
        ground.ball("white", "ivory", 0.5 + 182.5 / 1420.0, 0.25),
        ground.ball("yellow", "gold", 0.5, 0.25),
        ground.ball("red", "crimson", 0.5, 0.75),
    ]
}

/// The 8 in the middle of the third row stands on the spot, two rows behind the head.
fn english_pool(rack: &Rack, ground: &Ground) -> Vec<Ball> {
    let named = shuffled(rack.seed, 1..=14).into_iter().map(|number| match number {
        1..=7 => (format!("red_{number}"), "crimson"),
        _ => (format!("yellow_{}", number - 7), "gold"),
    });
    let mut named: Vec<Named> = named.collect();
    named.insert(4, ("8".into(), "black"));
    let two_rows = 2.0 * 2.0 * ground.radius * (1.0 + rack.spacing) * (0.75f64).sqrt();
    let head = [0.5 * ground.width, 0.75 * ground.length - two_rows];
    let mut balls = vec![ground.ball("cue", "ivory", 0.5, 0.2)];
    balls.extend(ground.seated(rack, head, &triangle(5), named));
    balls
}
