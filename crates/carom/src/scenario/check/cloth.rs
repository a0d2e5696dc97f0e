//! What needs a cloth, and what a cloth needs.

use super::{Draft, Findings};
use crate::scenario::path::Key;
use crate::scenario::schema::{Ball, Collapse, Cue, Flight, Table, Vector};

/// Where the law stands that makes balls roll.
const NEEDS: &str = "needs physics.flight.law = \"cloth\"";

/// Notes keys of balls with spin in a run of discs, and the other way round.
pub(super) fn check_cloth(draft: &Draft<'_>, findings: &mut Findings) {
    if !findings.is_sound("physics.flight") || !findings.is_sound("table.preset") {
        return;
    }
    match draft.physics.flight() {
        Flight::Cloth { air, .. } => check_spheres(draft, *air, findings),
        Flight::Free | Flight::Field { .. } => check_discs(draft, findings),
    }
}

/// Notes what discs do not have.
fn check_discs(draft: &Draft<'_>, findings: &mut Findings) {
    if let Some(preset) = draft.written.and_then(Table::preset) {
        findings.note("table.preset", format!("{:?} {NEEDS}", preset.preset.name()));
        return;
    }
    let mut places: Vec<String> = Vec::new();
    places.extend(draft.table.into_iter().flat_map(of_table));
    places.extend(of_laws(draft));
    places.extend(draft.shot.map(|_| "shot".into()));
    // A cue that does not strike was not filled in.
    places.extend((draft.shot.is_none() && *draft.cue != Cue::default()).then(|| "cue".into()));
    let defaults = draft.ball_defaults;
    let frictions = [defaults.sliding_friction, defaults.rolling_friction, defaults.spin_decay];
    places.extend(given(frictions).map(|key| format!("ball_defaults.{key}")));
    for (index, ball) in draft.balls() {
        places.extend(of_ball(ball).map(|key| draft.place(index, key)));
    }
    for place in places {
        if findings.is_sound(&place) {
            findings.note(place, NEEDS);
        }
    }
}

fn of_table(table: &Table) -> Vec<String> {
    let given = [
        ("shape", matches!(table, Table::PocketTable { .. })),
        ("nose_height", table.nose_height().is_some()),
        ("nose_contact", table.nose_contact().is_some()),
        ("pockets", !table.pockets().is_empty()),
    ];
    given.into_iter().filter(|(_, is_given)| *is_given).map(|(key, _)| format!("table.{key}")).collect()
}

fn of_laws(draft: &Draft<'_>) -> Vec<String> {
    let physics = draft.physics;
    let mut places = Vec::new();
    places.extend(physics.ball_ball().needs_cloth().map(|_| "physics.ball_ball.law".into()));
    places.extend(physics.ball_cushion().with_spin().map(|_| "physics.ball_cushion.law".into()));
    let with_spin = physics.cushions.iter().filter(|(_, law)| law.with_spin().is_some());
    places.extend(with_spin.map(|(id, _)| format!("physics.cushions.{}.law", Key(id))));
    places
}

/// The keys of a ball that only a sphere has.
fn of_ball(ball: &Ball) -> impl Iterator<Item = &'static str> {
    let has_up = |vector: Option<Vector>| vector.is_some_and(|vector| vector.up.is_some());
    let rest = [
        ("position[2]", has_up(ball.position)),
        ("velocity[2]", has_up(ball.velocity)),
        ("spin", ball.spin.is_some()),
    ];
    given([ball.sliding_friction, ball.rolling_friction, ball.spin_decay])
        .chain(rest.into_iter().filter(|(_, is_given)| *is_given).map(|(key, _)| key))
}

fn given(frictions: [Option<f64>; 3]) -> impl Iterator<Item = &'static str> {
    let keys = ["sliding_friction", "rolling_friction", "spin_decay"];
    keys.into_iter().zip(frictions).filter(|(_, value)| value.is_some()).map(|(key, _)| key)
}

/// Notes what balls on a cloth must have, and must not.
fn check_spheres(draft: &Draft<'_>, air: bool, findings: &mut Findings) {
    if draft.physics.collapse() == Collapse::Tc && findings.is_sound("physics.collapse") {
        findings.note("physics.collapse", "is for discs: on a cloth balls part with hops too small to see");
    }
    for (index, ball) in draft.balls() {
        let start = ball.start(index, draft.ball_defaults, &mut |_, value: f64| value);
        let sound = |findings: &Findings, key: &str| findings.is_sound(draft.place(index, key));
        let has_radius = ball.radius.or(draft.ball_defaults.radius).is_some();
        if !has_radius || !sound(findings, "radius") || !findings.is_sound("ball_defaults.radius") {
            continue;
        }
        if start.radius == 0.0 {
            let message = format!("ball {:?} is a point, and cannot roll on a cloth", ball.id);
            findings.add(draft.place(index, "radius"), message);
        } else if sound(findings, "position") && start.position.z < start.radius {
            let message = format!(
                "is the height of the centre, at least the radius {} of ball {:?}; got {}",
                start.radius, ball.id, start.position.z
            );
            findings.add(draft.place(index, "position[2]"), message);
        } else if !air && (start.position.z > start.radius || start.velocity.z != 0.0) {
            let key = if start.velocity.z == 0.0 { "position[2]" } else { "velocity[2]" };
            let message = format!("takes ball {:?} off the cloth, and physics.flight.air is false", ball.id);
            findings.add(draft.place(index, key), message);
        }
    }
}
