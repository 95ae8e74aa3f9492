//! A free body by rotations about two of its axes in turn.

use super::coefficients::{S6, S10, STRANG, Splitting};
use super::{Cost, Integrator, Order, Phase, Run, checked_moments, checked_run, unit};
use crate::error::Result;
use crate::integrators::real::{Real, Sums, dot, product};
use crate::precise::DoubleDouble;

/// A free body, its energy split as |L|²/2I₂ + ½(1/I₁ − 1/I₂)L₁² + ½(1/I₃ − 1/I₂)L₃², I₁ ≤ I₂ ≤ I₃.
///
/// Each part alone turns the body exactly: the first about L, which stays in space; the others about axes 1 and 3. The first commutes
/// with the others, so it is made once at the end of a run; a step of order 2 is one rotation about each axis, of 4 six and of 6 ten. Compared with
/// three rotations about the three axes, that is a third less work, and the errors carry the small factors of nearly symmetric bodies.
///
/// Kept: |L|, L in space and the phase volume (symplectic) to rounding; time symmetry; the energy oscillates by O(stepᵖ) and does not drift. Bodies
/// with two equal moments are turned exactly, whatever the step. Cost: one pair of sine and cosine a rotation. Source: McLachlan 1993 and Reich 1994
/// for rotations as parts; the choice of the parts is ours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeSplitting {
    moments: [f64; 3],
    order: Order,
    /// The axes of the smallest, middle and largest moment.
    axes: [usize; 3],
    /// −1 where that order of the axes is a mirror image.
    handedness: f64,
}

impl FreeSplitting {
    /// For the body with these principal moments, kg m², in any order.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive),
    /// [`Error::TriangleInequality`](crate::Error::TriangleInequality).
    pub fn new(moments: [f64; 3], order: Order) -> Result<Self> {
        let moments = checked_moments(moments)?;
        let mut axes = [0, 1, 2];
        axes.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
        let even = (axes[0] + 1) % 3 == axes[1];
        Ok(Self {
            moments,
            order,
            axes,
            handedness: if even { 1.0 } else { -1.0 },
        })
    }

    pub(super) fn run<T: Real>(&self, phase: &mut Phase<T>, step: T, steps: u64) -> u64 {
        match self.order {
            Order::Two => self.run_of(&STRANG, phase, step, steps),
            Order::Four => self.run_of(&S6, phase, step, steps),
            Order::Six => self.run_of(&S10, phase, step, steps),
        }
    }

    fn run_of<T: Real, const N: usize>(
        &self,
        splitting: &Splitting<N>,
        phase: &mut Phase<T>,
        step: T,
        steps: u64,
    ) -> u64 {
        if steps == 0 {
            return 0;
        }
        let [i, j, k] = self.axes;
        let sign = T::from_double(self.handedness);
        let (one, zero) = (T::from_double(1.0), T::from_double(0.0));
        let start = [sign * phase.l[i], sign * phase.l[j], sign * phase.l[k]];
        let mut run = Turning {
            l: Sums::new(start),
            q: Sums::new([one, zero, zero, zero]),
        };
        run.stages(splitting, self.halves(step), steps);
        // The part about L, of which the rider sees nothing: q exp(tL₀/2I₂) times what the others have made.
        let [less, x, y, z] = about_momentum(phase.l, self.moments[j], step, steps);
        let about = [one + less, x, y, z];
        let mut turned = [run.q.values[0]; 4];
        for (n, axis) in [i, j, k].into_iter().enumerate() {
            turned[axis + 1] = sign * run.q.values[n + 1];
            phase.l[axis] = sign * run.l.values[n];
        }
        phase.q = unit(product(product(phase.q, about), turned));
        steps * N as u64
    }

    /// One step as a part of another method's.
    #[inline(always)]
    pub(super) fn drift<T: Real>(&self, run: &mut Run<T>, h: T) {
        let [i, j, k] = self.axes;
        let (one, sign) = (T::from_double(1.0), T::from_double(self.handedness));
        let (vector, scalar_first) = ([sign; 3], [one, sign, sign, sign]);
        let places = [0, i + 1, j + 1, k + 1];
        let mut sorted = Turning {
            l: run.l.arranged([i, j, k], vector),
            q: run.q.arranged(places, scalar_first),
        };
        let about = about_momentum(sorted.l.values, self.moments[j], h, 1);
        sorted.q.add_all(product(sorted.q.values, about));
        let halves = self.halves(h);
        match self.order {
            Order::Two => sorted.stages(&STRANG, halves, 1),
            Order::Four => sorted.stages(&S6, halves, 1),
            Order::Six => sorted.stages(&S10, halves, 1),
        }
        run.l.arrange_back(&sorted.l, [i, j, k], vector);
        run.q.arrange_back(&sorted.q, places, scalar_first);
    }

