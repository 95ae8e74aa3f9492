//! Energy against Jellett's integral: friction moves a tippe top straight down.

use spinning_bodies::tippe_top::{Inversion, TippeTop};

use super::toys::*;
use crate::prelude::*;

/// Spins of the other runs drawn, rad/s, and of the fastest top in the picture.
const SPINS: [f64; 2] = [50.0, 100.0];
const WIDEST: f64 = 112.0;

const CHOSEN: Parameter = SPIN.between([10.0, 98.0], 70.0).dragged(release);
const OFFSET: Parameter = ALPHA.between([0.1, 0.6], 0.3);
/// The parameters; the start of the run in the middle is dragged.
pub const DIAGRAM: &[Parameter] = &[CHOSEN, OFFSET, GAMMA];

/// Energy of a top at this tilt with the Jellett integral of an upright one of this spin, mJ.
fn energy(top: &TippeTop, tilt: f64, spin: f64) -> f64 {
    1e3 * top.effective_potential(tilt, top.jellett_of_spin(spin, 0.0))
}

fn frame(top: &TippeTop) -> Frame {
    let most = 1.03 * energy(top, 0.0, SPINS[1]);
    Frame::linear([0.0, WIDEST], [0.0, most], [58.0, 560.0, 360.0, 34.0])
}

fn chosen(values: &Values) -> Result<TippeTop> {
    tippe(values.of(&OFFSET), values.of(&GAMMA))
}

fn release(values: &Values) -> Point {
    let spin = values.of(&CHOSEN);
    chosen(values).map_or([0.0; 2], |top| {
        frame(&top).at(spin, energy(&top, 0.0, spin))
    })
}

