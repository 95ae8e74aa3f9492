//! Section 1: what a body does to itself. Sliding, swivelling, falling cats of flesh and of paper, the skater.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, FRAC_PI_8, PI, TAU};

use approx::assert_relative_eq;
use spinning_bodies::conservation::{Law, Ledger};
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::inertia::InertiaMatrix;
use spinning_bodies::integrators::{Effort, Method, solve};
use spinning_bodies::phenomena::cat::{Bend, Cat, EqualHalves, Half};
use spinning_bodies::phenomena::crawler::{self, Strokes};
use spinning_bodies::phenomena::holonomy::{Hub, ShapePlane, Step, turn_along, turn_within};
use spinning_bodies::phenomena::ice::{PARTS, Part, Wriggler, feet};
use spinning_bodies::phenomena::skater::Skater;
use spinning_bodies::phenomena::{PaperCat, Swivel, Waist, quadrature};
use spinning_bodies::scene::{Request, Scene, shape};

const DEFAULT: Waist = Waist {
    upper_arms_out: 2.0,
    upper_arms_in: 0.7,
    lower: 0.6,
};

// claim: C1.1-1
#[test]
fn s1_1_no_wriggling_moves_the_centre() {
    for seed in 0..20 {
        let body = Wriggler::random(seed);
        let times: Vec<f64> = (0..=60).map(|k| f64::from(k) * 0.1).collect();
        let start = body.start();
        let run = solve(
            &body,
            0.0,
            start,
            &[1.0; 4 * PARTS],
            &times,
            Method::Dop853,
            Effort::Tolerance(1e-10),
        )
        .unwrap();
        let center = body.center(start);
        let mut travelled = 0.0_f64;
        for state in &run.states {
            let now = body.center(state);
            let drift = (now[0] - center[0]).hypot(now[1] - center[1]);
            // Rounding of some thousand steps, not the tolerance of the method. Observed: 9e-15 m.
            assert!(drift < 3e-14, "seed {seed}: {drift:e}");
            for part in 0..PARTS {
                let way = (state[2 * part] - start[2 * part])
                    .hypot(state[2 * part + 1] - start[2 * part + 1]);
                travelled = travelled.max(way);
            }
        }
        assert!(travelled > 0.2, "seed {seed}: nobody moved, {travelled}");
    }
}

/// A person who leans, as in picture a: parts of 8, 40, 20 and 12 kg.
fn person(lean: f64, arms: f64) -> [Part; 4] {
    [
        (8.0, [0.75 * lean, 1.6]),
        (40.0, [0.5 * lean, 1.1]),
        (20.0, [0.2 * lean, 0.5]),
        (12.0, [0.6 * lean + arms, 1.3]),
    ]
    .map(|(mass, from_feet)| Part { mass, from_feet })
}

// claim: C1.1-2, C1.1-11
#[test]
fn s1_1_picture_a_a_closed_cycle_of_shapes_brings_the_feet_back() {
    let center = [0.3, 1.0];
    let rest = feet(&person(0.0, 0.0), center).unwrap();
    let mut furthest = 0.0_f64;
    for k in 0..=64 {
        let s = TAU * f64::from(k) / 64.0;
        let (lean, arms) = if k == 64 {
            (0.0, 0.0)
        } else {
            (0.6 * s.sin(), 0.4 * (1.0 - s.cos()))
        };
        let now = feet(&person(lean, arms), center).unwrap();
        furthest = furthest.max((now[0] - rest[0]).abs());
        // The centre of what is drawn is where it was: one vertical line through all drawings.
        let parts = person(lean, arms);
        let mass: f64 = parts.iter().map(|p| p.mass).sum();
        let x: f64 = parts
            .iter()
            .map(|p| p.mass * (now[0] + p.from_feet[0]))
            .sum::<f64>()
            / mass;
        assert_relative_eq!(x, center[0], max_relative = 1e-15, epsilon = 0.0);
    }
    assert!(furthest > 0.2, "the feet moved on the way: {furthest}");
    // Bit for bit.
    assert_eq!(feet(&person(0.0, 0.0), center).unwrap(), rest);
    assert!(feet(&[], center).is_err());
}

