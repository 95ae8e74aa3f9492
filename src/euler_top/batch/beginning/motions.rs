//! The motions themselves: what theta functions and quarter periods add to the constants, and where each body stands at time 0.

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

use super::{Beginnings, Constants, Lesser};
use crate::elliptic::lanes::descent::{
    Landens, angles, circular_polynomials, complementary_quarters, from_either_end,
    hyperbolic_polynomials, logarithms, quarter, reduction,
};
use crate::elliptic::theta::{DualTheta, dual_excess};
use crate::euler_top::batch::constants::{Amplitudes, Circular, Hyperbolic, Phases, Steady};
use crate::euler_top::batch::lanes::{Motion, Rows, Work, row};
use crate::euler_top::batch::prepared::{quarters_reach, turning_reach};
use crate::euler_top::batch::rate::{Rate, halves};
use crate::euler_top::turning::{Theta, Turning};
use crate::precise::{DoubleDouble, Lane, Number, Two, Words};

/// What theta functions and quarter periods add to the constants.
struct Turnings<const W: usize> {
    quarter: Two<W>,
    lag: Two<W>,
    excess: Two<W>,
    /// π/(2K) or π/(2K′).
    mean: Two<W>,
    /// u at time 0, its sign that of L₂.
    start: Two<W>,
}

impl<const W: usize> Turnings<W> {
    fn zero() -> Self {
        let zero = [[0.0; W]; 2];
        Self {
            quarter: zero,
            lag: zero,
            excess: zero,
            mean: zero,
            start: zero,
        }
    }
}

/// A word of two times a power of two, into a rate.
#[inline(always)]
fn put_rate<const W: usize>(rate: &mut Rate<[f64; W]>, i: usize, [high, low]: [f64; 2]) {
    let [upper, lower] = halves(high);
    rate.high[i] = high;
    rate.upper[i] = upper;
    rate.lower[i] = lower;
    rate.low[i] = low;
}

fn least<const W: usize>(reach: &[f64; W]) -> f64 {
    let lesser = |a: f64, b: &f64| if *b < a { *b } else { a };
    reach.iter().fold(f64::INFINITY, lesser)
}

impl<const W: usize> Beginnings<W> {
    /// The phases, and up to which time they hold.
    #[inline(always)]
    fn put_phases(
        &self,
        constants: &Constants<W>,
        turnings: &Turnings<W>,
        phases: &mut Phases<[f64; W]>,
    ) -> f64 {
        let mut reach = [0.0; W];
        for i in 0..W {
            let rate = Lane::of(&constants.rate, i);
            let excess = rate * Lane::of(&turnings.excess, i);
            let sense = self.sense[i];
            // Base + sense · excess: the excess may have either sign.
            let turning = Lane::of(&constants.base, i) - excess.scaled(-sense);
            let pace = self.pace[i];
            let rate = rate.scaled(sense * pace).ordered().words();
            put_rate(&mut phases.rate, i, rate);
            let half_turning = turning.scaled(0.5 * pace).ordered().words();
            put_rate(&mut phases.half_turning, i, half_turning);
            let quarter = Lane::of(&turnings.quarter, i).words();
            let (inverse, parts) = reduction(quarter);
            phases.inverse[i] = inverse;
            for k in 0..3 {
                phases.parts[k][i] = parts[k];
            }
            for k in 0..2 {
                phases.start[k][i] = turnings.start[k][i];
                phases.pace[k][i] = turnings.mean[k][i];
            }
            let [high, low] = Lane::of(&turnings.lag, i).scaled(0.5).words();
            let [first, second] = halves(high);
            phases.half_lag[0][i] = first;
            phases.half_lag[1][i] = second;
            phases.half_lag[2][i] = low;
            let quarters = quarters_reach(quarter[0], rate[0].abs());
            let turns = turning_reach(2.0 * half_turning[0].abs());
            reach[i] = if quarters < turns { quarters } else { turns };
        }
        least(&reach)
    }

    /// The amplitudes, for bodies whose own axes are the renumbered ones at time 0.
    #[inline(always)]
    fn put_amplitudes(&self, constants: &Constants<W>, rows: &mut Amplitudes<[f64; W]>) {
        for i in 0..W {
            let p = row(&constants.amplitudes, i);
            let per_size = 1.0 / (p[0] * p[0] + p[2] * p[2]).sqrt();
            for k in 0..3 {
                let own = self.signs[k][i] * (p[k] * self.momentum[i]);
                rows.l[k][i] = own;
                rows.omega[k][i] = own / self.moments[k][i];
                rows.direction[k][i] = p[k] * per_size;
            }
            rows.aspect[i] = constants.aspect[i];
        }
        for k in 0..4 {
            rows.base[k] = [[0.0; W]; 4];
            rows.base[k][k] = [1.0; W];
        }
    }

