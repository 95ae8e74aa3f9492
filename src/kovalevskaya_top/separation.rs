//! Kovalevskaya's separation variables s₁, s₂, and the integrals that give time and phases (8.2).

use core::f64::consts::TAU;

use super::constants::{Complex, Constants, I, Root, WidePhase};
use crate::precise::{DoubleDouble, Number as _, power_of_two_below};

/// A value of s, given by its distances from the five roots and from Z, the point that belongs to the vertical: ω(s − e) for each, infinite where Z does not matter, and ω ≥ 0, which is 0 at −∞.
pub(super) type Place = ([Complex; 6], f64);

/// The interval in which s₁ moves, the turning point of s₂, and the real periods.
///
/// s₁ swings between two neighbouring roots A < B of P; s₂ comes from −∞, turns at the smallest root C and goes back; it is infinite whenever q = 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Separation {
    /// The roots e₁ … e₅.
    pub roots: [Root; 5],
    /// The real ones in ascending order.
    pub real: Vec<usize>,
    /// The numbers of the roots A, B and C.
    pub ends: [usize; 3],
    /// The distances e_i − e_j, each rounded once, and that from Z. Where two roots coincide, they are separated by less than any digit of the motion shows.
    pub apart: [[Complex; 6]; 5],
    /// The smallest distance of two roots as a fraction of the greatest, without that of e₄ and e₅, which may coincide without loss.
    pub narrowest: f64,
    widest: f64,
    /// A − σ = σ − C. ∫(s − σ)ds/√P grows with s₁ and falls with s₂, so that nothing cancels in the determinant of the four integrals.
    half_way: f64,
    /// N at Z, √−P.
    pub residue: DoubleDouble,
    /// ∫ds/√P, ∫(s−σ)ds/√P and ∫ds/((s−c)√P), where c is the s of Z, from A to B and from −∞ to C.
    halves: [[DoubleDouble; 3]; 2],
}

impl Separation {
    /// The separation for the interval that contains s₁; `None` if there is none, or if two roots are too close to be told apart.
    pub fn prepare(constants: &Constants, s1: DoubleDouble) -> Option<Self> {
        let roots = constants.roots();
        let mut real: Vec<usize> = (0..5).filter(|&i| roots[i].is_real()).collect();
        real.sort_by(|&i, &j| (roots[i].real - roots[j].real).value().total_cmp(&0.0));
        // P > 0 below the smallest root, between the second and third, and between the fourth and fifth.
        let outside = |a: usize, b: usize| {
            let below = (roots[a].real - s1).value();
            below.max((s1 - roots[b].real).value())
        };
        let (a, b) = real[1..]
            .chunks_exact(2)
            .map(|pair| (pair[0], pair[1]))
            .min_by(|x, y| outside(x.0, x.1).total_cmp(&outside(y.0, y.1)))?;
        let (apart, residue) = apart(constants, &roots);
        let c = real[0];
        let half_line = apart[a][c];
        let widest = apart.iter().flat_map(|row| &row[..5]);
        let widest = widest.fold(f64::MIN_POSITIVE, |most, x| most.max(x.norm()));
        let nearest = pairs().map(|[i, j]| apart[i][j].norm());
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        let mut separation = Self {
            roots,
            real,
            ends: [a, b, c],
            half_way: 0.5 * half_line.re,
            halves: [[DoubleDouble::from(0.0); 3]; 2],
            apart,
            narrowest: nearest / widest,
            widest,
            residue,
        };
        let cubic = separation.pinched() == Some([1, 2]);
        let told = |[i, j]: [usize; 2]| {
            let distance = apart[i][j].norm();
            match j {
                _ if cubic || j < 3 => distance > DOUBLE * widest,
                _ if constants.upright && distance == SPLIT => true,
                _ => {
                    // The nearer two roots of the cubic are, the less accurately they are known.
                    let others = (0..3).filter(|&other| other != i);
                    let beside = others.map(|other| apart[i][other].norm());
                    let clear = beside.fold(widest, f64::min) / widest;
                    !separation.passes([i, j]) || distance * clear > SHARED * widest
                }
            }
        };
        if !pairs().all(told) {
            return None;
        }
        let far_away = ([Complex::from(-widest); 6], 0.0);
        separation.halves = [
            separation.ahead(a, &(apart[b], 1.0)),
            separation.ahead(c, &far_away),
        ];
        Some(separation)
    }

