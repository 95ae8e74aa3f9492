//! On the ice (tutorial 1.1, picture a), and on rougher ground.

use spinning_bodies::Result;
use spinning_bodies::integrators::{Effort, Kept, order_eight};
use spinning_bodies::phenomena::crawler::{self, Strokes};
use spinning_bodies::phenomena::ice::{PARTS, Part, Wriggler, feet};
use spinning_bodies::scene::effects::{Coulomb, Gravity};
use spinning_bodies::scene::shape::{self, CrawlerState};
use spinning_bodies::scene::{Request, Scene};

use super::body::circle;
use crate::Figure;
use crate::solid::hull;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, figure, label, number, small,
    stroke,
};

/// A person: feet, knees, hip, shoulders, head, hand and hand, from the feet, m.
struct Person {
    places: [Point; 7],
}

/// Masses of legs, trunk, head and arms, kg, at the middle of what they are.
const MASSES: [(f64, [usize; 2]); 6] = [
    (7.0, [0, 1]),
    (15.0, [1, 2]),
    (36.0, [2, 3]),
    (6.0, [4, 4]),
    (4.0, [3, 5]),
    (4.0, [3, 6]),
];

impl Person {
    /// Someone whose hip is out by `hip` and whose shoulders are out by `lean`, arms raised by an angle.
    fn new(hip: f64, lean: f64, arms: [f64; 2]) -> Self {
        let shoulders = [lean, 1.42];
        let hand = |angle: f64, side: f64| {
            [
                shoulders[0] + side * 0.58 * angle.sin(),
                shoulders[1] - 0.58 * angle.cos(),
            ]
        };
        Self {
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
        MASSES.map(|(mass, [a, b])| {
            let (a, b) = (self.places[a], self.places[b]);
            Part {
                mass,
                from_feet: [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])],
            }
        })
    }

    /// Height of the centre of mass over the feet, m.
    fn height(&self) -> Result<f64> {
        Ok(-feet(&self.parts(), [0.0, 0.0])?[1])
    }

    fn draw(&self, pen: &mut Pen, from: Point, scale: f64) {
        let at = |k: usize| {
            let [x, y] = self.places[k];
            [from[0] + scale * x, from[1] - scale * y]
        };
        let limbs = [
            ([0, 1], [0.06, 0.075]),
            ([1, 2], [0.08, 0.105]),
            ([2, 3], [0.115, 0.135]),
            ([3, 5], [0.055, 0.04]),
            ([3, 6], [0.055, 0.04]),
            ([4, 4], [0.115, 0.115]),
        ];
        for ([a, b], radii) in limbs {
            let mut points = circle(at(a), radii[0] * scale);
            points.extend(circle(at(b), radii[1] * scale));
            let outline = hull(&points);
            pen.fill(&outline, Role::Paper, 1.0);
            pen.fill(&outline, Role::Ink, 0.1);
            pen.outline(&outline, stroke(Role::Ink, AXIS));
        }
    }
}

