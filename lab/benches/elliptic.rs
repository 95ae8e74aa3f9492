//! Jacobi functions: time beside GSL's, complete integrals beside K, and incomplete integrals beside those of Boost in long double and of GSL, in one run.
//!
//! `lab/peers/build.sh && cargo bench -p lab --bench elliptic`. Without the first step the peer's columns are
//! empty. Each time is the least of many runs over the same arguments, ours and the peer's in turn.

mod shared;

use std::hint::black_box;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use lab::stopwatch::{in_turn, least};
use shared::{head, numbers, only_tested};
use spinning_bodies::Result;
use spinning_bodies::elliptic::{
    Characteristic, Modulus, Parameter, complete_b, complete_d, complete_first,
    complete_first_excess, complete_second, complete_third, incomplete_first, incomplete_second,
    incomplete_third, rc, rd, rf, rg, rj, sn_cn_dn,
};
use support::Uniform;

/// Arguments for each modulus, and moduli in a set.
const ARGUMENTS: usize = 1024;
const MODULI: usize = 8;

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    let columns = ["GSL", "prepared", "and am", "from scratch"];
    head(
        "sn, cn, dn; ns each; from scratch the parameter is made from m and mc within the clock",
        &columns,
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
    complete(&mut uniform)?;
    integrals(&mut uniform)
}

