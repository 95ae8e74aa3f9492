//! Paragraph 4.5: a ball on a sheet that is withdrawn, in any manner.

use super::*;
use spinning_bodies::frame::SpaceVector as V;
use spinning_bodies::rolling::{
    Coulomb, Course, Happening, InPlane, Load, RollingResistance, RoundBody, Sheet, SheetSpeeds,
};
use spinning_bodies::scene::Roller;

const G: f64 = 9.81;

fn friction(mu: f64) -> Coulomb {
    Coulomb::new(mu).unwrap()
}

/// On this sheet and, beside it, on a table with friction of its own; until a time.
fn course(kappa: f64, (sheet, table): (&Sheet, f64), g: f64, start: Moment, until: f64) -> Course {
    let effects = (Some(friction(table)), None, Some(sheet));
    Course::new(kappa, Load::weight(g), effects, start, until).unwrap()
}

/// From rest on a sheet with its edge `margin` behind.
fn withdrawn(kappa: f64, speeds: &SheetSpeeds, margin: f64, [sheet, table]: [f64; 2]) -> Course {
    let sheet = Sheet::new(friction(sheet), speeds.clone(), margin).unwrap();
    let slip = -speeds.at(-1.0);
    let start = Moment {
        slip,
        ..Moment::default()
    };
    course(kappa, (&sheet, table), G, start, 1e3)
}

// claim: C4.5-1
#[test]
fn s4_5_numbers_of_a_quick_pull() {
    let speeds = SheetSpeeds::ramp(3.0, 0.02).unwrap();
    let mut stops = Vec::new();
    let rims = [-0.455_268, -0.273_161, -0.182_107];
    for (kappa, rim) in [0.4, 2.0 / 3.0, 1.0].into_iter().zip(rims) {
        let course = withdrawn(kappa, &speeds, 0.15, [0.3, 0.2]);
        let leaves = course.first(Happening::LeavesSheet).unwrap();
        near!(leaves.time, 0.061_88, 6e-7..=5e-6, "{leaves:?}");
        near!(leaves.moment.velocity, 0.182_107, 5e-8..=5e-7);
        near!(leaves.moment.rim_speed, rim, 8e-8..=5e-7);
        near!(leaves.moment.position, 0.005_634, 7e-8..=5e-7);
        let end = course.at(1e3);
        // Dead.
        assert_eq!((end.velocity, end.rim_speed, end.slip), (0.0, 0.0, 0.0));
        let stop = course.events.last().unwrap();
        assert_eq!(stop.what, Happening::Rest);
        let stop = stop.moment.position;
        near!(stop, 0.014_086, 1e-7..=5e-7, "{stop}");
        stops.push(stop);
    }
    // Pulled a second later it is held until then, and begins to slip once.
    let later = SheetSpeeds::through([(0.0, 0.0), (1.0, 0.0), (1.02, 3.0)]).unwrap();
    let events = withdrawn(0.4, &later, 0.15, [0.3, 0.2]).events;
    let begins = events
        .iter()
        .filter(|event| event.what == Happening::SlippingBegins);
    assert!(begins.map(|event| event.time).eq([1.0]));
    // It does not depend on κ.
    let alike = stops.iter().all(|stop| (stop - stops[0]).abs() < 1e-16);
    assert!(alike, "{stops:?}");
}

// claim: C4.5-2
#[test]
fn s4_5_numbers_of_a_gentle_pull() {
    for kappa in [0.4, 2.0 / 3.0, 1.0] {
        // 1 m/s reached in two seconds: no slip. Then a metre and more of sheet, then the table.
        let speeds = SheetSpeeds::ramp(1.0, 2.0).unwrap();
        let sheet = Sheet::new(friction(0.3), speeds, 1.5).unwrap();
        let course = course(kappa, (&sheet, 0.2), 9.8, Moment::default(), 1e3);
        let on = course.at(2.5);
        let share = kappa / (1.0 + kappa);
        assert_eq!(on.slip, 0.0);
        close!(on.velocity, share, 4e-16);
        close!(on.rim_speed, share - 1.0, 4e-16);
        close!(course.at(1.0).velocity, share * 0.5, 4e-16);
        let leaves = course.first(Happening::LeavesSheet).unwrap();
        let stops = course.events.last().unwrap();
        // V and RΩ reach zero together, after V/(μg) = κu/((1+κ)μg).
        close!(stops.time - leaves.time, share / 1.96, 1e-14);
        let way = stops.moment.position - leaves.moment.position;
        close!(way, share * share / 3.92, 1e-13);
        observed!(course.at(1e3).velocity.abs(), 0.0..=1e-15);
        if kappa == 0.4 {
            close!(share, 2.0 / 7.0, 3e-16);
            let time = stops.time - leaves.time;
            close!(time, 0.145_772_594_752_186_6, 1e-14);
            close!(way, 0.020_824_656_393_169_5, 1e-13);
        }
    }
}

