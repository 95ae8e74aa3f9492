//! Computed doubles against decimals of 34 digits, and the hexadecimal floats of the tables.

use crate::double_double::Dd;

/// A number in C's hexadecimal notation, ±0x1.hhhp±e, ±0x0.0p+0 or a subnormal ±0x0.hhhp-1022.
pub fn hexadecimal(text: &str) -> f64 {
    let (sign, text) = text
        .strip_prefix('-')
        .map_or((1.0, text), |rest| (-1.0, rest));
    let (mantissa, exponent) = text
        .strip_prefix("0x")
        .and_then(|text| text.split_once('p'))
        .expect("a hexadecimal float");
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let bits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("digits");
    let exponent: i32 = exponent.parse().expect("an exponent");
    let shift = exponent - 4 * fraction.len() as i32;
    // In two exact steps: the first keeps the number normal, the second may reach the subnormal.
    sign * bits as f64 * 2.0_f64.powi(shift / 2) * 2.0_f64.powi(shift - shift / 2)
}

/// Sign, 34 digits as an integer, and the power of ten of the first.
fn digits(text: &str) -> (bool, i128, i32) {
    let (negative, text) = text
        .strip_prefix('-')
        .map_or((false, text), |rest| (true, rest));
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    assert!(whole.len() == 1 && fraction.len() <= 33, "{text}");
    let value: i128 = format!("{whole}{fraction:0<33}").parse().expect("digits");
    (negative, value, exponent.parse().expect("an exponent"))
}

/// A decimal number with more digits than an f64 has, as hi + lo: lo is what the nearest f64 leaves over.
///
/// The remainder is computed from the digits themselves, in units of the last place of the decimal.
pub fn decimal(text: &str) -> Dd {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let negative = mantissa.starts_with('-');
    let digits = mantissa.trim_start_matches('-');
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let digits = whole.bytes().chain(fraction.bytes());
    let mut value = digits.fold(Dd::ZERO, |value, digit| {
        value * 10.0 + f64::from(digit - b'0')
    });
    // Ten to a power in steps that stay exact in 106 bits (10²² < 2⁷⁴ · 5-smooth part of 52 bits).
    let mut shift = exponent - fraction.len() as i32;
    while shift != 0 {
        let step = shift.clamp(-20, 20);
        let power = 10_f64.powi(step.abs());
        value = if step > 0 {
            value * power
        } else {
            value / power
        };
        shift -= step;
    }
    if negative { -value } else { value }
}

/// |computed − exact| as a part of |exact|; exact where both are written out in 34 digits.
pub fn relative_error(computed: f64, exact: &str) -> f64 {
    let (negative, value, exponent) = digits(exact);
    if !computed.is_finite() {
        return f64::INFINITY;
    }
    if value == 0 {
        return if computed == 0.0 { 0.0 } else { f64::INFINITY };
    }
    if computed == 0.0 {
        return 1.0;
    }
    let (sign, mut found, place) = digits(&format!("{computed:.33e}"));
    if sign != negative {
        return 2.0;
    }
    let mut value = value;
    match place - exponent {
        0 => {}
        // One place apart, as 9.99… and 1.00… × 10 are.
        1 => value /= 10,
        -1 => found /= 10,
        _ => return 1.0_f64.max(10.0_f64.powi(place - exponent)),
    }
    (found - value) as f64 / value as f64
}

/// |computed − exact| in units in the last place of the nearest double.
pub fn units(computed: f64, exact: &str) -> f64 {
    let nearest: f64 = exact.parse().expect("a decimal");
    if nearest == 0.0 {
        return computed.abs() / 5e-324;
    }
    let spacing = nearest.abs().next_up() - nearest.abs();
    if nearest.is_subnormal() {
        return (computed - nearest).abs() / spacing;
    }
    relative_error(computed, exact).abs() * (nearest.abs() / spacing)
}
