//! Carlson's symmetric integrals, by duplication in twice the precision, so that the result is rounded once.
//!
//! All sums have terms of one sign: where the usual form of R_J takes 1 + e with e near −1, the sum of the two
//! products that make it up is written out instead. Principal values are taken for a negative last argument of
//! [`rc`] and [`rj`]. Any double is an argument, subnormal ones included: where cubes would leave the range, the same
//! sums are formed in numbers with an exponent of their own.

use crate::error::{Error, Result, finite, not_negative, positive};
use crate::precise::{DoubleDouble as Dd, Extended, Number};

/// Spread of the arguments below which the series of order six or seven are right to 2·10⁻²², their own rounding included.
/// A double needs less; principal values, in which two such integrals nearly cancel, need it.
const SPREAD: f64 = 2e-3;

/// Duplications after which any spread between doubles is gone: each halves the exponents of their ratios, and then divides
/// what is left of the spread by four.
const ROUNDS: usize = 64;

/// What the arguments are off their mean, as parts of it, where the series will do.
fn near<N: Number>(arguments: [N; 3], mean: N) -> Option<[f64; 3]> {
    let parts = arguments.map(|x| (mean - x).ratio(mean));
    let near = parts.iter().all(|part| part.abs() < SPREAD);
    near.then_some(parts)
}

/// √x√y + √x√z + √y√z, which a duplication adds to every argument.
fn step<N: Number>([a, b, c]: [N; 3]) -> N {
    (a * b.add_alike(c)).add_alike(b * c)
}

/// R_F of arguments of which at most one is zero.
pub(super) fn first<N: Number>(mut x: [N; 3]) -> N {
    let third = N::from_double(1.0).quotient(N::from_double(3.0));
    let mut scale = 1.0;
    for _ in 0..ROUNDS {
        let mean = x[0].add_alike(x[1]).add_alike(x[2]) * third;
        if let Some([dx, dy, dz]) = near(x, mean) {
            let e2 = dx * dy - dz * dz;
            let e3 = dx * dy * dz;
            let series = e2
                * (-0.1 + e2 * (1.0 / 24.0 - e2 * (5.0 / 208.0) + e3 / 16.0) - e3 * (3.0 / 44.0))
                + e3 * (1.0 / 14.0 + e3 * (3.0 / 104.0));
            let sum = N::from_double(1.0).add_alike(N::from_double(series));
            return sum.quotient(mean.square_root()).times(scale);
        }
        let lambda = step(x.map(N::square_root));
        x = x.map(|x| x.add_alike(lambda));
        scale *= 2.0;
    }
    N::from_double(f64::NAN)
}

/// R_C(x, y) for x ≥ 0, y ≠ 0; the principal value for y < 0.
pub(super) fn elementary<N: Number>(x: N, y: N) -> N {
    if y.leading() < 0.0 {
        let (whole, y) = (x - y, -y);
        let root = x.quotient(whole).square_root();
        return root * first([whole, y, y]);
    }
    first([x, y, y])
}

/// R_J, at most one of the first three zero; the principal value for p < 0.
pub(super) fn third<N: Number<Narrow = Dd>>(mut x: [N; 3], p: N) -> N {
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if x[i].exceeds(x[j]) {
            x.swap(i, j);
        }
    }
    let [x, y, z] = x;
    if p.leading() > 0.0 && !p.exceeds(z.times(4.0)) {
        return duplicated([x, y, z], p);
    }
    // The other root q of (q − y)(y − p) = (z − y)(y − x), which lies between x and z. Far beyond z, R_J would take a duplication
    // for each factor of four; there R_C is at most 0.61 of R_F, and what remains has one sign.
    let gap = y - p;
    let more = ((z - y) * (y - x)).quotient(gap);
    let q = y + more;
    let (pq, xz) = (p * q, x * z);
    let arcs = elementary(xz.quotient(y), pq.quotient(y)) - first([x, y, z]);
    let rest = more * duplicated([x, y, z], q);
    (rest - arcs.times(-3.0)).quotient(gap)
}

