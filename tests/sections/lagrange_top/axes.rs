//! 7.1 and the first half of 7.2: what the top is, its axes, and what is conserved.

use super::*;
use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, TopState};

/// I₁ and I₃, and Mgl.
struct Body {
    transverse: f64,
    axial: f64,
    weight_moment: f64,
}

/// Tops and starts of every kind.
fn random_tops(count: usize) -> impl Iterator<Item = (Body, LagrangeTop)> {
    let mut numbers = Uniform(72);
    (0..count).map(move |_| {
        let transverse = 0.5 + numbers.next();
        let body = Body {
            transverse,
            axial: transverse * (0.05 + 1.9 * numbers.next()),
            weight_moment: 0.2 + 2.0 * numbers.next(),
        };
        let omega = numbers.vector() * 4.0;
        let attitude = numbers.attitude();
        let top = LagrangeTop::new(transverse, body.axial, body.weight_moment, omega, attitude);
        (body, top.unwrap())
    })
}

// claim: C7.1-1
#[test]
fn s7_1_lagranges_top() {
    let moments = AxisMoments::new(1.0, 1.0, AXIAL).unwrap();
    let lever = vector([0.0, 0.0, 1.0]);
    let top = HeavyTop::new(moments, lever).unwrap();
    // Released at rest it stays only where the axis is vertical; elsewhere gravity turns it by Mgl sin θ/I₁.
    let still = BodyVector::zero();
    for degrees in [0.0, 1e-3, 30.0, 90.0, 179.0_f64] {
        let attitude = tilted(degrees.to_radians());
        let up = attitude.to_body(UP);
        let torque = top.rate(&TopState { omega: still, up }).omega.norm();
        let sine = degrees.to_radians().sin();
        near!(torque, sine, 0.0..=3e-17);
        let state = at(&started([0.0; 3], attitude), 1e-3);
        within((state.omega.norm() - 1e-3 * sine).abs(), 4e-10 * sine);
        assert_eq!(state.omega.norm() == 0.0, degrees == 0.0);
    }
    let later = at(&started([0.0; 3], hanging()), 10.0);
    assert_eq!(later.omega, still);
    assert_eq!(later.attitude.angle_to(&hanging()), 0.0);
}

// claim: C7.2-1, C7.2-15
#[test]
fn s7_2_axes_that_follow_the_tilt_and_not_the_spin() {
    for (body, top) in random_tops(50) {
        for t in [0.3, 1.1] {
            let state = at(&top, t);
            let e3 = axis(&state);
            let (h, sine) = (state.height, (state.one_less * state.one_more).sqrt());
            // x₂ horizontal and square to x₃, x₁ completing: x₁ = x₂∧x₃ has +sin θ along the vertical.
            let e2 = [e3[1] / sine, -e3[0] / sine, 0.0];
            let e1 = cross(e2, e3);
            near!(e1[2], sine, 4e-16..=3e-15);
            near!(e3[2], h, 2e-16..=3e-15);
            // In these axes I is diag(I₁, I₁, I₃) all the same, and Ω₁ = φ' sin θ, Ω₂ = θ' up to its sign.
            let turning: [f64; 3] = state.attitude.to_space(state.omega).components().into();
            let along = |e: [f64; 3]| dot(e, turning);
            let (i1, i3) = (body.transverse, body.axial);
            let momentum = state.attitude.to_space(state.angular_momentum);
            let momentum: [f64; 3] = momentum.components().into();
            for k in 0..3 {
                let l = i1 * along(e1) * e1[k] + i1 * along(e2) * e2[k] + i3 * along(e3) * e3[k];
                observed!((l - momentum[k]).abs() / (1.0 + i1 + i3), 1e-15..=2e-14);
            }
            // Picture: L_vert = I₁Ω₁ sin θ + L₃ cos θ.
            let vertical = i1 * along(e1) * sine + i3 * along(e3) * h;
            near!(vertical, top.vertical_angular_momentum(), 2e-15..=2e-14);
            // φ' by differences of the azimuth: the axes turn with it.
            let [ahead, behind] = [1e-4, -1e-4].map(|step| azimuth(&at(&top, t + step)));
            let rate = wrapped(ahead - behind) / 2e-4;
            observed!((rate * sine - along(e1)).abs() * sine.powi(3), 1e-7..=2e-6);
        }
    }
}

// claim: C7.2-2
#[test]
fn s7_2_no_torque_about_the_axis_or_the_vertical() {
    // L' = Mgl ẑ∧e, by the library's states.
    for (body, top) in random_tops(20) {
        let l = |t: f64| {
            let state = at(&top, t);
            let [x, y, z]: [f64; 3] = state.omega.components().into();
            let l = vector([body.transverse * x, body.transverse * y, body.axial * z]);
            state.attitude.to_space(l).components().into()
        };
        let [across, along, up] = derivative(l, 0, 2_f64.powi(-5));
        let [x, y, _] = axis(&at(&top, 0.0));
        observed!((across + body.weight_moment * y).abs(), 2e-14..=4e-13);
        near!(along, body.weight_moment * x, 2e-14..=4e-13);
        observed!(up.abs(), 2e-14..=4e-13);
    }
}

