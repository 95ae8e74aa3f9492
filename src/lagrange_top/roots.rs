//! The cubic of the tilt and its roots, with every difference that matters formed without a subtraction (tutorial 7.2).
//!
//! h'² = f(h) for h = cos θ, f(h) = 2g (h − h₁)(h − h₂)(h − h₃), g = Mgl/I₁, and the motion stays in h₁ ≤ h ≤ h₂ ≤ 1 ≤ h₃.
//! One root stands alone, whichever is farther from h₂; Newton's method finds it from outside. The other two come from a
//! quadratic whose discriminant is a sum of squares: about the present tilt if they are h₁ and h₂, about the upright
//! position if they are h₂ and h₃. The distances from ±1 come from f(±1) = −((L_vert ∓ L₃)/I₁)².

use crate::extended::Scalar;

/// What the cubic is made of, everything divided by I₁.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cubic<N> {
    /// g = Mgl/I₁, not negative.
    pub(super) gravity: N,
    /// 1 − h and 1 + h at the start.
    pub(super) below_top: N,
    pub(super) above_bottom: N,
    /// Ω₁² + Ω₂².
    pub(super) swing: N,
    /// h' at the start.
    pub(super) rise: N,
    /// Ω₁z₁ + Ω₂z₂: (L_vert − L₃h)/I₁.
    pub(super) drift: N,
    /// L₃/I₁.
    pub(super) spin: N,
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
    /// (L_vert − L₃)/I₁ and (L_vert + L₃)/I₁.
    pub(super) difference: N,
    pub(super) sum: N,
    /// h₂ − h and h − h₁ at the start.
    pub(super) to_upper: N,
    pub(super) to_lower: N,
}

impl<N: Scalar> Cubic<N> {
    pub(super) fn solve(&self) -> Distances<N> {
        let two_g = self.gravity.times(2.0);
        // f(h + d) = 2g d³ + f₂ d² + f₁ d + f₀.
        let f0 = self.rise.square();
        let height = self.above_bottom.subtract(self.below_top).times(0.5);
        let twice_height = height.times(2.0);
        let terms = [
            self.drift.multiply(self.spin).times(2.0),
            twice_height.multiply(self.swing).negated(),
            two_g
                .multiply(self.below_top)
                .multiply(self.above_bottom)
                .negated(),
        ];
        let f1 = balance(terms);
        let f2 = two_g
            .multiply(twice_height)
            .subtract(self.swing)
            .subtract(self.spin.square());
        let [a, b, c] = [f2, two_g.multiply(f1), two_g.square().multiply(f0)];
        // Its sign at the inflection says on which side of it h₂ lies.
        let inflection = a
            .square()
            .multiply(a)
            .times(2.0 / 27.0)
            .subtract(a.multiply(b).times(1.0 / 3.0))
            .subtract(c.negated());
        if inflection.leading() > 0.0 {
            self.near_the_top(two_g)
        } else {
            self.near_the_start(two_g, [f0, f1], greatest_root([a, b, c]))
        }
    }

    fn difference(&self) -> N {
        self.drift.subtract(self.spin.multiply(self.below_top))
    }

    fn sum(&self) -> N {
        self.drift
            .subtract(self.spin.multiply(self.above_bottom).negated())
    }

    /// `third` is 2g (h₃ − h): h₁ and h₂ are the roots of d² − s d + p about the start.
    fn near_the_start(&self, two_g: N, [f0, f1]: [N; 2], third: N) -> Distances<N> {
        let zero = N::from_double(0.0);
        let p = if f0.is_zero() {
            zero
        } else {
            f0.divide(third).negated()
        };
        let s = f1.subtract(two_g.multiply(p)).divide(third);
        let band = s.square().add(p.times(-4.0)).square_root();
        // The greater of the two in size is a sum; the other is the product over it.
        let far = band.add(s.magnitude()).times(0.5);
        let near = if far.is_zero() {
            zero
        } else {
            p.negated().divide(far)
        };
        let (to_upper, to_lower) = if s.leading() < 0.0 {
            (near, far)
        } else {
            (far, near)
        };
        let (difference, sum) = (self.difference(), self.sum());
        let top1 = self.below_top.add(to_lower);
        let bottom2 = self.above_bottom.add(to_upper);
        let from_top = third.subtract(two_g.multiply(self.below_top));
        let from_bottom = third.add(two_g.multiply(self.above_bottom));
        // Of 1 − h₂ and h₃ − 1 the greater directly, the other from the product of all three distances from 1.
        let direct = self.below_top.subtract(to_upper);
        let product = if difference.is_zero() {
            zero
        } else {
            difference.square().divide(top1)
        };
        let (top2, from_top) = if third.multiply(direct).exceeds(from_top.multiply(top1)) {
            (direct, product.divide(direct))
        } else {
            (product.divide(from_top), from_top)
        };
        let bottom1 = if sum.is_zero() {
            zero
        } else {
            sum.square().divide(bottom2.multiply(from_bottom))
        };
        Distances {
            top: [top1, top2],
            bottom: [bottom1, bottom2],
            band,
            third: [
                from_top,
                from_bottom,
                third.add(two_g.multiply(to_lower)),
                third.subtract(two_g.multiply(to_upper)),
            ],
            difference,
            sum,
            to_upper,
            to_lower,
        }
    }

