//! The free top without one elliptic function: the power series of the heavy top, without weight, in pairs of doubles.

use crate::double_double::Dd;
use crate::power_series::{Top, Whole};
use spinning_bodies::frame::{Attitude, BodyVector};

/// Where it is, from the identity on.
#[derive(Debug, Clone, Copy)]
pub struct Flight {
    top: Top,
    now: Whole<Dd>,
}

impl Flight {
    /// From Ω in the body; no moment may be zero.
    pub fn from_omega(moments: [f64; 3], [x, y, z]: [f64; 3]) -> Self {
        let lever = [0.0; 3];
        Self {
            top: Top { moments, lever },
            now: [x, y, z, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0].map(Dd::from),
        }
    }

    /// Further by the time t, either way.
    pub fn fly(&mut self, t: f64) -> Self {
        self.now = self.top.after(self.now, t);
        *self
    }

    /// Ω along the body's axes, rounded.
    pub fn omega(&self) -> BodyVector {
        let [x, y, z, ..] = self.now.map(Dd::value);
        BodyVector::new(x, y, z)
    }

    /// The attitude, rounded.
    pub fn attitude(&self) -> Attitude {
        let [.., w, x, y, z] = self.now.map(Dd::value);
        Attitude::from_quaternion(w, x, y, z).expect("four numbers of norm one")
    }
}
