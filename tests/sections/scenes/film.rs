//! What a scene looks like is what its numbers tell: inertia, places, turns and floors, from the solids that are drawn.

use super::*;
use nalgebra::{Isometry3, UnitQuaternion};
use spinning_bodies::scene::files::parse;
use spinning_bodies::scene::{Around, Sight, Solid, Table};
use std::fs;

pub(super) fn file_of_the_book(name: &str) -> String {
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../book/scenes");
    fs::read_to_string(format!("{scenes}/{name}")).unwrap()
}

/// A scene at these times, all that it tells of itself, and what it looks like.
fn seen(name: &str, text: &str, times: &[f64]) -> (Table, Vec<Sight>) {
    let before = text.split("[run]").next().unwrap();
    let text = format!("{before}\n[run]\ntimes = {times:?}\naccuracy = 1e-9\n");
    let (scene, request) = parse(name, &text).unwrap_or_else(|told| panic!("{told}\n{text}"));
    let names: Vec<_> = scene.columns().iter().map(|column| column.name).collect();
    let scene = scene.telling(&names).unwrap();
    let table = scene.simulate(&request).unwrap();
    let sight = |(_, row): (f64, Vec<f64>)| scene.sight(&table.columns, &row).unwrap();
    let sights = table.rows().map(sight).collect();
    (table, sights)
}

fn number(table: &Table, row: usize, name: &str) -> f64 {
    let place = table.columns.iter().position(|column| column.name == name);
    table.row(row).1[place.unwrap()]
}

/// The means of x and of x xᵀ over a homogeneous solid, from its origin along its own axes. A ring must have some width.
fn means(solid: &Solid) -> (Vector3<f64>, Matrix3<f64>) {
    let centered = |second| (Vector3::zeros(), second);
    match solid {
        Solid::Ellipsoid(half_axes) => centered(half_axes * half_axes.transpose() / 5.0),
        Solid::Cuboid(edges) => centered(Matrix3::from_diagonal(&edges.map(|e| e * e / 12.0))),
        Solid::Bar(to) => (to / 2.0, to * to.transpose() / 3.0),
        Solid::Turned(outline) => {
            let (mut volume, mut first, mut along, mut across) = (0.0, 0.0, 0.0, 0.0);
            for pair in outline.windows(2) {
                // Three points of Gauss and Legendre: exact for a straight edge.
                for (at, weight) in [(-0.6_f64.sqrt(), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)] {
                    let [z, r] = [0, 1].map(|k| {
                        let (from, to) = (pair[0][k], pair[1][k]);
                        from + 0.5 * (1.0 + at) * (to - from)
                    });
                    let slice = weight * (pair[1][0] - pair[0][0]) * r * r;
                    volume += slice;
                    first += slice * z;
                    along += slice * z * z;
                    across += slice * r * r / 4.0;
                }
            }
            let second = Vector3::new(across, across, along) / volume;
            let center = Vector3::z() * (first / volume);
            (center, Matrix3::from_diagonal(&second))
        }
    }
}

/// The inertia of a homogeneous solid of 1 kg about a point of space.
fn inertia((solid, stands): &(Solid, Isometry3<f64>), about: Vector3<f64>) -> Matrix3<f64> {
    let (first, second) = means(solid);
    let turn = stands.rotation.to_rotation_matrix();
    let origin = stands.translation.vector - about;
    let mixed = turn * first * origin.transpose();
    let second = turn * second * turn.transpose();
    let second = second + mixed + mixed.transpose() + origin * origin.transpose();
    Matrix3::identity() * second.trace() - second
}

/// How low a solid reaches.
fn lowest((solid, stands): &(Solid, Isometry3<f64>)) -> f64 {
    // The vertical along the axes of the solid.
    let up = stands.rotation.inverse() * Vector3::z();
    let below = match solid {
        Solid::Ellipsoid(half_axes) => -(half_axes.transpose() * up).norm(),
        Solid::Cuboid(edges) => -0.5 * edges.component_mul(&up.abs()).sum(),
        Solid::Bar(to) => to.dot(&up).min(0.0),
        Solid::Turned(outline) => {
            let level = |&[z, r]: &[f64; 2]| z * up.z - r * up.x.hypot(up.y);
            outline.iter().map(level).fold(f64::INFINITY, f64::min)
        }
    };
    stands.translation.z + below
}

