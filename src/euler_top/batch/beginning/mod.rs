//! From moments and L to the constants of the motion, several bodies side by side: what
//! [`preparation`](crate::euler_top::preparation) does for one.

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

mod motions;

use super::Axes;
use super::lanes::row;
use super::release::{Release, Sorted};
use crate::elliptic::lanes::descent::Squares;
use crate::elliptic::theta::{Elevation, Which};
use crate::euler_top::separation::exact_separation;
use crate::precise::{Lane, Number, Two, Words, exponent_of};

/// Bodies along their renumbered axes.
pub(super) struct Beginnings<const W: usize> {
    axes: [Axes; W],
    /// In kg m².
    moments: [[f64; W]; 3],
    /// Less powers of two.
    scaled: [[f64; W]; 3],
    l: [[f64; W]; 3],
    sense: [f64; W],
    /// Unit of L, kg m²/s, and of rates, 1/s.
    momentum: [f64; W],
    pace: [f64; W],
    signs: [[f64; W]; 3],
    attitude: [[f64; W]; 4],
}

fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023).unsigned_abs() as u64) << 52)
}

impl<const W: usize> Beginnings<W> {
    pub(super) fn gather(releases: &[Release], sorted: [&Sorted; W]) -> Self {
        let mut rows = Self {
            axes: sorted.map(|x| x.axes.axis),
            moments: [[0.0; W]; 3],
            scaled: [[0.0; W]; 3],
            l: [[0.0; W]; 3],
            sense: sorted.map(|x| x.sense),
            momentum: sorted.map(|x| x.unit),
            pace: [0.0; W],
            signs: [[0.0; W]; 3],
            attitude: [[0.0; W]; 4],
        };
        for i in 0..W {
            let Sorted {
                place,
                axes,
                unit,
                unit_of_moments,
                ..
            } = *sorted[i];
            let release = &releases[place];
            // Reciprocals of powers of two: exact.
            let (per_unit, per_moment) = (1.0 / unit, 1.0 / unit_of_moments);
            let l: [f64; 3] = release.angular_momentum.components().into();
            let q = release.attitude.quaternion();
            let vector = [q.i, q.j, q.k];
            rows.attitude[0][i] = q.w;
            for k in 0..3 {
                let (axis, sign) = (axes.axis[k], axes.sign[k]);
                rows.moments[k][i] = release.moments[axis];
                rows.scaled[k][i] = release.moments[axis] * per_moment;
                rows.l[k][i] = sign * l[axis] * per_unit;
                rows.signs[k][i] = sign;
                rows.attitude[k + 1][i] = sign * vector[axis];
            }
            rows.pace[i] = power_of_two(exponent_of(unit) - exponent_of(unit_of_moments));
        }
        rows
    }
}

/// What both kinds of motion have: all from sums of terms of one sign, as for one body.
struct Constants<const W: usize> {
    /// The lesser of m and mc.
    lesser: Two<W>,
    rate: Two<W>,
    /// |L|/I₂.
    base: Two<W>,
    rise: Two<W>,
    run: Two<W>,
    slope: Two<W>,
    /// 1 for η, 0 for ξ.
    eta: [f64; W],
    amplitudes: [[f64; W]; 3],
    aspect: [f64; W],
    /// sn², cn², their sum, dn² and dn² + m sn², as in [`Squares`].
    squares: [[f64; W]; 5],
}

/// Which of m and mc is the lesser.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lesser {
    Parameter,
    Complement,
}

/// So much of the leading word may cancel before the difference is formed of exact products.
const CANCELLED: f64 = 1.0 / 1024.0;

impl<const W: usize> Beginnings<W> {
    /// c₁, c₂, c₃, not negative.
    #[inline(always)]
    fn differences(&self, i: usize) -> [Lane; 3] {
        let [i0, i1, i2] = row(&self.scaled, i);
        let sense = self.sense[i];
        let difference = |a: f64, b: f64| Lane::difference(sense * a, sense * b);
        [
            difference(i2, i1).times(i0),
            difference(i2, i0).times(i1),
            difference(i1, i0).times(i2),
        ]
    }

    #[inline(always)]
    fn squares(&self, i: usize) -> [Lane; 3] {
        let [x, y, z] = row(&self.l, i);
        [
            Lane::product(x, x),
            Lane::product(y, y),
            Lane::product(z, z),
        ]
    }

