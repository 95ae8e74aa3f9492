//! Timing by the least time of repeated calls, which other work on the machine disturbs least.

use std::time::Instant;

/// Least duration of the calls, s; [`LONG`] is about the greatest.
const SHORT: f64 = 0.02;
const LONG: f64 = 0.1;
/// Reading the clock costs some 30 ns, so calls are bundled into lots of this length, s.
const LOT: f64 = 2e-5;
const FEWEST: u32 = 5;

/// Seconds a call, from the fastest lot of calls. It ends after five lots and 0.02 s, or after 0.1 s.
pub fn least(mut work: impl FnMut()) -> f64 {
    let begin = Instant::now();
    work();
    let mut least = begin.elapsed().as_secs_f64();
    let lot = (LOT / least).clamp(1.0, 1000.0) as u32;
    let mut lots = 1;
    loop {
        let spent = begin.elapsed().as_secs_f64();
        if spent >= LONG || lots >= FEWEST && spent >= SHORT {
            return least;
        }
        let start = Instant::now();
        for _ in 0..lot {
            work();
        }
        least = least.min(start.elapsed().as_secs_f64() / f64::from(lot));
        lots += 1;
    }
}

/// Seconds a call of several functions, alternating in five rounds, so that all of them run under the same conditions.
pub fn in_turn<const N: usize>(mut works: [&mut dyn FnMut(); N]) -> [f64; N] {
    let mut best = [f64::INFINITY; N];
    for _ in 0..5 {
        for (best, work) in best.iter_mut().zip(&mut works) {
            *best = best.min(least(work));
        }
    }
    best
}
