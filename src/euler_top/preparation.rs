//! The regime and the constants of the motion, from the moments and the start, in 106 bits and without cancellation (tutorial 6.3, 6.6).

use nalgebra::Vector3;

use super::evaluation::{Constants, Renumbering};
use crate::elliptic::Side;
use crate::elliptic::lanes::Course;
use crate::elliptic::modulus::{Descent, Squares};
use crate::elliptic::theta::{Elevation, Turning};
use crate::error::{Result, refused};
use crate::precise::{
    DoubleDouble, Extended, Number, RIGHT_ANGLE, exponent_of, power_of_two_below, sum_of_products,
};
use crate::search::ascending;

/// What kind of motion a free top makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Regime {
    /// L = 0: nothing moves.
    AtRest,
    /// All moments equal: Ω is constant (6.4).
    Sphere,
    /// One moment is zero: a rod, which turns steadily about L. Its angular velocity along itself has no meaning and is returned as zero.
    Rod,
    /// L along a principal axis, or in the plane of the equal moments of a symmetric top: Ω is constant (6.2).
    PermanentRotation,
    /// Two moments equal: Ω circles the axis of the third (6.5).
    Symmetric,
    /// L² < 2EI₂: L circles the axis of the smallest moment (6.6).
    AroundSmallest,
    /// L² > 2EI₂: L circles the axis of the largest moment (6.6).
    AroundLargest,
    /// L² = 2EI₂ exactly: from one end of the middle axis to the other, once, without return (6.6).
    Separatrix,
}

/// The start of a motion: L or Ω as given along the body's axes, taken as exact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    pub(super) quantity: Quantity,
    pub(super) components: [f64; 3],
}

/// The vector whose components are given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Quantity {
    /// L, kg m²/s.
    AngularMomentum,
    /// Ω, rad/s.
    Omega,
}

impl Start {
    /// L, to 106 bits: the product of a moment and an angular velocity is not rounded.
    pub(super) fn angular_momentum<N: Number>(self, moments: [f64; 3]) -> [N; 3] {
        core::array::from_fn(|k| {
            let component = N::from_double(self.components[k]);
            match self.quantity {
                Quantity::AngularMomentum => component,
                Quantity::Omega => component.times(moments[k]),
            }
        })
    }

