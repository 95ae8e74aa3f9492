//! Splitting methods: motions that are each exact, in turn. Rotations about axes of the body, the rotation about L, kicks by a torque.

use super::coefficients::{NYSTROM_6, NYSTROM_11, S6, S10, STRANG, part_steps};
use super::stepper::{Run, checked_moments, unit};
use super::{Integrator, Phase, Stepper, Torque};
use crate::error::Result;
use crate::integrators::Cost;
use crate::integrators::real::{Real, Sums, dot, exponential, product};
use crate::precise::{DoubleDouble, Number};

/// Order of a splitting; `as u32` gives the number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Strang's splitting: one stage.
    Two = 2,
    /// Blanes' and Moan's splitting: six stages.
    Four = 4,
    /// Blanes' and Moan's splittings: ten stages, or eleven for kicks between exact motions.
    Six = 6,
}

impl Order {
    /// All orders.
    pub const ALL: [Self; 3] = [Self::Two, Self::Four, Self::Six];
}

/// The axes by which the energy of a free body is split, |L|²/2I₂ + ½(1/I₁ − 1/I₂)L₁² + ½(1/I₃ − 1/I₂)L₃², I₁ ≤ I₂ ≤ I₃.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Axes {
    /// The axis of the least or of the greatest moment, with that moment; `inner` is the other.
    outer: (usize, f64),
    inner: (usize, f64),
    middle: f64,
}

impl Axes {
    fn new(moments: [f64; 3]) -> Result<Self> {
        let moments = checked_moments(moments)?;
        let mut axes = [0, 1, 2].map(|axis| (axis, moments[axis]));
        axes.sort_by(|a, b| a.1.total_cmp(&b.1));
        let [outer, (_, middle), inner] = axes;
        Ok(Self {
            outer,
            inner,
            middle,
        })
    }

    /// The axis, and half the angle of the rotation about it per unit of L and time.
    fn rate<T: Real>(&self, (axis, moment): (usize, f64)) -> (usize, T) {
        let [middle, moment] = [self.middle, moment].map(T::from_double);
        // Differences first: the moments may be nearly equal.
        let product = middle * moment;
        let rate = T::from_double(0.5) * (middle - moment) * product.reciprocal();
        (axis, rate)
    }
}

/// A free body, by rotations about its axes of least and of greatest moment in turn.
///
/// Each part of the energy |L|²/2I₂ + ½(1/I₁ − 1/I₂)L₁² + ½(1/I₃ − 1/I₂)L₃² by itself gives an exact rotation: the first about L, which is fixed in
/// space; the others about axes 1 and 3. The first commutes with the others, so it is applied only when a phase is read; a step of order 2 is one
/// rotation about each axis, of order 4 six, of order 6 ten. That is a third less work than rotations about all three axes, and the errors carry the
/// small factors of nearly symmetric bodies.
///
/// Conserved: |L|, L in space and the phase volume (symplectic) to rounding; symmetric in time; the energy oscillates by O(stepᵖ) and does not drift.
/// Bodies with two equal moments are turned exactly, whatever the step. Cost: one pair of sine and cosine a rotation. Source: McLachlan 1993 and
/// Reich 1994 for rotations as parts; the choice of the parts is ours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeSplitting {
    axes: Axes,
    order: Order,
}

impl FreeSplitting {
    /// The method of this order for a body with these principal moments, kg m², in any order.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive),
    /// [`Error::TriangleInequality`](crate::Error::TriangleInequality).
    ///
    /// ```
    /// use spinning_bodies::integrators::geometric::{FreeSplitting, Order};
    /// assert!(FreeSplitting::new([1.0, 2.0, 2.5], Order::Four).is_ok());
    /// assert!(FreeSplitting::new([1.0, -2.0, 2.5], Order::Four).is_err());
    /// ```
    pub fn new(moments: [f64; 3], order: Order) -> Result<Self> {
        let axes = Axes::new(moments)?;
        Ok(Self { axes, order })
    }
}

