//! Point masses, and cubature by products of rules in one variable.

use crate::vector;
use spinning_bodies::Result;
use spinning_bodies::inertia::MassProperties;

/// The rigid body made of these masses at these places.
pub fn particles(list: &[(f64, [f64; 3])]) -> Result<MassProperties> {
    let parts: Vec<_> = list
        .iter()
        .map(|(mass, x)| MassProperties::particle(*mass, vector(*x)))
        .collect::<Result<_>>()?;
    MassProperties::compose(&parts)
}

/// Nodes and weights of a quadrature rule in one variable.
pub type Rule = Vec<(f64, f64)>;

/// The Gauss rule with five points on −1..1: exact to degree 9.
pub fn gauss() -> Rule {
    let node = |sign: f64| {
        let place = (5.0 + sign * 2.0 * (10.0_f64 / 7.0).sqrt()).sqrt() / 3.0;
        (place, (322.0 - sign * 13.0 * 70.0_f64.sqrt()) / 900.0)
    };
    let [near, far] = [-1.0, 1.0].map(node);
    let mirrored = |(place, weight): (f64, f64)| (-place, weight);
    let middle = (0.0, 128.0 / 225.0);
    vec![mirrored(far), mirrored(near), middle, near, far]
}

/// ∫f from `from` to `to` of a smooth function, by the same rule on two hundred stretches.
pub fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let stretch = (to - from) / 200.0;
    (0..200)
        .flat_map(|k| {
            unit_gauss()
                .into_iter()
                .map(move |node| (f64::from(k), node))
        })
        .map(|(k, (x, weight))| weight * f(from + stretch * (k + x)))
        .sum::<f64>()
        * stretch
}

/// The same on 0..1.
pub fn unit_gauss() -> Rule {
    gauss()
        .into_iter()
        .map(|(x, w)| (0.5 + 0.5 * x, 0.5 * w))
        .collect()
}

/// Twelve equal steps round the circle: exact for trigonometric polynomials to degree 11.
pub fn circle() -> Rule {
    (0..12)
        .map(|k| (f64::from(k) * std::f64::consts::TAU / 12.0, 1.0))
        .collect()
}

/// A variable that is not integrated over.
pub fn fixed(x: f64) -> Rule {
    vec![(x, 1.0)]
}

/// Inertia matrix entries xx, yy, zz, xy, xz, yz about the origin, for unit mass, by cubature.
///
/// The body is the image of a product domain: `map` gives the point and the Jacobian.
pub fn cubature(rules: [Rule; 3], map: impl Fn([f64; 3]) -> ([f64; 3], f64)) -> [f64; 6] {
    let mut volume = 0.0;
    let mut s = [0.0; 6];
    for &(a, wa) in &rules[0] {
        for &(b, wb) in &rules[1] {
            for &(c, wc) in &rules[2] {
                let ([x, y, z], jacobian) = map([a, b, c]);
                let w = wa * wb * wc * jacobian;
                volume += w;
                for (sum, term) in s.iter_mut().zip([x * x, y * y, z * z, x * y, x * z, y * z]) {
                    *sum += w * term;
                }
            }
        }
    }
    let [xx, yy, zz, xy, xz, yz] = s.map(|sum| sum / volume);
    [yy + zz, zz + xx, xx + yy, -xy, -xz, -yz]
}

/// The same of an ellipsoid with these half axes, the origin so far along the first of them; with a fixed radius of a shell.
pub fn ellipsoid(radius: Rule, axes: [f64; 3], along: f64) -> [f64; 6] {
    cubature([radius, gauss(), circle()], |[r, u, phi]| {
        let across = r * (1.0 - u * u).sqrt();
        let [x, y, z] = [across * phi.cos(), across * phi.sin(), r * u];
        ([axes[0] * x - along, axes[1] * y, axes[2] * z], r * r)
    })
}

/// Fails unless the body's inertia matrix is `mass` times the six entries, to 16 eps of the largest.
pub fn assert_inertia(body: &MassProperties, entries: [f64; 6]) {
    let matrix = body.inertia().matrix() / body.mass();
    let size = entries.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    for (entry, (i, j)) in entries
        .into_iter()
        .zip([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)])
    {
        let difference = (matrix[(i, j)] - entry).abs();
        let same = difference <= 16.0 * f64::EPSILON * size;
        assert!(same, "{matrix} {i}{j} {entry}");
    }
}
