//! The integrals: against the table, their inverses, their infinities.

use super::*;
use spinning_bodies::elliptic::complete_first_excess;

/// `n:0x…` or `nc:0x…`.
fn characteristic(text: &str) -> Result<Characteristic> {
    match text.split_once(':') {
        Some(("n" | "m", value)) => Characteristic::from_characteristic(hexadecimal(value)),
        Some(("nc" | "mc", value)) => Characteristic::from_complement(hexadecimal(value)),
        _ => panic!("{text}"),
    }
}

/// The value of one row of the table of integrals.
fn integral(function: &str, arguments: &[&str]) -> Result<f64> {
    let x = |i: usize| hexadecimal(arguments[i]);
    let p = |i: usize| parameter(arguments[i]);
    let c = |i: usize| characteristic(arguments[i]);
    match function {
        "K" => complete_first(c(0)?),
        "X" => complete_first_excess(c(0)?),
        "E" => complete_second(c(0)?),
        "D" => complete_d(c(0)?),
        "B" => complete_b(c(0)?),
        "Fi" => incomplete_first(x(0), c(1)?),
        "Ei" => incomplete_second(x(0), c(1)?),
        "P" => complete_third(c(0)?, c(1)?),
        "Pi" => incomplete_third(x(0), c(1)?, c(2)?),
        "RF" => rf(x(0), x(1), x(2)),
        "RC" => rc(x(0), x(1)),
        "RD" => rd(x(0), x(1), x(2)),
        "RJ" => rj(x(0), x(1), x(2), x(3)),
        "RG" => rg(x(0), x(1), x(2)),
        "ASN" => inverse_sn(x(0), p(1)?),
        "ACN" => inverse_cn(x(0), p(1)?),
        "ADN" => inverse_dn(x(0), p(1)?),
        _ => panic!("{function}"),
    }
}

#[test]
fn integrals_are_right_to_the_last_place_everywhere() -> Result<()> {
    let tables = [
        include_str!("../../reference/elliptic_integrals.csv"),
        include_str!("../../reference/elliptic_range.csv"),
    ];
    for line in tables.into_iter().flat_map(str::lines) {
        let fields: Vec<&str> = line.split(',').collect();
        let arguments: Vec<&str> = fields[2].split(' ').collect();
        let value = integral(fields[1], &arguments)?;
        let error = relative_error(value, fields[3]).abs() / f64::EPSILON;
        // Observed: 0.47, for every function and every kind of argument; half an eps is what rounding alone can make.
        assert!(error <= 0.6, "{line}: {value:e} is {error} eps off");
    }
    Ok(())
}

/// Below 0 as well, to the greatest double, on both sides of where another way is taken: K by its own way, and less π/2.
#[test]
fn the_excess_is_what_the_quarter_period_has_more() -> Result<()> {
    let beyond = [-f64::MAX, -1e10, -1.0_f64.next_up(), -1.0];
    for m in beyond.into_iter().chain([-0.3, -1e-3, 0.0, 0.2, 0.9]) {
        let p = Characteristic::from_characteristic(m)?;
        let expected = complete_first(p)? - FRAC_PI_2;
        let excess = complete_first_excess(p)?;
        near!(excess, expected, 2.0 * f64::EPSILON);
    }
    let pole = Characteristic::from_complement(0.0)?;
    assert_eq!(complete_first_excess(pole)?, f64::INFINITY);
    Ok(())
}

/// Π(φ | n = 2, m = 0) is artanh(tan φ), and its period is nothing: next to a multiple of π all that counts is what π has beyond 106 bits.
#[test]
fn an_angle_next_to_many_half_turns_keeps_its_digits() -> Result<()> {
    let two = Characteristic::from_characteristic(2.0)?;
    let zero = Parameter::from_parameter(0.0)?;
    // Numerators of the continued fraction of π: within 10⁻⁸ and 10⁻¹⁵ of so many half turns.
    for phi in [245_850_922.0_f64, 6_134_899_525_417_045.0] {
        let value = incomplete_third(phi, two, zero)?;
        let expected = phi.tan().atanh();
        // Both are right to an ulp or two. Without the third word of π the second is 6% off.
        near!(value / expected, 1.0, 4.0 * f64::EPSILON);
    }
    Ok(())
}

#[test]
fn inverses_undo_the_functions() -> Result<()> {
    for mc in [1e-300, 1e-16, 1e-3, 0.3, 0.5, 0.7, 1.0 - 1e-10] {
        let p = Parameter::from_complement(mc)?;
        let modulus = Modulus::new(p);
        let k = modulus.quarter_period();
        for i in 1..100 {
            let u = k * f64::from(i) / 100.0;
            let Jacobi { sn, cn, dn, .. } = modulus.jacobi(u)?;
            // An error of 4 ulp in the value is that over the slope in the argument, while the slope is not next to
            // zero: there the pair (cn, sn) serves. Observed: 0.29 of what is allowed, and 0.41 for the pair.
            let slopes = [
                (inverse_sn(sn, p)?, sn / (cn * dn)),
                (inverse_cn(cn, p)?, cn / (sn * dn)),
                (inverse_dn(dn, p)?, dn / (p.m() * sn * cn)),
            ];
            for (back, condition) in slopes {
                if condition.abs() < 1e6 * u {
                    let allowed = 4.0 * f64::EPSILON * (u + condition);
                    assert!((back - u).abs() <= allowed, "mc = {mc}, u = {u}: {back}");
                }
            }
            let back = inverse_cn_sn(3e200 * cn, 3e200 * sn, p)?;
            // The ratio sn/cn carries 4 eps, which turns the amplitude by 4 eps sn cn, and u by that over dn.
            let allowed = f64::EPSILON * (u + 4.0 * sn * cn / dn);
            assert!((back - u).abs() <= allowed, "mc = {mc}, u = {u}: {back}");
            let back = inverse_cn_sn(-cn, -sn, p)?;
            let expected = u - 2.0 * k;
            near!(back, expected, 2.0 * allowed + 2.0 * f64::EPSILON * k);
        }
    }
    Ok(())
}

#[test]
fn infinite_integrals_are_infinite() -> Result<()> {
    let separatrix = Parameter::from_complement(0.0)?;
    assert_eq!(complete_first(separatrix)?, f64::INFINITY);
    assert_eq!(complete_d(separatrix)?, f64::INFINITY);
    assert_eq!(complete_second(separatrix)?, 1.0);
    assert_eq!(complete_b(separatrix)?, 1.0);
    assert_eq!(incomplete_first(2.0, separatrix)?, f64::INFINITY);
    assert_eq!(incomplete_first(-20.0, separatrix)?, f64::NEG_INFINITY);
    assert_eq!(inverse_sn(1.0, separatrix)?, f64::INFINITY);
    assert_eq!(inverse_sn(-1.0, separatrix)?, f64::NEG_INFINITY);
    assert_eq!(inverse_cn(0.0, separatrix)?, f64::INFINITY);
    assert_eq!(inverse_cn(-0.5, separatrix)?, f64::INFINITY);
    assert_eq!(inverse_cn_sn(0.0, -1.0, separatrix)?, f64::NEG_INFINITY);
    let below = Characteristic::from_characteristic(0.3)?;
    assert_eq!(complete_third(below, separatrix)?, f64::INFINITY);
    let third = incomplete_third(-9.0, below, separatrix)?;
    assert_eq!(third, f64::NEG_INFINITY);
    let above = Characteristic::from_characteristic(3.0)?;
    assert_eq!(complete_third(above, separatrix)?, f64::NEG_INFINITY);
    Ok(())
}
