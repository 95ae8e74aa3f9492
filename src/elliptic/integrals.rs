//! Complete and incomplete integrals of all three kinds, and the inverse Jacobi functions.

use super::carlson;
use super::landen::SMALL;
use super::modulus::Modulus;
use super::parameter::{Characteristic, Parameter};
use crate::error::{Result, finite, not_zero, refused, within};
use crate::precise::{DoubleDouble as Dd, Extended, Number, RIGHT_ANGLE};

/// K = ∫₀^{π/2} dθ/√(1 − m sin²θ) for m ≤ 1, the quarter period; π/2 at m = 0, ln(4/√mc) for mc → 0, infinite at mc = 0.
///
/// An m below 0 is given as a [`Characteristic`].
///
/// Error 0.50 ε at most of 20 000 parameters, mc to 5·10⁻³²⁴, m to −1.8·10³⁰⁸. Cost 30–110 ns: it is [`Modulus::new`](super::Modulus::new).
///
/// Source: Digital Library of Mathematical Functions, 19.2, 19.8.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_first};
/// assert_eq!(complete_first(Parameter::from_parameter(0.0)?)?, std::f64::consts::FRAC_PI_2);
/// // Gauss's lemniscate: K(1/2) = Γ(1/4)²/(4 √π).
/// assert_eq!(complete_first(Parameter::from_parameter(0.5)?)?, 1.854_074_677_301_371_9);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// For m > 1, where it is not real.
pub fn complete_first(parameter: impl Into<Characteristic>) -> Result<f64> {
    Ok(complete(Kind::First, parameter.into())?.value())
}

/// E = ∫₀^{π/2} √(1 − m sin²θ) dθ for m ≤ 1, π/2 at m = 0 and 1 at m = 1; formed as B + mc D, where nothing cancels.
///
/// Error 0.50 ε at most of 20 000 parameters. Cost 1.5–2.6 times that of K. Source: Digital Library of Mathematical Functions, 19.2, 19.8.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_first, complete_second};
/// // Legendre's relation: E K′ + E′ K − K K′ = π/2.
/// let p = Parameter::from_parameter(0.3)?;
/// let (k, e) = (complete_first(p)?, complete_second(p)?);
/// let (l, f) = (complete_first(p.exchanged())?, complete_second(p.exchanged())?);
/// assert!((e * l + f * k - k * l - std::f64::consts::FRAC_PI_2).abs() < 2e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_second(parameter: impl Into<Characteristic>) -> Result<f64> {
    Ok(complete(Kind::Second, parameter.into())?.value())
}

/// D = ∫₀^{π/2} sin²θ/√(1 − m sin²θ) dθ = (K − E)/m for m ≤ 1, without that difference; π/4 at m = 0, infinite at mc = 0.
///
/// Error 0.50 ε at most of 20 000 parameters, m and mc to 10⁻³⁰⁰ and less. Cost 1.5–2.7 times that of K. Source: Digital
/// Library of Mathematical Functions, 19.8.
///
/// # Errors
///
/// As for [`complete_first`].
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_b, complete_d, complete_first};
/// // B + D = K.
/// let half = Parameter::from_parameter(0.5)?;
/// assert!((complete_b(half)? + complete_d(half)? - complete_first(half)?).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn complete_d(parameter: impl Into<Characteristic>) -> Result<f64> {
    let parameter = real(parameter.into())?;
    Ok(second_kind(parameter)[1].value())
}

/// B = ∫₀^{π/2} cos²θ/√(1 − m sin²θ) dθ = (E − mc K)/m for m ≤ 1, without that difference; π/4 at m = 0, 1 at m = 1.
///
/// Error 0.49 ε at most of 20 000 parameters. Cost 1.5–2.7 times that of K. Source: Digital Library of Mathematical Functions, 19.8.
///
/// # Errors
///
/// As for [`complete_first`].
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_b};
/// assert_eq!(complete_b(Parameter::from_parameter(0.0)?)?, std::f64::consts::FRAC_PI_4);
/// assert_eq!(complete_b(Parameter::from_parameter(1.0)?)?, 1.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn complete_b(parameter: impl Into<Characteristic>) -> Result<f64> {
    let parameter = real(parameter.into())?;
    Ok(second_kind(parameter)[0].value())
}

