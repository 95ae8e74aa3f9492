//! The tippe top raises its centre of mass while its energy falls.

use spinning_bodies::scene::contact::{State, passage};

use super::toys::*;
use crate::prelude::*;

/// The parameters.
pub const ENERGY: [Parameter; 3] = [SPIN, VISCOUS, ALPHA.between([0.1, 0.5], 0.3)];

/// Duration of the motion, s.
const END: f64 = 8.0;

/// The centre of mass rises, and the spin loses several times the energy that this takes.
pub fn height_and_energy(values: &Values) -> Result<Figure> {
    let [spin, friction, alpha] = values.each(ENERGY);
    let scene = tippe_scene(&tippe(alpha, GAMMA.default)?, spin, friction)?;
    let rows = run(&scene, END, 400)?;
    let (first, last) = (rows[0].1, rows[rows.len() - 1].1);
    let half = passage(&rows, degrees, 90.0);
    let weight = 0.02 * G_TIPPE;
    let gain = weight * (last.position.z() - first.position.z());
    let loss = first.energy - last.energy;
    let ends = number(degrees(&last), 0);
    let taken = number(loss / gain, 1);
    let paid = if gain > 0.05 * weight * 0.02 * alpha {
        format!(
            "its energy falls: the spin pays for the climb, and friction takes {taken} times as much."
        )
    } else {
        let lifts = if gain > 0.0 {
            "hardly lifts"
        } else {
            "does not lift"
        };
        format!("what friction takes {lifts} it.")
    };
    let claim = match half {
        Some(_) if last.tilt() > 3.0 => format!("While the top climbs, {paid}"),
        Some(_) => format!("While the top climbs to {ends} degrees, {paid}"),
        None if gain > 0.05 * weight * 0.02 * alpha => {
            format!("In {END} seconds this top climbs only to {ends} degrees, and {paid}")
        }
        None => {
            let most = number(greatest_tilt(&rows), 0);
            format!("In {END} seconds this top leans by {most} degrees at most, and {paid}")
        }
    };
    let side = match half {
        Some(half) => format!("It lies on its side at {half:.2} s"),
        None => "It does not get to its side".to_owned(),
    };
    let energies: Vec<f64> = rows.iter().map(|(_, s)| s.energy).collect();
    let steady = energies.is_sorted_by(|before, after| *after <= before * (1.0 + 1e-6));
    let [low, high] = numbers([first, last].map(|s| 1e3 * s.position.z()), 2);
    let climb = number(1e3 * gain.abs(), 2);
    let pays = match (climb.as_str(), gain < 0.0) {
        ("0.00", _) => "The height hardly changes".to_owned(),
        (_, true) => format!("The height gives back {climb} mJ"),
        (_, false) => format!("The height costs {climb} mJ"),
    };
    let energies = [first, last].map(|s| 1e3 * s.energy);
    let [before, after] = numbers(energies, 2);
    let falls = if steady {
        ", at no instant rising."
    } else {
        "."
    };
    let [more, less] = numbers(energies, 1);
    let [lower, upper] = numbers([first, last].map(|s| 1e3 * weight * s.position.z()), 1);
    let [spin, friction, alpha] = briefs([spin, friction, alpha]);
    let words = words!(
        "{claim}",
        "Tippe top of 20 g, $R = 2$ cm, $\\alpha = {alpha}$, spun at {spin} rad/s about its axis, viscous friction {friction} s/m. $C$ goes from {low} to {high} mm. \
         {side}. {pays}. The energy falls from {before} to {after} mJ{falls}",
        "Two curves against time from 0 to {END} seconds. The upper one, total energy, falls from {more} to {less} millijoules. The lower one, dashed, the potential energy, \
         goes from {lower} to {upper}. {side}. The gap between the curves is the kinetic energy."
    );
    let height = |s: &State| 1e3 * weight * s.position.z();
    let made = figure("tippe-energy", 380.0, words, |pen| {
        let top = 1.08 * 1e3 * first.energy;
        let frame = Frame::linear([0.0, END], [0.0, top], [62.0, 486.0, 330.0, 34.0]);
        frame.draw_round(pen, ["time, s", "energy, mJ"]);
        let energy = rows.iter().map(|(t, s)| [*t, 1e3 * s.energy]);
        let lower = rows.iter().map(|(t, s)| [*t, height(s)]);
        let gap = energy.clone().chain(lower.clone().rev());
        pen.fill(frame.trace(gap), Ink, 0.08);
        frame.curve(pen, energy, inked(DATA));
        frame.curve(pen, lower, inked(DATA).dashed());
        if let Some(half) = half {
            let line = [frame.at(half, 0.0), frame.at(half, top)];
            pen.line(line, muted(HAIR).dotted());
            let (side, anchor) = match half < 6.0 {
                true => (6.0, Start),
                false => (-6.0, End),
            };
            pen.remark(shifted(line[1], [side, 8.0]), anchor, "on its side");
        }
        let ends = [1e3 * last.energy, height(&last)].map(|y| frame.y.at(y));
        let places = apart(&ends, 24.0, 308.0);
        pen.label([494.0, places[0] + 5.0], Start, "energy");
        pen.label([494.0, places[1] + 5.0], Start, "*Mg* × height");
        pen.label([494.0, places[1] + 23.0], Start, "of *C*");
        // In the early gap, which is the wider one, or where no line is in the way.
        let gaps = [95, 60, 200, 280, 340].map(|k: usize| {
            let (upper, lower) = (1e3 * rows[k].1.energy, height(&rows[k].1));
            [
                frame.x.at(k as f64 / 400.0 * END),
                frame.y.at(0.5 * (upper + lower)),
            ]
        });
        pen.name(gaps, "in the motion", label(Muted));
    });
    let columns = "time (s) | energy (mJ) | potential energy (mJ)";
    let table = rows.iter().map(|(t, s)| [*t, 1e3 * s.energy, height(s)]);
    Ok(made
        .data("tippe top", columns, table)
        .value("climb", climb)
        .value("taken", taken)
        .value("before", before)
        .value("after", after))
}
