//! A figure is a function of its parameters: all of a range can be drawn, captions follow, hands find the values they take.

use figures::{Entry, Figure, Look, Mark, Parameter, Values, all};
use rayon::prelude::*;
use std::sync::LazyLock;

/// Figures that have parameters, as the book has them.
static MOVED: LazyLock<Vec<(&Entry, Figure)>> = LazyLock::new(|| {
    let moved = all().par_iter().with_max_len(1);
    let moved = moved.filter(|entry| !entry.parameters.is_empty());
    moved
        .map(|entry| (entry, drawn(entry, &Values::default())))
        .collect()
});

/// Their parameters, each with its figure.
fn parameters() -> impl Iterator<Item = (&'static Entry, &'static Figure, &'static Parameter)> {
    let of = |(entry, book): &'static (&Entry, Figure)| {
        let each = entry.parameters.iter();
        each.map(move |one| (*entry, book, one))
    };
    MOVED.iter().flat_map(of)
}

/// These values, and of one more parameter what is at this share of its range.
fn and(values: Values, parameter: &Parameter, share: f64) -> Values {
    let values = values.with(parameter, parameter.at(share));
    values.unwrap_or_else(|told| panic!("its own range: {told}"))
}

fn chosen(parameter: &Parameter, share: f64) -> Values {
    and(Values::default(), parameter, share)
}

/// All parameters at this share of their ranges.
fn everywhere(entry: &Entry, share: f64) -> Values {
    let all = entry.parameters.iter();
    all.fold(Values::default(), |values, one| and(values, one, share))
}

fn drawn(entry: &Entry, values: &Values) -> Figure {
    let figure = entry.draw(values);
    figure.unwrap_or_else(|error| panic!("{} of {values:?}: {error}", entry.name))
}

/// Everything that a caption says.
fn told(figure: &Figure) -> [&str; 3] {
    [&figure.claim, &figure.details, &figure.alt]
}

/// All points of a mark are on the canvas.
fn stays_on_the_canvas(figure: &Figure, about: &str) {
    let [width, height] = figure.size.map(|side| side as i32);
    let inside = |&(x, y): &(i32, i32)| (0..=width).contains(&x) && (0..=height).contains(&y);
    for mark in figure.marks() {
        let there = match mark {
            Mark::Path(points, _) | Mark::Polygon(points, _) => points.iter().all(inside),
            Mark::Circle { center, .. } => inside(center),
            Mark::Text { at, .. } => inside(at),
        };
        assert!(there, "{about}: off the canvas: {mark:?}");
    }
}

/// Draws figures at these shares of each range.
fn walk(shares: &[f64]) {
    for (entry, book, parameter) in parameters() {
        let mut follows = false;
        for &share in shares {
            let values = chosen(parameter, share);
            let about = format!("{} of {values:?}", entry.name);
            let figure = drawn(entry, &values);
            stays_on_the_canvas(&figure, &about);
            assert_eq!(figure.size, book.size, "{about}");
            let svg = figure.svg();
            for text in told(&figure).into_iter().chain([svg.as_str()]) {
                let mut lost = ["NaN", "inf", "-0 ", "\u{2212}0 "].into_iter();
                let lost = lost.find(|lost| text.contains(lost) && !text.contains("infin"));
                assert_eq!(lost, None, "{about}: {}", text.lines().next().unwrap_or(""));
            }
            // Both ends, for the browser to look at.
            let end = match share {
                0.0 => Some("low"),
                1.0 => Some("high"),
                _ => None,
            };
            if let (Ok(folder), Some(end)) = (std::env::var("FIGURE_FOLDER"), end) {
                let file = format!("{folder}/{}--{}-{end}.svg", entry.name, parameter.key);
                std::fs::write(file, figure.file(Look::default())).expect("FIGURE_FOLDER exists");
            }
            let numbers = figure.data.rows.iter().flat_map(|(_, row)| row);
            assert!(numbers.clone().all(|n| n.is_finite()), "{about}: data");
            follows |= told(&figure) != told(book);
        }
        let key = parameter.key;
        assert!(follows, "{}: no caption follows {key}", entry.name);
    }
}

#[test]
fn both_ends_of_each_range_can_be_drawn() {
    walk(&[0.0, 1.0]);
}

#[test]
fn so_can_what_lies_between() {
    walk(&[0.2, 0.8]);
}

#[test]
fn so_can_what_is_nearer_the_middle() {
    walk(&[0.4, 0.6]);
}

#[test]
#[ignore = "minutes: fifty points of each range"]
fn fifty_points_of_each_range_can_be_drawn() {
    let every_other =
        |first: u32| Vec::from_iter((first..50).step_by(2).map(|k| f64::from(k) / 49.0));
    rayon::join(|| walk(&every_other(0)), || walk(&every_other(1)));
}

/// All of them at once at the lower ends, and at the upper ones.
#[test]
fn two_corners_of_all_ranges_can_be_drawn() {
    for (entry, _) in MOVED.iter() {
        for values in [0.0, 1.0].map(|share| everywhere(entry, share)) {
            let about = format!("{} of {values:?}", entry.name);
            stays_on_the_canvas(&drawn(entry, &values), &about);
        }
    }
}

#[test]
fn parameters_are_well_formed() {
    for (entry, _, one) in parameters() {
        let about = format!("{}: {one}", entry.name);
        let [low, high] = one.range;
        assert!(low < high && (low..=high).contains(&one.default), "{about}");
        assert!(Values::default().with(one, one.default).is_ok(), "{about}");
        let letters = |c: char| c.is_ascii_lowercase() || c == '_';
        assert!(one.key.chars().all(letters), "{about}");
        let empty = one.symbol.is_empty() || one.meaning.is_empty();
        assert!(!empty && !one.meaning.ends_with('.'), "{about}");
        let same = entry.parameters.iter().filter(|other| other.key == one.key);
        assert_eq!(same.count(), 1, "{about}");
    }
    for (entry, figure) in MOVED.iter() {
        assert!(!figure.data.rows.is_empty(), "{}: no data", entry.name);
        let width = figure.data.columns.len();
        assert!(figure.data.rows.iter().all(|(_, row)| row.len() == width));
    }
}

/// Where the handle of a value stands, a hand finds that value again.
#[test]
fn a_hand_finds_the_value_it_takes() {
    for (entry, book, parameter) in parameters() {
        let Some(handle) = parameter.handle else {
            continue;
        };
        for k in 0..50 {
            let values = chosen(parameter, f64::from(k) / 49.0);
            let (about, place) = (format!("{} of {values:?}", entry.name), handle(&values));
            // Whatever it was before.
            let found = parameter.dragged_to(place, &Values::default());
            let found = found.expect("it has a handle");
            let there = Values::default().with(parameter, found).map(|v| handle(&v));
            let [x, y] = there.expect("within its range");
            let off = (x - place[0]).hypot(y - place[1]);
            assert!(off <= 1e-3, "{about}: found at {found}");
            for (at, side) in place.into_iter().zip(book.size) {
                let side = f64::from(side) / figures::style::SCALE;
                assert!((0.0..=side).contains(&at), "{about}: off the canvas");
            }
        }
    }
}

/// What was drawn before does not matter: neither the same figure of other values nor another one.
#[test]
fn a_figure_has_no_memory() {
    let svg = |entry: &Entry| drawn(entry, &everywhere(entry, 0.7)).svg();
    let there: Vec<_> = MOVED.iter().map(|(entry, _)| svg(entry)).collect();
    for ((entry, _), first) in MOVED.iter().zip(&there).rev() {
        assert!(*first == svg(entry), "{}", entry.name);
    }
}
