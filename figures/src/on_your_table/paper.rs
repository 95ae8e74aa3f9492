//! Strips and a cat of paper, at true size. Lengths in millimetres where they are drawn.

use std::fmt::Write as _;

use spinning_bodies::falling_strip::{Coefficients, Fall, LongRun, Regime, Sheet, Start};
use spinning_bodies::frame::BodyVector;
use spinning_bodies::inertia::{MassProperties, shapes};
use spinning_bodies::phenomena::PaperCat;
use spinning_bodies::scene::effects::{Air, Gravity};
use spinning_bodies::scene::shape;

use crate::prelude::*;

/// Mass of office paper, kg/m².
const OFFICE: f64 = 0.08;
const AIR: f64 = 1.2;
const GRAVITY: f64 = 9.81;

/// Widths of the strips and their common length, mm.
const WIDTHS: [f64; 4] = [10.0, 20.0, 30.0, 50.0];
const LENGTH: f64 = 180.0;

/// The cat: its back, one of its four legs, its head and its tail, along the cat and across it, mm.
const BACK: Point = [90.0, 50.0];
const LEG: Point = [15.0, 35.0];
const HEAD: Point = [22.0, 22.0];
const TAIL: Point = [36.0, 6.0];

/// A size of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// 210 mm by 297 mm.
    A4,
    /// 8.5 inches by 11.
    Letter,
}

impl Paper {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::A4, Self::Letter];

    /// As it stands in the names of files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::A4 => "a4",
            Self::Letter => "letter",
        }
    }

    /// Width and height, mm.
    pub const fn size(self) -> [f64; 2] {
        match self {
            Self::A4 => [210.0, 297.0],
            Self::Letter => [215.9, 279.4],
        }
    }
}

/// A page in millimetres.
struct Page {
    svg: String,
    size: Point,
}

impl Page {
    fn new(paper: Paper, title: &str) -> Self {
        let [width, height] = paper.size();
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" \
             fill=\"none\" stroke=\"#000000\" stroke-width=\"0.25\" font-family=\"serif\">\n<title>{title}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\" stroke=\"none\"/>\n"
        );
        // A page of its own size, without the margins of a browser.
        svg += &format!("<style>@page{{size:{width}mm {height}mm;margin:0}}</style>\n");
        let size = [width, height];
        let mut page = Self { svg, size };
        page.text([18.0, 20.0], 6.0, title);
        page
    }

    /// A closed line to cut along.
    fn cut(&mut self, corners: &[Point]) {
        let _ = writeln!(self.svg, "<polygon points=\"{}\"/>", listed(corners));
    }

    /// A line to fold along.
    fn fold(&mut self, ends: [Point; 2]) {
        let points = listed(&ends);
        let _ = writeln!(
            self.svg,
            "<polyline points=\"{points}\" stroke-dasharray=\"2 1.5\"/>"
        );
    }

    fn text(&mut self, [x, y]: Point, size: f64, text: &str) {
        let _ = writeln!(
            self.svg,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"#000000\" stroke=\"none\">{text}</text>"
        );
    }

    /// Paragraphs below each other.
    fn prose(&mut self, [x, mut y]: Point, paragraphs: &[String]) {
        for paragraph in paragraphs {
            for line in wrapped(paragraph, 82) {
                self.text([x, y], 4.0, &line);
                y += 5.4;
            }
            y += 2.6;
        }
    }

    /// The document, with a ruler at the foot of the page.
    fn finished(mut self) -> String {
        let [left, y] = [18.0, self.size[1] - 18.0];
        let mut ruler = vec![[left, y], [left + 100.0, y]];
        for k in 0..=10 {
            let x = left + 100.0 - 10.0 * f64::from(k);
            let up = if k % 5 == 0 { 5.0 } else { 3.0 };
            ruler.extend([[x, y], [x, y - up], [x, y]]);
        }
        let _ = writeln!(self.svg, "<polyline points=\"{}\"/>", listed(&ruler));
        self.text([left + 104.0, y], 3.6, "100 mm, or print without scaling");
        self.svg + "</svg>\n"
    }
}

fn listed(points: &[Point]) -> String {
    let points = points.iter().map(|[x, y]| format!("{x},{y}"));
    points.collect::<Vec<_>>().join(" ")
}

/// The long-term motion of a strip of office paper of this width (m), and its unit of time, s.
fn fallen(width: f64) -> Result<(LongRun, f64)> {
    let sheet = Sheet::new(width, OFFICE, AIR, GRAVITY)?;
    let fall = Fall::new(sheet.mass_ratio(), Coefficients::PAPER)?;
    Ok((fall.long_run(Start::TILTED, 300.0, 300.0)?, sheet.time()))
}

/// Strips to let fall.
pub fn strips(paper: Paper) -> Result<String> {
    let mut page = Page::new(paper, "Strips to let fall");
    let told = "Office paper of 80 g/m². Cut along the lines. Hold a strip level by the middle of its long edge, above your head, \
                and let go with a twist of the fingers about its long axis.";
    page.prose([18.0, 29.0], &[told.to_owned()]);
    let mut top = 48.0;
    for width in WIDTHS {
        let (run, time) = fallen(1e-3 * width)?;
        let right = 18.0 + LENGTH;
        let bottom = top + width;
        page.cut(&boxed([18.0, top], [right, bottom]));
        let told = format!(
            "{width} mm: {} turns a second, a path {}° below level, {} m to the side for each metre down",
            number(run.rotation.abs() / time / TAU, 1),
            number(run.glide_angle().to_degrees(), 0),
            number((run.drift / run.descent).abs(), 2),
        );
        page.text([23.0, 0.5 * (top + bottom) + 1.3], 3.6, &told);
        top = bottom + 6.0;
    }
    let width = paper.size()[0];
    let (whole, _) = fallen(1e-3 * width)?;
    let does = match whole.regime {
        Regime::Flutter => "swings to and fro and does not turn over",
        _ => "turns over as well",
    };
    let told = [
        format!("And a whole sheet, {width} mm wide, dropped flat: it {does}."),
        "Computed for strips without ends, in still air, by a model whose coefficients were fitted to strips of paper: expect the size, \
         not the second digit. Short strips turn more slowly, for air goes round their ends; a curled or creased one does what it likes. Film them: a \
         telephone counts turns better than an eye."
            .to_owned(),
    ];
    page.prose([18.0, top + 8.0], &told);
    Ok(page.finished())
}

