//! measurement
#[path = "support/decimal.rs"]
mod decimal;
use decimal::{hexadecimal, relative_error, units};
use spinning_bodies::elliptic::{Modulus, Parameter};
use std::collections::BTreeMap;

#[test]
fn table() {
    let mut worst: BTreeMap<String, [f64; 6]> = BTreeMap::new();
    for line in include_str!("reference/jacobi.csv").lines() {
        let f: Vec<&str> = line.split(',').collect();
        let value = hexadecimal(f[2]);
        let p = if f[1] == "m" {
            Parameter::from_parameter(value)
        } else {
            Parameter::from_complement(value)
        }
        .unwrap();
        let u = hexadecimal(f[3]);
        let j = Modulus::new(p).jacobi(u).unwrap();
        let w = worst.entry(f[0].to_string()).or_default();
        for (i, (x, t)) in [j.sn, j.cn, j.dn, j.am]
            .into_iter()
            .zip(&f[4..])
            .enumerate()
        {
            let e = units(x, t);
            if e > 20.0 {
                println!("{line} : {i} {x:e} {e}");
            }
            w[i] = w[i].max(e);
            if i < 3 {
                w[4] = w[4].max(relative_error(x, t).abs() * x.abs());
            }
        }
    }
    for (k, w) in worst {
        println!(
            "{k:22} {:.2} {:.2} {:.2} {:.2} abs {:.2e}",
            w[0], w[1], w[2], w[3], w[4]
        );
    }
}

#[test]
fn integrals() {
    use spinning_bodies::elliptic::*;
    let mut worst: BTreeMap<String, f64> = BTreeMap::new();
    for line in include_str!("reference/elliptic_integrals.csv").lines() {
        let f: Vec<&str> = line.split(',').collect();
        let a: Vec<&str> = f[2].split(' ').collect();
        let param = |t: &str| {
            let (n, v) = t.split_once(':').unwrap();
            let v = hexadecimal(v);
            if n == "m" {
                Parameter::from_parameter(v).unwrap()
            } else {
                Parameter::from_complement(v).unwrap()
            }
        };
        let chr = |t: &str| {
            let (n, v) = t.split_once(':').unwrap();
            let v = hexadecimal(v);
            if n == "n" {
                Characteristic::from_characteristic(v).unwrap()
            } else {
                Characteristic::from_complement(v).unwrap()
            }
        };
        let x = |i: usize| hexadecimal(a[i]);
        let value = match f[1] {
            "K" => Ok(complete_first(param(a[0]))),
            "E" => Ok(complete_second(param(a[0]))),
            "D" => Ok(complete_d(param(a[0]))),
            "B" => Ok(complete_b(param(a[0]))),
            "Fi" => incomplete_first(x(0), param(a[1])),
            "Ei" => incomplete_second(x(0), param(a[1])),
            "P" => complete_third(chr(a[0]), param(a[1])),
            "Pi" => incomplete_third(x(0), chr(a[1]), param(a[2])),
            "RF" => carlson::rf(x(0), x(1), x(2)),
            "RC" => carlson::rc(x(0), x(1)),
            "RD" => carlson::rd(x(0), x(1), x(2)),
            "RJ" => carlson::rj(x(0), x(1), x(2), x(3)),
            "RG" => carlson::rg(x(0), x(1), x(2)),
            "ASN" => inverse_sn(x(0), param(a[1])),
            "ACN" => inverse_cn(x(0), param(a[1])),
            "ADN" => inverse_dn(x(0), param(a[1])),
            _ => panic!("{line}"),
        };
        let e = match value {
            Ok(v) => relative_error(v, f[3]).abs() / f64::EPSILON,
            Err(ref e) => {
                println!("{e}");
                f64::INFINITY
            }
        };
        if e > 4.0 {
            println!("{e:.3e} {:?} : {line}", value);
        }
        let w = worst.entry(format!("{} {}", f[1], f[0])).or_default();
        *w = w.max(e);
    }
    for (k, w) in worst {
        println!("{k:22} {w:.2}");
    }
}
