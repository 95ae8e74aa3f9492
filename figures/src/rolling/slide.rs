//! From sliding to rolling (tutorial 4.3): velocity and rim speed against time.

use spinning_bodies::rolling::{Coulomb, Course, Load, Moment, RoundBody};

use crate::prelude::*;

parameters! {
    /// κ of a ball that rolls or bounces, whatever it is made of.
    pub KAPPA: "kappa", r"\kappa", "", "moment of inertia of the ball over MR²", [0.3, 0.65], 0.4;
    FRICTION: "friction", r"\mu", "", "coefficient of friction", [0.05, 0.6], 0.2, logarithmic;
    SPEED: "speed", "V", "m/s", "velocity of the balls after the stroke", [0.5, 5.0], 2.0;
    TOP: "top", "H/R", "", "height of the highest stroke over the radius", [1.66, 2.0], 1.8;
}

/// The parameters.
pub const LINES: &[Parameter] = &[FRICTION, SPEED, TOP, KAPPA];

const LEFT: f64 = 62.0;
const RIGHT: f64 = 492.0;
const ZERO: f64 = 190.0;
const BOTTOM: f64 = 344.0;

/// V and RΩ for five heights of the cue; they meet where rolling begins.
pub fn lines(values: &Values) -> Result<Figure> {
    let [mu, speed, top, kappa] = values.each([FRICTION, SPEED, TOP, KAPPA]);
    let ball = RoundBody::new(0.17, 0.028_575, kappa)?;
    let heights = [0.2, 0.7, 1.0, 1.4, top];
    let shots = tried(heights, |height| ball.strike(height, speed))?;
    let slides = tried(&shots, |shot| Ok(shot.slide(mu, 9.81)?.time))?;
    let latest = slides.into_iter().fold(0.0, f64::max);
    let until = 1.144 * latest;
    let courses = tried(&shots, |shot| {
        let start = Moment {
            slip: shot.slip,
            ..Moment::moving(shot.velocity, shot.rim_speed)
        };
        let effects = (Some(Coulomb::new(mu)?), None, None);
        Course::new(kappa, Load::weight(9.81), effects, start, until)
    })?;
    let finals = courses.iter().map(|course| course.at(until).velocity);
    let finals: Vec<String> = finals.map(|pace| number(pace, 2)).collect();
    let [lowest, highest] = [0, 4].map(|k| shots[k].rim_speed);
    let sweet = short(ball.pure_rolling_height(), 2);
    let [factor, rough, pace, least, most] = briefs([kappa, mu, speed, lowest, highest]);
    let finals = finals.join(", ");
    let words = words!(
        "Wherever the cue strikes, velocity and rim speed meet, and from then on the ball rolls.",
        "Ball with $I = {factor}\\,MR^2$, struck at heights $H$ to the same velocity of {pace} m/s, friction $\\mu = {rough}$. Ink: velocity $V$ of the centre; blue: rim speed \
         $R\\Omega$. They meet at {finals} m/s. Skidding balls slow down along one line, the last until {latest:.2} s; struck above ${sweet}\\,R$, the ball speeds up.",
        "Graph of speed against time. Five lines of rim speed start from {least} to {most} metres a second, those of velocity at {pace}. \
         Each pair meets at a dot, and both go on level, at {finals} metres a second."
    );
    let greatest = highest.max(-lowest).max(speed);
    let most = 1.04 * greatest;
    let places = [LEFT, RIGHT, BOTTOM, 2.0 * ZERO - BOTTOM];
    let frame = Frame::linear([0.0, until], [-most, most], places);
    let at = |t: f64, v: f64| frame.at(t, v);
    let made = figure("slide-to-roll", 396.0, words, |pen| {
        frame.draw_round(pen, ["time, s", "speed, m/s"]);
        pen.line([at(0.0, 0.0), at(until, 0.0)], inked(AXIS));
        let mut name = BOTTOM;
        for (course, height) in courses.iter().zip(heights) {
            let start = course.at(0.0);
            let meets = course.events.first().map_or(0.0, |event| event.time);
            let rolls = course.at(meets).velocity;
            let meeting = at(meets, rolls);
            pen.line([at(0.0, start.rim_speed), meeting], stroke(Omega, DATA));
            pen.line([at(0.0, start.velocity), meeting], inked(DATA));
            pen.line([meeting, at(until, rolls)], inked(SECONDARY));
            pen.dot(meeting, 4.5);
            name = (frame.y.at(rolls) + 5.0).min(name - 16.0);
            let text = format!("*H* = {} *R*", brief(height));
            pen.note([RIGHT + 12.0, name], Start, &text);
        }
        let meeting = |k: usize| {
            let event = courses[k].events.first();
            event.map_or([LEFT, ZERO], |event| at(event.time, event.moment.velocity))
        };
        for (k, start, text, role, half) in [
            (4, highest, "*R*\u{03a9}, too fast", Omega, 48.0),
            (0, lowest, "*R*\u{03a9}, backspin", Omega, 52.0),
            (4, speed, "*V*", Ink, 7.0),
        ] {
            let (from, to) = (at(0.0, start), meeting(k));
            let beside = [[half + 8.0, -12.0], [half + 8.0, 14.0], [0.0, -14.0]];
            let places = (2..18).flat_map(|share| {
                let on = between(from, to, 0.05 * f64::from(share));
                beside.map(|beside| shifted(on, beside))
            });
            let inside = places.filter(|p| p[0] > LEFT + half + 6.0);
            pen.name(inside, text, label(role));
        }
    });
    let columns = "time (s) | velocity (m/s) | rim speed (m/s)";
    let shots = courses.iter().zip(heights);
    Ok(shots.fold(made, |made, (course, height)| {
        let events = course.events.iter().map(|event| event.time);
        let corners = core::iter::once(0.0).chain(events).chain([until]);
        let row = |t: f64| {
            let moment = course.at(t);
            [t, moment.velocity, moment.rim_speed]
        };
        let shot = format!("H = {} R", brief(height));
        made.data(shot, columns, corners.map(row))
    }))
}
