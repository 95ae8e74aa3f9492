//! Riemann's theta function of two variables on the real torus (8.2).

use core::f64::consts::{PI, TAU};
use core::ops::{Add, Mul};

use super::constants::{Complex, I};
use super::periods::{Curve, Half, MEASURES};
use crate::precise::DoubleDouble;

/// Σ exp(−π(n−n₀)·Y(n−n₀)) e^{2πi n·w} over integers n₁, n₂, summed separately for even and odd n₁ and n₂: θ(w − iy) with n₀ = Y⁻¹y, up to a constant factor.
///
/// The terms fall like a Gaussian, so that some sixty are enough; the series of a quotient of two such sums would take a thousand.
/// They are summed outward from n = 0, near which the greatest are, so that the rounding of high powers does not matter.
#[derive(Debug, Clone, PartialEq)]
struct Theta {
    /// n₁ = 0, 1, … and n₁ = −1, −2, ….
    rows: [Vec<Row>; 2],
}

/// The terms of one n₁, and n₂ times each: for n₂ = 2j, 2j + 1, −2j − 2 and −2j − 1, j = 0, 1, ….
type Row = Vec<[[f64; 4]; 2]>;

/// A function of time and its derivative.
pub(super) type Moving = [Complex; 2];

/// The four partial sums, by the parities of n₁ and n₂: (0,0), (0,1), (1,0), (1,1).
type Sums = [Complex; 4];

/// Terms e^{−πx} with x above this are left out: they are below 1e-19.
const REACH: f64 = 14.0;

/// The most terms.
const LARGEST: f64 = 4096.0;

impl Theta {
    /// For |n₀| not above ½ in either component. `None` if Y is not positive definite, or so small that more than 4096 terms are needed.
    fn prepare(curve: &Curve, y: [f64; 2]) -> Option<Self> {
        let [[a, b], [_, c]] = curve.y;
        let determinant = a * c - b * b;
        // Written so that NaN is refused as well.
        if !(a > 0.0 && determinant > 0.0 && PI * REACH < LARGEST * determinant.sqrt()) {
            return None;
        }
        let center = curve.along(y);
        if !center.iter().all(|x| x.is_finite()) {
            return None;
        }
        // a d₁² + 2b d₁d₂ + c d₂² = (determinant/c) d₁² + c (d₂ + b d₁/c)².
        let least = determinant / c;
        // Where Y is large, two functions may differ only by their second greatest terms.
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

    /// The sums at `z` = (e^{2πiw₁}, e^{2πiw₂}), and their rates of change if w changes at the given rates.
    fn at(&self, z: [Complex; 2], [r1, r2]: [f64; 2]) -> [Sums; 2] {
        let [mut sums, mut rates] = [Sums::default(); 2];
        let [upward, downward] = &self.rows;
        let back = z[0].conj();
        let sides = [
            (upward, 0, Complex::from(1.0), z[0]),
            (downward, -1, back, back),
        ];
        for (rows, first, mut power, step) in sides {
            for (n, row) in (0..).zip(rows) {
                let n1 = if first < 0 { first - n } else { n };
                let place = 2 * (n1 & 1) as usize;
                let [values, slopes] = along(z[1], row);
                for k in 0..2 {
                    sums[place + k] += power * values[k];
                    rates[place + k] += power * (values[k] * (r1 * f64::from(n1)) + slopes[k] * r2);
                }
                power *= step;
            }
        }
        [sums, rates.map(|rate| I * TAU * rate)]
    }
}

/// The sums over even and over odd n₂ of the terms times z^{n₂}, |z| = 1, and the same with the factor n₂.
#[inline(always)]
fn along(z: Complex, row: &Row) -> [[Complex; 2]; 2] {
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
        Complex::new(re, im)
    };
    [[sum(0, 0), sum(0, 1)], [sum(2, 0), sum(2, 1)]]
}

