//! A figure is a function of its parameters: all of a range can be drawn, captions follow, hands find the values they take.

use figures::{Entry, Figure, Look, Mark, Parameter, Values, all};
use rayon::prelude::*;

/// Figures that have parameters, and each of these.
fn parameters() -> impl Iterator<Item = (&'static Entry, &'static Parameter)> {
    let each = |entry: &'static Entry| entry.parameters.iter().map(move |one| (entry, one));
    all().iter().flat_map(each)
}

fn chosen(parameter: &Parameter, share: f64) -> Values {
    let values = Values::default().with(parameter, parameter.at(share));
    values.unwrap_or_else(|told| panic!("its own range: {told}"))
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

/// Draws `points` figures of each range.
fn walk(points: u32) {
    let walk = |(entry, parameter): (&Entry, &Parameter)| {
        let book = drawn(entry, &Values::default());
        let mut follows = false;
        for k in 0..points {
            let values = chosen(parameter, f64::from(k) / f64::from(points - 1));
            let about = format!("{} of {values:?}", entry.name);
            let figure = drawn(entry, &values);
            stays_on_the_canvas(&figure, &about);
            let svg = figure.svg();
            for text in told(&figure).into_iter().chain([svg.as_str()]) {
                let mut lost = ["NaN", "inf", "-0 ", "\u{2212}0 "].into_iter();
                let lost = lost.find(|lost| text.contains(lost) && !text.contains("infin"));
                assert_eq!(lost, None, "{about}: {}", text.lines().next().unwrap_or(""));
            }
            // Both ends, for the browser to look at.
            if let (Ok(folder), true) = (std::env::var("FIGURE_FOLDER"), k == 0 || k + 1 == points)
            {
                let end = ["low", "high"][usize::from(k > 0)];
                let file = format!("{folder}/{}--{}-{end}.svg", entry.name, parameter.key);
                std::fs::write(file, figure.file(Look::default())).expect("FIGURE_FOLDER exists");
            }
            let numbers = figure.data.rows.iter().flat_map(|(_, row)| row);
            assert!(numbers.clone().all(|n| n.is_finite()), "{about}: data");
            follows |= told(&figure) != told(&book);
        }
        let key = parameter.key;
        assert!(follows, "{}: no caption follows {key}", entry.name);
    };
    parameters().par_bridge().for_each(walk);
}

#[test]
fn five_points_of_each_range_can_be_drawn() {
    walk(5);
}

/// All of them at once at the lower ends, and at the upper ones.
#[test]
fn two_corners_of_all_ranges_can_be_drawn() {
    let moved = all()
        .par_iter()
        .filter(|entry| !entry.parameters.is_empty());
    moved.for_each(|entry| {
        for share in [0.0, 1.0] {
            let values = entry
                .parameters
                .iter()
                .fold(Values::default(), |values, one| {
                    let at = one.at(share);
                    values
                        .with(one, at)
                        .unwrap_or_else(|told| panic!("its own range: {told}"))
                });
            stays_on_the_canvas(
                &drawn(entry, &values),
                &format!("{} of {values:?}", entry.name),
            );
        }
    });
}

#[test]
#[ignore = "minutes: fifty points of each range"]
fn fifty_points_of_each_range_can_be_drawn() {
    walk(50);
}

#[test]
fn parameters_are_well_formed() {
    for (entry, one) in parameters() {
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
    let moved = all().iter().filter(|entry| !entry.parameters.is_empty());
    for entry in moved.clone() {
        let figure = drawn(entry, &Values::default());
        assert!(!figure.data.rows.is_empty(), "{}: no data", entry.name);
        let width = figure.data.columns.len();
        assert!(figure.data.rows.iter().all(|(_, row)| row.len() == width));
    }
}

/// Where the handle of a value stands, a hand finds that value again.
#[test]
fn a_hand_finds_the_value_it_takes() {
    for (entry, parameter) in parameters() {
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
            for (at, side) in place.into_iter().zip(drawn(entry, &values).size) {
                let side = f64::from(side) / figures::style::SCALE;
                assert!((0.0..=side).contains(&at), "{about}: off the canvas");
            }
        }
    }
}

/// What was drawn before does not matter.
#[test]
fn a_figure_has_no_memory() {
    for (entry, parameter) in parameters() {
        let values = chosen(parameter, 0.7);
        let first = drawn(entry, &values).svg();
        let _ = drawn(entry, &Values::default());
        assert_eq!(first, drawn(entry, &values).svg(), "{}", entry.name);
    }
}
