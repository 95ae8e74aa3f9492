//! Section 9: Pythagoras by rotation. The independent method is the pressure, integrated point by point.

use super::*;
use spinning_bodies::pythagoras::{
    GasBox, Orientation, opposite_side, polygon_torques, reversal_angle, tetrahedron_areas,
};

fn box_345() -> GasBox {
    GasBox::new([0.0, 0.0], [4.0, 0.0], [4.0, 3.0]).unwrap()
}

/// Torque about `hinge` of the pressure on one side, point by point.
fn by_quadrature(from: [f64; 2], to: [f64; 2], hinge: [f64; 2]) -> f64 {
    let edge = [to[0] - from[0], to[1] - from[1]];
    // Outward normal times length, for a boundary that runs anticlockwise.
    let normal = [edge[1], -edge[0]];
    let moments = unit_gauss().into_iter().map(|(s, weight)| {
        let arm = [0, 1].map(|k| from[k] + s * edge[k] - hinge[k]);
        weight * (arm[0] * normal[1] - arm[1] * normal[0])
    });
    moments.sum()
}

// claim: C9.1-1
#[test]
fn s9_1_lid_and_bottom() {
    // The pressure on the lid, summed over the midpoints of 100 × 100 cells of the triangle's square hull.
    let (height, cells) = (2.0, 100);
    let mut torque = SpaceVector::zero();
    for i in 0..cells {
        for j in 0..cells {
            let [x, y] = [i, j].map(|k| (f64::from(k) + 0.5) / 100.0);
            let (x, y) = (4.0 * x, 3.0 * y);
            if y / 3.0 < x / 4.0 {
                let upward = SpaceVector::new(0.0, 0.0, 4.0 * 3.0 / 1e4);
                torque += SpaceVector::new(x, y, height).cross(&upward);
            }
        }
    }
    // The lid strains at the hinge, sideways; it does not turn the box about it.
    assert_eq!(torque.z(), 0.0);
    assert!(torque.x() > 5.0 && torque.y() < -15.0, "{torque:?}");
}

// claim: C9.1-2
#[test]
fn s9_1_senses() {
    let torques = box_345().side_torques();
    assert_eq!([torques.ar, torques.rb, torques.ab], [-8.0, -4.5, 12.5]);
    assert_eq!(box_345().orientation(), Orientation::Anticlockwise);
    // The mirror image turns every sense round.
    let mirror = GasBox::new([0.0, 0.0], [4.0, 0.0], [4.0, -3.0]).unwrap();
    assert_eq!(mirror.orientation(), Orientation::Clockwise);
    let torques = mirror.side_torques();
    assert_eq!([torques.ar, torques.rb, torques.ab], [8.0, 4.5, -12.5]);
}

// claim: C9.1-3, C9.1-4, C9.1-5, C9.1-9
#[test]
fn s9_1_arms() {
    let (a, r, b) = ([1.0, -2.0], [1.0 + 4.0 * 0.6, -2.0 + 4.0 * 0.8], [1.0, 1.0]);
    let b = [r[0] + (b[0] - 1.0) - 3.0 * 0.8, r[1] + 3.0 * 0.6];
    let gas = GasBox::new(a, r, b).unwrap();
    let arms = gas.arms();
    // Half of each side. Corners rounded once; observed 3e-16.
    for (arm, half) in [(arms.ar, 2.0), (arms.rb, 1.5), (arms.ab, 2.5)] {
        close!(arm, half, 0.0..=1e-15);
    }
    // Torque over force, the torque by the pressure integrated along the side.
    for (from, to, arm, side) in [
        (a, r, arms.ar, 4.0),
        (r, b, arms.rb, 3.0),
        (b, a, arms.ab, 5.0),
    ] {
        let torque = by_quadrature(from, to, a);
        close!(torque.abs() / side, arm, 0.0..=1e-15);
    }
}

// claim: C9.1-7
#[test]
fn s9_1_no_torque_on_any_polygon() {
    // A heptagon with two dents; the hinge far outside.
    let heptagon = [
        [0.0, 0.0],
        [3.1, -0.7],
        [2.2, 1.4],
        [4.8, 2.9],
        [1.9, 2.3],
        [0.4, 5.6],
        [-1.3, 1.7],
    ];
    for hinge in [[-17.3, 42.9], [0.0, 0.0], [1.0, 1.0]] {
        let torques = polygon_torques(&heptagon, hinge).unwrap();
        let sum: f64 = torques.iter().sum();
        let size: f64 = torques.iter().map(|t| t.abs()).sum();
        assert!(sum.abs() < 2e-16 * size, "{sum:e} of {size}");
        for (k, torque) in torques.into_iter().enumerate() {
            let expected = by_quadrature(heptagon[k], heptagon[(k + 1) % 7], hinge);
            near!(torque, expected, 1e-15 * size);
        }
    }
    // In whole numbers the sum is zero to the bit.
    let square = [[0.0, 0.0], [6.0, 2.0], [4.0, 8.0], [-2.0, 4.0]];
    let torques = polygon_torques(&square, [100.0, 7.0]).unwrap();
    assert_eq!(torques.iter().sum::<f64>(), 0.0);
}

