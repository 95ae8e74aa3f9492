//! 5.2: the ideal fluid as a top.

use super::*;
use nalgebra::DMatrix;

/// The wave vectors of all modes.
fn waves(size: usize) -> Vec<[i32; 2]> {
    let half = (size as i32 - 1) / 2;
    (-half..=half)
        .flat_map(|a| (-half..=half).map(move |b| [a, b]))
        .filter(|&m| m != [0, 0])
        .collect()
}

#[test]
fn the_least_wave_vector_has_its_mirror_image() -> Result<()> {
    let wave = |m| TruncatedFluid::new(5, &[([m, 0], Complex::new(1.0, 2.0))]);
    assert_eq!(wave(i32::MIN)?, wave(2)?);
    Ok(())
}

#[test]
fn s5_2_the_matrix_is_the_sine_bracket() {
    // RK4 on the bracket, term by term, against the steps of the matrix: order 2, and the same motion.
    for size in [3, 5] {
        let start = fluid(size);
        let waves = waves(size);
        let combine = |f: &TruncatedFluid, k: &TruncatedFluid, h: f64| {
            let mode = |&m: &[i32; 2]| (m, f.vorticity(m) + k.vorticity(m) * h);
            let modes: Vec<_> = waves.iter().map(mode).collect();
            TruncatedFluid::new(size, &modes).unwrap()
        };
        let mut truth = start.clone();
        let h = 0.005;
        for _ in 0..200 {
            let k1 = truth.rate();
            let k2 = combine(&truth, &k1, h / 2.0).rate();
            let k3 = combine(&truth, &k2, h / 2.0).rate();
            let k4 = combine(&truth, &k3, h).rate();
            for (k, w) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
                truth = combine(&truth, &k, w * h / 6.0);
            }
        }
        let error = |steps: u32| {
            let mut now = start.clone();
            for _ in 0..steps {
                now.advance(1.0 / f64::from(steps)).unwrap();
            }
            let apart = |&m: &[i32; 2]| (now.vorticity(m) - truth.vorticity(m)).norm_sqr();
            waves.iter().map(apart).sum::<f64>().sqrt()
        };
        let (coarse, fine) = (error(50), error(100));
        assert!((3.9..4.1).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
        observed!(fine, 1e-6..=4e-5);
        // Back in time, to rounding.
        let mut back = start.clone();
        for h in [0.05; 20].into_iter().chain([-0.05; 20]) {
            back.advance(h).unwrap();
        }
        let off = (back.vorticity([1, 1]) - start.vorticity([1, 1])).norm();
        observed!(off, 0.0..=9e-16);
    }
}

#[test]
fn s5_2_any_step_keeps_the_invariants() {
    // A turn by a radian and more a step is no longer accurate, and keeps what it must all the same. (A vorticity that
    // is real but for rounding is not good enough: its imaginary part grew, and after forty steps of 1 the energy was off
    // by 6e-10.) Observed 8e-14 at most.
    let mut worst: f64 = 0.0;
    for (size, step, count) in [(3, 0.5, 400), (5, 0.5, 400), (5, 1.0, 400), (7, 0.25, 100)] {
        let start = fluid(size);
        let mut now = start.clone();
        for _ in 0..count {
            now.advance(step).unwrap();
        }
        let squares = waves(size)
            .into_iter()
            .map(|m| start.vorticity(m).norm_sqr());
        let enstrophy: f64 = squares.sum();
        let mut same = |a: f64, b: f64| worst = worst.max((a - b).abs() / b.abs().max(1.0));
        same(now.energy(), start.energy());
        for p in 2..=size as u32 {
            let trace = |f: &TruncatedFluid| f.trace_of_power(p, SquareRoot::OfUnity);
            same(trace(&now), trace(&start));
        }
        // The quadratic one is the enstrophy, whichever the square root.
        for root in [SquareRoot::OfUnity, SquareRoot::Opposite] {
            same(now.trace_of_power(2, root), enstrophy);
        }
    }
    observed!(worst, 3e-14..=3e-13);
}

