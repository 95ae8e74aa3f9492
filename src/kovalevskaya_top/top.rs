//! The top itself: it removes units and axes, decides the regime, and gives Ω, z and attitude at any time (8.1, 8.2).

use nalgebra::{Complex, Quaternion};

use super::classes::{Kind, classify};
use super::constants::{Constants, Phase, WidePhase};
use super::exact::Reason;
use super::pendulum::Pendulum;
use super::precession::Precession;
use super::separation::{Separation, Variables};
use super::taylor::{FullState, about_third, shortest};
use crate::error::{Result, each, finite, not_negative, positive, refused, too_long, within};
use crate::euler_equations::{AxisMoments, HeavyTop, TopState};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector, finite_vector};
use crate::precise::{DoubleDouble, Extended, Number, power_of_two_below};

/// The method by which the motion is computed: Ω, z and the attitude.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// Kovalevskaya's separation, at the same cost for any time: Ω and z are functions of two angles that advance uniformly; the azimuth of the third axis is αt less the
    /// phases of four theta functions θ(v − a), which is Kötter's quadrature of 1893.
    Separation,
    /// z along axis 3 at the start, or a pendulum in a vertical plane, where two roots coincide: theta functions of one variable, in the first case with exponentials, at the same cost for any time.
    Elliptic,
    /// The Euler–Poisson equations by their power series in 106 bits, step by step from time 0, for this reason.
    PowerSeries(Reason),
    /// C = O: the exact free top of section 6.
    FreeTop,
}

/// The state of Kovalevskaya's top at one time.
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
}

/// The constants of the motion (8.1, 8.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integrals {
    /// E = ½⟨IΩ,Ω⟩ + ⟨MgC, z⟩, J.
    pub energy: f64,
    /// L_vert = ⟨IΩ, z⟩, kg m²/s.
    pub vertical_angular_momentum: f64,
    /// Kovalevskaya's constant |K| = |(Ω₁+iΩ₂)² − (Mg/I₃)(C₁+iC₂)(z₁+iz₂)|, 1/s².
    pub kovalevskaya: f64,
}

/// A top with I₁ = I₂ = 2I₃ and its centre of mass in the plane of axes 1 and 2, with its motion prepared.
#[derive(Debug, Clone, PartialEq)]
pub struct KovalevskayaTop {
    /// I₃, kg m².
    pub(super) axial: f64,
    /// MgC, N m, along the body's axes.
    lever: BodyVector,
    /// The unit of angular velocity, a power of two; its reciprocal is that of time.
    pub(super) unit: f64,
    /// Angle from axis 1 to C about axis 3.
    pub(super) heading: f64,
    /// The start in the units and along the axes of the theory, rounded, and then in 106 bits.
    pub(super) start: FullState,
    pub(super) wide: WidePhase,
    pub(super) constants: Constants,
    kind: Kind,
    pub(super) motion: Motion,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Motion {
    Separated(Box<Precession>),
    Pendulum(Box<Pendulum>),
    Stepped(Reason),
    Free(Box<EulerTop>),
}

/// Above this, in rad/s, a rate that is rounded up could overflow.
const FASTEST: f64 = 1e307;

/// How far from 2 the ratios I₁/I₃ and I₂/I₃ may be rounded.
const ROUNDED: f64 = 8.0 * f64::EPSILON;

/// Units of time (the reciprocal of the greatest of |Ω_i(0)| and √(Mg|C|/I₃), up to a factor 2) beyond which doubles no longer give the phases to 1e-6.
pub(super) const LONGEST: f64 = 1e9;

impl KovalevskayaTop {
    /// The top with these moments about the pivot O (kg m², axis by axis), this lever MgC (N m, C seen from O), Ω along the
    /// body's axes (rad/s) and attitude at time 0; space's third axis points up (8.1).
    ///
    /// Domain: I₁ = I₂ = 2I₃ up to 8 eps, which is taken for rounding (the moments used are 2I₃, 2I₃, I₃), and C₃ = 0 exactly; C in any
    /// direction of the plane, or C = O. A real body must also satisfy Md² ≤ I₃/2, which is not checked, since mass and lever are not given
    /// separately. The regime is decided here: [`kind`](Self::kind), [`method`](Self::method).
    /// Cost: 0.12 ms in the median of random starts; a quarter of a millisecond where z starts along axis 3, 4 µs for a pendulum.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Condition`](crate::Error::Condition) for other ratios and for C off the plane;
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for |Ω_i| or √(Mg|C|/I₃) above 10³⁰⁷.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// use spinning_bodies::frame::Attitude;
    /// let upright = KovalevskayaTop::new([2.0, 2.0, 1.0], lever, omega, Attitude::identity())?;
    /// assert_eq!(upright.method(), Method::Elliptic);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        moments: [f64; 3],
        lever: BodyVector,
        omega: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        let q = attitude.quaternion();
        let quaternion = [q.w, q.i, q.j, q.k].map(DoubleDouble::from);
        Self::exactly(moments, widened(lever), widened(omega), quaternion)
    }

