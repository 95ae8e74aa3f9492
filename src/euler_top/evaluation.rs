//! The state of a prepared motion at one time, and its period, mean precession and solid angle (tutorial 6.6, 6.8).
//!
//! L is (P₁ cn u, P₂ sn u, P₃ dn u) along the renumbered axes, u = u₀ + λt. The same code serves one lane, for a single time, and eight.
//!
//! Let axis 3 be the one whose component of L keeps its sign (that of dn), let P(L) be the shortest rotation that carries L
//! onto it, and write the attitude as a turn by ψ about L after P(L). Then ψ' = 2E/|L| − (1 − cos θ) φ', an elliptic integral of
//! the third kind. With P₁, P₂, P₃ the amplitudes of cn, sn, dn, the elevation of L at sn = 0 is the amplitude of η for
//! the complementary modulus: sn η = P₃/|L|, cn η = P₁/|L|, dn η = P₂/|L|; and ξ = K′ − η depends on the moments alone.
//! Jacobi's transformation of the integral into theta functions leaves
//!
//! ψ = ν t + arg Z(u) − arg (P₁ cn u + i P₂ sn u),
//!
//! where Z̄ is ϑ₁(z + iw)/i for m ≤ 1/2, z + iw = π(u + iξ)/(2K), which is ϑ₄(π(u + iη)/(2K)) but for an even turn, and ϑ₂(ix − v),
//! v = πξ/(2K′) − π/2, beyond. The rate is
//! |L|/I₂, that of a body upright on its middle axis, and a theta quotient that vanishes at the separatrix: nothing
//! is left that could cancel. (C. G. J. Jacobi, Sur la rotation d'un corps, 1849; that the rate is |L|/I₂ and a theta
//! quotient follows from his formulas at u = K, where L₁ = 0.)

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

use nalgebra::Quaternion;

use crate::elliptic::Side;
use crate::elliptic::lanes::{Course, LANES, Places, phase, turned};
use crate::elliptic::theta::Turning;
use crate::error::Result;
use crate::frame::{Attitude, BodyVector};
use crate::precise::quick::{in_quadrant, sine_cosine};
use crate::precise::{DoubleDouble, Number, RIGHT_ANGLE};

/// The state of a free top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// L along the body's axes, kg m²/s.
    pub angular_momentum: BodyVector,
    /// The attitude of the body in space.
    pub attitude: Attitude,
}

impl Default for State {
    /// At rest, with the body's axes along those of space, to initialise a slice of states.
    fn default() -> Self {
        Self {
            omega: BodyVector::zero(),
            angular_momentum: BodyVector::zero(),
            attitude: Attitude::identity(),
        }
    }
}

/// A body's axes, renumbered and with signs chosen so that the component of L along axis 3 keeps its sign and components 1 and 3
/// start positive; right-handed like the old ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Renumbering {
    /// For each of the body's own axes, its new number.
    pub(super) own: [u8; 3],
    pub(super) sign: [i8; 3],
}

impl Renumbering {
    pub(super) fn new(axis: [usize; 3], l: [f64; 3]) -> Self {
        let sign_of = |x: f64| if x < 0.0 { -1 } else { 1 };
        let (first, third) = (sign_of(l[axis[0]]), sign_of(l[axis[2]]));
        let mut own = [0; 3];
        for k in 0..3 {
            own[axis[k]] = k as u8;
        }
        Self {
            own,
            sign: [first, handedness(axis) as i8 * first * third, third],
        }
    }

    /// Values along the body's own axes in the new order, without the signs.
    pub(super) fn renumber<T: Copy>(&self, v: [T; 3]) -> [T; 3] {
        let mut renumbered = v;
        for (k, value) in self.own.into_iter().zip(v) {
            renumbered[usize::from(k)] = value;
        }
        renumbered
    }

