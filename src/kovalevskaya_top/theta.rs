//! Riemann's theta function of two variables on the real torus (8.2).

use core::f64::consts::{PI, TAU};
use core::ops::{Add, Mul};

use nalgebra::Complex;

use super::periods::Half;

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

/// A function of time and its derivative.
pub(super) type Moving = [Number; 2];

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
        // Where Y is great the second greatest terms may be all that two functions differ by.
        let reach = REACH.max(1.5 * a.max(c));
        let row = |n1: i32| -> Option<Row> {
            let d1 = f64::from(n1) - center[0];
            let rest = reach - least * d1 * d1;
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
    side: f64,
    /// a, b/a.
    width: f64,
    slope: f64,
    /// ½, and e^{−πn²(c − b²/a)} for n = ½, 1, ….
    terms: Vec<f64>,
    twisted: bool,
    /// On a double root, the first phase, halved, where terms compete.
    passage: Option<f64>,
}

impl Pinched {
    pub fn prepare(
        [[a, b], [_, c]]: [[f64; 2]; 2],
        measure: [u8; 2],
        twisted: bool,
    ) -> Option<Self> {
        // m and −m are alike, and so are [1, 1] and [1, −1]: the one that is small.
        let side = -1_f64.copysign(b);
        // Y in a basis of which the measure is the first.
        let [width, mixed] = match measure {
            [1, 0] => [a, b],
            [0, 1] => [c, b],
            _ => [a + 2.0 * side * b + c, b + side * c],
        };
        let rest = (a * c - b * b) / width;
        if !(width > 0.0 && rest > 0.0 && REACH / rest < LARGEST) {
            return None;
        }
        let term = |n: i32| (-0.25 * PI * rest * f64::from(n * n)).exp();
        let terms = (0..4 + (4.0 * REACH / rest).sqrt() as i32).map(term);
        Some(Self {
            measure,
            side,
            width,
            slope: mixed / width,
            terms: [0.5].into_iter().chain(terms.skip(1)).collect(),
            twisted,
            passage: None,
        })
    }

    /// Whether fewer terms are left than there were.
    pub fn narrow(&self) -> bool {
        self.width < 1.0
    }

    /// Phases in that basis.
    fn along<T: Copy + Add<Output = T> + Mul<f64, Output = T>>(&self, [x, y]: [T; 2]) -> [T; 2] {
        match self.measure {
            [1, 0] => [x, y],
            [0, 1] => [y, x],
            _ => [x + y * self.side, y],
        }
    }

    /// How far the k are apart that count: half as far where Re τ tells odd ones apart in this direction.
    fn spacing(&self) -> f64 {
        if self.twisted && self.measure != [1, 1] {
            0.5
        } else {
            1.0
        }
    }

    /// For a curve with a double root: only the terms that compete where these phases, halved, are. All others belong to times that never come.
    pub fn at_double_root(&mut self, v: [f64; 2]) {
        let offset = if self.spacing() < 1.0 { 0.5 } else { 0.0 };
        let [first, _] = self.along(v);
        self.passage = Some(0.25 * ((4.0 * first - offset).round() + offset));
    }

    /// Whole turns that leave the first phase as it is, and less than one of the second.
    pub fn whole(&self, v: [f64; 2]) -> [f64; 2] {
        let turns = self.along(v)[1].floor();
        match self.measure {
            [1, 0] => [0.0, turns],
            [0, 1] => [turns, 0.0],
            _ => [-self.side * turns, turns],
        }
    }

    /// How far from the passage through a double root the phases are, halved, and the logarithm of the greatest of the functions there.
    pub fn since(&self, v: [f64; 2]) -> [f64; 2] {
        let [first, _] = self.along(v);
        let since = self.passage.map_or(0.0, |passage| first - passage);
        [since, TAU * self.spacing() * since.abs() / self.width]
    }

    /// The two sums of the function with this half period at v times `turns` less a, each with its rate if v changes at these rates; and the logarithm of what they are multiplied by besides.
    pub fn parts(
        &self,
        Half { n, m }: Half,
        v: [f64; 2],
        turns: f64,
        a: [Number; 2],
        rates: [f64; 2],
    ) -> ([Moving; 2], f64) {
        let [r1, r2] = self.along(rates).map(|rate| turns * rate);
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
        let since = turns * self.since(v)[0];
        let reach = match self.passage {
            Some(_) => 0.6 * self.spacing(),
            None => (REACH * self.width).sqrt() + 1.0,
        };
        let [u1, u2] = self.along(v).map(|u| turns * u);
        let [a1, a2] = self.along(a);
        let places = shifts.map(|(shift, _)| {
            let [h1, h2] = self.along(n.map(|n| shift + 0.5 * f64::from(n)));
            [u1 - since + h1 - a1, u2 + h2 - self.slope * since - a2]
        });
        // e^{−π(d+since)²/a} but for what all have.
        let terms = |class: usize| {
            let [w1, _] = places[class];
            let range = (-w1.re - reach).ceil() as i32..=(reach - w1.re).floor() as i32;
            let counted = move |k: &i32| self.twisted || (k & 1 == 0) == (class == 0);
            range.filter(counted).map(move |k| {
                let d = w1 + f64::from(k);
                (k, d, d * (d + 2.0 * since) * (-PI / self.width))
            })
        };
        let greatest = match self.passage {
            Some(_) => {
                let all = [0, 1].into_iter().flat_map(terms);
                all.map(|(.., x)| x.re).fold(f64::NEG_INFINITY, f64::max)
            }
            None => 0.0,
        };
        let sums = [0, 1].map(|class| {
            let mut sum = Moving::default();
            for (k, d, exponent) in terms(class) {
                let height = (exponent - greatest).exp();
                let height = if k & 1 == 0 || signed == 0 {
                    height
                } else {
                    -height
                };
                let [single, slope] = self.single(odd, places[class][1] - d * self.slope);
                sum[0] += height * single;
                sum[1] += height * (slope * turn - d * (TAU / self.width * r1) * single);
            }
            sum.map(|x| shifts[class].1 * x)
        });
        (sums, greatest)
    }

    /// The theta function of one variable, over whole n or over those with a half, and its derivative.
    fn single(&self, odd: u8, w: Number) -> Moving {
        let turned = |w: Number| (w * Number::new(0.0, TAU)).exp();
        let mut up = turned(w * (0.5 * f64::from(odd)));
        let step = turned(w);
        let (mut down, back) = (up.inv(), step.inv());
        let mut sum = Moving::default();
        for (n, term) in self.terms.iter().enumerate().skip(odd.into()).step_by(2) {
            sum[0] += (up + down) * term;
            sum[1] += (up - down) * (PI * n as f64 * term);
            (up, down) = (up * step, down * back);
        }
        [sum[0], sum[1] * Number::new(0.0, 1.0)]
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
