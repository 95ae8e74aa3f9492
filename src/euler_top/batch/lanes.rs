//! Motions side by side: each function goes over a row of lanes without a branch, so that the compiler may take several at a time.
//!
//! A lane is a time or a body. What is the same for all of them is one number, what is not is a row of numbers; the
//! code is the same, and so are the values.

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

use crate::double_double::DoubleDouble;
use crate::elliptic::lanes::{self, Choice, Crests, difference_of_bits};

/// A constant of the motion in a loop over lanes: one number for all, or one a lane.
pub(super) trait Constant: Copy {
    fn lane(&self, i: usize) -> f64;
}

impl Constant for f64 {
    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }
}

impl<const W: usize> Constant for [f64; W] {
    #[inline(always)]
    fn lane(&self, i: usize) -> f64 {
        self[i]
    }
}

#[inline(always)]
fn all<C: Constant, const N: usize>(constants: &[C; N], i: usize) -> [f64; N] {
    core::array::from_fn(|k| constants[k].lane(i))
}

#[inline(always)]
fn four<C: Constant>(constants: &[[C; 4]; 4], i: usize) -> [[f64; 4]; 4] {
    [
        all(&constants[0], i),
        all(&constants[1], i),
        all(&constants[2], i),
        all(&constants[3], i),
    ]
}

/// Row k holds the k-th number of every lane.
fn rows<const N: usize, const W: usize>(each: [&[f64; N]; W]) -> [[f64; W]; N] {
    core::array::from_fn(|k| core::array::from_fn(|i| each[i][k]))
}

fn tables<const N: usize, const W: usize>(each: [&[[f64; 4]; N]; W]) -> [[[f64; W]; 4]; N] {
    core::array::from_fn(|j| rows(each.map(|x| &x[j])))
}

/// A rate of two words that times are multiplied with: the first also in halves, whose products are exact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rate<C> {
    pub(super) high: C,
    pub(super) upper: C,
    pub(super) lower: C,
    pub(super) low: C,
}

/// A time and its halves.
#[derive(Clone, Copy)]
struct Time {
    t: f64,
    upper: f64,
    lower: f64,
}

impl Time {
    #[inline(always)]
    fn new(t: f64) -> Self {
        let [upper, lower] = halves(t);
        Self { t, upper, lower }
    }
}

/// Upper 26 bits and the rest (Veltkamp).
#[inline(always)]
pub(super) fn halves(x: f64) -> [f64; 2] {
    let y = 134_217_729.0 * x;
    let upper = y - (y - x);
    [upper, x - upper]
}

impl Rate<f64> {
    pub(super) fn new(rate: DoubleDouble) -> Self {
        let [upper, lower] = halves(rate.high());
        Self {
            high: rate.high(),
            upper,
            lower,
            low: rate.low(),
        }
    }
}

impl<const W: usize> Rate<[f64; W]> {
    fn zero() -> Self {
        Self {
            high: [0.0; W],
            upper: [0.0; W],
            lower: [0.0; W],
            low: [0.0; W],
        }
    }

    fn gather(each: [&Rate<f64>; W]) -> Self {
        Self {
            high: each.map(|x| x.high),
            upper: each.map(|x| x.upper),
            lower: each.map(|x| x.lower),
            low: each.map(|x| x.low),
        }
    }
}

impl<C: Constant> Rate<C> {
    /// Rate times time in two words (Dekker).
    #[inline(always)]
    fn times(&self, i: usize, Time { t, upper, lower }: Time) -> [f64; 2] {
        let (high, low) = (self.high.lane(i), self.low.lane(i));
        let product = high * t;
        let error = if cfg!(target_feature = "fma") {
            high.mul_add(t, -product)
        } else {
            let (a, b) = (self.upper.lane(i), self.lower.lane(i));
            ((a * upper - product) + (a * lower + b * upper)) + b * lower
        };
        [product, error + low * t]
    }
}

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

/// Ω stays: half the angle turned, and the attitudes at no turn and at a half turn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steady<C> {
    pub(super) half_rate: Rate<C>,
    pub(super) unturned: [C; 4],
    pub(super) turned: [C; 4],
    pub(super) l: [C; 3],
    pub(super) omega: [C; 3],
}