/// θ with half periods after the modular transformation in the one direction in which Y is small.
///
/// By Poisson's formula Σ exp(−πn·Yn + 2πi n·w) over n₁ becomes a sum over k of e^{−π(w₁+k)²/a}, a = Y₁₁, each multiplied by a theta function of one variable, the sum over n₂,
/// at w₂ − (w₁+k)b/a. As a tends to 0, one or two terms are left. A half period τ/2 in that direction changes the signs of the terms with odd k, so that two functions that differ by it
/// are the sum and the difference of two sums without a common term.
///
/// Where Re τ is ½ everywhere, the function is a sum over two shifts of w that differ by a half, and the two sums are those of the two shifts.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pinched {
    /// The direction in which Y is small, and another one.
    basis: [[f64; 2]; 2],
    /// In this basis a and b/a.
    width: f64,
    slope: f64,
    /// ½, and e^{−πn²(c − b²/a)} for n = ½, 1, ….
    terms: Vec<f64>,
    twisted: bool,
    /// Spacing of the relevant k: 1, or ½ where Re τ separates the odd ones in this direction.
    spacing: f64,
    /// On a double root, the first phase, halved, at which two terms are equally great.
    passage: Option<f64>,
}

impl Pinched {
    /// For the half period ½τm that is small, m = `measure`.
    pub fn prepare(curve: &Curve, measure: [u8; 2]) -> Option<Self> {
        let [[a, b], [_, c]] = curve.y;
        let basis = match measure {
            [1, 0] => [[1.0, 0.0], [0.0, 1.0]],
            [0, 1] => [[0.0, 1.0], [-1.0, 0.0]],
            // m and −m are equivalent, and so are [1, 1] and [1, −1]: of these the small one is taken.
            _ => [[1.0, -1_f64.copysign(b)], [0.0, 1.0]],
        };
        let small = curve.tau(basis[0]);
        let [width, mixed] = basis.map(|[x, y]| x * small[0].im + y * small[1].im);
        let rest = (a * c - b * b) / width;
        if !(width > 0.0 && rest > 0.0 && REACH / rest < LARGEST) {
            return None;
        }
        let term = |n: i32| (-0.25 * PI * rest * f64::from(n * n)).exp();
        let terms = (0..4 + (4.0 * REACH / rest).sqrt() as i32).map(term);
        let half = curve.real > 0.0 && measure != [1, 1];
        Some(Self {
            basis,
            width,
            slope: mixed / width,
            terms: [0.5].into_iter().chain(terms.skip(1)).collect(),
            twisted: curve.real > 0.0,
            spacing: if half { 0.5 } else { 1.0 },
            passage: None,
        })
    }

    /// Whether the transformed series has fewer terms.
    pub fn narrow(&self) -> bool {
        self.width < 1.0
    }

    /// Phases in that basis.
    fn along<T: Copy + Add<Output = T> + Mul<f64, Output = T>>(&self, [x, y]: [T; 2]) -> [T; 2] {
        self.basis.map(|[a, b]| x * a + y * b)
    }

    /// For a curve with a double root: keeps only the terms that matter near these phases, halved. All others belong to times that are never reached.
    pub fn at_double_root(&mut self, v: [f64; 2]) {
        let offset = if self.spacing < 1.0 { 0.5 } else { 0.0 };
        let [first, _] = self.along(v);
        self.passage = Some(0.25 * ((4.0 * first - offset).round() + offset));
    }

    /// Whole turns that leave the first phase as it is, and less than one of the second.
    pub fn whole(&self, v: [f64; 2]) -> [f64; 2] {
        let [[a, b], turns] = [self.basis[0], self.along(v)];
        let turns = turns[1].floor();
        [-b * turns, a * turns]
    }

