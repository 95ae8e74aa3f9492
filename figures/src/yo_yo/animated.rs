//! A yo-yo that is thrown, sleeps, wakes and comes back.

use core::fmt::Write as _;

use spinning_bodies::scene::effects::{AxleFriction, Gravity, Sleep};
use spinning_bodies::scene::{Phase, Play, Request, Scene, YoYoState};
use spinning_bodies::yo_yo::YoYo;

use super::toy::GRAVITY;
use crate::finish;
use crate::prelude::*;

const NAME: &str = "yo-yo-animated";
/// String, radius of the discs and of the axle, m: short, to be drawn to scale.
const LENGTH: f64 = 0.36;
const RADIUS: f64 = 0.029;
const AXLE: f64 = 0.006;
/// Design units per metre, and the place of the hand.
const METRE: f64 = 900.0;
const HAND: Point = [112.0, 40.0];
/// Speed of the throw, m/s; length of the sleep, s; friction of the loop, N m.
const THROW: f64 = 1.5;
const ASLEEP: f64 = 0.35;
const FRICTION: f64 = 5e-4;
/// Seconds of the film per second of the yo-yo.
const SLOWNESS: f64 = 8.0;
/// Pictures; the motion between two is filled in by the browser.
const PICTURES: u32 = 240;
/// Steps of the spin from picture to picture.
const BETWEEN: u32 = 8;

/// Time, state, and the angle turned.
type Picture = (f64, YoYoState, f64);

/// One loop, and its duration until the hand has the yo-yo again.
fn film() -> Result<(f64, Vec<Picture>)> {
    let toy = YoYo::disc(0.055, RADIUS, LENGTH, AXLE)?;
    let play = Play::new(toy, THROW)?
        .with(Gravity::new(GRAVITY)?)?
        .with(Sleep::new(ASLEEP)?)?
        .with(AxleFriction::new(FRICTION)?)?;
    let before = |t| Ok(play.simulate(&Request::at([t])?)?.rows[0].1.phase != Phase::Caught);
    let caught = border([0.0, 4.0], before)?;
    let times: Vec<f64> = spaced([0.0, caught], PICTURES * BETWEEN).collect();
    let rows = play.simulate(&Request::at(times)?)?.rows;
    let (mut angle, mut last) = (0.0, rows[0]);
    let pictures = rows.into_iter().map(|(t, state)| {
        angle += 0.5 * (t - last.0) * (state.omega + last.1.omega);
        last = (t, state);
        (t, state, angle)
    });
    Ok((caught, pictures.step_by(BETWEEN as usize).collect()))
}

/// Down, asleep, awake, and up.
pub fn animated(_: &Values) -> Result<Figure> {
    let (duration, pictures) = film()?;
    let fastest = pictures.iter().map(|p| p.1.omega).fold(0.0, f64::max);
    let time = [0.0, duration];
    let depth = Frame::linear(time, [0.4, 0.0], [270.0, 576.0, 180.0, 50.0]);
    let spin = Frame::linear(time, [0.0, 320.0], [270.0, 576.0, 370.0, 244.0]);
    let [axle, length] = numbers([1e3 * AXLE, 1e2 * LENGTH], 0);
    let friction = number(1e3 * FRICTION, 1);
    let words = words!(
        "Thrown, it sleeps at the end of its string; a jerk makes the string grip, and it climbs on the spin it has left.",
        "To scale: radius 29 mm, axle radius {axle} mm, a string of {length} cm with a loop at its end, thrown at {THROW} m/s, asleep for {ASLEEP} s under a friction of \
         {friction} mN m; {SLOWNESS} times slower than in life. Greatest spin {fastest:.0} rad/s.",
        "On the left a yo-yo on its string, with a spoke that shows its spin. It runs down, spins in place at the end of the string, and climbs back to the \
         hand on the other side of the string. On the right its depth and its spin against time, with a marker that moves along: the depth rises to a \
         plateau, the sleep, and returns; the spin rises on the way down, declines slowly in the sleep, drops a little at the jerk, and declines on the way up, \
         without ever changing its sense. Without motion: the yo-yo asleep."
    );
    let asleep = pictures.iter().filter(|p| p.1.phase == Phase::Asleep);
    let asleep: Vec<f64> = asleep.map(|p| p.0).collect();
    let still = figure(NAME, 420.0, words, |pen| {
        let seconds = marks(&[0.0, 0.25, 0.5, 0.75], "");
        depth.draw(pen, &[], &marks(&[0.0, 0.36], ""), ["", "depth, m"]);
        let y_ticks = marks(&[0.0, 200.0, 300.0], "");
        spin.draw(pen, &seconds, &y_ticks, ["time, s", "spin, rad/s"]);
        let line = pictures.iter().map(|p| depth.at(p.0, p.1.depth));
        pen.line(line, inked(DATA));
        let line = pictures.iter().map(|p| spin.at(p.0, p.1.omega));
        pen.line(line, stroke(Omega, DATA));
        let middle = 0.5 * (asleep[0] + asleep[asleep.len() - 1]);
        let [x, y] = depth.at(middle, 0.36);
        pen.remark([x, y - 10.0], Middle, "asleep");
        let rule = [-56.0, -36.0].map(|aside| shifted(HAND, [aside, 0.0]));
        pen.line(rule, inked(AXIS));
        pen.text(shifted(HAND, [-60.0, 5.0]), End, "hand", label(Muted));
    });
    Ok(still.moving(&moving(&pictures, duration, [&depth, &spin])))
}