// claim: C1.1-3, C1.1-4
#[test]
fn s1_1_the_swivel_turns_further_than_it_turns_back() {
    let body = Waist {
        upper_arms_out: 3.0,
        upper_arms_in: 1.0,
        lower: 1.0,
    };
    let exact = [
        (body.swivel_angle(FRAC_PI_2).unwrap(), -FRAC_PI_8),
        (body.phases(FRAC_PI_2).unwrap()[0], -3.0 * FRAC_PI_8),
        (body.phases(FRAC_PI_2).unwrap()[1], FRAC_PI_4),
    ];
    for (value, truth) in exact {
        assert_relative_eq!(value, truth, max_relative = 4e-16, epsilon = 0.0);
    }
    let turn = DEFAULT.swivel_angle(FRAC_PI_2).unwrap().to_degrees();
    assert!((turn + 20.769).abs() < 5e-4, "{turn}");
    // Exactly −90 · 0.6 · 1.3 / (2.6 · 1.3) = −270/13 degrees.
    assert_relative_eq!(turn, -270.0 / 13.0, max_relative = 5e-16, epsilon = 0.0);
    // A/(A + B) grows with A.
    let plane = Swivel { lower: 0.6 };
    let shares = (1..100).map(|k| plane.turn_back(0.1 * f64::from(k)));
    assert!(shares.is_sorted_by(|a, b| a < b));
    // The limits.
    for (out, arms_in, lower, twist) in [
        (2.0, 2.0, 0.6, 1.0),
        (2.0, 0.7, 0.0, 1.0),
        (2.0, 0.7, 0.6, 0.0),
    ] {
        let waist = Waist {
            upper_arms_out: out,
            upper_arms_in: arms_in,
            lower,
        };
        assert_eq!(waist.swivel_angle(twist).unwrap(), 0.0);
    }
    for lower in [1e9, 1e-9] {
        let waist = Waist { lower, ..DEFAULT };
        assert!(waist.swivel_angle(1.0).unwrap().abs() < 2e-9);
    }
}

// claim: C1.1-5
#[test]
fn s1_1_the_sense_of_the_swivel() {
    // Anticlockwise is positive: twist that way with the arms out, and the net turn is clockwise.
    assert!(DEFAULT.swivel_angle(1.0).unwrap() < 0.0);
    let swapped = Waist {
        upper_arms_out: DEFAULT.upper_arms_in,
        upper_arms_in: DEFAULT.upper_arms_out,
        ..DEFAULT
    };
    assert_relative_eq!(
        swapped.swivel_angle(1.0).unwrap(),
        -DEFAULT.swivel_angle(1.0).unwrap(),
        max_relative = 3e-16,
        epsilon = 0.0
    );
    assert_eq!(
        DEFAULT.swivel_angle(-1.0).unwrap(),
        -DEFAULT.swivel_angle(1.0).unwrap()
    );
}

// claim: C1.1-6
#[test]
fn s1_1_the_best_lower_moment() {
    let body = Waist {
        upper_arms_out: 3.0,
        upper_arms_in: 1.0,
        lower: 1.0,
    };
    let best = body.best_lower().unwrap();
    assert_relative_eq!(best, 3.0_f64.sqrt(), max_relative = 3e-16, epsilon = 0.0);
    let turn = |lower: f64| Waist { lower, ..body }.swivel_angle(FRAC_PI_2).unwrap();
    assert_relative_eq!(
        turn(best),
        -FRAC_PI_2 * (2.0 - 3.0_f64.sqrt()),
        max_relative = 5e-16,
        epsilon = 0.0
    );
    assert_relative_eq!(
        turn(best),
        -0.420_893_607_238_466_46,
        max_relative = 3e-16,
        epsilon = 0.0
    );
    for k in -40..=40 {
        let other = best * 1.1_f64.powi(k);
        assert!(k == 0 || turn(other) > turn(best));
        assert!(turn(other).abs() < FRAC_PI_2);
    }
}

/// The loop A = 2 + cos s, ψ = sin s.
fn ellipse(s: f64) -> Step {
    let (sin, cos) = s.sin_cos();
    Step {
        shape: [2.0 + cos, sin],
        rate: [-sin, cos],
    }
}

