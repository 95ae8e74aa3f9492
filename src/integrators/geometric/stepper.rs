//! What a geometric method is, what it carries from step to step, and how it is asked for a step.

use crate::error::{Error, Result, each_finite, finite};
use crate::euler_equations::AxisMoments;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::Cost;
use crate::integrators::real::{Real, Sums, product};
use crate::precise::power_of_two_below;

/// A body at one time: all that a geometric method carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase<T = f64> {
    /// L along the body's principal axes, kg m²/s.
    pub l: [T; 3],
    /// The attitude's quaternion (w, x, y, z), body to space; every method begins by giving it norm 1.
    pub q: [T; 4],
}

impl Phase {
    /// With this L and attitude.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::Phase;
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// assert_eq!((start.l, start.q), ([0.1, 2.0, 0.3], [1.0, 0.0, 0.0, 0.0]));
    /// ```
    pub fn new(l: BodyVector, attitude: &Attitude) -> Self {
        let q = attitude.quaternion();
        Self {
            l: l.components().into(),
            q: [q.w, q.i, q.j, q.k],
        }
    }

    /// L along the body's axes.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::Phase;
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// assert_eq!(start.angular_momentum().y(), 2.0);
    /// ```
    pub fn angular_momentum(&self) -> BodyVector {
        let [x, y, z] = self.l;
        BodyVector::new(x, y, z)
    }

    /// How the body stands in space.
    ///
    /// # Errors
    /// [`Error::NotFinite`] and [`Error::ZeroVector`] for a quaternion that is none.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::Phase;
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// assert_eq!(start.attitude()?, Attitude::identity());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn attitude(&self) -> Result<Attitude> {
        let [w, x, y, z] = self.q;
        Attitude::from_quaternion(w, x, y, z)
    }
}

impl<T: Real> Phase<T> {
    /// The same in other numbers.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{DoubleDouble, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// assert_eq!(start.cast::<DoubleDouble>().cast::<f64>(), start);
    /// ```
    pub fn cast<U: Real>(&self) -> Phase<U> {
        Phase {
            l: self.l.map(|x| U::from_double(x.to_double())),
            q: self.q.map(|x| U::from_double(x.to_double())),
        }
    }

    /// The upward unit vector z along the body's axes: the third row of the rotation matrix, divided by |q|² ≈ 1.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::Phase;
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// assert_eq!(start.up(), [0.0, 0.0, 1.0]);
    /// ```
    #[inline(always)]
    pub fn up(&self) -> [T; 3] {
        let [w, x, y, z] = self.q;
        let two = T::from_double(2.0);
        [
            two * (x * z - w * y),
            two * (y * z + w * x),
            (w * w + z * z) - (x * x + y * y),
        ]
    }

    pub(super) fn check(&self) -> Result<()> {
        each_finite("the angular momentum", self.l.map(T::to_double))?;
        each_finite("the attitude's quaternion", self.q.map(T::to_double))
    }
}

/// A method with steps of one length.
pub trait Integrator<T: Real = f64> {
    /// Its name, as in the tables.
    ///
    /// ```
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order};
    /// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
    /// assert_eq!(Integrator::<f64>::name(&method), "rotations 4");
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn name(&self) -> String;

    /// The order p: the error of a run is proportional to stepᵖ.
    ///
    /// ```
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order};
    /// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
    /// assert_eq!(Integrator::<f64>::order(&method), 4);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn order(&self) -> u32;

    /// The method at work: from this phase by steps of `step` seconds, negative ones backwards. What all steps share is made here, once.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for phase and step, [`Error::ZeroVector`] for a quaternion that is none; [`Error::Integration`] for a step that the
    /// method cannot take.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
    /// assert_eq!(method.start(&start, 0.02)?.phase()?, start);
    /// assert!(method.start(&start, f64::NAN).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn start(&self, phase: &Phase<T>, step: T) -> Result<Box<dyn Stepper<T> + '_>>;
}

