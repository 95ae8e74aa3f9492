//! The azimuth, the angle about the vertical, by theta functions (8.2).
//!
//! ξ = X + iY, the two horizontal axes of space seen from the body, obeys the same equation as z. From η₁² = ξ₁ + iξ₂ and
//! η₂² = −(ξ₁ − iξ₂), so that η₁η₂ = ξ₃, come two quadratures, for the phases of η₁²  and η₂²:
//!
//! ∫(−r/2 + A₋′/2)dt and ∫(r/2 + A₊′/2)dt, A±′ = (2l ± r)/(1 ± z₃).
//!
//! A₊′ has poles where z₁ + iz₂ = 0 or z₁ − iz₂ = 0 with z₃ = −1, at complex times only. With m = Ω₁² + Ω₂² these states form the curve
//! r²(c²+m²−k²) + 4lc²r + 4l²c² + 2(m−3l₁)(m²−k²) = 0, which is w² = P(s) again: m = l₁ − 2s. On the complex torus of the motion the two sets of poles
//! are copies of the curve, shifted against each other by the integrals from ∞ to Z (s = l² − l₁), and A₊/2 less a part linear in time is −2 arg G₊,
//!
//! G = θ(v − a) θ(v − a − h), where v are the turns of the two phases, halved, a is half of those integrals, and h the half period from e₄ to e₅.
//!
//! For z₃ = 1 the result is the same with a half period added to a. So the azimuth of the third axis, the phase of ξ₃, is αt − arg G₊G₋.

use core::f64::consts::{PI, TAU};

use nalgebra::{Quaternion, UnitQuaternion};

use super::constants::{Complex, Constants, I, Phase, WidePhase};
use super::exact::{Exact, Reason, Trial};
use super::periods::{Curve, Half, MEASURES};
use super::taylor::{FullState, about_third, full_state, series, shortest};
use super::theta::Family;
use crate::precise::{DoubleDouble, Number as _, RIGHT_ANGLE};

/// A motion solved by separation, including the attitude.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Precession {
    pub exact: Exact,
    /// The factors of G₊ and of G₋.
    family: Family,
    places: [Option<Half>; 4],
    /// α, which is the mean of α₊ and α₋, and 2α₊ and 2α₋.
    rates: [DoubleDouble; 3],
    /// The phases at time 0 of the three quantities that turn at these rates.
    angles: [f64; 3],
}

/// The greatest disagreement allowed between values of α from different states.
const AGREEING: f64 = 1e-9;

/// The same between α by integrals and its mean over states, or between those states, for an upright start; and, over c where c < 1, half of the greatest angle
/// between an attitude of the trial and the one found.
const SURE: f64 = 1e-13;

/// Where the sine of the tilt and K are both below this, the rounding of their directions would cost digits of the attitude.
const POINTING: f64 = 1e-3;
/// The sine of a tilt below which the azimuth of the third axis may be off by a quarter turn.
const UPRIGHT: f64 = 1e-8;

impl Precession {
    pub fn find(
        constants: &Constants,
        wide: &WidePhase,
        whole: &FullState,
    ) -> Result<Self, Reason> {
        let (exact, trial) = Exact::find(constants, wide, whole)?;
        let quadrature = Self::quadrature(constants, exact);
        let solved = quadrature.and_then(|found| found.with_angles(constants, &trial));
        solved.ok_or(Reason::DoubleRoot)
    }

    // ANCHOR: choice
    /// G₊ and G₋: a is half of the integrals to Z, on the sheet given by the sign of N, plus one of sixteen half periods, which h combines into eight pairs; for G₋ plus the one to e₄.
    ///
    /// Which of the eight is right depends on the signs of the roots that fitted the start; it is found as the one for which A′/2 + 2 d arg G/dt is the same α everywhere.
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
        // For sample phases: 1 ± z₃, A±′/2 times that, and the rates of the phases of the functions.
        let seen = exact.spread().map(|v| {
            let [_, _, r, .., z3] = exact.at_turns(constants, v);
            let functions = family.at(v, &all.map(Some), [0, 0]);
            let turning = functions.map(|[a, b]| ((a[1] + b[1]) / (a[0] + b[0])).im);
            [1.0, -1.0].map(|side| (1.0 + side * z3, l + side * 0.5 * r, turning))
        });
        let seen: Vec<_> = seen.collect();
        // α as a mean, each state weighted by how well-conditioned its quotient is, and the typical deviation from it.
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
        let rates = fits.map(|(rough, scatter)| {
            let known = nearest_rate(known, rough, exact.curve.advance);
            // Near a double root the integrals may lose digits, and the mean over states is better; for an upright start with a small K both may.
            let off = (known.value() - rough).abs();
            let better = if off <= 16.0 * scatter {
                known
            } else {
                rough.into()
            };
            Some(better).filter(|_| !constants.upright || off.min(scatter) < SURE)
        });
        let [Some(plus), Some(minus)] = rates else {
            return None;
        };
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

