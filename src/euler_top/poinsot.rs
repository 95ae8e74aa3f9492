//! Poinsot's picture of the free top (tutorial 6.2, 6.3): an ellipsoid that rolls on a plane.
//!
//! Time does not enter here: the curves on which the motion runs are given in closed form. Three differences decide between
//! them, L² − 2EI₁ ≥ 0, 2EI₃ − L² ≥ 0 and L² − 2EI₂ of either sign. None is formed by subtracting 2EI from L²:
//! the first two are sums of squares, the third is a difference of two squares in 106 bits.

use super::evaluation::handedness;
use crate::error::{Result, each, positive, refused};
use crate::frame::BodyVector;
use crate::precise::{DoubleDouble, Number, exponent_of, power_of_two_below, shifted};
use crate::search::ascending;

/// The axis that the polhode circles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sector {
    /// L² < 2EI₂: about the axis of the smallest moment.
    AroundSmallest,
    /// L² > 2EI₂: about the axis of the largest moment.
    AroundLargest,
    /// L² = 2EI₂ to the last bit: on one of the curves that cross on the middle axis, or at a crossing.
    Separatrix,
    /// All moments equal: every polhode is a point (6.4).
    Point,
}

/// The ellipsoid of inertia Θ on its invariable plane Π, with polhode and herpolhode (6.2).
///
/// The semi-axes and the curves have the unit of Ω, rad/s. The axes keep the order in which they are given; in the formulas 1, 2, 3
/// are those of the smallest, the middle and the largest moment. A result too large for a double is infinite.
///
/// Error, observed over 20 000 bodies, among them symmetric ones and ones a unit in the last place off symmetry, with tilts down to
/// 10⁻³⁰⁰ and scales 10^±150: 8·10⁻¹⁶ relative, for curves and radii.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Poinsot {
    /// Moments over a power of two: ascending, or descending where the polhode goes about the smallest, so that it always goes about the third axis.
    moments: [f64; 3],
    /// L over a power of two, along the axes in that order.
    l: [f64; 3],
    /// The numbers of these axes in the order given.
    axes: [usize; 3],
    /// Exponents of the powers of two that were divided out of Ω and of L. The powers themselves may overflow where the results do not.
    unit_of_omega: i32,
    unit_of_l: i32,
    /// The axis that the polhode circles, decided once.
    pub sector: Sector,
    /// Semi-axes √(2E/I_i) of the ellipsoid Θ: ⟨Ix, x⟩ = 2E, rad/s, in the order of the given axes (6.2).
    ///
    /// A few units in the last place, at any scale.
    pub semi_axes: [f64; 3],
    /// Distance of the plane Π: ⟨L, x⟩ = 2E from the centre, 2E/|L|, rad/s: the component of Ω along L, always (6.2).
    pub plane_distance: f64,
    /// √|L² − 2EI_k| over the unit of L, in the same order.
    roots: [f64; 3],
}

/// Thinner bodies are rods: their products of components would overflow.
const LEAST_RATIO: f64 = 1e-100;

