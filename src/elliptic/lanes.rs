//! Arguments reduced to the nearest multiple of K, and sn, cn and dn there, one argument a lane.
//!
//! Written once for any number of lanes, as loops without a branch. One lane is the code of a single state; eight lanes the
//! compiler vectorises, and the bits are the same. The passes are kept short, so that the processor can look far enough ahead to
//! start on the next lanes while it waits.

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

use super::jacobi::{Hyperbolic, circular_at, hyperbolic_at};
use super::modulus::Modulus;
use super::parameter::Side;
use super::theta::Theta;
use crate::error::{Result, same_length, too_long};
use crate::precise::quick::{
    self, EXACT_COUNT, ROUNDER, in_quadrant, polynomial, reduced, select, sine_cosine,
};
use crate::precise::{DoubleDouble, Number};

/// Number of states formed side by side.
pub(crate) const LANES: usize = 8;

/// From this many states on, it pays to evaluate all lanes.
const WORTHWHILE: usize = 3;

/// 2⁶² radians, the greatest angle of two words whose sine and cosine are meaningful: 106 bits leave them an error of 10⁻¹³.
const GREATEST_ANGLE: f64 = 4.6e18;

/// Keeps a bound a little below its limit.
const MARGIN: f64 = 0.99;

/// The argument u = start + rate · t of the functions of one modulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Course {
    pub(crate) modulus: Modulus,
    pub(crate) start: DoubleDouble,
    pub(crate) rate: DoubleDouble,
}

impl Course {
    /// The time, s, up to which the argument and phases of these rates, times `share`, are reduced without a branch: half of the right angles that
    /// [`sine_cosine`] takes are for the time, half for the lags. Later times are reduced in 106 bits; where a rate is near the ends of the range of doubles, all are, and the result is −1.
    pub(crate) fn reach(&self, share: f64, rates: &[DoubleDouble]) -> f64 {
        // Halves of other rates would overflow or underflow.
        let in_range = |rate: f64| rate == 0.0 || (1e-280..=1e280).contains(&rate);
        let rate = self.rate.high().abs();
        let fastest = rates
            .iter()
            .fold(0.0_f64, |most, rate| most.max(rate.high().abs()));
        if !(in_range(rate) && rates.iter().all(|rate| in_range(rate.high().abs()))) {
            return -1.0;
        }
        let quarters = (MARGIN * EXACT_COUNT - 1.0) * self.modulus.quarter_period() / rate;
        let turning = MARGIN * 0.5 * EXACT_COUNT * core::f64::consts::PI / (2.0 * share * fastest);
        (0.5 / share * quarters)
            .min(turning)
            .min(1e290 / rate.max(1.0))
    }
}

/// Rate times time.
#[inline(always)]
pub(crate) fn product(rate: DoubleDouble, t: f64) -> [f64; 2] {
    let (high, error) = quick::exact_product(rate.high(), t);
    [high, error + rate.low() * t]
}

/// Rate times time, less a lag for each of at most [`EXACT_COUNT`] quarter periods.
#[inline(always)]
pub(crate) fn phase(rate: DoubleDouble, t: f64, lag: DoubleDouble, quarters: f64) -> [f64; 2] {
    let [high, low] = product(rate, t);
    let (first, second) = quick::halves(lag.high());
    let once = DoubleDouble::difference(high, quarters * first);
    let twice = DoubleDouble::difference(once.high(), quarters * second);
    let low = (low - quarters * lag.low()) + (once.low() + twice.low());
    [twice.high(), low]
}

/// Sine and cosine of the angle rate · t less `lag`, or an error if its digits no longer determine them. Beyond [`EXACT_COUNT`] right angles by the slower
/// [`DoubleDouble::sin_cos`], which agrees.
pub(crate) fn turned(rate: DoubleDouble, t: f64, lag: DoubleDouble) -> Result<(f64, f64)> {
    let angle = rate * DoubleDouble::from(t) - lag;
    let right_angles = angle.high() * core::f64::consts::FRAC_2_PI;
    if right_angles.abs() < EXACT_COUNT {
        Ok(sine_cosine([angle.high(), angle.low()]))
    } else if angle.high().abs() <= GREATEST_ANGLE {
        Ok(angle.sin_cos())
    } else {
        // The angle itself may have overflowed.
        let mean = rate.high() - lag.high() / t;
        Err(too_long(t, GREATEST_ANGLE / mean.abs()))
    }
}

