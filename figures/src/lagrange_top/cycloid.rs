//! The nose of a top released from rest, beside the cycloid (tutorial 7.4).

use core::f64::consts::TAU;

use spinning_bodies::Result;
use spinning_bodies::lagrange_top::{Cycloid, dip};

use super::{launch, nose};
use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Point, Role, SECONDARY, Words, figure, label, number, small, stroke,
};

/// cos θ at the release: 60 degrees.
const HEIGHT: f64 = 0.5;
/// L₃ of the rows, and where the tilt of the release is drawn.
const ROWS: [(f64, f64); 3] = [(3.0, 46.0), (5.0, 164.0), (10.0, 276.0)];
/// Where the arches begin, and units to the radius of the rolling circle.
const LEFT: f64 = 84.0;
const UNIT: f64 = 34.0;
const ARCHES: u32 = 2;
const STEPS: u32 = 240;

/// One top against its cycloid.
struct Row {
    axial: f64,
    from: f64,
    /// φ sin θ₀ and θ − θ₀ in units of the radius, step by step.
    trace: Vec<Point>,
    /// The cycloid of the limit in the same units.
    limit: Vec<Point>,
    /// The greatest difference over the first arch in each of them.
    off: [f64; 2],
}

impl Row {
    fn new(axial: f64, from: f64) -> Result<Self> {
        let top = launch(HEIGHT, 0.0, axial)?;
        let tilt = HEIGHT.acos();
        let cycloid = dip(1.0, 1.0, axial, tilt)?.cycloid;
        let shown = |[down, azimuth]: [f64; 2]| {
            let Cycloid { radius, sine } = cycloid;
            [azimuth * sine / radius, down / radius]
        };
        let mut turned = 0.0;
        let mut azimuth = 0.0;
        let mut trace = Vec::new();
        for k in 0..=STEPS * ARCHES {
            let at = nose(&top, top.period() * f64::from(k) / f64::from(STEPS))?;
            let now = at.y.atan2(at.x);
            turned += (now - azimuth + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            azimuth = now;
            let here = at.x.hypot(at.y).atan2(at.z);
            trace.push(shown([here - tilt, turned]));
        }
        let limit: Vec<Point> = (0..=STEPS * ARCHES)
            .map(|k| shown(cycloid.at(TAU * f64::from(k) / f64::from(STEPS))))
            .collect();
        let off = core::array::from_fn(|c| {
            let arch = trace.iter().zip(&limit).take(STEPS as usize + 1);
            arch.map(|(trace, limit)| (trace[c] - limit[c]).abs())
                .fold(0.0, f64::max)
        });
        Ok(Self {
            axial,
            from,
            trace,
            limit,
            off,
        })
    }

    fn place(&self, [along, down]: Point) -> Point {
        [LEFT + UNIT * along, self.from + UNIT * down]
    }
}

/// Three tops, three cycloids.
pub fn cycloids() -> Result<Figure> {
    let rows = ROWS
        .iter()
        .map(|(axial, from)| Row::new(*axial, *from))
        .collect::<Result<Vec<_>>>()?;
    let greatest = |row: &Row| row.off[0].max(row.off[1]);
    let fastest = Row::new(20.0, 0.0)?;
    let words = Words {
        claim: "Released from rest the nose follows a cycloid, the better the faster the spin.".to_owned(),
        details: format!(
            "Tilt downwards, $\\varphi\\sin\\theta_0$ to the right, in units of the wheel's radius $a = I_1Mg\\ell\\sin\\theta_0/L_3^2$; $\\theta_0 = 60°$, \
             $I_1 = Mg\\ell = 1$. Dashed: the cycloid. Dots: eighths of a nutation. The nose leaves the cycloid \
             by {}$\\,a$ at most for $L_3 = 3$, {} for 5, {} for 10, {} for 20.",
            number(greatest(&rows[0]), 2),
            number(greatest(&rows[1]), 3),
            number(greatest(&rows[2]), 4),
            number(greatest(&fastest), 4),
        ),
        alt: "Three rows, each with two arches of a top's nose hanging from the level of its release, and a dashed cycloid. The slow top \
              dips below its cycloid and gets ahead of it; the second is closer; for the third the two curves \
              can hardly be told apart. All touch the upper level in upright cusps, where the dots crowd."
            .to_owned(),
    };
    Ok(figure("cycloid", 384.0, words, |pen| {
        for row in &rows {
            let end = row.place([TAU * f64::from(ARCHES) + 1.65, 0.0]);
            pen.line(&[row.place([0.0, 0.0]), end], stroke(Role::Ink, HAIR));
            let lowest = row.place([0.0, 2.0]);
            pen.line(
                &[lowest, [end[0], lowest[1]]],
                stroke(Role::Muted, AXIS).dotted(),
            );
            for (height, text) in [(0.0, "*θ*_{0}"), (2.0, "+2*a*")] {
                let [x, y] = row.place([0.0, height]);
                pen.text([x - 10.0, y + 5.0], Anchor::End, text, small(Role::Ink));
            }
            let limit: Vec<Point> = row.limit.iter().map(|p| row.place(*p)).collect();
            pen.line(&limit, stroke(Role::Ink, SECONDARY).dashed());
            let trace: Vec<Point> = row.trace.iter().map(|p| row.place(*p)).collect();
            pen.line(&trace, stroke(Role::Ink, DATA));
            for point in trace.iter().step_by(STEPS as usize / 8) {
                pen.disc(*point, 3.0, Role::Ink, 1.0);
            }
            pen.text(
                [LEFT, row.from - 14.0],
                Anchor::Start,
                &format!("*L*_{{3}} = {}", number(row.axial, 0)),
                label(Role::AngularMomentum),
            );
        }
        let row = &rows[2];
        let [x, y] = row.place([TAU, 2.0]);
        pen.text(
            [x, y + 26.0],
            Anchor::Middle,
            "*φ* sin *θ*_{0}",
            label(Role::Ink),
        );
    }))
}
