//! Friction, rolling resistance and the sheet, each absent and at zero, and in another order.

use super::*;
use spinning_bodies::scene::{Roller, Rolling};

pub fn times() -> Request {
    Request::at([2.0, 0.0, 0.1, 0.3, 0.7, 1.5]).unwrap()
}

pub fn same<S: Tabulated>(a: &Motion<S>, b: &Motion<S>) -> f64 {
    let rows = a.rows.iter().zip(&b.rows);
    let pairs = rows.flat_map(|(x, y)| x.1.row().into_iter().zip(y.1.row()));
    greatest(pairs.map(|(x, y)| (x - y).abs()))
}

pub fn balance<S>(motion: &Motion<S>) -> f64 {
    let entries = motion.ledger.entries().iter();
    greatest(entries.map(|e| e.relative_drift()))
}

/// The closed form's run, or that from event to event; DOP853 agrees with it, and both balance.
pub fn agreed<S: Tabulated>(scene: &impl Scene<State = S>, times: Request) -> Motion<S> {
    let exact = scene.simulate(&times).unwrap();
    let found = by_general(times, Method::Dop853);
    let found = scene.simulate(&found).unwrap();
    assert!(same(&exact, &found) < 1e-12, "{:e}", same(&exact, &found));
    assert!(balance(&exact) < 1e-13 && balance(&found) < 1e-12);
    exact
}

fn thrown() -> Roller {
    let ball = RoundBody::new(0.17, 0.028_575, 0.4).unwrap();
    Roller::new(ball, 9.81, 1.0, -4.0).unwrap()
}

fn with<const N: usize>(effects: [Effect; N]) -> Roller {
    let add = |roller: Roller, effect| roller.with(effect).unwrap();
    effects.into_iter().fold(thrown(), add)
}

fn mu(value: f64) -> Coulomb {
    Coulomb::new(value).unwrap()
}

fn run(scene: &impl Scene<State = Rolling>) -> Motion<Rolling> {
    let exact = agreed(scene, times());
    assert!(exact.ledger.entries().len() >= 2);
    exact
}

#[test]
fn each_effect_matters_and_fades() {
    let none = run(&thrown());
    assert_eq!(none.plan.solver, Solver::Exact);
    let rubbed = run(&with([mu(0.2).into()]));
    assert_eq!(rubbed.plan.solver, Solver::Events);
    assert!(same(&none, &rubbed) > 0.1);
    // μ = 0 to the bit; a small μ by as much as it is small.
    assert_eq!(same(&none, &run(&with([mu(0.0).into()]))), 0.0);
    let little = same(&none, &run(&with([mu(1e-9).into()])));
    assert!(little > 0.0 && little < 1e-7);

    let felt = |c| Effect::from(RollingResistance::new(c).unwrap());
    let both = with([mu(0.2).into(), felt(0.01)]);
    assert!(same(&rubbed, &run(&both)) > 1e-3);
    let zero = with([mu(0.2).into(), felt(0.0)]);
    // The spin's passage through zero is an event more: rounding.
    assert!(same(&rubbed, &run(&zero)) < 1e-15);
    let other = with([felt(0.01), mu(0.2).into()]);
    assert_eq!(same(&run(&both), &run(&other)), 0.0);

    let speeds = SheetSpeeds::ramp(3.0, 0.02).unwrap();
    let still = SheetSpeeds::through([(0.0, 0.0)]).unwrap();
    let sheet = |law, speeds| Effect::from(Sheet::new(law, speeds, 0.5).unwrap());
    let pulled = with([mu(0.2).into(), sheet(mu(0.3), speeds)]);
    assert!(same(&rubbed, &run(&pulled)) > 0.1);
    // A sheet of the table's friction that stays where it is, is table.
    let resting = with([mu(0.2).into(), sheet(mu(0.2), still)]);
    assert!(same(&rubbed, &run(&resting)) < 1e-15);
}

#[test]
fn what_a_roller_refuses() {
    let resistance = RollingResistance::new(0.01).unwrap();
    let scene = with([mu(0.2).into(), resistance.into()]);
    refused!(scene.simulate(&Request::at([-1.0]).unwrap()), OutOfRange);
    let exact = times().by(Choice::Use(Solver::Exact));
    refused!(scene.simulate(&exact), Solver);
    assert!(thrown().simulate(&exact).is_ok());
    let general = [Method::Rk4, Method::Dopri5, Method::Verner98].map(Solver::General);
    for solver in general.into_iter().chain([OURS]) {
        let motion = scene.simulate(&using(&times(), solver)).unwrap();
        let (off, told) = (same(&motion, &run(&scene)), motion.error_estimate);
        // The fastest of its speeds is 4 m/s.
        let said = format!("{solver}: {off:e} of {told:e}");
        assert!(off < 1e-12 && off <= 4.0 * told, "{said}");
    }
    let friction = thrown().with(BearingFriction::new(0.1).unwrap());
    let told = friction.unwrap_err().to_string();
    let named = ["bearing_friction", "sheet"].map(|effect| told.contains(effect));
    assert_eq!(named, [true; 2], "{told}");
}

/// The numbers of a ball at rest are rounding, and asked for alone they are answered all the same.
#[test]
fn a_ball_that_a_gentle_pull_has_left_behind() {
    let ball = RoundBody::new(0.17, 0.028_575, 0.4).unwrap();
    let speeds = SheetSpeeds::ramp(1.0, 2.0).unwrap();
    let sheet = Sheet::new(mu(0.3), speeds, 1.5).unwrap();
    let still = Roller::new(ball, 9.8, 0.0, 0.0).unwrap();
    let scene = still.clone().with(mu(0.2)).unwrap().with(sheet).unwrap();
    let motion = scene.simulate(&Request::at([9.0]).unwrap()).unwrap();
    assert!(motion.rows[0].1.moment.velocity.abs() < 1e-15);
    assert!(motion.error_estimate < 1e-12);
    // Thrown back in a tenth of a millisecond: the slip is still that of the speeds.
    let speeds = [(0.0, 0.0), (0.034, 0.29), (0.0341, -0.18)];
    let sheet = Sheet::new(mu(0.1), SheetSpeeds::through(speeds).unwrap(), 0.5).unwrap();
    let thrown = still.with(sheet).unwrap();
    let thrown = thrown.simulate(&asking([0.0342], 1e-9)).unwrap();
    let end = thrown.rows[0].1.moment;
    near!(end.slip, end.velocity - end.rim_speed + 0.18, 1e-16);
}

/// It spins on the spot until the couple has stopped it, and the slip with it.
#[test]
fn friction_of_nothing_beside_rolling_resistance() {
    let ball = RoundBody::new(0.17, 0.028_575, 0.4).unwrap();
    let scene = Roller::new(ball, 9.81, 0.0, -1.0).unwrap();
    let scene = scene.with(mu(0.0)).unwrap();
    let scene = scene.with(RollingResistance::new(0.1).unwrap()).unwrap();
    let motion = agreed(&scene, times());
    assert_eq!(motion.rows[0].1.moment.rim_speed, 0.0);
}