    /// c₁ L₃² − c₃ L₁², how far the separatrix is.
    #[inline(always)]
    fn distances(&self) -> Two<W> {
        let mut distances = [[0.0; W]; 2];
        let mut blurred = [0.0; W];
        for i in 0..W {
            let (c, squares) = (self.differences(i), self.squares(i));
            let third = c[0] * squares[2];
            let distance = third - c[2] * squares[0];
            distance.put(&mut distances, i);
            blurred[i] = distance.leading() - CANCELLED * third.leading();
        }
        for i in 0..W {
            if blurred[i] <= 0.0 {
                let exact = exact_separation(row(&self.scaled, i), row(&self.l, i));
                let number = Lane::new(exact);
                let number = if self.sense[i] < 0.0 { -number } else { number };
                number.put(&mut distances, i);
            }
        }
        distances
    }

    #[inline(always)]
    fn constants(&self, lesser: Lesser) -> Constants<W> {
        let zero = [[0.0; W]; 2];
        let mut rows = Constants {
            lesser: zero,
            rate: zero,
            base: zero,
            rise: zero,
            run: zero,
            slope: zero,
            eta: [0.0; W],
            amplitudes: [[0.0; W]; 3],
            aspect: [0.0; W],
            squares: [[0.0; W]; 5],
        };
        let distances = match lesser {
            Lesser::Parameter => zero,
            Lesser::Complement => self.distances(),
        };
        for i in 0..W {
            let (c, squares) = (self.differences(i), self.squares(i));
            let steady = (c[2] * squares[1]).add_alike(c[1] * squares[2]);
            let wobble = (c[1] * squares[0]).add_alike(c[0] * squares[1]);
            let size_squared = squares[0].add_alike(squares[1]).add_alike(squares[2]);
            let frequency = c[0] * steady;
            let part = match lesser {
                Lesser::Parameter => c[2] * wobble,
                Lesser::Complement => c[1] * Lane::of(&distances, i),
            };
            part.quotient(frequency).ordered().put(&mut rows.lesser, i);
            let [i0, i1, i2] = row(&self.scaled, i);
            let volume = Lane::product(i0, i1).times(i2);
            let rate = frequency.square_root().quotient(volume);
            rate.put(&mut rows.rate, i);
            let base = size_squared.square_root().quotient(Lane::from_double(i1));
            base.put(&mut rows.base, i);
            let elevation =
                Elevation::smaller([steady, wobble], [c[0], c[2]], |which| match which {
                    Which::Eta => c[1] * size_squared,
                    Which::Xi => c[1],
                });
            elevation.rise.put(&mut rows.rise, i);
            elevation.run.put(&mut rows.run, i);
            elevation.slope.put(&mut rows.slope, i);
            rows.eta[i] = match elevation.which {
                Which::Eta => 1.0,
                Which::Xi => 0.0,
            };
            rows.aspect[i] = c[0].root_of_quotient(c[1]);
            rows.amplitudes[0][i] = wobble.root_of_quotient(c[1]);
            rows.amplitudes[1][i] = wobble.root_of_quotient(c[0]);
            rows.amplitudes[2][i] = steady.root_of_quotient(c[1]);
            let (c0, c1) = (c[0].value(), c[1].value());
            let [s0, s1, s2] = [squares[0].value(), squares[1].value(), squares[2].value()];
            let places = [s1 * c0, s0 * c1, wobble.value(), s2 * c1, steady.value()];
            for k in 0..5 {
                rows.squares[k][i] = places[k];
            }
        }
        rows
    }
}

impl<const W: usize> Constants<W> {
    #[inline(always)]
    fn elevation(&self, i: usize) -> Elevation<Lane> {
        Elevation {
            which: if self.eta[i] > 0.5 {
                Which::Eta
            } else {
                Which::Xi
            },
            rise: Lane::of(&self.rise, i),
            run: Lane::of(&self.run, i),
            slope: Lane::of(&self.slope, i),
        }
    }

    #[inline(always)]
    fn squares(&self, i: usize) -> Squares {
        let [sn, cn, whole, dn, dn_whole] = row(&self.squares, i);
        Squares {
            sn,
            cn,
            whole,
            dn,
            dn_whole,
        }
    }
}
