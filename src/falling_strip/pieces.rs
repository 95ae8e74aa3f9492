//! A fall in pieces, from one moment at which the plate turns back to the next.
//!
//! The resistance −μ₂|ω|ω has a kink where ω is zero. A step across it is in error by its jump times the cube of the step, whatever the order of the
//! method, and an estimate of the error made for smooth motions may miss it. Between two such moments |ω| is ω or −ω: there the motion is smooth.

use super::plate::Pieces;
use crate::error::Result;
use crate::integrators::{Cost, Effort, Method, Solution, Stop, System, solve, until};

/// The equations with |ω| read as `sense` · ω.
struct Piece<'a> {
    plate: &'a dyn Pieces,
    sense: f64,
}

impl System<7> for Piece<'_> {
    fn rate(&self, _: f64, state: &[f64; 7]) -> [f64; 7] {
        self.plate.rate_in(self.sense, state)
    }

    fn reached(&self, time: f64) -> Result<()> {
        self.plate.whole().reached(time)
    }
}

/// States at all of `times`, in any order, from time 0; as [`solve`], piece by piece if there is a kink.
pub(crate) fn in_pieces(
    plate: &dyn Pieces,
    start: &[f64; 7],
    scales: &[f64; 7],
    times: &[f64],
    method: Method,
    effort: Effort,
) -> Result<Solution<7>> {
    let whole = |times: &[f64]| solve(plate.whole(), 0.0, start, scales, times, method, effort);
    if !plate.has_kink() || times.iter().any(|t| !t.is_finite()) {
        return whole(times);
    }
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|&i, &j| times[i].total_cmp(&times[j]));
    let (before, after) = order.split_at(order.partition_point(|&i| times[i] < 0.0));
    let before: Vec<usize> = before.iter().rev().copied().collect();
    let mut states = vec![*start; times.len()];
    let mut cost = Cost::default();
    for places in [before.as_slice(), after] {
        let Some(&last) = places.last() else { continue };
        let end = times[last];
        let mut sense = start[5];
        if sense == 0.0 {
            // Which way it begins to turn: seen after a thousandth of the time in which it crosses its own half chord.
            let soon = (1e-3 * scales[0] / scales[3]).min(end.abs());
            let times = [soon.copysign(end)];
            let step = Effort::Step(soon);
            if soon > 0.0 {
                let run = solve(plate.whole(), 0.0, start, scales, &times, Method::Rk4, step)?;
                cost += run.cost;
                sense = run.states[0][5];
            }
        }
        let mut sense = 1.0_f64.copysign(sense);
        let (mut time, mut state) = (0.0, *start);
        let ordered: Vec<f64> = places.iter().map(|&i| times[i]).collect();
        let (mut left, mut ordered) = (places, ordered.as_slice());
        while !left.is_empty() {
            let piece = Piece { plate, sense };
            let falls = |_: f64, y: &[f64; 7]| sense * y[5];
            let run = until(
                &piece, time, &state, scales, ordered, end, &falls, method, effort,
            )?;
            cost += run.cost;
            for (&place, state) in left.iter().zip(&run.states) {
                states[place] = *state;
            }
            left = &left[run.states.len()..];
            ordered = &ordered[run.states.len()..];
            if run.stopped == Stop::AtTheEnd {
                break;
            }
            // What falls through zero is just below it: from there on it is the other sense that rises.
            (time, state, sense) = (run.time, run.end, -sense);
        }
    }
    Ok(Solution { states, cost })
}