    /// Completes the solution with the angles at time 0, estimated from several states soon after, since at a single instant the third axis may be nearly upright or
    /// rounding at its worst. `None` unless it then gives the attitudes of the trial.
    fn with_angles(self, constants: &Constants, trial: &Trial) -> Option<Self> {
        let seen = trial[1..].iter().map(|&(t, (state, attitude))| {
            let turning = self.uniformly_turning(constants, t, &state, attitude);
            [0, 1, 2].map(|i| turning[i] * Complex::cis(-angle_gained(self.rates[i], t)))
        });
        let seen: Vec<[Complex; 3]> = seen.collect();
        let sums = [0, 1, 2].map(|i| seen.iter().map(|all| all[i]).sum::<Complex>());
        let solved = Self {
            angles: sums.map(Complex::arg),
            ..self
        };
        let off = |&(t, (_, attitude)): &(f64, FullState)| {
            let (_, known) = solved.full_state(constants, t);
            (known * attitude.conjugate()).imag().norm()
        };
        let sure = SURE / constants.c.value().min(1.0);
        trial.iter().all(|seen| off(seen) < sure).then_some(solved)
    }

    /// The three quantities whose phases are linear in time, for a given attitude: ξ₃G₊G₋, η₂⁴G₊⁴K and η₁⁴G₋⁴K̄, with G± normalised and K as a fraction of its bound; their magnitudes tell how well the phases are determined.
    fn uniformly_turning(
        &self,
        constants: &Constants,
        t: f64,
        &[p, q, _, z1, z2, _]: &Phase,
        attitude: Quaternion<f64>,
    ) -> [Complex; 3] {
        let functions = self.family.at(self.exact.halved(t), &self.places, [0, 0]);
        let [a, b, c, d] = functions.map(|[a, b]| a[0] + b[0]);
        let [plus, minus] = [a * b, c * d].map(|product| match product.norm() {
            // Upright, to the last digit: it has no phase.
            0.0 => product,
            size => product / size,
        });
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

    /// The state with its attitude at time `t`, from the exact Ω and z: z is vertical, and the third axis has its azimuth.
    pub fn full_state(&self, constants: &Constants, t: f64) -> FullState {
        let state = self.exact.state(constants, t);
        let (attitude, sharpness) = self.attitude(constants, t, &state);
        if sharpness > POINTING {
            return (state, attitude);
        }
        // From a moment before, when the third axis leaned; the power series carries the attitude on, and only a turn about the vertical is corrected.
        let series = series(constants.c.value(), &(state, attitude));
        let ago = series.reach.min(1.0);
        let (before, rough) = full_state(&series, -ago);
        let (known, better) = self.attitude(constants, t - ago, &before);
        if better < sharpness {
            return (state, attitude);
        }
        let missing = known * rough.conjugate();
        let turn = 2.0 * missing.k.atan2(missing.w);
        (state, about_third(turn) * attitude)
    }

    /// The attitude of a state, and how well its azimuth is determined.
    fn attitude(&self, constants: &Constants, t: f64, state: &Phase) -> (Quaternion<f64>, f64) {
        let &[.., z1, z2, z3] = state;
        let upright = shortest([z1, z2, z3]);
        let turning = self.uniformly_turning(constants, t, state, upright);
        let angle = |i: usize| self.angles[i] + angle_gained(self.rates[i], t) - turning[i].arg();
        let third = angle(0);
        // Near the vertical the third axis has no azimuth; there η₁ or η₂ gives the angle up to half turns, unless K is small. The sine of the tilt and the size of K
        // decide which is better.
        let side = if z3 < 0.0 { 2 } else { 1 };
        let [tilt, size] = [
            turning[0].norm(),
            turning[side].norm() / (1.0 + z3.abs()).powi(2),
        ];
        let angle = if tilt < size {
            let half = 0.5 * angle(side);
            half + PI * ((third - half) / PI).round()
        } else {
            third
        };
        // Where the third axis has no azimuth at all, half turns remain unknown.
        let sharpness = if tilt < UPRIGHT { tilt } else { tilt.max(size) };
        (about_third(angle) * upright, sharpness)
    }
}

/// The growth of an angle in the time `t`, up to whole turns.
fn angle_gained(rate: DoubleDouble, t: f64) -> f64 {
    let angle = rate * DoubleDouble::from(t);
    let turns = DoubleDouble::from((angle.value() / TAU).round());
    (angle - RIGHT_ANGLE.scaled(4.0) * turns).value()
}

/// Of the rates that differ from `known` by half turns of v per unit of time, the one nearest to `rough`.
fn nearest_rate(known: DoubleDouble, rough: f64, advance: [DoubleDouble; 2]) -> DoubleDouble {
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
