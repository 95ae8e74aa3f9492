//! Kovalevskaya's top against a table of 30 digits, near double roots, at q = 0, with weak gravity, and on bad input.
//!
//! `tests/reference/kovalevskaya.py` says how the table was made: by power series alone.

use spinning_bodies::Error;
use spinning_bodies::frame::SpaceVector;
use spinning_bodies::kovalevskaya_top::{Diagram, Kind, KovalevskayaTop, Method, Reason};
use support::{observed, vector};

use support::double_double::Dd;
use support::kovalevskaya::{LEVER, MOMENTS, SERIES, errors, parts, top};
use support::power_series::Whole;
use support::table::{Cells, lines};

/// The largest errors over a time, against power series.
pub(super) fn compared(top: &KovalevskayaTop, times: &[f64]) -> [f64; 2] {
    let start = top.at(0.0).expect("the start");
    let q = start.attitude.quaternion();
    let [a, b, c, d, e, f] = parts(&start);
    let whole = [a, b, c, d, e, f, q.w, q.i, q.j, q.k];
    times.iter().fold([0.0, 0.0], |worst: [f64; 2], &t| {
        let found = errors(&top.at(t).expect("a state"), &SERIES.after(whole, t));
        [worst[0].max(found[0]), worst[1].max(found[1])]
    })
}

/// Where a quantity passes zero, by halving: the two sides of it.
pub(super) fn crossing(of: impl Fn(f64) -> f64, [mut low, mut high]: [f64; 2]) -> [f64; 2] {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if of(low) * of(middle) <= 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    [low, high]
}

/// Kind of start, top, time, and the state there: a line of either table.
pub(super) fn row(cells: &Cells) -> (&'static str, KovalevskayaTop, f64, Whole) {
    let [axial, c1, c2] = cells.exact(1);
    let moments = [2.0 * axial, 2.0 * axial, axial];
    let [lever, omega, up] = [[c1, c2, 0.0], cells.exact(4), cells.exact(7)].map(vector);
    let top = KovalevskayaTop::with_up(moments, lever, omega, up).expect("a top");
    let ([t], expected) = (cells.exact(10), cells.decimals(11).map(Dd::value));
    (cells.text(0), top, t, expected)
}

#[test]
fn table_of_thirty_digits() {
    let table = include_str!("../reference/kovalevskaya.csv");
    let (mut rows, mut by_series) = (0, 0);
    for cells in lines(table) {
        let (kind, top, t, expected) = row(&cells);
        let weak = kind == "weak gravity";
        // Observed at t = 1, 10, 100: 2e-15, 5e-15, 5e-14 for Ω and z, 2e-15, 5e-15, 6e-14 rad for the attitude. With gravity a hundred
        // times weaker than the spin the quotients by c show: 2e-14, 4e-14, 7e-13.
        let walked = if weak { 3e-12 } else { 3e-15 + 1e-15 * t };
        // Observed at t = 1, 10, 100, 1000: 7e-15, 2e-14, 2e-13, 7e-13 rad; with weak gravity 2e-14, 5e-14, 7e-13.
        let leapt = if weak { 3e-12 } else { 1e-14 + 3e-15 * t };
        let allowed = if t <= 100.0 { walked } else { leapt };
        let [motion, attitude] = errors(&top.at(t).expect("a state"), &expected);
        assert!(motion.max(attitude) < allowed, "{kind} {t}");
        by_series += usize::from(top.method() == Method::Separation);
        rows += 1;
    }
    // The pendulums and the weakest gravity are not separated.
    assert_eq!((rows, by_series), (150, 140));
}

#[test]
fn start_and_motion_through_q_zero() {
    // s₂ is infinite at the start; z₂ = 0 there as well in the second.
    for (omega, up) in [
        ([1.0, 0.0, 0.3], [0.6, 0.48, 0.64]),
        ([1.0, 0.0, 0.3], [0.6, 0.0, 0.8]),
        ([-0.7, 1e-9, 0.9], [0.3, 1e-8, 0.9]),
        ([-0.7, 1e-170, 0.9], [0.3, 0.4, 0.9]),
        ([0.0, 0.0, 0.0], [0.6, 0.48, 0.64]),
    ] {
        let top = top(omega, up);
        assert_eq!(top.method(), Method::Separation);
        // Observed: 4e-15 and 4e-15.
        let [motion, attitude] = compared(&top, &[1e-9, 0.1, 1.0, 5.0, -5.0]);
        observed!(motion, 1e-15..=2e-14, "{motion:e} {attitude:e}");
        observed!(attitude, 1e-15..=2e-14, "{motion:e} {attitude:e}");
    }
    // And a moving one: q passes zero twice in each turn of the second phase; z₂ there, found by halving.
    let top = top([1.0, 0.5, 0.3], [0.6, 0.0, 0.8]);
    let q = |t: f64| top.omega_and_up(t).expect("a state").omega.y();
    let mut crossings = 0;
    for n in 0..200 {
        let ends = [n, n + 1].map(|n| 0.1 * f64::from(n));
        if q(ends[0]) * q(ends[1]) < 0.0 {
            let sides = crossing(q, ends);
            let [motion, _] = compared(&top, &sides);
            // Observed: 1e-13 after 19 units of time.
            observed!(motion, 1e-14..=2e-13, "{sides:?}: {motion:e}");
            crossings += 1;
        }
    }
    assert!(crossings >= 2, "{crossings}");
}