/// K − π/2 for m ≤ 1: πm/8 next to m = 0, negative for m < 0, infinite at m = 1.
///
/// By it a pendulum's quarter period exceeds that of small swings. The difference is taken in two words, and for |m| below 10⁻⁸ from the series.
/// Error 0.52 ε at most of 20 000 parameters, m and mc to 10⁻³⁰⁰ and less. Cost 1.0–1.4 times that of K.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, complete_first_excess};
/// let tiny = complete_first_excess(Parameter::from_parameter(1e-20)?)?;
/// assert_eq!(tiny, std::f64::consts::PI * 1e-20 / 8.0);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// As for [`complete_first`].
pub fn complete_first_excess(parameter: impl Into<Characteristic>) -> Result<f64> {
    let parameter = parameter.into();
    let quarter = complete(Kind::First, parameter)?;
    let m = parameter.n;
    if quarter.high() == f64::INFINITY {
        return Ok(f64::INFINITY);
    }
    if m.high().abs() < SMALL {
        let series = Dd::from(0.25).add_lesser(Dd::from(
            m.high() * (9.0 / 64.0 + m.high() * (25.0 / 256.0)),
        ));
        return Ok((RIGHT_ANGLE * m * series).value());
    }
    Ok((quarter - RIGHT_ANGLE).value())
}

/// B and D for m ≤ 1.
fn second_kind(parameter: Characteristic) -> [Dd; 2] {
    let (m, mc) = (parameter.n, parameter.nc);
    if m.high() < 0.0 {
        // The imaginary modulus exchanges sine and cosine: B(m) = D(−m/mc)/√mc, D(m) = B(−m/mc)/√mc.
        let (other, root) = imaginary(m, mc);
        let [b, d] = second_kind(other.into());
        return [d / root, b / root];
    }
    if mc.high() == 0.0 {
        return [1.0, f64::INFINITY].map(Dd::from);
    }
    let modulus = Modulus::new(Parameter::from_both(m, mc));
    let (quarter, mean) = (modulus.quarter_period_dd(), modulus.rate);
    let one = Dd::from(1.0);
    if m.value() <= mc.value() {
        let share = share(m, mc);
        return [one - share, share].map(|share| quarter.quick_product(share));
    }
    // E = a + mc K D′/K′, a = π/(2K′) the mean of 1 and k, is Legendre's relation; B = (E − mc K)/m and D = (K − E)/m then lose a bit or two.
    let few = mc.quick_product(quarter);
    let part = few.quick_product(share(mc, m));
    [mean + part - few, quarter - part - mean].map(|sum| sum.quick_quotient(m))
}

/// The parameter −m/mc that belongs to m < 0, and √mc: K(m) = K(−m/mc)/√mc.
#[inline(always)]
fn imaginary(m: Dd, mc: Dd) -> (Parameter, Dd) {
    // The root of mc/4: squaring the root of the greatest double would overflow.
    let root = mc.scaled(0.25).square_root().scaled(2.0);
    (Parameter::from_both(-m / mc, Dd::from(1.0) / mc), root)
}

/// D/K = (K − E)/(m K) for m ≤ 1/2, to 63 bits.
///
/// It is ½ + Σ 2ⁿ⁻¹uₙ with uₙ = cₙ²/m from the arithmetic–geometric mean of 1 and √mc, where c₁ = m/(4a₁) and cₙ = cₙ₋₁²/(4aₙ): all terms are positive, and
/// u₄ is 4·10⁻²¹ at most. Source: Digital Library of Mathematical Functions, 19.8.
fn share(m: Dd, mc: Dd) -> Dd {
    let x = m.high();
    if x < SMALL {
        return Dd::from(0.5).add_lesser(Dd::from(x * (1.0 / 16.0 + x / 32.0)));
    }
    let root = mc.square_root();
    let first = Dd::from(1.0).add_alike(root).scaled(0.5);
    let u1 = m.quick_quotient(first.quick_product(first)).scaled(0.0625);
    // u₂ is 10⁻⁴ of the whole: from here on doubles suffice.
    let next = |u: f64, mean: f64| x * (0.25 * u / mean).powi(2);
    let (a1, b1) = (first.high(), root.high().sqrt());
    let a2 = 0.5 * (a1 + b1);
    let a3 = 0.5 * (a2 + (a1 * b1).sqrt());
    let u2 = next(u1.high(), a2);
    let u3 = next(u2, a3);
    Dd::from(0.5)
        .add_alike(u1)
        .add_alike(Dd::from(2.0 * u2 + 4.0 * u3))
}

