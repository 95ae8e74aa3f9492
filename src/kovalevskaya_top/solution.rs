//! From the phases back to Ω and z: Kötter's linear system, solved by quotients of theta functions (8.2).

use core::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::constants::{Constants, Phase, Root};
use super::periods::{Curve, Half, MEASURES};
use super::separation::Separation;
use super::theta::{Moving, Pinched, Theta, join, parts, unit};

type Number = Complex<f64>;

const I: Number = Number::new(0.0, 1.0);

/// Kötter's linear system, solved by Cramer's rule.
///
/// For each of the three roots e of the cubic, with e′ = 2e − l₁, α = 2√(l₁+e), β = √(d+e′²) and αβ = b, every state obeys
///
/// 2(x₁−x₂) √((s₁−e)(s₂−e)) = α(x₁x₂ − e′) + β(x₁+x₂).
///
/// Since α₁α₂α₃ = 2b, β is half the product of the other two α, and every minor of the system is an α or β times a difference of two roots. With T = √((s₁−e)(s₂−e)) T∞, Wronskians
/// U₁ = (T₂′T₃ − T₂T₃′)/T∞ = ½Δ₁Z₁, Δ₁ = e₂ − e₃ and so on in turn, and S = Σ αΔT,
///
/// q = −2iΔ₁Δ₂Δ₃T∞/S, p = −Σ βΔT/S, r = i Σ αΔZ/S, cz₃ = −i Σ βΔZ/S.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reconstruction {
    /// α and β.
    system: [[Number; 3]; 2],
    /// Δ.
    apart: [Number; 3],
    /// e₂ and e₃ less −l₁, e₁, e₄ and e₅.
    over: [[Number; 4]; 2],
}

impl Reconstruction {
    pub fn prepare(constants: &Constants, roots: &[Root; 5], apart: [Number; 3]) -> Self {
        let over = |j: usize| {
            let real = constants.l1 + roots[j].real;
            Number::new(real.value(), roots[j].imaginary.value())
        };
        let [a, b, c] = [0, 1, 2].map(|j| 2.0 * over(j).sqrt());
        let against = (a * b * c).re * constants.b().value() < 0.0;
        let a = if against { -a } else { a };
        let from = |j: usize, i: usize| roots[j].from(&roots[i]);
        Self {
            system: [[a, b, c], [b * c, c * a, a * b].map(|x| 0.5 * x)],
            apart,
            over: [1, 2].map(|j| [over(j), from(j, 0), from(j, 3), from(j, 4)]),
        }
    }

    // ANCHOR: branch
    /// Of four origins and 4 × 8 signs of two phases and three roots, those that give the start back: the quotients for functions that are the first of these factors times T, and the others
    /// times U.
    pub fn fitted<O: Copy>(
        &self,
        constants: &Constants,
        factors: [[Number; 3]; 2],
        split: bool,
        origins: [O; 4],
        functions: impl Fn(O) -> Functions,
        start: &Phase,
    ) -> (Quotients, O) {
        let every = [0, 1, 2, 3, 4, 5, 6, 7].map(|choice| self.quotients(factors, choice, split));
        let mut best = (f64::INFINITY, &every[0], origins[0]);
        for origin in origins {
            let functions = functions(origin);
            for quotients in &every {
                let miss = distance(&quotients.state(constants, &functions), start);
                if miss < best.0 {
                    best = (miss, quotients, origin);
                }
            }
        }
        (best.1.clone(), best.2)
    }
    // ANCHOR_END: branch

