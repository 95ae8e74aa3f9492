//! On the ice (tutorial 1.1, picture a), and on rougher ground.

use spinning_bodies::integrators::{Effort, Kept, order_eight};
use spinning_bodies::phenomena::{Crawler, PARTS, Part, Strokes, Wriggler, feet};
use spinning_bodies::scene::effects::{Coulomb, Gravity};
use spinning_bodies::scene::shape::{self, CrawlerState};
use spinning_bodies::scene::{Request, Scene};

use super::body::circle;
use crate::prelude::*;

parameters! {
    LEAN: "lean", "s", "m", "how far the shoulders go out to the right; nine tenths of it to the left", [0.1, 0.45], 0.4;
    TRUNK: "trunk", "m", "kg", "mass of the trunk", [10.0, 80.0], 36.0;
}

/// The parameters of the person on ice.
pub const ICE: &[Parameter] = &[LEAN, TRUNK];

parameters! {
    GRIP: "friction", r"\mu", "", "coefficient of friction of the ground", [0.01, 0.6], 0.1, logarithmic;
    REAR: "rear", "m_1", "kg", "mass of the rear foot", [0.4, 6.0], 3.0;
    PUSH: "push", "t_1", "s", "duration of the push", [0.15, 2.0], 1.0;
    PULL: "pull", "t_2", "s", "duration of the pull", [0.1, 1.0], 0.15;
}

/// The parameters of the crawler.
pub const CRAWLER: &[Parameter] = &[GRIP, REAR, PUSH, PULL];

/// A person: feet, knees, hip, shoulders, head, hand and hand, from the feet, m.
struct Person {
    places: [Point; 7],
    trunk: f64,
}

/// Legs, trunk, head and arms: mass, kg, at their middle, and none of the trunk, which is chosen; the places of their ends; their radii there, m.
const LIMBS: [(Option<f64>, [usize; 2], [f64; 2]); 6] = [
    (Some(7.0), [0, 1], [0.06, 0.075]),
    (Some(15.0), [1, 2], [0.08, 0.105]),
    (None, [2, 3], [0.115, 0.135]),
    (Some(6.0), [4, 4], [0.115, 0.115]),
    (Some(4.0), [3, 5], [0.055, 0.04]),
    (Some(4.0), [3, 6], [0.055, 0.04]),
];

impl Person {
    /// A person whose hip is displaced by `hip` and whose shoulders by `lean`, with arms raised by an angle.
    fn new(trunk: f64, hip: f64, lean: f64, arms: [f64; 2]) -> Self {
        let shoulders = [lean, 1.42];
        let hand = |angle: f64, side: f64| {
            shifted(shoulders, [side * 0.58 * angle.sin(), -0.58 * angle.cos()])
        };
        Self {
            trunk,
            places: [
                [0.0, 0.0],
                [0.55 * hip + 0.04, 0.47],
                [hip, 0.92],
                shoulders,
                [lean + 0.25 * (lean - hip), 1.66],
                hand(arms[0], -1.0),
                hand(arms[1], 1.0),
            ],
        }
    }

    fn parts(&self) -> [Part; 6] {
        LIMBS.map(|(mass, [a, b], _)| {
            let (a, b) = (self.places[a], self.places[b]);
            Part {
                mass: mass.unwrap_or(self.trunk),
                from_feet: [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])],
            }
        })
    }

    fn draw(&self, pen: &mut Pen, from: Point, scale: f64) {
        let at = |k: usize| planned(from, scale, self.places[k]);
        // The head last, over the arms.
        for k in [0, 1, 2, 4, 5, 3] {
            let (_, [a, b], [here, there]) = LIMBS[k];
            let ends = [circle(at(a), here * scale), circle(at(b), there * scale)];
            let outline = hull(&ends.concat());
            pen.fill(&outline, Paper, 1.0);
            pen.fill(&outline, Ink, 0.1);
            pen.outline(&outline, inked(AXIS));
        }
    }
}

