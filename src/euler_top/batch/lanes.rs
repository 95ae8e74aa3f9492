//! Motions side by side: each function goes over a row of lanes without a branch, so that the compiler may take several at a time.
//!
//! A lane is a time or a body. What is the same for all of them is one number, what is not is a row of numbers; the
//! code is the same, and so are the values.

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

use super::constants::{Amplitudes, Circular, Constant, Hyperbolic, Phases, Steady, all, four};
use super::rate::Time;
use crate::elliptic::lanes::{self, Choice, Crests};
use crate::precise::DoubleDouble;

/// What comes out, a row for each component: L and Ω along the renumbered axes, and the attitude.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rows<const W: usize> {
    pub(super) l: [[f64; W]; 3],
    pub(super) omega: [[f64; W]; 3],
    pub(super) attitude: [[f64; W]; 4],
}

impl<const W: usize> Rows<W> {
    pub(super) fn zero() -> Self {
        Self {
            l: [[0.0; W]; 3],
            omega: [[0.0; W]; 3],
            attitude: [[0.0; W]; 4],
        }
    }
}

/// The numbers of one lane.
#[inline(always)]
pub(super) fn row<const N: usize, const W: usize>(rows: &[[f64; W]; N], i: usize) -> [f64; N] {
    core::array::from_fn(|k| rows[k][i])
}

/// What one pass hands to the next. Short passes over all lanes, rather than one long pass: of a long one the processor sees too
/// little ahead to work on the next lanes while it waits.
#[derive(Debug)]
pub(super) struct Work<const W: usize> {
    /// Quarter periods, in the lowest bits.
    bits: [u64; W],
    quarters: [f64; W],
    /// π/(2K) or π/(2K′) times what is left of u.
    angle: [[f64; W]; 2],
    half: [[f64; W]; 2],
    /// Sine and cosine of the angle or of half of ψ.
    sine: [f64; W],
    cosine: [f64; W],
    /// sn, cn, dn.
    functions: [[f64; W]; 3],
    /// Real and imaginary part of Z.
    z: [[f64; W]; 2],
    crests: Crests<W>,
}

impl<const W: usize> Work<W> {
    pub(super) fn new() -> Self {
        Self {
            bits: [0; W],
            quarters: [0.0; W],
            angle: [[0.0; W]; 2],
            half: [[0.0; W]; 2],
            sine: [0.0; W],
            cosine: [0.0; W],
            functions: [[0.0; W]; 3],
            z: [[0.0; W]; 2],
            crests: Crests::new(),
        }
    }
}

impl<C: Constant> Phases<C> {
    /// What is left of u after the nearest multiple of K, and half of νt − quarters · lag.
    #[inline(always)]
    fn run<const W: usize>(&self, times: &[f64; W], work: &mut Work<W>) {
        for i in 0..W {
            let [start, start_low] = all(&self.start, i);
            let [high, low] = self.rate.times(i, Time::new(times[i]));
            let u = DoubleDouble::sum(high, start);
            let rest = lanes::reduced(
                [u.high(), u.low() + (low + start_low)],
                self.inverse.lane(i),
                all(&self.parts, i),
            );
            let [high, low] = lanes::scaled(&rest, all(&self.pace, i));
            work.angle[0][i] = high;
            work.angle[1][i] = low;
            work.bits[i] = rest.bits;
            work.quarters[i] = rest.count;
        }
        for i in 0..W {
            let count = work.quarters[i];
            let [high, low] = self.half_turning.times(i, Time::new(times[i]));
            let [first, second, third] = all(&self.half_lag, i);
            let once = DoubleDouble::difference(high, count * first);
            let twice = DoubleDouble::difference(once.high(), count * second);
            work.half[0][i] = twice.high();
            work.half[1][i] = (low - count * third) + (once.low() + twice.low());
        }
    }
}

impl<C: Constant> Amplitudes<C> {
    /// L, Ω and the attitude from sn, cn, dn, Z and the half angle that is left.
    #[inline(always)]
    fn run<const W: usize>(&self, work: &mut Work<W>, rows: &mut Rows<W>) {
        for i in 0..W {
            let (sine, cosine) = lanes::sine_cosine([work.half[0][i], work.half[1][i]]);
            (work.sine[i], work.cosine[i]) = (sine, cosine);
        }
        for i in 0..W {
            let [sn, cn, _] = row(&work.functions, i);
            let [real, imaginary] = row(&work.z, i);
            // Z over P₁ cn + i P₂ sn, the quarter periods taken off both: an angle of at most a right one, and half of it.
            let across = self.aspect.lane(i) * cn;
            let (aside, along) = lanes::turned(
                work.bits[i],
                imaginary * across - real * sn,
                real * across + imaginary * sn,
            );
            let x = (along * along + aside * aside).sqrt() + along;
            let (sine, cosine) = (work.sine[i], work.cosine[i]);
            work.cosine[i] = cosine * x - sine * aside;
            work.sine[i] = sine * x + cosine * aside;
        }
        for i in 0..W {
            let [sn, cn, dn] = row(&work.functions, i);
            let (sine, cosine) = (work.sine[i], work.cosine[i]);
            let [d1, d2, d3] = all(&self.direction, i);
            let (n1, n2, w) = (d1 * cn, d2 * sn, 1.0 + d3 * dn);
            // (cos + k sin) (w + n₂ i − n₁ j), and its length.
            let size = (cosine * cosine + sine * sine) * (w * w + (n1 * n1 + n2 * n2));
            let scale = 1.0 / size.sqrt();
            let (cosine, sine) = (cosine * scale, sine * scale);
            let q = [
                cosine * w,
                cosine * n2 + sine * n1,
                sine * n2 - cosine * n1,
                sine * w,
            ];
            for k in 0..4 {
                rows.attitude[k][i] = q[k];
            }
        }
        for i in 0..W {
            let q = row(&rows.attitude, i);
            for k in 0..4 {
                let base = all(&self.base[k], i);
                rows.attitude[k][i] =
                    (base[0] * q[0] + base[1] * q[1]) + (base[2] * q[2] + base[3] * q[3]);
            }
        }
        for i in 0..W {
            let [sn, cn, dn] = row(&work.functions, i);
            let functions = [cn, sn, dn];
            for k in 0..3 {
                rows.l[k][i] = self.l[k].lane(i) * functions[k];
                rows.omega[k][i] = self.omega[k].lane(i) * functions[k];
            }
        }
    }
}

