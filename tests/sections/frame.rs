//! Body and space axes: which way the attitude turns, and both directions of the transport theorem (tutorial 2.2, 5.1).

use super::*;
use spinning_bodies::frame::{EulerAngles, rate_seen_from_body, rate_seen_from_space};
use support::any;

/// A known motion: precession α(t) about z, tilt β(t) about x, spin γ(t) about z, angles and their rates given.
struct Known {
    angles: [f64; 3],
    rates: [f64; 3],
}

impl Known {
    fn at(t: f64) -> Self {
        Self {
            angles: [
                0.3 + 1.1 * t - 0.4 * t * t,
                0.7 + 0.5 * t.sin(),
                2.0 * t + 0.2 * (3.0 * t).cos(),
            ],
            rates: [1.1 - 0.8 * t, 0.5 * t.cos(), 2.0 - 0.6 * (3.0 * t).sin()],
        }
    }

    /// The rotation matrix written out, body to space: no quaternion, no library.
    fn matrix(&self) -> Matrix3<f64> {
        let about_z =
            |a: f64| Matrix3::new(a.cos(), -a.sin(), 0.0, a.sin(), a.cos(), 0.0, 0.0, 0.0, 1.0);
        let about_x =
            |a: f64| Matrix3::new(1.0, 0.0, 0.0, 0.0, a.cos(), -a.sin(), 0.0, a.sin(), a.cos());
        about_z(self.angles[0]) * about_x(self.angles[1]) * about_z(self.angles[2])
    }

    /// Ω in space: each rate along the axis that its rotation has by then.
    fn omega(&self) -> SpaceVector {
        let [a, b, _] = self.angles;
        let node = Vector3::new(a.cos(), a.sin(), 0.0);
        let figure = Vector3::new(a.sin() * b.sin(), -a.cos() * b.sin(), b.cos());
        SpaceVector::from_components(
            self.rates[0] * Vector3::z() + self.rates[1] * node + self.rates[2] * figure,
        )
    }

    /// The same attitude by the library, composed of three turns.
    fn attitude(&self) -> Attitude {
        let turn =
            |axis: BodyVector, angle| Attitude::about_axis(axis, angle).unwrap().quaternion();
        let [x, z] = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(vector);
        let [a, b, c] = self.angles;
        let q = turn(z, a) * turn(x, b) * turn(z, c);
        Attitude::from_quaternion(q.w, q.i, q.j, q.k).unwrap()
    }
}

/// The derivative at [`T`].
fn derivative(f: impl Fn(f64) -> Vector3<f64>) -> Vector3<f64> {
    support::derivative(|t| f(t).into(), 70, T / 70.0).into()
}

/// Some vector that moves relative to the body: its body components at time t and their rates.
fn moving(t: f64) -> (BodyVector, BodyVector) {
    let place = vector([(2.0 * t).sin(), 1.0 + t * t, (-t).exp()]);
    let rate = vector([2.0 * (2.0 * t).cos(), 2.0 * t, -(-t).exp()]);
    (place, rate)
}

const T: f64 = 0.7;

#[test]
fn an_attitude_turns_body_axes_into_space_axes() {
    // The quaternion of a quarter turn about z is (cos 45°, 0, 0, sin 45°), scalar first, whatever its length and sign.
    let z = vector([0.0, 0.0, 1.0]);
    let quarter = Attitude::about_axis(z, FRAC_PI_2).unwrap();
    for scale in [1.0, -1.0, 1e-300, 1e300] {
        let half = scale * FRAC_1_SQRT_2;
        let same = Attitude::from_quaternion(half, 0.0, 0.0, half).unwrap();
        assert!(same.angle_to(&quarter) < 3e-16, "{scale}");
    }
    let q = quarter.quaternion();
    close!(q.w, FRAC_1_SQRT_2, 2e-16);
    close!(q.k, FRAC_1_SQRT_2, 2e-16);
    // The three turns of the known motion give the matrix written out.
    let known = Known::at(T);
    let matrix = known.matrix();
    for (i, column) in matrix.column_iter().enumerate() {
        let mut e = Vector3::zeros();
        e[i] = 1.0;
        let image = known.attitude().to_space(BodyVector::from_components(e));
        assert!((image.components() - column).norm() < 5e-16);
    }
}

