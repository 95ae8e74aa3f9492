//! The cost of every kind of scene with each effect that it can have (page "Scenes").

use crate::prelude::*;

/// The figures of the chapter, in its order.
pub const FIGURES: &[Entry] = &[of("scene-prices", &[], prices)];

/// Counted by the benches, checked by the tests of the book.
const PRICES: &str = include_str!("../../book/src/tables/scene-prices.csv");

/// Milliseconds.
const ACROSS: Axis = Axis::log([0.01, 10.0], [250.0, 400.0]);
const DECADES: [(f64, &str); 4] = [(0.01, "0.01"), (0.1, "0.1"), (1.0, "1"), (10.0, "10")];
/// Where the numbers at the margin end: milliseconds, evaluations.
const MARGIN: [f64; 2] = [482.0, 592.0];
const TOP: f64 = 62.0;
const ROW: f64 = 21.0;
const GAP: f64 = 9.0;

/// One cell of the matrix; times in milliseconds.
struct Cell {
    kind: &'static str,
    effect: String,
    without: Option<f64>,
    with: f64,
    solver: &'static str,
    evaluations: u32,
}

fn cells() -> Vec<Cell> {
    let lines = PRICES.lines().filter(|line| !line.starts_with('#')).skip(1);
    let cells = lines.filter_map(|line| {
        let fields: Vec<&'static str> = line.split(',').collect();
        let [kind, effect, _, solver, _, evaluations, without, with] = fields[..] else {
            return None;
        };
        Some(Cell {
            kind,
            effect: effect.replace('_', " "),
            without: without.parse().ok(),
            with: with.parse().ok()?,
            solver,
            evaluations: evaluations.parse().ok()?,
        })
    });
    cells.collect()
}

/// The change of the cost of a scene by each of its effects.
pub fn prices(_: &Values) -> Result<Figure> {
    let cells = cells();
    let kinds = cells.chunk_by(|a, b| a.kind == b.kind).count();
    let stays = cells.iter().filter(|cell| cell.evaluations == 0).count();
    let height = TOP + ROW * cells.len() as f64 + GAP * kinds as f64 + 14.0;
    let machine = PRICES.lines().next().unwrap_or_default();
    let (count, measured) = (cells.len(), machine.trim_start_matches(['#', ' ']));
    let words = words!(
        "An effect is paid for only where it is called for, and most of them never need an integrator.",
        "The time to follow one second to $10^{{-9}}$, reading the file included, without the effect (ring; none where the scene needs it) and with it (disc). At the margin the \
         time with it, and its evaluations, if any: {stays} of {count} effects never call for one. Least of repeated runs: {measured}.",
        "A table in {kinds} blocks, one a kind of scene, with a line for each of its effects. On each line a ring shows the time without \
         the effect and a disc the time with it. For {stays} of {count} lines the disc stays within some hundredths of a millisecond. For tops \
         gravity keeps it there, and every kind of friction moves it to the right by a decade and more."
    );
    Ok(figure("scene-prices", height, words, |pen| {
        head(pen, height);
        let mut y = TOP;
        for block in cells.chunk_by(|a, b| a.kind == b.kind) {
            y += GAP;
            pen.line([[8.0, y - 5.0], [592.0, y - 5.0]], muted(HAIR));
            if let Some(cell) = block.first() {
                pen.label([8.0, y + 14.0], Start, cell.kind);
            }
            for cell in block {
                row(pen, cell, y + 9.0);
                y += ROW;
            }
        }
    }))
}

fn head(pen: &mut Pen, height: f64) {
    for (milliseconds, text) in DECADES {
        let x = ACROSS.at(milliseconds);
        pen.remark([x, 40.0], Middle, text);
        let ends = [[x, 50.0], [x, height - 12.0]];
        pen.line(ends, muted(HAIR).alpha(0.5).dotted());
    }
    pen.note([325.0, 18.0], Middle, "ms a second");
    pen.note([MARGIN[0], 18.0], End, "ms");
    pen.note([MARGIN[1], 18.0], End, "evaluations");
}

fn row(pen: &mut Pen, cell: &Cell, y: f64) {
    pen.note([108.0, y + 5.0], Start, &cell.effect);
    let with = ACROSS.at(cell.with);
    if let Some(without) = cell.without.map(|time| ACROSS.at(time)) {
        let step = if with < without { -6.0 } else { 6.0 };
        if (with - without).abs() > 8.0 {
            pen.line([[without + step, y], [with, y]], inked(SECONDARY));
        }
        pen.ring([without, y], 6.0, muted(SECONDARY));
    }
    pen.dot([with, y], 3.6);
    let how = match (cell.solver, cell.evaluations) {
        ("exact", _) => "closed form".to_owned(),
        (solver, 0) => solver.to_owned(),
        (_, count) => thousands(count),
    };
    let time = format!("{:.*}", if cell.with < 1.0 { 2 } else { 1 }, cell.with);
    for (x, text) in MARGIN.into_iter().zip([time, how]) {
        pen.note([x, y + 5.0], End, &text);
    }
}

/// 12 345 with a narrow gap.
fn thousands(count: u32) -> String {
    match count / 1000 {
        0 => count.to_string(),
        whole => format!("{whole}\u{2009}{:03}", count % 1000),
    }
}
