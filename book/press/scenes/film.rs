//! A motion as the moving body itself: `--film`, and as stills of it: `--frames`.

use std::f64::consts::{FRAC_PI_2, PI};
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use figures::Look;
use figures::film::{Body, Film, Shot, Surroundings};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use serde::Deserialize;
use spinning_bodies::inertia::mesh::{mesh_of_obj, mesh_of_stl};
use spinning_bodies::inertia::{InertiaMatrix, mesh_mass_properties, principal_axes_of, shapes};

use super::output::Motion;
use super::{AnyScene, beside};
use crate::interrupt::Unfinished;
use crate::pictures::{Copying, Form, file};
use crate::progress::watched;
use crate::writer::{can_be_written_into, folder_of};
use crate::{Error, Result};

type Vector = Vector3<f64>;
/// What the library may refuse.
type Refusable<T> = spinning_bodies::Result<T>;

/// The kinds whose bodies keep their shape.
const KINDS: [&str; 8] = [
    "top",
    "table-top",
    "meteorite",
    "roller",
    "spool",
    "superball",
    "yo-yo",
    "strip",
];

/// The columns that may say where a body is and how it turns.
const COLUMNS: [&str; 19] = [
    "qw",
    "qx",
    "qy",
    "qz",
    "omega1",
    "omega2",
    "omega3",
    "lx",
    "ly",
    "lz",
    "x",
    "y",
    "z",
    "turned",
    "omega",
    "height",
    "rim_speed",
    "depth",
    "angle",
];

/// What a scene file says of a body that can be drawn; it has been read as a scene before.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Given {
    shape: Option<String>,
    mass: Option<f64>,
    moments: Option<[f64; 3]>,
    /// A matrix, or a number.
    inertia: Option<toml::Value>,
    center_of_mass: Option<[f64; 3]>,
    pivot: Option<[f64; 3]>,
    radius: Option<f64>,
    height: f64,
    edges: [f64; 3],
    semi_axes: Option<[f64; 3]>,
    long: f64,
    short: f64,
    head: f64,
    handle: f64,
    cut: f64,
    weight: f64,
    weight_at: [f64; 3],
    places: Vec<[f64; 3]>,
    parts: Vec<f64>,
    file: String,
    surface_turn: f64,
    surface_center: [f64; 3],
    width: f64,
    thickness_ratio: f64,
}

/// The columns that a film needs, of those that a scene has.
pub fn columns(scene: &AnyScene) -> Vec<String> {
    let there = scene.columns().iter().map(|column| column.name);
    there
        .filter(|name| COLUMNS.contains(name))
        .map(str::to_owned)
        .collect()
}

/// A scene of a kind that can be seen.
#[derive(Debug)]
pub struct Seen {
    kind: &'static str,
    body: Given,
    ceiling: Option<f64>,
}

impl Seen {
    /// What the text of a scene file says of it.
    ///
    /// # Errors
    /// [`Error::Input`] for a kind whose body changes its shape, by the name of the `option` that asks for it.
    pub fn of(option: &str, name: &str, text: &str) -> Result<Self> {
        let refused = |told: String| Error::Input(format!("{option}: {name}: {told}"));
        let table: toml::Table =
            toml::from_str(text).map_err(|error| refused(error.to_string()))?;
        let kind = table
            .get("kind")
            .and_then(toml::Value::as_str)
            .unwrap_or("top");
        let Some(kind) = KINDS.into_iter().find(|known| *known == kind) else {
            let kinds = KINDS.join(", ");
            return Err(refused(format!(
                "the body of kind `{kind}` changes its shape; expected a kind whose body keeps it: {kinds}"
            )));
        };
        let body = table
            .get("body")
            .cloned()
            .unwrap_or(toml::Value::Table(toml::Table::new()));
        let body = body
            .try_into()
            .map_err(|error| refused(error.to_string()))?;
        let effects = table.get("effects");
        let ceiling = effects.and_then(|effects| effects.get("ceiling"));
        let number = |value: &toml::Value| value.clone().try_into().ok();
        Ok(Self {
            kind,
            body,
            ceiling: ceiling.and_then(number),
        })
    }

