//! The reader's own motions as pictures of the body: stills, and films.

use core::f64::consts::TAU;
use core::fmt::Write as _;

use nalgebra::{Isometry3, Matrix3};
use spinning_bodies::scene::{Around, Sight, Solid};

use crate::figure::Figure;
use crate::finish::{Theme, short};
use crate::plot::Axis;
use crate::solid::{Vector, View, dot, hull};
use crate::style::*;

/// The drawing of a solid, along its own axes.
///
/// It is the convex hull of ellipsoids, which may be flat or points, with lines on its surface; or a bar.
#[derive(Default)]
struct Body {
    /// Centre and semi-axes of each ellipsoid.
    rounds: Vec<(Vector, Matrix3<f64>)>,
    /// Points of lines with the outward normals of the two faces that meet there: a point is hidden if both faces look away from the eye.
    edges: Vec<Vec<[Vector; 3]>>,
    bar: Option<Vector>,
}

impl Body {
    fn of(solid: &Solid) -> Self {
        match solid {
            Solid::Ellipsoid(half) => Self::ellipsoid(*half),
            Solid::Turned(profile) => Self::turned(profile),
            Solid::Cuboid(edges) => Self::cuboid(edges),
            Solid::Bar(to) => Self {
                bar: Some(*to),
                ..Self::default()
            },
        }
    }

    /// Three ellipses on it, and a ring about the end of the third.
    fn ellipsoid(half: Matrix3<f64>) -> Self {
        let [a, b, c] = [0, 1, 2].map(|k| half.column(k).into_owned());
        let across = [b.cross(&c), c.cross(&a), a.cross(&b)];
        let ring = |[i, j]: [usize; 2], share: f64| {
            let k = 3 - i - j;
            let off = (1.0 - share * share).max(0.0).sqrt();
            round_about(|angle| {
                let (s, c) = angle.sin_cos();
                let [x, y] = [share * c, share * s];
                let normal = across[i] * x + across[j] * y + across[k] * off;
                let place = half.column(i) * x + half.column(j) * y + half.column(k) * off;
                [place, normal, normal]
            })
        };
        // A small ring distinguishes the ends of the third axis.
        let rings = [([0, 1], 1.0), ([1, 2], 1.0), ([2, 0], 1.0), ([0, 1], 0.3)];
        Self {
            rounds: vec![(Vector::zeros(), half)],
            edges: rings.map(|(plane, share)| ring(plane, share)).into(),
            bar: None,
        }
    }

    /// A line over both faces and down the side shows how it turns.
    fn turned(profile: &[[f64; 2]]) -> Self {
        let disc = |&[z, radius]: &[f64; 2]| {
            let half = Matrix3::from_diagonal(&Vector::new(radius, radius, 0.0));
            (Vector::new(0.0, 0.0, z), half)
        };
        let [Some(&low), Some(&high)] = [profile.first(), profile.last()] else {
            return Self::default();
        };
        let rim = |[z, radius]: [f64; 2], face: Vector| {
            round_about(|angle| {
                let (s, c) = angle.sin_cos();
                let side = Vector::new(c, s, 0.0);
                [side * radius + Vector::z() * z, face, side]
            })
        };
        let mark = |[z, radius]: [f64; 2], face: Vector| {
            [0.0, radius].map(|x| [Vector::new(x, 0.0, z), face, face])
        };
        let side = profile
            .iter()
            .map(|&[z, radius]| [Vector::new(radius, 0.0, z), Vector::x(), Vector::x()]);
        Self {
            rounds: profile.iter().map(disc).collect(),
            edges: vec![
                rim(low, -Vector::z()),
                rim(high, Vector::z()),
                mark(low, -Vector::z()).into(),
                mark(high, Vector::z()).into(),
                side.collect(),
            ],
            bar: None,
        }
    }

