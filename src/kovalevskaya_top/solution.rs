//! From the phases back to Ω and z: Kötter's linear system, solved by quotients of theta functions (8.2).

use core::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::constants::{Constants, Phase, Root};
use super::periods::{Curve, Half, MEASURES};
use super::separation::Separation;
use super::theta::{Theta, join, unit};

type Number = Complex<f64>;

const I: Number = Number::new(0.0, 1.0);

/// The linear system, solved by Cramer's rule.
///
/// For each of the three roots e of the cubic, with e′ = 2e − l₁, α = 2√(l₁+e), β = √(d+e′²) and αβ = b, every state obeys
///
/// 2(x₁−x₂) √((s₁−e)(s₂−e)) = α(x₁x₂ − e′) + β(x₁+x₂).
///
/// With Q the vector of the three roots of products, N = α×β, M = αe′×α and O = αe′×β this is x₁−x₂ = −N·αe′/2N·Q, x₁+x₂ = −M·Q/N·Q and x₁x₂ = O·Q/N·Q.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reconstruction {
    /// N, M and O.
    rows: [[Number; 3]; 3],
    /// M×N.
    minors: [Number; 3],
    /// q N·Q.
    side: Number,
}

impl Reconstruction {
    pub fn prepare(constants: &Constants, roots: &[Root; 5]) -> Self {
        let b = constants.b().value();
        let [mut alpha, mut beta, mut right] = [[Number::default(); 3]; 3];
        for j in 0..3 {
            let root = &roots[j];
            let twice = root.real.scaled(2.0) - constants.l1;
            let imaginary = root.imaginary.scaled(2.0);
            let first = Number::new((constants.l1 + root.real).value(), root.imaginary.value());
            let square = twice * twice - imaginary * imaginary + constants.d;
            let second = Number::new(square.value(), (twice * imaginary).scaled(2.0).value());
            (alpha[j], beta[j]) = (2.0 * first.sqrt(), second.sqrt());
            // The smaller of the two is a root of a difference; the product is known.
            if alpha[j].norm() > beta[j].norm() {
                beta[j] = b / alpha[j];
            } else if beta[j].norm() > 0.0 {
                alpha[j] = b / beta[j];
            }
            right[j] = alpha[j] * Number::new(twice.value(), imaginary.value());
        }
        let [n, m, o] = [
            cross(&alpha, &beta),
            cross(&right, &alpha),
            cross(&right, &beta),
        ];
        Self {
            side: 0.25 * I * dot(&n, &right),
            minors: cross(&m, &n),
            rows: [n, m, o],
        }
    }

    /// The quotients for functions that are these factors times √((s₁−e)(s₂−e)), and these times the Wronskians of the second and third, third and first, first and second;
    /// with one of eight choices of signs of the three roots.
    pub fn quotients(
        &self,
        factors: [Number; 3],
        wronskians: [Number; 3],
        choice: usize,
    ) -> Quotients {
        let signs = [0, 1, 2].map(|bit| if choice >> bit & 1 == 0 { 1.0 } else { -1.0 });
        let pair = |i: usize| signs[(i + 1) % 3] * signs[(i + 2) % 3];
        Quotients {
            rows: self
                .rows
                .map(|row| [0, 1, 2].map(|j| row[j] * factors[j] * signs[j])),
            wronskians: [0, 1, 2].map(|i| self.minors[i] * wronskians[i] * pair(i)),
            side: self.side,
        }
    }
}

/// A function of time and its derivative.
pub(super) type Moving = [Number; 2];

/// Ω and z as quotients of sums of functions with one common denominator; there is nothing to divide by where q = 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Quotients {
    /// What stands before the functions of the three roots in S, −2pS and x₁x₂S.
    rows: [[Number; 3]; 3],
    /// What stands before their Wronskians in −rS times the next.
    wronskians: [Number; 3],
    /// qS over the function that vanishes where q does.
    side: Number,
}

