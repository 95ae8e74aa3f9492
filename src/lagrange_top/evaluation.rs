//! A prepared top at one time: both Cayley–Klein parameters, and from them attitude and Ω (tutorial 7.2).

use nalgebra::Quaternion;

use super::motion::State;
use super::turning::{Complex, Parameter};
use crate::elliptic::local::{GREATEST_ANGLE, Local, sine_cosine};
use crate::elliptic::{Modulus, Side};
use crate::error::{Result, too_long};
use crate::frame::{Attitude, BodyVector};
use crate::precise::{DoubleDouble, RIGHT_ANGLE, power_of_two_below};

/// Which way gravity pulls along space z; up is solved as down, upside down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Pull {
    Down,
    Up,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Constants {
    pub(super) pull: Pull,
    pub(super) modulus: Modulus,
    pub(super) start: DoubleDouble,
    pub(super) rate: DoubleDouble,
    /// α and β without their phases.
    pub(super) parameters: [Parameter; 2],
    /// Their phases, radians a second.
    pub(super) rates: [DoubleDouble; 2],
    /// Their constant factors.
    pub(super) factors: [Complex; 2],
    /// 1 − h₂, 1 + h₁ and h₂ − h₁: what 1 − h and 1 + h are made of.
    pub(super) top2: f64,
    pub(super) bottom1: f64,
    pub(super) band: f64,
}

impl Constants {
    /// By how much the arguments of α and β together grow in one period of nutation.
    ///
    /// The rates are added first: what the spin does to either, the other takes back, and that may be more than a double holds.
    pub(super) fn precession_per_nutation(&self) -> DoubleDouble {
        let quarter = self.modulus.quarter_period_dd();
        // The period itself may be beyond the doubles.
        let unit = 1.0 / power_of_two_below(self.rate.high());
        let period = quarter.scaled(2.0) / self.rate.scaled(unit);
        let [alpha, beta] = &self.parameters;
        let lag = |parameter: &Parameter| {
            let lag = match self.modulus.side() {
                Side::Circular => RIGHT_ANGLE,
                Side::Hyperbolic => parameter.lag,
            };
            lag.scaled(2.0 * parameter.sense)
        };
        let rate = (self.rates[0] + self.rates[1]).scaled(unit);
        rate * period - (lag(alpha) + lag(beta))
    }

    /// α and β at a place, with their derivatives by time.
    fn pair(&self, t: f64, u: DoubleDouble) -> Result<([f64; 3], [Complex; 4])> {
        let place = self.modulus.place(u);
        let triple = self.modulus.triple(&place);
        let root = self.modulus.root();
        let odd = (place.quarters as i64) & 1 != 0;
        let weight = match (self.modulus.side(), &place.local) {
            (Side::Hyperbolic, Local::Hyperbolic(crest)) => {
                if odd {
                    root * root * crest.wave.growth
                } else {
                    crest.wave.decay(1.0)
                }
            }
            _ => 1.0,
        };
        let pace = self.modulus.pace() * self.rate.high();
        let mut out = [Complex::new(0.0, 0.0); 4];
        for k in 0..2 {
            let parameter = &self.parameters[k];
            let quarters = place.quarters + k as f64;
            let phase = self.rates[k] * DoubleDouble::from(t)
                - parameter.lag * DoubleDouble::from(quarters * parameter.sense);
            let (sine, cosine) = turned(phase, t)?;
            let factor = self.factors[k] * Complex::new(cosine, sine);
            let [value, slope] = parameter.at(&place, k == 1, root);
            let weight = if k == 1 { weight } else { 1.0 };
            let slope = slope * pace + value * Complex::new(0.0, self.rates[k].high());
            out[k] = factor * value * weight;
            out[k + 2] = factor * slope * weight;
        }
        Ok((triple, out))
    }

