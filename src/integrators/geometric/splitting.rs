//! Splitting methods: motions that are each exact, in turn. Rotations about axes of the body, the rotation about L, kicks by a torque.

use super::coefficients::{NYSTROM_6, NYSTROM_11, S6, S10, STRANG, part_steps};
use super::stepper::{Rule, Run, Steps, checked_moments, unit};
use super::{Integrator, Phase, Stepper, Torque};
use crate::error::Result;
use crate::integrators::real::{Real, Sums, dot, exponential, product};
use crate::precise::{DoubleDouble, Number};
use crate::search::ascending;

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

/// The axes by which the energy of a free body is split, |L|²/2I₂ + ½(1/I₁ − 1/I₂)L₁² + ½(1/I₃ − 1/I₂)L₃², each with its moment: an outer one, of the
/// least or of the greatest moment, the middle one, and the other, the inner one.
type Axes = [(usize, f64); 3];

fn axes(moments: [f64; 3]) -> Result<Axes> {
    let moments = checked_moments(moments)?;
    Ok(ascending([0, 1, 2], &moments).map(|axis| (axis, moments[axis])))
}

/// A free body, by rotations about its axes of least and of greatest moment in turn.
///
/// Each part of the energy |L|²/2I₂ + ½(1/I₁ − 1/I₂)L₁² + ½(1/I₃ − 1/I₂)L₃² by itself gives an exact rotation: the first about L, which is fixed in
/// space; the others about axes 1 and 3. The first commutes with the others, so it is applied only when a phase is read; a step of order 2 is one
/// rotation about each axis, of order 4 six, of order 6 ten. That is a third less work than rotations about all three axes, and the errors carry the
/// small factors of nearly symmetric bodies.
///
/// Conserved: |L|, L in space and the phase volume (symplectic) to rounding; symmetric in time; the energy oscillates by O(stepᵖ) and does not drift.
/// Bodies with two equal moments are turned exactly, whatever the step. Cost: one pair of sine and cosine a rotation, two a stage. Source: McLachlan
/// 1993 and Reich 1994 for rotations as parts; the choice of the parts is ours.
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
        let axes = axes(moments)?;
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
        // The attitude without the rotation about L, which is postponed to the end.
        run.q = Sums::new([1.0, 0.0, 0.0, 0.0].map(T::from_double));
        let exact = l.map(T::two_words);
        let size = Number::square_root(dot(exact, exact));
        let halved = step.two_words() * DoubleDouble::from(0.5);
        let [outer, (_, middle), inner] = self.axes;
        // Half the angle about L in a step has two words: in one, 10⁷ steps would lose five digits.
        let half = size * halved / DoubleDouble::from(middle);
        let direction = unit(l);
        let splitting = match self.order {
            Order::Two => STRANG,
            Order::Four => S6,
            Order::Six => S10,
        };
        let motions = (about(outer, middle), nothing, about(inner, middle));
        let rule = Alternating::new(splitting, step, 2, motions, move |run, steps| {
            // The attitude q exp(tL₀/2I₂) times the product of the other rotations.
            let (sine, cosine) = T::sine_and_cosine(half * DoubleDouble::from(steps as f64));
            let [x, y, z] = direction.map(|component| sine * component);
            run.q.values = product(product(q, [cosine, x, y, z]), run.q.values);
        });
        Ok(Steps::boxed(run, rule))
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
/// time; the energy oscillates by O(stepᵖ) and does not drift. Cost: three pairs of sine and cosine and two torques a stage; for a body with two equal
/// moments two pairs and one torque.
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
        let mut axes = axes(moments)?;
        let [outer, inner] = [axes[0], axes[2]].map(|(_, moment)| (moment - axes[1].1).abs());
        // A rotation with rate 0 comes first, to be left out. At order 4 the slower one comes first, which needs 0.85 of the steps for the same error
        // (geometric mean of 300 bodies).
        if inner == 0.0 || order == Order::Four && inner < outer {
            axes.reverse();
        }
        Ok(Self {
            axes,
            torque,
            order,
        })
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
        let [outer, (_, middle), inner] = self.axes;
        // The change of L by the torque.
        let kick = move |run: &mut Run<T>, h: T| {
            let torque = self.torque.torque(&run.phase());
            run.l.add_all(torque.map(|component| component * h));
        };
        // The rotation about L, by half its angle per unit of L and time, and the one about the inner axis.
        let about_momentum = T::from_double(0.5) * T::from_double(middle).reciprocal();
        let about_inner = about(inner, middle);
        let drift = move |run: &mut Run<T>, h: T| {
            let turn = exponential(run.l.values.map(|x| x * (about_momentum * h)));
            run.q.add_all(product(run.q.values, turn));
            about_inner.over(run, h);
        };
        // A rotation with rate 0 is left out.
        let unequal = outer.1 != middle;
        let splitting = match self.order {
            Order::Two => STRANG,
            Order::Four => NYSTROM_6,
            Order::Six if unequal => S10,
            Order::Six => NYSTROM_11,
        };
        Ok(if unequal {
            let motions = (about(outer, middle), kick, drift);
            let rule = Alternating::new(splitting, step, 3, motions, |_, _| ());
            Steps::boxed(run, rule)
        } else {
            let rule = Alternating::new(splitting, step, 2, (kick, nothing, drift), |_, _| ());
            Steps::boxed(run, rule)
        })
    }
}

