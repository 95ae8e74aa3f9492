//! `kind = "meteorite"`, `"roller"`, `"spool"`, `"superball"`: bodies that strike, skid, roll and bounce (4.2 to 4.6).

use core::f64::consts::PI;

use nalgebra::Vector3;

use super::body::{Matter, Round, not_beyond};
use super::file::*;
use crate::impacts::{Meteorite, Planet};
use crate::rolling::{RoundBody, SheetSpeeds, Spool};
use crate::scene::{Roller, StruckPlanet, Superball, TuggedSpool};
use crate::superball::{InFlight, Motion};

section! { RoundKeys
    mass: f64, "a mass in kg", Positive;
    radius: f64, "a radius in m", Positive;
    round: Round;
}

section! { Friction
    friction: Option<f64>, "the coefficient of friction of what slides, a ratio", NotNegative;
    static_friction: Option<f64>, "the coefficient of friction of what rolls, a ratio", NotNegative;
    rolling_resistance: Option<RollingResistance>, "the coefficient of rolling resistance, a ratio", NotNegative;
}

impl RoundKeys {
    fn made(&self, file: &Reader<'_>) -> Option<RoundBody> {
        let body = RoundBody::new(self.mass, self.radius, self.round.kappa(file)?);
        file.right("body.inertia_factor", body)
    }
}

impl Friction {
    fn acting(&self, file: &Reader<'_>) -> Option<Vec<Acting>> {
        if self.friction.is_none() && self.static_friction.is_some() {
            return file.wrong("effects.static_friction", " needs `friction` beside it");
        }
        let grip = |kinetic| self.static_friction.unwrap_or(kinetic);
        let law = (self.friction).map(|kinetic| Coulomb::with_grip(kinetic, grip(kinetic)));
        let keys = "effects.static_friction, effects.friction";
        let law = file.right(keys, law.transpose())?.map(Effect::from);
        let resistance = self.rolling_resistance.map(Effect::from);
        Some(vec![
            (keys, law),
            ("effects.rolling_resistance", resistance),
        ])
    }
}

tables! { RollerKeys
    [body]
    ball: RoundKeys;
    [initial]
    velocity: Option<f64>, "the speed of the centre in m/s";
    rim_speed: Option<f64>, "the speed RΩ of the rim in m/s";
    cue_height: Option<f64>, "the height of the cue above the table in radii, from 0 to 2";
    [effects]
    gravity: f64, "an acceleration in m/s²", Positive;
    friction: Friction;
    sheet_friction: Option<Coulomb>, "the coefficient of friction on the sheet, a ratio", NotNegative;
    sheet_times: Option<Vec<f64>>, "a list of times in s";
    sheet_speeds: Option<Vec<f64>>, "a list of speeds in m/s";
    sheet_margin: Option<f64>, "the way back from the ball to the edge, toward −x, in m", Positive;
}

impl RollerKeys {
    fn sheet(&self, file: &Reader<'_>) -> Option<Option<Sheet>> {
        let keys = "effects.sheet_friction, effects.sheet_times, effects.sheet_speeds, effects.sheet_margin";
        let course = self.sheet_times.as_ref().zip(self.sheet_speeds.as_ref());
        let sheet = course.zip(self.sheet_friction.zip(self.sheet_margin));
        let Some(((times, speeds), (law, margin))) = file.together(keys, sheet)? else {
            return Some(None);
        };
        if times.len() != speeds.len() {
            let (times, speeds) = (times.len(), speeds.len());
            let told = format!(" must be as many as sheet_times, {times}, got {speeds}");
            return file.wrong("effects.sheet_speeds", &told);
        }
        let points = times.iter().copied().zip(speeds.iter().copied());
        let speeds = SheetSpeeds::through(points.collect::<Vec<_>>());
        let speeds = file.right("effects.sheet_times", speeds)?;
        let sheet = Sheet::new(law, speeds, margin);
        file.right("effects.sheet_margin", sheet).map(Some)
    }
}

