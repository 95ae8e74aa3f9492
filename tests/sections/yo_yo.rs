//! Tutorial 4.9: how does a yo-yo work?

use super::*;
use spinning_bodies::scene::effects::{AirDrag, AxleFriction, Gravity, Sleep};
use spinning_bodies::scene::{Phase, Play, Request, Scene};
use spinning_bodies::yo_yo::{Turn, Unwinding, YoYo, sleeping_spin, spin_after_waking};

const G: f64 = 9.81;

/// The register's disc: R = 3 cm, r = 0.5 cm, 1 m of string.
fn disc() -> YoYo {
    YoYo::disc(0.1, 0.03, 1.0, 0.005).unwrap()
}

/// The toy of the book: 55 g, R = 29 mm, r = 5 mm.
pub fn toy() -> YoYo {
    YoYo::disc(0.055, 0.029, 1.0, 0.005).unwrap()
}

/// The same with a string that fills the gap up to 10 mm, on an axle of 4 mm.
pub fn thick() -> YoYo {
    let thin = YoYo::disc(0.055, 0.029, 1.0, 0.004).unwrap();
    thin.wound_to(0.010).unwrap()
}

fn let_go(toy: YoYo) -> Unwinding {
    Unwinding::new(toy, G, 0.0).unwrap()
}

// claim: C4.9-1
#[test]
fn s4_9_the_way_down() {
    let toy = disc();
    close!(toy.acceleration(0.5, 100.0, G), G / 19.0, 3e-16);
    close!(toy.tension(0.5, 100.0, G), 18.0 / 19.0 * 0.1 * G, 3e-16);
    let way = let_go(toy);
    // cm/s and rad/s of the register. Observed: 2e-16.
    close!(way.speed(1.0), 1.016_184_815_349_731_8, 5e-16);
    close!(way.omega(1.0), 203.236_963_069_946_35, 5e-16);
    // An axle of no thickness hardly falls at all.
    let thin = YoYo::disc(0.1, 0.03, 1.0, 1e-6).unwrap();
    observed!(thin.acceleration(0.5, 0.0, G), 7e-9..=3e-8);
}

// claim: C4.9-1
#[test]
fn s4_9_the_thick_string_in_closed_form() -> Result<()> {
    // Against the equations of motion by order 8: depth, velocity. a(x, ω) is the acceleration of the physics, V = r ω.
    let [little, much] = [0.0050001, 0.1].map(|outer| toy().wound_to(outer).unwrap());
    for toy in [thick(), toy(), little, much] {
        for (gravity, throw) in [(G, 0.0), (G, 0.3), (G, 3.0), (0.0, 1.0), (1e-3, 1.0)] {
            let energy = Unwinding::energy_at(&toy, gravity, 0.0, throw)?;
            let way = Unwinding::new(toy, gravity, energy)?;
            let duration = way.duration()?;
            let system = |_: f64, y: &[f64; 2]| {
                let omega = y[1] / toy.radius(y[0]);
                [y[1], toy.acceleration(y[0], omega, gravity)]
            };
            let times = [0.1, 0.5, 0.9].map(|part| part * duration);
            let effort = Effort::Tolerance(1e-14);
            let start = [0.0, throw];
            let run = order_eight(&system, Kept::Nothing, &start, &[1.0; 2], &times, effort);
            for (t, y) in times.iter().zip(run?.states) {
                let [depth, _] = way.at(*t)?;
                // Observed: 4e-14, the error of order 8.
                let bound = 2e-13;
                near!(depth, y[0], bound);
                assert!((way.speed(depth) - y[1]).abs() < 5.0 * bound);
                close!(way.time_at(depth)?, *t, 1e-14);
            }
        }
    }
    // The thin string is the limit of the thick one. Observed: as far apart as the strings are thick.
    let nearly = toy().wound_to(0.005 * (1.0 + 1e-13))?;
    close!(let_go(nearly).duration()?, let_go(toy()).duration()?, 1e-12);
    Ok(())
}

// claim: C4.9-1
#[test]
fn s4_9_energy_and_the_pull_of_the_thick_string() {
    let toy = thick();
    let way = let_go(toy);
    for k in 0..=100 {
        let depth = f64::from(k) / 100.0;
        let kinetic = toy.kinetic_energy(depth, way.omega(depth));
        near!(kinetic, 0.055 * G * depth, 0.0..=3e-16);
        let omega = way.omega(depth);
        let pull = 0.055 * (G - toy.acceleration(depth, omega, G));
        close!(toy.tension(depth, omega, G), pull, 2e-15);
    }
    // At the end the string brakes: more than the weight hangs on it.
    assert!(toy.tension(1.0, way.omega(1.0), G) > 1.1 * 0.055 * G);
}