/// Wriggling on ice: before, on the way, and after.
pub fn ice() -> Result<Figure> {
    let upright = || Person::new(0.0, 0.0, [0.35, 0.35]);
    let poses = [
        upright(),
        Person::new(0.1, -0.36, [1.7, 0.3]),
        Person::new(0.0, 0.4, [0.3, 1.9]),
        upright(),
    ];
    let centers = [80.0, 226.0, 372.0, 518.0];
    let mut placed = Vec::new();
    for pose in &poses {
        placed.push((feet(&pose.parts(), [0.0, 0.0])?[0], pose.height()?));
    }
    let words = Words {
        claim: "However you wriggle, your centre of mass stays on its vertical line.".to_owned(),
        details: format!(
            "Four postures on frictionless ice, each with the centre of mass on the dotted line; for that the feet slide to {} m and to {} m from where they were. \
             In the old posture they are back in the old place. 72 kg in six parts.",
            number(placed[1].0 - placed[0].0, 3),
            number(placed[2].0 - placed[0].0, 3),
        ),
        alt: "A person on ice in four postures: upright, leaning to the left with one arm out, leaning to the right with the other, upright again. A \
              vertical dotted line runs through the dot of the centre of mass each time; the feet shift to the side and return."
            .to_owned(),
    };
    let ground = 288.0;
    let scale = 138.0;
    Ok(figure("ice", 340.0, words, |pen| {
        pen.line(
            &[[14.0, ground + 9.0], [586.0, ground + 9.0]],
            stroke(Role::Ink, AXIS),
        );
        for ((pose, x), (foot, height)) in poses.iter().zip(centers).zip(&placed) {
            pen.line(
                &[[x, 30.0], [x, ground + 9.0]],
                stroke(Role::Ink, SECONDARY).dotted(),
            );
            pose.draw(pen, [x + scale * foot, ground], scale);
            pen.disc([x, ground - scale * height], 6.0, Role::Paper, 1.0);
            pen.disc([x, ground - scale * height], 5.0, Role::Ink, 1.0);
            let y = ground + 24.0;
            let [from, to] = [placed[0].0, *foot].map(|foot| [x + scale * foot, y]);
            pen.arrow(from, to, stroke(Role::Ink, DATA));
        }
        pen.text(
            [centers[0], ground + 40.0],
            Anchor::Middle,
            "before",
            label(Role::Ink),
        );
        pen.text(
            [centers[3], ground + 40.0],
            Anchor::Middle,
            "after",
            label(Role::Ink),
        );
        pen.text([300.0, 22.0], Anchor::Middle, "*C* stays", label(Role::Ink));
    }))
}

/// What the crawler does: a slow push, a fast pull.
const STROKES: Strokes = Strokes {
    gap: 0.25,
    length: 0.2,
    push: 1.0,
    pull: 0.15,
};
const CYCLES: f64 = 5.0;

fn crawled(mu: Option<f64>) -> Result<Vec<(f64, CrawlerState)>> {
    let scene = shape::Crawler::new(crawler::Crawler::new(3.0, 1.0, STROKES)?);
    let times: Vec<f64> = (0..=600)
        .map(|k| CYCLES * STROKES.cycle() * f64::from(k) / 600.0)
        .collect();
    let request = Request::at(times)?;
    Ok(match mu {
        None => scene.simulate(&request)?.rows,
        Some(mu) => {
            let heavy = scene.with(Gravity::new(9.81)?)?;
            let rough = heavy.with(Coulomb::new(mu)?)?;
            rough.simulate(&request)?.rows
        }
    })
}

