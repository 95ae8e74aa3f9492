//! Bounces as reflections, and paths under the table for three balls (tutorial 4.6).

use spinning_bodies::Result;
use spinning_bodies::superball::{Motion, UnderTable, return_threshold};

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Point, Role, SECONDARY, Words, between, figure, label, number, polar,
    small, stroke,
};

const THROWN: Motion<f64> = Motion {
    velocity: 1.0,
    rim_speed: 0.0,
};

/// Each bounce reflects the point (V, √κ RΩ) of the unit circle in one of two lines.
pub fn reflections() -> Result<Figure> {
    let kappa: f64 = 0.4;
    let root = kappa.sqrt();
    let motions: Vec<Motion<f64>> = core::iter::once(THROWN)
        .chain(UnderTable::new(THROWN, kappa).take(3))
        .collect();
    let beta = root.atan();
    let degrees = number(beta.to_degrees(), 1);
    let words = Words {
        claim: "A bounce is a reflection; floor and ceiling have a mirror each.".to_owned(),
        details: format!(
            "The motion of a superball is a point of a circle: across, the velocity $V$; upward, the spin as $\\sqrt{{\\kappa}}\\,R\\Omega$. The floor reflects it \
             in the upper dashed line, the ceiling in the lower, both {degrees} degrees from the axis ($\\tan\\beta = \\sqrt{{\\kappa}}$, $\\kappa = 2/5$). \
             Start at 0, thrown without spin; after floor, ceiling, floor the ball is at 3, almost at the opposite point."
        ),
        alt: format!(
            "A circle with two dashed mirror lines at plus and minus {degrees} degrees. Point 0 lies at the right. Reflected in the upper line it goes to 1, at the upper right; in the lower line to 2, \
             at the lower left; in the upper line again to 3, at the far left, just below the axis."
        ),
    };
    const CENTER: Point = [300.0, 188.0];
    const SIZE: f64 = 150.0;
    Ok(figure("bounce-reflections", 376.0, words, |pen| {
        pen.ring(CENTER, SIZE, stroke(Role::Ink, SECONDARY));
        pen.line(
            &[
                [CENTER[0] - 190.0, CENTER[1]],
                [CENTER[0] + 190.0, CENTER[1]],
            ],
            stroke(Role::Ink, AXIS),
        );
        pen.line(
            &[[CENTER[0], 18.0], [CENTER[0], 358.0]],
            stroke(Role::Ink, AXIS),
        );
        pen.text(
            [CENTER[0] + 196.0, CENTER[1] + 5.0],
            Anchor::Start,
            "*V*",
            label(Role::Ink),
        );
        pen.text(
            [CENTER[0] + 8.0, 22.0],
            Anchor::Start,
            "√κ *R*\u{03a9}",
            label(Role::Omega),
        );
        for (angle, name) in [(beta, "floor"), (-beta, "ceiling")] {
            let ends = [polar(CENTER, 186.0, angle), polar(CENTER, -186.0, angle)];
            pen.line(&ends, stroke(Role::Muted, DATA).dashed());
            let shift = if angle > 0.0 { -4.0 } else { 16.0 };
            pen.text(
                [ends[0][0] + 6.0, ends[0][1] + shift],
                Anchor::Start,
                name,
                label(Role::Muted),
            );
        }
        let point = |m: &Motion<f64>| {
            [
                CENTER[0] + SIZE * m.velocity,
                CENTER[1] - SIZE * root * m.rim_speed,
            ]
        };
        for pair in motions.windows(2) {
            let (from, to) = (point(&pair[0]), point(&pair[1]));
            pen.arrow(from, between(from, to, 0.965), stroke(Role::Ink, DATA));
        }
        for (n, m) in motions.iter().enumerate() {
            let p = point(m);
            pen.disc(p, 5.5, Role::Ink, 1.0);
            let out = between(CENTER, p, 1.13);
            pen.text(
                [out[0], out[1] + if n == 0 { -6.0 } else { 9.0 }],
                Anchor::Middle,
                &n.to_string(),
                label(Role::Ink).strong(),
            );
        }
    }))
}

