//! The constants of the motion, and the five roots that follow from them (8.2).

use crate::lagrange_top::greatest_root;
use crate::precise::{DoubleDouble, Number};

type Wide = DoubleDouble;

/// A complex number of two doubles.
pub(super) type Complex = nalgebra::Complex<f64>;

pub(super) const I: Complex = Complex::new(0.0, 1.0);

/// Angular velocity and vertical, (p, q, r, z₁, z₂, z₃), in units where I = (2, 2, 1) and C = (C₁, 0, 0).
pub(super) type Phase = [f64; 6];

/// The same in 106 bits.
pub(super) type WidePhase = [Wide; 6];

/// The constants of a motion in 106 bits: rounding them to doubles would move two close roots.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Constants {
    /// c = MgC₁/I₃.
    pub c: Wide,
    /// l₁ = E/3: 6l₁ = 2(p² + q²) + r² + 2cz₁.
    pub l1: Wide,
    /// l = L_vert/2: 2l = 2(pz₁ + qz₂) + rz₃.
    pub l: Wide,
    /// k = |(p + iq)² − c(z₁ + iz₂)|.
    pub k: Wide,
    /// d = c² − k².
    pub d: Wide,
    /// Whether z was exactly along axis 3 at the start: then 3l₁ − k = 2l² identically, and e₅ is a root of the cubic.
    pub upright: bool,
}

impl Constants {
    /// The constants of a start with |z| = 1.
    pub fn of(c: Wide, &[p, q, r, z1, z2, z3]: &WidePhase) -> Self {
        let square = |x: Wide| x * x;
        let twice_energy = (square(p) + square(q)).scaled(2.0) + square(r) + (z1 * c).scaled(2.0);
        let vertical = (p * z1 + q * z2).scaled(2.0) + r * z3;
        let real = square(p) - square(q) - z1 * c;
        let imaginary = (p * q).scaled(2.0) - z2 * c;
        let k_squared = square(real) + square(imaginary);
        Self {
            c,
            l1: twice_energy / Wide::from(6.0),
            l: vertical.scaled(0.5),
            k: k_squared.square_root(),
            d: square(c) - k_squared,
            upright: [z1, z2].map(Wide::high) == [0.0; 2],
        }
    }

    /// b = −2lc, the middle coefficient of R(x) = −x⁴ + 6l₁x² + 2bx + d.
    pub fn b(&self) -> Wide {
        (self.l * self.c).scaled(-2.0)
    }

    /// s = l² − l₁, where P(s) = −N²: Z, the point of the curve that the vertical belongs to.
    pub fn vertical_point(&self) -> Wide {
        self.l * self.l - self.l1
    }

    /// N = l(m²−k²)/2 with m = 3l₁ − 2l².
    pub fn residue(&self) -> Wide {
        let m = self.l1 - self.vertical_point().scaled(2.0);
        (self.l * (m - self.k) * (m + self.k)).scaled(0.5)
    }

    /// Coefficients g₂, g₃ of Kovalevskaya's cubic 4s³ − g₂s − g₃.
    fn invariants(&self) -> [Wide; 2] {
        let square = self.l1 * self.l1;
        let g2 = square.times(3.0) - self.d;
        let lc = self.l * self.c;
        let g3 = lc * lc - self.l1 * (self.d + square);
        [g2, g3]
    }

    /// e₁, e₂, e₃, the roots of 4s³ − g₂s − g₃ with e₁ the greatest in magnitude, and e₄, e₅ = (l₁ ± k)/2.
    ///
    /// The sum of the three is zero, so the greatest in magnitude keeps its distance from the others. It is found by Newton's
    /// method from outside, and the others from s² + e₁s + e₁² − g₂/4: their distance √(g₂ − 3e₁²) is never a difference
    /// of rounded roots.
    pub fn roots(&self) -> [Root; 5] {
        if self.upright {
            return self.beside(self.fifth());
        }
        let [quarter, rest] = self.invariants().map(|g| g.scaled(0.25));
        let first = greatest_root([Wide::from(0.0), -quarter, -rest.magnitude()]);
        self.beside(first.signed(rest.high()))
    }

    /// All five roots, from one root of the cubic.
    fn beside(&self, first: Wide) -> [Root; 5] {
        let [g2, _] = self.invariants();
        let spread = g2 - (first * first).times(3.0);
        let middle = first.scaled(-0.5);
        let half = spread.magnitude().square_root().scaled(0.5);
        let [second, third] = if spread.high() < 0.0 {
            [half, -half].map(|imaginary| Root {
                real: middle,
                imaginary,
            })
        } else {
            [middle + half, middle - half].map(Root::on_axis)
        };
        let fourth = (self.l1 + self.k).scaled(0.5);
        let mut roots = [
            Root::on_axis(first),
            second,
            third,
            Root::on_axis(fourth),
            Root::on_axis(self.fifth()),
        ];
        let cubic = &mut roots[..3];
        if second.is_real() {
            cubic.sort_by(|x, y| y.real.high().total_cmp(&x.real.high()));
            // The root of greatest magnitude has the opposite sign.
            let shift = usize::from(cubic[1].real.high() > 0.0);
            cubic.rotate_right(shift);
        }
        roots
    }

    /// e₅.
    fn fifth(&self) -> Wide {
        (self.l1 - self.k).scaled(0.5)
    }
}

/// A root of P(s) = −4(s−e₁)(s−e₂)(s−e₃)(s−e₄)(s−e₅).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Root {
    pub real: Wide,
    pub imaginary: Wide,
}

impl Root {
    pub fn on_axis(real: Wide) -> Self {
        Self {
            real,
            imaginary: Wide::from(0.0),
        }
    }

    pub fn is_real(&self) -> bool {
        self.imaginary.high() == 0.0
    }

    /// `self` − `other`, rounded once.
    pub fn from(&self, other: &Self) -> Complex {
        let [re, im] = [self.real - other.real, self.imaginary - other.imaginary];
        Complex::new(re.value(), im.value())
    }

    pub fn value(&self) -> Complex {
        Complex::new(self.real.value(), self.imaginary.value())
    }
}
