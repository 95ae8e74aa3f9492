//! From the backend's SVG to the finished one: roles to variables of the page, mathematics to `tspan`s.

use std::fmt::Write as _;

use crate::Figure;
use crate::style::{LEAST, Role, SCALE};

/// Ink and paper of a file that is looked at by itself, and the page of a browser behind it, which may be dark.
const INK: &str = "#1c1e2a";
const PAPER: &str = "#ffffff";
const ALONE: &str = "<style>svg:root{background:#ffffff}</style>\n";

/// The finished document.
///
/// `raw` is the backend's output and `extras` holds, an entry a drawn element, the attributes the backend
/// cannot write.
pub fn finish(name: &str, claim: &str, alt: &str, raw: &str, extras: &[String]) -> String {
    let mut lines = raw.lines();
    let view_box = lines
        .next()
        .and_then(|head| attribute(head, "viewBox"))
        .unwrap_or_default();
    let mut svg = String::with_capacity(raw.len());
    let _ = writeln!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" id=\"fig-{name}-svg\" viewBox=\"{view_box}\" role=\"img\" \
         aria-label=\"{}\" fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" \
         font-family=\"var(--figure-font, 'Open Sans', 'Helvetica Neue', Arial, sans-serif)\">",
        escaped(alt)
    );
    let _ = writeln!(svg, "<title>{}</title>", escaped(claim));
    if raw.contains(&stand_in(Role::Shade)) {
        let _ = writeln!(
            svg,
            "<defs><radialGradient id=\"fig-{name}-shade\" cx=\"50%\" cy=\"50%\" r=\"50%\" fx=\"34%\" fy=\"28%\">\
             <stop offset=\"0%\" stop-color=\"currentColor\" stop-opacity=\"0.02\"/>\
             <stop offset=\"62%\" stop-color=\"currentColor\" stop-opacity=\"0.13\"/>\
             <stop offset=\"100%\" stop-color=\"currentColor\" stop-opacity=\"0.3\"/>\
             </radialGradient></defs>"
        );
    }
    let mut extras = extras.iter();
    while let Some(line) = lines.next() {
        if line.starts_with("</") {
            continue;
        }
        let extra = extras.next().map_or("", String::as_str);
        if line.starts_with("<text") {
            let body = lines.next().unwrap_or_default();
            text_element(&mut svg, name, line, body, extra);
        } else {
            shape_element(&mut svg, name, line, extra);
        }
    }
    svg.push_str("</svg>\n");
    svg
}

/// The figure as a file for any program: variables of the page replaced by what they fall back on, so that every colour is a plain one.
pub fn plain(svg: &str) -> String {
    const VARIABLE: &str = "var(--";
    let svg = svg
        .replace("currentColor", INK)
        .replace("var(--bg, Canvas)", PAPER);
    let mut parts = svg.split(VARIABLE);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (value, after) = part.split_once(')').unwrap_or((part, ""));
        let fallback = value.split_once(',').map_or("", |(_, fallback)| fallback);
        out.push_str(fallback.trim_start());
        out.push_str(after);
    }
    // A stroke of so many pixels on the page is one of so many units in the file.
    let mut parts = out.split("style=\"stroke-width:calc(");
    let mut lines = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (pixels, after) = part.split_once("px*1)\"").unwrap_or(("1", part));
        let units = SCALE * pixels.parse().unwrap_or(1.0);
        let _ = write!(lines, "stroke-width=\"{units:.0}\"");
        lines.push_str(after.trim_start_matches(" vector-effect=\"non-scaling-stroke\""));
    }
    let (head, body) = lines.split_once("</title>\n").unwrap_or(("", &lines));
    format!("{head}</title>\n{ALONE}{body}")
}

/// The figure with more elements on top of what was drawn: for what moves.
pub fn with(mut figure: Figure, elements: &str) -> Figure {
    let end = figure.svg.rfind("</svg>").unwrap_or(figure.svg.len());
    figure.svg.insert_str(end, elements);
    figure
}

fn stand_in(role: Role) -> String {
    let color = role.stand_in();
    format!("#{:02X}{:02X}{:02X}", color.0, color.1, color.2)
}

/// Stand-in colours replaced by the paint of their role.
fn painted(name: &str, tag: &str) -> String {
    Role::ALL.iter().fold(tag.to_owned(), |tag, role| {
        tag.replace(&stand_in(*role), &role.paint(name))
    })
}

fn shape_element(svg: &mut String, name: &str, line: &str, extra: &str) {
    let tag = painted(name, line)
        .replace(" opacity=\"1\"", "")
        .replace(" fill=\"none\"", "")
        .replace(" stroke=\"none\"", "")
        .replace(" \"/>", "\"/>");
    // A filled circle carries a width for the stroke it does not have.
    let tag = match (tag.contains(" stroke=\""), tag.find(" stroke-width=\"")) {
        (false, Some(start)) => {
            let end = tag[start + 15..]
                .find('"')
                .map_or(tag.len(), |k| start + 16 + k);
            format!("{}{}", &tag[..start], &tag[end..])
        }
        _ => tag,
    };
    let _ = writeln!(svg, "{}{extra}/>", tag.trim_end_matches("/>"));
}

fn text_element(svg: &mut String, name: &str, line: &str, body: &str, extra: &str) {
    if body.is_empty() {
        return;
    }
    let _ = write!(svg, "<text");
    for key in ["x", "y", "text-anchor", "fill"] {
        if let Some(value) = attribute(line, key)
            && value != "start"
        {
            let _ = write!(svg, " {key}=\"{}\"", painted(name, value));
        }
    }
    let size = attribute(extra, "font-size")
        .and_then(|s| s.parse().ok())
        .unwrap_or(LEAST * SCALE);
    let _ = writeln!(svg, "{extra}>{}</text>", rich(body, size));
}

/// `*x*` to an italic letter, `_{…}` and `^{…}` to an index and a power, in a text of `size` canvas units.
fn rich(body: &str, size: f64) -> String {
    let small = (0.76 * size).max(LEAST * SCALE);
    let mut out = String::new();
    let mut italic = false;
    let mut rest = body;
    // Base line offset of the piece before, canvas units; a `tspan` shifts all that follows it.
    let mut offset = 0.0;
    while !rest.is_empty() {
        let (piece, level, next) = match rest.as_bytes() {
            [b'*', ..] => {
                italic = !italic;
                rest = &rest[1..];
                continue;
            }
            [b'_' | b'^', b'{', ..] => {
                let end = rest.find('}').unwrap_or(rest.len());
                let level = if rest.starts_with('_') {
                    0.24 * size
                } else {
                    -0.36 * size
                };
                (&rest[2..end], level, rest.get(end + 1..).unwrap_or(""))
            }
            _ => {
                let end = rest
                    .char_indices()
                    .skip(1)
                    .find(|(k, c)| {
                        *c == '*' || (matches!(c, '_' | '^') && rest[k + 1..].starts_with('{'))
                    })
                    .map_or(rest.len(), |(k, _)| k);
                (&rest[..end], 0.0, &rest[end..])
            }
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
                    " font-style=\"italic\" font-family=\"var(--figure-math, 'Times New Roman', serif)\""
                );
            }
            let _ = write!(out, ">{piece}</tspan>");
        }
        offset = level;
        rest = next;
    }
    out
}

/// Value of an attribute in a tag.
fn attribute<'a>(tag: &'a str, key: &str) -> Option<&'a str> {
    let start = tag.find(&format!(" {key}=\""))? + key.len() + 3;
    let length = tag[start..].find('"')?;
    Some(&tag[start..start + length])
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