    fn cuboid(edges: &Vector) -> Self {
        let signs = [-1.0, 1.0];
        let corner = |s: Vector| edges.component_mul(&s) * 0.5;
        let corners = signs.map(|x| signs.map(|y| signs.map(|z| corner(Vector::new(x, y, z)))));
        let mut lines = Vec::new();
        for axis in 0..3 {
            let [along, j, k] = [0, 1, 2].map(|n| Vector::ith((axis + n) % 3, 1.0));
            for (p, q) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
                let (u, v) = (p * j, q * k);
                let end = |sign: f64| [corner(sign * along + u + v), u, v];
                lines.push(signs.map(end).into());
            }
        }
        let corners = corners.as_flattened().as_flattened().iter();
        Self {
            rounds: corners.map(|place| (*place, Matrix3::zeros())).collect(),
            edges: lines,
            bar: None,
        }
    }

    /// The greatest distance from its origin, m.
    fn reach(&self) -> f64 {
        // Flat discs lie across the way to their middle.
        let rounds = self.rounds.iter().map(|(middle, half)| {
            let radii = half.column_iter().map(|axis| axis.norm());
            middle.norm().hypot(radii.fold(0.0, f64::max))
        });
        rounds
            .chain(self.bar.map(|to| to.norm()))
            .fold(0.0, f64::max)
    }

    /// The point of the hull that is farthest in this direction.
    fn farthest(&self, direction: &Vector) -> Option<Vector> {
        let rounds = self.rounds.iter().map(|(middle, half)| {
            let share: Vector = half.data.0.map(|axis| dot(&axis.into(), direction)).into();
            let length = dot(&share, &share).sqrt();
            (dot(middle, direction) + length, middle, half, share, length)
        });
        let (_, middle, half, share, length) = rounds.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let beyond = if length > 0.0 {
            half * (share / length)
        } else {
            Vector::zeros()
        };
        Some(middle + beyond)
    }

    fn draw(&self, pen: &mut Pen, view: &View, stands: &Isometry3<f64>) {
        let view = view.along_body(stands);
        if let Some(to) = self.bar {
            return pen.line(view.trace(&[Vector::zeros(), to]), inked(DATA));
        }
        let corner = |turns: f64| {
            let (s, c) = (TAU * turns).sin_cos();
            let point = self.farthest(&(view.right * c + view.up * s))?;
            Some(view.project(&point))
        };
        let outline: Vec<Point> = (0..CORNERS)
            .flat_map(|k| {
                let turns = move |part: f64| (f64::from(k) + part) / f64::from(CORNERS);
                let far = |([x, y], [u, v]): (Point, Point)| (x - u).hypot(y - v) > LONG;
                let ends = corner(turns(0.0)).zip(corner(turns(1.0)));
                // The long side of a thin body is bent, too.
                let parts = if ends.is_some_and(far) { 6 } else { 1 };
                (0..parts).filter_map(move |j| corner(turns(f64::from(j) / f64::from(parts))))
            })
            .collect();
        pen.sheet(&thinned(&hull(&outline)), inked(SECONDARY));
        for edge in &self.edges {
            let seen = |[_, a, b]: &[Vector; 3]| view.faces(a) || view.faces(b);
            for piece in edge.split(|point| !seen(point)) {
                let line: Vec<Point> = piece
                    .iter()
                    .map(|[place, ..]| view.project(place))
                    .collect();
                pen.line(thinned(&line), inked(AXIS));
            }
        }
    }
}

/// The line without the points that lie on it anyway.
fn thinned(line: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    for (k, [x, y]) in line.iter().enumerate() {
        let ends = kept.last().zip(line.get(k + 1));
        let needless = ends.is_some_and(|([a, b], [c, d])| {
            let area = (c - a) * (y - b) - (d - b) * (x - a);
            area.abs() < FINE * (c - a).hypot(d - b)
        });
        if !needless {
            kept.push([*x, *y]);
        }
    }
    kept
}