/// Wriggling on ice: before, on the way, and after.
pub fn ice(values: &Values) -> Result<Figure> {
    let [trunk, lean] = values.each([TRUNK, LEAN]);
    let upright = || Person::new(trunk, 0.0, 0.0, [0.35, 0.35]);
    let poses = [
        upright(),
        Person::new(trunk, 0.25 * lean, -0.9 * lean, [1.7, 0.3]),
        Person::new(trunk, 0.0, lean, [0.3, 1.9]),
        upright(),
    ];
    let centers = [80.0, 226.0, 372.0, 518.0];
    let placed = tried(&poses, |pose| feet(&pose.parts(), [0.0, 0.0]))?;
    let slid = [1, 2, 3].map(|k| placed[k][0] - placed[0][0]);
    let mass: f64 = poses[0].parts().iter().map(|part| part.mass).sum();
    let [left, right, _] = numbers(slid, 3);
    let [whole, body, less, more] = briefs([mass, trunk, 0.9 * lean, lean]);
    let [first, second, _] = numbers(slid, 2);
    let words = words!(
        "However you wriggle, the centre of mass keeps to one vertical line.",
        "Four postures on frictionless ice, each with the centre of mass on the dotted line; for this the feet slide to {left} m and to {right} m from where they were. \
         In the old posture they are back in the old place. {whole} kg in six parts, {body} of them the trunk; shoulders out by {less} m and {more} m.",
        "A person on ice in four postures: upright, leaning to the left with one arm out, leaning to the right with the other, upright again. A \
         vertical dotted line runs through the dot of the centre of mass each time; the feet shift by {first} m and {second} m and return."
    );
    let ground = 288.0;
    let scale = 138.0;
    let made = figure("ice", 340.0, words, |pen| {
        pen.line([[14.0, ground + 9.0], [586.0, ground + 9.0]], inked(AXIS));
        for ((pose, x), [foot, depth]) in poses.iter().zip(centers).zip(&placed) {
            pen.line([[x, 30.0], [x, ground + 9.0]], inked(SECONDARY).dotted());
            pose.draw(pen, [x + scale * foot, ground], scale);
            let center = [x, ground + scale * depth];
            pen.disc(center, 6.0, Paper, 1.0);
            pen.dot(center, 5.0);
            let [from, to] = [&placed[0][0], foot].map(|foot| [x + scale * foot, ground + 24.0]);
            pen.arrow(from, to, inked(DATA));
        }
        pen.label([centers[0], ground + 40.0], Middle, "before");
        pen.label([centers[3], ground + 40.0], Middle, "after");
        pen.label([300.0, 22.0], Middle, "*C* stays");
    });
    let rows = placed.iter().map(|[foot, depth]| [*foot, -depth]);
    let columns = "feet from the line (m) | height of the centre of mass (m)";
    Ok(made.data("postures", columns, rows))
}

/// Five rounds of a push and a pull of the feet.
const CYCLES: f64 = 5.0;

fn strokes(values: &Values) -> Strokes {
    Strokes {
        gap: 0.25,
        length: 0.2,
        push: values.of(&PUSH),
        pull: values.of(&PULL),
    }
}

fn crawled(values: &Values, mu: Option<f64>) -> Result<Vec<(f64, CrawlerState)>> {
    let strokes = strokes(values);
    let mut scene = shape::Crawler::new(Crawler::new(values.of(&REAR), 1.0, strokes)?);
    if let Some(mu) = mu {
        scene = scene.with(Gravity::new(9.81)?)?.with(Coulomb::new(mu)?)?;
    }
    let times: Vec<f64> = spaced([0.0, CYCLES * strokes.cycle()], 600).collect();
    Ok(scene.simulate(&Request::at(times)?)?.rows)
}

