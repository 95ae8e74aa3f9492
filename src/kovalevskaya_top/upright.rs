//! The motions that start with z exactly along axis 3: a root of her cubic is e₅, and one handle of the curve is gone (8.2).
//!
//! Such a start has E/I₃ − |K| = L_vert²/2I₃² by algebra, whatever Ω is, so that P(s) = (s−e)²Q(s) with e = e₅ and Q = −4(s−e₄)(s−e_a)(s−e_b). Her two sums become
//! Σdu_i = dt and Σdu_i/(s_i−e) = 0, du = ds/√Q: elliptic integrals of the first and the third kind. With s = −℘(u), but for a constant, e = −℘(κ), U = u₁ + u₂ and Weierstrass's σ
//!
//! U = U₀ + t, σ(u₁−κ)σ(u₂−κ) = e^Y σ(u₁+κ)σ(u₂+κ), Y = Y₀ − 2ζ(κ)t,
//!
//! and from the relation of three terms between σ's, with D = e^{−Y/2}σ(U−κ) + e^{Y/2}σ(U+κ),
//!
//! √((s₁−e)(s₂−e)) = σ(2κ)σ(U)/(σ(κ)³D), √((s₁−e_j)(s₂−e_j)) = σ_j(κ)(e^{−Y/2}σ_j(U−κ) − e^{Y/2}σ_j(U+κ))/(σ(κ)D).
//!
//! These are theta functions of two variables with one entry of the period matrix at infinity. Kötter's linear system for x₁x₂, x₁+x₂ and x₁−x₂ (`solution`) is solved by Cramer's rule, and what stands
//! there instead of Wronskians are again such sums: for e_a, e_b the one of σ₄ with a plus, for e, e_j a multiple of σ_j(U). D is not divided by, so nothing goes wrong at q = 0.
//!
//! Where e is the smallest root κ is real: one of s₁, s₂ comes to e as e^{−|2ζ(κ) t|} and the top to a periodic motion, from which it came. Otherwise Y is imaginary, and the motion has two periods.
//!
//! The integral of the third kind for the attitude has residue l(m²−k²)/2 (`periods`), and it vanishes: m = k. What is left is algebraic. With w = p + iq, ζ = z₁ + iz₂,
//! K = ke^{iψ} = w² − cζ, we^{−iψ/2} = a + ib and ζe^{−iψ/2} = ν + iη every such motion keeps, with one of the two signs of e^{iψ/2},
//!
//! r − 2lz₃ = 2√k ν and η(lη − b) = ν(a − lν + √k z₃),
//!
//! (found by trial, held by the tests), and the phase of η₂² (`precession`) is lt + 2 arg (a − lν + √k z₃ + i(lη − b))(√k + a + ib). For η₁² it is the conjugate at (p, q, −r, z₁, z₂, −z₃). ν is
//! σ_a(U) and σ_b(U) over a sum: z comes back to axis 3 in equal times.

use core::f64::consts::PI;

use nalgebra::Complex;

use super::constants::{Constants, Phase, Root, WidePhase};
use super::exact::tried;
use super::precession::horizontal;
use super::separation::Variables;
use super::solution::{Functions, Quotients, Reconstruction};
use super::taylor::{Carried, about_third, project, shortest};
use crate::precise::Number as _;

type Number = Complex<f64>;

const I: Number = Number::new(0.0, 1.0);

/// θ₁, θ₂, θ₃, θ₄ as σ, σ₂, σ₃, σ₄ without the factor e^{ηu²/2ω}, which cancels.
#[derive(Debug, Clone, PartialEq)]
struct Sigma {
    /// π/2ω.
    scale: f64,
    /// ½, and q^{(k²−1)/4} for k = 1, 3, …, which are those of σ and σ₂, q^{k²/4} for k = 2, 4, ….
    terms: Vec<Number>,
    /// Reciprocals of θ₁′(0)·scale, θ₂(0), θ₃(0) and θ₄(0).
    norms: [Number; 4],
}

/// Half of the most terms of a theta series.
const LONGEST: f64 = 40.0;

