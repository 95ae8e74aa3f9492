//! Sliding: on ice nobody gets anywhere, with a little friction anybody does.

use super::*;
use spinning_bodies::phenomena::{Crawler, PARTS, Part, Strokes, Wriggler, feet};
use spinning_bodies::scene::effects::Coulomb;

// claim: C1.1-1
#[test]
fn s1_1_no_wriggling_moves_the_centre() {
    for seed in 0..20 {
        let body = Wriggler::random(seed);
        let times: Vec<f64> = (0..=60).map(|k| f64::from(k) * 0.1).collect();
        let start = &body.start;
        let (scales, effort) = ([1.0; 4 * PARTS], Effort::Tolerance(1e-10));
        let run = order_eight(&body, Kept::Nothing, start, &scales, &times, effort).unwrap();
        let center = body.center(start);
        let mut travelled = 0.0_f64;
        for state in &run.states {
            let now = body.center(state);
            let drift = (now[0] - center[0]).hypot(now[1] - center[1]);
            // Rounding of some thousand steps, not the tolerance of the method. Observed: 9e-15 m.
            observed!(drift, 1e-15..=3e-14, "seed {seed}: {drift:e}");
            for part in 0..PARTS {
                let [x, y] = [2 * part, 2 * part + 1].map(|k| state[k] - start[k]);
                travelled = travelled.max(x.hypot(y));
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

/// A loop of shapes, and how fast it is run through: lean and arms, each a wave of its own overtones.
fn wriggle(overtone: i32, s: f64) -> ([f64; 2], [f64; 2]) {
    let n = f64::from(overtone);
    let ([sine, cosine], [wave, coast]) = ([s.sin(), s.cos()], [(n * s).sin(), (n * s).cos()]);
    let (lean, arms) = (0.6 * sine + 0.2 * coast, 0.4 * (1.0 - cosine) + 0.1 * wave);
    let rates = [0.6 * cosine - 0.2 * n * wave, 0.4 * sine + 0.1 * n * coast];
    ([lean, arms], rates)
}

// claim: C1.1-2, C1.1-11
#[test]
fn s1_1_picture_a_a_closed_cycle_of_shapes_brings_the_feet_back() {
    let center = [0.3, 1.0];
    assert!(feet(&[], center).is_err());
    // The parts' velocities from the feet, when the posture changes at these rates: `person` is linear in both.
    let moment_rate = |[lean, arms]: [f64; 2]| -> f64 {
        let parts = person(lean, arms).into_iter().zip(person(0.0, 0.0));
        let moments = parts.map(|(a, b)| a.mass * (a.from_feet[0] - b.from_feet[0]));
        moments.sum()
    };
    for overtone in 2..7 {
        // No momentum: the sum of m (F′ + x′) is zero. That constraint is integrated round the loop, as is that of the swivel with
        // the same steps, A = 2 + lean/2 and ψ = arms.
        let slide = |s: f64| -moment_rate(wriggle(overtone, s).1) / 80.0;
        let swivel = |s: f64| {
            let ([lean, _], [_, twist]) = wriggle(overtone, s);
            -(2.0 + 0.5 * lean) / (3.0 + 0.5 * lean) * twist
        };
        let shape = |s: f64| {
            let [lean, arms] = wriggle(overtone, s).0;
            person(lean, arms)
        };
        let home = feet(&shape(0.0), center).unwrap()[0];
        let (mut place, mut turned, mut furthest) = (home, 0.0, 0.0_f64);
        let h = TAU / 1000.0;
        for k in 0..1000 {
            let s = h * f64::from(k);
            let simpson =
                |f: &dyn Fn(f64) -> f64| h / 6.0 * (f(s) + 4.0 * f(s + 0.5 * h) + f(s + h));
            place += simpson(&slide);
            turned += simpson(&swivel);
            let parts = shape(s + h);
            // Simpson's error, h⁴/2880 times the change of the third derivative: 1.4e-10 for the sixth wave. Observed: 1.3e-10.
            let now = feet(&parts, center).unwrap()[0];
            near!(now, place, 2e-10);
            furthest = furthest.max((place - home).abs());
            // The centre of what is drawn is where it was: one vertical line through all drawings.
            let moments = parts.map(|p| p.mass * (place + p.from_feet[0]));
            near!(moments.iter().sum::<f64>() / 80.0, center[0], 2e-10);
        }
        assert!(furthest > 0.2, "the feet moved on the way: {furthest}");
        near!(place, home, 0.0..=7e-15, "{:e}", place - home);
        // The same loop turns a swivel.
        assert!(turned.abs() > 1e-2);
    }
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
    let body = Crawler::new(3.0, 1.0, strokes).unwrap();
    let times: Vec<f64> = (0..=40).map(|k| f64::from(k) * strokes.cycle()).collect();
    let request = Request::at(times).unwrap();
    let still = shape::Crawler::new(body);
    let ice = still.simulate(&request).unwrap();
    assert!(ice.rows.iter().all(|(_, s)| s.center == 0.0));
    let drift = |mu: f64| {
        let heavy = still.with(Gravity::new(9.81).unwrap()).unwrap();
        let rough = heavy.with(Coulomb::new(mu).unwrap()).unwrap();
        let motion = rough.simulate(&request).unwrap();
        let [a, b] = [20, 40].map(|k| motion.rows[k].1.center);
        (b - a) / 20.0
    };
    assert_eq!(drift(0.0), 0.0);
    let drifts = [0.01, 0.02, 0.05, 0.1, 0.2].map(drift);
    // Metres a cycle; none is more than a heavy foot that never slips would make, 1/4 of a stroke.
    let slow = drifts.iter().all(|d| (0.02..0.05).contains(d));
    assert!(slow, "{drifts:?}");
}
