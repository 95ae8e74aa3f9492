//! Free motion as one part of a heavy top's step.

use super::{FreeSplitting, Order, Run, checked_moments};
use crate::error::{Error, Result, finite};
use crate::euler_top::EulerTop;
use crate::frame::{Attitude, BodyVector};
use crate::integrators::real::{Real, dot};

/// The motion without torque over a part step.
pub trait Drift<T: Real> {
    /// How it is made, for names of methods.
    fn name(&self) -> String;

    /// Moves the run by the free motion of `h` seconds, either way.
    ///
    /// # Errors
    /// Those of the solution, where there is one.
    fn drift(&self, run: &mut Run<T>, h: T) -> Result<()>;

    /// Its own order, if it is not exact: a splitting made with it has no more.
    fn order(&self) -> Option<u32> {
        None
    }

    /// Evaluations that one drift counts for: sine pairs, or one where the motion is solved.
    fn evaluations(&self) -> u64;
}

/// The exact free motion of a symmetric body: a turn about L by |L|h/I₁, one about the axis by (1/I₃ − 1/I₁)L₃h. Two sine pairs, no root.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SymmetricDrift {
    transverse: f64,
    axial: f64,
    axis: usize,
}

impl SymmetricDrift {
    /// For a body of which two moments are equal; a sphere is one.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::TriangleInequality`] for moments that no body has; [`Error::Condition`] where no two are equal.
    pub fn new(moments: [f64; 3]) -> Result<Self> {
        let moments = checked_moments(moments)?;
        for axis in [2, 0, 1] {
            let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
            if moments[j] == moments[k] {
                return Ok(Self {
                    transverse: moments[j],
                    axial: moments[axis],
                    axis,
                });
            }
        }
        Err(Error::Condition {
            condition: "two moments of a symmetric body must be equal",
            value: moments[1] / moments[0],
        })
    }
}

impl<T: Real> Drift<T> for SymmetricDrift {
    fn name(&self) -> String {
        "exact drift".to_owned()
    }

    #[inline(always)]
    fn drift(&self, run: &mut Run<T>, h: T) -> Result<()> {
        about_momentum(run, self.transverse, h);
        let factor = half_factor(self.transverse, self.axial, h);
        match self.axis {
            0 => about_axis::<T, 0>(run, factor),
            1 => about_axis::<T, 1>(run, factor),
            _ => about_axis::<T, 2>(run, factor),
        }
        Ok(())
    }

    fn evaluations(&self) -> u64 {
        2
    }
}

/// The exact free motion of any body, by elliptic functions: [`EulerTop::for_one_step`]. A microsecond a drift; doubles only, and without the
/// leftovers of sums.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnequalDrift {
    moments: [f64; 3],
}

impl UnequalDrift {
    /// For the body with these moments.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::TriangleInequality`].
    pub fn new(moments: [f64; 3]) -> Result<Self> {
        Ok(Self {
            moments: checked_moments(moments)?,
        })
    }
}

impl Drift<f64> for UnequalDrift {
    fn name(&self) -> String {
        "exact drift".to_owned()
    }

    fn drift(&self, run: &mut Run<f64>, h: f64) -> Result<()> {
        let [x, y, z] = run.l.values;
        for component in [x, y, z] {
            finite("the angular momentum", component)?;
        }
        let l = BodyVector::new(x, y, z);
        let state = EulerTop::for_one_step(self.moments, l, Attitude::identity())?.at(h)?;
        let q = state.attitude.quaternion();
        let change = (state.angular_momentum - l).components();
        run.turn([q.w - 1.0, q.i, q.j, q.k], change.into());
        Ok(())
    }

    fn evaluations(&self) -> u64 {
        1
    }
}

/// The free motion by rotations: about L once, about the axes of the smallest and the largest moment in turn, as [`FreeSplitting`]
/// does it in any of its orders. Four, fourteen or twenty-two sine pairs; for unequal moments that is a tenth, a quarter or a third of the cost of an exact drift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotations {
    splitting: FreeSplitting,
    order: Order,
}

impl Rotations {
    /// For the body with these moments.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`], [`Error::TriangleInequality`].
    pub fn new(moments: [f64; 3], order: Order) -> Result<Self> {
        Ok(Self {
            splitting: FreeSplitting::new(moments, order)?,
            order,
        })
    }
}

impl<T: Real> Drift<T> for Rotations {
    fn name(&self) -> String {
        "rotations".to_owned()
    }

    fn drift(&self, run: &mut Run<T>, h: T) -> Result<()> {
        self.splitting.drift(run, h);
        Ok(())
    }

    fn order(&self) -> Option<u32> {
        Some(self.order.number())
    }

    fn evaluations(&self) -> u64 {
        match self.order {
            Order::Two => 4,
            Order::Four => 14,
            Order::Six => 22,
        }
    }
}

/// ½h(1/I − 1/I₀), differences first.
#[inline(always)]
fn half_factor<T: Real>(base: f64, moment: f64, h: T) -> T {
    let difference = T::from_double(base) - T::from_double(moment);
    let product = T::from_double(base) * T::from_double(moment);
    T::from_double(0.5) * h * difference * product.reciprocal()
}

/// A turn about L by |L|h/I.
#[inline(always)]
fn about_momentum<T: Real>(run: &mut Run<T>, moment: f64, h: T) {
    let rate = T::from_double(0.5) * h * T::from_double(moment).reciprocal();
    let half = run.l.values.map(|x| x * rate);
    let square = dot(half, half);
    let (sine, versine) = square.turn_of_square();
    let [x, y, z] = half.map(|component| sine * component);
    run.q
        .add_all(super::product(run.q.values, [-(square * versine), x, y, z]));
}

/// A turn about an axis of the body by 2·`factor`·L along it.
#[inline(always)]
fn about_axis<T: Real, const AXIS: usize>(run: &mut Run<T>, factor: T) {
    let (j, k) = ((AXIS + 1) % 3, (AXIS + 2) % 3);
    let l = run.l.values;
    let (s, v) = (factor * l[AXIS]).turn();
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
