//! The one style of all figures: sizes, strokes, colours by role, and the pen that draws with them.
//!
//! Coordinates are units of the design, 600 wide, y downwards. A backend wants whole numbers, so the canvas is ten times as large
//! and its view box is scaled back; the finisher does the rest.

use core::borrow::Borrow;
use core::f64::consts::PI;

use plotters_backend::BackendCoord;
use spinning_bodies::Result;

pub use crate::canvas::Anchor::{self, End, Middle, Start};
pub use crate::canvas::Point;
pub use crate::canvas::Role::{self, AngularMomentum, Ink, Muted, Omega, Paper, Shade, Torque};
use crate::canvas::{Mark, Paint};
use crate::figure::{Data, Figure};

/// Width of every figure, units.
pub const WIDTH: f64 = 600.0;
/// Canvas units in a design unit.
pub const SCALE: f64 = 10.0;
/// Size of label text, units.
pub const LABEL: f64 = 17.0;
/// Size of ticks and remarks, units: a telephone shows it at 0.6, nine pixels.
pub const SMALL: f64 = 15.0;
/// Least size of indices and powers, units; nothing is smaller.
pub const LEAST: f64 = 13.0;
/// Stroke of the data.
pub const DATA: f64 = 2.0;
/// Stroke of secondary lines.
pub const SECONDARY: f64 = 1.2;
/// Stroke of axes.
pub const AXIS: f64 = 0.8;
/// Stroke of hairlines.
pub const HAIR: f64 = 0.5;

/// The dashes of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// A solid line.
    Solid,
    /// For what is approximate or did not happen.
    Dashed,
    /// Construction lines and lines of sight.
    Dotted,
}

/// A line's role, width, opacity and dash.
#[derive(Debug, Clone, Copy)]
pub struct Stroke {
    role: Role,
    width: f64,
    alpha: f64,
    dash: Dash,
}

/// A solid line of full opacity.
pub const fn stroke(role: Role, width: f64) -> Stroke {
    Stroke {
        role,
        width,
        alpha: 1.0,
        dash: Dash::Solid,
    }
}

/// A solid line of ink.
pub const fn inked(width: f64) -> Stroke {
    stroke(Role::Ink, width)
}

/// A stroke of fainter ink.
pub const fn muted(width: f64) -> Stroke {
    stroke(Role::Muted, width)
}

impl Stroke {
    /// The same at an opacity in 0…1.
    pub const fn alpha(mut self, alpha: f64) -> Self {
        self.alpha = alpha;
        self
    }

    /// The same, dashed.
    pub const fn dashed(mut self) -> Self {
        self.dash = Dash::Dashed;
        self
    }

    /// The same, dotted.
    pub const fn dotted(mut self) -> Self {
        self.dash = Dash::Dotted;
        self
    }

    /// What it means.
    pub const fn role(self) -> Role {
        self.role
    }

    fn paint(self) -> Paint {
        Paint {
            role: self.role,
            alpha: self.alpha,
            width: (self.width * SCALE).round() as u32,
        }
    }
}

/// Size and colour of a text.
#[derive(Debug, Clone, Copy)]
pub struct Lettering {
    role: Role,
    size: f64,
    strong: bool,
}

/// A label.
pub const fn label(role: Role) -> Lettering {
    sized(role, LABEL)
}

/// A tick or a remark.
pub const fn small(role: Role) -> Lettering {
    sized(role, SMALL)
}

/// The text of a tick in fainter ink; a power of ten a little larger, so that its exponent is seen to be one.
fn tick(text: &str) -> Lettering {
    match text.contains('^') {
        true => label(Role::Muted),
        false => small(Role::Muted),
    }
}

/// A text of a size of its own, units.
pub const fn sized(role: Role, size: f64) -> Lettering {
    Lettering {
        role,
        size,
        strong: false,
    }
}

impl Lettering {
    /// The same in semibold.
    pub const fn strong(mut self) -> Self {
        self.strong = true;
        self
    }
}

/// The words of a picture.
#[derive(Debug, Clone)]
pub struct Words {
    /// First sentence of the caption.
    pub claim: String,
    /// Rest of the caption.
    pub details: String,
    /// For readers who cannot see it.
    pub alt: String,
}

