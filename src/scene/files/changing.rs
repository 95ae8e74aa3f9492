//! `kind = "swivel"`, `"skater"`, `"cat"`, `"paper-cat"`, `"crawler"`: bodies that change their shape, and a cat of paper (1.1). Effects that need more than
//! one number are tables of their own, such as `[effects.turnover]`.

use core::f64::consts::PI;

use nalgebra::{Isometry3, Matrix3, UnitQuaternion, Vector3};

use super::file::*;
use crate::phenomena::{self, Bend, Half, PaperCat as Postcard, Strokes};
use crate::scene::shape::{Cat, Crawler, PaperCat, Skater, Swivel};

tables! { SwivelKeys
    [body]
    lower: f64, "the moment of the lower part in kg m²", Positive;
    upper: f64, "the moment of the upper part, of no effect beside `four_phases`, in kg m²", Positive;
    [initial]
    angular_momentum: f64 = 0.0, "an angular momentum in kg m²/s";
    [effects]
    bearing_friction: Option<BearingFriction>, "against the spin, a coefficient in N m s", NotNegative;
    four_phases: Option<FourPhases>, "";
}

keys! { FourPhases
    arms_out: f64, "the upper moment with the arms out in kg m²", Positive;
    arms_in: f64, "the upper moment with the arms in, in kg m²", Positive;
    twist: f64, "the angle by which the upper part twists, and back, in rad";
    duration: f64, "the time of a cycle in s", Positive;
    pace: Pace, "";
}

pub fn swivel(file: &Reader<'_>, given: SwivelKeys) -> Option<AnyScene> {
    let scene = file.right("body.lower", Swivel::new(given.lower, given.upper))?;
    let scene = scene.with_angular_momentum(given.angular_momentum);
    let scene = file.right("initial.angular_momentum", scene)?;
    let acting = acting![given: bearing_friction, four_phases];
    let scene = with(file, scene, acting, Swivel::with)?;
    // The radius of a disc of 1 kg with this moment.
    let radius = |moment: f64| (2.0 * moment).sqrt();
    let lower = radius(given.lower);
    drawn(scene, move |told| {
        let [lower_turn, upper_turn, moment] = told.vector(["lower", "upper", "upper_moment"]);
        let [below, above] = [0.2, 0.6].map(|part| Vector3::z() * (part * lower));
        let disc = |radius: f64, place: Vector3<f64>, turn: f64| {
            let solid = Solid::wheel(radius, 0.3 * lower);
            (solid, Isometry3::new(place, Vector3::z() * turn))
        };
        let discs = vec![
            disc(lower, below, lower_turn),
            disc(radius(moment), above, upper_turn),
        ];
        let drawn_as = "two discs of 1 kg with its moments, Ω that of the lower";
        let turning = told.vector(["rate", "angular_momentum"]);
        still(drawn_as, Around::Floor, above, discs).turning(Vector3::z(), turning)
    })
}

tables! { SkaterKeys
    [body]
    core: f64, "the moment without the hands in kg m²", Positive;
    hand: f64, "the mass of each hand in kg, not negative";
    [initial]
    reach: f64, "the distance of the hands in m, not negative";
    spin: f64, "an angular velocity in rad/s";
    [effects]
    bearing_friction: Option<BearingFriction>, "against the spin, a coefficient in N m s", NotNegative;
    draw: Option<Draw>, "";
}

keys! { Draw
    to: f64, "the last distance of the hands in m", NotNegative;
    begin: f64 = 0.0, "the time at which the hands begin in s", NotNegative;
    duration: f64, "the time that the hands take in s", Positive;
    pace: Pace, "";
}