/// The distance to which it is drawn from the point that is followed, m.
fn reach(sight: &Sight) -> f64 {
    let solids = sight.solids.iter().map(|(solid, stands)| {
        (stands.translation.vector - sight.place).norm() + Body::of(solid).reach()
    });
    solids.fold(0.0, f64::max)
}

/// Corners of an outline, and of an ellipse on the surface.
const CORNERS: u32 = 36;
const INNER: u32 = 24;
/// An edge of an outline that may be a curve, units.
const LONG: f64 = 16.0;
/// Bends shallower than this are not visible, units.
const FINE: f64 = 0.12;

fn round_about<T>(at: impl Fn(f64) -> T) -> Vec<T> {
    let angles = spaced([0.0, TAU], INNER);
    angles.map(at).collect()
}

/// A motion that can be drawn.
#[derive(Debug)]
pub struct Film<'a> {
    /// The name of the motion.
    pub title: &'a str,
    /// Seconds of the motion in a second of the film.
    pub speed: f64,
    /// The view at each of the given times (s), which are equally spaced; there is at least one.
    pub shots: Vec<(f64, Sight)>,
}

const HEIGHT: f64 = 420.0;
const MIDDLE: Point = [300.0, 200.0];
/// Length of the longest arrow of a film, units.
const ARROW: f64 = 150.0;
/// The direction of view: slightly from the right and from above.
const DIRECTION: [f64; 2] = [-1.2, 0.3];

/// What the arrows and the view have in common.
struct Scenery {
    view: View,
    followed: bool,
    /// Whether the surroundings are the same in every picture, so that they are drawn only once.
    still: bool,
    /// The round distance between the points of space, m.
    step: f64,
    /// Units of the picture per unit of the quantity that an arrow shows.
    shares: [f64; 2],
}

/// The vectors shown by arrows, and the letters at their tips.
fn vectors(sight: &Sight) -> [Vector; 2] {
    [sight.omega, sight.angular_momentum.unwrap_or_default()]
}

const NAMES: [(Role, &str); 2] = [(Omega, "Ω"), (AngularMomentum, "L")];

impl Scenery {
    /// The arrows of a sight on the paper, from their beginning.
    fn ways(&self, sight: &Sight) -> [Point; 2] {
        let vectors = vectors(sight);
        [0, 1].map(|k| {
            let vector = vectors[k] * self.shares[k];
            [self.view.right.dot(&vector), -self.view.up.dot(&vector)]
        })
    }
}

/// Floor and ceiling on the paper.
fn levels(view: &View, ceiling: f64) -> [f64; 2] {
    [0.0, ceiling].map(|height| view.project(&(Vector::z() * height))[1])
}

/// The middle of a name, moved off a level line that would cross it.
fn clear_of(y: f64, line: f64) -> f64 {
    match y - line {
        off if off.abs() < 13.0 => line + 13.0_f64.copysign(off),
        _ => y,
    }
}

