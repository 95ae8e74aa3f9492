//! Whether a small tilt grows: quasi-steady sliding states and the eigenvalues about them.

use nalgebra::{Complex, DMatrix, SMatrix, SVector, Schur, Vector3, Vector4};

use super::body::ConvexBody;
use super::equations::{Pose, Table};
use super::friction::Friction;
use crate::error::{Result, finite, positive, refused};

/// An eigenvalue (1/s): the perturbation grows with `growth` and turns with `frequency` in the body's axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rate {
    /// Real part, 1/s.
    pub growth: f64,
    /// Imaginary part, rad/s.
    pub frequency: f64,
}

/// A state that is constant in the body's axes except for a slow loss of spin: the body spins about the vertical, and C goes round a circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuasiSteady {
    /// Tilt of the third axis, rad.
    pub tilt: f64,
    /// The rate at which the spin changes in this state, rad/s².
    pub spin_rate: f64,
    /// The eigenvalues of small perturbations in the body's axes, the fastest growing first (1/s): three pairs, of slip, nutation and
    /// slow swing. The seventh, the smallest, is the loss of spin itself and is left out.
    ///
    /// Since the state drifts as it loses spin, its rates depend on the choice of coordinates by about the relative rate of that loss,
    /// which is of first order in friction and the same for both senses. The coordinates used are two of the vertical, Ω, and two of the velocity of C. The Jacobian is taken by differences of fourth order over 2% of
    /// the law's slip scale: error observed over a hundred round tops, against 34 digits, 2e-7 of the fastest rate.
    pub growth_rates: [Rate; 6],
    /// The slow swing, the pair of eigenvalues with the least frequency: its growth tells whether a tippe top begins to turn over.
    pub slow_swing: Rate,
}

/// The quasi-steady sliding state at `spin` (rad/s about the vertical) with the third axis nearly upright.
///
/// The unknowns are the vertical in the body (two numbers) and the velocity of C in the body's axes (two); neither
/// they nor the level part of Ω may change. Solved by Newton's method, from the state without friction to the full law in eight steps. Error:
/// residuals of rounding, about 1e-12 relative. Cost: some fifty Jacobians of 4 × 4, a fraction of a millisecond.
///
/// # Errors
/// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::NotPositive`](crate::Error::NotPositive) for gravity, and for unsmoothed Coulomb friction and pure rolling, which have no derivative;
/// [`Error::Condition`](crate::Error::Condition) where Newton's method finds no such state or its eigenvalues cannot be found, as without spin.
///
/// ```
/// use spinning_bodies::tippe_top::{Regularised, bodies, quasi_steady};
/// let state = quasi_steady(&bodies::tippe_top()?, 9.81, Regularised::new(0.3, 1e-3)?, 150.0)?;
/// // A round top can stand upright.
/// assert!(state.tilt < 1e-9);
/// // The chiral one leans slightly and loses spin by friction; the fastest growing pair comes first.
/// let state = quasi_steady(&bodies::chiral_top()?, 9.81, Regularised::new(0.3, 1e-3)?, 150.0)?;
/// assert!(state.tilt > 0.0 && state.tilt < 0.2);
/// assert!(state.spin_rate < 0.0 && state.growth_rates[0].growth >= state.growth_rates[5].growth);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn quasi_steady(
    body: &ConvexBody,
    gravity: f64,
    friction: impl Into<Friction>,
    spin: f64,
) -> Result<QuasiSteady> {
    let friction = friction.into();
    // Zero for a law without a derivative, infinite for a linear one.
    let bends = friction.sharpness().min(f64::MAX);
    positive("the slip over which friction bends", bends)?;
    let mut table = Table::new(*body, positive("gravity", gravity)?);
    let spin = finite("the spin", spin)?;
    let mut x = Vector4::zeros();
    for part in 0..=8 {
        table.friction = Some(friction.weakened(f64::from(part) / 8.0));
        x = newton(&table, bends, spin, x)?;
    }
    let pose = steady(&table, spin, &x);
    let up = pose.up;
    let [_, turning, _] = table.drift(&pose, &table.slides(&pose));
    let growth_rates = growth_rates(&table, bends, spin, &pose)?;
    let mut slowest = growth_rates;
    slowest.sort_by(|a, b| a.frequency.abs().total_cmp(&b.frequency.abs()));
    Ok(QuasiSteady {
        tilt: up.x.hypot(up.y).atan2(up.z),
        spin_rate: up.dot(&turning),
        growth_rates,
        slow_swing: slowest[0],
    })
}

/// The state with these unknowns: two components of the vertical, and two of the velocity over √(gR).
fn steady(table: &Table, spin: f64, x: &Vector4<f64>) -> Pose {
    let speed = table.body.speed_scale(table.gravity);
    let up = upright(x[0], x[1]);
    let level = tangent(&up, [x[2] * speed, x[3] * speed]);
    Pose::seen(up, up * spin, level)
}

