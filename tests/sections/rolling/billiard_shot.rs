//! Paragraph 4.3: the billiard shot. The pulse of the cue is integrated step by step, under Coulomb friction.

use super::*;
use spinning_bodies::rolling::Regime;

const MASS: f64 = 0.17;
const RADIUS: f64 = 0.028_575;
const FRICTION: f64 = 0.2;
const GRAVITY: f64 = 9.81;
const HEIGHTS: [f64; 5] = [0.5, 1.0, 1.2, 1.4, 1.8];

fn ball() -> RoundBody {
    RoundBody::new(MASS, RADIUS, 0.4).unwrap()
}

/// Centre and spin of a body on cloth.
#[derive(Default)]
struct OnCloth {
    inertia: f64,
    velocity: f64,
    omega: f64,
    friction_impulse: f64,
}

impl OnCloth {
    fn slip(&self) -> f64 {
        self.velocity - RADIUS * self.omega
    }

    /// One step of sliding under a force of the cue at `arm` above the centre.
    fn step(&mut self, cue: f64, arm: f64, dt: f64) {
        let friction = -FRICTION * MASS * GRAVITY * self.slip().signum();
        self.velocity += (cue + friction) / MASS * dt;
        self.omega += (cue * arm - friction * RADIUS) / self.inertia * dt;
        self.friction_impulse += friction * dt;
    }
}

// claim: C4.3-1
#[test]
fn s4_3_impulse_of_a_finite_pulse() {
    let (height, impulse) = (1.2, MASS * 2.0);
    let mut errors = Vec::new();
    for duration in [1e-2, 1e-3, 1e-4] {
        let steps = 1000;
        // The contact point starts to move forward at once, so the friction has its sign from the first step on.
        let mut state = OnCloth {
            inertia: 0.4 * MASS * RADIUS * RADIUS,
            velocity: f64::MIN_POSITIVE,
            ..OnCloth::default()
        };
        for _ in 0..steps {
            let (arm, dt) = ((height - 1.0) * RADIUS, duration / f64::from(steps));
            state.step(impulse / duration, arm, dt);
        }
        // 5/2 (H−R)/R V' with V' = 2 m/s, up to the friction impulse, which is μMg times the duration.
        let shot = ball().strike(height, 2.0).unwrap();
        close!(shot.rim_speed, 2.5 * 0.2 * 2.0, 0.0..=1e-15);
        let bound = FRICTION * GRAVITY * duration;
        close!(state.friction_impulse.abs() / MASS, bound, 1e-15..=1e-13);
        errors.push((RADIUS * state.omega - shot.rim_speed).abs());
        assert!((state.velocity - shot.velocity).abs() <= bound * (1.0 + 1e-9));
    }
    // Ten times shorter, ten times nearer to the tutorial's impulse equations.
    for pair in errors.windows(2) {
        close!(pair[0] / pair[1], 10.0, 7e-13..=8e-11);
    }
}

// claim: C4.3-2
#[test]
fn s4_3_speed_of_the_contact_point() {
    for (height, slip) in HEIGHTS.into_iter().zip([2.25, 1.0, 0.5, 0.0, -1.0]) {
        // Observed: at most one unit in the last place.
        close!(ball().cue_slip(height).unwrap(), slip, 0.0..=4.5e-16);
        let printed = (7.0 - 5.0 * height) / 2.0;
        near!(printed, slip, 4.5e-16);
        // The same from the two speeds themselves.
        let shot = ball().strike(height, 3.0).unwrap();
        near!(shot.velocity - shot.rim_speed, shot.slip, 2e-15);
    }
}