#[test]
fn appelrots_classes_in_their_diagram() {
    let gap = |roots: [nalgebra::Complex<f64>; 5]| {
        let pairs = (0..5).flat_map(|i| (0..i).map(move |j| (i, j)));
        let gaps = pairs.map(|(i, j)| (roots[i] - roots[j]).norm());
        gaps.fold(f64::INFINITY, f64::min)
    };
    for (c, k) in [(1.0, 0.4), (1.0, 1.7), (0.3, 0.9)] {
        let diagram = Diagram::new(c, k).expect("a diagram");
        let mut seen = [0; 4];
        for n in 1..40 {
            let energy = 0.1 * f64::from(n) - 1.0;
            let lines = [diagram.shared_upper(energy), diagram.shared_lower(energy)];
            let curve = diagram.cubic_double(energy).expect("finite");
            let all = || lines.into_iter().chain(curve.into_iter().flatten());
            for (i, h) in all().enumerate().filter(|(_, h)| *h > 0.0) {
                // A double root of the cubic is only as sharp as the root of the rounding of h.
                let sharp = if i < 2 { 2e-14 } else { 2e-7 };
                let on = gap(diagram.roots(energy, h).expect("roots"));
                assert!(on < sharp, "{i} {energy} {h}: {on:e}");
                seen[i] += 1;
            }
            // Away from all of them no two roots meet.
            let off = diagram.roots(energy, 0.37).expect("roots");
            let near = all().any(|h| (h - 0.37).abs() < 0.02);
            assert!(near || gap(off) > 1e-3, "{energy}: {:e}", gap(off));
        }
        assert!(seen.iter().filter(|n| **n > 3).count() >= 3, "{seen:?}");
    }
    // K = 0: the first class is a diagram of its own, with e₄ = e₅ all over.
    let flat = Diagram::new(1.0, 0.0).expect("a diagram");
    let roots = flat.roots(0.9, 0.5).expect("roots");
    assert_eq!(roots[3], roots[4]);
    // Units that cubes leave: at powers of two the same bits.
    let [here, far] = [1.0, 2f64.powi(400)].map(|unit| {
        let scaled = Diagram::new(unit, 0.4 * unit).expect("a diagram");
        let roots = scaled.roots(1.5 * unit, 0.7 * unit).expect("roots");
        let curve = scaled.cubic_double(2.0 * unit).expect("finite");
        let curve = curve.expect("real").map(|h| h / unit);
        (roots.map(|root| root / unit), curve)
    });
    assert_eq!(here, far);
    assert!(Diagram::new(0.0, 1.0).is_err() && Diagram::new(1.0, -1.0).is_err());
    assert!(flat.roots(f64::NAN, 1.0).is_err() && flat.cubic_double(f64::INFINITY).is_err());
}

#[test]
fn delaunays_case_stays_delaunays() {
    for (omega, up) in [
        // w² = cζ exactly, in doubles.
        ([1.0, 0.0, 0.7], [1.0, 0.0, 0.0]),
        // 0.609375 = 1 − 0.5² − 0.375².
        ([0.75, 0.25, 0.5], [0.5, 0.375, 0.609375_f64.sqrt()]),
        ([0.0, 0.0, 0.7], [0.0, 0.0, 1.0]),
    ] {
        let top = top(omega, up);
        assert_eq!(top.kind(), Kind::Delaunay);
        for n in 0..100 {
            let state = top.at(0.3 * f64::from(n)).expect("a state");
            let (o, z) = (state.omega, state.up);
            let k = (o.x() * o.x() - o.y() * o.y() - z.x()).hypot(2.0 * o.x() * o.y() - z.y());
            observed!(k, 9e-16..=4e-15);
        }
        let [motion, attitude] = compared(&top, &[1.0, 10.0]);
        observed!(motion, 4e-16..=2e-14, "{motion:e} {attitude:e}");
        observed!(attitude, 9e-16..=4e-14, "{motion:e} {attitude:e}");
    }
}

#[test]
fn a_moment_after_an_upright_start_nothing_has_turned() {
    for n in 1..60 {
        let x = f64::from(n);
        let top = top([x.sin(), (2.0 * x).cos(), (3.0 * x).sin()], [0.0, 0.0, 1.0]);
        let attitude = |t| top.at(t).expect("a state").attitude;
        for t in [5.6e-17, 1e-15, -1e-14, 1e-13] {
            assert!(attitude(t).angle_to(&attitude(0.0)) < 1e-12, "{n} {t}");
        }
    }
}