impl<T: Real> Integrator<T> for FreeSplitting {
    fn name(&self) -> String {
        format!("rotations {}", self.order as u32)
    }

    fn order(&self) -> u32 {
        self.order as u32
    }

    fn start(&self, phase: &Phase<T>, step: T) -> Result<Box<dyn Stepper<T> + '_>> {
        let mut run = Run::new(phase, step)?;
        let Phase { l, q } = run.phase();
        // The attitude without the rotation about L.
        run.q = Sums::new([1.0, 0.0, 0.0, 0.0].map(T::from_double));
        let exact = l.map(T::two_words);
        let size = Number::square_root(dot(exact, exact));
        let halved = step.two_words() * DoubleDouble::from(0.5);
        let parts = Free {
            q,
            direction: unit(l),
            half: size * halved / DoubleDouble::from(self.axes.middle),
            outer: self.axes.rate(self.axes.outer),
            inner: self.axes.rate(self.axes.inner),
        };
        let splitting = match self.order {
            Order::Two => STRANG,
            Order::Four => S6,
            Order::Six => S10,
        };
        Ok(Alternating::boxed(parts, run, splitting, step))
    }
}

/// A body under a torque that depends on its attitude alone: kicks and exact rotations in turn.
///
/// A body with two equal moments has an exact free motion, a rotation about L and one about the axis; the kicks stand between such motions, in
/// Blanes' and Moan's Nyström splittings with six and eleven kicks for orders 4 and 6. For other bodies the energy is split in three, like that of
/// [`FreeSplitting`]: rotations about one outer axis, kicks, rotations about L and the other axis, and back in reverse order. Order 4 uses the Nyström
/// splitting there too, which has that order for any parts, and begins with the axis whose moment is nearer to the middle one; order 6 uses the splitting
/// with ten stages. The error carries the torque or the differences of the moments as factors.
///
/// Conserved under weight, to rounding: L along the vertical and the phase volume (symplectic); for Lagrange's top also L along the axis. Symmetric in
/// time; the energy oscillates by O(stepᵖ) and does not drift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeavySplitting<N> {
    axes: Axes,
    torque: N,
    order: Order,
}

impl<N> HeavySplitting<N> {
    /// The method of this order for a body with these principal moments, kg m², in any order, under this torque.
    ///
    /// # Errors
    /// Those of an invalid moment.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::integrators::geometric::{HeavySplitting, Integrator, Order, Phase, Weight};
    /// let start = Phase::new(BodyVector::new(0.1, 2.0, 0.3), &Attitude::identity());
    /// let method = HeavySplitting::new([1.0, 1.0, 0.5], Weight::new([0.0, 0.0, 1.0])?, Order::Four)?;
    /// let mut run = method.start(&start, 0.01)?;
    /// run.advance(1000)?;
    /// // A symmetric top keeps L₃.
    /// assert!((run.phase()?.l[2] - 0.3).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: [f64; 3], torque: N, order: Order) -> Result<Self> {
        let mut axes = Axes::new(moments)?;
        let [outer, inner] =
            [axes.outer, axes.inner].map(|(_, moment)| (moment - axes.middle).abs());
        // A rotation with rate 0 comes first, to be left out. At order 4 the slower one comes first, which needs 0.85 of the steps for the same error
        // (geometric mean of 300 bodies).
        if inner == 0.0 || order == Order::Four && inner < outer {
            (axes.outer, axes.inner) = (axes.inner, axes.outer);
        }
        Ok(Self {
            axes,
            torque,
            order,
        })
    }

    fn parts<T: Real, const UNEQUAL: bool>(&self) -> Kicked<'_, T, N, UNEQUAL> {
        let axes = self.axes;
        Kicked {
            outer: axes.rate(axes.outer),
            inner: axes.rate(axes.inner),
            about_momentum: T::from_double(0.5) * T::from_double(axes.middle).reciprocal(),
            torque: &self.torque,
        }
    }
}