// claim: C9.1-8
#[test]
fn s9_1_pythagoras_for_a_tetrahedron() {
    let corner = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 6.0]];
    assert_eq!(tetrahedron_areas(corner).unwrap()[1], [-9.0, 0.0, 0.0]);
    // The forces balance for this and for any tetrahedron, whichever way its corners are numbered.
    let skew = [
        [0.3, -1.2, 0.7],
        [2.9, 0.4, -0.6],
        [-1.1, 2.5, 0.2],
        [0.8, 0.9, 3.4],
    ];
    for vertices in [corner, skew, [skew[1], skew[0], skew[2], skew[3]]] {
        let areas = tetrahedron_areas(vertices).unwrap();
        for k in 0..3 {
            observed!(areas.iter().map(|a| a[k]).sum::<f64>().abs(), 4e-16..=2e-15);
        }
        // Outward: each points away from the vertex opposite.
        for (j, area) in areas.iter().enumerate() {
            let on_face = vertices[(j + 1) % 4];
            let height = [0, 1, 2].map(|k| on_face[k] - vertices[j][k]);
            assert!(dot(*area, height) > 0.0);
        }
    }
    // Which side is out does not depend on the unit.
    let areas = |unit: f64| {
        let corners = [
            [0.0, 0.0, 0.0],
            [1.0, 0.1, 0.0],
            [0.0, 1.0, 0.2],
            [0.3, 0.0, 1.0],
        ];
        tetrahedron_areas(corners.map(|corner| corner.map(|x| x * unit))).unwrap()
    };
    for unit in [2f64.powi(400), 2f64.powi(-400)] {
        let larger = areas(1.0).map(|face| face.map(|x| x * unit * unit));
        assert_eq!(areas(unit), larger);
    }
}

// claim: C9.2-1
#[test]
fn s9_2_cosine_law() {
    let gamma: f64 = 2.0;
    let ab = opposite_side(4.0, 3.0, gamma).unwrap();
    close!(ab * ab, 34.987_524_077_131_42, 0.0..=4.5e-16);
    for gamma in [0.3, 1.0, 1.5, 2.0, 3.0] {
        let gas = GasBox::from_sides(4.0, 3.0, gamma).unwrap();
        let torques = gas.side_torques();
        // Torque of F_RB is (RB/2 − AR cos γ) times RB; the balance is the law.
        let arm = 1.5 - 4.0 * gamma.cos();
        near!(gas.arms().rb, arm, 2e-15);
        near!(torques.rb, -3.0 * arm, 4e-15);
        assert!((torques.ar + torques.rb + torques.ab).abs() < 4e-15);
        let law = 16.0 + 9.0 - 24.0 * gamma.cos();
        close!(2.0 * torques.ab, law, 0.0..=2e-15);
        close!(gas.right_angle_defect(), 24.0 * gamma.cos(), 3e-16..=1e-14);
        close!(gas.angle_at_r(), gamma, 0.0..=1e-15);
        let [_, _, side] = gas.sides();
        close!(opposite_side(4.0, 3.0, gamma).unwrap(), side, 0.0..=1e-15);
    }
    // Flat triangles: the sum and the difference of the sides.
    close!(opposite_side(4.0, 3.0, PI).unwrap(), 7.0, 0.0..=2.3e-16);
    assert_eq!(opposite_side(4.0, 3.0, 0.0), Ok(1.0));
}

// claim: C9.2-2
#[test]
fn s9_2_change_of_sense() {
    let gas = |gamma| GasBox::from_sides(4.0, 3.0, gamma).unwrap();
    let torque = |gamma| gas(gamma).side_torques().rb;
    close!(torque(0.5), 12.0 * 0.5_f64.cos() - 4.5, 0.0..=2e-15);
    assert!((torque(0.5) - 6.03).abs() < 1e-2 && torque(FRAC_PI_2) < 0.0);
    let flip = reversal_angle(4.0, 3.0).unwrap().unwrap();
    close!(flip, 1.186_399_552_299_257_5, 0.0..=2.3e-16);
    assert!(torque(flip - 1e-9) > 0.0 && torque(flip + 1e-9) < 0.0);
    // A long RB never changes its sense.
    assert_eq!(reversal_angle(1.0, 2.1), Ok(None));
    assert_eq!(reversal_angle(1.0, 2.0), Ok(Some(0.0)));
    // One unit shorter than twice AR, RB = 2AR(1 − δ): 1 − cos γ = δ, at any size.
    let delta = f64::exp2(-50.0) / 6.0;
    for unit in [0.0, -1000.0, 1020.0].map(|exponent| 3.0 * f64::exp2(exponent)) {
        let flip = reversal_angle(unit, (2.0 * unit).next_down()).unwrap();
        let expected = 2.0 * (0.5 * delta).sqrt().asin();
        close!(flip.unwrap(), expected, 0.0..=5e-16);
    }
    let least = reversal_angle(5e-324, 5e-324).unwrap().unwrap();
    close!(least, FRAC_PI_3, 0.0..=3e-16);
}