#[test]
fn pendulums_stay_in_their_plane() {
    // About axis 2: Ω = (0, q, 0), z₂ = 0. About axis 3: Ω = (0, 0, r), z₃ = 0.
    for (omega, up, zeros) in [
        ([0.0, 0.7, 0.0], [0.6, 0.0, 0.8], [0, 2, 4]),
        ([0.0, 0.0, 0.7], [0.6, 0.8, 0.0], [0, 1, 5]),
        ([0.0, 3.1, 0.0], [0.6, 0.0, 0.8], [0, 2, 4]),
    ] {
        let top = top(omega, up);
        assert_eq!(top.method(), Method::Elliptic);
        for t in [0.5, 5.0, 50.0, 1e8] {
            let state = parts(&top.at(t).expect("a state"));
            assert_eq!(zeros.map(|i| state[i]), [0.0; 3], "{t}");
        }
    }
}

#[test]
fn close_to_a_double_root_the_reason_is_told() {
    // A pendulum about axis 3, pushed a little out of its plane; the roots part with the push.
    let mut methods = Vec::new();
    for exponent in 0..=12 {
        let push = 10_f64.powi(-exponent);
        let top = top([0.3 * push, push, 0.7], [0.6, 0.8, 0.0]);
        let separated = top.method() == Method::Separation;
        methods.push(separated);
        let [motion, attitude] = compared(&top, &[0.5, 3.0, 8.0]);
        observed!(motion, 2e-15..=3e-14, "{push:e} {:?}", top.method());
        observed!(attitude, 2e-15..=5e-14, "{push:e} {:?}", top.method());
        if !separated {
            assert_eq!(top.method(), Method::PowerSeries(Reason::DoubleRoot));
            assert!(top.frequencies().is_none());
        }
        match top.at(300.0) {
            Ok(late) => {
                let vertical = late.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
                observed!((vertical - late.up).norm(), 1e-16..=2e-15);
            }
            // More than 106 bits can follow.
            Err(Error::Integration { time, .. }) => assert!(time < 300.0 && !separated),
            Err(error) => panic!("{error}"),
        }
    }
    // At 1e-4 the cosine series would need about 2¹⁰ terms, which is where they end.
    assert_eq!(methods[..3], [true; 3]);
    assert!(!methods[11] && !methods[12], "{methods:?}");
}

#[test]
fn roots_of_the_cubic_meet_and_no_variable_passes_between() {
    // Ω₁ by halving until e₂ and e₃ were one to half of the digits; and a little beside, where they are real or complex.
    let starts = [
        (
            [0.018238973487506947, -0.0625, 0.9375],
            [0.1875, -0.875, 0.1875],
        ),
        ([2.3170881378851916, 1.0, 0.625], [0.1875, -0.875, 1.1875]),
        ([0.6354277762836253, 0.75, -0.0625], [1.1875, -1.1875, -0.5]),
    ];
    let mut worst = [0.0_f64; 2];
    for ([p, q, r], up) in starts {
        for push in [1e-6, -1e-6, 1e-9, -1e-9, 1e-11, -1e-11] {
            let top = top([p + push, q, r], up);
            let [_, second, third, ..] = top.roots();
            assert!((second - third).norm() < 1e-3, "{p} {push:e}");
            assert_eq!(top.method(), Method::Separation, "{p} {push:e}");
            let found = compared(&top, &[1.0, 10.0, 30.0]);
            worst = [0, 1].map(|i| worst[i].max(found[i]));
        }
    }
    let [motion, attitude] = worst;
    observed!(motion, 2e-14..=1e-13);
    observed!(attitude, 2e-14..=1e-13);
}

#[test]
fn at_rest_and_on_its_head() {
    for (omega, up, kind) in [
        ([0.0; 3], [-1.0, 0.0, 0.0], Kind::SharedUpper),
        ([0.0; 3], [1.0, 0.0, 0.0], Kind::SharedLower),
        ([2.0, 0.0, 0.0], [1.0, 0.0, 0.0], Kind::SharedUpper),
    ] {
        let top = top(omega, up);
        assert_eq!(top.kind(), kind);
        for t in [1.0, 30.0] {
            let state = top.at(t).expect("a state");
            observed!((state.omega - vector(omega)).norm(), 0.0..=1e-15);
            observed!((state.up - vector(up)).norm(), 0.0..=1e-15);
        }
    }
}

#[test]
fn any_unit_of_mass_length_and_time() {
    let plain = top([1.0, 0.5, 0.3], [2.0, -1.0, 2.0]);
    let expected = plain.at(3.0).expect("a state");
    for power in [-300, -60, -1, 1, 60, 300] {
        // Powers of two: exact, so the same digits must come out.
        let (mass, rate) = (2_f64.powi(power), 2_f64.powi(power / 3));
        let scaled = KovalevskayaTop::with_up(
            MOMENTS.map(|i| i * mass),
            vector(LEVER) * (mass * rate * rate),
            vector([1.0, 0.5, 0.3]) * rate,
            vector([2.0, -1.0, 2.0]),
        )
        .expect("a top");
        let found = scaled.at(3.0 / rate).expect("a state");
        assert_eq!(found.omega, expected.omega * rate);
        assert_eq!((found.up, found.attitude), (expected.up, expected.attitude));
    }
}