/// R_J by duplication, p > 0.
fn duplicated<N: Number<Narrow = Dd>>(mut x: [N; 3], mut p: N) -> N {
    let fifth = N::from_double(1.0).quotient(N::from_double(5.0));
    let mut sum = N::from_double(0.0);
    let mut scale = 1.0;
    for _ in 0..ROUNDS {
        let mean = x[0].add_alike(x[1]).add_alike(x[2]).add_alike(p.times(2.0)) * fifth;
        if let Some([dx, dy, dz]) = near(x, mean) {
            let dp = -0.5 * (dx + dy + dz);
            let last = tail(dx, dy, dz, dp, mean);
            return sum.times(6.0).add_alike(last.times(scale));
        }
        let roots = x.map(N::square_root);
        let (lambda, r) = (step(roots), p.square_root());
        let [a, b, c] = roots.map(|root| root.add_alike(r));
        let d = a * b * c;
        // 1 + e, with e the product of (r − a)/(r + a) over the three: both products summed, nothing cancels.
        let whole = (r.times(2.0) * p.add_alike(lambda)).quotient(d);
        // Rarely far from 1: without an exponent, then.
        let narrow = whole.narrow();
        let arc = if ordinary(&[narrow.high()]) {
            N::from_narrow(elementary(Dd::from(1.0), narrow))
        } else {
            elementary(N::from_double(1.0), whole)
        };
        sum = sum.add_alike(arc.quotient(d).times(scale));
        x = x.map(|x| x.add_alike(lambda));
        p = p.add_alike(lambda);
        scale *= 2.0;
    }
    N::from_double(f64::NAN)
}

/// R_D, at most one of x and y zero, z > 0.
pub(super) fn second<N: Number>(mut x: [N; 3]) -> N {
    let fifth = N::from_double(1.0).quotient(N::from_double(5.0));
    let mut sum = N::from_double(0.0);
    let mut scale = 1.0;
    for _ in 0..ROUNDS {
        let mean = x[0].add_alike(x[1]).add_alike(x[2].times(3.0)) * fifth;
        if let Some([dx, dy, _]) = near(x, mean) {
            let dz = -(dx + dy) / 3.0;
            let last = tail(dx, dy, dz, dz, mean);
            return sum.times(3.0).add_alike(last.times(scale));
        }
        let roots = x.map(N::square_root);
        let lambda = step(roots);
        x = x.map(|x| x.add_alike(lambda));
        sum = sum.add_alike(N::from_double(scale).quotient(roots[2] * x[2]));
        scale *= 2.0;
    }
    N::from_double(f64::NAN)
}

/// R_J about equal arguments, by its series to order six.
fn tail<N: Number>(x: f64, y: f64, z: f64, p: f64, mean: N) -> N {
    let xyz = x * y * z;
    let e2 = x * y + z * (x + y) - 3.0 * p * p;
    let e3 = xyz + 2.0 * e2 * p + 4.0 * p * p * p;
    let e4 = (2.0 * xyz + e2 * p + 3.0 * p * p * p) * p;
    let e5 = xyz * p * p;
    let series =
        -3.0 / 14.0 * e2 + e3 / 6.0 + 9.0 / 88.0 * e2 * e2 - 3.0 / 22.0 * e4 - 9.0 / 52.0 * e2 * e3
            + 3.0 / 26.0 * e5
            - e2 * e2 * e2 / 16.0
            + 3.0 / 40.0 * e3 * e3
            + 3.0 / 20.0 * e2 * e4
            + 45.0 / 272.0 * e2 * e2 * e3
            - 9.0 / 68.0 * (e3 * e4 + e2 * e5);
    let sum = N::from_double(1.0).add_alike(N::from_double(series));
    sum.quotient(mean * mean.square_root())
}

/// R_G, at most one argument zero: 6 R_G = Σ x (y + z) R_D(y, z, x), all terms positive; a zero has no term.
fn surface<N: Number>([x, y, z]: [N; 3]) -> N {
    let mut sum = N::from_double(0.0);
    for (u, v, w) in [(x, y, z), (y, z, x), (z, x, y)] {
        if !w.is_zero() {
            sum = sum.add_alike(w * u.add_alike(v) * second([u, v, w]));
        }
    }
    sum.quotient(N::from_double(6.0))
}

