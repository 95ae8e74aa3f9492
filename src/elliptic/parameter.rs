//! The parameter m together with its complement 1 − m.

use crate::error::{Error, Result, finite};
use crate::precise::DoubleDouble;

/// The parameter m = k² and its complement mc = 1 − m, neither formed from the other by a subtraction that cancels.
///
/// The lesser of the two is kept to the last bit it was given with, the greater is one minus that to 106 bits. So
/// a parameter within 10⁻³⁰⁰ of 1 is as good as one within 10⁻³⁰⁰ of 0.
///
/// ```
/// use spinning_bodies::elliptic::Parameter;
/// let near = Parameter::from_complement(1e-40)?;
/// assert_eq!((near.m(), near.mc()), (1.0, 1e-40));
/// assert_eq!(near.exchanged(), Parameter::from_parameter(1e-40)?);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    m: DoubleDouble,
    mc: DoubleDouble,
}

impl Parameter {
    /// The parameter from both m and mc, as mechanics gives them; the lesser is believed.
    ///
    /// # Errors
    ///
    /// If one is not finite, lies outside 0…1, or if |m + mc − 1| exceeds 4 ε: then they do not belong together.
    pub fn new(m: f64, mc: f64) -> Result<Self> {
        let m = within_unit("parameter m", m)?;
        let mc = within_unit("complementary parameter mc", mc)?;
        let defect = DoubleDouble::sum(m, mc) - DoubleDouble::from(1.0);
        if defect.value().abs() > 4.0 * f64::EPSILON {
            return Err(Error::Condition {
                condition: "m + mc must be 1 to within 4 eps",
                value: m + mc,
            });
        }
        Ok(if m <= mc {
            Self::with_lesser_m(DoubleDouble::from(m))
        } else {
            Self::with_lesser_m(DoubleDouble::from(mc)).exchanged()
        })
    }

    /// The parameter from m, which is taken as exact; mc is 1 − m to 106 bits. Right for m up to 1/2 and for any m
    /// that is known no better than to an ulp of 1.
    ///
    /// # Errors
    ///
    /// If m is not finite or lies outside 0…1.
    pub fn from_parameter(m: f64) -> Result<Self> {
        let m = within_unit("parameter m", m)?;
        Ok(Self::with_lesser_m(DoubleDouble::from(m)))
    }

    /// The parameter from mc = 1 − m, which is taken as exact; m is 1 − mc to 106 bits.
    ///
    /// # Errors
    ///
    /// If mc is not finite or lies outside 0…1.
    pub fn from_complement(mc: f64) -> Result<Self> {
        let mc = within_unit("complementary parameter mc", mc)?;
        Ok(Self::with_lesser_m(DoubleDouble::from(mc)).exchanged())
    }

    /// The parameter m = k² from the modulus k, which is taken as exact; mc = (1 − k)(1 + k).
    ///
    /// # Errors
    ///
    /// If k is not finite or lies outside 0…1.
    pub fn from_modulus(k: f64) -> Result<Self> {
        let k = within_unit("modulus k", k)?;
        let mc = DoubleDouble::difference(1.0, k) * DoubleDouble::sum(1.0, k);
        Ok(Self {
            m: DoubleDouble::product(k, k),
            mc,
        })
    }

    /// The parameter from the lesser of m and mc to 106 bits.
    #[allow(
        dead_code,
        reason = "for callers inside the library that know m to 106 bits"
    )]
    pub(crate) fn from_lesser(lesser: Lesser, value: DoubleDouble) -> Result<Self> {
        within_unit("lesser of m and mc", value.value())?;
        let parameter = Self::with_lesser_m(value);
        Ok(match lesser {
            Lesser::Parameter => parameter,
            Lesser::Complement => parameter.exchanged(),
        })
    }

    /// The parameter from m and mc to 106 bits, each.
    pub(crate) fn from_both(m: DoubleDouble, mc: DoubleDouble) -> Self {
        Self { m, mc }
    }

    fn with_lesser_m(m: DoubleDouble) -> Self {
        let mc = DoubleDouble::from(1.0) - m;
        Self { m, mc }
    }

    /// The parameter of which m and mc are exchanged: that of K′.
    pub fn exchanged(self) -> Self {
        Self {
            m: self.mc,
            mc: self.m,
        }
    }

    /// The parameter m, rounded to a double.
    pub fn m(self) -> f64 {
        self.m.value()
    }

    /// The complement mc = 1 − m, rounded to a double.
    pub fn mc(self) -> f64 {
        self.mc.value()
    }

    pub(crate) fn m_dd(self) -> DoubleDouble {
        self.m
    }

    pub(crate) fn mc_dd(self) -> DoubleDouble {
        self.mc
    }
}

/// Which of m and mc is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(
    dead_code,
    reason = "for callers inside the library that know m to 106 bits"
)]
pub(crate) enum Lesser {
    Parameter,
    Complement,
}

/// `value`, if it lies in 0…1; −0 becomes 0.
pub(super) fn within_unit(quantity: &'static str, value: f64) -> Result<f64> {
    let value = finite(quantity, value)?;
    if (0.0..=1.0).contains(&value) {
        Ok(value.abs())
    } else {
        Err(Error::OutOfRange {
            quantity,
            value,
            least: 0.0,
            greatest: 1.0,
        })
    }
}
