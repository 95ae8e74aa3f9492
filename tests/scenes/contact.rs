//! Bodies on a table. Effects fill slots by type, so the order of listing cannot matter.

use nalgebra::Matrix3;
use spinning_bodies::Error;
use spinning_bodies::frame::{BodyVector, SpaceVector};
use spinning_bodies::integrators::Method;
use spinning_bodies::rolling::slide_to_roll;
use spinning_bodies::scene::contact::{
    Coulomb, Friction, Gravity, Grip, NoSlip, Pull, Regularised, Resist, Resistance, State,
    Support, TableTop, Viscous, listed,
};
use spinning_bodies::scene::{Choice, Motion, Request, Scene, Solver};
use spinning_bodies::tippe_top::{ConvexBody, Start, bodies};

const G: f64 = 9.81;

fn gravity() -> Gravity {
    Gravity::new(G).unwrap()
}

fn motion<A: Pull, B: Grip, C: Resist>(
    scene: &TableTop<A, B, C>,
    times: &[f64],
    accuracy: f64,
) -> Motion<State> {
    let request = Request::at(times).unwrap().to_accuracy(accuracy).unwrap();
    scene.simulate(&request).unwrap()
}

fn end<A: Pull, B: Grip, C: Resist>(scene: &TableTop<A, B, C>, t: f64, accuracy: f64) -> State {
    motion(scene, &[t], accuracy).rows[0].1
}

fn skew() -> TableTop {
    let start = Start::about_vertical(0.4, 0.3, 60.0).unwrap();
    TableTop::new(bodies::chiral_top().unwrap(), start)
}

/// A homogeneous ball, K = C.
fn ball() -> ConvexBody {
    bodies::hoop_with_clay(1.0, 0.03, 0.0).unwrap()
}

fn same(a: &State, b: &State) -> bool {
    a.attitude == b.attitude && a.omega == b.omega && a.velocity == b.velocity
}

fn angle(a: &State, b: &State) -> f64 {
    a.attitude.angle_to(&b.attitude)
}

#[test]
fn every_effect_changes_the_answer() {
    let t = 0.2;
    let free = end(&skew(), t, 1e-9);
    let smooth = end(&skew().with_gravity(gravity()), t, 1e-9);
    let table = skew().with_gravity(gravity());
    let rough = end(&table.with_friction(Viscous::new(0.3).unwrap()), t, 1e-9);
    let bent = end(
        &table.with_friction(Regularised::new(0.3, 1e-3).unwrap()),
        t,
        1e-9,
    );
    let dry = end(&table.with_friction(Coulomb::new(0.3).unwrap()), t, 1e-9);
    let rolling = end(&table.with_friction(NoSlip), t, 1e-9);
    let resisted = end(
        &table.with_resistance(Resistance::new(1e-4, 1e-4).unwrap()),
        t,
        1e-9,
    );
    let all = [free, smooth, rough, bent, dry, rolling, resisted];
    for (i, a) in all.iter().enumerate() {
        for b in &all[..i] {
            assert!(angle(a, b) > 1e-5, "{i}");
        }
    }
}

#[test]
fn without_strength_an_effect_is_absent_bit_for_bit() {
    let table = skew().with_gravity(gravity());
    let smooth = end(&table, 0.3, 1e-9);
    assert!(same(
        &smooth,
        &end(&table.with_friction(Viscous::new(0.0).unwrap()), 0.3, 1e-9)
    ));
    assert!(same(
        &smooth,
        &end(&table.with_friction(Coulomb::new(0.0).unwrap()), 0.3, 1e-9)
    ));
    assert!(same(
        &smooth,
        &end(
            &table.with_friction(Regularised::new(0.0, 1e-3).unwrap()),
            0.3,
            1e-9
        )
    ));
    assert!(same(
        &smooth,
        &end(
            &table.with_resistance(Resistance::new(0.0, 0.0).unwrap()),
            0.3,
            1e-9
        )
    ));
}

#[test]
fn a_ball_without_friction_does_not_feel_gravity() {
    // K = C: the reaction has no moment. To the accuracy asked for.
    let inertia = Matrix3::new(0.4, 0.02, 0.01, 0.02, 0.35, 0.03, 0.01, 0.03, 0.45);
    let body = bodies::eccentric_ball(1.0, 0.03, 0.0, inertia).unwrap();
    let start = Start::spinning(skew().start().attitude, BodyVector::new(3.0, 4.0, 5.0)).unwrap();
    let scene = TableTop::new(body, start);
    let (free, heavy) = (
        end(&scene, 3.0, 1e-10),
        end(&scene.with_gravity(gravity()), 3.0, 1e-10),
    );
    assert!(angle(&free, &heavy) < 1e-9, "{:e}", angle(&free, &heavy));
}

