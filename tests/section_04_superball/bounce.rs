//! One bounce: the balances, the two solutions, the matrices.

use spinning_bodies::superball::{Motion, Surface, bounce, bounce_matrix, friction_impulse};

use crate::common::{Q, determinant, exact, kappas, q, thrown, times};

fn apply(a: [[Q; 2]; 2], m: Motion<Q>) -> Motion<Q> {
    exact(
        a[0][0] * m.velocity + a[0][1] * m.rim_speed,
        a[1][0] * m.velocity + a[1][1] * m.rim_speed,
    )
}

const IDENTITY: fn() -> [[Q; 2]; 2] = || [[q(1, 1), q(0, 1)], [q(0, 1), q(1, 1)]];

// claim: C4.6-1, C4.6-3
#[test]
fn s4_6_balances_and_reversed_contact_speed() {
    for kappa in kappas() {
        for before in [
            exact(q(1, 1), q(3, 10)),
            exact(q(-7, 3), q(5, 2)),
            exact(q(2, 1), q(2, 1)),
        ] {
            for (surface, sign) in [(Surface::Floor, q(1, 1)), (Surface::Ceiling, q(-1, 1))] {
                let after = bounce(before, surface, kappa);
                // Per mass: V' − V = F, κ(RΩ' − RΩ) = ∓F; the ceiling has the other sign, R → −R.
                let impulse = friction_impulse(before, surface, kappa);
                assert_eq!(after.velocity - before.velocity, impulse);
                assert_eq!(
                    kappa * (after.rim_speed - before.rim_speed),
                    -sign * impulse
                );
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
    for kappa in kappas().into_iter().filter(|kappa| *kappa != q(0, 1)) {
        let before = exact(q(1, 1), q(3, 10));
        let gain = |f: Q| {
            exact(before.velocity + f, before.rim_speed - f / kappa).energy(kappa)
                - before.energy(kappa)
        };
        let quadratic = (gain(q(1, 1)) + gain(q(-1, 1))) / q(2, 1);
        let linear = (gain(q(1, 1)) - gain(q(-1, 1))) / q(2, 1);
        assert_eq!(gain(q(0, 1)), q(0, 1));
        assert_ne!(quadratic, q(0, 1));
        let other = -linear / quadratic;
        assert_eq!(gain(other), q(0, 1));
        assert_eq!(other, friction_impulse(before, Surface::Floor, kappa));
        // A ball that already rolls has only one solution.
        let rolling = exact(q(5, 7), q(5, 7));
        assert_eq!(bounce(rolling, Surface::Floor, kappa), rolling);
    }
}

// claim: C4.6-4, C4.6-5
#[test]
fn s4_6_matrices_of_floor_and_ceiling() {
    let sevenths = |m: [[i128; 2]; 2]| m.map(|row| row.map(|n| q(n, 7)));
    assert_eq!(
        bounce_matrix(Surface::Floor, q(2, 5)),
        sevenths([[3, 4], [10, -3]])
    );
    assert_eq!(
        bounce_matrix(Surface::Ceiling, q(2, 5)),
        sevenths([[3, -4], [-10, -3]])
    );
    let spun = exact(q(1, 1), q(3, 10));
    assert_eq!(
        bounce(spun, Surface::Floor, q(2, 5)),
        exact(q(3, 5), q(13, 10))
    );
    assert_eq!(
        bounce(spun, Surface::Ceiling, q(2, 5)),
        exact(q(9, 35), q(-109, 70))
    );
    for kappa in kappas() {
        for surface in [Surface::Floor, Surface::Ceiling] {
            assert_eq!(
                apply(bounce_matrix(surface, kappa), spun),
                bounce(spun, surface, kappa)
            );
        }
    }
    // All mass at the centre: spin has no say. All mass on the rim: velocity and rim speed swap.
    assert_eq!(
        bounce(spun, Surface::Floor, q(0, 1)).velocity,
        spun.velocity
    );
    assert_eq!(
        bounce(spun, Surface::Floor, q(1, 1)),
        exact(spun.rim_speed, spun.velocity)
    );
}

// claim: C4.6-6
#[test]
fn s4_6_reflections() {
    for kappa in kappas() {
        for surface in [Surface::Floor, Surface::Ceiling] {
            let m = bounce_matrix(surface, kappa);
            assert_eq!(determinant(m), q(-1, 1));
            assert_eq!(times(m, m), IDENTITY());
            // Trace 0 with determinant −1: eigenvalues +1 and −1.
            assert_eq!(m[0][0] + m[1][1], q(0, 1));
        }
    }
}

// claim: C4.6-8
#[test]
fn s4_6_energy_is_kept_exactly() {
    // The squares of 22 bounces are the last that fit into 127 bits.
    for motion in thrown().take(21) {
        assert_eq!(motion.energy(q(2, 5)), q(1, 1));
    }
}
