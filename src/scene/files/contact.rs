//! `kind = "meteorite"`, `"roller"`, `"spool"`, `"superball"`: bodies that strike, skid, roll and bounce (4.2 to 4.6).

use nalgebra::Vector3;

use super::body::{Matter, Round, kappa};
use super::file::*;
use crate::impacts::{Meteorite, Planet};
use crate::rolling::{RoundBody, SheetSpeeds, Spool};
use crate::scene::{Roller, StruckPlanet, Superball, TuggedSpool};
use crate::superball::{InFlight, Motion};

section! {
    /// `[body]` of a roller.
    RoundKeys {
        mass: f64, "a mass in kg", Positive;
        radius: f64, "a radius in m", Positive;
        shape: Option<Round>, "";
        inertia_factor: Option<f64>, "I/MR², a ratio (0.4 if there is no shape either)", UpTo(1.0);
    }

    /// `[initial]` of a roller.
    RollerInitial {
        velocity: Option<f64>, "the speed of the centre in m/s";
        rim_speed: Option<f64>, "the speed RΩ of the rim in m/s";
        cue_height: Option<f64>, "the height of the cue above the table in radii";
    }

    /// The friction of a table.
    Friction {
        friction: Option<f64>, "the coefficient of friction of what slides, a ratio", NotNegative;
        static_friction: Option<f64>, "the coefficient of friction of what rolls, a ratio", NotNegative;
        rolling_resistance: Option<RollingResistance>, "the coefficient of rolling resistance, a ratio";
    }

    /// `[effects]` of a roller.
    RollerEffects {
        gravity: f64, "an acceleration in m/s²", Positive;
        friction: Friction, "";
        sheet_friction: Option<Coulomb>, "the coefficient of friction on the sheet, a ratio", NotNegative;
        sheet_times: Option<Vec<f64>>, "a list of times in s";
        sheet_speeds: Option<Vec<f64>>, "a list of speeds in m/s";
        sheet_margin: Option<f64>, "the way from the ball to the edge in m", Positive;
    }
}

impl RoundKeys {
    fn made(&self, file: &Reader<'_>) -> Option<RoundBody> {
        let kappa = kappa(file, self.inertia_factor, self.shape)?;
        let body = RoundBody::new(self.mass, self.radius, kappa);
        file.right("body.inertia_factor", body)
    }
}

impl Friction {
    fn listed(&self, file: &Reader<'_>) -> Option<[Option<Effect>; 2]> {
        if self.friction.is_none() && self.static_friction.is_some() {
            return file.wrong("effects.static_friction", " needs `friction` beside it");
        }
        let both = self.friction.zip(self.static_friction.or(self.friction));
        let law = both.map(|(kinetic, grip)| Coulomb::with_grip(kinetic, grip));
        let law = file.right("effects.static_friction, effects.friction", law.transpose())?;
        Some(listed![law, self.rolling_resistance])
    }
}

fn sheet(file: &Reader<'_>, effects: &RollerEffects) -> Option<Option<Sheet>> {
    let (law, margin) = (effects.sheet_friction, effects.sheet_margin);
    let (times, speeds) = (&effects.sheet_times, &effects.sheet_speeds);
    let (law, times, speeds, margin) = match (law, times, speeds, margin) {
        (Some(law), Some(times), Some(speeds), Some(margin)) => (law, times, speeds, margin),
        (None, None, None, None) => return Some(None),
        _ => {
            let keys = "effects.sheet_friction, effects.sheet_times, effects.sheet_speeds, effects.sheet_margin";
            return file.wrong(keys, " belong together");
        }
    };
    if times.len() != speeds.len() {
        let (times, speeds) = (times.len(), speeds.len());
        let told = format!(" must be as many as sheet_times, {times}, got {speeds}");
        return file.wrong("effects.sheet_speeds", told);
    }
    let points = times.iter().copied().zip(speeds.iter().copied());
    let speeds = SheetSpeeds::through(points.collect::<Vec<_>>());
    let speeds = file.right("effects.sheet_times", speeds);
    let sheet = Sheet::new(law, speeds?, margin);
    file.right("effects.sheet_margin", sheet).map(Some)
}