/// The words of a figure: claim, details and alternative text, each a format string that names the numbers in it.
macro_rules! words {
    ($claim:literal, $details:literal, $alt:literal) => {
        $crate::style::Words {
            claim: format!($claim),
            details: format!($details),
            alt: format!($alt),
        }
    };
}
pub(crate) use words;

/// Draws on a canvas `height` units high: the figure called `name`.
pub fn figure(
    name: &'static str,
    height: f64,
    words: Words,
    draw: impl FnOnce(&mut Pen),
) -> Figure {
    let marks = Vec::new();
    let mut pen = Pen { height, marks };
    draw(&mut pen);
    Figure {
        name,
        claim: words.claim,
        details: words.details,
        alt: words.alt,
        values: Vec::new(),
        data: Data::default(),
        size: [(WIDTH * SCALE) as u32, (height * SCALE).round() as u32],
        marks: pen.marks,
        moving: String::new(),
    }
}

/// Draws marks, each with the attributes that a backend has no place for.
#[derive(Debug)]
pub struct Pen {
    height: f64,
    marks: Vec<(Mark, String)>,
}

/// Design units to canvas units. NaN is placed far outside, where the tests find it.
fn canvas(point: Point) -> BackendCoord {
    let [x, y] = point.map(|units| match units.is_nan() {
        true => i32::MIN,
        false => (units * SCALE).round() as i32,
    });
    (x, y)
}

/// The points on the canvas, without repetitions.
fn trace(points: impl IntoIterator<Item: Borrow<Point>>) -> Vec<BackendCoord> {
    let points = points.into_iter();
    let mut trace: Vec<BackendCoord> = points.map(|p| canvas(*p.borrow())).collect();
    trace.dedup();
    trace
}

impl Pen {
    fn stroked(&mut self, stroke: Stroke, mark: Mark) {
        let unit = stroke.width.max(AXIS) * SCALE;
        let dashes = match stroke.dash {
            Dash::Solid => String::new(),
            Dash::Dashed => format!(" stroke-dasharray=\"{:.0} {:.0}\"", unit * 4.0, unit * 3.2),
            Dash::Dotted => format!(" stroke-dasharray=\"0 {:.0}\"", unit * 3.0),
        };
        self.marks.push((mark, dashes));
    }

    fn filled(&mut self, mark: impl FnOnce(Paint) -> Mark, role: Role, alpha: f64) {
        // More digits would not be visible, and the last ones differ between machines.
        let alpha = (1e3 * alpha).round() / 1e3;
        // What cannot be seen is no mark: the backend draws nothing for it.
        if alpha > 0.0 {
            let width = 1;
            let mark = mark(Paint { role, alpha, width });
            self.marks.push((mark, String::new()));
        }
    }

    /// A line through the points.
    pub fn line(&mut self, points: impl IntoIterator<Item: Borrow<Point>>, stroke: Stroke) {
        let points = trace(points);
        if points.len() > 1 {
            self.stroked(stroke, Mark::Path(points, stroke.paint()));
        }
    }

    /// Lines, each through points of its own.
    pub fn lines(&mut self, lines: impl IntoIterator<Item: AsRef<[Point]>>, stroke: Stroke) {
        for points in lines {
            self.line(points.as_ref(), stroke);
        }
    }

    /// A line through the points and back to the first.
    pub fn outline(&mut self, points: impl IntoIterator<Item: Borrow<Point>>, stroke: Stroke) {
        let mut closed: Vec<Point> = points.into_iter().map(|p| *p.borrow()).collect();
        closed.extend(closed.first().copied());
        self.line(closed, stroke);
    }

    /// A filled polygon.
    pub fn fill(&mut self, points: impl IntoIterator<Item: Borrow<Point>>, role: Role, alpha: f64) {
        self.filled(|paint| Mark::Polygon(trace(points), paint), role, alpha);
    }

