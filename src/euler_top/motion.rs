//! The exact motion of a free rigid body (tutorial 6.1, 6.6, 6.8): angular velocity, angular momentum and attitude at any time.

use nalgebra::Quaternion;

use super::evaluation::half_turn;
use super::preparation::{Constants, decide};
use super::start::{Digits, Start, ratio};
use crate::double_double::{DoubleDouble, power_of_two_below};
use crate::error::{Error, Result, finite, not_negative};
use crate::extended::{Extended, Scalar};
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;
use crate::words::Arithmetic;

/// What kind of motion a free top makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Regime {
    /// L = 0: nothing moves.
    AtRest,
    /// All moments equal: Ω stays (6.4).
    Sphere,
    /// One moment is zero: a rod, which turns steadily about L. Along itself it has no angular velocity to speak of; that component is returned as zero.
    Rod,
    /// L along a principal axis, or among the equal moments of a symmetric top: Ω stays (6.2).
    PermanentRotation,
    /// Two moments equal: Ω circles the axis of the third (6.5).
    Symmetric,
    /// L² < 2EI₂: L circles the axis of the smallest moment (6.6).
    AroundSmallest,
    /// L² > 2EI₂: L circles the axis of the largest moment (6.6).
    AroundLargest,
    /// L² = 2EI₂ exactly: one half turn over, from the middle axis to the middle axis, and no return (6.6).
    Separatrix,
}

/// A free top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// L along the body's axes, kg m²/s.
    pub angular_momentum: BodyVector,
    /// How the body stands in space.
    pub attitude: Attitude,
}

impl Default for State {
    /// At rest, the body's axes along those of space: what a slice of states may hold before it is filled.
    fn default() -> Self {
        Self {
            omega: BodyVector::zero(),
            angular_momentum: BodyVector::zero(),
            attitude: Attitude::identity(),
        }
    }
}

/// A free rigid body, its motion prepared.
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
    /// Ω constant: its components, its size to 106 bits, its direction.
    Steady {
        omega: [f64; 3],
        rate: DoubleDouble,
        direction: [f64; 3],
    },
    /// Ω moves: the constants, and the attitude less what ψ and P(L) make of it.
    Moving {
        constants: Constants,
        base: Quaternion<f64>,
    },
}

impl EulerTop {
    /// The body with these principal moments (kg m², in any order), with this angular momentum along its principal axes
    /// (kg m²/s) and this attitude at time 0.
    ///
    /// Domain: any moments that a body can have, rods and laminae included, at any scale; any L, however close to an axis
    /// or to the separatrix: what matters is the exact value of the doubles given. Cost: nine to fourteen evaluations of
    /// [`at`](Self::at), the price of constants to 106 bits: with them no later time costs a digit.
    ///
    /// # Errors
    /// [`Error::NotFinite`], also if Ω or the rate of the motion would leave the range of doubles; [`Error::Negative`] and
    /// [`Error::TriangleInequality`] for moments that no body has (2.4);
    /// [`Error::Condition`] for an angular momentum about an axis whose moment is zero.
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
    /// Along an axis whose moment is zero there is no angular velocity to speak of: that component is ignored.
    ///
    /// # Errors
    /// As for [`new`](Self::new); [`Error::Condition`] if I Ω is below the range of doubles.
    pub fn from_omega(moments: [f64; 3], omega: BodyVector, attitude: Attitude) -> Result<Self> {
        PrincipalMoments::new(moments[0], moments[1], moments[2])?;
        let start = Start::Omega(omega.components().into());
        Self::prepared(moments, start, attitude, Digits::ThirtyTwo)
    }

    /// The same as [`new`](Self::new) for a state or two soon after the start, such as one step of a larger simulation takes.
    ///
    /// The constants are formed in single doubles: that halves the cost, and the error grows with the angle turned, by 5e-16 rad a radian
    /// (observed 1.4e-15 rad after one, 2.8e-14 after sixty, next to the separatrix and elsewhere). The regime is decided as exactly as ever.
    /// Cost: four to five evaluations of [`at`](Self::at).
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn for_one_step(
        moments: [f64; 3],
        angular_momentum: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        PrincipalMoments::new(moments[0], moments[1], moments[2])?;
        let start = Start::AngularMomentum(angular_momentum.components().into());
        Self::prepared(moments, start, attitude, Digits::Sixteen)
    }

    /// The same as [`new`](Self::new) for moments that no body need have, such as 1, 2, 5: Euler's equations do not ask.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::Negative`] for a moment, [`Error::Condition`] if one moment is zero and L has a component
    /// about that axis, or the other two moments differ.
    pub fn beyond_bodies(
        moments: [f64; 3],
        angular_momentum: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        let start = Start::AngularMomentum(angular_momentum.components().into());
        Self::prepared(moments, start, attitude, Digits::ThirtyTwo)
    }

