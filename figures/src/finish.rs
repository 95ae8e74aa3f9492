//! Turns the backend's SVG into the finished one: roles become variables of the page, mathematics becomes `tspan`s.

use std::fmt::{Display, Write as _};

use plotters_svg::SVGBackend;

use crate::canvas::{self, Anchor, Mark};
use crate::figure::Figure;
use crate::style::{self, LEAST, Role, SCALE};

/// The look of a file that is viewed on its own.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Look {
    /// Its colours.
    pub theme: Theme,
    /// Whether there is no paper behind the drawing.
    pub transparent: bool,
}

/// Colours for light paper or dark.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Theme {
    /// Ink on white.
    #[default]
    Light,
    /// Chalk on slate.
    Dark,
}

impl Theme {
    /// The colour of a role; of [`Role::Shade`], that of its gradient.
    pub const fn color(self, role: Role) -> &'static str {
        let [light, dark] = match role {
            Role::Ink | Role::Shade => ["#1c1e2a", "#c8c9db"],
            Role::Muted => ["#61667a", "#8f93a8"],
            Role::Omega => ["#0b6bcb", "#5aa9ff"],
            Role::AngularMomentum => ["#b85300", "#ff9440"],
            Role::Torque => ["#6b1a6b", "#c064b4"],
            Role::Paper => ["#ffffff", "#161923"],
        };
        match self {
            Self::Light => light,
            Self::Dark => dark,
        }
    }
}

impl Figure {
    /// The picture, a complete SVG document whose colours are variables of the page around it.
    pub fn svg(&self) -> String {
        // An element for each mark.
        let mut raw = String::new();
        let mut backend = SVGBackend::with_string(&mut raw, self.size.into());
        canvas::draw(self.marks(), &mut backend).expect("a string takes every letter");
        drop(backend);
        let (name, [width, height]) = (self.name, self.size);
        let mut svg = String::with_capacity(raw.len());
        let _ = writeln!(
            svg,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" id=\"fig-{name}-svg\" viewBox=\"0 0 {width} {height}\" role=\"img\" \
         aria-label=\"{}\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" \
         font-family=\"var(--figure-font, 'Latin Modern Roman', 'CMU Serif', 'Times New Roman', serif)\">",
            escaped(&self.alt)
        );
        let _ = writeln!(svg, "<title>{}</title>", escaped(&self.claim));
        if self.marks().any(|mark| mark.paint().role == Role::Shade) {
            let _ = writeln!(
                svg,
                "<defs><radialGradient id=\"fig-{name}-shade\" cx=\"50%\" cy=\"50%\" r=\"50%\" fx=\"34%\" fy=\"28%\">\
             <stop offset=\"0%\" stop-color=\"currentColor\" stop-opacity=\"var(--lit, 0.02)\"/>\
             <stop offset=\"62%\" stop-color=\"currentColor\" stop-opacity=\"0.13\"/>\
             <stop offset=\"100%\" stop-color=\"currentColor\" stop-opacity=\"var(--rim, 0.3)\"/>\
             </radialGradient></defs>"
            );
        }
        let mut lines = raw.lines().skip(1);
        for (mark, extra) in &self.marks {
            let line = lines.next().unwrap_or_default();
            let role = mark.paint().role;
            let paint = match role {
                Role::Shade => format!("url(#fig-{name}-shade)"),
                _ => role.paint().to_owned(),
            };
            let Mark::Text {
                at: (x, y),
                anchor,
                size,
                ..
            } = mark
            else {
                let tag = shape(&line.replace(&stand_in(role), &paint));
                let _ = writeln!(svg, "{tag}{extra}/>");
                continue;
            };
            // Its letters, escaped, and its end.
            let letters = lines.next().unwrap_or_default();
            lines.next();
            let anchor = match anchor {
                Anchor::Start => "",
                Anchor::Middle => " text-anchor=\"middle\"",
                Anchor::End => " text-anchor=\"end\"",
            };
            let letters = rich(letters, *size);
            let _ = writeln!(
                svg,
                "<text x=\"{x}\" y=\"{y}\"{anchor} fill=\"{paint}\"{extra}>{letters}</text>"
            );
        }
        svg.push_str(&self.moving);
        svg.push_str("</svg>\n");
        svg
    }

    /// What was drawn, without the document around it.
    pub(crate) fn elements(&self) -> String {
        let svg = self.svg();
        let (_, inside) = svg.split_once("</title>\n").unwrap_or_default();
        inside.trim_end().trim_end_matches("</svg>").to_owned()
    }

