//! Scene files: a body is given by what it is.

use super::files::{last, mistakes, one_mistake};
use super::*;
use super::{film::file_of_the_book, units::changed};
use spinning_bodies::inertia::shapes::{ball_without_cap, torus};
use spinning_bodies::scene::files::parse_with;

fn listed<const N: usize>(numbers: [f64; N]) -> String {
    format!("{numbers:?}")
}

/// A body by its moments, and the same body by its matrix along axes turned against the principal ones.
#[test]
fn a_body_in_axes_of_its_own_moves_as_it_does_in_its_principal_axes() {
    let moments = [1.0, 1.6, 2.1];
    let turn = Attitude::from_quaternion(0.8, -0.2, 0.5, 0.3).unwrap();
    let r = turn.quaternion().to_rotation_matrix().into_inner();
    let matrix = r * Matrix3::from_diagonal(&moments.into()) * r.transpose();
    let i = |j: usize, k: usize| 0.5 * (matrix[(j, k)] + matrix[(k, j)]);
    let own = |v: [f64; 3]| -> [f64; 3] { (r * Vector3::from(v)).into() };
    let (center, omega) = ([0.1, -0.2, 0.3], [0.5, 2.0, -1.0]);
    let start = Attitude::from_quaternion(0.6, 0.0, 0.8, 0.0).unwrap();
    let file = |inertia: String, center, omega, start: Attitude, effects: &str| {
        let (center, omega) = (listed::<3>(center), listed::<3>(omega));
        let q = start.quaternion();
        let q = listed([q.w, q.i, q.j, q.k]);
        format!(
            "[body]\nmass = 1.5\n{inertia}\ncenter_of_mass = {center}\n[initial]\nattitude = {q}\nomega = {omega}\n[effects]\n{effects}\n\
             [run]\ntimes = [3.0]\naccuracy = 1e-11\n"
        )
    };
    let all = [
        ["lx", "ly", "lz"],
        ["energy", "potential", "height"],
        ["force_x", "force_y", "force_z"],
        ["omega_x", "omega_y", "omega_z"],
    ];
    for effects in [
        "",
        "gravity = 9.81",
        "gravity = 9.81\nair_drag = 0.02\npivot_friction = 0.1",
    ] {
        let principal = format!("moments = {moments:?}");
        let principal = file(principal, center, omega, start, effects);
        let six = listed([i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)]);
        let (six, own_start) = (format!("inertia = {six}"), start * turn.inverse());
        let turned = file(six, own(center), own(omega), own_start, effects);
        for names in all {
            for (a, b) in last(&principal, names).iter().zip(last(&turned, names)) {
                assert!((a - b).abs() < 1e-9 * (1.0 + a.abs()), "{names:?}: {a} {b}");
            }
        }
        let [first, own] = [&principal, &turned].map(|text| {
            let [w, x, y, z] = last(text, ["qw", "qx", "qy", "qz"]);
            Attitude::from_quaternion(w, x, y, z).unwrap()
        });
        assert!(first.angle_to(&(own * turn)) < 1e-9, "{effects}");
    }
    // A matrix without products is its moments, to the last bit.
    let diagonal = "moments = [2.0, 1.0, 1.5]";
    let level = Attitude::identity();
    let moments = file(diagonal.into(), center, omega, level, "gravity = 1");
    let matrix = |products: &str| {
        let six = format!("inertia = [2.0, 1.0, 1.5, {products}]");
        moments.replace(diagonal, &six)
    };
    for names in all {
        assert_eq!(last(&moments, names), last(&matrix("0, 0, 0"), names));
    }
    // What knows the third axis only by its number is refused.
    for friction in ["bearing_friction", "tip_friction"] {
        let rubbed = format!("[effects]\n{friction} = 0.1");
        let told = one_mistake(&matrix("0.1, 0, 0").replace("[effects]", &rubbed));
        assert!(told.contains(friction), "{told}");
    }
}

/// A quarter of a turn exchanges the half axes.
#[test]
fn the_surface_may_be_turned_in_the_body() {
    let stone = file_of_the_book("rattleback.toml").replace("until = 6.0", "until = 0.5");
    let omega = |change| last(&changed(&stone, change), ["omega1", "omega2", "omega3"]);
    let exchanged = omega("[0.2, 0.03, 0.02] => [0.03, 0.2, 0.02]");
    let turned = omega("0.02] => 0.02]; surface_turn = 1.5707963267948966");
    near!(exchanged[..], turned[..], 5e-12); // observed 7e-13
}

