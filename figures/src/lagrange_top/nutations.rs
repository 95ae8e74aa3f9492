//! Traces of the nose, each at its place in the plane of L_vert and L₃ (tutorial 7.2, pictures k, l, m, n).

use spinning_bodies::lagrange_top::{LagrangeTop, Nutation};

use super::launch::*;
use crate::prelude::*;

/// cos θ of every start: 60 degrees.
const HEIGHT: f64 = 0.5;
/// Where both momenta vanish, and units to one of them.
const ORIGIN: Point = [214.0, 490.0];
const UNIT: Point = [70.0, 112.0];
/// The plane that is shown: L_vert from and to, greatest L₃.
const REACH: [f64; 3] = [-2.95, 5.35, 4.15];
/// Radius of a sphere, units, and from how far above it is seen, radians.
const RADIUS: f64 = 52.0;
const SEEN: f64 = 0.5;

parameters! {
    VERTICAL: "vertical", r"L_{\text{vert}}", "", "vertical angular momentum of your top", [-2.9, 5.3], -0.5, dragged(|values| yours(values).center());
    AXIAL: "axial", "L_3", "", "axial angular momentum of your top", [0.0, 4.1], 1.5, dragged(|values| yours(values).center());
}
/// The parameters: the ring on the map is the handle of both.
pub const NUTATIONS: &[Parameter] = &[VERTICAL, AXIAL];

/// The sphere of the top whose momenta are chosen: its centre and radius.
const YOURS: (Point, f64) = ([529.0, 409.0], 56.0);

/// A sphere on the map.
struct Globe {
    name: &'static str,
    /// L_vert and L₃.
    momenta: [f64; 2],
    /// Duration of the trace, in nutations, or in turns if there are none.
    cycles: f64,
    /// Where the name stands, from the centre of the sphere.
    beside: Point,
    anchor: Anchor,
}

fn place(vertical: f64, axial: f64) -> Point {
    [ORIGIN[0] + UNIT[0] * vertical, ORIGIN[1] - UNIT[1] * axial]
}

/// L_vert of a start at this rate φ′ (7.2).
fn vertical(pace: f64, axial: f64) -> f64 {
    pace * (1.0 - HEIGHT * HEIGHT) + axial * HEIGHT
}

/// The trace of the nose of a top.
struct Trace {
    /// Seconds, and where the nose is.
    points: Vec<(f64, Vector)>,
    /// Heights of the turning circles.
    heights: [f64; 2],
    /// From where the middle of the trace is seen.
    azimuth: f64,
    kind: Nutation,
}

impl Globe {
    /// φ′ at the start.
    fn pace(&self) -> f64 {
        let [vertical, axial] = self.momenta;
        (vertical - axial * HEIGHT) / (1.0 - HEIGHT * HEIGHT)
    }

    fn top(&self) -> Result<LagrangeTop> {
        launch(HEIGHT, self.pace(), self.momenta[1])
    }

    fn center(&self) -> Point {
        place(self.momenta[0], self.momenta[1])
    }

    fn trace(&self) -> Result<Trace> {
        let top = self.top()?;
        let roots = top.roots();
        let circle = self.cycles == 1.0 || top.kind() == Nutation::PurePrecession;
        let time = match circle {
            true => TAU / self.pace().abs(),
            false => self.cycles * top.period(),
        };
        // A top takes infinite time to leave the upright position.
        let time = if time.is_finite() { time } else { 20.0 };
        let points = tried(spaced([0.0, time], 600), |t| Ok((t, nose(&top, t)?)))?;
        let turned = top.precession_per_nutation().unwrap_or_default() * self.cycles;
        // From the side on which more of it is, where the other shows next to nothing.
        let view = View::new(0.5 * turned, SEEN, [0.0; 2], 1.0);
        let front = points.iter().filter(|(_, nose)| view.faces(nose)).count();
        let side = if front < 60 { PI } else { 0.0 };
        Ok(Trace {
            points,
            heights: [roots.h1, roots.h2],
            azimuth: if circle { 0.0 } else { 0.5 * turned + side },
            kind: top.kind(),
        })
    }

    /// The sphere, its turning circles and the trace.
    fn draw(&self, pen: &mut Pen, trace: &Trace, (center, radius): (Point, f64)) {
        let view = View::new(trace.azimuth, SEEN, center, radius);
        pen.disc(center, radius, Shade, 1.0);
        pen.ring(center, radius, inked(AXIS));
        for h in trace.heights {
            let r = (1.0 - h * h).max(0.0).sqrt();
            let [front, _] = view.halves(&latitude(h, r, 120));
            pen.lines(front, inked(HAIR).alpha(0.6));
        }
        let points: Vec<Vector> = trace.points.iter().map(|(_, nose)| *nose).collect();
        let [front, back] = view.halves(&points);
        pen.lines(back, inked(HAIR).alpha(0.5));
        pen.lines(front, inked(DATA));
        pen.label(shifted(center, self.beside), self.anchor, self.name);
    }
}