    /// Two nearly equal roots such that s₁ or s₂ turns at one of them, with the other across a gap, or passes between them.
    pub fn pinched(&self) -> Option<[usize; 2]> {
        let near = |&[i, j]: &[usize; 2]| self.apart[i][j].norm();
        let close = |pair: &[usize; 2]| self.passes(*pair) && near(pair) < NEAR * self.widest;
        let first = pairs()
            .filter(close)
            .min_by(|x, y| near(x).total_cmp(&near(y)))?;
        // If two roots of the cubic are close as well, it is their sums that must be separated.
        let cubic = near(&first) != SPLIT && close(&[1, 2]);
        Some(if cubic { [1, 2] } else { first })
    }

    /// Whether two roots between which s₁ or s₂ passes coincide.
    pub fn touching(&self) -> bool {
        let pinched = self.pinched();
        pinched.is_some_and(|[i, j]| self.apart[i][j].norm() == SPLIT)
    }

    fn passes(&self, [i, j]: [usize; 2]) -> bool {
        let [a, b, c] = self.ends;
        if self.roots[i].is_real() && self.roots[j].is_real() {
            let turns = |root: usize| root == a || root == b;
            turns(i) != turns(j) || c == i || c == j
        } else {
            let right_of = |end: usize| self.apart[1][end].re > 0.0;
            [i, j] == [1, 2] && (!right_of(c) || right_of(a) && !right_of(b))
        }
    }

    // ANCHOR: straight
    /// ∫ds/√P, ∫(s−σ)ds/√P and, with c the s of Z, ∫ds/((s−c)√P), along the straight line from a root to a place.
    ///
    /// With s = (root + ωg place)/(1 + ωg), g = e^x, every root beyond the ends is at Im x = ±π, however near it is to an end; a root from which the path is seen under the angle φ is at ±(π−φ).
    /// With x = 3 sinh y, or more than 3 where two roots are close, the trapezoidal rule takes some forty steps, or some hundred: its error is e^{−2πd/step} if no singularity is nearer to the line
    /// than d, and the tails left out are e^{−40}.
    /// Each s − e is a sum of two distances, rounded once.
    pub fn straight(&self, from: usize, (place, weight): &Place) -> [[DoubleDouble; 2]; 3] {
        const DIGITS: f64 = 40.0;
        let depth = -self.narrowest.ln();
        let stretch = depth.max(3.0);
        let start = &self.apart[from];
        let first = start[self.ends[0]] + self.half_way;
        let length = place[from];
        let beyond = [Complex::from(1.0), Complex::from(*weight)];
        let ends = start.iter().zip(place).map(|(u, t)| [*u, *t]);
        let clear = ends
            .chain([beyond])
            .map(|[u, t]| -u / t)
            // Roots that rounding has put on the path or at its ends do not limit the step.
            .filter(|ratio| ratio.is_finite() && (ratio.im != 0.0 || ratio.re < 0.0))
            .map(|ratio| sine_of_area(ratio.ln() / stretch))
            .fold(1.0, f64::min)
            .asin();
        // e^step is rounded to few bits, so that its powers are exact, or nearly.
        let growth = (TAU * clear / DIGITS).exp_m1();
        let unit = 2.0_f64.powi(-12) * power_of_two_below(growth);
        let growth = (growth / unit).floor() * unit;
        let step = growth.ln_1p();
        let mut power = DoubleDouble::from(1.0);
        let mut sums = [[DoubleDouble::from(0.0); 2]; 3];
        let mut last = [None; 2];
        let most = ((2.2 * DIGITS + depth) / stretch).asinh() / step;
        for n in 0..=most.min(LONGEST) as usize {
            let inverse = DoubleDouble::from(1.0).quick_quotient(power);
            let x = (power - inverse).times(0.5 * stretch);
            let small = (-x.high()).exp() * (1.0 - x.low());
            let cosh = 0.5 * (power + inverse).value();
            // 1 and g, or both divided by g: only their ratio matters.
            let sides = [(1.0, small), (small, 1.0)];
            for (last, (near, far)) in last.iter_mut().zip(sides).skip(usize::from(n == 0)) {
                let here = |i: usize| start[i] * near + place[i] * far;
                let product: Complex = (0..5).map(here).product();
                let denominator = near + far * weight;
                // The square root that continues the one before.
                let next = root(product * denominator);
                let before = last.unwrap_or(next);
                let next = next * 1_f64.copysign((next * before.conj()).re);
                *last = Some(next);
                // √P = 2i√Π(s−e).
                let value = length * (small * cosh * denominator) / (2.0 * I * next);
                let mut add = |to: usize, value: Complex| {
                    let sum = [value.re, value.im].map(DoubleDouble::from);
                    sums[to] = [0, 1].map(|part| sums[to][part].add_alike(sum[part]));
                };
                add(0, value);
                add(1, value * (first + length * (far / denominator)));
                if place[5].is_finite() {
                    add(2, value * (denominator / here(5)));
                }
            }
            if n == 0 {
                last[0] = last[1];
            }
            power = power.times(1.0 + growth);
        }
        sums.map(|sum| sum.map(|part| part.times(stretch * step)))
    }
    // ANCHOR_END: straight

