//! The falling cat: two cylinders joined so that they cannot twist against each other (tutorial 1.1).

use core::f64::consts::{PI, TAU};

use nalgebra::{Matrix3, Unit, UnitQuaternion, Vector3};

use super::holonomy::ShapePlane;
use super::quadrature::integral;
use crate::error::{Result, positive, within};
use crate::frame::{Attitude, BodyVector, finite_vector};
use crate::inertia::possible;
use crate::precise::power_of_two_below;
use crate::search::halved;

/// One half of a cat: a body of revolution with the spine as its axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Half {
    /// Mass m, kg.
    pub mass: f64,
    /// Moment J about the spine, kg m².
    pub axial: f64,
    /// Moment I about any line across the spine through the half's own centre, kg m².
    pub transverse: f64,
    /// Distance d from that centre to the joint, m.
    pub to_joint: f64,
}

/// A shape and the rate at which it changes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bend {
    /// γ, angle between the halves' spines, radians: 0 is a straight cat.
    pub angle: f64,
    /// ψ, direction of the bend around the spine, radians.
    pub direction: f64,
    /// γ′, rad/s.
    pub angle_rate: f64,
    /// ψ′, rad/s.
    pub direction_rate: f64,
}

impl Bend {
    /// Spine of the second half along the axes of the first, whose own spine is x.
    fn spine(&self) -> Vector3<f64> {
        let ((s, c), (sp, cp)) = (self.angle.sin_cos(), self.direction.sin_cos());
        Vector3::new(c, s * cp, s * sp)
    }

    /// Axis b(ψ) of the bend.
    fn axis(&self) -> Vector3<f64> {
        let (sp, cp) = self.direction.sin_cos();
        Vector3::new(0.0, -sp, cp)
    }

    /// Angular velocity of the second half against the first, along the first's axes: γ′b + ψ′(e − Re).
    /// The exponential map is not differentiated, so that a straight cat is no exception.
    fn rate(&self) -> Vector3<f64> {
        self.axis() * self.angle_rate + (Vector3::x() - self.spine()) * self.direction_rate
    }

    /// The attitude of the second half relative to the first.
    ///
    /// ```
    /// use spinning_bodies::{frame::Attitude, phenomena::Bend};
    /// let bend = Bend { angle: 0.5, ..Bend::default() };
    /// assert!((bend.relative().angle_to(&Attitude::identity()) - 0.5).abs() < 1e-15);
    /// ```
    pub fn relative(&self) -> Attitude {
        let axis = Unit::new_unchecked(self.axis());
        UnitQuaternion::from_axis_angle(&axis, self.angle).into()
    }
}

/// A cat of two halves. Its body axes are those of the first half: x along the spine towards the joint.
///
/// The shape is given by the angle γ between the halves and the direction ψ around the spine in which they bend. The relative rotation is
/// R = exp(γ b(ψ)) with b perpendicular to the spine. The cat bends, carries the bend once round, and unbends: it then has its old shape, has had no
/// angular momentum at any time, and lies the other way up.
///
/// [`Cat`] takes any two halves and any path of shapes, and solves for the angular velocity at a given L, zero in a free fall. [`EqualHalves`] is the case with a closed form:
/// the bisector of the two spines then keeps its direction in space, and the cat obeys the law of a swivel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cat {
    pub(crate) halves: [Half; 2],
}

impl Cat {
    /// The cat with these halves, front and rear.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite); [`Error::TriangleInequality`](crate::Error::TriangleInequality) for moments that no body has.
    ///
    /// ```
    /// use spinning_bodies::phenomena::{Cat, Half};
    /// let half = Half { mass: 2.0, axial: 0.01, transverse: 0.03, to_joint: 0.2 };
    /// assert!(Cat::new([half; 2]).is_ok());
    /// assert!(Cat::new([half, Half { axial: 0.07, ..half }]).is_err());
    /// ```
    pub fn new(halves: [Half; 2]) -> Result<Self> {
        for half in &halves {
            positive("the mass of a half", half.mass)?;
            EqualHalves::new(half.axial, half.transverse)?;
            positive("the distance to the joint", half.to_joint)?;
        }
        Ok(Self { halves })
    }

