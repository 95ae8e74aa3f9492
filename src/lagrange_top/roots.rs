//! The kind of nutation and the heights between which the axis moves: the cubic of the tilt and its roots, with every difference that matters
//! formed without cancellation (tutorial 7.2, 7.5).
//!
//! h'² = f(h) for h = cos θ, f(h) = 2g (h − h₁)(h − h₂)(h − h₃), g = Mgl/I₁, and the motion stays in h₁ ≤ h ≤ h₂ ≤ 1 ≤ h₃.
//! The root farther from h₂, h₁ or h₃, stands alone, and Newton's method finds it from outside. The other two come from a
//! quadratic whose discriminant is a sum of squares: about the present tilt if they are h₁ and h₂, about the upright
//! position if they are h₂ and h₃. The distances from ±1 come from f(±1) = −((L_vert ∓ L₃)/I₁)².

use crate::precise::Number;

/// The kind of motion that the axis makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Nutation {
    /// φ' keeps its sign (7.2, picture k).
    Waves,
    /// φ' vanishes at the upper turning point, as after a release from rest (7.4, picture l).
    Cusps,
    /// φ' changes its sign between the turning points (7.2, picture m).
    Loops,
    /// The tilt is constant (7.3, picture n).
    PurePrecession,
    /// Upright (7.5).
    Sleeping {
        /// Whether it stays near the vertical when disturbed: L₃² ≥ 4I₁Mgl.
        stable: bool,
    },
    /// On the separatrix: falls from the upright position, or rises to it, in infinite time (7.5).
    Waking,
    /// Hanging straight down.
    Hanging,
    /// L₃ = 0: a spherical pendulum (7.6).
    SphericalPendulum,
    /// L₃ = L_vert = 0: a pendulum in one plane (7.6).
    PlanePendulum,
    /// No gravity and no Ω across the axis: the body turns about its own axis.
    Spinning,
}

/// The roots of the cubic, h₁ ≤ h₂ ≤ 1 ≤ h₃, with their distances from ±1 (7.2). With gravity upwards, those of −h.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roots {
    /// h₁, the lower turning point of cos θ.
    pub h1: f64,
    /// h₂, the upper one.
    pub h2: f64,
    /// h₃; infinite without gravity.
    pub h3: f64,
    /// 1 − h₁ and 1 − h₂.
    pub one_less: [f64; 2],
    /// 1 + h₁ and 1 + h₂.
    pub one_more: [f64; 2],
    /// h₃ − 1; infinite without gravity.
    pub third_less_one: f64,
}

impl Roots {
    pub(super) fn new(less: [f64; 2], more: [f64; 2], third_less_one: f64) -> Self {
        // Equal roots found in different ways may have been rounded out of order.
        let one_less = [less[0].max(less[1]), less[1]];
        let one_more = [more[0].min(more[1]), more[1]];
        let root = |k: usize| 0.5 * (one_more[k] - one_less[k]);
        Self {
            h1: root(0),
            h2: root(1),
            h3: 1.0 + third_less_one,
            one_less,
            one_more,
            third_less_one,
        }
    }

    pub(super) fn of<N: Number>(d: &Distances<N>, gravity: N) -> Self {
        let value = |x: N| x.narrow().value();
        let third = if gravity.is_zero() {
            f64::INFINITY
        } else {
            value(d.third[0].quotient(gravity.times(2.0)))
        };
        Self::new(d.top.map(value), d.bottom.map(value), third)
    }
}

/// Height and motion of the axis at time 0, everything divided by I₁.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place<N> {
    /// 1 − h and 1 + h.
    pub(super) below_top: N,
    pub(super) above_bottom: N,
    /// Ω₁² + Ω₂².
    pub(super) swing: N,
    /// h'.
    pub(super) rise: N,
    /// Ω₁z₁ + Ω₂z₂: (L_vert − L₃h)/I₁.
    pub(super) drift: N,
}

/// The roots and their distances.
#[derive(Debug, Clone, Copy)]
pub(super) struct Distances<N> {
    /// 1 − h₁, 1 − h₂.
    pub(super) top: [N; 2],
    /// 1 + h₁, 1 + h₂.
    pub(super) bottom: [N; 2],
    /// h₂ − h₁.
    pub(super) band: N,
    /// 2g (h₃ − 1), 2g (1 + h₃), 2g (h₃ − h₁), 2g (h₃ − h₂): finite also without gravity.
    pub(super) third: [N; 4],
    /// h₂ − h and h − h₁ at the start.
    pub(super) to_upper: N,
    pub(super) to_lower: N,
}

