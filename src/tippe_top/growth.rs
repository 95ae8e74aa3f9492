//! Does a small tilt grow? Quasi-steady sliding states and the eigenvalues about them.

use nalgebra::{Complex, Matrix6, SMatrix, Vector3, Vector4, Vector6};

use super::body::ConvexBody;
use super::equations::Table;
use super::friction::{Smooth, Traction};
use crate::error::{Error, Result, finite, positive};
use crate::frame::BodyVector;

/// An eigenvalue (1/s): the perturbation grows with `growth` and turns with `frequency` in the body's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate {
    /// Real part, 1/s.
    pub growth: f64,
    /// Imaginary part, rad/s.
    pub frequency: f64,
}

/// A state that is at rest in the body's axes but for a slow loss of spin: the body spins about the vertical, and C circles.
#[derive(Debug, Clone, Copy)]
pub struct QuasiSteady<F> {
    table: Table<F, Smooth>,
    up: Vector3<f64>,
    across: [Vector3<f64>; 2],
    level: [f64; 2],
    spin: f64,
}

/// The quasi-steady sliding state at `spin` (rad/s about the vertical) with the third axis nearly upright.
///
/// Unknown are the vertical in the body (two numbers) and the velocity of C in the body's axes (two); required is that neither
/// they nor the level part of Ω change. Newton's method from rest. Error: residuals of rounding, about 1e-12 relative. Cost: some ten
/// Jacobians of 4 × 4, microseconds.
///
/// # Errors
/// [`Error::NotFinite`], [`Error::NotPositive`]; [`Error::Condition`] where Newton's method finds no such state.
pub fn quasi_steady<F: Traction>(
    body: &ConvexBody,
    gravity: f64,
    friction: F,
    spin: f64,
) -> Result<QuasiSteady<F>> {
    let gravity = positive("gravity", gravity)?;
    let spin = finite("the spin", spin)?;
    let table = Table {
        body: *body,
        gravity,
        friction,
        resistance: Smooth,
    };
    let speed = body.speed_scale(gravity);
    let rate = speed / body.surface.size();
    let across = [Vector3::x(), Vector3::y()];
    // Unknown over their scales: vertical components, then velocity of C.
    let state = |x: &Vector4<f64>| {
        let height = (1.0 - x[0] * x[0] - x[1] * x[1]).max(0.0).sqrt();
        let up = Vector3::new(x[0], x[1], height);
        let level = tangent(&up, [x[2] * speed, x[3] * speed]);
        (up, level)
    };
    let residual = |x: &Vector4<f64>| {
        let (up, level) = state(x);
        let omega = up * spin;
        let contact = table.sliding(&up, &omega, &level);
        let push = contact.traction * (contact.reaction / body.mass);
        let drift = push - omega.cross(&level);
        let turn = contact.omega_rate - up * up.dot(&contact.omega_rate);
        Vector4::new(turn.x, turn.y, drift.x / body.surface.size(), drift.y / body.surface.size())
            / (rate * rate)
    };
    let sharp = (friction.sharpness() / speed).min(1.0);
    let strides = Vector4::new(1.0, 1.0, 1.0, 1.0) * (1e-4 * sharp * (rate / spin.abs()).min(1.0));
    let mut x = Vector4::zeros();
    for _ in 0..60 {
        let value = residual(&x);
        let jacobian = SMatrix::<f64, 4, 4>::from_columns(&core::array::from_fn::<_, 4, _>(|i| {
            let mut shift = Vector4::zeros();
            shift[i] = strides[i];
            (residual(&(x + shift)) - residual(&(x - shift))) / (2.0 * strides[i])
        }));
        let Some(step) = jacobian.lu().solve(&value) else {
            break;
        };
        // A step over more than the bend of the friction law would not be one of Newton's.
        let longest = step[2].hypot(step[3]) / (3.0 * sharp) + step[0].hypot(step[1]) / 0.1;
        x -= step / longest.max(1.0);
        if step.amax() <= 1e-13 * x.amax().max(1e-3) {
            let (up, level) = state(&x);
            let level = [level.x, level.y];
            return Ok(QuasiSteady {
                table,
                up,
                across,
                level,
                spin,
            });
        }
    }
    Err(Error::Condition {
        condition: "a quasi-steady state with the third axis nearly upright must exist at this spin",
        value: spin,
    })
}

