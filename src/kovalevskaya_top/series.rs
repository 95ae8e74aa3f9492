//! Cosine series of even periodic functions: quadratures prepared once, exact to rounding.

use nalgebra::Complex;

/// ∫₀^f of `N` even functions of period 2π together: mean·f + Σ bₙ sin nf for each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quadratures<const N: usize> {
    /// Mean values of the integrands: the integrals gain 2π of them in each turn.
    pub means: [f64; N],
    /// The coefficients b₁, b₂, ….
    sines: Vec<[f64; N]>,
}

/// Longest series that is tried.
const LONGEST: usize = 1 << 15;

impl<const N: usize> Quadratures<N> {
    /// The integrals of functions given together at each argument; none if they need more than 2¹⁵ terms.
    ///
    /// Ordinates at f = πj/n, their cosine series by a fast Fourier transform, n doubled until the last eighth of the terms is
    /// at rounding level.
    pub fn prepare(functions: impl Fn(f64) -> [f64; N]) -> Option<Self> {
        let mut n = 32;
        while n <= LONGEST {
            let ordinates: Vec<[f64; N]> = (0..=n)
                .map(|j| functions(core::f64::consts::PI * j as f64 / n as f64))
                .collect();
            let series: [Vec<f64>; N] = core::array::from_fn(|i| {
                let column: Vec<f64> = ordinates.iter().map(|row| row[i]).collect();
                cosine_coefficients(&column)
            });
            let done = series.iter().all(|a| {
                let largest = a.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                let tail = a[n - n / 8..].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                tail <= 2.0 * f64::EPSILON * largest
            });
            if done {
                return Some(Self::of_cosines(&series));
            }
            n *= 2;
        }
        None
    }

    /// The integrals of zero.
    pub fn empty() -> Self {
        Self {
            means: [0.0; N],
            sines: Vec::new(),
        }
    }

    fn of_cosines(series: &[Vec<f64>; N]) -> Self {
        let largest: [f64; N] =
            core::array::from_fn(|i| series[i].iter().fold(0.0_f64, |m, x| m.max(x.abs())));
        let mut sines: Vec<[f64; N]> = (1..series[0].len())
            .map(|n| core::array::from_fn(|i| series[i][n] / n as f64))
            .collect();
        // Below this the terms are the rounding of the transform.
        let small = |b: &[f64; N]| (0..N).all(|i| b[i].abs() < 2e-18 * largest[i]);
        while sines.last().is_some_and(small) {
            sines.pop();
        }
        Self {
            means: core::array::from_fn(|i| series[i][0]),
            sines,
        }
    }

    /// How far the integrals can be from their growing parts.
    pub fn bounds(&self) -> [f64; N] {
        let sum = |i: usize| self.sines.iter().map(|b| b[i].abs()).sum();
        core::array::from_fn(sum)
    }

    /// The integrals from 0 to `f`, less the parts that grow: Σ bₙ sin nf by Clenshaw's recurrence.
    pub fn periodic(&self, f: f64) -> [f64; N] {
        let (sine, cosine) = f.sin_cos();
        let (mut last, mut one_before) = ([0.0; N], [0.0; N]);
        for b in self.sines.iter().rev() {
            let next = core::array::from_fn(|i| 2.0 * cosine * last[i] - one_before[i] + b[i]);
            (last, one_before) = (next, last);
        }
        last.map(|x| x * sine)
    }

    /// The integrals from 0 to `f`.
    pub fn whole(&self, f: f64) -> [f64; N] {
        let periodic = self.periodic(f);
        core::array::from_fn(|i| self.means[i] * f + periodic[i])
    }
}

/// Coefficients a₀ … aₙ₋₁ of Σ aⱼ cos jf through n + 1 ordinates at f = πj/n, n a power of two.
fn cosine_coefficients(ordinates: &[f64]) -> Vec<f64> {
    let n = ordinates.len() - 1;
    let mut values: Vec<Complex<f64>> = (0..2 * n)
        .map(|j| Complex::new(ordinates[j.min(2 * n - j)], 0.0))
        .collect();
    transform(&mut values, &roots_of_unity(2 * n));
    (0..n)
        .map(|j| values[j].re / if j == 0 { 2 * n } else { n } as f64)
        .collect()
}

/// e^{−2πij/n} for the first half of j.
pub(super) fn roots_of_unity(n: usize) -> Vec<Complex<f64>> {
    let turn = -core::f64::consts::TAU / n as f64;
    // Each from its own angle: a recurrence would lose a digit over long series.
    let root = |j: usize| {
        let (sine, cosine) = (turn * j as f64).sin_cos();
        Complex::new(cosine, sine)
    };
    (0..n / 2).map(root).collect()
}

/// The fast Fourier transform of n = 2ᵐ values in place (Cooley and Tukey), with the roots of unity for n.
pub(super) fn transform(values: &mut [Complex<f64>], roots: &[Complex<f64>]) {
    let n = values.len();
    let bits = n.trailing_zeros();
    for i in 0..n {
        let j = i.reverse_bits() >> (usize::BITS - bits);
        if i < j {
            values.swap(i, j);
        }
    }
    let mut length = 2;
    while length <= n {
        for start in (0..n).step_by(length) {
            let (low, high) = values[start..start + length].split_at_mut(length / 2);
            let factors = roots.iter().step_by(n / length);
            for ((a, b), factor) in low.iter_mut().zip(high).zip(factors) {
                let product = *b * factor;
                (*a, *b) = (*a + product, *a - product);
            }
        }
        length *= 2;
    }
}