/// `bends` is the slip over which friction bends, m/s.
fn newton(table: &Table, bends: f64, spin: f64, start: Vector4<f64>) -> Result<Vector4<f64>> {
    let size = table.body.surface.size;
    let speed = table.body.speed_scale(table.gravity);
    let rate = speed / size;
    let residual = |x: &Vector4<f64>| {
        let pose = steady(table, spin, x);
        let [_, turning, drift] = table.drift(&pose, &table.slides(&pose));
        let (turn, drift) = (turning - pose.up * pose.up.dot(&turning), drift / size);
        Vector4::new(turn.x, turn.y, drift.x, drift.y) / (rate * rate)
    };
    let sharp = (bends / speed).min(1.0);
    let stride = 1e-4 * sharp * (rate / spin.abs()).min(1.0);
    let mut x = start;
    let mut value = residual(&x);
    for _ in 0..60 {
        let jacobian = jacobian(residual, x, [stride; 4], [1.0; 4])?;
        let Some(step) = jacobian.lu().solve(&value) else {
            break;
        };
        if step.amax() <= 1e-11 * x.amax().max(1e-2) {
            return Ok(x - step);
        }
        // A shorter step where the whole one does not reduce the residual.
        let mut part = 1.0;
        loop {
            let next = x - step * part;
            let there = residual(&next);
            if there.norm() < value.norm() || part < 1e-6 {
                (x, value) = (next, there);
                break;
            }
            part *= 0.5;
        }
    }
    let condition =
        "a quasi-steady state with the third axis nearly upright must exist at this spin";
    refused(condition, spin)
}

/// The unit vector with these components that points upward.
fn upright(x: f64, y: f64) -> Vector3<f64> {
    Vector3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt())
}

/// The level vector with these first two components.
fn tangent(up: &Vector3<f64>, [a, b]: [f64; 2]) -> Vector3<f64> {
    Vector3::new(a, b, -(up.x * a + up.y * b) / up.z)
}

/// The tilt over which the support map of an upright body bends: small for one that lies flat.
fn bend(body: &ConvexBody) -> f64 {
    let up = Vector3::z();
    body.surface.support(&up).dot(&up) / body.surface.greatest()
}

/// See [`QuasiSteady::growth_rates`].
fn growth_rates(table: &Table, bends: f64, spin: f64, steady: &Pose) -> Result<[Rate; 6]> {
    let body = &table.body;
    let speed = body.speed_scale(table.gravity);
    let size = body.surface.size;
    let rate = |x: &SVector<f64, 7>| {
        let up = upright(x[0], x[1]);
        let omega = Vector3::new(x[2], x[3], x[4]);
        let level = tangent(&up, [x[5], x[6]]);
        let pose = Pose::seen(up, omega, level);
        let [turn, r, drift] = table.drift(&pose, &table.slides(&pose));
        SVector::from([turn.x, turn.y, r.x, r.y, r.z, drift.x, drift.y])
    };
    let sharp = bends.min(speed);
    let swing = spin.abs() * size;
    let [v, w] = [0.02 * sharp, 0.02 * sharp / size];
    let n = (0.02 * sharp / (spin.abs() * body.surface.greatest())).min(1e-3) * bend(body);
    let (up, w0, v0) = (steady.up, steady.omega, steady.level);
    let x = SVector::from([up.x, up.y, w0.x, w0.y, w0.z, v0.x, v0.y]);
    let turn = spin.abs();
    let scales = [1.0, 1.0, turn, turn, turn, swing, swing];
    let jacobian = jacobian(rate, x, [n, n, w, w, w, v, v], scales)?;
    let mut values: [Complex<f64>; 7] = eigenvalues(&jacobian)?;
    values.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    let [_, rest @ ..] = values;
    Ok(fastest_first(rest))
}

/// Most sweeps of the QR iteration; it needs some ten.
const MOST_SWEEPS: usize = 1000;

/// The eigenvalues of a matrix, by an iteration that may stall where several have the same modulus, ±a ± ib, as for an egg of revolution. Then the matrix
/// is mirrored in an oblique plane, which leaves them as they are; where that stalls as well, they are refused.
fn eigenvalues<const N: usize>(matrix: &SMatrix<f64, N, N>) -> Result<[Complex<f64>; N]> {
    // Of any size, which is compiled once.
    let matrix = DMatrix::from_column_slice(N, N, matrix.as_slice());
    let found = |matrix: DMatrix<f64>| {
        let schur = Schur::try_new(matrix, f64::EPSILON, MOST_SWEEPS)?;
        <[_; N]>::try_from(schur.complex_eigenvalues().as_slice()).ok()
    };
    let mirrored = |matrix: &DMatrix<f64>| {
        let normal = DMatrix::from_fn(N, 1, |i, _| 1.0 / (1.0 + i as f64));
        let square = normal.norm_squared();
        let mirror = DMatrix::identity(N, N) - &normal * normal.transpose() * (2.0 / square);
        &mirror * matrix * &mirror
    };
    let values = found(matrix.clone()).or_else(|| found(mirrored(&matrix)));
    // Their squares may leave the range of doubles where the matrix does not.
    let values = values.filter(|values| values.iter().all(|value| value.is_finite()));
    let condition = "the eigenvalues of the linearised equations must be found, of size";
    values.map_or_else(|| refused(condition, matrix.amax()), Ok)
}

