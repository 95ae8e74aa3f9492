//! A top under gravity about a fixed point, and the question which tops have a further integral (tutorial 5.3, 8.1, 8.2).

use super::{AxisMoments, rate, runge_kutta};
use crate::error::{Result, finite, out_of_range, positive};
use crate::frame::{BodyVector, finite_vector};

/// A top with a fixed point O under uniform gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeavyTop {
    pub(crate) moments: AxisMoments,
    pub(crate) lever: BodyVector,
    kind: Integrability,
}

/// Angular velocity and the upward unit vector z, both along the body's axes: all that the equations of motion need.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopState {
    /// Ω, rad/s.
    pub omega: BodyVector,
    /// z, the vertical, a unit vector.
    pub up: BodyVector,
}

/// Whether a heavy top has an integral besides energy and L_vert (5.3).
///
/// The theorem of 5.3, *quoted and not proved here*, says that the first four kinds are all that have one for every initial
/// condition. The fifth has one for some.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Integrability {
    /// C = O: gravity has no torque. |L|² is conserved.
    Euler,
    /// I₁ = I₂ = I₃ with any C: L·C is conserved. Lagrange's top in disguise, since any axis is principal.
    SphericalInertia,
    /// Two moments equal, C on the axis of the third (given by its number, 0 to 2): L along that axis is conserved.
    Lagrange(usize),
    /// Two moments equal to twice the third, C at right angles to the third axis: Kovalevskaya's integral (8.2).
    Kovalevskaya(usize),
    /// Two moments equal to four times the third, C at right angles to the third axis: Goryachev's and Chaplygin's
    /// integral, conserved if L_vert = 0 and only then.
    GoryachevChaplygin(usize),
    /// No further integral.
    None,
}

/// A further integral: its value, and how fast it changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral {
    /// Its value; the unit depends on the kind.
    pub value: f64,
    /// Its rate of change by the formula of 5.3, not by differencing: zero, except on [`Integrability::GoryachevChaplygin`],
    /// where it is −(Mg/4I₃²)(C₁Ω₂ − C₂Ω₁)·L_vert.
    pub rate: f64,
}