// claim: C1.1-7
#[test]
fn s1_1_the_turn_is_an_area_and_the_pace_does_not_matter() {
    let plane = Swivel { lower: 1.0 };
    // 2π(1 − 3/√8).
    let truth = -0.381_139_100_057_962_9;
    let along = turn_along(&plane, ellipse).unwrap();
    let within = turn_within(&plane, ellipse, Hub::Point([2.0, 0.0])).unwrap();
    let aside = turn_within(&plane, ellipse, Hub::Point([1.4, 0.3])).unwrap();
    // Observed: 1.5e-16, 3e-16, 6e-16.
    for value in [along, within, aside] {
        assert_relative_eq!(value, truth, max_relative = 2e-15, epsilon = 0.0);
    }
    // Two other ways of going round it in time.
    let late = |s: f64| {
        let warped = s + 0.7 * s.sin();
        let step = ellipse(warped);
        Step {
            rate: step.rate.map(|r| r * (1.0 + 0.7 * s.cos())),
            ..step
        }
    };
    assert_relative_eq!(
        turn_along(&plane, late).unwrap(),
        truth,
        max_relative = 2e-15,
        epsilon = 0.0
    );
    for duration in [0.3, 60.0] {
        for pace in [shape::Pace::Even, shape::Pace::Late] {
            let round = shape::RoundTrip {
                mean: 2.0,
                swing: 1.0,
                twist: 1.0,
                duration,
                pace,
            };
            let scene = shape::Swivel::new(1.0, 3.0)
                .unwrap()
                .with_change(round)
                .unwrap();
            let motion = scene.simulate(&Request::at([duration]).unwrap()).unwrap();
            let turn = motion.rows[0].1.lower;
            // Observed: 3e-15.
            assert_relative_eq!(turn, truth, max_relative = 1e-14, epsilon = 0.0);
        }
    }
    // Round the other way: back again. A loop without area: nothing.
    let back = |s: f64| {
        let step = ellipse(-s);
        Step {
            rate: step.rate.map(|r| -r),
            ..step
        }
    };
    assert_relative_eq!(
        turn_along(&plane, back).unwrap(),
        -truth,
        max_relative = 2e-15,
        epsilon = 0.0
    );
    let line = |s: f64| Step {
        shape: [2.0 + s.sin(), s.sin()],
        rate: [s.cos(), s.cos()],
    };
    assert!(turn_along(&plane, line).unwrap().abs() < 1e-15);
}

// claim: C1.1-12
#[test]
fn s1_1_picture_b_the_four_frames() {
    let phases = shape::FourPhases {
        arms_out: 2.0,
        arms_in: 0.7,
        twist: FRAC_PI_2,
        duration: 4.0,
        pace: shape::Pace::Even,
    };
    let scene = shape::Swivel::new(0.6, 2.0)
        .unwrap()
        .with_change(phases)
        .unwrap();
    let motion = scene
        .simulate(&Request::at([1.0, 2.0, 3.0, 4.0]).unwrap())
        .unwrap();
    let [there, back] = DEFAULT.phases(FRAC_PI_2).unwrap();
    let whole = DEFAULT.swivel_angle(FRAC_PI_2).unwrap();
    // ΨB/(A + B) and −ΨA/(A + B).
    let upper = FRAC_PI_2 * 0.6 / 2.6;
    let expected = [
        [there, upper],
        [there, upper],
        [there + back, there + back],
        [whole, whole],
    ];
    for ((_, state), [lower, upper]) in motion.rows.iter().zip(expected) {
        // Observed: 4e-16.
        assert!((state.lower - lower).abs() < 2e-15, "{state:?}");
        assert!((state.upper - upper).abs() < 2e-15, "{state:?}");
    }
}

/// Two cylinders: I/J = 4.
fn equal(ratio: f64, to_joint: f64) -> Cat {
    let half = Half {
        mass: 1.5,
        axial: 0.004,
        transverse: 0.004 * ratio,
        to_joint,
    };
    Cat::new([half, half]).unwrap()
}