    /// The same along the real line, with signs such that the first is positive.
    ///
    /// Where a complex root is close to the line, the path goes through it: past it, the number of steps would grow without bound as it approaches.
    fn ahead(&self, from: usize, place: &Place) -> [DoubleDouble; 3] {
        let on_the_way = self.upper().filter(|&upper| {
            let [here, there] = [self.apart[from][upper].re, place.0[upper].re];
            here * there < 0.0 && self.pinched() == Some([1, 2])
        });
        let upward = |ways: [[DoubleDouble; 2]; 3]| {
            let sign = 1.0_f64.copysign(ways[0][0].high());
            ways.map(|[real, _]| real.scaled(sign))
        };
        match on_the_way {
            Some(root) => {
                let to_it = (self.apart[root], 1.0);
                let first = upward(self.straight(from, &to_it));
                let second = upward(self.straight(root, place));
                [0, 1, 2].map(|i| first[i] + second[i])
            }
            None => upward(self.straight(from, place)),
        }
    }

    /// The root above the real line, if there is one.
    pub fn upper(&self) -> Option<usize> {
        (!self.roots[1].is_real()).then_some(1)
    }

    /// ∫ds/√P and ∫(s−σ)ds/√P converted to turns of the two phases: the first gains 1 as s₁ goes round its interval, the second as s₂ does.
    pub fn normalized(&self, [a, b]: [DoubleDouble; 2]) -> [DoubleDouble; 2] {
        let [[a1, b1, _], [a2, b2, _]] = self.halves;
        let determinant = (b1 * a2 - a1 * b2).scaled(2.0);
        [a2 * b - b2 * a, a1 * b - b1 * a].map(|x| x / determinant)
    }

    // ANCHOR: abel
    /// Turns of the two phases per unit of time: ∫ds₁/√P + ∫ds₂/√P is constant, and ∫s₁ds₁/√P + ∫s₂ds₂/√P is the time.
    pub fn frequencies(&self) -> [DoubleDouble; 2] {
        self.normalized([0.0, 1.0].map(DoubleDouble::from))
    }

