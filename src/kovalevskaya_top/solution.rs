//! From the two phases back to Ω and z: Kötter's linear system, and its first two time derivatives (8.2).

use nalgebra::Complex;

use super::constants::{Constants, Phase, Root};
use super::separation::{Local, Phases, Separation};

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
    pub rows: [[Number; 3]; 3],
    /// M×N.
    pub minors: [Number; 3],
    /// q N·Q.
    pub side: Number,
    /// Which sign each of the three square roots has.
    pub signs: [f64; 3],
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
            signs: [1.0; 3],
        }
    }

    /// The state at these phases, regular at q = 0: there r, z₂ and z₃ are not quotients by q but derivatives of p and q.
    pub fn state(&self, constants: &Constants, separation: &Separation, phases: Phases) -> Phase {
        let local = separation.local(phases);
        let flow = Flow::at(separation, &local);
        let [_, [sine, cosine]] = local.half;
        let [mut q, mut q1, mut q2] = [[Number::default(); 3]; 3];
        for j in 0..3 {
            [q[j], q1[j], q2[j]] = flow
                .product(separation, &local, j)
                .map(|x| x * self.signs[j]);
        }
        let [n, m, o] = &self.rows;
        let bottom = dot(n, &q);
        // Derivatives over cos(f₂/2): of the logarithm of N·Q, and (M·Q′)(N·Q) − (M·Q)(N·Q′).
        let growth = dot(n, &q1) / bottom;
        let wronskian = dot(&self.minors, &cross(&q1, &q));
        let wronskian_rate = dot(&self.minors, &cross(&q2, &q));
        let share = -1.0 / (bottom * self.side);
        let r = (wronskian * share).re;
        let r_rate = ((wronskian_rate - wronskian * growth * cosine) * share).re;
        let side = self.side / bottom;
        let q_rate = (side * (-0.5 * sine * flow.rates[1] - cosine * cosine * growth)).re;
        let p = -0.5 * (dot(m, &q) / bottom).re;
        let squares = (dot(o, &q) / bottom).re;
        let c = constants.c.value();
        let z1 = (6.0 * constants.l1.value() - 2.0 * squares - r * r) / (2.0 * c);
        let z3 = (2.0 * q_rate + r * p) / c;
        [p, side.re * cosine, r, z1, -r_rate / c, z3]
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

/// How fast the phases and their functions change.
struct Flow {
    /// f₁′/cos²(f₂/2) and f₂′, never zero.
    rates: [f64; 2],
    /// Their time derivatives.
    second: [f64; 2],
}

impl Flow {
    fn at(separation: &Separation, local: &Local) -> Self {
        let [[s, k], [sine, cosine]] = local.half;
        let [a, b, c] = separation.ends;
        let rates = [local.root_g / local.d, local.root_h / local.d];
        let [first, second] = [rates[0] * cosine * cosine, rates[1]];
        // d ln √G = ½ Σ ds₁/(s₁−e), d ln √H = ½ Σ dh/h, over the roots that G and H contain.
        let s1_rate = separation.width * s * k * first;
        let g = (0..5)
            .filter(|i| ![a, b].contains(i))
            .map(|i| (s1_rate / local.s1_from[i]).re)
            .sum::<f64>();
        let turning = sine * cosine * second;
        let h = (0..5)
            .filter(|i| *i != c)
            .map(|i| (-separation.from_ends[1][i] * turning / local.h[i]).re)
            .sum::<f64>();
        let d_rate = s1_rate * cosine * cosine + turning * (separation.depth - local.s1_from[c].re);
        Self {
            rates,
            second: [
                rates[0] * (0.5 * g - d_rate / local.d),
                rates[1] * (0.5 * h - d_rate / local.d),
            ],
        }
    }

    /// Q = cos(f₂/2)√((s₁−e)(s₂−e)) of the root e_j, then Q′/cos(f₂/2), and the time derivative of that.
    ///
    /// Q = uv with u² = s₁ − e and v² = −h, both smooth: at an end of the band the root is taken of sin² or cos² before the sign is lost.
    fn product(&self, separation: &Separation, local: &Local, j: usize) -> [Number; 3] {
        let [[s, k], [sine, cosine]] = local.half;
        let [a, b, c] = separation.ends;
        let root = separation.width.sqrt();
        let [u, u1, u2] = if j == a {
            [root * s, 0.5 * root * k, -0.25 * root * s].map(Number::from)
        } else if j == b {
            [root * k, -0.5 * root * s, -0.25 * root * k].map(|x| I * x)
        } else {
            let u = local.s1_from[j].sqrt();
            let u1 = separation.width * s * k / (2.0 * u);
            let u2 = separation.width * (k * k - s * s) / (4.0 * u) - u1 * u1 / u;
            [u, u1, u2]
        };
        // v, and dv/df₂ and its derivative without their factor cos(f₂/2).
        let [v, v1, v2] = if j == c {
            let root = separation.depth.sqrt();
            [I * root * sine, 0.5 * root * I, Number::default()]
        } else {
            let v = I * local.h[j].sqrt();
            // e − B, from which m + C − e = B − e.
            let v1 = separation.from_ends[1][j] * sine / (2.0 * v);
            let v2 = separation.from_ends[1][j] / (4.0 * v) - v1 * v1 / v;
            [v, v1, v2]
        };
        let [rate1, rate2] = self.rates;
        let first = rate1 * cosine * cosine;
        let over_cosine = u1 * v * cosine * rate1 + u * v1 * rate2;
        let derivative = (u2 * first * v + u1 * v1 * (cosine * rate2)) * (cosine * rate1)
            - u1 * v * (0.5 * sine * rate2 * rate1)
            + u1 * v * (cosine * self.second[0])
            + (u1 * first * v1 + u * v2 * (cosine * rate2)) * rate2
            + u * v1 * self.second[1];
        [u * v, over_cosine, derivative]
    }
}
