//! The state of a prepared top at one time: the two Cayley–Klein parameters, one theta function each, and from them attitude and Ω (tutorial 7.2).
//!
//! α = cos(θ/2) e^{i(φ+ψ)/2} and β = sin(θ/2) e^{i(φ−ψ)/2} have |α|² = (1 + h)/2 and |β|² = (1 − h)/2, where h moves between h₁
//! and h₂ like sn². So |α| vanishes only at complex arguments u = ±iη, |β| only at u = K ± iη′, and Jacobi's
//! integrals of the third kind become
//!
//! α ∝ ϑ₁(π(u ± iη)/2K) e^{iμt}, β ∝ ϑ₂(π(u ± iη′)/2K) e^{iμ′t}.
//!
//! They are regular where the axis passes the upright or the hanging position: one of the two passes through zero there.

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

use nalgebra::Quaternion;

use crate::elliptic::Side;
use crate::elliptic::lanes::{Course, LANES, Places, phase, turned};
use crate::elliptic::theta::Turning;
use crate::error::{Result, finite, not_negative, positive};
use crate::frame::{Attitude, BodyVector};
use crate::inertia::PrincipalMoments;
use crate::precise::quick::sine_cosine;
use crate::precise::{DoubleDouble, Number, RIGHT_ANGLE, power_of_two_below};

/// The state of Lagrange's top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// L along the body's axes, kg m²/s.
    pub angular_momentum: BodyVector,
    /// The attitude of the body in space, whose third axis points up.
    pub attitude: Attitude,
    /// z, the upward unit vector, along the body's axes.
    pub up: BodyVector,
    /// h = cos θ = z₃, the height of the axis.
    pub height: f64,
    /// 1 − h, without cancellation.
    pub one_less: f64,
    /// 1 + h, without cancellation.
    pub one_more: f64,
}

impl State {
    pub(super) fn new(
        body: &Body,
        omega: BodyVector,
        q: Quaternion<f64>,
        [one_less, one_more]: [f64; 2],
    ) -> Self {
        let height = 0.5 * (one_more - one_less);
        let up = [q.i * q.k - q.w * q.j, q.j * q.k + q.w * q.i].map(|half| 2.0 * half);
        Self {
            omega,
            angular_momentum: body.angular_momentum(omega),
            attitude: Attitude::from_unit(q),
            up: BodyVector::new(up[0], up[1], height),
            height,
            one_less,
            one_more,
        }
    }
}

/// The constants of the body: I₁ = I₂ and I₃, kg m², and Mgl, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Body {
    pub(super) transverse: f64,
    pub(super) axial: f64,
    pub(super) weight_moment: f64,
}

impl Body {
    pub(super) fn new(transverse: f64, axial: f64, weight_moment: f64) -> Result<Self> {
        positive("the transverse moment", transverse)?;
        not_negative("the axial moment", axial)?;
        PrincipalMoments::new(transverse, transverse, axial)?;
        finite("the weight moment Mgl", weight_moment)?;
        Ok(Self {
            transverse,
            axial,
            weight_moment,
        })
    }

    pub(super) fn angular_momentum(&self, omega: BodyVector) -> BodyVector {
        let [x, y, z]: [f64; 3] = omega.components().into();
        BodyVector::new(self.transverse * x, self.transverse * y, self.axial * z)
    }
}

/// The direction of gravity along space z. Upward gravity is solved as downward gravity, seen upside down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pull {
    Down,
    Up,
}

impl Pull {
    pub(super) fn of(weight_moment: f64) -> Self {
        if weight_moment < 0.0 {
            Self::Up
        } else {
            Self::Down
        }
    }
}

/// A complex number.
pub(super) type Complex = nalgebra::Complex<f64>;

/// ϑ₁(π(u + iη)/2K), or its conjugate, without the factor that grows with η.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Parameter {
    /// 1, or −1 for the conjugate.
    pub(super) sense: f64,
    pub(super) turning: Turning,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Constants {
    pub(super) pull: Pull,
    pub(super) course: Course,
    /// See [`Course::reach`].
    pub(super) reach: f64,
    /// The theta functions of α and β.
    pub(super) parameters: [Parameter; 2],
    /// The rates of their phases, rad/s.
    pub(super) rates: [DoubleDouble; 2],
    /// Their constant factors.
    pub(super) factors: [Complex; 2],
    /// 1 − h₂, 1 + h₁ and h₂ − h₁, from which 1 − h and 1 + h are formed.
    pub(super) top2: f64,
    pub(super) bottom1: f64,
    pub(super) band: f64,
}

