//! Kovalevskaya's scribble, her circle, and the two bands of her polynomial (tutorial 8.2).

use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, TopState};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::kovalevskaya_top::{Diagram, KovalevskayaTop};
use spinning_bodies::{Error, Result};

use crate::Figure;
use crate::style::{
    AXIS, Anchor, DATA, HAIR, Pen, Point, Role, SECONDARY, Words, figure, label, number, stroke,
};

/// The start of all pictures: c = 1, Ω = (1, ½, 0.3), z = (2, −1, 2)/3.
fn start() -> Result<TopState> {
    Ok(TopState {
        omega: BodyVector::new(1.0, 0.5, 0.3),
        up: BodyVector::new(2.0, -1.0, 2.0).direction("up")?,
    })
}

/// w = Ω₁ + iΩ₂ and K = w² − ζ.
fn traced(state: &TopState) -> [Point; 2] {
    let (o, z) = (state.omega, state.up);
    [
        [o.x(), o.y()],
        [
            o.x() * o.x() - o.y() * o.y() - z.x(),
            2.0 * o.x() * o.y() - z.y(),
        ],
    ]
}

/// How long the scribble, the circle and the ring are followed.
const SECONDS: f64 = 240.0;
const SAMPLES: u32 = 6000;

/// Half the width of a panel, and the height of its middle.
const PANEL: f64 = 88.0;
const MIDDLE: f64 = 112.0;

/// What the body does, what her constant does, and what the same expression does for slightly wrong moments.
pub fn circle() -> Result<Figure> {
    let at_start = start()?;
    let lever = BodyVector::new(1.0, 0.0, 0.0);
    let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, at_start.omega, at_start.up)?;
    let mut hers = Vec::new();
    for n in 0..=SAMPLES {
        let t = SECONDS * f64::from(n) / f64::from(SAMPLES);
        hers.push(traced(&top.omega_and_up(t)?));
    }
    let wrong = HeavyTop::new(AxisMoments::new(1.9, 1.9, 1.0)?, lever)?;
    let mut state = at_start;
    let mut wandering = Vec::new();
    let step = SECONDS / f64::from(SAMPLES) / 8.0;
    for _ in 0..=SAMPLES {
        wandering.push(traced(&state)[1]);
        for _ in 0..8 {
            state = wrong.step(&state, step);
        }
    }
    let k = top.constants().kovalevskaya;
    let sizes = || wandering.iter().map(|[x, y]| x.hypot(*y));
    let (least, greatest) = (sizes().fold(k, f64::min), sizes().fold(k, f64::max));

    let words = Words {
        claim: "The top scribbles; its constant runs round a circle.".to_owned(),
        details: format!(
            "Three drawings of {} s from one start, $MgC_1/I_3=1$. Left: $w=\\Omega_1+i\\Omega_2$. Middle: \
             $K=w^2-(z_1+iz_2)$ of the same motion, always {} from the origin. Right: the same expression if \
             $I_1=I_2=1.9\\,I_3$; dashed, where it should be. It wanders from {} to {}.",
            number(SECONDS, 0),
            number(k, 4),
            number(least, 2),
            number(greatest, 2),
        ),
        alt: format!(
            "Three panels. Left, a tangle of loops: the horizontal path of the angular velocity in the body. Middle, one clean \
             circle of radius {}: Kovalevskaya's expression along that motion. Right, a broad smeared ring between radius {} and \
             {}: the same expression when the first two moments are 1.9 instead of 2 times the third.",
            number(k, 2),
            number(least, 2),
            number(greatest, 2),
        ),
    };

    Ok(figure("kovalevskaya-circle", 268.0, words, |pen| {
        // Each fills its panel: the scribble is wider to the left than to the right.
        let reach = hers
            .iter()
            .map(|p| p[0][0].hypot(p[0][1]))
            .fold(0.0, f64::max);
        let panels = [100.0, 300.0, 500.0];
        let place = |x: f64, reach: f64| {
            let scale = PANEL / reach;
            move |[re, im]: Point| [x + scale * re, MIDDLE - scale * im]
        };
        let [scribble, circle, smear] =
            [(0, reach), (1, greatest), (2, greatest)].map(|(n, reach)| place(panels[n], reach));
        for (x, text, remark) in [
            (panels[0], "*w*", "what the top does"),
            (panels[1], "*K*", "*I*_{1} = 2 *I*_{3}"),
            (panels[2], "*K*", "*I*_{1} = 1.9 *I*_{3}"),
        ] {
            let [left, right] = [x - PANEL - 6.0, x + PANEL + 6.0];
            pen.line(&[[left, MIDDLE], [right, MIDDLE]], stroke(Role::Ink, HAIR));
            let [above, below] = [MIDDLE - PANEL - 6.0, MIDDLE + PANEL + 6.0];
            pen.line(&[[x, above], [x, below]], stroke(Role::Ink, HAIR));
            pen.text(
                [right - 4.0, above + 18.0],
                Anchor::Middle,
                text,
                label(Role::Ink),
            );
            pen.text([x, below + 26.0], Anchor::Middle, remark, label(Role::Ink));
        }
        let path: Vec<Point> = hers.iter().map(|p| scribble(p[0])).collect();
        pen.line(&path, stroke(Role::Omega, AXIS).alpha(0.8));
        let ring: Vec<Point> = (0..=360)
            .map(|n| f64::from(n).to_radians().sin_cos())
            .map(|(sine, cosine)| smear([k * cosine, k * sine]))
            .collect();
        let path: Vec<Point> = hers.iter().map(|p| circle(p[1])).collect();
        pen.line(&path, stroke(Role::AngularMomentum, DATA));
        let path: Vec<Point> = wandering.iter().map(|p| smear(*p)).collect();
        pen.line(&path, stroke(Role::AngularMomentum, HAIR).alpha(0.8));
        pen.line(&ring, stroke(Role::Ink, SECONDARY).dashed());
    }))
}

