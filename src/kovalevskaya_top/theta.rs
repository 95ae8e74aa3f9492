//! Riemann's theta function of two variables on the real torus (8.2).

use core::f64::consts::{PI, TAU};

use nalgebra::Complex;

type Number = Complex<f64>;

/// Σ exp(−π(n−n₀)·Y(n−n₀)) e^{2πi n·w} over whole n₁, n₂, apart by whether n₁ and n₂ are even: θ(w − iy) with n₀ = Y⁻¹y, but for a constant factor.
///
/// The terms fall like a Gauss curve, so that some sixty are enough; the series of a quotient of two such sums would take a thousand.
/// They are summed outward from n = 0, next to which the greatest are, so that rounding of the high powers does not show.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Theta {
    /// n₁ = 0, 1, … and n₁ = −1, −2, ….
    rows: [Vec<Row>; 2],
}

/// Terms of one n₁, and n₂ times each: of n₂ = 2j, 2j + 1, −2j − 2 and −2j − 1 for j = 0, 1, ….
type Row = Vec<[[f64; 4]; 2]>;

/// The four partial sums, of even and odd n₁ by even and odd n₂: (0,0), (0,1), (1,0), (1,1).
pub(super) type Sums = [Number; 4];

/// Exponents −πx beyond which a term is left out: e^{−πx} is 1e-19.
const REACH: f64 = 14.0;

/// The most terms.
const LARGEST: f64 = 4096.0;

impl Theta {
    /// For |n₀| not above ½ in either component. None if Y is not positive or so small that more than 4096 terms count.
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
        if !center.iter().all(|x| x.is_finite()) {
            return None;
        }
        // a d₁² + 2b d₁d₂ + c d₂² = (determinant/c) d₁² + c (d₂ + b d₁/c)².
        let least = determinant / c;
        let row = |n1: i32| -> Option<Row> {
            let d1 = f64::from(n1) - center[0];
            let rest = REACH - least * d1 * d1;
            if rest < 0.0 {
                return None;
            }
            let middle = center[1] - b * d1 / c;
            let farthest = (rest / c).sqrt() + middle.abs();
            let term = |n2: i32| {
                let d2 = f64::from(n2) - middle;
                (-PI * (least * d1 * d1 + c * d2 * d2)).exp()
            };
            let terms = (0..=(0.5 * farthest) as i32).map(|j| {
                let orders = [2 * j, 2 * j + 1, -2 * j - 2, -2 * j - 1];
                let terms = orders.map(term);
                [terms, [0, 1, 2, 3].map(|k| f64::from(orders[k]) * terms[k])]
            });
            Some(terms.collect())
        };
        let upward = (0..).map_while(row).collect();
        let downward = (1..).map_while(|n| row(-n)).collect();
        Some(Self {
            rows: [upward, downward],
        })
    }

    /// The sums for e^{2πiw₁} and e^{2πiw₂}.
    pub fn at(&self, z: [Number; 2]) -> Sums {
        let mut sums = Sums::default();
        self.each_row(z[0], |n1, power, row| {
            let place = 2 * (n1 & 1) as usize;
            for (k, value) in along(z[1], row)[0].iter().enumerate() {
                sums[place + k] += power * value;
            }
        });
        sums
    }

    /// The sums, and their rates if w changes at these rates.
    pub fn with_rates(&self, z: [Number; 2], [r1, r2]: [f64; 2]) -> [Sums; 2] {
        let [mut sums, mut rates] = [Sums::default(); 2];
        self.each_row(z[0], |n1, power, row| {
            let place = 2 * (n1 & 1) as usize;
            let [values, slopes] = along(z[1], row);
            for k in 0..2 {
                sums[place + k] += power * values[k];
                rates[place + k] += power * (values[k] * (r1 * f64::from(n1)) + slopes[k] * r2);
            }
        });
        [sums, rates.map(|rate| Number::new(0.0, TAU) * rate)]
    }

    /// Every row with its n₁ and the power z^{n₁}.
    fn each_row(&self, z: Number, mut take: impl FnMut(i32, Number, &Row)) {
        let [upward, downward] = &self.rows;
        let mut power = Number::new(1.0, 0.0);
        for (n, row) in (0..).zip(upward) {
            take(n, power, row);
            power *= z;
        }
        power = z.conj();
        for (n, row) in (1..).zip(downward) {
            take(-n, power, row);
            power *= z.conj();
        }
    }
}

/// The sums over even and over odd n₂ of the terms times z^{n₂}, |z| = 1, and those of n₂ times each.
#[inline(always)]
fn along(z: Number, row: &Row) -> [[Number; 2]; 2] {
    let ratio = z * z;
    let turn = [ratio.im, ratio.im, -ratio.im, -ratio.im];
    let mut re = [1.0, z.re, ratio.re, z.re];
    let mut im = [0.0, z.im, -ratio.im, -z.im];
    let mut sums = [[0.0; 4]; 4];
    for (j, [terms, slopes]) in row.iter().enumerate() {
        for k in 0..4 {
            if j > 0 {
                let (x, y) = (re[k], im[k]);
                re[k] = x * ratio.re - y * turn[k];
                im[k] = x * turn[k] + y * ratio.re;
            }
            sums[0][k] += terms[k] * re[k];
            sums[1][k] += terms[k] * im[k];
            sums[2][k] += slopes[k] * re[k];
            sums[3][k] += slopes[k] * im[k];
        }
    }
    let sum = |of: usize, k: usize| {
        let [re, im] = [sums[of], sums[of + 1]].map(|x| x[k] + x[k + 2]);
        Number::new(re, im)
    };
    [[sum(0, 0), sum(0, 1)], [sum(2, 0), sum(2, 1)]]
}