/// A free body of this shape, and its moments by L over Ω about each axis.
fn moments(body: &str) -> [f64; 3] {
    let about = |axis: usize| {
        let mut omega = [0.0; 3];
        omega[axis] = 1.0;
        let text = format!("[body]\n{body}\n[initial]\nomega = {omega:?}\n[run]\ntimes = [0.0]\n");
        last(&text, ["lx", "ly", "lz"])[axis]
    };
    [about(0), about(1), about(2)]
}

#[test]
fn a_body_is_given_by_what_it_is() {
    let (m, r, h) = (2.0, 0.3, 0.8);
    let round = |across: f64, about: f64| [across, across, about];
    let (ball, disc) = (0.4 * m * r * r, 0.5 * m * r * r);
    let half = round(83.0 / 320.0 * m * r * r, ball);
    let cylinder = round(m * (r * r / 4.0 + h * h / 12.0), disc);
    // About its centre of mass, and about its tip.
    let cone = round(0.15 * m * (r * r + h * h / 4.0), 0.3 * m * r * r);
    let on_its_tip = round(0.6 * m * (r * r / 4.0 + h * h), 0.3 * m * r * r);
    let cuboid = [117.0, 90.0, 45.0].map(|squares| m * squares / 12.0);
    let ellipsoid = [13.0, 10.0, 5.0].map(|squares| m * squares / 5.0);
    // Half the mass in a ball, half a third below: M/4 between two points 1/3 R apart.
    let weighted = round(ball / 2.0 + m * 0.01 / 4.0, ball / 2.0);
    let egg = round(13.0 * m / 5.0, 8.0 * m / 5.0);
    for (body, expected) in [
        ("'ball'\nradius = 0.3", [ball; 3]),
        ("'shell'\nradius = 0.3", [ball / 0.6; 3]),
        ("'hoop'\nradius = 0.3", round(disc, 2.0 * disc)),
        ("'disc'\nradius = 0.3", round(0.5 * disc, disc)),
        ("'cylinder'\nradius = 0.3\nheight = 0.8", cylinder),
        ("'cone'\nradius = 0.3\nheight = 0.8", cone),
        (
            "'cone'\nradius = 0.3\nheight = 0.8\npivot = [0, 0, 0]",
            on_its_tip,
        ),
        ("'cuboid'\nedges = [3, 6, 9]", cuboid),
        ("'ellipsoid'\nsemi_axes = [1, 2, 3]", ellipsoid),
        ("'egg'\nlong = 3\nshort = 2", egg),
        ("'ball-without-cap'\nradius = 0.3\ncut = 0", half),
        ("'ball-without-cap'\nradius = 0.3\ncut = 0.3", [ball; 3]),
        (
            "'ball-with-weight'\nradius = 0.3\nweight = 0.5\nweight_at = [0, 0, -0.1]",
            weighted,
        ),
        ("'beads'\nplaces = [[0, 0, 1], [0, 0, -1]]", [m, m, 0.0]),
        (
            "'beads'\nparts = [1, 3]\nplaces = [[4, 0, 0], [0, 0, 0]]",
            [0.0, 3.0 * m, 3.0 * m],
        ),
        // A ring and no handle.
        ("'racket'\nhead = 0.3\nhandle = 0", round(disc, 2.0 * disc)),
    ] {
        let seen = moments(&format!("mass = 2.0\nshape = {body}"));
        for (seen, expected) in seen.iter().zip(expected) {
            let off = (seen - expected).abs() / (1.0 + 8.0 * expected);
            assert!(off < 1e-15, "{body}: {seen} {expected}");
        }
    }
    // The same by density: per volume, per area, per length.
    let (ball, wire) = (4.0 / 3.0 * PI * r * r * r, 2.0 * PI * r);
    // ∫ π(R² − z²) dz from −R to the cut.
    let cut = PI * (9.0 * 4.0 - 28.0 / 3.0);
    // A quarter of the mass is the weight, three quarters are the ball.
    let weighted = 36.0 * PI / 0.75;
    for (sized, measure) in [
        ("'ball'\nradius = 0.3", ball),
        ("'ball-without-cap'\nradius = 0.3\ncut = 0.0", 0.5 * ball),
        ("'shell'\nradius = 0.3", 4.0 * PI * r * r),
        ("'cone'\nradius = 0.3\nheight = 0.8", PI * r * r * h / 3.0),
        ("'racket'\nhead = 0.3\nhandle = 0.8", wire + h),
        ("'hoop'\nradius = 0.3", wire),
        ("'disc'\nradius = 0.3", PI * r * r),
        ("'cylinder'\nradius = 0.3\nheight = 0.8", PI * r * r * h),
        ("'cuboid'\nedges = [2, 3, 7]", 42.0),
        ("'ellipsoid'\nsemi_axes = [2, 3, 7]", 56.0 * PI),
        ("'egg'\nlong = 3\nshort = 2", 16.0 * PI),
        ("'ball-without-cap'\nradius = 3\ncut = 1", cut),
        (
            "'ball-with-weight'\nradius = 3\nweight = 0.25\nweight_at = [0, 0, 2]",
            weighted,
        ),
    ] {
        let by_mass = moments(&format!("mass = {:?}\nshape = {sized}", 7.0 * measure));
        let by_density = moments(&format!("density = 7.0\nshape = {sized}"));
        for (a, b) in by_mass.iter().zip(by_density) {
            assert!((a - b).abs() < 1e-14 * a, "{sized}");
        }
    }
    // The axis of a racket's handle has the least moment, the normal the greatest: their sum, for it is flat.
    let racket = "mass = 0.3\nshape = \"racket\"\nhead = 0.13\nhandle = 0.4";
    let [along, across, normal] = moments(racket);
    assert!(along < across && (along + across - normal).abs() < 1e-15);
    // A ring and a rod of one wire, each about its middle, and both masses at the ends of the line between.
    let (ring, rod) = (2.0 * PI * 0.13, 0.4);
    let [ring, rod] = [ring, rod].map(|length| 0.3 * length / (ring + rod));
    let apart: f64 = 0.13 + 0.2;
    let expected =
        0.5 * ring * 0.13 * 0.13 + rod * 0.4 * 0.4 / 12.0 + ring * rod / 0.3 * apart * apart;
    assert!((along - 0.5 * ring * 0.13 * 0.13).abs() < 1e-17);
    assert!((across - expected).abs() < 1e-16, "{across} {expected}");
}