#[test]
fn angles_between_attitudes_keep_their_digits() {
    let z = vector([0.0, 0.0, 1.0]);
    let attitude = |angle| Attitude::about_axis(z, angle).unwrap();
    for angle in [1e-200, 1e-15, 1e-9, 1e-3, 1.0, 3.0] {
        let measured = Attitude::identity().angle_to(&attitude(angle));
        close!(measured, angle, 4e-16);
    }
    // A full turn is no turn; more than half a turn is the rest the other way.
    assert!(Attitude::identity().angle_to(&attitude(2.0 * PI)) < 3e-16);
    let angle = Attitude::identity().angle_to(&attitude(4.0));
    close!(angle, 2.0 * PI - 4.0, 4e-16);
}

// claim: C5.1-1
#[test]
fn s5_1_basis_vectors_turn_with_the_body() {
    let known = Known::at(T);
    for i in 0..3 {
        let column = |t: f64| -> Vector3<f64> { Known::at(t).matrix().column(i).into() };
        let e = SpaceVector::from_components(column(T));
        let rate = derivative(column);
        let difference = rate - known.omega().cross(&e).components();

        observed!(difference.norm(), 1e-14..=3e-13);
    }
}

// claim: C5.1-2
#[test]
fn s5_1_transport_theorem_towards_space() {
    // dA/dt differentiated in space, brought back to body axes, against ∂A/∂t + Ω∧A computed in the body.
    let (vector, rate) = moving(T);
    let known = Known::at(T);
    let attitude = known.attitude();
    let in_space = derivative(|t| Known::at(t).matrix() * moving(t).0.components());
    let seen = rate_seen_from_space(rate, attitude.to_body(known.omega()), vector);
    let difference = attitude.to_space(seen).components() - in_space;
    observed!(difference.norm(), 1e-14..=3e-13, "{difference:?}");
    // Leaving out Ω∧A, or taking it with the wrong sign, is wrong by far.
    let naive = attitude.to_space(rate).components() - in_space;
    assert!(naive.norm() > 1.0);
}

// claim: C5.1-2
#[test]
fn s5_1_transport_theorem_towards_the_body() {
    // A vector given in space; ∂A/∂t differentiated in body axes, taken back to space, against dA/dt − Ω∧A.
    let in_space = |t: f64| Vector3::new(1.0 + t, (3.0 * t).cos(), t * t * t);
    let rate = SpaceVector::new(1.0, -3.0 * (3.0 * T).sin(), 3.0 * T * T);
    let known = Known::at(T);
    let in_body = derivative(|t| Known::at(t).matrix().transpose() * in_space(t));
    let expected = BodyVector::from_components(in_body);
    let expected = known.attitude().to_space(expected);
    let vector = SpaceVector::from_components(in_space(T));
    let seen = rate_seen_from_body(rate, known.omega(), vector);
    observed!((seen - expected).norm(), 1e-14..=3e-13);
    assert!((rate - expected).norm() > 1.0);
    // A vector at rest in space seems to turn backwards.
    let still = rate_seen_from_body(SpaceVector::zero(), known.omega(), vector);
    assert_eq!(still, -known.omega().cross(&vector));
}

// claim: C5.1-3
#[test]
fn s5_1_no_difference_for_omega_itself() {
    let in_space = |t: f64| Known::at(t).omega().components();
    let in_body = |t: f64| Known::at(t).matrix().transpose() * in_space(t);
    let (space, body) = (derivative(in_space), derivative(in_body));
    let attitude = Known::at(T).attitude();
    let body = attitude.to_space(BodyVector::from_components(body));
    let body = body.components();
    observed!((space - body).norm(), 1e-14..=3e-13);
    assert!(space.norm() > 1.0);
    let omega = attitude.to_body(Known::at(T).omega());
    assert_eq!(rate_seen_from_space(omega, omega, omega), omega);
}

