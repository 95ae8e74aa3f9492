//! The tug, friction and rolling resistance, each absent and at zero.

use super::*;
use spinning_bodies::scene::{Spooling, TuggedSpool};

fn spool() -> Spool {
    Spool::new(RoundBody::new(0.2, 0.05, 0.5).unwrap(), 0.02).unwrap()
}

fn reel() -> TuggedSpool {
    TuggedSpool::new(spool(), 9.81).unwrap().moving(-0.5, 0.8)
}

fn run(scene: &impl Scene<State = Spooling>) -> Motion<Spooling> {
    agreed(scene, times())
}

#[test]
fn each_effect_matters_and_fades() {
    let tug = |tension| Effect::from(Tug::new(tension, 1.0).unwrap());
    let mu = |value| Effect::from(Coulomb::new(value).unwrap());
    let felt = |c| Effect::from(RollingResistance::new(c).unwrap());
    let with = |effects: &[Effect]| {
        let add = |spool: TuggedSpool, effect: &Effect| spool.with(effect.clone()).unwrap();
        effects.iter().fold(reel(), add)
    };
    let alone = run(&reel());
    assert_eq!(alone.plan.solver, Solver::Exact);
    let pulled = run(&with(&[tug(0.3)]));
    assert!(same(&alone, &pulled) > 0.1);
    assert_eq!(same(&alone, &run(&with(&[tug(0.0)]))), 0.0);
    let held = run(&with(&[tug(0.3), mu(0.4)]));
    assert!(same(&pulled, &held) > 0.1);
    // The slip passes through zero on the way, an event more: rounding. Observed: 4e-16.
    assert!(same(&pulled, &run(&with(&[tug(0.3), mu(0.0)]))) < 2e-15);
    let slowed = run(&with(&[tug(0.3), mu(0.4), felt(0.01)]));
    assert!(same(&held, &slowed) > 1e-3);
    // Events more than without: rounding.
    assert!(same(&held, &run(&with(&[tug(0.3), mu(0.4), felt(0.0)]))) < 2e-15);
    assert_eq!(same(&held, &run(&with(&[mu(0.4), tug(0.3)]))), 0.0);
}

#[test]
fn a_lifted_spool_is_refused() {
    refused!(reel().with(Tug::new(2.1, 1.4).unwrap()), NotPositive);
}

/// The force that rolling takes lies between what holds a spool and what slows one that slides.
#[test]
fn a_spool_that_rolls_rolls_on() {
    let (tension, angle) = (0.5, 0.5_f64);
    let rolling = TuggedSpool::new(spool(), 9.81).unwrap().moving(0.3, 0.3);
    let tugged = rolling.with(Tug::new(tension, angle).unwrap()).unwrap();
    let scene = tugged.with(Coulomb::with_grip(0.1, 0.3).unwrap()).unwrap();
    let (t, motion) = scene.simulate(&Request::at([1.5]).unwrap()).unwrap().rows[0];
    let acceleration = tension * (angle.cos() - 0.4) / (0.2 * 1.5);
    let place = 0.3 * t + 0.5 * acceleration * t * t;
    assert!((motion.moment.position - place).abs() < 1e-15);
}

/// At the critical angle pull and twist balance, and what is left is rounding: that is no reason to refuse an answer.
#[test]
fn a_spool_at_the_critical_angle_stays() {
    let tug = Tug::new(0.3, spool().critical_angle().unwrap()).unwrap();
    let tugged = TuggedSpool::new(spool(), 9.81).unwrap().with(tug).unwrap();
    let scene = tugged.with(Coulomb::new(0.5).unwrap()).unwrap();
    let motion = run(&scene);
    let mut places = motion.rows.iter().map(|row| row.1.moment.position);
    assert!(places.all(|place| place.abs() < 1e-15));
    assert!(motion.error_estimate < 1e-13);
}
