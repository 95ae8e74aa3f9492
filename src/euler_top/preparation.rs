//! From moments and angular momentum to the constants of the motion, in 106 bits and without a cancellation (tutorial 6.6).

use super::motion::Regime;
use super::turning::Turning;
use crate::double_double::{DoubleDouble, power_of_two_below};
use crate::elliptic::landen::Landen;
use crate::elliptic::theta::{Elevation, Which};
use crate::elliptic::{Modulus, Parameter, Side};
use crate::extended::{Extended, Scalar, exponent_of, shifted};
use crate::words::{Arithmetic, Words};

/// To how many digits the constants are formed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Digits {
    /// One double: for the first few radians.
    Sixteen,
    /// Two doubles: for ever.
    ThirtyTwo,
}

/// 2⁻²⁰⁰: the fourth power of what is above it is a normal double.
const FAR_BELOW: f64 = 6.223_015_277_861_142e-61;

/// How a motion starts: the components along the body's axes of what was given, exact as they stand.
#[derive(Debug, Clone, Copy)]
pub(super) enum Start {
    /// L, kg m²/s.
    AngularMomentum([f64; 3]),
    /// Ω, rad/s.
    Omega([f64; 3]),
}

impl Start {
    /// What it is.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::AngularMomentum(_) => "a component of the angular momentum",
            Self::Omega(_) => "a component of the angular velocity",
        }
    }

    /// What was given.
    pub(super) fn components(self) -> [f64; 3] {
        match self {
            Self::AngularMomentum(components) | Self::Omega(components) => components,
        }
    }

    /// L, to 106 bits: the product of a moment and an angular velocity is not rounded.
    pub(super) fn angular_momentum<N: Scalar>(self, moments: [f64; 3]) -> [N; 3] {
        match self {
            Self::AngularMomentum([x, y, z]) => {
                [N::from_double(x), N::from_double(y), N::from_double(z)]
            }
            Self::Omega([x, y, z]) => [
                N::from_double(x).times(moments[0]),
                N::from_double(y).times(moments[1]),
                N::from_double(z).times(moments[2]),
            ],
        }
    }

    /// L and Ω as doubles.
    pub(super) fn both(self, moments: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        match self {
            Self::AngularMomentum(l) => (l, ratio(l, moments)),
            Self::Omega([x, y, z]) => {
                let l = [moments[0] * x, moments[1] * y, moments[2] * z];
                (l, [x, y, z])
            }
        }
    }

    /// The same quantity with other components.
    fn with(self, components: [f64; 3]) -> Self {
        match self {
            Self::AngularMomentum(_) => Self::AngularMomentum(components),
            Self::Omega(_) => Self::Omega(components),
        }
    }
}

/// L_i/I_i; zero along an axis whose moment is zero.
#[inline]
pub(super) fn ratio(l: [f64; 3], moments: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| {
        if moments[k] == 0.0 {
            0.0
        } else {
            l[k] / moments[k]
        }
    })
}

/// A body's axes, renumbered and turned over so that axis 3 has the component that keeps its sign and components 1 and 3
/// start positive; right-handed like the old ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Renumbering {
    axis: [usize; 3],
    sign: [f64; 3],
}

impl Renumbering {
    fn new(axis: [usize; 3], l: [f64; 3]) -> Self {
        let parity = if (axis[0] + 1) % 3 == axis[1] {
            1.0
        } else {
            -1.0
        };
        let sign_of = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
        let (first, third) = (sign_of(l[axis[0]]), sign_of(l[axis[2]]));
        Self {
            axis,
            sign: [first, parity * first * third, third],
        }
    }

    fn there<T: Copy>(&self, v: [T; 3]) -> [T; 3] {
        self.axis.map(|i| v[i])
    }

    /// Back along the body's own axes.
    #[inline]
    pub(super) fn back(&self, w: [f64; 3]) -> [f64; 3] {
        let mut v = [0.0; 3];
        for k in 0..3 {
            v[self.axis[k]] = self.sign[k] * w[k];
        }
        v
    }
}

/// The constants of a motion in which Ω moves in the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Constants {
    pub(super) axes: Renumbering,
    pub(super) modulus: Modulus,
    /// u = `start` + `rate` t.
    pub(super) start: DoubleDouble,
    pub(super) rate: DoubleDouble,
    /// L along the renumbered axes is (P₁ cn u, P₂ sn u, P₃ dn u).
    pub(super) amplitudes: [f64; 3],
    pub(super) turning: Turning,
    /// ψ = `turning_rate` t − quarters · lag + …
    pub(super) turning_rate: DoubleDouble,
}