    /// The two sums of the function with this half period at `turns` · v − a, each with its rate if v changes at these rates; all up to a positive factor, which is the same for all half periods if a = 0.
    fn parts(
        &self,
        Half { n, m }: Half,
        v: [f64; 2],
        turns: f64,
        a: [Complex; 2],
        rates: [f64; 2],
    ) -> [Moving; 2] {
        let [r1, r2] = self.along(rates).map(|rate| turns * rate);
        let turn = r2 - self.slope * r1;
        let [[x, y], [z, w]] = self.basis.map(|of| of.map(|part| part.abs() as u8));
        let [signed, odd] = [w * m[0] + z * m[1], y * m[0] + x * m[1]].map(|m| m & 1);
        // The shifts of w, and the coefficients of the function there.
        let shifts = match (self.twisted, m[0] == m[1]) {
            (false, _) => [(0.0, Complex::from(1.0)); 2],
            (true, true) => [0.0, 0.5].map(|x| (x, Complex::new(0.5, 0.5 - 2.0 * x))),
            (true, false) => [0.25, -0.25].map(|x| (x, Complex::from(0.5_f64.sqrt()))),
        };
        let shifts = &shifts[..1 + usize::from(self.twisted)];
        let [u1, u2] = self.along(v).map(|u| turns * u);
        // The distance in phase from the passage through a double root.
        let since = self.passage.map_or(0.0, |passage| u1 - turns * passage);
        let reach = match self.passage {
            Some(_) => 0.6 * self.spacing,
            None => (REACH * self.width).sqrt() + 1.0,
        };
        let [a1, a2] = self.along(a);
        // The parity of k, the two arguments, and the exponent of e^{−π(d+since)²/a} without what is common to all.
        let terms = |shift: f64| {
            let [h1, h2] = self.along(n.map(|n| shift + 0.5 * f64::from(n)));
            let [w1, w2] = [u1 - since + h1 - a1, u2 + h2 - self.slope * since - a2];
            let range = (-w1.re - reach).ceil() as i32..=(reach - w1.re).floor() as i32;
            range.map(move |k| {
                let d = w1 + f64::from(k);
                let exponent = d * (d + 2.0 * since) * (-PI / self.width);
                ((k & 1) as u8, d, w2 - d * self.slope, exponent)
            })
        };
        let all = shifts.iter().flat_map(|(shift, _)| terms(*shift));
        let greatest = all.map(|(.., x)| x.re).fold(f64::NEG_INFINITY, f64::max);
        // The greatest of the functions for Ω and z are of this magnitude; of the others at least the direction is kept in range.
        let size = PI * self.spacing * since.abs() / self.width;
        let scale = (greatest - size).clamp(-300.0, 0.0).exp();
        let mut sums = [Moving::default(); 2];
        for (class, &(shift, before)) in shifts.iter().enumerate() {
            for (alternate, d, w2, exponent) in terms(shift) {
                let sign = if alternate & signed == 1 {
                    -scale
                } else {
                    scale
                };
                let height = before * sign * (exponent - greatest).exp();
                let [single, slope] = self.single(odd, w2);
                let part = if self.twisted {
                    class
                } else {
                    alternate.into()
                };
                sums[part][0] += height * single;
                sums[part][1] += height * (slope * turn - d * (TAU / self.width * r1) * single);
            }
        }
        sums
    }

    /// The theta function of one variable, summed over integers or over half-integers if `odd` is 1, and its derivative.
    fn single(&self, odd: u8, w: Complex) -> Moving {
        let turned = |w: Complex| (I * TAU * w).exp();
        let mut up = turned(w * (0.5 * f64::from(odd)));
        let step = turned(w);
        let (mut down, back) = (up.inv(), step.inv());
        let mut sum = Moving::default();
        for (n, term) in self.terms.iter().enumerate().skip(odd.into()).step_by(2) {
            sum[0] += (up + down) * term;
            sum[1] += (up - down) * (PI * n as f64 * term);
            (up, down) = (up * step, down * back);
        }
        [sum[0], I * sum[1]]
    }
}

/// The functions θ(w − a) with half periods, where w are the turns of the two phases, or half of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Family {
    /// For each m, e^{2πi Re(τκ − a)} and the series of θ(w − a + τκ), where κ is m/2 up to integers.
    tables: Vec<([u8; 2], [Complex; 2], Theta)>,
    /// Or, instead, the sums after the modular transformation, and a.
    pinched: Option<(Pinched, [Complex; 2])>,
    /// 2 or 1: w in units of the halved turns v.
    multiple: u8,
    twisted: bool,
    /// Turns of the phases a unit of time, halved.
    advance: [f64; 2],
}

