//! Holds gases of hard discs to what is known of them, at full size.
//!
//! `gas_campaign [PART] [SCALE]`; `make campaign-gas` runs all parts. Each case prints one line, its progress goes to the
//! standard error output, and the program ends with 1 if a bound was broken. A scale below one makes runs so much shorter;
//! bounds of what is measured by chance are then wider by the square root of it.
//!
//! | part | what |
//! |---|---|
//! | `truth` | Z, collision rate, free path and speeds of the fluid, from a packing fraction of 0.1 to 0.65 |
//! | `dense` | Z close to freezing |
//! | `billion` | 1e9 events among 1e4 discs: overlaps, energy, momentum |
//! | `million` | 1e8 events among 1e6 discs: the same |
//! | `cost` | what measuring costs in time |
//! | `memory` | what a disc of a million costs in memory |

// A program that prints what it found, and breaks off where it cannot go on.
#![allow(clippy::print_stdout, clippy::print_stderr, clippy::expect_used, clippy::disallowed_methods)]

mod audit;
mod cost;
mod long;
mod memory;
mod truth;
mod verdict;

use std::process::ExitCode;
use verdict::Verdict;

#[global_allocator]
static ALLOCATOR: peak_alloc::PeakAlloc = peak_alloc::PeakAlloc;

type Part = fn(f64, &mut Verdict);

const PARTS: [(&str, Part); 6] = [
    ("truth", truth::fluid),
    ("dense", truth::dense),
    ("billion", long::billion),
    ("million", long::million),
    ("cost", cost::cost),
    ("memory", memory::memory),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let asked = arguments.first().map_or("all", String::as_str);
    let scale = arguments.get(1).map_or(Ok(1.0), |text| text.parse::<f64>());
    let parts: Vec<_> = PARTS.iter().filter(|(name, _)| asked == "all" || asked == *name).collect();
    let scale = match scale {
        Ok(scale) if scale > 0.0 && scale.is_finite() && !parts.is_empty() && arguments.len() <= 2 => scale,
        _ => {
            let names = PARTS.map(|(name, _)| name).join(", ");
            eprintln!(
                "gas_campaign [PART] [SCALE]: the part is all, or one of {names}; the scale a positive number"
            );
            return ExitCode::from(2);
        }
    };
    let mut verdict = Verdict::default();
    for (name, part) in parts {
        println!("# {name}, scale {scale}");
        part(scale, &mut verdict);
    }
    verdict.end()
}
