//! A prepared motion at one time: where L is, by how much the body has turned, and what repeats (tutorial 6.6, 6.8).

use nalgebra::Quaternion;

use super::preparation::Constants;
use crate::elliptic::Side;
use crate::elliptic::local::{GREATEST_ANGLE, Place, sine_cosine};
use crate::error::{Result, too_long};
use crate::precise::{DoubleDouble, RIGHT_ANGLE};

/// Where L is, along the renumbered axes.
pub(super) struct Point {
    place: Place,
    sn: f64,
    cn: f64,
    pub(super) l: [f64; 3],
}

impl Constants {
    pub(super) fn point(&self, t: f64) -> Result<Point> {
        let u = self.rate * DoubleDouble::from(t) + self.start;
        let greatest = self.modulus.greatest_argument();
        if u.high().abs() <= greatest {
            let place = self.modulus.place(u);
            let [sn, cn, dn] = self.modulus.triple(&place);
            let [p1, p2, p3] = self.amplitudes;
            let l = [p1 * cn, p2 * sn, p3 * dn];
            return Ok(Point { place, sn, cn, l });
        }
        Err(too_long(t, greatest / self.rate.high().abs()))
    }

    /// The turn by ψ about L after the shortest rotation of L onto axis 3, as a unit quaternion along the body's own axes.
    pub(super) fn turned(&self, t: f64, point: &Point) -> Result<Quaternion<f64>> {
        let turning = &self.turning;
        let quarters = DoubleDouble::from(point.place.quarters);
        let half = (self.turning_rate * DoubleDouble::from(t) - turning.lag * quarters).scaled(0.5);
        let (sine, cosine) = half_turn(half, t, self.turning_rate)?;
        let (x, y) = turning.half_angle(&point.place, point.sn, point.cn);
        let (cosine, sine) = (cosine * x - sine * y, sine * x + cosine * y);
        let [l1, l2, l3] = point.l;
        let largest = l1.abs().max(l2.abs()).max(l3);
        let [n1, n2, n3] = [l1 / largest, l2 / largest, l3 / largest];
        let w = n3 + (n1 * n1 + n2 * n2 + n3 * n3).sqrt();
        // (cos + k sin) (w + n₂ i − n₁ j).
        let [a, b, c] =
            self.axes
                .back([cosine * n2 + sine * n1, sine * n2 - cosine * n1, sine * w]);
        let q = Quaternion::new(cosine * w, a, b, c);
        Ok(q / q.norm())
    }

    pub(super) fn period(&self) -> f64 {
        let quarter = self.modulus.quarter_period_dd();
        if quarter.high() == f64::INFINITY {
            return f64::INFINITY;
        }
        let nearly = 4.0 * (quarter.high() / self.rate.high()).abs();
        if nearly.is_finite() {
            4.0 * (quarter / self.rate).value().abs()
        } else {
            nearly
        }
    }

    /// ν less the lag of each quarter period, and a right angle more for each: the azimuth of L in the body advances by that.
    pub(super) fn mean_precession_rate(&self) -> f64 {
        let quarter = self.modulus.quarter_period_dd();
        if quarter.high() == f64::INFINITY {
            return self.turning_rate.value();
        }
        let gain = RIGHT_ANGLE - self.turning.lag;
        let quarters = self.rate / quarter;
        (self.turning_rate + gain * quarters).value()
    }

    /// Solid angle of the cone that L draws in the body in one period, with the sense of du/dt.
    pub(super) fn solid_angle(&self) -> f64 {
        let [p1, p2, p3] = self.amplitudes;
        let size = p1.hypot(p3);
        let magnitude = match self.modulus.side() {
            // ∮ (1 − cos θ) dφ = P₁P₂/P₃ ∫ P₃ dn/(|L| (|L| + P₃ dn)) du, a periodic function with poles beyond ±iK′: the rule of
            // equal ordinates leaves out q¹⁶, and nothing cancels for a small cone.
            Side::Circular => {
                let quarter = self.modulus.quarter_period_dd();
                let ordinates = (0..16).map(|k| {
                    let u = quarter * DoubleDouble::from(f64::from(k) / 8.0);
                    let [_, _, dn] = self.modulus.triple(&self.modulus.place(u));
                    dn / (1.0 + p3 / size * dn)
                });
                let mean = ordinates.sum::<f64>() / 16.0;
                4.0 * quarter.value() * mean * (p1 / size) * (p2 / size)
            }
            // Near the separatrix the cone is wide: the closed form, which is Heuman's lambda function.
            Side::Hyperbolic => {
                let mc = self.modulus.parameter().mc();
                let share = mc * (p1 / p2) * (p3 / size) + self.turning.excess.value();
                let quarter = self.modulus.quarter_period();
                4.0 * (self.turning.lag.value() - quarter * share)
            }
        };
        magnitude * self.rate.high().signum()
    }
}

/// Sine and cosine of half the angle turned about L until time t at about this rate.
pub(super) fn half_turn(half: DoubleDouble, t: f64, rate: DoubleDouble) -> Result<(f64, f64)> {
    if half.high().abs() <= GREATEST_ANGLE {
        Ok(sine_cosine(half))
    } else {
        Err(too_long(t, 2.0 * GREATEST_ANGLE / rate.high().abs()))
    }
}
