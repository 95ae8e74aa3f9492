//! Sliding: on ice nobody gets anywhere, with a little friction anybody does.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use spinning_bodies::integrators::{Effort, Method, solve};
use spinning_bodies::phenomena::crawler::{self, Strokes};
use spinning_bodies::phenomena::ice::{PARTS, Part, Wriggler, feet};
use spinning_bodies::scene::{Request, Scene, shape};

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