// claim: C4.3-3
#[test]
fn s4_3_three_cases() {
    use Regime::{PureRolling, SkidsBackward, SkidsForward};
    for height in HEIGHTS {
        let shot = ball().strike(height, 2.0).unwrap();
        let regime = match height {
            1.4 => PureRolling,
            1.8 => SkidsForward,
            _ => SkidsBackward,
        };
        assert_eq!(shot.regime, regime, "struck at {height} R");
        let rolled = shot.slide(FRICTION, GRAVITY).unwrap();
        // Friction slows a ball that skids backward, speeds up one that skids forward, leaves the rolling one alone.
        match regime {
            SkidsBackward => assert!(rolled.speed < shot.velocity),
            PureRolling => assert_eq!((rolled.speed, rolled.time), (2.0, 0.0)),
            SkidsForward => assert!(rolled.speed > shot.velocity),
        }
    }
    // "Backward" is relative to rolling: the ball itself turns backward only when struck below its centre.
    let spin = |height| ball().strike(height, 2.0).unwrap().rim_speed;
    assert!(spin(1.2) > 0.0 && spin(1.0) == 0.0 && spin(0.8) < 0.0);
    // One unit in the last place decides.
    let height = ball().pure_rolling_height();
    let [below, above] = [height.next_down(), height.next_up()];
    assert_eq!(ball().strike(below, 2.0).unwrap().regime, SkidsBackward);
    assert_eq!(ball().strike(above, 2.0).unwrap().regime, SkidsForward);
}

// claim: C4.3-4, C4.3-6
#[test]
fn s4_3_general_inertia() {
    for (kappa, expected) in [(0.4, 1.4), (2.0 / 3.0, 5.0 / 3.0), (0.5, 1.5), (1.0, 2.0)] {
        let body = RoundBody::new(MASS, RADIUS, kappa).unwrap();
        let height = body.pure_rolling_height();
        close!(height, expected, 0.0..=2.3e-16);
        assert_eq!(body.cue_slip(height), Ok(0.0));
        // By forces: a short pulse at that height and no friction leaves the contact point at rest.
        let (impulse, arm) = (MASS * 2.0, (height - 1.0) * RADIUS);
        let rim_speed = RADIUS * impulse * arm / (kappa * MASS * RADIUS * RADIUS);
        close!(rim_speed, impulse / MASS, 0.0..=1e-15);
    }
    // The hoop has to be struck at its very top, and nothing with κ ≤ 1 higher.
    let hoop = RoundBody::new(1.0, 1.0, 1.0).unwrap();
    assert_eq!(hoop.strike(2.0, 1.0).unwrap().regime, Regime::PureRolling);
    assert!(RoundBody::new(1.0, 1.0, 1.0f64.next_up()).is_err());
}

// claim: C4.3-5
#[test]
fn s4_3_eventual_rolling_speed() {
    let off = relative(ball().eventual_speed(1.0).unwrap(), 5.0 / 7.0);
    observed!(off, 0.0..=2.3e-16);
    let off = relative(ball().eventual_speed(1.2).unwrap(), 6.0 / 7.0);
    observed!(off, 0.0..=2.3e-16);
    for kappa in [0.4, 2.0 / 3.0, 1.0] {
        let body = RoundBody::new(MASS, RADIUS, kappa).unwrap();
        for height in HEIGHTS {
            let shot = body.strike(height, 2.0).unwrap();
            let slide = shot.slide(FRICTION, GRAVITY).unwrap();
            let expected = body.eventual_speed(height).unwrap() * 2.0;
            close!(slide.speed, expected, 0.0..=1e-15);
        }
    }
}

// claim: C4.3-5
#[test]
fn s4_3_where_and_when_rolling_sets_in() -> Result<()> {
    // The published times and distances, and the same integrated step by step, are in `cloth.rs`.
    // 2|V − RΩ|/(7μg) for the ball; the final speed keeps V + κRΩ, and the heat is the energy that is missing.
    let (v, w) = (2.0, -5.5);
    let slide = RoundBody::new(1.0, 1.0, 0.4)?.slide_to_roll(v, w, FRICTION, GRAVITY)?;
    let off = relative(slide.time, 2.0 * 7.5 / (7.0 * FRICTION * GRAVITY));
    observed!(off, 0.0..=4.5e-16);
    close!(1.4 * slide.speed, v + 0.4 * w, 0.0..=4e-15);
    assert!(slide.speed < 0.0, "enough backspin turns the ball round");
    let energy = |v: f64, w: f64| 0.5 * (v * v + 0.4 * w * w);
    let lost = energy(v, w) - energy(slide.speed, slide.speed);
    close!(slide.heat, lost, 0.0..=4.5e-16);
    Ok(())
}

