//! The exact motion of a free rigid body (tutorial 6.1, 6.6, 6.8): angular velocity, angular momentum and attitude at any time.

use nalgebra::{Quaternion, UnitQuaternion};

use super::evaluation::{Constants, Moving, State, vector};
use super::preparation::{Quantity, Regime, Start, decide, decide_from, ratio};
use crate::elliptic::Parameter;
use crate::elliptic::lanes::{fill, turned};
use crate::error::{Result, each, each_finite, finite, not_negative, positive, refused};
use crate::frame::{Attitude, BodyVector, SpaceVector, finite_vector};
use crate::inertia::{InertiaMatrix, PrincipalMoments};
use crate::precise::{DoubleDouble, Extended, Number, power_of_two_below, sum_of_products};
use crate::search::ascending;

/// A free rigid body whose motion has been prepared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerTop {
    pub(super) moments: [f64; 3],
    pub(super) angular_momentum: BodyVector,
    pub(super) attitude: Attitude,
    regime: Regime,
    pub(super) motion: Motion,
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(
    clippy::large_enum_variant,
    reason = "a top is one value without allocation; most tops move"
)]
pub(super) enum Motion {
    /// Ω is constant: its components, its magnitude to 106 bits, its direction.
    Steady {
        omega: [f64; 3],
        rate: DoubleDouble,
        direction: [f64; 3],
    },
    Moving(Moving),
}