impl Sigma {
    /// For a half period and a nome; none if the series are long.
    fn prepare(half_period: f64, ratio: f64, rhombic: bool) -> Option<Self> {
        let count = 2.0 + (1.0 + 40.0 / (PI * ratio)).sqrt();
        // Periods that are not numbers are refused as well.
        if !(half_period > 0.0 && count < LONGEST) {
            return None;
        }
        let turn = if rhombic { I } else { Number::from(1.0) };
        let power = |n: u32| turn.powu(n % 4) * (-PI * ratio * f64::from(n)).exp();
        let mut sigma = Self {
            scale: 0.5 * PI / half_period,
            terms: (0..2 * count as u32).map(|k| power(k * k / 4)).collect(),
            norms: [Number::from(1.0); 4],
        };
        sigma.terms[0] *= 0.5;
        let [[_, slope], rest @ ..] = sigma.at(Number::default());
        sigma.norms = [slope, rest[0][0], rest[1][0], rest[2][0]].map(|x| x.inv());
        Some(sigma)
    }

    /// σ, σ₂, σ₃, σ₄ at u, each with its derivative.
    fn at(&self, u: Number) -> [[Number; 2]; 4] {
        let once = (I * u * self.scale).exp();
        let back = once.inv();
        let mut sums = [[Number::default(); 2]; 4];
        let (mut up, mut down) = (Number::from(1.0), Number::from(1.0));
        for (k, term) in self.terms.iter().enumerate() {
            let order = k as f64 * self.scale;
            let (cosine, sine) = ((up + down) * term, (down - up) * term * I);
            let even = [cosine, -sine * order];
            let sign = if k & 2 == 0 { 1.0 } else { -1.0 };
            let (place, pair) = if k & 1 == 0 {
                (2, [even, even.map(|x| x * sign)])
            } else {
                (0, [[sine * sign, cosine * (order * sign)], even])
            };
            for (sum, values) in sums[place..].iter_mut().zip(pair) {
                *sum = [sum[0] + values[0], sum[1] + values[1]];
            }
            (up, down) = (up * once, down * back);
        }
        core::array::from_fn(|j| sums[j].map(|x| x * self.norms[j]))
    }
}

/// The functions of a curve with one handle gone.
#[derive(Debug, Clone, PartialEq)]
struct Sums {
    sigma: Sigma,
    /// Which of σ₂, σ₃, σ₄ belong to the cubic's other roots e_a and e_b, and which to e₄.
    places: [usize; 3],
    kappa: Number,
    /// Y′.
    rate: Number,
}

impl Sums {
    /// U and Y of a start, for either sign of u₁ and u₂.
    fn origins(
        &self,
        constants: &Constants,
        wide: &WidePhase,
        [a, b, upper, e]: [Root; 4],
    ) -> Option<[[Number; 2]; 4]> {
        let Variables {
            s1,
            numerator,
            q_squared,
        } = Variables::of(constants, [wide[0], wide[1]]);
        let second = constants.l1.scaled(0.5) - numerator / q_squared.scaled(8.0);
        let [one, two] = [s1, second].map(|s| {
            let s = Root::on_axis(s);
            // s₂ is infinite where q = 0.
            let u = if s.real.value().is_finite() {
                first_kind([a, b, upper].map(|x| x.from(&s)))
            } else {
                Number::default()
            };
            let at = |u: Number| self.sigma.at(u)[0][0];
            let (mut less, mut more) = (at(u - self.kappa), at(u + self.kappa));
            // Next to e one of them is small, and the product tells it to all digits.
            let product = s.from(&e).re * (at(u) * at(self.kappa)).powu(2);
            if less.norm() < 0.5 * more.norm() {
                less = product / more;
            } else if more.norm() < 0.5 * less.norm() {
                more = product / less;
            }
            (u, (less / more).ln())
        });
        let all = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
        let all = all.map(|(x, y)| [one.0 * x + two.0 * y, one.1 * x + two.1 * y]);
        all.iter().flatten().all(|x| x.is_finite()).then_some(all)
    }