fn lowest_of_all(sight: &Sight) -> f64 {
    let solids = sight.solids.iter().map(lowest);
    solids.fold(f64::INFINITY, f64::min)
}

/// What a scene of the book looks like at these times.
fn in_the_book(name: &str, times: &[f64]) -> Vec<Sight> {
    let file = format!("{name}.toml");
    seen(&file, &file_of_the_book(&file), times).1
}

/// From a little before to a little after, s.
const MOMENT: f64 = 2e-4;

/// A scene of the book a little before a time, then, and a little after.
fn around(name: &str, t: f64) -> [Sight; 3] {
    let times = [t - 0.5 * MOMENT, t, t + 0.5 * MOMENT];
    in_the_book(name, &times).try_into().unwrap()
}

/// Ω by the way in which a solid stands a little before and a little after.
fn turning([before, _, after]: &[Sight; 3], solid: usize) -> Vector3<f64> {
    let turn = |sight: &Sight| sight.solids[solid].1.rotation;
    (turn(after) * turn(before).inverse()).scaled_axis() / MOMENT
}

#[test]
fn a_body_is_drawn_with_the_inertia_that_it_has() {
    let (tip, pivoted) = ("pivot = [0.0, 0.0, 0.0]", "pivot = [0.1, -0.2, 0.05]");
    let center = "center_of_mass = [0.1, -0.05, 0.02]";
    let moments = "moments = [0.3, 0.4, 0.5]";
    let inertia_matrix = "inertia = [0.3, 0.4, 0.5, 0.01, -0.02, 0.03]";
    // Drawn with sixteen levels.
    let cut = "shape = 'ball-without-cap'\nradius = 0.3\ncut = 0.1";
    for (body, held) in [
        ("shape = 'ball'\nradius = 0.3", pivoted),
        ("shape = 'cylinder'\nradius = 0.3\nheight = 0.5", pivoted),
        ("shape = 'cone'\nradius = 0.3\nheight = 0.5", tip),
        ("shape = 'cone'\nradius = 0.3\nheight = 0.5", pivoted),
        ("shape = 'cuboid'\nedges = [0.1, 0.2, 0.4]", pivoted),
        ("shape = 'ellipsoid'\nsemi_axes = [0.1, 0.2, 0.4]", pivoted),
        ("shape = 'egg'\nlong = 0.3\nshort = 0.2", pivoted),
        (cut, pivoted),
        (moments, ""),
        (moments, center),
        (inertia_matrix, ""),
        (inertia_matrix, center),
    ] {
        let tolerance = if body == cut { 0.004 } else { 4e-15 };
        let start =
            "[initial]\nattitude = [0.1, 0.3, -0.5, 0.8062257748298549]\nomega = [1.0, 2.0, -3.0]";
        let weight = ["gravity = 9.81", ""][usize::from(held.is_empty())];
        let text = format!("[body]\nmass = 2.0\n{body}\n{held}\n{start}\n[effects]\n{weight}\n");
        let (_, sights) = seen("mine.toml", &text, &[0.0, 0.4]);
        for sight in sights {
            let mut solids = sight.solids.iter();
            let drawn = solids.find(|(solid, _)| !matches!(solid, Solid::Bar(_)));
            let expected = inertia(drawn.unwrap(), Vector3::zeros()) * sight.omega * 2.0;
            let off = (sight.angular_momentum.unwrap() - expected).norm() / expected.norm();
            assert!(off < tolerance, "{body} {held}: {off}");
            assert_eq!(sight.drawn_as == "its shape", body.starts_with("shape"));
            assert_eq!(sight.around, Around::Pivot);
            assert_eq!(sight.place, Vector3::zeros());
        }
    }
}