/// The position of the centre shows how far the axle has gone round the string's end: left of the string on the way down, right of it on the way up.
fn aside(state: &YoYoState, after: bool) -> f64 {
    let below = ((state.depth - LENGTH) / AXLE).clamp(0.0, 1.0);
    let away = (1.0 - below * below).sqrt();
    match state.phase {
        Phase::Down => -1.0,
        Phase::Turn if !after => -away,
        Phase::Turn => away,
        Phase::Up | Phase::Caught => 1.0,
        Phase::Asleep | Phase::Hanging => 0.0,
    }
}

fn moving(pictures: &[Picture], duration: f64, [depth, spin]: [&Frame; 2]) -> String {
    // In the middle of the loop it is asleep.
    let still = pictures.len() / 2;
    let mut frames: [Vec<String>; 4] = Default::default();
    let mut slept = false;
    for (t, state, angle) in pictures {
        slept |= state.phase == Phase::Asleep;
        let x = SCALE * (HAND[0] + METRE * AXLE * aside(state, slept));
        let y = SCALE * (HAND[1] + METRE * state.depth);
        frames[0].push(format!(
            "translate({x:.0}px,{y:.0}px) rotate({angle:.2}rad)"
        ));
        // A string of 1000 canvas units, stretched; it ends level with the axle, or at its top in the turn.
        let end = METRE * state.depth.min(LENGTH) * SCALE / 1000.0;
        frames[1].push(format!("scale(1,{end:.4})"));
        let markers = [depth.at(*t, state.depth), spin.at(*t, state.omega)];
        for (frames, point) in frames[2..].iter_mut().zip(markers) {
            let [x, y] = point.map(|c| c * SCALE);
            frames.push(format!("translate({x:.0}px,{y:.0}px)"));
        }
    }
    let (big, axle) = (METRE * RADIUS * SCALE, METRE * AXLE * SCALE);
    let yo_yo = format!(
        "<circle r=\"{big:.0}\" fill=\"currentColor\" fill-opacity=\"0.16\" stroke=\"currentColor\" stroke-width=\"16\"/>\
         <path d=\"M0 0L{big:.0} 0\" stroke=\"var(--omega, #0b6bcb)\" stroke-width=\"30\"/>\
         <circle r=\"{axle:.0}\" fill=\"currentColor\"/>"
    );
    let marker = "<circle r=\"50\" fill=\"currentColor\"/>";
    let string = "<path d=\"M0 0L0 1000\" stroke=\"currentColor\" stroke-width=\"14\" vector-effect=\"non-scaling-stroke\" \
                  style=\"stroke-width:1.4px\"/>";
    let parts = [
        ("string", 1, string),
        ("toy", 0, yo_yo.as_str()),
        ("depth", 2, marker),
        ("spin", 3, marker),
    ];
    let (mut style, mut groups, mut all) = ("<style>".to_owned(), String::new(), String::new());
    for (part, slot, drawing) in parts {
        let name = format!("fig-{NAME}-{part}");
        let share = |p: &Picture| format!("{:.2}", 100.0 * p.0 / duration);
        let shares = pictures.iter().map(share);
        let seconds = SLOWNESS * duration;
        style += &finish::keyframes(&name, shares.zip(&frames[slot]));
        style += &format!(".{name}{{animation:{name} {seconds:.2}s linear infinite}}");
        let _ = write!(all, "{}.{name}", if all.is_empty() { "" } else { "," });
        let rest = frames[slot][still].replace("px", "").replace("rad", "");
        // In the attribute an angle is in degrees; a yo-yo at rest may show any.
        let rest = rest.split(" rotate").next().unwrap_or_default();
        let moved = format!("<g class=\"{name}\" transform=\"{rest}\">{drawing}</g>");
        if part == "string" {
            let [x, y] = HAND.map(|c| c * SCALE);
            let _ = writeln!(
                groups,
                "<g transform=\"translate({x:.0} {y:.0})\">{moved}</g>"
            );
        } else {
            let _ = writeln!(groups, "{moved}");
        }
    }
    style += &finish::stops(NAME, &all);
    style + &groups
}
