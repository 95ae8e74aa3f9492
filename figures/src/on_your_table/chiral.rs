//! A chiral top to print: a plastic ball with an oblique hollow.

use nalgebra::Matrix3;
use spinning_bodies::frame::Attitude;
use spinning_bodies::inertia::{MassProperties, Mesh, icosphere, mesh_mass_properties};
use spinning_bodies::scene::contact::{State, passage};
use spinning_bodies::scene::{Request, Scene};
use spinning_bodies::tippe_top::{ConvexBody, Surface};

use crate::prelude::*;
use crate::tippe_top::toys::body_scene;

/// Radius of the ball, m.
const RADIUS: f64 = 0.03;
/// Density of solid polylactide, kg/m³.
const DENSITY: f64 = 1240.0;
/// The hollow, an ellipsoid: its semi-axes and how far it stands above the centre of the ball, in radii, and its attitude w x y z.
const SEMI_AXES: [f64; 3] = [0.78, 0.615, 0.835];
const HEIGHT: f64 = 0.154;
const ATTITUDE: [f64; 4] = [0.382, -0.609, -0.228, -0.656];
/// Ten thousand triangles: the facets lie within a twentieth of a millimetre of the ball.
const LEVELS: u32 = 4;

/// Spin, rad/s, tilt of the release, rad, friction, and for how long the top is followed, s.
const SPIN: f64 = 157.0;
const TILT: f64 = 0.0524;
const FRICTION: f64 = 0.3;
const END: f64 = 5.0;

/// The ellipsoid as a map of the unit sphere, in radii.
fn hollow() -> Result<Matrix3<f64>> {
    let [w, x, y, z] = ATTITUDE;
    let attitude = Attitude::from_quaternion(w, x, y, z)?;
    let columns = [0, 1, 2].map(|k| turned(&attitude, Vector::ith(k, SEMI_AXES[k])));
    Ok(Matrix3::from_columns(&columns))
}

/// The ball and, with its faces turned inward, the hollow, m.
fn mesh() -> Result<Mesh> {
    let (mut vertices, mut triangles) = icosphere(LEVELS, RADIUS)?;
    let (inner, faces) = icosphere(LEVELS, 1.0)?;
    let first = vertices.len() as u32;
    let map = hollow()?;
    vertices.extend(inner.into_iter().map(|v| -> [f64; 3] {
        let place = map * Vector::from(v) + HEIGHT * Vector::z();
        (RADIUS * place).into()
    }));
    let inward = |[a, b, c]: [u32; 3]| [a, c, b].map(|n| first + n);
    triangles.extend(faces.into_iter().map(inward));
    Ok((vertices, triangles))
}

fn properties() -> Result<MassProperties> {
    let (vertices, triangles) = mesh()?;
    mesh_mass_properties(&vertices, &triangles, DENSITY)
}