impl Constants {
    /// From a motion whose unit of L was `momentum` and whose unit of rates 2^`exponent`.
    fn put_in_units(&mut self, (momentum, exponent): (f64, i32)) {
        let scaled = |x: DoubleDouble| {
            DoubleDouble::sum(shifted(x.high(), exponent), shifted(x.low(), exponent))
        };
        self.rate = scaled(self.rate);
        self.turning_rate = scaled(self.turning_rate);
        for amplitude in &mut self.amplitudes {
            *amplitude *= momentum;
        }
    }
}

/// The power of two next below the largest of them.
fn unit(values: [f64; 3]) -> f64 {
    power_of_two_below(values.iter().fold(0.0, |largest, x| x.abs().max(largest)))
}

/// 1/I_i − 1/I_j all multiplied by I₁I₂I₃, from exact differences: c₁ = I₁(I₃ − I₂), c₂ = I₂(I₃ − I₁), c₃ = I₃(I₂ − I₁),
/// for ascending moments.
fn differences<N: Scalar>(i: [f64; 3]) -> [N; 3] {
    [
        N::difference(i[2], i[1]).times(i[0]),
        N::difference(i[2], i[0]).times(i[1]),
        N::difference(i[1], i[0]).times(i[2]),
    ]
}

/// The order of the moments, ascending.
pub(super) fn ascending(moments: [f64; 3]) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    order
}

/// What kind of motion it is: decided here, once, by exact differences.
///
/// Returns the constants too if Ω moves.
pub(super) fn decide(
    moments: [f64; 3],
    start: Start,
    digits: Digits,
) -> (Regime, Option<Constants>) {
    // Powers of two are taken off without rounding; then no square overflows or underflows, unless the numbers are far apart.
    let (unit_of_moments, unit) = (unit(moments), unit(start.components()));
    let near = |x: f64, unit: f64| x == 0.0 || x.abs() > unit * FAR_BELOW;
    let tame = moments.iter().all(|x| near(*x, unit_of_moments))
        && start.components().iter().all(|x| near(*x, unit));
    if !tame {
        return decide_with::<Extended>(moments, start, separation);
    }
    let scaled = start.with(start.components().map(|x| x / unit));
    let moments = moments.map(|i| i / unit_of_moments);
    let (regime, mut constants) = match digits {
        Digits::Sixteen => decide_with::<f64>(moments, scaled, rounded_separation),
        Digits::ThirtyTwo => decide_with::<DoubleDouble>(moments, scaled, separation),
    };
    let units = match start {
        Start::AngularMomentum(_) => (unit, exponent_of(unit) - exponent_of(unit_of_moments)),
        Start::Omega(_) => (unit * unit_of_moments, exponent_of(unit)),
    };
    if let Some(constants) = &mut constants {
        constants.put_in_units(units);
    }
    (regime, constants)
}

fn decide_with<N: Scalar>(
    moments: [f64; 3],
    start: Start,
    separation: impl Fn([f64; 3], [usize; 3], Start) -> N,
) -> (Regime, Option<Constants>) {
    let l: [N; 3] = start.angular_momentum(moments);
    if l.iter().all(|component| component.is_zero()) {
        return (Regime::AtRest, None);
    }
    let order = ascending(moments);
    let i = order.map(|k| moments[k]);
    if i[0] == i[2] {
        return (Regime::Sphere, None);
    }
    if i[0] == 0.0 {
        return (Regime::Rod, None);
    }
    let moves =
        |a: usize, b: usize| i[a] != i[b] && !l[order[a]].is_zero() && !l[order[b]].is_zero();
    if !(moves(0, 1) || moves(1, 2) || moves(0, 2)) {
        return (Regime::PermanentRotation, None);
    }
    let c = differences(i);
    let separation = separation(i, order, start);
    let sign = separation.leading();
    let (axis, regime) = if sign < 0.0 {
        ([order[2], order[1], order[0]], Regime::AroundSmallest)
    } else if sign > 0.0 {
        (order, Regime::AroundLargest)
    } else {
        (order, Regime::Separatrix)
    };
    let regime = if i[0] == i[1] || i[1] == i[2] {
        Regime::Symmetric
    } else {
        regime
    };
    let (c, distance, sense) = if sign < 0.0 {
        ([c[2], c[1], c[0]], separation.negated(), -1.0)
    } else {
        (c, separation, 1.0)
    };
    let axes = Renumbering::new(axis, start.components());
    let l = axes.there(l);
    (
        regime,
        Some(constants(axes, axes.there(moments), l, c, distance, sense)),
    )
}