    /// The motion at so many equal steps from the first of its times to the last, and the picture of it.
    fn film<'a>(&self, motion: &'a Motion<'_>, count: usize, speed: f64) -> Result<Film<'a>> {
        let [first, last] = ends(motion);
        // Where an angle is told by its rate only, it is summed up in between.
        let rate = matches!(self.kind, "superball" | "yo-yo");
        let parts = if rate { 16 } else { 1 };
        let steps = (count - 1) * parts;
        let time = |k: usize| match k {
            0 => first,
            k if k == steps => last,
            k => first + (last - first) * (k as f64 / steps as f64),
        };
        let request = motion
            .request
            .of_times(&(0..=steps).map(time).collect::<Vec<_>>());
        let table = Motion {
            request: &request,
            ..*motion
        }
        .table()?;
        let place = |name: &str| table.columns.iter().position(|column| column.name == name);
        let rows: Vec<(f64, Vec<f64>)> = table.rows().collect();
        let told = |row: &[f64], name: &str| place(name).map_or(0.0, |place| row[place]);
        let highest = rows
            .iter()
            .map(|(_, row)| told(row, "height"))
            .fold(0.0, f64::max);
        // A superball has a speed of its rim but no radius.
        let radius = match self.kind {
            "superball" => match 0.06 * self.ceiling.unwrap_or(highest) {
                0.0 => 0.05,
                radius => radius,
            },
            _ => self.body.radius.unwrap_or(1.0),
        };
        let spin = |row: &[f64]| match self.kind {
            "superball" => told(row, "rim_speed") / radius,
            _ => told(row, "omega"),
        };
        let mut turned = 0.0;
        let mut shots = Vec::with_capacity(count);
        for (k, (time, row)) in rows.iter().enumerate() {
            if rate && k > 0 {
                let (before, ref last) = rows[k - 1];
                turned += 0.5 * (spin(row) + spin(last)) * (time - before);
            }
            if k % parts == 0 {
                let of = |name: &str| told(row, name);
                let vector = |names: [&str; 3]| Vector::from(names.map(of));
                let shot = if place("qw").is_some() {
                    let q = Quaternion::new(of("qw"), of("qx"), of("qy"), of("qz"));
                    let attitude = UnitQuaternion::from_quaternion(q);
                    let l = place("lx").map(|_| vector(["lx", "ly", "lz"]));
                    Shot {
                        time: *time,
                        place: vector(["x", "y", "z"]),
                        attitude,
                        omega: attitude * vector(["omega1", "omega2", "omega3"]),
                        angular_momentum: l,
                    }
                } else {
                    // In the plane of x and z; the third axis of what rolls lies across, as y does.
                    let (place, angle, lie, sense) = match self.kind {
                        "strip" => ([of("x"), 0.0, of("y")], of("angle"), 0.0, -1.0),
                        "superball" => (
                            [of("x"), 0.0, of("height") + radius],
                            turned,
                            FRAC_PI_2,
                            1.0,
                        ),
                        "yo-yo" => ([0.0, 0.0, -of("depth")], turned, FRAC_PI_2, 1.0),
                        _ => ([of("x"), 0.0, radius], of("turned"), FRAC_PI_2, 1.0),
                    };
                    let about =
                        |axis: Vector, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
                    Shot {
                        time: *time,
                        place: place.into(),
                        attitude: about(Vector::y(), sense * angle) * about(Vector::x(), -lie),
                        omega: Vector::y() * (sense * spin(row)),
                        angular_momentum: None,
                    }
                };
                shots.push(shot);
            }
        }
        let drawn = self.drawn(motion.name, radius);
        let (body, drawn_as) = drawn.map_err(|error| super::told(motion.name, &[], error))?;
        let surroundings = match (self.kind, self.ceiling) {
            ("top", _) => Surroundings::Pivot,
            ("meteorite" | "strip", _) => Surroundings::Space,
            ("yo-yo", _) => Surroundings::String,
            ("superball", Some(ceiling)) => Surroundings::Under(ceiling + 2.0 * radius),
            _ => Surroundings::Floor,
        };
        let title = Path::new(motion.name).file_stem().unwrap_or_default();
        let title = title.to_str().unwrap_or("motion");
        Ok(Film {
            title,
            body,
            drawn_as,
            surroundings,
            speed,
            shots,
        })
    }

