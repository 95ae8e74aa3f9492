//! Every figure draws, twice the same, and as committed, in the colours of the page around it or in plain ones.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::OnceLock;

use figures::canvas::Paint;
use figures::style::Anchor;
use figures::{Entry, Figure, Look, Mark, Values, all, compare};

/// All figures, drawn once for all tests of this file.
fn drawn() -> impl Iterator<Item = &'static (Entry, Figure)> {
    static DRAWN: OnceLock<Vec<(Entry, Figure)>> = OnceLock::new();
    let draw = |entry: &Entry| {
        let figure = entry
            .draw(&Values::default())
            .unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        (*entry, figure)
    };
    DRAWN
        .get_or_init(|| all().iter().map(draw).collect())
        .iter()
}

fn committed(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("svg")
        .join(format!("{name}.svg"))
}

/// Values of an attribute, in order of appearance.
fn values<'a>(svg: &'a str, key: &str) -> Vec<&'a str> {
    let opening = format!(" {key}=\"");
    svg.split(&opening)
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect()
}

#[test]
fn drawing_twice_gives_the_same_bytes() {
    for (entry, first) in drawn() {
        let second = entry
            .draw(&Values::default())
            .expect("it drew a moment ago");
        assert_eq!(first.svg(), second.svg(), "{}", entry.name);
    }
}

/// `FIGURES=write cargo test -p figures` writes the files instead; look at them before you commit them.
#[test]
fn the_committed_files_are_what_the_code_draws() {
    let write = std::env::var_os("FIGURES").is_some_and(|v| v == "write");
    for (entry, figure) in drawn() {
        let path = committed(entry.name);
        if write {
            std::fs::write(&path, figure.file(Look::default()))
                .expect("figures/svg can be written");
        }
        let old = std::fs::read_to_string(&path).unwrap_or_default();
        if let Err(difference) = compare(entry.name, &old, &figure.file(Look::default())) {
            panic!("{difference}");
        }
    }
}

#[test]
fn no_file_without_a_figure() {
    let names: HashSet<&str> = all().iter().map(|entry| entry.name).collect();
    let files =
        std::fs::read_dir(committed("x").parent().expect("a folder")).expect("figures/svg exists");
    for file in files {
        let file = file.expect("a directory entry").path();
        let name = file
            .file_stem()
            .and_then(|s| s.to_str())
            .unwrap_or_default();
        assert!(names.contains(name), "no figure is called {name}");
    }
}

#[test]
fn names_are_unique_and_kebab_case() {
    let mut seen = HashSet::new();
    for entry in all() {
        assert!(
            seen.insert(entry.name),
            "two figures are called {}",
            entry.name
        );
        let kebab = entry.name.split('-').all(|word| {
            !word.is_empty()
                && word
                    .chars()
                    .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit())
        });
        assert!(kebab, "{} is not kebab-case", entry.name);
    }
}

#[test]
fn captions_and_alt_texts_say_something() {
    for (entry, figure) in drawn() {
        let name = entry.name;
        assert!(
            figure.alt.chars().count() >= 40,
            "{name}: alt text of {} characters",
            figure.alt.chars().count()
        );
        assert!(!figure.alt.contains('$'), "{name}: alt text is plain text");
        let sentence = figure
            .claim
            .starts_with(|c: char| c.is_uppercase() || c.is_ascii_digit())
            && figure.claim.ends_with('.')
            && figure.claim.split_whitespace().count() >= 5;
        assert!(
            sentence,
            "{name}: the claim is no sentence: {}",
            figure.claim
        );
        assert!(
            !figure.claim.contains('$'),
            "{name}: the claim is plain text"
        );
        assert_eq!(
            figure.details.matches('$').count() % 2,
            0,
            "{name}: a formula is left open"
        );
        assert!(
            figure.details.contains(|c: char| c.is_ascii_digit()),
            "{name}: the caption has no number"
        );
    }
}

#[test]
fn no_text_is_below_thirteen_units() {
    for (entry, figure) in drawn() {
        let svg = figure.svg();
        let sizes = values(&svg, "font-size");
        assert!(!sizes.is_empty(), "{}: no text at all", entry.name);
        for size in sizes {
            let units = size.parse::<f64>().expect("a number") / figures::style::SCALE;
            assert!(
                units >= figures::style::LEAST,
                "{}: text of {units} units",
                entry.name
            );
        }
    }
}