    /// h₁ stands alone: 1 − h₂ and h₃ − 1 are the roots of a quadratic about 1.
    fn near_the_top(&self, two_g: N) -> Distances<N> {
        let zero = N::from_double(0.0);
        let (difference, sum) = (self.difference(), self.sum());
        // Twice the energy above the upright position, over I₁.
        let energy = self.swing.subtract(two_g.multiply(self.below_top));
        // f(1 − x) = −2g x³ + (4g − e − l²) x² + 2 (e − δ l) x − δ².
        let linear = energy.subtract(difference.multiply(self.spin)).times(2.0);
        let quadratic = two_g
            .times(2.0)
            .subtract(energy)
            .subtract(self.spin.square());
        let constant = difference.square();
        let top1 = greatest_root([
            quadratic.divide(two_g).negated(),
            linear.divide(two_g).negated(),
            if constant.is_zero() {
                zero
            } else {
                constant.divide(two_g)
            },
        ]);
        let product = if constant.is_zero() {
            zero
        } else {
            constant.divide(two_g.multiply(top1))
        };
        let gap = linear
            .multiply(top1)
            .subtract(constant)
            .divide(two_g.multiply(top1.square()));
        let far_apart = gap.square().add(product.times(4.0)).square_root();
        let far = far_apart.add(gap.magnitude()).times(0.5);
        let near = if product.is_zero() {
            zero
        } else {
            product.divide(far)
        };
        let (top2, beyond) = if gap.leading() < 0.0 {
            (far, near)
        } else {
            (near, far)
        };
        let two = N::from_double(2.0);
        let bottom2 = two.subtract(top2);
        let from_bottom = two_g.multiply(two.add(beyond));
        let bottom1 = if sum.is_zero() {
            zero
        } else {
            sum.square().divide(bottom2.multiply(from_bottom))
        };
        // The greater of the two directly; their product with 2g (h₃ − h) is h'².
        let third = two_g.multiply(self.below_top.add(beyond));
        let product = if self.rise.is_zero() {
            zero
        } else {
            self.rise.square().divide(third)
        };
        let (up, down) = (self.below_top.subtract(top2), top1.subtract(self.below_top));
        let (to_upper, to_lower) = if up.exceeds(down) {
            (up, product.divide(up))
        } else {
            (product.divide(down), down)
        };
        Distances {
            top: [top1, top2],
            bottom: [bottom1, bottom2],
            band: top1.subtract(top2),
            third: [
                two_g.multiply(beyond),
                from_bottom,
                two_g.multiply(top1.add(beyond)),
                two_g.multiply(far_apart),
            ],
            difference,
            sum,
            to_upper,
            to_lower,
        }
    }
}

/// The sum of three terms; nothing, if it is no more than what rounding leaves of terms that balance.
///
/// Pure precession is such a balance, and few tilts are doubles: the cosine 3/5 is not.
fn balance<N: Scalar>(terms: [N; 3]) -> N {
    let [a, b, c] = terms;
    let sum = a.subtract(b.negated()).subtract(c.negated());
    let size = a.magnitude().add(b.magnitude()).add(c.magnitude());
    if sum.magnitude().exceeds(size.times(2f64.powi(-99))) {
        sum
    } else {
        N::from_double(0.0)
    }
}

/// The greatest root of y³ + a y² + b y + c, all of whose roots are real, if it stands alone: Newton's method from above.
fn greatest_root<N: Scalar>([a, b, c]: [N; 3]) -> N {
    // Fujiwara's bound.
    let mut y = a.magnitude();
    let root_of_b = b.magnitude().square_root();
    if root_of_b.exceeds(y) {
        y = root_of_b;
    }
    let root_of_c = c.magnitude().rough_cube_root();
    if root_of_c.exceeds(y) {
        y = root_of_c;
    }
    let mut y = y.times(2.0);
    if y.is_zero() {
        return y;
    }
    // Each step takes off at least a third of the way; at the end they double the digits.
    for _ in 0..200 {
        let value = y
            .subtract(a.negated())
            .multiply(y)
            .subtract(b.negated())
            .multiply(y)
            .subtract(c.negated());
        let slope = y
            .times(3.0)
            .subtract(a.times(-2.0))
            .multiply(y)
            .subtract(b.negated());
        if value.leading() <= 0.0 || slope.leading() <= 0.0 {
            break;
        }
        let step = value.divide(slope);
        let next = y.subtract(step);
        if !step.exceeds(y.times(2f64.powi(-102))) {
            return next;
        }
        y = next;
    }
    y
}
