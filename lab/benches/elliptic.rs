//! Jacobi functions: time beside GSL's, in one run.
//!
//! `lab/peers/build.sh && cargo bench -p lab --bench elliptic`. Without the first step the peer's columns are
//! empty. Each time is the least of many runs over the same arguments, ours and the peer's in turn.

mod support;

use std::hint::black_box;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use spinning_bodies::Result;
use spinning_bodies::elliptic::{Jacobi, Modulus, Parameter, sn_cn_dn};
use support::{Uniform, only_tested};

/// Arguments for each modulus, and moduli in a set.
const ARGUMENTS: usize = 1024;
const MODULI: usize = 8;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    println!("sn, cn, dn; ns each, and the part of GSL's time");
    println!(
        "{:>28} {:>8} {:>16} {:>16} {:>16} {:>16}",
        "set", "GSL", "prepared", "and am", "from scratch", "batch"
    );
    let mut uniform = Uniform(3);
    type Draw<'a> = &'a dyn Fn(&mut Uniform) -> Result<(Parameter, f64)>;
    let sets: [(&str, Draw); 5] = [
        ("|u| < 10, m random", &|u| {
            Ok((Parameter::from_parameter(u.next())?, 10.0))
        }),
        ("|u| < 10, m < 1/2", &|u| {
            Ok((Parameter::from_parameter(u.next() / 2.0)?, 10.0))
        }),
        ("|u| < 4K, mc 1e-1...1e-15", &|u| {
            let p = Parameter::from_complement(10_f64.powf(-1.0 - 14.0 * u.next()))?;
            Ok((p, 4.0 * Modulus::new(p).quarter_period()))
        }),
        ("|u| < 10, m 1e-1...1e-20", &|u| {
            let p = Parameter::from_parameter(10_f64.powf(-1.0 - 19.0 * u.next()))?;
            Ok((p, 10.0))
        }),
        ("|u| < 1e6, m random", &|u| {
            Ok((Parameter::from_parameter(u.next())?, 1e6))
        }),
    ];
    for (name, draw) in sets {
        let mut groups = Vec::new();
        for _ in 0..MODULI {
            let (parameter, range) = draw(&mut uniform)?;
            let arguments: Vec<f64> = (0..ARGUMENTS)
                .map(|_| range * (2.0 * uniform.next() - 1.0))
                .collect();
            groups.push((parameter, arguments));
        }
        measure(name, &groups)?;
    }
    Ok(())
}

type Group = (Parameter, Vec<f64>);

fn measure(name: &str, groups: &[Group]) -> Result<()> {
    let prepared: Vec<Modulus> = groups.iter().map(|(p, _)| Modulus::new(*p)).collect();
    let mut out = vec![
        Jacobi {
            sn: 0.0,
            cn: 0.0,
            dn: 0.0,
            am: 0.0
        };
        ARGUMENTS
    ];
    let [mut sn, mut cn, mut dn] = [const { [0.0; ARGUMENTS] }; 3];
    let mut best = [f64::INFINITY; 5];
    for _ in 0..4 {
        if let Some(time) = peer(groups) {
            best[0] = best[0].min(time);
        }
        for _ in 0..10 {
            best[1] = best[1].min(each(|| {
                for (modulus, (_, arguments)) in prepared.iter().zip(groups) {
                    for (&u, out) in arguments.iter().zip(&mut out) {
                        *out = modulus.jacobi(u)?;
                    }
                    black_box(&out);
                }
                Ok(())
            })?);
            best[4] = best[4].min(each(|| {
                for (modulus, (_, arguments)) in prepared.iter().zip(groups) {
                    for (i, &u) in arguments.iter().enumerate() {
                        (sn[i], cn[i], dn[i]) = modulus.sn_cn_dn(u)?;
                    }
                    black_box((&sn, &cn, &dn));
                }
                Ok(())
            })?);
            best[2] = best[2].min(each(|| {
                for (parameter, arguments) in groups {
                    for (i, &u) in arguments.iter().enumerate() {
                        (sn[i], cn[i], dn[i]) = sn_cn_dn(u, black_box(*parameter))?;
                    }
                    black_box((&sn, &cn, &dn));
                }
                Ok(())
            })?);
            best[3] = best[3].min(each(|| {
                for (modulus, (_, arguments)) in prepared.iter().zip(groups) {
                    modulus.jacobi_batch(arguments, &mut sn, &mut cn, &mut dn)?;
                    black_box((&sn, &cn, &dn));
                }
                Ok(())
            })?);
        }
    }
    let column = |time: f64| {
        if best[0].is_finite() {
            format!("{time:8.1} {:7.3}", time / best[0])
        } else {
            format!("{time:8.1}        ")
        }
    };
    println!(
        "{name:>28} {:>8.1} {} {} {} {}",
        best[0],
        column(best[4]),
        column(best[1]),
        column(best[2]),
        column(best[3]),
    );
    Ok(())
}

/// Nanoseconds a triple of one run over all groups.
fn each(mut work: impl FnMut() -> Result<()>) -> Result<f64> {
    let start = Instant::now();
    work()?;
    Ok(start.elapsed().as_secs_f64() * 1e9 / (ARGUMENTS * MODULI) as f64)
}

/// The peer's time for the same list, if it was built.
fn peer(groups: &[Group]) -> Option<f64> {
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/peers/elliptic_gsl");
    let mut child = Command::new(program)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .ok()?;
    let mut input = String::new();
    for (parameter, arguments) in groups {
        for u in arguments {
            input.push_str(&format!("{u:e} {:e}\n", parameter.m()));
        }
    }
    child.stdin.take()?.write_all(input.as_bytes()).ok()?;
    let output = child.wait_with_output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    text.split_whitespace().next()?.parse().ok()
}
