//! Lines, bounds, and whether all bounds held.

use std::io::Write;
use std::process::ExitCode;

/// What has been found so far.
#[derive(Default)]
pub struct Verdict {
    lines: u32,
    broken: u32,
}

/// A number that may be no larger than its bound, but for its sign.
pub struct Bounded {
    pub name: &'static str,
    pub value: f64,
    pub bound: f64,
}

impl Bounded {
    /// By how much `value` is off, as a part of what was expected.
    pub fn relative(name: &'static str, value: f64, expected: f64, bound: f64) -> Self {
        Self { name, value: value / expected - 1.0, bound }
    }

    /// Small numbers with their exponents, others as they are.
    fn told(&self) -> String {
        let Self { name, value, bound } = self;
        match bound {
            ..0.0 | 0.0 | 1.0.. => format!("{name} {value:.0} (≤ {bound:.0})"),
            0.1.. => format!("{name} {value:+.3} (≤ {bound:.2})"),
            _ => format!("{name} {value:+.1e} (≤ {bound:.1e})"),
        }
    }

    /// No number is within no bound.
    fn is_within(&self) -> bool {
        self.value.abs() <= self.bound
    }
}

impl Verdict {
    /// Prints the line of a case: what it is, and the numbers that have bounds.
    pub fn line(&mut self, case: &str, numbers: &[Bounded]) {
        let all: Vec<String> = numbers.iter().map(Bounded::told).collect();
        let broken: Vec<&str> =
            numbers.iter().filter(|number| !number.is_within()).map(|number| number.name).collect();
        let end = if broken.is_empty() { "ok".to_owned() } else { format!("BROKEN: {}", broken.join(", ")) };
        clear_progress();
        println!("{case}  {}  {end}", all.join("  "));
        self.lines += 1;
        self.broken += u32::from(!broken.is_empty());
    }

    /// A case that could not be gone through with.
    pub fn failure(&mut self, case: &str, why: &str) {
        clear_progress();
        println!("{case}  BROKEN: {why}");
        self.lines += 1;
        self.broken += 1;
    }

    /// The last line, and what the program says to those who called it.
    pub fn end(&self) -> ExitCode {
        println!("{} of {} cases within their bounds", self.lines - self.broken, self.lines);
        if self.broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}

/// Says on the standard error output how far a case has come, in place of what was said before.
pub fn progress(case: &str, share: f64) {
    eprint!("\r\x1b[K{case}: {:.0} %", 100.0 * share);
    // A line that is not shown is no reason to break off.
    let _ = std::io::stderr().flush();
}

fn clear_progress() {
    eprint!("\r\x1b[K");
}
