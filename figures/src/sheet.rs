//! The ball on a withdrawn sheet (tutorial 4.5).

use spinning_bodies::rolling::{Coulomb, Course, Happening, Load, Moment, Sheet, SheetSpeeds};

use crate::prelude::*;
use crate::{finish, rolling};

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of(
        "withdrawn-sheet",
        &[PULL, ON_SHEET, ON_TABLE, KAPPA],
        speeds,
    ),
    of("sheet-animated", &[], animated),
];

parameters! {
    PULL: "speed", "v", "m/s", "speed of the sheet once it goes", [1.0, 8.0], 3.0;
    ON_SHEET: "sheet_friction", r"\mu_1", "", "coefficient of friction on the sheet", [0.05, 0.8], 0.3;
    ON_TABLE: "table_friction", r"\mu_2", "", "coefficient of friction on the table", [0.05, 0.8], 0.2;
}
const KAPPA: Parameter = rolling::KAPPA.between([0.25, 1.0], 0.4);

/// The time in which the sheet reaches its speed, s; the distance of its edge behind the ball, m.
const JERK: f64 = 0.02;
const MARGIN: f64 = 0.15;

/// The edge of the sheet is 15 cm behind.
fn withdrawn(values: &Values, until: f64) -> Result<Course> {
    let speeds = SheetSpeeds::ramp(values.of(&PULL), JERK)?;
    let sheet = Sheet::new(Coulomb::new(values.of(&ON_SHEET))?, speeds, MARGIN)?;
    let table = Coulomb::new(values.of(&ON_TABLE))?;
    Course::new(
        values.of(&KAPPA),
        Load::weight(9.81),
        (Some(table), None, Some(&sheet)),
        Moment::default(),
        until,
    )
}

fn time_of(course: &Course, what: Happening) -> f64 {
    course.first(what).map_or(0.0, |event| event.time)
}

