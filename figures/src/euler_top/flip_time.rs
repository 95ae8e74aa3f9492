//! The time before a racket flips, over sixteen decades of the distance from the separatrix (tutorial 6.3, 6.7).

use spinning_bodies::frame::{Attitude, BodyVector};

use super::body::*;
use crate::prelude::*;

/// The results of well-known libraries, measured with the scripts next to the table.
const PEERS: &str = include_str!("../../../tests/reference/peers/flip_time.csv");
/// Relative error above which a flip time counts as wrong.
const GIVEN_UP: f64 = 1e-3;

/// The results of a library, from its last good one on.
#[derive(Debug, Clone, PartialEq)]
struct Peer {
    name: &'static str,
    /// The last good result and the wrong ones beyond it: decades below 1, and seconds. They end where the library returns no number.
    answers: Vec<[f64; 2]>,
}

impl Peer {
    /// Whether it still gives numbers at the end of the axis.
    fn goes_on(&self) -> bool {
        let last = self.answers.last();
        last.is_some_and(|answer| answer[0] >= f64::from(DECADES) - 0.25)
    }
}

/// The libraries in the order of the table, which has a header line and decreasing tilts for each library.
fn peers() -> Vec<Peer> {
    let cells = |line: &'static str| line.split(',').collect::<Vec<_>>();
    let mut lines = PEERS.lines().map(cells);
    let head = lines.next().unwrap_or_default();
    let column = |ending: &str| head.iter().position(|name| name.ends_with(ending));
    let (Some(tilt), Some(time)) = (column("epsilon"), column("flip_time")) else {
        return Vec::new();
    };
    let error = time + 1;
    let mut found: Vec<Peer> = Vec::new();
    for cells in lines.filter(|cells| cells.len() > error && cells[0] != "exact") {
        let read = |k: usize| cells[k].trim().parse::<f64>().unwrap_or(f64::NAN);
        let answer = [-read(tilt).log10(), read(time)];
        let name = cells[0];
        if found.last().is_none_or(|peer| peer.name != name) {
            let answers = Vec::new();
            found.push(Peer { name, answers });
        }
        let Some(peer) = found.last_mut() else {
            continue;
        };
        if answer[0] > f64::from(DECADES) + 0.1 || !answer[1].is_finite() {
            continue;
        }
        if read(error).abs() <= GIVEN_UP {
            peer.answers.clear();
        }
        peer.answers.push(answer);
    }
    found
}

const DECADES: i32 = 16;
/// Left, right, bottom, top of the frame.
const FRAME: [f64; 4] = [70.0, 560.0, 330.0, 30.0];

parameters! {
    SPIN: "spin", r"\Omega_2", "rad/s", "angular velocity about the middle axis", [0.2, 20.0], 1.0, logarithmic;
    DISTANCE: "distance", r"\varepsilon", "", "distance from the middle axis at the throw", [1e-16, 1.0], 1e-2, logarithmic, dragged(|values| match Course::of(values) {
        Ok(course) => course.place(course.marked),
        Err(_) => [FRAME[0], FRAME[2]],
    });
}
/// The parameters; the handle is the ring on the line.
pub const FLIP_TIME: &[Parameter] = &[SMALLEST, MIDDLE, LARGEST, SPIN, DISTANCE];

/// Flip times, each with the number of decades by which the error of the throw is below 1.
struct Course {
    moments: [f64; 3],
    spin: f64,
    line: Vec<[f64; 2]>,
    marked: [f64; 2],
    /// The longest time on the axis, s.
    longest: f64,
}

