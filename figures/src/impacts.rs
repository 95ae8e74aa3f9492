//! A meteorite tilts a planet (tutorial 4.2, picture c).

use spinning_bodies::frame::BodyVector;
use spinning_bodies::impacts::{Meteorite, Planet, strike};

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[of("meteorite", &[MASS, HEIGHT, ACROSS, MOMENT], meteorite)];

parameters! {
    MASS: "mass", "m/M", "", "mass of the meteorite over that of the planet", [0.001, 0.03], 0.01, logarithmic;
    HEIGHT: "height", "z/R", "", "height over the equator at which it hits, over the radius", [-0.6, 0.85], 0.8;
    ACROSS: "across", r"-v_y/R\Omega", "", "speed of the meteorite against the turn of the planet, over that of the equator", [0.0, 40.0], 20.0;
    MOMENT: "moment", "I/MR^2", "", "moment of inertia of the planet over MR²", [0.2, 0.66], 0.4;
}

/// Where the planet is drawn, its radius and the length of Ω = 1, units.
const CENTER: Point = [254.0, 252.0];
const RADIUS: f64 = 108.0;
const SPIN: f64 = 186.0;
/// The magnifying glass.
const GLASS: Point = [492.0, 146.0];
const GLASS_RADIUS: f64 = 74.0;

/// A planet before and after a hit, exactly and in first order.
pub fn meteorite(values: &Values) -> Result<Figure> {
    let [small_mass, height, across, moment] = values.each([MASS, HEIGHT, ACROSS, MOMENT]);
    let mass = 1.0;
    let out = ((1.0 - height) * (1.0 + height)).sqrt();
    let at = BodyVector::new(out, 0.0, height);
    let velocity = BodyVector::new(-10.0, -across, 5.0);
    let before = BodyVector::new(0.0, 0.0, 1.0);
    let planet = Planet::spherical(mass, moment, BodyVector::zero(), before)?;
    let hit = strike(&planet, &Meteorite::new(small_mass, velocity)?, at)?;
    let (after, rough) = (hit.omega_after, hit.first_order()?);
    let tilt = number(hit.tilt()?.to_degrees(), 1);
    let miss = 100.0 * (rough - after).norm() / (after - before).norm();

    let triple = |v: BodyVector| {
        let [x, y, z] = numbers(v.components().into(), 3);
        format!("({x}, {y}, {z})")
    };
    let ascii = |text: String| text.replace('\u{2212}', "-");
    let claim = match hit.tilt()?.to_degrees() >= 10.0 {
        true => "A small meteorite can tilt a planet's axis a long way.".to_owned(),
        false => format!("Hit like this, the planet's axis tilts by only {tilt} degrees."),
    };
    let [ratio, light, across, up] = briefs([moment, small_mass, velocity.y(), height]);
    let [across, up, exactly, roughly] = [across, up, triple(after), triple(rough)].map(ascii);
    let (outward, off, over) = (short(out, 3), number(miss, 1), short(height, 2));
    let words = words!(
        "{claim}",
        "Ball, $M = {mass}$, $R = 1$, $I = {ratio}$; meteorite $m = {light}$ with $v = (-10, {across}, 5)$ at \
         $x = ({outward}, 0, {up})$, where it sticks. The angular velocity goes from $(0, 0, 1)$ to ${exactly}$, a tilt of \
         {tilt} degrees; the first-order formula gives ${roughly}$, off by {off} per cent of the change.",
        "A planet with its vertical axis of rotation before the impact, dashed, and its axis after it, {tilt} \
         degrees away. A meteorite comes in and sticks to the ball at {over} of its radius over the equator. Under a \
         magnifying glass the tip of the first-order answer lies beside the tip of the exact one."
    );

    let view = View::new(1.4, 0.32, CENTER, RADIUS);
    // As long as the longest arrow allows.
    let longest = [before, after, rough].map(|v| {
        let unit = View::new(1.4, 0.32, [0.0, 0.0], 1.0);
        let [x, y] = unit.project(&v.components());
        (x.abs() / 130.0).max(-y / 176.0).max(y / 108.0)
    });
    let scale = SPIN.min(1.0 / longest.into_iter().fold(0.0, f64::max));
    let spin = View::new(1.4, 0.32, CENTER, scale);
    let made = figure("meteorite", 380.0, words, |pen| {
        pen.disc(CENTER, RADIUS, Shade, 0.8);
        pen.ring(CENTER, RADIUS, inked(DATA));
        // The equator and a meridian show that the ball is round.
        let [seen, hidden] = view.halves(&latitude(0.0, 1.0, 240));
        pen.lines(seen, inked(HAIR).alpha(0.7));
        pen.lines(hidden, inked(HAIR).alpha(0.25));

        let tips = [before, after, rough].map(|v| spin.project(&v.components()));
        pen.arrow(CENTER, tips[0], stroke(Omega, SECONDARY).dashed());
        pen.arrow(CENTER, tips[1], stroke(Omega, 2.8));
        pen.dot(CENTER, 3.0);
        let place = view.project(&at.components());
        let back = velocity.components() / velocity.norm();
        let start = |far: f64| view.project(&(at.components() - far * back));
        // It comes from as far away as there is room for.
        let far = (0..60).map(|k| start(3.3 - 0.05 * f64::from(k)));
        let come = far.into_iter().find(within([40.0, 400.0], [20.0, 364.0]));
        let come = come.unwrap_or(start(0.3));
        pen.line([CENTER, place], inked(AXIS).dotted());
        pen.arrow(come, place, inked(DATA));
        pen.dot(come, 7.0);
        glass(pen, tips[1], tips[2]);
        let mut name = |at: Point, text: &str, lettering, half: f64| {
            let far = [1.0, 1.4, 1.9, 2.5];
            let places = far.into_iter().flat_map(|far| {
                let (x, y) = (far * (half + 8.0), far * 14.0);
                let beside = [[-x, 0.0], [x, 0.0], [-x, -y], [x, -y]];
                let around = [beside, [[0.0, -y], [-x, y], [x, y], [0.0, y]]];
                around.concat().into_iter().map(move |by| shifted(at, by))
            });
            let inside = within([half + 4.0, 592.0 - half], [14.0, 368.0]);
            pen.name(places.filter(inside), text, lettering);
        };
        name(tips[0], "before, *Ω*", label(Omega), 42.0);
        name(tips[1], "after, *Ω*\u{2032}", label(Omega), 36.0);
        name(come, "*m*", label(Ink), 8.0);
        name(between(come, place, 0.4), "*v*", label(Ink), 5.0);
        name(place, "*x*", label(Ink), 5.0);
        name(CENTER, "*C*", label(Ink), 6.0);
    });
    let row = |v: BodyVector| [v.x(), v.y(), v.z()];
    let columns = "Ω_x (Ω) | Ω_y (Ω) | Ω_z (Ω)";
    Ok(made
        .data("before", columns, [row(before)])
        .data("after", columns, [row(after)])
        .data("first order", columns, [row(rough)])
        .value("tilt", tilt)
        .value("miss", number(miss, 1)))
}

