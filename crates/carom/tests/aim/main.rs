//! Aiming: closed forms, and what happens to shots that are aimed so.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod directions;
mod layouts;
mod pots;
mod stick;