/// The reduced arguments of W lanes, and the functions there.
#[derive(Debug)]
pub(crate) struct Places<const W: usize> {
    /// u = quarters · K + rest, and the quarters in the lowest bits.
    pub(crate) quarters: [f64; W],
    pub(crate) bits: [u64; W],
    /// The rest times π/(2K), or π/(2K′) beyond m = 1/2.
    angle: [[f64; W]; 2],
    /// Sine and cosine of πu/(2K), quarters included; or sinh and cosh of the rest, scaled as in [`Hyperbolic`].
    pub(crate) sine: [f64; W],
    pub(crate) cosine: [f64; W],
    sign: [u64; W],
    pub(crate) growth: [f64; W],
    decay: [[f64; W]; 2],
    z: [f64; W],
    /// sn, cn, dn.
    pub(crate) functions: [[f64; W]; 3],
}

impl<const W: usize> Places<W> {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self {
            quarters: [0.0; W],
            bits: [0; W],
            angle: [[0.0; W]; 2],
            sine: [0.0; W],
            cosine: [0.0; W],
            sign: [0; W],
            growth: [0.0; W],
            decay: [[0.0; W]; 2],
            z: [0.0; W],
            functions: [[0.0; W]; 3],
        }
    }

    /// Reduces the argument at times within [reach](Course::reach).
    #[inline(always)]
    pub(crate) fn follow(&mut self, course: &Course, times: &[f64; W]) {
        for i in 0..W {
            let [high, low] = product(course.rate, times[i]);
            let u = DoubleDouble::sum(high, course.start.high());
            let low = u.low() + (low + course.start.low());
            self.put(i, &course.modulus, [u.high(), low]);
        }
    }

    /// Reduces the argument at any time at which it still has digits to tell the place, in the first lane.
    pub(crate) fn follow_any_time(&mut self, course: &Course, t: f64) -> Result<()> {
        let u = course.rate * DoubleDouble::from(t) + course.start;
        let greatest = course.modulus.greatest_argument();
        let countable = u.high().abs() <= greatest;
        if !countable {
            return Err(too_long(t, greatest / course.rate.high().abs()));
        }
        self.put_any(0, &course.modulus, u);
        Ok(())
    }

    /// An argument of at most [`EXACT_COUNT`] quarter periods.
    #[inline(always)]
    fn put(&mut self, i: usize, modulus: &Modulus, u: [f64; 2]) {
        let reduction = &modulus.reduction;
        let (rounded, rest) = reduced(u, reduction.inverse, reduction.parts);
        self.bits[i] = rounded.to_bits();
        self.put_rest(i, modulus, rounded - ROUNDER, rest);
    }

    /// Any argument. The error is relative to u, not to the rest, which suffices for a position.
    pub(crate) fn put_any(&mut self, i: usize, modulus: &Modulus, u: DoubleDouble) {
        if !modulus.reduction.refuses(u.high()) {
            return self.put(i, modulus, [u.high(), u.low()]);
        }
        let (quarters, rest) = modulus.reduce(u);
        self.bits[i] = quarters as i64 as u64;
        self.put_rest(i, modulus, quarters, [rest.high(), rest.low()]);
    }

    #[inline(always)]
    fn put_rest(&mut self, i: usize, modulus: &Modulus, quarters: f64, [high, low]: [f64; 2]) {
        self.quarters[i] = quarters;
        (self.angle[0][i], self.angle[1][i]) = modulus.multiplied(high, low);
    }

    /// sn, cn and dn, and what the theta functions need.
    #[inline(always)]
    pub(crate) fn evaluate(&mut self, modulus: &Modulus) {
        let series = &modulus.series;
        match modulus.side() {
            Side::Circular => {
                for i in 0..W {
                    let (sine, cosine) =
                        quick::small_sine_cosine(self.angle[0][i], self.angle[1][i]);
                    (self.sine[i], self.cosine[i]) = in_quadrant(self.bits[i], sine, cosine);
                }
                for i in 0..W {
                    let set = &series.corrections;
                    let (functions, _) = circular_at(set, self.sine[i], self.cosine[i]);
                    self.put_functions(i, functions);
                }
            }
            Side::Hyperbolic => {
                for i in 0..W {
                    let at = Hyperbolic::new(series.root, self.angle[0][i], self.angle[1][i]);
                    (self.sign[i], self.z[i]) = (at.sign, at.z);
                    (self.sine[i], self.cosine[i]) = (at.sine, at.cosine);
                    self.growth[i] = at.growth;
                    (self.decay[0][i], self.decay[1][i]) = (at.decay[0], at.decay[1]);
                }
                for i in 0..W {
                    let functions = hyperbolic_at(series, self.bits[i], &self.argument(i));
                    self.put_functions(i, functions);
                }
            }
        }
    }

    #[inline(always)]
    fn put_functions(&mut self, i: usize, functions: [f64; 3]) {
        for (row, value) in self.functions.iter_mut().zip(functions) {
            row[i] = value;
        }
    }

    /// The functions of one lane.
    #[inline(always)]
    pub(crate) fn functions(&self, i: usize) -> [f64; 3] {
        core::array::from_fn(|k| self.functions[k][i])
    }

    #[inline(always)]
    fn argument(&self, i: usize) -> Hyperbolic {
        Hyperbolic {
            sign: self.sign[i],
            sine: self.sine[i],
            cosine: self.cosine[i],
            growth: self.growth[i],
            decay: [self.decay[0][i], self.decay[1][i]],
            z: self.z[i],
        }
    }

    /// A theta function and its derivative by the angle, `shifted` by a quarter period or not, over e^x where the sum of both parities is even. On the circular side
    /// `theta` holds the polynomials of the derivative in place of those near odd multiples.
    #[inline(always)]
    pub(crate) fn theta_with_slope(
        &self,
        i: usize,
        modulus: &Modulus,
        theta: &Theta,
        shifted: bool,
    ) -> [[f64; 2]; 2] {
        let (sine, cosine, z) = (self.sine[i], self.cosine[i], self.z[i]);
        match modulus.side() {
            Side::Circular => {
                let (s, c) = if shifted {
                    (cosine, -sine)
                } else {
                    (sine, cosine)
                };
                let x = s * s;
                let ([real, imaginary], [real_slope, imaginary_slope]) = (theta.even, theta.odd);
                let value = [s * polynomial(&real, x), c * polynomial(&imaginary, x)];
                let slope = [
                    c * polynomial(&real_slope, x),
                    s * polynomial(&imaginary_slope, x),
                ];
                [value, slope]
            }
            Side::Hyperbolic => {
                let odd = ((self.bits[i] ^ u64::from(shifted)) & 1).wrapping_neg();
                let [real, imaginary] = theta.chosen(odd);
                let ([p, dp], [q, dq]) =
                    (with_derivative(&real, z), with_derivative(&imaginary, z));
                let sign = 1.0_f64.copysign(f64::from_bits(self.sign[i]));
                let root = modulus.series.root;
                let (square, grown) = (root * root, root * self.growth[i]);
                // 4√q′ sinh cosh.
                let product = grown * (grown * sine) * cosine;
                let either = |a: f64, b: f64| select(odd, a, b);
                let value = [either(1.0, cosine) * p, sign * either(product, sine) * q];
                let slope = [
                    sign * either(2.0 * product * dp, sine * (p + 2.0 * (square + z) * dp)),
                    either(
                        (square + 2.0 * z) * q + 2.0 * z * (square + z) * dq,
                        cosine * (q + 2.0 * z * dq),
                    ),
                ];
                [value, slope]
            }
        }
    }

    /// The factor that puts a theta function shifted by a quarter period on the scale of one that is not.
    #[inline(always)]
    pub(crate) fn weight_of_shifted(&self, i: usize, modulus: &Modulus) -> f64 {
        match modulus.side() {
            Side::Circular => 1.0,
            Side::Hyperbolic => {
                let root = modulus.series.root;
                let odd = (self.bits[i] & 1).wrapping_neg();
                let decay = self.decay[0][i] * self.decay[1][i];
                select(odd, root * root * self.growth[i], decay)
            }
        }
    }
}