impl Family {
    pub fn prepare(
        curve: &Curve,
        pinched: Option<Pinched>,
        a: [Complex; 2],
        multiple: u8,
    ) -> Option<Self> {
        let place = curve.along(a.map(|a| a.im));
        let moved = |m: [u8; 2]| {
            // Chosen so that the greatest terms of each theta function are those near n = 0.
            let kappa = [0, 1].map(|i| {
                let half = 0.5 * f64::from(m[i]);
                half + (place[i] - half).round_ties_even()
            });
            let across = curve.tau(kappa);
            [0, 1].map(|i| a[i] - across[i])
        };
        let mut tables = Vec::new();
        for m in MEASURES.into_iter().filter(|_| pinched.is_none()) {
            let a = moved(m);
            let theta = Theta::prepare(curve, a.map(|a| a.im))?;
            tables.push((m, a.map(|a| unit(-a.re)), theta));
        }
        Some(Self {
            tables,
            pinched: pinched.map(|functions| (functions, moved([0, 0]))),
            multiple,
            twisted: curve.real > 0.0,
            advance: curve.advance.map(DoubleDouble::value),
        })
    }

    /// The functions with these half periods and their rates. Each comes in two parts, the second of which changes its sign if one more half period is added: `between` if
    /// that is along the real directions, or the half period in the direction of the modular transformation.
    ///
    /// Where w is whole turns, each is multiplied by e^{πi m·w}, which has period 1 in the halved turns v; where w is half turns the factor would not be periodic, and is left out.
    pub fn at<const N: usize>(
        &self,
        v: [f64; 2],
        places: &[Option<Half>; N],
        between: [u8; 2],
    ) -> [[Moving; 2]; N] {
        let mut found = [[Moving::default(); 2]; N];
        if let Some((functions, a)) = &self.pinched {
            let multiple = f64::from(self.multiple);
            for (found, place) in found.iter_mut().zip(places) {
                if let Some(half) = place {
                    *found = functions.parts(*half, v, multiple, *a, self.advance);
                }
            }
            return found;
        }
        let once = v.map(unit);
        let [turned, halved] = [self.multiple, self.multiple - 1].map(i32::from);
        let rates = self.advance.map(|x| f64::from(turned) * x);
        for (m, turn, table) in &self.tables {
            let here = |half: &Half| half.m == *m;
            if !places.iter().flatten().any(here) {
                continue;
            }
            let sums = table.at([0, 1].map(|i| once[i].powi(turned) * turn[i]), rates);
            let [first, second] = m.map(|m| halved * i32::from(m));
            let factor = once[0].powi(first) * once[1].powi(second);
            let growth = f64::from(first) * self.advance[0] + f64::from(second) * self.advance[1];
            let growth = I * TAU * growth;
            for (found, place) in found.iter_mut().zip(places) {
                if let Some(half) = place.filter(here) {
                    let [x, rate] = sums
                        .each_ref()
                        .map(|sums| parts(sums, half.n, self.twisted, between));
                    *found = [0, 1].map(|k| [factor * x[k], factor * (rate[k] + growth * x[k])]);
                }
            }
        }
        found
    }

    /// The functions after the modular transformation, where they are used.
    pub fn pinched(&self) -> Option<&Pinched> {
        self.pinched.as_ref().map(|(functions, _)| functions)
    }

    /// For a curve with a double root and a start at these phases, halved.
    pub fn at_double_root(&mut self, v: [f64; 2]) {
        if let Some((functions, _)) = &mut self.pinched {
            functions.at_double_root(v);
        }
    }
}

/// The partial sums combined into two parts, the second of which changes its sign if the `other` half period is added; the half period n/2 brings signs, the real part ½ of τ factors i.
fn parts(sums: &Sums, half: [u8; 2], twisted: bool, other: [u8; 2]) -> [Complex; 2] {
    let mut parts = [Complex::default(); 2];
    for (place, sum) in sums.iter().enumerate() {
        let odd = [place >> 1, place & 1].map(|x| x as u8);
        let sign = |half: [u8; 2]| (odd[0] & half[0]) ^ (odd[1] & half[1]);
        let term = if twisted && odd[0] != odd[1] {
            Complex::new(-sum.im, sum.re)
        } else {
            *sum
        };
        parts[usize::from(sign(other))] += if sign(half) == 1 { -term } else { term };
    }
    parts
}

/// e^{2πix}.
fn unit(turns: f64) -> Complex {
    let (sine, cosine) = (TAU * (turns - turns.round())).sin_cos();
    Complex::new(cosine, sine)
}
