//! `kind = "yo-yo"`: a yo-yo, let go or thrown (4.9).

use super::body::not_beyond;
use super::file::*;
use crate::scene::Play;
use crate::yo_yo::YoYo;

tables! { YoYoKeys
    [body]
    mass: f64, "a mass in kg", Positive;
    inertia: Option<f64>, "a moment of inertia in kg m²", Positive;
    radius: Option<f64>, "the radius of the disc in m", Positive;
    length: f64, "the length of the string in m", Positive;
    axle: f64, "the radius of the axle in m", Positive;
    wound: Option<f64>, "the radius of the wound string in m", Positive;
    [initial]
    throw: f64 = 0.0, "a speed in m/s", NotNegative;
    [effects]
    gravity: Option<Gravity>, "an acceleration in m/s²", Positive;
    turn_loss: Option<TurnLoss>, "the part of the spin that a turn leaves", From(0.0, 1.0);
    hand: Option<Hand>, "the work of the hand at a turn in J", NotNegative;
    sleep: Option<Sleep>, "the time that it sleeps at the end of the string in s", NotNegative;
    axle_friction: Option<AxleFriction>, "a torque in N m", NotNegative;
    air_drag: Option<AirDrag>, "a coefficient in kg m²", NotNegative;
}

pub fn yo_yo(file: &Reader<'_>, given: YoYoKeys) -> Option<AnyScene> {
    let toy = match (given.inertia, given.radius) {
        (Some(inertia), None) => {
            let toy = YoYo::new(given.mass, inertia, given.length, given.axle);
            file.right("body.axle, body.length, body.mass, body.inertia", toy)
        }
        (None, Some(radius)) => {
            not_beyond(file, given.axle, radius)?;
            let toy = YoYo::disc(given.mass, radius, given.length, given.axle);
            file.right("body.axle, body.length, body.mass, body.radius", toy)
        }
        (Some(_), Some(_)) => file.exclude("body.inertia", "radius"),
        (None, None) => {
            let expected = "either `inertia` in kg m² or `radius` of a disc in m";
            file.missing("body.inertia", expected)
        }
    }?;
    let toy = given.wound.map_or(Ok(toy), |wound| toy.wound_to(wound));
    let toy = file.right("body.wound", toy)?;
    let scene = file.right("initial.throw", Play::new(toy, given.throw))?;
    let acting = acting![given: gravity, turn_loss, hand, sleep, axle_friction, air_drag];
    let scene = with(file, scene, acting, Play::with)?;
    // Without another value, the radius of the disc with this mass and inertia.
    let of_disc = (2.0 * toy.inertia / toy.mass).sqrt();
    let radius = given.radius.unwrap_or(of_disc);
    let outline = Outline::new("a yo-yo", Solid::wheel(radius, 0.8 * radius));
    drawn(scene, move |told| {
        let [depth] = told.vector(["depth"]);
        rolling(&outline, Around::String, [0.0, -depth], None, told)
    })
}