// claim: C4.3-3
#[test]
fn s4_3_near_pure_rolling_nothing_cancels() {
    let height = ball().pure_rolling_height() - 2f64.powi(-40);
    let shot = ball().strike(height, 1.0 / 3.0).unwrap();
    let exact = 2f64.powi(-40) / 0.4 / 3.0;
    close!(shot.slip, exact, 0.0..=2.3e-16);
    // The difference of the two speeds has lost a dozen digits; it is what `slide` must not use.
    let naive = shot.velocity - shot.rim_speed;
    assert!(relative(naive, exact) > 1e-6, "{naive:e} {exact:e}");
    let time = shot.slide(FRICTION, GRAVITY).unwrap().time;
    close!(time, 2.0 / 7.0 * exact / (FRICTION * GRAVITY), 0.0..=1e-15);
}

/// V = RΩ to the last place of the product, not to the last of the numbers; the times by exact fractions of the doubles given.
#[test]
fn s4_3_next_to_rolling_the_spin_says_how_near() -> Result<()> {
    let known = [
        (1.0, 0.0286, 34.96503496503497, 9.391176134514211e-18),
        (1.0, 0.028575, 34.99562554680665, 2.6395336946191e-18),
        (2.0, 0.03, 66.66666666666667, 9.916073808602921e-18),
        (0.7, 0.0254, 27.559055118110237, 5.220502240320678e-18),
        (1.3, 0.11, 11.818181818181818, 2.9248498338616327e-18),
    ];
    for (v, radius, omega, time) in known {
        let ball = RoundBody::new(MASS, radius, 0.4)?;
        let slide = ball.slide_of_spin(v, omega, FRICTION, GRAVITY)?;
        close!(slide.time, time, 0.0..=7e-16);
        let rounded = ball.slide_to_roll(v, radius * omega, FRICTION, GRAVITY)?;
        assert_eq!(rounded.time, 0.0);
    }
    let none = ball().slide_of_spin(1.0, f64::NAN, FRICTION, GRAVITY);
    assert!(none.is_err());
    let same = ball().slide_of_spin(2.0, -4.0 / RADIUS, FRICTION, GRAVITY)?;
    let other = ball().slide_to_roll(2.0, -4.0, FRICTION, GRAVITY)?;
    close!(same.time, other.time, 4e-16);
    close!(same.speed, other.speed, 1e-15);
    Ok(())
}

/// V + κRΩ = 0, up to the rounding of the product: it stops, and does not creep.
#[test]
fn s4_3_what_stops_is_at_rest() -> Result<()> {
    for (rim, kappa) in [
        (-2.5, 0.4),
        (-7.1, 0.4),
        (1.3, 2.0 / 3.0),
        (-4.4, 0.5),
        (-1.3, 1.0),
        (-3.0, 0.3),
    ] {
        let v: f64 = -(kappa * rim);
        let body = RoundBody::new(MASS, RADIUS, kappa)?;
        assert_eq!(body.slide_to_roll(v, rim, FRICTION, GRAVITY)?.speed, 0.0);
        let law = Coulomb::new(FRICTION)?;
        let (load, start) = (Load::weight(GRAVITY), Moment::moving(v, rim));
        let course = Course::new(kappa, load, (Some(law), None, None), start, 9.0)?;
        let end = course.at(9.0);
        assert_eq!((end.velocity, end.rim_speed, end.slip), (0.0, 0.0, 0.0));
        assert_eq!(course.events.last().unwrap().what, Happening::Rest);
        let roller = Roller::new(body, GRAVITY, v, rim)?.with(law)?;
        let run = roller.simulate(&by_general(Request::at([9.0])?, Method::Dop853))?;
        let end = run.rows[0].1.moment;
        assert_eq!((end.velocity, end.rim_speed, end.slip), (0.0, 0.0, 0.0));
    }
    // A stroke at the table's level, which no cue makes, gives the ball no angular momentum about the table.
    let dead = ball().strike(0.0, 2.0)?.slide(FRICTION, GRAVITY)?;
    assert_eq!(dead.speed, 0.0);
    Ok(())
}