/// A cap so thin that the difference of radius and cut is all there is of it: nearly a paraboloid of height h on a circle of 2Rh, its moment about
/// the axis M·2Rh/3, its centre h/3 above the lowest point; and a ball that lacks as little.
#[test]
fn a_thin_cap_keeps_its_digits() {
    let h = f64::exp2(-40.0);
    let cap = ball_without_cap(3.0, 1.0, h - 1.0).unwrap();
    let moment = cap.inertia().matrix()[(2, 2)];
    // 2Rh/3 (1 − 5h/12 + …).
    assert!((moment / (2.0 * h) - 1.0 + 5.0 * h / 12.0).abs() < 1e-15);
    let whole = ball_without_cap(3.0, 1.0, 1.0 - h).unwrap();
    assert!((whole.center().z() / (-0.75 * h * h) - 1.0).abs() < 2.0 * h);
    let refused = torus(1.0, 1.0, 2.0).unwrap_err().to_string();
    assert!(refused.starts_with("the radius of the tube must lie between 0 and 1"));
}

#[test]
fn a_ball_and_its_cap_are_a_ball() {
    let (r, cut) = (1.5_f64, 0.4_f64);
    let volume = |height: f64| height * height * (r - height / 3.0);
    let below = ball_without_cap(volume(r + cut), r, cut).unwrap();
    let cap = ball_without_cap(volume(r - cut), r, -cut).unwrap();
    let upside_down = Attitude::about_axis(vector([1.0, 0.0, 0.0]), PI).unwrap();
    let ball = MassProperties::compose(&[below, cap.turned(&upside_down)]).unwrap();
    let expected = 0.4 * (4.0 / 3.0 * r * r * r) * r * r;
    assert!(ball.center().norm() < 1e-15);
    for k in 0..3 {
        assert!((ball.inertia().matrix()[(k, k)] / expected - 1.0).abs() < 1e-15);
    }
}