/// Π for n < 1 and m < 1, where the integrand is positive: by Bulirsch's transformation, whose terms are all positive too.
///
/// Source: R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions III, Numerische Mathematik 13 (1969) 305–315.
fn third_kind(nc: Dd, mc: Dd) -> Dd {
    let one = Dd::from(1.0);
    let (mut root, mut p) = (mc.square_root(), nc.square_root());
    let (mut a, mut b) = (one, one.quick_quotient(p));
    let (mut product, mut mean) = (root, one);
    loop {
        let inverse = one.quick_quotient(p);
        let (before, g) = (a, product.quick_product(inverse));
        a = a.add_alike(b.quick_product(inverse));
        b = b.add_alike(before.quick_product(g)).scaled(2.0);
        p = p.add_alike(g);
        let last = mean;
        mean = mean.add_alike(root);
        // The error is the square of this gap: two digits and more below the last bit of a double.
        if (last - root).high().abs() <= 3e-10 * last.high() {
            let value = RIGHT_ANGLE.quick_product(b.add_alike(a.quick_product(mean)));
            return value.quick_quotient(mean.quick_product(mean.add_alike(p)));
        }
        root = product.square_root().scaled(2.0);
        product = root.quick_product(mean);
    }
}

/// An angle as a multiple of π and a rest of at most π/2, with the sine and cosine of the rest to 106 bits.
struct Angle {
    halves: f64,
    negative: bool,
    pair: [Dd; 2],
}

impl Angle {
    fn new(phi: f64) -> Result<Self> {
        const GREATEST: f64 = 9_007_199_254_740_992.0;
        let phi = within("angle phi", phi, -GREATEST, GREATEST)?;
        let (mut quarters, mut rest) = (0.0, Dd::from(phi));
        // Twice, because the first quotient may round to the wrong integer.
        for _ in 0..2 {
            let more = (rest.high() * core::f64::consts::FRAC_2_PI).round();
            quarters += more;
            rest = rest.less_right_angles(more);
        }
        let mut pair = sine_cosine(rest.magnitude());
        let odd = quarters % 2.0 != 0.0;
        if odd {
            // Short of the right angle on from the multiple of π before it, beyond it back from the next: next to it the cosine has all its digits.
            quarters += 1.0_f64.copysign(rest.high());
            pair.reverse();
        }
        Ok(Self {
            halves: 0.5 * quarters,
            negative: (rest.high() < 0.0) != odd,
            pair,
        })
    }

    /// The value at the rest, with its sign, plus `half_period` for each multiple of π.
    fn assemble(&self, at_rest: Dd, half_period: Dd) -> f64 {
        let signed = if self.negative { -at_rest } else { at_rest };
        if self.halves == 0.0 || signed.high().is_infinite() {
            return signed.value();
        }
        let size = half_period.high() * self.halves;
        if size.is_infinite() {
            return size;
        }
        (half_period * Dd::from(self.halves) + signed).value()
    }
}

/// 1, −1/3!, 1/5!, … −1/15!.
const SINE: [Dd; 8] = [
    Dd::new(1.0, 0.0),
    Dd::new(-0.16666666666666666, -9.25185853854297e-18),
    Dd::new(0.008333333333333333, 1.1564823173178714e-19),
    Dd::new(-0.0001984126984126984, -1.7209558293420705e-22),
    Dd::new(2.7557319223985893e-06, -1.858393274046472e-22),
    Dd::new(-2.505210838544172e-08, 1.448814070935912e-24),
    Dd::new(1.6059043836821613e-10, 1.2585294588752098e-26),
    Dd::new(-7.647163731819816e-13, -7.03872877733453e-30),
];

