//! The angle about the vertical by theta functions (8.2).
//!
//! ξ = X + iY, the two horizontal axes of space seen from the body, obeys the same equation as z. From η₁² = ξ₁ + iξ₂ and
//! η₂² = −(ξ₁ − iξ₂), so that η₁η₂ = ξ₃, come two quadratures, for the phases of η₁²  and η₂²:
//!
//! ∫(−r/2 + A₋′/2)dt and ∫(r/2 + A₊′/2)dt, A±′ = (2l ± r)/(1 ± z₃).
//!
//! A₊′ has poles where z₁ + iz₂ = 0 or z₁ − iz₂ = 0 with z₃ = −1, at complex times only. With m = Ω₁² + Ω₂² these states make the curve
//! r²(c²+m²−k²) + 4lc²r + 4l²c² + 2(m−3l₁)(m²−k²) = 0, and this is w² = P(s) again: m = l₁ − 2s. On the complex torus of the motion the two curves
//! are copies of the curve itself, moved apart by the integrals from ∞ to Z (s = l² − l₁), and A₊/2 less something that grows evenly is −2 arg G₊,
//!
//! G = θ(v − a) θ(v − a − h), v the turns of the two phases, halved, a half of those integrals, h the half period from e₄ to e₅.
//!
//! With z₃ = 1 the same comes out but for a half period added to a. So the azimuth of the third axis, the phase of ξ₃, is αt − arg G₊G₋.

use core::f64::consts::{PI, TAU};
use std::sync::Arc;

use nalgebra::{Complex, Quaternion};

use super::constants::{Constants, Phase, WidePhase};
use super::exact::{Exact, Reason, Trial};
use super::periods::{Curve, Half, MEASURES};
use super::taylor::{Carried, Series, about_third, shortest};
use super::theta::{Pinched, Theta, join, unit};
use crate::precise::{DoubleDouble, Number as _, RIGHT_ANGLE};

type Number = Complex<f64>;

/// A motion solved by separation, attitude and all.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Precession {
    pub exact: Exact,
    /// G₊ and G₋, two factors each.
    products: [Product; 2],
    /// α₊ and α₋; their mean is α.
    rates: [DoubleDouble; 2],
    /// arg ξ₃G₊G₋ at time 0.
    angle: f64,
    /// 2 arg η₂²G₊²√K and 2 arg η₁²G₋²/√K at time 0.
    doubled: [f64; 2],
}

/// The largest disagreement about the angles at time 0, relative to the sine of the tilt.
const TRUSTED: f64 = 1e-11;

/// Where the sine of the tilt and K are both as small as this, their directions are rounding, a digit of the attitude.
const POINTING: f64 = 1e-3;

impl Precession {
    pub fn find(constants: &Constants, wide: &WidePhase, whole: &Carried) -> Result<Self, Reason> {
        let (exact, trial) = Exact::find(constants, wide, whole)?;
        let products = products(constants, &exact).ok_or(Reason::DoubleRoot)?;
        let known = Curve::rate(constants, &exact.separation);
        let rates = products.each_ref().map(|product| {
            let known = settled(known, product.rate, exact.advance);
            // Beside a double root the integrals may lose digits, and the states know better.
            let off = (known.value() - product.rate).abs();
            if off <= 16.0 * product.scatter {
                known
            } else {
                DoubleDouble::from(product.rate)
            }
        });
        let mut precession = Self {
            exact,
            products,
            rates,
            angle: 0.0,
            doubled: [0.0; 2],
        };
        if precession.set_out(constants, &trial) {
            Ok(precession)
        } else {
            Err(Reason::DoubleRoot)
        }
    }

    /// The angles at time 0, from several states soon after: at one instant the third axis may be nearly upright, or rounding just there the
    /// worst. Says whether they agree.
    fn set_out(&mut self, constants: &Constants, trial: &Trial) -> bool {
        let seen: Vec<[Number; 3]> = trial
            .iter()
            .map(|&(t, (state, attitude))| {
                let sight = self.sight(constants, t, &state, attitude);
                let [a, b] = self.rates.map(|rate| 2.0 * rate.value() * t);
                [
                    sight.third * Number::cis(-0.25 * (a + b)),
                    sight.doubled[0] * Number::cis(-a),
                    sight.doubled[1] * Number::cis(-b),
                ]
            })
            .collect();
        let [third, first, second] =
            [0, 1, 2].map(|i| seen.iter().map(|all| all[i]).sum::<Number>());
        self.angle = third.arg();
        self.doubled = [first.arg(), second.arg()];
        let mean = third.conj() / third.norm();
        // The attitude is as uncertain as the azimuth where the axis leans most: next to the vertical all the time it points nowhere.
        let most = seen
            .iter()
            .fold(0.0_f64, |most, all| most.max(all[0].norm()));
        seen.iter()
            .all(|all| (all[0] * mean).im.abs() < TRUSTED * most)
    }