/// Velocity, rim speed and slip against time.
pub fn speeds(values: &Values) -> Result<Figure> {
    let course = withdrawn(values, 10.0)?;
    let kappa = values.of(&KAPPA);
    let leaves = time_of(&course, Happening::LeavesSheet);
    let stops = course.events.last().map_or(0.0, |event| event.time);
    let rolls = course
        .first(Happening::RollingBegins)
        .filter(|event| event.time < leaves);
    let then = course.at(leaves);
    let place = course.at(stops).position;
    let [rolling, kept, back] = rolls.map_or_else(Default::default, |event| {
        let from = number(1e3 * event.time, 0);
        [
            format!(" from {from} ms on it rolls there, and friction rests;"),
            ", and then both stay".to_owned(),
            "comes back to zero, ".to_owned(),
        ]
    });
    let until = 1.16 * stops;
    // The events, and the moments next to a jump of the slip.
    let mut corners = vec![0.0, JERK.min(leaves), leaves * (1.0 - 1e-12), until];
    corners.extend(course.events.iter().map(|event| event.time));
    corners.sort_by(f64::total_cmp);
    let slips: Vec<f64> = corners.iter().map(|&t| course.at(t).slip).collect();
    let least = slips.iter().copied().fold(0.0, f64::min);
    let most = slips.iter().copied().fold(0.0, f64::max);
    let [pull, on_sheet, on_table] = briefs(values.each([PULL, ON_SHEET, ON_TABLE]));
    let (inertia, ratio) = (brief(kappa), short(1.0 / kappa, 2));
    let [gone, way] = numbers([1e3 * leaves, 1e3 * place], 1);
    let end = number(1e3 * stops, 0);
    let [velocity, rim] = numbers([then.velocity, then.rim_speed], 2);
    let [lowest, highest] = numbers([least, most], 1);
    let words = words!(
        "Velocity and spin reach zero in the same instant: the ball stops dead.",
        "A sheet jerked away at {pull} m/s, friction $\\mu = {on_sheet}$ on it and {on_table} on the table, $I = {inertia}\\,MR^2$. On the sheet friction drives the ball \
         forward and spins it backward;{rolling} off it, after {gone} ms, the table's friction does the opposite. Rim speed and velocity stay in the ratio −{ratio} to 1, so \
         both are zero after {end} ms, {way} mm from the start.",
        "Two graphs against time. Above: velocity rises in a straight line to {velocity} metres a second while the rim speed falls to {rim}{kept}; when the sheet has gone, both return in straight \
         lines to zero at the same moment. Below: the slip goes down to {lowest}, {back}jumps to {highest} as the sheet leaves, and ends at zero at that moment."
    );
    let time = Axis::linear([0.0, until], [66.0, 580.0]);
    let high = Axis::linear([then.rim_speed, then.velocity], [210.0, 52.0]);
    let low = Axis::linear([least, most], [344.0, 254.0]);
    let (x, upper, lower) = (|t| time.at(t), |v| high.at(v), |u| low.at(u));
    let bottom = 352.0;
    let made = figure("withdrawn-sheet", 376.0, words, |pen| {
        let edge = x(leaves);
        pen.fill(boxed([x(0.0), 20.0], [edge, bottom]), Ink, 0.06);
        // Side by side if both fit, otherwise one above the other.
        let (on, off) = ("on the sheet", "on the table");
        if edge - x(0.0) > 100.0 {
            pen.note([x(0.0) + 8.0, 38.0], Start, on);
            pen.note([edge + 10.0, 38.0], Start, off);
        } else {
            let text = format!("grey: {on}; then {off}");
            pen.note([edge + 10.0, 38.0], Start, &text);
        }
        for y in [upper(0.0), lower(0.0)] {
            pen.line([[x(0.0), y], [x(until), y]], inked(AXIS));
        }
        pen.line([[x(0.0), 20.0], [x(0.0), bottom]], inked(AXIS));
        let rule = [[x(stops), upper(0.0) - 20.0], [x(stops), bottom]];
        pen.line(rule, inked(HAIR).dashed());
        for axis in [&high, &low] {
            for (value, text) in axis.ticks(26.0) {
                let y = axis.at(value);
                pen.line([[x(0.0) - 4.0, y], [x(0.0), y]], inked(AXIS));
                pen.note([x(0.0) - 8.0, y + 5.0], End, &text);
            }
        }
        pen.note([8.0, 15.0], Start, "speed, m/s");
        let milliseconds = Axis::linear([0.0, 1e3 * until], time.ends);
        for (t, text) in milliseconds.ticks(80.0).into_iter().skip(1) {
            let x = milliseconds.at(t);
            pen.line([[x, bottom - 3.0], [x, bottom + 3.0]], inked(AXIS));
            if x < 500.0 {
                pen.note([x, bottom + 20.0], Middle, &text);
            }
        }
        pen.note([x(until), bottom + 20.0], End, "time, ms");
        let moments = || corners.iter().map(|&t| (x(t), course.at(t)));
        let velocity = moments().map(|(x, m)| [x, upper(m.velocity)]);
        let rim = moments().map(|(x, m)| [x, upper(m.rim_speed)]);
        pen.line(velocity, inked(2.6));
        pen.line(rim, stroke(Omega, 2.6));
        // Beside the longer of the two slopes.
        let after = stops - leaves > leaves;
        let (from, to, anchor) = match after {
            true => (leaves, stops, Start),
            false => (leaves, rolls.map_or(0.0, |event| event.time), End),
        };
        let side = if after { 8.0 } else { -8.0 };
        let beside = |v: fn(&Moment) -> f64| {
            let on = |t: f64| [x(t), upper(v(&course.at(t)))];
            between(on(from), on(to), 0.3)
        };
        let [at_v, at_rim] = [beside(|m| m.velocity), beside(|m| m.rim_speed)];
        pen.label([at_v[0] + side, at_v[1] - 6.0], anchor, "*V*");
        let spot = [at_rim[0] + side, at_rim[1] + 16.0];
        pen.text(spot, anchor, "*R*\u{03a9}", label(Omega));
        pen.note([x(stops) + 6.0, upper(0.0) + 20.0], Start, "both zero");
        let slip = corners.iter().zip(&slips).map(|(&t, &u)| [x(t), lower(u)]);
        let slip: Vec<_> = slip.collect();
        pen.line(&slip, inked(DATA));
        let places = [24.0, -24.0].map(|aside| [edge + aside, lower(0.0) + 19.0]);
        pen.name(places, "slip", label(Ink));
        let rule = [[x(0.0), 232.0], [x(until), 232.0]];
        pen.line(rule, inked(SECONDARY).alpha(0.15));
    });
    let rows = corners.iter().map(|&t| {
        let m = course.at(t);
        [t, m.velocity, m.rim_speed, m.slip, m.position]
    });
    let columns = "time (s) | velocity (m/s) | rim speed (m/s) | slip (m/s) | place (m)";
    Ok(made
        .data("ball", columns, rows)
        .value("way", number(1e3 * place, 0)))
}

