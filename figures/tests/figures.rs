//! Every figure draws, twice the same, and as committed.

use std::collections::HashSet;
use std::path::PathBuf;

use figures::{Entry, Figure, all, compare};

fn drawn() -> impl Iterator<Item = (&'static Entry, Figure)> {
    all().iter().map(|entry| {
        let figure = (entry.draw)().unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        (entry, figure)
    })
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
        let second = (entry.draw)().expect("it drew a moment ago");
        assert_eq!(first.svg, second.svg, "{}", entry.name);
    }
}

/// `FIGURES=write cargo test -p figures` writes the files instead; look at them before you commit them.
#[test]
fn the_committed_files_are_what_the_code_draws() {
    let write = std::env::var_os("FIGURES").is_some_and(|v| v == "write");
    for (entry, figure) in drawn() {
        let path = committed(entry.name);
        if write {
            std::fs::write(&path, &figure.svg).expect("figures/svg can be written");
        }
        let old = std::fs::read_to_string(&path).unwrap_or_default();
        if let Err(difference) = compare(entry.name, &old, &figure.svg) {
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
        let sizes = values(&figure.svg, "font-size");
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
        let (name, svg) = (entry.name, &figure.svg);
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
fn everything_lies_on_the_canvas() {
    for (entry, figure) in drawn() {
        let view = values(&figure.svg, "viewBox")[0];
        let size: Vec<i64> = view
            .split(' ')
            .map(|n| n.parse().expect("a number"))
            .collect();
        for points in values(&figure.svg, "points") {
            for (k, n) in points
                .split([' ', ','])
                .filter(|n| !n.is_empty())
                .enumerate()
            {
                let n: i64 = n.parse().expect("canvas coordinates are whole numbers");
                assert!(
                    (0..=size[2 + k % 2]).contains(&n),
                    "{}: {n} of {}",
                    entry.name,
                    size[2 + k % 2]
                );
            }
        }
    }
}

#[test]
fn the_comparison_allows_one_unit_of_a_coordinate_and_nothing_else() {
    let old = "<polyline points=\"10,20 30,40\" stroke-width=\"20\"/><text x=\"5\">*I* = 10</text>";
    assert_eq!(compare("a", old, old), Ok(()));
    assert_eq!(compare("a", old, &old.replace("30,40", "31,39")), Ok(()));
    let far = compare("a", old, &old.replace("30,40", "32,40")).expect_err("two units");
    assert_eq!(
        (
            far.figure.as_str(),
            far.committed.as_str(),
            far.drawn.as_str()
        ),
        ("a", "30", "32")
    );
    assert!(far.to_string().contains("figure a: token"), "{far}");
    assert!(
        compare("a", old, &old.replace("= 10", "= 11")).is_err(),
        "a label is not a coordinate"
    );
    assert!(
        compare("a", old, &old.replace("\"20\"", "\"21\"")).is_err(),
        "a width is not a coordinate"
    );
    assert!(
        compare("a", old, &old.replace("30,40", "30,40 50,60")).is_err(),
        "more points"
    );
    assert!(compare("a", old, "").is_err(), "a missing file");
}
