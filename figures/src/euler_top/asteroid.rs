//! The axes of Toutatis on the sky (tutorial 6.8): a motion with two periods that never repeats.

use nalgebra::Rotation3;
use spinning_bodies::euler_top::toutatis;
use spinning_bodies::euler_top::{EulerTop, State};
use spinning_bodies::frame::{Attitude, BodyVector};

use crate::prelude::*;

/// A day, s.
const DAY: f64 = 86_400.0;
/// Points drawn per day.
const A_DAY: u32 = 24;
/// Dots, one per day.
const DOTS: usize = 8;

parameters! {
    DAYS: "days", "t", "days", "how long it is followed", [10.0, 150.0], 60.0, whole;
    ROLL: "roll", r"\Omega_{\text{long}}", "° a day", "angular velocity about the long axis on 9 November 1992", [30.0, 200.0], 98.709;
}
/// The parameters; the other two components of Ω and the moments are those of Toutatis.
pub const TOUTATIS: &[Parameter] = &[DAYS, ROLL];

/// How far the arrow of L reaches beyond the sphere.
const BEYOND: f64 = 1.22;

/// The directions of the long and the short axis during two months.
pub fn two_axes(values: &Values) -> Result<Figure> {
    let [days, roll] = values.each([DAYS, ROLL]);
    let seen = toutatis::top()?.at(0.0)?.omega;
    let omega = BodyVector::new(seen.x(), seen.y(), -roll.to_radians() / DAY);
    let asteroid = EulerTop::from_omega(toutatis::MOMENTS, omega, Attitude::identity())?;
    let l = asteroid.angular_momentum_in_space().components();
    let upright = Rotation3::rotation_between(&l, &Vector::z()).unwrap_or_default();
    // The end of the long axis that stands on the side of L, and one end of the short axis.
    let ends = [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
    let times = (0..=days as u32 * A_DAY).map(|k| f64::from(k) / f64::from(A_DAY));
    let steps = times.clone().map(|day| day * DAY);
    let states = asteroid.states(steps).collect::<Result<Vec<_>>>()?;
    let [long, short] = ends.map(|end| -> Vec<Vector> {
        let in_the_sky = |a: &State| upright * turned(&a.attitude, end.into());
        states.iter().map(in_the_sky).collect()
    });
    let angle = |a: &Vector| a.z.acos().to_degrees();
    let rolling = asteroid.period() / DAY;
    let going_round = TAU / asteroid.mean_precession_rate() / DAY;

    let name = match roll == ROLL.default {
        true => "Toutatis",
        false => "A body with the moments of Toutatis",
    };
    // The first numbers of turns of the one that are whole numbers of turns of the other to within a fiftieth.
    let (long_turn, short_turn) = (rolling.max(going_round), rolling.min(going_round));
    let fit = (1..=6).map(|turns| (turns, f64::from(turns) * long_turn / short_turn));
    let fit = fit.map(|(turns, others)| (turns, others, (others - others.round()).abs()));
    let claim = match fit.clone().find(|(.., off)| *off < 0.02) {
        None => format!("{name} has two periods, and they do not fit together."),
        Some((turns, others, _)) => format!(
            "{name} has two periods that nearly fit together: {turns} of the longer {} as long as {} of the shorter.",
            if turns == 1 { "is" } else { "are" },
            number(others, 0)
        ),
    };
    let extremes = [&long, &short].map(|axis| extent(axis.iter().map(angle)));
    let [[low, high], [least, most]] = extremes.map(|ends| numbers(ends, 1));
    let [rolls, round] = numbers([rolling, going_round], 2);
    let begins = match roll == ROLL.default {
        true => String::new(),
        false => format!(
            " It starts with {}° a day about its long axis; Toutatis had {}°.",
            brief(roll),
            ROLL.default
        ),
    };
    let [[from, to], [top, bottom]] = extremes.map(|ends| numbers(ends, 0));
    let words = words!(
        "{claim}",
        "Where its long axis (thick, a dot a day in the first week) and its short axis (thin) point for {days} days from 9 November 1992, on a sphere with \
         $L$ upright. The long axis keeps between {low}° and {high}° from $L$ and goes round in {round} days; about it \
         the body rolls in {rolls} days, and the short axis draws a net, from {least}° to {most}°.{begins}",
        "A sphere with the angular momentum pointing up. The long axis of the asteroid runs round it nearly in a circle of latitude, {from} to \
         {to} degrees from the top, once in {round} of the {days} days. The short axis draws loops between {top} and {bottom} degrees, which in time make a fine net \
         over a belt of the sphere."
    );
    let made = figure("toutatis", 392.0, words, |pen| {
        let view = View::new(0.5, 0.42, [300.0, 218.0], 160.0);
        let outline = view.trace(&rim(&Vector::repeat(1.0), &view.toward, 240));
        pen.fill(&outline, Shade, 1.0);
        let axis = segment(Vector::zeros(), Vector::z(), 2);
        pen.line(view.trace(&axis), stroke(AngularMomentum, AXIS).dotted());
        let [seen, hidden] = view.halves(&short);
        pen.lines(hidden, muted(HAIR).alpha(0.35));
        let [ring, behind] = view.halves(&long);
        pen.lines(behind, inked(SECONDARY).alpha(0.3));
        pen.lines(&seen, muted(AXIS));
        pen.outline(&outline, inked(SECONDARY));
        pen.lines(&ring, inked(SECONDARY));
        let days = long.iter().step_by(A_DAY as usize).take(DOTS);
        for day in days.filter(|p| view.faces(p)) {
            pen.dot(view.project(day), 4.5);
        }
        let tip = view.project(&(Vector::z() * BEYOND));
        let style = stroke(AngularMomentum, 2.0);
        pen.arrow(view.project(&Vector::z()), tip, style);
        let place = shifted(tip, [14.0, 12.0]);
        pen.text(place, Start, "*L*", label(AngularMomentum));
        // Leaders go to what is nearest.
        let remarks = [
            ([112.0, 96.0], End, "long axis", [116.0, 92.0], &ring),
            ([500.0, 326.0], Start, "short axis", [496.0, 321.0], &seen),
        ];
        for (at, anchor, text, from, pieces) in remarks {
            if let Some(to) = nearest(from, pieces.iter().flatten().copied()) {
                pen.line([from, to], inked(HAIR));
            }
            pen.note(at, anchor, text);
        }
    });
    let columns = "time (days) | from L (°) | about L (°)";
    let rows = |axis: &[Vector]| -> Vec<[f64; 3]> {
        let row = |(day, a): (f64, &Vector)| [day, angle(a), a.y.atan2(a.x).to_degrees()];
        times.clone().zip(axis).map(row).collect()
    };
    Ok(made
        .data("long axis", columns, rows(&long))
        .data("short axis", columns, rows(&short)))
}
