//! The attitude: rebuilt from the polhode (6.2), after one period (6.6), and by theta functions (6.8).

use super::*;
use nalgebra::{Complex, Quaternion};
use spinning_bodies::elliptic::{Characteristic, complete_third, incomplete_first};

/// The azimuth of a vector about L, seen from its tip; zero where `from` points.
fn azimuth(vector: SpaceVector, from: SpaceVector, l: SpaceVector) -> f64 {
    let [v, f] = [vector, from].map(|v| v.components());
    let n = l.components() / l.norm();
    let side = n.cross(&f);
    side.dot(&v).atan2((f - n * n.dot(&f)).dot(&v))
}

// claim: C6.2-8
#[test]
fn s6_2_motion_rebuilt_from_the_polhode() {
    let top = example();
    let size = 14f64.sqrt();
    // Ω alone, with its pace, gives the azimuth of x₃ about L.
    let rate = |t: f64| {
        let [o1, o2, _] = omega(&top, t);
        size * (o1 * o1 + 2.0 * o2 * o2) / (o1 * o1 + 4.0 * o2 * o2)
    };
    let turned = integral(rate, 0.0, 1.0);
    close!(turned, 2.736_033_504_273_013, 0.0..=3e-15);
    // The same in the exact attitude and in the integrated one.
    let x3 = vector([0.0, 0.0, 1.0]);
    let l = top.angular_momentum_in_space();
    let before = at(&top, 0.0).attitude.to_space(x3);
    let flight = Flight::from_omega(MOMENTS, omega(&top, 0.0)).fly(1.0);
    for attitude in [at(&top, 1.0).attitude, flight.attitude()] {
        let now = attitude.to_space(x3);
        let off = (azimuth(now, before, l) - 2.736_033_504_273_013).abs();
        observed!(off, 0.0..=4.5e-16); // observed none
        // And the angle between x₃ and L from I₃Ω₃/|L|.
        let off = (now.dot(&l) / size - 3.0 * omega(&top, 1.0)[2] / size).abs();
        observed!(off, 0.0..=4.5e-16); // observed none
    }
    // The condition: the curve without its pace is not enough. Along the same curve at constant parameter speed
    // the azimuth comes out differently.
    let (curve, end) = (picture(&top, 0.0), picture(&top, 1.0).start());
    let wrong: f64 = (0..64)
        .map(|n| {
            let o = curve.polhode(end * (f64::from(n) + 0.5) / 64.0);
            size * (o.x().powi(2) + 2.0 * o.y().powi(2))
                / (o.x().powi(2) + 4.0 * o.y().powi(2))
                / 64.0
        })
        .sum();
    assert!((wrong - turned).abs() > 0.01, "{wrong}");
}

/// By how much the body turns about L in a period: ∫|L|(2E − L_kΩ_k)/(L² − L_k²) dt over one period, by equal ordinates; k the axis
/// that the polhode goes round.
fn turn_by_quadrature(top: &EulerTop, k: usize) -> f64 {
    let l = at(top, 0.0).angular_momentum;
    let (size, twice_energy) = (l.norm(), 2.0 * top.energy());
    let period = top.period();
    period
        * mean(600, |s| {
            let state = at(top, s * period);
            let l = state.angular_momentum.components();
            let o = state.omega.components();
            let squares = (0..3).filter(|j| *j != k).map(|j| l[j].powi(2));
            size * (twice_energy - l[k] * o[k]) / squares.sum::<f64>()
        })
}

/// The solid angle swept by L in the body: ∮ (1 − cos θ) dφ about axis k, positive if right-handed about L.
fn solid_angle(top: &EulerTop, k: usize) -> f64 {
    let i = top.moments();
    let l = at(top, 0.0).angular_momentum;
    let size = l.norm();
    let (a, b) = ((k + 1) % 3, (k + 2) % 3);
    let side = l.components()[k].signum();
    let period = top.period();
    period
        * mean(600, |s| {
            let o = omega(top, s * period);
            let rate = euler(i, o);
            let square = (i[a] * o[a]).powi(2) + (i[b] * o[b]).powi(2);
            let turning = i[a] * i[b] * (o[a] * rate[b] - o[b] * rate[a]) / square;
            // 1 − cos θ = sin²θ/(1 + cos θ).
            let cosine = (i[k] * o[k]).abs() / size;
            side * turning * square / (size * size) / (1.0 + cosine)
        })
}

