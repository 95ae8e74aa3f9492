//! From the phases back to Ω and z: Kötter's linear system, solved by quotients of theta functions (8.2).

use core::f64::consts::PI;

use super::constants::{Complex, Constants, I, Phase};
use super::periods::{Curve, Half};
use super::separation::Separation;
use super::theta::{Family, Moving, Pinched};

/// Kötter's linear system, solved by Cramer's rule.
///
/// For each of the three roots e of the cubic, with e′ = 2e − l₁, α = 2√(l₁+e), β = √(d+e′²) and αβ = b, every state obeys
///
/// 2(x₁−x₂) √((s₁−e)(s₂−e)) = α(x₁x₂ − e′) + β(x₁+x₂).
///
/// Since α₁α₂α₃ = 2b, β is half the product of the other two α, and every minor of the system is an α or β times a difference of two roots. With T = √((s₁−e)(s₂−e)) T∞, the Wronskians
/// U₁ = (T₂′T₃ − T₂T₃′)/T∞ = ½Δ₁Z₁, Δ₁ = e₂ − e₃ and so on in turn, and S = Σ αΔT,
///
/// q = −2iΔ₁Δ₂Δ₃T∞/S, p = −Σ βΔT/S, r = i Σ αΔZ/S, cz₃ = −i Σ βΔZ/S.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reconstruction {
    /// α and β.
    system: [[Complex; 3]; 2],
    /// Δ.
    apart: [Complex; 3],
    /// e₂ and e₃, each minus −l₁, e₁, e₄ and e₅.
    over: [[Complex; 4]; 2],
}

impl Reconstruction {
    pub fn prepare(constants: &Constants, separation: &Separation) -> Self {
        let (roots, apart) = (&separation.roots, &separation.apart);
        let over = |j: usize| {
            let real = constants.l1 + roots[j].real;
            Complex::new(real.value(), roots[j].imaginary.value())
        };
        let [a, b, c] = [0, 1, 2].map(|j| 2.0 * over(j).sqrt());
        let against = (a * b * c).re * constants.b().value() < 0.0;
        let a = if against { -a } else { a };
        Self {
            system: [[a, b, c], [b * c, c * a, a * b].map(|x| 0.5 * x)],
            apart: [apart[1][2], apart[2][0], apart[0][1]],
            over: [1, 2].map(|j| [over(j), apart[j][0], apart[j][3], apart[j][4]]),
        }
    }

    // ANCHOR: branch
    /// Of four origins, one for each pair of signs of the two phases, and eight sets of signs of the three roots, those that reproduce the start.
    pub fn fitted(
        &self,
        constants: &Constants,
        torus: &Torus,
        factors: [[Complex; 3]; 2],
        origins: [[f64; 2]; 4],
        start: &Phase,
    ) -> Option<(Quotients, [f64; 2])> {
        let signs = |n: i32| [1, 2, 4].map(|bit| if n & bit == 0 { 1.0 } else { -1.0 });
        let every =
            [0, 1, 2, 3, 4, 5, 6, 7].map(|n| self.quotients(factors, signs(n), torus.split));
        let all = origins.into_iter().flat_map(|origin| {
            let functions = torus.parts(origin);
            let miss = move |quotients: &Quotients| {
                distance(&quotients.state(constants, &functions), start)
            };
            every
                .iter()
                .map(move |quotients| (miss(quotients), quotients, origin))
        });
        let (_, quotients, origin) = all.min_by(|x, y| x.0.total_cmp(&y.0))?;
        Some((quotients.clone(), origin))
    }
    // ANCHOR_END: branch