/// (L² − 2EI₂) I₁I₃ = c₁ L₃² − c₃ L₁²: its sign decides about which axis L goes, its size how close the separatrix is.
fn separation<N: Scalar>(i: [f64; 3], order: [usize; 3], start: Start) -> N {
    let x = order.map(|k| start.components()[k]);
    let l: [N; 3] = start.with(x).angular_momentum(i);
    let c = differences::<N>(i);
    let third = c[0].multiply(l[2].square());
    let first = c[2].multiply(l[0].square());
    let difference = third.subtract(first);
    let scale = third.times(1.0 / 1024.0);
    if difference.magnitude().exceeds(scale) {
        return difference;
    }
    // More than ten of the 106 bits have cancelled; from the exact products none is lost.
    N::from_extended(match start {
        Start::AngularMomentum(_) => {
            exact_difference([i[0], i[2], i[1], x[2]], [i[2], i[1], i[0], x[0]])
        }
        Start::Omega(_) => exact_difference([i[2], i[2], i[1], x[2]], [i[0], i[1], i[0], x[0]])
            .times(i[0])
            .times(i[2]),
    })
}

/// The same rounded to a double.
fn rounded_separation(i: [f64; 3], order: [usize; 3], start: Start) -> f64 {
    separation::<DoubleDouble>(i, order, start).value()
}

/// a (b − c) d² for the first four less the same for the second four, to 106 bits whatever cancels.
fn exact_difference(minuend: [f64; 4], subtrahend: [f64; 4]) -> Extended {
    let (third, exponent) = expansion(minuend);
    let (first, other) = expansion(subtrahend);
    let shift = Extended::power_of_two(other - exponent);
    let mut terms = [0.0; 32];
    for k in 0..16 {
        terms[k] = third[k];
        terms[k + 16] = -first[k] * shift;
    }
    // Error-free sums leave ever smaller remainders in front: after four rounds nothing of the first 200 bits is missing.
    for _ in 0..4 {
        for k in 1..32 {
            let sum = DoubleDouble::sum(terms[k], terms[k - 1]);
            terms[k] = sum.high();
            terms[k - 1] = sum.low();
        }
    }
    let total = terms.iter().fold(DoubleDouble::from(0.0), |sum, term| {
        sum.add(DoubleDouble::from(*term))
    });
    let mut result = Extended::from(total);
    if !result.is_zero() {
        result.exponent += exponent;
    }
    result
}

/// a (b − c) d² as sixteen doubles and a power of two, exactly.
fn expansion([a, b, c, d]: [f64; 4]) -> ([f64; 16], i32) {
    let (a, d) = (Extended::from_double(a), Extended::from_double(d));
    let difference = Extended::difference(b, c);
    let square = DoubleDouble::product(d.digits.high(), d.digits.high());
    let mut terms = [0.0; 16];
    let mut place = 0;
    for part in [difference.digits.high(), difference.digits.low()] {
        let product = DoubleDouble::product(a.digits.high(), part);
        for x in [product.high(), product.low()] {
            for y in [square.high(), square.low()] {
                let exact = DoubleDouble::product(x, y);
                terms[place] = exact.high();
                terms[place + 1] = exact.low();
                place += 2;
            }
        }
    }
    (terms, a.exponent + difference.exponent + 2 * d.exponent)
}

