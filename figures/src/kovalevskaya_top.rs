//! The path of w = Ω₁ + iΩ₂, the circle of Kovalevskaya's constant, and the two bands of her polynomial (tutorial 8.2).

use spinning_bodies::euler_equations::{AxisMoments, HeavyTop, TopState};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::kovalevskaya_top::{Diagram, KovalevskayaTop};

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[
    of(
        "kovalevskaya-circle",
        &[FIRST, SECOND, THIRD, RATIO],
        circle,
    ),
    of("kovalevskaya-bands", &[FIRST, SECOND, THIRD], bands),
    of("appelrot-classes", &[SIZE], classes),
];

parameters! {
    FIRST: "first", r"\Omega_1", "rad/s", "spin about the first axis at the start", [0.2, 2.0], 1.0;
    SECOND: "second", r"\Omega_2", "rad/s", "spin about the second axis at the start", [-1.0, 1.5], 0.5;
    THIRD: "third", r"\Omega_3", "rad/s", "spin about the third axis at the start", [-1.5, 1.5], 0.3;
    RATIO: "ratio", "I_1/I_3", "", "ratio of moments in the panel on the right", [1.5, 2.5], 1.9;
    SIZE: "size", r"\lvert K\rvert", "s⁻²", "Kovalevskaya's constant", [0.05, 1.6], 0.6;
}

/// The start of all pictures: c = 1, z = (2, −1, 2)/3.
fn start(values: &Values) -> Result<TopState> {
    let [x, y, z] = values.each([FIRST, SECOND, THIRD]);
    Ok(TopState {
        omega: BodyVector::new(x, y, z),
        up: BodyVector::new(2.0, -1.0, 2.0).direction("up")?,
    })
}

fn spun(values: &Values) -> String {
    let told = briefs(values.each([FIRST, SECOND, THIRD])).join(", ");
    format!("$\\Omega=({})$ rad/s", told.replace('\u{2212}', "-"))
}

/// w = Ω₁ + iΩ₂ and K = w² − ζ.
fn traced(state: &TopState) -> [Point; 2] {
    let ([x, y], z) = ([state.omega.x(), state.omega.y()], state.up);
    [[x, y], [x * x - y * y - z.x(), 2.0 * x * y - z.y()]]
}

/// Kovalevskaya's top from the start.
fn launched(start: &TopState) -> Result<KovalevskayaTop> {
    KovalevskayaTop::with_up([2.0, 2.0, 1.0], LEVER, start.omega, start.up)
}

/// The place of the centre of mass.
const LEVER: BodyVector = BodyVector::new(1.0, 0.0, 0.0);

/// Duration of the motion that the scribble, the circle and the ring show.
const SECONDS: f64 = 240.0;
const SAMPLES: u32 = 6000;

/// Half the width of a panel, and the height of its middle.
const PANEL: f64 = 88.0;
const MIDDLE: f64 = 112.0;