/// The two tips enlarged.
fn glass(pen: &mut Pen, exact: Point, rough: Point) {
    let apart = distance(rough, exact);
    // A round number, so that the two tips are well apart and inside.
    let magnified = [300.0, 200.0, 100.0, 50.0, 24.0, 10.0, 5.0, 2.0]
        .into_iter()
        .find(|times| times * apart < 50.0)
        .unwrap_or(1.0);
    let rim = (GLASS_RADIUS / magnified + 3.0).min(14.0);
    let middle = between(exact, rough, 0.5);
    pen.ring(middle, rim, inked(AXIS));
    let (dx, dy) = (GLASS[0] - middle[0], GLASS[1] - middle[1]);
    let way = dy.atan2(dx);
    let start = polar(middle, rim, -way);
    let stop = polar(GLASS, -GLASS_RADIUS, -way);
    pen.line([start, stop], inked(HAIR));
    pen.disc(GLASS, GLASS_RADIUS, Ink, 0.04);
    pen.ring(GLASS, GLASS_RADIUS, inked(SECONDARY));
    let enlarged = |[x, y]: Point| planned(GLASS, magnified, [x - middle[0], middle[1] - y]);
    for (tip, style) in [
        (exact, stroke(Omega, 2.8)),
        (rough, stroke(Omega, SECONDARY).dashed()),
    ] {
        // The shaft as far as the glass reaches.
        let there = enlarged(tip);
        let angle = (CENTER[1] - tip[1]).atan2(CENTER[0] - tip[0]);
        let on = |t: f64| polar(there, t, -angle);
        let mut t = 0.0;
        while distance(on(t), GLASS) < GLASS_RADIUS {
            t += 0.5;
        }
        pen.arrow(on(t), there, style);
    }
    for (tip, other, lines) in [
        (exact, rough, &["exact"][..]),
        (rough, exact, &["first", "order"]),
    ] {
        let [tip, other] = [tip, other].map(enlarged);
        let half = [20.0, 8.0 * lines.len() as f64];
        let places = (0..24).flat_map(|k| {
            [30.0, 38.0, 46.0].map(|far| {
                let [x, y] = polar([0.0; 2], far, TAU * f64::from(k) / 24.0);
                shifted(tip, [x, 0.8 * y])
            })
        });
        // On the side of its tip where the other one is not.
        let inside = places.filter(|p| distance(*p, GLASS) < GLASS_RADIUS - 24.0);
        let inside =
            inside.filter(|p| distance(*p, other) >= distance(*p, tip).hypot(distance(tip, other)));
        let [x, y] = pen.room(inside, half);
        for (line, text) in lines.iter().enumerate() {
            let at = [x, y + 13.0 - half[1] + 16.0 * line as f64];
            pen.text(at, Middle, text, small(Omega));
        }
    }
    let under = shifted(GLASS, [0.0, GLASS_RADIUS + 20.0]);
    pen.remark(under, Middle, &format!("{magnified:.0} times"));
}