// claim: C6.6-14
#[test]
fn s6_6_turn_after_one_period() {
    // By the register, to twenty digits; the second top in the other sector.
    let other = tilted(MOMENTS, [2.0, 0.0, 1.0]);
    for (top, k, expected) in [
        (example(), 2, 15.580_047_713_328_212_112_5),
        (other, 0, 11.754_983_226_935_397_075_1),
    ] {
        let turn = top.mean_precession_rate() * top.period();
        close!(turn, expected, 0.0..=4.5e-16);
        close!(turn_by_quadrature(&top, k), expected, 2e-16..=3e-15);
    }
    // The complete integral of the third kind: 2E = 6, L² = 14, P₁² = 2, P₂² = 8, rate 2/√3, n = 1 − P₂²/P₁² = −3.
    let half = Parameter::from_parameter(0.5).unwrap();
    let third = complete_third(Characteristic::from_characteristic(-3.0).unwrap(), half).unwrap();
    let size = 14f64.sqrt();
    let closed = size
        * (example().period() / 3.0 + (6.0 - 14.0 / 3.0) / 2.0 * 4.0 * third * 3f64.sqrt() / 2.0);
    close!(closed, 15.580_047_713_328_212_112_5, 0.0..=1e-15);
    // Montgomery: 2ET/|L| less the solid angle, any body, either sector, unsorted axes; against the integrated attitude.
    let mut numbers = Uniform(6614);
    let mut starts = vec![
        (MOMENTS, [0.4, 0.3, 1.0]),
        (MOMENTS, [2.0, 0.0, 1.0]),
        (MOMENTS, [-2.0, 0.3, -1.0]),
    ];
    starts.extend((0..24).map(|_| random_start(&mut numbers)));
    for (moments, omega0) in starts {
        let top = tilted(moments, omega0);
        let k = kept_axis(&top);
        let phase = top.geometric_phase().unwrap();
        let l = top.angular_momentum_in_space();
        let dynamical = 2.0 * top.energy() * top.period() / l.norm();
        close!(phase.dynamical, dynamical, 0.0..=1e-15);
        let swept = solid_angle(&top, k);
        observed!((phase.geometric + swept).abs(), 1e-15..=3e-14); // observed 8e-15
        let truth = Flight::from_omega(moments, omega0).fly(top.period());
        // The turn that brings the body from its first attitude to this one is about L.
        let q = truth.attitude().quaternion();
        let along = q.imag().dot(&l.components()) / l.norm();
        let turn = 2.0 * along.atan2(q.w);
        let off = (q.imag() - l.components() / l.norm() * along).norm();
        observed!(off, 1e-16..=2e-15); // observed 3.6e-16
        let together = phase.dynamical + phase.geometric;
        within(wrapped(together - turn).abs(), 4e-15 + 4e-16 * dynamical);
        // With the whole turns: the mean precession, which counts those of the axis that L goes round.
        let counted = top.mean_precession_rate() * top.period();
        within(wrapped(counted - together).abs(), 4e-15 + 4e-16 * dynamical);
        close!(turn_by_quadrature(&top, k), counted, 4e-16..=6e-15); // observed 1.4e-15
        // No small number of periods brings the body home.
        for n in 1..30 {
            assert!(wrapped(f64::from(n) * turn).abs() > 1e-6);
        }
    }
}

/// Jacobi's four theta functions of a complex argument, by their series.
fn theta(kind: u32, nome: f64, z: Complex<f64>) -> Complex<f64> {
    let mut total = Complex::from(if kind > 2 { 1.0 } else { 0.0 });
    for n in 0..12 {
        let order = f64::from(n) + if kind > 2 { 1.0 } else { 0.5 };
        let alternating = if n % 2 == 0 { 1.0 } else { -1.0 };
        let sign = match kind {
            1 => alternating,
            4 => -alternating,
            _ => 1.0,
        };
        let turned = z * (2.0 * order);
        let wave = if kind == 1 {
            turned.sin()
        } else {
            turned.cos()
        };
        total += wave * (2.0 * sign * nome.powf(order * order));
    }
    total
}

fn real_theta(kind: u32, nome: f64, x: f64) -> f64 {
    theta(kind, nome, x.into()).re
}

/// sn, cn, dn as quotients of theta functions.
fn jacobi_by_theta(nome: f64, u: f64) -> [f64; 3] {
    let [t2, t3, t4] = [2, 3, 4].map(|kind| real_theta(kind, nome, 0.0));
    let z = u / (t3 * t3);
    let denominator = real_theta(4, nome, z);
    [
        t3 / t2 * real_theta(1, nome, z) / denominator,
        t4 / t2 * real_theta(2, nome, z) / denominator,
        t4 / t3 * real_theta(3, nome, z) / denominator,
    ]
}

