//! The traits of a geometric method and of its runs, the phase of a body, the sums that a run carries from step to step, and the loop that all runs share.

use crate::error::{Result, each_finite, finite, not_zero};
use crate::euler_equations::AxisMoments;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::Cost;
use crate::integrators::real::{Real, Sums, product};
use crate::precise::power_of_two_below;

/// The phase of a body: L and the attitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase<T = f64> {
    /// L along the body's principal axes, kg m²/s.
    pub l: [T; 3],
    /// The attitude's quaternion (w, x, y, z), body to space; every method first normalises it.
    pub q: [T; 4],
}

impl Phase {
    /// The phase with this L and attitude.
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

    /// The attitude.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::ZeroVector`](crate::Error::ZeroVector) for a quaternion of norm 0.
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
    /// The phase in another kind of number.
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
    /// Its name in the tables.
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

    /// A run from this phase by steps of `step` seconds, backward if negative. What all steps share is computed here, once.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for phase and step; [`Error::ZeroVector`](crate::Error::ZeroVector) for a quaternion of norm 0; [`Error::Integration`](crate::Error::Integration) for a step that the
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

/// A run of a geometric method. Single steps cost no more than steps in one call, and end on the same bits.
pub trait Stepper<T: Real = f64> {
    /// Takes this many steps.
    ///
    /// # Errors
    /// [`Error::Integration`](crate::Error::Integration) where an implicit step has no solution.
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

    /// Takes one step.
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

    /// The present phase, the norm of its attitude 1 to rounding. Splittings complete it here by the rotation or two that they postpone.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
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

    /// The cost so far: steps, and pairs of sine and cosine, torques or Newton's rounds, depending on the method.
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

/// What a run carries from step to step: the phase, with the rounding error of each component's sum.
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
        not_zero("the attitude's quaternion", size)?;
        Ok(Self {
            l: Sums::new(phase.l),
            q: Sums::new(unit(phase.q)),
        })
    }

    /// The present phase, its norm not restored.
    #[inline(always)]
    pub fn phase(&self) -> Phase<T> {
        Phase {
            l: self.l.values,
            q: self.q.values,
        }
    }

    /// Turns the body by a rotation whose quaternion, less 1, is `turn`: q becomes q(1 + turn), and L along the body's axes changes accordingly.
    ///
    /// `change` is that change of L, which the caller computes with fewer rounding errors than the quaternion would give.
    #[inline(always)]
    pub fn turn(&mut self, turn: [T; 4], change: [T; 3]) {
        self.q.add_all(product(self.q.values, turn));
        self.l.add_all(change);
    }

    /// The present phase with norm 1.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn settled(&self) -> Result<Phase<T>> {
        let Phase { l, q } = self.phase();
        let phase = Phase { l, q: unit(q) };
        phase.check()?;
        Ok(phase)
    }
}

/// One step of a method, which is all that distinguishes its runs from another's. A closure is a rule that postpones nothing.
pub(super) trait Rule<T: Real> {
    /// Takes a step and returns the evaluations it took.
    fn step(&mut self, run: &mut Run<T>) -> Result<u64>;

    /// Applies what `steps` steps have postponed to the end.
    fn finish(&self, _run: &mut Run<T>, _steps: u64) {}
}

impl<T: Real, F: FnMut(&mut Run<T>) -> Result<u64>> Rule<T> for F {
    #[inline(always)]
    fn step(&mut self, run: &mut Run<T>) -> Result<u64> {
        self(run)
    }
}

/// A run by the steps of a rule.
pub(super) struct Steps<T, R> {
    run: Run<T>,
    rule: R,
    cost: Cost,
}

impl<'a, T: Real, R: Rule<T> + 'a> Steps<T, R> {
    pub fn boxed(run: Run<T>, rule: R) -> Box<dyn Stepper<T> + 'a> {
        let cost = Cost::default();
        Box::new(Self { run, rule, cost })
    }
}

impl<T: Real, R: Rule<T>> Stepper<T> for Steps<T, R> {
    fn advance(&mut self, steps: u64) -> Result<()> {
        // Local copies, so that the loop can keep them in registers.
        let (mut run, mut cost) = (self.run, self.cost);
        for _ in 0..steps {
            cost.evaluations += self.rule.step(&mut run)?;
            cost.steps += 1;
        }
        (self.run, self.cost) = (run, cost);
        Ok(())
    }

    fn phase(&self) -> Result<Phase<T>> {
        let mut run = self.run;
        self.rule.finish(&mut run, self.cost.steps);
        run.settled()
    }

    fn cost(&self) -> Cost {
        self.cost
    }
}

/// The vector or quaternion, normalised; one of length zero is returned unchanged.
pub(crate) fn unit<T: Real, const N: usize>(v: [T; N]) -> [T; N] {
    let (zero, size) = (T::from_double(0.0), v.map(|x| x.to_double().abs()));
    // Divided by a power of two, so that no square overflows or underflows.
    let unit = T::from_double(1.0 / power_of_two_below(size.into_iter().fold(0.0, f64::max)));
    let v = v.map(|x| x * unit);
    let square = v.iter().fold(zero, |sum, &x| sum + x * x);
    if square == zero {
        return v;
    }
    let scale = square.square_root().reciprocal();
    v.map(|x| x * scale)
}

/// The moments, if each is positive and a body can have them.
pub(super) fn checked_moments(moments: [f64; 3]) -> Result<[f64; 3]> {
    let [a, b, c] = moments;
    Ok(AxisMoments::new(a, b, c)?.values())
}