impl HeavyTop {
    /// The top with these moments about O (kg m²), along principal axes, and the lever MgC (N m), C the centre of mass seen from O.
    ///
    /// The kind is decided here, by exact equality: a top whose moments miss Kovalevskaya's ratio by one ulp is not one of hers.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for the lever.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, Integrability}, frame::BodyVector};
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(0.0, 0.0, 3.0))?;
    /// assert_eq!(top.kind(), Integrability::Lagrange(2));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: AxisMoments, lever: BodyVector) -> Result<Self> {
        finite_vector("the lever MgC", lever)?;
        Ok(Self {
            moments,
            lever,
            kind: classify(moments.values(), lever),
        })
    }

    /// The further integral that the top has, if any.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, Integrability}, frame::BodyVector};
    /// // Two moments twice the third, and C at right angles to its axis: Kovalevskaya's top.
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(3.0, 0.0, 0.0))?;
    /// assert_eq!(top.kind(), Integrability::Kovalevskaya(2));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn kind(&self) -> Integrability {
        self.kind
    }

    /// The rates ∂Ω/∂t and ∂z/∂t: Euler's equations with N = z∧MgC, and ∂z/∂t = z∧Ω (5.1, 8.1).
    ///
    /// Cost: [`rate`] and two vector products. No errors.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, TopState}, frame::BodyVector};
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(0.0, 0.0, 3.0))?;
    /// let state = TopState { omega: BodyVector::new(1.0, 0.0, 2.0), up: BodyVector::new(0.6, 0.0, 0.8) };
    /// // z' = z ∧ Ω.
    /// assert!((top.rate(&state).up - BodyVector::new(0.0, 0.8 - 1.2, 0.0)).norm() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn rate(&self, state: &TopState) -> TopState {
        TopState {
            omega: rate(&self.moments, state.omega, state.up.cross(&self.lever)),
            up: state.up.cross(&state.omega),
        }
    }

    /// The state one step of `step` seconds later, by the classical Runge–Kutta method.
    ///
    /// Error O(step⁵) a step. The method keeps no invariant by construction, so their drift measures its error. Cost: four [`rate`](Self::rate)s.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, TopState}, frame::BodyVector};
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(0.0, 0.0, 3.0))?;
    /// let state = TopState { omega: BodyVector::new(1.0, 0.0, 2.0), up: BodyVector::new(0.6, 0.0, 0.8) };
    /// let later = top.step(&state, 1e-3);
    /// assert!((top.energy(&later) - top.energy(&state)).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn step(&self, state: &TopState, step: f64) -> TopState {
        unpack(&runge_kutta(|y| self.packed_rate(y), &pack(state), step))
    }

    fn packed_rate(&self, y: &[f64; 6]) -> [f64; 6] {
        pack(&self.rate(&unpack(y)))
    }

    /// Energy ½⟨IΩ, Ω⟩ + ⟨MgC, z⟩, J.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, TopState}, frame::BodyVector};
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(0.0, 0.0, 3.0))?;
    /// let state = TopState { omega: BodyVector::new(1.0, 0.0, 2.0), up: BodyVector::new(0.6, 0.0, 0.8) };
    /// // ½(2·1 + 1·4) + 3·0.8.
    /// assert!((top.energy(&state) - 5.4).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy(&self, state: &TopState) -> f64 {
        self.moments.energy(state.omega) + self.lever.dot(&state.up)
    }

    /// L_vert = ⟨IΩ, z⟩, kg m²/s: gravity has no torque about the vertical.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, TopState}, frame::BodyVector};
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(0.0, 0.0, 3.0))?;
    /// let state = TopState { omega: BodyVector::new(1.0, 0.0, 2.0), up: BodyVector::new(0.6, 0.0, 0.8) };
    /// // 2·0.6 + 2·0.8.
    /// assert!((top.vertical_angular_momentum(&state) - 2.8).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn vertical_angular_momentum(&self, state: &TopState) -> f64 {
        self.moments.angular_momentum(state.omega).dot(&state.up)
    }

    /// The further integral of the top's kind and its rate, or `None` (5.3).
    ///
    /// Euler |L|²; spherical inertia ⟨L, MgC⟩; Lagrange L₃; Kovalevskaya |w² − cζ|² with w = Ω₁+iΩ₂, ζ = z₁+iz₂,
    /// c = Mg(C₁+iC₂)/I₃; Goryachev–Chaplygin Ω₃(Ω₁²+Ω₂²) − (Mg/I₃)(C₁Ω₁+C₂Ω₂)z₃. The axis called 3 is the
    /// one that [`Integrability`] names. Cost: a few multiplications.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, TopState}, frame::BodyVector};
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(0.0, 0.0, 3.0))?;
    /// let state = TopState { omega: BodyVector::new(1.0, 0.0, 2.0), up: BodyVector::new(0.6, 0.0, 0.8) };
    /// // Lagrange's: L₃, at rest.
    /// let integral = top.further_integral(&state).unwrap();
    /// assert_eq!((integral.value, integral.rate), (2.0, 0.0));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn further_integral(&self, state: &TopState) -> Option<Integral> {
        let l = self.moments.angular_momentum(state.omega);
        let kept = |value| Some(Integral { value, rate: 0.0 });
        match self.kind {
            Integrability::Euler => kept(l.dot(&l)),
            Integrability::SphericalInertia => kept(l.dot(&self.lever)),
            Integrability::Lagrange(axis) => kept(l.components()[axis]),
            Integrability::Kovalevskaya(axis) => {
                let [re, im] = self.kovalevskaya(state, axis);
                kept(re * re + im * im)
            }
            Integrability::GoryachevChaplygin(axis) => {
                let [o1, o2, o3] = turned(state.omega, axis);
                let [_, _, z3] = turned(state.up, axis);
                let moment = self.moments.values()[axis];
                let [c1, c2, _] = turned(self.lever, axis).map(|c| c / moment);
                Some(Integral {
                    value: o3 * (o1 * o1 + o2 * o2) - (c1 * o1 + c2 * o2) * z3,
                    rate: -0.25
                        * (c1 * o2 - c2 * o1)
                        * (self.vertical_angular_momentum(state) / moment),
                })
            }
            Integrability::None => None,
        }
    }

    /// w² − cζ of Kovalevskaya's top, real and imaginary part; `axis` is its third axis.
    pub(crate) fn kovalevskaya(&self, state: &TopState, axis: usize) -> [f64; 2] {
        let moment = self.moments.values()[axis];
        let [o1, o2, _] = turned(state.omega, axis);
        let [z1, z2, _] = turned(state.up, axis);
        let [c1, c2, _] = turned(self.lever, axis).map(|c| c / moment);
        let re = o1 * o1 - o2 * o2 - (c1 * z1 - c2 * z2);
        [re, 2.0 * o1 * o2 - (c1 * z2 + c2 * z1)]
    }

    /// Largest Lyapunov exponent over `duration` seconds, 1/s: the mean rate at which a neighbouring motion departs (5.3).
    ///
    /// (1/T) Σ ln(d/d₀) for a neighbour 1e-8 away, pulled back to that distance after every 50 steps; both by
    /// [`step`](Self::step). Over a finite time T a regular motion shows a value near ln T/T, not zero; and a value near
    /// that level does not prove that the top is integrable, since every top has regular motions. Observed: halving the step
    /// changes the value of a chaotic motion by up to 40 per cent, for it follows another orbit. Cost: 8·`duration`/`step` rates.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for duration or step, [`Error::NotFinite`](crate::Error::NotFinite) for the start or if the motion is lost,
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for more than 10⁹ steps.
    ///
    /// ```
    /// use spinning_bodies::{euler_equations::{AxisMoments, HeavyTop, TopState}, frame::BodyVector};
    /// let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, BodyVector::new(0.0, 0.0, 3.0))?;
    /// let state = TopState { omega: BodyVector::new(1.0, 0.0, 2.0), up: BodyVector::new(0.6, 0.0, 0.8) };
    /// // A regular motion: neighbours separate in proportion to the time, and the mean rate is small.
    /// assert!(top.lyapunov_exponent(&state, 50.0, 0.01)? < 0.2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn lyapunov_exponent(&self, start: &TopState, duration: f64, step: f64) -> Result<f64> {
        positive("the duration", duration)?;
        positive("the step", step)?;
        finite_vector("the angular velocity", start.omega)?;
        finite_vector("the vertical", start.up)?;
        let steps = (duration / step).round();
        if !(1.0..=1e9).contains(&steps) {
            return Err(out_of_range("the number of steps", steps, [1.0, 1e9]));
        }
        const APART: f64 = 1e-8;
        let mut y = pack(start);
        let mut neighbour = y;
        neighbour[0] += APART;
        let mut sum = 0.0;
        let advance = |y: &[f64; 6]| runge_kutta(|y| self.packed_rate(y), y, step);
        for n in 1..=steps as u64 {
            y = advance(&y);
            neighbour = advance(&neighbour);
            if n % 50 == 0 || n == steps as u64 {
                let gap: [f64; 6] = core::array::from_fn(|i| neighbour[i] - y[i]);
                let distance = gap.iter().map(|g| g * g).sum::<f64>().sqrt();
                sum += (distance / APART).ln();
                finite("the distance of two neighbouring motions", sum)?;
                neighbour = core::array::from_fn(|i| y[i] + gap[i] * (APART / distance));
            }
        }
        // Divided by the time that the steps take, which differs from a duration that is no whole number of steps.
        Ok(sum / (steps * step))
    }
}