/// The constants along renumbered axes; `sense` is the sign of du/dt.
fn constants<N: Scalar>(
    axes: Renumbering,
    i: [f64; 3],
    l: [N; 3],
    c: [N; 3],
    distance: N,
    sense: f64,
) -> Constants {
    let l = [
        l[0].signed(axes.sign[0]),
        l[1].signed(axes.sign[1]),
        l[2].signed(axes.sign[2]),
    ];
    let squares = [l[0].square(), l[1].square(), l[2].square()];
    // Sums of terms of one sign stand in for L² − 2EI and 2EI − L².
    let steady = c[2].multiply(squares[1]).add(c[1].multiply(squares[2]));
    let wobble = c[1].multiply(squares[0]).add(c[0].multiply(squares[1]));
    let size_squared = squares[0].add(squares[1]).add(squares[2]);
    let frequency = c[0].multiply(steady);
    let m = c[2].multiply(wobble).divide(frequency);
    let mc = c[1].multiply(distance).divide(frequency);
    let volume = N::from_double(i[0]).times(i[1]).times(i[2]);
    let lambda = frequency.square_root().divide(volume);
    let base = size_squared.square_root().divide(N::from_double(i[1]));

    let side = if m.exceeds(mc) {
        Side::Hyperbolic
    } else {
        Side::Circular
    };
    let (lesser, greater) = match side {
        Side::Circular => (m, mc),
        Side::Hyperbolic => (mc, m),
    };
    let landen = Landen::new(lesser, greater.narrow().square_root());
    let one = N::from_double(1.0);
    let k_prime = mc.root_of_quotient(one);
    let parameter = Parameter::from_both(m.narrow().two(), mc.narrow().two());
    let modulus = Modulus::from_landen(side, parameter, k_prime, &landen);
    let aspect = c[0].root_of_quotient(c[1]);
    let elevation = elevation(steady, wobble, size_squared, &c);
    let turning = match side {
        Side::Circular => Turning::circular(&landen, &elevation, m, aspect),
        Side::Hyperbolic => Turning::hyperbolic(&landen, &elevation, mc, aspect),
    };
    let amplitudes = [
        wobble.root_of_quotient(c[1]),
        wobble.root_of_quotient(c[0]),
        steady.root_of_quotient(c[1]),
    ];
    let start = start(&squares, &c, wobble, steady, mc, &modulus, &landen);
    let rate = lambda.signed(sense);
    let excess = rate.multiply(N::from_narrow(N::Narrow::from_two(turning.excess)));
    Constants {
        axes,
        modulus,
        start: if l[1].leading() < 0.0 {
            start.negated()
        } else {
            start
        },
        rate: rate.narrow().two(),
        amplitudes,
        turning,
        turning_rate: base.subtract(excess.negated()).narrow().two(),
    }
}

/// η or ξ, whichever is the smaller: sc η = P₃/P₁ against sc ξ = √(c₁/c₃).
fn elevation<N: Scalar>(steady: N, wobble: N, size_squared: N, c: &[N; 3]) -> Elevation<N> {
    if c[0].multiply(wobble).exceeds(c[2].multiply(steady)) {
        Elevation {
            which: Which::Eta,
            rise: steady,
            run: wobble,
            slope: c[1].multiply(size_squared),
        }
    } else {
        Elevation {
            which: Which::Xi,
            rise: c[0],
            run: c[2],
            slope: c[1],
        }
    }
}

/// |u| at time 0, between 0 and K, from cn² = L₁²c₂/wobble, sn² = L₂²c₁/wobble and dn² = L₃²c₂/steady there.
fn start<N: Scalar>(
    squares: &[N; 3],
    c: &[N; 3],
    wobble: N,
    steady: N,
    mc: N,
    modulus: &Modulus,
    landen: &Landen<N>,
) -> DoubleDouble {
    let (cn2, sn2) = (squares[0].multiply(c[1]), squares[1].multiply(c[0]));
    let dn2 = squares[2].multiply(c[1]);
    // Beyond the middle of the quarter period, where mc sn⁴ > cn⁴, count from its end: there sn is cn/dn and dn is k′/dn.
    let from_end = mc.multiply(sn2.square()).exceeds(cn2.square());
    let rest = match modulus.side() {
        Side::Circular => {
            let [s, d] = if from_end {
                [
                    cn2.multiply(steady).root_of_quotient(dn2.multiply(wobble)),
                    mc.multiply(steady).root_of_quotient(dn2),
                ]
            } else {
                [sn2.root_of_quotient(wobble), dn2.root_of_quotient(steady)]
            };
            N::from_double(landen.nearest_sine(s, d, 1.0).asin())
        }
        Side::Hyperbolic => {
            let [s, d] = if from_end {
                [
                    cn2.root_of_quotient(mc.multiply(sn2)),
                    wobble.root_of_quotient(sn2),
                ]
            } else {
                [
                    sn2.root_of_quotient(cn2),
                    dn2.multiply(wobble).root_of_quotient(cn2.multiply(steady)),
                ]
            };
            let sinh = landen.nearest_sine(s, d, -1.0);
            N::from_narrow(N::from_double(sinh + sinh.hypot(1.0)).logarithm())
        }
    }
    .divide(N::from_narrow(landen.mean))
    .narrow()
    .two();
    if from_end {
        modulus.quarter_period_dd().subtract(rest)
    } else {
        rest
    }
}