/// A motion that is exact over any time `h`. A closure is one.
trait Motion<T: Real> {
    fn over(&self, run: &mut Run<T>, h: T);
}

impl<T: Real, F: Fn(&mut Run<T>, T)> Motion<T> for F {
    #[inline(always)]
    fn over(&self, run: &mut Run<T>, h: T) {
        self(run, h);
    }
}

/// No motion.
#[inline(always)]
fn nothing<T>(_: &mut Run<T>, _: T) {}

/// The rotation about one of the body's axes, by half its angle per unit of L along it and time.
struct About<T> {
    axis: usize,
    rate: T,
}

/// The rotation about an axis by which the energy differs from that of a body with the middle moment alone.
fn about<T: Real>((axis, moment): (usize, f64), middle: f64) -> About<T> {
    let [middle, moment] = [middle, moment].map(T::from_double);
    // Differences first: the moments may be nearly equal.
    let product = middle * moment;
    let rate = T::from_double(0.5) * (middle - moment) * product.reciprocal();
    About { axis, rate }
}

impl<T: Real> Motion<T> for About<T> {
    #[inline(always)]
    fn over(&self, run: &mut Run<T>, h: T) {
        let half = self.rate * h;
        match self.axis {
            0 => turn_about::<T, 0>(run, half),
            1 => turn_about::<T, 1>(run, half),
            _ => turn_about::<T, 2>(run, half),
        }
    }
}

/// A splitting into an outer and an inner motion, a third on the way between them, and what is postponed to the end.
///
/// The last outer motion of a step and the first of the next are combined, so a step ends before it; a phase that is read has it added.
struct Alternating<T, O, B, I, F> {
    /// Lengths of the outer motion, the one between, the inner, and again the one between.
    stages: Vec<[T; 4]>,
    /// Pairs of sine and cosine in a stage.
    pairs: u64,
    motions: (O, B, I),
    postponed: F,
    /// Length of the outer motion that is still due.
    due: T,
}

impl<T: Real, O, B, I, F: Fn(&mut Run<T>, u64)> Alternating<T, O, B, I, F> {
    fn new(splitting: &[f64], step: T, pairs: u64, motions: (O, B, I), postponed: F) -> Self {
        let mut after = 0.0;
        let part_steps = part_steps(splitting);
        let stages = part_steps.chunks_exact(2).map(|pair| {
            let (outer, inner) = (pair[0], pair[1]);
            // A step and its mirror image alternate: the step before the inner motion has the length by which it completes the outer one.
            let before = outer - after;
            after = inner - before;
            [outer, before, inner, after].map(|part| T::from_double(part) * step)
        });
        Self {
            stages: stages.collect(),
            pairs,
            motions,
            postponed,
            due: T::from_double(0.0),
        }
    }
}

impl<T, O, B, I, F> Rule<T> for Alternating<T, O, B, I, F>
where
    T: Real,
    O: Motion<T>,
    B: Motion<T>,
    I: Motion<T>,
    F: Fn(&mut Run<T>, u64),
{
    #[inline(always)]
    fn step(&mut self, run: &mut Run<T>) -> Result<u64> {
        let (outer, between, inner) = &self.motions;
        for &[first, before, middle, after] in &self.stages {
            outer.over(run, self.due + first);
            between.over(run, before);
            inner.over(run, middle);
            between.over(run, after);
            self.due = T::from_double(0.0);
        }
        self.due = self.stages[0][0];
        Ok(self.stages.len() as u64 * self.pairs)
    }

    fn finish(&self, run: &mut Run<T>, steps: u64) {
        self.motions.0.over(run, self.due);
        (self.postponed)(run, steps);
    }
}

/// Turns the body about one of its axes by 2·`half` times L along it.
#[inline(always)]
fn turn_about<T: Real, const AXIS: usize>(run: &mut Run<T>, half: T) {
    let (j, k) = ((AXIS + 1) % 3, (AXIS + 2) % 3);
    let l = run.l.values;
    let (s, v) = (half * l[AXIS]).turn();
    // L turns by twice the half angle: 2s(1 − v) and 2s² are its sine and versine. They are not formed, for where all steps are alike, as with two equal
    // moments, their rounding would turn L ever further against the attitude.
    let twice = s + s;
    run.l.add(j, twice * (l[k] - (v * l[k] + s * l[j])));
    run.l.add(k, twice * ((v * l[j] - s * l[k]) - l[j]));
    let q = run.q.values;
    run.q.add(0, -(s * q[AXIS + 1]) - v * q[0]);
    run.q.add(AXIS + 1, s * q[0] - v * q[AXIS + 1]);
    run.q.add(j + 1, s * q[k + 1] - v * q[j + 1]);
    run.q.add(k + 1, -(s * q[j + 1]) - v * q[k + 1]);
}