/// Sine and cosine of 0 ≤ x ≤ π/4, with relative error 10⁻³¹: terms up to 1/15! in two words, the rest in one.
fn sine_cosine(x: Dd) -> [Dd; 2] {
    let square = x.quick_product(x);
    let fourth = square.quick_product(square);
    let y = square.high();
    // 1/29!, 1/27!, … 1/17!.
    let (mut tail, mut coefficient) = (0.0, 1.130_996_288_644_771_6e-31);
    for last in [28.0, 26.0, 24.0, 22.0, 20.0, 18.0, 16.0] {
        tail = y * (coefficient - tail);
        coefficient *= last * (last + 1.0);
    }
    // Every other coefficient, so that two chains of operations run side by side.
    let chain = |start: Dd, coefficients: [usize; 3]| {
        coefficients.into_iter().fold(start, |sum, i| {
            SINE[i].add_lesser(sum.quick_product(fourth))
        })
    };
    let even = chain(SINE[6], [4, 2, 0]);
    let odd = chain(SINE[7] + Dd::from(tail), [5, 3, 1]);
    let sine = (even + square.quick_product(odd)) * x;
    [sine, (Dd::from(1.0) - sine * sine).square_root()]
}

/// Which integral.
#[derive(Clone, Copy)]
enum Kind {
    First,
    Second,
    Third(Characteristic),
}

/// An integral from 0 to any φ: its value at the rest of φ, plus twice the complete integral for each multiple of π.
fn at_angle(kind: Kind, phi: f64, parameter: Characteristic) -> Result<f64> {
    let angle = Angle::new(phi)?;
    let rest = within_quarter(kind, angle.pair, parameter)?;
    let half = if angle.halves == 0.0 {
        Dd::from(0.0)
    } else {
        complete(kind, parameter)?.scaled(2.0)
    };
    Ok(angle.assemble(rest, half))
}

/// An integral from 0 to π/2, for m up to 1.
fn complete(kind: Kind, parameter: Characteristic) -> Result<Dd> {
    let Characteristic { n: m, nc: mc } = real(parameter)?;
    match kind {
        Kind::First if m.high() < 0.0 => {
            let (other, root) = imaginary(m, mc);
            Ok(Modulus::new(other).quarter_period_dd() / root)
        }
        Kind::First => Ok(Modulus::new(Parameter::from_both(m, mc)).quarter_period_dd()),
        Kind::Second if mc.high() == 0.0 => Ok(Dd::from(1.0)),
        Kind::Second => {
            // Both terms are positive.
            let [b, d] = second_kind(parameter);
            Ok(b + mc * d)
        }
        Kind::Third(Characteristic { nc, .. })
            if (1e-60..1e60).contains(&nc.high()) && (1e-300..1e60).contains(&mc.high()) =>
        {
            Ok(third_kind(nc, mc))
        }
        Kind::Third(_) => within_quarter(kind, [Dd::from(1.0), Dd::from(0.0)], parameter),
    }
}

/// The parameter, if its complete integrals are real: m ≤ 1.
fn real(parameter: Characteristic) -> Result<Characteristic> {
    if parameter.nc() < 0.0 {
        return not_real(parameter.n);
    }
    Ok(parameter)
}

fn not_real<T>(m: Dd) -> Result<T> {
    let condition = "m sin² must not exceed 1 between 0 and phi, where the integral is not real";
    refused(condition, m.value())
}

/// An integral from 0 to the angle between 0 and π/2 that has this sine and cosine.
fn within_quarter(kind: Kind, [sine, cosine]: [Dd; 2], parameter: Characteristic) -> Result<Dd> {
    let (m, mc) = (parameter.n, parameter.nc);
    let mut sizes = [sine, cosine, m, mc, m, mc];
    if let Kind::Third(Characteristic { n, nc }) = kind {
        sizes[4..].copy_from_slice(&[n, nc]);
    }
    if carlson::ordinary(&sizes.map(Dd::high)) {
        Place::<Dd>::new([sine, cosine, m, mc])?.value(kind)
    } else {
        Place::<Extended>::new([sine, cosine, m, mc])?.value(kind)
    }
}

/// sin φ, sin²φ, cos²φ, Δ² = 1 − m sin²φ, m and mc.
struct Place<N> {
    s: N,
    s2: N,
    c2: N,
    delta2: N,
    m: N,
    mc: N,
}

impl<N: Number> Place<N> {
    fn new(numbers: [Dd; 4]) -> Result<Self> {
        let [s, c, m, mc] = numbers.map(N::from);
        let (s2, c2) = (s.square(), c.square());
        let delta2 = c2 + mc * s2;
        if delta2.leading() < 0.0 {
            return not_real(numbers[2]);
        }
        Ok(Self {
            s,
            s2,
            c2,
            delta2,
            m,
            mc,
        })
    }