pub fn skater(file: &Reader<'_>, given: SkaterKeys) -> Option<AnyScene> {
    let SkaterKeys { core, hand, .. } = given;
    let person = file.right("body.hand", phenomena::Skater::new(core, hand))?;
    let scene = Skater::new(person, given.reach, given.spin);
    let scene = file.right("initial.reach", scene)?;
    let acting = acting![given: bearing_friction, draw];
    let scene = with(file, scene, acting, Skater::with)?;
    // The radius at which both hands would have the moment of the core.
    let girth = (0.5 * core / hand.max(0.02 * core)).sqrt();
    drawn(scene, move |told| {
        let [angle, reach] = told.vector(["angle", "reach"]);
        let shoulders = Vector3::z() * (0.6 * girth);
        let turned = about(Vector3::z(), angle);
        let arms = Isometry3::from_parts(shoulders.into(), turned);
        let core = Isometry3::new(Vector3::z() * (0.2 * girth), Vector3::z() * angle);
        let mut solids = vec![(Solid::wheel(girth, 0.4 * girth), core)];
        for side in [-reach, reach] {
            let hand = arms * Isometry3::translation(side, 0.0, 0.0);
            solids.push((Solid::Bar(Vector3::x() * side), arms));
            solids.push((Solid::ball(0.12 * girth), hand));
        }
        let drawn_as = "hands, and a core on whose rim they would have its moment";
        let turning = told.vector(["spin", "l"]);
        still(drawn_as, Around::Floor, shoulders, solids).turning(Vector3::z(), turning)
    })
}

// Each list has a number for the front half and one for the rear.
tables! { CatKeys
    [body]
    mass: [f64; 2], "two masses in kg", Positive;
    axial: [f64; 2], "two moments about the spine in kg m²", Positive;
    transverse: [f64; 2], "two moments across the spine in kg m²", Positive;
    to_joint: [f64; 2], "two distances from centre of mass to joint in m", Positive;
    [initial]
    attitude: Attitude, "a unit quaternion w x y z";
    [effects]
    gravity: Option<Gravity>, "an acceleration in m/s²";
    turnover: Option<Turnover>, "";
}

keys! { Turnover
    forward: f64, "the bend forward in rad", From(0.0, PI);
    back: f64, "the bend backward, half-way round, in rad", From(0.0, PI);
    duration: f64, "the time of the whole turn in s", Positive;
    pace: Pace, "";
}

pub fn cat(file: &Reader<'_>, given: CatKeys) -> Option<AnyScene> {
    let half = |k: usize| Half {
        mass: given.mass[k],
        axial: given.axial[k],
        transverse: given.transverse[k],
        to_joint: given.to_joint[k],
    };
    let halves = [half(0), half(1)];
    let animal = phenomena::Cat::new(halves);
    let animal = file.right("body.axial, body.transverse", animal)?;
    let scene = Cat::new(animal, given.attitude);
    let acting = acting![given: gravity, turnover];
    let scene = with(file, scene, acting, Cat::with)?;
    let outlines = halves.map(|half| {
        let length = (6.0 * (2.0 * half.transverse - half.axial) / half.mass).sqrt();
        Solid::wheel((2.0 * half.axial / half.mass).sqrt(), length)
    });
    // A cylinder's axis is its third, a half's spine its first axis. The faces point outward, and the line on them marks the belly, +y.
    let [first, second] = [-1.0, 1.0].map(|out| {
        let axes = Matrix3::new(0.0, 0.0, out, 1.0, 0.0, 0.0, 0.0, out, 0.0);
        UnitQuaternion::from_matrix(&axes)
    });
    drawn(scene, move |told| {
        let [angle, direction] = told.vector(["bend", "direction"]);
        let bend = Bend {
            angle,
            direction,
            ..Bend::default()
        };
        let [joint, a, b] = animal.places(&bend).map(|place| place.components());
        let relative = bend.relative().quaternion();
        let stands = |place: Vector3<f64>, turn| Isometry3::from_parts(place.into(), turn);
        let spine = |from: Vector3<f64>| (Solid::Bar(joint - from), from.into());
        let front = (outlines[0].clone(), stands(a, first));
        let rear = (outlines[1].clone(), stands(b, relative * second));
        let drawn_as = "two cylinders with its masses and moments, Ω that of the front";
        let solids = vec![spine(a), spine(b), front, rear];
        Sight {
            // The cat starts from rest: its computed L is rounding.
            angular_momentum: None,
            ..posed(&Outline { drawn_as, solids }, Around::Space, told)
        }
    })
}

