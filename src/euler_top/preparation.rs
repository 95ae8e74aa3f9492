//! From moments and a start to the regime and the constants of the motion, in 106 bits and without a cancellation (tutorial 6.3, 6.6).

use super::evaluation::{Constants, Renumbering};
use crate::elliptic::Side;
use crate::elliptic::lanes::Course;
use crate::elliptic::modulus::{Descent, Squares};
use crate::elliptic::turning::{Elevation, Turning, Which};
use crate::error::{Error, Result};
use crate::precise::{
    DoubleDouble, Extended, Number, RIGHT_ANGLE, exponent_of, power_of_two_below, shifted,
    sum_of_products,
};

/// What kind of motion a free top makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Regime {
    /// L = 0: nothing moves.
    AtRest,
    /// All moments equal: Ω stays (6.4).
    Sphere,
    /// One moment is zero: a rod, which turns steadily about L. Along itself it has no angular velocity to speak of; that component is returned as zero.
    Rod,
    /// L along a principal axis, or among the equal moments of a symmetric top: Ω stays (6.2).
    PermanentRotation,
    /// Two moments equal: Ω circles the axis of the third (6.5).
    Symmetric,
    /// L² < 2EI₂: L circles the axis of the smallest moment (6.6).
    AroundSmallest,
    /// L² > 2EI₂: L circles the axis of the largest moment (6.6).
    AroundLargest,
    /// L² = 2EI₂ exactly: one half turn over, from the middle axis to the middle axis, and no return (6.6).
    Separatrix,
}

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
    pub(super) fn angular_momentum<N: Number>(self, moments: [f64; 3]) -> [N; 3] {
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

    /// Whether a component of I Ω is not zero, though as a double it may be.
    pub(super) fn vanishes_by_rounding(self, moments: [f64; 3]) -> bool {
        match self {
            Self::AngularMomentum(_) => false,
            Self::Omega(omega) => omega
                .iter()
                .zip(moments)
                .any(|(component, moment)| *component != 0.0 && moment != 0.0),
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
    pub(super) fn with(self, components: [f64; 3]) -> Self {
        match self {
            Self::AngularMomentum(_) => Self::AngularMomentum(components),
            Self::Omega(_) => Self::Omega(components),
        }
    }

    /// A body on a line must not spin about that line, nor be a line in only one of two directions.
    pub(super) fn refuse_impossible_rod(&self, moments: [f64; 3]) -> Result<()> {
        let [first, middle, last] = ascending(moments);
        if moments[first] > 0.0 {
            return Ok(());
        }
        if let Start::AngularMomentum(l) = self {
            for (moment, component) in moments.iter().zip(l) {
                if *moment == 0.0 && *component != 0.0 {
                    return Err(Error::Condition {
                        condition: "the angular momentum about an axis whose moment is zero must be zero",
                        value: *component,
                    });
                }
            }
        }
        let gap = moments[last] - moments[middle];
        if gap > 8.0 * f64::EPSILON * moments[last] {
            return Err(Error::Condition {
                condition: "if one moment is zero, the difference of the other two must be zero",
                value: gap,
            });
        }
        Ok(())
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

/// The order of the moments, ascending.
pub(super) fn ascending(moments: [f64; 3]) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    order
}

/// 1/I_i − 1/I_j all multiplied by I₁I₂I₃, from exact differences: c₁ = I₁(I₃ − I₂), c₂ = I₂(I₃ − I₁), c₃ = I₃(I₂ − I₁),
/// for ascending moments.
pub(super) fn differences<N: Number>(i: [f64; 3]) -> [N; 3] {
    [
        N::difference(i[2], i[1]).times(i[0]),
        N::difference(i[2], i[0]).times(i[1]),
        N::difference(i[1], i[0]).times(i[2]),
    ]
}

/// (L² − 2EI₂) I₁I₃ = c₁ L₃² − c₃ L₁²: its sign decides about which axis L goes, its size how close the separatrix is.
pub(super) fn separation<N: Number>(i: [f64; 3], order: [usize; 3], start: Start) -> N {
    let x = order.map(|k| start.components()[k]);
    let l: [N; 3] = start.with(x).angular_momentum(i);
    let c = differences::<N>(i);
    let third = c[0] * l[2].square();
    let first = c[2] * l[0].square();
    let difference = third - first;
    let scale = third.times(1.0 / 1024.0);
    if difference.magnitude().exceeds(scale) {
        return difference;
    }
    // More than ten of the 106 bits have cancelled; from the exact products none is lost.
    let sum = |a: f64, b: f64| {
        sum_of_products(&[
            [a, i[2], x[2], x[2]],
            [-a, i[1], x[2], x[2]],
            [-b, i[1], x[0], x[0]],
            [b, i[0], x[0], x[0]],
        ])
    };
    N::from_extended(match start {
        Start::AngularMomentum(_) => sum(i[0], i[2]),
        Start::Omega(_) => sum(i[2], i[0]).times(i[0]).times(i[2]),
    })
}

/// 2⁻²⁰⁰: the fourth power of what is above it is a normal double.
const FAR_BELOW: f64 = 6.223_015_277_861_142e-61;

impl Constants {
    /// From a motion whose unit of L was `momentum` and whose unit of rates 2^`exponent`.
    fn put_in_units(&mut self, (momentum, exponent): (f64, i32)) {
        let scaled = |x: DoubleDouble| {
            DoubleDouble::sum(shifted(x.high(), exponent), shifted(x.low(), exponent))
        };
        self.course.rate = scaled(self.course.rate);
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

/// What kind of motion it is: decided here, once, by exact differences.
///
/// Returns the constants too if Ω moves.
pub(super) fn decide(moments: [f64; 3], start: Start) -> (Regime, Option<Constants>) {
    // Powers of two are taken off without rounding; then no square overflows or underflows, unless the numbers are far apart.
    let (unit_of_moments, unit) = (unit(moments), unit(start.components()));
    let near = |x: f64, unit: f64| x == 0.0 || x.abs() > unit * FAR_BELOW;
    let tame = moments.iter().all(|x| near(*x, unit_of_moments))
        && start.components().iter().all(|x| near(*x, unit));
    if !tame {
        return decide_with::<Extended>(moments, start);
    }
    let scaled = start.with(start.components().map(|x| x / unit));
    let moments = moments.map(|i| i / unit_of_moments);
    let (regime, mut constants) = decide_with::<DoubleDouble>(moments, scaled);
    let units = match start {
        Start::AngularMomentum(_) => (unit, exponent_of(unit) - exponent_of(unit_of_moments)),
        Start::Omega(_) => (unit * unit_of_moments, exponent_of(unit)),
    };
    if let Some(constants) = &mut constants {
        constants.put_in_units(units);
    }
    (regime, constants)
}

fn decide_with<N: Number>(moments: [f64; 3], start: Start) -> (Regime, Option<Constants>) {
    decide_from(moments, start.angular_momentum::<N>(moments), |i, order| {
        separation::<N>(i, order, start)
    })
}

/// From L along the axes and (L² − 2EI₂) I₁I₃ of the ascending moments in that order.
pub(super) fn decide_from<N: Number>(
    moments: [f64; 3],
    l: [N; 3],
    separation: impl Fn([f64; 3], [usize; 3]) -> N,
) -> (Regime, Option<Constants>) {
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
    let separation = separation(i, order);
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
        ([c[2], c[1], c[0]], -separation, -1.0)
    } else {
        (c, separation, 1.0)
    };
    let axes = Renumbering::new(axis, l.map(N::leading));
    let l = axes.there(l);
    (
        regime,
        Some(constants(axes, axes.there(moments), l, c, distance, sense)),
    )
}

/// The constants along renumbered axes; `sense` is the sign of du/dt.
fn constants<N: Number>(
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
    let steady = (c[2] * squares[1]).add_alike(c[1] * squares[2]);
    let wobble = (c[1] * squares[0]).add_alike(c[0] * squares[1]);
    let size_squared = squares[0].add_alike(squares[1]).add_alike(squares[2]);
    let frequency = c[0] * steady;
    let m = (c[2] * wobble).quotient(frequency);
    let mc = (c[1] * distance).quotient(frequency);
    let volume = N::from_double(i[0]).times(i[1]).times(i[2]);
    let lambda = frequency.square_root().quotient(volume);
    let base = size_squared.square_root().quotient(N::from_double(i[1]));

    let descent = Descent::new(m, mc);
    let aspect = c[0].root_of_quotient(c[1]);
    // sc η = √(c₁/c₃) against sc ξ = P₃/P₁.
    let elevation = Elevation::smaller([c[0], c[2]], [steady, wobble], |which| match which {
        Which::Eta => c[1],
        Which::Xi => c[1] * size_squared,
    });
    let turning = Turning::new(&descent, &elevation);
    let lag = match descent.side() {
        Side::Circular => DoubleDouble::from(0.0),
        Side::Hyperbolic => RIGHT_ANGLE - turning.lag,
    };
    let amplitudes = [
        wobble.root_of_quotient(c[1]),
        wobble.root_of_quotient(c[0]),
        steady.root_of_quotient(c[1]),
    ];
    let start = descent.argument(&Squares {
        sn: squares[1] * c[0],
        cn: squares[0] * c[1],
        whole: wobble,
        dn: squares[2] * c[1],
        dn_whole: steady,
    });
    let rate = lambda.signed(sense);
    let slope = rate * N::from(turning.slope);
    Constants {
        axes,
        course: Course {
            modulus: descent.modulus,
            start: if l[1].leading() < 0.0 { -start } else { start },
            rate: rate.narrow(),
        },
        amplitudes,
        aspect,
        turning,
        lag,
        turning_rate: (base + slope).narrow(),
    }
}