// claim: C6.8-1
#[test]
fn s6_8_theta_functions() {
    // m = 1/2 has the nome e^{−π}.
    let nome = (-PI).exp();
    let modulus = Modulus::new(Parameter::from_parameter(0.5).unwrap());
    let quarter = FRAC_PI_2 * real_theta(3, nome, 0.0).powi(2);
    close!(quarter, 1.854_074_677_301_371_918_4, 1e-16..=4.5e-16);
    let error = relative(modulus.quarter_period(), 1.854_074_677_301_371_918_4);
    observed!(error, 0.0..=2.3e-16);
    let expected = [
        0.803_001_824_895_643_887_6,
        0.595_976_567_672_140_674_0,
        0.823_161_001_631_596_269_4,
    ];
    let jacobi = modulus.jacobi(1.0).unwrap();
    let error = norm(difference([jacobi.sn, jacobi.cn, jacobi.dn], expected));
    observed!(error, 0.0..=4.5e-16); // observed none
    let error = norm(difference(jacobi_by_theta(nome, 1.0), expected));
    observed!(error, 2e-16..=2e-15); // observed 5e-16
    for k in -20..20 {
        let u = 0.31 * f64::from(k);
        let jacobi = modulus.jacobi(u).unwrap();
        let off = difference([jacobi.sn, jacobi.cn, jacobi.dn], jacobi_by_theta(nome, u));
        observed!(norm(off), 6e-16..=6e-15); // observed 1.9e-15
    }
    // The whole motion, attitude and all, by theta series: I = (1, 2, 3), 2E = 6, L² = 14.
    let (size, rate) = (14f64.sqrt(), 2.0 / 3f64.sqrt());
    let amplitudes = [2f64.sqrt(), 2.0 * 2f64.sqrt(), 2.0 * 3f64.sqrt()];
    // L/|L| at sn = 0 stands at the height am η for the complementary modulus, here the same 1/2.
    let half = Parameter::from_parameter(0.5).unwrap();
    let eta = incomplete_first((amplitudes[2] / size).asin(), half).unwrap();
    let w = PI * eta / (2.0 * complete_first(half).unwrap());
    let terms = (1..8).map(f64::from);
    let terms = terms.map(|n| 4.0 * n * nome.powf(n * n) * (2.0 * n * w).sinh());
    let sum: f64 = terms.sum();
    let excess = FRAC_PI_2 / quarter * sum / theta(3, nome, Complex::new(0.0, w)).re;
    let nu = size / 2.0 + rate * excess;
    let turned = |t: f64| {
        let u = rate * t;
        let [sn, cn, dn] = jacobi_by_theta(nome, u);
        let z = theta(4, nome, Complex::new(FRAC_PI_2 / quarter * u, w));
        let l = [amplitudes[0] * cn, amplitudes[1] * sn, amplitudes[2] * dn];
        let psi = nu * t + z.arg() - l[1].atan2(l[0]);
        // The shortest turn that carries L onto x₃, and then ψ about it.
        let upright = Quaternion::new(l[2] + size, l[1], -l[0], 0.0);
        let about = Quaternion::new((psi / 2.0).cos(), 0.0, 0.0, (psi / 2.0).sin());
        (about * upright).normalize()
    };
    let top = example();
    let mut flight = Flight::from_omega(MOMENTS, omega(&top, 0.0));
    for step in 0..40 {
        let t = 0.25 * f64::from(step);
        let q = turned(0.0).conjugate() * turned(t);
        let series = Attitude::from_quaternion(q.w, q.i, q.j, q.k).unwrap();
        let truth = if step == 0 { flight } else { flight.fly(0.25) };
        observed!(series.angle_to(&truth.attitude()), 2e-15..=3e-14); // observed 6.7e-15
        let error = at(&top, t).attitude.angle_to(&truth.attitude());
        observed!(error, 2e-16..=2e-15); // observed 5.1e-16
    }
    // Tori: Ω and attitude run with two frequencies, 2π/T and the mean precession; strip both off and what is left comes
    // back with every period.
    let l = vector(in_space(top.angular_momentum_in_space()));
    let left = |t: f64| {
        let back = Attitude::about_axis(l, -top.mean_precession_rate() * t).unwrap();
        let turned = at(&top, t).attitude.to_space(vector([0.6, 0.0, 0.8]));
        back.to_space(vector(in_space(turned)))
    };
    for n in 1..6 {
        let later = 1.1 + f64::from(n) * top.period();
        observed!((left(later) - left(1.1)).norm(), 6e-16..=6e-15); // observed 1.7e-15
        assert!(TAU * f64::from(n) > 6.0);
    }
}