/// A kind of motion that goes over a row of times.
pub(super) trait Motion {
    fn at<const W: usize>(&self, times: &[f64; W], work: &mut Work<W>, rows: &mut Rows<W>);
}

impl<C: Constant> Steady<C> {
    /// The attitudes alone.
    #[inline(always)]
    pub(super) fn turn<const W: usize>(&self, times: &[f64; W], attitude: &mut [[f64; W]; 4]) {
        for i in 0..W {
            let half = self.half_rate.times(i, Time::new(times[i]));
            let (sine, cosine) = lanes::sine_cosine(half);
            for k in 0..4 {
                attitude[k][i] = cosine * self.unturned[k].lane(i) + sine * self.turned[k].lane(i);
            }
        }
    }
}

impl<C: Constant> Motion for Steady<C> {
    #[inline(never)]
    fn at<const W: usize>(&self, times: &[f64; W], _: &mut Work<W>, rows: &mut Rows<W>) {
        self.turn(times, &mut rows.attitude);
        for i in 0..W {
            for k in 0..3 {
                rows.l[k][i] = self.l[k].lane(i);
                rows.omega[k][i] = self.omega[k].lane(i);
            }
        }
    }
}

impl<C: Constant> Motion for Circular<C> {
    #[inline(never)]
    fn at<const W: usize>(&self, times: &[f64; W], work: &mut Work<W>, rows: &mut Rows<W>) {
        self.phases.run(times, work);
        for i in 0..W {
            let (sine, cosine) = lanes::place(work.bits[i], row(&work.angle, i));
            (work.sine[i], work.cosine[i]) = (sine, cosine);
        }
        for i in 0..W {
            let (sine, cosine) = (work.sine[i], work.cosine[i]);
            let [sn, cn, dn] = lanes::circular(four(&self.corrections, i), sine, cosine);
            work.functions[0][i] = sn;
            work.functions[1][i] = cn;
            work.functions[2][i] = dn;
        }
        for i in 0..W {
            let (sine, cosine) = (work.sine[i], work.cosine[i]);
            let s2 = sine * sine;
            let [a, b, c, d] = all(&self.real, i);
            work.z[0][i] = a + s2 * (b + s2 * (c + s2 * d));
            let [a, b, c] = all(&self.imaginary, i);
            work.z[1][i] = sine * cosine * (a + s2 * (b + s2 * c));
        }
        self.amplitudes.run(work, rows);
    }
}

impl<C: Constant> Motion for Hyperbolic<C> {
    #[inline(never)]
    fn at<const W: usize>(&self, times: &[f64; W], work: &mut Work<W>, rows: &mut Rows<W>) {
        self.phases.run(times, work);
        for i in 0..W {
            let root = self.roots[0].lane(i);
            work.crests.set(i, root, row(&work.angle, i));
        }
        for i in 0..W {
            let [sn, cn, dn] = lanes::hyperbolic(
                self.corrections.lane(i),
                self.roots[1].lane(i),
                work.bits[i],
                &work.crests.get(i),
            );
            work.functions[0][i] = sn;
            work.functions[1][i] = cn;
            work.functions[2][i] = dn;
        }
        for i in 0..W {
            let root = self.roots[0].lane(i);
            let crest = work.crests.get(i);
            let [real, imaginary] = crest_theta(&crest, root, self.theta.lane(i), work.bits[i]);
            work.z[0][i] = real;
            work.z[1][i] = imaginary;
        }
        self.amplitudes.run(work, rows);
    }
}

/// Z there, over e^x next to even multiples of K: [`DualTheta::at`](crate::elliptic::theta::DualTheta::at) without a branch.
#[inline(always)]
fn crest_theta(
    crest: &crate::elliptic::local::Crest,
    root: f64,
    [real, imaginary]: [Choice; 2],
    bits: u64,
) -> [f64; 2] {
    let mask = lanes::odd_mask(bits);
    let [a, b, c, d] = real.of(mask);
    let [e, f, g, h] = imaginary.of(mask);
    let (sine, cosine, z) = (crest.wave.sine, crest.wave.cosine, crest.z);
    // 4√q′ sinh cosh.
    let root = root * crest.wave.growth;
    let product = root * (root * sine) * cosine;
    let aside = lanes::either(mask, product, sine) * (e + z * (f + z * (g + z * h)));
    [
        lanes::either(mask, 1.0, cosine) * (a + z * (b + z * (c + z * d))),
        f64::from_bits(aside.to_bits() ^ crest.sign),
    ]
}