#[test]
fn what_is_refused() {
    refused!(Attitude::from_quaternion(0.0, 0.0, 0.0, 0.0), ZeroVector);
    let none = Attitude::from_quaternion(f64::NAN, 0.0, 0.0, 1.0);
    refused!(none, NotFinite);
    refused!(Attitude::about_axis(BodyVector::zero(), 1.0), ZeroVector);
    let z = vector([0.0, 0.0, 1.0]);
    refused!(Attitude::about_axis(z, f64::INFINITY), NotFinite);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn there_and_back_again(q in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0, 0.1..1.0], a in [-5.0..5.0_f64, -5.0..5.0, -5.0..5.0]) {
        let attitude = Attitude::from_quaternion(q[3], q[0], q[1], q[2]).unwrap();
        let vector = vector([a[0], a[1], a[2]]);
        let space = attitude.to_space(vector);
        prop_assert!((attitude.to_body(space) - vector).norm() < 2e-15 * vector.norm() + 1e-300);
        prop_assert!((space.norm() - vector.norm()).abs() < 1e-15 * vector.norm() + 1e-300);
        // The two transport theorems undo each other.
        let omega = BodyVector::new(q[0], q[1], q[2]);
        let there = rate_seen_from_space(vector, omega, vector);
        let back = rate_seen_from_body(attitude.to_space(there), attitude.to_space(omega), space);
        prop_assert!((attitude.to_body(back) - vector).norm() < 3e-14);
    }

    #[test]
    fn nothing_panics(n in prop::collection::vec(any(), 4)) {
        if let Ok(attitude) = Attitude::from_quaternion(n[0], n[1], n[2], n[3]) {
            prop_assert!((attitude.quaternion().norm() - 1.0).abs() < 1e-15);
        }
        let vector = vector([n[0], n[1], n[2]]);
        let _ = Attitude::about_axis(vector, n[3]);
        if let Ok(unit) = vector.direction("a vector") {
            prop_assert!((unit.norm() - 1.0).abs() < 1e-15);
        }
        let _ = vector.norm();
    }
}

/// Euler's angles make the attitude that has them, and attitudes compose as turns do.
#[test]
fn attitudes_compose_and_have_eulers_angles() {
    let axis =
        |k: usize| BodyVector::from_components(nalgebra::Matrix3::identity().column(k).into());
    let turn = |k: usize, angle: f64| Attitude::about_axis(axis(k), angle).unwrap();
    let composed = |[phi, theta, psi]: [f64; 3]| turn(2, phi) * turn(0, theta) * turn(2, psi);
    let made = |theta, phi, psi| Attitude::from_euler_angles(EulerAngles { theta, phi, psi });
    for (theta, phi, psi) in [(0.3, 1.0, -2.0), (2.9, -3.0, 0.5), (1e-9, 0.4, 0.2)] {
        let made = made(theta, phi, psi).unwrap();
        assert!(made.angle_to(&composed([phi, theta, psi])) < 4e-16);
        let back = made.euler_angles();
        assert!((back.theta / theta - 1.0).abs() < 1e-15, "{back:?}");
        near!(back.phi, phi, 1e-15);
        near!(back.psi, psi, 1e-15);
        assert!((made * made.inverse()).angle_to(&Attitude::identity()) < 1e-15);
    }
    // At the pole the difference of φ and ψ counts as zero, whatever signs the zeros of the quaternion have.
    let spun = turn(2, -0.5).euler_angles();
    assert_eq!((spun.phi, spun.psi), (-0.25, -0.25));
    // Any attitude is that of its angles, next to the poles and on them too, and after many turns.
    let mut numbers = Uniform(71);
    for theta in [0.0, 1e-160, 1e-9, 0.7, 3.0, PI] {
        for _ in 0..80 {
            let [phi, psi] = [7.0, 7e15].map(|most| most * numbers.signed());
            let attitude = composed([phi, theta, psi]);
            let wound = made(theta, phi, psi).unwrap();
            assert!(wound.angle_to(&attitude) < 1e-15, "{theta} {phi} {psi}");
            let EulerAngles { theta, phi, psi } = attitude.euler_angles();
            let again = composed([phi, theta, psi]);
            observed!(attitude.angle_to(&again), 5e-16..=2e-15, "{theta}");
        }
    }
    let half = nalgebra::Quaternion::new(0.5, 0.5, 0.5, 0.5);
    let untouched = nalgebra::UnitQuaternion::new_unchecked(half);
    let again = nalgebra::UnitQuaternion::from(Attitude::from(untouched));
    assert_eq!(again, untouched);
    refused!(made(f64::NAN, 0.0, 0.0), NotFinite);
}