// claim: C4.9-2
#[test]
fn s4_9_the_turn() {
    let toy = disc();
    let omega = let_go(toy).omega(1.0);
    let turn = Turn::new(toy, G, omega).unwrap();
    let weight = 0.1 * G;
    let mean = turn.mean_tension_at_constant_spin / weight;
    close!(mean, 14.402_521_523_528_028, 5e-16);
    // Spin before and after are the same, the velocity of the centre is reversed, and the sense of the spin is kept.
    let [first, last] = [0.0, turn.duration].map(|t| turn.at(t).unwrap());
    close!(first.omega, omega, 5e-16);
    close!(last.omega, omega, 5e-16);
    close!(first.velocity, let_go(toy).speed(1.0), 5e-16);
    close!(last.velocity, -first.velocity, 5e-16);
    observed!(first.angle.abs(), 0.0..=1e-15);
    near!(last.angle, PI, 0.0..=1e-15);
    // The true pendulum is 0.16 per cent faster than the constant spin on the average, and pulls as much harder.
    let exact = turn.mean_tension / weight;
    near!(exact, 14.4238, 7e-6..=5e-5, "{exact}");
    // By the impulse: twice the momentum and the weight, over the time. The tension itself, summed over the turn, says the same.
    let steps = 2000;
    let parts = (0..steps).map(|k| (f64::from(k) + 0.5) / f64::from(steps));
    let tensions = parts.map(|part| turn.at(part * turn.duration).unwrap().tension);
    let sum: f64 = tensions.sum();
    close!(sum / f64::from(steps) / weight, exact, 1e-6);
    // The pull begins and ends with that of the unwinding.
    close!(first.tension, toy.tension(1.0, omega, G), 1e-14);
}

// claim: C4.9-2
#[test]
fn s4_9_the_turn_against_its_equation_of_motion() {
    // α'' = n cos α from α = 0.
    let toy = toy();
    for omega in [6.0, 20.0, 210.0, 5000.0] {
        let turn = Turn::new(toy, 20.0 * G, omega);
        let Ok(turn) = turn else {
            refused!(turn, Condition);
            assert!(omega < 21.0);
            continue;
        };
        // n = m g r/(I + m r²).
        let pull = 20.0 * G / (0.005 * (1.0 + 16.82));
        let system = |_: f64, y: &[f64; 2]| [y[1], pull * y[0].cos()];
        let time = |k: i32| f64::from(k) / 10.0 * turn.duration;
        let times: Vec<f64> = (0..=10).map(time).collect();
        let effort = Effort::Tolerance(1e-14);
        let (start, scales) = ([0.0, omega], [1.0, omega]);
        let run = order_eight(&system, Kept::Nothing, &start, &scales, &times, effort);
        for (t, y) in times.iter().zip(run.unwrap().states) {
            let state = turn.at(*t).unwrap();
            // Observed: 2e-14.
            near!(state.angle, y[0], 0.0..=1e-13, "{omega} {t}");
            close!(state.omega, y[1], 1e-13);
        }
    }
}

// claim: C4.9-2
#[test]
fn s4_9_the_hand_that_rises_in_the_turn() {
    // The string's end moves up with the speed v sin α. In its frame gravity is g + v α' cos α, and the spin gained is the work done.
    let toy = toy();
    let omega = let_go(toy).omega(1.0);
    let turn = Turn::new(toy, G, omega).unwrap();
    for lift in [1e-3, 0.01] {
        let speed = 0.5 * omega * lift;
        let pull = G / (0.005 * (1.0 + 16.82));
        let r = 0.005;
        let (mass, inertia) = (0.055, 0.5 * 0.055 * 0.029 * 0.029);
        // α, α', height of the end, work of the tension on it.
        let system = |_: f64, y: &[f64; 4]| {
            let up = speed * y[0].sin();
            let boost = speed * y[0].cos() * y[1];
            let spin_up = pull / G * (G + boost) * y[0].cos();
            let centre = boost + r * (y[1] * y[1] * y[0].sin() - spin_up * y[0].cos());
            [y[1], spin_up, up, mass * (G + centre) * up]
        };
        let event = |_: f64, y: &[f64; 4]| PI - y[0];
        let effort = Effort::Tolerance(1e-13);
        let (start, scales) = ([0.0, omega, 0.0, 0.0], [1.0, omega, 1.0, 1.0]);
        let run = leg(&system, (&start, &scales), (&[], 1.0)).follow(Some(&event), effort);
        let [_, after, height, work] = run.unwrap().end;
        let gained = 0.5 * (inertia + mass * r * r) * (after * after - omega * omega);
        // What the hand does is what the yo-yo gains, and what lifting it by `height` takes. Observed: 1e-12.
        assert!((gained + mass * G * height - work).abs() < 1e-10 * work);
        // The formula, without gravity's part. Observed: 0.4 per cent.
        close!(gained, turn.work_of_lift(height), 0.006);
    }
    let work = FRAC_PI_4 * 0.055 * 0.005 * omega * omega * 1e-9;
    close!(turn.work_of_lift(1e-9), work, 1e-7);
}

