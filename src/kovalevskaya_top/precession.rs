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

use nalgebra::{Quaternion, UnitQuaternion};

use super::constants::{Complex, Constants, I, Phase, WidePhase};
use super::exact::{Exact, Reason, Trial};
use super::periods::{Curve, Half, MEASURES};
use super::taylor::{Carried, Series, about_third, shortest};
use super::theta::Family;
use crate::precise::{DoubleDouble, Number as _, RIGHT_ANGLE};

/// A motion solved by separation, attitude and all.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Precession {
    pub exact: Exact,
    /// The factors of G₊ and of G₋.
    family: Family,
    places: [Option<Half>; 4],
    /// α, which is the mean of α₊ and α₋, and 2α₊ and 2α₋.
    rates: [DoubleDouble; 3],
    /// The arguments at time 0 of what advances at these rates.
    angles: [f64; 3],
}

/// The largest disagreement about the angle at time 0, relative to the sine of the tilt.
const TRUSTED: f64 = 1e-11;

/// The largest disagreement about α between states.
const AGREEING: f64 = 1e-9;

/// Where the sine of the tilt and K are both as small as this, their directions are rounding, a digit of the attitude.
const POINTING: f64 = 1e-3;

impl Precession {
    pub fn find(constants: &Constants, wide: &WidePhase, whole: &Carried) -> Result<Self, Reason> {
        let (exact, trial) = Exact::find(constants, wide, whole)?;
        let quadrature = Self::quadrature(constants, exact);
        let set_out = quadrature.and_then(|found| found.set_out(constants, &trial));
        set_out.ok_or(Reason::DoubleRoot)
    }

    // ANCHOR: choice
    /// G₊ and G₋: a is half of the integrals to Z, on the sheet that the sign of N tells, and one of sixteen half periods, of which h makes eight pairs; for G₋ the one to e₄ besides.
    ///
    /// Which of the eight it is depends on the signs of the roots with which the start was found; the one that fits is told by A′/2 + 2 d arg G/dt being the same α everywhere.
    fn quadrature(constants: &Constants, exact: Exact) -> Option<Self> {
        let sheet = -(1_f64.copysign(exact.separation.residue.high()));
        let a = exact.curve.point(&exact.separation).map(|x| sheet * x);
        let pinched = exact.torus.family.pinched().cloned();
        let family = Family::prepare(&exact.curve, pinched, a, 1)?;
        let all: [Half; 16] = core::array::from_fn(|i| Half {
            m: MEASURES[i / 4],
            n: MEASURES[i % 4],
        });
        let l = constants.l.value();
        // 1 ± z₃, A±′/2 times that, and the rates of the arguments.
        let seen = exact.spread().map(|v| {
            let [_, _, r, .., z3] = exact.at_turns(constants, v);
            let functions = family.at(v, &all.map(Some), [0, 0]);
            let turning = functions.map(|[a, b]| ((a[1] + b[1]) / (a[0] + b[0])).im);
            [1.0, -1.0].map(|side| (1.0 + side * z3, l + side * 0.5 * r, turning))
        });
        let seen: Vec<_> = seen.collect();
        // α as a mean, each state trusted as far as its quotient is well-conditioned, and how far one of them is from it, roughly.
        let fit = |side: usize, pair: [Half; 2]| {
            let told = seen.iter().map(|both| {
                let (height, turn, turning) = &both[side];
                let own = all
                    .iter()
                    .zip(turning)
                    .filter(|(half, _)| pair.contains(half));
                let own: f64 = own.map(|(_, rate)| rate).sum();
                (*height, turn + height * (2.0 * own))
            });
            let weights: f64 = told.clone().map(|(height, _)| height * height).sum();
            let rate = told.clone().map(|(height, x)| height * x).sum::<f64>() / weights;
            let off = told.map(|(height, x)| height * (x - height * rate).abs());
            (rate, off.sum::<f64>() / weights)
        };
        let [.., fourth, fifth] = exact.curve.roots;
        let both = all.map(|half| {
            let other = half.plus(fourth);
            let pairs = [[half, other.plus(fifth)], [other, half.plus(fifth)]];
            (pairs, [0, 1].map(|side| fit(side, pairs[side])))
        });
        let off = |fits: &[(f64, f64); 2]| {
            let parts = fits.map(|(rate, scatter)| scatter / (1.0 + rate.abs()));
            parts[0].max(parts[1])
        };
        let best = both.iter().min_by(|x, y| off(&x.1).total_cmp(&off(&y.1)))?;
        let &([[a, b], [c, d]], fits) = Some(best).filter(|best| off(&best.1) < AGREEING)?;
        let known = Curve::rate(constants, &exact.separation);
        let [plus, minus] = fits.map(|(rough, scatter)| {
            let known = settled(known, rough, exact.curve.advance);
            // Beside a double root the integrals may lose digits, and the states know better; of an upright start they are those of the double root itself.
            let off = (known.value() - rough).abs();
            if constants.upright || off <= 16.0 * scatter {
                known
            } else {
                rough.into()
            }
        });
        let mean = (plus + minus).scaled(0.5);
        Some(Self {
            exact,
            family,
            places: [a, b, c, d].map(Some),
            rates: [mean, plus.scaled(2.0), minus.scaled(2.0)],
            angles: [0.0; 3],
        })
    }
    // ANCHOR_END: choice

