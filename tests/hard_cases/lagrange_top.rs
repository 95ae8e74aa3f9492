//! Lagrange's top against a table of 32 digits: angular velocity, attitude, and the distances 1 ∓ cos θ from the poles.
//!
//! `tests/reference/lagrange_top.py` says how the table was made and by which two routes. The inputs are exact numbers, so
//! whatever differs is the library's error.

use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::{LagrangeTop, State};
use support::observed;

use support::double_double::Dd;
use support::table::{Report, WRONG, angle, lines};

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

fn table() -> impl Iterator<Item = Row> {
    lines(include_str!("../reference/lagrange_top.csv")).map(|cells| Row {
        id: cells.id(),
        group: cells.text(1),
        body: cells.exact(2),
        start_omega: cells.exact(5),
        start_attitude: cells.exact(8),
        time: cells.exact::<1>(12)[0],
        omega: cells.decimals(13),
        attitude: cells.decimals(16),
        nutations: cells.number(20),
        turns: cells.number(21),
    })
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

    /// Angle between the attitudes (radians), |ΔΩ| over the fastest rate, and how far the distances from the two poles are off,
    /// as chords of the unit sphere.
    fn errors(&self, state: &State) -> [f64; 3] {
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
        [
            angle(&state.attitude, self.attitude),
            if off == 0.0 { 0.0 } else { off / fastest },
            chord(state.one_less, twice * (b * b + c * c))
                .max(chord(state.one_more, twice * (a * a + d * d))),
        ]
    }
}

/// Bar for all errors, at any time. Observed: attitude 8.6e-16, Ω 1.2e-15, poles 5.1e-16.
const BAR: f64 = 3e-15;

#[test]
fn lagrange_top_against_the_table() {
    let spans = &[
        (10.5, "<= 10 nutations"),
        (f64::INFINITY, "<= 1e3 nutations"),
    ];
    let mut report = Report::new(["attitude", "omega", "poles"], BAR, spans);
    for row in table() {
        let (errors, note) = match row.top().and_then(|top| top.at(row.time)) {
            Ok(state) => (row.errors(&state), format!("h {:?}", state.height)),
            Err(error) => (WRONG, error.to_string()),
        };
        report.add(row.group, [row.nutations, row.turns], errors, || {
            format!(
                "row {} ({}, {:.4e} nutations, {:.4e} turns) {note}\n    body {:?} omega {:?} attitude {:?} t {:?}\n    ",
                row.id, row.group, row.nutations, row.turns, row.body, row.start_omega, row.start_attitude, row.time,
            )
        });
    }
    report.finish(ROWS);
}

/// The height is the difference of its complements: h = ½((1 + h) − (1 − h)), all three of the same state.
#[test]
fn height_and_its_complements_agree() -> Result<()> {
    for row in table() {
        let state = row.top()?.at(row.time)?;
        let half = 0.5 * (state.one_more - state.one_less);
        observed!((state.height - half).abs(), 0.0..=5e-16, "row {}", row.id);
        observed!((state.one_more + state.one_less - 2.0).abs(), 3e-16..=1e-15);
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
    for cells in lines(include_str!("../reference/lagrange_constants.csv")) {
        rows += 1;
        let [i1, i3, weight, x, y, z] = cells.exact(1);
        let [a, b, c, d] = cells.exact(7);
        let attitude = Attitude::from_quaternion(a, b, c, d)?;
        let top = LagrangeTop::new(i1, i3, weight, BodyVector::new(x, y, z), attitude)?;
        let numbers: [Dd; 6] = cells.decimals(11);
        let roots = top.roots();
        let ([less1, less2], [more1, more2]) = (roots.one_less, roots.one_more);
        let found = [less1, less2, more1, more2, roots.third_less_one];
        let mut errors = [0.0; 7];
        for k in 0..5 {
            errors[k] = relative(found[k], numbers[k]);
        }
        errors[5] = relative(top.period(), numbers[5]);
        // Through a pole the axis has no azimuth.
        if cells.text(17) != "nan" {
            let [exact] = cells.decimals(17);
            let found = top.precession_per_nutation().expect("a period");
            errors[6] = (Dd::from(found) - exact).value().abs() / exact.value().abs().max(1e-3);
        }
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = if *worst >= error { *worst } else { error };
        }
        if !errors.iter().all(|error| *error <= 1e-15) {
            failures.push(format!("row {rows}, {}: {}", cells.text(0), shown(errors)));
        }
    }
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
