//! Gauss's transformation in one word or two: from a parameter of at most 1/2 to parameter 0 in three steps and a remainder.
//!
//! Each step replaces the modulus k by k₁ = (1 − k′)/(1 + k′) and divides both K and u by 1 + k₁, so that z = πu/(2K) stays.
//! At the end K is π/2 and sn z is sin z. The mean of 1 and k′, the nome and the functions of z all come from the same steps.

use crate::precise::{DoubleDouble, Number, RIGHT_ANGLE, Words};

/// The moduli on the way down.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Landen<N: Number> {
    /// 1 + k′ₙ for n = 0, 1, 2.
    pub(super) sums: [N::Narrow; 3],
    /// k₁ and k₂; k₃² fits a double, since it enters as a correction of at most 2·10⁻¹⁰.
    pub(super) moduli: [N::Narrow; 2],
    pub(super) last: f64,
    /// The arithmetic-geometric mean of 1 and k′: π/(2K).
    pub(crate) mean: N::Narrow,
    /// The nome divided by k².
    pub(super) nome_over_square: N::Narrow,
    pub(super) parameter: N,
    /// The nome q = exp(−πK′/K); zero where it underflows.
    pub(crate) nome: N::Narrow,
}

impl<N: Number> Landen<N> {
    /// For the parameter m = k² ≤ 1/2 and the complementary modulus k′, both to all the digits of their kind.
    #[inline(always)]
    pub(crate) fn new(parameter: N, complement: N::Narrow) -> Self {
        let one = N::Narrow::from_double(1.0);
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
        let k3 = (k2.leading() / sum2.leading()).powi(2);
        let last = k3 * k3;
        // (1 + k′₃)(1 + k′₄)/4 with k₄ = k₃²/4; the next term is 10⁻³⁰.
        let rest = N::Narrow::from_double(-0.25 * last * (1.0 + 0.3125 * last));
        let mean = (sum0 * sum1 * sum2).scaled(0.125);
        let mean = mean.add_alike(mean * rest);
        // l = (1 − √k′)/(2(1 + √k′)); q = l + 2l⁵ + 15l⁹ + 150l¹³ + 1707l¹⁷ + …
        let l_over_square = (inverse0_squared * inverse1).scaled(0.5);
        let l = square * l_over_square;
        let l2 = l * l;
        let l4 = l2 * l2;
        let x = l4.leading();
        let tail = x * x * (15.0 + x * (150.0 + x * (1707.0 + x * 20_910.0)));
        let series = one
            .add_alike(l4.scaled(2.0))
            .add_alike(N::Narrow::from_double(tail));
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

    /// √q for the modulus k, as a double: still there where q underflows.
    #[inline(always)]
    pub(crate) fn root_of_nome(&self, k: f64) -> f64 {
        k * self.nome_over_square.value().sqrt()
    }

    /// The quarter period K = π/(2 mean).
    pub(crate) fn quarter(&self) -> DoubleDouble {
        N::Narrow::from_two(RIGHT_ANGLE).quotient(self.mean).two()
    }

    /// The quarter period of the complementary modulus, K′ = (K/π) ln(1/q), also where q itself underflows; infinite for k = 0.
    pub(crate) fn complementary_quarter(&self) -> DoubleDouble {
        if self.parameter.is_zero() {
            return DoubleDouble::from(f64::INFINITY);
        }
        let nome = self.parameter * N::from_narrow(self.nome_over_square);
        let logarithm = -nome.logarithm();
        logarithm.quotient(self.mean.scaled(2.0)).two()
    }

    /// sin z from sn u and dn u, z = πu/(2K).
    #[inline(always)]
    pub(crate) fn sine(&self, sn: N::Narrow, dn: N::Narrow) -> N::Narrow {
        self.descend(sn, dn, 1.0)
    }

    /// sinh x from −i sn(iy) = sc(y, k′) and dn(iy) = dc(y, k′), x = πy/(2K).
    #[inline(always)]
    pub(crate) fn hyperbolic_sine(&self, sc: N::Narrow, dc: N::Narrow) -> N::Narrow {
        self.descend(sc, dc, -1.0)
    }

    /// sin z, or sinh x if `sign` is −1, as a double: good for one place, not for a rate.
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

    #[inline(always)]
    fn descend(&self, start: N::Narrow, delta: N::Narrow, sign: f64) -> N::Narrow {
        let one = N::Narrow::from_double(1.0);
        let (mut s, mut d) = (start, delta);
        for (sum, modulus) in self.sums.iter().zip(&self.moduli) {
            s = (s * *sum).quotient(one.add_alike(d));
            let ks = s * *modulus;
            let square = (ks * ks).scaled(sign);
            d = one.add_alike(-square).square_root();
        }
        s = (s * self.sums[2]).quotient(one.add_alike(d));
        // The rest of the way: (1 + k′₃)/(1 + √(1 − k₃² s²)) and one factor more, both 1 up to 4·10⁻¹⁰.
        let a = self.last;
        let b = sign * (self.scaled_square(s, a));
        let correction =
            -0.25 * (a - b) + a * (-a / 16.0 - b / 16.0) + b * b / 8.0 - a * (a - b) / 64.0;
        s.add_alike(s * N::Narrow::from_double(correction))
    }

    /// a s², where s² alone may overflow.
    #[inline(always)]
    fn scaled_square(&self, s: N::Narrow, a: f64) -> f64 {
        let root = a.sqrt() * s.leading();
        root * root
    }
}