#[test]
fn twice_as_heavy_is_one_number() {
    let file = |mass: &str| {
        format!(
            "[body]\nmass = {mass}\nshape = \"racket\"\nhead = 0.13\nhandle = 0.4\n[initial]\nomega = [0.01, 5.0, 0.02]\n[run]\ntimes = [30.0]\n"
        )
    };
    let names = ["qw", "qx", "qy", "qz", "omega1", "omega2", "omega3"];
    assert_eq!(last(&file("0.3"), names), last(&file("0.6"), names));
    let [once, twice] = ["0.3", "0.6"].map(|mass| last(&file(mass), ["energy"])[0]);
    assert!((twice / once - 2.0).abs() < 1e-14);
}

#[test]
fn a_shape_gives_all_that_a_table_needs() {
    let run = "[initial]\ntilt = 0.1\naxial_spin = 155.0\n[effects]\ngravity = 9.81\nfriction_law = \"viscous\"\nfriction = 0.3\n[run]\ntimes = [0.2]\n";
    let names = ["qw", "qx", "omega1", "omega3", "x", "slip", "reaction"];
    // Half a ball: C is 3R/8 below its centre.
    let (m, r) = (0.02_f64, 0.02_f64);
    let (across, about) = (83.0 / 320.0 * m * r * r, 0.4 * m * r * r);
    let by_hand = format!(
        "kind = \"table-top\"\n[body]\nmass = 0.02\nradius = 0.02\nsurface_center = [0, 0, {:?}]\ninertia = [{across:?}, {across:?}, {about:?}, 0, 0, 0]\n{run}",
        0.375 * r
    );
    let by_shape = format!(
        "kind = \"table-top\"\n[body]\nmass = 0.02\nshape = \"ball-without-cap\"\nradius = 0.02\ncut = 0\n{run}"
    );
    for (a, b) in last(&by_hand, names).iter().zip(last(&by_shape, names)) {
        assert!((a - b).abs() < 1e-8 * (1.0 + a.abs()), "{a} {b}");
    }
    let cube = by_shape.replace(
        "\"ball-without-cap\"\nradius = 0.02\ncut = 0",
        "\"cuboid\"\nedges = [1, 1, 1]",
    );
    assert!(mistakes(&cube)[0].contains("smooth surface"));
    let more = by_shape.replace("cut = 0", "cut = 0\nsurface_center = [0, 0, 1]");
    assert!(mistakes(&more)[0].contains("`surface_center` in [body] is unknown"));
}

#[test]
fn what_rolls_is_a_shape_too() {
    let file = |body: &str| {
        format!(
            "kind = \"roller\"\n[body]\nmass = 1\nradius = 0.1\n{body}\n[initial]\nvelocity = 1\n[effects]\ngravity = 9.8\nfriction = 0.2\n[run]\ntimes = [9]\n"
        )
    };
    for (shape, kappa) in [
        ("ball", 0.4),
        ("shell", 2.0 / 3.0),
        ("disc", 0.5),
        ("hoop", 1.0),
    ] {
        let [speed] = last(&file(&format!("shape = \"{shape}\"")), ["velocity"]);
        // A ball keeps five sevenths of its speed, another body 1/(1 + κ).
        assert!((speed - 1.0 / (1.0 + kappa)).abs() < 1e-14, "{shape}");
    }
    let told = one_mistake(&file("shape = \"ball\"\ninertia_factor = 0.5"));
    assert!(told.contains("inertia_factor"), "{told}");
}

