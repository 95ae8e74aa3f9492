//! Paragraph 4.6, continued: stiff contacts, restitution along the surface, slipping, bounces that pile up, and flights in closed form.

use super::*;
use spinning_bodies::integrators::Stop;
use spinning_bodies::rolling::Coulomb;
use spinning_bodies::superball::{Restitution, bounce_with, gripping_bounce, return_threshold};
use support::any;

/// A contact on springs of frequency `omega`, tuned, with gravity: V and RΩ as the ball leaves, and how long it took.
fn stiff(omega: f64, kappa: f64, before: Motion<f64>) -> ([f64; 2], f64) {
    let (k, g) = (omega * omega, 9.81);
    let rate = |_: f64, y: &[f64; 5]| {
        let f = -k * kappa / (1.0 + kappa) * y[4];
        [y[1], -k * y[0] - g, f, -f / kappa, y[2] - y[3]]
    };
    let lifted = |t: f64, y: &[f64; 5]| if t * omega > 1.0 { -y[0] } else { 1.0 };
    let start = [0.0, -2.0, before.velocity, before.rim_speed, 0.0];
    let scales = [1.0 / omega, 1.0, 1.0, 1.0, 1.0 / omega];
    let leg = leg(&rate, (&start, &scales), (&[], 4.0 / omega));
    let end = leg.follow(Some(&lifted), Effort::Tolerance(1e-14)).unwrap();
    assert_eq!(end.stopped, Stop::AtTheEvent);
    ([end.end[2], end.end[3]], end.time)
}

// claim: C4.6-1, C4.6-3, C4.6-14
#[test]
fn s4_6_stiff_contact_converges_to_the_law() {
    for kappa in [0.4, 2.0 / 3.0, 1.0] {
        let before = moving(1.0, 0.3);
        let law = bounce(before, Surface::Floor, kappa);
        let mut last: Option<[f64; 2]> = None;
        for omega in [1e2, 1e3, 1e4] {
            let ([v, _], time) = stiff(omega, kappa, before);
            let error = [(v - law.velocity).abs(), time];
            if let Some([coarse, long]) = last {
                // Stiffness a hundred times: the error a hundredth, order 1 in 1/k; the duration a tenth.
                near!(coarse / error[0], 100.0, 3.0);
                assert!((long / time - 10.0).abs() < 0.4);
            }
            // κ/(1+κ) u (1 − cos ε), ε = 2g/(ωV_z).
            let phase = 9.81 / omega;
            let expected = kappa / (1.0 + kappa) * 0.7 * 0.5 * phase * phase;
            close!(error[0], expected, 0.02);
            last = Some(error);
        }
    }
}

#[test]
fn s4_6_tangential_restitution() {
    let thrown = moving(1.0, 0.0);
    let surfaces = [Surface::Floor, Surface::Ceiling, Surface::Floor];
    let third = |kappa: f64, e: f64| {
        let after = |m, &s: &Surface| bounce_with(m, s, kappa, e);
        surfaces.iter().fold(thrown, after).velocity
    };
    let velocities = [-0.9708, -0.7167, -0.4819, -0.2640];
    for (e, v) in [1.0, 0.8, 0.6, 0.4].into_iter().zip(velocities) {
        near!(third(0.4, e), v, 1e-5..=5e-5);
    }
    near!(return_threshold(0.4).unwrap(), 0.13809, 1e-6..=5e-6);
    for kappa in [0.08, 0.2, 0.25, 1.0 / 3.0, 0.4, 0.5, 0.6, 2.0 / 3.0] {
        let e = return_threshold(kappa).unwrap();
        observed!(third(kappa, e).abs(), 0.0..=2e-15, "{kappa}: {e}");
        assert!(third(kappa, e + 1e-6) < 0.0 && third(kappa, e - 1e-6) > 0.0);
    }
    refused!(return_threshold(0.05), Condition);
    refused!(return_threshold(0.7), OutOfRange);
    // The cubic, in fractions.
    let q = |n: i128, d: i128| Ratio::new(n, d);
    let (kappa, e, one) = (q(2, 5), q(3, 4), q(1, 1));
    let start = moving(one, q(0, 1));
    let after = |m, &s: &Surface| bounce_with(m, s, kappa, e);
    let end = surfaces.iter().fold(start, after);
    let a = (one + e) / (one + kappa);
    let c = one - kappa;
    let three = q(3, 1);
    let cubic = three + (one - three * kappa) * a + c * c * a * a;
    assert_eq!(end.velocity, one - kappa * a * cubic);
}

