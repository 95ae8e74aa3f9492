//! `kind = "table-top"`: a body that stands on a table (4.7).

use nalgebra::{Matrix3, Vector3};

use super::body::Matter;
use super::file::*;
use crate::scene::contact::TableTop;
use crate::tippe_top::{ConvexBody, Start, Surface};

tables! { TableTopKeys
    [body]
    matter: Matter;
    stands_on: Option<StandsOn>;
    [initial]
    tilt: Option<f64>, "the angle of the third axis to the vertical in rad";
    azimuth: Option<f64>, "the azimuth of the vertical along the body's axes in rad";
    vertical_spin: Option<f64>, "an angular velocity about the vertical in rad/s";
    axial_spin: Option<f64>, "an angular velocity about the third axis in rad/s";
    attitude: Option<Attitude>, "a unit quaternion w x y z";
    omega: Option<BodyVector>, "an angular velocity in rad/s";
    velocity: Option<[f64; 3]>, "a level velocity in m/s";
    [effects]
    gravity: Option<Gravity>, "an acceleration in m/s²", Positive;
    friction_law: Option<Law>, "";
    friction: Option<f64>, "a coefficient of friction, s/m for the viscous law", NotNegative;
    friction_slip: Option<f64>, "the speed in m/s below which friction fades", Positive;
    rolling_resistance: Option<f64>, "the couple over reaction and level part of Ω, in m s", NotNegative;
    pivoting_resistance: Option<f64>, "the couple over reaction and vertical part of Ω, in m s", NotNegative;
}

// The surface of a body given without a shape.
section! { StandsOn
    radius: Option<f64>, "a radius in m", Positive;
    semi_axes: Option<[f64; 3]>, "semi-axes in m", Positive;
    surface_turn: f64 = 0.0, "the turn of the semi-axes about the third axis in rad";
    surface_center: Option<BodyVector>, "the place of the centre of the surface, from C, in m";
}

/// Absent beside a `shape`, which has a surface of its own.
impl Section for Option<StandsOn> {
    fn fields(table: &Table<'_>) -> Option<Self> {
        match table.entry("shape") {
            Some(_) => Some(None),
            None => StandsOn::fields(table).map(Some),
        }
    }
}

/// The law that `friction_law` names.
#[derive(Debug, Clone, Copy)]
pub(super) enum Law {
    Coulomb,
    Smoothed,
    Viscous,
    NoSlip,
}

impl Word for Law {
    fn words() -> Vec<(&'static str, Self)> {
        vec![
            ("coulomb", Self::Coulomb),
            ("smoothed", Self::Smoothed),
            ("viscous", Self::Viscous),
            ("no-slip", Self::NoSlip),
        ]
    }
}

pub fn table_top(file: &Reader<'_>, given: TableTopKeys) -> Option<AnyScene> {
    let made = given.made(file);
    let start = given.start(file);
    let law = given.law(file);
    let (rolling, pivoting) = (given.rolling_resistance, given.pivoting_resistance);
    let resistance = rolling
        .or(pivoting)
        .map(|_| Resistance::new(rolling.unwrap_or_default(), pivoting.unwrap_or_default()));
    let resistance = file.right("effects.rolling_resistance", resistance.transpose());
    let (body, outline) = made?;
    let scene = TableTop::new(body, start?);
    let mut acting = acting![given: gravity];
    acting.push(("effects.friction_law", law?));
    acting.push(("effects.rolling_resistance", resistance?.map(Effect::from)));
    let scene = with(file, scene, acting, TableTop::with)?;
    drawn(scene, move |told| posed(&outline, Around::Floor, told))
}

impl TableTopKeys {
    fn made(&self, file: &Reader<'_>) -> Option<(ConvexBody, Outline)> {
        let matter = &self.matter;
        let solid = matter.about_center(file);
        let Some(own) = &self.stands_on else {
            let Some(surface) = &matter.shape.as_ref()?.surface else {
                let told = " must have a smooth surface to stand on: a ball, with a weight or without a cap, a shell, an egg or an ellipsoid";
                return file.wrong("body.shape", told);
            };
            let (solid, surface) = (solid?, file.right("body.shape", surface.clone())?);
            let made = ConvexBody::new(solid.mass(), solid.inertia(), surface, -solid.center());
            let outline = matter.outline(&solid).moved(-solid.center().components());
            return Some((file.right("body.shape", made)?, outline));
        };
        let (surface, solid) = (own.surface(file)?, solid?);
        let made = ConvexBody::new(solid.mass(), solid.inertia(), surface, own.center());
        Some((file.right(matter.key(), made)?, own.outline()))
    }