#[test]
fn a_planet_is_drawn_about_its_centre_of_mass() {
    let text = "kind = \"meteorite\"\n[body]\nmass = 2.0\nshape = \"cone\"\nradius = 0.3\nheight = 0.5\n\
                [initial]\nvelocity = [3.0, 0.0, 1.0]\nomega = [1.0, 2.0, -3.0]\n";
    let (table, sights) = seen("mine.toml", text, &[0.0, 0.4]);
    for (row, sight) in sights.iter().enumerate() {
        let center = means(&sight.solids[0].0).0;
        let stands = sight.solids[0].1;
        let center = stands.rotation * center + stands.translation.vector;
        let told = ["x", "y", "z"].map(|name| number(&table, row, name));
        assert!((center - Vector3::from(told)).norm() < 1e-14);
        assert_eq!((sight.place, sight.around), (told.into(), Around::Space));
        let l = inertia(&sight.solids[0], center) * sight.omega * 2.0;
        assert!((sight.angular_momentum.unwrap() - l).norm() < 1e-14 * l.norm());
    }
}

#[test]
fn everything_turns_as_omega_says() {
    // The yo-yo and the superball do not tell how far they have turned; the feet of the crawler do not turn.
    let first = "billiard-shot chiral-top egg meteorite nutation-dies paper-cat racket rattleback sleeping-top strip swivel tippe-top \
                 withdrawn-sheet";
    let others: [&[usize]; 4] = [&[2], &[0, 1], &[0, 1, 4], &[0, 2]];
    let others = ["cat", "heavy-body", "skater", "spool"]
        .into_iter()
        .zip(others);
    let first = first.split(' ').map(|name| (name, &[0][..]));
    for (name, solids) in first.chain(others) {
        for t in [0.11, 0.27] {
            let sights = around(name, t);
            let told = sights[1].omega;
            for &solid in solids {
                let off = (turning(&sights, solid) - told).norm();
                let turns = sights[1].turned && off <= 4e-5 * told.norm();
                assert!(turns, "{name} at {t}: {off}");
            }
        }
    }
}

#[test]
fn what_is_on_a_floor_touches_it() {
    let times: Vec<f64> = (0..21).map(|k| 0.05 * f64::from(k)).collect();
    let rest_on_it = "billiard-shot chiral-top egg hoop-with-clay rattleback sliding-ball spool tippe-top withdrawn-sheet crawler";
    for name in rest_on_it.split(' ') {
        let sights = in_the_book(name, &times);
        for (t, sight) in times.iter().zip(&sights) {
            let low = lowest_of_all(sight);
            assert_eq!(sight.around, Around::Floor, "{name}");
            assert!(low.abs() < 2e-16, "{name} at {t}: {low}");
        }
    }
    // Here one disc is above the other, or a core below the arms.
    for name in ["swivel", "skater"] {
        for sight in in_the_book(name, &times) {
            let low = lowest_of_all(&sight);
            let size = sight.place.z;
            assert!(low >= -1e-15 && low < 0.2 * size, "{name}: {low}");
        }
    }
}

#[test]
fn a_superball_touches_floor_and_ceiling_where_it_bounces() {
    let text = file_of_the_book("superball.toml");
    let times: Vec<f64> = (0..101).map(|k| 0.01 * f64::from(k)).collect();
    let (table, sights) = seen("superball.toml", &text, &times);
    for (row, sight) in sights.iter().enumerate() {
        let height = number(&table, row, "height");
        let Around::Under(ceiling) = sight.around else {
            panic!("{:?}", sight.around)
        };
        let low = lowest_of_all(sight);
        near!(low, height, 1e-15);
        // Seen from above.
        let mut over = sight.clone();
        let half_turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI);
        for (_, stands) in &mut over.solids {
            *stands = Isometry3::from_parts(Vector3::zeros().into(), half_turn) * *stands;
        }
        near!(ceiling + lowest_of_all(&over), 0.6 - height, 1e-15);
        // L = 2/5 M R² Ω: the radius is not told, the quotient of the two is.
        let radius = sight.place.z - low;
        let l = sight.angular_momentum.unwrap();
        assert!((l - sight.omega * (0.4 * 0.05 * radius * radius)).norm() < 1e-15);
        assert!(!sight.turned);
    }
}