    /// At these U and Y.
    fn at(&self, [u, y]: [Number; 2]) -> Functions {
        let (y, rate) = (y * 0.5, self.rate * 0.5);
        let [alone, less, more] =
            [Number::default(), -self.kappa, self.kappa].map(|x| self.sigma.at(u + x));
        // Only ratios count, so the greater of the exponentials may be 1.
        let size = y.re.abs();
        let (fall, rise) = ((-y - size).exp(), (y - size).exp());
        let single = |place: usize| alone[place].map(|x| x * (-size).exp());
        let both = |place: usize, sign: f64| {
            let ([a, a_rate], [b, b_rate]) = (less[place], more[place]);
            let (fall, rise) = (fall, rise * sign);
            [
                fall * a + rise * b,
                fall * (a_rate - rate * a) + rise * (b_rate + rate * b),
            ]
        };
        let [a, b, upper] = self.places;
        [
            single(0),
            both(a, -1.0),
            both(b, -1.0),
            both(upper, 1.0),
            single(b),
            single(a),
            both(0, 1.0),
        ]
    }
}

/// A motion that starts with z along axis 3.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Upright {
    sums: Sums,
    /// U and Y at time 0.
    origin: [Number; 2],
    quotients: Quotients,
    /// The phases of η₁² and η₂² at time 0, but for 2φ.
    angles: [f64; 2],
}

/// The largest disagreement of the angles with which it is trusted, relative.
const TRUSTED: f64 = 1e-11;

/// |Y| from which a : q tells the sign of √K: what is left of the other side is 2e-6.
const FADED: f64 = 26.0;

impl Upright {
    /// None if more roots meet.
    pub fn find(constants: &Constants, wide: &WidePhase, whole: &Carried) -> Option<Self> {
        let roots = constants.roots_with_fifth();
        let [.., upper, e] = roots;
        let [a, b] = [roots[1], roots[2]];
        let rhombic = !a.is_real();
        // Which root belongs to σ₂, σ₃, σ₄, and the half periods, by the arithmetic–geometric mean.
        let (order, [first, second]) = if rhombic {
            let z = a.from(&upper);
            let size = z.norm().sqrt();
            let [half, other] = [z, -z].map(|z| mean(z.sqrt().re, size));
            // e_a is above the axis, and θ₂(0)⁴ − θ₃(0)⁴ has this sign.
            ([3, 2, 1], [half, 2.0 * other])
        } else {
            let mut order = [1, 2, 3];
            order.sort_by(|&i: &usize, &j: &usize| roots[i].from(&roots[j]).re.total_cmp(&0.0));
            let [low, middle, high] = order.map(|i| roots[i]);
            let [whole, below, above] =
                [(high, low), (middle, low), (high, middle)].map(|(x, y)| x.from(&y).re.sqrt());
            (order, [mean(whole, below), mean(whole, above)])
        };
        let sigma = Sigma::prepare(0.5 * PI / first, first / second, rhombic)?;
        let place = |root: usize| 1 + order.iter().position(|&i| i == root).unwrap_or(0);
        let places = [1, 2, 3].map(place);
        let over = |root: &Root| [a, b, upper].map(|x| x.from(root));
        let kappa = first_kind(over(&e));
        let at_kappa = sigma.at(kappa);
        let [s, slope] = at_kappa[0];
        let [[double, _], ..] = sigma.at(kappa * 2.0);
        let factors = [
            double / (s * s * s),
            at_kappa[places[0]][0] / s,
            at_kappa[places[1]][0] / s,
        ];
        let apart = a.from(&b);
        let system = Reconstruction::prepare(constants, &roots, [apart, b.from(&e), e.from(&a)]);
        let [first, second, third] = factors;
        let wronskians = [
            second * third * apart,
            first * third * third,
            -first * second * second,
        ];
        let sums = Sums {
            sigma,
            places,
            kappa,
            rate: -2.0 * slope / s,
        };
        let origins = sums.origins(constants, wide, [a, b, upper, e])?;
        let factors = [factors, wronskians];
        let (quotients, origin) =
            system.fitted(constants, factors, false, origins, |x| sums.at(x), &whole.0);
        let mut upright = Self {
            sums,
            origin,
            quotients,
            angles: [0.0; 2],
        };
        let trial = tried(constants, whole, |t| upright.state(constants, t)).ok()?;
        let mut agree = true;
        upright.angles = [0, 1].map(|side| {
            let seen: Vec<Number> = trial
                .iter()
                .map(|(t, (state, attitude))| {
                    let [_, eta @ ..] = horizontal(*attitude);
                    let bearing = upright.bearing(constants, state, side, *t);
                    eta[side] * (bearing * bearing).conj() * Number::cis(-constants.l.value() * t)
                })
                .collect();
            let sum: Number = seen.iter().sum();
            let largest = seen.iter().fold(0.0_f64, |m, x| m.max(x.norm()));
            let along = sum.conj() / sum.norm();
            agree &= seen
                .iter()
                .all(|x| (x * along).im.abs() <= TRUSTED * largest);
            sum.arg()
        });
        agree.then_some(upright)
    }