    /// The same from a lever, Ω and a quaternion w, x, y, z of norm 1 that have not been rounded to doubles: near the upright the motion would amplify
    /// the rounding.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub(crate) fn exactly(
        moments: [f64; 3],
        lever: [DoubleDouble; 3],
        omega: [DoubleDouble; 3],
        quaternion: [DoubleDouble; 4],
    ) -> Result<Self> {
        let [w, x, y, z] = quaternion;
        let twice = |a: DoubleDouble, b: DoubleDouble| (a * b).scaled(2.0);
        let square = |a: DoubleDouble| a * a;
        let up = [
            twice(x, z) - twice(w, y),
            twice(y, z) + twice(w, x),
            square(w) + square(z) - (square(x) + square(y)),
        ];
        let [w, x, y, z] = quaternion.map(DoubleDouble::value);
        let attitude = Attitude::from_unit(Quaternion::new(w, x, y, z));
        Self::prepare(moments, lever, omega, up, attitude)
    }

    /// The same from the upward vector z along the body's axes; the attitude is the shortest turn of z onto the vertical; where z
    /// points below the horizon, that after half a turn about axis 1.
    ///
    /// `up` of any length but zero.
    ///
    /// # Errors
    /// As for [`new`](Self::new), and [`Error::ZeroVector`](crate::Error::ZeroVector).
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, kovalevskaya_top::KovalevskayaTop};
    /// let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let k = top.constants().kovalevskaya;
    /// assert!((k - 257f64.sqrt() / 12.0).abs() < 1e-15);
    /// let later = top.at(1.0)?;
    /// assert!((later.omega.x() - 1.110_955_534_402_430_9).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn with_up(
        moments: [f64; 3],
        lever: BodyVector,
        omega: BodyVector,
        up: BodyVector,
    ) -> Result<Self> {
        let direction = up.direction("the vertical")?;
        let attitude = Attitude::from_unit(shortest(direction.components().into()));
        let size = power_of_two_below(up.components().amax());
        let up = [up.x(), up.y(), up.z()].map(|z| DoubleDouble::from(z / size));
        Self::prepare(moments, widened(lever), widened(omega), up, attitude)
    }

    fn prepare(
        moments: [f64; 3],
        wide_lever: [DoubleDouble; 3],
        omega: [DoubleDouble; 3],
        up: [DoubleDouble; 3],
        attitude: Attitude,
    ) -> Result<Self> {
        let lever = BodyVector::from(wide_lever.map(DoubleDouble::value));
        let rounded_omega = BodyVector::from(omega.map(DoubleDouble::value));
        each(positive, "a principal moment", moments)?;
        let axial = moments[2];
        for moment in &moments[..2] {
            let ratio = moment / axial;
            // An infinite quotient of finite moments is refused here too.
            if (ratio - 2.0).abs() > 2.0 * ROUNDED {
                return refused("I1/I3 and I2/I3 must be 2 for Kovalevskaya's top", ratio);
            }
        }
        finite_vector("the lever MgC", lever)?;
        finite_vector("the angular velocity", rounded_omega)?;
        if lever.z() != 0.0 {
            let condition = "the centre of mass of Kovalevskaya's top must lie in the plane of axes 1 and 2, C3 = 0";
            return refused(condition, lever.z());
        }
        let strength = finite("the lever over I3", lever.x().hypot(lever.y()) / axial)?;
        let fastest = rounded_omega.components().amax().max(strength.sqrt());
        within(
            "the angular velocity, or the square root of MgC/I3",
            fastest,
            0.0,
            FASTEST,
        )?;
        let unit = power_of_two_below(fastest);
        // In two quotients: the square of the unit may overflow or underflow where the result does not.
        let rounded = strength / unit / unit;
        let (along, c) = direction_of_lever(wide_lever, axial, rounded);
        let scaled = omega.map(|rate| rate / DoubleDouble::from(unit));
        let wide = start_of(along, scaled, up);
        let start = wide.map(DoubleDouble::value);
        let constants = Constants::of(c, &wide);
        let [cosine, sine] = along.map(DoubleDouble::value);
        let heading = sine.atan2(cosine);
        let turned = attitude.quaternion().into_inner() * about_third(heading);
        let start = (start, turned);
        let motion = if rounded == 0.0 {
            // Only ratios matter, so that no moment or rate can be too small to square.
            let free = EulerTop::from_omega([2.0, 2.0, 1.0], rounded_omega / unit, attitude)?;
            Motion::Free(Box::new(free))
        } else if let Some(pendulum) = Pendulum::find(&constants, &wide, &start) {
            Motion::Pendulum(Box::new(pendulum))
        } else {
            match Precession::find(&constants, &wide, &start) {
                Ok(separated) => Motion::Separated(Box::new(separated)),
                Err(reason) => Motion::Stepped(reason),
            }
        };
        Ok(Self {
            axial,
            lever,
            unit,
            heading,
            start,
            wide,
            constants,
            kind: classify(&constants),
            motion,
        })
    }

    /// The kind of motion, by the position of the five roots; decided once.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// assert_eq!(top.kind(), Kind::General);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn kind(&self) -> Kind {
        self.kind
    }

    /// The method by which the motion is computed, and if it is not separation, why.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// assert_eq!(top.method(), Method::Separation);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn method(&self) -> Method {
        match &self.motion {
            Motion::Separated(_) if self.constants.upright => Method::Elliptic,
            Motion::Separated(_) => Method::Separation,
            Motion::Pendulum(_) => Method::Elliptic,
            Motion::Stepped(reason) => Method::PowerSeries(*reason),
            Motion::Free(_) => Method::FreeTop,
        }
    }

    /// E, L_vert and |K|, from the start (8.1, 8.2).
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let kept = top.constants();
    /// // ½(2·1² + 2·0.5² + 0.3²) + 2/3, and 2·(2/3) − 2·0.5/3 + 0.3·2/3.
    /// assert!((kept.energy - (1.295 + 2.0 / 3.0)).abs() < 1e-15);
    /// assert!((kept.vertical_angular_momentum - 1.2).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn constants(&self) -> Integrals {
        let Constants { l1, l, k, .. } = self.constants;
        let unit = self.unit;
        Integrals {
            energy: 3.0 * l1.value() * unit * unit * self.axial,
            vertical_angular_momentum: 2.0 * l.value() * unit * self.axial,
            kovalevskaya: k.value() * unit * unit,
        }
    }

    /// Ω and z at any time t (s), without the attitude: at the same cost for every t where [`method`](Self::method) is not
    /// [`PowerSeries`](Method::PowerSeries).
    ///
    /// Quotients of sums of seven theta functions, moved to the nearest point of the surface E, L_vert, |z|,
    /// |K| = const. Error: see [the module](super). Cost: 1 µs in the median.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) for |t| beyond 10⁹ units of the motion (4096 by power series), the unit being 1/max(|Ω|, √(Mg|C|/I₃));
    /// [`Error::Integration`](crate::Error::Integration) if, by power series, the motion has amplified rounding more than 10¹⁷ times by then, with the time at which it does.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let late = top.omega_and_up(1e5)?;
    /// let energy = top.heavy_top()?.energy(&late);
    /// assert_eq!(top.omega_and_up(0.0)?.omega, omega);
    /// assert!((energy - top.constants().energy).abs() < 1e-14 && (late.up.norm() - 1.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn omega_and_up(&self, t: f64) -> Result<TopState> {
        match &self.motion {
            Motion::Separated(separated) if t != 0.0 => {
                let time = self.scaled_time(t, LONGEST)?;
                Ok(self.restored_state(&separated.exact.state(&self.constants, time)))
            }
            _ => {
                let State { omega, up, .. } = self.at(t)?;
                Ok(TopState { omega, up })
            }
        }
    }

    // ANCHOR: stated_error
    /// The error stated for time t (s): of Ω in units of u, of z, and of the attitude in radians.
    ///
    /// 10⁻¹² + 2·10⁻¹³|t|u, multiplied for [`Separation`](Method::Separation) by max(1, u²I₃/Mg|C|), where u is the power of two next below the greatest of |Ω_i(0)| and √(Mg|C|/I₃).
    /// Observed over 8000 starts, near double roots and far from them, up to |t|u = 100, and over 16,000 scenes: at worst 0.6 of it, for the azimuth near a
    /// double root; over 1000 starts with z along axis 3 and Ω nearly so 0.4 of it; Ω and z far less.
    /// The doubles given are taken as exact: how the motion amplifies their own rounding is not included.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// assert_eq!(top.stated_error(0.0), 1e-12);
    /// // Upright, and hardly turning about the other axes: by a power series of 34 digits, a turn half of 0.9570… about axis 1.
    /// let [omega, up] = [BodyVector::new(0.0, 1e-8, 0.2), BodyVector::new(0.0, 0.0, 1.0)];
    /// let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, up)?;
    /// assert!((top.at(100.0)?.attitude.quaternion().i.abs() - 0.957_015_675_680_616_1).abs() < top.stated_error(100.0));
    /// // Soon after an upright start with a small K, the azimuth of axis 3 is known only as well as the argument of θ: by the same series, 0.069….
    /// let [lever, omega] = [BodyVector::new(-0.25, -0.415, 0.0), BodyVector::new(7e-5, 6e-5, -1.4)];
    /// let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, up)?;
    /// assert!((top.at(0.1)?.attitude.quaternion().k.abs() - 0.069_942_826_676_652_3).abs() < top.stated_error(0.1));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn stated_error(&self, t: f64) -> f64 {
        let weak = match self.motion {
            Motion::Separated(_) => self.constants.c.value().min(1.0),
            _ => 1.0,
        };
        (1e-12 + 2e-13 * (t * self.unit).abs()) / weak
    }
    // ANCHOR_END: stated_error

    /// Turns of the two phases a second, or `None` where the motion is not separated.
    ///
    /// Ω and z are functions of two angles that advance uniformly at these rates; they return to themselves after an even number of turns of each.
    /// Error: 1e-15 relative. Cost: none.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// // Constants of the motion: they are the same from any later state.
    /// let later = top.omega_and_up(3.0)?;
    /// let again = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, later.omega, later.up)?;
    /// let ([n1, n2], [m1, m2]) = (top.frequencies().expect("separated"), again.frequencies().expect("separated"));
    /// assert!((n1 - m1).abs() < 1e-13 && (n2 - m2).abs() < 1e-13);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn frequencies(&self) -> Option<[f64; 2]> {
        let turns = self.separation()?.frequencies();
        Some(turns.map(|n| n.value() * self.unit))
    }

    /// Kovalevskaya's separation variables s₁, s₂ of any state with the same constants, directly from their definition (8.2), 1/s².
    ///
    /// s = l₁/2 + (R(x₁,x₂) ∓ |R(x₁)|)/(2(x₁−x₂)²) with x₁,₂ = Ω₁ ± iΩ₂ along axes for which C₂ = 0. Error: a few eps of |Ω|². Cost: a few multiplications.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let state = top.omega_and_up(2.5)?;
    /// let [s1, s2] = top.separation_variables(&state);
    /// let p = |s: f64| top.roots().iter().map(|e| s - e).product::<nalgebra::Complex<f64>>().re * -4.0;
    /// assert!(s2 < s1 && p(s1) > 0.0 && p(s2) > 0.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn separation_variables(&self, state: &TopState) -> [f64; 2] {
        let inward = turned(self.heading, [state.omega.x(), state.omega.y()]);
        let inward = inward.map(|omega| DoubleDouble::from(omega / self.unit));
        let variables = Variables::of(&self.constants, inward);
        let half = 0.5 * self.constants.l1.value();
        let s2 = half - variables.numerator.value() / (8.0 * variables.q_squared.value());
        [variables.s1.value(), s2].map(|s| s * self.unit * self.unit)
    }

    /// The five roots of P(s) = −4(s−e₁)(s−e₂)(s−e₃)(s−e₄)(s−e₅), 1/s²: (s₁−s₂)² (ds_i/dt)² = P(s_i). e₁+e₂+e₃ = 0, e₄,₅ = (E/3I₃ ± |K|)/2.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let [a, b, c, fourth, fifth] = top.roots();
    /// assert!((a + b + c).norm() < 1e-15);
    /// assert!((fourth - fifth - top.constants().kovalevskaya).norm() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn roots(&self) -> [Complex<f64>; 5] {
        let square = self.unit * self.unit;
        self.constants.roots().map(|root| root.value() * square)
    }

    /// The same top as a [`HeavyTop`], for the general equations (5.1).
    ///
    /// # Errors
    /// None in practice: [`new`](Self::new) has already checked what is checked here.
    ///
    /// ```
    /// # use spinning_bodies::{frame::BodyVector, kovalevskaya_top::*};
    /// # let (lever, omega) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(1.0, 0.5, 0.3));
    /// # let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, omega, BodyVector::new(2.0, -1.0, 2.0))?;
    /// let heavy = top.heavy_top()?;
    /// assert!((heavy.energy(&top.omega_and_up(0.0)?) - top.constants().energy).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn heavy_top(&self) -> Result<HeavyTop> {
        let moments = AxisMoments::new(2.0 * self.axial, 2.0 * self.axial, self.axial)?;
        HeavyTop::new(moments, self.lever)
    }

    fn separation(&self) -> Option<&Separation> {
        match &self.motion {
            Motion::Separated(separated) if !self.constants.upright => {
                Some(&separated.exact.separation)
            }
            _ => None,
        }
    }

    /// The time in units of the motion, refused beyond `longest`.
    pub(super) fn scaled_time(&self, t: f64, longest: f64) -> Result<f64> {
        let time = finite("the time", t)? * self.unit;
        if time.abs() > longest {
            return Err(too_long(t, longest / self.unit));
        }
        Ok(time)
    }

    /// Ω and z in SI units along the body's axes.
    pub(super) fn restored_state(&self, &[p, q, r, z1, z2, z3]: &Phase) -> TopState {
        let [o1, o2] = turned(-self.heading, [p, q]);
        let [u1, u2] = turned(-self.heading, [z1, z2]);
        TopState {
            omega: BodyVector::new(o1, o2, r) * self.unit,
            up: BodyVector::new(u1, u2, z3),
        }
    }
}

