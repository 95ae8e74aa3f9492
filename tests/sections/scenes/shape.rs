//! Bodies that change their shape. The order in which effects are listed cannot matter: each has a field of its own.

use super::*;
use spinning_bodies::phenomena::{Cat, Crawler, Half, PaperCat, Skater, Strokes};
use spinning_bodies::scene::effects::{Air, Draw, FourPhases, Pace, Turnover};
use spinning_bodies::scene::shape;

const GENERAL: Solver = Solver::General(Method::Dop853);

fn request(until: f64, accuracy: f64) -> Request {
    let times: Vec<f64> = (0..=50).map(|k| until * f64::from(k) / 50.0).collect();
    asking(times, accuracy)
}

fn rows<S: Scene>(scene: &S, request: &Request) -> Vec<Vec<f64>> {
    let motion = scene.simulate(request).unwrap();
    motion.rows.iter().map(|(_, state)| state.row()).collect()
}

/// Largest difference of any column at any time, of numbers above 1 as a part of them.
fn apart(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    greatest(pairs.map(|(a, b)| (a - b).abs() / a.abs().max(1.0)))
}

const PHASES: FourPhases = FourPhases {
    arms_out: 2.0,
    arms_in: 0.7,
    twist: FRAC_PI_2,
    duration: 2.0,
    pace: Pace::Even,
};

fn swivel() -> shape::Swivel {
    shape::Swivel::new(0.6, 2.0).unwrap().with(PHASES).unwrap()
}

#[test]
fn a_swivel_without_its_effects() {
    let asked = request(7.0, 1e-10);
    // Rigid, it does not turn; rigid with angular momentum it turns evenly.
    let rigid = shape::Swivel::new(0.6, 2.0).unwrap();
    let still = rows(&rigid, &asked);
    assert!(still.iter().all(|row| row[..2] == [0.0, 0.0]));
    let turning = rigid.with_angular_momentum(2.6).unwrap();
    for (t, state) in turning.simulate(&asked).unwrap().rows {
        near!(state.lower, t, 4e-15);
    }
    // Friction with c = 0 is no friction, to the error of the method that then has to run.
    let none = swivel().with(BearingFriction::new(0.0).unwrap()).unwrap();
    let exact = rows(&swivel(), &asked);
    for (a, b) in exact.iter().zip(rows(&none, &asked)) {
        near!(a[..], b[..], 3e-10);
    }
    // With friction the answer is another.
    let some = swivel().with(BearingFriction::new(0.1).unwrap()).unwrap();
    let difference = (exact[50][0] - rows(&some, &asked)[50][0]).abs();
    assert!(difference > 0.05, "{difference}");
}

/// Without L every round turns the lower part by the same angle, wherever one begins to count.
#[test]
fn every_round_of_the_swivel_is_like_the_first() {
    let times: Vec<f64> = (0..12).map(|k| 0.17 * f64::from(k)).collect();
    let later = |round: f64| times.iter().map(move |t| t + 2.0 * round);
    let at = |times: Vec<f64>| rows(&swivel(), &Request::at(times).unwrap());
    let (first, round) = (at(times.clone()), at(vec![2.0])[0][0]);
    // Halfway in, the arms have half the way behind them.
    near!(at(vec![0.75])[0][2], 0.5 * (2.0 + 0.7), 1e-15);
    for whole in [1.0, 5.0] {
        for (a, b) in first.iter().zip(at(later(whole).collect())) {
            near!(a[0] + whole * round, b[0], 1e-14);
        }
    }
}