/// The integrals of the motion, everything divided by I₁.
#[derive(Debug, Clone, Copy)]
pub(super) struct Integrals<N> {
    /// g = Mgl/I₁, not negative.
    pub(super) gravity: N,
    /// L₃/I₁.
    pub(super) spin: N,
    /// (L_vert − L₃)/I₁ and (L_vert + L₃)/I₁.
    pub(super) difference: N,
    pub(super) sum: N,
    /// Twice the energy above that of the top that spins about its axis upright, and hanging: Ω₁² + Ω₂² there.
    pub(super) above_top: N,
    pub(super) above_bottom: N,
}

impl<N: Number> Integrals<N> {
    /// The integrals of a start.
    pub(super) fn of(gravity: N, spin: N, start: &Place<N>) -> Self {
        let two_g = gravity.times(2.0);
        let above_top = start.swing - two_g * start.below_top;
        Self {
            gravity,
            spin,
            difference: start.drift - spin * start.below_top,
            sum: start.drift + spin * start.above_bottom,
            above_top,
            above_bottom: above_top + two_g.times(2.0),
        }
    }

    /// The kind of nutation, decided by exact zeros and signs; φ' has the sign of (L_vert − L₃h)/I₁, which is given at both turning points.
    pub(super) fn kind(&self, [lower, upper]: [N; 2], d: &Distances<N>) -> Nutation {
        if d.third[3].is_zero() {
            Nutation::Waking
        } else if self.spin.is_zero() && self.sum.is_zero() {
            Nutation::PlanePendulum
        } else if d.band.is_zero() {
            Nutation::PurePrecession
        } else if self.spin.is_zero() {
            Nutation::SphericalPendulum
        } else if upper.is_zero() {
            Nutation::Cusps
        } else if upper.leading() * lower.leading() < 0.0 {
            Nutation::Loops
        } else {
            Nutation::Waves
        }
    }

    /// The roots, the place of the start between them, and (L_vert − L₃h)/I₁ at the lower and at the upper turning point.
    pub(super) fn solve_from(&self, start: &Place<N>) -> (Distances<N>, [N; 2]) {
        let two_g = self.gravity.times(2.0);
        // f(h + d) = 2g d³ + f₂ d² + f₁ d + f₀.
        let f0 = start.rise.square();
        let twice_height = start.above_bottom - start.below_top;
        let f1 = balance([
            (start.drift * self.spin).times(2.0),
            -(twice_height * start.swing),
            -(two_g * start.below_top * start.above_bottom),
        ]);
        let f2 = two_g * twice_height - start.swing - self.spin.square();
        let depressed = [f2, two_g * f1, two_g.square() * f0];
        // The sign of f at its inflection tells on which side h₂ lies.
        let d = if at_inflection(depressed).leading() > 0.0 {
            self.near_the_top(two_g, start)
        } else {
            self.near_the_start(two_g, start, [f0, f1], greatest_root(depressed))
        };
        let drifts = [
            start.drift + self.spin * d.to_lower,
            start.drift - self.spin * d.to_upper,
        ];
        (d, drifts)
    }

    /// `third` is 2g (h₃ − h): h₁ and h₂ are the roots of d² − s d + p about the start.
    fn near_the_start(
        &self,
        two_g: N,
        start: &Place<N>,
        [f0, f1]: [N; 2],
        third: N,
    ) -> Distances<N> {
        let p = -f0.quotient(third);
        let s = (f1 - two_g * p).quotient(third);
        let band = s.square().add_alike(p.times(-4.0)).square_root();
        // The greater of the two in magnitude is a sum; the other is the product divided by it.
        let far = band.add_alike(s.magnitude()).times(0.5);
        let near = (-p).quotient(far);
        let (to_upper, to_lower) = if s.leading() < 0.0 {
            (near, far)
        } else {
            (far, near)
        };
        let top1 = start.below_top.add_alike(to_lower);
        let bottom2 = start.above_bottom.add_alike(to_upper);
        let from_top = third - two_g * start.below_top;
        let from_bottom = third.add_alike(two_g * start.above_bottom);
        // The greater of 1 − h₂ and h₃ − 1 is formed directly, the other from the product of all three distances from 1.
        let direct = start.below_top - to_upper;
        let product = self.difference.square().quotient(top1);
        let (top2, from_top) = if (third * direct).exceeds(from_top * top1) {
            (direct, product.quotient(direct))
        } else {
            (product.quotient(from_top), from_top)
        };
        Distances {
            top: [top1, top2],
            bottom: [self.over_the_bottom(bottom2, from_bottom), bottom2],
            band,
            third: [
                from_top,
                from_bottom,
                third.add_alike(two_g * to_lower),
                third - two_g * to_upper,
            ],
            to_upper,
            to_lower,
        }
    }

