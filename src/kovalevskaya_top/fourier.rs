//! Fourier series in two angles: the fast transform over a grid, and the sum of the terms that count.

use nalgebra::Complex;

use super::series::{roots_of_unity, transform};

type Number = Complex<f64>;

/// Functions at the places u₁ = 2πi/n₁, u₂ = 2πj/n₂ in rows of constant i, or their coefficients in the same order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Grid {
    /// n₁ and n₂, powers of two.
    pub size: [usize; 2],
}

impl Grid {
    pub fn count(self) -> usize {
        self.size[0] * self.size[1]
    }

    /// Where (i, j) is found; both return to 0.
    pub fn place(self, i: usize, j: usize) -> usize {
        i % self.size[0] * self.size[1] + j % self.size[1]
    }

    /// The wave numbers k₁, k₂ of the coefficient at a place, each from −n/2 to n/2 − 1.
    pub fn waves(self, place: usize) -> [i32; 2] {
        let signed = |k: usize, n: usize| {
            if 2 * k < n {
                k as i32
            } else {
                k as i32 - n as i32
            }
        };
        let [rows, columns] = self.size;
        [
            signed(place / columns, rows),
            signed(place % columns, columns),
        ]
    }

    /// Where the coefficient of (−k₁, −k₂) is found.
    pub fn opposite(self, place: usize) -> usize {
        let [rows, columns] = self.size;
        self.place(rows - place / columns, columns - place % columns)
    }

    /// Coefficients of Σ c_k e^{ik·u} through ordinates.
    pub fn coefficients(self, mut ordinates: Vec<Number>) -> Vec<Number> {
        self.transform(&mut ordinates);
        let share = 1.0 / self.count() as f64;
        ordinates.iter().map(|x| x * share).collect()
    }

    /// Ordinates of Σ c_k e^{ik·u}: the same transform of the conjugates.
    pub fn ordinates(self, coefficients: &[Number]) -> Vec<Number> {
        let mut values: Vec<Number> = coefficients.iter().map(Number::conj).collect();
        self.transform(&mut values);
        values.iter().map(Number::conj).collect()
    }

    fn transform(self, values: &mut [Number]) {
        let [rows, columns] = self.size;
        let roots = roots_of_unity(columns);
        for row in values.chunks_exact_mut(columns) {
            transform(row, &roots);
        }
        let roots = roots_of_unity(rows);
        let mut column = vec![Number::default(); rows];
        for j in 0..columns {
            for (i, x) in column.iter_mut().enumerate() {
                *x = values[self.place(i, j)];
            }
            transform(&mut column, &roots);
            for (i, x) in column.iter().enumerate() {
                values[self.place(i, j)] = *x;
            }
        }
    }

    /// How much is left of coefficients in the last eighth of the waves, along each angle.
    pub fn tails(self, coefficients: &[Number]) -> [f64; 2] {
        let mut tails = [0.0_f64; 2];
        for (place, c) in coefficients.iter().enumerate() {
            for (axis, k) in self.waves(place).into_iter().enumerate() {
                if 16 * k.unsigned_abs() as usize > 7 * self.size[axis] {
                    tails[axis] = tails[axis].max(c.norm());
                }
            }
        }
        tails
    }
}

/// `N` real functions of two angles together: a mean and Re Σ over half of the waves.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DoubleSeries<const N: usize> {
    mean: [f64; N],
    rows: Vec<Row<N>>,
}

/// Terms with one k₁ and with k₂ = first, first + step, ….
#[derive(Debug, Clone, PartialEq)]
struct Row<const N: usize> {
    k1: i32,
    first: i32,
    step: i32,
    /// Real and imaginary parts of the coefficients.
    terms: Vec<[[f64; N]; 2]>,
}

impl<const N: usize> DoubleSeries<N> {
    /// The series with these coefficients of positive k₁, and of positive k₂ where k₁ = 0; `term` returns none for what is too small to count.
    pub fn collect(
        grid: Grid,
        mean: [f64; N],
        term: impl Fn(usize) -> Option<[Number; N]>,
    ) -> Self {
        let [rows, columns] = grid.size.map(|n| n as i32 / 2);
        let rows = (0..rows)
            .filter_map(|k1| {
                let least = if k1 == 0 { 1 } else { 1 - columns };
                let at = |k2: i32| grid.place(k1 as usize, k2.rem_euclid(2 * columns) as usize);
                Row::trimmed(k1, (least..columns).map(|k2| (k2, term(at(k2)))))
            })
            .collect();
        Self { mean, rows }
    }

    /// How many terms there are.
    pub fn len(&self) -> usize {
        self.rows.iter().map(|row| row.terms.len()).sum()
    }

    /// The functions at two angles: Horner's scheme in e^{iu₂} along each row.
    pub fn at(&self, [u1, u2]: [f64; 2]) -> [f64; N] {
        let unit = |angle: f64| {
            let (sine, cosine) = angle.sin_cos();
            Number::new(cosine, sine)
        };
        let ratios = [unit(u2), unit(2.0 * u2)];
        let mut sum = self.mean;
        for row in &self.rows {
            let ratio = ratios[row.step as usize - 1];
            // The functions side by side, so that they are computed at once.
            let (mut re, mut im) = ([0.0; N], [0.0; N]);
            for [c_re, c_im] in row.terms.iter().rev() {
                for n in 0..N {
                    let (x, y) = (re[n], im[n]);
                    re[n] = (x * ratio.re - y * ratio.im) + c_re[n];
                    im[n] = (x * ratio.im + y * ratio.re) + c_im[n];
                }
            }
            let factor = unit(f64::from(row.k1) * u1 + f64::from(row.first) * u2);
            for n in 0..N {
                sum[n] += re[n] * factor.re - im[n] * factor.im;
            }
        }
        sum
    }
}

impl<const N: usize> Row<N> {
    /// Without the terms that are none at both ends, and without every other one if those are none throughout, as half turns make them.
    fn trimmed(k1: i32, terms: impl Iterator<Item = (i32, Option<[Number; N]>)>) -> Option<Self> {
        let all: Vec<_> = terms.collect();
        let first = all.iter().position(|(_, term)| term.is_some())?;
        let last = all.iter().rposition(|(_, term)| term.is_some())?;
        let all = &all[first..=last];
        let sparse = all
            .iter()
            .skip(1)
            .step_by(2)
            .all(|(_, term)| term.is_none());
        let step = if sparse { 2 } else { 1 };
        Some(Self {
            k1,
            first: all[0].0,
            step: step as i32,
            terms: all
                .iter()
                .step_by(step)
                .map(|(_, term)| {
                    let term = term.unwrap_or([Number::default(); N]);
                    [term.map(|c| c.re), term.map(|c| c.im)]
                })
                .collect(),
        })
    }
}