/// The law L + cβ = const: however small the friction, it turns you all the way back.
#[test]
fn viscous_friction_undoes_the_swivel() {
    // Three cycles, and then as stiff as at their end.
    let asked = Request::at([6.0]).unwrap();
    let stiff = shape::Swivel::new(0.6, 2.0).unwrap();
    let free = swivel().simulate(&asked).unwrap().rows[0].1;
    let friction = BearingFriction::new(0.1).unwrap();
    let rubbed = swivel().with(friction).unwrap();
    let after = rubbed.simulate(&asked).unwrap().rows[0].1;
    let rest = stiff.with_angular_momentum(after.angular_momentum).unwrap();
    let rest = rest.with(friction).unwrap();
    // Time constant (A + B)/c = 26 s: after 594 s nothing is left.
    let late = rest.simulate(&Request::at([594.0]).unwrap()).unwrap();
    let late = after.lower + late.rows[0].1.lower;
    assert!(after.lower < 0.5 * free.lower, "{after:?}");
    assert!(late.abs() < 1e-9, "{late:e}");
}

/// 3 · 0.35 s over 0.35 s is rounded to less than 3, and yet the corner there has been passed. After 190 rounds, and 2,900 rad, the last is as exact as
/// the first.
#[test]
fn a_run_by_steps_gets_past_every_corner() -> Result<()> {
    let mut path = PHASES;
    path.duration = 1.4;
    let swivel = shape::Swivel::new(0.6, 2.0)?.with_angular_momentum(20.0)?;
    let turning = swivel.with(path)?.with(BearingFriction::new(1e-4)?)?;
    let end = turning.simulate(&asking([5.0, 266.0], 1e-10))?.rows[1].1;
    near!(end.angular_momentum + 1e-4 * end.lower, 20.0, 1e-12);
    Ok(())
}

fn grown() -> Skater {
    Skater::new(0.8, 2.5).unwrap()
}

const DRAW: Draw = Draw {
    to: 0.2,
    begin: 0.3,
    duration: 0.8,
    pace: Pace::Even,
};

#[test]
fn a_skater_without_effects_spins_evenly_and_friction_matters() -> Result<()> {
    let asked = request(2.0, 1e-10);
    let still = shape::Skater::new(grown(), 0.7, 12.0)?;
    for (t, state) in still.simulate(&asked)?.rows {
        assert_eq!((state.spin, state.work, state.heat), (12.0, 0.0, 0.0));
        near!(state.angle, 12.0 * t, 1e-13);
    }
    let moving = still.with(DRAW)?;
    let none = rows(&moving.with(BearingFriction::new(0.0)?)?, &asked);
    let off = apart(&rows(&moving, &asked), &none);
    assert!(off <= 1e-9, "{off:e}");
    // Without spin the arms work too, and get back what they have given.
    let standing = shape::Skater::new(grown(), 0.7, 0.0)?.with(DRAW)?;
    let standing = standing.with(BearingFriction::new(0.1)?)?;
    near!(rows(&standing, &asking([2.0], 1e-10))[0][4], 0.0, 1e-13);
    let rubbed = moving.with(BearingFriction::new(0.05)?)?;
    let motion = rubbed.simulate(&asked)?;
    let end = motion.rows[50].1;
    assert!(end.heat > 1.0 && end.spin < none[50][1] - 1.0, "{end:?}");
    assert!(motion.ledger.is_kept_within(1e-9)?, "{}", motion.ledger);
    Ok(())
}

const HALF: Half = Half {
    mass: 1.5,
    axial: 0.004,
    transverse: 0.016,
    to_joint: 0.12,
};

fn cat_body() -> Cat {
    Cat::new([HALF; 2]).unwrap()
}

const OVER: Turnover = Turnover {
    forward: PI / 2.0,
    back: 0.6,
    duration: 0.4,
    pace: Pace::Late,
};

fn cat() -> shape::Cat {
    let attitude = shape::Cat::on_its_back();
    shape::Cat::new(cat_body(), attitude).with(OVER).unwrap()
}

