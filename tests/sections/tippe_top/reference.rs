//! Trajectories against 25 digits, by other equations, another method and another arithmetic (`tests/reference/tippe_top.py`).

use super::*;

const G: f64 = 9.81;

/// The attitude of a turn about the second axis whose half angle has the tangent given, and a vertical spin.
fn spun(tangent: f64, spin: f64) -> Start {
    let attitude = Attitude::from_quaternion(1.0, 0.0, tangent, 0.0).unwrap();
    let up = attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0));
    Start::spinning(attitude, up * spin).unwrap()
}

fn states(scene: TableTop, times: &[f64]) -> Vec<(f64, State)> {
    let request = Request::at(times).unwrap().to_accuracy(1e-9).unwrap();
    scene.simulate(&request).unwrap().rows
}

fn of(name: &str, times: &[f64]) -> Vec<(f64, State)> {
    let on = |body: ConvexBody, start: Start| {
        TableTop::new(body, start)
            .with(Gravity::new(G).unwrap())
            .unwrap()
    };
    let coulomb = |mu: f64, epsilon: f64| Regularised::new(mu, epsilon).unwrap();
    let half = (1.0 - 0.16) / 1.16;
    let c1 = bodies::celt_ended_top(0.288, [0.351, 0.550, 0.505], f64::acos(half), 0.144).unwrap();
    match name {
        "tippe top viscous" => {
            let start = Start::spinning(spun(0.05, 0.0).attitude, BodyVector::new(0.0, 0.0, 155.0));
            let scene = on(bodies::tippe_top().unwrap(), start.unwrap());
            states(scene.with(Viscous::new(0.3).unwrap()).unwrap(), times)
        }
        "hoop with clay coulomb" => {
            let scene = on(
                bodies::hoop_with_clay(0.02, 0.02, 0.1).unwrap(),
                spun(0.1, 314.0),
            );
            states(scene.with(coulomb(1.0 / 3.0, 1e-3)).unwrap(), times)
        }
        "egg coulomb" => {
            let scene = on(bodies::egg(0.06, 0.03, 0.02).unwrap(), spun(0.9, 94.0));
            states(scene.with(coulomb(0.1, 2e-3)).unwrap(), times)
        }
        "chiral top +" | "chiral top -" => {
            let spin = if name.ends_with('+') { 132.9 } else { -132.9 };
            let scene = on(bodies::chiral_top().unwrap(), spun(0.025, spin));
            states(scene.with(coulomb(0.3, 1e-3)).unwrap(), times)
        }
        "celt-ended top" => {
            let scene = on(c1, spun(0.025, 102.4));
            states(scene.with(coulomb(0.5, 1e-3)).unwrap(), times)
        }
        "frictionless ellipsoid" => states(on(c1, spun(0.25, 20.0)), times),
        "rattleback rolling" => {
            let attitude = Attitude::from_quaternion(1.0, 0.004, 0.004, 0.0).unwrap();
            let start = Start::spinning(attitude, BodyVector::new(0.0, 0.0, -5.0)).unwrap();
            states(
                on(bodies::rattleback().unwrap(), start)
                    .with(NoSlip)
                    .unwrap(),
                times,
            )
        }
        other => panic!("no case {other}"),
    }
}

#[test]
fn s4_7_trajectories_to_eight_digits() {
    // claim: C4.7-1, C4.7-7, C4.7-8
    let table = include_str!("../../reference/tippe_top.csv");
    let lines: Vec<Vec<&str>> = table
        .lines()
        .skip(1)
        .map(|l| l.split(',').collect())
        .collect();
    assert!(lines.len() >= 18, "six cases of three times");
    for case in lines.chunks(3) {
        let name = case[0][0];
        let number = |line: &[&str], i: usize| line[i].parse::<f64>().unwrap();
        let times: Vec<f64> = case.iter().map(|line| number(line, 1)).collect();
        let mut worst = 0.0_f64;
        for (line, (_, state)) in case.iter().zip(of(name, &times)) {
            let q = Attitude::from_quaternion(
                number(line, 2),
                number(line, 3),
                number(line, 4),
                number(line, 5),
            );
            let omega = Vector3::new(number(line, 6), number(line, 7), number(line, 8));
            let angle = state.attitude.angle_to(&q.unwrap());
            let turn = (state.omega.components() - omega).norm() / omega.norm();
            worst = worst.max(angle).max(turn);
            let work = number(line, 9);
            near!(state.dissipated, work, 1e-8 * state.energy);
        }
        // Observed: 9e-11 at most; asked for is 1e-9.
        observed!(worst, 1e-11..=4e-10, "{name}: {worst:e}");
    }
}