/// These eigenvalues, the fastest growing first.
fn fastest_first<const N: usize>(mut values: [Complex<f64>; N]) -> [Rate; N] {
    values.sort_by(|a, b| b.re.total_cmp(&a.re));
    values.map(|Complex { re, im }| Rate {
        growth: re,
        frequency: im,
    })
}

/// The Jacobian by differences of fourth order, each coordinate divided by its scale, so that the eigenvalue solver gets numbers of similar magnitude.
fn jacobian<const N: usize>(
    rate: impl Fn(&SVector<f64, N>) -> SVector<f64, N>,
    x: SVector<f64, N>,
    strides: [f64; N],
    scales: [f64; N],
) -> Result<SMatrix<f64, N, N>> {
    let columns: [SVector<f64, N>; N] = core::array::from_fn(|i| {
        let at = |factor: f64| {
            let mut moved = x;
            moved[i] += factor * strides[i];
            rate(&moved)
        };
        let near = (at(1.0) - at(-1.0)) * 8.0;
        (near - (at(2.0) - at(-2.0))) / (12.0 * strides[i])
    });
    let matrix = SMatrix::<f64, N, N>::from_fn(|i, j| columns[j][i] * scales[j] / scales[i]);
    if !matrix.iter().all(|x| x.is_finite()) {
        return refused("the linearised equations must be finite", matrix.sum());
    }
    Ok(matrix)
}

/// The eigenvalues (1/s) of pure rolling about steady spin round the vertical third axis, the fastest growing first. That spin must be steady: CK
/// must lie along the third axis, and that must be a symmetric direction of surface and inertia (rattleback, celt-ended tops).
///
/// Coordinates: two of the vertical, two of Ω across the third axis. Differences of fourth order; error observed over 90 bodies, up to a thousand times as long as
/// high, against 34 digits: 1e-10 relative.
///
/// # Errors
/// [`Error::Condition`](crate::Error::Condition) if spin about the third axis is not steady, or the eigenvalues cannot be found.
///
/// ```
/// use spinning_bodies::tippe_top::{bodies, rolling_growth_rates};
/// // The rattleback is stable for one sense of spin, unstable for the other.
/// let stone = bodies::rattleback()?;
/// let [one, other] = [5.0, -5.0].map(|spin| rolling_growth_rates(&stone, 9.81, spin).map(|rates| rates[0].growth));
/// assert!(one? != other?);
/// // In 34 digits, though its surface is ten times as long as high.
/// let fast = rolling_growth_rates(&stone, 9.81, -50.0)?;
/// assert!((fast[0].growth / 19.5553354660581 - 1.0).abs() < 1e-9);
/// // An egg on its end falls, as e to the 2.84 t.
/// let egg = rolling_growth_rates(&bodies::egg(1.0, 1.0, 0.1)?, 9.81, -1.0)?;
/// assert!((egg[0].growth - 2.8425).abs() < 1e-4 && egg[3].growth < -2.8);
/// // Its mass does not matter.
/// let heavy = rolling_growth_rates(&bodies::egg(2f64.powi(900), 1.0, 0.1)?, 9.81, -1.0)?;
/// assert_eq!(heavy[0].growth, egg[0].growth);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn rolling_growth_rates(body: &ConvexBody, gravity: f64, spin: f64) -> Result<[Rate; 4]> {
    let table = Table::new(*body, positive("gravity", gravity)?);
    let spin = finite("the spin", spin)?;
    let rate = |x: &Vector4<f64>| {
        let up = upright(x[0], x[1]);
        let omega = Vector3::new(x[2], x[3], spin);
        let pose = Pose::seen(up, omega, Vector3::zeros());
        let [turn, r, _] = table.drift(&pose, &table.rolls(&pose));
        Vector4::new(turn.x, turn.y, r.x, r.y)
    };
    let natural = body.speed_scale(gravity) / body.surface.size;
    let drift = rate(&Vector4::zeros()).amax();
    let rounding = 1e-12 * (natural * natural + spin * spin);
    if drift.is_nan() || drift > rounding {
        let condition = "spin about the third axis must be steady in pure rolling";
        return refused(condition, drift);
    }
    let turn = natural.max(spin.abs());
    let tilt = 5e-4 * bend(body);
    let strides = [tilt, tilt, 1e-3 * turn, 1e-3 * turn];
    let jacobian = jacobian(rate, Vector4::zeros(), strides, [1.0, 1.0, turn, turn])?;
    Ok(fastest_first(eigenvalues(&jacobian)?))
}
