//! Moduli of many bodies side by side: the transformations, the quarter periods, the polynomials and the arguments at the start.

#![allow(
    clippy::needless_range_loop,
    reason = "a lane is its index: all rows are read and written at it"
)]

use crate::elliptic::kernel;
use crate::elliptic::landen::Landen;
use crate::elliptic::series::{
    Corrections, circular_corrections, circular_thetas, hyperbolic_corrections, hyperbolic_thetas,
};
use crate::precise::{
    DoubleDouble, Lane, Number, Place, RIGHT_ANGLE, Two, Words, angle_at, logarithm_at, nearest,
    quick, tabulated,
};

/// Gauss's transformation of one parameter a lane: [`Landen`] in rows.
#[derive(Debug)]
pub(crate) struct Landens<const W: usize> {
    sums: [Two<W>; 3],
    moduli: [Two<W>; 2],
    last: [f64; W],
    mean: Two<W>,
    nome_over_square: Two<W>,
    parameter: Two<W>,
    nome: Two<W>,
}

impl<const W: usize> Landens<W> {
    /// Of these parameters, each the lesser of m and mc.
    #[inline(always)]
    pub(crate) fn new(parameters: &Two<W>) -> Self {
        let zero = [[0.0; W]; 2];
        let mut rows = Self {
            sums: [zero; 3],
            moduli: [zero; 2],
            last: [0.0; W],
            mean: zero,
            nome_over_square: zero,
            parameter: *parameters,
            nome: zero,
        };
        for i in 0..W {
            let parameter = Lane::of(parameters, i);
            let greater = Lane::from_double(1.0).add_alike(-parameter);
            let landen = Landen::new(parameter, greater.square_root());
            for k in 0..3 {
                landen.sums[k].ordered().put(&mut rows.sums[k], i);
            }
            for k in 0..2 {
                landen.moduli[k].ordered().put(&mut rows.moduli[k], i);
            }
            rows.last[i] = landen.last;
            landen.mean.put(&mut rows.mean, i);
            landen.nome_over_square.put(&mut rows.nome_over_square, i);
            landen.nome.ordered().put(&mut rows.nome, i);
        }
        rows
    }

    /// That of one lane.
    #[inline(always)]
    pub(crate) fn lane(&self, i: usize) -> Landen<Lane> {
        Landen {
            sums: [
                Lane::of(&self.sums[0], i),
                Lane::of(&self.sums[1], i),
                Lane::of(&self.sums[2], i),
            ],
            moduli: [Lane::of(&self.moduli[0], i), Lane::of(&self.moduli[1], i)],
            last: self.last[i],
            mean: Lane::of(&self.mean, i),
            nome_over_square: Lane::of(&self.nome_over_square, i),
            parameter: Lane::of(&self.parameter, i),
            nome: Lane::of(&self.nome, i),
        }
    }
}

/// The natural logarithms of normal positive numbers; of zero, nothing of use.
#[inline(always)]
pub(crate) fn logarithms<const W: usize>(numbers: &Two<W>) -> Two<W> {
    let mut places = [[0.0; W]; 5];
    for i in 0..W {
        // The table is looked up lane by lane.
        let place = Place::new(numbers[0][i]);
        places[0][i] = place.inverse;
        places[1][i] = place.exponent;
        places[2][i] = place.center;
        places[3][i] = place.entry.high();
        places[4][i] = place.entry.low();
    }
    let mut logarithms = [[0.0; W]; 2];
    for i in 0..W {
        let place = Place {
            inverse: places[0][i],
            exponent: places[1][i],
            center: places[2][i],
            entry: DoubleDouble::new(places[3][i], places[4][i]),
        };
        let number = Lane::of(numbers, i).two();
        Lane::new(logarithm_at(number, &place)).put(&mut logarithms, i);
    }
    logarithms
}

/// The angles of the points (cosine, sine) in the first quadrant.
#[inline(always)]
pub(crate) fn angles<const W: usize>(cosines: &Two<W>, sines: &Two<W>) -> Two<W> {
    let mut places = [[0.0; W]; 3];
    for i in 0..W {
        places[0][i] = nearest(cosines[0][i], sines[0][i]);
    }
    for i in 0..W {
        let entry = tabulated(places[0][i]);
        places[1][i] = entry.high();
        places[2][i] = entry.low();
    }
    let mut angles = [[0.0; W]; 2];
    for i in 0..W {
        let entry = DoubleDouble::new(places[1][i], places[2][i]);
        let (cosine, sine) = (Lane::of(cosines, i), Lane::of(sines, i));
        let angle = angle_at(cosine, sine, places[0][i], entry);
        angle.ordered().put(&mut angles, i);
    }
    angles
}

