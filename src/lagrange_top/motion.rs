//! The exact motion of Lagrange's top (tutorial 7.2): attitude and angular velocity at any time.

use nalgebra::Quaternion;

use super::evaluation::{Constants, Pull, turned};
use super::kinds::{Nutation, Roots};
use super::preparation::{Body, moderate, prepare};
use crate::double_double::DoubleDouble;
use crate::error::{Error, Result, finite, not_negative, positive};
use crate::extended::Extended;
use crate::frame::{Attitude, BodyVector};

/// Beyond this, in rad/s, sums of rates overflow.
pub(super) const FASTEST: f64 = 1e307;

/// The top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// How the body stands in space.
    pub attitude: Attitude,
    /// h = cos θ, the height of the axis.
    pub height: f64,
    /// 1 − h, without cancellation.
    pub one_less: f64,
    /// 1 + h, without cancellation.
    pub one_more: f64,
}

/// A symmetric body that turns about a fixed point of its axis under gravity, its motion prepared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LagrangeTop {
    transverse: f64,
    axial: f64,
    weight_moment: f64,
    omega: BodyVector,
    attitude: Attitude,
    kind: Nutation,
    roots: Roots,
    motion: Motion,
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(
    clippy::large_enum_variant,
    reason = "a top is one value without allocation; most tops move"
)]
pub(super) enum Motion {
    /// The axis stays: upright, hanging, or at rest without gravity.
    Still,
    Moving(Constants),
}

