//! A meteorite tilts a planet (tutorial 4.2, picture c).

use nalgebra::Vector3;
use spinning_bodies::Result;
use spinning_bodies::frame::BodyVector;
use spinning_bodies::impacts::{Meteorite, Planet, strike};

use crate::Figure;
use crate::solid::{View, ellipse};
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, between, figure, label, number,
    small, stroke,
};

/// Where the planet is drawn, its radius and the length of Ω = 1, units.
const CENTER: Point = [254.0, 252.0];
const RADIUS: f64 = 108.0;
const SPIN: f64 = 186.0;
/// The magnifying glass.
const GLASS: Point = [492.0, 146.0];
const GLASS_RADIUS: f64 = 74.0;
const MAGNIFIED: f64 = 24.0;

/// A planet before and after a hit, exactly and in first order.
pub fn meteorite() -> Result<Figure> {
    let (mass, moment, small_mass) = (1.0, 0.4, 0.01);
    let at = BodyVector::new(0.6, 0.0, 0.8);
    let velocity = BodyVector::new(-10.0, -20.0, 5.0);
    let before = BodyVector::new(0.0, 0.0, 1.0);
    let planet = Planet::spherical(mass, moment, BodyVector::zero(), before)?;
    let hit = strike(&planet, &Meteorite::new(small_mass, velocity)?, at)?;
    let (after, rough) = (hit.omega_after(), hit.first_order()?);
    let tilt = number(hit.tilt()?.to_degrees(), 1);
    let miss = 100.0 * (rough - after).norm() / (after - before).norm();

    let triple = |v: BodyVector| {
        format!(
            "({}, {}, {})",
            number(v.x(), 3),
            number(v.y(), 3),
            number(v.z(), 3)
        )
    };
    let ascii = |text: String| text.replace('\u{2212}', "-");
    let words = Words {
        claim: "A small meteorite can tilt a planet's axis a long way.".to_owned(),
        details: format!(
            "Uniform ball, $M = {mass}$, $R = 1$, $I = {moment}$; meteorite $m = {small_mass}$ with $v = (-10, -20, 5)$ at \
             $x = (0.6, 0, 0.8)$, where it sticks. The angular velocity goes from $(0, 0, 1)$ to ${}$, a tilt of \
             {tilt} degrees; the first-order formula gives ${}$, off by {} per cent of the change.",
            ascii(triple(after)),
            ascii(triple(rough)),
            number(miss, 1),
        ),
        alt: format!(
            "A planet with its vertical axis of rotation before the impact, dashed, and the tilted axis after it, {tilt} \
             degrees away. A meteorite comes in fast from the lower left, grazes the near side and sticks at the upper left of the ball. Under a \
             magnifying glass the tip of the first-order answer lies just beyond the tip of the exact one."
        ),
    };

    let view = View::new(1.4, 0.32, CENTER, RADIUS);
    let spin = View::new(1.4, 0.32, CENTER, SPIN);
    Ok(figure("meteorite", 392.0, words, |pen| {
        pen.disc(CENTER, RADIUS, Role::Shade, 0.8);
        pen.ring(CENTER, RADIUS, stroke(Role::Ink, DATA));
        // Equator and a meridian, so that the ball is seen to be round.
        let equator = ellipse(Vector3::zeros(), Vector3::x(), Vector3::y(), 240);
        let [seen, hidden] = view.split(&equator, |p| p.dot(&view.toward) > 0.0);
        for piece in seen {
            pen.line(&piece, stroke(Role::Ink, HAIR).alpha(0.7));
        }
        for piece in hidden {
            pen.line(&piece, stroke(Role::Ink, HAIR).alpha(0.25));
        }

        let tips = [before, after, rough].map(|v| spin.project(&v.components()));
        pen.arrow(CENTER, tips[0], stroke(Role::Omega, SECONDARY).dashed());
        pen.arrow(CENTER, tips[1], stroke(Role::Omega, 2.8));
        pen.disc(CENTER, 3.0, Role::Ink, 1.0);
        pen.text(
            [CENTER[0] + 9.0, CENTER[1] + 16.0],
            Anchor::Start,
            "*C*",
            label(Role::Ink),
        );
        pen.text(
            [tips[0][0] + 12.0, tips[0][1] + 10.0],
            Anchor::Start,
            "before, *Ω*",
            label(Role::Omega),
        );
        pen.text(
            [tips[1][0] - 16.0, tips[1][1] - 2.0],
            Anchor::End,
            "after, *Ω*\u{2032}",
            label(Role::Omega),
        );

        let place = view.project(&at.components());
        let come = view.project(&(at.components() - 0.142 * velocity.components()));
        pen.line(&[CENTER, place], stroke(Role::Ink, AXIS).dotted());
        pen.arrow(come, place, stroke(Role::Ink, DATA));
        pen.disc(come, 7.0, Role::Ink, 1.0);
        pen.text(
            [come[0] - 12.0, come[1] + 10.0],
            Anchor::End,
            "*m*",
            label(Role::Ink),
        );
        let half = between(come, place, 0.4);
        pen.text(
            [half[0] - 10.0, half[1] - 6.0],
            Anchor::End,
            "*v*",
            label(Role::Ink),
        );
        pen.text(
            [place[0] - 6.0, place[1] - 7.0],
            Anchor::End,
            "*x*",
            label(Role::Ink),
        );

        glass(pen, tips[1], tips[2]);
    })
    .value("tilt", tilt)
    .value("miss", number(miss, 1)))
}