/// The motion of the body, Kovalevskaya's constant during it, and the same expression for slightly different moments.
pub fn circle(values: &Values) -> Result<Figure> {
    let at_start = start(values)?;
    let ratio = values.of(&RATIO);
    let top = launched(&at_start)?;
    let times = spaced([0.0, SECONDS], SAMPLES);
    let hers = tried(times.clone(), |t| Ok(traced(&top.omega_and_up(t)?)))?;
    let wrong = HeavyTop::new(AxisMoments::new(ratio, ratio, 1.0)?, LEVER)?;
    let mut state = at_start;
    let mut wandering = Vec::new();
    // The motion is chaotic: with steps three times as long the last fifth would be none of its own.
    let step = SECONDS / f64::from(SAMPLES) / 24.0;
    for _ in 0..=SAMPLES {
        wandering.push(traced(&state)[1]);
        for _ in 0..24 {
            state = wrong.step(&state, step);
        }
    }
    let k = top.constants().kovalevskaya;
    let sizes = || wandering.iter().map(|[x, y]| x.hypot(*y));
    let (least, greatest) = (sizes().fold(k, f64::min), sizes().fold(k, f64::max));

    // The widest gap in the part of its circle that K has passed, rad.
    let mut angles: Vec<f64> = hers.iter().map(|p| p[1][1].atan2(p[1][0])).collect();
    angles.sort_by(f64::total_cmp);
    let round = angles[0] + TAU - angles[angles.len() - 1];
    let open = angles.windows(2).map(|pair| pair[1] - pair[0]);
    let open = open.fold(round, f64::max);
    let named = brief(ratio);
    let [low, high] = [least, greatest].map(|radius| number(radius, 2));
    let mut told = "It does not wander.".to_owned();
    let mut ring = "the same circle".to_owned();
    if greatest - least > 1e-3 * greatest {
        told = format!("It wanders from {low} to {high}.");
        ring = format!("a smeared ring between radius {low} and {high}");
    }
    let does = match k > 1e-3 {
        true if open < 0.2 => "runs round a circle",
        true => "runs to and fro on an arc of a circle",
        false => "stands still at the origin",
    };
    let (seconds, from) = (number(SECONDS, 0), spun(values));
    let [size, radius] = [4, 2].map(|digits| number(k, digits));
    let words = words!(
        "The top scribbles; its constant {does}.",
        "Three drawings of {seconds} s from {from} and $z=(2,-1,2)/3$, $MgC_1/I_3=1$. Left: $w=\\Omega_1+i\\Omega_2$. Middle: \
         $K=w^2-(z_1+iz_2)$ of the same motion, always {size} from the origin. Right: the same expression if \
         $I_1=I_2={named}\\,I_3$; dashed, where it should be. {told}",
        "Three panels. Left, a tangle of loops: the horizontal path of the angular velocity in the body. Middle, one clean \
         circle of radius {radius}, or a part of it: Kovalevskaya's expression along that motion. Right, {ring}: the same expression when the first two moments are {named} times the third."
    );

    let made = figure("kovalevskaya-circle", 246.0, words, |pen| {
        // Each fills its panel: the scribble is wider to the left than to the right.
        let reach = hers.iter().map(|p| p[0][0].hypot(p[0][1]));
        let reach = reach.fold(0.0, f64::max);
        let panels = [100.0, 300.0, 500.0];
        let place = |x: f64, reach: f64| {
            let scale = PANEL / reach;
            move |[re, im]: Point| [x + scale * re, MIDDLE - scale * im]
        };
        let [scribble, circle, smear] =
            [(0, reach), (1, greatest), (2, greatest)].map(|(n, reach)| place(panels[n], reach));
        let right = format!("*I*_{{1}} = {named} *I*_{{3}}");
        for (x, text, remark) in [
            (panels[0], "*w*", "what the top does"),
            (panels[1], "*K*", "*I*_{1} = 2 *I*_{3}"),
            (panels[2], "*K*", &right),
        ] {
            let [left, right] = [x - PANEL - 6.0, x + PANEL + 6.0];
            pen.line([[left, MIDDLE], [right, MIDDLE]], inked(HAIR));
            let [above, below] = [MIDDLE - PANEL - 6.0, MIDDLE + PANEL + 6.0];
            pen.line([[x, above], [x, below]], inked(HAIR));
            pen.label([right - 10.0, above + 18.0], Middle, text);
            pen.label([x, below + 26.0], Middle, remark);
        }
        let path = hers.iter().map(|p| scribble(p[0]));
        pen.line(path, stroke(Omega, AXIS).alpha(0.8));
        let ring = (0..=360).map(|n| f64::from(n).to_radians().sin_cos());
        let ring = ring.map(|(sine, cosine)| smear([k * cosine, k * sine]));
        let path = hers.iter().map(|p| circle(p[1]));
        pen.line(path, inked(DATA));
        let path = wandering.iter().map(|p| smear(*p));
        pen.line(path, muted(HAIR).alpha(0.8));
        pen.line(ring, inked(SECONDARY).dashed());
    });
    let columns = "time (s) | real part | imaginary part";
    let rows = |points: Vec<Point>| {
        let rows = times.clone().zip(points).step_by(10);
        rows.map(|(time, [real, imaginary])| [time, real, imaginary])
    };
    let [w, k] = [0, 1].map(|which: usize| hers.iter().map(|p| p[which]).collect());
    Ok(made
        .data("w", columns, rows(w))
        .data("K", columns, rows(k))
        .data("K of other moments", columns, rows(wandering)))
}