proptest! {
    #[test]
    fn s4_6_every_bounce_of_the_family(
        v in -5.0..5.0_f64, w in -5.0..5.0_f64, kappa in 0.05..1.0_f64, e in -1.0..1.0_f64, most in 0.0..3.0_f64,
    ) {
        let before = moving(v, w);
        for surface in [Surface::Floor, Surface::Ceiling] {
            let elastic = bounce_with(before, surface, kappa, 1.0);
            prop_assert_eq!(elastic, bounce(before, surface, kappa));
            let u = before.contact_speed(surface);
            let after = bounce_with(before, surface, kappa, e);
            prop_assert!((after.contact_speed(surface) + e * u).abs() < 1e-14 * (v.abs() + w.abs()));
            let lost = before.energy(kappa) - after.energy(kappa);
            let expected = kappa / (1.0 + kappa) * u * u * (1.0 - e * e);
            prop_assert!((lost - expected).abs() < 1e-13);
            let law = Coulomb::new(0.3).unwrap();
            let clipped = gripping_bounce(before, surface, kappa, e, law, most / 0.3);
            let impulse = (clipped.velocity - v).abs();
            prop_assert!(impulse <= most * (1.0 + 1e-14) + 1e-15);
            prop_assert!(clipped.energy(kappa) <= before.energy(kappa) * (1.0 + 1e-15));
        }
    }
}

/// Static friction holds up to its limit; a contact that it does not hold slips, and takes what kinetic friction gives.
#[test]
fn s4_6_a_contact_that_holds_better_at_rest() {
    let law = Coulomb::with_grip(0.25, 0.5).unwrap();
    let bounced = |v: f64| gripping_bounce(moving(v, 0.0), Surface::Floor, 1.0, 1.0, law, 2.0);
    assert_eq!(bounced(1.0), bounce(moving(1.0, 0.0), Surface::Floor, 1.0));
    assert_eq!(bounced(1.5), moving(1.0, 0.5));
    // A ball of another κ slips: friction takes 0.5 m/s of its speed, and gives the rim 1/κ times that.
    let slipping = gripping_bounce(moving(5.0, 0.0), Surface::Floor, 0.4, 1.0, law, 2.0);
    assert_eq!(slipping, moving(4.5, 1.25));
}

fn thrown(height: f64, climb: f64, velocity: f64, rim_speed: f64) -> InFlight {
    InFlight {
        position: 0.0,
        height,
        climb,
        motion: moving(velocity, rim_speed),
        bounces: 0,
    }
}

/// Place, speeds and spin.
fn numbers(ball: &InFlight) -> [f64; 5] {
    let Motion {
        velocity,
        rim_speed,
    } = ball.motion;
    [ball.position, ball.height, ball.climb, velocity, rim_speed]
}

/// Gravity, m/s².
const WEIGHT: Option<f64> = Some(9.81);

// claim: C4.6-11
#[test]
fn s4_6_flights_two_ways() {
    // Stepped by a general method as well in `scenes::superball`.
    let mut worst = 0.0_f64;
    let sky = f64::INFINITY;
    for (room, start) in [
        (0.6, thrown(0.3, -5.0, 2.0, 0.0)),
        (0.6, thrown(0.3, 5.0, 2.0, 0.7)),
        (0.6, thrown(0.0, 4.0, -1.0, 0.7)),
        (sky, thrown(1.0, 0.0, 1.0, -3.0)),
        (sky, thrown(0.2, 3.0, 1.0, 2.0)),
        // The ceiling is out of reach.
        (2.0, thrown(1.0, 0.0, 1.0, -3.0)),
    ] {
        let flight = Flight::new(0.4, room, (WEIGHT, None, None), start).unwrap();
        let times: Vec<f64> = (0..40).map(|k| 0.0731 * f64::from(k)).collect();
        let followed = flight.followed(&times).unwrap();
        for (&t, other) in times.iter().zip(&followed) {
            let e = flight.exact(t).unwrap();
            let (a, b) = (numbers(&e), numbers(other));
            worst = worst.max(greatest((0..5).map(|k| (a[k] - b[k]).abs())));
            assert_eq!(e.bounces, other.bounces);
        }
    }
    observed!(worst, 4e-16..=5e-14);
    // At the doubles next to the bounces themselves.
    let ball = Flight::new(0.4, sky, (WEIGHT, None, None), thrown(0.0, 3.0, 1.0, 2.0)).unwrap();
    for k in 1..1000_u64 {
        let there = ball.exact(k as f64 * (6.0 / 9.81)).unwrap();
        // Up again from this one, or still down to it.
        let counted = if there.climb > 0.0 { k } else { k - 1 };
        assert_eq!(there.bounces, counted);
        near!(there.height, 0.0, 1e-15 * k as f64);
    }
}

