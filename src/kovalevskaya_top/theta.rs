//! Riemann's theta function of two variables on the real torus (8.2).

use core::f64::consts::{PI, TAU};

use nalgebra::Complex;

type Number = Complex<f64>;

/// Σ exp(−π(n−n₀)·Y(n−n₀)) e^{2πi n·w} over whole n₁, n₂, apart by whether n₁ and n₂ are even: θ(w − iy) with n₀ = Y⁻¹y, but for a constant factor.
///
/// The terms fall like a Gauss curve, so that some eighty are enough; the series of a quotient of two such sums would take a thousand.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Theta {
    rows: Vec<Row>,
}

/// Terms of one n₁, and of n₂ = 2·first, 2·first + 1, …, by pairs.
#[derive(Debug, Clone, PartialEq)]
struct Row {
    n1: i32,
    first: i32,
    pairs: Vec<[f64; 2]>,
}

/// The four partial sums, of even and odd n₁ by even and odd n₂: (0,0), (0,1), (1,0), (1,1).
pub(super) type Sums = [Number; 4];

/// Exponents −πx beyond which a term is left out: e^{−πx} is 1e-19.
const REACH: f64 = 14.0;

/// The most terms.
const LARGEST: f64 = 4096.0;

impl Theta {
    /// None if Y is not positive or so small that more than 4096 terms count.
    pub fn prepare([[a, b], [_, c]]: [[f64; 2]; 2], [y1, y2]: [f64; 2]) -> Option<Self> {
        let determinant = a * c - b * b;
        // A Y that is not a number is refused as well.
        if !(a > 0.0 && determinant > 0.0 && PI * REACH < LARGEST * determinant.sqrt()) {
            return None;
        }
        let center = [
            (c * y1 - b * y2) / determinant,
            (a * y2 - b * y1) / determinant,
        ];
        // a d₁² + 2b d₁d₂ + c d₂² = (determinant/c) d₁² + c (d₂ + b d₁/c)².
        let least = determinant / c;
        let reach = (REACH / least).sqrt();
        let [low, high] = [center[0] - reach, center[0] + reach].map(f64::round);
        let mut rows = Vec::new();
        for n1 in low as i32..=high as i32 {
            let d1 = f64::from(n1) - center[0];
            let middle = center[1] - b * d1 / c;
            let reach = ((REACH - least * d1 * d1).max(0.0) / c).sqrt();
            let first = (0.5 * (middle - reach)).floor() as i32;
            let last = (0.5 * (middle + reach)).floor() as i32;
            let term = |n2: i32| {
                let d2 = f64::from(n2) - middle;
                (-PI * (least * d1 * d1 + c * d2 * d2)).exp()
            };
            let pairs = (first..=last)
                .map(|n| [term(2 * n), term(2 * n + 1)])
                .collect();
            rows.push(Row { n1, first, pairs });
        }
        Some(Self { rows })
    }

    /// How many terms there are.
    pub fn len(&self) -> usize {
        self.rows.iter().map(|row| 2 * row.pairs.len()).sum()
    }

    /// The sums at a real w: Horner's scheme in e^{4πiw₂} along each row.
    pub fn at(&self, [w1, w2]: [f64; 2]) -> Sums {
        let step = unit(w2);
        let ratio = step * step;
        let mut sums = [Number::default(); 4];
        for row in &self.rows {
            let [mut even, mut odd] = [Number::default(); 2];
            for &[c0, c1] in row.pairs.iter().rev() {
                even = Number::new(
                    even.re * ratio.re - even.im * ratio.im + c0,
                    even.re * ratio.im + even.im * ratio.re,
                );
                odd = Number::new(
                    odd.re * ratio.re - odd.im * ratio.im + c1,
                    odd.re * ratio.im + odd.im * ratio.re,
                );
            }
            let factor = unit(f64::from(row.n1) * w1 + f64::from(2 * row.first) * w2);
            let at = 2 * (row.n1 & 1) as usize;
            sums[at] += even * factor;
            sums[at + 1] += odd * factor * step;
        }
        sums
    }

    /// The sums, and their rates if w changes at these rates.
    pub fn with_rates(&self, [w1, w2]: [f64; 2], [r1, r2]: [f64; 2]) -> [Sums; 2] {
        let mut found = [[Number::default(); 4]; 2];
        let step = unit(w2);
        for row in &self.rows {
            let mut wave = unit(f64::from(row.n1) * w1 + f64::from(2 * row.first) * w2);
            for (k, pair) in row.pairs.iter().enumerate() {
                for (odd, c) in pair.iter().enumerate() {
                    let n2 = 2 * (row.first + k as i32) + odd as i32;
                    let place = 2 * (row.n1 & 1) as usize + odd;
                    let term = wave * *c;
                    let rate = TAU * (f64::from(row.n1) * r1 + f64::from(n2) * r2);
                    found[0][place] += term;
                    found[1][place] += Number::new(-term.im, term.re) * rate;
                    wave *= step;
                }
            }
        }
        found
    }
}

/// e^{2πix}.
fn unit(turns: f64) -> Number {
    let (sine, cosine) = (TAU * turns).sin_cos();
    Number::new(cosine, sine)
}
