//! The motions with a double root: Appelrot's classes, and their place among all motions (8.2).

use nalgebra::Complex;

use super::constants::{Constants, Root};
use crate::error::{Result, finite, not_negative, positive};
use crate::precise::{DoubleDouble, Number, power_of_two_below};

/// The kind of motion, by the position of the five roots e₁ … e₅. All but [`General`](Self::General) and [`EulerSymmetric`](Self::EulerSymmetric) are Appelrot's
/// classes of *particularly remarkable* motions: they have a double root, at which s₁ or s₂ may rest, or come to rest in infinite time, and the
/// functions of time are elliptic or elementary.
///
/// Roots count as equal if they agree to 8 eps of the terms compared, the rounding of the start.
///
/// How they are solved: Delaunay's case, upright starts and pendulums in closed form at any time. Starts in doubles with another shared root, or a double root of the cubic, mostly too, because rounding separates the two roots. Where
/// they agree to 17 digits (9, if both are the cubic's) and s₁ or s₂ reaches them, or another root is as near, the motion is followed by power series in 106 bits, and refused once it has amplified rounding 10¹⁷ times.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Kind {
    /// Five different roots: in general two incommensurable frequencies.
    General,
    /// K = 0, e₄ = e₅: Delaunay's case, Appelrot's first class. Ω and z obey (Ω₁+iΩ₂)² = c(z₁+iz₂), two conditions instead of one.
    Delaunay,
    /// e₄ = (l₁+|K|)/2 is a root of the cubic: L_vert² = 2I₃(E + I₃|K|). Of Appelrot's second and third class.
    SharedUpper,
    /// e₅ = (l₁−|K|)/2 is a root of the cubic: L_vert² = 2I₃(E − I₃|K|). Of Appelrot's second and third class.
    SharedLower,
    /// Two roots of the cubic coincide: Appelrot's fourth class.
    CubicDouble,
    /// C = O: gravity has no torque; Euler's symmetric top with I₁ = 2I₃ (6.5).
    EulerSymmetric,
}

/// The kind, decided by the constants in 106 bits.
pub(super) fn classify(constants: &Constants) -> Kind {
    const ROUNDED: f64 = 8.0 * f64::EPSILON;
    let Constants { c, l1, l, k, .. } = *constants;
    let energy = l1.times(3.0);
    let doubled = (l * l).scaled(2.0);
    let size = energy.value().abs() + doubled.value() + k.value() + 2.0 * c.value();
    let small = |x: DoubleDouble| x.value().abs() <= ROUNDED * size;
    let [first, second, third, fourth, fifth] = constants.roots();
    // Weak gravity brings roots together whatever L_vert is: the conditions below are their distances over c².
    let meets = |root: &Root| {
        let cubic = [first, second, third];
        cubic.iter().any(|e| e.from(root).norm() <= ROUNDED * size)
    };
    let spread = second.from(&third).re.hypot(2.0 * second.imaginary.value());
    // A rounded start determines the square of the distance.
    let greatest = first.real.value().abs();
    if c.high() == 0.0 {
        Kind::EulerSymmetric
    } else if small(k) {
        Kind::Delaunay
    } else if small(energy + k - doubled) || meets(&fourth) {
        Kind::SharedUpper
    } else if small(energy - k - doubled) || meets(&fifth) {
        Kind::SharedLower
    } else if spread * spread <= ROUNDED * (greatest * greatest + size * size) {
        Kind::CubicDouble
    } else {
        Kind::General
    }
}

/// The plane of energy and L_vert² for a given |K|, with the curves on which a root is double (8.2).
///
/// Per unit of I₃: c = MgC/I₃ (1/s²), k = |K| (1/s²), e = E/I₃ (1/s²) and h = (L_vert/I₃)² (1/s²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diagram {
    c: f64,
    k: f64,
}

impl Diagram {
    /// The diagram for this c > 0 and this k ≥ 0.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::Negative`](crate::Error::Negative), [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::Diagram;
    /// assert!(Diagram::new(1.0, 0.4).is_ok() && Diagram::new(0.0, 0.4).is_err());
    /// ```
    pub fn new(c: f64, k: f64) -> Result<Self> {
        positive("MgC/I3", c)?;
        not_negative("the constant |K|", k)?;
        Ok(Self { c, k })
    }

