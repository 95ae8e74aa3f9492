//! Arithmetic-geometric mean, quarter period and nome of a parameter: by Gauss's transformation in two words, or the mean alone in two words or three.
//!
//! Gauss's transformation takes a parameter of at most 1/2 to parameter 0 in three steps and a remainder. Each step replaces the modulus k by k₁ = (1 − k′)/(1 + k′) and divides both K and u by 1 + k₁, so that z = πu/(2K) does not change.
//! At the end K is π/2 and sn z is sin z. The mean of 1 and k′, the nome and the functions of z all come from the same steps.

use core::ops::{Add, Mul};

use super::parameter::Parameter;
use crate::precise::{
    DoubleDouble as Dd, Number, RIGHT_ANGLE, RIGHT_ANGLE_REST, exponent_of, logarithm_of_quotient,
    power_of_two_below, quick,
};

/// The moduli of the steps, and what follows from them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Landen<N: Number> {
    /// 1 + k′ₙ for n = 0, 1, 2.
    pub(super) sums: [Dd; 3],
    /// k₁ and k₂; k₃² fits a double, since it enters as a correction of at most 2·10⁻¹⁰.
    pub(super) moduli: [Dd; 2],
    pub(super) last: f64,
    /// The arithmetic-geometric mean of 1 and k′: π/(2K).
    pub(crate) mean: Dd,
    /// The nome divided by k².
    pub(super) nome_over_square: Dd,
    /// The lesser of m and mc, k².
    pub(super) parameter: N,
    /// The nome q = exp(−πK′/K); zero where it underflows.
    pub(crate) nome: Dd,
}

impl<N: Number> Landen<N> {
    /// For the parameter m = k² ≤ 1/2 and the complementary modulus k′, both accurate to the last digit of their types.
    #[inline(always)]
    pub(crate) fn new(parameter: N, complement: Dd) -> Self {
        let one = Dd::from(1.0);
        let square = parameter.narrow();
        let sum0 = one.add_alike(complement);
        let inverse0 = one.quotient(sum0);
        let inverse0_squared = inverse0 * inverse0;
        let k1 = square * inverse0_squared;
        let k1_complement = (complement.square_root() * inverse0).scaled(2.0);
        let sum1 = one.add_alike(k1_complement);
        let inverse1 = one.quotient(sum1);
        let root = k1 * inverse1;
        let k2 = root * root;
        let sum2 = one.add_alike((k1_complement.square_root() * inverse1).scaled(2.0));
        let root = k2.quotient(sum2);
        let k3 = root * root;
        let square3 = k3 * k3;
        let last = square3.leading();
        // (1 + k′₃)(1 + k′₄)/4 with k₄ = k₃²/4; the next term is 10⁻³⁰.
        let rest = square3
            .scaled(-0.25)
            .add_alike(Dd::from(-5.0 / 64.0 * last * last));
        let mean = (sum0 * sum1 * sum2).scaled(0.125);
        let mean = mean.add_alike(mean * rest);
        // l = (1 − √k′)/(2(1 + √k′)); q = l + 2l⁵ + 15l⁹ + 150l¹³ + 1707l¹⁷ + …
        let l_over_square = (inverse0_squared * inverse1).scaled(0.5);
        let l = square * l_over_square;
        let l2 = l * l;
        let l4 = l2 * l2;
        let x = l4.leading();
        let tail = x * x * x * (150.0 + x * (1707.0 + x * (20_910.0 + x * 268_616.0)));
        let second = (l4 * l4).times(15.0).add_alike(Dd::from(tail));
        let series = one.add_alike(l4.scaled(2.0)).add_alike(second);
        let nome_over_square = l_over_square * series;
        Self {
            sums: [sum0, sum1, sum2],
            moduli: [k1, k2],
            last,
            mean,
            nome_over_square,
            parameter,
            nome: square * nome_over_square,
        }
    }

    /// The quarter period of the complementary modulus, K′ = (K/π) ln(1/q), also where q itself underflows; infinite for k = 0.
    pub(crate) fn complementary_quarter(&self) -> Dd {
        if self.parameter.is_zero() {
            return Dd::from(f64::INFINITY);
        }
        let nome = self.parameter * N::from(self.nome_over_square);
        let logarithm = -nome.logarithm();
        logarithm.quotient(self.mean.scaled(2.0))
    }

