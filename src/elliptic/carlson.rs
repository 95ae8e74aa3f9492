//! Carlson's symmetric integrals, by duplication in twice the precision, so that the result is rounded once.
//!
//! All sums have terms of one sign: where the usual form of R_J takes 1 + e with e near −1, the sum of the two
//! products that make it up is written out instead. Principal values are taken for a negative last argument of
//! [`rc`] and [`rj`].

use crate::double_double::DoubleDouble as Dd;
use crate::error::{Error, Result, finite, not_negative};

/// Spread of the arguments at which the series of order seven is exact to 10⁻²⁶, and its rounding to 10⁻²³.
/// A double needs less; principal values, in which two such integrals nearly cancel, need it.
const SPREAD: f64 = 5e-4;

/// Duplications after which any spread between doubles is gone.
const ROUNDS: usize = 600;

fn one() -> Dd {
    Dd::from(1.0)
}

/// R_F of arguments of which at most one is zero.
pub(super) fn first(mut x: Dd, mut y: Dd, mut z: Dd) -> Dd {
    let third = one().divide(Dd::from(3.0));
    for _ in 0..ROUNDS {
        let mean = x.add(y).add(z).multiply(third);
        let a = mean.value();
        let (dx, dy) = (mean.subtract(x).value() / a, mean.subtract(y).value() / a);
        let dz = mean.subtract(z).value() / a;
        if dx.abs().max(dy.abs()).max(dz.abs()) < SPREAD {
            let e2 = dx * dy - dz * dz;
            let e3 = dx * dy * dz;
            let series = e2
                * (-0.1 + e2 * (1.0 / 24.0 - e2 * (5.0 / 208.0) + e3 / 16.0) - e3 * (3.0 / 44.0))
                + e3 * (1.0 / 14.0 + e3 * (3.0 / 104.0));
            return one().add(Dd::from(series)).divide(mean.square_root());
        }
        let (a, b, c) = (x.square_root(), y.square_root(), z.square_root());
        let lambda = a.multiply(b.add(c)).add(b.multiply(c));
        x = x.add(lambda).scaled(0.25);
        y = y.add(lambda).scaled(0.25);
        z = z.add(lambda).scaled(0.25);
    }
    Dd::from(f64::NAN)
}

/// R_C(x, y) for x ≥ 0, y ≠ 0; the principal value for y < 0.
pub(super) fn elementary(x: Dd, y: Dd) -> Dd {
    if y.value() < 0.0 {
        let whole = x.subtract(y);
        return x
            .divide(whole)
            .square_root()
            .multiply(first(whole, y.negated(), y.negated()));
    }
    first(x, y, y)
}

/// R_J for p > 0, at most one of the others zero.
pub(super) fn third(mut x: Dd, mut y: Dd, mut z: Dd, mut p: Dd) -> Dd {
    let fifth = one().divide(Dd::from(5.0));
    let mut sum = Dd::from(0.0);
    let mut scale = 1.0;
    for _ in 0..ROUNDS {
        let mean = x.add(y).add(z).add(p.scaled(2.0)).multiply(fifth);
        let a = mean.value();
        let (dx, dy) = (mean.subtract(x).value() / a, mean.subtract(y).value() / a);
        let dz = mean.subtract(z).value() / a;
        let dp = -0.5 * (dx + dy + dz);
        if dx.abs().max(dy.abs()).max(dz.abs()) < SPREAD {
            let last = one()
                .add(Dd::from(tail(dx, dy, dz, dp)))
                .divide(mean.multiply(mean.square_root()));
            return sum.multiply(Dd::from(6.0)).add(last.scaled(scale));
        }
        let (a, b, c, r) = (
            x.square_root(),
            y.square_root(),
            z.square_root(),
            p.square_root(),
        );
        let lambda = a.multiply(b.add(c)).add(b.multiply(c));
        let d = r.add(a).multiply(r.add(b)).multiply(r.add(c));
        // 1 + e, with e the product of (r − a)/(r + a) over the three: both products summed, nothing cancels.
        let whole = r.scaled(2.0).multiply(p.add(lambda)).divide(d);
        sum = sum.add(elementary(one(), whole).divide(d).scaled(scale));
        x = x.add(lambda).scaled(0.25);
        y = y.add(lambda).scaled(0.25);
        z = z.add(lambda).scaled(0.25);
        p = p.add(lambda).scaled(0.25);
        scale *= 0.25;
    }
    Dd::from(f64::NAN)
}

