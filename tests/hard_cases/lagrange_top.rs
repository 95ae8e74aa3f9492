//! Lagrange's top against a table of 32 digits: angular velocity, attitude, and the distances 1 ∓ cos θ from the poles.
//!
//! `tests/reference/lagrange_top.py` says how the table was made and by which two routes. The inputs are exact numbers, so
//! whatever differs is the library's error.

use std::collections::BTreeMap;

use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::{LagrangeTop, State};

use super::decimal::hexadecimal;
use super::inertia::{decimal, double_double::Dd};

/// One line of the table.
struct Row {
    id: usize,
    group: &'static str,
    /// I₁ = I₂, I₃ and Mgl.
    body: [f64; 3],
    start_omega: [f64; 3],
    start_attitude: [f64; 4],
    time: f64,
    omega: [Dd; 3],
    attitude: [Dd; 4],
    /// |t| in periods of nutation, infinite where there is none.
    nutations: f64,
    /// |t| times the fastest rate over 2π.
    turns: f64,
}

/// Angle between the attitudes (radians), |ΔΩ| over the fastest rate, and how far the distances from the two poles are off,
/// as chords of the unit sphere.
#[derive(Debug, Clone, Copy, Default)]
struct Errors {
    attitude: f64,
    omega: f64,
    poles: f64,
}

impl Errors {
    const WRONG: Self = Self {
        attitude: f64::INFINITY,
        omega: f64::INFINITY,
        poles: f64::INFINITY,
    };

    fn all(&self) -> [f64; 3] {
        [self.attitude, self.omega, self.poles]
    }
}

fn table() -> impl Iterator<Item = Row> {
    let lines = include_str!("../reference/lagrange_top.csv")
        .lines()
        .skip(1);
    lines.map(|line| {
        let fields: Vec<&'static str> = line.split(',').collect();
        let exact = |k: usize| hexadecimal(fields[k]);
        let number = |k: usize| fields[k].parse().expect("a number");
        Row {
            id: fields[0].parse().expect("a number"),
            group: fields[1],
            body: [2, 3, 4].map(exact),
            start_omega: [5, 6, 7].map(exact),
            start_attitude: [8, 9, 10, 11].map(exact),
            time: exact(12),
            omega: [13, 14, 15].map(|k| decimal(fields[k])),
            attitude: [16, 17, 18, 19].map(|k| decimal(fields[k])),
            nutations: number(20),
            turns: number(21),
        }
    })
}

/// Twice the vector part of q⁻¹p in 106 bits: the angle between the attitudes without a subtraction from 1.
fn angle(found: &Attitude, exact: [Dd; 4]) -> f64 {
    let p = found.quaternion();
    let [w, x, y, z] = [p.w, p.i, p.j, p.k].map(Dd::from);
    let [a, b, c, d] = exact;
    let i = a * x - b * w - c * z + d * y;
    let j = a * y + b * z - c * w - d * x;
    let k = a * z - b * y + c * x - d * w;
    2.0 * i.value().hypot(j.value()).hypot(k.value())
}

/// √2x̂ − √2x, which is what an error of the tilt is near a pole, where 1 − cos θ is flat.
fn chord(found: f64, exact: Dd) -> f64 {
    if found < 0.0 {
        return f64::INFINITY;
    }
    let sum = (2.0 * found).sqrt() + (2.0 * exact.value()).sqrt();
    if sum == 0.0 {
        0.0
    } else {
        2.0 * (Dd::from(found) - exact).value().abs() / sum
    }
}

impl Row {
    fn top(&self) -> Result<LagrangeTop> {
        let [w, x, y, z] = self.start_attitude;
        let attitude = Attitude::from_quaternion(w, x, y, z)?;
        // The table is for the floats that it prints: they must not be rounded again on the way in.
        let q = attitude.quaternion();
        assert_eq!([q.w, q.i, q.j, q.k], [w, x, y, z], "row {}", self.id);
        let [x, y, z] = self.start_omega;
        let [transverse, axial, weight_moment] = self.body;
        let omega = BodyVector::new(x, y, z);
        LagrangeTop::new(transverse, axial, weight_moment, omega, attitude)
    }

    fn errors(&self, state: &State) -> Errors {
        let [transverse, _, weight_moment] = self.body;
        let swing = (weight_moment / transverse).abs().sqrt();
        let fastest = self
            .start_omega
            .iter()
            .fold(swing, |most, omega| most.max(omega.abs()));
        let omega = state.omega.components();
        let off = [0, 1, 2].map(|k| (Dd::from(omega[k]) - self.omega[k]).value());
        let off = off[0].hypot(off[1]).hypot(off[2]);
        let [a, b, c, d] = self.attitude;
        let twice = Dd::from(2.0);
        Errors {
            attitude: angle(&state.attitude, self.attitude),
            omega: if off == 0.0 { 0.0 } else { off / fastest },
            poles: chord(state.one_less, twice * (b * b + c * c))
                .max(chord(state.one_more, twice * (a * a + d * d))),
        }
    }

    /// What the motion has gone through: nutations, or turns where nothing nutates.
    fn elapsed(&self) -> f64 {
        if self.nutations.is_finite() {
            self.nutations
        } else {
            self.turns
        }
    }
}

