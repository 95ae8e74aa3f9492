//! Inertia: time and error of the mesh integral and of the principal axes, beside the peers, in one run.
//!
//! `cargo bench -p lab --bench inertia`. Errors are against 106-bit arithmetic on the very numbers given. Times
//! are the least of several runs, ours and the peer's in turn.
//!
//! One run on two cores of an Intel Xeon server, Rust 1.95:
//!
//! | task | ours | peer | ratio of times |
//! |---|---|---|---|
//! | mesh of 1.3 million triangles at the origin | 11 ns a triangle, inertia to 2e-15 | parry3d-f64: 34 ns, 4e-14 | 0.32 |
//! | the same, a million radii away | 12 ns, inertia to 8e-16 | parry3d-f64: 34 ns, 4e-14 | 0.34 |
//! | principal axes, matrices at random | 98 ns, moments to 3e-16 | nalgebra: 323 ns, 2e-15 | 0.31 |
//! | principal axes, gaps of 1e-6 to 1e-14 | 93 ns, moments to 3e-16 | nalgebra: 234 ns, 2e-15 | 0.40 |

mod shared;

use std::hint::black_box;

use lab::stopwatch::in_turn;
use nalgebra::Matrix3;
use parry3d_f64::mass_properties::MassProperties as Parry;
use parry3d_f64::math::Vector;
use shared::{head, numbers, only_tested};
use spinning_bodies::Result;
use spinning_bodies::inertia::{InertiaMatrix, icosphere, mesh_mass_properties, principal_axes_of};
use support::double_double::{eigenvalues, inertia_error, mesh_truth};
use support::{Uniform, greatest};

fn main() -> Result<()> {
    if only_tested() {
        return Ok(());
    }
    meshes()?;
    axes()
}

fn meshes() -> Result<()> {
    let columns = [
        "ours, ns each",
        "parry",
        "ratio",
        "ours: inertia",
        "ours: centre",
        "parry: inertia",
    ];
    head(
        "mesh inertia, icosphere of radius 1: ns a triangle, and errors",
        &columns,
    );
    for levels in [4, 6, 8] {
        for offset in [0.0, 1e6] {
            let (mut vertices, triangles) = icosphere(levels, 1.0)?;
            for v in &mut vertices {
                *v = [v[0] + offset, v[1] - 0.7 * offset, v[2] + offset / 3.0];
            }
            let truth = mesh_truth(&vertices, &triangles);
            let points: Vec<Vector> = vertices
                .iter()
                .map(|v| Vector::new(v[0], v[1], v[2]))
                .collect();
            let own = || mesh_mass_properties(black_box(&vertices), black_box(&triangles), 1.0);
            let peer = || Parry::from_trimesh(1.0, black_box(&points), black_box(&triangles));
            let seconds = in_turn([&mut || drop(black_box(own())), &mut || {
                black_box(peer());
            }]);
            let [ours, theirs] = seconds.map(|seconds| 1e9 * seconds / triangles.len() as f64);
            let (body, parry) = (own()?, peer().reconstruct_inertia_matrix());
            let matrix = body.inertia().matrix();
            let error = inertia_error(&truth, |i, j| matrix[(i, j)]);
            let columns = [parry.x_axis, parry.y_axis, parry.z_axis].map(|c| [c.x, c.y, c.z]);
            let parry_error = inertia_error(&truth, |i, j| columns[j][i]);
            let center = body.center().components();
            let off = |i: usize| {
                (center[i] - (truth.center_from_first_vertex[i] + vertices[0][i]))
                    .value()
                    .abs()
            };
            let center_error = greatest((0..3).map(off));
            let name = format!("{} triangles, {offset:e} away", triangles.len());
            numbers(
                &name,
                &[
                    ours,
                    theirs,
                    ours / theirs,
                    error,
                    center_error,
                    parry_error,
                ],
            );
        }
    }
    Ok(())
}

fn axes() -> Result<()> {
    let columns = [
        "ours, ns",
        "nalgebra",
        "ratio",
        "ours: moment",
        "nalgebra",
        "ours: VtV-1",
        "nalgebra",
    ];
    head(
        "principal axes, 20 000 inertia matrices of a kind",
        &columns,
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
        let bodies = (0..20_000).map(|_| {
            let [a, b, c] = moments(&mut uniform);
            let (body, turn) = (InertiaMatrix::diagonal(a, b, c)?, uniform.attitude());
            Ok(if name == "diagonal" {
                body
            } else {
                body.rotated(&turn)
            })
        });
        let bodies: Vec<InertiaMatrix> = bodies.collect::<Result<_>>()?;
        let matrices: Vec<Matrix3<f64>> = bodies.iter().map(InertiaMatrix::matrix).collect();
        let seconds = in_turn([
            &mut || {
                for body in &bodies {
                    black_box(black_box(body).principal_axes());
                }
            },
            &mut || {
                for matrix in &matrices {
                    black_box(black_box(*matrix).symmetric_eigen());
                }
            },
        ]);
        let [ours, theirs] = seconds.map(|seconds| 1e9 * seconds / matrices.len() as f64);
        let mut worst = [0.0_f64; 4];
        for matrix in &matrices {
            let exact = eigenvalues((*matrix).into());
            let error = |values: [f64; 3]| {
                let off = (0..3).map(|k| (values[k] - exact[k]).value().abs());
                greatest(off) / exact[2].hi
            };
            let skew = |v: &Matrix3<f64>| (v.transpose() * v - Matrix3::identity()).amax();
            let (own, peer) = (principal_axes_of(matrix)?, matrix.symmetric_eigen());
            let mut values: [f64; 3] = peer.eigenvalues.into();
            values.sort_by(f64::total_cmp);
            let found = [
                error(own.moments),
                error(values),
                skew(&own.axes),
                skew(&peer.eigenvectors),
            ];
            worst = core::array::from_fn(|k| worst[k].max(found[k]));
        }
        let [a, b, c, d] = worst;
        numbers(name, &[ours, theirs, ours / theirs, a, b, c, d]);
    }
    Ok(())
}