    /// The closed form, if the halves are equal.
    pub(crate) fn equal_halves(&self) -> Option<EqualHalves> {
        let [first, second] = self.halves;
        let equal = EqualHalves::new(first.axial, first.transverse).ok();
        equal.filter(|_| first == second)
    }

    /// Positions of the joint and of the two halves' centres relative to the common centre of mass, m, along the first half's axes.
    ///
    /// ```
    /// use spinning_bodies::phenomena::{Bend, Cat, Half};
    /// let half = Half { mass: 2.0, axial: 0.01, transverse: 0.03, to_joint: 0.2 };
    /// let (cat, straight) = (Cat::new([half; 2])?, Bend::default());
    /// let [joint, front, rear] = cat.places(&straight);
    /// assert_eq!((joint.norm(), front.x(), rear.x()), (0.0, -0.2, 0.2));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn places(&self, bend: &Bend) -> [BodyVector; 3] {
        let [first, second] = self.halves;
        let mass = first.mass + second.mass;
        let a = Vector3::x() * first.to_joint;
        let b = bend.spine() * second.to_joint;
        let joint = a * (first.mass / mass) - b * (second.mass / mass);
        [joint, joint - a, joint + b].map(BodyVector::from_components)
    }

    /// Angular momentum about the centre of mass, along the first half's axes, when that half turns at `omega`.
    ///
    /// The sum of the halves' own angular momentum and that of their centres about each other, μ c ∧ (c′ + Ω ∧ c). The ledger of a fall records it.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, phenomena::{Bend, Cat, Half}};
    /// let half = Half { mass: 2.0, axial: 0.01, transverse: 0.03, to_joint: 0.2 };
    /// let (cat, straight) = (Cat::new([half; 2])?, Bend::default());
    /// // A straight cat has twice the moment of a half about its spine.
    /// let l = cat.angular_momentum(&straight, BodyVector::new(1.0, 0.0, 0.0));
    /// assert!((l - BodyVector::new(0.02, 0.0, 0.0)).norm() < 1e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_momentum(&self, bend: &Bend, omega: BodyVector) -> BodyVector {
        let omega = omega.components();
        let other = omega + bend.rate();
        let [first, second] = &self.halves;
        let spins = spin(first, Vector3::x(), omega) + spin(second, bend.spine(), other);
        let (reduced, c) = self.pair(bend);
        // The velocity of one centre as seen from the other, along turning axes: c′ + Ω ∧ c.
        let parting = bend.rate().cross(&bend.spine()) * second.to_joint + omega.cross(&c);
        BodyVector::from_components(spins + c.cross(&parting) * reduced)
    }

    /// The reduced mass of the halves, and the way from centre to centre along the first half's axes; where the cat is all but folded up, to its own digits.
    fn pair(&self, bend: &Bend) -> (f64, Vector3<f64>) {
        let [first, second] = &self.halves;
        let mut c = bend.spine() * second.to_joint;
        // 1 + cos γ from half the angle.
        let half = (0.5 * bend.angle).cos();
        c.x = (first.to_joint - second.to_joint) + second.to_joint * (2.0 * half * half);
        (first.mass * (second.mass / (first.mass + second.mass)), c)
    }

    /// Angular velocity of the first half, rad/s along its own axes, at this shape and angular momentum (also along those axes).
    ///
    /// The locked body's inertia matrix times Ω is L less the angular momentum of the changing shape: [I_A + RI_BRᵀ + μ(c²1 − ccᵀ)] Ω = L − RI_BRᵀw − μ c ∧ c′,
    /// with c from centre to centre and μ the reduced mass. Observed error, as an error of L: 1.2e-15 of its largest term, those with Ω included.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) if the shape or L is not.
    ///
    /// ```
    /// use spinning_bodies::{frame::BodyVector, phenomena::{Bend, Cat, Half}};
    /// let half = Half { mass: 2.0, axial: 0.01, transverse: 0.03, to_joint: 0.2 };
    /// let (cat, straight) = (Cat::new([half; 2])?, Bend::default());
    /// let omega = cat.angular_velocity(&straight, BodyVector::new(0.02, 0.0, 0.0))?;
    /// assert!((omega.x() - 1.0).abs() < 1e-14);
    /// // Two balls on long arms, all but folded up: each turns by half of what the bend does.
    /// let ball = Half { mass: 20.0, axial: 1e-3, transverse: 1e-3, to_joint: 5.0 };
    /// let folding = Bend { angle: std::f64::consts::PI - 1e-8, angle_rate: 2.0, ..Bend::default() };
    /// let omega = Cat::new([ball; 2])?.angular_velocity(&folding, BodyVector::zero())?;
    /// assert!((omega.z() + 1.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angular_velocity(&self, bend: &Bend, momentum: BodyVector) -> Result<BodyVector> {
        let [first, second] = &self.halves;
        let (e, u) = (Vector3::x(), bend.spine());
        let (reduced, c) = self.pair(bend);
        let c_rate = bend.rate().cross(&u) * second.to_joint;
        let matrix = inertia(first, e)
            + inertia(second, u)
            + (Matrix3::identity() * c.norm_squared() - c * c.transpose()) * reduced;
        let shape = spin(second, u, bend.rate()) + c.cross(&c_rate) * reduced;
        let right = momentum.components() - shape;
        let omega = matrix.cholesky().map(|factors| factors.solve(&right));
        let omega = BodyVector::from_components(omega.unwrap_or(Vector3::repeat(f64::NAN)));
        finite_vector("the angular velocity of the cat", omega)
    }
}