/// The two tips enlarged.
fn glass(pen: &mut Pen, exact: Point, rough: Point) {
    pen.ring(
        exact,
        GLASS_RADIUS / MAGNIFIED + 3.0,
        stroke(Role::Ink, AXIS),
    );
    let (dx, dy) = (GLASS[0] - exact[0], GLASS[1] - exact[1]);
    let along = dy.atan2(dx);
    let start = [exact[0] + 6.1 * along.cos(), exact[1] + 6.1 * along.sin()];
    let stop = [
        GLASS[0] - GLASS_RADIUS * along.cos(),
        GLASS[1] - GLASS_RADIUS * along.sin(),
    ];
    pen.line(&[start, stop], stroke(Role::Ink, HAIR));
    pen.disc(GLASS, GLASS_RADIUS, Role::Ink, 0.04);
    pen.ring(GLASS, GLASS_RADIUS, stroke(Role::Ink, SECONDARY));
    let enlarged = |p: Point| {
        [
            GLASS[0] + MAGNIFIED * (p[0] - exact[0]),
            GLASS[1] + MAGNIFIED * (p[1] - exact[1]),
        ]
    };
    for (tip, style) in [
        (exact, stroke(Role::Omega, 2.8)),
        (rough, stroke(Role::Omega, SECONDARY).dashed()),
    ] {
        // The shaft as far as the glass reaches.
        let there = enlarged(tip);
        let angle = (CENTER[1] - tip[1]).atan2(CENTER[0] - tip[0]);
        let on = |t: f64| [there[0] + t * angle.cos(), there[1] + t * angle.sin()];
        let mut t = 0.0;
        while (on(t)[0] - GLASS[0]).hypot(on(t)[1] - GLASS[1]) < GLASS_RADIUS {
            t += 0.5;
        }
        pen.arrow(on(t), there, style);
    }
    let (there, rough) = (enlarged(exact), enlarged(rough));
    pen.text(
        [there[0] + 10.0, there[1] - 2.0],
        Anchor::Start,
        "exact",
        small(Role::Omega),
    );
    pen.text(
        [rough[0] - 6.0, rough[1] + 4.0],
        Anchor::End,
        "first",
        small(Role::Omega),
    );
    pen.text(
        [rough[0] - 6.0, rough[1] + 20.0],
        Anchor::End,
        "order",
        small(Role::Omega),
    );
    let under = [GLASS[0], GLASS[1] + GLASS_RADIUS + 20.0];
    pen.text(
        under,
        Anchor::Middle,
        &format!("{} times", number(MAGNIFIED, 0)),
        small(Role::Muted),
    );
}