// claim: C1.1-8
#[test]
fn s1_1_the_cat_in_closed_form() {
    let close = |value: f64, truth: f64| {
        assert_relative_eq!(value, truth, max_relative = 6e-16, epsilon = 0.0)
    };
    let cat = EqualHalves::new(1.0, 3.0).unwrap();
    close(cat.turn_per_swing(1.0).unwrap(), 2.505_681_320_653_108);
    close(cat.half_turn_bend(), 2.0 * 0.604_342_896_591_750_2);
    close(
        EqualHalves::new(1.0, 1.0).unwrap().half_turn_bend(),
        2.0 * FRAC_PI_3,
    );
    assert_eq!(cat.turn_per_swing(0.0).unwrap(), 0.0);
    for (ratio, degrees) in [(4.0, 59.43), (2.63, 74.29)] {
        let cat = EqualHalves::new(1.0, ratio).unwrap();
        let bend = cat.half_turn_bend();
        assert!((bend.to_degrees() - degrees).abs() < 5e-3, "{bend}");
        close(cat.turn_per_swing(bend).unwrap(), PI);
    }
    let half = EqualHalves::new(1.0, 4.0)
        .unwrap()
        .half_turn_bend()
        .to_degrees()
        / 2.0;
    assert!((half - 29.713).abs() < 5e-4, "{half}");
    // A small bend: π/2 (2I/J − 1) a², to the next order, without cancellation.
    let small = cat.turn_per_swing(2e-9).unwrap();
    close(small, PI * (2.0 * 3.0 - 1.0) * 1e-18);
}

// claim: C1.1-8
#[test]
fn s1_1_the_curvature_of_the_cat_is_the_slope_of_its_turn() {
    for ratio in [0.5, 1.0, 2.63, 4.0, 10.0] {
        let cat = EqualHalves::new(1.0, ratio).unwrap();
        for bend in [0.1, 1.0, 2.0, 3.0] {
            let sum = quadrature::integral(|x| cat.curvature(x), 0.0, bend, 0.0).unwrap();
            assert_relative_eq!(
                sum,
                cat.turn_back(bend),
                max_relative = 3e-15,
                epsilon = 0.0
            );
            assert!(cat.curvature(bend) > 0.0);
            assert_relative_eq!(
                cat.turn_back(bend),
                1.0 - cat.frame_turn(bend),
                max_relative = 0.0,
                epsilon = 1e-15
            );
        }
        // Kane and Scher's loop, by its length and by its area.
        let path = |s: f64| Step {
            shape: [1.1 + 0.4 * s.cos(), s],
            rate: [-0.4 * s.sin(), 1.0],
        };
        let along = turn_along(&cat, path).unwrap();
        let within = turn_within(&cat, path, Hub::Pole).unwrap();
        assert_relative_eq!(along, within, max_relative = 3e-15, epsilon = 0.0);
        let uneven = cat.turn_of_uneven_swing(1.5, 0.7).unwrap();
        assert_relative_eq!(-along, uneven, max_relative = 1e-15, epsilon = 0.0);
    }
}

/// The turn of a cat after a turnover: attitudes against each other, and its axis in the body.
fn turned(cat: Cat, forward: f64, back: f64, duration: f64) -> (f64, BodyVector) {
    let turnover = shape::Turnover {
        forward,
        back,
        duration,
        pace: shape::Pace::Even,
    };
    let scene = shape::Cat::new(cat, Attitude::identity())
        .with_change(turnover)
        .unwrap();
    let request = Request::at([duration]).unwrap().to_accuracy(1e-11).unwrap();
    let general = request.clone().by(spinning_bodies::scene::Choice::Use(
        spinning_bodies::scene::Solver::General(Method::Dop853),
    ));
    let [exact, followed] = [request, general].map(|r| scene.simulate(&r).unwrap().rows[0].1);
    // Closed form, and L = 0 solved and integrated without any symmetry. Observed: 9e-13 rad, 1e-11 asked.
    let apart = exact.attitude.angle_to(&followed.attitude);
    assert!(apart < 4e-12, "{apart:e}");
    let axis = followed.attitude.quaternion().imag();
    let axis = BodyVector::from_components(axis)
        .direction("the axis of the turn")
        .unwrap();
    (followed.attitude.angle_to(&Attitude::identity()), axis)
}

