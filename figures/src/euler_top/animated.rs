//! The racket's flip as an animation (tutorial 6.3): one drawing of the flat racket, and a matrix for every picture.
//!
//! An orthographic view of a flat body is an affine map, six numbers a picture. A reader who asks for less motion, a printer,
//! and a program without CSS show one characteristic picture.

use core::fmt::Write as _;

use spinning_bodies::frame::Attitude;

use super::racket::{Face, Flat, Throw, draw, face, parts, view};
use crate::finish::{self, short};
use crate::prelude::*;
use crate::solid;

const NAME: &str = "racket-flip-animated";
const CENTER: Point = [300.0, 166.0];
/// Units per metre.
const SIZE: f64 = 420.0;
/// Pictures in a loop, and how long it takes, s.
const PICTURES: usize = 240;
const SECONDS: f64 = 10.0;
/// The picture that is shown without animation: in the first twist.
const STILL: usize = 75;
/// The graph of Ω₂ below: left, right, middle, half height.
const GRAPH: [f64; 4] = [70.0, 530.0, 372.0, 30.0];

/// One racket, thrown and caught for ever. The figure has no parameters, because only this throw closes its loop.
pub fn animated(_: &Values) -> Result<Figure> {
    let throw = Throw::aimed()?;
    let period = throw.top.period();
    let times = (0..=PICTURES).map(|k| period * k as f64 / PICTURES as f64);
    let states = throw.top.states(times).collect::<Result<Vec<_>>>()?;
    let height = |k: usize| states[k].omega.y() / throw.omega.y();
    let [left, right, middle, half] = GRAPH;
    let graph = |k: usize| {
        let x = left + (right - left) * k as f64 / PICTURES as f64;
        [x, middle - half * height(k)]
    };
    let slower = SECONDS / period;
    // x₁ up, x₂ to the left, x₃ towards the reader.
    let upright = Attitude::from_quaternion(0.0, 1.0, 0.0, 1.0)?;
    let words = words!(
        "The racket turns over twice in a period, and each time shows the other face.",
        "The second throw of the film strip, {slower:.1} times slower: two somersaults and two half twists in {period:.2} s, after which everything \
         repeats. Left, its axes: $x_1$ of the least moment, $x_2$ of the middle one, $x_3$ of the greatest. Below, $\\Omega_2$ \
         goes from one value to its negative and back.",
        "A tennis racket turns head over handle about a horizontal angular momentum. In the middle of each somersault it \
         twists by half a turn about its handle, so that the bare face and the filled face change places and the dot on the \
         rim changes sides. A graph below shows the angular velocity about the middle axis going from one value to its negative \
         and back. Without motion: the racket upside down, turned half out of its plane."
    );
    let still = figure(NAME, 424.0, words, |pen| {
        let ends = [[150.0, CENTER[1]], [520.0, CENTER[1]]];
        pen.line(ends, stroke(AngularMomentum, AXIS).dotted());
        let tail = [480.0, CENTER[1]];
        pen.arrow(tail, [552.0, CENTER[1]], stroke(AngularMomentum, 2.6));
        let place = [562.0, CENTER[1] + 6.0];
        pen.text(place, Start, "*L*", label(AngularMomentum));
        axes(pen, &upright);
        pen.line([[left, middle], [right, middle]], inked(HAIR));
        for half in [0.5, 1.0_f64] {
            let x = between([left, 0.0], [right, 0.0], half)[0];
            pen.line([[x, middle - 4.0], [x, middle + 4.0]], inked(AXIS));
            let time = format!("{} s", number(half * period, 2));
            let place = [x, middle + if half < 1.0 { -10.0 } else { 22.0 }];
            pen.note(place, Middle, &time);
        }
        let curve = (0..=PICTURES).map(graph);
        pen.line(curve, stroke(Omega, 2.0));
        let place = [left - 10.0, graph(0)[1] + 5.0];
        pen.text(place, End, "*Ω*_{2}", label(Omega));
    });
    let attitudes: Vec<Attitude> = states.iter().map(|s| s.attitude).collect();
    let dots: Vec<Point> = (0..PICTURES).map(graph).collect();
    Ok(still.moving(&moving(&attitudes[..PICTURES], &dots)))
}

/// A small racket at rest with its principal axes.
fn axes(pen: &mut Pen, attitude: &Attitude) {
    let view = View::new(-0.62, 0.3, [92.0, 106.0], 170.0);
    draw(pen, &view, attitude, 0.6);
    let arms = [
        (0.36, 0.47, "*x*_{1}"),
        (0.0, 0.3, "*x*_{2}"),
        (0.0, 0.34, "*x*_{3}"),
    ];
    for (axis, (from, to, name)) in solid::axes(attitude).into_iter().zip(arms) {
        let at = |reach: f64| view.project(&(axis * reach));
        pen.arrow(at(from), at(to), inked(SECONDARY));
        pen.label(shifted(at(to + 0.07), [0.0, 5.0]), Middle, name);
    }
}