/// A ball under the open sky.
fn flight((losses, grip): (Option<Restitution>, Option<Coulomb>), start: InFlight) -> Flight {
    Flight::new(0.4, f64::INFINITY, (WEIGHT, losses, grip), start).unwrap()
}

#[test]
fn s4_6_bounces_that_pile_up() {
    for e in [0.0, 0.3, 0.8, 0.99, 0.999] {
        let dull = Restitution::new(e, 0.6).unwrap();
        let start = thrown(1.0, 0.0, 1.0, 0.0);
        let ball = flight((Some(dull), None), start);
        let done = ball.last_contact().unwrap().unwrap();
        let expected = (2.0_f64 / 9.81).sqrt() * (1.0 + e) / (1.0 - e);
        close!(done, expected, 1e-14);
        // The way as the bounces add it up, the small ones first, and how many there are above a millionth of the first speed.
        let heights = |n: i32| 2.0 * e.powi(2 * n);
        let way = (1..=30_000).rev().map(heights).sum::<f64>() + 1.0;
        close!(dull.path_of_a_drop(1.0).unwrap(), way, 1e-15..=3e-14);
        let counted = (0..).find(|&n| e.powi(n) <= 1e-6).unwrap() as u64;
        assert_eq!(dull.bounces_down_to(4.4, 4.4e-6).unwrap(), Some(counted));
        let end = ball.followed(&[0.5 * done, done, done + 2.0]).unwrap()[2];
        assert_eq!((end.height, end.climb), (0.0, 0.0));
        // It rolls with what a point of the floor has always known.
        close!(end.motion.velocity, 5.0 / 7.0, 1e-14);
        assert_eq!(end.motion.velocity, end.motion.rim_speed);
    }
    // e_n = 1 − 1e-6: the time is known at once.
    let dull = Restitution::new(1.0 - 1e-6, 0.6).unwrap();
    let ball = flight((Some(dull), None), thrown(1.0, 0.0, 1.0, 0.0));
    let done = ball.last_contact().unwrap().unwrap();
    close!(done, (2.0_f64 / 9.81).sqrt() * (2.0 - 1e-6) / 1e-6, 1e-10);
    // ln 10⁶/(10⁻⁶ + 10⁻¹²/2 + …) = 13 815 503.65.
    assert_eq!(dull.bounces_down_to(1.0, 1e-6).unwrap(), Some(13_815_504));
    // A ball that is all but dead, and speeds whose quotient no double holds.
    let bounces = |e, speed, least| {
        let ball = Restitution::new(e, 0.6).unwrap();
        ball.bounces_down_to(speed, least).unwrap()
    };
    assert_eq!(bounces(1e-20, 8.0, 1.0), Some(1));
    assert_eq!(bounces(1e-10, 1.0, 1e-30), Some(3));
    assert_eq!(bounces(0.5, 1e300, 1e-300), Some(1994)); // 600 ln 10/ln 2 = 1993.2
    // Two units less than 5 is 3.2 · 2⁻⁵³ of it, and each bounce takes 2⁻⁵³.
    let least = 5.0_f64.next_down().next_down();
    assert_eq!(bounces(1.0_f64.next_down(), 5.0, least), Some(4));
    let elastic = Restitution::new(1.0, 0.6).unwrap();
    assert_eq!(elastic.bounces_down_to(1.0, 0.5).unwrap(), None);
    assert_eq!(elastic.path_of_a_drop(1.0).unwrap(), f64::INFINITY);
    // A contact speed that is reversed for ever has no last value.
    let odd = Restitution::new(0.5, 1.0).unwrap();
    let ball = flight((Some(odd), None), thrown(1.0, 0.0, 1.0, 0.0));
    refused!(ball.followed(&[10.0]), Condition);
    // With a limited grip it may still slide when the bounces are over, and ends rolling all the same.
    let dull = Restitution::new(0.3, 0.6).unwrap();
    let grip = Coulomb::new(0.05).unwrap();
    let ball = flight((Some(dull), Some(grip)), thrown(0.1, 0.0, 3.0, 0.0));
    let done = ball.last_contact().unwrap().unwrap();
    let [ends, slides, rolls] = ball.followed(&[done, done + 0.01, done + 9.0]).unwrap()[..] else {
        unreachable!()
    };
    let slip = slides.motion.contact_speed(Surface::Floor);
    assert!(slip > 1.0);
    close!(rolls.motion.velocity, 15.0 / 7.0, 1e-14);
    // μg takes 0.01 μg from V, and 1.4/0.4 times as much from the slip; then it rolls for the rest of the nine seconds.
    let brake = 0.05 * 9.81;
    let lost = ends.motion.velocity - slides.motion.velocity;
    near!(lost, 0.01 * brake, 1e-12);
    let way = 0.01 * ends.motion.velocity - 0.5 * 0.01 * 0.01 * brake;
    close!(slides.position - ends.position, way, 1e-12);
    let sliding = slip / (3.5 * brake);
    let way = 8.99 * 15.0 / 7.0 + 0.5 * brake * sliding * sliding;
    close!(rolls.position - slides.position, way, 1e-13);
    // Up to the end of the bounces it moved on as a ball between them does.
    let before = ball.followed(&[done - 1e-7]).unwrap()[0];
    let way = 1e-7 * ends.motion.velocity;
    near!(ends.position - before.position, way, 1e-12);
}

