//! The nose of a top released from rest, beside the cycloid (tutorial 7.4).

use spinning_bodies::lagrange_top::{Cycloid, dip};

use super::launch::*;
use crate::prelude::*;

parameters! {
    TILT: "tilt", r"\theta_0", "°", "tilt at the release", [5.0, 175.0], 60.0;
    UPPER: "upper", "L_3", "", "axial momentum of the upper top", [1.0, 20.0], 3.0;
    MIDDLE: "middle", "L_3", "", "axial momentum of the top in the middle", [1.0, 20.0], 5.0;
    LOWER: "lower", "L_3", "", "axial momentum of the lower top", [1.0, 20.0], 10.0;
}
/// The parameters.
pub const CYCLOIDS: &[Parameter] = &[TILT, UPPER, MIDDLE, LOWER];

/// The beginning of the arches, their greatest width, and the distance between two rows, units.
const LEFT: f64 = 84.0;
const RIGHT: f64 = 570.0;
const BETWEEN: f64 = 42.0;
const ARCHES: u32 = 2;
const STEPS: u32 = 240;

/// One top against its cycloid.
struct Row {
    axial: f64,
    /// φ sin θ₀ and θ − θ₀ in units of the radius, step by step.
    trace: Vec<Point>,
    /// The cycloid of the limit in the same units.
    limit: Vec<Point>,
    /// The greatest difference over the first arch.
    off: f64,
}

impl Row {
    fn new(axial: f64, tilt: f64) -> Result<Self> {
        let top = launch(tilt.cos(), 0.0, axial)?;
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
        let turns = (0..=STEPS * ARCHES).map(|k| TAU * f64::from(k) / f64::from(STEPS));
        let limit: Vec<Point> = turns.map(|turn| shown(cycloid.at(turn))).collect();
        let arch = trace.iter().zip(&limit).take(STEPS as usize + 1);
        let off = arch.flat_map(|([a, b], [c, d])| [(a - c).abs(), (b - d).abs()]);
        let off = off.fold(0.0, f64::max);
        Ok(Self {
            axial,
            trace,
            limit,
            off,
        })
    }

    /// How far to the right and how far down both curves go.
    fn reach(&self) -> Point {
        let all = self.trace.iter().chain(&self.limit);
        all.fold([0.0; 2], |most: Point, at| {
            [most[0].max(at[0]), most[1].max(at[1])]
        })
    }
}

/// Three tops, three cycloids.
pub fn cycloids(values: &Values) -> Result<Figure> {
    let degrees = values.of(&TILT);
    let spins = values.each([UPPER, MIDDLE, LOWER]);
    let rows = tried(spins, |spin| Row::new(spin, degrees.to_radians()))?;
    let mut order: Vec<&Row> = rows.iter().collect();
    order.sort_by(|a, b| a.axial.total_cmp(&b.axial));
    let better = order.windows(2).all(|pair| pair[1].off <= pair[0].off);
    let told = |row: &Row| {
        let digits = (1.0 - row.off.log10().floor()).clamp(0.0, 6.0);
        number(row.off, digits as usize)
    };
    let closest = (order.iter()).fold(order[2], |a, b| if b.off < a.off { b } else { a });
    let claim = match (better, closest.off < 1.0) {
        (true, true) => "Released from rest the nose follows a cycloid, the better the faster the spin.".to_owned(),
        (false, true) => "Released from rest the nose follows a cycloid, but of these three not the better the faster the spin.".to_owned(),
        (_, false) => format!(
            "Released from rest the nose comes back to upright cusps, but none of these tops is fast enough for a cycloid: the best leaves it by {} radii in the first arch.",
            told(closest)
        ),
    };
    let tilt = brief(degrees);
    let [a, b, c] = [0, 1, 2].map(|k: usize| told(order[k]));
    let [slow, medium, fast] = [0, 1, 2].map(|k: usize| brief(order[k].axial));
    let [upper, middle, lower] = [0, 1, 2].map(|k: usize| brief(rows[k].axial));
    let words = words!(
        "{claim}",
        "Tilt downwards, $\\varphi\\sin\\theta_0$ to the right, in units of the wheel's radius $a = I_1Mg\\ell\\sin\\theta_0/L_3^2$; $\\theta_0 = {tilt}$°, \
         $I_1 = Mg\\ell = 1$. Dashed: the cycloid. Dots: eighths of a nutation. In its first arch the nose leaves the cycloid \
         by {a}$\\,a$ at most for $L_3 = {slow}$, {b} for {medium}, {c} for {fast}.",
        "Three rows, each with two arches of a top's nose hanging from the level of its release at {tilt} degrees, and a dashed cycloid. The axial \
         momenta are {upper}, {middle} and {lower} from top to bottom. In the first arch they leave their cycloids by {a}, {b} and {c} radii at most, from the slowest to the fastest. All touch the upper \
         level in upright cusps, where the dots crowd."
    );
    let reaches = [0, 1, 2].map(|k: usize| rows[k].reach());
    let [along, down] = reaches.into_iter().fold([0.0; 2], |sum: Point, reach| {
        [sum[0].max(reach[0]), sum[1] + reach[1].max(2.0)]
    });
    // Units to the radius of the rolling circle: at most 34, and no more than 226 for all arches together.
    let unit = f64::min(34.0, (RIGHT - LEFT) / along).min(226.0 / down);
    let made = figure("cycloid", 384.0, words, |pen| {
        let mut from = 40.0;
        for (row, [_, depth]) in rows.iter().zip(reaches) {
            let place = |&[along, down]: &Point| [LEFT + unit * along, from + unit * down];
            let lowest = place(&[0.0, 2.0]);
            pen.line([[LEFT, from], [RIGHT, from]], inked(HAIR));
            pen.line([lowest, [RIGHT, lowest[1]]], muted(AXIS).dotted());
            let levels = spread([from, lowest[1]], 18.0);
            for (y, text) in levels.into_iter().zip(["*θ*_{0}", "+2*a*"]) {
                pen.note([LEFT - 10.0, y + 5.0], End, text);
            }
            let limit = row.limit.iter().map(place);
            pen.line(limit, inked(SECONDARY).dashed());
            let trace: Vec<Point> = row.trace.iter().map(place).collect();
            pen.line(&trace, inked(DATA));
            for point in trace.iter().step_by(STEPS as usize / 8) {
                pen.dot(*point, 3.0);
            }
            let name = format!("*L*_{{3}} = {}", brief(row.axial));
            pen.text([LEFT, from - 14.0], Start, &name, label(AngularMomentum));
            from += unit * depth.max(2.0) + BETWEEN;
        }
        let under = [RIGHT, from - BETWEEN + 26.0];
        pen.label(under, End, "*φ* sin *θ*_{0}");
    });
    let columns = "φ sin θ₀ (radii of the wheel) | θ − θ₀ (radii of the wheel)";
    Ok(rows.iter().fold(made, |made, row| {
        let name = brief(row.axial);
        made.data(format!("top with L3 = {name}"), columns, row.trace.clone())
            .data(
                format!("cycloid for L3 = {name}"),
                columns,
                row.limit.clone(),
            )
    }))
}