/// R_D, at most one of x and y zero, z > 0.
pub(super) fn second(mut x: Dd, mut y: Dd, mut z: Dd) -> Dd {
    let fifth = one().divide(Dd::from(5.0));
    let mut sum = Dd::from(0.0);
    let mut scale = 1.0;
    for _ in 0..ROUNDS {
        let mean = x.add(y).add(z.multiply(Dd::from(3.0))).multiply(fifth);
        let a = mean.value();
        let (dx, dy) = (mean.subtract(x).value() / a, mean.subtract(y).value() / a);
        let dz = -(dx + dy) / 3.0;
        if dx.abs().max(dy.abs()).max(dz.abs()) < SPREAD {
            let last = one()
                .add(Dd::from(tail(dx, dy, dz, dz)))
                .divide(mean.multiply(mean.square_root()));
            return sum.multiply(Dd::from(3.0)).add(last.scaled(scale));
        }
        let (a, b, c) = (x.square_root(), y.square_root(), z.square_root());
        let lambda = a.multiply(b.add(c)).add(b.multiply(c));
        sum = sum.add(Dd::from(scale).divide(c.multiply(z.add(lambda))));
        x = x.add(lambda).scaled(0.25);
        y = y.add(lambda).scaled(0.25);
        z = z.add(lambda).scaled(0.25);
        scale *= 0.25;
    }
    Dd::from(f64::NAN)
}

/// The series of R_J about equal arguments, less its 1, to order seven.
fn tail(x: f64, y: f64, z: f64, p: f64) -> f64 {
    let xyz = x * y * z;
    let e2 = x * y + z * (x + y) - 3.0 * p * p;
    let e3 = xyz + 2.0 * e2 * p + 4.0 * p * p * p;
    let e4 = (2.0 * xyz + e2 * p + 3.0 * p * p * p) * p;
    let e5 = xyz * p * p;
    -3.0 / 14.0 * e2 + e3 / 6.0 + 9.0 / 88.0 * e2 * e2 - 3.0 / 22.0 * e4 - 9.0 / 52.0 * e2 * e3
        + 3.0 / 26.0 * e5
        - e2 * e2 * e2 / 16.0
        + 3.0 / 40.0 * e3 * e3
        + 3.0 / 20.0 * e2 * e4
        + 45.0 / 272.0 * e2 * e2 * e3
        - 9.0 / 68.0 * (e3 * e4 + e2 * e5)
}

/// Arguments further apart than this would leave the range of a double on the way.
const FARTHEST: f64 = 1e280;

/// The root of a power of four by which all arguments are divided, so that 1 lies in their midst.
fn common_scale(arguments: &[f64]) -> Result<f64> {
    let sizes = || arguments.iter().map(|x| x.abs());
    let greatest = sizes().fold(0.0, f64::max);
    let least = sizes().filter(|x| *x > 0.0).fold(f64::INFINITY, f64::min);
    if greatest / FARTHEST > least {
        return Err(Error::Condition {
            condition: "arguments other than zero must lie within a factor of 1e280 of each other",
            value: least,
        });
    }
    // The cube of a root must not leave the range either way.
    let exponent = (0.25 * (greatest.log2() + least.log2())).floor() as i32;
    Ok(2.0_f64.powi(exponent))
}

fn at_most_one_zero(x: f64, y: f64) -> Result<()> {
    if x == 0.0 && y == 0.0 {
        return Err(Error::Condition {
            condition: "at most one argument may be zero",
            value: 0.0,
        });
    }
    Ok(())
}

/// Divided by the root of the scale twice, so that neither step overflows.
fn divided(x: f64, root: f64) -> Dd {
    Dd::from(x / root / root)
}

/// R_F(x, y, z) = ½∫₀^∞ dt/√((t+x)(t+y)(t+z)), symmetric, of degree −1/2; R_F(x, x, x) = 1/√x.
///
/// Arguments from 0 (one of them) to 10³⁰⁸; they are scaled by a power of four first. Error 0.44 ε at most of 38 rows, ratios to 10²⁸⁰.
/// Cost 1.3 µs. Source: B. C. Carlson, Numerical computation of real or complex elliptic integrals (1995); Digital
/// Library of Mathematical Functions, 19.36.
///
/// # Errors
///
/// If an argument is negative or not finite, if two are zero, or if they lie more than a factor 10²⁸⁰ apart.
pub fn rf(x: f64, y: f64, z: f64) -> Result<f64> {
    let mut a = [
        not_negative("argument x", x)?,
        not_negative("argument y", y)?,
        not_negative("argument z", z)?,
    ];
    a.sort_by(f64::total_cmp);
    at_most_one_zero(a[0].abs(), a[1].abs())?;
    let root = common_scale(&a)?;
    let [x, y, z] = a.map(|x| divided(x.abs(), root));
    Ok(first(x, y, z).value() / root)
}

/// R_C(x, y) = R_F(x, y, y) = arctan(√(y/x − 1))/√(y − x), the principal value for y < 0.
///
/// Error 0.46 ε at most of 68 rows, both signs of y. Cost 1.2 µs. Source as for [`rf`].
///
/// # Errors
///
/// If x is negative, y is zero, one is not finite, or if they lie more than a factor 10²⁸⁰ apart.
pub fn rc(x: f64, y: f64) -> Result<f64> {
    let x = not_negative("argument x", x)?.abs();
    if finite("argument y", y)? == 0.0 {
        return Err(Error::Condition {
            condition: "the last argument must not be zero",
            value: y,
        });
    }
    let root = common_scale(&[x, y])?;
    Ok(elementary(divided(x, root), divided(y, root)).value() / root)
}