// claim: C1.1-8
#[test]
fn s1_1_the_reconstructed_cat_turns_over() {
    let closed = EqualHalves::new(1.0, 4.0).unwrap();
    let bend = closed.half_turn_bend();
    // Neither the distance to the joint nor the speed matters.
    for to_joint in [0.05, 0.12, 0.2] {
        for duration in [0.2, 3.0] {
            let (turn, axis) = turned(equal(4.0, to_joint), bend, bend, duration);
            // Observed: 9e-13.
            assert!((turn - PI).abs() < 4e-12, "{turn}");
            // From straight to straight about the spine.
            assert!((axis.x().abs() - 1.0).abs() < 1e-12, "{axis:?}");
        }
    }
    // Forward and back, degrees: exactly half a turn.
    for (forward, back) in [
        (70.0, 49.59),
        (80.0, 41.43),
        (90.0, 34.09),
        (100.0, 27.32),
        (120.0, 14.58),
    ] {
        let forward = f64::to_radians(forward);
        let found = closed.back_bend_for_half_turn(forward).unwrap().unwrap();
        assert!(
            (found.to_degrees() - back).abs() < 6e-3,
            "{}",
            found.to_degrees()
        );
        let (turn, _) = turned(equal(4.0, 0.12), forward, found, 0.5);
        assert!((turn - PI).abs() < 4e-12, "{turn}");
    }
    for (forward, back, degrees) in [(90.0, 45.0, 161.0), (120.0, 30.0, 154.7)] {
        let (turn, _) = turned(
            equal(4.0, 0.12),
            f64::to_radians(forward),
            f64::to_radians(back),
            0.5,
        );
        assert!(
            (turn.to_degrees() - degrees).abs() < 0.05,
            "{}",
            turn.to_degrees()
        );
        // The cat went past half a turn.
        let whole = closed
            .turn_of_uneven_swing(f64::to_radians(forward), f64::to_radians(back))
            .unwrap();
        assert_relative_eq!(TAU - whole, turn, max_relative = 1e-12, epsilon = 0.0);
    }
    assert_eq!(
        closed.back_bend_for_half_turn(0.5).unwrap().is_some(),
        closed.turn_of_uneven_swing(0.5, PI).unwrap() > PI
    );
    assert_eq!(closed.back_bend_for_half_turn(3.1).unwrap(), None);
}

// claim: C1.1-8
#[test]
fn s1_1_a_bent_loop_turns_the_cat_about_its_mean_spine() {
    // The loop alone, from bent to bent: the axis lies γ/2 from the spine of the first half, towards the bend.
    let cat = equal(4.0, 0.12);
    let (forward, back) = (f64::to_radians(90.0), f64::to_radians(45.0));
    let system = |t: f64, y: &[f64; 4]| {
        let bend = Bend {
            angle: 0.5 * (forward + back) + 0.5 * (forward - back) * t.cos(),
            direction: t,
            angle_rate: -0.5 * (forward - back) * t.sin(),
            direction_rate: 1.0,
        };
        let w = cat.angular_velocity(&bend, BodyVector::zero()).unwrap();
        let [q, x, y, z] = *y;
        [
            -0.5 * (x * w.x() + y * w.y() + z * w.z()),
            0.5 * (q * w.x() + y * w.z() - z * w.y()),
            0.5 * (q * w.y() + z * w.x() - x * w.z()),
            0.5 * (q * w.z() + x * w.y() - y * w.x()),
        ]
    };
    let run = solve(
        &system,
        0.0,
        &[1.0, 0.0, 0.0, 0.0],
        &[1.0; 4],
        &[TAU],
        Method::Dop853,
        Effort::Tolerance(1e-14),
    );
    let [w, x, y, z] = run.unwrap().states[0];
    let turn = 2.0 * x.hypot(y).hypot(z).atan2(w.abs());
    assert!(
        (turn.to_degrees() - 161.007).abs() < 1e-3,
        "{}",
        turn.to_degrees()
    );
    let tilt = y.atan2(x).rem_euclid(PI);
    assert!(
        (tilt - 0.5 * forward).abs() < 1e-12 && z.abs() < 1e-12,
        "{tilt} {z:e}"
    );
}

