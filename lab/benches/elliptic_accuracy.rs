//! Elliptic integrals: greatest error against the table of 34 digits, ours and the crate `ellip`'s.
//!
//! `cargo bench -p lab --bench elliptic_accuracy`. The peer is asked twice: with m and n, rounded from the
//! complements where those are the exact ones, and through Bulirsch's forms, which take the complements.

use std::collections::BTreeMap;

use shared::{head, numbers, only_tested};
use spinning_bodies::elliptic::{
    Characteristic, Parameter, complete_b, complete_d, complete_first, complete_first_excess,
    complete_second, complete_third, incomplete_first, incomplete_second, incomplete_third, rc, rd,
    rf, rg, rj,
};

mod shared;
use support::decimal::{hexadecimal, relative_error};

fn main() {
    if only_tested() {
        return;
    }
    // Greatest error of the finite answers, and how many there were none.
    let mut worst: BTreeMap<(String, String), ([f64; 3], [u32; 4])> = BTreeMap::new();
    for line in include_str!("../../tests/reference/elliptic_integrals.csv").lines() {
        let fields: Vec<&str> = line.split(',').collect();
        let arguments: Vec<&str> = fields[2].split(' ').collect();
        let Some(values) = values(fields[1], &arguments) else {
            continue;
        };
        let key = (fields[1].to_string(), fields[0].to_string());
        let (worst, missing) = worst.entry(key).or_default();
        missing[3] += 1;
        for (i, value) in values.into_iter().enumerate() {
            match value {
                Some(value) if value.is_finite() => {
                    let error = relative_error(value, fields[3]).abs();
                    worst[i] = worst[i].max(error / f64::EPSILON);
                }
                _ => missing[i] += 1,
            }
        }
    }
    let columns = [
        "rows",
        "ours",
        "none",
        "ellip(m, n)",
        "none",
        "ellip(kc, nc)",
        "none",
    ];
    head(
        "greatest error in eps of the finite answers, and how often there was none",
        &columns,
    );
    for ((function, kind), (worst, missing)) in worst {
        let [a, b, c, rows] = missing.map(f64::from);
        let [ours, plain, complementary] = worst;
        numbers(
            &format!("{function} {kind}"),
            &[rows, ours, a, plain, b, complementary, c],
        );
    }
}

/// m or n, and what it is less than 1.
fn pair(text: &str) -> (f64, f64) {
    let (name, value) = text.split_once(':').expect("name:value");
    let (value, rest) = (hexadecimal(value), 1.0 - hexadecimal(value));
    if name.ends_with('c') {
        (rest, value)
    } else {
        (value, rest)
    }
}

fn parameter(text: &str) -> Parameter {
    let (m, mc) = pair(text);
    let exact = if text.starts_with("mc") {
        Parameter::from_complement(mc)
    } else {
        Parameter::from_parameter(m)
    };
    exact.expect("a parameter")
}

fn characteristic(text: &str) -> Characteristic {
    let (n, nc) = pair(text);
    let exact = if text.starts_with("nc") {
        Characteristic::from_complement(nc)
    } else {
        Characteristic::from_characteristic(n)
    };
    exact.expect("a characteristic")
}

/// Ours, the peer's from m and n, and the peer's from the complements.
fn values(function: &str, a: &[&str]) -> Option<[Option<f64>; 3]> {
    let x = |i: usize| hexadecimal(a[i]);
    let last = a[a.len() - 1];
    Some(match function {
        "X" => [complete_first_excess(parameter(last)).ok(), None, None],
        "K" | "E" | "D" | "B" | "P" => {
            let (m, mc) = pair(last);
            let p = parameter(last);
            let kc = mc.sqrt();
            match function {
                "K" => [
                    complete_first(p).ok(),
                    ellip::ellipk(m).ok(),
                    ellip::cel(kc, 1.0, 1.0, 1.0).ok(),
                ],
                "E" => [
                    complete_second(p).ok(),
                    ellip::ellipe(m).ok(),
                    ellip::cel(kc, 1.0, 1.0, mc).ok(),
                ],
                "D" => [
                    complete_d(p).ok(),
                    ellip::ellipd(m).ok(),
                    ellip::cel(kc, 1.0, 0.0, 1.0).ok(),
                ],
                "B" => [complete_b(p).ok(), None, ellip::cel(kc, 1.0, 1.0, 0.0).ok()],
                _ => {
                    let (n, nc) = pair(a[0]);
                    [
                        complete_third(characteristic(a[0]), p).ok(),
                        ellip::ellippi(n, m).ok(),
                        ellip::cel(kc, nc, 1.0, 1.0).ok(),
                    ]
                }
            }
        }
        "Fi" | "Ei" | "Pi" => {
            let (m, mc) = pair(last);
            let p = parameter(last);
            let (phi, kc) = (x(0), mc.sqrt());
            // Bulirsch's forms take the tangent of an amplitude within a quarter turn.
            let within = phi.abs() < std::f64::consts::FRAC_PI_2;
            let bulirsch = |value: Option<f64>| if within { value } else { None };
            match function {
                "Fi" => [
                    incomplete_first(phi, p).ok(),
                    ellip::ellipf(phi, m).ok(),
                    bulirsch(ellip::el1(phi.tan(), kc).ok()),
                ],
                "Ei" => [
                    incomplete_second(phi, p).ok(),
                    ellip::ellipeinc(phi, m).ok(),
                    bulirsch(ellip::el2(phi.tan(), kc, 1.0, mc).ok()),
                ],
                _ => {
                    let (n, nc) = pair(a[1]);
                    [
                        incomplete_third(phi, characteristic(a[1]), p).ok(),
                        ellip::ellippiinc(phi, n, m).ok(),
                        bulirsch(ellip::el3(phi.tan(), kc, nc).ok()),
                    ]
                }
            }
        }
        "RF" => [
            rf(x(0), x(1), x(2)).ok(),
            ellip::elliprf(x(0), x(1), x(2)).ok(),
            None,
        ],
        "RC" => [rc(x(0), x(1)).ok(), ellip::elliprc(x(0), x(1)).ok(), None],
        "RD" => [
            rd(x(0), x(1), x(2)).ok(),
            ellip::elliprd(x(0), x(1), x(2)).ok(),
            None,
        ],
        "RG" => [
            rg(x(0), x(1), x(2)).ok(),
            ellip::elliprg(x(0), x(1), x(2)).ok(),
            None,
        ],
        "RJ" => [
            rj(x(0), x(1), x(2), x(3)).ok(),
            ellip::elliprj(x(0), x(1), x(2), x(3)).ok(),
            None,
        ],
        _ => return None,
    })
}
