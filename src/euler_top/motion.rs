//! The exact motion of a free rigid body (tutorial 6.1, 6.6, 6.8): angular velocity, angular momentum and attitude at any time.

use nalgebra::Quaternion;

use super::preparation::{Constants, ascending, decide};
use crate::double_double::DoubleDouble;
use crate::error::{Error, Result, finite, not_negative};
use crate::extended::Extended;
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;

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

/// A free rigid body, its motion prepared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerTop {
    moments: [f64; 3],
    angular_momentum: BodyVector,
    attitude: Attitude,
    regime: Regime,
    motion: Motion,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Motion {
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
    /// The body with these principal moments (kg m², in any order), angular momentum along its principal axes (kg m²/s) and
    /// attitude at time 0.
    pub fn new(
        moments: [f64; 3],
        angular_momentum: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        PrincipalMoments::new(moments[0], moments[1], moments[2])?;
        Self::beyond_bodies(moments, angular_momentum, attitude)
    }

    /// The same for any moments that are not negative.
    pub fn beyond_bodies(
        moments: [f64; 3],
        angular_momentum: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        for moment in moments {
            not_negative("a principal moment", moment)?;
        }
        let l: [f64; 3] = angular_momentum.components().into();
        for component in l {
            finite("a component of the angular momentum", component)?;
        }
        for (moment, component) in moments.iter().zip(l) {
            if *moment == 0.0 && component != 0.0 {
                return Err(Error::Condition {
                    condition: "the angular momentum about an axis whose moment is zero must be zero",
                    value: component,
                });
            }
        }
        let (regime, constants) = decide(moments, l);
        let mut top = Self {
            moments,
            angular_momentum,
            attitude,
            regime,
            motion: steady(moments, l),
        };
        if let Some(constants) = constants {
            finite("the rate of the motion", constants.rate.value())?;
            finite("the rate of turning about L", constants.turning_rate.value())?;
            let moving = |base| Motion::Moving { constants, base };
            top.motion = moving(Quaternion::identity());
            let turned = constants.turned(0.0, &constants_place(&constants, 0.0)?);
            top.motion = moving(attitude.quaternion().into_inner() * turned.conjugate());
        }
        for component in omega_of(moments, l) {
            finite("a component of the angular velocity", component)?;
        }
        Ok(top)
    }

    /// The body with this angular velocity, rad/s.
    pub fn from_omega(moments: [f64; 3], omega: BodyVector, attitude: Attitude) -> Result<Self> {
        let omega: [f64; 3] = omega.components().into();
        for (moment, component) in moments.iter().zip(omega) {
            finite("a component of the angular velocity", component)?;
            finite("a principal moment", *moment)?;
            finite("a component of the angular momentum", moment * component)?;
        }
        let l = BodyVector::new(
            moments[0] * omega[0],
            moments[1] * omega[1],
            moments[2] * omega[2],
        );
        Self::new(moments, l, attitude)
    }

    /// What kind of motion it is.
    pub const fn regime(&self) -> Regime {
        self.regime
    }

    /// Everything at time t (s).
    pub fn at(&self, t: f64) -> Result<State> {
        let t = finite("the time", t)?;
        match &self.motion {
            Motion::Steady {
                omega,
                rate,
                direction,
            } => {
                let half = rate.multiply(DoubleDouble::from(t)).scaled(0.5);
                finite("the angle turned", half.high())?;
                let (sine, cosine) = half.sin_cos();
                let turn = Quaternion::new(
                    cosine,
                    sine * direction[0],
                    sine * direction[1],
                    sine * direction[2],
                );
                Ok(State {
                    omega: vector(*omega),
                    angular_momentum: self.angular_momentum,
                    attitude: Attitude::from_unit(self.attitude.quaternion().into_inner() * turn),
                })
            }
            Motion::Moving { constants, base } => {
                let point = constants_place(constants, t)?;
                let l = constants.axes.back(point.l);
                Ok(State {
                    omega: vector(omega_of(self.moments, l)),
                    angular_momentum: vector(l),
                    attitude: Attitude::from_unit(*base * constants.turned(t, &point)),
                })
            }
        }
    }
}

/// Where L is, along the renumbered axes.
struct Point {
    place: crate::elliptic::local::Place,
    sn: f64,
    cn: f64,
    l: [f64; 3],
}

fn constants_place(constants: &Constants, t: f64) -> Result<Point> {
    let u = constants
        .rate
        .multiply(DoubleDouble::from(t))
        .add(constants.start);
    let modulus = &constants.modulus;
    let greatest = modulus.greatest_argument();
    if !(u.high().abs() <= greatest) {
        let limit = greatest / constants.rate.high().abs();
        return Err(Error::OutOfRange {
            quantity: "the time",
            value: t,
            least: -limit,
            greatest: limit,
        });
    }
    let place = modulus.place(u);
    let [sn, cn, dn] = modulus.triple(&place);
    let [p1, p2, p3] = constants.amplitudes;
    Ok(Point {
        place,
        sn,
        cn,
        l: [p1 * cn, p2 * sn, p3 * dn],
    })
}

impl Constants {
    /// The turn by ψ about L after the shortest rotation of L onto axis 3, as a unit quaternion along the body's own axes.
    fn turned(&self, t: f64, point: &Point) -> Quaternion<f64> {
        let turning = &self.turning;
        let lag = turning
            .lag
            .multiply(DoubleDouble::from(point.place.quarters));
        let half = self
            .turning_rate
            .multiply(DoubleDouble::from(t))
            .subtract(lag)
            .scaled(0.5);
        let (sine, cosine) = half.sin_cos();
        let (x, y) = turning.half_angle(&point.place, point.sn, point.cn);
        let (cosine, sine) = (cosine * x - sine * y, sine * x + cosine * y);
        let [l1, l2, l3] = point.l;
        let largest = l1.abs().max(l2.abs()).max(l3);
        let [n1, n2, n3] = [l1 / largest, l2 / largest, l3 / largest];
        let w = n3 + (n1 * n1 + n2 * n2 + n3 * n3).sqrt();
        // (cos + k sin) (w + n₂ i − n₁ j).
        let [a, b, c] = self.axes.back([
            cosine * n2 + sine * n1,
            sine * n2 - cosine * n1,
            sine * w,
        ]);
        let q = Quaternion::new(cosine * w, a, b, c);
        q / q.norm()
    }
}

fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

/// L_i/I_i; zero along an axis whose moment is zero.
fn omega_of(moments: [f64; 3], l: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| if moments[k] == 0.0 { 0.0 } else { l[k] / moments[k] })
}

/// Rotation with constant Ω about L: 2E/|L| = Σ L_i²/I_i / |L|.
fn steady(moments: [f64; 3], l: [f64; 3]) -> Motion {
    let (mut square, mut energy) = (Extended::zero(), Extended::zero());
    for (moment, component) in moments.iter().zip(l) {
        if component != 0.0 {
            let term = Extended::from_double(component).square();
            square = square.add(term);
            energy = energy.add(term.divide(Extended::from_double(*moment)));
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
        rate: energy.divide(size).narrow(),
        direction: l.map(|x| Extended::from_double(x).divide(size).value()),
    }
}