    fn prepared(
        moments: [f64; 3],
        start: Start,
        attitude: Attitude,
        digits: Digits,
    ) -> Result<Self> {
        for moment in moments {
            not_negative("a principal moment", moment)?;
        }
        for component in start.components() {
            finite(start.name(), component)?;
        }
        start.refuse_impossible_rod(moments)?;
        let (l, omega) = start.both(moments);
        for component in l.into_iter().chain(omega) {
            finite("a component of angular velocity or momentum", component)?;
        }
        let largest = vector(l).components().amax();
        if largest < f64::MIN_POSITIVE && start.vanishes_by_rounding(moments) {
            return Err(Error::Condition {
                condition: "the angular momentum of a body that turns must not underflow",
                value: largest,
            });
        }
        if largest > f64::MAX / 2.0 {
            finite("the size of the angular momentum", vector(l).norm())?;
        }
        let (regime, constants) = decide(moments, start, digits);
        let motion = match constants {
            None => steady(moments, &start.angular_momentum(moments)),
            Some(constants) => {
                let largest = constants
                    .rate
                    .value()
                    .abs()
                    .max(constants.turning_rate.value());
                finite("the rate of the motion", largest)?;
                // What is finite at the start may swing onto an axis with a smaller moment, or round up.
                for peak in ratio(constants.axes.back(constants.amplitudes), moments) {
                    finite("twice the greatest angular velocity", 2.0 * peak)?;
                }
                let turned = constants.turned(0.0, &constants.point(0.0)?)?;
                let base = attitude.quaternion().into_inner() * turned.conjugate();
                Motion::Moving { constants, base }
            }
        };
        Ok(Self {
            moments,
            angular_momentum: vector(l),
            attitude,
            regime,
            motion,
        })
    }

    /// What kind of motion it is, decided once from exact differences.
    pub const fn regime(&self) -> Regime {
        self.regime
    }

    /// The principal moments, kg m², in the order they were given.
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Ω, L and attitude at any time t (s), before or after (6.6, 6.8).
    ///
    /// (L₁, L₂, L₃) = (P₁ cn u, P₂ sn u, P₃ dn u), u = u₀ + λt, and the attitude turned about L by an angle that theta functions
    /// give. Error observed against 998 references of 32 digits, ordinary bodies and every hard case: attitude at most
    /// 9e-16 rad, Ω and L 5e-16, at any time up to 10⁹ periods; beyond, up to 10⁻²⁶ of the angle turned comes on top. Cost: the same at every
    /// time, twice that of one sn, cn, dn in the GNU Scientific Library.
    ///
    /// ```
    /// use spinning_bodies::euler_top::{EulerTop, Regime};
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// let (start, upright) = (BodyVector::new(0.0, 1.0, 1e-9), Attitude::identity());
    /// let racket = EulerTop::from_omega([1.0, 2.0, 3.0], start, upright)?;
    /// assert_eq!(racket.regime(), Regime::AroundLargest);
    /// let flipped = racket.at(racket.period() / 2.0)?;
    /// assert!((flipped.omega.y() + 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::OutOfRange`] beyond 2⁵³ quarter periods,
    /// where a double no longer counts them, or 2⁶³ radians.
    pub fn at(&self, t: f64) -> Result<State> {
        let t = finite("the time", t)?;
        match &self.motion {
            Motion::Steady {
                omega,
                rate,
                direction,
            } => {
                let half = rate.multiply(DoubleDouble::from(t)).scaled(0.5);
                let (sine, cosine) = half_turn(half, t, *rate)?;
                let [x, y, z] = direction.map(|component| sine * component);
                let turn = Quaternion::new(cosine, x, y, z);
                Ok(State {
                    omega: vector(*omega),
                    angular_momentum: self.angular_momentum,
                    attitude: Attitude::from_unit(self.attitude.quaternion().into_inner() * turn),
                })
            }
            Motion::Moving { constants, base } => {
                let point = constants.point(t)?;
                let l = constants.axes.back(point.l);
                Ok(State {
                    omega: vector(ratio(l, self.moments)),
                    angular_momentum: vector(l),
                    attitude: Attitude::from_unit(*base * constants.turned(t, &point)?),
                })
            }
        }
    }

