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