/// R_D(x, y, z) = (3/2)∫₀^∞ dt/((t+z)√((t+x)(t+y)(t+z))), symmetric in x and y, of degree −3/2.
///
/// Error 0.43 ε at most of 28 rows, ratios to 10⁶⁰. Cost 1.8 µs. Source as for [`rf`].
///
/// # Errors
///
/// If x or y is negative, both are zero, z is not positive, one is not finite, or if they lie more than a factor
/// 10²⁸⁰ apart.
pub fn rd(x: f64, y: f64, z: f64) -> Result<f64> {
    let x = not_negative("argument x", x)?.abs();
    let y = not_negative("argument y", y)?.abs();
    let z = crate::error::positive("argument z", z)?;
    at_most_one_zero(x, y)?;
    let root = common_scale(&[x, y, z])?;
    let value = second(divided(x, root), divided(y, root), divided(z, root)).value();
    Ok(value / root / root / root)
}

/// R_J(x, y, z, p) = (3/2)∫₀^∞ dt/((t+p)√((t+x)(t+y)(t+z))), the principal value for p < 0.
///
/// Symmetric in x, y, z, of degree −3/2. Error 0.43 ε at most of 48 rows, of which 20 are principal values, ratios to 10⁶⁰. Where a
/// principal value passes through zero, about 10⁻²² of its two parts is the error instead. Cost 4–7 µs. Source as for
/// [`rf`]; Digital Library of Mathematical Functions, 19.20.14.
///
/// # Errors
///
/// If one of x, y, z is negative, two of them are zero, p is zero, one is not finite, or if they lie more than a
/// factor 10²⁸⁰ apart.
pub fn rj(x: f64, y: f64, z: f64, p: f64) -> Result<f64> {
    let mut a = [
        not_negative("argument x", x)?.abs(),
        not_negative("argument y", y)?.abs(),
        not_negative("argument z", z)?.abs(),
    ];
    a.sort_by(f64::total_cmp);
    at_most_one_zero(a[0], a[1])?;
    if finite("argument p", p)? == 0.0 {
        return Err(Error::Condition {
            condition: "the last argument must not be zero",
            value: p,
        });
    }
    let root = common_scale(&[a[0], a[1], a[2], p])?;
    let [x, y, z] = a.map(|x| divided(x, root));
    let p = divided(p, root);
    let value = if p.value() > 0.0 {
        third(x, y, z, p)
    } else {
        // The other root q of (q − y)(y − p) = (z − y)(y − x), which is positive.
        let gap = y.subtract(p);
        let q = y.add(z.subtract(y).multiply(y.subtract(x)).divide(gap));
        let pq = p.multiply(q);
        let xz = x.multiply(z);
        let bracket = q
            .subtract(y)
            .multiply(third(x, y, z, q))
            .subtract(first(x, y, z).multiply(Dd::from(3.0)))
            .add(elementary(xz.divide(y), pq.divide(y)).multiply(Dd::from(3.0)));
        bracket.divide(gap)
    };
    Ok(value.value() / root / root / root)
}

/// R_G(x, y, z), the mean of √(x n₁² + y n₂² + z n₃²) over directions n.
///
/// Zeros are allowed, all three as well. Error 0.44 ε at most of 38 rows, ratios to 10²⁸⁰. Cost 6 µs. Source: Digital Library of
/// Mathematical Functions, 19.21.10, of which all terms have one sign.
///
/// ```
/// use spinning_bodies::elliptic::carlson::rg;
/// // A sphere: the mean of the radius.
/// assert_eq!(rg(4.0, 4.0, 4.0)?, 2.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// If an argument is negative or not finite, or if they lie more than a factor 10²⁸⁰ apart.
pub fn rg(x: f64, y: f64, z: f64) -> Result<f64> {
    let mut a = [
        not_negative("argument x", x)?.abs(),
        not_negative("argument y", y)?.abs(),
        not_negative("argument z", z)?.abs(),
    ];
    a.sort_by(f64::total_cmp);
    if a[1] == 0.0 {
        return Ok(0.5 * a[2].sqrt());
    }
    let root = common_scale(&a)?;
    let [x, y, z] = a.map(|x| divided(x, root));
    // 6 R_G = Σ x (y + z) R_D(y, z, x), all terms positive; a zero argument has no term.
    let mut sum = Dd::from(0.0);
    for (u, v, w) in [(x, y, z), (y, z, x), (z, x, y)] {
        if w.value() > 0.0 {
            sum = sum.add(w.multiply(u.add(v)).multiply(second(u, v, w)));
        }
    }
    Ok(sum.divide(Dd::from(6.0)).value() * root)
}
