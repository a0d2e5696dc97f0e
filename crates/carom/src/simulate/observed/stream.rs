//! The events of a span of time, handed out piece by piece.

use super::plan::Window;
use crate::run::{Dynamics, Event, Observer};
use serde::{Deserialize, Serialize};

/// Events in a piece, as soon as there are so many; a cluster is not parted.
const PIECE: usize = 65_536;

/// Takes in the events of a window until they are handed out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Stream {
    window: Option<Window>,
    /// Events of the run so far, in the window or not.
    seen: u64,
    /// The number of the first that is held, counted from 0.
    first: u64,
    held: Vec<Event<f64>>,
    /// Events that were handed out before those.
    handed_out: u64,
}

impl Stream {
    pub(super) fn new(window: Option<Window>) -> Self {
        Self { window, seen: 0, first: 0, held: Vec::new(), handed_out: 0 }
    }

    /// What is to be handed out, and the number of the first.
    pub(super) fn piece(&self) -> (&[Event<f64>], u64) {
        (&self.held, self.first)
    }

    /// Whether a piece is there: a full one, or what there is after the window or the run; `is_over`: whether that ends here.
    pub(super) fn is_due(&self, time: f64, is_over: bool) -> bool {
        let is_last = is_over || self.window.is_some_and(|window| time > window.to);
        self.held.len() >= PIECE || (is_last && !self.held.is_empty())
    }

    /// The piece was handed out.
    pub(super) fn clear(&mut self) {
        self.handed_out += self.held.len() as u64;
        self.held.clear();
    }

    pub(super) fn handed_out(&self) -> u64 {
        self.handed_out
    }
}

impl<D: Dynamics<f64>> Observer<f64, D> for Stream {
    #[inline(always)]
    fn event(&mut self, event: &Event<f64>) {
        let Some(Window { from, to }) = self.window else { return };
        if event.time >= from && event.time <= to {
            if self.held.is_empty() {
                self.first = self.seen;
            }
            self.held.push(*event);
        }
        self.seen += 1;
    }

    #[inline(always)]
    fn flight(&mut self, _: usize, _: &D::Flight) {}
}
