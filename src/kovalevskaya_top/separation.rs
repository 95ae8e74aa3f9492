//! Her separation variables s₁, s₂, the two phases that run through them, and the time (8.2).

use core::cmp::Ordering;
use core::f64::consts::TAU;

use nalgebra::Complex;

use super::constants::{Constants, Root, WidePhase};
use super::series::{LONGEST, Quadratures};
use crate::precise::DoubleDouble;

/// The phases f₁, f₂: s₁ = A + (B−A) sin²(f₁/2), s₂ = C − m tan²(f₂/2) with m = B − C.
///
/// s₁ swings between two neighbouring roots A < B of P, s₂ comes from −∞, turns at the smallest root C and goes back; it is
/// infinite whenever q = 0, and f₂ is there an odd multiple of π. Both phases always increase.
pub(super) type Phases = [f64; 2];

/// The band of s₁, the end of s₂, and the four quadratures.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Separation {
    /// The roots e₁ … e₅.
    pub roots: [Root; 5],
    /// Which root is A, B and C.
    pub ends: [usize; 3],
    /// e − A, e − B and e − C of every root, rounded once.
    pub from_ends: [[Complex<f64>; 5]; 3],
    /// Δ = B − A.
    pub width: f64,
    /// m = B − C.
    pub depth: f64,
    /// A − σ = σ − C. Integrals of (s − σ)ds/√P grow in s₁ and fall in s₂, so that nothing cancels in the determinant of the four.
    half_way: f64,
    /// a₁ = ∫df₁/√G and b₁ = ∫(s₁−σ)df₁/√G.
    first: Quadratures<2>,
    /// a₂ = ∫w df₂ and b₂ = ∫(s₂−σ)w df₂.
    second: Quadratures<2>,
}

/// G and H at given phases, and what else both the quadratures and the solution ask for.
pub(super) struct Local {
    /// sin and cos of f₁/2 and f₂/2.
    pub half: [[f64; 2]; 2],
    /// s₁ − e for every root.
    pub s1_from: [Complex<f64>; 5],
    /// h_e = (e−C)cos²(f₂/2) + m sin²(f₂/2) = −(s₂ − e)cos²(f₂/2) for every root.
    pub h: [Complex<f64>; 5],
    /// √G: (ds₁/df₁)² G = P(s₁).
    pub root_g: f64,
    /// √(H/m): w = cos²(f₂/2)/√(H/m).
    pub root_h: f64,
    /// D = (s₁ − s₂)cos²(f₂/2), never zero.
    pub d: f64,
}

impl Separation {
    /// The band that contains s₁; none if the roots leave no room for it.
    pub fn prepare(constants: &Constants, s1: DoubleDouble) -> Option<Self> {
        let roots = constants.roots();
        let real = in_order(&roots);
        // P > 0 below the smallest root, between the second and third, and between the fourth and fifth.
        let outside = |a: usize, b: usize| {
            let below = (roots[a].real - s1).value();
            below.max((s1 - roots[b].real).value())
        };
        let (a, b) = real[1..]
            .chunks_exact(2)
            .map(|pair| (pair[0], pair[1]))
            .min_by(|x, y| outside(x.0, x.1).total_cmp(&outside(y.0, y.1)))?;
        let ends = [a, b, real[0]];
        let from_ends = ends.map(|end| roots.map(|root| root.from(&roots[end])));
        let mut separation = Self {
            roots,
            ends,
            from_ends,
            width: from_ends[0][b].re,
            depth: from_ends[2][b].re,
            half_way: 0.5 * from_ends[2][a].re,
            first: Quadratures::empty(),
            second: Quadratures::empty(),
        };
        let first = Quadratures::prepare(LONGEST, |f| {
            let local = separation.local([f, 0.0]);
            [1.0, separation.above(&local)].map(|x| x / local.root_g)
        })?;
        let second = Quadratures::prepare(LONGEST, |f| {
            let local = separation.local([0.0, f]);
            let [_, cosine] = local.half[1];
            [cosine * cosine, -separation.below(&local)].map(|x| x / local.root_h)
        })?;
        (separation.first, separation.second) = (first, second);
        Some(separation)
    }

    /// The smallest distance of two roots, as a part of the greatest; e₄ and e₅ may meet at no loss.
    pub fn narrowest(&self) -> f64 {
        let values = self.roots.map(|root| root.value());
        let mut least = f64::INFINITY;
        let mut greatest = f64::MIN_POSITIVE;
        for (i, a) in values.iter().enumerate() {
            for b in &values[..i.min(3)] {
                least = least.min((a - b).norm());
                greatest = greatest.max((a - b).norm());
            }
        }
        least / greatest
    }

    /// s₁ and s₂ at given phases; s₂ is −∞ where q = 0.
    pub fn variables(&self, phases: Phases) -> [f64; 2] {
        let local = self.local(phases);
        let [_, cosine] = local.half[1];
        let s1 = self.s1(&local);
        [s1, s1 - local.d / (cosine * cosine)]
    }

