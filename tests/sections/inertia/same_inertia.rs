//! 2.5: different bodies, one inertia.

use super::*;

/// Six masses on the axes and eight at the corners of a box, both with moments 2, 3, 4 (2.5).
fn six_and_eight() -> [Vec<(f64, [f64; 3])>; 2] {
    let s = [2.5_f64, 1.5, 0.5];
    let mut six = Vec::new();
    for k in 0..3 {
        for sign in [-1.0, 1.0] {
            let mut x = [0.0; 3];
            x[k] = sign * (3.0 * s[k]).sqrt();
            six.push((1.0 / 6.0, x));
        }
    }
    let corner = |n: usize| {
        let sign = |k: usize| if n >> k & 1 == 0 { 1.0 } else { -1.0 };
        (0.125, [0, 1, 2].map(|k| sign(k) * s[k].sqrt()))
    };
    [six, (0..8).map(corner).collect()]
}

#[test]
fn s2_5_different_bodies_same_inertia() -> Result<()> {
    // claim: C2.5-1
    let [six, eight] = six_and_eight();
    for list in [six, eight] {
        let body = particles(&list)?;
        assert_inertia(&body, [2.0, 3.0, 4.0, 0.0, 0.0, 0.0]);
        assert!(body.center().norm() <= 2.0 * EPS);
    }
    let radius = 1.7;
    let ball = shapes::ball(1.0, radius)?.inertia().matrix();
    let shell = shapes::spherical_shell(1.0, radius * 0.6_f64.sqrt())?.inertia();
    close!(ball, shell.matrix(), 4.0 * EPS);
    Ok(())
}

#[test]
fn s2_5_only_the_ellipsoid_is_seen() -> Result<()> {
    // claim: C2.5-2
    let [six, eight] = six_and_eight();
    type Masses = Vec<(f64, [f64; 3])>;
    let torque = |list: &Masses, field: &dyn Fn(BodyVector) -> BodyVector| -> BodyVector {
        let places = list.iter().map(|(m, x)| (*m, vector(*x)));
        places.map(|(m, x)| m * x.cross(&field(x))).sum()
    };
    // Any linear field: equal torques, and the torque that the inertia matrix alone predicts.
    let mut uniform = Uniform(52);
    let inertia = InertiaMatrix::diagonal(2.0, 3.0, 4.0)?;
    for _ in 0..200 {
        let a = Matrix3::from_fn(|_, _| uniform.signed());
        let linear = |x: BodyVector| BodyVector::from_components(a * x.components());
        let predicted = inertia.torque_in_linear_field(&a);
        for list in [&six, &eight] {
            assert!((torque(list, &linear) - predicted).norm() <= 16.0 * EPS * 2.5);
        }
    }
    // The condition: in the cubic field f = −x³ẑ, at a tilt of 0.4 about y, they part.
    let tilt = Attitude::about_axis(vector([0.0, 1.0, 0.0]), 0.4)?;
    let cubic = |list: &Masses| -> f64 {
        let places = list.iter().map(|(m, x)| (m, tilt.to_space(vector(*x)).x()));
        // N_y = z f_x − x f_z with f = (0, 0, −x³).
        places.map(|(m, x)| m * x * x.powi(3)).sum()
    };
    close!(cubic(&six), 13.511_686_548_515_098, 8.0 * EPS);
    close!(cubic(&eight), 5.468_770_068_329_157, 8.0 * EPS);
    Ok(())
}
