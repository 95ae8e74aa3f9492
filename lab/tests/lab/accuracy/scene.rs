//! Scenes of any kind: what their judges are worth.

use lab::accuracy::JudgedScene;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::integrators::Method;
use spinning_bodies::rolling::RoundBody;
use spinning_bodies::scene::Roller;
use spinning_bodies::scene::effects::{Coulomb, PivotFriction};
use spinning_bodies::scene::top::{Body, Start, Top};
use spinning_bodies::scene::{AnyScene, Geometric, Solver};

const END: f64 = 5.0;
const SPIN: [f64; 3] = [1.0, -2.0, 2.0];
/// c/I, 1/s.
const RATE: f64 = 0.3;

/// A ball that friction at its pivot brakes: about an axis that stays where it is, Ω = Ω₀ exp(−ct/I).
fn braked() -> JudgedScene {
    let omega = BodyVector::new(SPIN[0], SPIN[1], SPIN[2]);
    let start = Start::with_omega(omega, Attitude::identity());
    let ball = Top::new(Body::new([0.4; 3]).unwrap(), start).unwrap();
    let ball = ball.with(PivotFriction::new(0.4 * RATE).unwrap()).unwrap();
    JudgedScene::new(AnyScene::scene(Box::new(ball)), END).unwrap()
}

/// Its errors, from the numbers of a row.
fn errors(row: &[f64]) -> [f64; 2] {
    let left = (-RATE * END).exp();
    let half = 0.5 * 3.0 * (1.0 - left) / RATE;
    let size = |v: [f64; 3]| v[0].hypot(v[1]).hypot(v[2]);
    let q: [f64; 3] = core::array::from_fn(|k| row[1 + k] - half.sin() * SPIN[k] / 3.0);
    let omega = core::array::from_fn(|k| row[4 + k] - left * SPIN[k]);
    // Twice the chord between unit quaternions; over the greatest rate of the samples, that of the first.
    let fastest = 3.0 * (-RATE * END / 16.0).exp();
    let angle = 2.0 * size(q).hypot(row[0] - half.cos());
    [angle, size(omega) / fastest]
}

#[test]
fn judges_that_step_are_right() {
    let judged = braked();
    let names: Vec<&str> = judged.judges().iter().map(|judge| judge.name()).collect();
    assert_eq!(names, ["dormand-prince-8", "verner98"]);
    assert!(judged.floor() < 1e-12 && judged.has_attitude());
    let mut judged_rows = 0;
    let general = [Method::Rk4, Method::Dopri5, Method::Dop853].map(Solver::General);
    let ours = Solver::Geometric(Geometric::DormandPrince8);
    for solver in general.into_iter().chain([ours]) {
        let efforts = judged.efforts(solver);
        let trial = judged.trial("ball", solver, &efforts, 1_000_000);
        let rows = trial.sweep(|rows, effort| {
            let more = rows.last().is_none_or(|row| row.evaluations < 20_000);
            more.then(|| trial.measure(effort))
        });
        for (row, effort) in rows.iter().zip(&efforts) {
            if row.error_attitude.min(row.error_omega) < 10.0 * judged.floor() {
                continue;
            }
            let [attitude, omega] = errors(&(trial.run)(*effort).unwrap().0.row(0).1);
            for (told, true_one) in [(row.error_attitude, attitude), (row.error_omega, omega)] {
                let ratio = told / true_one;
                let near = (0.9..1.1).contains(&ratio);
                assert!(near, "{solver} {effort:?}: {told:e} {true_one:e}");
            }
            judged_rows += 1;
        }
    }
    assert!(judged_rows > 20, "{judged_rows}");
}

#[test]
fn what_has_no_attitude_is_judged_by_its_velocities() {
    let body = RoundBody::new(0.17, 0.0286, 0.4).unwrap();
    let shot = Roller::new(body, 9.81, 1.4, 0.0).unwrap();
    let shot = shot.with(Coulomb::new(0.2).unwrap()).unwrap();
    let judged = JudgedScene::new(AnyScene::scene(Box::new(shot)), 5.0).unwrap();
    assert!(!judged.has_attitude() && judged.judges()[0] == Solver::Events);
    let efforts = judged.efforts(Solver::General(Method::Rk4));
    let trial = judged.trial("shot", Solver::General(Method::Rk4), &efforts, 1_000_000);
    let row = trial.measure(efforts[0]);
    assert!(row.error_attitude.is_nan() && row.error() == row.error_omega);
    // It rolls at five sevenths of its speed, so do rim and centre; the slip is none.
    let speeds = (trial.run)(efforts[0]).unwrap().0.row(0).1;
    for (speed, known) in speeds.iter().zip([1.0, 1.0, 0.0]) {
        assert!((speed - known).abs() < 1e-9, "{speeds:?}");
    }
    // The closed forms are as good as they say, and not better.
    let events = judged.efforts(Solver::Events);
    let row = judged
        .trial("shot", Solver::Events, &events, 1)
        .measure(events[0]);
    assert!((1e-15..1e-13).contains(&row.error_omega) && row.error_attitude.is_nan());
    // One evaluation too many: a run that fails says so.
    let trial = judged.trial("shot", Solver::General(Method::Rk4), &efforts, 1);
    assert!(trial.measure(efforts[0]).failure.is_some());
}