#[test]
fn s5_2_towards_the_ideal_fluid() {
    // The sine bracket against Fourier's own, Σ (m∧n)/|n|² ω_n ω_{m−n}: the difference falls as 1/N².
    let difference = |size: usize| {
        let start = fluid(size);
        let told = start.rate();
        let mut worst: f64 = 0.0;
        for m in (-2..=2).flat_map(|a| (-2..=2).map(move |b| [a, b])) {
            let ideal: Complex<f64> = waves(3)
                .into_iter()
                .filter(|n| (0..2).all(|k| i32::abs(m[k] - n[k]) <= 1))
                .map(|n: [i32; 2]| {
                    let wedge = f64::from(m[0] * n[1] - m[1] * n[0]);
                    let length = f64::from(n[0] * n[0] + n[1] * n[1]);
                    start.vorticity(n)
                        * start.vorticity([m[0] - n[0], m[1] - n[1]])
                        * (wedge / length)
                })
                .sum();
            worst = worst.max((told.vorticity(m) - ideal).norm());
        }
        worst
    };
    let (coarse, fine) = (difference(9), difference(27));
    assert!((8.0..10.0).contains(&(coarse / fine)));
    assert!(fine < 0.05, "{fine:e}");
}

#[test]
fn s5_2_tops_in_more_dimensions() {
    // dM/dt = [M, Ω], M = JΩ + ΩJ: in three dimensions Euler's top with I_i = J_j + J_k; in any, spectrum of M + λJ² kept.
    for n in [3_usize, 4, 5] {
        let j: Vec<f64> = (0..n).map(|k| 1.0 + 0.5 * k as f64).collect();
        let mut omega = DMatrix::<f64>::zeros(n, n);
        for a in 0..n {
            for b in a + 1..n {
                let value = ((3 * a + 5 * b) as f64).sin();
                (omega[(a, b)], omega[(b, a)]) = (value, -value);
            }
        }
        let weight = |m: &DMatrix<f64>, back: bool| {
            DMatrix::from_fn(n, n, |a, b| {
                let sum = j[a] + j[b];
                if back {
                    m[(a, b)] / sum
                } else {
                    m[(a, b)] * sum
                }
            })
        };
        let rate_of = |m: &DMatrix<f64>| {
            let omega = weight(m, true);
            m * &omega - omega * m
        };
        let mut m = weight(&omega, false);
        if n == 3 {
            let vector = |m: &DMatrix<f64>| vector([m[(2, 1)], m[(0, 2)], m[(1, 0)]]);
            let top = moments([j[1] + j[2], j[2] + j[0], j[0] + j[1]]);
            let ours = rate(&top, vector(&omega), BodyVector::zero());
            let theirs = vector(&weight(&rate_of(&m), true));
            observed!((ours - theirs).norm(), 0.0..=3e-16);
        }
        let squares = nalgebra::DVector::from_iterator(n, j.iter().map(|j| j * j));
        let j_squared = DMatrix::from_diagonal(&squares);
        let traces = |m: &DMatrix<f64>| -> Vec<f64> {
            let shifted = m + &j_squared * 0.7;
            let mut power = shifted.clone();
            (1..n)
                .map(|_| {
                    power *= &shifted;
                    power.trace()
                })
                .collect()
        };
        let (before, h) = (traces(&m), 0.002);
        for _ in 0..2500 {
            let k1 = rate_of(&m);
            let k2 = rate_of(&(&m + &k1 * (h / 2.0)));
            let k3 = rate_of(&(&m + &k2 * (h / 2.0)));
            let k4 = rate_of(&(&m + &k3 * h));
            m += (k1 + (k2 + k3) * 2.0 + k4) * (h / 6.0);
        }
        for (a, b) in traces(&m).into_iter().zip(before) {
            close!(a, b, 2e-13..=5e-12);
        }
    }
}