/// The angular momentum of the cat at zero, from matrices of the library's inertia module and finite rotations: nothing shared with the cat's own sum.
// claim: C1.1-8
#[test]
fn s1_1_no_angular_momentum_at_any_shape() {
    let halves = [
        Half {
            mass: 1.3,
            axial: 0.003,
            transverse: 0.011,
            to_joint: 0.11,
        },
        Half {
            mass: 2.1,
            axial: 0.005,
            transverse: 0.014,
            to_joint: 0.14,
        },
    ];
    for cat in [Cat::new(halves).unwrap(), equal(4.0, 0.12)] {
        for k in 0..200 {
            let s = f64::from(k);
            let bend = Bend {
                angle: 1.5 * (0.37 * s).sin().abs(),
                direction: 1.7 * s,
                angle_rate: (1.1 * s).cos(),
                direction_rate: 2.0 * (0.9 * s).sin(),
            };
            let omega = cat.angular_velocity(&bend, BodyVector::zero()).unwrap();
            let l = cat.angular_momentum(&bend, omega);
            assert!(l.norm() < 1e-16, "{k}: {:e}", l.norm());
            // Attitudes and places half a step before and after, by the exact rotation about `omega`.
            let h = 1e-4;
            let at = |t: f64| {
                let moved = Bend {
                    angle: bend.angle + bend.angle_rate * t,
                    direction: bend.direction + bend.direction_rate * t,
                    ..bend
                };
                let turn = Attitude::about_axis(omega, omega.norm() * t).unwrap();
                let places = cat.places(&moved).map(|p| turn.to_space(p));
                let second = turn.quaternion() * moved.relative().quaternion();
                (places, [turn.quaternion(), second])
            };
            let (before, after) = (at(-h), at(h));
            let mut sum = SpaceVector::zero();
            for (half, body) in cat.halves().iter().zip([0, 1]) {
                let place = (before.0[body + 1] + after.0[body + 1]) * 0.5;
                let velocity = (after.0[body + 1] - before.0[body + 1]) / (2.0 * h);
                sum += half.mass * place.cross(&velocity);
                let step = after.1[body] * before.1[body].inverse();
                let rate = SpaceVector::from_components(step.scaled_axis() / (2.0 * h));
                let attitude = Attitude::from_quaternion(
                    before.1[body].slerp(&after.1[body], 0.5).w,
                    before.1[body].slerp(&after.1[body], 0.5).i,
                    before.1[body].slerp(&after.1[body], 0.5).j,
                    before.1[body].slerp(&after.1[body], 0.5).k,
                )
                .unwrap();
                let matrix =
                    InertiaMatrix::diagonal(half.axial, half.transverse, half.transverse).unwrap();
                sum += attitude.to_space(matrix.angular_momentum(attitude.to_body(rate)));
            }
            // The step's own error, h² times third derivatives. Observed: 4e-9 of terms of 0.03.
            assert!(sum.norm() < 2e-8, "{k}: {:e}", sum.norm());
        }
    }
}