const NAME: &str = "sheet-animated";
/// Pictures in one loop of the film, its duration in seconds, and how much slower than the ball it runs.
const PICTURES: usize = 60;
const LASTS: f64 = 0.2;
const SLOWNESS: f64 = 20.0;
const TABLE: f64 = 112.0;
const RADIUS: f64 = 44.0;
/// Units per metre.
const METRE: f64 = 44.0 / 0.02;
const FIRST: f64 = 352.0;

/// The same in motion, always with the numbers of the book, because the film is made from them.
pub fn animated(_: &Values) -> Result<Figure> {
    let course = withdrawn(&Values::default(), 0.4)?;
    let place = course.at(LASTS).position;
    let millimetres = number(1e3 * place, 1);
    let words = words!(
        "The sheet goes, the ball moves a little, and stops dead.",
        "A ball of 2 cm radius on a sheet that is jerked to the right at 3 m/s, twenty times slower than life. While the sheet is under it, it is dragged along and spun backward; \
         the table undoes both at once. It ends {millimetres} mm from where it began (the mark).",
        "A ball with a clock hand on a sheet of paper. The sheet slides out to the right; the ball creeps right while turning backward, the sheet's edge passes, and the ball \
         comes to rest, neither moving nor turning. Without motion: the ball as the sheet's edge comes."
    );
    let still = figure(NAME, 160.0, words, |pen| {
        pen.line([[8.0, TABLE], [592.0, TABLE]], inked(SECONDARY));
        pen.line([[FIRST, TABLE], [FIRST, TABLE + 18.0]], inked(AXIS));
        pen.note([FIRST, TABLE + 36.0], Middle, "began here");
    });
    let frame = |n: usize| {
        let t = LASTS * n as f64 / PICTURES as f64;
        let m = course.at(t);
        let x = (FIRST + METRE * m.position) * SCALE;
        let y = (TABLE - RADIUS - 2.0) * SCALE;
        let angle = (m.turned / 0.02).to_degrees();
        let margin = course.margin(t).unwrap_or(0.0);
        let edge = (FIRST + METRE * (m.position - margin)) * SCALE;
        [
            format!("translate({x:.0}px,{y:.0}px)"),
            format!("rotate({angle:.1}deg)"),
            format!("translate({edge:.0}px,0px)"),
        ]
    };
    let frames: Vec<_> = (0..=PICTURES).map(frame).collect();
    let [at, turned, far] =
        frame(PICTURES * 3 / 10).map(|moved| moved.replace("px", "").replace("deg", ""));
    let names = ["ball", "hand", "paper"].map(|part| format!("fig-{NAME}-{part}"));
    let mut style = String::from("<style>");
    for (k, name) in names.iter().enumerate() {
        let share = |(n, moved)| (format!("{:.2}", 100.0 * n as f64 / PICTURES as f64), moved);
        let moved = frames.iter().map(|frame| &frame[k]);
        style += &finish::keyframes(name, moved.enumerate().map(share));
        let seconds = SLOWNESS * LASTS;
        style += &format!(".{name}{{animation:{name} {seconds}s linear infinite}}");
    }
    let all = names.each_ref().map(|name| format!(".{name}")).join(",");
    style += &finish::stops(NAME, &all);
    let [ball, hand, paper] = names;
    let (r, top) = (RADIUS * SCALE, (TABLE - 2.0) * SCALE);
    let long = 1200.0 * SCALE;
    let (thick, thin) = (2.6 * SCALE, 2.0 * SCALE);
    let groups = format!(
        "<defs><clipPath id=\"fig-{NAME}-room\"><path d=\"M80 0H5920V1600H80Z\"/></clipPath></defs>\n\
         <g clip-path=\"url(#fig-{NAME}-room)\"><g class=\"{paper}\" transform=\"{far}\"><path d=\"M0 {top:.0}L{long:.0} {top:.0}\" stroke=\"currentColor\" stroke-width=\"{thick:.0}\"/></g></g>\n\
         <g class=\"{ball}\" transform=\"{at}\"><g class=\"{hand}\" transform=\"{turned}\">\
         <circle r=\"{r:.0}\" fill=\"currentColor\" fill-opacity=\"0.1\" stroke=\"currentColor\" stroke-width=\"{thin:.0}\"/>\
         <path d=\"M0 0L0 -{r:.0}\" stroke=\"var(--omega, #0b6bcb)\" stroke-width=\"{thick:.0}\"/></g></g>\n"
    );
    Ok(still.moving(&(style + &groups)))
}