tables! { PaperCatKeys
    [body]
    card: Postcard;
    [initial]
    tilt: f64, "the tilt from feet-down in rad", From(-MOST_TURNED, MOST_TURNED);
    [effects]
    gravity: Option<Gravity>, "an acceleration in m/s²";
    air: Option<Air>, "a density in kg/m³", NotNegative;
}

const POSTCARD: Postcard = Postcard::POSTCARD;

keys! { Postcard
    mass: f64 = POSTCARD.mass, "a mass in kg", Positive;
    area: f64 = POSTCARD.area, "the area of the sheet in m²", Positive;
    lever: f64 = POSTCARD.lever, "the height of the centre of pressure above the centre of mass, feet down, in m";
    gyration: f64 = POSTCARD.gyration, "the radius of gyration in m", Positive;
    coefficient: f64 = POSTCARD.coefficient, "the coefficient of the normal force, a number", Positive;
    damping: f64 = POSTCARD.damping, "the square of the damping length in m²", Positive;
}

pub fn paper_cat(file: &Reader<'_>, given: PaperCatKeys) -> Option<AnyScene> {
    let scene = file.right("body", PaperCat::new(given.card, given.tilt))?;
    let acting = acting![given: gravity, air];
    let scene = with(file, scene, acting, PaperCat::with)?;
    let edge = given.card.area.sqrt();
    let lever = Vector3::z() * given.card.lever;
    let flat = Solid::Cuboid(Vector3::new(edge, edge, 0.01 * edge));
    let outline = Outline::new("a square of its area", flat)
        .moved(lever)
        .and(Solid::Bar(lever), Vector3::zeros());
    drawn(scene, move |told| {
        let [fall, tilt] = told.vector(["fall", "tilt"]);
        let (place, attitude) = (Vector3::z() * -fall, about(Vector3::y(), tilt));
        let sight = outline.sight(Around::Space, place, attitude);
        sight.turning(Vector3::y(), told.vector(["tilt_rate", "l"]))
    })
}

tables! { CrawlerKeys
    [body]
    masses: [f64; 2], "two masses in kg", Positive;
    strokes: Strokes;
    [initial]
    [effects]
    ground_friction: Option<GroundFriction>, "";
}

keys! { Strokes
    gap: f64, "the least distance of the feet in m", Positive;
    length: f64, "the length of a push in m", Positive;
    push: f64, "the time of a push in s", Positive;
    pull: f64, "the time of a pull in s", Positive;
}

section! { GroundFriction
    coefficient: Coulomb, "the coefficient of friction, a ratio", NotNegative;
    gravity: Gravity, "an acceleration in m/s²", Positive;
}

pub fn crawler(file: &Reader<'_>, given: CrawlerKeys) -> Option<AnyScene> {
    let [rear, front] = given.masses;
    let largest = 0.25 * given.strokes.gap;
    let animal = phenomena::Crawler::new(rear, front, given.strokes);
    let scene = Crawler::new(file.right("body.length, body.push, body.pull", animal)?);
    let acting = given.ground_friction.map_or(vec![], |ground| {
        let (law, gravity) = (ground.coefficient.into(), ground.gravity.into());
        let keys = "effects.ground_friction";
        vec![(keys, Some(law)), (keys, Some(gravity))]
    });
    let scene = with(file, scene, acting, Crawler::with)?;
    let radii = [rear, front].map(|mass| largest * (mass / rear.max(front)).cbrt());
    drawn(scene, move |told| {
        let [rear, front, center] = told.vector(["rear", "front", "center"]);
        let foot = |radius: f64, x: f64| {
            let stands = Isometry3::translation(x, 0.0, radius);
            (Solid::ball(radius), stands)
        };
        let feet = [foot(radii[0], rear), foot(radii[1], front)];
        let [from, to] = [&feet[0], &feet[1]].map(|(_, stands)| stands.translation.vector);
        let muscle = (Solid::Bar(to - from), feet[0].1);
        let solids = core::iter::once(muscle).chain(feet).collect();
        let place = Vector3::new(center, 0.0, largest);
        let drawn_as = "two feet, as large as balls of their masses";
        still(drawn_as, Around::Floor, place, solids)
    })
}