    /// sin z, or sinh x if `sign` is −1, to double precision: enough for a position, not for a rate.
    #[inline(always)]
    pub(crate) fn nearest_sine(&self, start: f64, delta: f64, sign: f64) -> f64 {
        let (mut s, mut d) = (start, delta);
        for (sum, modulus) in self.sums.iter().zip(&self.moduli) {
            s *= sum.leading() / (1.0 + d);
            let ks = s * modulus.leading();
            d = (1.0 - sign * ks * ks).sqrt();
        }
        s *= self.sums[2].leading() / (1.0 + d);
        let ks = self.last.sqrt() * s;
        s - 0.25 * s * (self.last - sign * ks * ks)
    }

    /// sin z from sn u and dn u, z = πu/(2K); or with `sign` −1 sinh x from −i sn(iy) = sc(y, k′) and dn(iy) = dc(y, k′), x = πy/(2K).
    #[inline(always)]
    pub(crate) fn sine(&self, start: Dd, delta: Dd, sign: f64) -> Dd {
        let one = Dd::from(1.0);
        let (mut s, mut d) = (start, delta);
        for (sum, modulus) in self.sums.iter().zip(&self.moduli) {
            s = (s * *sum).quotient(one.add_alike(d));
            let ks = s * *modulus;
            let square = (ks * ks).scaled(sign);
            d = one.add_alike(-square).square_root();
        }
        s = (s * self.sums[2]).quotient(one.add_alike(d));
        // The remainder: (1 + k′₃)/(1 + √(1 − k₃² s²)) and one more factor, both 1 up to 4·10⁻¹⁰.
        let a = self.last;
        // a s², where s² alone may overflow.
        let root = a.sqrt() * s.leading();
        let b = sign * (root * root);
        let correction =
            -0.25 * (a - b) + a * (-a / 16.0 - b / 16.0) + b * b / 8.0 - a * (a - b) / 64.0;
        s.add_alike(s * Dd::from(correction))
    }
}

/// If the lesser of m and mc is below this, the first terms of each series suffice.
///
/// The terms left out are 3·10⁻³⁴ of the mean and 10⁻²⁶ of a theta function, so both sides agree.
pub(super) const SMALL: f64 = 1e-8;

/// The arithmetic-geometric mean of 1 and √x for x in 1/2…1.
pub(super) struct Mean {
    pub(super) value: Dd,
    /// First mean times second mean, from which the nome follows.
    pub(super) product: Dd,
}

impl Mean {
    /// Two rounds, and the third from its series. Pairs (number, error) are not normalised in between: that shortens
    /// the chain of operations, each of which waits for the one before.
    #[inline(always)]
    pub(super) fn new(x: Dd, complement: Dd) -> Self {
        if complement.high() < SMALL {
            return Self::next_to_one(complement);
        }
        let (b0, b0_low) = quick::root(x.high(), x.low());
        let (sum, rest) = quick::ordered_sum(1.0, b0);
        let (a1, a1_low) = (0.5 * sum, 0.5 * (rest + b0_low));
        let (b1, b1_low) = quick::root(b0, b0_low);
        let (sum, rest) = quick::ordered_sum(a1, b1);
        let (a2, a2_low) = (0.5 * sum, 0.5 * (rest + (a1_low + b1_low)));
        let (square, rest) = quick::exact_product(a1, b1);
        let (b2, b2_low) = quick::root(square, rest + (a1 * b1_low + a1_low * b1));
        // With S = a2 + b2 and d = (a2 − b2)/S ≤ 1.4e-5:
        // agm(a2, b2) = S/2 (1 − d²/4 − 5 d⁴/64 − 11 d⁶/256 − …), where the first term needs both words.
        let (sum, rest) = quick::ordered_sum(a2, b2);
        let sum_low = rest + (a2_low + b2_low);
        let gap = Dd::sum(a2 - b2, a2_low - b2_low);
        let (gap2, error) = quick::exact_product(gap.high(), gap.high());
        let gap2_low = error + 2.0 * gap.high() * gap.low();
        let eight = 8.0 * sum;
        let inverse = 1.0 / eight;
        let less = gap2 * inverse;
        let (back, error) = quick::exact_product(less, eight);
        let less_low = (((gap2 - back) - error) + (gap2_low - 8.0 * less * sum_low)) * inverse;
        let d2 = 8.0 * less * (8.0 * inverse);
        let tail = 0.5 * sum * d2 * d2 * (5.0 / 64.0 + d2 * (11.0 / 256.0));
        let (high, low) = quick::ordered_sum(0.5 * sum, -less);
        let low = low + (0.5 * sum_low - less_low - tail);
        let (high, low) = quick::ordered_sum(high, low);
        let product = Dd::quick_product(Dd::new(a1, a1_low), Dd::new(a2, a2_low));
        Self {
            value: Dd::new(high, low),
            product,
        }
    }

