//! Laws of single cushions and corners: whether there are such.

use super::Findings;
use crate::model;
use crate::scenario::nearest::suggestion;
use crate::scenario::path::Key;
use crate::scenario::schema::Physics;

/// Notes laws of cushions and corners that do not exist.
pub(super) fn check_laws(physics: &Physics, table: &model::Table<f64>, findings: &mut Findings) {
    let corners = table.corners.iter().map(|corner| corner.id.as_str());
    let known: Vec<&str> = table.cushions().map(|cushion| cushion.id.as_str()).chain(corners).collect();
    for id in physics.cushions.keys().filter(|id| !known.contains(&id.as_str())) {
        let message = format!("the table has no such cushion or corner{}", suggestion(id, &known));
        findings.add(format_args!("physics.cushions.{}", Key(id)), message);
    }
}
