//! A moving top for each kind of nutation (tutorial 7.2 to 7.4).
//!
//! Seen from far away a flywheel is an affine image of a disc and its axle a line: six numbers each for every picture. Every top
//! closes its path after one turn about the vertical, so that the film can be repeated.

use core::fmt::Write as _;

use spinning_bodies::frame::BodyVector;
use spinning_bodies::lagrange_top::LagrangeTop;

use super::launch::*;
use crate::finish::{self, short};
use crate::prelude::*;

const NAME: &str = "top-animated";
/// cos θ of every start: 60 degrees.
const HEIGHT: f64 = 0.5;
/// Nutations in a turn about the vertical.
const NUTATIONS: f64 = 5.0;
/// Spokes of a flywheel.
const SPOKES: usize = 3;
/// Pictures in a loop.
const PICTURES: usize = 240;
/// The picture that is shown without animation.
const STILL: usize = 56;
/// Seconds per unit of time.
const SLOWNESS: f64 = 0.7;
/// Radius of a sphere; where the flywheel sits on the axle, and its radius, in radii of the sphere.
const RADIUS: f64 = 116.0;
const SEAT: f64 = 0.56;
const WHEEL: f64 = 0.36;

/// A top whose loop closes.
struct Loop {
    name: &'static str,
    center: Point,
    /// φ′ of the start.
    pace: f64,
    axial: f64,
    time: f64,
    top: LagrangeTop,
    path: Vec<Vector>,
}

/// L₃ with which a top that starts at the rate `pace` goes round once in five nutations.
fn closing(pace: f64) -> Result<f64> {
    // The faster the spin, the less the top goes round in a nutation.
    border([1.9, 4.0], |axial| {
        let advance = launch(HEIGHT, pace, axial)?.precession_per_nutation();
        Ok(NUTATIONS * advance.unwrap_or(f64::NAN) > TAU)
    })
}

impl Loop {
    fn new(
        name: &'static str,
        center: Point,
        pace: f64,
        axial: f64,
        time: Option<f64>,
    ) -> Result<Self> {
        let top = launch(HEIGHT, pace, axial)?;
        let time = time.unwrap_or(NUTATIONS * top.period());
        // The angle that the body has turned about its axis when the axis is back, and the spin near L₃ that makes it a whole number of
        // spokes.
        let (start, end) = (top.at(0.0)?.attitude, top.at(time)?.attitude);
        let side = start.to_body(end.to_space(BodyVector::new(1.0, 0.0, 0.0)));
        let turned = side.y().atan2(side.x());
        let spin = axial - turned.rem_euclid(TAU / SPOKES as f64) / time;
        let top = launch_body(HEIGHT, pace, axial / spin, spin)?;
        Ok(Self {
            name,
            center,
            pace,
            axial,
            time,
            path: tried(spaced([0.0, time], 900), |t| nose(&top, t))?,
            top,
        })
    }

    /// Sphere, path and name, which do not move.
    fn draw(&self, pen: &mut Pen) {
        let view = View::new(0.55, 0.5, self.center, RADIUS);
        pen.disc(self.center, RADIUS, Shade, 1.0);
        pen.ring(self.center, RADIUS, inked(AXIS));
        let roots = self.top.roots();
        for h in [roots.h1, roots.h2] {
            let r = (1.0 - h * h).sqrt();
            let [front, _] = view.halves(&latitude(h, r, 180));
            pen.lines(front, inked(HAIR).alpha(0.5));
        }
        let [front, back] = view.halves(&self.path);
        pen.lines(back, inked(AXIS).alpha(0.5));
        pen.lines(front, inked(DATA).alpha(0.85));
        let below = shifted(self.center, [0.0, RADIUS + 22.0]);
        pen.label(below, Middle, self.name);
    }

    /// The transforms of axle and flywheel, picture by picture.
    fn frames(&self) -> Result<[Vec<String>; 2]> {
        let view = View::new(0.55, 0.5, [0.0, 0.0], 1.0);
        let mut frames = [Vec::new(), Vec::new()];
        for k in 0..PICTURES {
            let state = self.top.at(self.time * k as f64 / PICTURES as f64)?;
            let [e1, e2, e3] = axes(&state.attitude).map(|e| view.project(&e));
            frames[0].push(matrix(e3, [-e3[1], e3[0]], [0.0, 0.0]));
            frames[1].push(matrix(e1, e2, e3.map(|c| c * SEAT * RADIUS * SCALE)));
        }
        Ok(frames)
    }
}

fn matrix(x: Point, y: Point, to: Point) -> String {
    let [a, b, c, d] = [x[0], x[1], y[0], y[1]].map(|n| short(n, 3));
    let [e, f] = to.map(|n| short(n, 0));
    format!("matrix({a},{b},{c},{d},{e},{f})")
}

/// The four tops: pushed forward, released, pushed back, and pushed at the slow rate of pure precession.
fn tops() -> Result<[Loop; 4]> {
    let paces = [0.25, 0.0, -0.5];
    let axial = tried(paces, closing)?;
    let [slow, _] = pure_rates(HEIGHT, axial[1])?;
    let round = Some(TAU / slow);
    Ok([
        Loop::new("waves", [158.0, 130.0], paces[0], axial[0], None)?,
        Loop::new("cusps", [442.0, 130.0], paces[1], axial[1], None)?,
        Loop::new("loops", [158.0, 416.0], paces[2], axial[2], None)?,
        Loop::new("pure precession", [442.0, 416.0], slow, axial[1], round)?,
    ])
}