/// Complete integrals in units of the time of K, all in one run.
fn complete(uniform: &mut Uniform) -> Result<()> {
    let columns = ["K, ns", "E/K", "D/K", "B/K", "(K - pi/2)/K", "Pi/K"];
    head("complete integrals; 0 < n < 1", &columns);
    type Draw = fn(f64) -> Result<Characteristic>;
    type Set = (&'static str, fn(f64) -> f64, Draw);
    let of_m: Draw = |m| Ok(Parameter::from_parameter(m)?.into());
    let of_mc: Draw = |mc| Ok(Parameter::from_complement(mc)?.into());
    let sets: [Set; 8] = [
        ("m random", |x| x, of_m),
        ("m < 1/2", |x| 0.5 * x, of_m),
        ("mc < 1/2", |x| 0.5 * x, of_mc),
        ("mc 1e-1...1e-15", |x| 10_f64.powf(-1.0 - 14.0 * x), of_mc),
        ("mc 1e-1...1e-300", |x| 10_f64.powf(-1.0 - 299.0 * x), of_mc),
        ("m 1e-1...1e-7", |x| 10_f64.powf(-1.0 - 6.0 * x), of_m),
        ("m 1e-8...1e-20", |x| 10_f64.powf(-8.0 - 12.0 * x), of_m),
        (
            "-m 1e-3...1e6",
            |x| -(10_f64.powf(9.0 * x - 3.0)),
            |m| Characteristic::from_characteristic(m),
        ),
    ];
    for (name, scale, draw) in sets {
        let pair = |_| {
            let n = Characteristic::from_characteristic(uniform.next())?;
            Ok((n, draw(scale(uniform.next()))?))
        };
        let rows = (0..ARGUMENTS).map(pair).collect::<Result<Vec<_>>>()?;
        let seconds = in_turn([
            &mut over(&rows, |_, m| complete_first(m)),
            &mut over(&rows, |_, m| complete_second(m)),
            &mut over(&rows, |_, m| complete_d(m)),
            &mut over(&rows, |_, m| complete_b(m)),
            &mut over(&rows, |_, m| complete_first_excess(m)),
            &mut over(&rows, complete_third),
        ]);
        let mut cells = seconds.map(|time| time / seconds[0]);
        cells[0] = 1e9 * seconds[0] / ARGUMENTS as f64;
        numbers(name, &cells);
    }
    Ok(())
}

/// Calls a complete integral for each pair of n and m.
fn over(
    rows: &[(Characteristic, Characteristic)],
    integral: impl Fn(Characteristic, Characteristic) -> Result<f64>,
) -> impl FnMut() {
    move || {
        for row in rows {
            let (n, m) = black_box(*row);
            let _ = black_box(integral(n, m));
        }
    }
}

/// A function of the peer, what its arguments are, how they are drawn, and the same of ours.
type Integral = (
    &'static str,
    &'static str,
    fn(&mut Uniform) -> [f64; 4],
    fn(&[f64; 4]) -> Result<f64>,
);

const INTEGRALS: [Integral; 13] = [
    ("F", "phi < pi/2", angle, first),
    ("F", "|phi| < 100", long_angle, first),
    ("E", "phi < pi/2", angle, |[phi, m, ..]| {
        incomplete_second(*phi, Parameter::from_parameter(*m)?)
    }),
    ("Pi", "0 < n < 1", angle, third),
    ("Pi", "-1 < n < 0", negative_angle, third),
    ("RF", "0 to 1", four, |[x, y, z, _]| rf(*x, *y, *z)),
    ("RF", "1e-20 to 1e20", wide, |[x, y, z, _]| rf(*x, *y, *z)),
    ("RF", "1e-300 to 1e300", anywhere, |[x, y, z, _]| {
        rf(*x, *y, *z)
    }),
    ("RC", "0 to 1", four, |[x, y, ..]| rc(*x, *y)),
    ("RD", "0 to 1", four, |[x, y, z, _]| rd(*x, *y, *z)),
    ("RJ", "0 to 1", four, |[x, y, z, p]| rj(*x, *y, *z, *p)),
    ("RJ", "1e-20 to 1e20", wide, |[x, y, z, p]| {
        rj(*x, *y, *z, *p)
    }),
    ("RG", "0 to 1", four, |[x, y, z, _]| rg(*x, *y, *z)),
];

fn four(u: &mut Uniform) -> [f64; 4] {
    [(); 4].map(|()| u.next())
}

fn wide(u: &mut Uniform) -> [f64; 4] {
    four(u).map(|x| 10_f64.powf(40.0 * x - 20.0))
}

fn anywhere(u: &mut Uniform) -> [f64; 4] {
    four(u).map(|x| 10_f64.powf(600.0 * x - 300.0))
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
    let columns = [
        "ours",
        "Boost, 64 bits",
        "ours/Boost",
        "GSL, 53 bits",
        "ours/GSL",
    ];
    head("integrals; ns each", &columns);
    for (function, name, draw, ours) in INTEGRALS {
        let rows: Vec<[f64; 4]> = (0..ARGUMENTS).map(|_| draw(uniform)).collect();
        let lines = rows
            .iter()
            .map(|[a, b, c, d]| format!("{a:e} {b:e} {c:e} {d:e}\n"));
        let lines: String = lines.collect();
        let mut best = [f64::NAN; 3];
        for _ in 0..5 {
            let seconds = least(|| {
                rows.iter()
                    .for_each(|row| drop(black_box(ours(black_box(row)))))
            });
            let peers = told("elliptic_integrals", &[function], &lines);
            let times = [1e9 * seconds / ARGUMENTS as f64].into_iter().chain(peers);
            for (best, time) in best.iter_mut().zip(times) {
                *best = best.min(time);
            }
        }
        let [ours, boost, gsl] = best;
        numbers(
            &format!("{function}, {name}"),
            &[ours, boost, ours / boost, gsl, ours / gsl],
        );
    }
    Ok(())
}

type Group = (Parameter, Vec<f64>);

fn measure(name: &str, groups: &[Group]) -> Result<()> {
    let moduli: Vec<Modulus> = groups.iter().map(|(p, _)| Modulus::new(*p)).collect();
    let seconds = in_turn([
        &mut filled(&moduli, groups, |modulus, _, u| modulus.sn_cn_dn(u)),
        &mut filled(&moduli, groups, |modulus, _, u| modulus.jacobi(u)),
        &mut filled(&moduli, groups, |_, [m, mc], u| {
            sn_cn_dn(u, Parameter::new(m, mc)?)
        }),
    ]);
    let [prepared, with_am, scratch] =
        seconds.map(|seconds| 1e9 * seconds / (ARGUMENTS * MODULI) as f64);
    let peers = (0..5).filter_map(|_| peer(groups));
    let gsl = peers.reduce(f64::min).unwrap_or(f64::NAN);
    numbers(name, &[gsl, prepared, with_am, scratch]);
    Ok(())
}

/// All values of all groups, one after the other into a list, as the peer does it.
fn filled<T: Clone>(
    moduli: &[Modulus],
    groups: &[Group],
    value: impl Fn(&Modulus, [f64; 2], f64) -> Result<T>,
) -> impl FnMut() {
    let mut list = vec![None; ARGUMENTS];
    move || {
        for (modulus, (parameter, arguments)) in moduli.iter().zip(groups) {
            let both = [parameter.m(), parameter.mc()];
            for (place, &u) in list.iter_mut().zip(arguments) {
                *place = value(modulus, black_box(both), u).ok();
            }
            black_box(&list);
        }
    }
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
