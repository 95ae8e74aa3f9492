//! The truth about equations that have neither series nor closed form here: Gragg's rule, extrapolated to order 20 in double-doubles.

use support::double_double::Dd;
use support::greatest;

/// Columns of the extrapolation: the rule with 2, 4, … 20 parts, as many as it takes.
const COLUMNS: usize = 10;
/// Error of a step.
const TOLERANCE: f64 = 1e-21;

/// Where a motion is.
#[derive(Debug, Clone, Copy)]
pub struct Place<const N: usize> {
    pub time: Dd,
    pub state: [Dd; N],
}

/// The state a step later, and the estimate of its error.
fn step<const N: usize>(
    rate: &impl Fn(Dd, &[Dd; N]) -> [Dd; N],
    from: &Place<N>,
    length: Dd,
    scales: &[f64; N],
) -> ([Dd; N], f64) {
    let mut table: [[[Dd; N]; COLUMNS]; 2] = [[[Dd::ZERO; N]; COLUMNS]; 2];
    let first = rate(from.time, &from.state);
    let mut error = f64::INFINITY;
    for k in 0..COLUMNS {
        let parts = 2 * (k + 1);
        let h = length / parts as f64;
        let mut before = from.state;
        let mut now: [Dd; N] = core::array::from_fn(|i| before[i] + h * first[i]);
        for n in 1..parts {
            let slope = rate(from.time + h * n as f64, &now);
            let next = core::array::from_fn(|i| before[i] + 2.0 * h * slope[i]);
            (before, now) = (now, next);
        }
        // Gragg's last step: the mean of both chains.
        let slope = rate(from.time + length, &now);
        let (old, new) = (table[(k + 1) % 2], &mut table[k % 2]);
        new[0] = core::array::from_fn(|i| 0.5 * (now[i] + before[i] + h * slope[i]));
        for j in 1..=k {
            let ratio = Dd::from((k + 1) as f64 / (k + 1 - j) as f64);
            let weight = 1.0 / (ratio * ratio - 1.0);
            let (coarse, fine) = (old[j - 1], new[j - 1]);
            new[j] = core::array::from_fn(|i| fine[i] + (fine[i] - coarse[i]) * weight);
        }
        if k > 2 {
            let off = |i: usize| (new[k][i] - new[k - 1][i]).value().abs() / scales[i];
            error = greatest((0..N).map(off));
            if error < TOLERANCE {
                return (new[k], error);
            }
        }
    }
    (table[(COLUMNS - 1) % 2][COLUMNS - 1], error)
}

/// What a leg comes to.
pub struct Leg<const N: usize> {
    /// The states at the times within the leg.
    pub samples: Vec<[Dd; N]>,
    pub end: Place<N>,
    /// The event ended it, not the last time.
    pub met: bool,
}

/// From one place on through the times (s, ascending) to `end`, or until `event` falls through zero, if there is one. No step is longer than
/// `longest`, so that no event is stepped over.
pub fn followed<const N: usize>(
    rate: impl Fn(Dd, &[Dd; N]) -> [Dd; N],
    from: Place<N>,
    scales: &[f64; N],
    times: &[f64],
    end: Dd,
    longest: f64,
    event: impl Fn(&[Dd; N]) -> Dd,
) -> Leg<N> {
    let mut samples = Vec::new();
    let mut here = from;
    let mut length = longest * 1e-3;
    // The state where the step begins may be the event itself: only a step away it counts.
    loop {
        let next = times.get(samples.len()).map(|&t| Dd::from(t));
        let next = next.filter(|t| *t <= end);
        let goal = next.unwrap_or(end);
        let left = (goal - here.time).value();
        if left <= 0.0 {
            if next.is_some() {
                samples.push(here.state);
                continue;
            }
            let (end, met) = (here, false);
            return Leg { samples, end, met };
        }
        let cut = left <= length;
        let taken = if cut {
            goal - here.time
        } else {
            Dd::from(length)
        };
        let (state, error) = step(&rate, &here, taken, scales);
        let grown = (TOLERANCE / error).powf(1.0 / (2 * COLUMNS - 1) as f64) * 0.8;
        if error > TOLERANCE {
            length = taken.value() * grown.clamp(0.1, 0.8);
            let time = here.time;
            assert!(
                length > 1e-30 * longest,
                "the step has become nothing at {time:?}"
            );
            continue;
        }
        if event(&state).value() < 0.0 {
            let (wait, state) = located(&rate, &here, taken, scales, &event);
            let (time, met) = (here.time + wait, true);
            let end = Place { time, state };
            return Leg { samples, end, met };
        }
        if !cut || grown > 1.0 {
            let before = if cut { length } else { 0.0 };
            length = (taken.value().max(before) * grown.clamp(0.2, 4.0)).min(longest);
        }
        let time = if cut { goal } else { here.time + taken };
        here = Place { time, state };
    }
}

/// The states at these times (s, ascending) from time 0 on; the rate, which is told the number of the piece, may change its form at the corners.
pub fn pieced<const N: usize>(
    rate: impl Fn(usize, Dd, &[Dd; N]) -> [Dd; N],
    state: [Dd; N],
    scales: &[f64; N],
    corners: &[Dd],
    times: &[f64],
    longest: f64,
) -> Vec<[Dd; N]> {
    let mut rows = Vec::new();
    let (time, last) = (Dd::ZERO, Dd::from(times[times.len() - 1]));
    let mut here = Place { time, state };
    for (piece, &end) in corners.iter().chain([&last]).enumerate() {
        if rows.len() == times.len() {
            break;
        }
        // No further than asked for.
        let end = if end > last { last } else { end };
        let (rate, left) = (|t, y: &_| rate(piece, t, y), &times[rows.len()..]);
        let leg = followed(rate, here, scales, left, end, longest, |_| Dd::from(1.0));
        rows.extend(leg.samples);
        here = leg.end;
    }
    rows
}

/// When within a step the event comes, by secants that keep the root between them.
fn located<const N: usize>(
    rate: &impl Fn(Dd, &[Dd; N]) -> [Dd; N],
    from: &Place<N>,
    length: Dd,
    scales: &[f64; N],
    event: &impl Fn(&[Dd; N]) -> Dd,
) -> (Dd, [Dd; N]) {
    let at = |h: Dd| step(rate, from, h, scales).0;
    let (mut low, mut high) = (Dd::ZERO, length);
    let (mut below, mut above) = (event(&from.state), event(&at(length)));
    let mut best = (length, at(length));
    for _ in 0..80 {
        let mut h = low + (high - low) * (below / (below - above));
        if !(h.value() > low.value() && h.value() < high.value()) {
            h = (low + high) * 0.5;
        }
        let state = at(h);
        let value = event(&state);
        let moved = (h - best.0).abs().value();
        best = (h, state);
        if value.value() == 0.0 || moved <= 1e-29 * length.value() {
            break;
        }
        if value.value() > 0.0 {
            (low, below) = (h, value);
            above = above * 0.5;
        } else {
            (high, above) = (h, value);
            below = below * 0.5;
        }
    }
    best
}