    /// What keeps pace with the time, seen from an attitude.
    fn sight(
        &self,
        constants: &Constants,
        t: f64,
        &[p, q, _, z1, z2, _]: &Phase,
        attitude: Quaternion<f64>,
    ) -> Sight {
        let v = self.exact.halved(t);
        let place = (v, v.map(unit));
        let products = self.products.each_ref().map(|Product { factors, .. }| {
            let product = factors[0].value(&place) * factors[1].value(&place);
            product / product.norm()
        });
        let c = constants.c.value();
        let x = Number::new(p, q);
        let k = x * x - c * Number::new(z1, z2);
        let size = p * p + q * q + c;
        let [third, first, second] = horizontal(attitude);
        let fourth = |eta: Number, g: Number| {
            let square = eta * g * g;
            square * square
        };
        Sight {
            third: third * products[0] * products[1],
            doubled: [
                fourth(second, products[0]) * k / size,
                fourth(first, products[1]) * k.conj() / size,
            ],
        }
    }

    /// The state and how it stands, from the exact Ω and z: z upright, and the third axis at its azimuth.
    pub fn carried(&self, constants: &Constants, t: f64) -> Carried {
        let state = self.exact.state(constants, t);
        let (attitude, told) = self.turned(constants, t, &state);
        if told > POINTING {
            return (state, attitude);
        }
        // From a moment ago, when the third axis leaned: what is missing is a turn about the vertical.
        let series = Series::<f64, 10>::of(constants.c.value(), &(state, attitude));
        let ago = series.reach.min(1.0);
        let (before, rough) = series.carried(-ago);
        let (known, better) = self.turned(constants, t - ago, &before);
        if better < told {
            return (state, attitude);
        }
        let missing = known * rough.conjugate();
        let turn = 2.0 * missing.k.atan2(missing.w);
        (state, about_third(turn) * attitude)
    }

    /// How a state stands, and how well its azimuth is told.
    fn turned(&self, constants: &Constants, t: f64, state: &Phase) -> (Quaternion<f64>, f64) {
        let &[.., z1, z2, z3] = state;
        let upright = shortest([z1, z2, z3]);
        let sight = self.sight(constants, t, state, upright);
        let mean = (self.rates[0] + self.rates[1]).scaled(0.5);
        let third = self.angle + gained(mean, t) - sight.third.arg();
        // Near the poles the third axis points nowhere; there η₁ or η₂ tells the angle, but for half a turn, unless K is small. Which is better is told by the sine of the
        // tilt and the size of K.
        let side = usize::from(z3 < 0.0);
        let other = sight.doubled[side];
        let [tilt, size] = [sight.third.norm(), other.norm() / (1.0 + z3.abs()).powi(2)];
        let angle = if tilt < size {
            let half = 0.5 * (self.doubled[side] - other.arg()) + gained(self.rates[side], t);
            half + PI * ((third - half) / PI).round()
        } else {
            third
        };
        (about_third(angle) * upright, tilt.max(size))
    }
}

/// What an angle gains in a time, but for whole turns.
fn gained(rate: DoubleDouble, t: f64) -> f64 {
    let angle = rate * DoubleDouble::from(t);
    let turns = DoubleDouble::from((angle.value() / TAU).round());
    (angle - RIGHT_ANGLE.scaled(4.0) * turns).value()
}

/// The rate that is nearest to a rough one among those that half turns of v set apart.
fn settled(known: DoubleDouble, rough: f64, advance: [DoubleDouble; 2]) -> DoubleDouble {
    const MOST: i32 = 8;
    let turns = advance.map(|x| x * RIGHT_ANGLE.scaled(2.0));
    let all = (-MOST..=MOST).flat_map(|i| (-MOST..=MOST).map(move |j| [i, j].map(f64::from)));
    let off = |x: &DoubleDouble| (x.value() - rough).abs();
    all.map(|[i, j]| known + turns[0].times(i) + turns[1].times(j))
        .min_by(|x, y| off(x).total_cmp(&off(y)))
        .unwrap_or(known)
}

/// ξ₃, η₁² and η₂² as they follow from an attitude: the horizontal parts of the body's axes.
fn horizontal(q: Quaternion<f64>) -> [Number; 3] {
    let third = 2.0 * Number::new(q.i * q.k + q.w * q.j, q.j * q.k - q.w * q.i);
    let axis1 = Number::new(
        1.0 - 2.0 * (q.j * q.j + q.k * q.k),
        2.0 * (q.i * q.j + q.w * q.k),
    );
    let axis2 = Number::new(
        2.0 * (q.i * q.j - q.w * q.k),
        1.0 - 2.0 * (q.i * q.i + q.k * q.k),
    );
    let i = Number::new(0.0, 1.0);
    [third, axis1 + i * axis2, i * axis2 - axis1]
}

/// What advances evenly, where it is not rounding.
struct Sight {
    /// ξ₃G₊G₋, G± of length 1.
    third: Number,
    /// η₂⁴G₊⁴K and η₁⁴G₋⁴K̄, as parts of the largest that K may be.
    doubled: [Number; 2],
}

/// θ(v − a) for one a.
#[derive(Debug, Clone, PartialEq)]
struct Factor {
    function: Arc<Function>,
    half: Half,
}