/// The level vector with these first two components.
fn tangent(up: &Vector3<f64>, [a, b]: [f64; 2]) -> Vector3<f64> {
    Vector3::new(a, b, -(up.x * a + up.y * b) / up.z)
}

impl<F: Traction> QuasiSteady<F> {
    /// The vertical in the body's axes.
    pub const fn up(&self) -> BodyVector {
        BodyVector::from_components(self.up)
    }

    /// Tilt of the third axis, rad.
    pub fn tilt(&self) -> f64 {
        self.up.x.hypot(self.up.y).atan2(self.up.z)
    }

    /// Slip of the point in contact, m/s.
    pub fn slip(&self) -> f64 {
        let level = tangent(&self.up, self.level);
        let omega = self.up * self.spin;
        self.table.sliding(&self.up, &omega, &level).slip.norm()
    }

    /// The rate at which the spin changes in this state, rad/s².
    pub fn spin_rate(&self) -> f64 {
        let level = tangent(&self.up, self.level);
        let omega = self.up * self.spin;
        let contact = self.table.sliding(&self.up, &omega, &level);
        self.up.dot(&contact.omega_rate)
    }

    /// The six eigenvalues of small perturbations in the body's axes, the fastest growing first: 1/s.
    ///
    /// Coordinates: two of the vertical, two of Ω across the third axis, two of the velocity of C; the spin is frozen. The Jacobian is
    /// taken by differences of fourth order over 2% of what bends the law: relative error about 1e-7 in the fastest rates. Observed
    /// against steps a factor 2 apart: 1e-6 of √(g/R) at ε = 10⁻³ √(gR).
    ///
    /// # Errors
    /// [`Error::Condition`] if the eigenvalues cannot be found.
    pub fn growth_rates(&self) -> Result<[Rate; 6]> {
        let body = &self.table.body;
        let speed = body.speed_scale(self.table.gravity);
        let size = body.surface.size();
        let rate = |x: &Vector6<f64>| {
            let height = (1.0 - x[0] * x[0] - x[1] * x[1]).max(0.0).sqrt();
            let up = Vector3::new(x[0], x[1], height);
            let omega = Vector3::new(x[2], x[3], self.spin * self.up.z);
            let level = tangent(&up, [x[4], x[5]]);
            let contact = self.table.sliding(&up, &omega, &level);
            let turn = up.cross(&omega);
            // V minus its vertical part, seen from the body.
            let drift = contact.traction * (contact.reaction / body.mass) - omega.cross(&level);
            let omega_rate = contact.omega_rate;
            Vector6::new(turn.x, turn.y, omega_rate.x, omega_rate.y, drift.x, drift.y)
        };
        let sharp = self.table.friction.sharpness().min(speed);
        let swing = self.spin.abs() * size;
        let [v, w] = [0.02 * sharp, 0.02 * sharp / size];
        let n = (0.02 * sharp / swing).min(1e-3);
        let strides = [n, n, w, w, v, v];
        let omega = self.up * self.spin;
        let x = Vector6::new(
            self.up.x,
            self.up.y,
            omega.x,
            omega.y,
            self.level[0],
            self.level[1],
        );
        let columns: [Vector6<f64>; 6] = core::array::from_fn(|i| {
            let at = |factor: f64| {
                let mut moved = x;
                moved[i] += factor * strides[i];
                rate(&moved)
            };
            let near = (at(1.0) - at(-1.0)) * 8.0;
            (near - (at(2.0) - at(-2.0))) / (12.0 * strides[i])
        });
        // Each coordinate over its scale, so that the eigenvalue solver sees numbers of one size.
        let scales = Vector6::new(1.0, 1.0, self.spin.abs(), self.spin.abs(), swing, swing);
        let jacobian = Matrix6::from_fn(|i, j| columns[j][i] * scales[j] / scales[i]);
        eigenvalues(jacobian)
    }
}

