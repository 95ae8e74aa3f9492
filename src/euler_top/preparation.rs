//! From moments and angular momentum to the constants of the motion, in 106 bits and without a cancellation (tutorial 6.6).

use super::motion::Regime;
use super::turning::{Elevation, Turning, Which};
use crate::double_double::DoubleDouble;
use crate::elliptic::landen::Landen;
use crate::elliptic::{Modulus, Parameter, Side};
use crate::extended::{Extended, logarithm};

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
    pub(super) fn angular_momentum(self, moments: [f64; 3]) -> [Extended; 3] {
        match self {
            Self::AngularMomentum(l) => l.map(Extended::from_double),
            Self::Omega(omega) => {
                core::array::from_fn(|k| Extended::from_double(omega[k]).times(moments[k]))
            }
        }
    }
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

/// 1/I_i − 1/I_j all multiplied by I₁I₂I₃, from exact differences: c₁ = I₁(I₃ − I₂), c₂ = I₂(I₃ − I₁), c₃ = I₃(I₂ − I₁),
/// for ascending moments.
fn differences(i: [f64; 3]) -> [Extended; 3] {
    [
        Extended::difference(i[2], i[1]).times(i[0]),
        Extended::difference(i[2], i[0]).times(i[1]),
        Extended::difference(i[1], i[0]).times(i[2]),
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
pub(super) fn decide(moments: [f64; 3], start: Start) -> (Regime, Option<Constants>) {
    let l = start.angular_momentum(moments);
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
    let separation = separation(i, order, start, &l, &c);
    let sign = separation.digits.high();
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
fn separation(
    i: [f64; 3],
    order: [usize; 3],
    start: Start,
    l: &[Extended; 3],
    c: &[Extended; 3],
) -> Extended {
    let third = c[0].multiply(l[order[2]].square());
    let first = c[2].multiply(l[order[0]].square());
    let difference = third.subtract(first);
    let scale = third.times(2f64.powi(-10));
    if difference.magnitude().exceeds(scale) {
        return difference;
    }
    // More than ten of the 106 bits have cancelled; from the exact products none is lost.
    let x = order.map(|k| start.components()[k]);
    match start {
        Start::AngularMomentum(_) => {
            exact_difference([i[0], i[2], i[1], x[2]], [i[2], i[1], i[0], x[0]])
        }
        Start::Omega(_) => exact_difference([i[2], i[2], i[1], x[2]], [i[0], i[1], i[0], x[0]])
            .times(i[0])
            .times(i[2]),
    }
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
fn constants(
    axes: Renumbering,
    i: [f64; 3],
    l: [Extended; 3],
    c: [Extended; 3],
    distance: Extended,
    sense: f64,
) -> Constants {
    let l: [Extended; 3] = core::array::from_fn(|k| l[k].signed(axes.sign[k]));
    let squares = l.map(Extended::square);
    // Sums of terms of one sign stand in for L² − 2EI and 2EI − L².
    let steady = c[2].multiply(squares[1]).add(c[1].multiply(squares[2]));
    let wobble = c[1].multiply(squares[0]).add(c[0].multiply(squares[1]));
    let size_squared = squares[0].add(squares[1]).add(squares[2]);
    let frequency = c[0].multiply(steady);
    let m = c[2].multiply(wobble).divide(frequency);
    let mc = c[1].multiply(distance).divide(frequency);
    let volume = Extended::from_double(i[0]).times(i[1]).times(i[2]);
    let lambda = frequency.square_root().divide(volume);
    let base = size_squared
        .square_root()
        .divide(Extended::from_double(i[1]));

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
    let k_prime = mc.nearest_square_root();
    let parameter = Parameter::from_both(m.narrow(), mc.narrow());
    let modulus = Modulus::from_landen(side, parameter, k_prime, &landen);
    let aspect = c[0].divide(c[1]).nearest_square_root();
    let elevation = elevation(steady, wobble, size_squared, &c);
    let turning = match side {
        Side::Circular => Turning::circular(&landen, &elevation, m, aspect),
        Side::Hyperbolic => Turning::hyperbolic(&landen, &elevation, mc, aspect),
    };
    let amplitudes = [
        wobble.divide(c[1]).nearest_square_root(),
        wobble.divide(c[0]).nearest_square_root(),
        steady.divide(c[1]).nearest_square_root(),
    ];
    let phase = [
        squares[0].multiply(c[1]).divide(wobble),
        squares[1].multiply(c[0]).divide(wobble),
        squares[2].multiply(c[1]).divide(steady),
    ];
    let start = start(phase, mc, &modulus, &landen);
    let rate = lambda.signed(sense);
    let excess = rate.multiply(Extended::from(turning.excess));
    Constants {
        axes,
        modulus,
        start: if l[1].digits.high() < 0.0 {
            start.negated()
        } else {
            start
        },
        rate: rate.narrow(),
        amplitudes,
        turning,
        turning_rate: base.add(excess).narrow(),
    }
}

/// η or ξ, whichever is the smaller: sc η = P₃/P₁ against sc ξ = √(c₁/c₃).
fn elevation(
    steady: Extended,
    wobble: Extended,
    size_squared: Extended,
    c: &[Extended; 3],
) -> Elevation {
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

/// |u| at time 0, from (cn², sn², dn²) there: between 0 and K.
fn start(
    [cn2, sn2, dn2]: [Extended; 3],
    mc: Extended,
    modulus: &Modulus,
    landen: &Landen,
) -> DoubleDouble {
    // Beyond the middle of the quarter period count from its end: cn²/dn² and mc/dn² are the squares of sn and dn there.
    let from_end = mc.multiply(sn2.square()).exceeds(cn2.square());
    let rest = match modulus.side() {
        Side::Circular => {
            let (s2, d2) = if from_end {
                (cn2.divide(dn2), mc.divide(dn2))
            } else {
                (sn2, dn2)
            };
            let sine = landen.nearest_sine(s2.nearest_square_root(), d2.nearest_square_root(), 1.0);
            DoubleDouble::from(sine.asin())
        }
        Side::Hyperbolic => {
            let (s2, d2) = if from_end {
                (cn2.divide(mc.multiply(sn2)), sn2.inverse())
            } else {
                (sn2.divide(cn2), dn2.divide(cn2))
            };
            let sinh =
                landen.nearest_sine(s2.nearest_square_root(), d2.nearest_square_root(), -1.0);
            let exponential = sinh + sinh.hypot(1.0);
            logarithm(Extended::from_double(exponential))
        }
    }
    .divide(landen.mean);
    if from_end {
        modulus.quarter_period_dd().subtract(rest)
    } else {
        rest
    }
}