pub fn roller(file: &Reader<'_>, given: RollerKeys) -> Option<AnyScene> {
    let body = given.ball.made(file);
    let friction = given.friction.acting(file);
    let sheet = given.sheet(file);
    let (body, gravity) = (body?, given.gravity);
    let velocity = given.velocity.unwrap_or(0.0);
    let scene = match (given.rim_speed, given.cue_height) {
        (Some(_), Some(_)) => file.exclude("initial.rim_speed", "cue_height"),
        (None, Some(height)) if velocity > 0.0 => {
            let shot = body.strike(height, velocity);
            let scene = shot.and_then(|shot| Roller::after(&shot, gravity));
            file.right("initial.cue_height, initial.velocity", scene)
        }
        (None, Some(_)) => {
            let told = " must be a speed in m/s, positive, after a cue";
            file.wrong("initial.velocity", told)
        }
        (rim, None) => {
            let scene = Roller::new(body, gravity, velocity, rim.unwrap_or(0.0));
            file.right("initial.velocity, initial.rim_speed", scene)
        }
    };
    let mut acting = friction?;
    acting.push(("effects.sheet_margin", sheet?.map(Effect::from)));
    let scene = with(file, scene?, acting, Roller::with)?;
    let radius = given.ball.radius;
    let outline = given.ball.round.outline(radius);
    drawn(scene, move |told| on_the_table(&outline, radius, told))
}

fn on_the_table(body: &Outline, radius: f64, told: &Told<'_>) -> Sight {
    let [x, turned] = told.vector(["x", "turned"]);
    rolling(body, Around::Floor, [x, radius], Some(turned), told)
}

tables! { SpoolKeys
    [body]
    reel: RoundKeys;
    axle: f64, "the radius of the axle in m", Positive;
    [initial]
    velocity: f64 = 0.0, "the speed of the centre in m/s";
    rim_speed: f64 = 0.0, "the speed RΩ of the rim in m/s";
    [effects]
    gravity: f64, "an acceleration in m/s²", Positive;
    friction: Friction;
    tension: Option<f64>, "a force in N", NotNegative;
    tug_angle: Option<f64>, "the angle of the string above the horizontal in rad", From(0.0, PI);
}

pub fn spool(file: &Reader<'_>, given: SpoolKeys) -> Option<AnyScene> {
    let (radius, axle) = (given.reel.radius, given.axle);
    let body = given.reel.made(file);
    let friction = given.friction.acting(file);
    let tug = given.tension.zip(given.tug_angle);
    let tug = tug.map(|(tension, angle)| Tug::new(tension, angle));
    let tug = file.together("effects.tension, effects.tug_angle", tug);
    let tug = tug.and_then(|tug| file.right("effects.tug_angle", tug.transpose()));
    not_beyond(file, axle, radius)?;
    let reel = file.right("body.axle", Spool::new(body?, axle))?;
    let scene = TuggedSpool::new(reel, given.gravity);
    let scene = file.right("effects.gravity", scene)?;
    let keys = "effects.tension, effects.tug_angle, effects.gravity, body.mass";
    let tug = (keys, tug?.map(Effect::from));
    let scene = with(file, scene, vec![tug], TuggedSpool::with)?;
    let scene = with(file, scene, friction?, TuggedSpool::with)?;
    let side = || Solid::wheel(radius, 0.1 * radius);
    let to_side = Vector3::z() * (0.5 * radius);
    let outline = Outline::new("a spool", Solid::wheel(axle, radius))
        .and(side(), -to_side)
        .and(side(), to_side);
    let scene = scene.moving(given.velocity, given.rim_speed);
    drawn(scene, move |told| on_the_table(&outline, radius, told))
}

tables! { BallKeys
    [body]
    mass: f64, "a mass in kg", Positive;
    round: Round;
    [initial]
    height: f64, "a height in m", NotNegative;
    climb: f64 = 0.0, "the speed upward in m/s";
    velocity: f64 = 0.0, "the speed of the centre in m/s";
    rim_speed: f64 = 0.0, "the speed RΩ of the rim in m/s";
    [effects]
    gravity: Option<Gravity>, "an acceleration in m/s², not negative";
    ceiling: Option<f64>, "the height of the ceiling, less the diameter, in m", Positive;
    restitution: Option<f64>, "the coefficient of restitution upward, a ratio", From(0.0, 1.0);
    tangential_restitution: Option<f64>, "the coefficient of restitution along the floor, a ratio", From(-1.0, 1.0);
    grip: Option<Coulomb>, "the coefficient of friction at a bounce, a ratio, not negative";
}

