//! Lagrange's top against a table of 32 digits: angular velocity, attitude, and the distances 1 ∓ cos θ from the poles.
//!
//! `tests/reference/lagrange_top.py` says how the table was made and by which two routes. The inputs are exact numbers, so
//! whatever differs is the library's error.

use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::{LagrangeTop, State, dip};
use support::{greatest, near, observed, refused, vector, within};

use support::double_double::Dd;
use support::table::{Cells, angle, apart, lines};

const TABLE: &str = include_str!("../reference/lagrange_top.csv");

/// The state that is found for a line of the table.
fn state(cells: &Cells) -> Result<State> {
    let ([i1, i3, weight], [time]) = (cells.exact(2), cells.exact(12));
    let printed: [f64; 4] = cells.exact(8);
    let [w, x, y, z] = printed;
    let attitude = Attitude::from_quaternion(w, x, y, z)?;
    // The table is for the floats that it prints: they must not be rounded again on the way in.
    let q = attitude.quaternion();
    assert_eq!([q.w, q.i, q.j, q.k], printed, "row {}", cells.text(0));
    LagrangeTop::new(i1, i3, weight, vector(cells.exact(5)), attitude)?.at(time)
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

/// Angle between the attitudes (radians), |ΔΩ| over the fastest rate, and how far the distances from the two poles are off,
/// as chords of the unit sphere.
fn errors(cells: &Cells, state: &State) -> [f64; 4] {
    let ([transverse, _, weight], omega): ([f64; 3], [f64; 3]) = (cells.exact(2), cells.exact(5));
    let fastest = greatest(omega.map(f64::abs)).max((weight / transverse).abs().sqrt());
    let off = apart(state.omega, cells.decimals(13));
    let attitude @ [a, b, c, d] = cells.decimals(16);
    [
        angle(&state.attitude, attitude),
        if off == 0.0 { 0.0 } else { off / fastest },
        chord(state.one_less, 2.0 * (b * b + c * c)),
        chord(state.one_more, 2.0 * (a * a + d * d)),
    ]
}

/// Bar for all errors, at any time. Observed: attitude 8.6e-16, Ω 1.2e-15, poles 5.1e-16.
const BAR: f64 = 3e-15;

#[test]
fn lagrange_top_against_the_table() {
    let mut rows = 0;
    for cells in lines(TABLE) {
        let told = format!("row {} ({})", cells.text(0), cells.text(1));
        let state = state(&cells).expect(&told);
        observed!(greatest(errors(&cells, &state)), 4e-16..=BAR, "{told}");
        rows += 1;
    }
    assert_eq!(rows, 857);
}

/// The height is the difference of its complements: h = ½((1 + h) − (1 − h)), all three of the same state.
#[test]
fn height_and_its_complements_agree() -> Result<()> {
    for cells in lines(TABLE) {
        let state = state(&cells)?;
        let half = 0.5 * (state.one_more - state.one_less);
        near!(state.height, half, 0.0..=5e-16, "{}", cells.text(0));
        near!(state.one_more + state.one_less, 2.0, 3e-16..=1e-15);
    }
    Ok(())
}

/// |found − exact|/|exact|; 0 for 0 against 0.
fn relative(found: f64, exact: Dd) -> f64 {
    if exact.value() == 0.0 {
        return found.abs();
    }
    ((found - exact) / exact).value().abs()
}

/// Turning points, period and azimuth per nutation: `tests/reference/lagrange_constants.py` says how that table was made.
#[test]
fn constants_against_the_table() -> Result<()> {
    let mut rows = 0;
    for cells in lines(include_str!("../reference/lagrange_constants.csv")) {
        rows += 1;
        let ([i1, i3, weight], [a, b, c, d]) = (cells.exact(1), cells.exact(7));
        let attitude = Attitude::from_quaternion(a, b, c, d)?;
        let top = LagrangeTop::new(i1, i3, weight, vector(cells.exact(4)), attitude)?;
        let numbers: [Dd; 6] = cells.decimals(11);
        let roots = top.roots();
        let ([less1, less2], [more1, more2]) = (roots.one_less, roots.one_more);
        let (third, period) = (roots.third_less_one, top.period());
        let found = [less1, less2, more1, more2, third, period];
        let worst = greatest((0..6).map(|k| relative(found[k], numbers[k])));
        assert!(worst <= 1e-15, "row {rows}: {worst:e}");
        // Through a pole the axis has no azimuth.
        if cells.text(17) != "nan" {
            let [exact] = cells.decimals(17);
            let found = top.precession_per_nutation().expect("a period");
            let off = (found - exact).value().abs() / exact.value().abs().max(1e-3);
            assert!(off <= 1e-15, "row {rows}: azimuth off by {off:e}");
        }
    }
    assert_eq!(rows, 200);
    Ok(())
}

/// So close to upright that no double tells the square of the tilt: up to 2⁵³ quarter periods a state is a state all the same.
#[test]
fn next_to_upright_to_the_last_time_that_is_admitted() -> Result<()> {
    for tilt in [1e-140, 1e-155, 1e-161, 1e-170, 1e-250] {
        let attitude = Attitude::from_quaternion(1.0, 0.0, 0.5 * tilt, 0.0)?;
        let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::zero(), attitude)?;
        for turns in [1e3, 1e13, 2e14, 3e14, 1e15, 2.2e15] {
            for part in 0..5 {
                let state = top.at((turns + 0.23 * f64::from(part)) * top.period())?;
                let energy = 0.5 * state.omega.dot(&state.angular_momentum) + state.height;
                let kept = (energy - 1.0).abs() < 4e-15;
                assert!(kept, "{tilt:e} {turns:e}: {state:?}");
            }
        }
    }
    Ok(())
}