#[test]
fn gravity_moves_the_cat_and_does_not_turn_it() -> Result<()> {
    let asked = request(0.4, 1e-10);
    for asked in [asked.clone(), using(&asked, GENERAL)] {
        let floating = cat().simulate(&asked)?;
        let falling = cat().with(Gravity::new(9.81)?)?.simulate(&asked)?;
        for ((t, a), (_, b)) in floating.rows.iter().zip(&falling.rows) {
            // Not a bit.
            assert_eq!(a.attitude, b.attitude);
            assert_eq!(a.omega, b.omega);
            assert_eq!(a.center, SpaceVector::zero());
            near!(b.center.z(), -0.5 * 9.81 * t * t, 1e-15);
        }
        let weightless = cat().with(Gravity::new(0.0)?)?;
        assert_eq!(rows(&weightless, &asked), rows(&cat(), &asked));
    }
    Ok(())
}

#[test]
fn a_rigid_cat_does_not_turn_and_one_with_angular_momentum_does() -> Result<()> {
    let asked = request(0.4, 1e-10);
    let start = shape::Cat::on_its_back();
    let stiff = shape::Cat::new(cat_body(), start);
    for (_, state) in stiff.simulate(&asked)?.rows {
        assert!(state.attitude.angle_to(&start) < 1e-15);
    }
    // About the spine: evenly, L/2J.
    let spinning = stiff.with_angular_momentum(SpaceVector::new(0.008, 0.0, 0.0))?;
    let plan = spinning.plan(&asked)?;
    assert_eq!(plan.solver, Solver::Geometric(Geometric::DormandPrince8));
    for (t, state) in spinning.simulate(&asked)?.rows {
        assert!((state.attitude.angle_to(&start) - t).abs() < 1e-10);
    }
    // The shape adds its own turn: for a straight spine and equal halves the two parts do not simply add, but L stays.
    let both = cat().with_angular_momentum(SpaceVector::new(0.01, 0.02, -0.01))?;
    let motion = both.simulate(&asked)?;
    assert!(motion.ledger.is_kept_within(1e-13)?, "{}", motion.ledger);
    // Unequal halves have no closed form: `exact` is refused, by name.
    let mut heavier = HALF;
    heavier.axial = 0.005;
    let unequal = shape::Cat::new(Cat::new([HALF, heavier])?, start).with(OVER)?;
    let refused = unequal.simulate(&using(&asked, Solver::Exact));
    assert!(matches!(refused, Err(Error::Solver { condition }) if condition.contains("`exact`")));
    assert!(unequal.simulate(&asked).is_ok());
    Ok(())
}

#[test]
fn a_paper_cat_without_its_effects() {
    let asked = request(1.0, 1e-10);
    let cat = shape::PaperCat::new(PaperCat::POSTCARD, 2.9).unwrap();
    let (g, air) = (Gravity::new(9.81).unwrap(), Air::new(1.2).unwrap());
    // Without weight nothing moves, air or not.
    for rows in [rows(&cat, &asked), rows(&cat.with(air).unwrap(), &asked)] {
        assert!(rows.iter().all(|row| row[..] == [0.0, 0.0, 2.9, 0.0, 0.0]));
    }
    let falling = cat.with(g).unwrap();
    let vacuum = rows(&falling, &asked);
    let thin = falling.with(Air::new(0.0).unwrap()).unwrap();
    for (a, b) in vacuum.iter().zip(rows(&thin, &asked)) {
        near!(a[..], b[..], 1e-10);
    }
    let full = falling.with(air).unwrap().simulate(&asked).unwrap();
    assert!(full.rows[50].1.tilt < 1.0);
    assert!(full.ledger.is_kept_within(1e-9).unwrap(), "{}", full.ledger);
}

/// The double next to π is 1.2e-16 less: upside down, a cat of paper still knows on which side it is.
#[test]
fn a_paper_cat_upside_down_falls_to_the_nearer_side() -> Result<()> {
    let below = PI.next_down();
    for tilt in [PI, -PI, below, -below, PI.next_up()] {
        let feet_down = if tilt > PI { TAU } else { 0.0 };
        let cat = shape::PaperCat::new(PaperCat::POSTCARD, tilt)?;
        let cat = cat.with(Air::new(1.2)?)?.with(Gravity::new(9.81)?)?;
        let end = cat.simulate(&request(40.0, 1e-6))?.rows[50].1.tilt;
        near!(end, feet_down, 0.1);
    }
    Ok(())
}