impl<T: Real, N: Torque<T>> Integrator<T> for HeavySplitting<N> {
    fn name(&self) -> String {
        format!("kick and drift {}", self.order as u32)
    }

    fn order(&self) -> u32 {
        self.order as u32
    }

    fn start(&self, phase: &Phase<T>, step: T) -> Result<Box<dyn Stepper<T> + '_>> {
        let run = Run::new(phase, step)?;
        // A rotation with rate 0 is left out.
        let unequal = self.axes.outer.1 != self.axes.middle;
        let splitting = match self.order {
            Order::Two => STRANG,
            Order::Four => NYSTROM_6,
            Order::Six if unequal => S10,
            Order::Six => NYSTROM_11,
        };
        if unequal {
            let parts = self.parts::<T, true>();
            Ok(Alternating::boxed(parts, run, splitting, step))
        } else {
            let parts = self.parts::<T, false>();
            Ok(Alternating::boxed(parts, run, splitting, step))
        }
    }
}

/// Two motions that are each exact over any time; or three, the third on the way between the other two.
trait Parts<T: Real> {
    /// Pairs of sine and cosine in a stage.
    const PAIRS: u64;

    fn outer(&self, run: &mut Run<T>, h: T);

    fn between(&self, _: &mut Run<T>, _: T) {}

    fn inner(&self, run: &mut Run<T>, h: T);

    /// Applies what has been postponed to the end.
    fn finish(&self, _: &mut Run<T>, _steps: u64) {}
}

/// Rotations about two axes, with the rotation about L postponed to the end.
struct Free<T> {
    q: [T; 4],
    /// The direction of L. Half the angle about L in a step has two words: in one, 10⁷ steps would lose five digits.
    direction: [T; 3],
    half: DoubleDouble,
    outer: (usize, T),
    inner: (usize, T),
}

impl<T: Real> Parts<T> for Free<T> {
    const PAIRS: u64 = 1;

    #[inline(always)]
    fn outer(&self, run: &mut Run<T>, h: T) {
        about_axis(run, self.outer, h);
    }

    #[inline(always)]
    fn inner(&self, run: &mut Run<T>, h: T) {
        about_axis(run, self.inner, h);
    }

    /// The attitude q exp(tL₀/2I₂) times the product of the other rotations.
    fn finish(&self, run: &mut Run<T>, steps: u64) {
        let (sine, cosine) = T::sine_and_cosine(self.half * DoubleDouble::from(steps as f64));
        let [x, y, z] = self.direction.map(|component| sine * component);
        run.q.values = product(product(self.q, [cosine, x, y, z]), run.q.values);
    }
}

/// Kicks, and rotations about L and one axis; also about a second axis, if no two moments are equal.
struct Kicked<'a, T, N, const UNEQUAL: bool> {
    outer: (usize, T),
    inner: (usize, T),
    /// Half the angle about L per unit of L and time.
    about_momentum: T,
    torque: &'a N,
}

impl<T: Real, N: Torque<T>, const UNEQUAL: bool> Kicked<'_, T, N, UNEQUAL> {
    #[inline(always)]
    fn kick(&self, run: &mut Run<T>, h: T) {
        let torque = self.torque.torque(&run.phase());
        run.l.add_all(torque.map(|component| component * h));
    }
}

impl<T: Real, N: Torque<T>, const UNEQUAL: bool> Parts<T> for Kicked<'_, T, N, UNEQUAL> {
    const PAIRS: u64 = if UNEQUAL { 3 } else { 2 };

    #[inline(always)]
    fn outer(&self, run: &mut Run<T>, h: T) {
        if UNEQUAL {
            about_axis(run, self.outer, h);
        } else {
            self.kick(run, h);
        }
    }

    #[inline(always)]
    fn between(&self, run: &mut Run<T>, h: T) {
        if UNEQUAL {
            self.kick(run, h);
        }
    }

    #[inline(always)]
    fn inner(&self, run: &mut Run<T>, h: T) {
        let turn = exponential(run.l.values.map(|x| x * (self.about_momentum * h)));
        run.q.add_all(product(run.q.values, turn));
        about_axis(run, self.inner, h);
    }
}