#[test]
fn the_page_decides_colours_and_background() {
    for (entry, figure) in drawn() {
        let (name, svg) = (entry.name, &figure.svg());
        let head = svg.lines().next().unwrap_or_default();
        assert!(
            !svg.contains("#000000"),
            "{name}: black does not turn with the theme"
        );
        assert!(!svg.contains("<rect"), "{name}: a background or a box");
        for forbidden in [" width=\"", " height=\""] {
            assert!(!head.contains(forbidden), "{name}: a fixed size");
        }
        for needed in [
            "viewBox=\"0 0 6000 ",
            "role=\"img\"",
            "aria-label=\"",
            "class=\"fig\"",
        ] {
            assert!(head.contains(needed), "{name}: no {needed} in {head}");
        }
        for outside in ["href", "://", "@import", "<image", "<script"] {
            let inside = svg.replace("http://www.w3.org/2000/svg", "");
            assert!(
                !inside.contains(outside),
                "{name}: reaches out by {outside}"
            );
        }
        for id in values(svg, "id") {
            assert!(
                id.starts_with(&format!("fig-{name}-")),
                "{name}: the id {id} lacks its prefix"
            );
        }
        // Colours come only as fallbacks of the page's variables.
        for key in ["fill", "stroke"] {
            for paint in values(svg, key) {
                let by_role = ["none", "currentColor"].contains(&paint)
                    || paint.starts_with("var(--")
                    || paint.starts_with("url(#fig-");
                assert!(by_role, "{name}: a colour without a role: {paint}");
            }
        }
        assert!(
            !svg.contains("\n\n"),
            "{name}: a blank line ends an HTML block in Markdown"
        );
    }
}

#[test]
fn a_file_has_plain_colours() {
    for (entry, figure) in drawn() {
        let (name, svg) = (entry.name, figure.file(Look::default()));
        for key in ["fill", "stroke", "stop-color"] {
            for paint in values(&svg, key) {
                let plain = paint.len() == 7 && paint.starts_with('#');
                let plain = plain || paint == "none" || paint.starts_with("url(#fig-");
                assert!(plain, "{name}: {key} is {paint}");
            }
        }
        for word in ["var(", "calc(", "currentColor", "Canvas"] {
            let at = svg.find(word).map(|at| &svg[at..svg.len().min(at + 60)]);
            assert_eq!(at, None, "{name} needs a browser");
        }
    }
}

/// librsvg knows no variables: what was drawn in them was left out, or black.
#[test]
fn another_renderer_shows_the_colours() {
    let there = std::process::Command::new("rsvg-convert")
        .arg("--version")
        .output();
    if there.is_err() {
        return;
    }
    for (name, least) in [("polhodes", 5000), ("nutations", 500)] {
        let picture = std::process::Command::new("rsvg-convert")
            .args(["--width=600", "--background-color=white"])
            .arg(committed(name))
            .output()
            .expect("it ran a moment ago");
        let mut decoder = png::Decoder::new(std::io::Cursor::new(picture.stdout));
        decoder.set_transformations(png::Transformations::STRIP_16);
        let mut reader = decoder.read_info().expect("a picture");
        let mut bytes = vec![0; reader.output_buffer_size().expect("a small picture")];
        let info = reader.next_frame(&mut bytes).expect("a frame");
        // Ink and its shades are nearly grey.
        let coloured = bytes[..info.buffer_size()]
            .chunks(info.color_type.samples())
            .filter(|dot| {
                dot[..3].iter().max().expect("three") - dot[..3].iter().min().expect("three") > 60
            })
            .count();
        assert!(coloured >= least, "{name}: {coloured} coloured dots");
    }
}

/// The backend moves points outside to the edge: a curve that reaches the edge was cut.
#[test]
fn curves_keep_off_the_edge() {
    for (entry, figure) in drawn() {
        let size = size(&figure.svg());
        for points in values(&figure.svg(), "points") {
            for (k, n) in points
                .split([' ', ','])
                .filter(|n| !n.is_empty())
                .enumerate()
            {
                let n: i64 = n.parse().expect("canvas coordinates are whole numbers");
                let inside = 20..=size[k % 2] - 20;
                assert!(
                    inside.contains(&n),
                    "{}: {n} of {}",
                    entry.name,
                    size[k % 2]
                );
            }
        }
    }
}

