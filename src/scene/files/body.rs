//! The tables of a body: its shape with its sizes, or its moments or inertia matrix, and its mass or density.

use core::f64::consts::{PI, TAU};

use nalgebra::{Matrix3, Vector3};

use super::file::*;
use crate::error::Result;
use crate::inertia::{
    InertiaMatrix, MassProperties, mesh_mass_properties, mesh_of_obj, mesh_of_stl, shapes,
};
use crate::tippe_top::Surface;

// The keys of a rigid body: one of `shape`, `moments` and `inertia`.
section! { Matter
    mass: Option<f64>, "a mass in kg", Positive;
    shape: Option<Shape>, "a shape, ";
    density: Option<f64>, "the density of a shape, in place of its mass, in kg/m³ (of a shell or a disc in kg/m², of a hoop or a racket in kg/m)", Positive;
    moments: Option<[f64; 3]>, "principal moments in kg m²";
    inertia: Option<[f64; 6]>, "the inertia matrix I11 I22 I33 I12 I13 I23 in kg m²";
}

/// The message for a number that the shape already determines.
const FOLLOWS: &str = " follows from `shape`, which stands beside it";

/// The source of a body's inertia: a matrix or a shape.
pub(super) enum Inertia {
    Matrix(InertiaMatrix),
    Shape(MassProperties),
}

impl Matter {
    /// The key of the inertia.
    pub fn key(&self) -> &'static str {
        match (&self.shape, self.moments) {
            (Some(_), _) => "body.shape",
            (None, Some(_)) => "body.moments",
            (None, None) => "body.inertia",
        }
    }

    pub fn inertia(&self, file: &Reader<'_>) -> Option<Inertia> {
        let given = |matrix| file.right(self.key(), matrix).map(Inertia::Matrix);
        match (&self.shape, self.moments, self.inertia) {
            (Some(shape), None, None) => self.shaped(file, shape).map(Inertia::Shape),
            (None, ..) if self.density.is_some() => {
                file.wrong("body.density", " goes with `shape`, which is not there")
            }
            (None, Some([a, b, c]), None) => given(InertiaMatrix::diagonal(a, b, c)),
            (None, None, Some([a, b, c, ab, ac, bc])) => {
                let matrix = Matrix3::new(a, ab, ac, ab, b, bc, ac, bc, c);
                given(InertiaMatrix::from_matrix(matrix))
            }
            (None, None, None) => {
                let expected = "`moments` or `inertia` in kg m², or a `shape`";
                file.missing("body.moments", expected)
            }
            (Some(_), Some(_), _) => file.wrong("body.moments", FOLLOWS),
            (Some(_), ..) => file.wrong("body.inertia", FOLLOWS),
            (None, Some(_), Some(_)) => file.exclude("body.moments", "inertia"),
        }
    }

    /// The drawing of the body, along its axes from their origin.
    pub fn outline(&self, body: &MassProperties) -> Outline {
        if let Some(Some(outline)) = self.shape.as_ref().map(|shape| &shape.outline) {
            return outline.clone();
        }
        let about_origin = body.about(BodyVector::zero()).unwrap_or(body.inertia());
        let center = body.center().components();
        Outline::of_inertia(about_origin.second_moments(), body.mass(), center)
    }

    fn shaped(&self, file: &Reader<'_>, shape: &Shape) -> Option<MassProperties> {
        let expected = "the `mass` of the shape in kg, or its `density`,";
        let mass = match (self.mass, self.density, shape.measure) {
            (Some(mass), None, _) => Some(mass),
            (None, Some(density), Some(measure)) => Some(density * measure),
            (None, Some(_), None) => file.wrong("body.density", " is of no use: beads have a mass"),
            (Some(_), Some(_), _) => file.exclude("body.density", "mass"),
            (None, None, _) => file.missing("body.mass", expected),
        };
        file.right("body.shape", (shape.made)(mass?))
    }

    /// Mass and inertia, for a body whose inertia is about its centre of mass.
    pub fn about_center(&self, file: &Reader<'_>) -> Option<MassProperties> {
        let inertia = match self.inertia(file)? {
            Inertia::Shape(shaped) => return Some(shaped),
            Inertia::Matrix(matrix) => matrix,
        };
        let Some(mass) = self.mass else {
            return file.missing("body.mass", "a mass in kg, positive,");
        };
        let made = MassProperties::new(mass, BodyVector::zero(), inertia);
        file.right(self.key(), made)
    }
}