// claim: C1.1-9, C1.1-13
#[test]
fn s1_1_the_paper_cat_needs_air() {
    let cat = PaperCat::POSTCARD;
    let g = shape::Gravity { g: 9.81 };
    let air = shape::Air { density: 1.2 };
    assert!((cat.terminal_speed(1.2, 9.81) - 2.022).abs() < 5e-4);
    // The torque of the air points to upright from every tilt, and is zero at the two ends.
    for k in 1..180 {
        let tilt = f64::from(k).to_radians();
        assert!(cat.righting(1.2, 2.0, tilt, 0.0) < 0.0);
        assert!(cat.righting(1.2, 2.0, -tilt, 0.0) > 0.0);
    }
    assert_eq!(cat.righting(1.2, 2.0, 0.0, 0.0), 0.0);
    // Heights of fall, m.
    for (degrees, fall) in [
        (150.0, 0.610),
        (170.0, 0.826),
        (175.0, 0.965),
        (179.0, 1.292),
    ] {
        let tilt = f64::to_radians(degrees);
        let scene = shape::PaperCat::new(cat, tilt).unwrap().with_gravity(g);
        let righted = scene.with_air(air).rights_itself(10.0).unwrap().unwrap();
        assert!(
            (righted.fall - fall).abs() < 6e-4,
            "{degrees}: {}",
            righted.fall
        );
        // In a vacuum it lands as it was let go.
        assert_eq!(scene.rights_itself(10.0).unwrap(), None);
        let motion = scene.simulate(&Request::at([0.5]).unwrap()).unwrap();
        assert_eq!(motion.rows[0].1.tilt, tilt);
        assert_relative_eq!(
            motion.rows[0].1.fall,
            0.5 * 9.81 * 0.25,
            max_relative = 1e-15,
            epsilon = 0.0
        );
    }
    // Upright is the only rest that lasts: it gets there and stays.
    let scene = shape::PaperCat::new(cat, 3.0)
        .unwrap()
        .with_air(air)
        .with_gravity(g);
    let motion = scene.simulate(&Request::at([30.0]).unwrap()).unwrap();
    assert!(motion.rows[0].1.tilt.abs() < 1e-8, "{:?}", motion.rows[0].1);
    // Speed and fall have a closed form, the tilt has no say in them.
    let [velocity, fall] = cat.fall(1.2, 9.81, 30.0);
    assert_relative_eq!(
        motion.rows[0].1.velocity,
        velocity,
        max_relative = 1e-10,
        epsilon = 0.0
    );
    assert_relative_eq!(
        motion.rows[0].1.fall,
        fall,
        max_relative = 1e-10,
        epsilon = 0.0
    );
}

// claim: C1.1-9
#[test]
fn s1_1_upside_down_is_an_equilibrium_and_costs_a_logarithm() {
    let cat = PaperCat::POSTCARD;
    let fall = |error: f64| {
        let scene = shape::PaperCat::new(cat, PI - error).unwrap();
        let scene = scene
            .with_air(shape::Air { density: 1.2 })
            .with_gravity(shape::Gravity { g: 9.81 });
        scene.rights_itself(30.0).unwrap().unwrap().fall
    };
    let decade = cat.fall_per_decade(1.2, 9.81);
    for exponent in 3..7 {
        let grown = fall(10f64.powi(-exponent - 1)) - fall(10f64.powi(-exponent));
        // The errors are small enough to be linear and the speed is terminal: the closed rate. Observed: 2e-5, 2e-7, 2e-9 and less, the
        // last by the rounding of π − error.
        assert_relative_eq!(grown, decade, max_relative = 1e-3, epsilon = 0.0);
    }
}