    fn value(&self, kind: Kind) -> Result<Dd> {
        if self.s.is_zero() {
            return Ok(self.s.narrow());
        }
        let value = match kind {
            Kind::First => self.first(),
            Kind::Second => self.second(),
            Kind::Third(Characteristic { n, nc }) => {
                let [n, nc] = [n, nc].map(N::from);
                let p = self.c2 + nc * self.s2;
                if p.is_zero() {
                    let condition = "n sin² phi must not be 1, where the integral of the third kind is infinite";
                    return refused(condition, n.narrow().value());
                }
                if self.c2.is_zero() && self.delta2.is_zero() {
                    return Ok(Dd::from(f64::INFINITY.copysign(p.leading())));
                }
                self.third(n, nc, p)
            }
        };
        Ok(value.narrow())
    }

    /// c², Δ², 1.
    fn arguments(&self) -> [N; 3] {
        [self.c2, self.delta2, N::from_double(1.0)]
    }

    fn first(&self) -> N {
        self.s * carlson::first(self.arguments())
    }

    /// Three forms of E(φ), each with terms of one sign where it is taken (Digital Library of Mathematical Functions 19.25.9 to
    /// 19.25.11).
    fn second(&self) -> N {
        let (s, s2, c2, delta2, m, mc) = (self.s, self.s2, self.c2, self.delta2, self.m, self.mc);
        let one = N::from_double(1.0);
        let third_of_cube = (s * s2).quotient(N::from_double(3.0));
        if m.leading() < 0.0 {
            let (d, rest) = carlson::second([c2, delta2, one]);
            return (s * rest.first()).add_alike(-m * (d * third_of_cube));
        }
        if mc.is_zero() {
            return s;
        }
        if mc.leading() < 0.0 {
            let d = carlson::second([delta2, one, c2]).0 * third_of_cube;
            let end = delta2.quotient(c2).square_root() * s;
            return (-mc * d).add_alike(end);
        }
        let (d, rest) = carlson::second([c2, one, delta2]);
        let end = s * c2.quotient(delta2).square_root();
        let whole = mc * (s * rest.first()).add_alike(m * (d * third_of_cube));
        whole.add_alike(m * end)
    }

    /// Π by R_J where n > 0 and p = 1 − n sin²φ > 0; else by another characteristic, so that no sum cancels.
    fn third(&self, n: N, nc: N, p: N) -> N {
        let (s, s2, c2, delta2, m, mc) = (self.s, self.s2, self.c2, self.delta2, self.m, self.mc);
        let third_of_cube = (s * s2).quotient(N::from_double(3.0));
        let negative = n.leading() < 0.0;
        if !negative && p.leading() > 0.0 {
            let (tail, rest) = carlson::third(self.arguments(), p);
            return (s * rest.first()).add_alike(n * (tail * third_of_cube));
        }
        if negative && m.leading() < 0.0 {
            // Transformed to the characteristic 1 − mc/nc (19.7.9 of the Digital Library, with its sign of n).
            let few = mc.quotient(nc);
            let q = c2.add_alike(few * s2);
            let arc = carlson::elementary(delta2, p * q);
            let arc = s * c2.square_root() * arc;
            let (tail, rest) = carlson::third(self.arguments(), q);
            let sum = arc.add_alike(few * (tail * third_of_cube));
            return (s * rest.first()).add_alike(-n * sum).quotient(nc);
        }
        // Transformed to the characteristic m/n; 1 − m/n = (mc − nc)/n does not cancel for n > 1.
        let ratio = m.quotient(n);
        let q = if negative {
            N::from_double(1.0).add_alike(-ratio * s2)
        } else {
            c2.add_alike((mc - nc).quotient(n) * s2)
        };
        let arc = carlson::elementary(c2 * delta2, p * q) * s;
        let tail = carlson::third(self.arguments(), q).0 * third_of_cube;
        arc - ratio * tail
    }
}