    /// With one of eight choices of signs of the three roots.
    ///
    /// Where `split`, the functions of the second root and the third are the sum and the difference of those given, likewise their Wronskians.
    fn quotients(
        &self,
        [factors, wronskians]: [[Number; 3]; 2],
        choice: usize,
        split: bool,
    ) -> Quotients {
        let signs = [0, 1, 2].map(|bit| if choice >> bit & 1 == 0 { 1.0 } else { -1.0 });
        let [d1, d2, d3] = self.apart;
        let roots = [0, 1, 2].map(|j| factors[j] * signs[j]);
        let others = [0, 1, 2].map(|j| {
            let sign = signs[(j + 1) % 3] * signs[(j + 2) % 3];
            2.0 * wronskians[j] * sign / self.apart[j]
        });
        // Over Δ₁, which all the sums hold.
        let row = |of: usize, functions: [Number; 3], powers: [i32; 3]| {
            let [a, b, c] = [0, 1, 2].map(|j| self.system[of][j] * functions[j]);
            if !split {
                return [a, d2 / d1 * b, d3 / d1 * c];
            }
            let powers = [[2, -2][of], powers[0], powers[1], powers[2]];
            // Which of the two sums holds the distance is told by the sign of b : c.
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

    /// (b − c)/Δ₁ where b⁴ : c⁴ is the product of these powers of what e₂ and e₃ are over −l₁, e₁, e₄, e₅, but for its sign.
    ///
    /// Where e₂ and e₃ meet b and c do, or one is the other times a root of unity.
    fn slope(&self, b: Number, c: Number, powers: [i32; 4]) -> Number {
        let apart = self.apart[0];
        let ratio = b / c;
        let one = Number::from(1.0);
        if (ratio - one).norm() > 0.5 {
            return (b - c) / apart;
        }
        // The product less 1 over Δ₁, factor by factor.
        let [second, third] = self.over;
        let mut product = Number::default();
        for (i, power) in powers.into_iter().enumerate() {
            let step = if power > 0 {
                1.0 / third[i]
            } else {
                -1.0 / second[i]
            };
            for _ in 0..power.abs() {
                product += step * (one + apart * product);
            }
        }
        c * product / ((ratio + one) * (ratio * ratio + one))
    }
}

/// The functions of the three roots, of their Wronskians, and the one alone that is T∞.
pub(super) type Functions = [Moving; 7];

/// Ω and z as quotients of sums of functions with one common denominator; there is nothing to divide by where q = 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quotients {
    /// What stands before the functions of the roots in Σ αΔT and Σ βΔT over Δ₁.
    of_roots: [[Number; 3]; 2],
    /// And before their Wronskians in Σ αΔZ and Σ βΔZ over Δ₁.
    of_others: [[Number; 3]; 2],
    /// q Σ αΔT over Δ₁T∞.
    side: Number,
}

impl Quotients {
    /// The state; z₂ is the rate of r.
    pub fn state(&self, constants: &Constants, functions: &Functions) -> Phase {
        let (roots, others, [alone, _]) = (&functions[..3], &functions[3..6], functions[6]);
        let sum = |row: &[Number; 3], of: &[Moving], k: usize| {
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
/// √((s₁−e)(s₂−e)) is a theta function over the one that vanishes where s₂ is infinite, times the fourth root of ±Π(e−e′) over the other four roots e′; and the Wronskian of two such
/// roots is √(e−e′) times both constants and the theta function of the sum of their half periods (Thomae 1870, Kötter 1893).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Torus {
    /// θ with τm/2 added, for each m that is needed.
    tables: Vec<([u8; 2], Theta)>,
    /// Half periods of the functions of the three roots, of their Wronskians, and of the one alone.
    places: [Half; 7],
    /// The half period from e₂ to e₃ if it is one along the real directions.
    between: Option<[u8; 2]>,
    /// Where two roots are near each other and s₁ or s₂ passes between them, and whether these are e₂ and e₃.
    pinched: Option<(Pinched, bool)>,
    /// Re τm/2 in both components, a share of m₁ + m₂.
    twisted: bool,
    /// Turns of the phases a unit of time, halved.
    advance: [f64; 2],
}

impl Torus {
    pub fn prepare(curve: &Curve, pinched: Option<[usize; 2]>, advance: [f64; 2]) -> Option<Self> {
        let one = |j: usize| curve.infinite.plus(curve.roots[j % 3]);
        let places = core::array::from_fn(|i| match i {
            0..3 => one(i),
            3..6 => one(i + 1).plus(curve.roots[(i + 2) % 3]),
            _ => curve.infinite,
        });
        let between = |[i, j]: [usize; 2]| curve.roots[i].plus(curve.roots[j]);
        let passed = |pair| {
            let measure = match (between(pair).n, between(pair).m) {
                (_, [0, 0]) if curve.y[0][0] < curve.y[1][1] => [1, 0],
                (_, [0, 0]) => [0, 1],
                ([0, 0], m) => m,
                // Another root lies between the two.
                _ => return None,
            };
            Pinched::prepare(curve.y, measure, curve.twisted)
                .map(|functions| (functions, pair == [1, 2]))
        };
        let pinched = match pinched {
            Some(pair) => match passed(pair) {
                None if pair == [1, 2] => return None,
                found => found.filter(|(functions, _)| functions.narrow()),
            },
            None => None,
        };
        let between = between([1, 2]);
        let needed =
            |m: &[u8; 2]| pinched.is_none() && places.iter().any(|place: &Half| place.m == *m);
        let tables = MEASURES.into_iter().filter(needed).map(|m| {
            let [a, b] = m.map(|x| -0.5 * f64::from(x));
            let theta = Theta::prepare(curve.y, curve.y.map(|[x, y]| x * a + y * b))?;
            Some((m, theta))
        });
        Some(Self {
            tables: tables.collect::<Option<Vec<_>>>()?,
            between: (between.m == [0, 0]).then_some(between.n),
            pinched,
            places,
            twisted: curve.twisted,
            advance,
        })
    }

    /// All seven where the phases have turned so far, halved.
    pub fn at(&self, v: [f64; 2]) -> Functions {
        let mut found = self.parts(v);
        if self.split() {
            for i in [1, 4] {
                let [even, odd] = [found[i], found[i + 1]];
                found[i] = [0, 1].map(|k| even[k] + odd[k]);
                found[i + 1] = [0, 1].map(|k| even[k] - odd[k]);
            }
        }
        found
    }

    /// With a double root where the phases are so far, halved.
    pub fn at_double_root(&mut self, v: [f64; 2]) {
        if let Some((functions, _)) = &mut self.pinched {
            functions.at_double_root(v);
        }
    }

    /// Theta functions after the modular transformation, where they are needed.
    pub fn pinched(&self) -> Option<&Pinched> {
        self.pinched.as_ref().map(|(functions, _)| functions)
    }

    /// Whether the functions of the second root and the third come as half their sum and half their difference.
    pub fn split(&self) -> bool {
        match self.pinched {
            Some((_, split)) => split,
            None => self.between.is_some(),
        }
    }

    /// The seven, two pairs of them split.
    pub fn parts(&self, v: [f64; 2]) -> Functions {
        let mut found = Functions::default();
        if let Some((pinched, split)) = &self.pinched {
            let nowhere = [Number::default(); 2];
            let [_, size] = pinched.since(v);
            for (i, place) in self.places.iter().enumerate() {
                let (parts, greater) = pinched.parts(*place, v, 2.0, nowhere, self.advance);
                let [even, odd] = parts.map(|part| part.map(|x| x * (greater - size).exp()));
                match i {
                    1 | 4 if *split => [found[i], found[i + 1]] = [even, odd],
                    2 | 5 if *split => {}
                    _ => found[i] = [0, 1].map(|k| even[k] + odd[k]),
                }
            }
            return found;
        }
        let once = v.map(unit);
        for (m, table) in &self.tables {
            let [first, second] = m.map(i32::from);
            let twist = if self.twisted { first + second } else { 0 };
            let turned = once.map(|x| x * x * I.powi(twist));
            let sums = table.with_rates(turned, self.advance.map(|x| 2.0 * x));
            let factor = once[0].powi(first) * once[1].powi(second);
            let growth = I
                * TAU
                * (f64::from(first) * self.advance[0] + f64::from(second) * self.advance[1]);
            let moving = |[x, rate]: Moving| [factor * x, factor * (rate + growth * x)];
            for (i, place) in self.places.iter().enumerate() {
                if place.m != *m {
                    continue;
                }
                match (i, self.between) {
                    (1 | 4, Some(between)) => {
                        let [x, rate] = sums
                            .each_ref()
                            .map(|sums| parts(sums, place.n, self.twisted, between));
                        [found[i], found[i + 1]] = [0, 1].map(|k| moving([x[k], rate[k]]));
                    }
                    (2 | 5, Some(_)) => {}
                    _ => {
                        let whole = sums.each_ref();
                        found[i] = moving(whole.map(|sums| join(sums, place.n, self.twisted)));
                    }
                }
            }
        }
        found
    }

    /// The constants of the three roots and of their Wronskians, up to signs: which of the fourth roots they are is told by the theta functions where s₁ = A and s₂ = C for a complex root, and
    /// anywhere for a real one.
    pub fn constants(&self, separation: &Separation) -> [[Number; 3]; 2] {
        // None of the greatest terms vanishes at the first of these.
        let [found, at_ends] = [[0.11, 0.06], [0.0; 2]].map(|v| self.at(v));
        let alone = found[6][0];
        let roots: [Number; 3] = core::array::from_fn(|j| {
            let real = separation.roots[j].is_real();
            let seen = if real { &found } else { &at_ends };
            let rough = separation.product(j) * (seen[6][0] / seen[j][0]).powi(2);
            let apart = (0..5).filter(|i| *i != j).map(|i| separation.apart[j][i]);
            aligned(apart.product::<Number>().sqrt(), rough).sqrt()
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
fn aligned(number: Number, rough: Number) -> Number {
    let turns = (8.0 / PI * (rough / number).arg()).round();
    number * Number::cis(PI / 8.0 * turns)
}

pub(super) fn distance(a: &Phase, b: &Phase) -> f64 {
    let difference = (0..6).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    // What is not a number is no agreement.
    if difference.is_nan() {
        f64::INFINITY
    } else {
        difference
    }
}