#[test]
fn the_free_body_in_closed_form_and_by_integration() {
    let request = Request::at([4.0, -1.0, 0.5])
        .unwrap()
        .to_accuracy(1e-10)
        .unwrap();
    let exact = skew().simulate(&request).unwrap();
    assert_eq!(exact.plan.solver, Solver::Exact);
    let by = Choice::Use(Solver::General(Method::Dop853));
    let general = skew().simulate(&request.by(by)).unwrap();
    for (a, b) in exact.rows.iter().zip(&general.rows) {
        assert!(angle(&a.1, &b.1) < 1e-9 && (a.1.position - b.1.position).norm() < 1e-9);
    }
}

#[test]
fn without_friction_energy_and_vertical_momentum_stay() {
    let times: Vec<f64> = (0..=50).map(|i| 0.02 * f64::from(i)).collect();
    let start = Start::about_vertical(0.5, 0.2, 20.0).unwrap();
    for body in [
        bodies::celt_ended_top_1().unwrap(),
        bodies::chiral_top().unwrap(),
    ] {
        let scene = TableTop::new(body, start).with_gravity(gravity());
        let motion = motion(&scene, &times, 1e-12);
        for entry in motion.ledger.entries() {
            println!("{} {:e}", entry.name(), entry.relative_drift());
            // Observed: 4e-15.
            assert!(entry.relative_drift() < 1e-13, "{}", entry.name());
        }
        assert!(
            motion
                .ledger
                .entries()
                .iter()
                .any(|e| e.name() == "vertical angular momentum")
        );
    }
}

#[test]
fn energy_lost_is_what_the_contact_has_taken() {
    let times: Vec<f64> = (0..=50).map(|i| 0.02 * f64::from(i)).collect();
    let table = skew().with_gravity(gravity());
    let check = |motion: Motion<State>| {
        let (first, last) = (motion.rows[0].1, motion.rows[50].1);
        let lost = first.energy - last.energy;
        println!("lost {lost:e}, balance {:e}", last.dissipated - lost);
        assert!(lost > 1e-5 * first.energy);
        assert!((last.dissipated - lost).abs() < 1e-9 * first.energy);
    };
    check(motion(
        &table.with_friction(Viscous::new(0.3).unwrap()),
        &times,
        1e-10,
    ));
    check(motion(
        &table.with_friction(Regularised::new(0.3, 1e-3).unwrap()),
        &times,
        1e-10,
    ));
    check(motion(
        &table.with_friction(Coulomb::new(0.3).unwrap()),
        &times,
        1e-8,
    ));
    let resisting = Resistance::new(1e-4, 1e-4).unwrap();
    check(motion(&table.with_resistance(resisting), &times, 1e-10));
    check(motion(
        &table.with_friction(NoSlip).with_resistance(resisting),
        &times,
        1e-10,
    ));
}

#[test]
fn a_struck_ball_slides_until_it_rolls() {
    // The billiard shot of 4.3: the transition is an event, and where it lies is known in closed form.
    let mut start = Start::spinning(skew().start().attitude, BodyVector::zero()).unwrap();
    start.velocity = SpaceVector::new(0.7, 0.0, 0.0);
    let scene = TableTop::new(ball(), start)
        .with_gravity(gravity())
        .with_friction(Coulomb::new(0.2).unwrap());

    let known = slide_to_roll(0.7, 0.0, 0.2, G).unwrap();
    let request = Request::at([2.0]).unwrap().to_accuracy(1e-9).unwrap();
    let phases = scene.phases(&request).unwrap();
    println!("{phases:?}");
    assert_eq!(phases.len(), 2);
    assert_eq!(phases[1].support, Support::Rolling);
    assert!((phases[1].start - known.time).abs() < 1e-8);
    let state = end(&scene, 2.0, 1e-9);
    assert!((state.velocity.x() - 0.5).abs() < 1e-8);
}