impl Poinsot {
    /// The picture for these principal moments (kg m², in the order of the axes) and this angular momentum (J s).
    ///
    /// Moments that no body has (I₁ + I₂ < I₃) are allowed: the geometry holds for them too, and the curvature of the herpolhode
    /// then gives them away ([`Self::herpolhode_curvature`]). Cost: a few dozen operations, six roots.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::NotPositive`](crate::Error::NotPositive) for a moment (the ellipsoid of a rod is a cylinder);
    /// [`Error::Condition`](crate::Error::Condition) if the smallest moment is below 10⁻¹⁰⁰ of the largest; [`Error::ZeroVector`](crate::Error::ZeroVector) for L.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::Poinsot, frame::BodyVector};
    /// // I = (1, 2, 3), Ω = (1, 1, 1): the distance of the plane is 6/√14.
    /// let picture = Poinsot::new([1.0, 2.0, 3.0], BodyVector::new(1.0, 2.0, 3.0))?;
    /// assert!((picture.plane_distance - 1.603567451474546308).abs() < 4e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(moments: [f64; 3], l: BodyVector) -> Result<Self> {
        each(positive, "a principal moment", moments)?;
        l.direction("the angular momentum")?;
        let (given, size) = (l.components(), l.components().amax());
        let axes = ascending([0, 1, 2], &moments);
        let [least, _, greatest] = axes.map(|k| moments[k]);
        if least / greatest < LEAST_RATIO {
            let condition = "the smallest moment must be at least 1e-100 of the largest";
            return refused(condition, least);
        }
        let (unit_of_moments, unit) = (power_of_two_below(greatest), power_of_two_below(size));
        let mut picture = Self {
            moments: axes.map(|k| moments[k] / unit_of_moments),
            l: axes.map(|k| given[k] / unit),
            axes,
            unit_of_omega: exponent_of(unit) - exponent_of(unit_of_moments),
            unit_of_l: exponent_of(unit),
            sector: Sector::Point,
            semi_axes: [0.0; 3],
            plane_distance: 0.0,
            roots: [0.0; 3],
        };
        picture.decide();
        let root = norm([0, 1, 2].map(|k| picture.l[k] / picture.moments[k].sqrt()));
        let semi_axes = picture.moments.map(|i| root / i.sqrt());
        picture.semi_axes = picture.unsorted(semi_axes, picture.unit_of_omega);
        picture.plane_distance = picture.in_units(root * (root / norm(picture.l)));
        Ok(picture)
    }

    /// Computes the three differences, the sector, and the order of axes that goes with it.
    fn decide(&mut self) {
        let ([i1, i2, i3], [l1, l2, l3]) = (self.moments, self.l);
        let weight = |more: f64, less: f64, over: f64| ((more - less) / over).sqrt();
        let about_smallest = (l2 * weight(i2, i1, i2)).hypot(l3 * weight(i3, i1, i3));
        let about_largest = (l1 * weight(i3, i1, i1)).hypot(l2 * weight(i3, i2, i2));
        // Squares far below one would vanish: the unit is that of the greater term's root.
        let unit = power_of_two_below(
            (l1 * weight(i2, i1, i1))
                .abs()
                .max((l3 * weight(i3, i2, i3)).abs()),
        );
        let term = |l: f64, more: f64, less: f64, over: f64| {
            let l = if more > less { l / unit } else { 0.0 };
            DoubleDouble::product(l, l) * DoubleDouble::difference(more, less)
                / DoubleDouble::from(over)
        };
        let middle = (term(l3, i3, i2, i3) - term(l1, i2, i1, i1)).value();
        self.roots = [about_smallest, unit * middle.abs().sqrt(), about_largest];
        self.sector = if i1 == i3 {
            Sector::Point
        } else if middle > 0.0 {
            Sector::AroundLargest
        } else if middle < 0.0 || i2 == i3 {
            // With I₂ = I₃ the equator is the widest of the circles about x₁, not a separatrix.
            self.moments.swap(0, 2);
            self.l.swap(0, 2);
            self.axes.swap(0, 2);
            self.roots.swap(0, 2);
            Sector::AroundSmallest
        } else {
            Sector::Separatrix
        };
    }

    /// A point of the polhode, Ω in body axes, at the parameter `s` in radians (6.3).
    ///
    /// One turn of `s` runs through the closed curve, and `s` grows with time: it is the amplitude of the elliptic functions of
    /// 6.6, zero where Ω₂ = 0. About the largest moment L₁ = A cos s, L₂ = B sin s and
    /// L₃² = I₃((L² − 2EI₁)cos²s/(I₃−I₁) + (L² − 2EI₂)sin²s/(I₃−I₂)), with A² = I₁(2EI₃ − L²)/(I₃−I₁) and B² = I₂(2EI₃ − L²)/(I₃−I₂);
    /// about the smallest with 1 and 3 exchanged. Only sums are formed, so the error is a few units in the last place for the thinnest and the
    /// widest polhode. On the separatrix the curve is the rim of the sector that the motion bounds: two arcs that meet on the middle axis.
    /// For three equal moments every `s` gives Ω.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::{Poinsot, Sector}, frame::BodyVector};
    /// let picture = Poinsot::new([1.0, 2.0, 3.0], BodyVector::new(0.4, 0.6, 3.0))?;
    /// assert_eq!(picture.sector, Sector::AroundLargest);
    /// let omega = picture.polhode(1.0);
    /// let (e2, l2) = (omega.x().powi(2) + 2.0 * omega.y().powi(2) + 3.0 * omega.z().powi(2),
    ///     omega.x().powi(2) + 4.0 * omega.y().powi(2) + 9.0 * omega.z().powi(2));
    /// assert!((e2 - 3.34).abs() < 2e-15 && (l2 - 9.52).abs() < 4e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn polhode(&self, s: f64) -> BodyVector {
        let l = self.point(s);
        let omega = [0, 1, 2].map(|k| l[k] / self.moments[k]);
        BodyVector::from_components(self.unsorted(omega, self.unit_of_omega).into())
    }

    /// The same point of the polhode as L in body axes, J s, where the sphere of radius |L| cuts the ellipsoid Σ L_i²/(2EI_i) = 1 (6.3).
    ///
    /// ```
    /// use spinning_bodies::{euler_top::Poinsot, frame::BodyVector};
    /// let picture = Poinsot::new([1.0, 2.0, 3.0], BodyVector::new(0.4, 0.6, 3.0))?;
    /// let l = picture.polhode_of_l(4.0);
    /// assert!((l.norm() / 9.52f64.sqrt() - 1.0).abs() < 5e-16, "on the sphere");
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn polhode_of_l(&self, s: f64) -> BodyVector {
        BodyVector::from_components(self.unsorted(self.point(s), self.unit_of_l).into())
    }

    /// The parameter of the given L on its own polhode, radians in −π…π; [`Self::polhode`] is its inverse.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::Poinsot, frame::BodyVector};
    /// let picture = Poinsot::new([3.0, 1.0, 2.0], BodyVector::new(3.0, 0.4, 0.6))?;
    /// let omega = picture.polhode(picture.start());
    /// assert!((omega - BodyVector::new(1.0, 0.4, 0.3)).norm() < 4e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn start(&self) -> f64 {
        if self.sector == Sector::Point {
            return 0.0;
        }
        let ([i1, i2, i3], [l1, l2, _]) = (self.moments, self.l);
        // Half widths along the middle and along the first axis: they may underflow, their quotient does not.
        let width = |i: f64| (i / (i3 - i).abs()).sqrt();
        l2.atan2(l1 * (width(i2) / width(i1))) * self.sense()
    }

    /// ds/dt at the parameter `s`, rad/s: √((I₃−I₁)(I₃−I₂)/(I₁I₂))·|Ω₃|, about the smallest moment with 1 and 3 exchanged (6.6).
    ///
    /// The pace of the motion, which the picture alone does not show. Near the separatrix it drops almost to zero twice a turn:
    /// there the top lingers next to the middle axis. Zero for three equal moments.
    ///
    /// ```
    /// use spinning_bodies::{euler_top::Poinsot, frame::BodyVector};
    /// let nearly = Poinsot::new([1.0, 2.0, 3.0], BodyVector::new(1e-3, 2.0, 3e-3))?;
    /// let (quick, slow) = (nearly.pace(0.0), nearly.pace(std::f64::consts::FRAC_PI_2));
    /// assert!(slow < 2e-3 * quick);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn pace(&self, s: f64) -> f64 {
        let [i1, i2, i3] = self.moments;
        let share = |i: f64| ((i3 - i).abs() / i).sqrt();
        self.in_units(share(i1) * share(i2) * (self.point(s)[2] / i3).abs())
    }

    /// A rate converted to rad/s.
    fn in_units(&self, rate: f64) -> f64 {
        shifted(rate, self.unit_of_omega)
    }

    /// Components in the order of the given axes, multiplied by 2^`exponent`.
    fn unsorted(&self, sorted: [f64; 3], exponent: i32) -> [f64; 3] {
        let mut given = [0.0; 3];
        for (value, axis) in sorted.into_iter().zip(self.axes) {
            given[axis] = shifted(value, exponent);
        }
        given
    }

    /// +1 if the parameter in the formulas grows with time, −1 if it falls: dL₂/dt = (I₃−I₁)/(I₃I₁)·L₃L₁ along right-handed axes.
    fn sense(&self) -> f64 {
        let [i1, _, i3] = self.moments;
        1.0_f64.copysign(handedness(self.axes) * (i3 - i1) * self.l[2])
    }

    /// L over its unit at the parameter `s`.
    fn point(&self, s: f64) -> [f64; 3] {
        if self.sector == Sector::Point {
            return self.l;
        }
        let ([i1, i2, i3], [d1, d2, d3]) = (self.moments, self.roots);
        let part = |root: f64, i: f64, other: f64| root * (i / (i - other).abs()).sqrt();
        let (sin, cos) = (self.sense() * s).sin_cos();
        let third = (part(d1, i3, i1) * cos).hypot(part(d2, i3, i2) * sin);
        [
            part(d3, i1, i3) * cos,
            part(d3, i2, i3) * sin,
            third.copysign(self.l[2]),
        ]
    }

    /// ∂Ω/∂t over its unit: ((I_j − I_k)/(I_iI_jI_k)) L_jL_k, up to the handedness.
    fn rate(&self, s: f64) -> [f64; 3] {
        let (i, l) = (self.moments, self.point(s));
        [0, 1, 2].map(|k| {
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            (i[a] - i[b]) / i[k] * (l[a] / i[a]) * (l[b] / i[b])
        })
    }
}