/// The top whose momenta are chosen.
fn yours(values: &Values) -> Globe {
    Globe {
        name: "yours",
        momenta: values.each([VERTICAL, AXIAL]),
        cycles: 3.0,
        beside: [0.0, -YOURS.1 - 9.0],
        anchor: Middle,
    }
}

/// The name of a motion in the caption.
fn told(kind: Nutation, pace: f64) -> &'static str {
    match kind {
        Nutation::Waves if pace < 0.0 => "waves, backwards",
        Nutation::Waves => "waves",
        Nutation::Cusps => "cusps",
        Nutation::Loops => "loops",
        Nutation::PurePrecession => "a circle",
        Nutation::SphericalPendulum => "the path of a spherical pendulum",
        Nutation::PlanePendulum => "the arc of a pendulum in one plane",
        Nutation::Waking => "the way up to the upright position and back, for ever",
        _ => "a point",
    }
}

fn globes() -> Result<Vec<Globe>> {
    let slow = vertical(pure_rates(HEIGHT, 3.0)?[0], 3.0);
    let fast = vertical(pure_rates(HEIGHT, 2.0)?[1], 2.0);
    let globe = |name, momenta, cycles, beside, anchor| Globe {
        name,
        momenta,
        cycles,
        beside,
        anchor,
    };
    let below = RADIUS + 20.0;
    let above = -RADIUS - 9.0;
    Ok(vec![
        globe("waves, backwards", [-2.1, 1.0], 2.0, [12.0, below], Middle),
        globe("loops", [-1.1, 2.75], 3.0, [0.0, above], Middle),
        globe("cusps", [1.0, 2.0], 3.0, [-24.0, above], Middle),
        globe("waves", [2.0, 1.0], 1.5, [RADIUS + 8.0, 18.0], Start),
        globe("slow circle", [slow, 3.0], 1.0, [-22.0, above], End),
        globe("fast circle", [fast, 2.0], 1.0, [12.0, below], End),
        globe("loops", [3.25, 3.6], 5.0, [0.0, above], Middle),
        globe("waves", [4.6, 3.05], 2.5, [0.0, above], Middle),
        globe("pendulum", [0.75, 0.0], 4.0, [0.0, below], Middle),
    ])
}

/// The part of a line that is on the map and on no sphere.
fn clear(pen: &mut Pen, points: &[Point], globes: &[Globe], style: Stroke) {
    let [left, right, top] = REACH;
    let ([x0, y0], [x1, _]) = (place(left, top), place(right, top));
    let away = |p: &Point| {
        globes
            .iter()
            .all(|one| distance(*p, one.center()) >= RADIUS)
    };
    let free = |p: &Point| (x0..=x1).contains(&p[0]) && p[1] >= y0 && away(p);
    for piece in points.split(|p| !free(p)) {
        // Breaks of a broken line need long pieces.
        pen.line(piece, style);
    }
}

/// The lines that separate the kinds of motion, each by its L₃ and L_vert.
fn borders() -> Result<[(Vec<Point>, bool); 6]> {
    let top = REACH[2];
    let from = |least: f64| spaced([least, top], 900);
    let along = |least: f64, vertical: fn(f64) -> f64| {
        let places = from(least).map(|axial| place(vertical(axial), axial));
        places.collect()
    };
    let least = (4.0 * HEIGHT).sqrt() * (1.0 + f64::EPSILON);
    let pure = |which: usize| {
        tried(from(least), |axial| {
            let rate = pure_rates(HEIGHT, axial)?[which];
            Ok(place(vertical(rate, axial), axial))
        })
    };
    // Released from rest at cos θ = 1/2 + 3/(2L₃²) it dips to 60 degrees; from the top itself for L₃ = √3.
    let rest = |axial: f64| axial * HEIGHT + (1.0 - HEIGHT * HEIGHT) * 2.0 / axial;
    Ok([
        (along(0.0, |axial| axial * HEIGHT), false),
        (along(3.0_f64.sqrt(), rest), false),
        (along(0.0, |axial| -axial), true),
        (along(3.0_f64.sqrt(), |axial| axial), true),
        (pure(0)?, false),
        (pure(1)?, false),
    ])
}