/// F(φ) = ∫₀^φ dθ/√(1 − m sin²θ) for any m; the inverse of am.
///
/// Odd in φ. For m ≤ 1 at any angle, with F(φ + π) = F(φ) + 2K; for m > 1 as far as it is real, m sin²φ ≤ 1. Multiples of π are subtracted with 160
/// bits, so that cos φ has all its digits next to odd multiples of π/2. Infinite at m = 1 beyond π/2.
///
/// An m outside 0…1 is given as a [`Characteristic`], with its complement.
///
/// Error 0.46 ε at most of 150 rows: φ from 10⁻³⁰⁰ to 10⁶ and at successive floats next to multiples of π/2, mc to 10⁻³⁰⁰ and 0.
/// Cost 0.3–0.5 µs. Source: Digital Library of Mathematical Functions, 19.25.5.
///
/// ```
/// use spinning_bodies::elliptic::{Characteristic, incomplete_first};
/// // F(φ | −1) inverts the lemniscate's arc: φ = π/2 is its quarter, Γ(1/4)²/(4√(2π)).
/// let m = Characteristic::from_characteristic(-1.0)?;
/// let quarter = incomplete_first(std::f64::consts::FRAC_PI_2, m)?;
/// assert!((quarter - 1.311_028_777_146_059_9).abs() < 3e-16);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
///
/// # Errors
///
/// If φ is not finite or beyond 2⁵³, or if m sin² exceeds 1 between 0 and φ.
pub fn incomplete_first(phi: f64, parameter: impl Into<Characteristic>) -> Result<f64> {
    at_angle(Kind::First, phi, parameter.into())
}

/// E(φ) = ∫₀^φ √(1 − m sin²θ) dθ for any m, with the domain of [`incomplete_first`]; E(φ + π) = E(φ) + 2E. At m = 1 it is sin φ up to π/2, and goes on in steps.
///
/// Error 0.42 ε at most of 150 rows, as for [`incomplete_first`]. Cost 0.5–0.7 µs. Source: Digital Library of Mathematical
/// Functions, 19.25.9 to 19.25.11, whichever has terms of one sign.
///
/// # Errors
///
/// As for [`incomplete_first`].
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, incomplete_second};
/// // At m = 1 it is sin φ.
/// assert!((incomplete_second(0.5, Parameter::from_parameter(1.0)?)? - 0.5_f64.sin()).abs() < 1e-16);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn incomplete_second(phi: f64, parameter: impl Into<Characteristic>) -> Result<f64> {
    at_angle(Kind::Second, phi, parameter.into())
}

/// Π(n) = ∫₀^{π/2} dθ/((1 − n sin²θ)√(1 − m sin²θ)) for m ≤ 1; the principal value for n > 1; infinite at m = 1, and
/// where it exceeds the greatest double.
///
/// Where Bulirsch's transformation does not apply, n < 0 and n > 1 are transformed to other characteristics, so that no sum cancels.
///
/// Error 0.46 ε at most of 160 rows, 0.52 ε of 20 000 parameters: any n, nc and mc to ±10⁻³⁰⁰, n within an ulp of m. Cost 1.2–2.2 times that of K for n < 1, three to four
/// times for mc from 10⁻¹⁰⁰ down and for m below 10⁻⁸, where K takes two products; beyond n = 1, where it is a principal value, 4–9 µs; and up to 0.1 ms where nc is beyond
/// 10^±60 or mc below 10⁻³⁰⁰.
/// Source: Bulirsch (1969) for n < 1; Digital Library of Mathematical Functions, 19.7, 19.25.14; its sign of n.
///
/// # Errors
///
/// At n = 1, where it is infinite, and for m > 1, where it is not real.
///
/// ```
/// use spinning_bodies::elliptic::{Characteristic, Parameter, complete_third};
/// // At m = 0 it is π/(2√(1 − n)).
/// let round = Parameter::from_parameter(0.0)?;
/// let integral = complete_third(Characteristic::from_characteristic(0.75)?, round)?;
/// assert!((integral - std::f64::consts::PI).abs() < 1e-15);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn complete_third(
    characteristic: Characteristic,
    parameter: impl Into<Characteristic>,
) -> Result<f64> {
    Ok(complete(Kind::Third(characteristic), parameter.into())?.value())
}