    /// The mean and the product as series in 1 − x.
    #[inline(always)]
    pub(super) fn next_to_one(c: Dd) -> Self {
        let x = c.high();
        let square = x * x;
        let one_less = |first: Dd, rest: f64| {
            Dd::from(1.0).add_lesser(Dd::new(-first.high(), -(first.low() + rest)))
        };
        Self {
            value: one_less(c.scaled(0.25), square * (5.0 / 64.0 + x * (11.0 / 256.0))),
            product: one_less(c.scaled(0.5), square * (5.0 / 64.0 + x * (5.0 / 128.0))),
        }
    }
}

/// K = π/2 (1 + m/4 + 9m²/64 + 25m³/256 + …) for m below [`SMALL`], without a division.
#[inline(always)]
pub(super) fn quarter_next_to_zero(m: Dd) -> Dd {
    let x = m.high();
    let rest = x * x * (9.0 / 64.0 + x * (25.0 / 256.0));
    let more = Dd::new(0.25 * x, 0.25 * m.low() + rest);
    let quarter = RIGHT_ANGLE.add_lesser(RIGHT_ANGLE.quick_product(more));
    let (high, low) = quick::ordered_sum(quarter.high(), quarter.low());
    Dd::new(high, low)
}

/// The nome q, from l = (1 − √k′)/(2 (1 + √k′)) = m/(16 a1 a2) with the means of [`Mean`].
///
/// q = l + 2 l⁵ + 15 l⁹ + 150 l¹³ + 1707 l¹⁷ + …
pub(super) struct Nome {
    l: f64,
    l4: f64,
}

impl Nome {
    /// From the lesser of m and mc, and the product of the first two means of the other.
    pub(super) fn new(lesser: f64, product: f64) -> Self {
        let l = lesser / (16.0 * product);
        Self {
            l,
            l4: (l * l) * (l * l),
        }
    }

    pub(super) fn value(&self) -> f64 {
        let y = self.l4;
        self.l * (1.0 + y * (2.0 + y * (15.0 + y * (150.0 + y * 1707.0))))
    }

    /// ln(1/q) to 101 bits and more, for q > 0.
    pub(super) fn logarithm(&self, lesser: Dd, product: Dd) -> Dd {
        // ln(q/l) = 2 y + 13 y² + (368/3) y³ + …, y = l⁴ ≤ 3.6e-6.
        // The quotient is formed with a power of two taken out: mc may be as small as a double can be.
        let unit = power_of_two_below(lesser.high());
        let (n, d) = (product.scaled(16.0), lesser.scaled(1.0 / unit));
        let logarithm = logarithm_of_quotient(n, d, -exponent_of(unit));
        if self.l4 < 1e-34 {
            return logarithm;
        }
        // l in two words by one step of Newton.
        let l = self.l / unit;
        let (back, error) = quick::exact_product(l, n.high());
        let off = ((d.high() - back) - error) + (d.low() - l * n.low());
        let l = Dd::new(self.l, unit * off / n.high());
        let square = l.quick_product(l);
        let y = square.quick_product(square);
        let second = y.quick_product(y).quick_product(Dd::from(13.0));
        let x = y.high();
        let rest =
            x * (368.0 / 3.0 + x * (2701.0 / 2.0 + x * (80912.0 / 5.0 + x * (613_720.0 / 3.0))));
        let correction = y
            .scaled(2.0)
            .add_lesser(second.add_lesser(Dd::from(x * x * rest)));
        logarithm.add_alike(-correction)
    }
}