/// Speeds of a sheet: up to ten random points, forwards and back, jerks among them, and away at the end.
fn speeds() -> impl Strategy<Value = SheetSpeeds> {
    let point = (prop_oneof![Just(0.0), 0.0..0.4], -1.0..4.0);
    proptest::collection::vec(point, 1..10).prop_map(|steps| {
        let mut time = 0.0;
        let mut points = vec![(0.0, 0.0)];
        for (wait, speed) in steps {
            time += wait;
            points.push((time, speed));
        }
        points.push((time + 0.1, 5.0));
        SheetSpeeds::through(points).unwrap()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    // claim: C4.5-1, C4.5-5
    #[test]
    fn s4_5_stops_dead_after_any_history(
        speeds in speeds(), margin in 0.05..0.5, kappa in 0.05..1.0,
        sheet in 0.0..0.8, table in 0.05..0.8,
    ) {
        let course = withdrawn(kappa, &speeds, margin, [sheet, table]);
        for k in 0..200 {
            let m = course.at(0.02 * f64::from(k));
            // Never more than the roundings of some events.
            let about_the_table = m.velocity + kappa * m.rim_speed;
            prop_assert!(about_the_table.abs() < 1e-13, "{about_the_table}");
            let books = m.energy(kappa) + m.heat - m.work;
            let scale = m.energy(kappa) + m.heat + m.work.abs() + 1.0;
            prop_assert!(books.abs() < 1e-13 * scale, "{books}");
        }
        let end = course.at(1e3);
        prop_assert!(course.margin(1e3).unwrap() < 0.0);
        prop_assert!(end.velocity.abs() < 1e-13 && end.rim_speed.abs() < 1e-13);
    }

    #[test]
    fn s4_5_closed_forms_against_dop853(
        speeds in speeds(), margin in 0.1..0.5, sheet in 0.1..0.8, table in 0.05..0.8,
    ) {
        let cloth = Sheet::new(friction(sheet), speeds, margin).unwrap();
        let resistance = RollingResistance::new(0.01).unwrap();
        let effects = (Some(friction(table)), Some(resistance), Some(&cloth));
        let start = Moment::default();
        let times: Vec<f64> = (0..=40).map(|k| 0.1 * f64::from(k)).collect();
        let course = Course::new(0.4, Load::weight(G), effects, start, 4.0).unwrap();
        let body = RoundBody::new(1.0, 1.0, 0.4).unwrap();
        let roller = Roller::new(body, G, 0.0, 0.0).unwrap().with(friction(table)).unwrap();
        let roller = roller.with(resistance).unwrap().with(cloth).unwrap();
        let request = by_general(Request::at(times).unwrap(), Method::Dop853);
        let run = roller.simulate(&request).unwrap();
        for (t, row) in run.rows {
            let (c, m) = (course.at(t), row.moment);
            // Speeds up to 5 m/s.
            prop_assert!((c.velocity - m.velocity).abs() < 1e-12, "{t}: {c:?} {m:?}");
            prop_assert!((c.rim_speed - m.rim_speed).abs() < 1e-12);
            prop_assert!((c.position - m.position).abs() < 1e-12);
        }
    }
}

#[test]
fn s4_5_what_resistance_and_ice_do_to_it() {
    let speeds = SheetSpeeds::ramp(3.0, 0.02).unwrap();
    // A couple against the turning is no force along the table: while the ball spins backward it adds forward momentum, so the ball
    // rolls on a little, and then the couple stops it.
    let sheet = Sheet::new(friction(0.3), speeds.clone(), 0.15).unwrap();
    let resistance = RollingResistance::new(0.01).unwrap();
    let effects = (Some(friction(0.2)), Some(resistance), Some(&sheet));
    let course = Course::new(0.4, Load::weight(G), effects, Moment::default(), 1e3).unwrap();
    let dies = course.first(Happening::TurningStops).unwrap();
    // V = arm g t/… : all momentum about the table comes from the couple, arm g a second.
    close!(dies.moment.velocity, 0.01 * G * dies.time, 1e-13);
    assert!(dies.moment.velocity > 0.01);
    let rest = course.first(Happening::Rest).unwrap();
    assert!(rest.moment.position > 0.014_086);
    assert_eq!(course.at(1e3).velocity, 0.0);
    // A table without friction: the ball keeps both.
    let course = withdrawn(0.4, &speeds, 0.15, [0.3, 0.0]);
    let end = course.at(1e3);
    assert!((end.velocity - 0.182_107).abs() < 5e-7 && end.rim_speed < -0.45);
    // Nearly without: it still stops dead, V²/(2μg) farther on.
    let course = withdrawn(0.4, &speeds, 0.15, [0.3, 1e-3]);
    let stop = course.events.last().unwrap();
    assert_eq!((stop.moment.velocity, stop.what), (0.0, Happening::Rest));
    let off = (stop.moment.position - (0.005_634 + 0.182_107_f64.powi(2) / (2e-3 * G))).abs();
    observed!(off, 1e-6..=2e-5);
}

/// Top-spin takes a ball that the sheet has left behind after it and onto it again; one that only touches the edge stays on.
#[test]
fn s4_5_top_spin_brings_it_back() {
    let speeds = SheetSpeeds::through([(0.0, 2.0)]).unwrap();
    let start = Moment {
        slip: -21.0,
        ..Moment::moving(1.0, 20.0)
    };
    let course = |margin, [on_it, beside]: [f64; 2]| {
        let sheet = Sheet::new(friction(on_it), speeds.clone(), margin).unwrap();
        self::course(0.4, (&sheet, beside), 10.0, start, 1.6)
    };
    // Half a metre at 1 m/s on ice; then 1 + 2t from there is 2t, the edge's way, after a second.
    let back = course(0.5, [0.0, 0.2]);
    let mounts = back.first(Happening::MountsSheet).unwrap();
    close!(mounts.time, 1.5, 3e-16);
    assert_eq!((mounts.moment.position, mounts.moment.velocity), (2.5, 3.0));
    // The scene of it, which finds the slip itself.
    let ball = RoundBody::new(0.17, 0.03, 0.4).unwrap();
    let sheet = Sheet::new(friction(0.0), speeds.clone(), 0.5).unwrap();
    let scene = Roller::new(ball, 10.0, 1.0, 20.0).unwrap();
    let scene = scene.with(friction(0.2)).unwrap().with(sheet).unwrap();
    let motion = scene.simulate(&Request::at([0.4, 1.6]).unwrap()).unwrap();
    assert_eq!(motion.cost.steps, 1 + back.events.len() as u64);
    for (t, state) in motion.rows {
        assert_eq!(state.moment, back.at(t));
    }
    // 0.25 − t + t²: at the edge it is as fast as the sheet.
    let touches = course(0.25, [0.2, 0.3]);
    let end = touches.at(1.0);
    assert_eq!((end.position, end.velocity), (2.0, 3.0));
}

/// A ball in space on a sheet with velocity `sheet(t)`, table after `leaves`: x, y, V, Ω; friction μg against the slip, softened, or viscous.
fn in_space(
    sheet: impl Fn(f64) -> [f64; 2],
    leaves: f64,
    kappa: f64,
    rubbing: impl Fn([f64; 2]) -> [f64; 2],
    start: [f64; 5],
    end: f64,
) -> [f64; 5] {
    let radius = 0.02;
    let rate = |t: f64, y: &[f64; 5]| {
        let [vx, vy, ox, oy, oz] = *y;
        let omega = V::new(ox, oy, oz);
        let arm = V::new(0.0, 0.0, -radius);
        let ground = if t < leaves { sheet(t) } else { [0.0; 2] };
        let spin = omega.cross(&arm);
        let f = rubbing([vx + spin.x() - ground[0], vy + spin.y() - ground[1]]);
        let turn = kappa * radius * radius;
        let torque = arm.cross(&V::new(f[0], f[1], 0.0));
        let [x, y, z]: [f64; 3] = (torque / turn).components().into();
        [f[0], f[1], x, y, z]
    };
    let mut y = start;
    for (from, to) in [(0.0, leaves), (leaves, end)] {
        let effort = Effort::Tolerance(1e-12);
        // Times shift so that the run starts at `from`, and its first stage sees the right ground.
        let shifted = |t: f64, y: &[f64; 5]| {
            let end = if to == leaves { to * (1.0 - 1e-15) } else { to };
            rate((from + t).clamp(from * (1.0 + 1e-15), end), y)
        };
        let scales = [1.0, 1.0, 50.0, 50.0, 50.0];
        let run = order_eight(&shifted, Kept::Nothing, &y, &scales, &[to - from], effort);
        y = run.unwrap().states[0];
    }
    y
}

fn coulomb(mu: f64) -> impl Fn([f64; 2]) -> [f64; 2] {
    // Softened below 0.1 mm/s, so that sliding dies out as e^(−t/τ), τ = 3e-5 s.
    move |u| {
        let size = u[0].hypot(u[1]).hypot(1e-4);
        u.map(|c| -mu * G * c / size)
    }
}

// claim: C4.5-1, C4.5-3, C4.5-4
#[test]
fn s4_5_in_space_with_any_friction() {
    let forward = |t: f64| 1.5 * (9.0 * t).sin() + 2.0 * t;
    let jerks = |t: f64| [forward(t), 0.8 * (17.0 * t).cos() - 0.5];
    let viscous = |u: [f64; 2]| u.map(|c| -30.0 * c);
    for kappa in [0.4, 2.0 / 3.0] {
        for start in [[0.0; 5], [0.0, 0.0, 0.0, 0.0, 20.0]] {
            for end in [
                in_space(jerks, 0.4, kappa, coulomb(0.3), start, 2.0),
                in_space(jerks, 0.4, kappa, viscous, start, 2.0),
            ] {
                let speed = end[0].hypot(end[1]);
                observed!(speed, 8e-15..=1e-13);
                // Spin about the vertical is not touched by a point of contact.
                assert_eq!(end[4], start[4]);
            }
        }
        // Rolling at (0.5, −0.3) when the sheet comes in: rolling at (0.5, −0.3) in the end. RΩ_y = V_x, −RΩ_x = V_y.
        let rolling = [0.5, -0.3, 0.3 / 0.02, 0.5 / 0.02, 20.0];
        let end = in_space(jerks, 0.4, kappa, coulomb(0.3), rolling, 2.0);
        for (a, b) in end.iter().zip(&rolling) {
            near!(a, b, 2e-12..=3e-11, "{end:?}");
        }
        let body = RoundBody::new(1.0, 0.02, kappa).unwrap();
        let (velocity, rim_velocity) = ([0.5, -0.3], [0.5, -0.3]);
        let motion = InPlane {
            velocity,
            rim_velocity,
        };
        let [x, y] = body.slide_in_plane(motion, 0.3, 9.81).unwrap().rolling;
        near!(x, 0.5, 0.0..=1e-16);
        observed!((y + 0.3).abs(), 0.0..=1e-16);
    }
}

// claim: C4.5-4
#[test]
fn s4_5_a_ball_already_rolling_keeps_its_velocity() {
    let speeds = SheetSpeeds::through([(0.0, 0.0), (0.2, 3.0), (0.3, -1.0), (0.5, 4.0)]).unwrap();
    for v in [0.5, -0.3] {
        let sheet = Sheet::new(friction(0.3), speeds.clone(), 0.6).unwrap();
        let course = course(0.4, (&sheet, 0.2), G, Moment::moving(v, v), 50.0);
        assert!(course.first(Happening::LeavesSheet).is_some());
        let end = course.at(50.0);
        close!(end.velocity, v, 4e-15);
        assert_eq!(end.slip, 0.0);
    }
}

#[test]
fn sheet_refuses_what_is_no_history() {
    refused!(SheetSpeeds::through([]), Empty);
    refused!(SheetSpeeds::through([(1.0, 0.0)]), Condition);
    let back = SheetSpeeds::through([(0.0, 0.0), (1.0, 1.0), (0.5, 1.0)]);
    refused!(back, Condition);
    assert!(SheetSpeeds::through([(0.0, f64::NAN)]).is_err());
    let speeds = SheetSpeeds::ramp(1.0, 1.0).unwrap();
    assert!(Sheet::new(friction(0.1), speeds.clone(), 0.0).is_err());
    assert_eq!([0.5, 7.0, -1.0].map(|t| speeds.at(t)), [0.5, 1.0, 0.0]);
}