/// A wriggler on ice beside a crawler on ground.
pub fn crawler(values: &Values) -> Result<Figure> {
    let wriggler = Wriggler::random(4);
    let times: Vec<f64> = (0..=500).map(|k| 0.01 * f64::from(k)).collect();
    let (start, scales) = (&wriggler.start, [1.0; 4 * PARTS]);
    let effort = Effort::Tolerance(1e-6);
    let run = order_eight(&wriggler, Kept::Nothing, start, &scales, &times, effort)?;
    let center = wriggler.center(start);
    let (mu, strokes) = (values.of(&GRIP), strokes(values));
    let (ice, ground) = (crawled(values, None)?, crawled(values, Some(mu))?);
    let way = |rows: &[(f64, CrawlerState)]| rows.last().map_or(0.0, |(_, s)| s.center);
    let span = CYCLES * strokes.cycle();
    let far = way(&ground);
    let claim = match far {
        far if far > 0.01 => "Without friction nobody gets anywhere, with a little anybody does.",
        far if far < -0.01 => {
            "Without friction nobody gets anywhere, with a little anybody does: these strokes lead backward."
        }
        _ if short(far, 3) == "0" => {
            "Without friction nobody gets anywhere, and these strokes do not with friction either."
        }
        _ => {
            "Without friction nobody gets anywhere, and these strokes hardly do with friction either."
        }
    };
    let [rear, push, pull] = briefs([values.of(&REAR), strokes.push, strokes.pull]);
    let (apart, iced) = (strokes.length, short(way(&ice), 3));
    let (lasts, rough, reached) = (short(span, 2), brief(mu), short(far, 3));
    let words = words!(
        "{claim}",
        "Left, seen from above: six parts on ice, pulled about by fifteen muscles for 5 s; the dot is the track of their centre of mass. Right: two feet of \
         {rear} kg and 1 kg, pushed apart by {apart} m in {push} s and pulled together in {pull} s. On ice the centre $C$ (dashed) moves by {iced} m in \
         {lasts} s, with a coefficient of friction of {rough} by {reached} m.",
        "Left, a tangle of six tracks around a single dot. Right, place against time: the feet of the crawler on ice go to and fro about a level \
         dashed line; on ground both feet and the centre between them have gone {reached} metres after {lasts} seconds."
    );
    let feet = || ground.iter().flat_map(|(_, s)| [s.rear, s.front]);
    let (least, most) = (feet().fold(0.0, f64::min), feet().fold(0.0, f64::max));
    let time = Axis::linear([0.0, span], [318.0, 580.0]);
    let way = Axis::linear([least - 0.15 * (most - least), most], [280.0, 36.0]);
    let frame = Frame { x: time, y: way };
    let made = figure("crawler", 340.0, words, |pen| {
        let at = |[x, y]: Point| planned([146.0, 160.0], 118.0, [x - center[0], y - center[1]]);
        for part in 0..PARTS {
            let track = run.states.iter().map(|y| [y[2 * part], y[2 * part + 1]]);
            let track: Vec<Point> = track.map(at).collect();
            pen.line(&track, inked(HAIR).alpha(0.7));
            if let Some(&end) = track.last() {
                pen.disc(end, 4.0, Ink, 0.8);
            }
        }
        let track = run.states.iter().map(|y| at(wriggler.center(y)));
        pen.line(track, inked(DATA));
        pen.dot(at(center), 6.0);
        pen.label([146.0, 328.0], Middle, "on ice: *C* is a point");
        let mut seconds = time.ticks(70.0);
        seconds.iter_mut().for_each(|(_, text)| text.push_str(" s"));
        frame.draw(pen, &seconds, &way.ticks(45.0), ["", "place, m"]);
        let curve = |rows: &[(f64, CrawlerState)], which: fn(&CrawlerState) -> f64| -> Vec<Point> {
            rows.iter().map(|(t, s)| frame.at(*t, which(s))).collect()
        };
        let curves = [
            curve(&ground, |s| s.rear),
            curve(&ground, |s| s.front),
            curve(&ground, |s| s.center),
            curve(&ice, |s| s.center),
        ];
        pen.lines(&curves[..2], inked(SECONDARY));
        pen.line(&curves[2], inked(DATA));
        pen.line(&curves[3], inked(SECONDARY).dashed());
        for (k, text, half) in [
            (1, "front foot", 34.0),
            (0, "rear foot", 32.0),
            (2, "*C* on ground", 44.0),
            (3, "*C* on ice", 30.0),
        ] {
            let beside = [14.0, 18.0, 24.0, 32.0].into_iter().flat_map(|far| {
                let up = if k == 1 { -far } else { far };
                curves[k]
                    .iter()
                    .step_by(10)
                    .flat_map(move |p| [[p[0], p[1] + up], [p[0], p[1] - up]])
            });
            let inside = within([324.0 + half, 590.0 - half], [24.0, 268.0]);
            pen.name(beside.filter(inside), text, small(Ink));
        }
        pen.label([448.0, 328.0], Middle, "on ground: stick and slip");
    });
    let columns = "time (s) | rear foot (m) | front foot (m) | centre (m)";
    let row = |(t, s): (f64, CrawlerState)| [t, s.rear, s.front, s.center];
    let [ice, ground] = [ice, ground].map(|rows| rows.into_iter().map(row));
    Ok(made
        .data("on ice", columns, ice)
        .data("on ground", columns, ground))
}