    /// Components with the signs of the old axes, still in the new order.
    pub(super) fn signed(&self, w: [f64; 3]) -> [f64; 3] {
        core::array::from_fn(|k| f64::from(self.sign[k]) * w[k])
    }
}

/// +1 if the axes in this order are right-handed, −1 if not.
pub(super) fn handedness(axes: [usize; 3]) -> f64 {
    if (axes[0] + 1) % 3 == axes[1] {
        1.0
    } else {
        -1.0
    }
}

/// The constants of a motion in which Ω moves in the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Constants {
    pub(super) axes: Renumbering,
    /// The argument u as a function of time.
    pub(super) course: Course,
    /// P₁, P₂, P₃, the coefficients of cn, sn and dn in L, with the signs of the old axes.
    pub(super) amplitudes: [f64; 3],
    /// P₁/P₂ without the signs.
    pub(super) aspect: f64,
    /// Z̄, or iZ̄ on the circular side, with the lag of the phase of Z with each quarter period.
    pub(super) turning: Turning,
    /// ψ = `turning_rate` t − quarters · lag + …
    pub(super) turning_rate: DoubleDouble,
}

/// A motion prepared for any time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moving {
    pub(super) constants: Constants,
    /// The coefficients of cn, sn and dn in Ω and, without the signs, in L/|L|, along the renumbered axes.
    omega: [f64; 3],
    direction: [f64; 3],
    /// The constant factor of the attitude, to which the turn by ψ and P(L) are applied, along those axes.
    base: [f64; 4],
    /// The time, s, up to which phases are reduced without a branch, as [`Course::reach`] has it.
    pub(super) reach: f64,
}

/// Intermediate values that one pass over the lanes leaves to the next.
pub(super) struct Work<const W: usize> {
    places: Places<W>,
    /// Sine and cosine of half of νt − quarters · lag; then of half of ψ, not normalised.
    sine: [f64; W],
    cosine: [f64; W],
    /// Real and imaginary part of Z.
    z: [[f64; W]; 2],
    attitude: [[f64; W]; 4],
}

impl<const W: usize> Work<W> {
    pub(super) fn new() -> Self {
        Self {
            places: Places::new(),
            sine: [0.0; W],
            cosine: [0.0; W],
            z: [[0.0; W]; 2],
            attitude: [[0.0; W]; 4],
        }
    }

    /// The states at these times, each within reach.
    #[inline(always)]
    pub(super) fn states(&mut self, body: &Moving, times: &[f64; W]) {
        let constants = &body.constants;
        self.places.follow(&constants.course, times);
        for i in 0..W {
            let quarters = self.places.quarters[i];
            let [high, low] = phase(
                constants.turning_rate,
                times[i],
                constants.turning.lag,
                quarters,
            );
            (self.sine[i], self.cosine[i]) = sine_cosine([0.5 * high, 0.5 * low]);
        }
        self.turn(body);
    }