/// Π(φ, n) = ∫₀^φ dθ/((1 − n sin²θ)√(1 − m sin²θ)) for any n and m; the principal value where n sin² passes 1.
///
/// Odd in φ. For m ≤ 1 at any angle: each π adds 2Π(n), for principal values too. For m > 1 as far as it is real,
/// m sin²φ ≤ 1. Infinite at m = 1 beyond π/2.
///
/// Error 0.47 ε at most of 560 rows, as for [`complete_third`] and with φ as for [`incomplete_first`]. Cost 0.7–0.9 µs within a quarter turn for n < 1; 4–9 µs
/// for principal values.
/// Source: Digital Library of Mathematical Functions, 19.7, 19.25.14; its sign of n.
///
/// # Errors
///
/// If φ is not finite or beyond 2⁵³, if n sin²φ = 1, or if m sin² exceeds 1 between 0 and φ.
///
/// ```
/// use spinning_bodies::elliptic::{Characteristic, Parameter, incomplete_third};
/// // At m = 0 it is arctan(√(1 − n) tan φ)/√(1 − n).
/// let (n, round) = (Characteristic::from_characteristic(-3.0)?, Parameter::from_parameter(0.0)?);
/// let integral = incomplete_third(std::f64::consts::FRAC_PI_4, n, round)?;
/// assert!((integral - 0.5 * 2.0_f64.atan()).abs() < 2e-16);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn incomplete_third(
    phi: f64,
    characteristic: Characteristic,
    parameter: impl Into<Characteristic>,
) -> Result<f64> {
    at_angle(Kind::Third(characteristic), phi, parameter.into())
}

fn complement(x: f64) -> Dd {
    Dd::difference(1.0, x) * Dd::sum(1.0, x)
}

/// The u in −K…K with sn u = x; ±infinity at m = 1, x = ±1.
///
/// Error 0.4 ε at most of 48 rows, x from 10⁻³⁰⁰ to the float below 1, x taken as exact. An error of x enters u
/// multiplied by 1/(cn dn), which is unbounded next to ±1: use [`inverse_cn`] or [`inverse_cn_sn`] there.
/// Cost 0.3 µs, up to three times that with numbers beyond 10^±60. Source: Digital Library of Mathematical Functions, 19.25.31, 22.15.
///
/// # Errors
///
/// If x is not finite or lies outside −1…1.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, inverse_sn};
/// // At m = 1, sn u = tanh u.
/// assert!((inverse_sn(0.5, Parameter::from_parameter(1.0)?)? - 0.5_f64.atanh()).abs() < 2e-16);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn inverse_sn(x: f64, parameter: Parameter) -> Result<f64> {
    let x = within("value of sn", x, -1.0, 1.0)?;
    Ok(from_sine_cosine([Dd::from(x), complement(x).square_root()], parameter).value())
}

/// The u in 0…2K with cn u = x; infinite at m = 1, x ≤ 0.
///
/// Error 0.6 ε at most of 48 rows, x from 10⁻³⁰⁰ to the float below 1, both signs. Ill-conditioned next to ±1, as
/// [`inverse_sn`] is. Cost 0.2–0.5 µs, up to three times that with numbers beyond 10^±60. Source: Digital Library of Mathematical Functions, 19.25.31, 22.15.
///
/// # Errors
///
/// If x is not finite or lies outside −1…1.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, inverse_cn};
/// assert!((inverse_cn(0.5, Parameter::from_parameter(0.0)?)? - 0.5_f64.acos()).abs() < 3e-16);
/// // At m = 1, cn u = 1/cosh u.
/// assert!((inverse_cn(1e-300, Parameter::from_parameter(1.0)?)? - (2.0_f64.ln() + 300.0 * 10.0_f64.ln())).abs() < 1e-12);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn inverse_cn(x: f64, parameter: Parameter) -> Result<f64> {
    let x = within("value of cn", x, -1.0, 1.0)?;
    let u = from_sine_cosine([complement(x).square_root(), Dd::from(x)], parameter);
    Ok(reflected(u, x < 0.0, parameter))
}

/// `u`, or 2K − u where the cosine is negative.
fn reflected(u: Dd, negative: bool, parameter: Parameter) -> f64 {
    if !negative {
        return u.value();
    }
    let half = Modulus::new(parameter).quarter_period_dd().scaled(2.0);
    if half.high().is_infinite() {
        return half.high();
    }
    (half - u).value()
}

