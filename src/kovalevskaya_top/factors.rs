//! The theta functions of the azimuth: which half periods belong to them (8.2).

use nalgebra::Complex;

use super::constants::{Constants, Phase};
use super::exact::Exact;
use super::periods::{Half, MEASURES};
use super::theta::{Theta, join, unit};

type Number = Complex<f64>;

/// θ(±v − a) for one a.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Factor {
    pub theta: Theta,
    place: Place,
    twisted: bool,
}

/// Where a factor is taken: v or −v less this, and a half period along the real directions.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place {
    sign: f64,
    /// e^{−2πi·shift}.
    turn: [Number; 2],
    half: [u8; 2],
}

impl Place {
    fn new(sign: f64, half: Half, shift: [f64; 2]) -> Self {
        Self {
            sign,
            turn: shift.map(|x| unit(-x)),
            half: half.n,
        }
    }

    /// e^{2πiw} from e^{2πiv}.
    fn at(&self, z: [Number; 2]) -> [Number; 2] {
        [0, 1].map(|i| self.turn[i] * if self.sign < 0.0 { z[i].conj() } else { z[i] })
    }
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
const WITNESSES: i32 = 4;

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
    pub fn value(&self, z: [Number; 2]) -> Number {
        let sums = self.theta.at(self.place.at(z));
        join(&sums, self.place.half, self.twisted)
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
/// G₊ and G₋: a is half of the integrals to Z, up to its sign and one of sixteen half periods, of which h makes eight pairs.
///
/// Which it is depends on the signs of the roots with which the start was found; the one that fits is told by A′/2 + 2 d arg G/dt being the same α everywhere.
pub(super) fn products(constants: &Constants, exact: &Exact) -> Option<[Product; 2]> {
    let (curve, advance) = (&exact.curve, exact.advance());
    let [real, imaginary] = curve.point(constants, &exact.separation);
    let mut thetas = Vec::with_capacity(4);
    let mut shifts = Vec::with_capacity(4);
    for m in MEASURES {
        let moved = m.map(|x| 0.5 * f64::from(x));
        let (imaginary, whole) = curve.reduced(
            [0, 1].map(|i| imaginary[i] + curve.y[i][0] * moved[0] + curve.y[i][1] * moved[1]),
        );
        thetas.push(Theta::prepare(curve.y, imaginary)?);
        // Re τ(m/2 − whole), the same in both components.
        let twist = curve.twist(moved[0] + moved[1] - whole[0] - whole[1]);
        shifts.push(real.map(|x| x + twist));
    }
    let number = |m: [u8; 2]| usize::from(2 * m[0] + m[1]);
    let factor = |sign: f64, half: Half| Factor {
        theta: thetas[number(half.m)].clone(),
        place: Place::new(sign, half, shifts[number(half.m)]),
        twisted: curve.twisted,
    };
    let witnesses = Witness::some(constants, exact);
    let mut best = [(f64::INFINITY, 0.0, 1.0, Half::default()); 2];
    for sign in [1.0, -1.0] {
        // d arg θ/dt for every witness and half period.
        let turning = witnesses.iter().map(|witness| {
            let rates = advance.map(|x| sign * x);
            let all = MEASURES.map(|m| {
                let at = Place::new(sign, Half { n: [0, 0], m }, shifts[number(m)]).at(witness.z);
                thetas[number(m)].with_rates(at, rates)
            });
            let turning = Half::all().map(|half| {
                let sums = all[number(half.m)].each_ref();
                let [value, rate] = sums.map(|sums| join(sums, half.n, curve.twisted));
                (rate / value).im
            });
            turning.collect()
        });
        let turning: Vec<Vec<f64>> = turning.collect();
        for (i, half) in Half::all().enumerate() {
            let other = Half::all().position(|x| x == half.plus(curve.between()))?;
            for (side, best) in best.iter_mut().enumerate() {
                let seen = || {
                    let rates = turning.iter().map(|all| 2.0 * (all[i] + all[other]));
                    witnesses
                        .iter()
                        .zip(rates)
                        .map(|(w, rate)| (w.heights[side].powi(2), w.rates[side] + rate))
                };
                let weights: f64 = seen().map(|(weight, _)| weight).sum();
                let rate = seen().map(|(weight, x)| weight * x).sum::<f64>() / weights;
                let off = |(weight, x): (f64, f64)| weight * (x - rate).abs();
                let scatter = seen().map(off).sum::<f64>() / weights;
                if scatter < best.0 {
                    *best = (scatter, rate, sign, half);
                }
            }
        }
    }
    let trusted =
        |&(scatter, rate, ..): &(f64, f64, f64, Half)| scatter < TRUSTED * (1.0 + rate.abs());
    best.iter().all(trusted).then(|| {
        best.map(|(scatter, rate, sign, half)| Product {
            factors: [half, half.plus(curve.between())].map(|half| factor(sign, half)),
            rate,
            scatter,
        })
    })
}
// ANCHOR_END: choice
