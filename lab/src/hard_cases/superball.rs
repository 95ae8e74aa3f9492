//! A ball without loss, after many bounces: by the angle of one bounce, and by a power in two words.

use super::family::{Family, numbers};
use spinning_bodies::superball::{BounceRotation, Motion};

pub(super) const MANY_BOUNCES: Family = Family {
    name: "many-bounces",
    paragraph: "4.6",
    quantity: "velocity and spin of a homogeneous superball after *n* bounces",
    lost: "*n* times a rounded angle",
    printed: r"\cos n\alpha,\;\sin n\alpha",
    cure: r"A^n=(A^{n/2})^2",
    textbook: |inputs| {
        let [bounces] = numbers(inputs)?;
        let kappa = 0.4_f64;
        let angle = ((1.0 - kappa) / (1.0 + kappa)).acos() * bounces;
        let sense = if bounces % 2.0 == 0.0 { -1.0 } else { 1.0 };
        Ok(vec![angle.cos(), sense * angle.sin() / kappa.sqrt()])
    },
    ours: |inputs| {
        let thrown = Motion {
            velocity: 1.0,
            rim_speed: 0.0,
        };
        let [bounces] = numbers(inputs)?;
        let after = BounceRotation::of_fraction(2, 5)?.after(thrown, bounces as u64);
        Ok(vec![after.velocity, after.rim_speed])
    },
};