/// A half's own angular momentum when it turns at `omega`.
fn spin(half: &Half, spine: Vector3<f64>, omega: Vector3<f64>) -> Vector3<f64> {
    omega * half.transverse + spine * ((half.axial - half.transverse) * spine.dot(&omega))
}

fn inertia(half: &Half, spine: Vector3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * half.transverse
        + spine * spine.transpose() * (half.axial - half.transverse)
}

/// The cat with equal halves, after Rademaker and ter Braak (1935): x is the bend γ, ψ its direction, polar coordinates of a disc of shapes.
///
/// The angular momentum of the changing shape is along the bisector of the spines, so the bisector keeps its direction in space and the frame of
/// the bend turns about it by χ′ = f(γ)ψ′, f = J cos a/(J cos²a + I sin²a), a = γ/2. Each half spins back by ψ about its own axis: for
/// the straight cat the net turn is −∮(1 − f) dψ. The bending γ′ itself causes no turn, and the distance to the joint does not occur.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EqualHalves {
    axial: f64,
    transverse: f64,
}

impl ShapePlane for EqualHalves {
    fn turn_back(&self, angle: f64) -> f64 {
        // 1 − f = 2 sin²(a/2) [(2I − J) cos a + 2I sin²(a/2)]/D: nothing cancels, neither for a small bend nor for flat halves.
        let (quarter, c) = ((0.25 * angle).sin(), (0.5 * angle).cos());
        let versed = 2.0 * quarter * quarter;
        versed * (self.excess() * c + self.transverse * versed) / self.stiffness(angle)
    }

    fn curvature(&self, angle: f64) -> f64 {
        let (s, c) = (0.5 * angle).sin_cos();
        let d = self.stiffness(angle);
        0.5 * self.axial * s / d * ((self.excess() * c * c + self.transverse * s * s) / d)
    }
}