    /// The attitudes less those that the motions have at time 0.
    fn put_base(&self, base: &mut [[[f64; W]; 4]; 4], found: &[[f64; W]; 4]) {
        let mut renumbered = [[[0.0; W]; 4]; 4];
        for i in 0..W {
            let [a, b, c, d] = row(&self.attitude, i);
            let [w, x, y, z] = row(found, i);
            // (a + bi + cj + dk)(w − xi − yj − zk).
            let p = (a * w + b * x) + (c * y + d * z);
            let q = (b * w - a * x) + (d * y - c * z);
            let r = (c * w - a * y) + (b * z - d * x);
            let s = (d * w - a * z) + (c * x - b * y);
            let [e, f, g] = row(&self.signs, i);
            let rows = [
                [p, -q, -r, -s],
                [e * q, e * p, -e * s, e * r],
                [f * r, f * s, f * p, -f * q],
                [g * s, -g * r, g * q, g * p],
            ];
            for row in 0..4 {
                for column in 0..4 {
                    renumbered[row][column][i] = rows[row][column];
                }
            }
        }
        base[0] = renumbered[0];
        for i in 0..W {
            for k in 0..3 {
                let own = self.axes[i][k] + 1;
                for column in 0..4 {
                    base[own][column][i] = renumbered[k + 1][column][i];
                }
            }
        }
    }

    /// Motions with m ≤ 1/2, and up to which time they hold.
    #[inline(never)]
    pub(in crate::euler_top::batch) fn circular(
        &self,
        motion: &mut Circular<[f64; W]>,
        work: &mut Work<W>,
    ) -> f64 {
        let constants = self.constants(Lesser::Parameter);
        let landens = Landens::new(&constants.lesser);
        let mut turnings = Turnings::zero();
        for i in 0..W {
            let landen = landens.lane(i);
            let elevation = constants.elevation(i);
            let exponentials =
                elevation.bounded_exponentials(&landen, Lane::of(&constants.lesser, i));
            let turning = Turning::circular(&landen, elevation.which, exponentials, 0.0);
            Lane::new(turning.lag).put(&mut turnings.lag, i);
            Lane::new(turning.excess).put(&mut turnings.excess, i);
            if let Theta::Circular { real, imaginary } = turning.theta {
                for k in 0..4 {
                    motion.real[k][i] = real[k];
                }
                for k in 0..3 {
                    motion.imaginary[k][i] = imaginary[k];
                }
            }
        }
        for i in 0..W {
            let landen = landens.lane(i);
            let polynomials = circular_polynomials(&landen);
            for j in 0..4 {
                for k in 0..4 {
                    motion.corrections[j][k][i] = polynomials[j][k];
                }
            }
        }
        for i in 0..W {
            let landen = landens.lane(i);
            let quarter = quarter(&landen);
            quarter.put(&mut turnings.quarter, i);
            landen.mean.ordered().put(&mut turnings.mean, i);
            let (squares, mc) = (constants.squares(i), 1.0 - constants.lesser[0][i]);
            let rest = Lane::from_double(squares.angle(&landen, mc)).quotient(landen.mean);
            let start = from_either_end(squares.nearer_to_end(mc), quarter, rest);
            self.put_start(&mut turnings.start, i, start);
        }
        let reach = self.put_phases(&constants, &turnings, &mut motion.phases);
        self.put_amplitudes(&constants, &mut motion.amplitudes);
        let mut rows = Rows::zero();
        motion.at(&[0.0; W], work, &mut rows);
        self.put_base(&mut motion.amplitudes.base, &rows.attitude);
        reach
    }

    #[inline(always)]
    fn put_start(&self, starts: &mut Two<W>, i: usize, start: DoubleDouble) {
        let sign = if self.l[1][i] < 0.0 { -1.0 } else { 1.0 };
        Lane::new(start).scaled(sign).put(starts, i);
    }

