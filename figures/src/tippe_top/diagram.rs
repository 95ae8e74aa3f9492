//! Energy against Jellett's integral: friction moves a tippe top straight down.

use core::f64::consts::PI;

use spinning_bodies::Result;

use super::plot::Frame;
use super::{run, tippe, tippe_scene};
use crate::Figure;
use crate::style::{
    Anchor, DATA, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

/// Spins of the runs drawn, rad/s.
const RUNS: [f64; 3] = [50.0, 70.0, 100.0];

/// Down the plumb line to the branch of steady states.
pub fn energy_and_momentum() -> Result<Figure> {
    let top = tippe()?;
    let unit = top.jellett_of_spin(1.0, 0.0);
    let energy = |tilt: f64, spin: f64| 1e3 * top.effective_potential(tilt, spin * unit);
    let (rise, invert) = (
        top.least_spin_to_rise().unwrap_or(f64::NAN),
        top.least_spin_to_invert().unwrap_or(f64::NAN),
    );
    let mut falls = Vec::new();
    for spin in RUNS {
        let rows = run(&tippe_scene(spin)?, 14.0, 28, 1e-2)?;
        let path: Vec<(f64, f64)> = rows
            .iter()
            .map(|(_, s)| (s.jellett / unit, 1e3 * s.energy))
            .collect();
        falls.push((path, rows[rows.len() - 1].1.tilt().to_degrees()));
    }
    let words = Words {
        claim: "Friction takes energy and leaves Jellett's integral alone, so every top falls down a plumb line.".to_owned(),
        details: format!(
            "Energy of the steady states of the tippe top against Jellett's integral $J$, given as the spin $J/RI_3(1-\\alpha)$ of \
             the upright top. Solid: stable; dashed: not. The tilted branch leaves the upright one at {} rad/s and reaches the inverted one \
             at {} rad/s. Orange: three runs released at 0.1 rad, spun at 50, 70 and 100 rad/s; after 14 s they are at {}°, {}° and {}°.",
            number(rise, 3),
            number(invert, 3),
            number(falls[0].1, 1),
            number(falls[1].1, 1),
            number(falls[2].1, 1),
        ),
        alt: "Energy against spin. Two parabolas: the steep one, upright, is solid up to 28 radians a second and dashed beyond; the flat one, upside \
              down, is dashed up to 77 and solid beyond. They cross, and a solid curve joins the two ends below both. Three vertical arrows fall from \
              the upright parabola, two onto the joining curve and one onto the inverted parabola."
            .to_owned(),
    };
    Ok(figure("tippe-diagram", 402.0, words, |pen| {
        let frame = Frame {
            sides: [58.0, 560.0, 350.0, 14.0],
            x: [0.0, 112.0],
            y: [0.0, 20.0],
        };
        frame.axes(
            pen,
            &[
                (0.0, "0"),
                (25.0, "25"),
                (50.0, "50"),
                (75.0, "75"),
                (100.0, "100 rad/s"),
            ],
            &[
                (0.0, "0"),
                (5.0, "5"),
                (10.0, "10"),
                (15.0, "15"),
                (20.0, "20 mJ"),
            ],
        );
        frame.names(pen, "*J*, as the spin of the upright top", "");
        let branch = |tilt: f64, from: f64, to: f64| {
            (0..=120).map(move |k| {
                let spin = from + (to - from) * f64::from(k) / 120.0;
                (spin, energy(tilt, spin))
            })
        };
        let solid = stroke(Role::Ink, DATA);
        let broken = stroke(Role::Ink, SECONDARY).dashed();
        frame.curve(pen, branch(0.0, 0.0, rise), solid);
        frame.curve(pen, branch(0.0, rise, 112.0), broken);
        frame.curve(pen, branch(PI, 0.0, invert), broken);
        frame.curve(pen, branch(PI, invert, 112.0), solid);
        let tilted = (0..=240).filter_map(|k| {
            let tilt = PI * f64::from(k) / 240.0;
            let jellett = top.steady_jellett(tilt)?;
            Some((jellett / unit, energy(tilt, jellett / unit)))
        });
        frame.curve(pen, tilted, solid);
        for spin in [rise, invert] {
            let tilt = if spin < 50.0 { 0.0 } else { PI };
            pen.disc(frame.at(spin, energy(tilt, spin)), 4.5, Role::Ink, 1.0);
        }
        for (path, _) in &falls {
            let drawn: Vec<Point> = path.iter().map(|&(x, y)| frame.at(x, y)).collect();
            let (start, end) = (drawn[0], drawn[drawn.len() - 1]);
            pen.line(&drawn, stroke(Role::AngularMomentum, DATA));
            let middle = crate::style::between(start, end, 0.55);
            pen.arrow(
                crate::style::between(start, end, 0.5),
                middle,
                stroke(Role::AngularMomentum, DATA),
            );
            pen.disc(start, 3.0, Role::AngularMomentum, 1.0);
            pen.disc(end, 5.0, Role::AngularMomentum, 1.0);
        }
        pen.text(
            frame.at(72.0, 13.4),
            Anchor::End,
            "upright",
            label(Role::Ink),
        );
        pen.text(
            frame.at(14.0, 6.4),
            Anchor::Middle,
            "upside down",
            label(Role::Ink),
        );
        pen.text(
            frame.at(57.0, 4.2),
            Anchor::Start,
            "tilted",
            label(Role::Ink),
        );
        pen.text(
            frame.at(101.5, 13.0),
            Anchor::Start,
            "friction",
            small(Role::AngularMomentum),
        );
    }))
}