    /// Ω alone, rad/s, along the body's axes (6.6). Cost: half of [`at`](Self::at).
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    pub fn omega_at(&self, t: f64) -> Result<BodyVector> {
        let t = finite("the time", t)?;
        match &self.motion {
            Motion::Steady { omega, .. } => Ok(vector(*omega)),
            Motion::Moving { constants, .. } => {
                let l = constants.axes.back(constants.point(t)?.l);
                Ok(vector(ratio(l, self.moments)))
            }
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

    /// Kinetic energy ½⟨Ω, L⟩, J: constant (6.1).
    pub fn energy(&self) -> f64 {
        let l: [f64; 3] = self.angular_momentum.components().into();
        let omega = ratio(l, self.moments);
        (0..3).map(|k| 0.5 * omega[k] * l[k]).sum()
    }

    /// L along the axes of space, kg m²/s: constant (6.1).
    pub fn angular_momentum_in_space(&self) -> SpaceVector {
        // Rotating adds products up, which may overflow or underflow before the result does.
        let unit = power_of_two_below(self.angular_momentum.components().amax());
        let l = self.attitude.to_space(self.angular_momentum / unit) * unit;
        let [x, y, z] =
            <[f64; 3]>::from(l.components()).map(|component| component.clamp(-f64::MAX, f64::MAX));
        SpaceVector::new(x, y, z)
    }

    /// Period of Ω in the body, 4K/λ, s: the polhode run through once (6.6). The attitude does not return with it.
    ///
    /// Infinite where Ω stays, and on the separatrix. Error: 2 ulp.
    pub fn period(&self) -> f64 {
        match &self.motion {
            Motion::Steady { .. } => f64::INFINITY,
            Motion::Moving { constants, .. } => constants.period(),
        }
    }

    /// Mean rate, rad/s, at which the axis that L circles goes round L in space, right-handed about L (6.5, 6.8).
    ///
    /// |L|/I₁ for a symmetric top. Where Ω stays: the rate 2E/|L| at which the body turns about L; 0 at rest. Error: 2 ulp.
    pub fn mean_precession_rate(&self) -> f64 {
        match &self.motion {
            Motion::Steady { rate, .. } => rate.value(),
            Motion::Moving { constants, .. } => constants.mean_precession_rate(),
        }
    }

    /// By how much the body has turned about L when Ω has returned, in Montgomery's two terms (6.8); none where Ω has no period.
    pub fn geometric_phase(&self) -> Option<GeometricPhase> {
        match &self.motion {
            Motion::Moving { constants, .. } if self.regime != Regime::Separatrix => {
                // 2E/|L| is the component of Ω along L.
                let size = self.angular_momentum.norm();
                let l: [f64; 3] = self.angular_momentum.components().into();
                let omega = ratio(l, self.moments);
                let along: f64 = (0..3).map(|k| l[k] / size * omega[k]).sum();
                Some(GeometricPhase {
                    dynamical: along * constants.period(),
                    geometric: -constants.solid_angle(),
                })
            }
            _ => None,
        }
    }
}

/// The turn about L after one period of Ω, radians: the sum of both, up to whole turns (6.8).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GeometricPhase {
    /// 2ET/|L|: as if Ω had stayed at its mean component along L.
    pub dynamical: f64,
    /// Less the solid angle of the cone that L draws in the body, counted positive if L goes round right-handed as seen from its
    /// own end. It depends on the shape of the path alone, not on the pace.
    pub geometric: f64,
}

fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

/// L_i/I_i before rounding; zero along an axis whose moment is zero.
fn omega_of(moments: [f64; 3], l: &[Extended; 3]) -> [f64; 3] {
    core::array::from_fn(|k| {
        if moments[k] == 0.0 {
            0.0
        } else {
            l[k].divide(Extended::from_double(moments[k])).value()
        }
    })
}

/// Rotation with constant Ω about L: at the rate 2E/|L| = Σ L_i²/I_i / |L|.
fn steady(moments: [f64; 3], l: &[Extended; 3]) -> Motion {
    let (mut square, mut twice_energy) = (Extended::zero(), Extended::zero());
    for (moment, component) in moments.iter().zip(l) {
        if !component.is_zero() {
            let term = component.square();
            square = square.add(term);
            twice_energy = twice_energy.add(term.divide(Extended::from_double(*moment)));
        }
    }
    if square.is_zero() {
        return Motion::Steady {
            omega: [0.0; 3],
            rate: DoubleDouble::from(0.0),
            direction: [0.0, 0.0, 1.0],
        };
    }
    let size = square.square_root();
    Motion::Steady {
        omega: omega_of(moments, l),
        rate: twice_energy.divide(size).narrow(),
        direction: core::array::from_fn(|k| l[k].divide(size).value()),
    }
}