    /// A polygon with an outline that hides what is behind it.
    pub fn sheet(&mut self, points: &[Point], outline: Stroke) {
        self.fill(points, Role::Paper, 1.0);
        if let Some((_, extra)) = self.marks.last_mut() {
            let (paint, width) = (outline.role.paint(), outline.width * SCALE);
            *extra = format!(" stroke=\"{paint}\" stroke-width=\"{width:.0}\"");
        }
    }

    /// A filled disc.
    pub fn disc(&mut self, center: Point, radius: f64, role: Role, alpha: f64) {
        let disc = |paint| Mark::Circle {
            center: canvas(center),
            radius: (radius * SCALE).round() as u32,
            paint,
            filled: true,
        };
        self.filled(disc, role, alpha);
    }

    /// A disc of ink.
    pub fn dot(&mut self, center: Point, radius: f64) {
        self.disc(center, radius, Role::Ink, 1.0);
    }

    /// A circle.
    pub fn ring(&mut self, center: Point, radius: f64, stroke: Stroke) {
        let ring = Mark::Circle {
            center: canvas(center),
            radius: (radius * SCALE).round() as u32,
            paint: stroke.paint(),
            filled: false,
        };
        self.stroked(stroke, ring);
    }

    /// An arc, angles in radians counterclockwise from the right as the reader sees it.
    pub fn arc(&mut self, center: Point, radius: f64, from: f64, to: f64, stroke: Stroke) {
        self.line(arc(center, radius, from, to), stroke);
    }

    /// An arrow: shaft and head, the tip exactly at `to`. Nothing if it has no length.
    pub fn arrow(&mut self, from: Point, to: Point, stroke: Stroke) {
        let length = distance(to, from);
        if length > 0.0 {
            let (reach, _) = head_size(stroke.width, length);
            let neck = between(to, from, 0.7 * reach / length);
            self.line([from, neck], stroke);
            self.head(from, to, stroke);
        }
    }

    /// A bent arrow along an arc.
    pub fn arc_arrow(&mut self, center: Point, radius: f64, from: f64, to: f64, stroke: Stroke) {
        let length = (to - from).abs() * radius;
        if length > 0.0 {
            let (reach, _) = head_size(stroke.width, length);
            let back = (to - from) * (reach / length).min(1.0);
            self.arc(center, radius, from, to - 0.7 * back, stroke);
            let [from, to] = [to - back, to].map(|angle| polar(center, radius, angle));
            self.head(from, to, stroke);
        }
    }

    /// The head of an arrow that comes from `from`, its tip at `to`.
    fn head(&mut self, from: Point, to: Point, stroke: Stroke) {
        let length = distance(to, from);
        let [u, v] = [0, 1].map(|k| (to[k] - from[k]) / length);
        let (reach, half) = head_size(stroke.width, f64::INFINITY);
        let at = |back: f64, side: f64| [to[0] - back * u - side * v, to[1] - back * v + side * u];
        let notch = at(0.72 * reach, 0.0);
        let head = [to, at(reach, half), notch, at(reach, -half)];
        self.fill(head, stroke.role, stroke.alpha);
    }

    /// A label in ink, as [`Pen::text`] writes it.
    pub fn label(&mut self, at: Point, anchor: Anchor, body: &str) {
        self.text(at, anchor, body, label(Role::Ink));
    }

    /// A small text in ink.
    pub fn note(&mut self, at: Point, anchor: Anchor, body: &str) {
        self.text(at, anchor, body, small(Role::Ink));
    }

    /// A small text in fainter ink.
    pub fn remark(&mut self, at: Point, anchor: Anchor, body: &str) {
        self.text(at, anchor, body, small(Role::Muted));
    }

    /// A tick below a place of an axis, and its text so far down.
    pub fn tick_below(&mut self, at: Point, down: f64, text: &str) {
        self.line([at, shifted(at, [0.0, 5.0])], inked(AXIS));
        self.text(shifted(at, [0.0, down]), Anchor::Middle, text, tick(text));
    }

    /// A tick on the left of a place of an axis, and its text.
    pub fn tick_beside(&mut self, at: Point, text: &str) {
        self.line([shifted(at, [-5.0, 0.0]), at], inked(AXIS));
        self.text(shifted(at, [-9.0, 5.0]), Anchor::End, text, tick(text));
    }

