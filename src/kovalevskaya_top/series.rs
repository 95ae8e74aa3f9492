//! Cosine series of even periodic functions: quadratures prepared once, exact to rounding.

use core::f64::consts::PI;

use nalgebra::Complex;

/// ∫₀^f of `N` even functions of period 2π together: mean·f + Σ bₙ sin nf for each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quadratures<const N: usize> {
    /// Mean values of the integrands: the integrals gain 2π of them in each turn.
    pub means: [f64; N],
    /// The coefficients b₁, b₂, ….
    sines: Vec<[f64; N]>,
}

/// Longest series that is tried for the motion itself.
pub(super) const LONGEST: usize = 1 << 10;

impl<const N: usize> Quadratures<N> {
    /// The integrals of functions given together at each argument; none if they need more terms than `longest`.
    ///
    /// Ordinates at f = πj/n, their cosine series by a fast Fourier transform, n doubled until the last eighth of the terms is
    /// at rounding level.
    pub fn prepare(longest: usize, functions: impl Fn(f64) -> [f64; N]) -> Option<Self> {
        let mut n = 32;
        let at = |j: usize, n: usize| functions(PI * j as f64 / n as f64);
        let mut ordinates: Vec<[f64; N]> = (0..=n).map(|j| at(j, n)).collect();
        while n <= longest {
            let series = cosine_coefficients(&ordinates);
            let done = series.iter().all(|a| {
                let largest = a.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                let tail = a[n - n / 8..].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                tail <= 2.0 * f64::EPSILON * largest
            });
            if done {
                return Some(Self::of_cosines(&series));
            }
            n *= 2;
            // Every other one is known.
            ordinates = (0..=n)
                .map(|j| {
                    if j % 2 == 0 {
                        ordinates[j / 2]
                    } else {
                        at(j, n)
                    }
                })
                .collect();
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
}

/// Coefficients a₀ … aₙ₋₁ of Σ aⱼ cos jf through n + 1 ordinates at f = πj/n of each function, n a power of two.
///
/// Two functions go through one transform: those of even functions are real.
fn cosine_coefficients<const N: usize>(ordinates: &[[f64; N]]) -> [Vec<f64>; N] {
    let n = ordinates.len() - 1;
    let roots = roots_of_unity(2 * n);
    let mut series = [(); N].map(|()| Vec::new());
    let largest = |i: usize| ordinates.iter().fold(0.0_f64, |m, row| m.max(row[i].abs()));
    for pair in 0..N.div_ceil(2) {
        let (first, second) = (2 * pair, (2 * pair + 1).min(N - 1));
        // Of one size, lest the rounding of the greater show in the smaller.
        let scale = largest(first) / largest(second).max(f64::MIN_POSITIVE);
        let mut values: Vec<Complex<f64>> = (0..2 * n)
            .map(|j| ordinates[j.min(2 * n - j)])
            .map(|ordinate| Complex::new(ordinate[first], scale * ordinate[second]))
            .collect();
        transform(&mut values, &roots);
        let share = |j: usize| 1.0 / if j == 0 { 2 * n } else { n } as f64;
        series[second] = (0..n).map(|j| values[j].im / scale * share(j)).collect();
        series[first] = (0..n).map(|j| values[j].re * share(j)).collect();
    }
    series
}

/// e^{−2πij/n} for the first half of j.
fn roots_of_unity(n: usize) -> Vec<Complex<f64>> {
    let turn = -core::f64::consts::TAU / n as f64;
    // Each from its own angle: a recurrence would lose a digit over long series.
    let root = |j: usize| {
        let (sine, cosine) = (turn * j as f64).sin_cos();
        Complex::new(cosine, sine)
    };
    (0..n / 2).map(root).collect()
}

/// The fast Fourier transform of n = 2ᵐ values in place (Cooley and Tukey), with the roots of unity for n.
fn transform(values: &mut [Complex<f64>], roots: &[Complex<f64>]) {
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