fn norm(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

impl Poinsot {
    /// Least and greatest distance of the herpolhode from the foot of L on the plane, rad/s (6.2).
    ///
    /// Greatest √((L²−2EI₁)(2EI₃−L²)/(I₁I₃))/|L|, where Ω₂ = 0; least √((L²−2EI₂)(2EI₃−L²)/(I₂I₃))/|L| about the largest moment,
    /// √((2EI₂−L²)(L²−2EI₁)/(I₁I₂))/|L| about the smallest: zero on the separatrix, where the curve spirals into the foot.
    /// Error: a few units in the last place; next to the separatrix L² − 2EI₂ is as accurate as 106 bits of the given numbers allow.
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
        let length = norm(self.l);
        let radius = |a: f64, b: f64, i: f64, j: f64| {
            self.in_units((a / length) * (b / i.sqrt()) / j.sqrt())
        };
        [radius(d3, d2, i2, i3), radius(d1, d3, i1, i3)]
    }

    /// Curvature of the herpolhode at the parameter `s`, s/rad; positive where it bends to the left seen from the tip of L (6.2).
    ///
    /// With u = ∂Ω/∂t it is Σ_k u_k²((I_i+I_j−I_k)(L_i²+L_j²)/(I_iI_j) + I_kΩ_k²) over |L||u|³, {i, j, k} the three axes.
    /// For moments that a body has, every bracket is positive: **the herpolhode never bends the other way**. Moments with
    /// I₁ + I₂ < I₃ can give it inflections. For every body the sums have terms of one sign, so the error is a few units in the last place.
    /// NaN for a permanent rotation, whose herpolhode is a point.
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
        shifted(sum / norm(self.l) / speed, -self.unit_of_omega)
    }
}