    /// s₁.
    pub fn s1(&self, local: &Local) -> f64 {
        let [sine, _] = local.half[0];
        self.roots[self.ends[0]].real.value() + self.width * sine * sine
    }

    /// s₁ − σ.
    fn above(&self, local: &Local) -> f64 {
        let [sine, _] = local.half[0];
        self.half_way + self.width * sine * sine
    }

    /// (σ − s₂)cos²(f₂/2).
    fn below(&self, local: &Local) -> f64 {
        let [sine, cosine] = local.half[1];
        self.half_way * cosine * cosine + self.depth * sine * sine
    }

    pub fn local(&self, phases: Phases) -> Local {
        let half = phases.map(|f| {
            let (sine, cosine) = (0.5 * f).sin_cos();
            [sine, cosine]
        });
        let [[s, k], [sine, cosine]] = half;
        let [a, b, c] = self.ends;
        let s1_from: [Complex<f64>; 5] = core::array::from_fn(|i| {
            // From the end that is nearer, so that nothing cancels at either.
            if s * s < 0.5 {
                self.width * s * s - self.from_ends[0][i]
            } else {
                -self.width * k * k - self.from_ends[1][i]
            }
        });
        let h: [Complex<f64>; 5] = core::array::from_fn(|i| {
            self.from_ends[2][i] * (cosine * cosine) + self.depth * sine * sine
        });
        let product = |values: &[Complex<f64>; 5], without: &[usize]| {
            (0..5)
                .filter(|i| !without.contains(i))
                .map(|i| values[i])
                .product::<Complex<f64>>()
                .re
        };
        Local {
            half,
            root_g: 2.0 * product(&s1_from, &[a, b]).abs().sqrt(),
            root_h: 2.0 * (product(&h, &[c]) / self.depth).abs().sqrt(),
            d: s1_from[c].re * cosine * cosine + self.depth * sine * sine,
            s1_from,
            h,
        }
    }

    // ANCHOR: abel
    /// a₁(f₁) − a₂(f₂) and b₁(f₁) − b₂(f₂): the first stays, the second is the time.
    pub fn abel(&self, [f1, f2]: Phases) -> [f64; 2] {
        let ([a1, b1], [a2, b2]) = (self.first.periodic(f1), self.second.periodic(f2));
        let [m1, n1] = self.first.means;
        let [m2, n2] = self.second.means;
        [m1 * f1 - m2 * f2 + (a1 - a2), n1 * f1 - n2 * f2 + (b1 - b2)]
    }

    /// The phases if both sums only grew.
    fn linear(&self, [a, b]: [f64; 2]) -> Phases {
        let ([a1, b1], [a2, b2]) = (self.first.means, self.second.means);
        let determinant = b1 * a2 - a1 * b2;
        [
            (a2 * b - b2 * a) / determinant,
            (a1 * b - b1 * a) / determinant,
        ]
    }

    /// The phases at which both sums have these values, by Newton's method from the linear part.
    ///
    /// The map is one to one on the whole plane: its determinant (s₁ − s₂)w/√G is positive. A step after which the sums were no closer is halved.
    pub fn phases(&self, target: [f64; 2]) -> Phases {
        let mut phases = self.linear(target);
        let missing = |phases: Phases| {
            let sums = self.abel(phases);
            [target[0] - sums[0], target[1] - sums[1]]
        };
        let size = |x: [f64; 2]| x[0].abs().max(x[1].abs());
        let mut rest = missing(phases);
        for _ in 0..100 {
            let local = self.local(phases);
            let [_, cosine] = local.half[1];
            // df₁ = √G (b − s₂a)/(s₁ − s₂), df₂ = (b − s₁a)/(w(s₁ − s₂)), s less σ and both with the cosine² taken out.
            let [above, below] = [self.above(&local), self.below(&local)];
            let step = [
                local.root_g * (rest[1] * cosine * cosine + below * rest[0]) / local.d,
                local.root_h * (rest[1] - above * rest[0]) / local.d,
            ];
            let rounding = 64.0 * f64::EPSILON * size(phases);
            if size(step) < 1e-10 + rounding {
                return [phases[0] + step[0], phases[1] + step[1]];
            }
            let moved = |share: f64| [phases[0] + share * step[0], phases[1] + share * step[1]];
            // The phases stray by a turn or two at most; between two roots that nearly meet a step may be by far too long.
            let longest = (1.0 / size(step)).min(1.0);
            let closer = (0..HALVINGS)
                .map(|n| moved(longest * 0.5_f64.powi(n)))
                .map(|phases| (phases, missing(phases)))
                .find(|(_, left)| size(*left) < size(rest));
            // Nothing comes closer than rounding lets it.
            let Some(next) = closer else { break };
            (phases, rest) = next;
        }
        phases
    }
    // ANCHOR_END: abel