impl EulerTop {
    /// The body with these principal moments (kg m², in any order), with this angular momentum along its principal axes
    /// (kg m²/s) and this attitude at time 0.
    ///
    /// Domain: any moments that a body can have, rods and laminae included, at any scale; any L, however close to an axis
    /// or to the separatrix. The doubles given are taken as exact. Cost: some fifteen evaluations of
    /// [`at`](Self::at), thirty next to an axis or to the separatrix, for constants to 106 bits; with them later times lose no digit.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), also if Ω or the rate of the motion would leave the range of doubles; [`Error::Negative`](crate::Error::Negative) and
    /// [`Error::TriangleInequality`](crate::Error::TriangleInequality) for moments that no body has (2.4);
    /// [`Error::Condition`](crate::Error::Condition) for an angular momentum about an axis whose moment is zero.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let l = BodyVector::new(0.01, 2.0, 0.03);
    /// let top = EulerTop::new([1.0, 2.0, 3.0], l, Attitude::identity())?;
    /// // L along the axes of space has not changed.
    /// assert!((top.at(1e6)?.attitude.to_space(top.at(1e6)?.angular_momentum) - top.angular_momentum_in_space()).norm() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        moments: [f64; 3],
        angular_momentum: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        PrincipalMoments::new(moments[0], moments[1], moments[2])?;
        Self::beyond_bodies(moments, angular_momentum, attitude)
    }

    /// The same from the angular velocity along the principal axes at time 0, rad/s; I Ω is formed without rounding.
    ///
    /// The component along an axis whose moment is zero has no meaning and is ignored.
    ///
    /// # Errors
    /// As for [`new`](Self::new); [`Error::Condition`](crate::Error::Condition) if I Ω is below the range of doubles.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.01, 1.0, 0.01);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// assert!((top.at(0.0)?.angular_momentum.y() - 2.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_omega(moments: [f64; 3], omega: BodyVector, attitude: Attitude) -> Result<Self> {
        PrincipalMoments::new(moments[0], moments[1], moments[2])?;
        Self::beyond_bodies_from_omega(moments, omega, attitude)
    }

    /// The same as [`new`](Self::new) for any moments, such as 1, 2, 5, which no body has: Euler's equations hold for them as well.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative) for a moment, [`Error::Condition`](crate::Error::Condition) if one moment is zero and L has a component
    /// about that axis, or the other two moments differ.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let l = BodyVector::new(1.0, 2.0, 3.0);
    /// assert!(EulerTop::new([1.0, 2.0, 5.0], l, Attitude::identity()).is_err());
    /// assert!(EulerTop::beyond_bodies([1.0, 2.0, 5.0], l, Attitude::identity()).is_ok());
    /// ```
    pub fn beyond_bodies(
        moments: [f64; 3],
        angular_momentum: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        let name = "a component of the angular momentum";
        let quantity = Quantity::AngularMomentum;
        Self::prepared(moments, (name, quantity, angular_momentum), attitude)
    }

    /// The same as [`beyond_bodies`](Self::beyond_bodies) from the angular velocity along the principal axes, rad/s; I Ω is formed without rounding.
    ///
    /// # Errors
    /// As for [`beyond_bodies`](Self::beyond_bodies); [`Error::Condition`](crate::Error::Condition) if I Ω is below the range of doubles.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.3, 1.0, -0.2);
    /// let top = EulerTop::beyond_bodies_from_omega([1.0, 2.0, 5.0], omega, Attitude::identity())?;
    /// assert!((top.at(0.0)?.angular_momentum - BodyVector::new(0.3, 2.0, -1.0)).norm() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn beyond_bodies_from_omega(
        moments: [f64; 3],
        omega: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        let name = "a component of the angular velocity";
        Self::prepared(moments, (name, Quantity::Omega, omega), attitude)
    }

    /// The body with these principal moments (kg m², in any order), L² (kg² m⁴/s²) and kinetic energy E (J), with this attitude at time 0 (6.6).
    ///
    /// At time 0 Ω crosses the plane of the axes of the smallest and the largest moment, its components along both not negative:
    /// L₁² = I₁(2EI₃ − L²)/(I₃ − I₁), L₂ = 0, L₃² = I₃(L² − 2EI₁)/(I₃ − I₁) for ascending moments; with L² = 2EI₂ this is the middle of the single flip.
    /// In a symmetric top the part of Ω in the plane of the equal moments is along the first of their axes in that order, in a sphere Ω is along its third axis.
    /// All differences are exact for the doubles given, so the separatrix is recognised exactly; where 2EI₂ is not a double,
    /// [`beside_separatrix`](Self::beside_separatrix) reaches it. Cost: some twenty evaluations of [`at`](Self::at).
    ///
    /// # Errors
    /// As for [`new`](Self::new), but [`Error::NotPositive`](crate::Error::NotPositive) for a moment that is zero, because L² and E do not determine how a rod moves; [`Error::Negative`](crate::Error::Negative) for L² or E;
    /// [`Error::Condition`](crate::Error::Condition) unless 2EI₁ ≤ L² ≤ 2EI₃.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::{EulerTop, Regime}, frame::Attitude};
    /// let flip = EulerTop::from_integrals([1.0, 2.0, 3.0], 4.0, 1.0, Attitude::identity())?;
    /// assert_eq!(flip.regime(), Regime::Separatrix);
    /// // L = (1, 0, √3) at the middle of the half turn, and L₁ = sech(t/√3) around it.
    /// let l = flip.at(1000.0)?.angular_momentum;
    /// assert!((l.x() * (1000.0 / 3f64.sqrt()).cosh() - 1.0).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_integrals(
        moments: [f64; 3],
        l_squared: f64,
        energy: f64,
        attitude: Attitude,
    ) -> Result<Self> {
        not_negative("the square of the angular momentum", l_squared)?;
        Self::from_energy(moments, energy, [l_squared, 0.0], attitude)
    }

    /// The same as [`from_integrals`](Self::from_integrals), from the energy (J) and the distance L² − 2EI₂ from the separatrix (kg² m⁴/s²). Distance zero is the
    /// separatrix itself for every body, and next to it no digit is lost.
    ///
    /// # Errors
    /// As for [`from_integrals`](Self::from_integrals).
    ///
    /// ```
    /// use spinning_bodies::{euler_top::{EulerTop, Regime}, frame::Attitude};
    /// let at = |distance| EulerTop::beside_separatrix([0.3, 0.5, 0.7], 0.1, distance, Attitude::identity());
    /// assert_eq!(at(0.0)?.regime(), Regime::Separatrix);
    /// assert_eq!(at(5e-324)?.regime(), Regime::AroundLargest);
    /// assert_eq!(at(-5e-324)?.regime(), Regime::AroundSmallest);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn beside_separatrix(
        moments: [f64; 3],
        energy: f64,
        distance: f64,
        attitude: Attitude,
    ) -> Result<Self> {
        finite("the distance L² − 2EI₂ from the separatrix", distance)?;
        Self::from_energy(moments, energy, [distance, 2.0], attitude)
    }

    /// From E, and L² as the sum of a double and a multiple of EI₂.
    fn from_energy(
        moments: [f64; 3],
        energy: f64,
        [l_squared, share]: [f64; 2],
        attitude: Attitude,
    ) -> Result<Self> {
        each(positive, "a principal moment", moments)?;
        PrincipalMoments::new(moments[0], moments[1], moments[2])?;
        not_negative("the kinetic energy", energy)?;
        let order = ascending([0, 1, 2], &moments);
        let i = order.map(|k| moments[k]);
        // L² − 2EI_k.
        let [least, middle, greatest] = i.map(|moment| {
            let less = [-energy, moment];
            let more = [energy, if share == 0.0 { 0.0 } else { i[1] }];
            sum_of_products(&[[l_squared, 1.0], more, more, less, less])
        });
        let number = Extended::from_double;
        if least.leading() < 0.0 || greatest.leading() > 0.0 {
            let condition =
                "L² must lie between 2E times the smallest and 2E times the largest moment";
            return refused(
                condition,
                (middle + number(energy).times(2.0) * number(i[1])).value(),
            );
        }
        let span = Extended::difference(i[2], i[0]);
        let part = |above: Extended, moment: f64| (above * number(moment)).quotient(span);
        let third = if span.is_zero() {
            // All moments equal: L² = 2EI.
            number(energy).times(2.0) * number(i[2])
        } else {
            part(least, i[2])
        };
        let mut l = [Extended::zero(); 3];
        (l[order[0]], l[order[2]]) = (part(-greatest, i[0]).square_root(), third.square_root());
        let separation = middle * number(i[0]) * number(i[2]);
        let decided = decide_from(moments, l, |_, _| separation);
        Self::assembled(moments, &l, attitude, decided)
    }

    fn prepared(
        moments: [f64; 3],
        (name, quantity, start): (&'static str, Quantity, BodyVector),
        attitude: Attitude,
    ) -> Result<Self> {
        each(not_negative, "a principal moment", moments)?;
        let components = finite_vector(name, start)?.components().into();
        let start = Start {
            quantity,
            components,
        };
        start.refuse_impossible_rod(moments)?;
        let l = start.angular_momentum(moments);
        let largest = vector(l.map(Extended::value)).components().amax();
        let turns = quantity == Quantity::Omega && l.iter().any(|component| !component.is_zero());
        if largest < f64::MIN_POSITIVE && turns {
            let condition = "the angular momentum of a body that turns must not underflow";
            return refused(condition, largest);
        }
        Self::assembled(moments, &l, attitude, decide(moments, start))
    }

    /// From the regime, the constants and L before rounding.
    fn assembled(
        moments: [f64; 3],
        exact: &[Extended; 3],
        attitude: Attitude,
        (regime, constants): (Regime, Option<Constants>),
    ) -> Result<Self> {
        let l = exact.map(Extended::value);
        let components = l.into_iter().chain(ratio(l, moments));
        each_finite("a component of angular velocity or momentum", components)?;
        let angular_momentum = vector(l);
        if angular_momentum.components().amax() > f64::MAX / 2.0 {
            finite("the size of the angular momentum", angular_momentum.norm())?;
        }
        let motion = match constants {
            None => steady(moments, exact)?,
            Some(constants) => {
                let rate = constants.course.rate.value().abs();
                let rate = rate.max(constants.turning_rate.value());
                finite("the rate of the motion", rate)?;
                // L may swing onto an axis with a smaller moment, where Ω is greater than at the start, or round up.
                let axes = constants.axes;
                let peaks = ratio(constants.amplitudes, axes.renumber(moments));
                let doubled = peaks.map(|peak| 2.0 * peak);
                each_finite("twice the greatest angular velocity", doubled)?;
                Motion::Moving(Moving::new(constants, peaks, attitude)?)
            }
        };
        Ok(Self {
            moments,
            angular_momentum,
            attitude,
            regime,
            motion,
        })
    }

    /// The kind of motion, decided once from exact differences.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::{EulerTop, Regime}, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.01, 1.0, 0.01);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// // I₁(I₂ − I₁)Ω₁² < I₃(I₃ − I₂)Ω₃².
    /// assert_eq!(top.regime(), Regime::AroundLargest);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn regime(&self) -> Regime {
        self.regime
    }

    /// The principal moments, kg m², in the order they were given.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.01, 1.0, 0.01);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// assert_eq!(top.moments(), [1.0, 2.0, 3.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Ω, L and attitude at any time t (s), before or after the start (6.6, 6.8).
    ///
    /// (L₁, L₂, L₃) = (P₁ cn u, P₂ sn u, P₃ dn u), u = u₀ + λt, and the attitude turned about L by an angle that theta functions
    /// give. Error observed against 998 references of 32 digits, ordinary bodies and every hard case: attitude at most
    /// 9e-16 rad, Ω and L 5e-16, at any time up to 10⁹ periods; beyond, up to 10⁻²⁶ of the angle turned is added. Cost: the same at every
    /// time, about that of one sn, cn, dn in the GNU Scientific Library.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{EulerTop, Regime};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let (start, upright) = (BodyVector::new(0.0, 1.0, 1e-9), Attitude::identity());
    /// let racket = EulerTop::from_omega([1.0, 2.0, 3.0], start, upright)?;
    /// assert_eq!(racket.regime(), Regime::AroundLargest);
    /// let flipped = racket.at(racket.period() / 2.0)?;
    /// assert!((flipped.omega.y() + 1.0).abs() < 1e-15);
    /// // A phase beyond every double: the error tells how late a time may be.
    /// let ball = EulerTop::from_omega([1.0; 3], BodyVector::new(0.0, 0.0, 1e10), upright)?;
    /// let most = |t| ball.at(t).unwrap_err().to_string().contains("-9.2e8 and 9.2e8");
    /// assert!(most(1e9) && most(1e300));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) beyond 2⁵³ quarter periods,
    /// where a double can no longer count them, or 2⁶³ radians.
    pub fn at(&self, t: f64) -> Result<State> {
        let t = finite("the time", t)?;
        match &self.motion {
            Motion::Steady {
                omega,
                rate,
                direction,
            } => {
                let (sine, cosine) = turned(rate.scaled(0.5), t, DoubleDouble::from(0.0))?;
                let [x, y, z] = direction.map(|component| sine * component);
                let turn = Quaternion::new(cosine, x, y, z);
                Ok(State {
                    omega: vector(*omega),
                    angular_momentum: self.angular_momentum,
                    attitude: Attitude::from_unit(self.attitude.quaternion().into_inner() * turn),
                })
            }
            Motion::Moving(body) => body.at(t),
        }
    }

    /// Ω alone, rad/s, along the body's axes (6.6).
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.0, 0.0, 2.0);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// assert_eq!(top.omega_at(1e9)?, omega);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn omega_at(&self, t: f64) -> Result<BodyVector> {
        Ok(self.at(t)?.omega)
    }

    /// The states at these times, one after another.
    ///
    /// # Errors
    /// Each as for [`at`](Self::at).
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.01, 1.0, 0.01);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// let states: Result<Vec<_>, _> = top.states([0.0, 0.5, 1.0]).collect();
    /// assert_eq!(states?[2], top.at(1.0)?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states(
        &self,
        times: impl IntoIterator<Item = f64>,
    ) -> impl Iterator<Item = Result<State>> {
        times.into_iter().map(|t| self.at(t))
    }

    /// Fills a slice with Ω, L and attitude at each of these times (s), which may be in any order; the slices have one length (6.6, 6.8).
    ///
    /// The states are those of [`at`](Self::at) to the last bit, with its domain and error. Eight times are computed side by side up to some 8·10⁶ turns from the
    /// start, unless a rate is near the ends of the range of doubles; the others one by one. Different threads may fill parts of the slices.
    ///
    /// Cost a state, relative to [`at`](Self::at) in the same run (`cargo bench -p lab --bench ensembles`), with the instructions that every processor of the
    /// family has: 0.35 where m ≤ 1/2, 0.42 where m > 1/2, 1 where Ω is constant; 1.1 for a batch of one time.
    ///
    /// # Errors
    /// [`Error::Condition`](crate::Error::Condition) if the slices differ in length; otherwise that of the first time that [`at`](Self::at) refuses, with some of the states
    /// written.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{EulerTop, State};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let start = BodyVector::new(1.8, 0.4, -0.9);
    /// let top = EulerTop::new([0.6, 0.8, 1.0], start, Attitude::identity())?;
    /// let times: Vec<f64> = (0..100).map(|k| 0.1 * f64::from(k)).collect();
    /// let mut states = [State::default(); 100];
    /// top.states_at(&times, &mut states)?;
    /// assert_eq!(states[70], top.at(times[70])?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states_at(&self, times: &[f64], states: &mut [State]) -> Result<()> {
        let moving = self.moving().map(|body| (body, body.reach));
        fill(times, states, moving, |t| self.at(t), Moving::side_by_side)
    }

    /// Kinetic energy ½⟨Ω, L⟩, J: constant (6.1).
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(2.0, 1.0, 2.0);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// // ½(1·4 + 2·1 + 3·4).
    /// assert_eq!(top.energy(), 9.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy(&self) -> f64 {
        let l: [f64; 3] = self.angular_momentum.components().into();
        let omega = ratio(l, self.moments);
        (0..3).map(|k| 0.5 * omega[k] * l[k]).sum()
    }

    /// L along the axes of space, kg m²/s: constant (6.1).
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector, SpaceVector}};
    /// let omega = BodyVector::new(2.0, 1.0, 2.0);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// assert_eq!(top.angular_momentum_in_space(), SpaceVector::new(2.0, 2.0, 6.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_momentum_in_space(&self) -> SpaceVector {
        // The products that rotation adds may overflow or underflow where the result does not.
        let unit = power_of_two_below(self.angular_momentum.components().amax());
        let l = self.attitude.to_space(self.angular_momentum / unit) * unit;
        let [x, y, z] =
            <[f64; 3]>::from(l.components()).map(|component| component.clamp(-f64::MAX, f64::MAX));
        SpaceVector::new(x, y, z)
    }

    /// The motion, unless Ω is constant.
    const fn moving(&self) -> Option<&Moving> {
        match &self.motion {
            Motion::Moving(body) => Some(body),
            Motion::Steady { .. } => None,
        }
    }

    /// Period of Ω in the body, 4K/λ, s: once round the polhode (6.6). In general the attitude does not return with it.
    ///
    /// Infinite where Ω is constant, and on the separatrix. Error: 2 ulp.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.1, 0.2, 1.0);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// let later = top.omega_at(top.period())?;
    /// assert!((later - omega).norm() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn period(&self) -> f64 {
        let moving = self.moving();
        moving.map_or(f64::INFINITY, |body| body.constants.period())
    }

    /// The parameter m = k² of the elliptic functions in Ω, and its complement (6.6): 0 for a symmetric top, 1 on the separatrix. `None` where Ω
    /// is constant. Error: 1 ulp of the lesser of m and 1 − m.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let top = EulerTop::new([1.0, 2.0, 3.0], BodyVector::new(2.0, 2.0, 3.0), Attitude::identity())?;
    /// // (I₃ − I₂)(L² − 2EI₁)/((I₂ − I₁)(2EI₃ − L²)) with 2E = 9 and L² = 17 < 2EI₂.
    /// assert!((top.parameter().expect("it moves").m() - 0.8).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn parameter(&self) -> Option<Parameter> {
        let constants = &self.moving()?.constants;
        Some(constants.course.modulus.parameter)
    }

    /// Mean rate, rad/s, at which the axis that L circles in the body goes round L in space, right-handed about L (6.5, 6.8).
    ///
    /// |L|/I₁ for a symmetric top. Where Ω is constant: the rate 2E/|L| at which the body turns about L; 0 at rest. Infinite beyond the doubles. Error: 2 ulp; for a needle that spins about its own axis, with
    /// a moment of 10⁻¹⁶ of the others or less, 10⁻³² of the spin.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// // Nearly about axis 3 that is Ω₃(1 + √((I₃−I₁)(I₃−I₂)/I₁I₂)), for a symmetric body |L|/I₁.
    /// let omega = BodyVector::new(1e-9, 0.0, 1.0);
    /// let top = EulerTop::from_omega([1.0, 1.0, 1.5], omega, Attitude::identity())?;
    /// assert!((top.mean_precession_rate() - 1.5).abs() < 1e-14);
    /// // The tilt, 10⁻³¹⁰, is below every normal number.
    /// let upright = EulerTop::new([1.0, 1.0, 1.5], BodyVector::new(1e-155, 0.0, 1e155), Attitude::identity())?;
    /// assert!((upright.mean_precession_rate() / 1e155 - 1.0).abs() < 1e-15);
    /// // |L|/I₁ = 2·10³⁰⁸.
    /// let fast = EulerTop::beyond_bodies([0.25, 0.25, 0.75], BodyVector::new(1e300, 0.0, 5e307), Attitude::identity())?;
    /// assert_eq!(fast.mean_precession_rate(), f64::INFINITY);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn mean_precession_rate(&self) -> f64 {
        match &self.motion {
            Motion::Steady { rate, .. } => rate.value(),
            Motion::Moving(Moving { constants, .. }) => constants.mean_precession_rate(),
        }
    }

    /// The angle by which the body has turned about L when Ω has returned, in Montgomery's two terms (6.8); `None` where Ω has no period.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::EulerTop, frame::{Attitude, BodyVector}};
    /// let omega = BodyVector::new(0.1, 0.2, 1.0);
    /// let top = EulerTop::from_omega([1.0, 2.0, 3.0], omega, Attitude::identity())?;
    /// let phase = top.geometric_phase().unwrap();
    /// let turned = Attitude::about_axis(top.at(0.0)?.angular_momentum, phase.dynamical + phase.geometric)?;
    /// assert!(top.at(top.period())?.attitude.angle_to(&turned) < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn geometric_phase(&self) -> Option<GeometricPhase> {
        let constants = &self.moving()?.constants;
        // 2E/|L| is the component of Ω along L.
        let size = self.angular_momentum.norm();
        let l: [f64; 3] = self.angular_momentum.components().into();
        let omega = ratio(l, self.moments);
        let along: f64 = (0..3).map(|k| l[k] / size * omega[k]).sum();
        (self.regime != Regime::Separatrix).then(|| GeometricPhase {
            dynamical: along * constants.period(),
            geometric: -constants.solid_angle(),
        })
    }
}

