//! 6.6: tops from L² and E, and the separatrix reached exactly.

use super::*;

const BODIES: [[f64; 3]; 5] = [
    [1.0, 2.0, 3.0],
    [0.3, 0.5, 0.7],
    [0.7, 0.3, 0.5],
    [2.1e-7, 1.9e-7, 2.0e-7],
    [1e20, 1.0000001e20, 1.9e20],
];

fn beside(moments: [f64; 3], energy: f64, distance: f64) -> EulerTop {
    EulerTop::beside_separatrix(moments, energy, distance, Attitude::identity()).unwrap()
}

fn from(moments: [f64; 3], square: f64, energy: f64) -> Result<EulerTop> {
    EulerTop::from_integrals(moments, square, energy, Attitude::identity())
}

/// L along the axes of the ascending moments.
fn along(i: [f64; 3], l: BodyVector) -> [f64; 3] {
    let l = l.components();
    ascending(i).map(|k| l[k])
}

/// L = (P₁ sech λt, ±|L| tanh λt, P₃ sech λt), λ² = 2E(I₂ − I₁)(I₃ − I₂)/(I₁I₂I₃), until it underflows, whatever the body and the energy.
#[test]
fn s6_6_the_separatrix_of_every_body_down_to_underflow() {
    for moments in BODIES {
        let [i1, i2, i3] = sorted(moments);
        for energy in [1.0, 0.1, 7e-9] {
            let top = beside(moments, energy, 0.0);
            assert_eq!(top.regime(), Regime::Separatrix);
            assert_eq!(top.period(), f64::INFINITY);
            let rate = (2.0 * energy * ((i2 - i1) / i1) * ((i3 - i2) / i3) / i2).sqrt();
            let size = (2.0 * energy * i2).sqrt();
            let first = (2.0 * energy * i1 * ((i3 - i2) / (i3 - i1))).sqrt();
            let third = (2.0 * energy * i3 * ((i2 - i1) / (i3 - i1))).sqrt();
            for turned in [0.0, 0.5, -2.0, 30.0, -300.0, 650.0] {
                let t = turned / rate;
                let (cosh, tanh) = ((rate * t).cosh(), (rate * t).tanh());
                let [x, y, z] = along(moments, at(&top, t).angular_momentum);
                // Observed: 9e-14 at 650, the rounding of λt.
                let expected = [first / cosh, size * tanh.abs(), third / cosh];
                for (found, expected) in [x, y.abs(), z].into_iter().zip(expected) {
                    within((found - expected).abs(), 3e-13 * expected);
                }
            }
        }
    }
    // A power of two as energy makes 2EI₂ a double.
    for moments in BODIES {
        let [_, middle, _] = sorted(moments);
        for (square, regime) in [
            (middle, Regime::Separatrix),
            (middle.next_up(), Regime::AroundLargest),
            (middle.next_down(), Regime::AroundSmallest),
        ] {
            assert_eq!(from(moments, square, 0.5).unwrap().regime(), regime);
        }
    }
}

/// 4K(m)/λ with 1 − m = (I₃ − I₁)d/((I₃ − I₂)(L² − 2EI₁)) and λ² = (I₃ − I₂)(L² − 2EI₁)/(I₁I₂I₃) for L² = 2EI₂ + d > 2EI₂, and 1, 3 exchanged below.
#[test]
fn s6_6_the_way_to_the_separatrix() {
    let [i1, i2, i3] = [1.0, 2.0, 3.0];
    let energy = 0.75;
    for d in [1e-3, 1e-8, f64::EPSILON, 1e-30, 1e-100, 1e-300] {
        for (distance, [least, greatest]) in [(d, [i1, i3]), (-d, [i3, i1])] {
            let top = beside([i1, i2, i3], energy, distance);
            let over = (2.0 * energy * (i2 - least) + distance).abs();
            let mc = (greatest - least).abs() * d / ((greatest - i2).abs() * over);
            let rate = ((greatest - i2).abs() * over / (i1 * i2 * i3)).sqrt();
            let quarter = Modulus::new(Parameter::from_complement(mc).unwrap()).quarter_period();
            close!(top.period() * rate, 4.0 * quarter, 0.0..=1e-15);
        }
    }
}