/// The phases: u, reduced by quarter periods, and half of what ψ is made of besides theta functions.
#[derive(Debug, Clone, Copy)]
pub(super) struct Phases<C> {
    pub(super) rate: Rate<C>,
    pub(super) start: [C; 2],
    pub(super) inverse: C,
    pub(super) parts: [C; 3],
    pub(super) pace: [C; 2],
    pub(super) half_turning: Rate<C>,
    /// Half the lag in three words, of which the first two are short.
    pub(super) half_lag: [C; 3],
}

/// What sn, cn, dn and the turn about L are multiplied with.
#[derive(Debug, Clone, Copy)]
pub(super) struct Amplitudes<C> {
    /// Of L, of Ω and of L/|L|, for cn, sn and dn.
    pub(super) l: [C; 3],
    pub(super) omega: [C; 3],
    pub(super) direction: [C; 3],
    /// P₁/P₂.
    pub(super) aspect: C,
    /// The attitude from the turn by ψ after the shortest rotation, with the renumbering of the axes.
    pub(super) base: [[C; 4]; 4],
}

/// Ω moves, m ≤ 1/2.
#[derive(Debug, Clone, Copy)]
pub(super) struct Circular<C> {
    pub(super) phases: Phases<C>,
    pub(super) amplitudes: Amplitudes<C>,
    pub(super) corrections: [[C; 4]; 4],
    pub(super) real: [C; 4],
    pub(super) imaginary: [C; 3],
}

/// N polynomials next to even multiples of K, and by which bits those next to odd ones differ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Choices<C, const N: usize> {
    even: [[C; 4]; N],
    change: [[C; 4]; N],
}

impl<const N: usize> Choices<f64, N> {
    pub(super) fn new(even: [[f64; 4]; N], odd: [[f64; 4]; N]) -> Self {
        let change = |j: usize, k: usize| difference_of_bits(even[j][k], odd[j][k]);
        Self {
            even,
            change: core::array::from_fn(|j| core::array::from_fn(|k| change(j, k))),
        }
    }
}

impl<const N: usize, const W: usize> Choices<[f64; W], N> {
    fn zero() -> Self {
        Self {
            even: [[[0.0; W]; 4]; N],
            change: [[[0.0; W]; 4]; N],
        }
    }

    #[inline(always)]
    pub(super) fn put(&mut self, i: usize, even: [[f64; 4]; N], odd: [[f64; 4]; N]) {
        for j in 0..N {
            for k in 0..4 {
                self.even[j][k][i] = even[j][k];
                self.change[j][k][i] = difference_of_bits(even[j][k], odd[j][k]);
            }
        }
    }

    fn gather(each: [&Choices<f64, N>; W]) -> Self {
        Self {
            even: tables(each.map(|x| &x.even)),
            change: tables(each.map(|x| &x.change)),
        }
    }
}

impl<C: Constant, const N: usize> Choices<C, N> {
    #[inline(always)]
    fn lane(&self, i: usize) -> [Choice; N] {
        core::array::from_fn(|j| Choice {
            even: all(&self.even[j], i),
            change: all(&self.change[j], i),
        })
    }
}

/// Ω moves, m > 1/2, the separatrix included.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hyperbolic<C> {
    pub(super) phases: Phases<C>,
    pub(super) amplitudes: Amplitudes<C>,
    pub(super) corrections: Choices<C, 4>,
    /// 2q′^{1/4} and √mc.
    pub(super) roots: [C; 2],
    /// Real and imaginary part of the theta function.
    pub(super) theta: Choices<C, 2>,
}

impl<const W: usize> Steady<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            half_rate: Rate::zero(),
            unturned: [[0.0; W]; 4],
            turned: [[0.0; W]; 4],
            l: [[0.0; W]; 3],
            omega: [[0.0; W]; 3],
        }
    }

    pub(super) fn gather(each: [&Steady<f64>; W]) -> Self {
        Self {
            half_rate: Rate::gather(each.map(|x| &x.half_rate)),
            unturned: rows(each.map(|x| &x.unturned)),
            turned: rows(each.map(|x| &x.turned)),
            l: rows(each.map(|x| &x.l)),
            omega: rows(each.map(|x| &x.omega)),
        }
    }
}