    /// Computes the attitudes from the reduced arguments and phases.
    #[inline(always)]
    fn turn(&mut self, body: &Moving) {
        let constants = &body.constants;
        let (axes, modulus) = (&constants.axes, &constants.course.modulus);
        self.places.evaluate(modulus);
        for i in 0..W {
            let [value, _] =
                self.places
                    .theta_with_slope(i, modulus, &constants.turning.theta, false);
            (self.z[0][i], self.z[1][i]) = (value[0], value[1]);
        }
        // On the hyperbolic side Z does not turn with the quarter periods, so these quarter turns are subtracted.
        let turns = match modulus.side() {
            Side::Circular => {
                self.z.swap(0, 1);
                0
            }
            Side::Hyperbolic => {
                self.z[1] = self.z[1].map(|imaginary| -imaginary);
                u64::MAX
            }
        };
        for i in 0..W {
            let [sn, cn, _] = self.places.functions(i);
            let (real, imaginary) = (self.z[0][i], self.z[1][i]);
            // The phase of Z over P₁ cn + i P₂ sn, at most a right angle, and half of it.
            let across = constants.aspect * cn;
            let (aside, along) = in_quadrant(
                self.places.bits[i] & turns,
                imaginary * across - real * sn,
                real * across + imaginary * sn,
            );
            // They may be of any magnitude, so they are scaled by a power of two. Where both are zero, so is the angle.
            let unit = inverse_unit(along, aside);
            let (along, aside) = (along * unit, aside * unit);
            let x = (along * along + aside * aside).sqrt() + along + 1e-150;
            let (sine, cosine) = (self.sine[i], self.cosine[i]);
            self.cosine[i] = cosine * x - sine * aside;
            self.sine[i] = sine * x + cosine * aside;
        }
        for i in 0..W {
            let [sn, cn, dn] = self.places.functions(i);
            let (sine, cosine) = (self.sine[i], self.cosine[i]);
            let [d1, d2, d3] = body.direction;
            let (n1, n2, w) = (d1 * cn, d2 * sn, 1.0 + d3 * dn);
            // (cos + k sin) (w + n₂ i − n₁ j), and its length.
            let size = (cosine * cosine + sine * sine) * (w * w + (n1 * n1 + n2 * n2));
            let scale = 1.0 / size.sqrt();
            let (cosine, sine) = (cosine * scale, sine * scale);
            self.attitude[0][i] = cosine * w;
            self.attitude[1][i] = cosine * n2 + sine * n1;
            self.attitude[2][i] = sine * n2 - cosine * n1;
            self.attitude[3][i] = sine * w;
        }
        for i in 0..W {
            let [w, x, y, z] = core::array::from_fn(|k| self.attitude[k][i]);
            let ([a, b, c, d], [first, second, third]) = (body.base, axes.sign.map(f64::from));
            self.attitude[0][i] = (a * w - b * x) - (c * y + d * z);
            self.attitude[1][i] = first * ((a * x + b * w) + (c * z - d * y));
            self.attitude[2][i] = second * ((a * y + c * w) + (d * x - b * z));
            self.attitude[3][i] = third * ((a * z + d * w) + (b * y - c * x));
        }
    }

    /// The state in lane `i`, along the body's own axes.
    #[inline(always)]
    pub(super) fn state(&self, i: usize, body: &Moving) -> State {
        let [sn, cn, dn] = self.places.functions(i);
        let functions = [cn, sn, dn];
        let own = body.constants.axes.own.map(usize::from);
        let l = own.map(|k| body.constants.amplitudes[k] * functions[k]);
        let omega = own.map(|k| body.omega[k] * functions[k]);
        let [x, y, z] = own.map(|k| self.attitude[k + 1][i]);
        State {
            omega: vector(omega),
            angular_momentum: vector(l),
            attitude: Attitude::from_unit(Quaternion::new(self.attitude[0][i], x, y, z)),
        }
    }
}

/// The reciprocal of the power of two next below the greater of two magnitudes, both below 10³⁰⁰; without a branch.
#[inline(always)]
fn inverse_unit(a: f64, b: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    const TWICE_ONE: u64 = 2046 << 52;
    let size = if a.abs() > b.abs() { a } else { b };
    f64::from_bits(TWICE_ONE.wrapping_sub(size.to_bits() & EXPONENT))
}

pub(super) fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

impl Moving {
    /// From the constants, the coefficients in Ω, and the attitude at time 0.
    pub(super) fn new(constants: Constants, omega: [f64; 3], attitude: Attitude) -> Result<Self> {
        let (axes, amplitudes) = (constants.axes, constants.amplitudes);
        let size = amplitudes[0].hypot(amplitudes[2]);
        let mut moving = Self {
            omega,
            direction: amplitudes.map(|x| x.abs() / size),
            base: [1.0, 0.0, 0.0, 0.0],
            reach: constants.course.reach(0.5, &[constants.turning_rate]),
            constants,
        };
        let found = moving.at(0.0)?.attitude.quaternion().into_inner();
        let base = attitude.quaternion().into_inner() * found.conjugate();
        let [x, y, z] = axes.signed(axes.renumber([base.i, base.j, base.k]));
        moving.base = [base.w, x, y, z];
        Ok(moving)
    }