/// That without half periods along the real directions, and after the modular transformation without any.
#[derive(Debug, Clone, PartialEq)]
enum Function {
    Plain {
        theta: Theta,
        /// e^{−2πi Re a}.
        turn: [Number; 2],
        twisted: bool,
    },
    Pinched {
        functions: Pinched,
        a: [Number; 2],
    },
}

/// v and e^{2πiv}.
type Place = ([f64; 2], [Number; 2]);

/// What tells a fit at a state.
struct Witness {
    place: Place,
    /// A₊′/2 and A₋′/2.
    rates: [f64; 2],
    /// 1 + z₃ and 1 − z₃.
    heights: [f64; 2],
}

/// States that tell which half periods belong to a, and from which α is taken as a mean, where its whole turns are all that is in question as a rule.
const WITNESSES: i32 = 6;

/// The largest disagreement about α between them.
const AGREEING: f64 = 1e-9;

/// G₊ or G₋.
#[derive(Debug, Clone, PartialEq)]
struct Product {
    factors: [Factor; 2],
    /// α by the witnesses, each trusted as far as its quotient is well-conditioned; and how far one of them is from it, roughly.
    rate: f64,
    scatter: f64,
}

impl Factor {
    fn value(&self, (v, z): &Place) -> Number {
        match &*self.function {
            Function::Plain {
                theta,
                turn,
                twisted,
            } => {
                let sums = theta.at([turn[0] * z[0], turn[1] * z[1]]);
                join(&sums, self.half.n, *twisted)
            }
            Function::Pinched { functions, a } => {
                let ([[one, _], [other, _]], _) = functions.parts(self.half, *v, 1.0, *a, [0.0; 2]);
                one + other
            }
        }
    }
}

impl Function {
    /// d arg θ/dt for each of four half periods n if v changes at these rates.
    fn turning(&self, m: [u8; 2], (v, z): &Place, rates: [f64; 2]) -> [f64; 4] {
        match self {
            Self::Plain {
                theta,
                turn,
                twisted,
            } => {
                let sums = theta.with_rates([turn[0] * z[0], turn[1] * z[1]], rates);
                MEASURES.map(|n| {
                    let [value, rate] = sums.each_ref().map(|sums| join(sums, n, *twisted));
                    (rate / value).im
                })
            }
            Self::Pinched { functions, a } => MEASURES.map(|n| {
                let ([one, other], _) = functions.parts(Half { n, m }, *v, 1.0, *a, rates);
                ((one[1] + other[1]) / (one[0] + other[0])).im
            }),
        }
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
                let v = if exact.closed {
                    exact.halved(f64::from(n) - 2.5)
                } else {
                    [part(0.754_877_666_246_692_7), part(0.569_840_290_998_053_2)]
                };
                let [_, _, r, .., z3]: Phase = exact.at_turns(constants, v);
                let heights = [1.0 + z3, 1.0 - z3];
                let rates = [(l + 0.5 * r) / heights[0], (l - 0.5 * r) / heights[1]];
                rates.iter().all(|x| x.is_finite()).then_some(Self {
                    place: (v, v.map(unit)),
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
fn products(constants: &Constants, exact: &Exact) -> Option<[Product; 2]> {
    let (curve, advance) = (&exact.curve, exact.advance());
    let sheet = -(1_f64.copysign(exact.separation.residue.high()));
    let [real, imaginary] = curve
        .point(&exact.separation)
        .map(|part| part.map(|x| sheet * x));
    let witnesses = Witness::some(constants, exact);
    let mut factors = Vec::with_capacity(16);
    for m in MEASURES {
        let function = Arc::new(if let Some(functions) = exact.torus.pinched() {
            let (imaginary, whole) = curve.reduced(imaginary);
            let twist = curve.twist(-whole[0] - whole[1]);
            Function::Pinched {
                functions: functions.clone(),
                a: [0, 1].map(|i| Number::new(real[i] + twist, imaginary[i])),
            }
        } else {
            let moved = m.map(|x| 0.5 * f64::from(x));
            let (imaginary, whole) = curve.reduced(
                [0, 1].map(|i| imaginary[i] + curve.y[i][0] * moved[0] + curve.y[i][1] * moved[1]),
            );
            // Re τ(m/2 − whole), the same in both components.
            let twist = curve.twist(moved[0] + moved[1] - whole[0] - whole[1]);
            Function::Plain {
                theta: Theta::prepare(curve.y, imaginary)?,
                turn: real.map(|x| unit(-x - twist)),
                twisted: curve.twisted,
            }
        });
        let turning: Vec<[f64; 4]> = witnesses
            .iter()
            .map(|witness| function.turning(m, &witness.place, advance))
            .collect();
        for (i, n) in MEASURES.into_iter().enumerate() {
            let half = Half { n, m };
            let factor = Factor {
                function: function.clone(),
                half,
            };
            let turning: Vec<f64> = turning.iter().map(|all| all[i]).collect();
            factors.push((half, factor, turning));
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
                .all(|one| one.scatter < AGREEING * (1.0 + one.rate.abs()))
        })
        .min_by(|x, y| x[0].scatter.total_cmp(&y[0].scatter))
}
// ANCHOR_END: choice