/// A polynomial and its derivative.
#[inline(always)]
fn with_derivative(coefficients: &[f64; 4], x: f64) -> [f64; 2] {
    let [a, b, c, d] = coefficients;
    let value = ((d * x + c) * x + b) * x + a;
    [value, (d * x + (d * x + c)) * x + ((d * x + c) * x + b)]
}

/// Fills `states` with those at `times`: of a motion given with its reach, eight side by side where all times are within reach; otherwise one by one.
pub(crate) fn fill<S, B>(
    times: &[f64],
    states: &mut [S],
    moving: Option<(&B, f64)>,
    one: impl Fn(f64) -> Result<S>,
    side_by_side: impl Fn(&B, &[f64; LANES], &mut [S]),
) -> Result<()> {
    same_length(times.len(), states.len())?;
    for (times, states) in times.chunks(LANES).zip(states.chunks_mut(LANES)) {
        if let Some((body, reach)) = moving
            && times.len() >= WORTHWHILE
            && times.iter().all(|t| t.abs() <= reach)
        {
            // Lanes left over repeat the last time.
            let lanes = core::array::from_fn(|i| times[i.min(times.len() - 1)]);
            side_by_side(body, &lanes, states);
        } else {
            for (t, state) in times.iter().zip(states) {
                *state = one(*t)?;
            }
        }
    }
    Ok(())
}