/// Without gravity both turning points are one, and found by different ways.
#[test]
fn a_top_that_only_turns_has_its_roots_in_order() -> Result<()> {
    for l_vert in (0..4000).map(|k| 0.001 * f64::from(k) - 2.0) {
        let top = LagrangeTop::above_upright(1e-150, 1.19e-150, 0.0, 4.0, l_vert, 0.0)?;
        let r = top.roots();
        let ordered = r.h1 <= r.h2 && r.one_less[0] >= r.one_less[1];
        assert!(ordered && r.one_more[0] <= r.one_more[1], "{r:?}");
    }
    Ok(())
}

/// On the separatrix it stands still long before its argument is no double any more; then it says so.
#[test]
fn at_the_end_of_the_doubles_a_time_is_refused() -> Result<()> {
    let top = LagrangeTop::above_upright(1.4e-153, 0.0, 4.6e163, 0.0, 0.0, 0.0)?;
    assert_eq!(top.at(1e149)?.height, 1.0);
    refused!(top.at(1e150), OutOfRange);
    Ok(())
}

/// Units in which squares overflow, tilts whose squares underflow, and an energy just below that of the least motion.
#[test]
fn the_ends_of_the_doubles() -> Result<()> {
    let standing = LagrangeTop::above_upright(1e-134, 1e-134, 1e240, 0.0, 0.0, 0.0)?;
    within((standing.energy() / 1e240 - 1.0).abs(), 1e-15);
    // What a turn multiplies leaves the doubles, and what comes of it does not: it takes axis 2 to the vertical.
    let omega = vector([1.5e8, -1.5e8, 1.5e8]);
    let turned = Attitude::from_quaternion(1.0, 1.0, 1.0, 1.0)?;
    let heavy = LagrangeTop::new(1e300, 1e300, 0.0, omega, turned)?;
    let vertical = heavy.vertical_angular_momentum();
    within((vertical / -1.5e308 - 1.0).abs(), 1e-15);
    // Next to upright θ₁²/θ₀² is λ/(λ − 1), λ = 9/4.
    let sunk = dip(1.0, 1.0, 3.0, 1e-200)?;
    let ratio = 3.0 / 5.0_f64.sqrt();
    within((sunk.lowest_tilt / 1e-200 - ratio).abs(), 1e-15);
    within((sunk.depth / 1e-200 - ratio + 1.0).abs(), 1e-15);
    for missing in [1e-3, 1e-17, 1e-300] {
        let asleep = LagrangeTop::above_upright(1.0, 0.5, 1.0, 2.5, 2.5, -missing);
        refused!(asleep, Condition);
    }
    Ok(())
}