    /// The body along its axes, and what it is drawn as.
    fn drawn(&self, name: &str, radius: f64) -> Refusable<(Body, &'static str)> {
        let given = &self.body;
        let ball = |r: f64| Body::ellipsoid(Vector::zeros(), Matrix3::identity() * r);
        let wheel = |half: f64| Body::turned(&[[-half, radius], [half, radius]]);
        let word = given.shape.as_deref();
        match (self.kind, word) {
            ("strip", _) => {
                let thick = given.thickness_ratio.max(0.02);
                let edges = Vector::new(1.0, 2.0, thick) * given.width;
                return Ok((Body::cuboid(edges), "a strip, its length cut short"));
            }
            ("yo-yo", _) => {
                let inertia = given.inertia.as_ref().and_then(toml::Value::as_float);
                let of_inertia = || Some((2.0 * inertia? / given.mass?).sqrt());
                let radius = given.radius.or_else(of_inertia).unwrap_or(1.0);
                let half = 0.4 * radius;
                return Ok((Body::turned(&[[-half, radius], [half, radius]]), "a yo-yo"));
            }
            ("spool", _) => return Ok((wheel(0.6 * radius), "a spool")),
            ("roller" | "superball", Some("cylinder")) => {
                return Ok((wheel(radius), "a cylinder"));
            }
            ("roller" | "superball", Some("disc" | "hoop")) => {
                return Ok((wheel(0.15 * radius), "a wheel"));
            }
            ("roller" | "superball", _) => return Ok((ball(radius), "a ball")),
            _ => (),
        }
        let Some(word) = word else {
            return self.shapeless();
        };
        let (body, center) = match word {
            "hoop" | "disc" => (Body::turned(&[[0.0, radius]]), Vector::zeros()),
            "cylinder" => {
                let half = 0.5 * given.height;
                (
                    Body::turned(&[[-half, radius], [half, radius]]),
                    Vector::zeros(),
                )
            }
            "cone" => {
                let tip_and_base = [[0.0, 0.0], [given.height, radius]];
                (
                    Body::turned(&tip_and_base),
                    Vector::z() * (0.75 * given.height),
                )
            }
            "cuboid" => (Body::cuboid(given.edges.into()), Vector::zeros()),
            "ellipsoid" | "egg" => {
                let egg = [given.short, given.short, given.long];
                let half = Vector::from(given.semi_axes.unwrap_or(egg));
                let half = Matrix3::from_diagonal(&half);
                (Body::ellipsoid(Vector::zeros(), half), Vector::zeros())
            }
            "racket" => {
                let [rim, end] = [given.head, given.head + given.handle].map(|x| -Vector::x() * x);
                let racket = shapes::racket(1.0, given.head, given.handle)?;
                let body = Body::turned(&[[0.0, given.head]]).bar(rim, end);
                (body, racket.center().components())
            }
            "ball-without-cap" => {
                let height = radius + given.cut;
                let level = |k: u32| {
                    let z = -radius + height * 0.5 * (1.0 - (PI * f64::from(k) / 16.0).cos());
                    [z, (radius * radius - z * z).max(0.0).sqrt()]
                };
                let levels: Vec<[f64; 2]> = (0..=16).map(level).collect();
                let cut = shapes::ball_without_cap(1.0, radius, given.cut)?;
                (Body::turned(&levels), cut.center().components())
            }
            "ball-with-weight" => {
                let at = Vector::from(given.weight_at);
                (ball(radius).bar(Vector::zeros(), at), at * given.weight)
            }
            "beads" => {
                let part = |k: usize| given.parts.get(k).copied().unwrap_or(1.0);
                let places = || given.places.iter().map(|&place| Vector::from(place));
                let sum: Vector = places().enumerate().map(|(k, place)| place * part(k)).sum();
                let center = sum / (0..given.places.len()).map(part).sum::<f64>();
                let bars = places().fold(Body::default(), |body, bead| body.bar(center, bead));
                (bars, center)
            }
            "mesh" => {
                // It was there when the scene was read.
                let bytes = beside(name)(&given.file).unwrap_or_default();
                let mesh = match given.file.to_lowercase().ends_with("stl") {
                    true => mesh_of_stl(&bytes),
                    false => mesh_of_obj(&String::from_utf8_lossy(&bytes)),
                };
                let (vertices, triangles) = mesh?;
                let solid = mesh_mass_properties(&vertices, &triangles, 1.0)?;
                let half = of_inertia(&solid.inertia(), solid.mass(), Vector::zeros())?;
                let center = solid.center().components();
                (Body::ellipsoid(center, half), center)
            }
            _ => (ball(radius), Vector::zeros()),
        };
        let held = given.pivot.map_or(center, Vector::from);
        Ok((
            body.moved(-held),
            if word == "mesh" {
                OF_INERTIA
            } else {
                "its shape"
            },
        ))
    }