impl Quotients {
    /// The state: r, z₂ and z₃ are not quotients by q but derivatives of p, q and r.
    pub fn state(
        &self,
        constants: &Constants,
        roots: &[Moving; 3],
        wronskians: &[Moving; 3],
        alone: Moving,
    ) -> Phase {
        let sum = |row: &[Number; 3], of: &[Moving; 3]| [0, 1].map(|i| dot(row, &of.map(|x| x[i])));
        let bottom = sum(&self.rows[0], roots);
        // A quotient by the first row, and its rate.
        let over = |[x, x_rate]: Moving| {
            let quotient = x / bottom[0];
            [quotient, (x_rate - quotient * bottom[1]) / bottom[0]].map(|x| x.re)
        };
        let [q, q_rate] = over(alone.map(|x| x * self.side));
        let [p, _] = over(sum(&self.rows[1], roots).map(|x| x * -0.5));
        let [squares, _] = over(sum(&self.rows[2], roots));
        let [r, r_rate] = over(sum(&self.wronskians, wronskians).map(|x| -x / self.side));
        let c = constants.c.value();
        let z1 = (6.0 * constants.l1.value() - 2.0 * squares - r * r) / (2.0 * c);
        [p, q, r, z1, -r_rate / c, (2.0 * q_rate + r * p) / c]
    }
}

pub(super) fn cross(a: &[Number; 3], b: &[Number; 3]) -> [Number; 3] {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

pub(super) fn dot(a: &[Number; 3], b: &[Number; 3]) -> Number {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The functions of a curve that is not degenerate: Riemann's, with half periods.
///
/// √((s₁−e)(s₂−e)) is a theta function over the one that vanishes where s₂ is infinite, times the fourth root of ±Π(e−e′) over the other four roots e′; and the Wronskian of two such
/// roots is √(e−e′) times both constants and the theta function of the sum of their half periods (Thomae 1870, Kötter 1893).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Torus {
    /// θ with τm/2 added, for each m, where one is needed.
    tables: Vec<Option<Theta>>,
    /// Half periods of the functions of the three roots, of their Wronskians, and of the one alone.
    places: [Half; 7],
    /// Re τm/2 in both components, a share of m₁ + m₂.
    twisted: bool,
    /// Turns of the phases a unit of time, halved.
    advance: [f64; 2],
}

impl Torus {
    pub fn prepare(curve: &Curve, advance: [f64; 2]) -> Option<Self> {
        let one = |j: usize| curve.infinite.plus(curve.roots[j % 3]);
        let places = core::array::from_fn(|i| match i {
            0..3 => one(i),
            3..6 => one(i + 1).plus(curve.roots[(i + 2) % 3]),
            _ => curve.infinite,
        });
        let tables = MEASURES.map(|m| {
            let [a, b] = m.map(|x| -0.5 * f64::from(x));
            let needed = places.iter().any(|place: &Half| place.m == m);
            needed.then(|| Theta::prepare(curve.y, curve.y.map(|[x, y]| x * a + y * b)))
        });
        let lacking = tables.iter().any(|table| matches!(table, Some(None)));
        (!lacking).then(|| Self {
            tables: tables.into_iter().map(Option::flatten).collect(),
            places,
            twisted: curve.twisted,
            advance,
        })
    }

    /// All seven where the phases have turned so far, halved.
    pub fn at(&self, v: [f64; 2]) -> [Moving; 7] {
        let once = v.map(unit);
        let mut found = [Moving::default(); 7];
        for (m, table) in MEASURES.iter().zip(&self.tables) {
            let Some(table) = table else { continue };
            let [first, second] = m.map(i32::from);
            let twist = if self.twisted { first + second } else { 0 };
            let turned = once.map(|x| x * x * I.powi(twist));
            let sums = table.with_rates(turned, self.advance.map(|x| 2.0 * x));
            let factor = once[0].powi(first) * once[1].powi(second);
            let growth = I
                * TAU
                * (f64::from(first) * self.advance[0] + f64::from(second) * self.advance[1]);
            for (value, place) in found.iter_mut().zip(&self.places) {
                if place.m == *m {
                    let [x, rate] = sums
                        .each_ref()
                        .map(|sums| join(sums, place.n, self.twisted));
                    *value = [factor * x, factor * (rate + growth * x)];
                }
            }
        }
        found
    }

    /// The constants of the three roots and of their Wronskians, from the theta functions where (s₁−e)(s₂−e) have these values: these tell which of the fourth roots they are.
    pub fn constants(
        &self,
        separation: &Separation,
        v: [f64; 2],
        products: &[Number; 5],
    ) -> [[Number; 3]; 2] {
        let found = self.at(v);
        let alone = found[6][0];
        let roots: [Number; 3] = core::array::from_fn(|j| {
            let rough = products[j] * (alone / found[j][0]).powi(2);
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