    /// A text whose base line starts, is centred or ends at the point. `*x*` is an italic letter,
    /// `_{…}` an index, `^{…}` a power.
    pub fn text(&mut self, at: Point, anchor: Anchor, body: &str, lettering: Lettering) {
        if body.is_empty() {
            return;
        }
        let weight = match lettering.strong {
            true => " font-weight=\"600\"",
            false => "",
        };
        let size = lettering.size.max(SMALL) * SCALE;
        let text = Mark::Text {
            at: canvas(at),
            anchor,
            body: body.to_owned(),
            paint: Paint {
                role: lettering.role,
                alpha: 1.0,
                width: 1,
            },
            size,
        };
        self.marks
            .push((text, format!(" font-size=\"{size:.0}\"{weight}")));
    }

    /// A name at the first of these places where it has [`Pen::room`].
    pub fn name(
        &mut self,
        places: impl IntoIterator<Item = Point>,
        text: &str,
        lettering: Lettering,
    ) {
        let size = lettering.size;
        let at = self.room(places, half_of(text, size));
        let line = shifted(at, [0.0, LOWER * size]);
        self.text(line, Anchor::Middle, text, lettering);
    }

    /// The place for a label of these half sides: the first of the places for its middle that is well clear of all lines, discs and words
    /// so far, or the clearest. Where it would touch something at all of them, places round about them are tried.
    pub fn room(&self, places: impl IntoIterator<Item = Point>, half: [f64; 2]) -> Point {
        self.clearest(&Vec::from_iter(places), half)
    }

    fn clearest(&self, places: &[Point], half: [f64; 2]) -> Point {
        let mut taken = self.taken();
        let mut best = ([0.0; 2], f64::MIN);
        let inside = within([half[0], WIDTH - half[0]], [half[1], self.height - half[1]]);
        // First the places themselves, then round about them in eight directions.
        let moves = (7..40).map(|k| (8.0 * f64::from(k / 8), f64::from(k % 8) * PI / 4.0));
        for by in moves.map(|(far, turn)| polar([0.0; 2], far, turn)) {
            let moved = places.iter().map(|p| shifted(*p, by));
            for place in moved.filter(|p| by == [0.0; 2] || inside(p)) {
                let mut room = CLEAR;
                // A place that is no clearer than the best need not be measured to the end.
                let barred = taken.iter().position(|[x, y]| {
                    let across = (x - place[0]).abs() - half[0];
                    room = room.min(across.max((y - place[1]).abs() - half[1]));
                    room <= best.1
                });
                match barred {
                    // What bars it bars the next one, too, more often than not.
                    Some(k) => taken.swap(0, k),
                    None => best = (place, room),
                }
            }
            // Letters are smaller than their box; a place beyond those given must be clear.
            if best.1 > if by == [0.0; 2] { -1.5 } else { 1.0 } {
                break;
            }
        }
        best.0
    }

    /// Points all over the marks that a name must not touch. Light and shade, thin circles and faint marks may lie under it.
    fn taken(&self) -> Vec<Point> {
        let units = |&(x, y): &BackendCoord| [f64::from(x) / SCALE, f64::from(y) / SCALE];
        let strong = |paint: &Paint| paint.alpha >= 0.35 && !matches!(paint.role, Shade | Paper);
        let mut taken = Vec::new();
        let marks = self.marks.iter().map(|(mark, _)| mark);
        for mark in marks.filter(|mark| strong(mark.paint())) {
            match mark {
                Mark::Path(points, _) => {
                    let points: Vec<Point> = points.iter().map(units).collect();
                    taken.extend(along(&points, 4.0));
                }
                Mark::Polygon(points, _) => taken.extend(points.iter().map(units)),
                Mark::Text {
                    at,
                    anchor,
                    body,
                    size,
                    ..
                } => {
                    let (size, [x, y]) = (size / SCALE, units(at));
                    let half = half_of(body, size);
                    let x = match anchor {
                        Anchor::Start => x + half[0],
                        Anchor::Middle => x,
                        Anchor::End => x - half[0],
                    };
                    taken.extend(area([x, y - LOWER * size], half));
                }
                Mark::Circle {
                    center,
                    radius,
                    paint,
                    filled,
                } => {
                    let (center, radius) = (units(center), f64::from(*radius) / SCALE);
                    match *filled {
                        true => taken.extend(area(center, [radius; 2])),
                        false if f64::from(paint.width) < AXIS * SCALE => (),
                        false => taken.extend(arc(center, radius, 0.0, 6.3)),
                    }
                }
            }
        }
        taken
    }