/// The turn about L after one period of Ω, radians: the sum of the two terms, up to whole turns (6.8).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeometricPhase {
    /// 2ET/|L|: the constant component of Ω along L, times the period T.
    pub dynamical: f64,
    /// Minus the solid angle of the cone that L traces in the body, counted positive if L goes round anticlockwise as seen from its
    /// own tip. It depends on the shape of the path alone, not on the pace.
    pub geometric: f64,
}

/// A free body with any inertia matrix, its motion prepared: an [`EulerTop`] whose Ω, L and attitude are given along the axes of the matrix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeBody {
    principal: EulerTop,
    /// The rotation that turns components along the principal axes into those along the body's own.
    own: UnitQuaternion<f64>,
}

impl FreeBody {
    /// The body with this inertia matrix about its centre of mass (kg m²), with this Ω (rad/s) and this attitude at time 0, all along its own axes (2.3, 6.6).
    ///
    /// Error: that of [`EulerTop`], plus a rounding or two of the principal moments times the angle turned. Cost: [`EulerTop::new`] and
    /// [`InertiaMatrix::principal_axes`]; a state costs [`EulerTop::at`] and three rotations.
    ///
    /// # Errors
    /// As for [`EulerTop::from_omega`].
    ///
    /// ```
    /// use nalgebra::Matrix3;
    /// use spinning_bodies::{euler_top::FreeBody, frame::{Attitude, BodyVector}, inertia::InertiaMatrix};
    /// let matrix = Matrix3::new(2.0, -0.5, 0.1, -0.5, 2.5, 0.3, 0.1, 0.3, 3.0);
    /// let inertia = InertiaMatrix::from_matrix(matrix)?;
    /// let body = FreeBody::new(&inertia, BodyVector::new(1.0, -2.0, 0.5), Attitude::identity())?;
    /// let state = body.at(10.0)?;
    /// let l = inertia.angular_momentum(state.omega);
    /// assert!((l - state.angular_momentum).norm() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(inertia: &InertiaMatrix, omega: BodyVector, attitude: Attitude) -> Result<Self> {
        let axes = inertia.principal_axes();
        let own = axes.turn();
        // From Ω, not from L: rounding leaves a rod's own moment tiny, and L would have to be divided by it.
        let omega = own.inverse_transform_vector(&omega.components());
        let principal = EulerTop::from_omega(
            axes.principal_moments().values(),
            BodyVector::from_components(omega),
            attitude * Attitude::from(own),
        )?;
        Ok(Self { principal, own })
    }

    /// The motion along the principal axes, which has period, regime and integrals.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::FreeBody, frame::{Attitude, BodyVector}, inertia::InertiaMatrix};
    /// let inertia = InertiaMatrix::diagonal(3.0, 1.0, 2.0)?;
    /// let body = FreeBody::new(&inertia, BodyVector::new(1.0, 2.0, 3.0), Attitude::identity())?;
    /// assert_eq!(body.principal().energy(), 12.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn principal(&self) -> &EulerTop {
        &self.principal
    }

    /// Ω, L and attitude at time t (s), along the body's own axes (6.6, 6.8).
    ///
    /// # Errors
    /// As for [`EulerTop::at`]; [`Error::NotFinite`](crate::Error::NotFinite) for a component that leaves the range of doubles in these axes.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::FreeBody, frame::{Attitude, BodyVector}, inertia::InertiaMatrix};
    /// let inertia = InertiaMatrix::diagonal(3.0, 1.0, 2.0)?;
    /// let body = FreeBody::new(&inertia, BodyVector::new(1.0, 2.0, 3.0), Attitude::identity())?;
    /// let omega = body.at(100.0)?.omega;
    /// // The energy of 12.5 J is conserved.
    /// assert!((inertia.rotational_energy(omega) - 12.5).abs() < 1e-13);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, t: f64) -> Result<State> {
        let state = self.principal.at(t)?;
        let outward = |v: BodyVector| {
            let outward = BodyVector::from_components(self.own * v.components());
            finite_vector("a component along the body's own axes", outward)
        };
        Ok(State {
            omega: outward(state.omega)?,
            angular_momentum: outward(state.angular_momentum)?,
            attitude: state.attitude * Attitude::from(self.own.inverse()),
        })
    }
}

/// Rotation with constant Ω about L: at the rate 2E/|L| = Σ L_i²/I_i / |L|.
fn steady(moments: [f64; 3], l: &[Extended; 3]) -> Result<Motion> {
    let (mut square, mut twice_energy) = (Extended::zero(), Extended::zero());
    let mut omega = [0.0; 3];
    for (k, component) in l.iter().enumerate() {
        if !component.is_zero() {
            let (term, moment) = (component.square(), Extended::from_double(moments[k]));
            square = square.add_alike(term);
            twice_energy = twice_energy.add_alike(term.quotient(moment));
            omega[k] = component.quotient(moment).value();
        }
    }
    if square.is_zero() {
        return Ok(Motion::Steady {
            omega,
            rate: DoubleDouble::from(0.0),
            direction: [0.0, 0.0, 1.0],
        });
    }
    let size = square.square_root();
    let rate = twice_energy.quotient(size);
    finite("the rate of the motion", rate.value())?;
    Ok(Motion::Steady {
        omega,
        rate: rate.narrow(),
        direction: core::array::from_fn(|k| l[k].quotient(size).value()),
    })
}