    /// h₁ stands alone: the roots from the integrals, and the place of the start between them.
    fn near_the_top(&self, two_g: N, start: &Place<N>) -> Distances<N> {
        let d = self.lowest_alone(two_g, self.at_the_top(two_g));
        // The greater of h₂ − h and h − h₁ is formed directly; their product with 2g (h₃ − h) is h'².
        let third = d.third[0].add_alike(two_g * start.below_top);
        let product = start.rise.square().quotient(third);
        let (up, down) = (start.below_top - d.top[1], d.top[0] - start.below_top);
        let (to_upper, to_lower) = if up.exceeds(down) {
            (up, product.quotient(up))
        } else {
            (product.quotient(down), down)
        };
        Distances {
            to_upper,
            to_lower,
            ..d
        }
    }

    /// The roots, with the start at the lower turning point; `None` if the energy is too small for any motion.
    pub(super) fn solve(&self) -> Option<Distances<N>> {
        let two_g = self.gravity.times(2.0);
        let at_the_top = self.at_the_top(two_g);
        let [quadratic, linear, constant] = at_the_top;
        // y = 2g (h − 1): y³ + a y² + b y + c, and its sign at the inflection.
        let cubic = [quadratic, -(two_g * linear), -(two_g.square() * constant)];
        let d = if at_inflection(cubic).leading() > 0.0 {
            self.lowest_alone(two_g, at_the_top)
        } else {
            self.third_alone(two_g, at_the_top, greatest_root(cubic))?
        };
        // f(±1) is not positive: both roots lie between, or both outside.
        let inside = |[a, b]: [N; 2]| (a + b).leading() >= 0.0;
        (inside(d.top) && inside(d.bottom)).then_some(d)
    }

    /// f(1 − x) = −2g x³ + (4g − e − l²) x² + 2 (e − δ l) x − δ²: the middle two coefficients, and δ².
    fn at_the_top(&self, two_g: N) -> [N; 3] {
        [
            two_g.times(2.0) - self.above_top - self.spin.square(),
            (self.above_top - self.difference * self.spin).times(2.0),
            self.difference.square(),
        ]
    }

    /// 1 + h₁, from the product of all three distances from −1.
    fn over_the_bottom(&self, bottom2: N, from_bottom: N) -> N {
        self.sum.square().quotient(bottom2 * from_bottom)
    }

    /// h₁ stands alone: 1 − h₂ and h₃ − 1 are the roots of a quadratic about 1.
    fn lowest_alone(&self, two_g: N, [quadratic, linear, constant]: [N; 3]) -> Distances<N> {
        let zero = N::from_double(0.0);
        let top1 = greatest_root([
            -quadratic.quotient(two_g),
            -linear.quotient(two_g),
            constant.quotient(two_g),
        ]);
        let product = constant.quotient(two_g * top1);
        let gap = (linear * top1 - constant).quotient(two_g * top1.square());
        let far_apart = gap.square().add_alike(product.times(4.0)).square_root();
        let far = far_apart.add_alike(gap.magnitude()).times(0.5);
        let near = product.quotient(far);
        let (top2, beyond) = if gap.leading() < 0.0 {
            (far, near)
        } else {
            (near, far)
        };
        let two = N::from_double(2.0);
        let bottom2 = two - top2;
        let from_bottom = two_g * two.add_alike(beyond);
        let band = top1 - top2;
        Distances {
            top: [top1, top2],
            bottom: [self.over_the_bottom(bottom2, from_bottom), bottom2],
            band,
            third: [
                two_g * beyond,
                from_bottom,
                two_g * top1.add_alike(beyond),
                two_g * far_apart,
            ],
            to_upper: band,
            to_lower: zero,
        }
    }