fn eigenvalues(jacobian: Matrix6<f64>) -> Result<[Rate; 6]> {
    let refusal = Error::Condition {
        condition: "the linearised equations must have finite eigenvalues",
        value: jacobian.sum(),
    };
    if !jacobian.iter().all(|x| x.is_finite()) {
        return Err(refusal);
    }
    let values: [Complex<f64>; 6] = jacobian.complex_eigenvalues().into();
    let mut rates = values.map(|value| Rate {
        growth: value.re,
        frequency: value.im,
    });
    rates.sort_by(|a, b| b.growth.total_cmp(&a.growth));
    Ok(rates)
}

/// The eigenvalues (1/s) of pure rolling about steady spin round the third axis, which must be vertical-steady: CK along it and the
/// vertical a symmetric direction of surface and inertia (rattleback, celt-ended tops). Fastest growing first.
///
/// Coordinates: two of the vertical, two of Ω across the third axis. Differences of fourth order; error about 1e-9 relative.
///
/// # Errors
/// [`Error::Condition`] if spin about the third axis is not steady, or the eigenvalues cannot be found.
pub fn rolling_growth_rates(body: &ConvexBody, gravity: f64, spin: f64) -> Result<[Rate; 4]> {
    let table = Table {
        body: *body,
        gravity: positive("gravity", gravity)?,
        friction: Smooth,
        resistance: Smooth,
    };
    let spin = finite("the spin", spin)?;
    let rate = |x: &Vector4<f64>| {
        let height = (1.0 - x[0] * x[0] - x[1] * x[1]).max(0.0).sqrt();
        let up = Vector3::new(x[0], x[1], height);
        let omega = Vector3::new(x[2], x[3], spin);
        let contact = table.rolling(&up, &omega);
        let turn = up.cross(&omega);
        Vector4::new(turn.x, turn.y, contact.omega_rate.x, contact.omega_rate.y)
    };
    let natural = body.speed_scale(gravity) / body.surface.size();
    let drift = rate(&Vector4::zeros()).amax();
    if !(drift <= 1e-12 * (natural * natural + spin * spin)) {
        return Err(Error::Condition {
            condition: "spin about the third axis must be steady in pure rolling",
            value: drift,
        });
    }
    let turn = natural.max(spin.abs());
    let strides = [1e-3, 1e-3, 1e-3 * turn, 1e-3 * turn];
    let columns: [Vector4<f64>; 4] = core::array::from_fn(|i| {
        let at = |factor: f64| {
            let mut moved = Vector4::zeros();
            moved[i] = factor * strides[i];
            rate(&moved)
        };
        let near = (at(1.0) - at(-1.0)) * 8.0;
        (near - (at(2.0) - at(-2.0))) / (12.0 * strides[i])
    });
    let scales = [1.0, 1.0, turn, turn];
    let jacobian = SMatrix::<f64, 4, 4>::from_fn(|i, j| columns[j][i] * scales[j] / scales[i]);
    let values: [Complex<f64>; 4] = jacobian.complex_eigenvalues().into();
    let mut rates = values.map(|value| Rate {
        growth: value.re,
        frequency: value.im,
    });
    if rates.iter().any(|rate| !rate.growth.is_finite()) {
        return Err(Error::Condition {
            condition: "the linearised equations must have finite eigenvalues",
            value: jacobian.sum(),
        });
    }
    rates.sort_by(|a, b| b.growth.total_cmp(&a.growth));
    Ok(rates)
}
