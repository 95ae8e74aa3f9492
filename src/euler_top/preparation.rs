//! From moments and angular momentum to the constants of the motion, in 106 bits and without a cancellation (tutorial 6.6).

use super::evaluation::Constants;
use super::separation::{differences, rounded_separation, separation};
use super::start::{Digits, Renumbering, Start, ascending};
use super::turning::Turning;
use crate::elliptic::descent::{Descent, Squares};
use crate::elliptic::theta::{Elevation, Which};
use crate::precise::{
    DoubleDouble, Extended, Number, Words, exponent_of, power_of_two_below, shifted,
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

/// 2⁻²⁰⁰: the fourth power of what is above it is a normal double.
const FAR_BELOW: f64 = 6.223_015_277_861_142e-61;

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

fn decide_with<N: Number>(
    moments: [f64; 3],
    start: Start,
    separation: impl Fn([f64; 3], [usize; 3], Start) -> N,
) -> (Regime, Option<Constants>) {
    decide_from(moments, start.angular_momentum(moments), |i, order| {
        separation(i, order, start)
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
    // sc η = P₃/P₁ against sc ξ = √(c₁/c₃).
    let elevation = Elevation::smaller([steady, wobble], [c[0], c[2]], |which| match which {
        Which::Eta => c[1] * size_squared,
        Which::Xi => c[1],
    });
    let turning = Turning::new(&descent, &elevation, aspect);
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
    let excess = rate * N::from_narrow(N::Narrow::from_two(turning.excess));
    Constants {
        axes,
        modulus: descent.modulus,
        start: if l[1].leading() < 0.0 { -start } else { start },
        rate: rate.narrow().two(),
        amplitudes,
        turning,
        turning_rate: (base + excess).narrow().two(),
    }
}