/// P(s) with its five roots: s₁ swings in the middle band, s₂ comes from −∞ and goes back.
pub fn bands() -> Result<Figure> {
    let at_start = start()?;
    let lever = BodyVector::new(1.0, 0.0, 0.0);
    let top = KovalevskayaTop::with_up([2.0, 2.0, 1.0], lever, at_start.omega, at_start.up)?;
    let roots = top.roots();
    let mut real: Vec<f64> = roots.iter().filter(|e| e.im == 0.0).map(|e| e.re).collect();
    real.sort_by(f64::total_cmp);
    let [first, second, frequencies] = {
        let [a, b] = top.frequencies().ok_or(Error::Empty {
            quantity: "the frequencies",
        })?;
        [a, b, a / b]
    };
    // The band of s₁ is the one in which it is found.
    let s1 = |t: f64| -> Result<f64> {
        let variables = top.separation_variables_at(t)?;
        Ok(variables.ok_or(Error::Empty {
            quantity: "the separation variables",
        })?[0])
    };
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for n in 0..400 {
        let s = s1(0.1 * f64::from(n))?;
        (low, high) = (low.min(s), high.max(s));
    }
    let value = |s: f64| {
        let product = roots
            .iter()
            .fold(nalgebra::Complex::new(1.0, 0.0), |p, e| p * (s - e));
        -4.0 * product.re
    };

    let words = Words {
        claim: "Two quantities swing where a polynomial is positive.".to_owned(),
        details: format!(
            "$P(s)=-4(s-e_1)\\cdots(s-e_5)$ for the motion of the circle, heights on a logarithmic scale beyond 0.01. $s_1$ swings between \
             {} and {}, {} times a second; $s_2$ comes from $-\\infty$, turns at {} and goes back, {} times a second. Their ratio is {}.",
            number(low, 3),
            number(high, 3),
            number(first, 4),
            number(real[0], 3),
            number(second, 4),
            number(frequencies, 3),
        ),
        alt: format!(
            "The graph of a polynomial of degree five with {} real roots. It is positive to the left of the smallest root, where \
             the second separation variable comes and goes, and between two further roots, where the first swings; both stretches \
             are marked on the axis.",
            real.len(),
        ),
    };

    Ok(figure("kovalevskaya-bands", 250.0, words, |pen| {
        let (from, to) = (real[0] - 1.1, real[real.len() - 1] + 0.35);
        let x = |s: f64| 30.0 + 540.0 * (s - from) / (to - from);
        let y = |p: f64| 132.0 - 13.0 * (p / 0.01).asinh();
        let graph: Vec<Point> = (0..=600)
            .map(|n| from + (to - from) * f64::from(n) / 600.0)
            .map(|s| [x(s), y(value(s))])
            .filter(|[_, y]| (8.0..=222.0).contains(y))
            .collect();
        pen.line(&[[20.0, 132.0], [580.0, 132.0]], stroke(Role::Ink, AXIS));
        band(pen, [20.0, x(real[0])], "*s*_{2}");
        band(pen, [x(low), x(high)], "*s*_{1}");
        pen.line(&graph, stroke(Role::Ink, DATA));
        for e in &real {
            pen.disc([x(*e), 132.0], 3.5, Role::Ink, 1.0);
        }
        pen.text([588.0, 128.0], Anchor::End, "*s*", label(Role::Ink));
        pen.text([116.0, 32.0], Anchor::Start, "*P*(*s*)", label(Role::Ink));
    }))
}

/// |K| of all motions in the map.
const SIZE: f64 = 0.6;