/// What was given is kept at any time; at time 0 L is in the plane of the outer axes.
#[test]
fn s6_6_any_integrals_are_kept() {
    let mut numbers = Uniform(66);
    for _ in 0..2000 {
        let (a, b) = (0.2 + numbers.next(), 0.2 + numbers.next());
        let third = (a - b).abs() + (a + b - (a - b).abs()) * numbers.next();
        let i = [a, b, third];
        let [least, _, greatest] = sorted(i);
        let energy = 5.0 * numbers.next();
        let square = 2.0 * energy * (least + (greatest - least) * numbers.next());
        let top = from(i, square, energy).unwrap();
        let [x, y, z] = along(i, at(&top, 0.0).angular_momentum);
        assert!(x >= 0.0 && z >= 0.0 && y == 0.0, "{x} {y} {z}");
        for t in [0.0, 1.3, -20.0] {
            let state = at(&top, t);
            let l2 = state.angular_momentum.dot(&state.angular_momentum);
            let e = 0.5 * state.omega.dot(&state.angular_momentum);
            // Observed: 9e-16.
            let off = (l2 / square - 1.0).abs().max((e / energy - 1.0).abs());
            observed!(off, 3e-16..=3e-15);
        }
    }
}

#[test]
fn s6_6_the_ends_and_what_lies_beyond() {
    let body = [1.0, 2.0, 2.5];
    for (square, axis) in [
        (2.0, [2f64.sqrt(), 0.0, 0.0]),
        (5.0, [0.0, 0.0, 5f64.sqrt()]),
    ] {
        let steady = from(body, square, 1.0).unwrap();
        assert_eq!(steady.regime(), Regime::PermanentRotation);
        let l: [f64; 3] = at(&steady, 3.0).angular_momentum.components().into();
        assert_eq!(l, axis);
    }
    let round = from([1.0, 1.0, 1.5], 2.5, 1.0).unwrap();
    assert_eq!(round.regime(), Regime::Symmetric);
    let sphere = from([4.0; 3], 24.0, 3.0).unwrap();
    assert_eq!(sphere.regime(), Regime::Sphere);
    close!(at(&sphere, 1.0).omega.norm(), 1.5f64.sqrt(), 3e-16);
    assert_eq!(from(body, 0.0, 0.0).unwrap().regime(), Regime::AtRest);
    for (i, square, energy) in [
        (body, 2f64.next_down(), 1.0),
        (body, 5f64.next_up(), 1.0),
        (body, 0.0, 1e-300),
        (body, 5e-324, 0.0),
        ([1.0; 3], 2f64.next_up(), 1.0),
    ] {
        let refused = from(i, square, energy);
        let Err(Error::Condition { value, .. }) = refused else {
            panic!("{refused:?}")
        };
        assert_eq!(value, square);
    }
    for bad in [f64::NAN, f64::INFINITY] {
        refused!(from(body, bad, 1.0), NotFinite);
        refused!(from(body, 1.0, bad), NotFinite);
    }
    refused!(from(body, -1.0, 1.0), Negative);
    refused!(from([0.0, 1.0, 1.0], 1.0, 1.0), NotPositive);
    refused!(from([1.0, 1.0, 3.0], 3.0, 1.0), TriangleInequality);
}

/// The top with 2E = 1 and a given L²/2EI₁, at the moment when Ω₂ = 0.
#[test]
fn the_mode_of_an_asteroid_is_one_number() {
    use spinning_bodies::euler_top::toutatis::mode;
    let moments = [1.0, 3.09, 3.22];
    // Nearly round: I₃/I₁ has seven digits next to 1, and 2E has all.
    let round = mode([0.7, 0.7 + 1e-9, 0.7 + 2e-9], 1.0 + 1e-9).unwrap();
    assert!((round.energy() - 0.5).abs() < 1e-15);
    for ratio in [1.0, 1.3, 1.6977, 3.0, 3.15, 3.22] {
        let top = mode(moments, ratio).unwrap();
        let l = top.at(0.0).unwrap().angular_momentum.components();
        let twice_energy = (l.x * l.x / moments[0]) + l.z * l.z / moments[2];
        assert!((twice_energy - 1.0).abs() < 1e-15 && l.y == 0.0, "{ratio}");
        assert!((l.norm_squared() - ratio).abs() < 2e-15, "{ratio}");
    }
    refused!(mode(moments, 3.23), OutOfRange);
    refused!(mode([1.0, 3.0, 2.0], 1.2), Condition);
}

#[test]
fn a_rod_is_a_line_in_both_directions() {
    let top = |moments, l| EulerTop::beyond_bodies(moments, vector(l), Attitude::identity());
    assert!(top([0.0, 1.0, 1.0], [0.0, 1.0, 2.0]).is_ok());
    refused!(top([0.0, 1.0, 1.0], [1e-300, 1.0, 2.0]), Condition);
    refused!(top([0.0, 1.0, 1.0 + 3e-15], [0.0, 1.0, 2.0]), Condition);
    refused!(top([0.0, 1.0, 1.5], [0.0, 1.0, 2.0]), Condition);
}

#[test]
fn a_ball_has_no_pace_along_a_polhode() {
    let ball = Poinsot::new([2.0; 3], vector([1.0, -2.0, 3.0])).unwrap();
    assert_eq!(ball.pace(0.3), 0.0);
}