/// The style sheet and the two groups that move.
fn moving(attitudes: &[Attitude], dots: &[Point]) -> String {
    let matrices: Vec<String> = attitudes.iter().map(matrix).collect();
    let shown = |attitude| match face(attitude, &view(CENTER, 1.0)) {
        Face::Front => "hidden".to_owned(),
        Face::Back => "visible".to_owned(),
    };
    let faces: Vec<String> = attitudes.iter().map(shown).collect();
    let places: Vec<String> = dots.iter().map(translation).collect();
    let mut svg = String::from("<style>");
    let mut frames = |name: &str, property: &str, values: &[String]| {
        let _ = write!(svg, "@keyframes fig-{NAME}-{name}{{");
        for (k, value) in values.iter().enumerate() {
            // Unchanged pictures are left out.
            if k == 0 || values[k - 1] != *value {
                let percent = 100.0 * k as f64 / values.len() as f64;
                let _ = write!(svg, "{}%{{{property}:{value}}}", short(percent, 3));
            }
        }
        svg.push('}');
    };
    frames("turn", "transform", &matrices);
    frames("face", "visibility", &faces);
    frames("pace", "transform", &places);
    for name in ["turn", "face", "pace"] {
        let _ = write!(
            svg,
            ".fig-{NAME}-{name}{{animation:fig-{NAME}-{name} {SECONDS}s step-end infinite}}"
        );
    }
    let all = format!(".fig-{NAME}-turn,.fig-{NAME}-face,.fig-{NAME}-pace");
    svg += &format!(
        ".fig-{NAME}-turn{{--fig-{NAME}-pen:1}}@media (max-width:620px){{.fig-{NAME}-turn{{--fig-{NAME}-pen:0.6}}}}"
    );
    svg += &finish::stops(NAME, &all);
    let ([x, y], turn) = (CENTER.map(|units| units * SCALE), &matrices[STILL]);
    let _ = writeln!(
        svg,
        "<g transform=\"translate({x:.0} {y:.0})\"><g class=\"fig-{NAME}-turn\" transform=\"{turn}\" stroke=\"currentColor\">"
    );
    racket(&mut svg, &faces[STILL]);
    let _ = writeln!(svg, "</g></g>");
    let _ = writeln!(
        svg,
        "<circle class=\"fig-{NAME}-pace\" r=\"55\" fill=\"{}\" transform=\"{}\"/>",
        Omega.paint(),
        places[STILL].replace("px", "")
    );
    svg
}

/// The flat racket in canvas units, its handle along x.
fn racket(svg: &mut String, back: &str) {
    let parts = parts();
    let path = |line: &Flat| {
        let mut d = String::new();
        for (k, [along, across]) in line.iter().enumerate() {
            let (x, y) = (along * SIZE * SCALE, across * SIZE * SCALE);
            let _ = write!(d, "{}{x:.0} {y:.0}", if k == 0 { "M" } else { "L" });
        }
        d
    };
    let all = |lines: &[Flat]| lines.iter().map(&path).collect::<String>();
    // The strokes keep their width while the racket is seen foreshortened; they are pixels of the page, so a narrow page
    // takes a finer pen.
    let mut draw = |d: String, width: f64, rest: &str| {
        let _ = writeln!(
            svg,
            "<path d=\"{d}\" style=\"stroke-width:calc({width}px*var(--fig-{NAME}-pen,1))\" \
             vector-effect=\"non-scaling-stroke\"{rest}/>"
        );
    };
    let head = path(&parts.head) + "Z";
    let face = format!(
        " class=\"fig-{NAME}-face\" visibility=\"{back}\" fill=\"currentColor\" fill-opacity=\"0.55\""
    );
    draw(head.clone(), 0.0, &face);
    draw(all(&parts.strings), 0.6, "");
    draw(all(&parts.throat), 2.2, "");
    draw(head, 3.4, "");
    draw(path(&parts.grip), 10.0, "");
    draw(path(&vec![parts.mark; 2]), 12.0, "");
}

/// The map from the plane of the racket to the canvas.
fn matrix(attitude: &Attitude) -> String {
    let view = view([0.0, 0.0], 1.0);
    let [x, y, _] = solid::axes(attitude).map(|axis| view.project(&axis));
    let [a, b, c, d] = [x[0], x[1], y[0], y[1]].map(|n| short(n, 3));
    format!("matrix({a},{b},{c},{d},0,0)")
}

fn translation(at: &Point) -> String {
    format!("translate({:.0}px,{:.0}px)", at[0] * SCALE, at[1] * SCALE)
}