/// The kinds of nutation on the map of the two momenta.
pub fn nutations(values: &Values) -> Result<Figure> {
    let globes = globes()?;
    let drawn = tried(&globes, Globe::trace)?;
    let [slow, fast] = [4, 5].map(|k: usize| globes[k].pace());
    let yours = yours(values);
    let own = yours.trace()?;
    let [vertical, axial] = briefs(yours.momenta);
    let tilts = own.heights.map(|height| height.clamp(-1.0, 1.0).acos());
    let [greatest, least] = numbers(tilts.map(f64::to_degrees), 1);
    let kind = [told(own.kind, yours.pace()), "a circle"][usize::from(least == greatest)];
    let [slow, fast] = numbers([slow, fast], 4);
    let words = words!(
        "Two momenta decide whether the nose draws waves, cusps, loops or a circle.",
        "The tutorial's pictures k, l, m and n: every top starts 60° from the vertical, at a turning point, with $I_1 = Mg\\ell = 1$. Dashed: cusps. Dotted: the nose passes through a pole, $L_3 = \\pm L_{{\\text{{vert}}}}$. Solid: pure precession, \
         slow ({slow} at $L_3 = 3$) on the left, fast ({fast} at $L_3 = 2$) on the right. The ring is yours, $L_{{\\text{{vert}}}} = {vertical}$ and $L_3 = {axial}$: it draws \
         {kind}, between {least}° and {greatest}°.",
        "A half plane, the vertical angular momentum to the right and the axial one upwards, with nine spheres on it, each with \
         the trace of the nose of a top that starts 60 degrees from the vertical. From left to right: backward waves, loops, \
         cusps on a dashed line, waves, a circle of slow precession on one branch of a solid curve, loops and waves between \
         the branches, a circle of fast precession on the other branch; at the bottom, without axial momentum, a spherical \
         pendulum. Loops shrink to cusps where the dashed line is crossed and open to waves beyond. A ring at {vertical} and {axial} \
         has its sphere apart: the nose draws {kind}."
    );
    let borders = borders()?;
    let made = figure("nutations", 566.0, words, |pen| {
        let [left, right, top] = REACH;
        let ink = inked(AXIS);
        for (from, to) in [([left, 0.0], [right, 0.0]), ([0.0; 2], [0.0, top])] {
            let [from, to] = [from, to].map(|[x, y]| place(x, y));
            let axis = spaced([0.0, 1.0], 400).map(|share| between(from, to, share));
            let axis: Vec<Point> = axis.collect();
            clear(pen, &axis, &globes, ink);
        }
        for k in [-2, -1, 1, 2, 3, 4, 5] {
            let [x, y] = place(f64::from(k), 0.0);
            let off = |globe: &Globe| distance([x, y], globe.center());
            if globes.iter().all(|globe| off(globe) > RADIUS + 2.0) {
                pen.tick_below([x, y], 21.0, &number(f64::from(k), 0));
            }
        }
        for k in [1, 2, 3, 4] {
            pen.tick_beside(place(0.0, f64::from(k)), &k.to_string());
        }
        let spot = [place(right, 0.0)[0], ORIGIN[1] + 48.0];
        pen.text(spot, End, "*L*_{vert}", label(AngularMomentum));
        let spot = shifted(place(0.0, top), [9.0, 10.0]);
        pen.text(spot, Start, "*L*_{3}", label(AngularMomentum));
        for (k, (points, pole)) in borders.iter().enumerate() {
            let style = match (k, pole) {
                (_, true) => muted(SECONDARY).dotted(),
                (0 | 1, _) => inked(SECONDARY).dashed(),
                _ => inked(1.8),
            };
            clear(pen, points, &globes, style);
        }
        for (globe, trace) in globes.iter().zip(&drawn) {
            globe.draw(pen, trace, (globe.center(), RADIUS));
        }
        yours.draw(pen, &own, YOURS);
        let [x, y] = YOURS.0;
        let rings = [yours.center(), [x - 32.0, y - YOURS.1 - 14.0]];
        for at in rings {
            pen.disc(at, 6.0, Paper, 1.0);
            pen.ring(at, 6.0, inked(DATA));
            pen.dot(at, 2.0);
        }
    });
    let columns = "time (√(I1/Mgl)) | tilt (°) | azimuth (°)";
    let named = globes.iter().zip(&drawn).chain([(&yours, &own)]);
    Ok(named.fold(made, |made, (globe, trace)| {
        let [vertical, axial] = globe.momenta;
        let name = format!("{}, Lvert = {vertical}, L3 = {axial}", globe.name);
        made.data(name, columns, trace.points.iter().copied().map(angles))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Just left and right of every border on the map, the library reports different kinds.
    #[test]
    fn the_borders_part_the_kinds() {
        let kind = |at: Point, shift: f64| {
            let momenta = [
                (at[0] - ORIGIN[0]) / UNIT[0] + shift,
                (ORIGIN[1] - at[1]) / UNIT[1],
            ];
            let top = Globe {
                name: "",
                momenta,
                cycles: 1.0,
                beside: [0.0; 2],
                anchor: Start,
            }
            .top();
            top.map(|top| top.kind()).expect("a finite top")
        };
        for (k, (points, _)) in borders().expect("finite tops").into_iter().enumerate() {
            for at in points.iter().skip(100).step_by(100) {
                let sides = [kind(*at, -1e-4), kind(*at, 1e-4)];
                let expected = match k {
                    0 => [Nutation::Loops, Nutation::Waves],
                    1 => [Nutation::Waves, Nutation::Loops],
                    2 => [Nutation::Waves, Nutation::Loops],
                    3 => [Nutation::Loops, Nutation::Waves],
                    // On both sides of pure precession there are waves.
                    _ => [Nutation::Waves, Nutation::Waves],
                };
                assert_eq!(sides, expected, "border {k} at {at:?}");
            }
        }
    }
}