impl Course {
    fn of(values: &Values) -> Result<Self> {
        let (moments, spin) = (moments(values), values.of(&SPIN));
        let time = |exponent: f64| -> Result<[f64; 2]> {
            let tilt = spin * 10f64.powf(-exponent);
            let omega = BodyVector::new(tilt, spin, tilt);
            let top = top_of(moments, omega, Attitude::identity())?;
            // On the separatrix there is no flip to draw.
            let time = Some(0.5 * top.period()).filter(|time| time.is_finite());
            Ok([exponent, time.unwrap_or_default()])
        };
        let line = tried(0..=DECADES, |k| time(f64::from(k)))?;
        Ok(Self {
            moments,
            spin,
            marked: time(-values.of(&DISTANCE).log10())?,
            longest: match line[DECADES as usize][1] {
                0.0 => 100.0 / spin,
                most => 1.06 * most,
            },
            line,
        })
    }

    fn place(&self, [exponent, time]: [f64; 2]) -> Point {
        self.frame().at(exponent, time)
    }

    fn frame(&self) -> Frame {
        Frame::linear([0.0, f64::from(DECADES)], [0.0, self.longest], FRAME)
    }

    fn axes(&self, pen: &mut Pen) {
        let frame = self.frame();
        let mut decades = powers((0..=DECADES).step_by(4).map(|decade| -decade));
        decades.iter_mut().for_each(|(one, _)| *one = -one.log10());
        let names = ["", "time between flips, s"];
        frame.draw(pen, &decades, &frame.y.ticks(60.0), names);
        // Clear of the powers above it.
        let below = [frame.x.ends[1], frame.y.ends[0] + 48.0];
        pen.label(below, End, "distance *ε* from the middle axis");
    }
}

/// A time to three digits.
fn seconds(time: f64) -> String {
    let digits = (2.0 - time.log10().floor()).clamp(0.0, 6.0);
    number(time, digits as usize)
}

