//! Sheets are true to size, the solid is closed, and the numbers on them are those of just these things.

use core::f64::consts::FRAC_PI_4;
use std::collections::HashSet;

use figures::on_your_table::{Paper, sheets};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use spinning_bodies::inertia::{Mesh, mesh_mass_properties, mesh_of_stl};
use spinning_bodies::scene::contact::TableTop;
use spinning_bodies::scene::effects::{Gravity, Regularised};
use spinning_bodies::scene::{Request, Scene};
use spinning_bodies::tippe_top::{ConvexBody, Start, Surface};

fn files(paper: Paper) -> [(String, Vec<u8>); 3] {
    let sheets = sheets(paper).expect("they draw");
    sheets.map(|sheet| (sheet.name, sheet.contents))
}

fn svgs(paper: Paper) -> [String; 2] {
    let [strips, cat, _] = files(paper);
    [strips, cat].map(|(_, bytes)| String::from_utf8(bytes).expect("text"))
}

/// The polygons and lines, millimetres.
fn shapes(svg: &str) -> Vec<Vec<[f64; 2]>> {
    let pieces = svg.split("points=\"").skip(1);
    let point = |pair: &str| {
        let (x, y) = pair.split_once(',').expect("a pair");
        [x, y].map(|number| number.parse().expect("a number"))
    };
    let listed = pieces.map(|piece| piece.split('"').next().unwrap_or_default());
    let shapes = listed.map(|points| points.split(' ').map(point).collect());
    shapes.collect()
}

/// The lines of a sheet, one after the other.
fn words(svg: &str) -> String {
    let pieces = svg
        .split("</text>")
        .filter_map(|piece| piece.rsplit('>').next());
    pieces.collect::<Vec<_>>().join(" ")
}

#[test]
fn a_unit_is_a_millimetre_and_all_is_on_the_page() {
    for paper in Paper::ALL {
        let [width, height] = paper.size();
        for svg in svgs(paper) {
            let head = format!("width=\"{width}mm\" height=\"{height}mm\"");
            assert!(svg.contains(&format!("{head} viewBox=\"0 0 {width} {height}\"")));
            let shapes = shapes(&svg);
            // Printers do not reach the edge.
            for [x, y] in shapes.iter().flatten() {
                assert!((6.0..width - 6.0).contains(x) && (6.0..height - 6.0).contains(y));
            }
            let ruler = shapes.last().expect("a ruler");
            let span = ruler.iter().map(|p| p[0]);
            let least = span.clone().fold(f64::INFINITY, f64::min);
            assert_eq!(span.fold(0.0, f64::max) - least, 100.0);
            for text in svg.split("<text").skip(1) {
                let text = text.split("</text>").next().unwrap_or_default();
                let value = |key: &str| -> f64 {
                    let (_, after) = text.split_once(key).expect("an attribute");
                    let value = after.split('"').next().unwrap_or_default();
                    value.parse().expect("a number")
                };
                let words = text.rsplit('>').next().unwrap_or_default();
                let length = 0.52 * value("font-size=\"") * words.chars().count() as f64;
                assert!(value("x=\"") + length < width - 6.0, "{paper:?}: {words}");
                assert!(value("y=\"") < height - 6.0);
            }
        }
    }
}

#[test]
fn strips_are_as_wide_as_they_say_and_turn_as_the_chapter_says() {
    for paper in Paper::ALL {
        let [strips, _] = svgs(paper);
        let shapes = shapes(&strips);
        // What the chapter on the falling strip asserts of these widths.
        let turns = [Some("14.6"), Some("8.6"), None, Some("3.9")];
        for ((strip, width), turns) in shapes.iter().zip([10.0, 20.0, 30.0, 50.0]).zip(turns) {
            assert_eq!(strip[1][0] - strip[0][0], 180.0);
            assert!((strip[2][1] - strip[1][1] - width).abs() < 1e-9);
            let told = turns.map(|turns| format!(">{width} mm: {turns} turns a second"));
            assert!(told.is_none_or(|told| strips.contains(&told)));
        }
        let whole = "it swings to and fro and does not turn over";
        assert!(words(&strips).contains(whole), "wider than 16 cm");
    }
}

/// By hand: 4500 + 484 + 216 mm² of back, head and tail, four legs of 525 mm² whose middles hang 17.5 mm lower.
#[test]
fn the_cat_weighs_what_its_outline_weighs() {
    let outline = 4500.0 + 484.0 + 216.0 + 4.0 * 525.0;
    for paper in Paper::ALL {
        let [_, cat] = svgs(paper);
        let shapes = shapes(&cat);
        let corners = shapes[0].iter().zip(shapes[0].iter().cycle().skip(1));
        let area = corners.map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1]));
        let area: f64 = area.sum();
        assert!((area.abs() - outline).abs() < 1e-6, "{area}");
        let lever = 4.0 * 525.0 * 17.5 / outline;
        let told = [
            format!("weighs {:.2} g", 80e-6 * outline),
            "with 52 cm²".to_owned(),
            format!("lies {lever:.1} mm below"),
        ];
        let words = words(&cat);
        for told in told {
            assert!(words.contains(&told), "{told}: {words}");
        }
    }
}

fn solid() -> Mesh {
    let [.., (_, bytes)] = files(Paper::A4);
    let mesh = mesh_of_stl(&bytes).expect("a mesh");
    assert_eq!(bytes.len(), 84 + 50 * mesh.1.len());
    mesh
}