#[test]
fn rolling_becomes_sliding_where_the_cone_ends() {
    // A rocking ball with C off centre needs friction; less is there than that.
    let body = bodies::hoop_with_clay(1.0, 0.03, 0.3).unwrap();
    let attitude = Start::about_vertical(0.0, 0.0, 0.0).unwrap().attitude;
    let mut start = Start::spinning(attitude, BodyVector::new(0.0, 18.0, 0.0)).unwrap();
    // At rest at the contact: V = −Ω∧ρ.
    start.velocity = SpaceVector::new(18.0 * 0.7 * 0.03, 0.0, 0.0);
    let table = TableTop::new(body, start).with_gravity(gravity());
    let scene = table.with_friction(Coulomb::new(0.05).unwrap());
    let at = |accuracy: f64| {
        let request = Request::at([1.0]).unwrap().to_accuracy(accuracy).unwrap();
        scene.phases(&request).unwrap()
    };
    let (phases, again) = (at(1e-8), at(1e-6));
    println!("{phases:?}");
    assert_eq!(phases[0].support, Support::Rolling);
    assert_eq!(phases[1].support, Support::Sliding);
    assert!((phases[1].start - again[1].start).abs() < 1e-6);
    // Before that it rolls as if the table could hold anything, after that not.
    let before = 0.9 * phases[1].start;
    let held = table.with_friction(NoSlip);
    assert!(angle(&end(&scene, before, 1e-8), &end(&held, before, 1e-8)) < 1e-7);
    assert!(angle(&end(&scene, 1.0, 1e-6), &end(&held, 1.0, 1e-6)) > 1e-3);
    // With enough friction it never slides.
    let sticky = table.with_friction(Coulomb::new(5.0).unwrap());
    assert!(angle(&end(&sticky, 1.0, 1e-8), &end(&held, 1.0, 1e-8)) < 1e-7);
}

#[test]
fn resistance_stops_a_rolling_ball_exponentially() {
    // (I + M R²) dΩ/dt = −M g a Ω.
    let start = Start::spinning(skew().start().attitude, BodyVector::zero()).unwrap();
    let omega = start.attitude.to_body(SpaceVector::new(0.0, 20.0, 0.0));
    let start = Start::spinning(start.attitude, omega).unwrap();
    let a = 1e-4;
    let scene = TableTop::new(ball(), start)
        .with_gravity(gravity())
        .with_friction(NoSlip)
        .with_resistance(Resistance::new(a, 0.0).unwrap());
    let state = end(&scene, 1.5, 1e-10);
    let expected = 20.0 * (-G * a * 1.5 / (1.4 * 0.03 * 0.03)).exp();
    assert!((state.omega.norm() / expected - 1.0).abs() < 1e-9);
}

#[test]
fn a_smoothed_law_tends_to_coulombs() {
    let start = Start::about_vertical(0.3, 0.0, 300.0).unwrap();
    let table = TableTop::new(bodies::hoop_with_clay(0.02, 0.02, 0.1).unwrap(), start)
        .with_gravity(gravity());
    let dry = end(&table.with_friction(Coulomb::new(0.3).unwrap()), 0.3, 1e-7).tilt();
    let bent = |e: f64| {
        end(
            &table.with_friction(Regularised::new(0.3, e).unwrap()),
            0.3,
            1e-7,
        )
        .tilt()
    };
    let (far, near) = ((bent(4e-3) - dry).abs(), (bent(1e-3) - dry).abs());
    println!("{far:e} {near:e}");
    // Second order in ε while the body slips.
    assert!(near < 0.1 * far && near < 1e-5);
}

#[test]
fn a_body_hops_rather_than_be_pulled() {
    // Thrown up by its own eccentric mass: spun about a level axis fast enough, it leaves the table and comes back.
    let body = bodies::hoop_with_clay(1.0, 0.03, 0.3).unwrap();
    let attitude = Start::about_vertical(0.0, 0.0, 0.0).unwrap().attitude;
    let mut start = Start::spinning(attitude, BodyVector::new(0.0, 90.0, 0.0)).unwrap();
    start.velocity = SpaceVector::new(90.0 * 0.7 * 0.03, 0.0, 0.0);
    let table = TableTop::new(body, start).with_gravity(gravity());
    let times: Vec<f64> = (0..=400).map(|i| 1e-3 * f64::from(i)).collect();
    let check = |motion: Motion<State>, phases: usize| {
        let mut aloft = 0;
        for (t, state) in &motion.rows {
            let lowest = body.lowest_point(state.up()).unwrap();
            let gap = state.position.z() + lowest.dot(&state.up());
            assert!(state.reaction >= 0.0 && gap > -1e-12, "{t}: {gap:e}");
            if state.support == Support::Airborne {
                aloft += 1;
                assert!(gap > 0.0);
            }
        }
        println!(
            "{phases} phases, {aloft} samples in the air, {}",
            motion.ledger
        );
        assert!(phases >= 3 && aloft > 10);
    };
    let request = Request::at(times.clone())
        .unwrap()
        .to_accuracy(1e-8)
        .unwrap();
    let rough = table.with_friction(Viscous::new(0.3).unwrap());
    check(
        rough.simulate(&request).unwrap(),
        rough.phases(&request).unwrap().len(),
    );
    let dry = table.with_friction(Coulomb::new(0.3).unwrap());
    check(
        dry.simulate(&request).unwrap(),
        dry.phases(&request).unwrap().len(),
    );
    check(
        table.simulate(&request).unwrap(),
        table.phases(&request).unwrap().len(),
    );
}

