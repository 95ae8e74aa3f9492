//! The theta functions of the azimuth: which half periods belong to them (8.2).

use nalgebra::Complex;

use super::constants::{Constants, Phase};
use super::exact::Exact;
use super::periods::{Curve, Half, MEASURES};
use super::theta::{Sums, Theta, join, unit};

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
    /// e^{2πiw} from e^{2πiv}.
    fn at(&self, z: [Number; 2]) -> [Number; 2] {
        [0, 1].map(|i| self.turn[i] * if self.sign < 0.0 { z[i].conj() } else { z[i] })
    }
}

/// e^{2πiv} at a state, and what tells a fit.
pub(super) struct Witness {
    pub z: [Number; 2],
    /// A₊′/2 and A₋′/2.
    pub rates: [f64; 2],
    /// 1 + z₃ and 1 − z₃.
    pub heights: [f64; 2],
}

/// States from which α is taken as a mean, where its whole turns are all that is in question as a rule; and those that tell which half periods belong to a.
pub(super) const WITNESSES: usize = 6;
const DECIDING: usize = 4;

/// The largest disagreement about α between those few.
const TRUSTED: f64 = 1e-9;

impl Factor {
    pub fn value(&self, z: [Number; 2]) -> Number {
        let sums = self.theta.at(self.place.at(z));
        join(&sums, self.place.half, self.twisted)
    }

    /// d arg/dt.
    pub fn turning(&self, z: [Number; 2], advance: [f64; 2]) -> f64 {
        let rates = advance.map(|x| self.place.sign * x);
        let [value, rate] = self
            .theta
            .with_rates(self.place.at(z), rates)
            .map(|sums| join(&sums, self.place.half, self.twisted));
        (rate / value).im
    }
}

impl Witness {
    /// States spread over the torus.
    pub fn some(constants: &Constants, exact: &Exact, count: usize) -> Vec<Self> {
        let l = constants.l.value();
        (0..count)
            .filter_map(|n| {
                // Multiples of the plastic number's powers spread most evenly.
                let part = |x: f64| (0.1 + n as f64 * x).fract();
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
pub(super) fn products(
    curve: &Curve,
    point: [[f64; 2]; 2],
    witnesses: &[Witness],
    advance: [f64; 2],
) -> Option<[[Factor; 2]; 2]> {
    let [real, imaginary] = point;
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
    let place = |sign: f64, half: Half| Place {
        sign,
        turn: shifts[number(half.m)].map(|x: f64| unit(-x)),
        half: half.n,
    };
    let mut best = [(f64::INFINITY, 1.0, Half::default()); 2];
    let few = &witnesses[..DECIDING.min(witnesses.len())];
    for sign in [1.0, -1.0] {
        // d arg θ/dt for every half period and every witness.
        let turning: Vec<Vec<f64>> = few
            .iter()
            .map(|witness| {
                let all: Vec<[Sums; 2]> = MEASURES
                    .map(|m| {
                        let at = place(sign, Half { n: [0, 0], m }).at(witness.z);
                        thetas[number(m)].with_rates(at, advance.map(|x| sign * x))
                    })
                    .into();
                Half::all()
                    .map(|half| {
                        let [value, rate] = all[number(half.m)]
                            .each_ref()
                            .map(|sums| join(sums, half.n, curve.twisted));
                        (rate / value).im
                    })
                    .collect()
            })
            .collect();
        for (i, half) in Half::all().enumerate() {
            let other = Half::all().position(|x| x == half.plus(curve.between()))?;
            for (side, best) in best.iter_mut().enumerate() {
                let rates: Vec<f64> = few
                    .iter()
                    .zip(&turning)
                    .map(|(witness, turning)| {
                        witness.rates[side] + 2.0 * (turning[i] + turning[other])
                    })
                    .collect();
                let (least, most) = rates
                    .iter()
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| {
                        (a.min(x), b.max(x))
                    });
                let spread = (most - least) / (1.0 + most.abs());
                if spread < best.0 {
                    *best = (spread, sign, half);
                }
            }
        }
    }
    let factor = |sign: f64, half: Half| Factor {
        theta: thetas[number(half.m)].clone(),
        place: place(sign, half),
        twisted: curve.twisted,
    };
    best.iter().all(|x| x.0 < TRUSTED).then(|| {
        best.map(|(_, sign, half)| [half, half.plus(curve.between())].map(|h| factor(sign, h)))
    })
}
// ANCHOR_END: choice