    /// With the angles at time 0, from several states soon after: at one instant the third axis may be nearly upright, or rounding just there the
    /// worst. None if they do not agree.
    fn set_out(self, constants: &Constants, trial: &Trial) -> Option<Self> {
        let seen = trial[1..].iter().map(|&(t, (state, attitude))| {
            let sight = self.sight(constants, t, &state, attitude);
            [0, 1, 2].map(|i| sight[i] * Complex::cis(-gained(self.rates[i], t)))
        });
        let seen: Vec<[Complex; 3]> = seen.collect();
        let sums = [0, 1, 2].map(|i| seen.iter().map(|all| all[i]).sum::<Complex>());
        let mean = sums[0].conj() / sums[0].norm();
        // The attitude is as uncertain as the azimuth where the axis leans most: next to the vertical all the time it points nowhere.
        let most = seen
            .iter()
            .fold(0.0_f64, |most, all| most.max(all[0].norm()));
        let near = |all: &[Complex; 3]| (all[0] * mean).im.abs() < TRUSTED * most;
        let agreed = most > 0.0 && seen.iter().all(near);
        agreed.then_some(Self {
            angles: sums.map(Complex::arg),
            ..self
        })
    }

    /// What advances evenly, seen from an attitude, where it is not rounding: ξ₃G₊G₋, η₂⁴G₊⁴K and η₁⁴G₋⁴K̄, G± of length 1, and K as a part of the largest that it may be.
    fn sight(
        &self,
        constants: &Constants,
        t: f64,
        &[p, q, _, z1, z2, _]: &Phase,
        attitude: Quaternion<f64>,
    ) -> [Complex; 3] {
        let functions = self.family.at(self.exact.halved(t), &self.places, [0, 0]);
        let [a, b, c, d] = functions.map(|[a, b]| a[0] + b[0]);
        let [plus, minus] = [a * b, c * d].map(|product| product / product.norm());
        let turn = UnitQuaternion::new_unchecked(attitude).to_rotation_matrix();
        let [first, second, third] =
            [0, 1, 2].map(|axis| Complex::new(turn[(0, axis)], turn[(1, axis)]));
        let c = constants.c.value();
        let x = Complex::new(p, q);
        let k = (x * x - c * Complex::new(z1, z2)) / (p * p + q * q + c);
        let fourth = |square: Complex| square * square;
        [
            third * plus * minus,
            fourth((I * second - first) * plus * plus) * k,
            fourth((first + I * second) * minus * minus) * k.conj(),
        ]
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
        let angle = |i: usize| self.angles[i] + gained(self.rates[i], t) - sight[i].arg();
        let third = angle(0);
        // Near the poles the third axis points nowhere; there η₁ or η₂ tells the angle, but for half a turn, unless K is small. Which is better is told by the sine of the
        // tilt and the size of K.
        let side = if z3 < 0.0 { 2 } else { 1 };
        let [tilt, size] = [
            sight[0].norm(),
            sight[side].norm() / (1.0 + z3.abs()).powi(2),
        ];
        let angle = if tilt < size {
            let half = 0.5 * angle(side);
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
    const MOST: i32 = 16;
    let [first, second] = advance.map(|x| x * RIGHT_ANGLE.scaled(2.0));
    let off = |x: &DoubleDouble| (x.value() - rough).abs();
    (-MOST..=MOST)
        .map(|i| {
            let rate = known + first.times(f64::from(i));
            let rest = (rough - rate.value()) / second.value();
            rate + second.times(rest.round())
        })
        .min_by(|x, y| off(x).total_cmp(&off(y)))
        .unwrap_or(known)
}