    /// The real roots in ascending order.
    pub fn in_order(&self) -> Vec<usize> {
        in_order(&self.roots)
    }

    /// e − σ of a real root.
    pub fn over_middle(&self, root: usize) -> f64 {
        self.from_ends[0][root].re + self.half_way
    }

    /// The distances e_i − e_j of all roots, each rounded once. Where two are one, they are taken apart by what no digit of the motion shows.
    pub fn apart(&self) -> [[Complex<f64>; 5]; 5] {
        const NOTHING: f64 = 1e-40;
        let rank = |i: usize| self.in_order().iter().position(|&j| j == i);
        core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let distance = self.roots[i].from(&self.roots[j]);
                match rank(i).cmp(&rank(j)) {
                    _ if distance.norm() > NOTHING || i == j => distance,
                    Ordering::Less => Complex::from(-NOTHING),
                    _ => Complex::from(NOTHING),
                }
            })
        })
    }

    /// The mean over time of 1/((s₁−c)(s₂−c)), c between s₂ and s₁.
    ///
    /// 1/((s₁−c)(s₂−c)) = (1/(s₂−c) − 1/(s₁−c))/(s₁−s₂), and dt/(s₁−s₂) is df₁/√G as well as w df₂.
    pub fn third_kind(&self, c: DoubleDouble) -> Option<f64> {
        let [from_a, from_b, from_c] = self.ends.map(|end| (c - self.roots[end].real).value());
        let [turns1, turns2] = self.frequencies();
        let means = Quadratures::prepare(LONGEST_MEAN, |f| {
            let local = self.local([f, f]);
            let [[s, k], [sine, cosine]] = local.half;
            let above = if s * s < 0.5 {
                self.width * s * s - from_a
            } else {
                -self.width * k * k - from_b
            };
            let square = cosine * cosine;
            let below = from_c * square + self.depth * sine * sine;
            [
                1.0 / (local.root_g * above),
                square * square / (local.root_h * below),
            ]
        })?;
        let [first, second] = means.means;
        Some(-TAU * (turns1 * first + turns2 * second))
    }

    /// ∫ds/√P and ∫(s−σ)ds/√P in turns of the two phases.
    pub fn normalized(&self, integrals: [f64; 2]) -> Phases {
        self.linear(integrals).map(|u| u / TAU)
    }

    /// Turns of the two phases per unit of time: a₁n₁ = a₂n₂, b₁n₁ − b₂n₂ = 1.
    pub fn frequencies(&self) -> [f64; 2] {
        self.linear([0.0, 1.0 / TAU])
    }

    /// Increase of the four integrals in a whole turn of a phase: real periods of the curve w² = P(s).
    pub fn periods(&self) -> [f64; 4] {
        let ([a1, b1], [a2, b2]) = (self.first.means, self.second.means);
        let middle = self.roots[self.ends[2]].real.value() + self.half_way;
        [a1, b1 + middle * a1, a2, b2 + middle * a2].map(|mean| TAU * mean)
    }

    /// Phases of a start, their signs still open: f₁ from s₁, f₂ from s₂.
    ///
    /// At the ends of their ranges s₁ and s₂ tell the phases to half of their digits, 16 of 32.
    pub fn first_phases(&self, variables: &Variables, l1: DoubleDouble) -> Phases {
        let [a, b, c] = self.ends.map(|end| self.roots[end].real);
        let Variables {
            s1,
            numerator,
            q_squared,
        } = *variables;
        let eight = q_squared.scaled(8.0);
        let deep = numerator + eight * (c - l1.scaled(0.5));
        let phase = |sine: DoubleDouble, cosine: f64| {
            2.0 * sine.value().max(0.0).sqrt().atan2(cosine.max(0.0).sqrt())
        };
        [
            phase(s1 - a, (b - s1).value()),
            phase(deep, eight.value() * self.depth),
        ]
    }
}

/// The real ones of five roots in ascending order.
fn in_order(roots: &[Root; 5]) -> Vec<usize> {
    let mut real: Vec<usize> = (0..5).filter(|&i| roots[i].is_real()).collect();
    real.sort_by(|&i, &j| {
        let gap = (roots[i].real - roots[j].real).value();
        gap.total_cmp(&0.0)
    });
    real
}

/// Most terms of a mean.
const LONGEST_MEAN: usize = 1 << 14;

/// How often a step of Newton's method is halved at most.
const HALVINGS: i32 = 20;

/// s₁, and s₂ as the quotient that q = 0 makes infinite: s₂ = l₁/2 − numerator/8q².
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
    /// They solve (x₁−x₂)²σ² − R(x₁,x₂)σ + S/4 = 0 for σ = s − l₁/2; whichever of R ∓ |R| would cancel is taken from the other by
    /// (R + |R|)(R − |R|) = (x₁−x₂)² S.
    pub fn of(constants: &Constants, &[p, q, ..]: &WidePhase) -> Self {
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