impl Constants {
    /// Growth of the sum of the phases of α and β in one period of nutation.
    ///
    /// The rates are added first: the spin enters them with opposite signs, and its part alone could overflow.
    pub(super) fn precession_per_nutation(&self) -> DoubleDouble {
        let quarter = self.course.modulus.quarter_period_dd();
        // The period itself may overflow.
        let unit = 1.0 / power_of_two_below(self.course.rate.high());
        let period = quarter.scaled(2.0) / self.course.rate.scaled(unit);
        let [alpha, beta] = &self.parameters;
        let lag = |parameter: &Parameter| {
            let lag = match self.course.modulus.side() {
                Side::Circular => RIGHT_ANGLE,
                Side::Hyperbolic => parameter.turning.lag,
            };
            lag.scaled(2.0 * parameter.sense)
        };
        let rate = (self.rates[0] + self.rates[1]).scaled(unit);
        rate * period - (lag(alpha) + lag(beta))
    }

    /// sn, cn, dn, and α and β with their derivatives by time, at time `t` and argument `u`.
    fn pair(&self, t: f64, u: DoubleDouble) -> Result<([f64; 3], [Complex; 4])> {
        let mut work = Work::<1>::new();
        work.places.put_any(0, &self.course.modulus, u);
        work.put_phases_any_time(self, t)?;
        work.evaluate(self);
        Ok((work.places.functions(0), work.pair(0)))
    }

    #[inline(always)]
    pub(super) fn at(&self, t: f64, body: &Body, axial_rate: f64) -> Result<State> {
        let mut work = Work::<1>::new();
        if t.abs() <= self.reach {
            work.put(self, &[t]);
        } else {
            work.places.follow_any_time(&self.course, t)?;
            work.put_phases_any_time(self, t)?;
        }
        work.evaluate(self);
        Ok(work.state(0, self, body, axial_rate))
    }

    /// The states at eight times within reach; only as many as `states` has room for.
    #[inline(never)]
    pub(super) fn side_by_side(
        &self,
        times: &[f64; LANES],
        body: &Body,
        axial_rate: f64,
        states: &mut [State],
    ) {
        let mut work = Work::new();
        work.put(self, times);
        work.evaluate(self);
        for (i, state) in states.iter_mut().enumerate() {
            *state = work.state(i, self, body, axial_rate);
        }
    }
}

/// Intermediate values that one pass over the lanes leaves to the next.
struct Work<const W: usize> {
    places: Places<W>,
    /// Sines and cosines of the phases of α and β.
    sine: [[f64; W]; 2],
    cosine: [[f64; W]; 2],
    /// α, β and their derivatives by time: real and imaginary parts.
    pair: [[[f64; W]; 2]; 4],
}

impl<const W: usize> Work<W> {
    #[inline(always)]
    fn new() -> Self {
        Self {
            places: Places::new(),
            sine: [[0.0; W]; 2],
            cosine: [[0.0; W]; 2],
            pair: [[[0.0; W]; 2]; 4],
        }
    }

    /// Reduces arguments and phases at times within reach.
    #[inline(always)]
    fn put(&mut self, constants: &Constants, times: &[f64; W]) {
        self.places.follow(&constants.course, times);
        for k in 0..2 {
            let Parameter { sense, turning } = constants.parameters[k];
            for i in 0..W {
                let quarters = (self.places.quarters[i] + k as f64) * sense;
                let angle = phase(constants.rates[k], times[i], turning.lag, quarters);
                (self.sine[k][i], self.cosine[k][i]) = sine_cosine(angle);
            }
        }
    }

    /// Computes α, β and their derivatives there.
    #[inline(always)]
    fn evaluate(&mut self, constants: &Constants) {
        let Course { modulus, rate, .. } = &constants.course;
        self.places.evaluate(modulus);
        let pace = modulus.pace() * rate.high();
        for k in 0..2 {
            let Parameter { sense, turning } = &constants.parameters[k];
            let (factor, own) = (constants.factors[k], constants.rates[k].high());
            let shifted = k == 1;
            for i in 0..W {
                let [value, slope] =
                    self.places
                        .theta_with_slope(i, modulus, &turning.theta, shifted);
                let [value, slope] = [value, slope].map(|[re, im]| Complex::new(re, sense * im));
                let weight = if shifted {
                    self.places.weight_of_shifted(i, modulus)
                } else {
                    1.0
                };
                let factor = factor * Complex::new(self.cosine[k][i], self.sine[k][i]);
                let slope = slope * pace + value * Complex::new(0.0, own);
                let (value, slope) = (factor * value * weight, factor * slope * weight);
                (self.pair[k][0][i], self.pair[k][1][i]) = (value.re, value.im);
                (self.pair[k + 2][0][i], self.pair[k + 2][1][i]) = (slope.re, slope.im);
            }
        }
    }