    /// A body without a shape: the surface that it stands on, or the ellipsoid of its mass and moments.
    fn shapeless(&self) -> Refusable<(Body, &'static str)> {
        let given = &self.body;
        let surface = given.semi_axes.or(given.radius.map(|radius| [radius; 3]));
        if let Some(axes) = surface {
            let turn = UnitQuaternion::from_scaled_axis(Vector::z() * given.surface_turn);
            let half = turn.to_rotation_matrix() * Matrix3::from_diagonal(&axes.into());
            let middle = Vector::from(given.surface_center);
            return Ok((
                Body::ellipsoid(middle, half).bar(Vector::zeros(), middle),
                "its surface",
            ));
        }
        let inertia: Option<[f64; 6]> = given
            .inertia
            .clone()
            .and_then(|value| value.try_into().ok());
        let matrix = match (given.moments, inertia) {
            (Some([a, b, c]), _) => InertiaMatrix::diagonal(a, b, c)?,
            (None, Some([a, b, c, ab, ac, bc])) => {
                InertiaMatrix::from_matrix(Matrix3::new(a, ab, ac, ab, b, bc, ac, bc, c))?
            }
            (None, None) => InertiaMatrix::diagonal(1.0, 1.0, 1.0)?,
        };
        let center = given.center_of_mass.filter(|_| given.mass.is_some());
        let center = center.map_or(Vector::zeros(), Vector::from);
        let half = of_inertia(&matrix, given.mass.unwrap_or(1.0), center)?;
        let body = Body::ellipsoid(center, half).bar(Vector::zeros(), center);
        Ok((body, OF_INERTIA))
    }
}

const OF_INERTIA: &str = "its ellipsoid of inertia";

/// The half axes of the homogeneous ellipsoid of this mass and inertia matrix, which is about a point from which the centre of mass is seen here.
fn of_inertia(matrix: &InertiaMatrix, mass: f64, center: Vector) -> Refusable<Matrix3<f64>> {
    let second = matrix.second_moments() - center * center.transpose() * mass;
    let axes = principal_axes_of(&second)?;
    let half = axes
        .moments()
        .map(|moment| (5.0 * moment.max(0.0) / mass).sqrt());
    Ok(axes.axes() * Matrix3::from_diagonal(&half.into()))
}

/// The first and the last of the times that are asked for.
fn ends(motion: &Motion<'_>) -> [f64; 2] {
    let times = motion.request.times().iter();
    let [least, greatest] = [f64::INFINITY, f64::NEG_INFINITY];
    times.fold([least, greatest], |[low, high], &t| {
        [low.min(t), high.max(t)]
    })
}

/// Pictures in a second of a film, and most bytes of one.
const PER_SECOND: f64 = 25.0;
const MOST_BYTES: f64 = 390_000.0;
/// Pictures that are drawn to see how large they are.
const TRIED: usize = 12;
/// How long a film lasts by itself, and may last, s.
const LASTS: f64 = 10.0;
const MAY_LAST: [f64; 2] = [1.0, 60.0];