/// A method at work. It remembers: one step costs what it costs in a run of many, and ends on the same bits.
pub trait Stepper<T: Real = f64> {
    /// So many steps.
    ///
    /// # Errors
    /// [`Error::Integration`] where an implicit step has no solution.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
    /// let mut run = method.start(&start, 0.02)?;
    /// run.advance(50)?;
    /// assert_eq!(run.cost().steps, 50);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn advance(&mut self, steps: u64) -> Result<()>;

    /// One step.
    ///
    /// # Errors
    /// As for [`advance`](Self::advance).
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
    /// let (mut one, mut many) = (method.start(&start, 0.02)?, method.start(&start, 0.02)?);
    /// one.step()?;
    /// many.advance(1)?;
    /// assert_eq!(one.phase()?, many.phase()?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn step(&mut self) -> Result<()> {
        self.advance(1)
    }

    /// Where the body is now, the attitude's norm 1 to rounding. Splittings leave to this what only a phase that is looked at needs, a
    /// rotation or two.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
    /// assert_eq!(method.start(&start, 0.02)?.phase()?, start);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn phase(&self) -> Result<Phase<T>>;

    /// What it has cost so far: sine pairs, torques or Newton's rounds, whichever the method lives by; and steps.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Integrator, Order, Phase};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = FreeSplitting::new([1.0, 2.0, 2.5], Order::Four)?;
    /// let mut run = method.start(&start, 0.02)?;
    /// run.step()?;
    /// assert_eq!(run.cost().steps, 1);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    fn cost(&self) -> Cost;
}

/// What a run carries from step to step: the phase, each component with what rounding has left of it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run<T> {
    pub l: Sums<T, 3>,
    pub q: Sums<T, 4>,
}

impl<T: Real> Run<T> {
    /// # Errors
    /// Those of [`Integrator::start`] for phase and step.
    pub fn new(phase: &Phase<T>, step: T) -> Result<Self> {
        phase.check()?;
        finite("the step", step.to_double())?;
        let size = phase.q.iter().map(|x| x.to_double().abs()).sum::<f64>();
        if size == 0.0 {
            return Err(Error::ZeroVector {
                quantity: "the attitude's quaternion",
            });
        }
        Ok(Self {
            l: Sums::new(phase.l),
            q: Sums::new(unit(phase.q)),
        })
    }

    /// The phase here, its norm not restored.
    #[inline(always)]
    pub fn phase(&self) -> Phase<T> {
        Phase {
            l: self.l.values,
            q: self.q.values,
        }
    }

    /// Turns the body by a rotation whose quaternion, less 1, is `turn`: q becomes q(1 + turn), L becomes what a rider sees of it.
    ///
    /// `change` is that change of L: the caller has it with fewer roundings than the quaternion would give it.
    #[inline(always)]
    pub fn turn(&mut self, turn: [T; 4], change: [T; 3]) {
        self.q.add_all(product(self.q.values, turn));
        self.l.add_all(change);
    }

    /// The phase here with norm 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub fn settled(&self) -> Result<Phase<T>> {
        let Phase { l, q } = self.phase();
        let phase = Phase { l, q: unit(q) };
        phase.check()?;
        Ok(phase)
    }
}

/// The same vector or quaternion with norm 1; of length zero, itself.
pub(super) fn unit<T: Real, const N: usize>(v: [T; N]) -> [T; N] {
    let (zero, size) = (T::from_double(0.0), v.map(|x| x.to_double().abs()));
    // Over a power of two, for the squares of any numbers are numbers then.
    let unit = T::from_double(1.0 / power_of_two_below(size.into_iter().fold(0.0, f64::max)));
    let v = v.map(|x| x * unit);
    let square = v.iter().fold(zero, |sum, &x| sum + x * x);
    if square == zero {
        return v;
    }
    let scale = square.square_root().reciprocal();
    v.map(|x| x * scale)
}

/// Moments that a body can have, each positive.
pub(super) fn checked_moments(moments: [f64; 3]) -> Result<[f64; 3]> {
    let [a, b, c] = moments;
    Ok(AxisMoments::new(a, b, c)?.values())
}