fn crawler_body() -> shape::Crawler {
    let strokes = Strokes {
        gap: 0.3,
        length: 0.2,
        push: 1.0,
        pull: 0.15,
    };
    shape::Crawler::new(Crawler::new(3.0, 1.0, strokes).unwrap())
}

fn on_the_ground(mu: f64) -> shape::Crawler {
    let body = crawler_body().with(Coulomb::new(mu).unwrap()).unwrap();
    body.with(Gravity::new(9.81).unwrap()).unwrap()
}

#[test]
fn the_crawler_from_event_to_event_and_by_a_general_method() {
    for mu in [0.003, 0.03, 0.1, 0.3, 0.9] {
        let scene = on_the_ground(mu);
        let asked = request(8.0, 1e-10);
        assert_eq!(scene.plan(&asked).unwrap().solver, Solver::Events);
        let ours = scene.simulate(&asked).unwrap();
        let off = same(&ours, &scene.simulate(&using(&asked, GENERAL)).unwrap());
        assert!(off < 1e-10, "{mu}: {off:e}");
        // Observed: 6e-15.
        assert!(balance(&ours) <= 3e-14, "{mu}: {}", ours.ledger);
    }
}

/// Of feet of one weight none holds before the other: both slip, and come to rest together. The ground takes the way of both.
#[test]
fn a_crawler_with_equal_feet_pays_for_every_stroke() -> Result<()> {
    let strokes = Strokes {
        gap: 0.1,
        length: 0.1,
        push: 1.0,
        pull: 0.5,
    };
    // The last but one is an ulp heavier.
    let more = 1.0_f64.next_up();
    for (front, mu) in [(1.0, 0.02), (1.0, 0.3), (more, 0.3), (1.0, 10.0)] {
        let body = shape::Crawler::new(Crawler::new(1.0, front, strokes)?);
        let scene = body.with(Coulomb::new(mu)?)?.with(Gravity::new(9.81)?)?;
        let asked = request(3.0, 1e-10);
        for asked in [asked.clone(), using(&asked, GENERAL)] {
            for (t, state) in scene.simulate(&asked)?.rows {
                // Once 1.5 s, twice a cycle and a half of them: at every turn of the muscle all of its work is heat.
                if [1.5, 3.0].contains(&t) {
                    let heat = mu * 9.81 * 2.0 * 0.1 * t / 1.5;
                    near!(state.heat, heat, 1e-10 * heat);
                    near!(state.work, heat, 1e-10);
                }
                assert!(state.center.abs() < 1e-14, "{mu}: {state:?}");
            }
        }
    }
    Ok(())
}

/// On a rough ground both feet come to rest between two strokes: every cycle is like the first.
#[test]
fn every_cycle_of_a_crawler_that_comes_to_rest_is_like_the_first() {
    let times: Vec<f64> = (0..40).map(|k| 0.115 * f64::from(k)).collect();
    let rows = rows(&on_the_ground(3.0), &Request::at(times).unwrap());
    // Not beyond 250,000 of them.
    let [last, more] = [249_999.0, 250_001.0].map(|cycles| asking([1.15 * cycles], 1e-6));
    crawler_body().simulate(&last).unwrap();
    refused!(crawler_body().simulate(&more), OutOfRange);
    for (now, later) in rows.iter().zip(&rows[10..]) {
        for foot in [0, 1] {
            let first = rows[10][foot] - rows[0][foot];
            near!(later[foot] - now[foot], first, 1e-14);
        }
    }
    // An hour of them, by as little: no clock adds up.
    let hour = self::rows(&on_the_ground(3.0), &asking([1.15, 3450.0], 1e-9));
    near!(hour[1][2] / 3000.0, hour[0][2], 1e-15);
}