/// P(s) with its five roots: s₁ oscillates in the middle band, s₂ comes from −∞ and goes back.
pub fn bands(values: &Values) -> Result<Figure> {
    let top = launched(&start(values)?)?;
    let roots = top.roots();
    let mut real: Vec<f64> = roots.iter().filter(|e| e.im == 0.0).map(|e| e.re).collect();
    real.sort_by(f64::total_cmp);
    // The bands of the two variables; that of the second begins at −∞.
    let times = (0..400).map(|n| 0.1 * f64::from(n));
    let found = tried(times, |t| {
        Ok(top.separation_variables(&top.omega_and_up(t)?))
    })?;
    let ends = |k: usize, pick: fn(f64, f64) -> f64| found.iter().map(|s| s[k]).reduce(pick);
    let (low, high, turn) = (ends(0, f64::min), ends(0, f64::max), ends(1, f64::max));
    let value = |s: f64| {
        let product = roots
            .iter()
            .fold(nalgebra::Complex::new(1.0, 0.0), |p, e| p * (s - e));
        -4.0 * product.re
    };

    let moving = low.zip(high).zip(turn).zip(top.frequencies());
    let told = match moving {
        Some((((low, high), turn), [first, second])) => {
            let [low, high, turn, ratio] = numbers([low, high, turn, first / second], 3);
            let [first, second] = numbers([first, second], 4);
            format!(
                "$s_1$ swings between {low} and {high}, {first} times a second; $s_2$ comes from infinitely far below, turns at {turn} and goes back, {second} times a second. Their ratio is {ratio}."
            )
        }
        None => "Two roots meet, and the two quantities do not swing.".to_owned(),
    };
    let claim = match moving {
        Some(_) => "Two quantities swing where a polynomial is positive.".to_owned(),
        None => "Where two roots of the polynomial meet, nothing swings between them.".to_owned(),
    };
    let marked = match moving {
        Some(_) => {
            " To the left of the smallest one, where it is positive, the second separation variable comes and goes; the first swings between two further roots. \
                    Both stretches are marked on the axis."
        }
        None => "",
    };
    let (begun, count) = (spun(values), real.len());
    let words = words!(
        "{claim}",
        "$P(s)=-4(s-e_1)\\cdots(s-e_5)$ for the motion from {begun} and $z=(2,-1,2)/3$, heights on a logarithmic scale beyond 0.01; discs: its real roots. {told}",
        "The graph of a polynomial of degree five with {count} real roots.{marked}"
    );

    // The range of the polynomial between its outermost roots, and slightly beyond them.
    let (from, to) = (real[0] - 1.1, real[real.len() - 1] + 0.35);
    let grid: Vec<(f64, f64)> = spaced([from, to], 600).map(|s| (s, value(s))).collect();
    let made = figure("kovalevskaya-bands", 246.0, words, |pen| {
        let axis = Axis::linear([from, to], [30.0, 570.0]);
        let x = |s: f64| axis.at(s);
        let y = |p: f64| LEVEL - 13.0 * (p / 0.01).asinh();
        let seen = |[_, y]: &Point| (8.0..=216.0).contains(y);
        let graph: Vec<Point> = grid.iter().map(|&(s, p)| [x(s), y(p)]).collect();
        pen.line([[20.0, LEVEL], [580.0, LEVEL]], inked(AXIS));
        // Numbers stand below the curve, with a faint line to each.
        for (s, text) in axis.ticks(70.0) {
            pen.line([[x(s), 8.0], [x(s), 216.0]], inked(HAIR).alpha(0.18));
            pen.tick_below([x(s), 216.0], 22.0, &text);
        }
        // Nothing is drawn where it is beyond the picture.
        pen.lines(graph.split(|p| !seen(p)), inked(DATA));
        if let Some((((low, high), turn), _)) = moving {
            band(pen, [20.0, x(turn)], "*s*_{2}");
            band(pen, [x(low), x(high)], "*s*_{1}");
        }
        for e in &real {
            pen.dot([x(*e), LEVEL], 3.5);
        }
        pen.label([588.0, LEVEL - 8.0], End, "*s*");
        let top = graph.iter().find(|p| seen(p)).copied().unwrap_or_default();
        let spot = [top[0] + 80.0, (top[1] + 12.0).max(24.0)];
        pen.label(spot, Start, "*P*(*s*)");
    });
    let rows = grid.iter().map(|&(s, p)| [s, p]);
    Ok(made.data("P", "s (1/s²) | P (1/s¹⁰)", rows))
}

/// The axis of the bands, units.
const LEVEL: f64 = 124.0;