/// Energy and L_vert² of motions with one |K|, and the curves on which two roots meet.
pub fn classes() -> Result<Figure> {
    let top = HeavyTop::new(
        AxisMoments::new(2.0, 2.0, 1.0)?,
        BodyVector::new(1.0, 0.0, 0.0),
    )?;
    let diagram = Diagram::new(1.0, SIZE)?;
    let (least, greatest, highest) = (-1.1, 2.4, 6.4);
    // Evenly spread starts with w² − ζ = |K| e^{iα}: ζ follows, and z₃ if ζ is not too long.
    let mut motions = Vec::new();
    for n in 0..8_000 {
        let spread = |k: f64| (f64::from(n) * k).fract();
        let [p, q, r] =
            [0.618_033_988_7, 0.414_213_562_4, 0.732_050_807_6].map(|k| 4.4 * spread(k) - 2.2);
        let (sine, cosine) = (core::f64::consts::TAU * spread(0.236_067_977_5)).sin_cos();
        let zeta = [p * p - q * q - SIZE * cosine, 2.0 * p * q - SIZE * sine];
        let rest = 1.0 - zeta[0] * zeta[0] - zeta[1] * zeta[1];
        if rest > 0.0 {
            let state = TopState {
                omega: BodyVector::new(p, q, r),
                up: BodyVector::new(zeta[0], zeta[1], rest.sqrt()),
            };
            let h = top.vertical_angular_momentum(&state).powi(2);
            motions.push([top.energy(&state), h]);
        }
    }
    let mut curves = [Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    for n in 0..=700 {
        let energy = least + (greatest - least) * f64::from(n) / 700.0;
        curves[0].push([energy, diagram.shared_upper(energy)]);
        curves[1].push([energy, diagram.shared_lower(energy)]);
        for (i, h) in diagram
            .cubic_double(energy)?
            .into_iter()
            .flatten()
            .enumerate()
        {
            curves[2 + i].push([energy, h]);
        }
    }

    let ends = diagram.cubic_double(greatest)?;

    let words = Words {
        claim: "Where two roots meet, one kind of motion ends and another begins.".to_owned(),
        details: format!(
            "A dot for each of {} starts with $\\lvert K\\rvert={}$, $MgC_1=I_3=1$, at its energy and $L_{{\\text{{vert}}}}^2$. On the straight lines a root \
             of the cubic meets $e_4$ or $e_5$, on the curve two of its own meet: Appelrot's classes two to four.",
            motions.len(),
            number(SIZE, 1),
        ),
        alt: "A plane with energy to the right and the square of the vertical angular momentum upwards. Dots fill a region that starts at a \
              lowest energy and widens to the right; its edges, and borders inside it, are two parallel rising lines and a curve that touches them."
            .to_owned(),
    };

    Ok(figure("appelrot-classes", 300.0, words, |pen| {
        let place = |[e, h]: Point| {
            let x = 46.0 + 486.0 * (e - least) / (greatest - least);
            [x, 262.0 - 236.0 * h / highest]
        };
        let inside = |[e, h]: &Point| (least..=greatest).contains(e) && (0.0..=highest).contains(h);
        for motion in motions.iter().filter(|m| inside(m)) {
            pen.disc(place(*motion), 1.5, Role::Omega, 0.6);
        }
        for curve in &curves {
            // A branch may leave the picture and come back.
            for part in curve.split(|point| !inside(point)) {
                if part.len() > 1 {
                    let points: Vec<Point> = part.iter().map(|p| place(*p)).collect();
                    pen.line(&points, stroke(Role::Ink, DATA));
                }
            }
        }
        // Each line has its name where it ends.
        let shared = [
            (diagram.shared_upper(greatest), "*e*_{4}"),
            (diagram.shared_lower(greatest), "*e*_{5}"),
        ];
        let own = ends.into_iter().flatten().map(|h| (h, "cubic"));
        for (h, text) in shared.into_iter().chain(own) {
            let [x, y] = place([greatest, h]);
            pen.text([x + 8.0, y + 5.0], Anchor::Start, text, label(Role::Ink));
        }
        pen.line(&[[46.0, 262.0], [580.0, 262.0]], stroke(Role::Ink, AXIS));
        pen.line(&[[46.0, 262.0], [46.0, 16.0]], stroke(Role::Ink, AXIS));
        pen.text([580.0, 284.0], Anchor::End, "*E*", label(Role::Ink));
        pen.text(
            [54.0, 28.0],
            Anchor::Start,
            "*L*_{vert}^{2}",
            label(Role::Ink),
        );
    }))
}

/// A stretch of the axis with the name of what moves there.
fn band(pen: &mut Pen, [from, to]: [f64; 2], name: &str) {
    pen.line(
        &[[from, 132.0], [to, 132.0]],
        stroke(Role::Omega, 7.0).alpha(0.5),
    );
    pen.text(
        [0.5 * (from + to), 160.0],
        Anchor::Middle,
        name,
        label(Role::Omega).strong(),
    );
}
