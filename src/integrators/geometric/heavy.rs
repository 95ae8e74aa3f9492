//! Bodies under a torque: kicks between free motions.

use super::coefficients::{NYSTROM_6, NYSTROM_11, S6, S10, STRANG, Splitting};
use super::{Cost, Drift, Integrator, Order, Phase, Run, checked_moments, checked_run};
use crate::error::{Result, finite, not_negative};
use crate::integrators::real::{Real, cross};

/// A torque, N m along the body's axes, as a function of the phase.
pub trait Torque<T: Real> {
    /// Whether there is any: without, nothing is computed for it.
    const ACTS: bool = true;

    /// The torque here.
    fn torque(&self, phase: &Phase<T>) -> [T; 3];
}

/// What a torque alone does in a time, the body standing still: the exact change of L.
pub trait Kick<T: Real> {
    /// Whether the change depends on the attitude and the time alone, not on L. Orders 4 and 6 then need fewer kicks.
    const OF_ATTITUDE_ALONE: bool;

    /// The change of L over `h` seconds, either way, kg m²/s along the body's axes.
    fn change(&self, phase: &Phase<T>, h: T) -> [T; 3];
}

/// Any function of phase and time will do for a kick.
impl<T: Real, F: Fn(&Phase<T>, T) -> [T; 3]> Kick<T> for F {
    const OF_ATTITUDE_ALONE: bool = false;

    #[inline(always)]
    fn change(&self, phase: &Phase<T>, h: T) -> [T; 3] {
        self(phase, h)
    }
}

/// No torque.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Nothing;

impl<T: Real> Torque<T> for Nothing {
    const ACTS: bool = false;

    #[inline(always)]
    fn torque(&self, _: &Phase<T>) -> [T; 3] {
        [T::from_double(0.0); 3]
    }
}

/// Weight: the torque z∧MgC (8.1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weight {
    lever: [f64; 3],
}

impl Weight {
    /// With the lever MgC, N m along the body's axes, C the centre of mass seen from the pivot.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    pub fn new(lever: [f64; 3]) -> Result<Self> {
        for component in lever {
            finite("the lever MgC", component)?;
        }
        Ok(Self { lever })
    }
}

impl<T: Real> Torque<T> for Weight {
    #[inline(always)]
    fn torque(&self, phase: &Phase<T>) -> [T; 3] {
        cross(phase.up(), self.lever.map(T::from_double))
    }
}

impl<T: Real> Kick<T> for Weight {
    const OF_ATTITUDE_ALONE: bool = true;

    #[inline(always)]
    fn change(&self, phase: &Phase<T>, h: T) -> [T; 3] {
        self.torque(phase).map(|component| component * h)
    }
}

/// Another torque, and friction in proportion to the turning on top of it: −c_jΩ_j about axis j (7.4, 7.5).
///
/// While the body stands still both together have an exact solution: L_j goes towards N_jI_j/c_j like exp(−c_jt/I_j).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearFriction<N> {
    torque: N,
    rates: [f64; 3],
}

impl<N> LinearFriction<N> {
    /// With the coefficients c_j in N m s and the moments of the body.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative); those of the moments.
    pub fn new(torque: N, coefficients: [f64; 3], moments: [f64; 3]) -> Result<Self> {
        let moments = checked_moments(moments)?;
        for coefficient in coefficients {
            not_negative("friction", coefficient)?;
        }
        Ok(Self {
            torque,
            rates: core::array::from_fn(|k| coefficients[k] / moments[k]),
        })
    }
}

impl<T: Real, N: Torque<T>> Torque<T> for LinearFriction<N> {
    fn torque(&self, phase: &Phase<T>) -> [T; 3] {
        let torque = self.torque.torque(phase);
        core::array::from_fn(|k| torque[k] - T::from_double(self.rates[k]) * phase.l[k])
    }
}

/// Exact where the other torque does not depend on L.
impl<N: Torque<f64>> Kick<f64> for LinearFriction<N> {
    const OF_ATTITUDE_ALONE: bool = false;

    fn change(&self, phase: &Phase, h: f64) -> [f64; 3] {
        let torque = self.torque.torque(phase);
        core::array::from_fn(|k| {
            let decay = (-self.rates[k] * h).exp_m1();
            let time = if self.rates[k] == 0.0 {
                h
            } else {
                -decay / self.rates[k]
            };
            phase.l[k] * decay + torque[k] * time
        })
    }
}

/// A body under a torque: kicks and free motions in turn.
///
/// Order 2 is Strang's; orders 4 and 6 are Blanes' and Moan's Nyström splittings with six and eleven kicks where the kick is [of the attitude
/// alone](Kick::OF_ATTITUDE_ALONE), their splittings for any two parts with six and ten where it is not. The free motion being exact, the error
/// carries the torque as a factor: a fast top allows long steps. With a drift that is not exact the order is the lower of the two.
///
/// Kept, under weight alone: L along the vertical and the phase volume (symplectic), to rounding; time symmetry; the energy oscillates by
/// O(stepᵖ) and does not drift; for Lagrange's top also L along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeavySplitting<D, K> {
    drift: D,
    kick: K,
    order: Order,
}

impl<D, K> HeavySplitting<D, K> {
    /// With this free motion and this torque.
    pub const fn new(drift: D, kick: K, order: Order) -> Self {
        Self { drift, kick, order }
    }

    fn run<T: Real, const N: usize>(
        &self,
        splitting: &Splitting<N>,
        run: &mut Run<T>,
        step: T,
        steps: u64,
    ) -> Result<u64>
    where
        D: Drift<T>,
        K: Kick<T>,
    {
        if steps == 0 {
            return Ok(0);
        }
        let outer = splitting.outer.map(|c| T::from_double(c) * step);
        let inner = splitting.inner.map(|c| T::from_double(c) * step);
        let joint = T::from_double(2.0) * outer[0];
        run.push(self.kick.change(&run.phase(), outer[0]));
        for left in (0..steps).rev() {
            for n in 0..N {
                self.drift.drift(run, inner[n])?;
                let next = if n + 1 < N {
                    outer[n + 1]
                } else if left > 0 {
                    joint
                } else {
                    outer[0]
                };
                run.push(self.kick.change(&run.phase(), next));
            }
        }
        Ok(steps * N as u64 * self.drift.evaluations())
    }
}

impl<T: Real, D: Drift<T>, K: Kick<T>> Integrator<T> for HeavySplitting<D, K> {
    fn name(&self) -> String {
        let order = Integrator::<T>::order(self);
        format!("kick and {} {order}", self.drift.name())
    }

    fn order(&self) -> u32 {
        let order = self.order.number();
        self.drift.order().map_or(order, |own| own.min(order))
    }

    fn advance(&self, phase: &mut Phase<T>, step: T, steps: u64) -> Result<Cost> {
        checked_run(phase, step)?;
        let mut run = Run::new(phase);
        let evaluations = match (self.order, K::OF_ATTITUDE_ALONE) {
            (Order::Two, _) => self.run(&STRANG, &mut run, step, steps),
            (Order::Four, true) => self.run(&NYSTROM_6, &mut run, step, steps),
            (Order::Six, true) => self.run(&NYSTROM_11, &mut run, step, steps),
            (Order::Four, false) => self.run(&S6, &mut run, step, steps),
            (Order::Six, false) => self.run(&S10, &mut run, step, steps),
        }?;
        run.settle(phase)?;
        Ok(Cost { evaluations, steps })
    }
}
