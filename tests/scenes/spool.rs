//! The tug, friction and rolling resistance, each absent and at zero.

use spinning_bodies::Error;
use spinning_bodies::integrators::Method;
use spinning_bodies::rolling::RoundBody;
use spinning_bodies::rolling::course::{Coulomb, RollingResistance};
use spinning_bodies::rolling::spool::{Spool, Tug};
use spinning_bodies::scene::spool::{Spooling, TuggedSpool};
use spinning_bodies::scene::{Choice, Motion, Scene, Solver};

use super::roller::{balance, same, times};

fn reel() -> TuggedSpool {
    let spool = Spool::new(RoundBody::new(0.2, 0.05, 0.5).unwrap(), 0.02).unwrap();
    TuggedSpool::new(spool, 9.81).unwrap().moving(-0.5, 0.8)
}

fn run(scene: &impl Scene<State = Spooling>) -> Motion<Spooling> {
    let exact = scene.simulate(&times()).unwrap();
    let dop853 = Choice::Use(Solver::General(Method::Dop853));
    let found = scene.simulate(&times().by(dop853)).unwrap();
    assert!(same(&exact, &found) < 1e-12, "{:e}", same(&exact, &found));
    assert!(balance(&exact) < 1e-13 && balance(&found) < 1e-12);
    exact
}

#[test]
fn each_effect_matters_and_fades() {
    let tug = |tension| Tug::new(tension, 1.0).unwrap();
    let mu = |value| Coulomb::new(value).unwrap();
    let alone = run(&reel());
    assert_eq!(alone.plan.solver, Solver::Exact);
    let pulled = run(&reel().with_tug(tug(0.3)));
    assert!(same(&alone, &pulled) > 0.1);
    assert_eq!(same(&alone, &run(&reel().with_tug(tug(0.0)))), 0.0);
    let held = run(&reel().with_tug(tug(0.3)).with_friction(mu(0.4)));
    assert!(same(&pulled, &held) > 0.1);
    // The slip passes through zero on the way, an event more: rounding. Observed: 4e-16.
    let slippery = run(&reel().with_tug(tug(0.3)).with_friction(mu(0.0)));
    assert!(same(&pulled, &slippery) < 2e-15);
    let felt = |c| RollingResistance::new(c).unwrap();
    let scene = reel().with_tug(tug(0.3)).with_friction(mu(0.4));
    let slowed = run(&scene.with_resistance(felt(0.01)));
    assert!(same(&held, &slowed) > 1e-3);
    // Events more than without: rounding.
    assert!(same(&held, &run(&scene.with_resistance(felt(0.0)))) < 2e-15);
    let other = reel().with_friction(mu(0.4)).with_tug(tug(0.3));
    assert_eq!(same(&held, &run(&other)), 0.0);
}

#[test]
fn a_lifted_spool_is_refused() {
    let scene = reel().with_tug(Tug::new(2.1, 1.4).unwrap());
    assert!(matches!(
        scene.simulate(&times()),
        Err(Error::NotPositive { .. })
    ));
}
