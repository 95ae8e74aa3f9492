//! The yo-yo. Every effect has a place of its own, so the order of listing cannot matter.

use super::*;
use crate::yo_yo::{thick, toy};
use spinning_bodies::scene::effects::{AddedMass, AirDrag, AxleFriction, Hand, Sleep};
use spinning_bodies::scene::{Phase, Play, YoYoState};
use spinning_bodies::yo_yo::YoYo;

/// A yo-yo that leaves the hand at this speed, with weight.
fn thrown(toy: YoYo, speed: f64) -> Play {
    let play = Play::new(toy, speed).unwrap();
    play.with(gravity()).unwrap()
}

fn gravity() -> Gravity {
    Gravity::new(9.81).unwrap()
}

/// Odd times that meet no event.
fn times(until: f64) -> Vec<f64> {
    let odd = |k| until * (f64::from(k) + 0.123) / 200.0;
    (0..200).map(odd).collect()
}

fn run(scene: &impl Scene<State = YoYoState>, until: f64) -> Motion<YoYoState> {
    scene.simulate(&Request::at(times(until)).unwrap()).unwrap()
}

fn numbers(motion: &Motion<YoYoState>) -> Vec<Vec<f64>> {
    motion.rows.iter().map(|(_, state)| state.row()).collect()
}

/// Largest distance of depth (m) and spin (of 200 rad/s) between two motions.
fn apart(a: &Motion<YoYoState>, b: &Motion<YoYoState>) -> f64 {
    greatest(a.rows.iter().zip(&b.rows).map(|((_, a), (_, b))| {
        let spin = (a.omega - b.omega).abs() / 200.0;
        let spin = if a.phase == b.phase { spin } else { 0.0 };
        (a.depth - b.depth).abs().max(spin)
    }))
}

#[test]
fn every_effect_changes_the_motion() {
    let (bare, plain) = (Play::new(toy(), 1.0).unwrap(), thrown(toy(), 1.0));
    let loss = TurnLoss::new(0.9).unwrap();
    let let_go = thrown(toy(), 0.0);
    let sleeper = plain.with(Sleep::new(2.0).unwrap()).unwrap();
    for (without, effect) in [
        (bare, Effect::from(gravity())),
        (plain, loss.into()),
        (let_go.with(loss).unwrap(), Hand::new(0.1).unwrap().into()),
        (plain, Sleep::new(2.0).unwrap().into()),
        (sleeper, AxleFriction::new(5e-4).unwrap().into()),
        (plain, AirDrag::new(1e-8).unwrap().into()),
    ] {
        let with = without.with(effect).unwrap();
        assert!(apart(&run(&without, 12.0), &run(&with, 12.0)) > 0.1);
    }
}

/// Newton's law for the centre of mass: the string pulls with m(g − dV/dt), down and up, in the air too.
#[test]
fn the_string_pulls_as_the_fall_says() {
    let h = 1e-5;
    for toy in [toy(), thick()] {
        let plain = thrown(toy, 1.0);
        let in_air = plain.with(AirDrag::new(1e-7).unwrap()).unwrap();
        let mut seen = [0; 3];
        for scene in [plain, in_air] {
            // A turn at the end of the string is over in some hundredths of a second.
            let fine = (1..2000).map(|k| 2e-3 * f64::from(k));
            let looked = scene.simulate(&Request::at(fine.collect::<Vec<_>>()).unwrap());
            let looked = looked.unwrap().rows.into_iter();
            let turning = looked.filter(|(_, state)| state.phase == Phase::Turn);
            let coarse = (1..40).map(|k| 0.1 * f64::from(k));
            for t in coarse.chain(turning.map(|(t, _)| t)) {
                let request = asking([t - h, t, t + h], 1e-12);
                let rows = scene.simulate(&request).unwrap().rows;
                let [before, now, after] = [0, 1, 2].map(|k| rows[k].1);
                let phases = [Phase::Down, Phase::Up, Phase::Turn];
                let way = phases.iter().position(|phase| *phase == now.phase);
                let Some(way) = way.filter(|_| [before.phase, after.phase] == [now.phase; 2])
                else {
                    continue;
                };
                seen[way] += 1;
                let velocity = (after.depth - before.depth) / (2.0 * h);
                let pull = 0.055 * (9.81 - (after.velocity - before.velocity) / (2.0 * h));
                let off = (now.velocity - velocity).abs();
                assert!(off < 4e-6, "{t}: {} {velocity}", now.velocity);
                let off = (now.tension - pull).abs();
                assert!(off < 2e-6 * pull, "{t}: {} {pull}", now.tension);
            }
        }
        assert!(seen.iter().all(|count| *count > 5), "{seen:?}");
    }
}