/// K = (K′/π) ln(1/q′) for m > 1/2; infinite on the separatrix.
#[inline(always)]
pub(crate) fn complementary_quarters<const W: usize>(landens: &Landens<W>) -> Two<W> {
    let mut nomes = [[0.0; W]; 2];
    for i in 0..W {
        let nome =
            (Lane::of(&landens.parameter, i) * Lane::of(&landens.nome_over_square, i)).ordered();
        nome.put(&mut nomes, i);
    }
    let logarithms = logarithms(&nomes);
    let mut quarters = [[0.0; W]; 2];
    for i in 0..W {
        let logarithm = -Lane::of(&logarithms, i);
        let twice = Lane::of(&landens.mean, i).scaled(2.0);
        let [high, low] = logarithm.quotient(twice).ordered().words();
        let on_it = landens.parameter[0][i] == 0.0;
        quarters[0][i] = if on_it { f64::INFINITY } else { high };
        quarters[1][i] = if on_it { 0.0 } else { low };
    }
    quarters
}

/// A quarter period as it is taken off an argument: 1/K, and K in three words of which the first two are short.
#[inline(always)]
pub(crate) fn reduction([high, low]: [f64; 2]) -> (f64, [f64; 3]) {
    let (first, second) = quick::halves(high);
    let finite = high < f64::INFINITY;
    let kept = |x: f64| if finite { x } else { 0.0 };
    (1.0 / high, [kept(first), kept(second), kept(low)])
}

/// K = π/2 over the mean, for m ≤ 1/2.
#[inline(always)]
pub(crate) fn quarter(landen: &Landen<Lane>) -> Lane {
    Lane::new(RIGHT_ANGLE).quotient(landen.mean).ordered()
}

#[inline(always)]
fn polynomials(set: Corrections) -> super::Polynomials {
    [set.denominator, set.sn, set.cn, set.dn]
}

/// The polynomials for m ≤ 1/2.
#[inline(always)]
pub(crate) fn circular_polynomials(landen: &Landen<Lane>) -> super::Polynomials {
    polynomials(circular_corrections(circular_thetas(landen.nome.value())))
}

/// The polynomials for m > 1/2, next to even and to odd multiples of K, and 2q′^{1/4}.
#[inline(always)]
pub(crate) fn hyperbolic_polynomials(
    landen: &Landen<Lane>,
    complementary_modulus: f64,
) -> ([super::Polynomials; 2], f64) {
    let half = landen.root_of_nome(complementary_modulus);
    let [even, odd] = hyperbolic_corrections(hyperbolic_thetas(half), landen.mean.value());
    ([polynomials(even), polynomials(odd)], 2.0 * half.sqrt())
}

/// The squares of the three functions at one place, without their denominators, as in
/// [`Squares`](crate::elliptic::descent::Squares).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Squares {
    pub(crate) sn: f64,
    pub(crate) cn: f64,
    pub(crate) whole: f64,
    pub(crate) dn: f64,
    pub(crate) dn_whole: f64,
}

impl Squares {
    /// Beyond the middle of the quarter period, where mc sn⁴ > cn⁴: then an argument is counted from its end.
    #[inline(always)]
    pub(crate) fn nearer_to_end(&self, mc: f64) -> bool {
        mc * (self.sn * self.sn) > self.cn * self.cn
    }

    /// πu/(2K) from the nearer end of the quarter period, for m ≤ 1/2.
    #[inline(always)]
    pub(crate) fn angle(&self, landen: &Landen<Lane>, mc: f64) -> f64 {
        let Self {
            sn,
            cn,
            whole,
            dn,
            dn_whole,
        } = *self;
        let end = self.nearer_to_end(mc);
        let either = |a: f64, b: f64| if end { a } else { b };
        let s = (either(cn * dn_whole, sn) / either(dn * whole, whole)).sqrt();
        let d = (either(mc * dn_whole, dn) / either(dn, dn_whole)).sqrt();
        let sine = landen.nearest_sine(s, d, 1.0);
        kernel::angle(sine, ((1.0 - sine) * (1.0 + sine)).sqrt())
    }

    /// e^x, x = πu/(2K′) from the nearer end of the quarter period, for m > 1/2.
    #[inline(always)]
    pub(crate) fn growth(&self, landen: &Landen<Lane>, mc: f64) -> f64 {
        let Self {
            sn,
            cn,
            whole,
            dn,
            dn_whole,
        } = *self;
        let end = self.nearer_to_end(mc);
        let either = |a: f64, b: f64| if end { a } else { b };
        let s = (either(cn, sn) / either(mc * sn, cn)).sqrt();
        let d = (either(whole, dn * whole) / either(sn, cn * dn_whole)).sqrt();
        let sinh = landen.nearest_sine(s, d, -1.0);
        sinh + (1.0 + sinh * sinh).sqrt()
    }
}

/// The argument: what it is away from the end that it was counted from, or K less that.
#[inline(always)]
pub(crate) fn from_either_end(end: bool, quarter: Lane, rest: Lane) -> DoubleDouble {
    let (from_end, rest) = ((quarter - rest).ordered(), rest.ordered());
    let choose = |k: usize| {
        if end {
            from_end.words()[k]
        } else {
            rest.words()[k]
        }
    };
    DoubleDouble::new(choose(0), choose(1))
}