#[test]
fn pure_rolling_ends_where_nothing_presses_and_a_level_force_is_needed() {
    let body = bodies::hoop_with_clay(1.0, 0.03, 0.3).unwrap();
    let attitude = Start::about_vertical(0.0, 0.0, 0.0).unwrap().attitude;
    let start = Start::spinning(attitude, BodyVector::new(0.0, 90.0, 0.0)).unwrap();
    let scene = TableTop::new(body, start)
        .with_gravity(gravity())
        .with_friction(NoSlip);
    let request = Request::at([0.4]).unwrap().to_accuracy(1e-8).unwrap();
    let refused = scene.simulate(&request).unwrap_err();
    let Error::Integration { reason, time } = refused else {
        panic!("{refused}");
    };
    // Within the first turn, and not after a hundred thousand changes.
    assert!(reason.contains("pure rolling") && time < std::f64::consts::TAU / 90.0);
}

#[test]
fn effects_listed_at_run_time_make_the_same_scene() {
    let resistance = Resistance::new(1e-4, 1e-4).unwrap();
    let law = Coulomb::new(0.3).unwrap();
    let typed = skew()
        .with_gravity(gravity())
        .with_friction(law)
        .with_resistance(resistance);
    let request = Request::at([0.2]).unwrap().to_accuracy(1e-8).unwrap();
    let (g, f) = (Some(gravity()), Some(Friction::Coulomb(law)));
    let state = listed(skew(), g, f, Some(resistance), &request)
        .unwrap()
        .rows[0]
        .1;
    assert!(same(&state, &end(&typed, 0.2, 1e-8)));
    let bare = listed(skew(), None, None, None, &request).unwrap();
    assert_eq!(bare.plan.solver, Solver::Exact);
}

#[test]
fn what_cannot_be_run_is_refused() {
    let scene = skew().with_gravity(gravity());
    let request = Request::at([-1.0]).unwrap();
    assert!(matches!(
        scene.simulate(&request),
        Err(Error::OutOfRange { .. })
    ));
    for solver in [Solver::Exact, Solver::Events, Solver::General(Method::Rk4)] {
        let request = Request::at([1.0]).unwrap().by(Choice::Use(solver));
        assert!(
            matches!(scene.simulate(&request), Err(Error::Solver { .. })),
            "{solver}"
        );
    }
    assert!(Gravity::new(0.0).is_err() && Gravity::new(f64::NAN).is_err());
    assert!(Coulomb::new(-0.1).is_err() && Regularised::new(0.1, 0.0).is_err());
    assert!(Viscous::new(f64::INFINITY).is_err() && Resistance::new(0.1, -1.0).is_err());
    assert!(Start::about_vertical(f64::NAN, 0.0, 1.0).is_err());
    assert!(bodies::egg(0.0, 1.0, 1.0).is_err() && bodies::hoop_with_clay(1.0, 1.0, 1.0).is_err());
}

#[test]
fn other_methods_agree() {
    let scene = skew()
        .with_gravity(gravity())
        .with_friction(Viscous::new(0.3).unwrap());
    let best = end(&scene, 0.3, 1e-9);
    for method in [Method::Dopri5, Method::Verner98] {
        let by = Choice::Use(Solver::General(method));
        let request = Request::at([0.3])
            .unwrap()
            .to_accuracy(1e-8)
            .unwrap()
            .by(by);
        let other = scene.simulate(&request).unwrap();
        assert_eq!(other.plan.solver, Solver::General(method));
        assert!(angle(&best, &other.rows[0].1) < 1e-7, "{method:?}");
    }
}
