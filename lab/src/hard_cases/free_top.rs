//! The free top by 6.6 as printed, and by [`EulerTop`].

use super::family::{Family, numbers};
use spinning_bodies::Result;
use spinning_bodies::elliptic::{Parameter, sn_cn_dn};
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};

pub(super) const NEAR_SEPARATRIX: Family = Family {
    name: "near-separatrix",
    paragraph: "6.6",
    quantity: "Ω during the first flip of a top that starts next to the separatrix",
    lost: "*L*² − 2*EI*₂, and with it 1 − *k*²",
    printed: r"L^2-2EI_2",
    cure: r"\tfrac{I_3-I_2}{I_3}L_3^2-\tfrac{I_2-I_1}{I_1}L_1^2",
    textbook: printed,
    ours: exact,
};

pub(super) const NEAR_AXIS: Family = Family {
    name: "near-axis",
    paragraph: "6.6",
    quantity: "the wobble Ω₁, Ω₂ of a top that spins almost about its third axis",
    lost: "2*EI*₃ − *L*²",
    printed: r"2EI_3-L^2",
    cure: r"\tfrac{I_3-I_1}{I_1}L_1^2+\tfrac{I_3-I_2}{I_2}L_2^2",
    textbook: |inputs| wobble(printed, inputs),
    ours: |inputs| wobble(exact, inputs),
};

pub(super) const NEARLY_SPHERE: Family = Family {
    name: "nearly-sphere",
    paragraph: "6.6",
    quantity: "Ω of a body that is almost a sphere, after a third of its slow wobble",
    lost: "2*EI*₃ − *L*² and *L*² − 2*EI*₁",
    printed: r"2EI_3-L^2,\;L^2-2EI_1",
    cure: r"\tfrac{I_3-I_1}{I_1}L_1^2+\tfrac{I_3-I_2}{I_2}L_2^2,\;\tfrac{I_2-I_1}{I_2}L_2^2+\tfrac{I_3-I_1}{I_3}L_3^2",
    textbook: printed,
    ours: exact,
};

pub(super) const LONG_TIME: Family = Family {
    name: "long-time",
    paragraph: "6.6",
    quantity: "Ω of an ordinary top after a long time",
    lost: "the phase, a rounded rate times the time",
    printed: r"\varphi=\lambda t",
    cure: r"\varphi=(\lambda+\delta)\,t\text{ mod }4K",
    textbook: printed,
    ours: exact,
};

/// Ω(t) by the formulas as printed, for a start with Ω₂ = 0, Ω₁, Ω₃ > 0 and L² > 2EI₂. Inputs: moments, L, t.
fn printed(inputs: &[f64]) -> Result<Vec<f64>> {
    let [a, b, c, l1, _, l3, t] = numbers(inputs)?;
    let square = l1 * l1 + l3 * l3;
    let twice = l1 * l1 / a + l3 * l3 / c;
    let (to_third, to_first) = (twice * c - square, square - twice * a);
    let rate = ((c - b) * to_first / (a * b * c)).sqrt();
    let k2 = (b - a) * to_third / ((c - b) * to_first);
    let (sn, cn, dn) = sn_cn_dn(rate * t, Parameter::from_parameter(k2)?)?;
    Ok(vec![
        (to_third / (a * (c - a))).sqrt() * cn,
        (to_third / (b * (c - b))).sqrt() * sn,
        (to_first / (c * (c - a))).sqrt() * dn,
    ])
}

fn exact(inputs: &[f64]) -> Result<Vec<f64>> {
    let [a, b, c, l1, l2, l3, t] = numbers(inputs)?;
    let l = BodyVector::new(l1, l2, l3);
    let top = EulerTop::new([a, b, c], l, Attitude::identity())?;
    let omega = top.omega_at(t)?;
    Ok(vec![omega.x(), omega.y(), omega.z()])
}

/// Ω₁ and Ω₂ only.
fn wobble(way: super::Formula, inputs: &[f64]) -> Result<Vec<f64>> {
    let mut omega = way(inputs)?;
    omega.truncate(2);
    Ok(omega)
}