/// θ with half periods after the modular transformation in the one direction in which Y is small.
///
/// Σ exp(−πn·Yn + 2πi n·w) over n₁ is, by Poisson's formula, a sum of e^{−π(w₁+k)²/a}, a = Y₁₁, and with n₂ left it is such a sum of theta functions of one variable,
/// at w₂ − (w₁+k)b/a. As a comes to 0 one or two of them are left. A half period τ/2 in that direction changes the signs of those of odd k, so that two functions that differ by it
/// are the sum and the difference of two sums that have no term in common.
///
/// Where Re τ is ½ everywhere, that is a sum over two shifts of w by a half apart, and the two sums are those of either.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pinched {
    /// m of the half period ½τm that is small.
    measure: [u8; 2],
    /// a, b/a.
    width: f64,
    slope: f64,
    /// e^{−πn²(c − b²/a)} for n = 0, ½, 1, ….
    terms: Vec<f64>,
    twisted: bool,
}

impl Pinched {
    pub fn prepare(
        [[a, b], [_, c]]: [[f64; 2]; 2],
        measure: [u8; 2],
        twisted: bool,
    ) -> Option<Self> {
        // Y in a basis of which the measure is the first.
        let [width, mixed] = match measure {
            [1, 0] => [a, b],
            [0, 1] => [c, b],
            _ => [a + 2.0 * b + c, b + c],
        };
        let rest = (a * c - b * b) / width;
        if !(width > 0.0 && rest > 0.0 && REACH / rest < LARGEST) {
            return None;
        }
        let term = |n: i32| (-0.25 * PI * rest * f64::from(n * n)).exp();
        Some(Self {
            measure,
            width,
            slope: mixed / width,
            terms: (0..2 + (4.0 * REACH / rest).sqrt() as i32)
                .map(term)
                .collect(),
            twisted,
        })
    }

    /// Phases in that basis.
    fn along(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self.measure {
            [1, 0] => [x, y],
            [0, 1] => [y, x],
            _ => [x + y, y],
        }
    }

    /// The two sums of the function with half periods n and m at w, each with its rate if w changes at these rates.
    pub fn parts(&self, n: [u8; 2], m: [u8; 2], w: [f64; 2], rates: [f64; 2]) -> [[Number; 2]; 2] {
        let [r1, r2] = self.along(rates);
        let turn = r2 - self.slope * r1;
        let [signed, odd] = match self.measure {
            [1, 0] => m,
            [0, 1] => [m[1], m[0]],
            _ => [m[0], m[0] ^ m[1]],
        };
        let shifts = if !self.twisted {
            [(0.0, Number::from(1.0)); 2]
        } else if m[0] == m[1] {
            [(0.0, Number::new(0.5, 0.5)), (0.5, Number::new(0.5, -0.5))]
        } else {
            [0.25, -0.25].map(|x| (x, Number::from(0.5_f64.sqrt())))
        };
        let reach = (REACH * self.width).sqrt() + 1.0;
        [0, 1].map(|class| {
            let (shift, weight) = shifts[class];
            let [w1, w2] = self.along([0, 1].map(|i| w[i] + shift + 0.5 * f64::from(n[i])));
            let (mut value, mut rate) = (0.0, 0.0);
            for k in (-w1 - reach).ceil() as i32..=(reach - w1) as i32 {
                let even = k & 1 == 0;
                if !self.twisted && even != (class == 0) {
                    continue;
                }
                let d = w1 + f64::from(k);
                let height = (-PI * d * d / self.width).exp();
                let height = if even || signed == 0 { height } else { -height };
                let [single, slope] = self.single(odd, w2 - self.slope * d);
                value += height * single;
                rate += height * (turn * slope - TAU * d / self.width * r1 * single);
            }
            [value, rate].map(|x| weight * x)
        })
    }

    /// The theta function of one variable, over whole n or over those with a half, and its derivative.
    fn single(&self, odd: u8, w: f64) -> [f64; 2] {
        let step = unit(w);
        let mut power = unit(0.5 * f64::from(odd) * w);
        let (mut value, mut slope) = (0.0, 0.0);
        for (n, term) in self.terms.iter().enumerate().skip(odd.into()).step_by(2) {
            value += if n == 0 { *term } else { 2.0 * term * power.re };
            slope -= TAU * n as f64 * term * power.im;
            power *= step;
        }
        [value, slope]
    }
}

/// The partial sums put together: signs from a half period n/2 along the real directions, i from the real part ½ of τ.
pub(super) fn join(sums: &Sums, half: [u8; 2], twisted: bool) -> Number {
    let [whole, _] = parts(sums, half, twisted, [0, 0]);
    whole
}

/// The same in two parts, of which the second changes its sign with another half period along the real directions.
pub(super) fn parts(sums: &Sums, half: [u8; 2], twisted: bool, other: [u8; 2]) -> [Number; 2] {
    let mut parts = [Number::default(); 2];
    for (place, sum) in sums.iter().enumerate() {
        let odd = [place >> 1, place & 1].map(|x| x as u8);
        let sign = |half: [u8; 2]| (odd[0] & half[0]) ^ (odd[1] & half[1]);
        let term = if twisted && odd[0] != odd[1] {
            Number::new(-sum.im, sum.re)
        } else {
            *sum
        };
        parts[usize::from(sign(other))] += if sign(half) == 1 { -term } else { term };
    }
    parts
}

/// e^{2πix}.
pub(super) fn unit(turns: f64) -> Number {
    let (sine, cosine) = (TAU * (turns - turns.round())).sin_cos();
    Number::new(cosine, sine)
}