    /// The phases of s₁ and s₂, counted from s₁ = A and s₂ = C; each up to a sign, that of √P there.
    pub fn phases(&self, [first, second]: [&Place; 2]) -> [[f64; 2]; 2] {
        let [a, b, c] = self.ends;
        let integrals = |from: usize, place: &Place, side: f64| {
            // At an end, rounding may put the place outside.
            if place.0[from].re * side > 0.0 {
                let [first, second, _] = self.ahead(from, place);
                let turns = self.normalized([first, second]);
                turns.map(|turn| side * turn.value())
            } else {
                [0.0; 2]
            }
        };
        // Counted from the nearer end.
        let one = if first.0[a].re < -first.0[b].re {
            integrals(a, first, 1.0)
        } else {
            let [x, y] = integrals(b, first, -1.0);
            [0.5 + x, y]
        };
        [one, integrals(c, second, -1.0)]
    }
    // ANCHOR_END: abel

    /// s₁ and s₂ of a start, as places.
    ///
    /// Where one of them has just turned at a root, or is about to, its distance from the root is the product of both distances, a square, over the other's:
    /// as a difference it would keep only half of the digits of the time since the turn.
    pub fn places(&self, of: &Variables, constants: &Constants, start: &WidePhase) -> [Place; 2] {
        let mut first = self.roots.map(|root| Root::on_axis(of.s1).from(&root));
        let eight = of.q_squared.scaled(8.0);
        let mut second = self.roots.map(|root| {
            let real = eight * (constants.l1.scaled(0.5) - root.real) - of.numerator;
            Complex::new(real.value(), -(eight * root.imaginary).value())
        });
        let products = products(constants, &self.roots, start);
        for &i in &self.real {
            let product = products[i].value();
            if eight.value() * first[i].norm() < second[i].norm() {
                first[i] = (product / second[i].re).into();
            } else if first[i].re != 0.0 {
                second[i] = (product / first[i].re).into();
            }
        }
        let size = second.iter().fold(eight.value(), |m, x| m.max(x.norm()));
        let weight = eight.value() / size;
        // So near −∞ that no digit of the phase shows the difference.
        let weight = if weight < 1e-36 { 0.0 } else { weight };
        let second = beside(second.map(|x| x / size));
        [(beside(first), 1.0), (second, weight)]
    }

    /// (s₁−e)(s₂−e) at s₁ = A and s₂ = C for a complex root; for a real root the sign that it has throughout the motion.
    pub fn product(&self, root: usize) -> Complex {
        let [first, _, second] = self.ends.map(|end| self.apart[end][root]);
        if self.roots[root].is_real() {
            Complex::from(if first.re < 0.0 { 1.0 } else { -1.0 })
        } else {
            first * second
        }
    }

    /// The mean over time of 1/((s₁−c)(s₂−c)), where c is the s of Z, which lies between s₂ and s₁.
    ///
    /// 1/((s₁−c)(s₂−c)) = (1/(s₂−c) − 1/(s₁−c))/(s₁−s₂), and dt/(s₁−s₂) is ds₁/√P as well as −ds₂/√P.
    pub fn third_kind(&self) -> DoubleDouble {
        let [first, second] = self.halves.map(|[.., half]| half.magnitude());
        let [turns1, turns2] = self.frequencies();
        (turns1 * first + turns2 * second).scaled(-2.0)
    }
}

/// Pairs of roots, except e₄ and e₅.
fn pairs() -> impl Iterator<Item = [usize; 2]> {
    (0..3).flat_map(|i| (i + 1..5).map(move |j| [i, j]))
}

/// The least distances, as fractions of the greatest, that 106 bits resolve between two roots between which s₁ or s₂ passes: two roots of the cubic, of which the square of the distance is known, and others.
const DOUBLE: f64 = 1e-9;
const SHARED: f64 = 1e-17;

/// Below this distance of e₂ and e₃, theta functions are used after the modular transformation. Without it the half period between the two lies along the imaginary directions, and
/// 1e-16 over the distance is lost: at this distance as much as the error allowed at the start.
const NEAR: f64 = 3e-3;

