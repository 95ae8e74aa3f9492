//! The gyroscope (tutorial 4.8): torque, the change of L, and the precession that it makes.

use core::f64::consts::FRAC_PI_6;

use spinning_bodies::conservation::uniform_gravity;
use spinning_bodies::frame::{Attitude, BodyVector, SpaceVector};
use spinning_bodies::lagrange_top::{LagrangeTop, PurePrecession, pure_precession};

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[of("gyroscope", &[TURNS, TILT], gyroscope)];

/// The chapter's toy: mass, kg, place of its centre on the axle, m, radius of the wheel, m, moments about the support, kg m².
const MASS: f64 = 0.1;
const ARM: f64 = 0.04;
const WHEEL: f64 = 0.034_64;
const ACROSS: f64 = 3e-5 + MASS * ARM * ARM;
const ALONG: f64 = 6e-5;
const GRAVITY: f64 = 9.81;
/// Seconds between the two L that are drawn.
const STEP: f64 = 0.5;
/// How long an L of one kg m²/s is drawn, m.
const LENGTH: f64 = 2.2;

parameters! {
    TURNS: "turns", "n", "turns/s", "spin of the wheel", [60.0, 150.0], 100.0;
    TILT: "tilt", r"\theta", "°", "angle of the axle from the vertical", [30.0, 120.0], 90.0;
}

/// How far the axle reaches, m.
const HOLD: f64 = 0.06;
/// The elevation of the view, radians, and the units per metre.
const SEEN: f64 = 0.36;
const SCALE: f64 = 2100.0;
/// How deep the foot of the stand is below the support, m, and height of the picture, units.
const FOOT: f64 = 0.075;
const PAGE: f64 = 312.0;

/// Seen from slightly above, in the middle of the page, as large as the wheel, the stand and the circle of the tip of L allow.
fn view(values: &Values) -> View {
    let (sin, cos) = values.of(&TILT).to_radians().sin_cos();
    let length = LENGTH * ALONG * TAU * values.of(&TURNS);
    let (rise, depth) = (SEEN.cos(), SEEN.sin());
    let above = (length * (sin * depth + cos * rise)).max(ARM * cos.max(0.0) * rise + WHEEL);
    let below = (length * (sin * depth - cos * rise)).max(FOOT);
    let (room, tall) = (PAGE - 84.0, above + below);
    let scale = SCALE.min(room / tall);
    let pivot = 34.0 + 0.5 * (room + scale * (above - below));
    View::new(-1.0, SEEN, [250.0, pivot], scale)
}