/// The printer's file, binary, in millimetres.
pub fn stl() -> Result<Vec<u8>> {
    let (vertices, triangles) = mesh()?;
    let head = "chiral top of Spinning Bodies, in mm, print it solid";
    let mut bytes = format!("{head:80}").into_bytes();
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        let [a, b, c] = triangle.map(|n| 1e3 * Vector::from(vertices[n as usize]));
        let normal = (b - a).cross(&(c - a)).normalize();
        let coordinates = [normal, a, b, c].into_iter().flat_map(|v| [v.x, v.y, v.z]);
        bytes.extend(coordinates.flat_map(|x| (x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    Ok(bytes)
}

/// Motion of the printed top after such a release, leaning towards this azimuth of the body.
fn run(spin: f64, azimuth: f64) -> Result<Vec<(f64, State)>> {
    let properties = properties()?;
    let center = properties.center() * -1.0;
    let surface = Surface::sphere(RADIUS)?;
    let body = ConvexBody::new(properties.mass(), properties.inertia(), surface, center)?;
    let top = body_scene(body, spin, TILT, azimuth, FRICTION)?;
    let times: Vec<f64> = (0..=1000).map(|k| 1e-3 * END * f64::from(k)).collect();
    Ok(top.simulate(&Request::at(times)?.to_accuracy(1e-3)?)?.rows)
}

/// The printed top, cut open along its axis in two planes.
pub fn section(_: &Values) -> Result<Figure> {
    let map = hollow()?;
    let (vertices, _) = mesh()?;
    let inner = &vertices[vertices.len() / 2..];
    let reach = inner.iter().map(|v| Vector::from(*v).norm());
    let wall = 1e3 * (RADIUS - reach.fold(0.0, f64::max));
    let properties = properties()?;
    let low = -1e3 * properties.center().z();
    let degrees = |state: &State| state.tilt().to_degrees();
    let clockwise = run(-SPIN, 0.0)?;
    let other = tried([0.0, 1.0, 2.0, 3.0], |k| run(SPIN, k * FRAC_PI_2))?.concat();
    let side = passage(&clockwise, degrees, 90.0).unwrap_or(f64::INFINITY);
    let last = clockwise.last().map_or(0.0, |row| degrees(&row.1));
    let tilts = other.iter().map(|row| degrees(&row.1));
    let most = tilts.fold(0.0, f64::max).ceil();
    let turns = number(SPIN / TAU, 0);
    let [radius, mass] = numbers([1e3 * RADIUS, 1e3 * properties.mass()], 0);
    let lean = number(TILT.to_degrees(), 0);
    let words = words!(
        "A ball of one plastic with a hollow askew is a chiral top.",
        "Two sections along $CK$, at right angles; dashed: the long axis of the hollow. $R = {radius}$ mm, the wall at its thinnest {wall:.1} mm, $C$ {low:.1} mm below the \
         centre $K$, {mass} g of polylactide. Released at {lean}° with {turns} turns a second, $\\mu = {FRICTION}$ smoothed over 1 mm/s: clockwise it is on its side after \
         {side:.1} s, anticlockwise it stays below {most}° for {END} seconds, whichever of four ways it leans at first.",
        "Two circles, each with a large empty ellipse inside that nearly touches it, and whose dashed long axis leans. In both the centre of mass C lies a little below the centre K of the circle."
    );
    let drawn = figure("printed-top", 300.0, words, |pen| {
        let ellipsoid = (map * map.transpose()).cholesky();
        for (k, across) in [Vector::x(), Vector::y()].into_iter().enumerate() {
            let center = [150.0 + 300.0 * k as f64, 138.0];
            let scale = 122.0;
            let along = |angle: f64| angle.cos() * across + angle.sin() * Vector::z();
            let middle = shifted(center, [0.0, -scale * HEIGHT]);
            let angles = (0..120).map(|n| TAU * f64::from(n) / 120.0);
            let outline = angles.filter_map(|angle| {
                let way = along(angle);
                let reach = scale / way.dot(&ellipsoid.as_ref()?.solve(&way)).sqrt();
                Some(polar(middle, reach, angle))
            });
            let outline: Vec<Point> = outline.collect();
            cut(pen, center, scale, &outline, 1e-3 * low / RADIUS);
        }
    });
    Ok(drawn
        .value("mass", mass)
        .value("wall", number(wall, 1))
        .value("turns", turns)
        .value("side", number(side, 1))
        .value("last", number(last, 0))
        .value("most", number(most, 0)))
}

/// A ball cut through, its hollow, K and C.
fn cut(pen: &mut Pen, center: Point, scale: f64, hollow: &[Point], low: f64) {
    pen.disc(center, scale, Ink, 0.16);
    pen.ring(center, scale, inked(SECONDARY));
    pen.fill(hollow, Paper, 1.0);
    pen.outline(hollow, inked(SECONDARY));
    // Its long axis, between opposite points.
    let long = |k: &usize| distance(hollow[*k], hollow[k + 60]);
    if let Some(k) = (0..60).max_by(|a, b| long(a).total_cmp(&long(b))) {
        pen.line([hollow[k], hollow[k + 60]], muted(SECONDARY).dashed());
    }
    let [x, y] = center;
    let ends = [[x, y - scale - 8.0], [x, y + scale + 8.0]];
    pen.line(ends, muted(AXIS).dotted());
    for (name, down, by) in [("*K*", 0.0, -8.0), ("*C*", low, 8.0)] {
        let at = [x, y + scale * down];
        pen.dot(at, 3.5);
        let beside = [16.0, -16.0, 26.0, -26.0];
        pen.name(beside.map(|x| shifted(at, [x, by])), name, label(Ink));
    }
    pen.remark([x, y + scale + 30.0], Middle, "foot");
}