    pub(super) fn at(&self, t: f64, axial_rate: f64) -> Result<State> {
        let u = self.rate * DoubleDouble::from(t) + self.start;
        let greatest = self.modulus.greatest_argument();
        let countable = u.high().abs() <= greatest;
        if !countable {
            let limit = greatest / self.rate.high().abs();
            return Err(too_long(t, limit));
        }
        let ([sn, cn, _], [alpha, beta, alpha_rate, beta_rate]) = self.pair(t, u)?;
        let size = alpha.norm_sqr() + beta.norm_sqr();
        let transverse = (alpha.conj() * beta_rate - beta * alpha_rate.conj()) * (2.0 / size);
        let scale = 1.0 / size.sqrt();
        let (a, b) = (alpha * scale, beta * scale);
        let (one_less, one_more) = (
            self.top2 + self.band * cn * cn,
            self.bottom1 + self.band * sn * sn,
        );
        let (a, b, one_less, one_more) = match self.pull {
            Pull::Down => (a, b, one_less, one_more),
            Pull::Up => (b.conj(), -a.conj(), one_more, one_less),
        };
        Ok(State {
            omega: BodyVector::new(transverse.re, transverse.im, axial_rate),
            attitude: Attitude::from_unit(Quaternion::new(a.re, b.re, b.im, a.im)),
            height: 0.5 * (one_more - one_less),
            one_less,
            one_more,
        })
    }
}

impl Constants {
    /// The constant factors of α and β from the start: their sizes from the tilt at a place between the turning points, their phases from
    /// the vertical and Ω, which never vanish together.
    pub(super) fn fit(&mut self, q: Quaternion<f64>, omega: BodyVector) -> Result<()> {
        let middle = self.modulus.quarter_period() * 0.5;
        let middle = if middle.is_finite() { middle } else { 1.0 };
        let ([sn, cn, _], [alpha, beta, ..]) = self.pair(0.0, DoubleDouble::from(middle))?;
        let above = self.bottom1 + self.band * sn * sn;
        let below = self.top2 + self.band * cn * cn;
        self.factors[0] = Complex::new(above.sqrt() / alpha.norm(), 0.0);
        self.factors[1] = Complex::new(below.sqrt() / beta.norm(), 0.0);
        let (_, [alpha, beta, alpha_rate, beta_rate]) = self.pair(0.0, self.start)?;
        let size = alpha.norm_sqr() + beta.norm_sqr();
        let i = Complex::new(0.0, 1.0);
        // z₁ + iz₂ = 2i ᾱβ and Ω₁ + iΩ₂ = 2 (ᾱβ′ − βᾱ′).
        let vertical = i * alpha.conj() * beta * (2.0 / size);
        let turning = (alpha.conj() * beta_rate - beta * alpha_rate.conj()) * (2.0 / size);
        let (a, b) = (Complex::new(q.w, q.k), Complex::new(q.i, q.j));
        let wanted_vertical = i * a.conj() * b * 2.0;
        let wanted = Complex::new(omega.x(), omega.y());
        let time = 1.0 / self.rate.high();
        // Both pairs in their own size, so that the smallest kick has a direction.
        let unit = |x: Complex, y: Complex| {
            let size = x.re.abs().max(x.im.abs()).max(y.re.abs()).max(y.im.abs());
            if size > 0.0 {
                (x / size, y / size)
            } else {
                (x, y)
            }
        };
        let (vertical, turning) = unit(vertical, turning * time);
        let (wanted_vertical, wanted) = unit(wanted_vertical, wanted * time);
        let relative = wanted_vertical * vertical.conj() + wanted * turning.conj();
        let relative = if relative.norm() > 0.0 {
            relative / relative.norm()
        } else {
            Complex::new(1.0, 0.0)
        };
        let common = alpha.conj() * a + beta.conj() * b * relative.conj();
        let common = common / common.norm();
        self.factors[0] *= common;
        self.factors[1] *= common * relative;
        Ok(())
    }
}

/// Sine and cosine of an angle at a time, if it is one that its digits tell from its neighbours.
pub(super) fn turned(angle: DoubleDouble, t: f64) -> Result<(f64, f64)> {
    if angle.high().abs() <= GREATEST_ANGLE {
        Ok(sine_cosine(angle))
    } else {
        Err(too_long(t, GREATEST_ANGLE / (angle.high() / t).abs()))
    }
}