    /// Half angles per unit of L₁ and of L₃ in a whole step.
    fn halves<T: Real>(&self, step: T) -> [T; 2] {
        let [first, middle, third] = self.axes.map(|axis| self.moments[axis]);
        // Differences first: the moments may be nearly equal.
        [first, third].map(|moment| {
            let difference = T::from_double(middle) - T::from_double(moment);
            let product = T::from_double(middle) * T::from_double(moment);
            T::from_double(0.5) * step * difference * product.reciprocal()
        })
    }
}

impl<T: Real> Integrator<T> for FreeSplitting {
    fn name(&self) -> String {
        format!("rotations {}", self.order.number())
    }

    fn order(&self) -> u32 {
        self.order.number()
    }

    fn advance(&self, phase: &mut Phase<T>, step: T, steps: u64) -> Result<Cost> {
        checked_run(phase, step)?;
        let evaluations = self.run(phase, step, steps);
        phase.check()?;
        Ok(Cost { evaluations, steps })
    }
}

/// The quaternion, less 1, of the turn about L by |L|t/I in the time t of all steps.
///
/// A single word counts on for the angle that it holds to rounding, π/2; two words for any other, or 10⁷ steps would lose five digits here.
fn about_momentum<T: Real>(l: [T; 3], moment: f64, step: T, steps: u64) -> [T; 4] {
    let one = T::from_double(1.0);
    let count = T::from_double(steps as f64);
    let rate = T::from_double(0.5) * step * count * T::from_double(moment).reciprocal();
    let half = l.map(|x| x * rate);
    let square = dot(half, half);
    if square.to_double() < 0.6 {
        let (sine, versine) = square.turn_of_square();
        let [x, y, z] = half.map(|component| sine * component);
        return [-(square * versine), x, y, z];
    }
    let exact = DoubleDouble::from(0.5 * steps as f64)
        * step.two_words()
        * DoubleDouble::from(moment).reciprocal();
    let exact = l.map(|x| x.two_words() * exact);
    let (sine, cosine) = T::long_turn(dot(exact, exact));
    let [x, y, z] = half.map(|component| sine * component);
    [cosine - one, x, y, z]
}

/// L along the sorted axes and the turn so far.
#[derive(Clone, Copy)]
struct Turning<T> {
    l: Sums<T, 3>,
    q: Sums<T, 4>,
}

impl<T: Real> Turning<T> {
    /// So many steps of A B … A with these half angles per unit of L.
    ///
    /// One loop over all stages and a function of its own: every order and every caller share the small code.
    #[inline(never)]
    fn stages<const N: usize>(&mut self, splitting: &Splitting<N>, [a, b]: [T; 2], steps: u64) {
        let outer = splitting.outer.map(|c| T::from_double(c) * a);
        let inner = splitting.inner.map(|c| T::from_double(c) * b);
        // The last rotation of a step and the first of the next are one.
        let joint = T::from_double(2.0) * outer[0];
        let mut run = *self;
        run.about_first(outer[0]);
        let mut n = 0;
        for left in (0..steps * N as u64).rev() {
            run.about_third(inner[n]);
            n = if n + 1 < N { n + 1 } else { 0 };
            let last = if left == 0 { outer[0] } else { joint };
            run.about_first(if n == 0 { last } else { outer[n] });
        }
        *self = run;
    }

    /// The body turns by the angle 2·`half`·L₁ about the first axis.
    #[inline(always)]
    fn about_first(&mut self, half: T) {
        let [l1, l2, l3] = self.l.values;
        let (s, v) = (half * l1).turn();
        let [s2, v2] = doubled(s, v);
        self.l.add(1, s2 * l3 - v2 * l2);
        self.l.add(2, -(s2 * l2) - v2 * l3);
        let [w, x, y, z] = self.q.values;
        self.q.add_all([
            -(s * x) - v * w,
            s * w - v * x,
            s * z - v * y,
            -(s * y) - v * z,
        ]);
    }

    /// The same about the third.
    #[inline(always)]
    fn about_third(&mut self, half: T) {
        let [l1, l2, l3] = self.l.values;
        let (s, v) = (half * l3).turn();
        let [s2, v2] = doubled(s, v);
        self.l.add(0, s2 * l2 - v2 * l1);
        self.l.add(1, -(s2 * l1) - v2 * l2);
        let [w, x, y, z] = self.q.values;
        self.q.add_all([
            -(s * z) - v * w,
            s * y - v * x,
            -(s * x) - v * y,
            s * w - v * z,
        ]);
    }
}

/// sin 2x and 1 − cos 2x from sin x and 1 − cos x.
#[inline(always)]
fn doubled<T: Real>(s: T, v: T) -> [T; 2] {
    let twice = s + s;
    [twice - twice * v, twice * s]
}