    /// The states at eight times within reach; only as many as `states` has room for.
    #[inline(never)]
    pub(super) fn side_by_side(&self, times: &[f64; LANES], states: &mut [State]) {
        let mut work = Work::new();
        work.states(self, times);
        for (i, state) in states.iter_mut().enumerate() {
            *state = work.state(i, self);
        }
    }

    pub(super) fn at(&self, t: f64) -> Result<State> {
        let mut work = Work::<1>::new();
        if t.abs() <= self.reach {
            work.states(self, &[t]);
        } else {
            let constants = &self.constants;
            work.places.follow_any_time(&constants.course, t)?;
            let lag = constants.turning.lag * DoubleDouble::from(work.places.quarters[0]);
            (work.sine[0], work.cosine[0]) =
                turned(constants.turning_rate.scaled(0.5), t, lag.scaled(0.5))?;
            work.turn(self);
        }
        Ok(work.state(0, self))
    }
}

impl Constants {
    pub(super) fn period(&self) -> f64 {
        let quarter = self.course.modulus.quarter_period_dd();
        if quarter.high() == f64::INFINITY {
            return f64::INFINITY;
        }
        let nearly = 4.0 * (quarter.high() / self.course.rate.high()).abs();
        if nearly.is_finite() {
            4.0 * (quarter / self.course.rate).value().abs()
        } else {
            nearly
        }
    }

    /// ν less the lag of each quarter period, plus a right angle for each, by which the azimuth of L in the body advances.
    pub(super) fn mean_precession_rate(&self) -> f64 {
        let quarter = self.course.modulus.quarter_period_dd();
        if quarter.high() == f64::INFINITY {
            return self.turning_rate.value();
        }
        let gain = RIGHT_ANGLE - self.turning.lag;
        let quarters = self.course.rate / quarter;
        let rate = (self.turning_rate + gain * quarters).value();
        // The sum has no second word where the first is beyond the doubles.
        if rate.is_nan() { f64::INFINITY } else { rate }
    }

    /// Solid angle of the cone that L traces in the body in one period, with the sign of du/dt.
    pub(super) fn solid_angle(&self) -> f64 {
        let [p1, p2, p3] = self.amplitudes.map(f64::abs);
        let size = p1.hypot(p3);
        let magnitude = match self.course.modulus.side() {
            // ∮ (1 − cos θ) dφ = P₁P₂/P₃ ∫ P₃ dn/(|L| (|L| + P₃ dn)) du, over a periodic function with poles beyond ±iK′: the
            // trapezoidal rule has an error of order q¹⁶, and nothing cancels for a small cone.
            Side::Circular => {
                let quarter = self.course.modulus.quarter_period_dd();
                let ordinates = (0..16).map(|k| {
                    let u = quarter * DoubleDouble::from(f64::from(k) / 8.0);
                    let dn = self.course.modulus.jacobi_dd(u).dn;
                    dn / (1.0 + p3 / size * dn)
                });
                let mean = ordinates.sum::<f64>() / 16.0;
                4.0 * quarter.value() * mean * (p1 / size) * (p2 / size)
            }
            // Near the separatrix the cone is wide: the closed form, which is Heuman's lambda function.
            Side::Hyperbolic => {
                let mc = self.course.modulus.parameter.mc();
                let share = mc * (p1 / p2) * (p3 / size) + self.turning.slope.value();
                let quarter = self.course.modulus.quarter_period();
                4.0 * (self.turning.lag.value() - quarter * share)
            }
        };
        magnitude * self.course.rate.high().signum()
    }
}
