//! `kind = "swivel"`, `"skater"`, `"cat"`, `"paper-cat"`, `"crawler"`: bodies that change their shape, and a cat of paper (1.1). Effects that need more than
//! one number are tables of their own, such as `[effects.turnover]`.

use core::f64::consts::PI;

use nalgebra::{Isometry3, Matrix3, UnitQuaternion, Vector3};

use super::file::*;
use crate::phenomena::{self, Bend, Half, PaperCat as Postcard, Strokes};
use crate::scene::shape::{Cat, Crawler, PaperCat, Skater, Swivel};

section! {
    /// `[body]` of a swivel.
    SwivelBody {
        lower: f64, "a moment in kg m²", Positive;
        upper: f64, "a moment in kg m²", Positive;
    }

    /// `[initial]` of a swivel.
    SwivelInitial {
        angular_momentum: f64 = 0.0, "an angular momentum in kg m²/s";
    }

    /// `[effects]` of a swivel.
    SwivelEffects {
        bearing_friction: Option<BearingFriction>, "a coefficient in N m s", NotNegative;
        four_phases: Option<FourPhases>, "";
    }
}

keys! {
    FourPhases {
        arms_out: f64, "a moment in kg m²", Positive;
        arms_in: f64, "a moment in kg m²", Positive;
        twist: f64, "an angle in rad";
        duration: f64, "a time in s", Positive;
        pace: Pace, "";
    }
}

pub fn swivel(file: &File<'_, SwivelBody, SwivelInitial, SwivelEffects>) -> Made<Swivel> {
    let scene = file.right("body.lower", Swivel::new(file.body.lower, file.body.upper))?;
    let l = file.initial.angular_momentum;
    let scene = file.right("initial.angular_momentum", scene.with_angular_momentum(l))?;
    let acting = listed![file.effects.four_phases, file.effects.bearing_friction];
    let scene = with(file, scene, acting, Swivel::with)?;
    // The radius of a disc of 1 kg with this moment.
    let radius = |moment: f64| (2.0 * moment).sqrt();
    let lower = radius(file.body.lower);
    let look: Look = Box::new(move |told| {
        let [lower_turn, upper_turn, moment, rate, l] =
            told.vector(["lower", "upper", "upper_moment", "rate", "angular_momentum"]);
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
        still(drawn_as, Around::Floor, above, discs).turning(Vector3::z(), [rate, l])
    });
    Some((scene, look))
}

section! {
    /// `[body]` of a skater.
    SkaterBody {
        core: f64, "a moment in kg m²", Positive;
        hand: f64, "a mass in kg";
    }

    /// `[initial]` of a skater.
    SkaterInitial {
        reach: f64, "a distance in m";
        spin: f64, "an angular velocity in rad/s";
    }

    /// `[effects]` of a skater.
    SkaterEffects {
        bearing_friction: Option<BearingFriction>, "a coefficient in N m s", NotNegative;
        draw: Option<Draw>, "";
    }
}

keys! {
    Draw {
        to: f64, "a distance in m", NotNegative;
        begin: f64 = 0.0, "a time in s", NotNegative;
        duration: f64, "a time in s", Positive;
        pace: Pace, "";
    }
}

pub fn skater(file: &File<'_, SkaterBody, SkaterInitial, SkaterEffects>) -> Made<Skater> {
    let person = phenomena::Skater::new(file.body.core, file.body.hand);
    let person = file.right("body.hand", person)?;
    let scene = Skater::new(person, file.initial.reach, file.initial.spin);
    let scene = file.right("initial.reach", scene)?;
    let acting = listed![file.effects.draw, file.effects.bearing_friction];
    let scene = with(file, scene, acting, Skater::with)?;
    // The radius at which both hands would have the moment of the core.
    let girth = (0.5 * file.body.core / file.body.hand.max(0.02 * file.body.core)).sqrt();
    let look: Look = Box::new(move |told| {
        let [angle, spin, reach, l] = told.vector(["angle", "spin", "reach", "l"]);
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
        still(drawn_as, Around::Floor, shoulders, solids).turning(Vector3::z(), [spin, l])
    });
    Some((scene, look))
}

section! {
    /// `[body]` of a cat: each list has a number for the front half and one for the rear.
    CatBody {
        mass: [f64; 2], "two masses in kg", Positive;
        axial: [f64; 2], "two moments in kg m²", Positive;
        transverse: [f64; 2], "two moments in kg m²", Positive;
        to_joint: [f64; 2], "two distances in m", Positive;
    }

    /// `[initial]` of a cat.
    CatInitial {
        attitude: Attitude, "a unit quaternion w x y z";
    }

    /// `[effects]` of a cat.
    CatEffects {
        gravity: Option<Gravity>, "an acceleration in m/s²";
        turnover: Option<Turnover>, "";
    }
}

keys! {
    Turnover {
        forward: f64, "an angle in rad", From(0.0, PI);
        back: f64, "an angle in rad", From(0.0, PI);
        duration: f64, "a time in s", Positive;
        pace: Pace, "";
    }
}