    /// Motions with m > 1/2, and up to which time they hold.
    #[inline(never)]
    pub(in crate::euler_top::batch) fn hyperbolic(
        &self,
        motion: &mut Hyperbolic<[f64; W]>,
        work: &mut Work<W>,
    ) -> f64 {
        let constants = self.constants(Lesser::Complement);
        let landens = Landens::new(&constants.lesser);
        let mut turnings = Turnings::zero();
        let zero = [[0.0; W]; 2];
        let (mut sines, mut cosines) = (zero, zero);
        for i in 0..W {
            let landen = landens.lane(i);
            let lesser = Lane::of(&constants.lesser, i);
            let (sine, cosine) = constants.elevation(i).angle(&landen, lesser);
            sine.ordered().put(&mut sines, i);
            cosine.ordered().put(&mut cosines, i);
        }
        for i in 0..W {
            let (sine, cosine) = (Lane::of(&sines, i), Lane::of(&cosines, i));
            let excess = -dual_excess(&landens.lane(i), sine, cosine);
            excess.put(&mut turnings.excess, i);
        }
        // What it lags behind is the angle's complement.
        turnings.lag = angles(&sines, &cosines);
        for i in 0..W {
            let (sine, cosine) = (Lane::of(&sines, i), Lane::of(&cosines, i));
            let landen = landens.lane(i);
            let theta = DualTheta::new(landen.nome.value(), sine.value(), cosine.value());
            let [even, odd] = theta.coefficients();
            motion.theta.put(i, even, odd);
        }
        for i in 0..W {
            let landen = landens.lane(i);
            let complementary_modulus = constants.lesser[0][i].sqrt();
            let ([even, odd], root) = hyperbolic_polynomials(&landen, complementary_modulus);
            motion.corrections.put(i, even, odd);
            motion.roots[0][i] = root;
            motion.roots[1][i] = complementary_modulus;
        }
        let mut growths = zero;
        for i in 0..W {
            let landen = landens.lane(i);
            growths[0][i] = constants.squares(i).growth(&landen, constants.lesser[0][i]);
        }
        let arguments = logarithms(&growths);
        turnings.quarter = complementary_quarters(&landens);
        for i in 0..W {
            let landen = landens.lane(i);
            landen.mean.ordered().put(&mut turnings.mean, i);
            let rest = Lane::of(&arguments, i).quotient(landen.mean);
            let end = constants.squares(i).nearer_to_end(constants.lesser[0][i]);
            let quarter = Lane::of(&turnings.quarter, i);
            self.put_start(&mut turnings.start, i, from_either_end(end, quarter, rest));
        }
        let reach = self.put_phases(&constants, &turnings, &mut motion.phases);
        self.put_amplitudes(&constants, &mut motion.amplitudes);
        let mut rows = Rows::zero();
        motion.at(&[0.0; W], work, &mut rows);
        self.put_base(&mut motion.amplitudes.base, &rows.attitude);
        reach
    }

    /// Bodies whose Ω stays: at the rate Σ L_i²/I_i / |L| about L.
    #[inline(never)]
    pub(in crate::euler_top::batch) fn steady(&self, motion: &mut Steady<[f64; W]>) -> f64 {
        let mut reach = [0.0; W];
        for i in 0..W {
            let squares = self.squares(i);
            let moments = row(&self.scaled, i);
            let size = squares[0]
                .add_alike(squares[1])
                .add_alike(squares[2])
                .square_root();
            let energy = |k: usize| squares[k].quotient(Lane::from_double(moments[k]));
            let twice_energy = energy(0).add_alike(energy(1)).add_alike(energy(2));
            let rate = twice_energy.quotient(size).scaled(self.pace[i]);
            put_rate(&mut motion.half_rate, i, rate.scaled(0.5).ordered().words());
            reach[i] = turning_reach(rate.leading());
            for k in 0..3 {
                let own = self.signs[k][i] * (self.l[k][i] * self.momentum[i]);
                motion.l[k][i] = own;
                motion.omega[k][i] = own / self.moments[k][i];
            }
            let direction = |k: usize| Lane::from_double(self.l[k][i]).quotient(size).value();
            let (x, y, z) = (direction(0), direction(1), direction(2));
            let [a, b, c, d] = row(&self.attitude, i);
            let turned = [
                -(b * x + c * y + d * z),
                a * x + (c * z - d * y),
                a * y + (d * x - b * z),
                a * z + (b * y - c * x),
            ];
            let signs = [1.0, self.signs[0][i], self.signs[1][i], self.signs[2][i]];
            for k in 0..4 {
                motion.unturned[k][i] = signs[k] * self.attitude[k][i];
                motion.turned[k][i] = signs[k] * turned[k];
            }
        }
        // Back to the body's own order: the attitude is along the renumbered axes so far.
        let (unturned, turned) = (motion.unturned, motion.turned);
        for i in 0..W {
            for k in 0..3 {
                let own = self.axes[i][k] + 1;
                motion.unturned[own][i] = unturned[k + 1][i];
                motion.turned[own][i] = turned[k + 1][i];
            }
        }
        least(&reach)
    }
}
