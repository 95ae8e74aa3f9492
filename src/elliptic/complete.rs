//! Complete integrals of the first and second kind.

use super::carlson;
use super::modulus::Modulus;
use super::parameter::Parameter;
use crate::double_double::DoubleDouble as Dd;

/// K = ∫₀^{π/2} dθ/√(1 − m sin²θ); infinite at mc = 0.
pub fn complete_first(parameter: Parameter) -> f64 {
    Modulus::new(parameter).quarter_period()
}

/// E = ∫₀^{π/2} √(1 − m sin²θ) dθ.
pub fn complete_second(parameter: Parameter) -> f64 {
    if parameter.mc() == 0.0 {
        return 1.0;
    }
    let d = d_dd(parameter);
    b_dd(parameter).add(parameter.mc_dd().multiply(d)).value()
}

/// D = ∫₀^{π/2} sin²θ/√(1 − m sin²θ) dθ = (K − E)/m; infinite at mc = 0.
pub fn complete_d(parameter: Parameter) -> f64 {
    if parameter.mc() == 0.0 {
        return f64::INFINITY;
    }
    d_dd(parameter).value()
}

/// B = ∫₀^{π/2} cos²θ/√(1 − m sin²θ) dθ = (E − mc K)/m.
pub fn complete_b(parameter: Parameter) -> f64 {
    b_dd(parameter).value()
}

fn d_dd(parameter: Parameter) -> Dd {
    carlson::second(Dd::from(0.0), parameter.mc_dd(), Dd::from(1.0)).divide(Dd::from(3.0))
}

fn b_dd(parameter: Parameter) -> Dd {
    let mc = parameter.mc_dd();
    // B − 1 = O(mc ln mc), far below the last place; R_D would overflow soon after.
    if mc.value() < 1e-100 {
        return Dd::from(1.0);
    }
    mc.multiply(carlson::second(Dd::from(0.0), Dd::from(1.0), mc))
        .divide(Dd::from(3.0))
}
