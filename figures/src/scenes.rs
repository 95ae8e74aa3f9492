//! Every kind of scene with every effect that it can have, and what each costs (page "Scenes").

use spinning_bodies::Result;

use crate::Figure;
use crate::style::{Anchor, HAIR, Pen, Role, SECONDARY, Words, figure, label, small, stroke};

/// Counted by the benches, checked by the tests of the book.
const PRICES: &str = include_str!("../../book/src/tables/scene-prices.csv");

/// Where the lanes of closed forms and of events are, and ten and a hundred thousand evaluations.
const CLOSED: f64 = 262.0;
const EVENTS: f64 = 318.0;
const LOG: [f64; 2] = [362.0, 520.0];
const TOP: f64 = 62.0;
const ROW: f64 = 21.0;
const GAP: f64 = 9.0;

/// One cell of the matrix.
struct Cell {
    kind: &'static str,
    effect: String,
    without: Option<f64>,
    with: f64,
    evaluations: Option<u32>,
}

fn lane(solver: &str, evaluations: &str) -> f64 {
    match (solver, evaluations.parse::<f64>()) {
        ("exact", _) => CLOSED,
        (_, Ok(count)) if count > 0.0 => LOG[0] + (LOG[1] - LOG[0]) * (count.log10() - 1.0) / 4.0,
        _ => EVENTS,
    }
}

fn cells() -> Vec<Cell> {
    let lines = PRICES.lines().filter(|line| !line.starts_with('#')).skip(1);
    let cells = lines.filter_map(|line| {
        let mut fields = line.split(',');
        let mut next = || fields.next();
        let (kind, effect, before, after) = (next()?, next()?, next()?, next()?);
        let (less, more) = (next()?, next()?);
        Some(Cell {
            kind,
            effect: effect.replace('_', " "),
            without: (!before.is_empty()).then(|| lane(before, less)),
            with: lane(after, more),
            evaluations: more.parse().ok().filter(|count| *count > 0),
        })
    });
    cells.collect()
}

/// What each effect does to the price of its scene.
pub fn prices() -> Result<Figure> {
    let cells = cells();
    let kinds = cells.chunk_by(|a, b| a.kind == b.kind).count();
    let stays = cells
        .iter()
        .filter(|cell| cell.evaluations.is_none())
        .count();
    let height = TOP + ROW * cells.len() as f64 + GAP * kinds as f64 + 14.0;
    let words = Words {
        claim: "An effect is paid for only where it is called for, and most of them never need an integrator.".to_owned(),
        details: format!(
            "Every kind of scene with each of its effects: what it takes to follow one second to $10^{{-9}}$ without the effect (ring) and with \
             it (disc). Left lane: one closed form for all times. Middle: closed forms from event to event. Right: evaluations of the \
             right-hand side by a general method, on a logarithmic scale, the number at the margin. With {stays} of {} effects the general \
             method stays in its drawer. No ring: the scene cannot do without the effect.",
            cells.len()
        ),
        alt: format!(
            "A table in {kinds} blocks, one a kind of scene, with a line for each of its effects. On each line a ring shows the price without \
             the effect and a disc the price with it, in three lanes: closed form, events, number of evaluations. In {stays} of {} lines the \
             disc is in one of the first two lanes. For tops gravity keeps the disc in the first lane, and every kind of friction moves it \
             to thousands of evaluations.",
            cells.len()
        ),
    };
    Ok(figure("scene-prices", height, words, |pen| {
        head(pen, height);
        let mut y = TOP;
        for block in cells.chunk_by(|a, b| a.kind == b.kind) {
            y += GAP;
            pen.line(
                &[[8.0, y - 5.0], [592.0, y - 5.0]],
                stroke(Role::Muted, HAIR),
            );
            if let Some(cell) = block.first() {
                pen.text([8.0, y + 14.0], Anchor::Start, cell.kind, label(Role::Ink));
            }
            for cell in block {
                row(pen, cell, y + 9.0);
                y += ROW;
            }
        }
    }))
}

fn head(pen: &mut Pen<'_>, height: f64) {
    for (x, text) in [(CLOSED, "closed"), (EVENTS, "events")] {
        pen.text([x, 40.0], Anchor::Middle, text, small(Role::Ink));
        pen.line(
            &[[x, 50.0], [x, height - 12.0]],
            stroke(Role::Muted, HAIR).alpha(0.5),
        );
    }
    pen.text(
        [600.0 - 8.0, 18.0],
        Anchor::End,
        "evaluations a second",
        small(Role::Ink),
    );
    for (count, text) in [(2, "100"), (4, "10 000")] {
        let x = LOG[0] + (LOG[1] - LOG[0]) * f64::from(count - 1) / 4.0;
        pen.text([x, 40.0], Anchor::Middle, text, small(Role::Muted));
        pen.line(
            &[[x, 50.0], [x, height - 12.0]],
            stroke(Role::Muted, HAIR).alpha(0.5).dotted(),
        );
    }
}

fn row(pen: &mut Pen<'_>, cell: &Cell, y: f64) {
    let role = if cell.evaluations.is_some() {
        Role::AngularMomentum
    } else {
        Role::Omega
    };
    pen.text(
        [108.0, y + 5.0],
        Anchor::Start,
        &cell.effect,
        small(Role::Ink),
    );
    if let Some(without) = cell.without {
        let step = if cell.with < without { -6.0 } else { 6.0 };
        if (cell.with - without).abs() > 8.0 {
            pen.line(
                &[[without + step, y], [cell.with, y]],
                stroke(role, SECONDARY),
            );
        }
        pen.ring([without, y], 6.0, stroke(Role::Muted, SECONDARY));
    }
    pen.disc([cell.with, y], 3.6, role, 1.0);
    if let Some(count) = cell.evaluations {
        pen.text(
            [592.0, y + 5.0],
            Anchor::End,
            &thousands(count),
            small(Role::Ink),
        );
    }
}

/// 12 345 with a narrow gap.
fn thousands(count: u32) -> String {
    match count / 1000 {
        0 => count.to_string(),
        whole => format!("{whole}\u{2009}{:03}", count % 1000),
    }
}