/// One that is thrown upward has room for what it climbs, as if it had been let go there.
#[test]
fn a_superball_in_the_open_is_as_large_as_goes_with_its_way() {
    let open = file_of_the_book("superball.toml").replace("ceiling = 0.6", "");
    let dropped = open.replace("climb = -5.0", "");
    let dropped = dropped.replace("height = 0.3", "height = 1.5742099898063201");
    let radius = |text: &str| {
        let (_, sights) = seen("superball.toml", text, &[0.0]);
        sights[0].place.z - lowest_of_all(&sights[0])
    };
    assert!((radius(&open) / radius(&dropped) - 1.0).abs() < 1e-14);
}

/// Where a bar ends.
fn end((solid, stands): &(Solid, Isometry3<f64>)) -> Vector3<f64> {
    let Solid::Bar(to) = solid else {
        panic!("{solid:?}")
    };
    (stands * nalgebra::Point3::from(*to)).coords
}

fn place((_, stands): &(Solid, Isometry3<f64>)) -> Vector3<f64> {
    stands.translation.vector
}

/// The moment of a solid of 1 kg about a line through its centre.
fn moment(solid: &(Solid, Isometry3<f64>), line: Vector3<f64>) -> f64 {
    line.dot(&(inertia(solid, place(solid)) * line)) / line.norm_squared()
}

#[test]
fn a_cat_is_two_cylinders_that_meet_at_its_joint() {
    for sight in in_the_book("cat", &[0.0, 0.08, 0.2]) {
        let [spines @ .., front, rear] = &sight.solids[..] else {
            panic!()
        };
        let joint = end(&spines[0]);
        assert!((joint - end(&spines[1])).norm() < 1e-15);
        // Halves of the same mass.
        assert!((place(front) + place(rear) - 2.0 * sight.place).norm() < 1e-15);
        for (spine, half) in spines.iter().zip([front, rear]) {
            assert!((place(spine) - place(half)).norm() < 1e-15);
            let along = joint - place(half);
            assert!((along.norm() - 0.11).abs() < 1e-15);
            let across = along.cross(&Vector3::new(0.3, -0.5, 0.7));
            let [axial, transverse] = [along, across].map(|line| 1.5 * moment(half, line));
            assert!((axial - 0.0025).abs() < 1e-16 && (transverse - 0.01).abs() < 1e-16);
        }
        assert_eq!(sight.angular_momentum, None);
    }
}

/// As it is drawn, too, it has no angular momentum.
#[test]
fn a_cat_is_drawn_as_it_turns() {
    for t in [0.06, 0.13, 0.21] {
        let sights = around("cat", t);
        let half = |k: usize| {
            let seen = [0, 1, 2].map(|n| place(&sights[n].solids[k]) - sights[n].place);
            let orbit = seen[1].cross(&((seen[2] - seen[0]) / MOMENT));
            orbit + inertia(&sights[1].solids[k], place(&sights[1].solids[k])) * turning(&sights, k)
        };
        let (front, rear) = (half(2), half(3));
        let none = (front + rear).norm() < 1e-4 * front.norm();
        assert!(none, "{t}: {front} {rear}");
    }
}

/// A spool has a rim on either side; a paper cat falls; beads are at the ends of bars from their centre of mass.
#[test]
fn what_is_drawn_of_several_solids_is_where_it_belongs() {
    for sight in in_the_book("spool", &[0.0, 0.7]) {
        let [axle, one, other] = [0, 1, 2].map(|n| &sight.solids[n]);
        assert!((place(one) + place(other) - 2.0 * place(axle)).norm() < 1e-16);
        let axis = place(other) - place(one);
        assert!((axis - Vector3::y() * 0.05).norm() < 1e-16, "{axis}");
    }
    let (table, sights) = seen("", &file_of_the_book("paper-cat.toml"), &[0.5]);
    assert_eq!(sights[0].place.z, -number(&table, 0, "fall"));
    let beads = "shape = \"beads\"\nplaces = [[0.4, 0, 0], [0, 0.2, 0.1]]\nparts = [1, 3]";
    let text = format!("[body]\nmass = 2.0\n{beads}\n[initial]\nomega = [0, 0, 1]\n");
    let (_, sights) = seen("mine.toml", &text, &[0.0]);
    // From (0.1, 0.15, 0.075).
    let ends = [[0.3, -0.15, -0.075], [-0.1, 0.05, 0.025]].map(Vector3::from);
    for (bar, bead) in sights[0].solids.iter().zip(ends) {
        assert!((end(bar) - bead).norm() + place(bar).norm() < 1e-16);
    }
}