/// A sans-serif letter is 0.55 of its size wide on average, even in a wide face.
#[test]
fn texts_fit_on_the_canvas() {
    for (entry, figure) in drawn() {
        let width = size(&figure.svg())[0] as f64;
        for element in figure.svg().split("<text").skip(1) {
            let element = element.split("</text>").next().unwrap_or_default();
            assert!(
                !element.contains(['{', '}', '^', '*', '$']),
                "{}: a sign of the notation is printed: {element}",
                entry.name
            );
            let number = |key: &str| values(element, key)[0].parse::<f64>().expect("a number");
            let letters: usize = element
                .split('<')
                .map(|piece| piece.rsplit('>').next().unwrap_or_default().chars().count())
                .sum();
            let length = 0.55 * number("font-size") * letters as f64;
            let left = number("x")
                - match values(element, "text-anchor").first() {
                    Some(&"middle") => 0.5 * length,
                    Some(&"end") => length,
                    _ => 0.0,
                };
            assert!(
                left > -20.0 && left + length < width + 20.0,
                "{}: a text runs off: {element}",
                entry.name
            );
        }
    }
}

/// The marks through the drawing area and the elements of plotters.
fn by_plotters(figure: &Figure) -> String {
    use plotters::prelude::*;
    use plotters::style::text_anchor::{HPos, Pos, VPos};
    let mut raw = String::new();
    {
        let [width, height] = figure.size();
        let area = SVGBackend::with_string(&mut raw, (width, height)).into_drawing_area();
        let color = |paint: &Paint| {
            let (red, green, blue) = paint.role.stand_in();
            RGBColor(red, green, blue).mix(paint.alpha)
        };
        for mark in figure.marks() {
            let drawn = match mark {
                Mark::Path(points, paint) => {
                    let style = color(paint).stroke_width(paint.width);
                    area.draw(&PathElement::new(points.clone(), style))
                }
                Mark::Polygon(points, paint) => {
                    area.draw(&Polygon::new(points.clone(), color(paint).filled()))
                }
                Mark::Circle {
                    center,
                    radius,
                    paint,
                    filled,
                } => {
                    let mut style = color(paint).stroke_width(paint.width);
                    style.filled = *filled;
                    area.draw(&Circle::new(*center, *radius as i32, style))
                }
                Mark::Text {
                    at,
                    anchor,
                    body,
                    paint,
                    size,
                } => {
                    let horizontal = match anchor {
                        Anchor::Start => HPos::Left,
                        Anchor::Middle => HPos::Center,
                        Anchor::End => HPos::Right,
                    };
                    let color = color(paint);
                    let style = ("sans-serif", *size).into_text_style(&area).color(&color);
                    let style = style.pos(Pos::new(horizontal, VPos::Bottom));
                    area.draw(&Text::new(body.clone(), *at, style))
                }
            };
            drawn.expect("a string takes every letter");
        }
        area.present().expect("a string takes every letter");
    }
    raw
}

/// The pen calls the backend of plotters itself; plotters whole draws the same.
#[test]
fn plotters_draws_the_same_picture() {
    for (entry, figure) in drawn() {
        let mut raw = String::new();
        {
            let [width, height] = figure.size();
            let mut backend = plotters_svg::SVGBackend::with_string(&mut raw, (width, height));
            figure
                .draw(&mut backend)
                .expect("a string takes every letter");
        }
        assert_eq!(raw, by_plotters(figure), "{}", entry.name);
    }
}

/// Width and height of the canvas.
fn size(svg: &str) -> [i64; 2] {
    let view: Vec<i64> = values(svg, "viewBox")[0]
        .split(' ')
        .map(|n| n.parse().expect("a number"))
        .collect();
    [view[2], view[3]]
}

#[test]
fn the_comparison_allows_one_unit_of_a_coordinate_and_nothing_else() {
    let old = "<polyline points=\"10,20 30,40\" stroke-width=\"20\"/><text x=\"5\">*I* = 10</text>";
    assert_eq!(compare("a", old, old), Ok(()));
    assert_eq!(compare("a", old, &old.replace("30,40", "31,39")), Ok(()));
    let told = compare("a", old, &old.replace("30,40", "32,40")).expect_err("two units");
    assert!(told.starts_with("figure a: token"), "{told}");
    assert!(
        told.contains("`30` in the committed file and `32` when drawn"),
        "{told}"
    );
    // A label, a width, one more point.
    for (right, wrong) in [
        ("= 10", "= 11"),
        ("\"20\"", "\"21\""),
        ("30,40", "30,40 50,60"),
    ] {
        assert!(
            compare("a", old, &old.replace(right, wrong)).is_err(),
            "{wrong}"
        );
    }
    assert!(compare("a", old, "").is_err(), "a missing file");
}
