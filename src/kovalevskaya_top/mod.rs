//! Kovalevskaya's top (tutorial 8).
mod constants;
mod separation;
mod series;
mod solution;
mod taylor;

#[cfg(test)]
mod trial {
    use super::constants::*;
    use super::separation::*;
    use super::solution::*;
    use super::taylor::*;

    struct Rng(u64);
    impl Rng {
        fn next(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    fn find(c: &Constants, y: &Phase) -> Option<(Separation, Reconstruction, f64)> {
        let v = Variables::of(c, y);
        let mut sep = Separation::prepare(c, v.s1)?;
        let mut rec = Reconstruction::prepare(c, &sep);
        let f = sep.first_phases(&v, c.l1.value());
        let mut best = (f64::INFINITY, f, [1.0; 3]);
        for n in 0..32 {
            let sg = |b: u32| if n >> b & 1 == 0 { 1.0 } else { -1.0 };
            rec.signs = [sg(0), sg(1), sg(2)];
            let g = [f[0] * sg(3), f[1] * sg(4)];
            let x = rec.state(c, &sep, g);
            let e: f64 = (0..6).map(|i| (x[i] - y[i]).powi(2)).sum(); 
            if e < best.0 { best = (e, g, rec.signs); }
        }
        rec.signs = best.2;
        let mut f = best.1;
        let first = best.0.sqrt();
        for _ in 0..3 {
            let h = 1e-4;
            let x = rec.state(c, &sep, f);
            let d: Vec<[f64; 6]> = (0..2).map(|i| {
                let mut a = f; a[i] += h; let mut b = f; b[i] -= h;
                let (a, b) = (rec.state(c, &sep, a), rec.state(c, &sep, b));
                core::array::from_fn(|i| (a[i] - b[i]) / (2.0 * h))
            }).collect();
            let m = nalgebra::SMatrix::<f64, 6, 2>::from_fn(|i, j| d[j][i]);
            let e = nalgebra::SVector::<f64, 6>::from_fn(|i, _| y[i] - x[i]);
            let n = m.transpose() * m;
            if let Some(s) = n.cholesky() { let s = s.solve(&(m.transpose() * e)); f[0] += s[0]; f[1] += s[1]; }
        }
        let x = rec.state(c, &sep, f);
        let after = (0..6).map(|i| (x[i] - y[i]).powi(2)).sum::<f64>().sqrt();
        sep.origin = sep.abel(f);
        if std::env::var("V").is_ok() { println!("  start {first:e} {after:e}"); }
        Some((sep, rec, after))
    }

    #[test]
    fn reference_case() {
        for y in [[1.0, 0.5, 0.3, 0.6, 0.0, 0.8], [0.8, 0.4, 0.0, 0.5, -0.8, 0.331662]] {
            let c = Constants::of(1.0, &y);
            println!("{:?} {:?} {:?}", c.l1.value(), c.l.value(), c.k.value());
            let Some((s, _, e)) = find(&c, &y) else { panic!() };
            println!("{:?}", s.roots.map(|r| r.value()));
            println!("{:?} {:?} {e:e}", s.periods(), s.frequencies());
        }
    }

    #[test]
    fn many() {
        let mut g = Rng(0x9E3779B97F4A7C15);
        let mut errors = vec![];
        for n in 0..1000 {
            let mut z = [0.0; 3];
            loop {
                z = [0; 3].map(|_| 2.0 * g.next() - 1.0);
                let s: f64 = z.iter().map(|x| x * x).sum();
                if s < 1.0 && s > 0.01 { z = z.map(|x| x / s.sqrt()); break; }
            }
            let o = [0; 3].map(|_| 3.0 * g.next() - 1.5);
            let y = [o[0], o[1], o[2], z[0], z[1], z[2]];
            let c = Constants::of(1.0, &y);
            let Some((sep, rec, e0)) = find(&c, &y) else { println!("{n} not found {y:?}"); continue };
            let mut now = (y, [1.0, 0.0, 0.0, 0.0]);
            let mut t = 0.0;
            let mut worst = 0.0f64; let mut raw = 0.0f64;
            for stop in [1.3, 4.7, 10.0, 20.0] {
                while t < stop {
                    let s = Series::at(1.0, &now);
                    let h = s.reach.min(stop - t);
                    now = s.after(h);
                    t += h;
                }
                let f = sep.at(stop);
                let x = rec.state(&c, &sep, f);
                let x2 = project(&c, &x);
                for i in 0..6 { raw = raw.max((x[i] - now.0[i]).abs()); worst = worst.max((x2[i] - now.0[i]).abs()); }
            }
            if worst > 1e-11 { println!("{n} raw {raw:e} proj {worst:e} start {e0:e} {:?} roots {:?}", sep.ends, sep.roots.map(|r| r.value()).map(|r| (r.re as f32, r.im as f32))); }
            errors.push(worst);
        }
        errors.sort_by(f64::total_cmp);
        let n = errors.len();
        println!("n {n} median {:e} 95% {:e} 99% {:e} 99.5 {:e} max {:e}", errors[n / 2], errors[n * 95 / 100], errors[n * 99 / 100], errors[n * 995 / 1000], errors[n - 1]);
    }
}