/// On smooth ice its feet never rest: after a thousand cycles it goes on as fast, however late the clock.
#[test]
fn a_crawler_that_never_rests_is_as_fast_in_every_cycle() {
    // A cycle takes 1.15 s.
    let rows = rows(&on_the_ground(1e-3), &asking([1.15e3, 2.3e5], 1e-6));
    near!(rows[0][3], rows[1][3], 1e-12);
}

#[test]
fn a_crawler_without_friction_gets_nowhere() {
    let asked = request(8.0, 1e-10);
    let ice = rows(&crawler_body(), &asked);
    let none = on_the_ground(0.0);
    for (a, b) in ice.iter().zip(rows(&none, &asked)) {
        // Feet, centre and velocity bit for bit; the work is summed over the strokes there.
        assert_eq!(a[..4], b[..4]);
        // Observed: 3e-14 J of 7 J.
        near!(a[4], b[4], 2e-13);
    }
    for mu in [1e-6, 1e-4, 1e-2] {
        let scene = on_the_ground(mu);
        for (t, state) in scene.simulate(&asked).unwrap().rows {
            // Friction can do no more than μg.
            assert!(state.center.abs() <= 0.5 * mu * 9.81 * t * t * (1.0 + 1e-12));
        }
        assert!(rows(&scene, &asked)[50][2] != 0.0);
    }
}

#[test]
fn what_cannot_be_simulated_is_refused() {
    let asked = Request::at([-1.0]).unwrap();
    refused!(swivel().simulate(&asked), OutOfRange);
    refused!(crawler_body().simulate(&asked), OutOfRange);
    let asked = Request::at([1.0]).unwrap();
    let of_tops = using(&asked, Solver::Geometric(Geometric::MuntheKaas));
    refused!(cat().simulate(&of_tops), Solver);
    let lift = cat().with(Air::new(1.0).unwrap());
    assert!(matches!(lift, Err(Error::Effect { effect: "air", .. })));
    refused!(swivel().simulate(&using(&asked, Solver::Events)), Solver);
    let far = Request::at([1e300]).unwrap();
    // An angle of so many radians has no digits behind the point; and so many corners cannot be passed.
    refused!(swivel().simulate(&far), Amplified);
    let rubbed = swivel().with(BearingFriction::new(0.1).unwrap()).unwrap();
    refused!(rubbed.simulate(&far), OutOfRange);
    refused!(crawler_body().simulate(&far), OutOfRange);
    let mut impossible = OVER;
    impossible.forward = 4.0;
    assert!(cat().with(impossible).is_err());
    let mut half = HALF;
    half.axial = 0.04;
    refused!(Cat::new([half, half]), TriangleInequality);
    let mut nothing = PaperCat::POSTCARD;
    nothing.mass = f64::NAN;
    assert!(shape::PaperCat::new(nothing, 0.0).is_err());
    refused!(shape::PaperCat::new(PaperCat::POSTCARD, 1e20), OutOfRange);
    assert!(shape::Skater::new(grown(), -1.0, TAU).is_err());
}

#[test]
fn times_come_in_the_order_asked_for() {
    let asked = Request::at([0.4, 0.0, 0.1, 0.4]).unwrap();
    let rows = cat().simulate(&asked).unwrap().rows;
    let times: Vec<f64> = rows.iter().map(|(t, _)| *t).collect();
    assert_eq!(times, [0.4, 0.0, 0.1, 0.4]);
    assert_eq!(rows[0].1, rows[3].1);
    assert_eq!(rows[1].1.bend.angle, 0.0);
}

#[test]
fn a_fall_and_a_cycle_beyond_the_doubles_are_refused() -> Result<()> {
    let falling = cat().with(Gravity::new(9.81)?)?;
    let late = Request::at([1e200])?;
    refused!(falling.simulate(&late), NotFinite, "the height fallen");
    let mut still = PHASES;
    still.twist = 0.0;
    still.duration = 1e-3;
    let swivel = shape::Swivel::new(0.6, 2.0)?.with(still)?;
    let late = Request::at([f64::MAX])?;
    refused!(swivel.simulate(&late), NotFinite, "the number of rounds");
    Ok(())
}