#[test]
fn shapes_that_change_are_drawn_as_they_are() {
    let text = file_of_the_book("swivel.toml");
    let (table, sights) = seen("swivel.toml", &text, &[0.0, 0.9, 1.7, 3.3]);
    for (row, sight) in sights.iter().enumerate() {
        let told = |name| number(&table, row, name);
        let [lower, upper] = [0, 1].map(|k| &sight.solids[k]);
        assert!((moment(lower, Vector3::z()) - 0.6).abs() < 1e-15);
        assert!((moment(upper, Vector3::z()) - told("upper_moment")).abs() < 1e-15);
        let turn = upper.1.rotation.scaled_axis().z - told("upper");
        assert!((turn / TAU).fract().abs() < 1e-14);
        assert_eq!(place(upper), sight.place);
    }

    let text = file_of_the_book("skater.toml");
    let (table, sights) = seen("skater.toml", &text, &[0.0, 0.9, 1.2, 1.7]);
    for (row, sight) in sights.iter().enumerate() {
        let told = |name| number(&table, row, name);
        let [core, left_arm, left, right_arm, right]: &[_; 5] =
            sight.solids[..].try_into().unwrap();
        let (sine, cosine) = told("angle").sin_cos();
        let reach = Vector3::new(cosine, sine, 0.0) * told("reach");
        for (side, arm, hand) in [(-1.0, left_arm, left), (1.0, right_arm, right)] {
            assert!((place(hand) - sight.place - reach * side).norm() < 1e-14);
            assert!((end(arm) - place(hand)).norm() < 1e-15 && place(arm) == sight.place);
        }
        // Both hands, 2.5 kg each, on the rim of the core would have its 0.8 kg m².
        let girth_squared = 2.0 * moment(core, Vector3::z());
        assert!((2.0 * 2.5 * girth_squared - 0.8).abs() < 1e-15);
        let l = sight.angular_momentum.unwrap();
        let all = 0.8 + 2.0 * 2.5 * reach.norm_squared();
        assert!((l - sight.omega * all).norm() < 1e-13);
    }

    let text = file_of_the_book("crawler.toml");
    let (table, sights) = seen("crawler.toml", &text, &[0.0, 0.5, 1.1]);
    for (row, sight) in sights.iter().enumerate() {
        let [muscle, rear, front]: &[_; 3] = sight.solids[..].try_into().unwrap();
        assert_eq!((place(muscle), end(muscle)), (place(rear), place(front)));
        let [behind, before] = ["rear", "front"].map(|name| number(&table, row, name));
        assert_eq!((place(rear).x, place(front).x), (behind, before));
        let center = (3.0 * behind + before) / 4.0;
        assert!((sight.place.x - center).abs() < 1e-15);
        // As balls of their masses.
        let volumes = [rear, front].map(|foot| place(foot).z.powi(3));
        assert!((volumes[0] / volumes[1] - 3.0).abs() < 1e-14);
    }
}

#[test]
fn where_nothing_slips_the_lowest_point_rests() {
    for (name, times) in [("rattleback", [0.3, 2.1]), ("billiard-shot", [0.8, 2.0])] {
        for t in times {
            let [before, now, after] = around(name, t);
            // Where the vertical leaves the ellipsoid.
            let (solid, stands) = &now.solids[0];
            let Solid::Ellipsoid(half_axes) = solid else {
                panic!("{solid:?}")
            };
            let half_axes = stands.rotation.to_rotation_matrix() * half_axes;
            let down = half_axes.transpose() * -Vector3::z();
            let touching = place(&now.solids[0]) + half_axes * down / down.norm();
            let way = after.place - before.place;
            let speed = way / MOMENT + now.omega.cross(&(touching - now.place));
            let pace = now.omega.norm() * (touching - now.place).norm();
            assert!(speed.norm() < 1e-5 * pace, "{name} at {t}: {speed:?}");
        }
    }
}