pub fn superball(file: &Reader<'_>, given: BallKeys) -> Option<AnyScene> {
    let (height, climb, ceiling) = (given.height, given.climb, given.ceiling);
    let (velocity, rim_speed) = (given.velocity, given.rim_speed);
    let start = InFlight {
        position: 0.0,
        height,
        climb,
        motion: Motion {
            velocity,
            rim_speed,
        },
        bounces: 0,
    };
    let ball = Superball::new(given.mass, given.round.kappa(file)?, start);
    let ball = file.right("initial.height, initial.climb", ball)?;
    let ball = ball.under(ceiling.unwrap_or(f64::INFINITY));
    file.right("effects.ceiling, initial.height", ball.flight.checked())?;
    let (normal, along) = (given.restitution, given.tangential_restitution);
    let losses = Restitution::new(normal.unwrap_or(1.0), along.unwrap_or(1.0));
    let losses = file.right("effects.restitution", losses)?;
    let losses = normal.or(along).map(|_| losses.into());
    let mut acting = acting![given: gravity, grip];
    acting.push(("effects.restitution", losses));
    let ball = with(file, ball, acting, Superball::with)?;
    // The scene has a rim speed but no radius: the drawing takes one that fits the heights.
    let gravity = given.gravity.map(Gravity::value).filter(|&g| g > 0.0);
    let climbed = gravity.map_or(0.0, |g| 0.5 * climb.powi(2) / g);
    let room = ceiling.unwrap_or(height + climbed);
    let radius = if room > 0.0 { 0.06 * room } else { 0.05 };
    let under = |ceiling| Around::Under(ceiling + 2.0 * radius);
    let around = ceiling.map_or(Around::Floor, under);
    let outline = given.round.outline(radius);
    drawn(ball, move |told| {
        let [x, height, rim, l] = told.vector(["x", "height", "rim_speed", "l_over_radius"]);
        let sight = rolling(&outline, around, [x, height + radius], None, told);
        sight.turning(Vector3::y(), [rim / radius, l * radius])
    })
}

tables! { PlanetKeys
    [body]
    matter: Matter;
    [initial]
    velocity: Option<BodyVector>, "a velocity in m/s";
    omega: Option<BodyVector>, "an angular velocity in rad/s";
    [effects]
    impact_mass: Option<f64>, "the mass of the meteorite in kg", Positive;
    impact_velocity: Option<BodyVector>, "the velocity of the meteorite in m/s";
    impact_at: Option<BodyVector>, "the place of the impact, from the centre of the planet, in m";
}

pub fn meteorite(file: &Reader<'_>, given: PlanetKeys) -> Option<AnyScene> {
    let solid = given.matter.about_center(file)?;
    let outline = given.matter.outline(&solid);
    let outline = outline.moved(-solid.center().components());
    let still = BodyVector::zero();
    let [velocity, omega] = [given.velocity, given.omega].map(|given| given.unwrap_or(still));
    let planet = Planet::new(solid.mass(), solid.inertia(), velocity, omega);
    let mut planet = StruckPlanet::new(file.right("body.moments", planet)?);
    let keys = "effects.impact_mass, effects.impact_velocity, effects.impact_at";
    let impact = given.impact_mass.zip(given.impact_velocity);
    if let Some(((mass, velocity), at)) = file.together(keys, impact.zip(given.impact_at))? {
        let keys = "effects.impact_mass, effects.impact_velocity";
        let meteorite = file.right(keys, Meteorite::new(mass, velocity))?;
        let struck = planet.with(Impact { meteorite, at });
        planet = file.right("effects.impact_at", struck)?;
    }
    drawn(planet, move |told| posed(&outline, Around::Space, told))
}
