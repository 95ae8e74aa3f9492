//! Every figure draws, twice the same, and as committed, in the colours of the page around it or in plain ones.

use std::collections::HashSet;
use std::path::PathBuf;
use std::sync::LazyLock;

use figures::canvas::{Paint, draw};
use figures::style::{Anchor, LEAST, SCALE, SMALL};
use figures::{Entry, Figure, Look, Mark, Values, all, compare};
use plotters::prelude::SVGBackend;
use rayon::prelude::*;

/// All figures, drawn once for all tests of this file.
static DRAWN: LazyLock<Vec<(Entry, Figure)>> = LazyLock::new(|| {
    let draw = |entry: &Entry| {
        let figure = entry.draw(&Values::default());
        (
            *entry,
            figure.unwrap_or_else(|error| panic!("{}: {error}", entry.name)),
        )
    };
    all().par_iter().with_max_len(1).map(draw).collect()
});

/// Name, figure, and what is drawn.
fn drawn() -> impl Iterator<Item = (&'static str, &'static Figure, String)> {
    DRAWN
        .iter()
        .map(|(entry, figure)| (entry.name, figure, figure.svg()))
}

fn committed(name: &str) -> PathBuf {
    PathBuf::from(format!("svg/{name}.svg"))
}

/// Values of an attribute, in order of appearance.
fn values<'a>(svg: &'a str, key: &str) -> Vec<&'a str> {
    let pieces = svg.split(&format!(" {key}=\"")).skip(1).collect::<Vec<_>>();
    pieces
        .iter()
        .filter_map(|rest| rest.split('"').next())
        .collect()
}

#[test]
fn drawing_twice_gives_the_same_bytes() {
    DRAWN.par_iter().with_max_len(1).for_each(|(entry, first)| {
        let second = entry.draw(&Values::default()).expect("it drew before");
        assert_eq!(first.svg(), second.svg(), "{}", entry.name);
    });
}

/// `FIGURES=write cargo test -p figures` writes the files instead; look at them before you commit them.
#[test]
fn the_committed_files_are_what_the_code_draws() {
    let write = std::env::var_os("FIGURES").is_some_and(|v| v == "write");
    for (name, figure, _) in drawn() {
        let (path, new) = (committed(name), figure.file(Look::default()));
        if write {
            std::fs::write(&path, &new).expect("figures/svg can be written");
        }
        let old = std::fs::read_to_string(&path).unwrap_or_default();
        assert_eq!(compare(name, &old, &new), Ok(()));
    }
}

#[test]
fn no_file_without_a_figure() {
    let names: HashSet<&str> = all().iter().map(|entry| entry.name).collect();
    for file in std::fs::read_dir("svg").expect("figures/svg exists") {
        let file = file.expect("a directory entry").path();
        let name = file.file_stem().and_then(|name| name.to_str());
        assert!(names.contains(name.expect("a name")), "no figure: {name:?}");
    }
}

#[test]
fn names_are_unique_and_kebab_case() {
    let mut seen = HashSet::new();
    for entry in all() {
        let name = entry.name;
        assert!(seen.insert(name), "two figures are called {name}");
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit();
        let mut words = name.split('-');
        let kebab = words.all(|word| !word.is_empty() && word.chars().all(plain));
        assert!(kebab, "{name} is not kebab-case");
    }
}

#[test]
fn captions_and_alt_texts_say_something() {
    for (name, figure, _) in drawn() {
        let (claim, details, alt) = (&figure.claim, &figure.details, &figure.alt);
        let begins = claim.starts_with(|c: char| c.is_uppercase() || c.is_ascii_digit());
        let long = claim.split_whitespace().count() >= 5;
        for (right, what) in [
            (alt.chars().count() >= 40, "a longer alternative text"),
            (!alt.contains('$'), "an alternative text that is plain"),
            (
                begins && long && claim.ends_with('.'),
                "a claim that is a sentence",
            ),
            (!claim.contains('$'), "a claim that is plain text"),
            (details.matches('$').count() % 2 == 0, "a formula that ends"),
            (
                details.contains(|c: char| c.is_ascii_digit()),
                "a number in the caption",
            ),
        ] {
            assert!(right, "{name} lacks {what}");
        }
    }
}

#[test]
fn no_text_is_too_small() {
    for (name, _, svg) in drawn() {
        let sizes = |tag: &str| -> Vec<f64> {
            let heads = svg.split(tag).skip(1).filter_map(|x| x.split('>').next());
            let sizes = heads.flat_map(|head| values(head, "font-size"));
            sizes
                .map(|size| size.parse::<f64>().expect("a number") / SCALE)
                .collect()
        };
        let (texts, indices) = (sizes("<text"), sizes("<tspan"));
        assert!(!texts.is_empty(), "{name}: no text at all");
        assert!(texts.iter().all(|&x| x >= SMALL), "{name}: {texts:?}");
        assert!(indices.iter().all(|&x| x >= LEAST), "{name}: {indices:?}");
    }
}