#[test]
fn an_effect_of_size_zero_is_no_effect() {
    let plain = thrown(thick(), 0.0);
    let sleeper = plain.with(Sleep::new(2.0).unwrap()).unwrap();
    for (without, nothing) in [
        (plain, Effect::from(TurnLoss::new(1.0).unwrap())),
        (plain, Hand::new(0.0).unwrap().into()),
        (sleeper, AxleFriction::new(0.0).unwrap().into()),
    ] {
        let with = without.with(nothing).unwrap();
        assert_eq!(numbers(&run(&without, 12.0)), numbers(&run(&with, 12.0)));
    }
    // A sleep of no length still costs what the loop and the jerk take: it is the loop that is the effect.
    let nap = plain.with(Sleep::new(0.0).unwrap()).unwrap();
    assert!(apart(&run(&plain, 12.0), &run(&nap, 12.0)) > 0.05);
    // Air of resistance zero is integrated instead of solved.
    let airless = plain.with(AirDrag::new(0.0).unwrap()).unwrap();
    let airless = airless.simulate(&asking(times(12.0), 1e-12)).unwrap();
    let error = apart(&run(&plain, 12.0), &airless);
    assert!(error < 1e-10, "{error:e}");
}

#[test]
fn many_cycles_keep_their_energy() {
    // Let go from rest, no losses: 500 turns in 2000 s, and the ledger is not off by more than rounding. Observed: 5e-16.
    let plain = thrown(thick(), 0.0);
    let motion = run(&plain, 2000.0);
    assert!(balance(&motion) < 2e-15, "{:e}", balance(&motion));
    let mut states = motion.rows.iter().map(|(_, state)| state);
    assert!(states.all(|state| state.heat == 0.0 && state.work == 0.0));
    // With losses the heat is what is missing, turn after turn, until it hangs. Observed: 1e-15.
    let lossy = plain.with(TurnLoss::new(0.8).unwrap()).unwrap();
    let motion = run(&lossy, 60.0);
    assert!(balance(&motion) < 4e-15, "{:e}", balance(&motion));
    let (_, last) = motion.rows[motion.rows.len() - 1];
    assert_eq!((last.phase, last.omega), (Phase::Hanging, 0.0));
    // All of m g (l + r) has become heat.
    near!(last.heat, 0.055 * 9.81 * (1.0 + 0.004), 2e-15);
}

#[test]
fn the_hand_that_gives_what_the_turn_takes_keeps_it_going() {
    // Restitution 0.9 costs (1 - 0.81) of the energy at every turn.
    let (toy, loss) = (toy(), TurnLoss::new(0.9).unwrap());
    let energy = 0.055 * 9.81 * 1.0;
    let play = thrown(toy, 0.0).with(loss).unwrap();
    let kept = play.with(Hand::new(0.19 * energy).unwrap()).unwrap();
    let motion = run(&kept, 30.0);
    let tops = |motion: &Motion<YoYoState>| {
        let late = motion.rows.iter().filter(|(t, _)| *t > 20.0);
        late.map(|(_, state)| state.depth).fold(f64::MAX, f64::min)
    };
    assert!(tops(&motion) < 0.01, "{}", tops(&motion));
    assert!(tops(&run(&play, 30.0)) > 0.5);
    // With every turn the spin becomes what the energy says that it is.
    let stepped = kept.with(AirDrag::new(1e-12).unwrap()).unwrap();
    let stepped = run(&stepped, 30.0);
    let all = motion.rows.iter().chain(&stepped.rows);
    for (_, state) in all.filter(|(_, s)| s.depth < 1.0) {
        let kinetic = toy.kinetic_energy(state.depth, state.omega);
        near!(state.energy, kinetic - 0.055 * 9.81 * state.depth, 1e-9);
    }
    // A little more, and it slaps into the hand.
    let more = play.with(Hand::new(0.2 * energy).unwrap()).unwrap();
    let (_, last) = *run(&more, 30.0).rows.last().unwrap();
    assert_eq!(last.phase, Phase::Caught);
    assert_eq!([last.depth, last.energy], [0.0; 2]);
}