pub fn roller(file: &File<'_, RoundKeys, RollerInitial, RollerEffects>) -> Made<Roller> {
    let RoundKeys { radius, shape, .. } = file.body;
    let look = on_the_table(Round::outline(shape, radius), radius);
    let body = file.body.made(file);
    let friction = file.effects.friction.listed(file);
    let sheet = sheet(file, &file.effects);
    let (body, gravity) = (body?, file.effects.gravity);
    let velocity = file.initial.velocity.unwrap_or(0.0);
    let scene = match (file.initial.rim_speed, file.initial.cue_height) {
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
    let scene = with(file, scene?, friction?, Roller::with)?;
    Some((with(file, scene, listed![sheet?], Roller::with)?, look))
}

fn on_the_table(body: Outline, radius: f64) -> Look {
    rolling(body, Around::Floor, move |told| {
        let [x, turned] = told.vector(["x", "turned"]);
        ([x, radius], Some(turned))
    })
}

section! {
    /// `[body]` of a spool.
    SpoolBody {
        round: RoundKeys, "";
        axle: f64, "the radius of the axle in m", Positive;
    }

    /// `[initial]` of a spool.
    SpoolInitial {
        velocity: f64 = 0.0, "the speed of the centre in m/s";
        rim_speed: f64 = 0.0, "the speed RΩ of the rim in m/s";
    }

    /// `[effects]` of a spool.
    SpoolEffects {
        gravity: f64, "an acceleration in m/s²", Positive;
        friction: Friction, "";
        tension: Option<f64>, "a force in N", NotNegative;
        tug_angle: Option<f64>, "the angle of the string above the horizontal in rad";
    }
}

pub fn spool(file: &File<'_, SpoolBody, SpoolInitial, SpoolEffects>) -> Made<TuggedSpool> {
    let (radius, axle) = (file.body.round.radius, file.body.axle);
    let body = file.body.round.made(file);
    let friction = file.effects.friction.listed(file);
    let tug = match (file.effects.tension, file.effects.tug_angle) {
        (Some(tension), Some(angle)) => file
            .right("effects.tug_angle", Tug::new(tension, angle))
            .map(Some),
        (None, None) => Some(None),
        _ => file.wrong("effects.tension, effects.tug_angle", " belong together"),
    };
    if axle > radius {
        let told = format!(" must not exceed `radius`, {radius:?}, got {axle:?}");
        return file.wrong("body.axle", told);
    }
    let reel = file.right("body.axle", Spool::new(body?, axle))?;
    let scene = TuggedSpool::new(reel, file.effects.gravity);
    let scene = file.right("effects.gravity", scene)?;
    let scene = with(file, scene, listed![tug?], TuggedSpool::with)?;
    let scene = with(file, scene, friction?, TuggedSpool::with)?;
    let side = |at: f64| {
        let rim = Solid::wheel(radius, 0.1 * radius);
        (rim, (Vector3::z() * (at * radius)).into())
    };
    let mut outline = Outline::new("a spool", Solid::wheel(axle, radius));
    outline.solids.extend([side(-0.5), side(0.5)]);
    let scene = scene.moving(file.initial.velocity, file.initial.rim_speed);
    Some((scene, on_the_table(outline, radius)))
}

section! {
    /// `[body]` of a superball.
    BallBody {
        mass: f64, "a mass in kg", Positive;
        shape: Option<Round>, "";
        inertia_factor: Option<f64>, "I/MR², a ratio (0.4 if there is no shape either)", UpTo(1.0);
    }

    /// `[initial]` of a superball.
    BallInitial {
        height: f64, "a height in m", NotNegative;
        climb: f64 = 0.0, "the speed upward in m/s";
        velocity: f64 = 0.0, "the speed of the centre in m/s";
        rim_speed: f64 = 0.0, "the speed RΩ of the rim in m/s";
    }

    /// `[effects]` of a superball.
    BallEffects {
        gravity: Option<Gravity>, "an acceleration in m/s²";
        ceiling: Option<f64>, "the height of the ceiling, less the diameter, in m", Positive;
        restitution: Option<f64>, "the coefficient of restitution upward, a ratio";
        tangential_restitution: Option<f64>, "the coefficient of restitution along the floor, a ratio";
        grip: Option<Coulomb>, "the coefficient of friction at a bounce, a ratio";
    }
}

pub fn superball(file: &File<'_, BallBody, BallInitial, BallEffects>) -> Made<Superball> {
    let (initial, effects) = (&file.initial, &file.effects);
    let start = InFlight {
        position: 0.0,
        height: initial.height,
        climb: initial.climb,
        motion: Motion {
            velocity: initial.velocity,
            rim_speed: initial.rim_speed,
        },
        bounces: 0,
    };
    let kappa = kappa(file, file.body.inertia_factor, file.body.shape)?;
    let ball = Superball::new(file.body.mass, kappa, start);
    let ball = file.right("initial.height, initial.climb", ball)?;
    let ball = ball.under(effects.ceiling.unwrap_or(f64::INFINITY));
    file.right("effects.ceiling, initial.height", ball.flight.checked())?;
    let given = [effects.restitution, effects.tangential_restitution];
    let [normal, along] = given.map(|given| given.unwrap_or(1.0));
    file.right("effects.restitution", Restitution::new(normal, 1.0))?;
    let restitution = Restitution::new(normal, along);
    let restitution = file.right("effects.tangential_restitution", restitution)?;
    let restitution = given[0].or(given[1]).map(|_| restitution);
    let acting = listed![effects.gravity, restitution, effects.grip];
    let ball = with(file, ball, acting, Superball::with)?;
    // The scene has a rim speed but no radius: the drawing takes one that fits the heights.
    let gravity = effects.gravity.map(Gravity::value).filter(|&g| g > 0.0);
    let climbed = gravity.map_or(0.0, |g| 0.5 * initial.climb.powi(2) / g);
    let room = effects.ceiling.unwrap_or(initial.height + climbed);
    let radius = if room > 0.0 { 0.06 * room } else { 0.05 };
    let under = |ceiling| Around::Under(ceiling + 2.0 * radius);
    let around = effects.ceiling.map_or(Around::Floor, under);
    let outline = Round::outline(file.body.shape, radius);
    let flies = rolling(outline, around, move |told| {
        let [x, height] = told.vector(["x", "height"]);
        ([x, height + radius], None)
    });
    let look: Look = Box::new(move |told| {
        let [rim, l] = told.vector(["rim_speed", "l_over_radius"]);
        flies(told).turning(Vector3::y(), [rim / radius, l * radius])
    });
    Some((ball, look))
}

section! {
    /// `[initial]` of a planet.
    PlanetInitial {
        velocity: Option<BodyVector>, "a velocity in m/s";
        omega: Option<BodyVector>, "an angular velocity in rad/s";
    }

    /// `[effects]` of a planet.
    PlanetEffects {
        impact_mass: Option<f64>, "the mass of the meteorite in kg", Positive;
        impact_velocity: Option<BodyVector>, "a velocity in m/s";
        impact_at: Option<BodyVector>, "a place in m";
    }
}

pub fn meteorite(file: &File<'_, Matter, PlanetInitial, PlanetEffects>) -> Made<StruckPlanet> {
    let given = [file.initial.velocity, file.initial.omega];
    let [velocity, omega] = given.map(|given| given.unwrap_or_else(BodyVector::zero));
    let solid = file.body.about_center(file)?;
    let outline = file.body.outline(&solid);
    let look = free(outline.moved(-solid.center().components()), Around::Space);
    let planet = Planet::new(solid.mass(), solid.inertia(), velocity, omega);
    let planet = StruckPlanet::new(file.right("body.moments", planet)?);
    let given = &file.effects;
    let planet = match (given.impact_mass, given.impact_velocity, given.impact_at) {
        (Some(mass), Some(velocity), Some(at)) => {
            let keys = "effects.impact_mass, effects.impact_velocity";
            let meteorite = file.right(keys, Meteorite::new(mass, velocity))?;
            file.right("effects.impact_at", planet.with(Impact { meteorite, at }))?
        }
        (None, None, None) => planet,
        _ => {
            let keys = "effects.impact_mass, effects.impact_velocity, effects.impact_at";
            return file.wrong(keys, " belong together");
        }
    };
    Some((planet, look))
}
