//! 2.6: box, cylinder, equilateral lamina.

use super::*;

#[test]
fn s2_6_box() -> Result<()> {
    // claim: C2.6-1
    let edges = [4.0, 6.0, 10.0];
    let body = shapes::cuboid(2.0, edges)?;
    let entries = cubature([gauss(), gauss(), gauss()], |[a, b, c]| {
        ([2.0 * a, 3.0 * b, 5.0 * c], 1.0)
    });
    assert_inertia(&body, entries);
    assert_eq!(body.inertia().matrix()[(0, 1)], 0.0);
    // The same box as a mesh, in axes that do not suit it: the principal axes find its edges.
    let turn = Uniform(61).attitude();
    let cube = PlatonicSolid::Cube;
    let stretched = |v: &[f64; 3]| vector([0, 1, 2].map(|i| v[i] * edges[i]));
    let mut vertices = cube.vertices(1.0)?;
    for v in &mut vertices {
        *v = turn.to_space(stretched(v)).components().into();
    }
    let tilted = mesh_mass_properties(&vertices, &cube.triangles(), 2.0 / 240.0)?;
    let principal = tilted.inertia().principal_axes();
    for (column, k) in [(0, 2), (1, 1), (2, 0)] {
        let mut edge = [0.0; 3];
        edge[k] = 1.0;
        let edge = turn.to_space(vector(edge)).components();
        let sine = principal.axes.column(column).cross(&edge).norm();
        observed!(sine, 2e-16..=1e-14);
    }
    Ok(())
}

#[test]
fn s2_6_cylinder() -> Result<()> {
    // claim: C2.6-2
    let (radius, height) = (1.5, 2.0);
    let body = shapes::cylinder(3.0, radius, height)?;
    let across = rational(3 * 9, 4) + whole(4);
    let across = exact(across / 12);
    assert_inertia(&body, [across, across, 1.125, 0.0, 0.0, 0.0]);
    let over_ellipse = |[a, b]: [f64; 2]| {
        cubature([unit_gauss(), circle(), gauss()], move |[r, phi, u]| {
            let (sine, cosine) = phi.sin_cos();
            ([a * r * cosine, b * r * sine, 0.5 * height * u], r)
        })
    };
    assert_inertia(&body, over_ellipse([radius; 2]));
    let oval = shapes::elliptic_cylinder(3.0, [0.7, 1.3], height)?;
    assert_inertia(&oval, over_ellipse([0.7, 1.3]));
    let mut uniform = Uniform(62);
    for _ in 0..50 {
        let phi = 7.0 * uniform.next();
        let omega = vector([phi.cos(), phi.sin(), 0.0]);
        let angle = body.inertia().angle_between_l_and_omega(omega)?;
        assert!(angle <= 2.0 * EPS);
    }
    // h = √3 R is inertially a ball.
    let ball = shapes::cylinder(1.0, 1.0, 3.0_f64.sqrt())?.inertia();
    close!(ball.matrix(), Matrix3::identity() * 0.5, 2.0 * EPS);
    Ok(())
}

#[test]
fn s2_6_equilateral_lamina() -> Result<()> {
    // claim: C2.6-3
    let h = 0.75_f64.sqrt();
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, h]];
    let lamina = shapes::triangle_lamina(1.0, corners)?;
    let (flat, normal) = (exact(rational(1, 24)), exact(rational(1, 12)));
    assert_inertia(&lamina, [flat, flat, normal, 0.0, 0.0, 0.0]);
    close!(lamina.center().y(), h / 3.0, EPS);
    // A thin prism over the triangle, as a mesh: its thickness t adds t²/12 to the in-plane moments.
    let t = 1.0 / 1024.0;
    let vertices = [0.0, t].map(|z| corners.map(|[x, y]| [x, y, z])).concat();
    let side = |a, b| [[a, b, b + 3], [a, b + 3, a + 3]];
    let sides = [side(0, 1), side(1, 2), side(2, 0)].concat();
    let triangles = [vec![[0, 2, 1], [3, 4, 5]], sides].concat();
    let prism = mesh_mass_properties(&vertices, &triangles, 1.0)?;
    let thick = flat + t * t / 12.0;
    assert_inertia(&prism, [thick, thick, normal, 0.0, 0.0, 0.0]);
    // A scalene triangle is not of revolution; its corners may be weighed as three masses M/12 and 3M/4 at the centroid.
    let corners = [[0.0, 0.0], [3.0, 0.0], [1.0, 2.0]];
    let scalene = shapes::triangle_lamina(12.0, corners)?;
    let mut masses: Vec<_> = corners.iter().map(|[x, y]| (1.0, [*x, *y, 0.0])).collect();
    masses.push((9.0, [4.0 / 3.0, 2.0 / 3.0, 0.0]));
    let weighed = particles(&masses)?.inertia().matrix();
    let (found, most) = (scalene.inertia().matrix(), 8.0 * EPS);
    assert_relative_eq!(found, weighed, max_relative = most, epsilon = most);
    let [i1, i2, _] = scalene.inertia().principal_axes().moments;
    assert!(i2 > 1.5 * i1);
    Ok(())
}