// claim: C7.2-3, C7.2-4, C7.2-5
#[test]
fn s7_2_three_constants() {
    for (body, top) in random_tops(100) {
        let (i1, i3) = (body.transverse, body.axial);
        let (omega, (l3, _)) = (at(&top, 0.0).omega, spins(&top));
        let scale = 1.0 + i1 * omega.norm();
        within((l3 - i3 * omega.z()).abs(), 1e-15 * l3.abs());
        for t in [-7.3, 0.4, 20.0] {
            let state = at(&top, t);
            assert_eq!(state.omega.z(), omega.z());
            let (sine, h) = ((state.one_less * state.one_more).sqrt(), state.height);
            // φ' sin θ and θ' from Ω and the vertical in the body.
            let up = state.attitude.to_body(UP);
            let precessing = (state.omega.x() * up.x() + state.omega.y() * up.y()) / sine;
            let tilting = (state.omega.x() * up.y() - state.omega.y() * up.x()) / sine;
            let vertical = i1 * precessing * sine + l3 * h;
            let off = (vertical - top.vertical_angular_momentum()).abs() / scale;
            observed!(off, 2e-16..=2e-15);
            let kinetic = 0.5 * i1 * (tilting * tilting + precessing * precessing);
            let energy = kinetic + l3 * l3 / (2.0 * i3) + body.weight_moment * h;
            let off = (energy - top.energy()).abs() / (scale * scale);
            observed!(off, 5e-16..=5e-15);
        }
    }
}

// claim: C7.2-6
#[test]
fn s7_2_the_equation_for_h_is_exact() {
    let mut numbers = Uniform(726);
    for _ in 0..200 {
        let [i1, weight] = body(&mut numbers);
        let omega = [0; 3].map(|_| ration(&mut numbers));
        let z = unit_vector(&mut numbers);
        let (h, l3) = (z[2], ration(&mut numbers));
        // h' is the third component of z∧Ω (5.1); L_vert and E' = E − L₃²/2I₃ from their definitions.
        let rate = z[0] * omega[1] - z[1] * omega[0];
        let vertical = i1 * (omega[0] * z[0] + omega[1] * z[1]) + l3 * h;
        let energy = i1 * (omega[0] * omega[0] + omega[1] * omega[1]) / TWO + weight * h;
        let at = |h: R| cubic([i1, weight], energy, l3, vertical, h);
        assert_eq!(at(h), i1 * i1 * rate * rate);
        // A cubic: its third difference is 6 times the leading coefficient 2I₁Mgl.
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| at(whole(k)));
        let three = whole(3);
        assert_eq!(d - three * c + three * b - a, whole(12) * i1 * weight);
        // Without gravity a quadratic.
        let at = |k: i128| cubic([i1, ZERO], energy, l3, vertical, whole(k));
        assert_eq!(at(3) - three * (at(2) - at(1)) - at(0), ZERO);
    }
}

// claim: C7.2-7
#[test]
fn s7_2_the_top_moves_by_the_cubic_of_its_roots() {
    for (body, top) in random_tops(300) {
        let [h1, h2, h3] = roots(&top);
        let leading = 2.0 * body.transverse * body.weight_moment;
        for t in [0.0, 0.7, 3.0] {
            let state = at(&top, t);
            let z = state.attitude.to_body(UP);
            // h' = (z ∧ Ω)₃, from the state; the cubic from the roots.
            let slope = z.x() * state.omega.y() - z.y() * state.omega.x();
            let left = (body.transverse * slope).powi(2);
            let h = state.height;
            let right = leading * (h - h1) * (h2 - h) * (h3 - h);
            observed!((left - right).abs() / (leading * (h3 + 1.0)), 5e-16..=1e-14);
        }
    }
}

// claim: C7.2-8
#[test]
fn s7_2_order_of_the_roots() {
    for (body, top) in random_tops(300) {
        let [h1, h2, h3] = roots(&top);
        assert!([-1.0, h1, h2, 1.0, h3].is_sorted(), "{h1} {h2} {h3}");
        for t in [0.0, 0.7, 3.0] {
            let h = at(&top, t).height;
            assert!(h1 - 1e-15 <= h && h <= h2 + 1e-15, "{h1} {h} {h2}");
        }
        // f in factors is f: by its values at ±1 and at 0.
        let (l3, vertical) = spins(&top);
        let leading = 2.0 * body.transverse * body.weight_moment;
        let factors = |h: f64| leading * (h - h1) * (h - h2) * (h - h3);
        let size = leading * h3 + vertical * vertical + l3 * l3;
        let off = (factors(1.0) + (vertical - l3).powi(2)).abs() / size;
        observed!(off, 3e-16..=3e-15);
        let off = (factors(-1.0) + (vertical + l3).powi(2)).abs() / size;
        observed!(off, 2e-16..=2e-15);
    }
    // L_vert = L₃: the band reaches the pole. From upright with a kick.
    assert_eq!(roots(&kicked(1.5, 0.5))[1], 1.0);
    let below = started([0.5, 0.0, 3.0], hanging());
    assert_eq!(roots(&below)[0], -1.0);
}