/// The sums over the pile against the bounces one by one, and where there are too many of these.
#[test]
fn s4_6_after_the_last_bounce() {
    let (normal, along) = ([0.0, 0.5, 0.9, 0.8, 0.95], [0.6, 0.6, -0.3, -1.0, 0.99]);
    for (normal, along) in normal.into_iter().zip(along) {
        let dull = Restitution::new(normal, along).unwrap();
        let ball = flight((Some(dull), None), thrown(1.0, 0.0, 1.0, 0.3));
        let last = ball.last_contact().unwrap().unwrap();
        let end = ball.followed(&[last, last + 2.0]).unwrap();
        let mut here = moving(1.0, 0.3);
        let mut x = (2.0_f64 / 9.81).sqrt();
        let mut climb = 2.0 * 9.81_f64.sqrt() / 2.0_f64.sqrt();
        for _ in 0..4000 {
            here = bounce_with(here, Surface::Floor, 0.4, along);
            climb *= normal;
            x += 2.0 * climb / 9.81 * here.velocity;
        }
        close!(end[0].position, x, 3e-15);
        // (1 + 0.4 · 0.3)/1.4, or what it was where nothing rubs.
        let rolls = if along == -1.0 { 1.0 } else { 0.8 };
        close!(end[0].motion.velocity, rolls, 3e-16);
        close!(end[1].position, x + 2.0 * here.velocity, 3e-15);
    }
    // Some sixteen thousand million bounces, which nobody follows; thrown with V = −κRΩ, it is at rest in the end.
    let dull = Restitution::new(1.0 - 1e-9, 0.6).unwrap();
    let ball = flight((Some(dull), None), thrown(1.0, 0.0, 1.0, -2.5));
    let last = ball.last_contact().unwrap().unwrap();
    let end = ball.followed(&[last, 10.0 * last]).unwrap();
    assert_eq!(end[0], end[1]);
    assert_eq!((end[1].motion, end[1].height), (moving(0.0, 0.0), 0.0));
    assert!(end[1].bounces > 16_000_000_000);
    refused!(ball.followed(&[0.9 * last]), Integration);
}

