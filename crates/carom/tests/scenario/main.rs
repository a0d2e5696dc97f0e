//! The text format of scenarios: its checking, its values, the table it lays out, and the files that come with carom.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod balls_from;
mod boundary;
mod check;
mod cloth;
mod common;
mod equipment;
mod files;
mod gas;
mod periodic;
mod pocket_tables;
mod racks;
mod stories;
mod structure;
mod table_layout;
mod values;