fn widened(vector: BodyVector) -> [DoubleDouble; 3] {
    [vector.x(), vector.y(), vector.z()].map(DoubleDouble::from)
}

/// Cosine and sine of the angle from axis 1 to C, and c = MgC₁/I₃ in 106 bits, whose nearest double is `rounded`, or nearly.
fn direction_of_lever(
    [x, y, _]: [DoubleDouble; 3],
    axial: f64,
    rounded: f64,
) -> ([DoubleDouble; 2], DoubleDouble) {
    let wide = DoubleDouble::from;
    if rounded == 0.0 {
        return ([wide(1.0), wide(0.0)], wide(0.0));
    }
    let size = power_of_two_below(x.high().abs().max(y.high().abs()));
    let [x, y] = [x, y].map(|c| c / wide(size));
    let length = (x * x + y * y).square_root();
    let mantissa = length / wide(axial / power_of_two_below(axial));
    // The remaining factor is a power of two, found without forming powers that overflow.
    let power = power_of_two_below(1.5 * (rounded / mantissa.high()));
    ([x / length, y / length], mantissa.scaled(power))
}

/// Ω and z along the axes for which C₂ = 0 < C₁, z of length 1.
fn start_of(
    [cosine, sine]: [DoubleDouble; 2],
    [p, q, r]: [DoubleDouble; 3],
    up: [DoubleDouble; 3],
) -> WidePhase {
    let turned = |[x, y]: [DoubleDouble; 2]| [cosine * x + sine * y, cosine * y - sine * x];
    let square = up.map(|z| z * z);
    let length = (square[0] + square[1] + square[2]).square_root();
    let [x, y, z3] = up.map(|z| z / length);
    let ([p, q], [z1, z2]) = (turned([p, q]), turned([x, y]));
    [p, q, r, z1, z2, z3]
}