/// Lengths of the outer motion, the one between, the inner, and again the one between, in one stage.
type Stage<T> = [T; 4];

/// A splitting. The last outer motion of a step and the first of the next are combined, so a step ends before it; a phase that is read has it added.
struct Alternating<T, P> {
    parts: P,
    stages: Vec<Stage<T>>,
    run: Run<T>,
    /// Length of the outer motion that is still due.
    due: T,
    steps: u64,
}

impl<'a, T: Real, P: Parts<T> + 'a> Alternating<T, P> {
    fn boxed(parts: P, run: Run<T>, splitting: &[f64], step: T) -> Box<dyn Stepper<T> + 'a> {
        let mut after = 0.0;
        let part_steps = part_steps(splitting);
        let stages = part_steps.chunks_exact(2).map(|pair| {
            let (outer, inner) = (pair[0], pair[1]);
            // A step and its mirror image alternate: the step before the inner motion has the length by which it completes the outer one.
            let before = outer - after;
            after = inner - before;
            [outer, before, inner, after].map(|part| T::from_double(part) * step)
        });
        Box::new(Self {
            parts,
            stages: stages.collect(),
            run,
            due: T::from_double(0.0),
            steps: 0,
        })
    }
}

impl<T: Real, P: Parts<T>> Stepper<T> for Alternating<T, P> {
    fn advance(&mut self, steps: u64) -> Result<()> {
        let Some(&[last, ..]) = self.stages.first() else {
            return Ok(());
        };
        let (mut run, mut due) = (self.run, self.due);
        for _ in 0..steps {
            for &[outer, before, inner, after] in &self.stages {
                self.parts.outer(&mut run, due + outer);
                self.parts.between(&mut run, before);
                self.parts.inner(&mut run, inner);
                self.parts.between(&mut run, after);
                due = T::from_double(0.0);
            }
            due = last;
        }
        (self.run, self.due) = (run, due);
        self.steps += steps;
        Ok(())
    }

    fn phase(&self) -> Result<Phase<T>> {
        let mut run = self.run;
        self.parts.outer(&mut run, self.due);
        self.parts.finish(&mut run, self.steps);
        run.settled()
    }

    fn cost(&self) -> Cost {
        Cost {
            evaluations: self.steps * self.stages.len() as u64 * P::PAIRS,
            steps: self.steps,
        }
    }
}

/// Turns the body about one of its axes at `rate` per unit of L along it, for a time `h`.
#[inline(always)]
fn about_axis<T: Real>(run: &mut Run<T>, (axis, rate): (usize, T), h: T) {
    let half = rate * h;
    match axis {
        0 => about::<T, 0>(run, half),
        1 => about::<T, 1>(run, half),
        _ => about::<T, 2>(run, half),
    }
}

/// Turns the body about one of its axes by 2·`half` times L along it.
#[inline(always)]
fn about<T: Real, const AXIS: usize>(run: &mut Run<T>, half: T) {
    let (j, k) = ((AXIS + 1) % 3, (AXIS + 2) % 3);
    let l = run.l.values;
    let (s, v) = (half * l[AXIS]).turn();
    // sin 2x and 1 − cos 2x, for L, which turns by twice the half angle.
    let twice = s + s;
    let (s2, v2) = (twice - twice * v, twice * s);
    run.l.add(j, s2 * l[k] - v2 * l[j]);
    run.l.add(k, -(s2 * l[j]) - v2 * l[k]);
    let q = run.q.values;
    run.q.add(0, -(s * q[AXIS + 1]) - v * q[0]);
    run.q.add(AXIS + 1, s * q[0] - v * q[AXIS + 1]);
    run.q.add(j + 1, s * q[k + 1] - v * q[j + 1]);
    run.q.add(k + 1, -(s * q[j + 1]) - v * q[k + 1]);
}