/// A sum of three doubles, each below the last place of the one before: about 150 bits, for arguments unluckily close to a multiple of K.
///
/// Some doubles near 10¹⁵ agree with such a multiple to within 10⁻¹⁷ relative, or closer. The difference then needs more than the 101 bits of the
/// prepared K: for these arguments K is computed again with three words, by the plain arithmetic-geometric mean.
#[derive(Debug, Clone, Copy)]
struct Triple([f64; 3]);

impl Triple {
    /// The sum of terms of any size: each pass carries the rounding errors one word down.
    fn sum<const N: usize>(mut terms: [f64; N]) -> Self {
        for _ in 0..4 {
            for i in (1..N).rev() {
                let pair = Dd::sum(terms[i - 1], terms[i]);
                terms[i - 1] = pair.high();
                terms[i] = pair.low();
            }
        }
        let last = Dd::sum(terms[1], terms[2] + terms[3]);
        Self([terms[0], last.high(), last.low()])
    }

    fn pair(value: Dd) -> Self {
        Self([value.high(), value.low(), 0.0])
    }

    fn leading(self) -> Dd {
        Dd::sum(self.0[0], self.0[1])
    }

    fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|x| x * factor))
    }

    /// One step of Newton from the root of 104 bits.
    fn square_root(self) -> Self {
        let root = self.leading().square_root();
        let near = Self::pair(root);
        let rest = (self + (near * near).scaled(-1.0)).leading();
        near + Self::pair(rest.scaled(0.5) / root)
    }
}

impl Add for Triple {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        Self::sum([a, d, b, e, c, f])
    }
}

impl Mul for Triple {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let ([a, b, c], [d, e, f]) = (self.0, other.0);
        let (ad, ae, bd) = (Dd::product(a, d), Dd::product(a, e), Dd::product(b, d));
        let be = Dd::product(b, e);
        let small = a * f + c * d + (b * f + c * e);
        Self::sum([
            ad.high(),
            ad.low(),
            ae.high(),
            bd.high(),
            ae.low(),
            bd.low(),
            be.high(),
            small,
        ])
    }
}

/// The arithmetic-geometric mean of 1 and k′ in three words, for mc > 0.
fn mean(parameter: Parameter) -> Triple {
    let (m, mc) = (parameter.m_dd(), parameter.mc_dd());
    // The greater of m and mc is formed again from the lesser, whose 106 bits are exact.
    let (mc, power) = if m.value() <= mc.value() {
        let mc = Triple::sum([1.0, -m.high(), -m.low(), 0.0]);
        (mc, 1.0)
    } else {
        // √mc from a number near 1, so that no word underflows.
        let exponent = (mc.high().log2() * 0.5).floor() as i32;
        let step = 0.5_f64.powi(exponent);
        (Triple::pair(mc.scaled(step).scaled(step)), 1.0 / step)
    };
    let mut a = Triple([1.0, 0.0, 0.0]);
    let mut b = mc.square_root().scaled(power);
    // The least mc takes twelve rounds. The last mean squares the remaining gap once more.
    for _ in 0..16 {
        let next = (a + b).scaled(0.5);
        let gap = (a + b.scaled(-1.0)).0[0];
        if gap < 1e-25 * a.0[0] {
            return next;
        }
        b = (a * b).square_root();
        a = next;
    }
    a
}

/// `u − count K`, where the prepared K leaves too few bits: u times the mean, less `count` right angles, over the mean.
pub(super) fn remainder(parameter: Parameter, u: Dd, count: f64) -> Dd {
    let mean = mean(parameter);
    let right_angle = Triple([RIGHT_ANGLE.high(), RIGHT_ANGLE.low(), RIGHT_ANGLE_REST]);
    let rest = Triple::pair(u) * mean + right_angle * Triple([-count, 0.0, 0.0]);
    rest.leading() / mean.leading()
}