#[test]
fn each_edge_of_the_solid_has_two_triangles_of_opposite_sense() {
    let (_, triangles) = solid();
    let mut edges = HashSet::new();
    for [a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            assert!(edges.insert(edge), "an edge run along twice: {edge:?}");
        }
    }
    assert!(edges.iter().all(|&[a, b]| edges.contains(&[b, a])));
}

/// The ball less the ellipsoid by their formulas; the facets cut off up to a thousandth.
#[test]
fn the_solid_has_the_mass_and_the_moments_of_the_top() {
    let (vertices, triangles) = solid();
    let found = mesh_mass_properties(&vertices, &triangles, 1.0).expect("a closed solid");
    // Millimetres, density 1.
    let (radius, axes, height) = (30.0_f64, Vector3::new(0.78, 0.615, 0.835), 0.154);
    let ball = 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
    let hollow = ball * axes.product();
    let quaternion = nalgebra::Quaternion::new(0.382, -0.609, -0.228, -0.656);
    let turn = Rotation3::from(UnitQuaternion::from_quaternion(quaternion));
    let squares = Matrix3::from_diagonal(&axes.component_mul(&axes));
    let up = Vector3::z() * height;
    let spread = turn.matrix() * squares * turn.matrix().transpose() / 5.0 + up * up.transpose();
    let mass = ball - hollow;
    let center = -up * hollow / mass;
    let second =
        (Matrix3::identity() * 0.2 * ball - spread * hollow) / mass - center * center.transpose();
    let inertia = (Matrix3::identity() * second.trace() - second) * (mass * radius * radius);
    // Facets lie inside the ball and take 2 parts in a thousand of it, and of the hollow as well.
    let lost = 1.0 - found.mass() / mass;
    assert!((2.0e-3..2.4e-3).contains(&lost), "{lost}");
    let off = (found.inertia().matrix() - inertia).amax() / inertia.amax();
    assert!((1e-3..5e-3).contains(&off), "{off}");
    let apart = (found.center().components() / radius - center).amax();
    assert!(apart < 1e-6, "{apart}");
    let deep = triangles[..triangles.len() / 2].iter().map(|triangle| {
        let corners = triangle.map(|n| Vector3::from(vertices[n as usize]));
        radius - (corners.iter().sum::<Vector3<f64>>() / 3.0).norm()
    });
    let deep = deep.fold(0.0, f64::max);
    assert!((0.02..0.045).contains(&deep), "{deep}");
    // No wall is thinner than what a printer prints.
    let inner = vertices[vertices.len() / 2..].iter();
    let reach = inner.map(|v| Vector3::from(*v).norm()).fold(0.0, f64::max);
    assert!(reach < radius - 1.5 && reach > radius - 2.5, "{reach}");
}

/// What the printer's file itself does, spun faster and slower than the page says, on two kinds of table; at 14 turns a second it stays down.
#[test]
fn one_sense_turns_the_solid_over_and_the_other_does_not() {
    let (vertices, triangles) = solid();
    let metres: Vec<[f64; 3]> = vertices.iter().map(|v| v.map(|x| 1e-3 * x)).collect();
    let found = mesh_mass_properties(&metres, &triangles, 1240.0).expect("a closed solid");
    let surface = Surface::sphere(0.03).expect("a ball");
    let center = found.center() * -1.0;
    let body = ConvexBody::new(found.mass(), found.inertia(), surface, center).expect("a body");
    let tilted = |spin: f64, friction: f64, azimuth: f64| -> f64 {
        let lean = 3_f64.to_radians();
        let start = Start::about_vertical(lean, azimuth, spin).expect("a start");
        let weight = Gravity::new(9.81).expect("weight");
        let top = TableTop::new(body, start).with(weight).expect("weight");
        let law = Regularised::new(friction, 1e-3).expect("a law");
        let top = top.with(law).expect("friction");
        let times: Vec<f64> = (0..=100).map(|k| 0.05 * f64::from(k)).collect();
        let request = Request::at(times).and_then(|request| request.to_accuracy(1e-2));
        let request = request.expect("times and accuracy");
        let rows = top.simulate(&request).expect("a motion").rows;
        let tilts = rows.iter().map(|(_, state)| state.tilt().to_degrees());
        tilts.fold(0.0, f64::max)
    };
    // Leaning towards eight azimuths at first.
    let all = |spin: f64, friction: f64| {
        let azimuths = [0, 1, 2, 3, 4, 5, 6, 7].map(|k| f64::from(k) * FRAC_PI_4);
        azimuths.map(|azimuth| tilted(spin, friction, azimuth))
    };
    for (friction, spin) in [(0.3, 157.0), (0.2, 140.0)] {
        let (over, stays) = (all(-spin, friction), all(spin, friction));
        assert!(
            over.iter().all(|tilt| *tilt > 150.0),
            "{friction}: {over:?}"
        );
        assert!(
            stays.iter().all(|tilt| *tilt < 20.0),
            "{friction}: {stays:?}"
        );
        assert!(all(-88.0, friction).iter().all(|tilt| *tilt < 15.0));
    }
    // Too fast for so little friction.
    assert!(all(157.0, 0.2).iter().any(|tilt| *tilt > 150.0));
    assert!(all(210.0, 0.3).iter().any(|tilt| *tilt > 150.0));
}