/// A shape with its sizes, along axes of its own from an origin of its own.
pub(super) struct Shape {
    /// Makes the body from its mass.
    made: Box<dyn Fn(f64) -> Result<MassProperties>>,
    /// Its volume (m³), area (m²) or length (m), to be multiplied by its density.
    measure: Option<f64>,
    /// The surface on which it can stand, about its origin.
    pub surface: Option<Result<Surface>>,
    /// Its drawing; none for a mesh.
    outline: Option<Outline>,
}

impl Shape {
    fn new(
        measure: impl Into<Option<f64>>,
        outline: impl Into<Option<Outline>>,
        made: impl Fn(f64) -> Result<MassProperties> + 'static,
    ) -> Self {
        Self {
            made: Box::new(made),
            measure: measure.into(),
            surface: None,
            outline: outline.into(),
        }
    }

    fn on(mut self, surface: Result<Surface>) -> Self {
        self.surface = Some(surface);
        self
    }
}

/// The drawing of one solid about the origin.
fn centered(solid: Solid) -> Outline {
    Outline::new("its shape", solid)
}

/// Makes a shape from its sizes.
type Known = fn(&Table<'_>) -> Option<Shape>;

/// Declares the shapes, each with the keys of its sizes below it.
macro_rules! shapes {
    ($table:ident: $($name:literal => $made:expr; $($size:ident: $type:ty, $what:expr $(, $bound:expr)?;)*)*) => {
        impl Word for Known {
            fn words() -> Vec<(&'static str, Self)> {
                vec![$(($name, |$table| {
                    $(let $size = key!($table, $size: $type, $what $(, $bound)?);)*
                    $(let $size = $size?;)*
                    $made
                })),*]
            }
        }
    };
}

// Where nothing else is said, the origin is the centre, and an axis of symmetry the third.
shapes! { table:
    "ball" => Some(round(radius, 4.0 / 3.0 * PI * radius * radius * radius, move |m| shapes::ball(m, radius)));
    radius: f64, "the radius in m", Positive;

    "shell" => Some(round(radius, 4.0 * PI * radius * radius, move |m| shapes::spherical_shell(m, radius)));
    radius: f64, "the radius in m", Positive;

    "hoop" => Some(Shape::new(TAU * radius, centered(Solid::wheel(radius, 0.0)), move |m| shapes::hoop(m, radius)));
    radius: f64, "the radius in m", Positive;

    "disc" => Some(Shape::new(PI * radius * radius, centered(Solid::wheel(radius, 0.0)), move |m| shapes::disc(m, radius)));
    radius: f64, "the radius in m", Positive;

    "cylinder" => Some(Shape::new(PI * radius * radius * height, centered(Solid::wheel(radius, height)), move |m| shapes::cylinder(m, radius, height)));
    radius: f64, "the radius in m", Positive;
    height: f64, "the height along axis 3 in m, from the centre both ways", Positive;

    "cone" => Some(cone(radius, height));
    radius: f64, "the radius of the base in m", Positive;
    height: f64, "the height along axis 3 in m, from the tip, which is the origin, to the base", Positive;

    "cuboid" => Some(Shape::new(edges.iter().product::<f64>(), centered(Solid::Cuboid(edges.into())), move |m| shapes::cuboid(m, edges)));
    edges: [f64; 3], "the edges along the three axes in m", Positive;

    "ellipsoid" => Some(ellipsoid(semi_axes));
    semi_axes: [f64; 3], "the semi-axes in m", Positive;

    "egg" => Some(ellipsoid([short, short, long]));
    long: f64, "half its length, along axis 3, in m", Positive;
    short: f64, "half its width in m", Positive;

    // The origin is the centre of the ring.
    "racket" => Some(racket(head, handle));
    head: f64, "the radius of the ring in m, all of one wire", Positive;
    handle: f64, "the length of the handle in m, along axis 1; axis 3 is normal to the ring", NotNegative;

    "ball-without-cap" => without_cap(table.reader, radius, cut);
    radius: f64, "the radius in m", Positive;
    cut: f64, "the place of the cut on axis 3 in m from the centre of the ball, which is the origin; what is above is missing, but on a table it stands and rolls on the whole ball";

    "ball-with-weight" => with_weight(table.reader, radius, weight, weight_at);
    radius: f64, "the radius in m", Positive;
    weight: f64, "the part of the mass that is the weight, a point", From(0.0, 1.0);
    weight_at: BodyVector, "the place of the weight in m from the centre of the ball, which is the origin";

    "beads" => beads(table.reader, places, parts);
    places: Vec<BodyVector>, "the places of the beads in m, a list of lists of 3 numbers";
    parts: Option<Vec<f64>>, "the shares of the beads in the mass, in any unit (all the same by default)", Positive;

    "mesh" => mesh(table.reader, &file);
    file: String, "the file of a closed mesh in m, STL or OBJ by its ending, beside the scene file; it has the origin and the axes";
}

impl Value for Shape {
    fn expected(key: &Key) -> String {
        Known::expected(key)
    }

    fn read(place: &Place<'_>) -> Option<Self> {
        let known = Known::read(place);
        if known.is_none() {
            // Without a known shape no size can be called wrong.
            place.table.takes_any.set(true);
        }
        known?(place.table)
    }
}

/// Reads the sizes of every shape, each from a table with the shape's name.
pub(super) fn read_all_shapes(reader: &Reader<'_>) {
    for (name, shape) in Known::words() {
        shape(&Table::new(reader, name.to_owned()));
    }
}

fn cone(radius: f64, height: f64) -> Shape {
    let volume = PI / 3.0 * radius * radius * height;
    let center = BodyVector::new(0.0, 0.0, 0.75 * height);
    let made = move |mass| shapes::cone(mass, radius, height)?.moved(center);
    let tip_and_base = vec![[0.0, 0.0], [height, radius]];
    Shape::new(volume, centered(Solid::Turned(tip_and_base)), made)
}

fn round(r: f64, measure: f64, made: impl Fn(f64) -> Result<MassProperties> + 'static) -> Shape {
    Shape::new(measure, centered(Solid::ball(r)), made).on(Surface::sphere(r))
}

fn racket(head: f64, handle: f64) -> Shape {
    let made = move |mass| shapes::racket(mass, head, handle);
    let [rim, shaft] = [head, handle].map(|length| Vector3::x() * -length);
    let outline = centered(Solid::wheel(head, 0.0)).and(Solid::Bar(shaft), rim);
    Shape::new(TAU * head + handle, outline, made)
}

fn ellipsoid(semi_axes: [f64; 3]) -> Shape {
    let volume = 4.0 / 3.0 * PI * semi_axes.iter().product::<f64>();
    let made = move |mass| shapes::ellipsoid(mass, semi_axes);
    let half = Matrix3::from_diagonal(&semi_axes.into());
    Shape::new(volume, centered(Solid::Ellipsoid(half)), made).on(Surface::ellipsoid(semi_axes))
}

fn without_cap(file: &Reader<'_>, radius: f64, cut: f64) -> Option<Shape> {
    file.right("body.cut", shapes::ball_without_cap(1.0, radius, cut))?;
    let height = radius + cut;
    let volume = PI * height * height * (radius - height / 3.0);
    let level = |k: u32| {
        let z = -radius + height * 0.5 * (1.0 - (PI * f64::from(k) / 16.0).cos());
        [z, (radius * radius - z * z).max(0.0).sqrt()]
    };
    let made = move |mass| shapes::ball_without_cap(mass, radius, cut);
    let outline = centered(Solid::Turned((0..=16).map(level).collect()));
    Some(Shape::new(volume, outline, made).on(Surface::sphere(radius)))
}

fn with_weight(
    file: &Reader<'_>,
    radius: f64,
    weight: f64,
    weight_at: BodyVector,
) -> Option<Shape> {
    if weight_at.norm() > radius {
        let told = format!(" must be within the ball, of radius {radius:?} m");
        return file.wrong("body.weight_at", &told);
    }
    let made = move |mass: f64| match weight {
        0.0 => shapes::ball(mass, radius),
        1.0 => MassProperties::particle(mass, weight_at),
        part => MassProperties::compose(&[
            shapes::ball(mass * (1.0 - part), radius)?,
            MassProperties::particle(mass * part, weight_at)?,
        ]),
    };
    // The density is that of the ball.
    let whole = 4.0 / 3.0 * PI * radius * radius * radius / (1.0 - weight);
    let weight = Solid::Bar(weight_at.components());
    let outline = centered(Solid::ball(radius)).and(weight, Vector3::zeros());
    Some(Shape::new(whole, outline, made).on(Surface::sphere(radius)))
}

fn beads(file: &Reader<'_>, places: Vec<BodyVector>, parts: Option<Vec<f64>>) -> Option<Shape> {
    let parts = parts.unwrap_or_else(|| vec![1.0; places.len()]);
    if places.is_empty() {
        return file.wrong("body.places", " must have one bead at least");
    }
    if parts.len() != places.len() {
        let (beads, shares) = (places.len(), parts.len());
        let told = format!(" must be as many as places, {beads}, got {shares}");
        return file.wrong("body.parts", &told);
    }
    let all: f64 = parts.iter().sum();
    let weighed = places.iter().zip(&parts);
    let weighed = weighed.map(|(at, part)| at.components() * (part / all));
    let center: Vector3<f64> = weighed.sum();
    let bar = |bead: &BodyVector| (Solid::Bar(bead.components() - center), center.into());
    let outline = Outline {
        drawn_as: "its shape",
        solids: places.iter().map(bar).collect(),
    };
    let made = move |mass: f64| {
        let beads = places.iter().zip(&parts);
        let beads = beads.map(|(at, part)| MassProperties::particle(mass * (part / all), *at));
        MassProperties::compose(&beads.collect::<Result<Vec<_>>>()?)
    };
    Some(Shape::new(None, outline, made))
}

fn mesh(file: &Reader<'_>, name: &str) -> Option<Shape> {
    const KEY: &str = "body.file";
    let refused = |told: String| file.wrong::<()>(KEY, &format!(": {name}: {told}"));
    let bytes = (file.open)(name).map_err(refused).ok()?;
    let mesh = match name.rsplit('.').next().map(str::to_lowercase).as_deref() {
        Some("stl") => mesh_of_stl(&bytes),
        Some("obj") => mesh_of_obj(&String::from_utf8_lossy(&bytes)),
        _ => return file.wrong(KEY, &format!(" must end in .stl or .obj, got {name}")),
    };
    let solid = mesh.and_then(|(at, triangles)| mesh_mass_properties(&at, &triangles, 1.0));
    let solid = solid.map_err(|error| refused(error.to_string())).ok()?;
    let made = move |mass: f64| {
        let inertia = solid.inertia().matrix() * (mass / solid.mass());
        MassProperties::new(mass, solid.center(), InertiaMatrix::from_matrix(inertia)?)
    };
    Some(Shape::new(solid.mass(), None, made))
}

// The shape of a rolling body, or what stands for it.
section! { Round
    shape: Option<RoundShape>, "";
    inertia_factor: Option<f64>, "I/MR², a ratio (0.4 if there is no shape either)", UpTo(1.0);
}

/// I/MR², and the width of the drawing, in radii, unless it is a ball.
#[derive(Debug, Clone, Copy)]
pub(super) struct RoundShape(f64, Option<f64>);

impl Word for RoundShape {
    fn words() -> Vec<(&'static str, Self)> {
        vec![
            ("ball", Self(0.4, None)),
            ("shell", Self(2.0 / 3.0, None)),
            ("cylinder", Self(0.5, Some(2.0))),
            ("disc", Self(0.5, Some(0.3))),
            ("hoop", Self(1.0, Some(0.3))),
        ]
    }
}

impl Round {
    /// The inertia factor: the given one, that of the shape, or that of a ball.
    pub fn kappa(&self, file: &Reader<'_>) -> Option<f64> {
        match (self.inertia_factor, self.shape) {
            (Some(_), Some(_)) => file.wrong("body.inertia_factor", FOLLOWS),
            (factor, None) => Some(factor.unwrap_or(0.4)),
            (None, Some(RoundShape(factor, _))) => Some(factor),
        }
    }

    /// The drawing of a rolling body.
    pub fn outline(&self, radius: f64) -> Outline {
        match self.shape.and_then(|RoundShape(_, width)| width) {
            None => Outline::new("a ball", Solid::ball(radius)),
            Some(width) => Outline::new("a wheel", Solid::wheel(radius, width * radius)),
        }
    }
}

/// Records an axle that is thicker than its wheel.
pub(super) fn not_beyond(file: &Reader<'_>, axle: f64, radius: f64) -> Option<()> {
    if axle > radius {
        let told = format!(" must not exceed `radius`, {radius:?}, got {axle:?}");
        return file.wrong("body.axle", &told);
    }
    Some(())
}