#[test]
fn what_it_sleeps_off_it_cannot_climb() {
    let friction = AxleFriction::new(2e-4).unwrap();
    let sleeper = thrown(toy(), 3.0).with(friction).unwrap();
    let highest = |duration: f64| {
        let scene = sleeper.with(Sleep::new(duration).unwrap()).unwrap();
        let motion = run(&scene, 30.0);
        let slept = motion.rows.iter().any(|(_, s)| s.phase == Phase::Asleep);
        assert!(slept);
        let after = motion.rows.iter().filter(|(t, _)| *t > duration + 0.4);
        after.map(|(_, s)| s.depth).fold(f64::MAX, f64::min)
    };
    assert_eq!(highest(5.0), 0.0, "caught");
    assert!(highest(60.0) > 1.0, "spun out: it hangs");
}

/// At rest there is nothing to compute, however long it hangs.
#[test]
fn what_hangs_costs_nothing() {
    let air = AirDrag::new(1e-8).unwrap();
    let airy = thrown(toy(), 0.0).with(air).unwrap();
    let dead = airy.with(TurnLoss::new(0.0).unwrap()).unwrap();
    let spent = |t: f64| {
        let asked = Request::at([t]).unwrap();
        let motion = dead.simulate(&asked.in_one_run(Effort::Tolerance(1e-9)));
        motion.unwrap().cost
    };
    assert_eq!(spent(10.0), spent(1e6));
}

#[test]
fn requests_that_it_cannot_fulfil_are_refused() {
    let plain = thrown(toy(), 0.0);
    refused!(plain.simulate(&asking([1.0, -1.0], 1e-10)), OutOfRange);
    let once = Request::at([1.0]).unwrap();
    refused!(plain.simulate(&using(&once, Solver::Exact)), Solver);
    let airy = plain.with(AirDrag::new(1e-8).unwrap()).unwrap();
    refused!(airy.simulate(&using(&once, Solver::Events)), Solver);
    let for_ever = Request::at([1e12]).unwrap().within(100_000);
    refused!(plain.simulate(&for_ever), Budget);
    assert!(TurnLoss::new(1.1).is_err());
    assert!(Hand::new(f64::NAN).is_err());
    assert!(plain.with(Gravity::new(-9.81).unwrap()).is_err());
    let added = AddedMass { factor: 1.0 };
    refused!(plain.with(added), Effect);
    // Dead at the first turn, let go without weight: nothing to compute, nothing to fear.
    let dead = plain.with(TurnLoss::new(0.0).unwrap()).unwrap();
    assert_eq!(run(&dead, 10.0).rows[199].1.phase, Phase::Hanging);
    let afloat = Play::new(toy(), 0.0).unwrap();
    assert_eq!(run(&afloat, 10.0).rows[199].1.depth, 0.0);
    // Any order of times.
    let [motion, sorted] = [[3.0, 1.0, 2.0], [1.0, 2.0, 3.0]].map(|times| {
        let request = Request::at(times).unwrap();
        plain.simulate(&request).unwrap().rows
    });
    assert_eq!(motion[..2], [sorted[2], sorted[0]]);
}
