//! What an exact top prepares before its first state: from m and mc to the modulus, and from the squares of sn, cn, dn at time 0
//! to the argument they belong to.

use super::landen::Landen;
use super::modulus::{Modulus, Side};
use super::parameter::Parameter;
use crate::precise::{DoubleDouble, Number, Words};

/// A modulus in all the digits of m and mc, with the transformation by which it was prepared.
#[derive(Clone, Copy)]
pub(crate) struct Descent<N: Number> {
    pub(crate) m: N,
    pub(crate) mc: N,
    pub(crate) modulus: Modulus,
    /// Of the lesser of m and mc.
    pub(crate) landen: Landen<N>,
}

/// The squares of the three functions at one place, without their denominators: neither m nor a difference need be formed again.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Squares<N> {
    pub(crate) sn: N,
    pub(crate) cn: N,
    /// sn² + cn² in the same unit.
    pub(crate) whole: N,
    pub(crate) dn: N,
    /// dn² + m sn² in the unit of `dn`.
    pub(crate) dn_whole: N,
}

impl<N: Number> Descent<N> {
    /// Both are taken as they are: each right to all its digits, neither formed from the other.
    #[inline]
    pub(crate) fn new(m: N, mc: N) -> Self {
        let (side, lesser, greater) = if m.exceeds(mc) {
            (Side::Hyperbolic, mc, m)
        } else {
            (Side::Circular, m, mc)
        };
        let landen = Landen::new(lesser, greater.narrow().square_root());
        let parameter = Parameter::from_both(m.narrow().two(), mc.narrow().two());
        let complementary_modulus = mc.root_of_quotient(N::from_double(1.0));
        Self {
            m,
            mc,
            modulus: Modulus::from_landen(side, parameter, complementary_modulus, &landen),
            landen,
        }
    }

    pub(crate) fn side(&self) -> Side {
        self.modulus.side()
    }

    #[inline]
    /// The u in 0…K with these functions, good to a double's precision.
    pub(crate) fn argument(&self, squares: &Squares<N>) -> DoubleDouble {
        let Squares {
            sn,
            cn,
            whole,
            dn,
            dn_whole,
        } = *squares;
        // Beyond the middle of the quarter period, where mc sn⁴ > cn⁴, count from its end: there sn is cn/dn and dn is k′/dn.
        let from_end = (self.mc * sn.square()).exceeds(cn.square());
        let angle = match self.side() {
            Side::Circular => {
                let [s, d] = if from_end {
                    [
                        (cn * dn_whole).root_of_quotient(dn * whole),
                        (self.mc * dn_whole).root_of_quotient(dn),
                    ]
                } else {
                    [sn.root_of_quotient(whole), dn.root_of_quotient(dn_whole)]
                };
                N::from_double(self.landen.nearest_sine(s, d, 1.0).asin())
            }
            Side::Hyperbolic => {
                let [s, d] = if from_end {
                    [
                        cn.root_of_quotient(self.mc * sn),
                        whole.root_of_quotient(sn),
                    ]
                } else {
                    [
                        sn.root_of_quotient(cn),
                        (dn * whole).root_of_quotient(cn * dn_whole),
                    ]
                };
                let sinh = self.landen.nearest_sine(s, d, -1.0);
                N::from_narrow(N::from_double(sinh + sinh.hypot(1.0)).logarithm())
            }
        };
        let rest = angle
            .quotient(N::from_narrow(self.landen.mean))
            .narrow()
            .two();
        if from_end {
            self.modulus.quarter_period_dd() - rest
        } else {
            rest
        }
    }
}