/// The cat that the sheet becomes.
fn folded() -> Result<PaperCat> {
    // Along the cat, across it, upward from its back.
    let part = |[along, across]: Point, [x, y]: Point| {
        let mass = OFFICE * 1e-6 * along * across;
        let lamina = shapes::rectangle_lamina(mass, [1e-3 * along, 1e-3 * across])?;
        lamina.moved(BodyVector::new(1e-3 * x, 1e-3 * y, 0.0))
    };
    let mut parts = vec![
        part(BACK, [0.0; 2])?,
        part(HEAD, [0.5 * (BACK[0] + HEAD[0]), 0.0])?,
        part(TAIL, [-0.5 * (BACK[0] + TAIL[0]), 0.0])?,
    ];
    let area = parts.iter().map(MassProperties::mass).sum::<f64>() / OFFICE;
    let leg = OFFICE * 1e-6 * LEG[0] * LEG[1];
    for [side, end] in [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]] {
        let hanging = shapes::cuboid(leg, [1e-3 * LEG[0], 0.0, 1e-3 * LEG[1]])?;
        let [x, y] = [0.5 * end * (BACK[0] - LEG[0]), 0.5 * side * BACK[1]];
        parts.push(hanging.moved(BodyVector::new(1e-3 * x, 1e-3 * y, -0.5e-3 * LEG[1]))?);
    }
    let cat = MassProperties::compose(&parts)?;
    let about = cat.inertia().moment_about(BodyVector::new(1.0, 0.0, 0.0))?;
    Ok(PaperCat {
        mass: cat.mass(),
        area,
        lever: -cat.center().z(),
        gyration: (about / cat.mass()).sqrt(),
        ..PaperCat::POSTCARD
    })
}

/// The cat, unfolded.
pub fn cat(paper: Paper) -> Result<String> {
    let cat = folded()?;
    let mut page = Page::new(paper, "A cat of paper");
    let middle = [0.5 * paper.size()[0], 100.0];
    let at = |x: f64, y: f64| [middle[0] + x, middle[1] + y];
    let [half, side] = [0.5 * BACK[0], 0.5 * BACK[1]];
    let [foot, paw, nose] = [side + LEG[1], half - LEG[0], half + HEAD[0]];
    let (chin, tip, hair) = (0.5 * HEAD[1], half + TAIL[0], 0.5 * TAIL[1]);
    // From the nose once around; the lower half is the mirror image of the upper one.
    let upper = [
        [nose, chin],
        [half, chin],
        [half, foot],
        [paw, foot],
        [paw, side],
        [-paw, side],
        [-paw, foot],
        [-half, foot],
        [-half, hair],
        [-tip, hair],
    ];
    let outline = upper.iter().map(|&[x, y]| at(x, y));
    let mirrored = upper.iter().rev().map(|&[x, y]| at(x, -y));
    page.cut(&outline.chain(mirrored).collect::<Vec<_>>());
    for y in [-side, side] {
        for ends in [[-half, -paw], [paw, half]] {
            page.fold(ends.map(|x| at(x, y)));
        }
    }
    let told = wrapped("Fold the four legs away from you, by a right angle.", 28);
    for (k, line) in told.iter().enumerate() {
        page.text(at(-26.0, -5.0 + 5.4 * k as f64), 4.0, line);
    }
    page.text(at(half + 3.0, 1.4), 4.0, "head");
    let righted = |error: f64| -> Result<String> {
        let scene = shape::PaperCat::new(cat, PI - error.to_radians())?;
        let scene = scene.with(Air::new(AIR)?)?.with(Gravity::new(GRAVITY)?)?;
        let found = scene.rights_itself(30.0)?;
        Ok(found.map_or("no fall that we computed".to_owned(), |r| {
            format!("{} m", number(r.fall, 2))
        }))
    };
    let told = [
        "Office paper of 80 g/m². Cut along the outline, fold along the dashed lines. Hold the cat by its feet, back down, as level as \
         you can, and let go."
            .to_owned(),
        format!(
            "It weighs {} g and bears on the air with {} cm²; its centre of mass lies {} mm below its back. Ten degrees off upside down, its feet \
             point down after a fall of {}; one degree off, after {}. In the end it falls at {} m/s, and each tenfold gain in your aim costs {} m more.",
            number(1e3 * cat.mass, 2),
            number(1e4 * cat.area, 0),
            number(1e3 * cat.lever, 1),
            righted(10.0)?,
            righted(1.0)?,
            number(cat.terminal_speed(AIR, GRAVITY), 2),
            number(cat.fall_per_decade(AIR, GRAVITY), 2)
        ),
        "Computed for one tilt, about the long axis, with the air pushing at the middle of the back: it does not know that paper bends, nor of \
         pitch, nor of the air at the legs. A cat whose legs differ spins as it falls."
            .to_owned(),
    ];
    page.prose([18.0, 176.0], &told);
    Ok(page.finished())
}