    #[inline(always)]
    fn pair(&self, i: usize) -> [Complex; 4] {
        core::array::from_fn(|k| Complex::new(self.pair[k][0][i], self.pair[k][1][i]))
    }

    #[inline(always)]
    fn state(&self, i: usize, constants: &Constants, body: &Body, axial_rate: f64) -> State {
        let [sn, cn, _] = self.places.functions(i);
        let [alpha, beta, alpha_rate, beta_rate] = self.pair(i);
        let (one_less, one_more) = (
            constants.top2 + constants.band * cn * cn,
            constants.bottom1 + constants.band * sn * sn,
        );
        // |α| and |β| are taken from the height, which is more accurate than products of theta functions; where one vanishes, its scale comes from their sum of squares.
        let [a_size, b_size] = [alpha, beta].map(|x| x.norm_sqr());
        let scale = |part: f64, size: f64| match size > f64::MIN_POSITIVE {
            true => (0.5 * part / size).sqrt(),
            false => 1.0 / (a_size + b_size).sqrt(),
        };
        let [grown, other] = [scale(one_more, a_size), scale(one_less, b_size)];
        let transverse =
            (alpha.conj() * beta_rate - beta * alpha_rate.conj()) * (2.0 * grown * other);
        let (a, b) = (alpha * grown, beta * other);
        let (a, b, one_less, one_more) = match constants.pull {
            Pull::Down => (a, b, one_less, one_more),
            Pull::Up => (b.conj(), -a.conj(), one_more, one_less),
        };
        State::new(
            body,
            BodyVector::new(transverse.re, transverse.im, axial_rate),
            Quaternion::new(a.re, b.re, b.im, a.im),
            [one_less, one_more],
        )
    }
}

impl Work<1> {
    /// Computes the phases at any time, once the argument has been reduced.
    fn put_phases_any_time(&mut self, constants: &Constants, t: f64) -> Result<()> {
        for k in 0..2 {
            let Parameter { sense, turning } = constants.parameters[k];
            let quarters = DoubleDouble::from((self.places.quarters[0] + k as f64) * sense);
            (self.sine[k][0], self.cosine[k][0]) =
                turned(constants.rates[k], t, turning.lag * quarters)?;
        }
        Ok(())
    }
}

impl Constants {
    /// Fits the constant factors of α and β to the start: their magnitudes to the tilt at a point between the turning points, their phases to
    /// the horizontal parts of the vertical and of Ω, which never vanish together.
    pub(super) fn fit(&mut self, q: Quaternion<f64>, omega: BodyVector) -> Result<()> {
        // Next to a separatrix a quarter period is long, and halfway one of the two underflows.
        let middle = (self.course.modulus.quarter_period() * 0.5).min(1.0);
        let ([sn, cn, _], [alpha, beta, ..]) = self.pair(0.0, DoubleDouble::from(middle))?;
        let above = self.bottom1 + self.band * sn * sn;
        let below = self.top2 + self.band * cn * cn;
        self.factors[0] = Complex::new(above.sqrt() / alpha.norm(), 0.0);
        self.factors[1] = Complex::new(below.sqrt() / beta.norm(), 0.0);
        let (_, [alpha, beta, alpha_rate, beta_rate]) = self.pair(0.0, self.course.start)?;
        let i = Complex::new(0.0, 1.0);
        // Halves of z₁ + iz₂ = 2i ᾱβ and of Ω₁ + iΩ₂ = 2 (ᾱβ′ − βᾱ′).
        let vertical = i * alpha.conj() * beta;
        let turning = alpha.conj() * beta_rate - beta * alpha_rate.conj();
        let (a, b) = (Complex::new(q.w, q.k), Complex::new(q.i, q.j));
        let wanted_vertical = i * a.conj() * b * 2.0;
        let wanted = Complex::new(omega.x(), omega.y());
        // Each pair is scaled to its own magnitude, so that even the smallest kick has a direction.
        let unit = |x: Complex, y: Complex| {
            let size = x.re.abs().max(x.im.abs()).max(y.re.abs()).max(y.im.abs());
            if size > 0.0 {
                (x / size, y / size)
            } else {
                (x, y)
            }
        };
        let (vertical, turning) = unit(vertical, turning);
        let (wanted_vertical, wanted) = unit(wanted_vertical, wanted);
        let relative = wanted_vertical * vertical.conj() + wanted * turning.conj();
        let relative = if relative.norm() > 0.0 {
            relative / relative.norm()
        } else {
            Complex::new(1.0, 0.0)
        };
        let common = alpha.conj() * a + beta.conj() * b * relative.conj();
        let common = common / common.norm();
        self.factors[0] *= common;
        self.factors[1] *= common * relative;
        Ok(())
    }
}
