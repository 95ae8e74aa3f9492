//! The chiral tippe top: turned over one way only, its mirror image the other way, its symmetric relatives alike both ways.

use super::*;
use spinning_bodies::rolling::Coulomb;
use spinning_bodies::tippe_top::{Friction, beads, chirality_index};

const SPIN: f64 = 132.9;

fn leaning(azimuth: f64, spin: f64) -> Start {
    Start::about_vertical(3f64.to_radians(), azimuth, spin).unwrap()
}

fn index(inertia: Matrix3<f64>) -> f64 {
    let body = bodies::eccentric_ball(0.02, 0.02, 0.19, inertia).unwrap();
    let unit: f64 = 0.02 * 0.02 * 0.02;
    chirality_index(body.inertia(), body.center()).unwrap() / unit.powi(3)
}

#[test]
fn s4_7_chirality_index() {
    // claim: C4.7-14
    let i = bodies::chiral_top().unwrap().inertia().matrix() / 0.02_f64.powi(3);
    let chi = index(i);
    close!(chi, 3.84e-6, 0.0..=2e-14);
    let closed = i[(0, 1)] * (i[(0, 2)].powi(2) - i[(1, 2)].powi(2))
        + i[(0, 2)] * i[(1, 2)] * (i[(1, 1)] - i[(0, 0)]);
    close!(chi, closed, 0.0..=2e-14);
    let body = bodies::chiral_top().unwrap();
    let image = body.mirrored();
    let [mirrored, own] =
        [&image, &body].map(|body| chirality_index(body.inertia(), body.center()).unwrap());
    close!(mirrored, -own, 0.0..=1e-12);
    let principal = body.inertia().principal_axes();
    for (expected, moment) in [0.41469, 0.48380, 0.53151].iter().zip(principal.moments) {
        near!(moment / 8e-6, expected, 1e-6..=5e-6);
    }
    let axis = principal.axes.column(2).into_owned();
    near!(axis.z.abs().acos().to_degrees(), 8.39, 1e-3..=0.005);
    // Controls: any one product alone, or two planes of symmetry, has none.
    for (a, b, c) in [(0.0, 0.0, 0.0), (0.017, 0.0, 0.0), (0.0, -0.008, 0.0)] {
        let control = Matrix3::new(0.48, a, b, a, 0.42, c, b, c, 0.53);
        observed!(index(control).abs(), 0.0..=1e-17);
    }
}

/// So many seconds of the sense in which it stands, by friction that creeps at this speed where it should roll.
fn standing(slip: f64, seconds: u32) -> Vec<(f64, State)> {
    let law = Regularised::new(0.3, slip).unwrap();
    let body = bodies::chiral_top().unwrap();
    let scene = on_a_table(body, leaning(0.0, SPIN), G, law);
    run(&scene, f64::from(seconds), 10 * seconds, 1e-3)
}

#[test]
fn s4_7_the_other_sense_creeps_until_it_goes_over() {
    // claim: C4.7-14
    let creeps = standing(1e-3, 50);
    assert!(most(&creeps[..400], degrees) < 20.0 && degrees(&creeps[500].1) > 90.0);
    near!(creeps[420].1.spin() / SPIN, 0.75, 5e-4..=0.01);
}

#[test]
fn s4_7_with_a_tenth_of_the_creeping_it_stands() {
    // claim: C4.7-14
    let rolls = standing(1e-4, 60);
    assert!(most(&rolls, degrees) < 10.0);
    near!(last(&rolls).spin() / SPIN, 0.9, 3e-4..=0.01);
}

#[test]
fn s4_7_beads_that_build_it() {
    // claim: C4.7-14
    let body = bodies::chiral_top().unwrap();
    let compare = |places: [BodyVector; 3], within: f64| {
        let [a, b, c] = places;
        let places = [a, -a, b, -b, c, -c];
        let parts = places.map(|p| MassProperties::particle(0.02 / 6.0, p).unwrap());
        let built = MassProperties::compose(&parts).unwrap();
        let apart = (built.inertia().matrix() - body.inertia().matrix()).amax() / 8e-6;
        assert!(apart < within, "{apart:e}");
        let farthest = greatest(places.map(|p| (p - body.center()).norm() / 0.02));
        assert!(farthest < 1.0, "inside the ball");
        farthest
    };
    // The frame of the models, to the four digits printed there.
    let printed = [
        [0.1017, -0.0371, -0.7340],
        [0.7959, 0.2245, 0.0989],
        [0.2474, -0.9128, 0.0805],
    ];
    let printed = printed.map(|place| vector(place) * 0.02);
    near!(compare(printed, 1e-4), 0.984, 1e-4..=5e-4);
    let own = beads(0.02, body.inertia(), &Attitude::identity()).unwrap();
    compare(own, 1e-14);
    let turn = Attitude::about_axis(vector([1.0, 2.0, 3.0]), 0.2).unwrap();
    compare(beads(0.02, body.inertia(), &turn).unwrap(), 1e-14);
}