    /// A stacked fraction with its bar centred on the point; the texts are those before it, over the bar, under it, and after it.
    pub fn fraction(
        &mut self,
        at: Point,
        [before, over, under, after]: [&str; 4],
        lettering: Lettering,
    ) {
        let size = lettering.size;
        let digits = over.chars().count().max(under.chars().count()) as f64;
        let half = 0.29 * size * digits + 0.1 * size;
        for (beside, anchor, body) in [
            ([-half - 0.2 * size, 0.36 * size], Anchor::End, before),
            ([0.0, -0.32 * size], Anchor::Middle, over),
            ([0.0, 1.02 * size], Anchor::Middle, under),
        ] {
            self.text(shifted(at, beside), anchor, body, lettering);
        }
        let bar = [-half, half].map(|end| shifted(at, [end, 0.0]));
        self.line(bar, stroke(lettering.role, AXIS));
        let beyond = shifted(at, [half + 0.22 * size, 0.36 * size]);
        self.text(beyond, Anchor::Start, after, lettering);
    }
}

/// The distance at which a place is well clear.
const CLEAR: f64 = 4.0;
/// Height of the middle of letters above their base line, as a fraction of their size.
const LOWER: f64 = 0.3;

/// Half width and half height of a text of this size, approximately.
fn half_of(text: &str, size: f64) -> [f64; 2] {
    let letters = text.chars().filter(|c| !"*_{}^".contains(*c)).count();
    [(0.25 * letters as f64 + 0.15) * size, 0.47 * size]
}

/// Length and half width of an arrow's head.
fn head_size(width: f64, length: f64) -> (f64, f64) {
    let reach = (5.5 + 2.6 * width).min(length);
    (reach, 0.34 * (5.5 + 2.6 * width))
}