/// Every decade closer to the separatrix adds the same time.
pub fn flip_time(values: &Values) -> Result<Figure> {
    let course = Course::of(values)?;
    let (line, spin) = (&course.line, course.spin);
    // So far out the line is straight to the last digit printed: 2 ln 10/√λ.
    let decade = line[DECADES as usize][1] - line[DECADES as usize - 1][1];
    let near = line[DECADES as usize][1];
    // The results of other libraries were measured for one body at one speed.
    let measured = [SMALLEST, MIDDLE, LARGEST, SPIN]
        .iter()
        .all(|one| values.of(one) == one.default);
    let others = if measured { peers() } else { Vec::new() };
    let (stubborn, silent): (Vec<Peer>, Vec<Peer>) = others.into_iter().partition(Peer::goes_on);
    let end = silent.iter().filter_map(|peer| peer.answers.last()).next();
    let longest = stubborn.iter().flat_map(|peer| &peer.answers);
    let longest = longest.fold(0.0, |most: f64, answer| most.max(answer[1]));
    let (others_give_up, others_measured, others_seen) = match measured {
        true => (
            "; the usual formulas give up half-way",
            "Measured: the formulas of 6.6 with four libraries' functions, two integrators with tolerance $10^{-12}$, each drawn from the last point at which it was right to a thousandth.",
            format!(
                " The answers of well-known libraries end with a cross near ten to the minus {}, where the formulas of 6.6 return no \
                 number any more; two integrators leave the line there and never see a racket wait for more than {} seconds.",
                number(end.map_or(f64::NAN, |answer| answer[0]), 1),
                number(longest.ceil(), 0),
            ),
        ),
        false => (
            "",
            "How far others follow was measured for the body and the spin of the book only.",
            String::new(),
        ),
    };
    let never = near == 0.0;
    let (inertia, beyond) = (triple(course.moments), remark(course.moments));
    let pace = match spin {
        1.0 => String::new(),
        _ => format!("{}\\,", brief(spin)),
    };
    let thrown = distance(values.of(&DISTANCE));
    let [step, last, ring] = [decade, near, course.marked[1]].map(seconds);
    let rounds = number(near * spin / TAU, 1);
    let words = match never {
        true => words!(
            "Equal parts of spin about the first and the third axis put this body on its separatrix: its spin about the middle axis grows to the full, and it never flips.",
            "For $I = {inertia}$ the throw $\\Omega(0) = {pace}(\\varepsilon, 1, \\varepsilon)$ rad/s has $L^2 = 2EI_2$ for every $\\varepsilon$, {thrown} as well: \
             the time from flip to flip is infinite. Move a moment a little, and the line is there.{beyond}",
            "Empty axes for the time between two flips against the distance from the middle axis: for the moments {inertia} there is no flip."
        ),
        false => words!(
            "Close to the middle axis each further decade buys the same {step} seconds before the flip{others_give_up}.",
            "Half the period of $\\Omega$ for $I = {inertia}$ and $\\Omega(0) = {pace}(\\varepsilon, 1, \\varepsilon)$ rad/s. A decade adds $2\\ln 10/\\sqrt{{\\lambda}} = \
             {decade:.3}$ s: {ring} s at $\\varepsilon = {thrown}$ (ring), {last} s or {rounds} turns at $10^{{-{DECADES}}}$. {others_measured}{beyond}",
            "The time between two flips against the initial distance from the middle axis, on a logarithmic axis over {DECADES} decades: \
             a line that soon is straight, up by {step} seconds for every factor of ten, to {last} seconds at ten to the minus {DECADES}.{others_seen}"
        ),
    };
    let made = figure("flip-time", 392.0, words, |pen| {
        course.axes(pen);
        if never {
            return;
        }
        let points: Vec<Point> = line.iter().map(|&at| course.place(at)).collect();
        pen.line(&points, inked(DATA));
        for point in &points[1..] {
            pen.dot(*point, 3.0);
        }
        pen.ring(course.place(course.marked), 7.0, inked(DATA));
        let (a, b) = (points[11], points[12]);
        pen.line([a, [b[0], a[1]], b], muted(AXIS));
        let spot = [b[0] + 6.0, 0.5 * (a[1] + b[1]) + 9.0];
        pen.note(spot, Start, &format!("{} s a decade", seconds(decade)));
        for peer in stubborn.iter().chain(&silent) {
            let points: Vec<Point> = peer.answers.iter().map(|&at| course.place(at)).collect();
            pen.line(&points, muted(SECONDARY).dashed());
            if let (Some(end), false) = (points.last(), peer.goes_on()) {
                cross(pen, *end);
            }
        }
        if let Some(&end) = end {
            let first = listed(silent.iter().filter_map(|peer| peer.name.split(' ').next()));
            let last = stubborn.iter().map(|peer| peer.name.split(' '));
            let last = listed(last.filter_map(|mut words| words.next_back()));
            for (at, line) in [
                ([294.0, 282.0], "no number beyond the cross:"),
                ([294.0, 301.0], &first),
                ([372.0, 214.0], "integrators lose the axis:"),
                ([372.0, 233.0], &last),
            ] {
                pen.note(at, Start, line);
            }
            let [x, y] = course.place(end);
            pen.line([[x, y + 8.0], [x, 266.0]], inked(HAIR));
        }
    });
    let row = |&[exponent, time]: &[f64; 2]| [10f64.powf(-exponent), time];
    let columns = "distance (ratio) | time between flips (s)";
    let made = made.data("exact", columns, line.iter().map(row)).data(
        "ring",
        columns,
        [row(&course.marked)],
    );
    let others = stubborn.iter().chain(&silent);
    Ok(others.fold(made, |made, peer| {
        made.data(peer.name, columns, peer.answers.iter().map(row))
    }))
}

/// A distance as LaTeX.
fn distance(value: f64) -> String {
    match value >= 1e-3 {
        true => brief(value),
        false => scientific(value, 3),
    }
}

/// Names without repetitions.
fn listed<'a>(all: impl Iterator<Item = &'a str>) -> String {
    let mut names: Vec<&str> = Vec::new();
    for name in all {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.join(", ")
}

/// The end of a curve.
fn cross(pen: &mut Pen, at: Point) {
    for side in [4.5, -4.5] {
        let ends = [[-4.5, -side], [4.5, side]].map(|end| shifted(at, end));
        pen.line(ends, inked(DATA));
    }
}