/// Waves, cusps, loops, and none of them. The figure has no parameters, because its spins are those that close the paths.
pub fn top_animated(_: &Values) -> Result<Figure> {
    let tops = tops()?;
    let [waves, cusps, loops, pure] = &tops;
    let seconds = number(10.0 * SLOWNESS, 0);
    let (forward, back) = (number(waves.pace, 2), number(loops.pace, 1));
    let slow = number(pure.pace, 4);
    let [a, b, c, d] = [waves, cusps, loops, pure].map(|top| number(top.axial, 4));
    let words = words!(
        "One push decides how the nose goes round: waves, cusps, loops, or a circle.",
        "Four tops start 60° from the vertical, $I_1 = Mg\\ell = 1,$ ten units of time in {seconds} s: pushed forward at \
         $\\varphi' = {forward}$, released from rest, pushed back at ${back}$, pushed at exactly the slow rate {slow}. The spins, \
         $L_3 = {a}$, {b}, {c} and {d}, make every path close.",
        "Four spheres, in each a flywheel on an axle that stands on the centre and touches the sphere with its nose. The nose draws \
         a wavy line, a row of arches that meet in upright cusps, a row of loops, and a circle of latitude, while the flywheel spins \
         and the axle goes round the vertical. Each path closes after one turn. \
         Without motion: each top a quarter of the way round."
    );
    let still = figure(NAME, 566.0, words, |pen| {
        tops.iter().for_each(|top| top.draw(pen));
    });
    Ok(still.moving(&moving(&tops)?))
}

/// The style sheet and the groups that move.
fn moving(tops: &[Loop]) -> Result<String> {
    let mut style = String::from("<style>");
    let mut groups = String::new();
    let mut all = String::new();
    for top in tops {
        let [axle_frames, wheel_frames] = top.frames()?;
        let [x, y] = top.center.map(|units| units * SCALE);
        let _ = writeln!(
            groups,
            "<g transform=\"translate({x:.0} {y:.0})\" stroke=\"currentColor\">"
        );
        // The axle is drawn over the wheel, so that it is visible from below as well.
        for (part, paths, values) in [
            ("wheel", wheel(), wheel_frames),
            ("axle", axle(), axle_frames),
        ] {
            let class = top.name.trim_end_matches(" precession");
            let name = format!("fig-{NAME}-{class}-{part}");
            let percent = |n: usize| short(100.0 * n as f64 / PICTURES as f64, 3);
            let shares = (0..PICTURES).map(percent);
            let seconds = short(SLOWNESS * top.time, 3);
            style += &finish::keyframes(&name, shares.zip(&values));
            style += &format!(".{name}{{animation:{name} {seconds}s step-end infinite}}");
            let _ = write!(all, "{}.{name}", if all.is_empty() { "" } else { "," });
            let _ = writeln!(
                groups,
                "<g class=\"{name}\" transform=\"{}\">\n{paths}</g>",
                values[STILL]
            );
        }
        groups.push_str("</g>\n");
    }
    style += &format!(
        "#fig-{NAME}-svg{{--fig-{NAME}-pen:1}}@media (max-width:620px){{#fig-{NAME}-svg{{--fig-{NAME}-pen:0.6}}}}"
    );
    Ok(style + &finish::stops(NAME, &all) + &groups)
}

/// A path whose stroke keeps its width however the picture is stretched.
fn path(d: &str, width: f64, rest: &str) -> String {
    format!(
        "<path d=\"{d}\" style=\"stroke-width:calc({width}px*var(--fig-{NAME}-pen,1))\" \
         vector-effect=\"non-scaling-stroke\"{rest}/>\n"
    )
}

fn axle() -> String {
    let end = RADIUS * SCALE;
    path(&format!("M0 0L{end:.0} 0"), 2.6, "") + &path(&format!("M{end:.0} 0L{end:.0} 0"), 8.0, "")
}

fn wheel() -> String {
    let r = WHEEL * RADIUS * SCALE;
    let rim = format!("M{r:.0} 0A{r:.0} {r:.0} 0 1 1 -{r:.0} 0A{r:.0} {r:.0} 0 1 1 {r:.0} 0Z");
    let spokes: String = (0..SPOKES)
        .map(|k| (TAU * k as f64 / SPOKES as f64 + 0.5 * PI).sin_cos())
        .map(|(s, c)| format!("M0 0L{:.0} {:.0}", r * c, r * s))
        .collect();
    path(&rim, 2.4, " fill=\"currentColor\" fill-opacity=\"0.16\"") + &path(&spokes, 1.4, "")
}

#[cfg(test)]
mod tests {
    use super::*;
    use spinning_bodies::lagrange_top::Nutation;

    /// The last picture is followed smoothly by the first, and every top has the nutation of its name.
    #[test]
    fn the_loops_close() {
        let tops = tops().expect("four tops");
        for (top, kind) in tops
            .iter()
            .zip([Nutation::Waves, Nutation::Cusps, Nutation::Loops])
        {
            assert_eq!(top.top.kind(), kind, "{}", top.name);
        }
        // The rate of pure precession is rounded, so a narrow band remains. Observed: 1e-15.
        let roots = tops[3].top.roots();
        assert!(roots.h2 - roots.h1 < 4e-15, "{}", roots.h2 - roots.h1);
        for top in &tops {
            let [start, end] = [0.0, top.time].map(|t| top.top.at(t).expect("a state").attitude);
            let [first, last] = [start, end].map(|attitude| axes(&attitude));
            // Observed: 1e-13.
            assert!((first[2] - last[2]).norm() < 1e-12, "{}", top.name);
            let turned = first[1].dot(&last[0]).atan2(first[0].dot(&last[0]));
            let spokes = turned * SPOKES as f64 / TAU;
            assert!(
                (spokes - spokes.round()).abs() < 1e-12,
                "{}: {spokes}",
                top.name
            );
        }
    }
}