    /// The picture as a file for any program: variables of the page replaced by the colours of the look, or by what they fall back on.
    pub fn file(&self, look: Look) -> String {
        let svg = Role::ALL.iter().fold(self.svg(), |svg, &role| {
            svg.replace(role.paint(), look.theme.color(role))
        });
        // In the dark a ball is light where the light falls.
        let svg = match look.theme {
            Theme::Light => svg,
            Theme::Dark => svg
                .replace("lit, 0.02", "lit, 0.3")
                .replace("rim, 0.3", "rim, 0.04"),
        };
        let mut parts = svg.split("var(--");
        let mut out = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (value, after) = part.split_once(')').unwrap_or((part, ""));
            let fallback = value.split_once(',').map_or("", |(_, fallback)| fallback);
            out.push_str(fallback.trim_start());
            out.push_str(after);
        }
        // A stroke has as many units in the file as it has pixels on the page.
        let mut parts = out.split("style=\"stroke-width:calc(");
        let mut lines = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (pixels, after) = part.split_once("px*1)\"").unwrap_or(("1", part));
            let units = SCALE * pixels.parse().unwrap_or(1.0);
            let _ = write!(lines, "stroke-width=\"{units:.0}\"");
            lines.push_str(after.trim_start_matches(" vector-effect=\"non-scaling-stroke\""));
        }
        let (head, body) = lines.split_once("</title>\n").unwrap_or(("", &lines));
        let paper = look.theme.color(Role::Paper);
        let paper = format!("<style>svg:root{{background:{paper}}}</style>\n");
        let paper = if look.transparent { "" } else { &paper };
        format!("{head}</title>\n{paper}{body}")
    }
}

fn stand_in(role: Role) -> String {
    let (red, green, blue) = role.stand_in();
    format!("#{red:02X}{green:02X}{blue:02X}")
}

/// The tag of a line, a polygon or a circle without what it need not say, to be closed.
fn shape(tag: &str) -> String {
    let tag = tag
        .replace(" opacity=\"1\"", "")
        .replace(" fill=\"none\"", "")
        .replace(" stroke=\"none\"", "")
        .replace(" \"/>", "\"/>");
    let tag = tag.trim_end_matches("/>");
    // A filled circle carries a width for the stroke it does not have.
    match tag.contains(" stroke=\"") {
        true => tag.to_owned(),
        false => tag.replace(" stroke-width=\"1\"", ""),
    }
}

/// Converts `*x*` to an italic letter, `_{…}` to an index and `^{…}` to a power, in a text of `size` canvas units.
fn rich(body: &str, size: f64) -> String {
    let small = (0.76 * size).max(LEAST * SCALE);
    let mut out = String::new();
    let mut italic = false;
    // A prime is not raised: its glyph is already as high as a power.
    let body = body.replace('\u{2032}', "^{\u{2032}}");
    let mut rest = body.as_str();
    // Base line offset of the piece before, canvas units; a `tspan` shifts all that follows it.
    let mut offset = 0.0;
    while !rest.is_empty() {
        if let Some(after) = rest.strip_prefix('*') {
            (italic, rest) = (!italic, after);
            continue;
        }
        let marks = ["_{", "^{", "*"].map(|mark| rest.find(mark));
        let level = match marks {
            [Some(0), ..] => 0.24 * size,
            [_, Some(0), _] => -0.36 * size,
            _ => 0.0,
        };
        let (piece, next) = match level {
            0.0 => rest.split_at(marks.into_iter().flatten().min().unwrap_or(rest.len())),
            _ => rest[2..].split_once('}').unwrap_or((&rest[2..], "")),
        };
        // A letter inside an index may be italic as well.
        let slanted = italic || (piece.starts_with('*') && piece.ends_with('*'));
        let piece = piece.trim_matches('*');
        if level == 0.0 && offset == 0.0 && !slanted {
            out.push_str(piece);
        } else {
            let _ = write!(out, "<tspan");
            if level != offset {
                let _ = write!(out, " dy=\"{:.0}\"", level - offset);
            }
            if level != 0.0 {
                let _ = write!(out, " font-size=\"{small:.0}\"");
            }
            if slanted {
                let _ = write!(
                    out,
                    " font-style=\"italic\" font-family=\"var(--figure-math, 'Latin Modern Roman', 'CMU Serif', 'Times New Roman', serif)\""
                );
            }
            let _ = write!(out, ">{piece}</tspan>");
        }
        offset = level;
        rest = next;
    }
    out
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// The transforms of what moves in a film, each at its share of the round in percent.
pub fn keyframes(name: &str, frames: impl Iterator<Item = (String, impl Display)>) -> String {
    let frame = |(percent, moved)| format!("{percent}%{{transform:{moved}}}");
    let frames: String = frames.map(frame).collect();
    format!("@keyframes {name}{{{frames}}}")
}

/// The end of a film's style sheet: the motion stops under the pointer, for readers who prefer reduced motion, and on paper.
pub fn stops(name: &str, moving: &str) -> String {
    format!(
        "#fig-{name}-svg:hover :is({moving}){{animation-play-state:paused}}\
         @media (prefers-reduced-motion:reduce){{{moving}{{animation:none}}}}@media print{{{moving}{{animation:none}}}}</style>\n"
    )
}

/// A number without trailing zeros, and with the minus of a style sheet.
pub fn short(value: f64, digits: usize) -> String {
    style::short(value, digits).replace('\u{2212}', "-")
}
