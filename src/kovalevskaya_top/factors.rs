//! The theta functions of the azimuth: which half periods belong to them (8.2).

use std::sync::Arc;

use nalgebra::Complex;

use super::constants::{Constants, Phase};
use super::exact::Exact;
use super::periods::{Half, MEASURES};
use super::theta::{Sums, Theta, join, unit};

type Number = Complex<f64>;

/// θ(v − a) for one a.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Factor {
    theta: Arc<Theta>,
    /// e^{−2πi Re a}, but for a half period along the real directions.
    turn: [Number; 2],
    half: [u8; 2],
    twisted: bool,
}

/// e^{2πiv} at a state, and what tells a fit.
struct Witness {
    z: [Number; 2],
    /// A₊′/2 and A₋′/2.
    rates: [f64; 2],
    /// 1 + z₃ and 1 − z₃.
    heights: [f64; 2],
}

/// States that tell which half periods belong to a, and from which α is taken as a mean, where its whole turns are all that is in question as a rule.
const WITNESSES: i32 = 6;

/// The largest disagreement about α between them.
const TRUSTED: f64 = 1e-9;

/// G₊ or G₋.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Product {
    pub factors: [Factor; 2],
    /// α by the witnesses, each trusted as far as its quotient is well-conditioned; and how far one of them is from it, roughly.
    pub rate: f64,
    pub scatter: f64,
}

impl Factor {
    /// At e^{2πiv}.
    pub fn value(&self, [z1, z2]: [Number; 2]) -> Number {
        let sums = self.theta.at([self.turn[0] * z1, self.turn[1] * z2]);
        join(&sums, self.half, self.twisted)
    }
}

impl Witness {
    /// States spread over the torus.
    fn some(constants: &Constants, exact: &Exact) -> Vec<Self> {
        let l = constants.l.value();
        (0..WITNESSES)
            .filter_map(|n| {
                // Multiples of the plastic number's powers spread most evenly.
                let part = |x: f64| (0.1 + f64::from(n) * x).fract();
                let v = [part(0.754_877_666_246_692_7), part(0.569_840_290_998_053_2)];
                let [_, _, r, .., z3]: Phase = exact.at_turns(constants, v);
                let heights = [1.0 + z3, 1.0 - z3];
                let rates = [(l + 0.5 * r) / heights[0], (l - 0.5 * r) / heights[1]];
                rates.iter().all(|x| x.is_finite()).then_some(Self {
                    z: v.map(unit),
                    rates,
                    heights,
                })
            })
            .collect()
    }
}

// ANCHOR: choice
/// G₊ and G₋: a is half of the integrals to Z, on the sheet that the sign of N tells, and one of sixteen half periods, of which h makes eight pairs; for G₋ the one to e₄ besides.
///
/// Which of the eight it is depends on the signs of the roots with which the start was found; the one that fits is told by A′/2 + 2 d arg G/dt being the same α everywhere.
pub(super) fn products(constants: &Constants, exact: &Exact) -> Option<[Product; 2]> {
    let (curve, advance) = (&exact.curve, exact.advance());
    let sheet = -(1_f64.copysign(constants.residue().high()));
    let [real, imaginary] = curve
        .point(constants, &exact.separation)
        .map(|part| part.map(|x| sheet * x));
    let witnesses = Witness::some(constants, exact);
    let mut factors = Vec::with_capacity(16);
    for m in MEASURES {
        let moved = m.map(|x| 0.5 * f64::from(x));
        let (imaginary, whole) = curve.reduced(
            [0, 1].map(|i| imaginary[i] + curve.y[i][0] * moved[0] + curve.y[i][1] * moved[1]),
        );
        let theta = Arc::new(Theta::prepare(curve.y, imaginary)?);
        // Re τ(m/2 − whole), the same in both components.
        let twist = curve.twist(moved[0] + moved[1] - whole[0] - whole[1]);
        let turn = real.map(|x| unit(-x - twist));
        let sums: Vec<[Sums; 2]> = witnesses
            .iter()
            .map(|Witness { z, .. }| theta.with_rates([turn[0] * z[0], turn[1] * z[1]], advance))
            .collect();
        for n in MEASURES {
            // d arg θ/dt at every witness.
            let turning = sums.iter().map(|sums| {
                let [value, rate] = sums.each_ref().map(|sums| join(sums, n, curve.twisted));
                (rate / value).im
            });
            let factor = Factor {
                theta: theta.clone(),
                turn,
                half: n,
                twisted: curve.twisted,
            };
            factors.push((Half { n, m }, factor, turning.collect::<Vec<f64>>()));
        }
    }
    let product = |side: usize, halves: [Half; 2]| {
        let pair = halves.map(|half| factors.iter().find(|(of, ..)| *of == half));
        let [Some((_, one, turning)), Some((_, other, besides))] = pair else {
            return None;
        };
        let seen = || {
            let both = turning.iter().zip(besides).map(|(x, y)| 2.0 * (x + y));
            let rates = witnesses.iter().zip(both);
            rates.map(|(w, rate)| (w.heights[side].powi(2), w.rates[side] + rate))
        };
        let weights: f64 = seen().map(|(weight, _)| weight).sum();
        let rate = seen().map(|(weight, x)| weight * x).sum::<f64>() / weights;
        let off = |(weight, x): (f64, f64)| weight * (x - rate).abs();
        Some(Product {
            factors: [one.clone(), other.clone()],
            rate,
            scatter: seen().map(off).sum::<f64>() / weights,
        })
    };
    let [.., fourth, fifth] = curve.roots;
    factors
        .iter()
        .filter_map(|&(half, ..)| {
            let other = half.plus(fourth);
            let plus = product(0, [half, other.plus(fifth)])?;
            Some([plus, product(1, [other, half.plus(fifth)])?])
        })
        .filter(|both| {
            both.iter()
                .all(|one| one.scatter < TRUSTED * (1.0 + one.rate.abs()))
        })
        .min_by(|x, y| x[0].scatter.total_cmp(&y[0].scatter))
}
// ANCHOR_END: choice
