//! Cosine series of even periodic functions: quadratures prepared once, exact to rounding.

use nalgebra::Complex;

/// ∫₀^f of an even function of period 2π: mean·f + Σ bₙ sin nf.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quadrature {
    /// Mean value of the integrand: the integral gains 2π of it in each turn.
    pub mean: f64,
    /// The coefficients b₁, b₂, ….
    sines: Vec<f64>,
}

/// Longest series that is tried.
const LONGEST: usize = 1 << 15;

impl Quadrature {
    /// The integrals of `N` functions given together at each argument; none if they need more than 2¹⁵ terms.
    ///
    /// Ordinates at f = πj/n, their cosine series by a fast Fourier transform, n doubled until the last eighth of the terms is
    /// at rounding level.
    pub fn prepare<const N: usize>(functions: impl Fn(f64) -> [f64; N]) -> Option<[Self; N]> {
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
                return Some(series.map(Self::of_cosines));
            }
            n *= 2;
        }
        None
    }

    /// The integral of zero.
    pub fn empty() -> Self {
        Self {
            mean: 0.0,
            sines: Vec::new(),
        }
    }

    fn of_cosines(a: Vec<f64>) -> Self {
        let mut sines: Vec<f64> = (1..a.len()).map(|n| a[n] / n as f64).collect();
        let largest = a.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        // Below this the terms are the rounding of the transform, and no longer than they need to be for the sum.
        while sines.last().is_some_and(|b| b.abs() < 2e-18 * largest) {
            sines.pop();
        }
        Self { mean: a[0], sines }
    }

    /// How far the integral can be from its growing part.
    pub fn bound(&self) -> f64 {
        self.sines.iter().map(|b| b.abs()).sum()
    }

    /// The integral from 0 to `f`, less the part that grows: Σ bₙ sin nf by Clenshaw's recurrence.
    pub fn periodic(&self, f: f64) -> f64 {
        let (sine, cosine) = f.sin_cos();
        let (mut last, mut one_before) = (0.0, 0.0);
        for b in self.sines.iter().rev() {
            (last, one_before) = (2.0 * cosine * last - one_before + b, last);
        }
        last * sine
    }
}

/// Coefficients a₀ … aₙ₋₁ of Σ aⱼ cos jf through n + 1 ordinates at f = πj/n, n a power of two.
fn cosine_coefficients(ordinates: &[f64]) -> Vec<f64> {
    let n = ordinates.len() - 1;
    let mut values: Vec<Complex<f64>> = (0..2 * n)
        .map(|j| Complex::new(ordinates[j.min(2 * n - j)], 0.0))
        .collect();
    transform(&mut values);
    (0..n)
        .map(|j| values[j].re / if j == 0 { 2 * n } else { n } as f64)
        .collect()
}

/// The fast Fourier transform of 2ⁿ values in place (Cooley and Tukey).
fn transform(values: &mut [Complex<f64>]) {
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
        let turn = -core::f64::consts::TAU / length as f64;
        for j in 0..length / 2 {
            // Each factor from its own angle: a recurrence would lose a digit over long series.
            let (sine, cosine) = (turn * j as f64).sin_cos();
            let factor = Complex::new(cosine, sine);
            for start in (j..n).step_by(length) {
                let (a, b) = (values[start], values[start + length / 2] * factor);
                values[start] = a + b;
                values[start + length / 2] = a - b;
            }
        }
        length *= 2;
    }
}