    pub fn state(&self, constants: &Constants, t: f64) -> Phase {
        let [u, y] = self.origin;
        let functions = self.sums.at([u + t, y + self.sums.rate * t]);
        project(constants, &self.quotients.state(constants, &functions))
    }

    /// √K by its real part beside w, √K̄w = a + ib over √k: which of the two roots it is at time t.
    ///
    /// The one for which r − 2lz₃ = 2 Re √K̄ζ. Both sides vanish where z is along axis 3 again, and a = √k there; and they fade as the motion comes to be
    /// periodic, and a : q is a constant there, one before the passage and its opposite after: negative after it if e is the smallest root, positive if s₁ comes to it in its band (found by trial,
    /// too).
    fn root(
        &self,
        constants: &Constants,
        &[p, q, r, z1, z2, z3]: &Phase,
        side: f64,
        t: f64,
    ) -> Number {
        let (w, zeta) = (Number::new(p, q), Number::new(z1, z2));
        let constant = w * w - constants.c.value() * zeta;
        let root = (constant / constant.norm()).sqrt();
        let along = (w * root.conj()).re;
        let told = (zeta * root.conj()).re * side * (r - 2.0 * constants.l.value() * z3);
        let y = self.passage(t);
        let also = if y.abs() > FADED {
            // κ is real or half a period of the other kind above or below the real line, nothing between.
            let sense = if self.sums.kappa.im.abs() < 1e-6 {
                -1.0
            } else {
                1.0
            };
            1e-2 * along * q * sense * side * y.signum()
        } else {
            1e-14 * along
        };
        if told + also < 0.0 { -root } else { root }
    }

    /// How far from the passage, in powers of e.
    fn passage(&self, t: f64) -> f64 {
        (self.origin[1] + self.sums.rate * t).re
    }

    /// e^{iφ} but for a real factor, if the phase of η₂² (side 1) or η₁² (side 0) is lt + 2φ.
    fn bearing(&self, constants: &Constants, state: &Phase, side: usize, t: f64) -> Number {
        let [l, k] = [constants.l, constants.k].map(|x| x.value());
        let sign = if side == 1 { 1.0 } else { -1.0 };
        let [p, q, _, z1, z2, z3] = *state;
        let root = self.root(constants, state, sign, t).conj();
        let (w, zeta) = (Number::new(p, q) * root, Number::new(z1, z2) * root);
        let size = k.sqrt();
        let first = Number::new(w.re - l * zeta.re + size * sign * z3, l * zeta.im - w.im);
        let second = size * Number::new(zeta.im, zeta.re);
        let greater = if second.norm_sqr() > first.norm_sqr() {
            second
        } else {
            first
        };
        let bearing = greater * (size + w);
        if side == 1 { bearing } else { bearing.conj() }
    }

    /// The state and how it stands.
    pub fn carried(&self, constants: &Constants, t: f64) -> Carried {
        let state = self.state(constants, t);
        let [.., z1, z2, z3] = state;
        let upright = shortest([z1, z2, z3]);
        // The one of η₁ and η₂ that is greater.
        let side = usize::from(z3 >= 0.0);
        let [_, eta @ ..] = horizontal(upright);
        let angle = self.angles[side]
            + constants.l.value() * t
            + 2.0 * self.bearing(constants, &state, side, t).arg()
            - eta[side].arg();
        (state, about_third(angle) * upright)
    }
}

/// ∫ds/√Q from −∞, by Carlson's duplication: R_F of the distances to the three roots, also where they are complex.
fn first_kind(mut distances: [Number; 3]) -> Number {
    for _ in 0..40 {
        let [x, y, z] = distances.map(|x| x.sqrt());
        let sum = x * y + y * z + z * x;
        distances = distances.map(|x| (x + sum) * 0.25);
    }
    (distances.iter().sum::<Number>() / 3.0).sqrt().inv()
}

/// The arithmetic–geometric mean.
fn mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}