#[test]
fn s4_6_a_ball_that_lies_on_the_floor() {
    // What just reaches the ceiling does not strike it, nor what falls from it: a bounce of the floor each.
    let effects = (Some(8.0), None, None);
    for start in [thrown(0.0, 4.0, 1.0, 0.0), thrown(1.0, 0.0, 1.0, 0.0)] {
        let touches = Flight::new(0.4, 1.0, effects, start).unwrap();
        assert_eq!(touches.exact(1.25).unwrap().bounces, 1);
    }
    let effects = (WEIGHT, None, None);
    for room in (1..200).map(|n| 0.03 * f64::from(n)) {
        let drop = thrown(room, 0.0, 1.0, 0.0);
        let ball = Flight::new(0.4, room, effects, drop).unwrap();
        // Down, up, and half-way down again.
        let end = ball.followed(&[2.5 * (2.0 * room / 9.81).sqrt()]).unwrap()[0];
        assert_eq!(end.bounces, 1, "{room}");
    }
    let lies = |v, w| Flight::new(0.4, 1.0, effects, thrown(0.0, 0.0, v, w)).unwrap();
    let rolls = lies(0.5, 0.5).exact(3.0).unwrap();
    assert_eq!((rolls.height, rolls.climb, rolls.bounces), (0.0, 0.0, 0));
    close!(rolls.position, 1.5, 3e-16);
    let still = thrown(0.0, 0.0, 0.0, 0.0);
    assert_eq!(lies(0.0, 0.0).exact(1e20).unwrap(), still);
    assert_eq!(lies(0.5, 0.5).followed(&[3.0]).unwrap()[0], rolls);
    // A smooth one slides; bounces that lose nothing are infinitely many here, too.
    let gripped = Some(Coulomb::new(0.3).unwrap());
    for (normal, grip) in [(0.0, None), (0.5, None), (1.0, None), (0.5, gripped)] {
        let smooth = (WEIGHT, Some(Restitution::new(normal, -1.0).unwrap()), grip);
        let slides = Flight::new(0.4, 1.0, smooth, thrown(0.0, 0.0, 0.5, 0.0)).unwrap();
        let slides = slides.followed(&[3.0]).unwrap()[0];
        assert_eq!(numbers(&slides), [1.5, 0.0, 0.0, 0.5, 0.0]);
    }
    // A contact speed that would be reversed for ever.
    refused!(lies(0.5, 0.0).exact(1.0), Condition);
    refused!(lies(0.5, 0.0).followed(&[1.0]), Condition);
}

/// Numbers at the ends of the doubles, and a count that has none left: an answer of numbers, or a refusal, in any profile.
#[test]
fn s4_6_flights_of_any_numbers() {
    let sizes = [0.0, 5e-324, 1e-200, 1.0, 1e154, 1e200, f64::MAX];
    for (g, climb) in sizes.iter().flat_map(|&g| sizes.map(|v| (g, v))) {
        for (height, sign, t) in [(0.0, 1.0, 1.0), (0.3, -1.0, 1e20), (0.3, 1.0, f64::MAX)] {
            let start = InFlight {
                bounces: u64::MAX,
                ..thrown(height, sign * climb, 2.0, 0.7)
            };
            let effects = (Some(g), None, None);
            for room in [0.6, f64::INFINITY] {
                let Ok(ball) = Flight::new(0.4, room, effects, start) else {
                    continue;
                };
                let Ok(end) = ball.exact(t) else { continue };
                assert_eq!(end.bounces, u64::MAX);
                let depth = (-end.height).max(end.height - room);
                let free = g == 0.0 || depth < 1e-14 * end.height.abs().max(1.0);
                let known = !end.height.is_nan() && !end.climb.is_nan();
                assert!(free && known, "{g} {climb} {t} {room}: {end:?}");
            }
        }
    }
}