impl Film<'_> {
    fn scenery(&self) -> Scenery {
        // How far the body reaches from the point that is followed, m.
        let reaches = self.shots.iter().map(|(_, sight)| reach(sight));
        let reach = reaches.fold(f64::MIN_POSITIVE, f64::max);
        let ticks = Axis::linear([0.0, 16.0 * reach], [0.0, 16.0]).ticks(1.6);
        let around = self.shots[0].1.around;
        let mut seen: Vec<Vector> = self.shots.iter().map(|(_, sight)| sight.place).collect();
        match around {
            Around::String => seen.push(Vector::zeros()),
            Around::Under(ceiling) => {
                seen.extend([0.0, ceiling].map(|z| Vector::new(seen[0].x, seen[0].y, z)));
            }
            _ => (),
        }
        let far = |axis: Vector| {
            let [from, to] = extent(seen.iter().map(|place| place.dot(&axis)));
            to - from
        };
        let way = [Vector::x(), Vector::y(), Vector::z()].map(far);
        let bounded = matches!(around, Around::Under(_) | Around::String);
        // If the path is longer than nine bodies, the view moves with the body.
        let followed = !bounded && way.into_iter().fold(0.0, f64::max) > 9.0 * reach;
        let view = match followed {
            true => View::new(DIRECTION[0], DIRECTION[1], MIDDLE, 72.0 / reach),
            false => {
                let plain = View::new(DIRECTION[0], DIRECTION[1], [0.0; 2], 1.0);
                let sides = [plain.right, plain.up].map(|side| side * reach);
                let around = |place: &Vector| {
                    let place = *place;
                    sides.map(|side| [place + side, place - side])
                };
                let corners: Vec<_> = seen.iter().flat_map(around).flatten().collect();
                let frame = [60.0, 56.0, 540.0, 346.0];
                View::fitted(DIRECTION, &corners, frame, 92.0 / reach)
            }
        };
        let mut scenery = Scenery {
            view,
            followed,
            still: !followed && !matches!(around, Around::String),
            step: ticks.get(1).map_or(1.0, |tick| tick.0),
            shares: [0, 1].map(|k| {
                let lengths = self.shots.iter().map(|(_, sight)| vectors(sight)[k].norm());
                let longest = lengths.fold(0.0, f64::max);
                if longest > 0.0 { ARROW / longest } else { 0.0 }
            }),
        };
        // No arrow leaves the picture.
        let mut within: f64 = 1.0;
        for (_, sight) in &self.shots {
            let [x, y] = if followed {
                MIDDLE
            } else {
                view.project(&sight.place)
            };
            for [dx, dy] in scenery.ways(sight) {
                for (way, from, most) in [(dx, x, 572.0), (dy, y, 366.0)] {
                    let room = if way > 0.0 { most - from } else { from - 28.0 };
                    within = within.min(room / way.abs());
                }
            }
        }
        // The factor by which the arrows may be shortened.
        scenery.shares = scenery.shares.map(|share| share * within.max(0.3));
        scenery
    }

    /// The surroundings that are at rest in space.
    fn draw_around(&self, pen: &mut Pen, scenery: &Scenery, sight: &Sight) {
        let Scenery {
            view,
            followed,
            step,
            ..
        } = scenery;
        let floor = match sight.around {
            Around::Space => false,
            Around::Floor => true,
            Around::Pivot => {
                return pen.dot(view.project(&sight.place), 3.2);
            }
            Around::String => {
                let ends = [Vector::zeros(), sight.place];
                return pen.line(view.trace(&ends), inked(AXIS));
            }
            Around::Under(ceiling) => {
                let lines = levels(view, ceiling).map(|y| [[24.0, y], [576.0, y]]);
                return pen.lines(lines, muted(SECONDARY));
            }
        };
        // Points of space at round distances: on the floor, or in the plane of the motion.
        let near = if *followed {
            sight.place
        } else {
            self.shots[0].1.place
        };
        let round = |along: f64| (along / step).round() * step;
        for (i, j) in (-4..=4).flat_map(|i| (-3..=3).map(move |j| (i, j))) {
            let [across, on] = [f64::from(i), f64::from(j)].map(|k| k * step);
            let x = round(near.x) + across;
            let place = match floor {
                true => Vector::new(x, round(near.y) + on, 0.0),
                false => Vector::new(x, near.y, round(near.z) + on),
            };
            let [x, y] = view.project(&place);
            if (20.0..580.0).contains(&x) && (20.0..366.0).contains(&y) {
                pen.disc([x, y], 1.6, Muted, 1.0);
            }
        }
    }

    fn draw(&self, pen: &mut Pen, scenery: &Scenery, (time, sight): &(f64, Sight)) {
        let view = match scenery.followed {
            true => scenery.view.centered_on(&sight.place, MIDDLE),
            false => scenery.view,
        };
        let scenery = Scenery { view, ..*scenery };
        if !scenery.still {
            self.draw_around(pen, &scenery, sight);
        }
        let from = view.project(&sight.place);
        let ways = scenery.ways(sight);
        let [omega, l] = ways;
        let sizes = omega[0].hypot(omega[1]) * l[0].hypot(l[1]);
        let sine = (omega[0] * l[1] - omega[1] * l[0]) / sizes;
        let same = sizes > 0.0 && omega[0] * l[0] + omega[1] * l[1] > 0.0;
        // Where one covers the other, they are drawn side by side, with their names on different sides.
        let apart = if same {
            (1.0 - sine.abs() / 0.08).max(0.0)
        } else {
            0.0
        };
        let lines = match sight.around {
            Around::Under(ceiling) => levels(&view, ceiling),
            _ => [f64::INFINITY; 2],
        };
        // Nearer than this, which of them is on the left does not matter.
        let side = if sine > 0.03 { -1.0 } else { 1.0 };
        let [behind, before] = [true, false].map(|behind| {
            let each = vectors(sight).into_iter().zip(ways).zip(NAMES);
            let drawn = each.filter_map(|((vector, way), (role, name))| {
                let length = way[0].hypot(way[1]);
                if length <= 7.0 || (vector.dot(&view.toward) < 0.0) != behind {
                    return None;
                }
                let [dx, dy] = way.map(|part| part / length);
                let side = if role == Omega { -side } else { side };
                let beside = |along: f64, across: f64| {
                    let across = side * across;
                    [
                        from[0] + along * dx + across * dy,
                        from[1] + along * dy - across * dx,
                    ]
                };
                let ends = [0.0, length].map(|along| beside(along, 2.5 * apart));
                let [x, y] = beside(length + 12.0, 9.0 + 2.5 * apart);
                let y = lines.into_iter().fold(y, clear_of);
                let name = if length > 14.0 { name } else { "" };
                Some((ends, role, name, [x, y + 6.0]))
            });
            drawn.collect::<Vec<_>>()
        });
        for ([from, tip], role, ..) in &behind {
            pen.arrow(*from, *tip, stroke(*role, DATA));
        }
        let depth = |stands: &Isometry3<f64>| stands.translation.vector.dot(&view.toward);
        let mut solids: Vec<_> = sight.solids.iter().collect();
        solids.sort_by(|(_, a), (_, b)| depth(a).total_cmp(&depth(b)));
        for (solid, stands) in solids {
            Body::of(solid).draw(pen, &view, stands);
        }
        // The part of an arrow that the body hides is dashed.
        for (ends, role, ..) in &behind {
            pen.line(ends, stroke(*role, SECONDARY).dashed());
        }
        for ([from, tip], role, ..) in &before {
            pen.arrow(*from, *tip, stroke(*role, DATA));
        }
        for (_, role, name, place) in behind.into_iter().chain(before) {
            pen.text(place, Middle, name, label(role));
        }
        let time = format!("{} s", number(*time, self.decimals()));
        pen.note([24.0, HEIGHT - 32.0], Start, &time);
    }

    /// The number of decimals needed for different times of two pictures.
    fn decimals(&self) -> usize {
        let times = self.shots.first().zip(self.shots.get(1));
        let step = times.map_or(1.0, |(a, b)| (b.0 - a.0).abs());
        let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
        // One more where the step is no round number.
        let shown: f64 = number(step, decimals).parse().unwrap_or(0.0);
        decimals + usize::from((shown - step).abs() > 0.05 * step)
    }

    fn words(&self) -> Words {
        let (first, last) = (self.shots[0].0, self.shots[self.shots.len() - 1].0);
        let span = format!("{} s to {} s", brief(first), brief(last));
        Words {
            claim: format!("{} from {span}.", self.title),
            details: String::new(),
            alt: format!(
                "The motion {}, drawn as {}, from {span}.",
                self.title, self.shots[0].1.drawn_as
            ),
        }
    }

    /// The parts that all pictures share.
    fn draw_shared(&self, pen: &mut Pen, scenery: &Scenery, pace: &str) {
        if scenery.still {
            self.draw_around(pen, scenery, &self.shots[0].1);
        }
        let drawn_as = self.shots[0].1.drawn_as;
        let muted = small(Muted);
        pen.text([576.0, HEIGHT - 32.0], End, pace, muted);
        pen.text([576.0, HEIGHT - 12.0], End, drawn_as, muted);
    }

    /// A picture for each time.
    pub fn stills(&self) -> impl Iterator<Item = Figure> {
        let scenery = self.scenery();
        self.shots.iter().map(move |shot| {
            figure(NAME, HEIGHT, self.words(), |pen| {
                self.draw_shared(pen, &scenery, "");
                self.draw(pen, &scenery, shot);
            })
        })
    }

    /// The file that shows all of them in sequence, for this long (s), and then begins again. It holds still under the pointer, shows its middle picture to
    /// readers who prefer reduced motion, and is dark on a dark screen.
    pub fn film(&self, seconds: f64) -> String {
        let count = self.shots.len();
        let pace = match brief(self.speed).as_str() {
            "1" => "in real time".to_owned(),
            speed => format!("{speed} × real time"),
        };
        let scenery = self.scenery();
        let empty = figure(NAME, HEIGHT, self.words(), |pen| {
            self.draw_shared(pen, &scenery, &pace)
        });
        let mut moving = format!(
            "<style>{}@media screen and (prefers-color-scheme:dark){{{}}}\
             @keyframes fig-{NAME}{{0%{{visibility:visible}}{}%{{visibility:hidden}}}}\
             .fig-{NAME}{{visibility:hidden;animation:fig-{NAME} {seconds}s step-end infinite}}\
             #fig-{NAME}-svg:hover .fig-{NAME}{{animation-play-state:paused}}\
             @media (prefers-reduced-motion:reduce){{{STILL}}}@media print{{{STILL}}}</style>\n",
            colours(Theme::Light),
            colours(Theme::Dark),
            short(100.0 / count as f64, 9)
        );
        for (k, shot) in self.shots.iter().enumerate() {
            let picture = figure(NAME, HEIGHT, self.words(), |pen| {
                self.draw(pen, &scenery, shot)
            });
            let middle = if k == count / 2 { " still" } else { "" };
            // To the microsecond, because otherwise a picture would vanish before the next one appears.
            let delay = short(seconds * k as f64 / count as f64, 6);
            let _ = writeln!(
                moving,
                "<g class=\"fig-{NAME}{middle}\" style=\"animation-delay:{delay}s\">{}</g>",
                picture.elements()
            );
        }
        let svg = empty.moving(&moving).svg();
        Role::ALL.iter().fold(svg, |svg, role| {
            let Some(variable) = variable(*role) else {
                return svg;
            };
            svg.replace(role.paint(), &format!("var({variable})"))
        })
    }
}

/// The variable of a page that has the colour of a role.
fn variable(role: Role) -> Option<&'static str> {
    let (variable, _) = role.paint().strip_prefix("var(")?.split_once(',')?;
    Some(variable)
}

/// The style of a film on such paper.
fn colours(theme: Theme) -> String {
    let variables = Role::ALL
        .iter()
        .filter_map(|&role| Some(format!("{}:{};", variable(role)?, theme.color(role))));
    let [paper, ink] = [Paper, Ink].map(|role| theme.color(role));
    let variables: String = variables.collect();
    format!("#fig-{NAME}-svg{{background:{paper};color:{ink};{variables}}}")
}

const NAME: &str = "film";
/// The style for readers who prefer reduced motion.
const STILL: &str = ".fig-film{animation:none}.fig-film.still{visibility:visible}";
