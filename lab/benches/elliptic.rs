//! Jacobi functions: time beside GSL's, and incomplete integrals beside those of Boost in long double and of GSL, in one run.
//!
//! `lab/peers/build.sh && cargo bench -p lab --bench elliptic`. Without the first step the peer's columns are
//! empty. Each time is the least of many runs over the same arguments, ours and the peer's in turn.

mod shared;

use std::hint::black_box;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use shared::only_tested;
use spinning_bodies::Result;
use spinning_bodies::elliptic::{
    Characteristic, Jacobi, Modulus, Parameter, incomplete_first, incomplete_second,
    incomplete_third, rc, rd, rf, rj, sn_cn_dn,
};
use support::Uniform;

/// Arguments for each modulus, and moduli in a set.
const ARGUMENTS: usize = 1024;
const MODULI: usize = 8;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    println!(
        "sn, cn, dn; ns each, and the part of GSL's time; from scratch the parameter is made from m and mc within the clock"
    );
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
    integrals(&mut uniform)
}

/// A function of the peer, what its arguments are, how they are drawn, and the same of ours.
type Integral = (
    &'static str,
    &'static str,
    fn(&mut Uniform) -> [f64; 4],
    fn(&[f64; 4]) -> Result<f64>,
);

const INTEGRALS: [Integral; 11] = [
    ("F", "phi < pi/2", angle, first),
    ("F", "|phi| < 100", long_angle, first),
    ("E", "phi < pi/2", angle, |[phi, m, ..]| {
        incomplete_second(*phi, Parameter::from_parameter(*m)?)
    }),
    ("Pi", "0 < n < 1", angle, third),
    ("Pi", "-1 < n < 0", negative_angle, third),
    ("RF", "0 to 1", four, |[x, y, z, _]| rf(*x, *y, *z)),
    ("RF", "1e-20 to 1e20", wide, |[x, y, z, _]| rf(*x, *y, *z)),
    ("RC", "0 to 1", four, |[x, y, ..]| rc(*x, *y)),
    ("RD", "0 to 1", four, |[x, y, z, _]| rd(*x, *y, *z)),
    ("RJ", "0 to 1", four, |[x, y, z, p]| rj(*x, *y, *z, *p)),
    ("RJ", "1e-20 to 1e20", wide, |[x, y, z, p]| {
        rj(*x, *y, *z, *p)
    }),
];

fn four(u: &mut Uniform) -> [f64; 4] {
    [(); 4].map(|()| u.next())
}

fn wide(u: &mut Uniform) -> [f64; 4] {
    four(u).map(|x| 10_f64.powf(40.0 * x - 20.0))
}

/// φ, m and n.
fn angle(u: &mut Uniform) -> [f64; 4] {
    let [turn, m, n, rest] = four(u);
    [turn * std::f64::consts::FRAC_PI_2, m, n, rest]
}

fn negative_angle(u: &mut Uniform) -> [f64; 4] {
    let [phi, m, n, rest] = angle(u);
    [phi, m, -n, rest]
}

fn long_angle(u: &mut Uniform) -> [f64; 4] {
    let [turn, m, n, rest] = four(u);
    [200.0 * turn - 100.0, m, n, rest]
}

fn first([phi, m, ..]: &[f64; 4]) -> Result<f64> {
    incomplete_first(*phi, Parameter::from_parameter(*m)?)
}

fn third([phi, m, n, _]: &[f64; 4]) -> Result<f64> {
    let n = Characteristic::from_characteristic(*n)?;
    incomplete_third(*phi, n, Parameter::from_parameter(*m)?)
}

fn integrals(uniform: &mut Uniform) -> Result<()> {
    println!("\nintegrals; ns each, and our part of the peer's time");
    println!(
        "{:>4} {:>14} {:>8} {:>16} {:>16}",
        "", "arguments", "ours", "Boost, 64 bits", "GSL, 53 bits"
    );
    for (function, name, draw, ours) in INTEGRALS {
        let rows: Vec<[f64; 4]> = (0..ARGUMENTS).map(|_| draw(uniform)).collect();
        let lines: Vec<String> = rows
            .iter()
            .map(|[a, b, c, d]| format!("{a:e} {b:e} {c:e} {d:e}\n"))
            .collect();
        let mut best = [f64::INFINITY; 3];
        for _ in 0..5 {
            for _ in 0..8 {
                let start = Instant::now();
                for row in &rows {
                    black_box(ours(black_box(row))?);
                }
                best[0] = best[0].min(start.elapsed().as_secs_f64() * 1e9 / ARGUMENTS as f64);
            }
            let times = told("elliptic_integrals", &[function], &lines.concat());
            for (best, time) in best[1..].iter_mut().zip(times) {
                *best = best.min(time);
            }
        }
        let [ours, boost, gsl] = best;
        println!(
            "{function:>4} {name:>14} {ours:>8.1} {boost:>8.1} {:>7.3} {gsl:>8.1} {:>7.3}",
            ours / boost,
            ours / gsl
        );
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
                    let both = [parameter.m(), parameter.mc()];
                    for (i, &u) in arguments.iter().enumerate() {
                        let [m, mc] = black_box(both);
                        (sn[i], cn[i], dn[i]) = sn_cn_dn(u, Parameter::new(m, mc)?)?;
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
    let mut input = String::new();
    for (parameter, arguments) in groups {
        for u in arguments {
            input.push_str(&format!("{u:e} {:e}\n", parameter.m()));
        }
    }
    told("elliptic_gsl", &[], &input).first().copied()
}

/// The numbers a peer tells for an input; none if it was not built.
fn told(program: &str, arguments: &[&str], input: &str) -> Vec<f64> {
    let run = || {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/peers");
        let mut child = Command::new(folder.join(program))
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .ok()?;
        child.stdin.take()?.write_all(input.as_bytes()).ok()?;
        String::from_utf8(child.wait_with_output().ok()?.stdout).ok()
    };
    let text = run().unwrap_or_default();
    text.split_whitespace().flat_map(str::parse).collect()
}