// claim: C4.9-2
#[test]
fn s4_9_a_loop_lets_it_sleep() -> Result<()> {
    let toy = toy();
    let (inertia, omega) = (0.5 * 0.055 * 0.029 * 0.029, 200.0);
    // Against the equation of motion: closed forms, for friction and air of all proportions, asleep in the scene of the toy.
    for (torque, air) in [
        (0.0, 0.0),
        (1e-4, 0.0),
        (0.0, 1e-8),
        (1e-4, 1e-8),
        (1e-12, 1e-8),
        (1e-4, 1e-16),
    ] {
        let mut scene = Play::new(toy, 3.0)?
            .with(Gravity::new(G)?)?
            .with(Sleep::new(12.0)?)?;
        if torque > 0.0 {
            scene = scene.with(AxleFriction::new(torque)?)?;
        }
        if air > 0.0 {
            scene = scene.with(AirDrag::new(air)?)?;
        }
        let times: Vec<f64> = (0..120).map(|k| 0.1 * f64::from(k)).collect();
        let request = Request::at(times)?.to_accuracy(1e-12)?;
        let rows = scene.simulate(&request)?.rows;
        let asleep = Vec::from_iter(rows.iter().filter(|(_, s)| s.phase == Phase::Asleep));
        let (since, first) = asleep[0];
        for (t, state) in &asleep[1..] {
            // I ω' = −torque − c ω²: ω falls from the tangent of an angle in proportion to the time.
            let (t, omega) = (t - since, first.omega);
            let expected = match (torque > 0.0, air > 0.0) {
                (_, false) => omega - torque * t / inertia,
                (false, _) => omega / (1.0 + air * omega * t / inertia),
                _ => {
                    let terminal = (torque / air).sqrt();
                    let tangent = ((torque * air).sqrt() / inertia * t).tan();
                    (omega - terminal * tangent) / (1.0 + tangent * omega / terminal)
                }
            };
            close!(state.omega, expected, 2e-12);
            if air == 0.0 {
                close!(sleeping_spin(&toy, omega, t, torque), expected, 1e-15);
            }
        }
        assert!(asleep.len() > 100);
    }
    // It stops, and stays so.
    assert_eq!(sleeping_spin(&toy, omega, 1e3, 1e-4), 0.0);
    // The jerk keeps the angular momentum about the end of the string.
    let awake = spin_after_waking(&toy, omega);
    let about_the_end = inertia + 0.055 * 0.005 * 0.005;
    close!(about_the_end * awake, inertia * omega, 5e-16);
    // Falling asleep and waking leave (16.82/17.82)² of the energy of the spin at the bottom.
    let kept = toy.kinetic_energy(1.0, awake) / toy.kinetic_energy(1.0, omega);
    near!(kept, (16.82_f64 / 17.82).powi(2), 0.0..=1e-15);
    Ok(())
}

#[test]
fn what_is_no_yo_yo_is_refused() {
    assert!(YoYo::new(0.0, 1.0, 1.0, 0.1).is_err());
    assert!(YoYo::new(1.0, 1.0, 1.0, 0.6).is_err());
    assert!(toy().wound_to(0.004).is_err());
    assert!(toy().wound_to(f64::NAN).is_err());
    assert!(Unwinding::new(toy(), -1.0, 0.0).is_err());
    assert!(Unwinding::new(toy(), 0.0, 0.0).is_err());
    assert!(Unwinding::new(toy(), G, -1.0).is_err());
    assert!(let_go(toy()).time_at(1.1).is_err());
    assert!(let_go(toy()).at(-1e-9).is_err());
    assert!(Turn::new(toy(), G, 0.0).is_err());
    assert!(Turn::new(toy(), G, 1.0).is_err());
    let turn = Turn::new(toy(), 0.0, 1.0).unwrap();
    near!(turn.duration, PI, 0.0..=1e-15);
    near!(turn.at(FRAC_PI_2).unwrap().angle, FRAC_PI_2, 0.0..=1e-15);
}

#[test]
fn a_pull_beyond_the_doubles_is_refused() {
    let heavy = YoYo::new(1e308, 1e308, 1.0, 0.1).unwrap();
    refused!(
        Turn::new(heavy, G, 100.0),
        NotFinite,
        "the pull of the string"
    );
}