/// Most steps of an integral on either side. If it would need more it comes out wrong, and the trial against power series rejects it.
const LONGEST: f64 = 16_384.0;

/// The magnitude of the sine of the imaginary part of asinh x.
fn sine_of_area(x: Complex) -> f64 {
    let [one, other] = [1.0, -1.0].map(|side| x.re.hypot(x.im + side));
    2.0 * x.im.abs() / (one + other)
}

/// The square root with a positive real part, from real and imaginary part: twice as fast as by way of the angle.
fn root(z: Complex) -> Complex {
    let norm = (z.re * z.re + z.im * z.im).sqrt();
    let large = (0.5 * (norm + z.re.abs())).sqrt();
    let small = 0.5 * z.im.abs() / large;
    let (re, im) = if z.re < 0.0 {
        (small, large)
    } else {
        (large, small)
    };
    Complex::new(re, im.copysign(z.im))
}

/// The distance to which two equal roots are separated: its fourth root, with which it enters the motion, is too small to matter.
const SPLIT: f64 = 1e-28;

/// A place given by its distances from the roots, without Z.
pub(super) fn beside([a, b, c, d, e]: [Complex; 5]) -> [Complex; 6] {
    [a, b, c, d, e, f64::INFINITY.into()]
}

/// The distances of the roots from each other, equal ones separated in the order of their numbers, and from Z; and N there. The smallest distance from Z follows from −P(s) = N²
/// to all digits.
///
/// Where e₅ is a root of the cubic, Z coincides with it. Nearby N is −2lk(s−e₅), which decides where Z lies between the two separated roots.
fn apart(constants: &Constants, roots: &[Root; 5]) -> ([[Complex; 6]; 5], DoubleDouble) {
    let mut apart = roots.map(|one| beside(roots.map(|other| one.from(&other))));
    for (i, j) in (0..5).flat_map(|j| (0..j).map(move |i| (i, j))) {
        if apart[i][j].norm() == 0.0 {
            // Neither s₁ nor s₂ passes between e₄ and e₅.
            let split = if i == 3 { 1e-40 } else { SPLIT };
            [apart[i][j], apart[j][i]] = [-split, split].map(Complex::from);
        }
    }
    let (point, mut residue) = (constants.vertical_point(), constants.residue());
    let mut vertical = roots.map(|root| Root::on_axis(point).from(&root));
    let real = (0..5).filter(|&i| roots[i].is_real());
    if constants.upright {
        vertical.copy_from_slice(&apart[4][..5]);
        let slope = constants.l.value() * constants.k.value();
        let others = vertical[..4].iter().filter(|x| x.norm() != SPLIT);
        let ratio = slope * slope / others.product::<Complex>().re;
        let rest = SPLIT / (ratio - 1.0);
        for x in vertical.iter_mut().filter(|x| x.norm() == SPLIT) {
            *x = (ratio * rest).into();
        }
        vertical[4] = rest.into();
        residue = DoubleDouble::from(-2.0 * slope * rest);
    } else if let Some(i) = real.min_by(|&i, &j| vertical[i].norm().total_cmp(&vertical[j].norm()))
    {
        vertical[i] = Complex::from(1.0);
        let square = (residue * residue).scaled(0.25).value();
        vertical[i] = square / vertical.iter().product::<Complex>();
    }
    for (row, x) in apart.iter_mut().zip(vertical) {
        row[5] = -x;
    }
    (apart, residue)
}

