//! The curve on the plane: its rings and its curvature (tutorial 6.2).

use super::{Poinsot, Sector, norm};
use crate::precise::shifted;

impl Poinsot {
    /// Least and greatest distance of the herpolhode from the foot of L on the plane, rad/s (6.2).
    ///
    /// Greatest √((L²−2EI₁)(2EI₃−L²)/(I₁I₃))/|L|, where Ω₂ = 0; least √((L²−2EI₂)(2EI₃−L²)/(I₂I₃))/|L| about the largest moment,
    /// √((2EI₂−L²)(L²−2EI₁)/(I₁I₂))/|L| about the smallest: zero on the separatrix, where the curve spirals into the foot.
    /// Few units in the last place, but for L² − 2EI₂ next to the separatrix, which is as good as 106 bits of the given numbers.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::Poinsot, frame::BodyVector};
    /// let picture = Poinsot::new([1.0, 2.0, 3.0], BodyVector::new(0.4, 0.6, 3.0))?;
    /// let [inner, outer] = picture.herpolhode_radii();
    /// assert!((inner - 0.157670).abs() < 5e-7 && (outer - 0.328927).abs() < 5e-7);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn herpolhode_radii(&self) -> [f64; 2] {
        let ([i1, i2, i3], [d1, d2, d3]) = (self.moments, self.roots);
        let length = self.length();
        let radius = |a: f64, b: f64, i: f64, j: f64| {
            self.in_units((a / length) * (b / i.sqrt()) / j.sqrt())
        };
        let inner = match self.sector {
            Sector::AroundSmallest => radius(d1, d2, i1, i2),
            _ => radius(d3, d2, i2, i3),
        };
        [inner, radius(d1, d3, i1, i3)]
    }

    /// Distance of the point of contact at the parameter `s` from the foot of L, rad/s: |L ∧ Ω|/|L|.
    ///
    /// The products in L ∧ Ω are (1/I_j − 1/I_i) L_i L_j, so nothing cancels next to an axis.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::Poinsot, frame::BodyVector};
    /// let picture = Poinsot::new([1.0, 2.0, 3.0], BodyVector::new(0.4, 0.6, 3.0))?;
    /// let [inner, outer] = picture.herpolhode_radii();
    /// assert!((picture.herpolhode_radius(0.0) / outer - 1.0).abs() < 1e-15);
    /// assert!((picture.herpolhode_radius(std::f64::consts::FRAC_PI_2) / inner - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn herpolhode_radius(&self, s: f64) -> f64 {
        let u = self.rate(s);
        // (L ∧ Ω)_k is I_k times the rate of Ω_k.
        let cross = [0, 1, 2].map(|k| u[k] * self.moments[k]);
        self.in_units(norm(cross) / self.length())
    }

    /// Curvature of the herpolhode at the parameter `s`, s/rad; positive where it bends to the left seen from the tip of L (6.2).
    ///
    /// With u = ∂Ω/∂t it is Σ_k u_k²((I_i+I_j−I_k)(L_i²+L_j²)/(I_iI_j) + I_kΩ_k²) over |L||u|³, {i, j, k} the three axes.
    /// For moments that a body has, every bracket is positive: **the herpolhode never bends the other way**. Moments with
    /// I₁ + I₂ < I₃ can give it inflections. Sums of one sign for every body, so a few units in the last place.
    /// Not a number for a permanent rotation, whose herpolhode is a point.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::Poinsot, frame::BodyVector};
    /// let turns = |i3: f64| -> spinning_bodies::Result<bool> {
    ///     let picture = Poinsot::new([1.0, 2.0, i3], BodyVector::new(0.5, 1.6, 0.02))?;
    ///     Ok((0..100).any(|k| picture.herpolhode_curvature(0.0628 * f64::from(k)) < 0.0))
    /// };
    /// assert!(!turns(3.0)?, "a lamina");
    /// assert!(turns(3.5)?, "no body");
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn herpolhode_curvature(&self, s: f64) -> f64 {
        let (i, l, u) = (self.moments, self.point(s), self.rate(s));
        let speed = norm(u);
        let bracket = |k: usize| {
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            // Differences first: I_a + I_b − I_k is exact for a lamina as well.
            let excess = i[a].min(i[b]) - (i[k] - i[a].max(i[b]));
            let square = (l[a] / i[a]) * (l[a] / i[b]) + (l[b] / i[a]) * (l[b] / i[b]);
            let share = u[k] / speed;
            share * share * (excess * square + l[k] * (l[k] / i[k]))
        };
        let sum = bracket(0) + bracket(1) + bracket(2);
        shifted(sum / self.length() / speed, -self.units.omega)
    }
}