/// Three balls thrown alike.
pub fn three_balls() -> Result<Figure> {
    let balls = [
        (1.0 / 3.0, "1/3", stroke(Role::Ink, DATA).dashed()),
        (0.4, "2/5", stroke(Role::Ink, DATA)),
        (2.0 / 3.0, "2/3", stroke(Role::Muted, DATA)),
    ];
    let threshold = number(return_threshold(0.4)?, 3);
    let hollow = UnderTable::new(THROWN, 2.0 / 3.0)
        .nth(2)
        .map_or(f64::NAN, |m| -m.velocity);
    let last: Vec<String> = balls
        .iter()
        .filter_map(|&(kappa, _, _)| UnderTable::new(THROWN, kappa).nth(2))
        .map(|m| number(m.velocity, 3))
        .collect();
    let words = Words {
        claim: "With a dense core it comes back exactly; a hollow one turns too far.".to_owned(),
        details: format!(
            "Balls with $\\kappa = I/MR^2$ of 1/3 (dense core), 2/5 (solid) and 2/3 (shell), thrown alike without spin, drawn without gravity. After floor, ceiling, floor their velocities are \
             {} of $V$; the first leaves without spin, on the path it came. A solid ball that bounces back less than {threshold} of its contact speed does not return at all.",
            last.join(", ")
        ),
        alt: format!(
            "Zigzag paths between floor and table of three balls thrown from the left at one point of the floor. They run right by 0.5, 0.43 and 0.2 of a flight, come back to the floor, and fly out to the left, \
             with velocities {} of the first.",
            last.join(", ")
        ),
    };
    const FLOOR: f64 = 262.0;
    const CEILING: f64 = 62.0;
    let place = |x: f64, height: f64| [352.0 + 200.0 * x, FLOOR - (FLOOR - CEILING) * height];
    Ok(figure("three-superballs", 300.0, words, |pen| {
        pen.line(
            &[[10.0, FLOOR], [590.0, FLOOR]],
            stroke(Role::Ink, SECONDARY),
        );
        pen.fill(
            &[
                [250.0, CEILING - 12.0],
                [590.0, CEILING - 12.0],
                [590.0, CEILING],
                [250.0, CEILING],
            ],
            Role::Ink,
            0.16,
        );
        pen.line(
            &[[250.0, CEILING], [590.0, CEILING]],
            stroke(Role::Ink, AXIS),
        );
        let arrives = [place(-1.17, 1.17), place(0.0, 0.0)];
        pen.line(&arrives, stroke(Role::Ink, HAIR).dashed());
        pen.arrow(
            place(-1.05, 1.05),
            place(-0.93, 0.93),
            stroke(Role::Ink, DATA),
        );
        pen.text(
            [place(-0.93, 0.93)[0] + 14.0, place(-0.93, 0.93)[1] - 4.0],
            Anchor::Start,
            "thrown",
            small(Role::Ink),
        );
        for (k, &(kappa, name, line)) in balls.iter().enumerate() {
            let ball = UnderTable::new(THROWN, kappa);
            let xs: Vec<f64> = ball.positions().take(3).collect();
            let leaves = ball.take(3).last().map_or(0.0, |m| m.velocity);
            let out = 0.62;
            let path = [
                place(0.0, 0.0),
                place(xs[0], 1.0),
                place(xs[1], 0.0),
                place(xs[1] + out * leaves, out),
            ];
            pen.line(&path[..3], line);
            pen.arrow(path[2], path[3], line);
            let [x, y] = path[3];
            let shift = [[44.0, 12.0], [2.0, -12.0], [-20.0, -12.0]][k];
            pen.text(
                [x + shift[0], y + shift[1]],
                Anchor::Middle,
                &format!("κ = {name}"),
                label(Role::Ink),
            );
        }
    })
    .value("threshold", threshold)
    .value("hollow", number(hollow, 3)))
}
