//! A state known to 32 digits, and the error of a computed one.

use spinning_bodies::integrators::geometric::{DoubleDouble, Phase, Real};

/// The true attitude and angular velocity at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    time: f64,
    omega: [DoubleDouble; 3],
    attitude: [DoubleDouble; 4],
}

/// The error of a computed state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apart {
    /// Angle of the rotation between the two attitudes, rad; infinite if one is not finite, NaN for a scene without an attitude.
    pub attitude: f64,
    /// |ΔΩ|/|Ω|; infinite if that is not finite. For a scene the norm of the error of its rates over the greatest norm of the rates; NaN if it has none.
    pub omega: f64,
}

impl Sample {
    /// The sample at this time (s): Ω along the body's axes (rad/s) and the attitude's quaternion (w, x, y, z), each number the sum of two doubles.
    pub fn new(time: f64, omega: [[f64; 2]; 3], attitude: [[f64; 2]; 4]) -> Self {
        let sum = |[high, low]: [f64; 2]| {
            DoubleDouble::from_double(high) + DoubleDouble::from_double(low)
        };
        Self {
            time,
            omega: omega.map(sum),
            attitude: attitude.map(sum),
        }
    }

    /// The time, s.
    pub const fn time(&self) -> f64 {
        self.time
    }

    /// Ω along the body's axes (rad/s) and the attitude's quaternion (w, x, y, z).
    pub const fn numbers(&self) -> ([DoubleDouble; 3], [DoubleDouble; 4]) {
        (self.omega, self.attitude)
    }

    /// The error of `phase`, for a body with these moments.
    ///
    /// Differences are formed in two words, so that errors down to 1e-30 are themselves correct, in whatever kind of number the state is given.
    /// The quaternion may have any length.
    pub fn apart<T: Real>(&self, phase: &Phase<T>, moments: [f64; 3]) -> Apart {
        let [a, b, c, d] = self.attitude;
        let [w, x, y, z] = phase.q.map(T::two_words);
        // The vector part of truth⁻¹q, which contains all of a small angle.
        let across = [
            (a * x - b * w) + (d * y - c * z),
            (a * y + b * z) - (c * w + d * x),
            (a * z - b * y) + (c * x - d * w),
        ];
        let along = (a * w + b * x) + (c * y + d * z);
        let size = |v: [f64; 3]| v[0].hypot(v[1]).hypot(v[2]);
        let gap = |k: usize| {
            let l = self.omega[k] * DoubleDouble::from_double(moments[k]);
            (phase.l[k].two_words() - l).to_double() / moments[k]
        };
        let turn = size(across.map(DoubleDouble::to_double)).atan2(along.to_double().abs());
        let omega = size(self.omega.map(DoubleDouble::to_double));
        Apart {
            attitude: known(2.0 * turn),
            omega: known(size(core::array::from_fn(gap)) / omega),
        }
    }
}

/// The error; infinity in place of NaN.
pub(super) const fn known(error: f64) -> f64 {
    if error.is_nan() { f64::INFINITY } else { error }
}

#[cfg(test)]
mod tests {
    use super::Sample;
    use spinning_bodies::integrators::geometric::Phase;

    #[test]
    fn errors_far_below_rounding_are_seen() {
        let third = [1.0 / 3.0, 1.0 / 3.0 * 2.0_f64.powi(-54)];
        let truth = Sample::new(
            1.0,
            [third, [0.0; 2], [0.0; 2]],
            [[1.0, 0.0], [1e-25, 0.0], [0.0; 2], [0.0; 2]],
        );
        let phase = Phase {
            l: [1.0 / 3.0, 0.0, 0.0],
            q: [-3.0, 0.0, 0.0, 0.0],
        };
        let apart = truth.apart(&phase, [1.0; 3]);
        assert!((apart.attitude / 2e-25 - 1.0).abs() < 1e-15, "{apart:?}");
        assert!(
            (apart.omega / 2.0_f64.powi(-54) - 1.0).abs() < 1e-15,
            "{apart:?}"
        );
        let lost = Phase {
            l: [f64::NAN; 3],
            q: [f64::NAN; 4],
        };
        let apart = truth.apart(&lost, [1.0; 3]);
        assert!(apart.attitude == f64::INFINITY && apart.omega == f64::INFINITY);
    }
}
