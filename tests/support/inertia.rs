//! What the tests of Section 2 share: rationals, a seeded generator, Gauss quadrature, point masses.

#![allow(
    dead_code,
    reason = "each of the tests that include this file uses its own part"
)]

use num_rational::Ratio;
use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::MassProperties;

pub type R = Ratio<i128>;

pub fn rational(numerator: i128, denominator: i128) -> R {
    Ratio::new(numerator, denominator)
}

/// The nearest number: both parts are small, so this is one correctly rounded division.
pub fn exact(r: R) -> f64 {
    *r.numer() as f64 / *r.denom() as f64
}

pub fn vector([x, y, z]: [f64; 3]) -> BodyVector {
    BodyVector::new(x, y, z)
}

/// The rigid body made of these masses at these places.
pub fn particles(list: &[(f64, [f64; 3])]) -> Result<MassProperties> {
    let parts: Vec<_> = list
        .iter()
        .map(|(mass, x)| MassProperties::particle(*mass, vector(*x)))
        .collect::<Result<_>>()?;
    MassProperties::compose(&parts)
}

/// Splitmix64: numbers uniform in 0..1, the same on every machine.
pub struct Uniform(pub u64);

impl Uniform {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn signed(&mut self) -> f64 {
        2.0 * self.next() - 1.0
    }

    pub fn vector(&mut self) -> BodyVector {
        vector([0; 3].map(|_| self.signed()))
    }

    pub fn attitude(&mut self) -> Attitude {
        let [w, x, y, z] = [0; 4].map(|_| self.signed());
        Attitude::from_quaternion(w, x, y, z).expect("four random numbers are not all zero")
    }

    pub fn point_masses(&mut self, count: usize) -> Vec<(f64, [f64; 3])> {
        (0..count)
            .map(|_| (0.1 + self.next(), [0; 3].map(|_| self.signed())))
            .collect()
    }
}

/// Nodes and weights of a quadrature rule in one variable.
pub type Rule = Vec<(f64, f64)>;

/// The Gauss rule with five points on −1..1: exact to degree 9.
pub fn gauss() -> Rule {
    let root = (10.0_f64 / 7.0).sqrt();
    let (near, far) = (
        (5.0 - 2.0 * root).sqrt() / 3.0,
        (5.0 + 2.0 * root).sqrt() / 3.0,
    );
    let (heavy, light) = (
        (322.0 + 13.0 * 70.0_f64.sqrt()) / 900.0,
        (322.0 - 13.0 * 70.0_f64.sqrt()) / 900.0,
    );
    vec![
        (-far, light),
        (-near, heavy),
        (0.0, 128.0 / 225.0),
        (near, heavy),
        (far, light),
    ]
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

/// Fails unless the body's inertia matrix is `mass` times the six entries, to 16 eps of the largest.
pub fn assert_inertia(body: &MassProperties, entries: [f64; 6]) {
    let matrix = body.inertia().matrix() / body.mass();
    let size = entries.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    for (entry, (i, j)) in entries
        .into_iter()
        .zip([(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)])
    {
        let difference = (matrix[(i, j)] - entry).abs();
        assert!(
            difference <= 16.0 * f64::EPSILON * size,
            "{matrix} {i}{j} {entry}"
        );
    }
}