/// Whether products of three of these and their trailing words stay in the range of a double.
pub(super) fn ordinary(numbers: &[f64]) -> bool {
    let inside = |x: &f64| *x == 0.0 || (1e-60..1e60).contains(&x.abs());
    numbers.iter().all(inside)
}

/// A form of these arguments, rounded to a double, which must have room for it.
macro_rules! value {
    ($name:literal, $arguments:expr, $form:expr) => {{
        let arguments = $arguments;
        let value = if ordinary(&arguments) {
            $form(arguments.map(Dd::from)).value()
        } else {
            $form(arguments.map(Extended::from_double)).value()
        };
        finite(concat!("the value of ", $name), value)
    }};
}

/// Three arguments that are not negative; −0 becomes 0.
fn arguments(x: f64, y: f64, z: f64) -> Result<[f64; 3]> {
    Ok([
        not_negative("argument x", x)?.abs(),
        not_negative("argument y", y)?.abs(),
        not_negative("argument z", z)?.abs(),
    ])
}

fn at_most_one_zero(arguments: &[f64]) -> Result<()> {
    if arguments.iter().filter(|x| **x == 0.0).count() > 1 {
        return Err(Error::Condition {
            condition: "at most one argument may be zero",
            value: 0.0,
        });
    }
    Ok(())
}

fn not_zero(last: f64) -> Result<f64> {
    if last == 0.0 {
        return Err(Error::Condition {
            condition: "the last argument must not be zero",
            value: last,
        });
    }
    Ok(last)
}

/// R_F(x, y, z) = ½∫₀^∞ dt/√((t+x)(t+y)(t+z)), symmetric, of degree −1/2; R_F(x, x, x) = 1/√x.
///
/// Any arguments from 0 (one of them) to the greatest double. Error 0.43 ε at most of 77 rows over the whole range. Cost 1 µs; four
/// times as much beyond 10^±60, where an exponent is carried along. Source: B. C. Carlson, Numerical computation of real or complex elliptic integrals (1995); Digital
/// Library of Mathematical Functions, 19.36.
///
/// ```
/// use spinning_bodies::elliptic::carlson::rf;
/// // R_F(0, y, 1) for y → 0 is ln(4/√y).
/// assert!((rf(0.0, 1e-300, 1.0)? - (4f64.ln() + 150.0 * 10f64.ln())).abs() < 1e-13);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// If an argument is negative or not finite, or if two are zero.
pub fn rf(x: f64, y: f64, z: f64) -> Result<f64> {
    let a = arguments(x, y, z)?;
    at_most_one_zero(&a)?;
    value!("R_F", a, first)
}

/// R_C(x, y) = R_F(x, y, y) = arctan(√(y/x − 1))/√(y − x), the principal value for y < 0.
///
/// Any arguments with x ≥ 0 and y ≠ 0. Error 0.46 ε at most of 135 rows, both signs of y; a principal value may be subnormal or underflow to 0. Cost and source as for
/// [`rf`].
///
/// # Errors
///
/// If x is negative, y is zero, or one is not finite.
pub fn rc(x: f64, y: f64) -> Result<f64> {
    let x = not_negative("argument x", x)?.abs();
    let y = not_zero(finite("argument y", y)?)?;
    value!("R_C", [x, y], |[x, y]: [_; 2]| elementary(x, y))
}

/// R_D(x, y, z) = (3/2)∫₀^∞ dt/((t+z)√((t+x)(t+y)(t+z))), symmetric in x and y, of degree −3/2.
///
/// Any arguments whose value has room. Error 0.43 ε at most of 56 rows; where it underflows, the nearest subnormal
/// or 0. Cost 1.5 µs, and source, as for [`rf`].
///
/// # Errors
///
/// If x or y is negative, both are zero, z is not positive, or one is not finite; [`Error::NotFinite`] for a value beyond the greatest double.
pub fn rd(x: f64, y: f64, z: f64) -> Result<f64> {
    let a = arguments(x, y, positive("argument z", z)?)?;
    at_most_one_zero(&a[..2])?;
    value!("R_D", a, second)
}