    /// h on the line [`Kind::SharedUpper`]: 2(e + k), from e′ = 2e₄ − l₁ = k, where d + e′² = c². If it is negative, no motion belongs to it.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::Diagram;
    /// let diagram = Diagram::new(1.0, 0.4)?;
    /// let [a, b, c, fourth, _] = diagram.roots(1.0, diagram.shared_upper(1.0))?;
    /// assert!([a, b, c].iter().any(|e| (e - fourth).norm() < 2e-14));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn shared_upper(&self, energy: f64) -> f64 {
        2.0 * (energy + self.k)
    }

    /// h on the line [`Kind::SharedLower`]: 2(e − k).
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::Diagram;
    /// let diagram = Diagram::new(1.0, 0.4)?;
    /// let [a, b, c, _, fifth] = diagram.roots(1.0, diagram.shared_lower(1.0))?;
    /// assert!([a, b, c].iter().any(|e| (e - fifth).norm() < 2e-14));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn shared_lower(&self, energy: f64) -> f64 {
        2.0 * (energy - self.k)
    }

    /// h on the two branches of the curve [`Kind::CubicDouble`], with the double root s = ±√(g₂/12) of 4s³ − g₂s − g₃:
    /// l²c² = −8s³ − l₁(k² − c² − l₁²); `None` where g₂ < 0.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::Diagram;
    /// let diagram = Diagram::new(1.0, 0.4)?;
    /// assert!(diagram.cubic_double(1e200).is_err(), "h is beyond the doubles");
    /// for h in diagram.cubic_double(2.0)?.into_iter().flatten().filter(|h| *h > 0.0) {
    ///     let [_, b, c, ..] = diagram.roots(2.0, h)?;
    ///     assert!((b - c).norm() < 1e-7);
    /// }
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn cubic_double(&self, energy: f64) -> Result<Option<[f64; 2]>> {
        // In a unit in which no cube leaves the range of doubles.
        let unit = power_of_two_below(finite("the energy", energy)?.abs().max(self.greatest()));
        let [c, k, l1] = [self.c / unit, self.k / unit, energy / unit / 3.0];
        let excess = (k - c) * (k + c);
        let s_squared = (excess + 3.0 * l1 * l1) / 12.0;
        if s_squared < 0.0 {
            return Ok(None);
        }
        let s = s_squared.sqrt();
        let rest = l1 * (l1 * l1 - excess);
        // h = (2l)².
        let h = |s: f64| 4.0 * (rest - 8.0 * s_squared * s) / (c * c) * unit;
        Ok(Some([finite("h", h(s))?, finite("h", h(-s))?]))
    }

    /// The five roots at a point of the diagram, 1/s².
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::Negative`](crate::Error::Negative) for h.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::Diagram;
    /// let [a, b, c, fourth, fifth] = Diagram::new(1.0, 0.4)?.roots(1.5, 0.7)?;
    /// assert!((a + b + c).norm() < 1e-15);
    /// assert!((fourth.re - 0.45).abs() < 1e-15 && (fifth.re - 0.05).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn roots(&self, energy: f64, h: f64) -> Result<[Complex<f64>; 5]> {
        let energy = finite("the energy", energy)?;
        let h = not_negative("the square of L_vert/I3", h)?;
        let unit = power_of_two_below(energy.abs().max(h).max(self.greatest()));
        let wide = |number: f64| DoubleDouble::from(number / unit);
        let l1 = wide(energy) / DoubleDouble::from(3.0);
        let l = wide(h).square_root().scaled(0.5);
        let [c, k] = [self.c, self.k].map(wide);
        let d = c * c - k * k;
        let constants = Constants {
            c,
            l1,
            l,
            k,
            d,
            upright: false,
        };
        Ok(constants.roots().map(|root| root.value() * unit))
    }

    fn greatest(&self) -> f64 {
        self.c.max(self.k)
    }
}