/// The wheel on its axle, L now and a moment later, and the torque that carries the one to the other.
pub fn gyroscope(values: &Values) -> Result<Figure> {
    let [turns, degrees] = values.each([TURNS, TILT]);
    let tilt = degrees.to_radians();
    let (l3, height) = (ALONG * TAU * turns, tilt.cos());
    let attitude = Attitude::about_axis(BodyVector::new(0.0, 1.0, 0.0), tilt)?;
    let center = attitude.to_space(BodyVector::new(0.0, 0.0, ARM));
    let [pivot, weight] = [0.0, -GRAVITY].map(|z| SpaceVector::new(0.0, 0.0, z));
    let weight = uniform_gravity(MASS, center, pivot, weight)?;
    let law = MASS * GRAVITY * ARM / l3;
    let rate = match pure_precession(ACROSS, MASS * GRAVITY * ARM, l3, height)? {
        PurePrecession::One(rate) | PurePrecession::Two { slow: rate, .. } => rate,
        PurePrecession::None | PurePrecession::Any => f64::NAN,
    };
    let omega = BodyVector::new(-rate * tilt.sin(), 0.0, TAU * turns);
    let top = LagrangeTop::new(ACROSS, ALONG, MASS * GRAVITY * ARM, omega, attitude)?;
    let momentum = |time: f64| -> Result<Vector> {
        let state = top.at(time)?;
        Ok(state.attitude.to_space(state.angular_momentum).components())
    };
    let times = spaced([0.0, TAU / rate], 180);
    let path = tried(times.clone(), momentum)?;
    let [now, later] = [path[0], momentum(STEP)?];
    let percent = 1e2 * (rate / law - 1.0);
    let level = percent.abs() < 5e-4;
    let beside = match level {
        true => "exactly Mgℓ/L₃".to_owned(),
        false => {
            let than = if percent > 0.0 { "more" } else { "less" };
            let percent = number(percent.abs(), 3);
            format!("{percent} per cent {than} than Mgℓ/L₃")
        }
    };
    let (pace, round) = (number(rate, 3), number(TAU / rate, 2));
    let [spun, lean] = briefs([turns, degrees]);
    let words = words!(
        "The weight's torque pushes the tip of L sideways, so the axle goes round instead of down: at {pace} rad/s, {beside}.",
        "A wheel of 0.1 kg at $\\ell = 4$ cm from its support, $I_3 = 6 \\cdot 10^{{-5}}$ kg m², {spun} turns a second, axle {lean}° from the vertical: $Mg\\ell/L_3 = {law:.4}$ \
         rad/s. Orange: $L$ now and {STEP} s later, and $dL$, the change; purple: the torque $N$ of the weight times the same {STEP} s.",
        "A wheel on an axle that is held at one end on a stand, {lean} degrees from the vertical. An orange arrow, the angular momentum, lies along the axle; the weight points down from the \
         wheel; the purple torque is level and points across the axle, and the orange arrow half a second later has moved that way, along a dotted circle round the vertical."
    );
    let view = view(values);
    let at = |p: &Vector| view.project(p);
    let made = figure("gyroscope", PAGE, words, |pen| {
        let origin = Vector::zeros();
        let axle = Vector::new(tilt.sin(), 0.0, tilt.cos());
        let foot = Vector::new(0.0, 0.0, -FOOT);
        let hub = axle * ARM;
        let [across, upward] = [Vector::y(), Vector::y().cross(&axle)];
        let rim = view.trace(&ellipse(hub, across * WHEEL, upward * WHEEL, 96));
        let tips = [now, later].map(|l| l * LENGTH);
        let stand = ellipse(foot, Vector::x() * 0.018, Vector::y() * 0.018, 60);
        pen.outline(view.trace(&stand), inked(AXIS));
        pen.line([at(&foot), at(&origin)], inked(DATA));
        let circle = path.iter().map(|l| at(&(l * LENGTH)));
        pen.line(circle, muted(AXIS).dotted());
        pen.line([at(&origin), at(&(axle * HOLD))], inked(SECONDARY));
        let style = stroke(AngularMomentum, DATA).alpha(0.5);
        pen.arrow(at(&origin), at(&tips[1]), style);
        pen.fill(&rim, Ink, 0.14);
        pen.outline(&rim, inked(SECONDARY));
        for k in 0..3 {
            let angle = f64::from(k) * 2.0 * FRAC_PI_6;
            let spoke = across * angle.cos() + upward * angle.sin();
            let ends = [hub - spoke * WHEEL, hub + spoke * WHEEL];
            pen.line(view.trace(&ends), inked(AXIS).alpha(0.4));
        }
        pen.arrow(at(&origin), at(&tips[0]), stroke(AngularMomentum, 2.6));
        let down = hub - Vector::z() * 0.055;
        pen.arrow(at(&hub), at(&down), inked(DATA));
        let pushed = tips[0] + weight.torque.components() * STEP * LENGTH;
        pen.arrow(at(&tips[0]), at(&pushed), stroke(Torque, 2.6));
        let style = stroke(AngularMomentum, DATA).dashed();
        pen.arrow(at(&tips[0]), at(&tips[1]), style);
        pen.dot(at(&origin), 4.0);

        // Each name near its point, in this direction if there is room.
        let momentum = label(AngularMomentum);
        let again = format!("once round in {round} s");
        for (by, direction, text, lettering) in [
            (0.8 * tips[0], -1.2, "*L*", momentum),
            (tips[1], 0.8, "*L* + *dL*", momentum),
            (pushed, 0.0, "*N*", label(Torque)),
            (0.5 * (tips[0] + tips[1]), -1.2, "*dL*", momentum),
            (down, 0.0, "*Mg*", label(Ink)),
            (foot, -1.57, &again, small(Ink)),
        ] {
            let mut places: Vec<(i32, i32)> = (0..9)
                .flat_map(|out| (-12..=12).map(move |turned| (out, turned)))
                .collect();
            places.sort_by_key(|(out, turned)| 3 * out + 2 * turned.abs());
            let places = places.into_iter().map(|(out, turned)| {
                let angle = direction + TAU / 24.0 * f64::from(turned);
                polar(at(&by), 18.0 + 8.0 * f64::from(out), angle)
            });
            let inside = within([44.0, 556.0], [12.0, PAGE - 12.0]);
            pen.name(places.filter(inside), text, lettering);
        }
    });
    let columns = "time (s) | L_x (kg m²/s) | L_y (kg m²/s) | L_z (kg m²/s)";
    let rows = times.zip(&path).map(|(time, l)| [time, l.x, l.y, l.z]);
    Ok(made.data("tip of L", columns, rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// L changes with the torque of a weight on a lever, while its height and its length are constant.
    #[test]
    fn the_weight_moves_l_as_the_lever_says() {
        for tilt in [30.0_f64, 60.0, 90.0, 120.0] {
            let values = Values::default().with(&TILT, tilt).expect("a tilt");
            let rows = gyroscope(&values).expect("a figure").data.rows;
            let row = |k: usize| rows[k].1.clone();
            let step = row(2)[0] - row(0)[0];
            for k in [1, 50, 179] {
                let moved = (1..=3).map(|i| (row(k + 1)[i] - row(k - 1)[i]) / step);
                let speed = moved.map(|v| v * v).sum::<f64>().sqrt();
                // The chord of four degrees is shorter than its arc by 0.0002.
                let lever = 0.1 * 9.81 * 0.04 * tilt.to_radians().sin();
                assert!((speed / lever - 0.9998).abs() < 5e-5, "{tilt}: {speed}");
                assert!((row(k)[3] / row(0)[3] - 1.0).abs() < 1e-9);
            }
        }
    }
}