/// A box from a file in each of the three ways of writing it, its corner being the origin.
#[test]
fn a_mesh_is_read_from_its_file() {
    let at = |k: usize| [0, 1, 2].map(|axis| (k >> axis & 1) as f64 * [3.0, 6.0, 9.0][axis]);
    // Four corners of each face, in order as seen from outside.
    let faces = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let triangles = faces.map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let mut obj = String::from("# a box\n");
    for k in 0..8 {
        let [x, y, z] = at(k);
        obj += &format!(" v\t{x} {y} {z}\n");
    }
    for [a, b, c, d] in faces {
        obj += &format!("f {}/1 {}//2 {} {}\n", a + 1, b + 1, c + 1, d as i64 - 8);
    }
    let mut words = String::from("solid box\n");
    let mut binary = vec![0_u8; 80];
    binary.extend(12_u32.to_le_bytes());
    for triangle in triangles.as_flattened() {
        words += "facet normal 0 0 0\nouter loop\n";
        binary.extend([0; 12]);
        for &k in triangle {
            let [x, y, z] = at(k);
            words += &format!("  vertex {x} {y:e} {z}\n");
            binary.extend(at(k).iter().flat_map(|x| (*x as f32).to_le_bytes()));
        }
        words += "endloop\nendfacet\n";
        binary.extend([0; 2]);
    }
    let open = |name: &str| match name {
        "box.obj" => Ok(obj.clone().into_bytes()),
        "box.stl" => Ok(words.clone().into_bytes()),
        "one line.stl" => Ok(words.replace('\n', " ").into_bytes()),
        "binary.STL" => Ok(binary.clone()),
        "empty.stl" => Ok(b"solid vertex 0 0 0".to_vec()),
        "bad.obj" => Ok(b"v 0 0 zero\n".to_vec()),
        "open.obj" => Ok(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec()),
        "far.obj" => Ok(b"v 0 0 0\nf 1 2 3\n".to_vec()),
        "face.obj" => Ok(b"v 0 0 0\nf 0 -9 x\n".to_vec()),
        _ => Err("there is none".to_owned()),
    };
    let file = |name: &str| {
        format!(
            "[body]\nmass = 2\nshape = \"mesh\"\nfile = \"{name}\"\n[initial]\nomega = [1, 1, 1]\n[effects]\ngravity = 1\n[run]\ntimes = [0]\n"
        )
    };
    for name in ["box.obj", "box.stl", "one line.stl", "binary.STL"] {
        let (scene, request) = parse_with("mine.toml", &file(name), &open).unwrap();
        let names = ["lx", "ly", "lz"];
        let table = scene.telling(&names).unwrap().simulate(&request).unwrap();
        let found = table.numbers(names).unwrap()[0];
        near!(found[..], [117.0 / 6.0, 15.0, 7.5][..], 1e-13);
    }
    for name in "none.obj box.txt bad.obj open.obj far.obj face.obj empty.stl ".split(' ') {
        let told = parse_with("mine.toml", &file(name), &open);
        let told = told.unwrap_err().to_string();
        let said = told.starts_with("mine.toml:4: key `file` in [body]");
        assert!(said, "{told}");
        assert_eq!(told.lines().count(), 1);
    }
    assert!(mistakes(&file("box.obj"))[0].contains("out of reach"));
}

/// Which of the ways of giving a body exclude each other, and which numbers each needs.
#[test]
fn a_body_is_given_once() {
    let told = |body: &str| {
        let text = format!("[body]\n{body}\n[initial]\nomega = [0, 1, 5]\n[run]\ntimes = [1]\n");
        one_mistake(&text)
    };
    let ball = "shape = \"ball\"\nradius = 1";
    for (body, key) in [
        (format!("{ball}\nmass = 1\nmoments = [1, 1, 1]"), "moments"),
        (format!("{ball}\nmass = 1\ninertia = [1, 1, 1, 0, 0, 0]"), "inertia"),
        (format!("{ball}\nmass = 1\ndensity = 1"), "density"),
        (format!("{ball}\nmass = 1\ncenter_of_mass = [0, 0, 0]"), "center_of_mass"),
        (format!("{ball}\nmass = 1\nheight = 1"), "height"),
        (ball.to_owned(), "mass"),
        ("moments = [1, 1, 1]\ninertia = [1, 1, 1, 0, 0, 0]".to_owned(), "moments"),
        ("moments = [1, 1, 1]\ndensity = 1".to_owned(), "density"),
        ("moments = [1, 1, 1]\npivot = [0, 0, 0]".to_owned(), "pivot"),
        ("mass = 1".to_owned(), "moments"),
        ("mass = 1\nshape = \"ball-without-cap\"\nradius = 1\ncut = -1".to_owned(), "cut"),
        ("mass = 1\nshape = \"ball-with-weight\"\nradius = 1\nweight = 0.1\nweight_at = [1, 1, 0]".to_owned(), "weight_at"),
        ("mass = 1\nshape = \"beads\"\nplaces = []".to_owned(), "places"),
        ("density = 1\nshape = \"beads\"\nplaces = [[0, 0, 0], [1, 1, 1]]".to_owned(), "density"),
        ("mass = 1\nshape = \"ball\"".to_owned(), "radius"),
        ("mass = 1\nshape = \"balls\"\nradius = 1".to_owned(), "shape"),
    ] {
        let told = told(&body);
        assert!(told.contains(&format!("key `{key}`")), "{body}: {told}");
    }
}