// claim: C9.2-1, C9.1-6
#[test]
fn s9_2_needles() {
    // AR²+RB²−AB² of a needle, in exact fractions of its very corners, against the difference of squares in doubles.
    let (a, r, b) = (
        [0.1, 0.7],
        [1e8 + 0.3, 12_345.678],
        [1e8 + 0.3 - 1e-4, 12_345.678 + 0.7],
    );
    let exact = |x: f64| {
        Ratio::<i128>::new((x * 2f64.powi(60 - 27)) as i128, 1) / Ratio::new(1i128 << 33, 1)
    };
    // The corners as multiples of 2⁻³³: rounded to that grid first, so that the fractions are the doubles.
    let grid = |p: [f64; 2]| p.map(|x| (x * 2f64.powi(24)).round() / 2f64.powi(24));
    let (a, r, b) = (grid(a), grid(r), grid(b));
    let square = |p: [f64; 2], s: [f64; 2]| {
        let d = [exact(s[0]) - exact(p[0]), exact(s[1]) - exact(p[1])];
        d[0] * d[0] + d[1] * d[1]
    };
    let defect = square(a, r) + square(r, b) - square(a, b);
    let expected = *defect.numer() as f64 / *defect.denom() as f64;
    let gas = GasBox::new(a, r, b).unwrap();
    close!(gas.right_angle_defect(), expected, 0.0..=2.3e-16);
    let [ar, rb, ab] = gas.sides();
    let naive = ar * ar + rb * rb - ab * ab;
    assert!(relative(naive, expected) > 1e-6);
    // Far thinner than two words tell, and so great that squares overflow where the torque does not.
    for [size, thin] in [[1.0, 1e-40], [2f64.powi(600), 1e-100]] {
        let gas = GasBox::new([0.0, 0.0], [size, 0.0], [size, thin]).unwrap();
        assert_eq!(gas.side_torques().rb, -0.5 * (thin * thin));
        assert_eq!(gas.angle_at_r(), std::f64::consts::FRAC_PI_2);
    }
}

#[test]
fn pythagoras_refuses_what_is_no_triangle() {
    let line = GasBox::new([0.0, 0.0], [1.0, 1.0], [3.0, 3.0]);
    refused!(line, Condition);
    refused!(GasBox::new([0.0; 2], [0.0; 2], [0.0; 2]), Condition);
    let none = GasBox::new([f64::NAN, 0.0], [1.0, 1.0], [3.0, 2.0]);
    refused!(none, NotFinite);
    refused!(GasBox::from_sides(1.0, 1.0, 4.0), OutOfRange);
    refused!(polygon_torques(&[[0.0; 2]; 2], [0.0; 2]), Condition);
    refused!(tetrahedron_areas([[1.0; 3]; 4]), Condition);
    refused!(opposite_side(-1.0, 1.0, 1.0), NotPositive);
}

proptest! {
    #[test]
    fn pythagoras_never_panics(a in any::<[f64; 2]>(), r in any::<[f64; 2]>(), b in any::<[f64; 2]>(), v in any::<[[f64; 3]; 4]>()) {
        if let Ok(gas) = GasBox::new(a, r, b) {
            let _ = (gas.side_torques(), gas.arms(), gas.right_angle_defect(), gas.angle_at_r(), gas.sides());
        }
        let _ = (GasBox::from_sides(a[0], a[1], b[0]), opposite_side(a[0], a[1], b[0]), reversal_angle(a[0], a[1]));
        let _ = (polygon_torques(&[a, r, b], v[0][..2].try_into().unwrap()), tetrahedron_areas(v));
    }

    #[test]
    fn pythagoras_balances_for_every_triangle_at_every_scale(
        r in prop::array::uniform2(-9.0..9.0f64), b in prop::array::uniform2(-9.0..9.0f64), power in -400i32..400,
    ) {
        let gas = GasBox::new([0.0, 0.0], r, b);
        prop_assume!(gas.is_ok());
        let gas = gas.unwrap();
        let t = gas.side_torques();
        let size = t.ar.abs() + t.rb.abs() + t.ab.abs();
        // Three torques, each rounded once.
        prop_assert!((t.ar + t.rb + t.ab).abs() <= 2.3e-16 * size);
        let [ar, rb, _] = gas.sides();
        let cosine = 2.0 * ar * rb * gas.angle_at_r().cos();
        prop_assert!((gas.right_angle_defect() - cosine).abs() < 3e-15 * ar * rb);
        let scale = 2f64.powi(power);
        let scaled = GasBox::new([0.0, 0.0], r.map(|x| x * scale), b.map(|x| x * scale)).unwrap();
        prop_assert_eq!(scaled.angle_at_r(), gas.angle_at_r());
        prop_assert_eq!(scaled.right_angle_defect(), gas.right_angle_defect() * scale * scale);
    }
}
