//! What the benchmarks share: the clock, random numbers, and attitudes against a table.

#![allow(
    dead_code,
    reason = "each of the benchmarks that include this file uses its own part"
)]

use std::time::Instant;

/// Free tops: moments, L at the start, and the time over which states are asked.
pub const FREE_BODIES: [(&str, [f64; 3], [f64; 3], f64); 9] = [
    ("ordinary", [0.6, 0.8, 1.0], [1.8, 0.4, -0.9], 10.0),
    ("lamina", [1.0, 2.0, 3.0], [0.9, 1.5, 2.4], 10.0),
    ("the other sector", [0.6, 0.8, 1.0], [0.9, 0.4, 1.8], 10.0),
    ("racket, 1e-3", [1.0, 2.0, 3.0], [1e-3, 2.0, 3e-3], 100.0),
    (
        "2e-12 from the edge",
        [1.5, 3.0, 4.0],
        [1.0, 0.5, 2.0 + 4e-12],
        100.0,
    ),
    ("separatrix", [1.5, 3.0, 4.0], [1.0, 0.5, 2.0], 10.0),
    ("symmetric", [1.0, 1.0, 1.5], [0.3, 0.4, 2.0], 10.0),
    ("sphere", [1.0, 1.0, 1.0], [0.3, 0.4, 2.0], 10.0),
    ("a million turns", [0.6, 0.8, 1.0], [1.8, 0.4, -0.9], 1e6),
];

/// Least time of `runs` calls, seconds.
pub fn least(runs: usize, mut work: impl FnMut()) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..runs {
        let start = Instant::now();
        work();
        best = best.min(start.elapsed().as_secs_f64());
    }
    best
}

/// The same, with no further run once a second is gone: integrators that need seconds are steady enough.
pub fn least_of_few(runs: usize, mut work: impl FnMut()) -> f64 {
    let (mut best, mut gone) = (f64::INFINITY, 0.0);
    for _ in 0..runs {
        let once = least(1, &mut work);
        (best, gone) = (best.min(once), gone + once);
        if gone > 1.0 {
            break;
        }
    }
    best
}

/// Whether this is `cargo test --benches`, which passes a flag: there is nothing to measure then.
pub fn only_tested() -> bool {
    std::env::args().any(|argument| argument == "--test")
}

/// The angle of q⁻¹p from its vector and scalar parts: that between the attitudes, radians, good to about 2e-16.
pub fn angle(p: [f64; 4], q: [f64; 4]) -> f64 {
    let [w, x, y, z] = p;
    let [a, b, c, d] = q;
    let i = a * x - b * w - c * z + d * y;
    let j = a * y + b * z - c * w - d * x;
    let k = a * z - b * y + c * x - d * w;
    let real = a * w + b * x + c * y + d * z;
    2.0 * i.hypot(j).hypot(k).atan2(real.abs())
}