/// Static friction holds up to its limit and at it; kinetic friction would not.
#[test]
fn s4_3_at_its_limit_the_contact_still_holds() {
    // κ = 1: half of the pull is needed to hold the contact.
    let course = |push: f64| {
        let load = Load {
            push,
            twist: 0.0,
            reaction: 1.0,
        };
        let effects = (Some(Coulomb::with_grip(0.25, 0.5).unwrap()), None, None);
        Course::new(1.0, load, effects, Moment::default(), 1.0).unwrap()
    };
    let held = course(1.0);
    assert!(held.events.is_empty());
    assert_eq!((held.at(1.0).velocity, held.at(1.0).rim_speed), (0.5, 0.5));
    let torn = course(1.0 + f64::EPSILON);
    assert_eq!(torn.events[0].what, Happening::SlippingBegins);
    close!(torn.at(1.0).velocity, 0.75, 1e-15);
}

/// Here the friction that holds the contact is above its limit by one rounding, and yet with that limit nothing would start to slip: it holds.
#[test]
fn s4_3_what_does_not_start_to_slip_is_held() {
    let load = Load {
        push: 2.725,
        twist: -0.1,
        reaction: 1.0,
    };
    let effects = (Some(Coulomb::new(0.85).unwrap()), None, None);
    let course = Course::new(0.4, load, effects, Moment::default(), 1.0).unwrap();
    assert!(course.events.is_empty(), "{:?}", course.events);
    let end = course.at(1.0);
    assert_eq!([end.slip, end.heat], [0.0; 2]);
    assert_eq!(end.rim_speed, end.velocity);
}

#[test]
fn rolling_refuses_what_is_no_body_and_no_shot() {
    refused!(RoundBody::new(0.0, 1.0, 0.4), NotPositive);
    refused!(RoundBody::new(1.0, f64::NAN, 0.4), NotFinite);
    refused!(RoundBody::new(1.0, 1.0, 1.5), OutOfRange);
    refused!(ball().cue_slip(2.1), OutOfRange);
    refused!(ball().strike(1.0, -1.0), NotPositive);
    refused!(ball().slide_to_roll(1.0, 0.0, 0.0, 9.8), NotPositive);
    refused!(ball().slide_to_roll(1e308, -1e308, 0.1, 9.8), NotFinite);
}

proptest! {
    #[test]
    fn rolling_never_panics(a in any::<f64>(), b in any::<f64>(), c in any::<f64>(), d in any::<f64>()) {
        let _ = ball().slide_to_roll(a, b, c, d);
        if let Ok(body) = RoundBody::new(a, b, c) {
            let _ = (body.cue_slip(d), body.eventual_speed(d), body.pure_rolling_height());
        }
        if let Ok(shot) = ball().strike(a, b) {
            let _ = (shot.rim_speed, shot.slide(c, d));
        }
    }

    #[test]
    fn rolling_keeps_the_angular_momentum_about_the_table(
        kappa in 0.01..1.0f64, v in -10.0..10.0f64, w in -10.0..10.0f64, friction in 0.01..1.0f64,
    ) {
        let body = RoundBody::new(MASS, RADIUS, kappa).unwrap();
        let slide = body.slide_to_roll(v, w, friction, GRAVITY).unwrap();
        // Eight roundings of numbers up to 30.
        let rolled = slide.speed * (1.0 + kappa);
        prop_assert!((rolled - (v + kappa * w)).abs() < 2e-14);
    }
}