/// Straight down to the branch of steady states.
pub fn energies(values: &Values) -> Result<Figure> {
    let top = chosen(values)?;
    let unit = top.jellett_of_spin(1.0, 0.0);
    let (rise, over) = (top.least_spin_to_rise(), top.least_spin_to_invert());
    // The beginning of the branch of inverted states, which may be below the spin that brings a top there.
    let invert = over.and(top.steady_jellett(PI)).map(|j| j / unit);
    let spins = [SPINS[0], values.of(&CHOSEN), SPINS[1]];
    let falls = tried(spins, |spin| {
        let rows = run(&tippe_scene(&top, spin, 0.3)?, 14.0, 28)?;
        let path = rows.iter().map(|(_, s)| [s.jellett / unit, 1e3 * s.energy]);
        Ok((
            path.collect::<Vec<Point>>(),
            number(degrees(&rows[28].1), 1),
        ))
    })?;
    let branch = match (rise, invert) {
        (Some(rise), Some(invert)) => format!(
            "The tilted branch leaves the upright one at {rise:.3} rad/s and reaches the inverted one at {invert:.3} rad/s."
        ),
        (Some(rise), None) => format!(
            "The tilted branch leaves the upright one at {rise:.3} rad/s and never reaches the inverted one."
        ),
        (None, _) => {
            "No tilted branch leaves the upright one: that is stable at every spin.".to_owned()
        }
    };
    let [alpha, gamma] = briefs(values.each([OFFSET, GAMMA]));
    let [slow, chosen, fast] = briefs(spins);
    let [a, b, c] = [0, 1, 2].map(|k: usize| &falls[k].1);
    let steep = match rise {
        Some(rise) => format!("up to {rise:.0} radians a second and dashed beyond"),
        None => "all the way".to_owned(),
    };
    let flat = match (invert, top.inversion()) {
        (Some(invert), _) => format!("dashed up to {invert:.0} and solid beyond"),
        (None, Inversion::Never) => "solid from where it is steady".to_owned(),
        (None, _) => "dashed all the way".to_owned(),
    };
    let fell = |path: &[Point]| path[28][1] < 0.97 * path[0][1];
    let so = match falls.iter().filter(|(path, _)| fell(path)).count() {
        3 => "every top falls straight down",
        0 => "a top can only fall straight down: these three stay up for 14 seconds",
        _ => "a top can only fall straight down: not all of these three do within 14 seconds",
    };
    let words = words!(
        "Friction takes energy and leaves Jellett's integral alone, so {so}.",
        "Steady states of a tippe top with $\\alpha = {alpha}$, $I_1/I_3 = {gamma}$ against Jellett's integral, as the spin $J/RI_3(1-\\alpha)$. Solid: stable; dashed: not. \
         {branch} Arrows: runs released at 0.1 rad, spun at {slow}, {chosen} and {fast} rad/s; after 14 s they are at {a}°, {b}° and {c}°.",
        "Energy against spin. Two parabolas: the steep one, upright, is solid {steep}; the flat one, upside down, is {flat}. {branch} Three runs go straight down \
         from the upright parabola, to tilts of {a}, {b} and {c} degrees."
    );
    let steady = |tilt: f64| {
        let spins = spaced([0.0, WIDEST], 120);
        spins.map(move |spin| [spin, energy(&top, tilt, spin)])
    };
    let tilted = (0..=240).filter_map(|k| {
        let tilt = PI * f64::from(k) / 240.0;
        let spin = top.steady_jellett(tilt)? / unit;
        Some([spin, energy(&top, tilt, spin)])
    });
    let tilted: Vec<Point> = tilted.collect();
    let made = figure("tippe-diagram", 412.0, words, |pen| {
        let frame = frame(&top);
        let across = "*J*, as the spin of the upright top, rad/s";
        frame.draw_round(pen, [across, "energy, mJ"]);
        let solid = inked(DATA);
        let broken = inked(SECONDARY).dashed();
        // The inverted state is stable above its own least λ even if no upright start leads there.
        let on_head = top.steady_jellett(PI).map(|jellett| jellett / unit);
        for (tilt, border, below, above) in
            [(0.0, rise, solid, broken), (PI, on_head, broken, solid)]
        {
            let border = border.unwrap_or(f64::INFINITY);
            let edge = [border, energy(&top, tilt, border.min(WIDEST))];
            let first = steady(tilt).filter(|p| p[0] < border);
            let end = Some(edge).filter(|p| p[0] < WIDEST);
            frame.curve(pen, first.chain(end), below);
            let second = steady(tilt).filter(|p| p[0] > border);
            frame.curve(pen, [edge].into_iter().chain(second), above);
        }
        // A tilted top is stable where more of J tilts it further.
        for piece in tilted.chunk_by(|a, b| a[0] < b[0]) {
            frame.curve(pen, piece.iter().copied(), solid);
        }
        for piece in tilted.chunk_by(|a, b| a[0] >= b[0]) {
            frame.curve(pen, piece.iter().copied(), broken);
        }
        for (spin, tilt) in [(rise, 0.0), (invert, PI)] {
            if let Some(spin) = spin.filter(|spin| *spin < WIDEST) {
                pen.dot(frame.at(spin, energy(&top, tilt, spin)), 4.5);
            }
        }
        for (path, _) in &falls {
            let drawn = frame.trace(path.iter().copied());
            let (start, end) = (drawn[0], drawn[drawn.len() - 1]);
            let heavy = muted(1.4 * DATA);
            pen.line(&drawn, heavy);
            if end[1] - start[1] > 20.0 {
                pen.arrow(between(start, end, 0.5), between(start, end, 0.6), heavy);
            }
            pen.disc(start, 3.4, Muted, 1.0);
            pen.disc(end, 5.0, Muted, 1.0);
        }
        let low = |spin: f64| {
            let near = tilted.iter().filter(|p| (p[0] - spin).abs() < 3.0);
            let least = energy(&top, PI, spin).min(energy(&top, 0.0, spin));
            near.map(|p| p[1]).fold(least, f64::min)
        };
        let beside = |spin: f64, energy: f64, aside| shifted(frame.at(spin, energy), aside);
        let upright = [[-46.0, -8.0], [42.0, 9.0]].map(|aside| {
            let spins = [80.0, 72.0, 90.0, 60.0];
            spins.map(|spin| beside(spin, energy(&top, 0.0, spin), aside))
        });
        pen.name(upright.concat(), "upright", label(Ink));
        // As wide as 24 rad/s, and above every line that passes below it.
        let passing = tilted.iter().filter(|p| p[0] < 24.0).map(|p| p[1]);
        let passing = passing.chain([0.0, PI].map(|tilt| energy(&top, tilt, 24.0)));
        let inverted = beside(1.0, passing.fold(0.0, f64::max), [6.0, -8.0]);
        pen.label(inverted, Start, "upside down");
        // Without a branch no state is tilted, and no stable state loses energy.
        if rise.is_some() {
            pen.label(beside(60.0, low(60.0), [8.0, 26.0]), Start, "tilted");
        }
        let (fall, _) = &falls[2];
        let (from, to) = (fall[0][1], fall[fall.len() - 1][1]);
        if frame.y.at(to) - frame.y.at(from) > 20.0 {
            let shares = [0.5, 0.35, 0.65, 0.8].map(|share| from + share * (to - from));
            let places = [34.0, -34.0].map(|x| shares.map(|at| beside(100.0, at, [x, 0.0])));
            pen.name(places.concat(), "friction", small(Muted));
        }
    });
    let columns = "J as a spin (rad/s) | energy (mJ)";
    let made = made
        .data("upright", columns, steady(0.0))
        .data("upside down", columns, steady(PI))
        .data("tilted", columns, tilted);
    let runs = spins.into_iter().zip(falls);
    Ok(runs.fold(made, |made, (spin, (path, _))| {
        made.data(format!("run at {spin} rad/s"), columns, path)
    }))
}