    fn start(&self, file: &Reader<'_>) -> Option<Start> {
        let [tilt, azimuth] = [self.tilt, self.azimuth].map(Option::unwrap_or_default);
        let tilted = self.tilt.or(self.azimuth).is_some();
        let start = match (self.vertical_spin, self.axial_spin, self.omega) {
            (None, None, Some(_)) if tilted => {
                file.wrong("initial.omega", " goes with `attitude`, not with `tilt`")
            }
            (None, None, Some(omega)) => {
                let attitude = self.attitude.unwrap_or_else(Attitude::identity);
                file.right("initial.omega", Start::spinning(attitude, omega))
            }
            (Some(_), None, None) | (None, Some(_), None) if self.attitude.is_some() => {
                file.wrong("initial.attitude", " goes with `omega`, not with a spin")
            }
            (Some(spin), None, None) => {
                let start = Start::about_vertical(tilt, azimuth, spin);
                file.right("initial.vertical_spin", start)
            }
            (None, Some(spin), None) => {
                let start = Start::about_third_axis(tilt, azimuth, spin);
                file.right("initial.axial_spin", start)
            }
            _ => {
                let told = " or `axial_spin` or `omega` is expected, exactly one of the three";
                file.wrong("initial.vertical_spin", told)
            }
        }?;
        let velocity = match (self.velocity, self.friction_law) {
            (Some(given), Some(Law::NoSlip)) if given != [0.0; 3] => {
                let told = " follows from the angular velocity where nothing slips";
                return file.wrong("initial.velocity", told);
            }
            (Some([.., climb]), _) if climb != 0.0 => {
                let told = " must be level, its third number 0: the body begins on the table";
                return file.wrong("initial.velocity", told);
            }
            (given, _) => given.map_or(start.velocity, Into::into),
        };
        Some(Start { velocity, ..start })
    }

    fn law(&self, file: &Reader<'_>) -> Option<Option<Effect>> {
        let law = match (self.friction_law, self.friction, self.friction_slip) {
            (None, None, None) => return Some(None),
            (None, ..) => {
                let told = " is missing: it says what `friction` means";
                return file.wrong("effects.friction_law", told);
            }
            (Some(Law::Coulomb), Some(mu), None) => Coulomb::new(mu).map(Effect::from),
            (Some(Law::Smoothed), Some(mu), Some(slip)) => {
                Regularised::new(mu, slip).map(Effect::from)
            }
            (Some(Law::Viscous), Some(c), None) => Viscous::new(c).map(Effect::from),
            (Some(Law::NoSlip), None, None) => Ok(NoSlip.into()),
            _ => {
                let told = " \"coulomb\" and \"viscous\" need `friction`, \"smoothed\" `friction_slip` as well, \"no-slip\" neither";
                return file.wrong("effects.friction_law", told);
            }
        };
        file.right("effects.friction", law).map(Some)
    }
}

impl StandsOn {
    fn center(&self) -> BodyVector {
        self.surface_center.unwrap_or_else(BodyVector::zero)
    }

    /// The drawing of a body: its surface about the surface's centre, and a bar from C to that centre.
    fn outline(&self) -> Outline {
        let half = self.semi_axes.unwrap_or([self.radius.unwrap_or(1.0); 3]);
        let turn = about(Vector3::z(), self.surface_turn).to_rotation_matrix();
        let surface = Solid::Ellipsoid(turn * Matrix3::from_diagonal(&half.into()));
        let center = self.center().components();
        Outline::new("its surface", surface)
            .moved(center)
            .and(Solid::Bar(center), Vector3::zeros())
    }

    fn surface(&self, file: &Reader<'_>) -> Option<Surface> {
        let surface = match (self.radius, self.semi_axes) {
            (Some(radius), None) => file.right("body.radius", Surface::sphere(radius)),
            (None, Some(axes)) => file.right("body.semi_axes", Surface::ellipsoid(axes)),
            (Some(_), Some(_)) => file.exclude("body.radius", "semi_axes"),
            (None, None) => file.missing("body.radius", "either `radius` or `semi_axes` in m"),
        }?;
        if self.surface_turn == 0.0 {
            return Some(surface);
        }
        let turn = Attitude::about_axis(BodyVector::new(0.0, 0.0, 1.0), self.surface_turn);
        Some(surface.turned(&file.right("body.surface_turn", turn)?))
    }
}