/// A wriggler on ice beside a crawler on ground.
pub fn crawler() -> Result<Figure> {
    let wriggler = Wriggler::random(4);
    let times: Vec<f64> = (0..=500).map(|k| 0.01 * f64::from(k)).collect();
    let (start, scales) = (wriggler.start(), [1.0; 4 * PARTS]);
    let effort = Effort::Tolerance(1e-9);
    let run = order_eight(&wriggler, Kept::Nothing, start, &scales, &times, effort)?;
    let center = wriggler.center(wriggler.start());
    let (ice, ground) = (crawled(None)?, crawled(Some(0.1))?);
    let way = |rows: &[(f64, CrawlerState)]| rows.last().map_or(f64::NAN, |(_, s)| s.center);
    let words = Words {
        claim: "Without friction nobody gets anywhere, with a little anybody does.".to_owned(),
        details: format!(
            "Left, seen from above: six parts on ice, pulled about by fifteen muscles for 5 s; the dot is the track of their centre of mass. Right: two feet of \
             3 kg and 1 kg, pushed apart by 0.2 m in 1 s and pulled together in 0.15 s. On ice the centre (dashed) moves by {} m in \
             {} s, with a coefficient of friction of 0.1 by {} m: on the slow stroke the heavy foot holds.",
            number(way(&ice), 1),
            number(CYCLES * STROKES.cycle(), 2),
            number(way(&ground), 3),
        ),
        alt: "Left, a tangle of six tracks around a single dot. Right, place against time: the feet of the crawler on ice go to and fro about a level \
              dashed line; on ground both feet and the centre between them climb step by step, the rear foot standing still during each slow stroke."
            .to_owned(),
    };
    Ok(figure("crawler", 346.0, words, |pen| {
        let at = |[x, y]: Point| {
            [
                146.0 + 118.0 * (x - center[0]),
                160.0 - 118.0 * (y - center[1]),
            ]
        };
        for part in 0..PARTS {
            let track: Vec<Point> = run
                .states
                .iter()
                .map(|y| at([y[2 * part], y[2 * part + 1]]))
                .collect();
            pen.line(&track, stroke(Role::Ink, HAIR).alpha(0.7));
            if let Some(&end) = track.last() {
                pen.disc(end, 4.0, Role::Ink, 0.8);
            }
        }
        let track: Vec<Point> = run.states.iter().map(|y| at(wriggler.center(y))).collect();
        pen.line(&track, stroke(Role::Ink, DATA));
        pen.disc(at(center), 6.0, Role::Ink, 1.0);
        pen.text(
            [146.0, 332.0],
            Anchor::Middle,
            "on ice: *C* is a point",
            label(Role::Ink),
        );
        let span = CYCLES * STROKES.cycle();
        let place = |t: f64, x: f64| [318.0 + 262.0 * t / span, 236.0 - 360.0 * x];
        pen.line(
            &[place(0.0, -0.13), [580.0, place(0.0, -0.13)[1]]],
            stroke(Role::Ink, AXIS),
        );
        pen.line(
            &[place(0.0, -0.13), place(0.0, 0.6)],
            stroke(Role::Ink, AXIS),
        );
        for t in [0.0, 2.0, 4.0] {
            let [x, y] = place(t, -0.13);
            pen.line(&[[x, y], [x, y + 5.0]], stroke(Role::Ink, AXIS));
            pen.text(
                [x, y + 21.0],
                Anchor::Middle,
                &format!("{} s", number(t, 0)),
                small(Role::Ink),
            );
        }
        for x in [0.0, 0.2, 0.4] {
            let [left, y] = place(0.0, x);
            pen.line(&[[left - 5.0, y], [left, y]], stroke(Role::Ink, AXIS));
            pen.text(
                [left - 8.0, y + 5.0],
                Anchor::End,
                &number(x, 1),
                small(Role::Ink),
            );
        }
        pen.text([306.0, 24.0], Anchor::Start, "place, m", small(Role::Ink));
        let curve = |rows: &[(f64, CrawlerState)], which: fn(&CrawlerState) -> f64| -> Vec<Point> {
            rows.iter().map(|(t, s)| place(*t, which(s))).collect()
        };
        for which in [|s: &CrawlerState| s.rear, |s: &CrawlerState| s.front] {
            pen.line(&curve(&ground, which), stroke(Role::Ink, SECONDARY));
        }
        pen.line(&curve(&ground, |s| s.center), stroke(Role::Ink, DATA));
        pen.line(
            &curve(&ice, |s| s.center),
            stroke(Role::Ink, SECONDARY).dashed(),
        );
        let peak = place(0.95, 0.39);
        pen.text(
            [peak[0] - 26.0, peak[1] - 12.0],
            Anchor::Start,
            "front foot",
            small(Role::Ink),
        );
        let rear = place(0.0, -0.065);
        pen.text(
            [rear[0] + 5.0, rear[1] + 18.0],
            Anchor::Start,
            "rear foot",
            small(Role::Ink),
        );
        pen.text(
            [578.0, place(0.0, 0.0)[1] + 18.0],
            Anchor::End,
            "*C* without friction",
            small(Role::Ink),
        );
        pen.text(
            [448.0, 332.0],
            Anchor::Middle,
            "on ground: stick and slip",
            label(Role::Ink),
        );
    }))
}