    /// h₃ stands alone, y = 2g (h₃ − 1): 1 − h₁ and 1 − h₂ are the roots of x² − s x + p; below the horizon, 1 + h₁ and 1 + h₂ are those of
    /// a quadratic of their own.
    fn third_alone(
        &self,
        two_g: N,
        [quadratic, linear, constant]: [N; 3],
        y: N,
    ) -> Option<Distances<N>> {
        let zero = N::from_double(0.0);
        let two = N::from_double(2.0);
        // f(1 − x) = −(2g x + y) (x² − s x + p); if y = 0, p follows from the linear term.
        let p = if !constant.is_zero() {
            constant.quotient(y)
        } else if y.is_zero() {
            -linear.quotient(two_g)
        } else {
            zero
        };
        // Of two expressions for s, the one that is a sum, or a difference in which one term is less than half the other: p ≤ s²/4 and s ≤ 4.
        let s = if quadratic.leading() >= 0.0 {
            quadratic.add_alike(y).quotient(two_g)
        } else {
            (linear + two_g * p).quotient(y)
        };
        let from_bottom = y.add_alike(two_g.times(2.0));
        let below_horizon = s.exceeds(two);
        let (sum, product) = if below_horizon {
            let product = self.sum.square().quotient(from_bottom);
            let slope = self.above_bottom + self.sum * self.spin - self.gravity * product;
            (slope.times(2.0).quotient(from_bottom), product)
        } else {
            (s, p)
        };
        let discriminant = sum.square() - product.times(4.0);
        if sum.leading() < 0.0 {
            return None;
        }
        // Below what rounding leaves of terms that cancel, the tilt counts as constant.
        let rounding = sum.square().times(2f64.powi(-95));
        let band = if discriminant.exceeds(rounding) {
            discriminant.square_root()
        } else if (-discriminant).exceeds(rounding) {
            return None;
        } else {
            zero
        };
        let far = sum.add_alike(band).times(0.5);
        let (top, bottom) = if below_horizon {
            let bottom1 = product.quotient(far);
            let top1 = two - bottom1;
            ([top1, p.quotient(top1)], [bottom1, far])
        } else {
            let top2 = p.quotient(far);
            let bottom2 = two - top2;
            let bottom1 = self.over_the_bottom(bottom2, from_bottom);
            ([far, top2], [bottom1, bottom2])
        };
        Some(Distances {
            top,
            bottom,
            band,
            third: [
                y,
                from_bottom,
                y.add_alike(two_g * top[0]),
                y.add_alike(two_g * top[1]),
            ],
            to_upper: band,
            to_lower: zero,
        })
    }

    /// (L_vert − L₃h)/I₁ at the lower and at the upper turning point; zero at the upper one where the terms of a cusp cancel.
    pub(super) fn drifts(&self, d: &Distances<N>) -> [N; 2] {
        let drift = |k: usize| {
            if N::from_double(1.0).exceeds(d.top[k]) {
                self.difference + self.spin * d.top[k]
            } else {
                self.sum - self.spin * d.bottom[k]
            }
        };
        // A cusp: where Ω across the axis vanishes, 1 − h = −e/2g, the drift vanishes too, 1 − h = −δ/l. Below zero that is the third root.
        let zero = N::from_double(0.0);
        let cusp = [
            self.above_top * self.spin,
            (self.gravity * self.difference).times(-2.0),
            zero,
        ];
        let reached = self.difference.leading() * self.spin.leading() <= 0.0;
        let upper = if reached && balance(cusp).is_zero() {
            zero
        } else {
            drift(1)
        };
        [drift(0), upper]
    }
}

/// The sum of three terms; zero if it is no more than what rounding leaves of terms that cancel.
///
/// In pure precession such terms cancel, and few tilts are doubles: the cosine 3/5 is not.
fn balance<N: Number>(terms: [N; 3]) -> N {
    let [a, b, c] = terms;
    let sum = a + b + c;
    let size = a
        .magnitude()
        .add_alike(b.magnitude())
        .add_alike(c.magnitude());
    if sum.magnitude().exceeds(size.times(2f64.powi(-99))) {
        sum
    } else {
        N::from_double(0.0)
    }
}

/// y³ + a y² + b y + c at its inflection.
fn at_inflection<N: Number>([a, b, c]: [N; 3]) -> N {
    (a.square() * a).times(2.0 / 27.0) - (a * b).times(1.0 / 3.0) + c
}

/// The greatest root of y³ + a y² + b y + c, if it stands alone: Newton's method from above. The others may be complex where it lies above the inflection.
pub(crate) fn greatest_root<N: Number>([a, b, c]: [N; 3]) -> N {
    // Fujiwara's bound.
    let mut y = a
        .magnitude()
        .greater(b.magnitude().square_root())
        .greater(c.magnitude().rough_cube_root())
        .times(2.0);
    if y.is_zero() {
        return y;
    }
    // Each step covers at least a third of the way; at the end each doubles the digits.
    for _ in 0..200 {
        let value = ((y + a) * y + b) * y + c;
        let slope = (y.times(3.0) + a.times(2.0)) * y + b;
        if slope.leading() <= 0.0 {
            break;
        }
        // If the root is far smaller than the first guess, rounding may carry a step too far; the next one comes back.
        let step = value.quotient(slope);
        let next = y - step;
        if !step
            .magnitude()
            .exceeds(y.times(2f64.powi(-102)).magnitude())
        {
            return next;
        }
        y = next;
    }
    y
}
