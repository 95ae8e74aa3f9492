//! Inertia: time and error of the mesh integral and of the principal axes, beside the peers, in one run.
//!
//! `cargo bench -p lab --bench inertia`. Errors are against 106-bit arithmetic on the very numbers given. Times
//! are the least of several runs, ours and the peer's in turn.
//!
//! One run on two cores of an AMD EPYC server, Rust 1.95:
//!
//! | task | ours | peer | ratio of times |
//! |---|---|---|---|
//! | mesh of 1.3 million triangles at the origin | 13 ns a triangle, inertia to 2e-15 | parry3d-f64: 69 ns, 4e-14 | 0.19 |
//! | the same, a million radii away | 24 ns, inertia to 8e-16 | parry3d-f64: 67 ns, 4e-14 | 0.36 |
//! | principal axes, matrices at random | 150 ns, moments to 3e-16 | nalgebra: 960 ns, 2e-15 | 0.16 |
//! | principal axes, gaps of 1e-6 to 1e-14 | 151 ns, moments to 3e-16 | nalgebra: 603 ns, 2e-15 | 0.25 |

use std::hint::black_box;
use std::time::Instant;

use nalgebra::Matrix3;
use parry3d_f64::mass_properties::MassProperties as Parry;
use shared::only_tested;
use spinning_bodies::inertia::{InertiaMatrix, icosphere, mesh_mass_properties, principal_axes_of};
use support::Uniform;

mod shared;
use support::double_double::{Dd, eigenvalues, inertia_error, mesh_truth};

fn main() -> spinning_bodies::Result<()> {
    if only_tested() {
        return Ok(());
    }
    meshes()?;
    axes()
}

/// Least time of `runs` calls, seconds, and the last result.
fn least<T>(runs: usize, mut work: impl FnMut() -> T) -> (f64, T) {
    let mut best = f64::INFINITY;
    let mut result = None;
    for _ in 0..runs {
        let start = Instant::now();
        let value = black_box(work());
        best = best.min(start.elapsed().as_secs_f64());
        result = Some(value);
    }
    (best, result.expect("at least one run"))
}

fn meshes() -> spinning_bodies::Result<()> {
    println!("mesh inertia, icosphere of radius 1");
    println!(
        "{:>9} {:>8} {:>12} {:>12} {:>6} {:>14} {:>14} {:>14}",
        "triangles",
        "offset",
        "ours ns/tri",
        "parry",
        "ratio",
        "ours: inertia",
        "ours: centre",
        "parry: inertia"
    );
    for levels in [4, 6, 8] {
        for offset in [0.0, 1e6] {
            let (mut vertices, triangles) = icosphere(levels, 1.0)?;
            for vertex in &mut vertices {
                *vertex = [
                    vertex[0] + offset,
                    vertex[1] - 0.7 * offset,
                    vertex[2] + offset / 3.0,
                ];
            }
            let truth = mesh_truth(&vertices, &triangles);
            let count = triangles.len() as f64;
            let points: Vec<parry3d_f64::math::Vector> = vertices
                .iter()
                .map(|v| parry3d_f64::math::Vector::new(v[0], v[1], v[2]))
                .collect();
            let runs = if levels == 8 { 5 } else { 20 };
            let (mut ours, mut theirs) = (f64::INFINITY, f64::INFINITY);
            let mut results = None;
            for _ in 0..3 {
                let (time, body) = least(runs, || {
                    mesh_mass_properties(black_box(&vertices), black_box(&triangles), 1.0)
                });
                ours = ours.min(time);
                let (time, parry) = least(runs, || {
                    Parry::from_trimesh(1.0, black_box(&points), black_box(&triangles))
                });
                theirs = theirs.min(time);
                results = Some((body?, parry));
            }
            let (body, parry) = results.expect("three rounds");
            let matrix = body.inertia().matrix();
            let error = inertia_error(&truth, |i, j| matrix[(i, j)]);
            let peer = parry.reconstruct_inertia_matrix();
            let column = [peer.x_axis, peer.y_axis, peer.z_axis];
            let peer_error = inertia_error(&truth, |i, j| {
                let c = column[j];
                [c.x, c.y, c.z][i]
            });
            let center = body.center().components();
            let center_error = (0..3).fold(0.0, |m: f64, i| {
                let exact = truth.center_from_first_vertex[i] + Dd::from(vertices[0][i]);
                m.max((Dd::from(center[i]) - exact).value().abs())
            });
            println!(
                "{:>9} {:>8.0e} {:>12.2} {:>12.2} {:>6.3} {:>14.1e} {:>14.1e} {:>14.1e}",
                triangles.len(),
                offset,
                1e9 * ours / count,
                1e9 * theirs / count,
                ours / theirs,
                error,
                center_error,
                peer_error
            );
        }
    }
    Ok(())
}

