//! The body of the chapter: its moments, and the top that has them.

use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};

use crate::prelude::*;

parameters! {
    pub SMALLEST: "smallest", "I_1", "kg m²", "smallest principal moment", [0.2, 1.4], 1.0;
    pub MIDDLE: "middle", "I_2", "kg m²", "middle principal moment", [1.5, 2.5], 2.0;
    pub LARGEST: "largest", "I_3", "kg m²", "largest principal moment", [2.6, 5.0], 3.0;
}

pub fn moments(values: &Values) -> [f64; 3] {
    values.each([SMALLEST, MIDDLE, LARGEST])
}

/// The top with these moments, whether a body has them or not.
pub fn top_of(moments: [f64; 3], omega: BodyVector, attitude: Attitude) -> Result<EulerTop> {
    EulerTop::beyond_bodies_from_omega(moments, omega, attitude)
}

/// The addition to a caption if no body has these moments.
pub fn remark([i1, i2, i3]: [f64; 3]) -> &'static str {
    // Sliders stop at decimals, whose sums are rounded.
    match i1 + i2 < i3 * (1.0 - 1e-12) {
        true => " No body has such moments, for $I_1 + I_2 < I_3$; Euler's equations do not mind.",
        false => "",
    }
}

/// Three numbers as they are printed in a caption.
pub fn triple(numbers: [f64; 3]) -> String {
    format!("({})", numbers.map(brief).join(", "))
}