// claim: C1.1-10
#[test]
fn s1_1_the_skater_and_the_work_of_the_arms() {
    let body = Skater::new(1.0, 0.25).unwrap();
    let scene = shape::Skater::new(body, 1.0, 6.0)
        .unwrap()
        .with_change(shape::Draw {
            to: 0.4,
            begin: 0.5,
            duration: 1.0,
            pace: shape::Pace::Late,
        });
    let scene = scene.unwrap();
    let request = Request::at([0.9, 1.2, 2.0])
        .unwrap()
        .to_accuracy(1e-12)
        .unwrap();
    let exact = scene.simulate(&request).unwrap();
    let end = exact.rows[2].1;
    assert_relative_eq!(end.spin, 25.0 / 3.0, max_relative = 3e-16, epsilon = 0.0);
    assert_relative_eq!(end.work, 10.5, max_relative = 5e-16, epsilon = 0.0);
    // Coriolis' force and the pull against the centrifugal force, integrated.
    let method = spinning_bodies::scene::Choice::Use(spinning_bodies::scene::Solver::General(
        Method::Dop853,
    ));
    let followed = scene.simulate(&request.by(method)).unwrap();
    for ((_, a), (_, b)) in exact.rows.iter().zip(&followed.rows) {
        // Observed: 2e-14.
        assert_relative_eq!(a.spin, b.spin, max_relative = 1e-12, epsilon = 0.0);
        assert_relative_eq!(a.work, b.work, max_relative = 1e-12, epsilon = 0.0);
        assert_relative_eq!(b.work, b.energy - 27.0, max_relative = 1e-12, epsilon = 0.0);
    }
    // The arms alone: ∫ 2mΩ²r dr.
    let l = 9.0;
    let pull = |r: f64| -2.0 * 0.25 * body.spin(l, r).powi(2) * r;
    let work = quadrature::integral(pull, 1.0, 0.4, 0.0).unwrap();
    assert_relative_eq!(work, 10.5, max_relative = 1e-14, epsilon = 0.0);

    // A grown skater: 3.5 to 1 kg m², from two turns a second.
    let body = Skater::new(0.8, 2.5).unwrap();
    let [out, close] = [3.5, 1.0].map(|moment| body.reach(moment).unwrap());
    let l = 3.5 * 2.0 * TAU;
    assert_relative_eq!(
        body.spin(l, close) / TAU,
        7.0,
        max_relative = 5e-16,
        epsilon = 0.0
    );
    let before = body.energy(body.spin(l, out), out, 0.0);
    let after = body.energy(body.spin(l, close), close, 0.0);
    assert!(
        (before - 276.3).abs() < 0.05 && (after - 967.2).abs() < 0.05,
        "{before} {after}"
    );
    assert_relative_eq!(
        after - before,
        body.work(l, out, close).unwrap(),
        max_relative = 1e-15,
        epsilon = 0.0
    );
    assert_relative_eq!(after / before, 3.5, max_relative = 1e-15, epsilon = 0.0);
}

// claim: C1.1-1
#[test]
fn s1_1_friction_makes_the_crawler_move() {
    let strokes = Strokes {
        gap: 0.3,
        length: 0.2,
        push: 1.0,
        pull: 0.15,
    };
    let body = crawler::Crawler::new(3.0, 1.0, strokes).unwrap();
    let times: Vec<f64> = (0..=40).map(|k| f64::from(k) * strokes.cycle()).collect();
    let request = Request::at(times).unwrap();
    let still = shape::Crawler::new(body);
    let ice = still.simulate(&request).unwrap();
    assert!(ice.rows.iter().all(|(_, s)| s.center == 0.0));
    let drift = |mu: f64| {
        let ground = shape::GroundFriction::new(mu, 9.81).unwrap();
        let motion = still.with_friction(ground).simulate(&request).unwrap();
        let [a, b] = [20, 40].map(|k| motion.rows[k].1.center);
        (b - a) / 20.0
    };
    assert_eq!(drift(0.0), 0.0);
    let drifts = [0.01, 0.02, 0.05, 0.1, 0.2].map(drift);
    // Metres a cycle; none is more than a heavy foot that never slips would make, 1/4 of a stroke.
    assert!(
        drifts.iter().all(|d| (0.02..0.05).contains(d)),
        "{drifts:?}"
    );
}

// claim: C1.4-1
#[test]
fn s1_4_a_top_need_not_be_symmetric() {
    // Three different moments, and a free motion that keeps them apart.
    let matrix = InertiaMatrix::diagonal(1.0, 2.0, 3.0).unwrap();
    let axes = matrix.principal_axes().moments();
    assert_eq!(axes, [1.0, 2.0, 3.0]);
    let top = spinning_bodies::euler_top::EulerTop::from_omega(
        [1.0, 2.0, 3.0],
        BodyVector::new(0.4, 0.3, 1.0),
        Attitude::identity(),
    )
    .unwrap();
    let mut ledger = Ledger::new();
    let energy = |omega: BodyVector| matrix.rotational_energy(omega);
    let start = top.at(0.0).unwrap().omega;
    let account = ledger
        .open("energy", Law::Conserved, energy(start))
        .unwrap();
    for k in 1..20 {
        ledger
            .record(account, energy(top.at(f64::from(k)).unwrap().omega))
            .unwrap();
    }
    assert!(ledger.is_kept_within(1e-14).unwrap(), "{ledger}");
}