/// R_J(x, y, z, p) = (3/2)∫₀^∞ dt/((t+p)√((t+x)(t+y)(t+z))), the principal value for p < 0.
///
/// Symmetric in x, y, z, of degree −3/2. Any arguments whose value has room. Error 0.45 ε at most of 107 rows, principal values included; where it underflows, the nearest subnormal or 0. Where a
/// principal value passes through zero, about 10⁻²¹ of its two parts is the error instead. Cost 3–4 µs, and up to 0.1 ms beyond 10^±60. Source as for
/// [`rf`]; Digital Library of Mathematical Functions, 19.20.14, 19.21.12.
///
/// # Errors
///
/// If one of x, y, z is negative, two of them are zero, p is zero, or one is not finite; [`Error::NotFinite`] for a value beyond the
/// greatest double.
pub fn rj(x: f64, y: f64, z: f64, p: f64) -> Result<f64> {
    let [x, y, z] = arguments(x, y, z)?;
    at_most_one_zero(&[x, y, z])?;
    let p = not_zero(finite("argument p", p)?)?;
    value!("R_J", [x, y, z, p], |[x, y, z, p]: [_; 4]| third(
        [x, y, z],
        p
    ))
}

/// R_G(x, y, z), the mean of √(x n₁² + y n₂² + z n₃²) over directions n.
///
/// Any arguments; zeros are allowed, all three as well. Error 0.43 ε at most of 77 rows. Cost 5 µs. Source: Digital Library of
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
/// If an argument is negative or not finite.
pub fn rg(x: f64, y: f64, z: f64) -> Result<f64> {
    let a = arguments(x, y, z)?;
    if at_most_one_zero(&a).is_err() {
        return Ok(0.5 * a.iter().sum::<f64>().sqrt());
    }
    value!("R_G", a, surface)
}

#[cfg(test)]
mod tests {
    use super::{Dd, first, second, third};
    use crate::Result;
    use crate::elliptic::modulus::PI;
    use crate::elliptic::{Modulus, Parameter};

    /// A double hides the last terms of the series; two words do not. K comes from the arithmetic-geometric mean.
    #[test]
    fn no_series_lacks_a_term() -> Result<()> {
        let number = Dd::from;
        let (zero, one, third_part) = (number(0.0), number(1.0), one_third());
        let mut worst = [0.0_f64; 3];
        let mut observe = |which: usize, defect: Dd, size: Dd| {
            worst[which] = worst[which].max((defect.value() / size.value()).abs());
        };
        for i in 1..400 {
            let k = number(0.3 + 0.0017 * f64::from(i));
            let mc = (one - k) * (one + k);
            let p = Parameter::from_both(k * k, mc);
            let (quarter, other) = (Modulus::new(p), Modulus::new(p.exchanged()));
            let (quarter, other) = (quarter.quarter_period_dd(), other.quarter_period_dd());
            observe(0, first([zero, mc, one]) - quarter, quarter);
            // Legendre: E K′ + E′ K − K K′ = π/2, with E = K − m D and E′ = K′ − mc D′.
            let d = second([zero, mc, one]) * third_part;
            let d_other = second([zero, p.m_dd(), one]) * third_part;
            let e = quarter - p.m_dd() * d;
            let whole = e * other - mc * d_other * quarter;
            observe(1, whole - PI.scaled(0.5), PI);
            // Π(−k) = K/2 + π/(4(1 + k)), which is K − k R_J(0, mc, 1, 1 + k)/3.
            let more = one + k;
            let part = third([zero, mc, one], more) * k * third_part;
            let whole = quarter.scaled(0.5) - PI.scaled(0.25) / more;
            observe(2, part - whole, quarter);
        }
        // Observed: 1.7e-22, 2.4e-25, 1.8e-23; any term left out makes more than twice as much of one of them.
        for (worst, allowed) in worst.into_iter().zip([2.5e-22, 5e-25, 3e-23]) {
            assert!(worst <= allowed, "{worst:e} {allowed:e}");
        }
        Ok(())
    }

    fn one_third() -> Dd {
        Dd::from(1.0) / Dd::from(3.0)
    }
}