/// 8q²(s₁−e)(s₂−e) for the five roots, of which the complex ones do not count: a square times a number without cancellation.
///
/// For e₄ and e₅ it is 2 Im²(√ξ Ā) and −2 Re²(√ξ Ā), with ξ = x₁² − c(z₁+iz₂) and A = rx₁ − cz₃, since A² = R(x₁) + (x₁−x₂)²ξ and |A|² = R(x₁,x₂); for the roots
/// of the cubic −½(α(x₁x₂ − e′) + β(x₁+x₂))², with α² = 4(l₁+e), β² = d + e′², αβ = b and e′ = 2e − l₁ (Kötter).
fn products(
    constants: &Constants,
    roots: &[Root; 5],
    &[p, q, r, z1, z2, z3]: &WidePhase,
) -> [DoubleDouble; 5] {
    let square = |x: DoubleDouble| x * x;
    let (c, k, b) = (constants.c, constants.k, constants.b());
    let [re, im] = [square(p) - square(q) - c * z1, (p * q).scaled(2.0) - c * z2];
    let large = (k + re.magnitude()).scaled(0.5).square_root();
    let small = match large.high() {
        0.0 => large,
        _ => im / large.scaled(2.0),
    };
    let [x, y] = if re.high() < 0.0 {
        [small, large]
    } else {
        [large, small]
    };
    let a = [r * p - c * z3, r * q];
    core::array::from_fn(|i| match i {
        3 => square(y * a[0] - x * a[1]).scaled(2.0),
        4 => square(x * a[0] + y * a[1]).scaled(-2.0),
        _ => {
            let prime = roots[i].real.scaled(2.0) - constants.l1;
            let alpha_squared = (constants.l1 + roots[i].real).scaled(4.0);
            let beta_squared = constants.d + square(prime);
            let (rest, sum) = (square(p) + square(q) - prime, p.scaled(2.0));
            let [line, divisor] = if alpha_squared.magnitude().exceeds(beta_squared.magnitude()) {
                [alpha_squared * rest + b * sum, alpha_squared]
            } else {
                [b * rest + beta_squared * sum, beta_squared]
            };
            match divisor.high() {
                0.0 => divisor,
                _ => (square(line) / divisor).scaled(-0.5),
            }
        }
    })
}

/// s₁, and s₂ as a quotient, infinite for q = 0: s₂ = l₁/2 − numerator/8q².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Variables {
    pub s1: DoubleDouble,
    pub numerator: DoubleDouble,
    pub q_squared: DoubleDouble,
}

impl Variables {
    // ANCHOR: variables
    /// The separation variables of a state: s = l₁/2 + (R(x₁,x₂) ∓ |R(x₁)|)/(2(x₁−x₂)²), x₁,₂ = p ± iq.
    ///
    /// They solve (x₁−x₂)²σ² − R(x₁,x₂)σ + S/4 = 0 for σ = s − l₁/2; the one of R ∓ |R| that would cancel follows from the other by
    /// (R + |R|)(R − |R|) = (x₁−x₂)² S.
    pub fn of(constants: &Constants, [p, q]: [DoubleDouble; 2]) -> Self {
        let square = |x: DoubleDouble| x * x;
        let (d, b, six) = (constants.d, constants.b(), constants.l1.times(6.0));
        let q_squared = square(q);
        let product = square(p) + q_squared;
        let (re, im) = (square(p) - q_squared, (p * q).scaled(2.0));
        let linear = (b * p).scaled(2.0) + d;
        let real = square(im) - square(re) + six * re + linear;
        let imaginary = six * im - (re * im).scaled(2.0) + (b * q).scaled(2.0);
        let size = (square(real) + square(imaginary)).square_root();
        let mixed = six * product - square(product) + linear;
        let s = six * (square(product) - d) + p.scaled(4.0) * (d * p + b * product) + square(b);
        let (sigma, numerator) = if mixed.high() > 0.0 {
            let sum = mixed + size;
            ((s / sum).scaled(0.5), sum)
        } else {
            let difference = size - mixed;
            let four = q_squared.scaled(4.0);
            (difference / four.scaled(2.0), four * s / difference)
        };
        Self {
            s1: constants.l1.scaled(0.5) + sigma,
            numerator,
            q_squared,
        }
    }
    // ANCHOR_END: variables
}