/// Bar for all errors, at any time. Observed: attitude 8.6e-16, Ω 1.2e-15, poles 5.1e-16.
const BAR: f64 = 3e-15;

#[test]
fn lagrange_top_against_the_table() {
    let mut worst: BTreeMap<(&str, bool), (Errors, usize)> = BTreeMap::new();
    let mut failures = Vec::new();
    let mut rows = 0;
    for row in table() {
        rows += 1;
        let (errors, note) = match row.top().and_then(|top| top.at(row.time)) {
            Ok(state) => (row.errors(&state), format!("h {:?}", state.height)),
            Err(error) => (Errors::WRONG, error.to_string()),
        };
        let entry = worst.entry((row.group, row.elapsed() > 10.5)).or_default();
        // Written so that a NaN stays.
        let larger = |a: f64, b: f64| if a >= b { a } else { b };
        entry.0.attitude = larger(entry.0.attitude, errors.attitude);
        entry.0.omega = larger(entry.0.omega, errors.omega);
        entry.0.poles = larger(entry.0.poles, errors.poles);
        entry.1 += 1;
        if !errors.all().iter().all(|error| *error <= BAR) {
            let [attitude, omega, poles] = errors.all();
            failures.push(format!(
                "row {} ({}, {:.4e} nutations, {:.4e} turns): attitude {attitude:.2e}, omega {omega:.2e}, poles {poles:.2e}, {note}\n    body {:?} omega {:?} attitude {:?} t {:?}",
                row.id, row.group, row.nutations, row.turns, row.body, row.start_omega, row.start_attitude, row.time,
            ));
        }
    }
    for ((group, long), (errors, count)) in &worst {
        let span = if *long { "<= 1e3" } else { "<= 10" };
        println!(
            "{group:>20} {span:>7} nutations, {count:>3} rows: attitude {:.1e}, omega {:.1e}, poles {:.1e}",
            errors.attitude, errors.omega, errors.poles
        );
    }
    assert_eq!(rows, ROWS);
    assert!(
        failures.is_empty(),
        "{} of {rows} rows\n{}",
        failures.len(),
        failures.join("\n")
    );
}

/// The height is the difference of its complements: h = ½((1 + h) − (1 − h)), all three of the same state.
#[test]
fn height_and_its_complements_agree() -> Result<()> {
    for row in table() {
        let state = row.top()?.at(row.time)?;
        let half = 0.5 * (state.one_more - state.one_less);
        assert!(
            (state.height - half).abs() <= 5e-16,
            "row {}: {:e}",
            row.id,
            state.height - half
        );
        assert!((state.one_more + state.one_less - 2.0).abs() <= 1e-15);
    }
    Ok(())
}

/// |found − exact|/|exact|; 0 for 0 against 0.
fn relative(found: f64, exact: Dd) -> f64 {
    if exact.value() == 0.0 {
        return found.abs();
    }
    ((Dd::from(found) - exact) / exact).value().abs()
}

fn shown(errors: [f64; 7]) -> String {
    errors.map(|error| format!("{error:.1e}")).join(" ")
}

/// Turning points, period and azimuth per nutation: `tests/reference/lagrange_constants.py` says how that table was made.
#[test]
fn constants_against_the_table() -> Result<()> {
    let mut worst = [0.0_f64; 7];
    let mut failures = Vec::new();
    let mut rows = 0;
    let lines = include_str!("../reference/lagrange_constants.csv")
        .lines()
        .skip(1);
    for line in lines {
        rows += 1;
        let fields: Vec<&str> = line.split(',').collect();
        let [i1, i3, weight, x, y, z] = [1, 2, 3, 4, 5, 6].map(|k| hexadecimal(fields[k]));
        let [a, b, c, d] = [7, 8, 9, 10].map(|k| hexadecimal(fields[k]));
        let attitude = Attitude::from_quaternion(a, b, c, d)?;
        let top = LagrangeTop::new(i1, i3, weight, BodyVector::new(x, y, z), attitude)?;
        let numbers = [11, 12, 13, 14, 15].map(|k| decimal(fields[k]));
        let roots = top.roots();
        let ([less1, less2], [more1, more2]) = (roots.one_less, roots.one_more);
        let found = [less1, less2, more1, more2, roots.third_less_one];
        let mut errors = [0.0; 7];
        for k in 0..5 {
            errors[k] = relative(found[k], numbers[k]);
        }
        errors[5] = relative(top.period(), decimal(fields[16]));
        // Through a pole the axis has no azimuth.
        if fields[17] != "nan" {
            let exact = decimal(fields[17]);
            let found = top.precession_per_nutation().expect("a period");
            errors[6] = (Dd::from(found) - exact).value().abs() / exact.value().abs().max(1e-3);
        }
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = if *worst >= error { *worst } else { error };
        }
        if !errors.iter().all(|error| *error <= 1e-15) {
            failures.push(format!("{} {line}", shown(errors)));
        }
    }
    println!(
        "1 - h1, 1 - h2, 1 + h1, 1 + h2, h3 - 1, period, azimuth: {}",
        shown(worst)
    );
    assert_eq!(rows, 200);
    assert!(
        failures.is_empty(),
        "{}\n{}",
        failures.len(),
        failures.join("\n")
    );
    Ok(())
}

/// Lines of the table.
const ROWS: usize = 857;
