//! The fastest method for each accuracy and length: digits required against number of turns.

use lab::accuracy::measured::{EXACT, MOTIONS, SWEEP, TARGETS, crossover, ranking, rows};

use crate::prelude::*;

/// Size of a field, units.
const FIELD: Point = [86.0, 38.0];
/// The accuracy for which the crossovers are given.
const NINE: f64 = 1e-9;

/// Eight maps of twelve fields, the winner's name in each.
pub fn map(_: &Values) -> Result<Figure> {
    let rows = rows(SWEEP);
    let winners = MOTIONS.map(|(motion, name, lengths)| {
        let first = |turns: u32, target: f64| {
            let ranked = ranking(&rows, &format!("{motion}/{turns}"), target);
            ranked.first().map_or("", |row| row.0)
        };
        let fields = lengths.map(|turns| TARGETS.map(|target| first(turns, target)));
        (name, lengths, fields)
    });
    let all: Vec<&str> = winners.iter().flat_map(|won| won.2.concat()).collect();
    let exact = all.iter().filter(|name| **name == EXACT).count();
    let count = all.len();
    let words = words!(
        "Up to nine digits, take steps for a single turn, and for a thousand the closed form where there is one.",
        "Eight motions, the accuracy of the attitude upward in digits, the length of the run to the right. Each field names the quickest method; exact, on grey, is the closed \
         form, its preparation included: {exact} of {count} fields. Heavy line: where it overtakes whatever steps.",
        "Eight tables of three columns, 1, 10 and 1000 turns, and four rows, 3 to 12 digits. For the four free and symmetric tops all fields of 10 and 1000 turns are exact, and \
         most of those of one turn are geometric methods. Kovalevskaya's two are exact at 1000 turns, but for twelve digits of the level one, which is so for twelve digits at 10. Where there is no closed form, dormand-prince-8 wins most fields. Exact wins {exact} of all."
    );
    let mut drawn = figure("accuracy-map", 872.0, words, |pen| {
        for (k, (name, lengths, fields)) in winners.iter().enumerate() {
            let corner = [34.0 + 298.0 * (k % 2) as f64, 60.0 + 206.0 * (k / 2) as f64];
            panel(pen, corner, name, (lengths, fields));
            if k < 2 {
                let place = [corner[0] - 30.0, corner[1] - 36.0];
                pen.remark(place, Start, "digits");
            }
        }
    });
    for (motion, _, lengths) in &MOTIONS {
        if let Some(turns) = crossover(&rows, motion, lengths, NINE) {
            drawn = drawn.value(motion, number(turns, usize::from(turns < 9.95)));
        }
    }
    Ok(drawn)
}

/// One motion: a column for each length, a row for each accuracy, the finest on top.
fn panel(
    pen: &mut Pen,
    [left, top]: Point,
    name: &str,
    (lengths, fields): (&[u32; 3], &[[&str; 4]; 3]),
) {
    let [wide, high] = FIELD;
    let at = |column, row| [left + wide * column as f64, top + high * (4 - row) as f64];
    pen.label([left, top - 12.0], Start, name);
    for (column, turns) in lengths.iter().enumerate() {
        let [x, y] = at(column, 0);
        let unit = if *turns == 1 { "turn" } else { "turns" };
        let text = format!("{turns} {unit}");
        pen.remark([x + 0.5 * wide, y + 18.0], Middle, &text);
        for (row, winner) in fields[column].iter().enumerate() {
            let corners = boxed(at(column, row), at(column + 1, row + 1));
            if *winner == EXACT {
                pen.fill(corners, Ink, 0.12);
            }
            pen.outline(corners, inked(HAIR).alpha(0.4));
            let middle = [x + 0.5 * wide, y - high * (row as f64 + 0.5)];
            written(pen, middle, winner);
        }
    }
    // A border between a field where the closed form wins and a neighbour where it does not.
    let differ = |a: &str, b: &str| (a == EXACT) != (b == EXACT);
    for column in 0..3 {
        for row in 0..4 {
            let here = fields[column][row];
            if column < 2 && differ(here, fields[column + 1][row]) {
                pen.line([at(column + 1, row), at(column + 1, row + 1)], inked(DATA));
            }
            if row < 3 && differ(here, fields[column][row + 1]) {
                pen.line([at(column, row + 1), at(column + 1, row + 1)], inked(DATA));
            }
        }
    }
    for (row, target) in TARGETS.iter().enumerate() {
        let place = [left - 7.0, at(0, row)[1] - 0.5 * high + 5.0];
        pen.remark(place, End, &number(-target.log10(), 0));
    }
}

/// The name of a method in its field; a long name takes two lines.
fn written(pen: &mut Pen, [x, y]: Point, name: &str) {
    let lettering = match name {
        EXACT => small(Ink).strong(),
        _ => small(Ink),
    };
    match name.split_once('-') {
        Some((first, rest)) if rest.contains('-') => {
            pen.text([x, y - 3.0], Middle, &format!("{first}-"), lettering);
            pen.text([x, y + 13.0], Middle, rest, lettering);
        }
        _ => pen.text([x, y + 5.0], Middle, name, lettering),
    }
}