pub fn cat(file: &File<'_, CatBody, CatInitial, CatEffects>) -> Made<Cat> {
    let halves = [0, 1].map(|k| Half {
        mass: file.body.mass[k],
        axial: file.body.axial[k],
        transverse: file.body.transverse[k],
        to_joint: file.body.to_joint[k],
    });
    let animal = phenomena::Cat::new(halves);
    let animal = file.right("body.axial, body.transverse", animal)?;
    let scene = Cat::new(animal, file.initial.attitude);
    let acting = listed![file.effects.turnover, file.effects.gravity];
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
    let look: Look = Box::new(move |told| {
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
    });
    Some((scene, look))
}

/// Defaults of `[body]`: a cat cut from a postcard.
const POSTCARD: Postcard = Postcard::POSTCARD;

keys! {
    Postcard {
        mass: f64 = POSTCARD.mass, "a mass in kg", Positive;
        area: f64 = POSTCARD.area, "an area in m²", Positive;
        lever: f64 = POSTCARD.lever, "a distance in m";
        gyration: f64 = POSTCARD.gyration, "a distance in m", Positive;
        coefficient: f64 = POSTCARD.coefficient, "a number", Positive;
        damping: f64 = POSTCARD.damping, "an area in m²", Positive;
    }
}

section! {
    /// `[initial]` of a cat of paper.
    PaperCatInitial {
        tilt: f64, "an angle in rad";
    }

    /// `[effects]` of a cat of paper.
    PaperCatEffects {
        gravity: Option<Gravity>, "an acceleration in m/s²";
        air: Option<Air>, "a density in kg/m³", NotNegative;
    }
}

pub fn paper_cat(file: &File<'_, Postcard, PaperCatInitial, PaperCatEffects>) -> Made<PaperCat> {
    let scene = file.right("body", PaperCat::new(file.body, file.initial.tilt))?;
    let acting = listed![file.effects.air, file.effects.gravity];
    let scene = with(file, scene, acting, PaperCat::with)?;
    let edge = file.body.area.sqrt();
    let lever = Vector3::z() * file.body.lever;
    let flat = Solid::Cuboid(Vector3::new(edge, edge, 0.01 * edge));
    let outline = Outline::new("a square of its area", flat)
        .moved(lever)
        .and(Solid::Bar(lever));
    let look: Look = Box::new(move |told| {
        let [fall, tilt, rate, l] = told.vector(["fall", "tilt", "tilt_rate", "l"]);
        let (place, attitude) = (Vector3::z() * -fall, about(Vector3::y(), tilt));
        let sight = outline.sight(Around::Space, place, attitude);
        sight.turning(Vector3::y(), [rate, l])
    });
    Some((scene, look))
}

section! {
    /// `[body]` of a crawler.
    CrawlerBody {
        masses: [f64; 2], "two masses in kg", Positive;
        strokes: Strokes, "";
    }
}

keys! {
    Strokes {
        gap: f64, "a distance in m", Positive;
        length: f64, "a distance in m", Positive;
        push: f64, "a time in s", Positive;
        pull: f64, "a time in s", Positive;
    }
}

section! {
    /// `[initial]` of a crawler.
    CrawlerInitial {}

    /// `[effects]` of a crawler.
    CrawlerEffects {
        ground_friction: Option<GroundFriction>, "";
    }

    /// `[effects.ground_friction]`.
    GroundFriction {
        coefficient: Coulomb, "a number";
        gravity: Gravity, "an acceleration in m/s²", Positive;
    }
}

pub fn crawler(file: &File<'_, CrawlerBody, CrawlerInitial, CrawlerEffects>) -> Made<Crawler> {
    let [rear, front] = file.body.masses;
    let animal = phenomena::Crawler::new(rear, front, file.body.strokes);
    let largest = 0.25 * file.body.strokes.gap;
    let radii = [rear, front].map(|mass| largest * (mass / rear.max(front)).cbrt());
    let look: Look = Box::new(move |told| {
        let [rear, front, center] = told.vector(["rear", "front", "center"]);
        let foot = |k: usize, x: f64| {
            let stands = Isometry3::translation(x, 0.0, radii[k]);
            (Solid::ball(radii[k]), stands)
        };
        let feet = [foot(0, rear), foot(1, front)];
        let [from, to] = [&feet[0], &feet[1]].map(|(_, stands)| stands.translation.vector);
        let muscle = (Solid::Bar(to - from), feet[0].1);
        let solids = core::iter::once(muscle).chain(feet).collect();
        let place = Vector3::new(center, 0.0, largest);
        let drawn_as = "two feet, as large as balls of their masses";
        still(drawn_as, Around::Floor, place, solids)
    });
    let keys = "body.length, body.push, body.pull";
    let scene = Crawler::new(file.right(keys, animal)?);
    let ground = file.effects.ground_friction.as_ref();
    let acting = listed![ground.map(|it| it.coefficient), ground.map(|it| it.gravity)];
    let scene = with(file, scene, acting, Crawler::with)?;
    Some((scene, look))
}
