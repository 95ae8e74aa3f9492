//! Benchmarks only: see `benches/`. Each prints tables of time and error, ours and the peers' in one run.
//!
//! | `cargo bench -p bench --bench …` | what | beside |
//! |---|---|---|
//! | `inertia` | mesh integrals, principal axes | parry3d, nalgebra |
//! | `elliptic` | sn, cn, dn | GSL, if `bench/peers/build.sh` was run |
//! | `elliptic_accuracy` | errors of the elliptic integrals | ellip |
//! | `euler_top` | one state of a free top | Runge–Kutta, power series; GSL and Boost.Math on request |
//! | `lagrange_top` | one state of Lagrange's top | Runge–Kutta, DOP853, rapier3d |
//! | `integrators` | one step of each geometric method, and 10⁷ of them | Runge–Kutta, DOP853 |
//! | `kovalevskaya_top` | one state of Kovalevskaya's top | Runge–Kutta, DOP853 |