    /// Refuses a rod with L along itself, and one whose other two moments differ.
    pub(super) fn refuse_impossible_rod(&self, moments: [f64; 3]) -> Result<()> {
        let [first, middle, last] = ascending([0, 1, 2], &moments);
        if moments[first] > 0.0 {
            return Ok(());
        }
        let spin = (0..3).find(|&k| moments[k] == 0.0 && self.components[k] != 0.0);
        if let (Quantity::AngularMomentum, Some(axis)) = (self.quantity, spin) {
            let condition = "the angular momentum about an axis whose moment is zero must be zero";
            return refused(condition, self.components[axis]);
        }
        let gap = moments[last] - moments[middle];
        if gap > 8.0 * f64::EPSILON * moments[last] {
            let condition = "if one moment is zero, the difference of the other two must be zero";
            return refused(condition, gap);
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

/// The differences 1/I_i − 1/I_j, all multiplied by I₁I₂I₃, from exact differences: c₁ = I₁(I₃ − I₂), c₂ = I₂(I₃ − I₁), c₃ = I₃(I₂ − I₁),
/// for ascending moments.
pub(super) fn differences<N: Number>(i: [f64; 3]) -> [N; 3] {
    [
        N::difference(i[2], i[1]).times(i[0]),
        N::difference(i[2], i[0]).times(i[1]),
        N::difference(i[1], i[0]).times(i[2]),
    ]
}

/// (L² − 2EI₂) I₁I₃ from exact products, so that no bit is lost however much cancels; `order` is that of the ascending moments `i`.
fn separation<N: Number>(i: [f64; 3], order: [usize; 3], start: Start) -> N {
    let x = order.map(|k| start.components[k]);
    let sum = |a: f64, b: f64| {
        sum_of_products(&[
            [a, i[2], x[2], x[2]],
            [-a, i[1], x[2], x[2]],
            [-b, i[1], x[0], x[0]],
            [b, i[0], x[0], x[0]],
        ])
    };
    let exact = match start.quantity {
        Quantity::AngularMomentum => sum(i[0], i[2]),
        Quantity::Omega => sum(i[2], i[0]).times(i[0]).times(i[2]),
    };
    exact.as_number()
}

/// 2⁻²⁰⁰: the fourth power of a greater number is a normal double.
const FAR_BELOW: f64 = 6.223_015_277_861_142e-61;

/// The regime of the motion, decided here once from exact differences, and its constants if Ω moves in the body.
pub(super) fn decide(moments: [f64; 3], start: Start) -> (Regime, Option<Constants>) {
    // Scaling by powers of two rounds nothing; then no square overflows or underflows, unless the numbers are far apart.
    let unit_of = |values: [f64; 3]| power_of_two_below(Vector3::from(values).amax());
    let (unit_of_moments, unit) = (unit_of(moments), unit_of(start.components));
    let near = |x: f64, unit: f64| x == 0.0 || x.abs() > unit * FAR_BELOW;
    let close = moments.iter().all(|x| near(*x, unit_of_moments))
        && start.components.iter().all(|x| near(*x, unit));
    if !close {
        return decide_with::<Extended>(moments, start);
    }
    let scaled = Start {
        components: start.components.map(|x| x / unit),
        ..start
    };
    let moments = moments.map(|i| i / unit_of_moments);
    let (regime, mut constants) = decide_with::<DoubleDouble>(moments, scaled);
    let (momentum, exponent) = match start.quantity {
        Quantity::AngularMomentum => (unit, exponent_of(unit) - exponent_of(unit_of_moments)),
        Quantity::Omega => (unit * unit_of_moments, exponent_of(unit)),
    };
    if let Some(constants) = &mut constants {
        for rate in [&mut constants.course.rate, &mut constants.turning_rate] {
            *rate = DoubleDouble::from_parts(*rate, exponent);
        }
        constants.amplitudes = constants.amplitudes.map(|part| part * momentum);
    }
    (regime, constants)
}

fn decide_with<N: Number>(moments: [f64; 3], start: Start) -> (Regime, Option<Constants>) {
    decide_from(moments, start.angular_momentum::<N>(moments), |i, order| {
        separation::<N>(i, order, start)
    })
}

/// The same from L along the axes. Where L does not determine (L² − 2EI₂) I₁I₃ well enough, `exactly` gives it, from the ascending moments and their order.
pub(super) fn decide_from<N: Number>(
    moments: [f64; 3],
    l: [N; 3],
    exactly: impl Fn([f64; 3], [usize; 3]) -> N,
) -> (Regime, Option<Constants>) {
    if l.iter().all(|component| component.is_zero()) {
        return (Regime::AtRest, None);
    }
    let order = ascending([0, 1, 2], &moments);
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
    let c = differences::<N>(i);
    // (L² − 2EI₂) I₁I₃ = c₁ L₃² − c₃ L₁²: its sign decides which axis L circles, its magnitude how close the separatrix is.
    let third = c[0] * l[order[2]].square();
    let mut separation = third - c[2] * l[order[0]].square();
    if !separation.magnitude().exceeds(third.times(1.0 / 1024.0)) {
        // More than ten of the 106 bits have cancelled.
        separation = exactly(i, order);
    }
    let sign = separation.leading();
    let regime = if i[0] == i[1] || i[1] == i[2] {
        Regime::Symmetric
    } else if sign < 0.0 {
        Regime::AroundSmallest
    } else if sign > 0.0 {
        Regime::AroundLargest
    } else {
        Regime::Separatrix
    };
    let (mut axis, mut c) = (order, c);
    if sign < 0.0 {
        axis.reverse();
        c.reverse();
    }
    let axes = Renumbering::new(axis, l.map(N::leading));
    let (i, l) = (axes.renumber(moments), axes.renumber(l));
    (regime, Some(constants(axes, i, l, c, separation)))
}

/// The constants along the renumbered axes; du/dt has the sign of the separation.
fn constants<N: Number>(
    axes: Renumbering,
    i: [f64; 3],
    l: [N; 3],
    c: [N; 3],
    separation: N,
) -> Constants {
    let squares = l.map(N::square);
    // L² − 2EI and 2EI − L² for the outer moments, as sums of terms of one sign.
    let steady = (c[2] * squares[1]).add_alike(c[1] * squares[2]);
    let wobble = (c[1] * squares[0]).add_alike(c[0] * squares[1]);
    let size_squared = squares[0].add_alike(squares[1]).add_alike(squares[2]);
    let frequency = c[0] * steady;
    let m = (c[2] * wobble).quotient(frequency);
    let mc = (c[1] * separation.magnitude()).quotient(frequency);
    let volume = N::from_double(i[0]).times(i[1]).times(i[2]);
    let lambda = frequency.square_root().quotient(volume);
    let base = size_squared.square_root().quotient(N::from_double(i[1]));

    let descent = Descent::new(m, mc);
    let aspect = c[0].root_of_quotient(c[1]);
    // sc η = √(c₁/c₃) against sc ξ = P₃/P₁.
    let elevation = Elevation::smaller([c[0], c[2], c[1]], [steady, wobble, c[1] * size_squared]);
    let mut turning = Turning::new(descent.modulus.side(), &descent.landen, &elevation);
    if descent.modulus.side() == Side::Hyperbolic {
        turning.lag = RIGHT_ANGLE - turning.lag;
    }
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
    let rate = lambda.signed(separation.leading());
    let slope = rate * N::from(turning.slope);
    Constants {
        axes,
        course: Course {
            modulus: descent.modulus,
            start: start.signed(f64::from(axes.sign[1]) * l[1].leading()),
            rate: rate.narrow(),
        },
        amplitudes: axes.signed(amplitudes),
        aspect,
        turning,
        turning_rate: (base + slope).narrow(),
    }
}