#[test]
fn the_page_decides_colours_and_background() {
    for (name, _, svg) in drawn() {
        let head = svg.lines().next().unwrap_or_default();
        // A fixed size.
        for forbidden in [" width=\"", " height=\""] {
            assert!(!head.contains(forbidden), "{name}: {forbidden}");
        }
        for needed in "viewBox=\"0 0 6000 |role=\"img\"|aria-label=\"|class=\"fig\"".split('|') {
            assert!(head.contains(needed), "{name}: no {needed} in {head}");
        }
        // Black that does not turn with the theme, a background or a box, what lies outside, the end of an HTML block in Markdown.
        let inside = svg.replace("http://www.w3.org/2000/svg", "");
        for word in "#000000 <rect href :// @import <image <script \n\n".split(' ') {
            assert!(!inside.contains(word), "{name}: {word}");
        }
        for id in values(&svg, "id") {
            let own = id.starts_with(&format!("fig-{name}-"));
            assert!(own, "{name}: the id {id} lacks its prefix");
        }
        // Colours come only as fallbacks of the page's variables.
        for paint in ["fill", "stroke"].iter().flat_map(|key| values(&svg, key)) {
            let plain = ["none", "currentColor"].contains(&paint);
            let role = ["var(--", "url(#fig-"]
                .iter()
                .any(|role| paint.starts_with(role));
            assert!(plain || role, "{name}: a colour without a role: {paint}");
        }
    }
}

#[test]
fn a_file_has_plain_colours() {
    for (name, figure, _) in drawn() {
        let svg = figure.file(Look::default());
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

/// The backend moves points outside to the edge: a curve that reaches the edge was cut.
#[test]
fn curves_keep_off_the_edge() {
    for (name, _, svg) in drawn() {
        let size = size(&svg);
        for points in values(&svg, "points") {
            let numbers = points.split([' ', ',']).filter(|n| !n.is_empty());
            for (n, side) in numbers.zip(size.iter().cycle()) {
                let n: i64 = n.parse().expect("canvas coordinates are whole numbers");
                assert!((20..=side - 20).contains(&n), "{name}: {n} of {side}");
            }
        }
    }
}

/// A sans-serif letter is 0.55 of its size wide on average, even in a wide face.
#[test]
fn texts_fit_on_the_canvas() {
    for (name, _, svg) in drawn() {
        let width = size(&svg)[0] as f64;
        for element in svg.split("<text").skip(1) {
            let element = element.split("</text>").next().unwrap_or_default();
            let notation = element.contains(['{', '}', '^', '*', '$']);
            assert!(!notation, "{name}: a sign is printed: {element}");
            let number = |key: &str| values(element, key)[0].parse::<f64>().expect("a number");
            let pieces = element
                .split('<')
                .filter_map(|piece| piece.rsplit('>').next());
            let letters: usize = pieces.map(|piece| piece.chars().count()).sum();
            let length = 0.55 * number("font-size") * letters as f64;
            let before = match values(element, "text-anchor").first() {
                Some(&"middle") => 0.5 * length,
                Some(&"end") => length,
                _ => 0.0,
            };
            let left = number("x") - before;
            let fits = left > -20.0 && left + length < width + 20.0;
            assert!(fits, "{name}: a text runs off: {element}");
        }
    }
}

/// The marks through the drawing area and the elements of plotters.
fn by_plotters(figure: &Figure) -> String {
    use plotters::prelude::*;
    use plotters::style::text_anchor::{HPos, Pos, VPos};
    let mut raw = String::new();
    {
        let area = SVGBackend::with_string(&mut raw, figure.size.into()).into_drawing_area();
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
    for (name, figure, _) in drawn() {
        let mut raw = String::new();
        let mut backend = SVGBackend::with_string(&mut raw, figure.size.into());
        draw(figure.marks(), &mut backend).expect("a string takes every letter");
        drop(backend);
        assert_eq!(raw, by_plotters(figure), "{name}");
    }
}

/// Width and height of the canvas.
fn size(svg: &str) -> [i64; 2] {
    let view = values(svg, "viewBox")[0].split(' ');
    let view: Vec<i64> = view.map(|n| n.parse().expect("a number")).collect();
    [view[2], view[3]]
}

#[test]
fn the_comparison_allows_one_unit_of_a_coordinate_and_nothing_else() {
    let old = "<polyline points=\"10,20 30,40\" stroke-width=\"20\"/><text x=\"5\">*I* = 10</text>";
    assert_eq!(compare("a", old, old), Ok(()));
    assert_eq!(compare("a", old, &old.replace("30,40", "31,39")), Ok(()));
    let told = compare("a", old, &old.replace("30,40", "32,40")).expect_err("two units");
    assert!(told.starts_with("figure a: token"), "{told}");
    let both = "`30` in the committed file and `32` when drawn";
    assert!(told.contains(both), "{told}");
    // A label, a width, one more point.
    for (right, wrong) in [
        ("= 10", "= 11"),
        ("\"20\"", "\"21\""),
        ("30,40", "30,40 50,60"),
    ] {
        let other = old.replace(right, wrong);
        assert!(compare("a", old, &other).is_err(), "{wrong}");
    }
    assert!(compare("a", old, "").is_err(), "a missing file");
    // A film: 0.1 degree, a pixel; not another time, nor another unit.
    let film = "<style>@keyframes a{5.00%{transform:rotate(9.5deg) translate(3px,4px)}}.a{animation:a 8s}</style>";
    for (piece, other, same) in [
        ("9.5deg", "9.6deg", true),
        ("(3px", "(2px", true),
        ("9.5deg", "9.5rad", false),
        ("4px", "6px", false),
        ("8s", "9s", false),
        ("5.00%", "5.01%", false),
    ] {
        let told = compare("a", film, &film.replace(piece, other));
        assert_eq!(told.is_ok(), same, "{other}: {told:?}");
    }
}