#[test]
fn s4_6_grazing_incidence_slips() {
    let grip = Coulomb::new(0.2).unwrap();
    // κ(1+e)u/(1+κ) against μ(1+e)V_z: it slips if V_z < κu/((1+κ)μ).
    let limit: f64 = 0.4 / 1.4 * 5.0 / 0.2;
    for (factor, slips) in [(0.999, true), (1.001, false)] {
        let start = thrown(0.0, factor * limit, 5.0, 0.0);
        let ball = flight((None, Some(grip)), start);
        let t = 2.0 * factor * limit / 9.81 + 1e-3;
        let after = ball.followed(&[t]).unwrap()[0];
        assert_eq!(after.bounces, 1);
        let law = bounce(start.motion, Surface::Floor, 0.4);
        assert_eq!(after.motion != law, slips);
    }
}

#[test]
fn flight_refuses_what_is_no_ball() {
    let none = (None, None, None);
    let start = thrown(0.1, 0.0, 1.0, 0.0);
    for kappa in [0.0, -1.0, 1.1, f64::NAN] {
        assert!(Flight::new(kappa, 1.0, none, start).is_err());
    }
    assert!(Flight::new(0.4, 0.05, none, start).is_err());
    assert!(Flight::new(0.4, 0.0, none, start).is_err());
    assert!(Restitution::new(1.1, 0.0).is_err() && Restitution::new(0.5, -1.1).is_err());
    assert!(Restitution::new(f64::NAN, 0.0).is_err());
    let ball = Flight::new(0.4, 1.0, none, start).unwrap();
    refused!(ball.exact(-1.0), Negative);
    assert_eq!(ball.exact(5.0).unwrap().position, 5.0);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_flight_has_a_speed_that_is_no_number(n in prop::collection::vec(any(), 8), tangential in -1..3_i32) {
        let start = InFlight { position: n[0], ..thrown(n[1].abs(), n[2], n[3], n[4]) };
        let (room, weight, t) = (n[5].abs(), Some(n[6].abs()), n[7].abs());
        let losses = Restitution::new(0.5, 0.5 * f64::from(tangential)).unwrap();
        let elastic = Flight::new(0.4, room, (weight, None, None), start);
        let lossy = Flight::new(0.4, f64::INFINITY, (weight, Some(losses), None), start);
        let states = [elastic.and_then(|flight| flight.exact(t)), lossy.and_then(|flight| Ok(flight.followed(&[t])?[0]))];
        for ball in states.into_iter().flatten() {
            prop_assert!(numbers(&ball).iter().all(|x| x.is_finite()), "{start:?} {room:e} {weight:?} {t:e}: {ball:?}");
        }
    }
}

/// A lossy ball that is thrown at the surface it touches bounces off it at once, and one that does not rebound is held or dragged by its landing.
#[test]
fn the_first_bounce_is_no_end_of_a_pile() {
    let dull = Restitution::new(0.9, 0.5).unwrap();
    for grip in [None, Coulomb::new(0.3).ok()] {
        let in_a_room = |start: InFlight| {
            let flight = Flight::new(0.4, 2.0, (WEIGHT, Some(dull), grip), start).unwrap();
            flight.followed(&[0.05, 0.7]).unwrap()
        };
        for (height, climb, surface) in [(0.0, -2.0, Surface::Floor), (2.0, 3.0, Surface::Ceiling)]
        {
            let at_once = in_a_room(thrown(height, climb, 1.0, 0.5));
            let mut after = thrown(height, -0.9 * climb, 1.0, 0.5);
            after.motion = match grip {
                None => bounce_with(after.motion, surface, 0.4, 0.5),
                Some(law) => {
                    gripping_bounce(after.motion, surface, 0.4, 0.5, law, 1.9 * climb.abs())
                }
            };
            after.bounces = 1;
            assert_eq!(at_once, in_a_room(after));
            assert!(at_once.iter().all(|ball| ball.height >= 0.0));
        }
    }
    // It falls for a second and stays: too slippery for the blow to make it roll, friction takes μ times the fall from the velocity.
    let dead = Restitution::new(0.0, 0.0).unwrap();
    let ball = flight(
        (Some(dead), Coulomb::new(0.01).ok()),
        thrown(4.905, 0.0, 1.0, 0.0),
    );
    let landed = ball.followed(&[1.0 + 1e-9]).unwrap()[0];
    close!(landed.motion.velocity, 1.0 - 0.0981, 1e-8);
    assert_eq!(landed.bounces, 1);
}
