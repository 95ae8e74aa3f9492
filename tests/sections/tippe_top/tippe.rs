//! The axisymmetric tippe top: closed forms and the full motion.

use super::*;
use spinning_bodies::scene::effects::Resistance;
use spinning_bodies::tippe_top::Inversion;

const MR2: f64 = 0.02 * 0.02 * 0.02;

/// The top of Rauch-Wojciechowski and Rutstam.
fn top() -> TippeTop {
    TippeTop::new(0.02, 0.02, 0.3, MR2 * 131.0 / 350.0, MR2 * 0.4, 9.82).unwrap()
}

fn scene(spin: f64) -> TableTop {
    let start = Start::about_third_axis(0.1, 0.0, spin).unwrap();
    on_a_table(bodies::tippe_top().unwrap(), start, 9.82, viscous(0.3))
}

#[test]
fn s4_7_tippe_top_turns_over() {
    // claim: C4.7-2, C4.7-7
    let rows = run(&scene(155.0), 8.0, 4000, 1e-9);
    let t = |level| passage(&rows, degrees, level).unwrap();
    near!(t(170.0), 5.92, 2e-4..=0.005);
    let weight = 0.02 * 9.82;
    let least = -most(&rows, |s| -s.reaction) / weight;
    near!(least, 0.70, 1e-4..=0.005);
    // Observed: 4e-15.
    observed!(drift(&rows, |s| s.jellett), 8e-16..=9e-14);
}

#[test]
fn s4_7_thresholds_and_final_tilts() {
    // claim: C4.7-12
    let top = top();
    near!(top.least_spin_to_invert().unwrap(), 76.761, 9e-5..=5e-4);
    near!(top.least_spin_to_rise().unwrap(), 27.668, 2e-5..=5e-4);
    // λ² = M g R³ I3 α (1+α)⁴/(1 + α − γ), and at the other end.
    let gamma = 131.0 / 140.0;
    let unit = 0.02 * 9.82 * 0.02_f64.powi(3) * MR2 * 0.4 * 0.3;
    let inverted = (unit * 1.3_f64.powi(4) / (1.3 - gamma)).sqrt();
    let upright = (unit * 0.7_f64.powi(4) / (gamma - 0.7)).sqrt();
    close!(top.steady_jellett(PI).unwrap(), inverted, 0.0..=1e-14);
    close!(top.steady_jellett(0.0).unwrap(), upright, 0.0..=1e-14);
    for spin in [35.0, 40.0, 50.0, 60.0, 70.0, 74.0, 76.0] {
        let jellett = top.jellett_of_spin(spin, 0.1);
        // A stationary point of the effective potential, and the steady state there has this very λ.
        let steady = top.steady_jellett(top.final_tilt(jellett, 0.1).unwrap());
        close!(steady.unwrap(), jellett, 0.0..=2e-15);
    }
}

/// Of round tops from one end of complete inversion to the other: less spin leaves them short of their heads, more does not.
#[test]
fn the_least_spin_that_inverts_inverts() {
    for alpha in [0.1, 0.3, 0.6] {
        for part in [0.01, 0.1, 0.3, 0.9] {
            let gamma = 1.0 - alpha + 2.0 * alpha * part;
            let top = TippeTop::new(0.02, 0.02, alpha, MR2 * 0.4 * gamma, MR2 * 0.4, 9.82).unwrap();
            let spin = top.least_spin_to_invert().unwrap();
            let ends = |part: f64| top.final_tilt(top.jellett_of_spin(part * spin, 0.0), 0.0);
            let inverts = ends(0.999).unwrap() < PI && ends(1.001).unwrap() == PI;
            assert!(inverts, "{alpha} {gamma}");
            assert!(spin >= top.least_spin_to_rise().unwrap());
        }
    }
}

#[test]
fn s4_7_where_the_motion_ends_is_where_the_closed_form_says() {
    // claim: C4.7-12, C4.7-19
    let top = top();
    for spin in [40.0, 60.0, 74.0, 78.0] {
        let rows = run(&scene(spin), 60.0, 120, 1e-6);
        let closed = top.final_tilt(top.jellett_of_spin(spin, 0.1), 0.1).unwrap();
        let end = last(&rows);
        near!(end.tilt(), closed, 2e-5..=5e-4, "{spin}");
    }
}

#[test]
fn s4_7_steady_states_do_not_slip() {
    // claim: C4.7-19
    let top = top();
    let body = top.body().unwrap();
    for i in 1..30 {
        let tilt = PI * f64::from(i) / 30.0;
        let Some(jellett) = top.steady_jellett(tilt) else {
            continue;
        };
        // λ = R φ̇ D, and Ω = φ̇ (z − α e).
        let ((sine, cosine), [across, along]) = (tilt.sin_cos(), [131.0 / 350.0, 0.4]);
        let inertia = MR2 * (across * sine * sine + along * (cosine - 0.3) * (cosine - 0.3));
        let up = BodyVector::new(sine, 0.0, cosine);
        let omega = (up - BodyVector::new(0.0, 0.0, 0.3)) * (jellett / (0.02 * inertia));
        // Ω is parallel to the arm: the contact is at rest, and so is C.
        let arm = body.lowest_point(up).unwrap();
        assert!(omega.cross(&arm).norm() < 1e-15 * omega.norm());
        let start = Start::about_vertical(tilt, 0.0, 1.0).unwrap();
        let start = Start::spinning(start.attitude, omega).unwrap();
        let scene = on_a_table(body, start, 9.82, viscous(0.3));
        let end = last(&run(&scene, 0.05, 1, 1e-10));
        near!(end.tilt(), tilt, 1e-14..=2e-12, "{tilt}");
        observed!(end.slip.norm(), 1e-14..=2e-12, "{tilt}");
        close!(end.jellett, jellett, 9e-16..=1e-13);
        let energy = top.effective_potential(tilt, end.jellett);
        close!(end.energy, energy, 0.0..=3e-15);
    }
}