#[test]
fn s4_7_chiral_top_turns_over_one_way_only() {
    // claim: C4.7-14
    let body = bodies::chiral_top().unwrap();
    for (mu, most_up, ends_up, horizontal, ends_over) in [
        (0.3, 10.8, 1.6, 1.50, 175.0),
        (0.2, 16.3, 3.4, 2.18, 175.5),
        (0.1, 19.0, 7.9, 4.08, 174.5),
    ] {
        let scene = |body, start| on_a_table(body, start, G, regularised(mu));
        let [stays, turns] =
            [SPIN, -SPIN].map(|spin| run(&scene(body, leaning(0.0, spin)), 10.0, 2500, 1e-5));
        let over = passage(&turns, degrees, 90.0).unwrap();
        // The models do not say in which azimuth the release is tilted; theirs and ours differ in the last digit printed.
        assert!((most(&stays, degrees) - most_up).abs() < 0.15);
        assert!((degrees(&last(&stays)) - ends_up).abs() < 0.15);
        observed!((over / horizontal - 1.0).abs(), 1e-3..=0.01);
        assert!((degrees(&last(&turns)) - ends_over).abs() < 1.0);
        for rows in [&stays, &turns] {
            // No hopping is involved.
            assert!(-most(rows, |s| -s.reaction) > 0.85 * 0.02 * G);
        }
        if mu == 0.3 {
            near!(last(&stays).spin(), 124.9, 9e-3..=0.1);
            near!(passage(&turns, degrees, 150.0).unwrap(), 1.66, 1e-3..=0.02);
            // The mirror image does the same with the senses exchanged.
            let image = scene(body.mirrored(), leaning(0.0, -SPIN).mirrored());
            let image = run(&image, 2.0, 500, 1e-5);
            assert!(image[0].1.spin() > 0.0);
            for (a, b) in turns.iter().zip(&image) {
                near!(a.1.tilt(), b.1.tilt(), 2e-9..=8e-8);
            }
        }
    }
}

#[test]
fn s4_7_controls_tip_alike_both_ways() {
    // claim: C4.7-14
    for (a, b, turns) in [(0.0, 0.0, false), (0.017, 0.0, false), (0.0, -0.008, true)] {
        let inertia = Matrix3::new(0.48, a, b, a, 0.42, 0.0, b, 0.0, 0.53);
        let body = bodies::eccentric_ball(0.02, 0.02, 0.19, inertia).unwrap();
        let rows_of = |start| {
            let scene = on_a_table(body, start, G, regularised(0.3));
            run(&scene, 4.0, 800, 1e-6)
        };
        let start = leaning(0.3, SPIN);
        let rows = rows_of(start);
        assert_eq!(most(&rows, degrees) > 90.0, turns);
        // Only the plane across CK is one of symmetry: half a turn about CK maps the body to itself, no mirror through CK does.
        if b == 0.0 && a != 0.0 {
            continue;
        }
        // The release reflected along with the spin, in the plane that is principal.
        let mirrored = rows_of(start.mirrored());
        assert!(mirrored[0].1.spin() < 0.0);
        for (p, q) in rows.iter().zip(&mirrored) {
            near!(p.1.tilt(), q.1.tilt(), 0.0..=1e-3, "at {}", p.0);
        }
    }
}

/// Units of time and speed of the growth rates.
fn natural() -> (f64, f64) {
    ((G / 0.02).sqrt(), (G * 0.02).sqrt())
}

#[test]
fn s4_7_growth_rates_of_first_and_second_order_in_friction() {
    // claim: C4.7-14
    let (rate, speed) = natural();
    let body = bodies::chiral_top().unwrap();
    let swing = |mu: f64, sense: f64| {
        let law = Regularised::new(mu, 1e-3 * speed).unwrap();
        let state = quasi_steady(&body, G, law, sense * 6.0 * rate).unwrap();
        let drift = state.spin_rate.abs() / (6.0 * rate * rate);
        assert!(state.tilt.to_degrees() > 2.6 && state.tilt.to_degrees() < 8.2);
        (state.slow_swing.growth / rate, drift)
    };
    for (mu, plus, minus) in [
        (0.025, -0.00038, 0.00210),
        (0.05, -0.00275, 0.00756),
        (0.1, -0.01188, 0.03312),
        (0.2, -0.04486, 0.16776),
    ] {
        let ((p, drift), (m, _)) = (swing(mu, 1.0), swing(mu, -1.0));
        // The state drifts: rates are defined up to the relative loss of spin, alike for both senses.
        assert!((p - plus).abs() < drift && (m - minus).abs() < drift);
        let half = |a: f64, b: f64| 0.5 * (b - a);
        observed!((half(p, m) / half(plus, minus) - 1.0).abs(), 5e-3..=0.02);
    }
    // Handedness: slope two. What both senses share: slope one for small friction.
    let split = |mu: f64| {
        let (p, m) = (swing(mu, 1.0).0, swing(mu, -1.0).0);
        (0.5 * (m - p), 0.5 * (m + p))
    };
    let mus = [0.0015625, 0.003125, 0.00625, 0.0125, 0.025, 0.05];
    for pair in mus.windows(2) {
        let ((odd, even), (odd_2, even_2)) = (split(pair[0]), split(pair[1]));
        assert!((odd_2 / odd).log2() > 1.95 && (odd_2 / odd).log2() < 2.12);
        if pair[1] < 0.01 {
            observed!(((even_2 / even).log2() - 1.0).abs(), 4e-3..=0.1);
        }
    }
}

#[test]
fn a_handedness_beyond_the_doubles_is_refused() {
    let skew = Matrix3::new(0.48, 0.01, 0.02, 0.01, 0.42, 0.03, 0.02, 0.03, 0.53);
    let huge = InertiaMatrix::from_matrix(skew * 1e150).unwrap();
    let axis = BodyVector::new(0.0, 0.0, 1.0);
    refused!(
        chirality_index(&huge, axis),
        NotFinite,
        "the chirality index"
    );
}

/// Where friction has a corner there is nothing to differentiate, and no state without it stands for one.
#[test]
fn a_law_without_a_derivative_has_no_growth_rates() {
    let top = bodies::chiral_top().unwrap();
    for law in [Coulomb::new(0.3).unwrap().into(), Friction::NoSlip] {
        let state = quasi_steady(&top, 9.82, law, SPIN);
        refused!(state, NotPositive, "the slip over which friction bends");
    }
}