impl<const W: usize> Phases<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            rate: Rate::zero(),
            start: [[0.0; W]; 2],
            inverse: [0.0; W],
            parts: [[0.0; W]; 3],
            pace: [[0.0; W]; 2],
            half_turning: Rate::zero(),
            half_lag: [[0.0; W]; 3],
        }
    }

    fn gather(each: [&Phases<f64>; W]) -> Self {
        Self {
            rate: Rate::gather(each.map(|x| &x.rate)),
            start: rows(each.map(|x| &x.start)),
            inverse: each.map(|x| x.inverse),
            parts: rows(each.map(|x| &x.parts)),
            pace: rows(each.map(|x| &x.pace)),
            half_turning: Rate::gather(each.map(|x| &x.half_turning)),
            half_lag: rows(each.map(|x| &x.half_lag)),
        }
    }
}

impl<const W: usize> Amplitudes<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            l: [[0.0; W]; 3],
            omega: [[0.0; W]; 3],
            direction: [[0.0; W]; 3],
            aspect: [0.0; W],
            base: [[[0.0; W]; 4]; 4],
        }
    }

    fn gather(each: [&Amplitudes<f64>; W]) -> Self {
        Self {
            l: rows(each.map(|x| &x.l)),
            omega: rows(each.map(|x| &x.omega)),
            direction: rows(each.map(|x| &x.direction)),
            aspect: each.map(|x| x.aspect),
            base: tables(each.map(|x| &x.base)),
        }
    }
}

impl<const W: usize> Circular<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            phases: Phases::zero(),
            amplitudes: Amplitudes::zero(),
            corrections: [[[0.0; W]; 4]; 4],
            real: [[0.0; W]; 4],
            imaginary: [[0.0; W]; 3],
        }
    }

    pub(super) fn gather(each: [&Circular<f64>; W]) -> Self {
        Self {
            phases: Phases::gather(each.map(|x| &x.phases)),
            amplitudes: Amplitudes::gather(each.map(|x| &x.amplitudes)),
            corrections: tables(each.map(|x| &x.corrections)),
            real: rows(each.map(|x| &x.real)),
            imaginary: rows(each.map(|x| &x.imaginary)),
        }
    }
}

impl<const W: usize> Hyperbolic<[f64; W]> {
    pub(super) fn zero() -> Self {
        Self {
            phases: Phases::zero(),
            amplitudes: Amplitudes::zero(),
            corrections: Choices::zero(),
            roots: [[0.0; W]; 2],
            theta: Choices::zero(),
        }
    }

    pub(super) fn gather(each: [&Hyperbolic<f64>; W]) -> Self {
        Self {
            phases: Phases::gather(each.map(|x| &x.phases)),
            amplitudes: Amplitudes::gather(each.map(|x| &x.amplitudes)),
            corrections: Choices::gather(each.map(|x| &x.corrections)),
            roots: rows(each.map(|x| &x.roots)),
            theta: Choices::gather(each.map(|x| &x.theta)),
        }
    }
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

#[inline(always)]
pub(super) fn row<const N: usize, const W: usize>(rows: &[[f64; W]; N], i: usize) -> [f64; N] {
    core::array::from_fn(|k| rows[k][i])
}

/// A kind of motion that goes over a row of times.
pub(super) trait Motion {
    fn at<const W: usize>(&self, times: &[f64; W], work: &mut Work<W>, rows: &mut Rows<W>);
}

impl<C: Constant> Motion for Steady<C> {
    #[inline(never)]
    fn at<const W: usize>(&self, times: &[f64; W], _: &mut Work<W>, rows: &mut Rows<W>) {
        for i in 0..W {
            let half = self.half_rate.times(i, Time::new(times[i]));
            let (sine, cosine) = lanes::sine_cosine(half);
            for k in 0..4 {
                rows.attitude[k][i] =
                    cosine * self.unturned[k].lane(i) + sine * self.turned[k].lane(i);
            }
        }
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