#[test]
fn s4_7_classes_of_ueda_sasaki_and_watanabe() {
    // claim: C4.7-12
    // So small that λ² and D² are below every double.
    let of = |gamma: f64| TippeTop::new(1.0, 1e-60, 0.3, 4e-121 * gamma, 4e-121, 1e-60).unwrap();
    for (gamma, class) in [
        (0.6, Inversion::Never),
        (0.65, Inversion::Never),
        (0.75, Inversion::Complete),
        (1.25, Inversion::Complete),
        (1.35, Inversion::Partial),
    ] {
        let top = of(gamma);
        assert_eq!(top.inversion(), class);
        let far = top.final_tilt(1e-176, 0.01).unwrap();
        match class {
            Inversion::Never => assert!(far < 0.01 && top.least_spin_to_rise().is_none()),
            Inversion::Complete => assert!((far - PI).abs() < 1e-12),
            Inversion::Partial => {
                assert!(far > 2.0 && far < 3.1 && top.least_spin_to_invert().is_none())
            }
        }
    }
}

/// Where the band of tilts at which it rises is narrow, a top that sinks is caught by it all the same.
#[test]
fn s4_7_a_narrow_valley_holds_it() {
    // claim: C4.7-12
    let top = TippeTop::new(1.0, 1.0, 0.1, 0.4 * 0.6, 0.4, 1.0).unwrap();
    let steady = |tilt: f64| top.steady_jellett(tilt).unwrap();
    // The least λ of all steady states, near 2.036 rad, and one above it whose two tilts lie 0.01 rad apart.
    let tilts = (0..20_000).map(|k| 1.9 + 1.5e-5 * f64::from(k));
    let least = tilts.min_by(|a, b| steady(*a).total_cmp(&steady(*b)));
    let least = least.unwrap();
    near!(least, 2.036, 1e-4..=1e-2, "{least}");
    let held = least + 0.005;
    assert!(steady(least - 0.006) > steady(held));
    for start in [2.2, 2.45, 2.6, 2.7, 2.8, 2.9, 3.0, 3.1] {
        let end = top.final_tilt(steady(held), start).unwrap();
        near!(end, held, 5e-15..=1e-12, "from {start}: {end}");
    }
}

/// A ball that pivots and rolls without slipping, under resistance: each rate dies by its own coefficient.
#[test]
fn s4_7_pivoting_and_rolling_die_apart() {
    let (mass, radius, moment) = (0.17, 0.03, 6e-5);
    let inertia = InertiaMatrix::diagonal(moment, moment, moment).unwrap();
    let surface = Surface::sphere(radius).unwrap();
    let ball = ConvexBody::new(mass, inertia, surface, BodyVector::zero()).unwrap();
    let (rolling, pivoting) = (2e-5, 7e-5);
    let after = |omega: BodyVector, t: f64| -> State {
        let start = Start::about_vertical(0.0, 0.0, 0.0).unwrap();
        let start = Start::spinning(start.attitude, omega).unwrap();
        let table = on_a_table(ball, start, G, NoSlip);
        let table = table.with(Resistance::new(rolling, pivoting).unwrap());
        last(&run(&table.unwrap(), t, 1, 1e-11))
    };
    let weight = mass * G;
    for t in [0.2, 1.0] {
        let spins = after(vector([0.0, 0.0, 30.0]), t);
        let pivots = 30.0 * (-pivoting * weight * t / moment).exp();
        close!(spins.spin(), pivots, 0.0..=2e-15);
        let rolls = after(vector([0.0, 30.0, 0.0]), t);
        let whole = moment + mass * radius * radius;
        let rate = 30.0 * (-rolling * weight * t / whole).exp();
        close!(rolls.omega.norm(), rate, 0.0..=2e-14);
    }
}

/// M(g + z̈) of C, by differences of its height alone, is the reaction of the table, where resistance lifts or lowers C.
#[test]
fn s4_7_the_table_bears_what_the_height_says() {
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.37, 0.37, 0.4));
    let body = bodies::eccentric_ball(0.02, 0.02, 0.3, inertia);
    let start = Start::about_third_axis(1.1, 0.4, 60.0).unwrap();
    let table = on_a_table(body.unwrap(), start, G, NoSlip);
    let heavy = table.with(Resistance::new(3e-4, 1e-4).unwrap()).unwrap();
    let rows = run(&heavy, 0.04, 40, 1e-12);
    let free = run(&table, 0.04, 40, 1e-12);
    let (h, mut worst, mut matters) = (1e-3_f64, 0.0_f64, 0.0_f64);
    for (five, other) in rows.windows(5).zip(&free[2..]) {
        let z = [0, 1, 2, 3, 4].map(|k| five[k].1.position.z());
        let bend = (16.0 * (z[1] + z[3]) - (z[0] + z[4]) - 30.0 * z[2]) / (12.0 * h * h);
        let borne = 0.02 * (G + bend);
        worst = worst.max((five[2].1.reaction / borne - 1.0).abs());
        matters = matters.max((five[2].1.reaction / other.1.reaction - 1.0).abs());
    }
    assert!(worst < 1e-4 && matters > 1e-2, "{worst:e} {matters:e}");
}