fn axes() -> spinning_bodies::Result<()> {
    println!("\nprincipal axes, 20 000 inertia matrices of a kind");
    println!(
        "{:>22} {:>8} {:>9} {:>6} {:>13} {:>13} {:>13} {:>13}",
        "kind",
        "ours ns",
        "nalgebra",
        "ratio",
        "ours: moment",
        "nalgebra",
        "ours: VtV-1",
        "nalgebra"
    );
    let mut uniform = Uniform(2);
    type Moments<'a> = &'a dyn Fn(&mut Uniform) -> [f64; 3];
    let kinds: [(&str, Moments); 5] = [
        ("generic", &|u| {
            let s = [u.next(), u.next(), u.next()];
            [s[1] + s[2], s[2] + s[0], s[0] + s[1]]
        }),
        ("gap 1e-6..1e-14", &|u| {
            let gap = 10_f64.powf(-6.0 - 8.0 * u.next());
            [1.0, 1.0 + gap, 1.3 + 0.5 * u.next()]
        }),
        ("all near", &|u| {
            let gap = 10_f64.powf(-6.0 - 8.0 * u.next());
            [1.0, 1.0 + gap * u.next(), 1.0 + gap]
        }),
        ("needle (1e-15, 1, 1)", &|_| [1e-15, 1.0, 1.0]),
        ("diagonal", &|u| [1.0, 1.0 + u.next() / 2.0, 1.5]),
    ];
    for (name, moments) in kinds {
        let bodies: Vec<InertiaMatrix> = (0..20_000)
            .map(|_| -> spinning_bodies::Result<_> {
                let [a, b, c] = moments(&mut uniform);
                let body = InertiaMatrix::diagonal(a, b, c)?;
                if name == "diagonal" {
                    return Ok(body);
                }
                let [w, x, y, z] = [0; 4].map(|_| uniform.next() - 0.5);
                let turn = spinning_bodies::frame::Attitude::from_quaternion(w, x, y, z)?;
                Ok(body.rotated(&turn))
            })
            .collect::<Result<_, _>>()?;
        let matrices: Vec<Matrix3<f64>> = bodies.iter().map(InertiaMatrix::matrix).collect();
        let (mut ours, mut theirs) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..5 {
            let (time, _) = least(3, || {
                for body in &bodies {
                    black_box(black_box(body).principal_axes());
                }
            });
            ours = ours.min(time);
            let (time, _) = least(3, || {
                for matrix in &matrices {
                    black_box(black_box(*matrix).symmetric_eigen());
                }
            });
            theirs = theirs.min(time);
        }
        let mut worst = [0.0_f64; 4];
        for matrix in &matrices {
            let exact = eigenvalues((*matrix).transpose().into());
            let largest = exact[2].hi;
            let error = |values: [f64; 3]| {
                values
                    .into_iter()
                    .zip(exact)
                    .fold(0.0, |m: f64, (value, exact)| {
                        m.max((Dd::from(value) - exact).value().abs() / largest)
                    })
            };
            let skew = |v: &Matrix3<f64>| (v.transpose() * v - Matrix3::identity()).amax();
            let mine = principal_axes_of(matrix)?;
            let peer = matrix.symmetric_eigen();
            let mut values: [f64; 3] = peer.eigenvalues.into();
            values.sort_by(f64::total_cmp);
            let found = [
                error(mine.moments),
                error(values),
                skew(&mine.axes),
                skew(&peer.eigenvectors),
            ];
            for (worst, found) in worst.iter_mut().zip(found) {
                *worst = worst.max(found);
            }
        }
        let count = matrices.len() as f64;
        println!(
            "{:>22} {:>8.1} {:>9.1} {:>6.3} {:>13.2e} {:>13.2e} {:>13.2e} {:>13.2e}",
            name,
            1e9 * ours / count,
            1e9 * theirs / count,
            ours / theirs,
            worst[0],
            worst[1],
            worst[2],
            worst[3]
        );
    }
    Ok(())
}