/// Components with `axis` as the third, in cyclic order.
fn turned(vector: BodyVector, axis: usize) -> [f64; 3] {
    let c = vector.components();
    [c[(axis + 1) % 3], c[(axis + 2) % 3], c[axis]]
}

fn pack(state: &TopState) -> [f64; 6] {
    let (o, z) = (state.omega, state.up);
    [o.x(), o.y(), o.z(), z.x(), z.y(), z.z()]
}

fn unpack(y: &[f64; 6]) -> TopState {
    TopState {
        omega: BodyVector::new(y[0], y[1], y[2]),
        up: BodyVector::new(y[3], y[4], y[5]),
    }
}

pub(crate) fn classify(i: [f64; 3], lever: BodyVector) -> Integrability {
    let c = lever.components();
    if c.iter().all(|&c| c == 0.0) {
        return Integrability::Euler;
    }
    if i[0] == i[1] && i[1] == i[2] {
        return Integrability::SphericalInertia;
    }
    for axis in 0..3 {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        if i[j] == i[k] {
            let (on_axis, across) = (c[j] == 0.0 && c[k] == 0.0, c[axis] == 0.0);
            // A quotient would be rounded.
            return match i[axis] {
                _ if on_axis => Integrability::Lagrange(axis),
                axial if across && i[j] == 2.0 * axial => Integrability::Kovalevskaya(axis),
                axial if across && i[j] == 4.0 * axial => Integrability::GoryachevChaplygin(axis),
                _ => Integrability::None,
            };
        }
    }
    Integrability::None
}