/// Energy and L_vert² of motions with one |K|, and the curves on which two roots meet.
pub fn classes(values: &Values) -> Result<Figure> {
    let size = values.of(&SIZE);
    let top = HeavyTop::new(AxisMoments::new(2.0, 2.0, 1.0)?, LEVER)?;
    let diagram = Diagram::new(1.0, size)?;
    let (least, greatest) = (-1.1, 2.4);
    let highest = 1.07 * diagram.shared_upper(greatest);
    // Evenly spread starts with w² − ζ = |K| e^{iα}: ζ follows, and z₃ if ζ is not too long.
    let mut motions = Vec::new();
    for n in 0..8_000 {
        let spread = |k: f64| (f64::from(n) * k).fract();
        let [p, q, r] =
            [0.618_033_988_7, 0.414_213_562_4, 0.732_050_807_6].map(|k| 4.4 * spread(k) - 2.2);
        let (sine, cosine) = (TAU * spread(0.236_067_977_5)).sin_cos();
        let zeta = [p * p - q * q - size * cosine, 2.0 * p * q - size * sine];
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
    let mut curves: [Vec<Point>; 4] = Default::default();
    for energy in spaced([least, greatest], 700) {
        let shared = [diagram.shared_upper(energy), diagram.shared_lower(energy)];
        let own = diagram.cubic_double(energy)?.into_iter().flatten();
        for (curve, h) in curves.iter_mut().zip(shared.into_iter().chain(own)) {
            curve.push([energy, h]);
        }
    }

    let ends = diagram.cubic_double(greatest)?;

    let inside = |[e, h]: &Point| (least..=greatest).contains(e) && (0.0..=highest).contains(h);
    motions.retain(inside);
    let (count, radius) = (motions.len(), brief(size));
    let words = words!(
        "Where two roots meet, one kind of motion ends and another begins.",
        "A dot for each of {count} starts with $\\lvert K\\rvert={radius}$, $MgC_1=I_3=1$, at its energy and $L_{{\\text{{vert}}}}^2$. On the straight lines a root \
         of the cubic meets $e_4$ or $e_5$, on the curve two of its own meet: Appelrot's classes two to four.",
        "A plane with energy to the right and the square of the vertical angular momentum upwards. Dots fill a region that starts at a \
         lowest energy and widens to the right; its edges, and borders inside it, are two parallel rising lines and a curve that touches them."
    );

    let places = [56.0, 478.0, 290.0, 36.0];
    let frame = Frame::linear([least, greatest], [0.0, highest], places);
    let made = figure("appelrot-classes", 338.0, words, |pen| {
        frame.draw_round(pen, ["energy *E*", "*L*_{vert}^{2}"]);
        for start in frame.trace(motions.iter().copied()) {
            pen.disc(start, 1.5, Ink, 0.45);
        }
        for curve in &curves {
            // A branch may leave the picture and come back.
            frame.curve(pen, curve.iter().copied(), inked(DATA));
        }
        // Each line has its name where it ends.
        let shared = [
            (diagram.shared_upper(greatest), "root = *e*_{4}"),
            (diagram.shared_lower(greatest), "root = *e*_{5}"),
        ];
        let own = ends.into_iter().flatten().map(|h| (h, "double root"));
        let named = shared.into_iter().chain(own);
        let named = named.filter(|(h, _)| (0.0..=highest).contains(h));
        let (heights, names): (Vec<f64>, Vec<&str>) =
            named.map(|(h, name)| (frame.y.at(h), name)).unzip();
        for (text, y) in names.into_iter().zip(apart(&heights, 20.0, 284.0)) {
            pen.label([486.0, y + 5.0], Start, text);
        }
    });
    Ok(made.data("starts", "energy (J) | L_vert² (J² s²)", motions))
}

/// A part of the axis with the name of the variable that moves there, clear of the curve.
fn band(pen: &mut Pen, [from, to]: [f64; 2], name: &str) {
    pen.line([[from, LEVEL], [to, LEVEL]], inked(7.0).alpha(0.4));
    let middle = 0.5 * (from + to);
    let heights = [22.0, -20.0, 40.0, -38.0, 60.0, -58.0, 80.0];
    let places = [0.0, 18.0, -18.0].map(|dx| heights.map(|dy| [middle + dx, LEVEL + dy]));
    pen.name(places.concat(), name, label(Ink).strong());
}
