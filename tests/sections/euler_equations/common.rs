//! What the files of Section 5 share.

use super::*;

pub const PLATE: [f64; 3] = [2.0, 3.0, 4.0];

pub const OMEGA: BodyVector = BodyVector::new(0.7, 0.9, 1.1);

pub fn moments([a, b, c]: [f64; 3]) -> AxisMoments {
    AxisMoments::new(a, b, c).unwrap()
}

pub fn heavy(i: [f64; 3], lever: [f64; 3]) -> HeavyTop {
    HeavyTop::new(moments(i), vector([lever[0], lever[1], lever[2]])).unwrap()
}

pub const START: TopState = TopState {
    omega: vector([0.4, -0.9, 1.3]),
    up: vector([0.48, 0.6, 0.64]),
};

/// Two waves that feed the others.
pub fn fluid(size: usize) -> TruncatedFluid {
    let c = Complex::new;
    TruncatedFluid::new(
        size,
        &[
            ([1, 0], c(1.0, 0.3)),
            ([0, 1], c(-0.4, 0.7)),
            ([1, 1], c(0.5, -0.2)),
            ([1, -1], c(0.1, 0.6)),
        ],
    )
    .unwrap()
}