/// The point a fraction `t` of the way from `a` to `b`.
pub fn between(a: Point, b: Point, t: f64) -> Point {
    [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
}

/// A point displaced from another, to the right and down.
pub fn shifted([x, y]: Point, [right, down]: Point) -> Point {
    [x + right, y + down]
}

/// The point on the page of a place in a plan, y upward, given where its origin is drawn and its scale.
pub fn planned(origin: Point, unit: f64, [x, y]: Point) -> Point {
    [origin[0] + unit * x, origin[1] - unit * y]
}

/// The corners of a box, from one corner by the top or the bottom to the opposite one and back.
pub fn boxed([x, y]: Point, [u, v]: Point) -> [Point; 4] {
    [[x, y], [u, y], [u, v], [x, v]]
}

/// Whether a point lies between left and right, and between top and bottom.
pub fn within([left, right]: [f64; 2], [top, bottom]: [f64; 2]) -> impl Fn(&Point) -> bool {
    move |[x, y]| (left..right).contains(x) && (top..bottom).contains(y)
}

/// The point at `radius` and `angle` (counterclockwise from the right) about `center`.
pub fn polar(center: Point, radius: f64, angle: f64) -> Point {
    planned(center, radius, [angle.cos(), angle.sin()])
}

/// Points of an arc, a step every two degrees or closer.
pub fn arc(center: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    let steps = ((to - from).abs() / 0.035).ceil().max(1.0);
    (0..=steps as usize)
        .map(|k| polar(center, radius, from + (to - from) * k as f64 / steps))
        .collect()
}

/// How far two points are apart.
pub fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The one of these points that is nearest.
pub fn nearest(to: Point, points: impl IntoIterator<Item = Point>) -> Option<Point> {
    let off = |p: &Point| distance(*p, to);
    let points = points.into_iter();
    points.min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// Places as near to these as possible, in their order and no nearer to each other than `apart`.
pub fn spread<const N: usize>(places: [f64; N], apart: f64) -> [f64; N] {
    let mut order: [usize; N] = core::array::from_fn(|k| k);
    order.sort_by(|&a, &b| places[a].total_cmp(&places[b]));
    let mut moved = places;
    // Of two places that are too near each other, each gives way by half, again and again.
    for _ in 0..50 {
        for pair in order.windows(2) {
            let [below, above] = [pair[0], pair[1]];
            let way = 0.5 * (apart - (moved[above] - moved[below])).max(0.0);
            moved[below] -= way;
            moved[above] += way;
        }
    }
    moved
}

/// A number with `digits` decimals and a true minus sign.
pub fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    text.replace('-', if zero { "" } else { "\u{2212}" })
}

/// One more than `count` numbers at equal steps, from one end to the other.
pub fn spaced([from, to]: [f64; 2], count: u32) -> impl Iterator<Item = f64> + Clone {
    (0..=count).map(move |k| from + (to - from) * f64::from(k) / f64::from(count))
}

/// The least and the greatest of these numbers.
pub fn extent(values: impl IntoIterator<Item: Borrow<f64>>) -> [f64; 2] {
    let values = values.into_iter().map(|value| *value.borrow());
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}

/// The results for all items, or the first error.
pub fn tried<A, T>(
    each: impl IntoIterator<Item = A>,
    make: impl FnMut(A) -> Result<T>,
) -> Result<Vec<T>> {
    each.into_iter().map(make).collect()
}

/// The last number for which something holds that holds for the first of two and not for the second: by sixty halvings, to rounding.
pub fn border([mut holds, mut not]: [f64; 2], test: impl Fn(f64) -> Result<bool>) -> Result<f64> {
    for _ in 0..60 {
        let middle = 0.5 * (holds + not);
        let side = if test(middle)? { &mut holds } else { &mut not };
        *side = middle;
    }
    Ok(holds)
}

/// A number as a slider gives it: four figures, no trailing zeros.
pub fn brief(value: f64) -> String {
    let digits = (3.0 - value.abs().max(1e-9).log10().floor()).max(0.0) as usize;
    short(value, digits)
}

/// A number with at most `digits` decimals, without trailing zeros.
pub fn short(value: f64, digits: usize) -> String {
    let text = number(value, digits);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// Several numbers as sliders give them.
pub fn briefs<const N: usize>(values: [f64; N]) -> [String; N] {
    values.map(brief)
}

/// Several numbers with this number of decimals each.
pub fn numbers<const N: usize>(values: [f64; N], digits: usize) -> [String; N] {
    values.map(|value| number(value, digits))
}

/// A small number as LaTeX, its first figure with at most `digits` decimals.
pub fn scientific(value: f64, digits: usize) -> String {
    let exponent = value.log10().floor();
    match short(value / 10_f64.powf(exponent), digits).as_str() {
        "1" => format!("10^{{{exponent}}}"),
        first => format!("{first}\\cdot10^{{{exponent}}}"),
    }
}

/// A text in lines of at most this many letters.
pub fn wrapped(text: &str, letters: usize) -> Vec<String> {
    // The marks of italics take no room.
    let shown = |text: &str| text.chars().filter(|&letter| letter != '*').count();
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if shown(line) + 1 + shown(word) <= letters => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Points on a line through these, at most `step` units apart.
pub fn along(line: &[Point], step: f64) -> Vec<Point> {
    let piece = |pair: &[Point]| {
        let (a, b) = (pair[0], pair[1]);
        let steps = (distance(b, a) / step).ceil().max(1.0);
        (0..=steps as usize).map(move |k| between(a, b, k as f64 / steps))
    };
    line.windows(2).flat_map(piece).collect()
}

/// Points all over a box of these half sides, at most eight units apart.
pub fn area([x, y]: Point, half: [f64; 2]) -> Vec<Point> {
    let rows = along(&[[x, y - half[1]], [x, y + half[1]]], 8.0);
    let across = |[x, y]: Point| along(&[[x - half[0], y], [x + half[0], y]], 8.0);
    rows.into_iter().flat_map(across).collect()
}
