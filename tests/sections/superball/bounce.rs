//! One bounce: the balances, the two solutions, the matrices.

use super::*;

/// −2κu/(1+κ): what friction gives, per mass.
fn rubbed(before: Motion<R>, surface: Surface, kappa: R) -> R {
    -TWO * before.contact_speed(surface) * kappa / (ONE + kappa)
}

fn apply(a: [[R; 2]; 2], m: Motion<R>) -> Motion<R> {
    moving(
        a[0][0] * m.velocity + a[0][1] * m.rim_speed,
        a[1][0] * m.velocity + a[1][1] * m.rim_speed,
    )
}

const IDENTITY: [[R; 2]; 2] = [[ONE, ZERO], [ZERO, ONE]];

// claim: C4.6-1, C4.6-3
#[test]
fn s4_6_balances_and_reversed_contact_speed() {
    for kappa in kappas() {
        for before in [
            moving(ONE, rational(3, 10)),
            moving(rational(-7, 3), rational(5, 2)),
            moving(TWO, TWO),
        ] {
            for (surface, sign) in [(Surface::Floor, ONE), (Surface::Ceiling, whole(-1))] {
                let after = bounce(before, surface, kappa);
                // Per mass: V' − V = F, κ(RΩ' − RΩ) = ∓F; the ceiling has the other sign, R → −R.
                let impulse = rubbed(before, surface, kappa);
                assert_eq!(after.velocity - before.velocity, impulse);
                let spun = kappa * (after.rim_speed - before.rim_speed);
                assert_eq!(spun, -sign * impulse);
                assert_eq!(after.energy(kappa), before.energy(kappa));
                assert_eq!(after.contact_speed(surface), -before.contact_speed(surface));
            }
        }
    }
}

// claim: C4.6-2
#[test]
fn s4_6_exactly_two_solutions() {
    // Along the line of the two momentum balances, V' = V + f and RΩ' = RΩ − f/κ, the energy is a quadratic in f without a
    // constant term: f² (1 + 1/κ) + 2 f (V − RΩ) = 0. Three points fix it; its roots are the dull one and the superball's.
    for kappa in kappas().into_iter().filter(|kappa| *kappa != ZERO) {
        let before = moving(ONE, rational(3, 10));
        let after = |f: R| moving(before.velocity + f, before.rim_speed - f / kappa);
        let gain = |f: R| after(f).energy(kappa) - before.energy(kappa);
        let quadratic = (gain(ONE) + gain(whole(-1))) / TWO;
        let linear = (gain(ONE) - gain(whole(-1))) / TWO;
        assert_eq!(gain(ZERO), ZERO);
        assert_ne!(quadratic, ZERO);
        let other = -linear / quadratic;
        assert_eq!(gain(other), ZERO);
        assert_eq!(other, rubbed(before, Surface::Floor, kappa));
        // A ball that already rolls has only one solution.
        let rolling = moving(rational(5, 7), rational(5, 7));
        assert_eq!(bounce(rolling, Surface::Floor, kappa), rolling);
    }
}

// claim: C4.6-4, C4.6-5
#[test]
fn s4_6_matrices_of_floor_and_ceiling() {
    let sevenths = |m: [[i128; 2]; 2]| m.map(|row| row.map(|n| rational(n, 7)));
    let spun = moving(ONE, rational(3, 10));
    let floor = ([[3, 4], [10, -3]], moving(rational(3, 5), rational(13, 10)));
    let under = moving(rational(9, 35), rational(-109, 70));
    let ceiling = ([[3, -4], [-10, -3]], under);
    for (surface, (matrix, after)) in [(Surface::Floor, floor), (Surface::Ceiling, ceiling)] {
        assert_eq!(bounce_matrix(surface, KAPPA), sevenths(matrix));
        assert_eq!(bounce(spun, surface, KAPPA), after);
    }
    for kappa in kappas() {
        for surface in [Surface::Floor, Surface::Ceiling] {
            let after = apply(bounce_matrix(surface, kappa), spun);
            assert_eq!(after, bounce(spun, surface, kappa));
        }
    }
    // All mass at the centre: spin has no say. All mass on the rim: velocity and rim speed swap.
    let floor = |kappa| bounce(spun, Surface::Floor, kappa);
    assert_eq!(floor(ZERO).velocity, spun.velocity);
    assert_eq!(floor(ONE), moving(spun.rim_speed, spun.velocity));
}

// claim: C4.6-6
#[test]
fn s4_6_reflections() {
    for kappa in kappas() {
        for surface in [Surface::Floor, Surface::Ceiling] {
            let m = bounce_matrix(surface, kappa);
            assert_eq!(determinant(m), whole(-1));
            assert_eq!(times(m, m), IDENTITY);
            // Trace 0 with determinant −1: eigenvalues +1 and −1.
            assert_eq!(m[0][0] + m[1][1], ZERO);
        }
    }
}