/// The components of a vector along axes turned by an angle.
fn turned(angle: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x + sine * y, cosine * y - sine * x]
}

/// Semi-axes a ≤ b < c (m) of a homogeneous ellipsoid that is Kovalevskaya's top: of this mass (kg), with the least moment I₃ (kg m²) about a pivot
/// at this distance d (m) from its centre, on its shortest axis (8.1).
///
/// b² = 5I₃/(2M), c² = 3b² and a² = b² − 5d², in 106 bits: a body that is nearly a disc loses nothing until its a² is 10⁻¹⁵ of its b². Error: 1 ε; that of a is 10⁻³¹ b²/a² where that is more. The moment about the longest axis is I₃.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::NotPositive`](crate::Error::NotPositive) for mass or moment; [`Error::Negative`](crate::Error::Negative) for d; [`Error::Condition`](crate::Error::Condition) unless 2Md² < I₃: otherwise a² would not be positive.
///
/// ```
/// use spinning_bodies::kovalevskaya_top::ellipsoid;
/// let [a, b, c] = ellipsoid(1.0, 1.2, 0.4_f64.sqrt())?;
/// assert!((a - 1.0).abs() < 1e-15 && (b - 3_f64.sqrt()).abs() < 1e-15 && (c - 3.0).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn ellipsoid(mass: f64, least_moment: f64, distance: f64) -> Result<[f64; 3]> {
    positive("the mass", mass)?;
    positive("the least moment", least_moment)?;
    not_negative("the distance of the pivot from the centre", distance)?;
    let [heavy, moment, distant] = [mass, least_moment, distance].map(Extended::from_double);
    // I₃ − 2Md², which is small for a body that is nearly a disc.
    let rest = moment - (distant.square() * heavy).times(2.0);
    if rest.leading() <= 0.0 {
        let condition = "twice the mass times the square of the pivot's distance must be less than the least moment";
        return refused(condition, distance);
    }
    let axis = |square: Extended| {
        let square = square.times(2.5).quotient(heavy);
        finite("a semi-axis", square.square_root().value())
    };
    Ok([axis(rest)?, axis(moment)?, axis(moment.times(3.0))?])
}
