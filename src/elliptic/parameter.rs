//! The parameter m together with its complement 1 − m.

use crate::error::{Result, finite, refused, within};
use crate::precise::{DoubleDouble, Number};

/// The side of m = 1/2 on which the parameter lies, and so the nome that is small.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// m ≤ mc: sine and cosine with small corrections.
    Circular,
    /// m > mc: hyperbolic functions with small corrections.
    Hyperbolic,
}

/// The parameter m = k² and its complement mc = 1 − m, neither formed from the other by a subtraction that cancels.
///
/// The lesser of the two is kept to the bit as it was given, the greater is one minus it to 106 bits. So
/// a parameter within 10⁻³⁰⁰ of 1 is as accurate as one within 10⁻³⁰⁰ of 0.
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
    /// m, or mc beyond m = 1/2.
    lesser: DoubleDouble,
    pub(crate) side: Side,
}

impl Parameter {
    /// The parameter from both m and mc, as mechanics gives them; the lesser is taken as exact.
    ///
    /// # Errors
    ///
    /// If one is not finite, lies outside 0…1, or if |m + mc − 1| exceeds 4 ε: then they do not belong together.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Parameter;
    /// let beside_the_separatrix = Parameter::new(1.0, 1e-20)?;
    /// assert_eq!(beside_the_separatrix.mc(), 1e-20);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    #[inline]
    pub fn new(m: f64, mc: f64) -> Result<Self> {
        let m = within_unit("parameter m", m)?;
        let mc = within_unit("complementary parameter mc", mc)?;
        if (m + mc - 1.0).abs() > 4.0 * f64::EPSILON {
            return refused("m + mc must be 1 to within 4 eps", m + mc);
        }
        Ok(Self::from_both(m.into(), mc.into()))
    }

    /// The parameter from m, which is taken as exact; mc is 1 − m to 106 bits. Right for m up to 1/2 and for any m
    /// that is known no better than to an ulp of 1.
    ///
    /// # Errors
    ///
    /// If m is not finite or lies outside 0…1.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Parameter;
    /// assert_eq!(Parameter::from_parameter(0.25)?.mc(), 0.75);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_parameter(m: f64) -> Result<Self> {
        let m = within_unit("parameter m", m)?;
        Ok(Self::from_both(m.into(), DoubleDouble::difference(1.0, m)))
    }

    /// The parameter from mc = 1 − m, which is taken as exact; m is 1 − mc to 106 bits.
    ///
    /// # Errors
    ///
    /// If mc is not finite or lies outside 0…1.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Parameter;
    /// assert_eq!(Parameter::from_complement(1e-300)?.mc(), 1e-300);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_complement(mc: f64) -> Result<Self> {
        let mc = within_unit("complementary parameter mc", mc)?;
        Ok(Self::from_both(
            DoubleDouble::difference(1.0, mc),
            mc.into(),
        ))
    }

    /// The parameter from m and mc, the lesser of them to 106 bits.
    #[inline]
    pub(crate) fn from_both(m: DoubleDouble, mc: DoubleDouble) -> Self {
        let (lesser, side) = match m.value() <= mc.value() {
            true => (m, Side::Circular),
            false => (mc, Side::Hyperbolic),
        };
        Self { lesser, side }
    }

    /// The parameter with m and mc exchanged: that of K′.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Parameter;
    /// assert_eq!(Parameter::from_parameter(0.25)?.exchanged().m(), 0.75);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    #[inline]
    pub fn exchanged(self) -> Self {
        Self::from_both(self.mc_dd(), self.m_dd())
    }

    /// The parameter m, rounded to a double.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Parameter;
    /// assert_eq!(Parameter::from_complement(0.25)?.m(), 0.75);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn m(self) -> f64 {
        self.m_dd().value()
    }

    /// The complement mc = 1 − m, rounded to a double.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Parameter;
    /// assert_eq!(Parameter::from_parameter(0.25)?.mc(), 0.75);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn mc(self) -> f64 {
        self.mc_dd().value()
    }

    fn greater(self) -> DoubleDouble {
        DoubleDouble::from(1.0).add_lesser(-self.lesser)
    }

    pub(crate) fn m_dd(self) -> DoubleDouble {
        match self.side {
            Side::Circular => self.lesser,
            Side::Hyperbolic => self.greater(),
        }
    }

    pub(crate) fn mc_dd(self) -> DoubleDouble {
        match self.side {
            Side::Circular => self.greater(),
            Side::Hyperbolic => self.lesser,
        }
    }
}

/// `value`, if it lies in 0…1; −0 becomes 0.
#[inline]
fn within_unit(quantity: &'static str, value: f64) -> Result<f64> {
    if (0.0..=1.0).contains(&value) {
        return Ok(value.abs());
    }
    within(quantity, value, 0.0, 1.0)
}

/// The factor n of sin² in an integral, together with its complement nc = 1 − n: any finite n.
///
/// It is the characteristic n of Π, and also carries a parameter m outside 0…1 to F, E and Π. (Inside, a [`Parameter`] can be
/// given instead.) Next to n = 1 an integral goes as 1/√nc or ln nc, so there it is nc that must be known. The number given is exact, the
/// other is one minus it to 106 bits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Characteristic {
    pub(super) n: DoubleDouble,
    pub(super) nc: DoubleDouble,
}

impl Characteristic {
    /// From n, taken as exact.
    ///
    /// # Errors
    ///
    /// If n is not finite.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Characteristic;
    /// assert_eq!(Characteristic::from_characteristic(0.25)?, Characteristic::from_complement(0.75)?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_characteristic(n: f64) -> Result<Self> {
        let n = finite("characteristic n", n)?;
        Ok(Self {
            n: DoubleDouble::from(n),
            nc: DoubleDouble::difference(1.0, n),
        })
    }

    /// From nc = 1 − n, taken as exact.
    ///
    /// # Errors
    ///
    /// If nc is not finite.
    ///
    /// ```
    /// use spinning_bodies::elliptic::Characteristic;
    /// // Next to 1, where n itself has no digits left.
    /// assert!(Characteristic::from_complement(1e-20)? != Characteristic::from_characteristic(1.0)?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_complement(nc: f64) -> Result<Self> {
        let nc = finite("complementary characteristic nc", nc)?;
        Ok(Self {
            n: DoubleDouble::difference(1.0, nc),
            nc: DoubleDouble::from(nc),
        })
    }

    /// The complement nc = 1 − n, rounded to a double.
    pub(crate) fn nc(self) -> f64 {
        self.nc.value()
    }
}

impl From<Parameter> for Characteristic {
    fn from(parameter: Parameter) -> Self {
        Self {
            n: parameter.m_dd(),
            nc: parameter.mc_dd(),
        }
    }
}