/// Runs a scene, which tells the [`columns`], and films it. Says so if it turns too fast for the pictures.
///
/// # Errors
/// [`Error::Input`] for a single time and for a speed at which the film would be too short or too long; what [`run`](super::run) says.
pub fn film(motion: &Motion<'_>, seen: &Seen, speed: Option<f64>) -> Result<Vec<u8>> {
    let [first, last] = ends(motion);
    let span = last - first;
    if span <= 0.0 {
        let told = "expected times that go on, `until` in [run], for a film";
        return Err(Error::Input(format!("--film: {}: {told}", motion.name)));
    }
    let speed = speed.unwrap_or(span / LASTS);
    let seconds = span / speed;
    let [shortest, longest] = MAY_LAST;
    if !(shortest..=longest).contains(&seconds) {
        let [slow, fast] = [longest, shortest].map(|seconds| span / seconds);
        return Err(Error::Input(format!(
            "--speed: {} lasts {span:?} s, expected a speed from {slow:.3e} to {fast:.3e}, got {speed:?}: a film takes from {shortest} s to {longest} s",
            motion.name
        )));
    }
    let paper = Look::default();
    // A few of its pictures tell how many there may be.
    let bytes = seen
        .film(motion, TRIED, speed)?
        .film(seconds)
        .file(paper)
        .len();
    let room = MOST_BYTES / bytes as f64 * TRIED as f64;
    let count = room.min(PER_SECOND * seconds).max(2.0) as usize;
    let film = seen.film(motion, count, speed)?;
    let fastest = film
        .shots
        .iter()
        .map(|shot| shot.omega.norm())
        .fold(0.0, f64::max);
    let between = fastest * span / (count - 1) as f64;
    if between > FRAC_PI_2 {
        // Nothing is left to be done if standard error is closed.
        let _ = writeln!(
            std::io::stderr(),
            "warning: {}: it turns by up to {between:.1} rad from one picture to the next, which no eye can follow; a smaller --speed or a shorter run shows it",
            motion.name
        );
    }
    Ok(film.film(seconds).file(paper).into_bytes())
}

/// Most stills.
const MOST_STILLS: usize = 10_000;

/// How many stills go into which folder: `--frames DIR N`.
#[derive(Debug)]
pub struct Stills {
    folder: PathBuf,
    count: usize,
}

impl Stills {
    /// What stands after the option.
    ///
    /// # Errors
    /// [`Error::Input`] for a number that is none, and for a folder that has something in it, or is none.
    pub fn of(folder_and_count: &[OsString]) -> Result<Option<Self>> {
        let [folder, count] = folder_and_count else {
            return Ok(None);
        };
        let refused = |told: String| Error::Input(format!("--frames: {told}"));
        let number = count.to_str().and_then(|count| count.parse().ok());
        let Some(count) = number.filter(|count| (1..=MOST_STILLS).contains(count)) else {
            let count = count.display();
            let told = format!("N is '{count}', expected a whole number from 1 to {MOST_STILLS}");
            return Err(refused(told));
        };
        let folder = PathBuf::from(folder);
        let empty = std::fs::read_dir(&folder).map(|mut inside| inside.next().is_none());
        if folder.exists() && !empty.unwrap_or(false) {
            let folder = folder.display();
            return Err(refused(format!(
                "DIR is {folder}, expected an empty folder or a new one"
            )));
        }
        can_be_written_into(folder_of(&folder))?;
        Ok(Some(Self { folder, count }))
    }

    /// Runs a scene, which tells the [`columns`], and draws it at equal steps of time. All of the folder is there at the end, or nothing.
    ///
    /// # Errors
    /// [`Error::File`]; as for [`file`](file()) and [`run`](super::run).
    pub fn draw(&self, motion: &Motion<'_>, seen: &Seen, form: Form) -> Result<String> {
        let Self { folder, count } = self;
        let film = seen.film(motion, *count, 1.0)?;
        let parent = folder_of(folder);
        std::fs::create_dir_all(parent).map_err(Error::file(parent))?;
        let beside = Unfinished::folder(parent).map_err(Error::file(parent))?;
        let done = AtomicUsize::new(0);
        let how_far = || {
            let done = done.load(Ordering::Relaxed);
            (
                done as f64 / *count as f64,
                format!("drawn: {done} of {count} stills"),
            )
        };
        let copying = Copying::of(form);
        let digits = count.to_string().len();
        watched(how_far, || {
            for (k, figure) in film.stills().enumerate() {
                let name = format!("{:0digits$}.{}", k + 1, form.ending());
                let path = beside.path().join(name);
                std::fs::write(&path, file(&figure, copying)?).map_err(Error::file(&path))?;
                done.fetch_add(1, Ordering::Relaxed);
            }
            Ok::<_, Error>(())
        })?;
        // An empty folder gives way.
        let _ = std::fs::remove_dir(folder);
        beside.become_file(folder).map_err(Error::file(folder))?;
        Ok(format!("{count} stills in {}\n", folder.display()))
    }
}
