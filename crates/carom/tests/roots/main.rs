//! Certified closing crossings: against exact arithmetic, closed forms, each other, and in every scalar.

#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

mod contact;
mod exact;
mod gap;
mod reference;
mod scalars;
mod scaling;
