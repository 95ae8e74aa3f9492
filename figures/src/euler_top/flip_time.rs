//! How long a racket waits before it flips, over sixteen decades of the distance from the separatrix (tutorial 6.3, 6.7).

use core::f64::consts::LN_10;

use spinning_bodies::Result;
use spinning_bodies::euler_top::stability::saddle;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::PrincipalMoments;

use super::stand_in::EulerTop;
use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, Words, figure, label, number, small, stroke,
};

/// Where well-known libraries give up: measured, with the scripts, in `tests/reference/peers`.
const PEERS: &str = "";
/// A flip time wrong by more than this is no flip time.
const GIVEN_UP: f64 = 1e-3;

/// A library's last good point.
#[derive(Debug, Clone, PartialEq)]
struct Peer {
    name: String,
    /// Least tilt at which its flip time is still right, and that time.
    tilt: f64,
    time: f64,
}

/// The last good point of every library in the table `library,version,epsilon,flip_time,error`, in its order. A number that is
/// none counts as wrong, and so does everything closer than the first wrong one.
fn peers(table: &str) -> Vec<Peer> {
    let mut found: Vec<(Peer, bool)> = Vec::new();
    for line in table.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        let [library, version, tilt, time, error] = cells[..] else {
            continue;
        };
        let read = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
        let (tilt, time, good) = (read(tilt), read(time), read(error).abs() <= GIVEN_UP);
        let name = format!("{library} {version}");
        let place = match found.iter().position(|(peer, _)| peer.name == name) {
            Some(place) => place,
            None => {
                let time = f64::NAN;
                found.push((Peer { name, tilt, time }, true));
                found.len() - 1
            }
        };
        let (peer, alive) = &mut found[place];
        *alive &= good;
        if *alive {
            (peer.tilt, peer.time) = (tilt, time);
        }
    }
    found
        .into_iter()
        .map(|(peer, _)| peer)
        .filter(|peer| peer.time.is_finite())
        .collect()
}

const DECADES: i32 = 16;
/// Left, right, bottom, top of the frame.
const FRAME: [f64; 4] = [70.0, 560.0, 330.0, 30.0];
/// The longest time on the axis, s.
const LONGEST: f64 = 140.0;

fn place(exponent: f64, time: f64) -> Point {
    let [left, right, bottom, top] = FRAME;
    [
        left + (right - left) * exponent / f64::from(DECADES),
        bottom - (bottom - top) * time / LONGEST,
    ]
}

/// Every decade closer costs the same.
pub fn flip_time() -> Result<Figure> {
    let moments = [1.0, 2.0, 3.0];
    let time = |exponent: f64| -> Result<f64> {
        let tilt = 10f64.powf(-exponent);
        let omega = BodyVector::new(tilt, 1.0, tilt);
        Ok(0.5 * EulerTop::from_omega(moments, omega, Attitude::identity())?.period())
    };
    let line = (0..=DECADES)
        .map(|k| Ok(place(f64::from(k), time(f64::from(k))?)))
        .collect::<Result<Vec<_>>>()?;
    let [i1, i2, i3] = moments;
    let rate = saddle(&PrincipalMoments::new(i1, i2, i3)?, 1.0)?.rate;
    let decade = 2.0 * LN_10 / rate;
    let turns = |t: f64| t / core::f64::consts::TAU;
    let (near, far) = (time(f64::from(DECADES))?, time(2.0)?);
    let words = Words {
        claim: "Each decade closer to the middle axis buys the racket the same few seconds before it flips.".to_owned(),
        details: format!(
            "Time from flip to flip, half the period of $\\Omega$, for $I = (1, 2, 3)$ and $\\Omega(0) = (\\epsilon, 1, \\epsilon)$. \
             A decade adds $2\\ln 10/\\sqrt\\lambda = {}$ s. A hundredth off the axis waits {} s; $10^{{-{DECADES}}}$ \
             off it, {} s or {} turns.",
            number(decade, 3),
            number(far, 2),
            number(near, 2),
            number(turns(near), 1),
        ),
        alt: format!(
            "The time between two flips against the initial distance from the middle axis, on a logarithmic axis over {DECADES} decades: \
             a straight line, up by {} seconds for every factor of ten, to {} seconds at ten to the minus {DECADES}. No accuracy of \
             the hand keeps the racket from flipping; it only waits longer.",
            number(decade, 1),
            number(near, 0),
        ),
    };
    Ok(figure("flip-time", 392.0, words, |pen| {
        axes(pen);
        pen.line(&line, stroke(Role::Omega, DATA));
        for (k, point) in line.iter().enumerate() {
            if k > 0 {
                pen.disc(*point, 3.0, Role::Omega, 1.0);
            }
        }
        let (a, b) = (line[11], line[12]);
        pen.line(&[a, [b[0], a[1]], b], stroke(Role::Muted, AXIS));
        pen.text(
            [b[0] + 6.0, 0.5 * (a[1] + b[1]) + 9.0],
            Anchor::Start,
            &format!("{} s a decade", number(decade, 2)),
            small(Role::Ink),
        );
        for (k, peer) in peers(PEERS).iter().enumerate() {
            let at = place(-peer.tilt.log10(), peer.time);
            let y = at[1] + 40.0 + 20.0 * k as f64;
            pen.line(&[at, [at[0], y]], stroke(Role::Ink, HAIR));
            pen.ring(at, 5.0, stroke(Role::Ink, AXIS));
            pen.text(
                [at[0] + 6.0, y],
                Anchor::Start,
                &peer.name,
                small(Role::Ink),
            );
        }
    }))
}

fn axes(pen: &mut Pen<'_>) {
    let [left, right, bottom, top] = FRAME;
    pen.line(
        &[[left, top], [left, bottom], [right, bottom]],
        stroke(Role::Ink, AXIS),
    );
    for time in [0.0, 40.0, 80.0, 120.0] {
        let y = place(0.0, time)[1];
        pen.line(&[[left - 5.0, y], [left, y]], stroke(Role::Ink, AXIS));
        pen.text(
            [left - 9.0, y + 5.0],
            Anchor::End,
            &number(time, 0),
            small(Role::Ink),
        );
    }
    for exponent in [0, 4, 8, 12, 16] {
        let x = place(f64::from(exponent), 0.0)[0];
        pen.line(&[[x, bottom], [x, bottom + 5.0]], stroke(Role::Ink, AXIS));
        let text = if exponent == 0 {
            "1".to_owned()
        } else {
            format!("10^{{\u{2212}{exponent}}}")
        };
        pen.text([x, bottom + 22.0], Anchor::Middle, &text, small(Role::Ink));
    }
    pen.text(
        [left + 10.0, top + 6.0],
        Anchor::Start,
        "time between flips, s",
        label(Role::Ink),
    );
    pen.text(
        [right, bottom + 46.0],
        Anchor::End,
        "distance *ε* from the middle axis",
        label(Role::Ink),
    );
}