impl EqualHalves {
    /// The cat with these moments of each half, kg m².
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite), [`Error::TriangleInequality`](crate::Error::TriangleInequality).
    ///
    /// ```
    /// use spinning_bodies::phenomena::EqualHalves;
    /// assert!(EqualHalves::new(0.02, 0.02).is_ok() && EqualHalves::new(0.05, 0.02).is_err());
    /// ```
    pub fn new(axial: f64, transverse: f64) -> Result<Self> {
        positive("the moment about the spine", axial)?;
        positive("the moment across the spine", transverse)?;
        possible([transverse, transverse, axial], 0.0)?;
        // Only their ratio matters, so a power of two is divided out: products of the smallest moments would underflow.
        let unit = power_of_two_below(axial.max(transverse));
        let (axial, transverse) = ((axial / unit).max(f64::MIN_POSITIVE), transverse / unit);
        Ok(Self { axial, transverse })
    }

    /// 2I − J: never negative, and zero for flat discs.
    fn excess(&self) -> f64 {
        2.0 * self.transverse - self.axial
    }

    /// D = J cos²a + I sin²a.
    fn stiffness(&self, angle: f64) -> f64 {
        let (s, c) = (0.5 * angle).sin_cos();
        self.axial * c * c + self.transverse * s * s
    }

    /// f(γ): the angle by which the frame of the bend turns in space for each radian of ψ.
    pub(crate) fn frame_turn(&self, angle: f64) -> f64 {
        self.axial * (0.5 * angle).cos() / self.stiffness(angle)
    }

    /// Turn of the cat, radians, opposite to the swing, when the bend γ is carried once round:
    /// 2π[1 − J cos a/(J cos²a + I sin²a)] with a = γ/2. 0 for γ = 0; independent of pace and of the distance to the joint.
    /// Observed error: 9 ulp.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for γ outside 0…π.
    ///
    /// ```
    /// use spinning_bodies::phenomena::EqualHalves;
    /// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
    /// let third = 2.0 * std::f64::consts::FRAC_PI_3;
    /// // Half a turn for a bend of 120°.
    /// assert!((cat.turn_per_swing(third)? - std::f64::consts::PI).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn turn_per_swing(&self, angle: f64) -> Result<f64> {
        Ok(TAU * self.turn_back(bendable(angle)?))
    }

    /// The bend γ, radians, that turns the cat by exactly half a turn: cos(γ/2) = 1/(r + s) with r = J/I, at most 2, and s = √(1 + r(r − 1)).
    ///
    /// Formed as tan²(γ/4) = r(r + s)/((1 + s)(1 + r + s)), so that the small bend of a slender cat keeps its digits. Error: 3 ulp.
    ///
    /// ```
    /// use spinning_bodies::phenomena::EqualHalves;
    /// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
    /// let third = 2.0 * std::f64::consts::FRAC_PI_3;
    /// assert!((cat.half_turn_bend() - third).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn half_turn_bend(&self) -> f64 {
        let ratio = self.axial / self.transverse;
        let root = (1.0 + ratio * (ratio - 1.0)).sqrt();
        let (sum, whole) = (ratio + root, 1.0 + root);
        4.0 * (ratio * sum / (whole * (1.0 + sum))).sqrt().atan()
    }

    /// The turn, radians, when the bend is γ_forward at ψ = 0 and γ_back at ψ = π, and swings as (γ_f + γ_b)/2 + (γ_f − γ_b)/2 cos ψ:
    /// Kane and Scher's cat (1969), which bends back less than forward. Observed error: 7e-16 of the turn.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for bends outside 0…π.
    ///
    /// ```
    /// use spinning_bodies::phenomena::EqualHalves;
    /// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
    /// // An even swing is a special case.
    /// assert!((cat.turn_of_uneven_swing(1.0, 1.0)? - cat.turn_per_swing(1.0)?).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn turn_of_uneven_swing(&self, forward: f64, back: f64) -> Result<f64> {
        let (forward, back) = (bendable(forward)?, bendable(back)?);
        let (mean, swing) = (0.5 * (forward + back), 0.5 * (forward - back));
        integral(|psi| self.turn_back(mean + swing * psi.cos()), 0.0, TAU)
    }

    /// The bend γ_back, radians, with which the uneven swing turns the cat by half a turn, or `None` if no bend does. The turn grows with the bend, so
    /// bisection finds it, as far as the rounding of the turn allows: 1e-15 observed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for a bend outside 0…π.
    ///
    /// ```
    /// use spinning_bodies::phenomena::EqualHalves;
    /// let cat = EqualHalves::new(0.02, 0.02)?; // as round as balls
    /// let third = 2.0 * std::f64::consts::FRAC_PI_3;
    /// assert!((cat.back_bend_for_half_turn(third)?.unwrap() - third).abs() < 1e-13);
    /// // A cat that bends forward only a little never turns over.
    /// assert_eq!(cat.back_bend_for_half_turn(0.1)?, None);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn back_bend_for_half_turn(&self, forward: f64) -> Result<Option<f64>> {
        let turn = |back: f64| self.turn_of_uneven_swing(forward, back);
        if turn(0.0)? > PI || turn(PI)? < PI {
            return Ok(None);
        }
        let [less, more] = halved([0.0, PI], 0.0, |back| Ok(turn(back)? < PI))?;
        Ok(Some(0.5 * (less + more)))
    }
}

/// The bend, if it lies between 0 and π.
fn bendable(angle: f64) -> Result<f64> {
    within("the bend", angle, 0.0, PI)
}