    /// The quotients with these signs of the three roots; the first factors turn the theta functions into T, the second into U.
    ///
    /// If `split`, the functions of the second and the third root are sum and difference of those given, and likewise their Wronskians.
    fn quotients(
        &self,
        [factors, wronskians]: [[Complex; 3]; 2],
        signs: [f64; 3],
        split: bool,
    ) -> Quotients {
        let [d1, d2, d3] = self.apart;
        let roots = [0, 1, 2].map(|j| factors[j] * signs[j]);
        let others = [0, 1, 2].map(|j| {
            let sign = signs[(j + 1) % 3] * signs[(j + 2) % 3];
            2.0 * wronskians[j] * sign / self.apart[j]
        });
        // Divided by Δ₁, a factor of all the sums.
        let row = |of: usize, functions: [Complex; 3], powers: [i32; 3]| {
            let [a, b, c] = [0, 1, 2].map(|j| self.system[of][j] * functions[j]);
            if !split {
                return [a, d2 / d1 * b, d3 / d1 * c];
            }
            let powers = [[2, -2][of], powers[0], powers[1], powers[2]];
            // The sign of b/c tells which of the two sums contains the distance as a factor.
            let opposite = (b / c).re < 0.0;
            let c = if opposite { -c } else { c };
            let slope = d2 * self.slope(b, c, powers) - c;
            let mean = d2 * (b + c) / d1 + c;
            if opposite {
                [a, mean, slope]
            } else {
                [a, slope, mean]
            }
        };
        Quotients {
            of_roots: [0, 1].map(|of| row(of, roots, [1, 1, 1])),
            of_others: [0, 1].map(|of| row(of, others, [1, -1, -1])),
            side: -2.0 * I * d2 * d3,
        }
    }

    /// (b − c)/Δ₁, where b⁴/c⁴ is, up to its sign, the product of these powers of the quotients of e₂ − x and e₃ − x, x = −l₁, e₁, e₄, e₅.
    ///
    /// Where e₂ and e₃ coincide, so do b and c, or one is the other times a root of unity.
    fn slope(&self, b: Complex, c: Complex, powers: [i32; 4]) -> Complex {
        let apart = self.apart[0];
        let ratio = b / c;
        let one = Complex::from(1.0);
        if (ratio - one).norm() > 0.5 {
            return (b - c) / apart;
        }
        // (The product − 1)/Δ₁, factor by factor.
        let [second, third] = self.over;
        let mut product = Complex::default();
        for (i, power) in powers.into_iter().enumerate() {
            let over = if power > 0 { third } else { second };
            let step = f64::from(power.signum()) / over[i];
            for _ in 0..power.abs() {
                product += step * (one + apart * product);
            }
        }
        c * product / ((ratio + one) * (ratio * ratio + one))
    }
}

/// The functions of the three roots, of their Wronskians, and T∞.
pub(super) type Functions = [Moving; 7];

/// Ω and z as quotients of sums of functions with one common denominator, which does not vanish where q = 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quotients {
    /// Coefficients of the functions of the roots in Σ αΔT and Σ βΔT over Δ₁.
    of_roots: [[Complex; 3]; 2],
    /// Coefficients of their Wronskians in Σ αΔZ and Σ βΔZ over Δ₁.
    of_others: [[Complex; 3]; 2],
    /// q Σ αΔT over Δ₁T∞.
    side: Complex,
}

impl Quotients {
    /// The state; z₂ follows from the rate of r.
    pub fn state(&self, constants: &Constants, functions: &Functions) -> Phase {
        let (roots, others, [alone, _]) = (&functions[..3], &functions[3..6], functions[6]);
        let sum = |row: &[Complex; 3], of: &[Moving], k: usize| {
            row[0] * of[0][k] + row[1] * of[1][k] + row[2] * of[2][k]
        };
        let ([first, second], [third, fourth]) = (&self.of_roots, &self.of_others);
        let bottom = sum(first, roots, 0);
        let p = -(sum(second, roots, 0) / bottom).re;
        let q = (self.side * alone / bottom).re;
        let quotient = sum(third, others, 0) / bottom;
        let r = -quotient.im;
        let r_rate = (sum(third, others, 1) - quotient * sum(first, roots, 1)) / bottom;
        let c = constants.c.value();
        let z1 = (6.0 * constants.l1.value() - 2.0 * (p * p + q * q) - r * r) / (2.0 * c);
        let z3 = (sum(fourth, others, 0) / bottom).im / c;
        [p, q, r, z1, r_rate.im / c, z3]
    }
}

/// The functions of a curve that is not degenerate: Riemann's, with half periods.
///
/// √((s₁−e)(s₂−e)) is a theta function divided by the one that vanishes where s₂ is infinite, times the fourth root of ±Π(e−e′) over the other four roots e′; and the Wronskian of two such
/// functions is √(e−e′) times both constants and the theta function of the sum of their half periods (Thomae 1870, Kötter 1893).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Torus {
    pub family: Family,
    /// Half periods of the functions of the three roots, of their Wronskians, and of T∞.
    places: [Option<Half>; 7],
    /// Whether the functions of the second and the third root are given as half their sum and half their difference, and likewise those of their Wronskians; the places of the third are then empty.
    pub split: bool,
    /// The half period from e₂ to e₃, if the two functions differ by it and it is along the real directions.
    between: [u8; 2],
}

