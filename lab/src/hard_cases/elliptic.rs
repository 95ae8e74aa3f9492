//! dn by its definition, and by Jacobi's functions of the complementary parameter.

use super::family::{Family, numbers};
use spinning_bodies::elliptic::{Parameter, sn_cn_dn};

pub(super) const QUARTER_PERIOD: Family = Family {
    name: "quarter-period",
    paragraph: "6.6",
    quantity: "dn(*u*, *k*) next to a quarter period, *k*² near 1",
    lost: "1 − *k*² sn²",
    printed: r"\sqrt{1-k^2\,\mathrm{sn}^2u}",
    cure: r"\mathrm{dn}(u;\,1-k^2)",
    textbook: |inputs| {
        let [u, mc] = numbers(inputs)?;
        let k2 = 1.0 - mc;
        let (sn, ..) = sn_cn_dn(u, Parameter::from_parameter(k2)?)?;
        Ok(vec![(1.0 - k2 * sn * sn).sqrt()])
    },
    ours: |inputs| {
        let [u, mc] = numbers(inputs)?;
        let (.., dn) = sn_cn_dn(u, Parameter::from_complement(mc)?)?;
        Ok(vec![dn])
    },
};
