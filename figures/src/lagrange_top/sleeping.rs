//! f(h) and its roots while the spin of a sleeping top falls through the threshold (tutorial 7.5).

use spinning_bodies::Result;
use spinning_bodies::lagrange_top::{LagrangeTop, Roots};

use super::launch;
use crate::Figure;
use crate::style::{
    AXIS, Anchor, HAIR, Pen, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

/// L₃ of the curves: above the threshold, at it, below it.
const SPINS: [f64; 5] = [2.4, 2.15, 2.0, 1.85, 1.7];
/// Angular velocity across the axis after a kick, rad/s.
const KICK: f64 = 0.01;
/// Left and right end of the axis of h, height of zero, units to one of f.
const FRAME: [f64; 4] = [44.0, 556.0, 150.0, 760.0];
/// The part of the axis of h that is shown.
const SHOWN: [f64; 2] = [0.4, 1.56];
/// The greatest |f| shown, below and above zero.
const CUT: [f64; 2] = [-0.215, 0.145];

fn place(h: f64, f: f64) -> Point {
    let [left, right, zero, unit] = FRAME;
    [
        left + (right - left) * (h - SHOWN[0]) / (SHOWN[1] - SHOWN[0]),
        zero - unit * f,
    ]
}

/// f(h) from its roots (7.2), I₁ = Mgl = 1.
fn cubic(roots: &Roots, h: f64) -> f64 {
    2.0 * (h - roots.h1) * (h - roots.h2) * (h - roots.h3)
}

/// The root that is not the double one of the sleeping top.
fn loner(roots: &Roots) -> f64 {
    if roots.h3 > 1.0 { roots.h3 } else { roots.h1 }
}

fn kicked(axial: f64, kick: f64) -> Result<LagrangeTop> {
    use spinning_bodies::frame::{Attitude, BodyVector};
    let omega = BodyVector::new(kick, 0.0, axial);
    LagrangeTop::new(1.0, 1.0, 1.0, omega, Attitude::identity())
}

/// The third root goes through the double one, and the sign of f next to h = 1 changes.
pub fn sleeping_threshold() -> Result<Figure> {
    let curves = SPINS
        .iter()
        .map(|axial| Ok((*axial, launch(1.0, 0.0, *axial)?.roots())))
        .collect::<Result<Vec<_>>>()?;
    let tilt = |axial: f64| -> Result<f64> {
        let roots = kicked(axial, KICK)?.roots();
        // 1 − cos θ without cancellation.
        Ok(2.0 * (0.5 * roots.one_less[0]).sqrt().asin().to_degrees())
    };
    let (above, at, below) = (tilt(2.4)?, tilt(2.0)?, tilt(1.7)?);
    let words = Words {
        claim: "A top sleeps until its third root has come down past the upright position."
            .to_owned(),
        details: format!(
            "$f(h)$ of an upright top, $I_1 = Mg\\ell = 1$, as $L_3$ falls from 2.4 to 1.7. The motion needs $f\\ge0$: shaded, the room \
             below $h = 1$ that opens under the threshold $L_3 = 2$, down to $\\cos\\theta = {}$ for 1.7. A sideways kick of 0.01 tilts the \
             top by {}° at $L_3 = 2.4$, by {}° at 2 and by {}° at 1.7.",
            number(loner(&curves[4].1), 3),
            number(above, 2),
            number(at, 2),
            number(below, 2),
        ),
        alt: format!(
            "Five cubics that all touch or cross zero at h = 1. For fast spin the curve touches zero from below at 1 and crosses further right. \
             As the spin falls the crossing moves left, reaches 1 at the threshold, where the curve has a flat crossing, and goes on to {} for \
             the slowest top: there the curve is positive between the crossing and 1, and the top falls over as far as that.",
            number(loner(&curves[4].1), 2),
        ),
    };
    Ok(figure("sleeping-threshold", 352.0, words, |pen| {
        axes(pen);
        for (axial, roots) in &curves {
            let points: Vec<Point> = (0..=600)
                .map(|k| SHOWN[0] + (SHOWN[1] - SHOWN[0]) * f64::from(k) / 600.0)
                .map(|h| (h, cubic(roots, h)))
                .filter(|(_, f)| (CUT[0]..=CUT[1]).contains(f))
                .map(|(h, f)| place(h, f))
                .collect();
            let style = match axial.total_cmp(&2.0) {
                core::cmp::Ordering::Greater => stroke(Role::Ink, SECONDARY),
                core::cmp::Ordering::Equal => stroke(Role::AngularMomentum, 2.6),
                core::cmp::Ordering::Less => stroke(Role::Ink, SECONDARY).dashed(),
            };
            // The room that the top may fall into.
            let room: Vec<Point> = points
                .iter()
                .filter(|p| p[0] <= place(1.0, 0.0)[0] && p[1] <= FRAME[2])
                .copied()
                .collect();
            if *axial < 2.0 {
                pen.fill(&room, Role::Ink, 0.13);
            }
            pen.line(&points, style);
            let root = loner(roots);
            if root < SHOWN[1] {
                pen.disc(place(root, 0.0), 3.6, Role::AngularMomentum, 1.0);
            }
            let role = if *axial == 2.0 {
                Role::AngularMomentum
            } else {
                Role::Ink
            };
            let digits = number(*axial, if *axial * 10.0 % 1.0 > 0.2 { 2 } else { 1 });
            if let Some([x, y]) = points.first() {
                // The number stands at the left end of its curve, that of the last one over its crest.
                let crest = points.iter().filter(|p| p[0] < place(0.9, 0.0)[0]);
                let [top_x, top_y] = crest.fold([*x, *y], |a, b| if b[1] < a[1] { *b } else { a });
                if *x < FRAME[0] + 3.0 && top_y < *y && *axial < 1.8 {
                    let text = format!("*L*_{{3}} = {digits}");
                    pen.text([top_x, top_y - 9.0], Anchor::Middle, &text, small(role));
                } else {
                    pen.text([x + 8.0, *y], Anchor::Start, &digits, small(role));
                }
            }
        }
    }))
}

fn axes(pen: &mut Pen) {
    let ink = stroke(Role::Ink, AXIS);
    pen.line(&[place(SHOWN[0], 0.0), place(SHOWN[1], 0.0)], ink);
    pen.line(&[place(SHOWN[0], CUT[0]), place(SHOWN[0], CUT[1])], ink);
    pen.line(
        &[place(1.0, CUT[0]), place(1.0, CUT[1])],
        stroke(Role::Muted, HAIR).dotted(),
    );
    for h in [0.5, 1.0, 1.5] {
        let [x, y] = place(h, 0.0);
        pen.line(&[[x, y], [x, y + 5.0]], ink);
        pen.text(
            [x + 4.0, y + 24.0],
            Anchor::Start,
            &number(h, 1),
            small(Role::Ink),
        );
    }
    pen.text(
        [FRAME[0] + 10.0, 34.0],
        Anchor::Start,
        "*f*(*h*)",
        label(Role::Ink),
    );
    pen.text(
        [FRAME[1] + 9.0, FRAME[2] + 5.0],
        Anchor::Start,
        "*h*",
        label(Role::Ink),
    );
}