impl Torus {
    pub fn prepare(curve: &Curve, pinched: Option<[usize; 2]>) -> Option<Self> {
        let between = |[i, j]: [usize; 2]| curve.roots[i].plus(curve.roots[j]);
        let cubic = between([1, 2]);
        let passed = |pair| {
            let measure = match (between(pair).n, between(pair).m) {
                (_, [0, 0]) if curve.y[0][0] < curve.y[1][1] => [1, 0],
                (_, [0, 0]) => [0, 1],
                ([0, 0], m) => m,
                // Another root lies between the two.
                _ => return None,
            };
            Pinched::prepare(curve, measure)
        };
        let functions = match pinched {
            Some(pair) => match passed(pair) {
                None if pair == [1, 2] => return None,
                found => found.filter(Pinched::narrow),
            },
            None => None,
        };
        let along = functions.is_none() && cubic.m == [0, 0];
        let split = along || functions.is_some() && pinched == Some([1, 2]);
        let one = |j: usize| curve.infinite.plus(curve.roots[j % 3]);
        let place = |i: usize| match i {
            2 | 5 if split => None,
            0..3 => Some(one(i)),
            3..6 => Some(one(i + 1).plus(curve.roots[(i + 2) % 3])),
            _ => Some(curve.infinite),
        };
        Some(Self {
            family: Family::prepare(curve, functions, Default::default(), 2)?,
            places: core::array::from_fn(place),
            split,
            between: if along { cubic.n } else { [0, 0] },
        })
    }

    /// The seven functions at the phases v, halved; two pairs of them as sum and difference if `split`.
    pub fn parts(&self, v: [f64; 2]) -> Functions {
        let all = self.family.at(v, &self.places, self.between);
        let mut found = all.map(|[even, odd]| [0, 1].map(|k| even[k] + odd[k]));
        if self.split {
            [found[1], found[2]] = all[1];
            [found[4], found[5]] = all[4];
        }
        found
    }

    /// All seven functions at the phases v, halved.
    fn at(&self, v: [f64; 2]) -> Functions {
        let mut found = self.parts(v);
        for i in [1, 4].into_iter().filter(|_| self.split) {
            let [even, odd] = [found[i], found[i + 1]];
            found[i] = [0, 1].map(|k| even[k] + odd[k]);
            found[i + 1] = [0, 1].map(|k| even[k] - odd[k]);
        }
        found
    }

    /// The constants of the three roots and of their Wronskians, up to signs. Which fourth root is meant follows from the theta functions at s₁ = A and s₂ = C for a complex root, and
    /// at any phases for a real one.
    pub fn constants(&self, separation: &Separation) -> [[Complex; 3]; 2] {
        // At the first of these phases none of the greatest terms vanishes.
        let [found, at_ends] = [[0.11, 0.06], [0.0; 2]].map(|v| self.at(v));
        let alone = found[6][0];
        let roots: [Complex; 3] = core::array::from_fn(|j| {
            let real = separation.roots[j].is_real();
            let seen = if real { &found } else { &at_ends };
            let rough = separation.product(j) * (seen[6][0] / seen[j][0]).powi(2);
            let apart = (0..5).filter(|i| *i != j).map(|i| separation.apart[j][i]);
            aligned(apart.product::<Complex>().sqrt(), rough).sqrt()
        });
        let wronskians = core::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let both = roots[j] * roots[k];
            let [[x, x_rate], [y, y_rate]] = [found[j], found[k]];
            let rough = both * (x_rate * y - x * y_rate) / (alone * found[3 + i][0]);
            aligned(both * separation.apart[j][k].sqrt(), rough)
        });
        [roots, wronskians]
    }
}

/// A number times the sixteenth root of unity that brings it nearest to the direction of another.
fn aligned(number: Complex, rough: Complex) -> Complex {
    let turns = (8.0 / PI * (rough / number).arg()).round();
    number * Complex::cis(PI / 8.0 * turns)
}

pub(super) fn distance(a: &Phase, b: &Phase) -> f64 {
    let difference = (0..6).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    // NaN counts as no agreement.
    if difference.is_nan() {
        f64::INFINITY
    } else {
        difference
    }
}
