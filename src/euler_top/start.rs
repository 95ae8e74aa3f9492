//! How a motion of the free top starts, and along which axes it is looked at.

use crate::error::{Error, Result};
use crate::precise::Number;

/// To how many digits the constants are formed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Digits {
    /// One double: for the first few radians.
    Sixteen,
    /// Two doubles: for ever.
    ThirtyTwo,
}

/// How a motion starts: the components along the body's axes of what was given, exact as they stand.
#[derive(Debug, Clone, Copy)]
pub(super) enum Start {
    /// L, kg m²/s.
    AngularMomentum([f64; 3]),
    /// Ω, rad/s.
    Omega([f64; 3]),
}

impl Start {
    /// What it is.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::AngularMomentum(_) => "a component of the angular momentum",
            Self::Omega(_) => "a component of the angular velocity",
        }
    }

    /// What was given.
    pub(super) fn components(self) -> [f64; 3] {
        match self {
            Self::AngularMomentum(components) | Self::Omega(components) => components,
        }
    }

    /// L, to 106 bits: the product of a moment and an angular velocity is not rounded.
    pub(super) fn angular_momentum<N: Number>(self, moments: [f64; 3]) -> [N; 3] {
        match self {
            Self::AngularMomentum([x, y, z]) => {
                [N::from_double(x), N::from_double(y), N::from_double(z)]
            }
            Self::Omega([x, y, z]) => [
                N::from_double(x).times(moments[0]),
                N::from_double(y).times(moments[1]),
                N::from_double(z).times(moments[2]),
            ],
        }
    }

    /// Whether a component of I Ω is not zero, though as a double it may be.
    pub(super) fn vanishes_by_rounding(self, moments: [f64; 3]) -> bool {
        match self {
            Self::AngularMomentum(_) => false,
            Self::Omega(omega) => omega
                .iter()
                .zip(moments)
                .any(|(component, moment)| *component != 0.0 && moment != 0.0),
        }
    }

    /// L and Ω as doubles.
    pub(super) fn both(self, moments: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        match self {
            Self::AngularMomentum(l) => (l, ratio(l, moments)),
            Self::Omega([x, y, z]) => {
                let l = [moments[0] * x, moments[1] * y, moments[2] * z];
                (l, [x, y, z])
            }
        }
    }

    /// The same quantity with other components.
    pub(super) fn with(self, components: [f64; 3]) -> Self {
        match self {
            Self::AngularMomentum(_) => Self::AngularMomentum(components),
            Self::Omega(_) => Self::Omega(components),
        }
    }

    /// A body on a line must not spin about that line, nor be a line in only one of two directions.
    pub(super) fn refuse_impossible_rod(&self, moments: [f64; 3]) -> Result<()> {
        let [first, middle, last] = ascending(moments);
        if moments[first] > 0.0 {
            return Ok(());
        }
        if let Start::AngularMomentum(l) = self {
            for (moment, component) in moments.iter().zip(l) {
                if *moment == 0.0 && *component != 0.0 {
                    return Err(Error::Condition {
                        condition: "the angular momentum about an axis whose moment is zero must be zero",
                        value: *component,
                    });
                }
            }
        }
        let gap = moments[last] - moments[middle];
        if gap > 8.0 * f64::EPSILON * moments[last] {
            return Err(Error::Condition {
                condition: "if one moment is zero, the difference of the other two must be zero",
                value: gap,
            });
        }
        Ok(())
    }
}

/// L_i/I_i; zero along an axis whose moment is zero.
#[inline]
pub(super) fn ratio(l: [f64; 3], moments: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| {
        if moments[k] == 0.0 {
            0.0
        } else {
            l[k] / moments[k]
        }
    })
}

/// A body's axes, renumbered and turned over so that axis 3 has the component that keeps its sign and components 1 and 3
/// start positive; right-handed like the old ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Renumbering {
    axis: [usize; 3],
    /// Which of the new axes is which of the old ones.
    pub(super) own: [usize; 3],
    pub(super) sign: [f64; 3],
}

impl Renumbering {
    pub(super) fn new(axis: [usize; 3], l: [f64; 3]) -> Self {
        let parity = if (axis[0] + 1) % 3 == axis[1] {
            1.0
        } else {
            -1.0
        };
        let sign_of = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
        let (first, third) = (sign_of(l[axis[0]]), sign_of(l[axis[2]]));
        let mut own = [0; 3];
        for k in 0..3 {
            own[axis[k]] = k;
        }
        Self {
            axis,
            own,
            sign: [first, parity * first * third, third],
        }
    }

    pub(super) fn there<T: Copy>(&self, v: [T; 3]) -> [T; 3] {
        self.axis.map(|i| v[i])
    }

    /// Back along the body's own axes.
    pub(super) fn back(&self, w: [f64; 3]) -> [f64; 3] {
        let signed = self.signed(w);
        self.own.map(|k| signed[k])
    }

    /// With the signs of the old axes, in the order of the new ones.
    pub(super) fn signed(&self, w: [f64; 3]) -> [f64; 3] {
        core::array::from_fn(|k| self.sign[k] * w[k])
    }
}

/// The order of the moments, ascending.
pub(super) fn ascending(moments: [f64; 3]) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    order
}