/// The u in −2K…2K at which (cn u, sn u) has the direction of (x, y); it has the sign of y, that of a zero included, as `atan2` does.
///
/// Well conditioned for every direction, where the inverses from one value alone lose half the digits next to the
/// extremes of that value. The length of (x, y) does not matter. ±infinity at m = 1, x ≤ 0.
///
/// Error: at most 0.41 of the change of u that a relative change of 4 ε in y/x makes. Cost 0.2–0.5 µs, up to three times that with numbers beyond 10^±60.
///
/// # Errors
///
/// If x or y is not finite, or both are zero.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, inverse_cn_sn};
/// assert!((inverse_cn_sn(-1.0, 1.0, Parameter::from_parameter(0.0)?)? - 3.0 * std::f64::consts::FRAC_PI_4).abs() < 5e-16);
/// // At m = 1 it is the inverse hyperbolic sine of y/x, here of 10⁶⁰⁰: ln 2 more than its logarithm.
/// let far = inverse_cn_sn(1e-300, 1e300, Parameter::from_parameter(1.0)?)?;
/// assert!((far - (600.0 * 10.0_f64.ln() + 2.0_f64.ln())).abs() < 1e-12);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn inverse_cn_sn(x: f64, y: f64, parameter: Parameter) -> Result<f64> {
    let x = finite("x along cn", x)?;
    let y = finite("y along sn", y)?;
    not_zero("direction (cn, sn)", x.abs().max(y.abs()))?;
    let u = from_sine_cosine([y.abs(), x].map(Dd::from), parameter);
    Ok(reflected(u, x < 0.0, parameter).copysign(y))
}

/// The u in 0…K with dn u = x; 0 at m = 0.
///
/// Error 0.5 ε at most of 30 rows. Ill-conditioned next to 1 and to √mc, and everywhere for small m: use
/// [`inverse_cn_sn`] there. Cost 0.2–0.5 µs, up to three times that with numbers beyond 10^±60. Source: Digital Library of Mathematical Functions, 19.25.31, 22.15.
///
/// # Errors
///
/// If x is not finite or lies outside √mc…1.
///
/// ```
/// use spinning_bodies::elliptic::{Parameter, inverse_dn};
/// // At m = 1, dn u = 1/cosh u.
/// assert!((inverse_dn(0.5, Parameter::from_parameter(1.0)?)? - 2.0_f64.acosh()).abs() < 3e-16);
/// assert!((inverse_dn(1e-300, Parameter::from_parameter(1.0)?)? - (2.0_f64.ln() + 300.0 * 10.0_f64.ln())).abs() < 1e-12);
/// // The double next below 1 is less than √mc here, which is 1 − m/2: the end is K.
/// let small = Parameter::from_parameter(1e-16)?;
/// assert_eq!(inverse_dn(1.0_f64.next_down(), small)?, std::f64::consts::FRAC_PI_2);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
pub fn inverse_dn(x: f64, parameter: Parameter) -> Result<f64> {
    let least = parameter.mc().sqrt();
    let x = within("value of dn", x, least, 1.0)?;
    if parameter.m() == 0.0 {
        return Ok(0.0);
    }
    let m = parameter.m_dd();
    let [mc, whole] = [parameter.mc_dd(), m].map(Extended::from);
    let c2 = (Extended::from_double(x).square() - mc).quotient(whole);
    if c2.leading() < 0.0 {
        // Only rounded is √mc not above x.
        return complete_first(parameter);
    }
    let pair = [(complement(x) / m).square_root(), c2.square_root().narrow()];
    Ok(from_sine_cosine(pair, parameter).value())
}

/// The argument from sine and cosine, in any unit.
fn from_sine_cosine([s, c]: [Dd; 2], parameter: Parameter) -> Dd {
    fn first<N: Number>([s, c, mc]: [N; 3]) -> Dd {
        let (s2, c2) = (s.square(), c.square());
        let delta2 = c2 + mc * s2;
        if delta2.is_zero() {
            return Dd::from(f64::INFINITY.copysign(s.leading()));
        }
        (s * carlson::first([c2, delta2, c2 + s2])).narrow()
    }
    if s.value() == 0.0 {
        return s;
    }
    let numbers = [s, c, parameter.mc_dd()];
    if carlson::ordinary(&numbers.map(Dd::high)) {
        first(numbers)
    } else {
        first(numbers.map(Extended::from))
    }
}