impl LagrangeTop {
    /// The top with moments I₁ = I₂ = `transverse` about the pivot and I₃ = `axial`, kg m², and Mgl = `weight_moment`, N m,
    /// the centre of mass at +l on x₃; with this angular velocity (rad/s) and attitude at time 0. The space axis z points up.
    ///
    /// Domain: any such body; no gravity (the pivot at the centre of mass), and gravity upwards (Mgl < 0), are tops like others, and
    /// so is a needle (I₃ = 0), whose L₃ is zero whatever its Ω₃. Upright or hanging, at rest or spinning, the axis stays, exactly.
    /// The attitude counts as the direction of its quaternion. What is exactly pure precession, a cusp, upright, at the threshold or on the separatrix is
    /// found to be so, up to the rounding of the numbers given. Cost: some twenty evaluations of [`at`](Self::at).
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`] for I₁, [`Error::Negative`] for I₃, [`Error::TriangleInequality`] for
    /// I₃ > 2I₁, which no body has (2.4), [`Error::OutOfRange`] for |Ω| or √(Mgl/I₁) above 10³⁰⁷.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::lagrange_top::{LagrangeTop, Nutation};
    /// // Released from rest at 60°, spinning: it dips, and comes back to rest (7.4).
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_3)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 4.0), tilted)?;
    /// assert_eq!(top.kind(), Nutation::Cusps);
    /// assert!((top.roots().h1 - 0.0).abs() < 1e-15); // as far as the horizontal
    /// let back = top.at(top.period())?;
    /// assert!(back.omega.x().hypot(back.omega.y()) < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        transverse: f64,
        axial: f64,
        weight_moment: f64,
        omega: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        positive("the transverse moment", transverse)?;
        not_negative("the axial moment", axial)?;
        if axial * 0.5 > transverse * (1.0 + 4.0 * f64::EPSILON) {
            return Err(Error::TriangleInequality {
                smallest: transverse,
                middle: transverse,
                largest: axial,
            });
        }
        finite("the weight moment Mgl", weight_moment)?;
        for component in omega.components().iter() {
            finite("a component of the angular velocity", *component)?;
        }
        if omega.norm() > FASTEST {
            return Err(Error::OutOfRange {
                quantity: "the angular velocity",
                value: omega.norm(),
                least: 0.0,
                greatest: FASTEST,
            });
        }
        let body = Body {
            transverse,
            axial,
            weight_moment,
        };
        let (kind, roots, motion) = if moderate(body, omega, &attitude) {
            prepare::<DoubleDouble>(body, omega, &attitude)?
        } else {
            prepare::<Extended>(body, omega, &attitude)?
        };
        Ok(Self {
            transverse,
            axial,
            weight_moment,
            omega,
            attitude,
            kind,
            roots,
            motion,
        })
    }

    /// What kind of motion the axis makes, decided once. With gravity upwards, the kind of the same motion seen upside down:
    /// the axis that points down is then the sleeping one.
    pub const fn kind(&self) -> Nutation {
        self.kind
    }

    /// L₃ = I₃Ω₃, kg m²/s: constant (7.2).
    pub fn axial_angular_momentum(&self) -> f64 {
        self.axial * self.omega.z()
    }

    /// L_vert, the component of L along the vertical, kg m²/s: constant (7.2).
    pub fn vertical_angular_momentum(&self) -> f64 {
        let l = BodyVector::new(
            self.transverse * self.omega.x(),
            self.transverse * self.omega.y(),
            self.axial * self.omega.z(),
        );
        self.attitude.to_space(l).z()
    }

    /// E = ½⟨Ω, L⟩ + Mgl cos θ, J: constant (7.2).
    pub fn energy(&self) -> f64 {
        let [x, y, z]: [f64; 3] = self.omega.components().into();
        let q = self.attitude.quaternion();
        let height = (q.w * q.w + q.k * q.k) - (q.i * q.i + q.j * q.j);
        0.5 * (self.transverse * (x * x + y * y) + self.axial * z * z) + self.weight_moment * height
    }

    /// Whether C would rise: Mgl < 0.
    pub(super) fn pulls_up(&self) -> bool {
        self.weight_moment < 0.0
    }

    /// The roots of the cubic.
    pub const fn roots(&self) -> Roots {
        self.roots
    }

    /// Everything at time t (s), before or after (7.2).
    ///
    /// Attitude and Ω from two theta functions; through the upright and the hanging position too. Error observed against 857
    /// references of 32 digits, hard cases included: attitude at most 9e-16 rad, Ω 1.2e-15 relative, 1 ∓ h 5e-16, not growing up to
    /// 10³ nutations. Cost: the same at every time, that of three or four triples of Jacobi functions.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::OutOfRange`] beyond 2⁵³ quarter periods or 2⁶² radians.
    pub fn at(&self, t: f64) -> Result<State> {
        let t = finite("the time", t)?;
        match &self.motion {
            Motion::Still => {
                let half = DoubleDouble::product(self.omega.z(), t).scaled(0.5);
                let (sine, cosine) = turned(half, t)?;
                let turn = Quaternion::new(cosine, 0.0, 0.0, sine);
                let q = self.attitude.quaternion().into_inner() * turn;
                let upper = q.w * q.w + q.k * q.k;
                let lower = q.i * q.i + q.j * q.j;
                let (alpha, beta) = (upper / (upper + lower), lower / (upper + lower));
                Ok(State {
                    omega: BodyVector::new(0.0, 0.0, self.omega.z()),
                    attitude: Attitude::from_unit(q),
                    height: alpha - beta,
                    one_less: 2.0 * beta,
                    one_more: 2.0 * alpha,
                })
            }
            Motion::Moving(constants) => constants.at(t, self.omega.z()),
        }
    }

    /// The states at these times, one after another.
    ///
    /// # Errors
    /// Each as for [`at`](Self::at).
    pub fn states(
        &self,
        times: impl IntoIterator<Item = f64>,
    ) -> impl Iterator<Item = Result<State>> {
        times.into_iter().map(|t| self.at(t))
    }

    /// Period of the nutation, 2K/λ, s; infinite where the tilt stays or never returns.
    pub fn period(&self) -> f64 {
        match &self.motion {
            Motion::Still => f64::INFINITY,
            Motion::Moving(constants) => {
                2.0 * constants.modulus.quarter_period() / constants.rate.high().abs()
            }
        }
    }
}

impl LagrangeTop {
    /// By how much the axis goes round the vertical in one period of nutation, radians (7.2); none where there is no period.
    pub fn precession_per_nutation(&self) -> Option<f64> {
        match &self.motion {
            Motion::Moving(constants) if constants.modulus.quarter_period().is_finite() => {
                let precession = constants.precession_per_nutation().value();
                Some(match constants.pull {
                    Pull::Down => precession,
                    Pull::Up => -precession,
                })
            }
            _ => None,
        }
    }

    /// Mean rate at which the axis goes round the vertical, rad/s (7.2); none where there is no period.
    pub fn mean_precession_rate(&self) -> Option<f64> {
        Some(self.precession_per_nutation()? / self.period())
    }
}
