//! The measured table of the chapter "What accuracy costs" is that of the committed measurements.

use std::path::Path;

use lab::accuracy::measured::{self, EXACT, MOTIONS, SWEEP, TARGETS};
use press::accuracy::HEADER;

fn file(name: &str) -> std::path::PathBuf {
    Path::new("src/tables").join(name)
}

#[test]
fn the_table_is_that_of_the_measurements() {
    super::kept("src/tables/accuracy.md", &winners());
}

/// A Markdown table: for each motion over its longest run the time of the closed form, and for each accuracy the quickest stepper with its own.
fn winners() -> String {
    let rows = measured::rows(SWEEP);
    let head = "| motion | exact | $10^{-3}$ | $10^{-6}$ | $10^{-9}$ | $10^{-12}$ |\n";
    let mut text = format!("{head}|---|---|---|---|---|---|\n");
    for (motion, name, [.., turns]) in MOTIONS {
        let run = format!("{motion}/{turns}");
        let told = |target: f64, exact: bool| {
            let ranked = measured::ranking(&rows, &run, target);
            let first = ranked.iter().find(|row| (row.0 == EXACT) == exact);
            first.map(|&(method, seconds)| (method, time(seconds)))
        };
        let exact = TARGETS.iter().find_map(|&target| told(target, true));
        let exact = exact.map_or("—".to_owned(), |(_, time)| time);
        text += &format!("| {name} | {exact}");
        for target in TARGETS {
            let cell = told(target, false).map(|(method, time)| format!("{method} {time}"));
            text += &format!(" | {}", cell.unwrap_or("—".to_owned()));
        }
        text += " |\n";
    }
    text
}

fn time(seconds: f64) -> String {
    let micro = seconds < 1e-3;
    let (factor, unit) = if micro { (1e6, "µs") } else { (1e3, "ms") };
    format!("{}\u{a0}{unit}", short(factor * seconds))
}

/// Two digits: more would not be the same tomorrow.
fn short(value: f64) -> String {
    if value < 9.95 {
        format!("{value:.1}")
    } else {
        let unit = 10.0_f64.powf(value.log10().floor() - 1.0);
        format!("{:.0}", (value / unit).round() * unit)
    }
}

/// A closed form that costs 4, a stepper that costs 1 a turn: it pays from four turns on, and a method too coarse does not count.
#[test]
fn a_closed_form_pays_where_the_prices_meet() {
    let line = |method: &str, turns: u32, error: &str, price: u32| {
        format!("top/{turns},{method},0,{error},{error},1,1,{price},ok\n")
    };
    let mut csv = format!("{HEADER}\n");
    for turns in [1, 10, 1000] {
        csv += &line("exact", turns, "1e-15", 4);
        csv += &line("slow", turns, "1e-10", turns);
        csv += &line("coarse", turns, "1e-5", 1);
    }
    let rows = measured::rows(&csv);
    let from = |lengths: &[u32], target| measured::crossover(&rows, "top", lengths, target);
    assert!((from(&[1, 10, 1000], 1e-9).unwrap() - 4.0).abs() < 1e-12);
    assert_eq!(from(&[10, 1000], 1e-9), None, "it pays from the start");
    assert_eq!(from(&[1, 10, 1000], 1e-4), None, "it never pays");
    assert_eq!(from(&[1, 10, 1000], 1e-12), None, "nothing to overtake");
}

/// The first line names machine and compiler; then comes what the command writes, nothing else.
#[test]
fn the_measurements_name_their_machine() {
    let [csv, scenes] = ["accuracy.csv", "accuracy-scenes.csv"]
        .map(|name| std::fs::read_to_string(file(name)).unwrap());
    assert!(scenes.starts_with("# ") && scenes.contains("Rust 1."));
    assert_eq!(scenes.lines().nth(1), Some(HEADER));
    let mut lines = csv.lines();
    let first = lines.next().unwrap();
    let told = first.starts_with("# ") && first.contains("Rust 1.");
    assert!(told, "{first}");
    assert_eq!(lines.next(), Some(HEADER));
    assert!(lines.clone().count() > 1000);
    for line in lines {
        assert_eq!(line.split(',').count(), 9, "{line}");
    }
}

/// How many times as long as the cheapest method another takes, if it gets there.
fn factor(ranked: &[(&str, f64)], which: impl Fn(&str) -> bool) -> Option<f64> {
    let other = ranked.iter().find(|(method, _)| which(method))?;
    Some(other.1 / ranked[0].1)
}

/// What the page says of the table.
#[test]
fn the_page_says_what_was_measured() {
    let csv = std::fs::read_to_string(file("accuracy.csv")).unwrap();
    let rows = measured::rows(&csv);
    let ranked = |problem: &str, target: f64| measured::ranking(&rows, problem, target);
    // A thousand turns of a free or symmetric top: the closed form, and the next best takes at least a hundred times as long.
    for problem in ["free-top", "near-separatrix", "cusped-top", "near-sleeping"] {
        for target in [1e-3, 1e-6, 1e-9, 1e-12] {
            let ranked = ranked(&format!("{problem}/1000"), target);
            assert_eq!(ranked[0].0, "exact");
            let next = factor(&ranked, |method| method != "exact");
            let far = next.is_none_or(|factor| factor > 100.0);
            assert!(far, "{problem} {target:e}");
        }
    }
    // Kovalevskaya's, too, at the same price for one turn and a thousand: less than a tenth of a millisecond from an ordinary start, a quarter of one from the upright one.
    let exact = |problem: &str| {
        let ranked = ranked(problem, 1e-9);
        ranked.iter().find(|row| row.0 == "exact").unwrap().1
    };
    for (problem, target, price) in [
        ("kovalevskaya-level", 1e-9, 5e-5..1e-4),
        ("kovalevskaya", 1e-12, 1.5e-4..3e-4),
    ] {
        assert_eq!(ranked(&format!("{problem}/1000"), target)[0].0, "exact");
        let [once, far] = [1, 1000].map(|turns| exact(&format!("{problem}/{turns}")));
        assert!((far / once - 1.0).abs() < 0.2 && price.contains(&far));
    }
    // Next to the separatrix and next to sleep nothing that steps has nine digits left after a thousand turns.
    for problem in ["near-separatrix/1000", "near-sleeping/1000"] {
        assert_eq!(ranked(problem, 1e-9).len(), 1, "{problem}");
    }
    // A million turns of the four that are cheap: the same times.
    for problem in ["free-top", "near-separatrix", "cusped-top", "near-sleeping"] {
        let ratio = exact(&format!("{problem}/1000000")) / exact(&format!("{problem}/1000"));
        assert!((ratio - 1.0).abs() < 0.15, "{problem}: {ratio}");
    }
    // One turn of a free body to six digits is cheaper by steps, to twelve it is a tie; ten turns never are.
    assert_ne!(ranked("free-top/1", 1e-6)[0].0, "exact");
    assert!(factor(&ranked("free-top/1", 1e-12), |m| m == "exact").unwrap() < 1.2);
    for target in [1e-3, 1e-6, 1e-9, 1e-12] {
        assert_eq!(ranked("free-top/10", target)[0].0, "exact");
    }
    // Where there is no closed form, ours of order 8 is about twice as quick as dop853; on the tippe top 1.7 times at least.
    for target in [1e-3, 1e-6, 1e-9] {
        let heavy = ranked("heavy-body/1000", target);
        let ours = heavy.iter().position(|row| row.0 == "dormand-prince-8");
        let ours = &heavy[ours.unwrap()..];
        // To three digits, kicks and drifts of order 4 are as quick.
        assert!(ours[0].1 < 1.2 * heavy[0].1);
        assert!(factor(ours, |m| m == "dop853").unwrap() > 1.9);
        let tippe = ranked("tippe-top/100", target);
        assert_eq!(tippe[0].0, "dormand-prince-8");
        assert!(factor(&tippe, |m| m == "dop853").unwrap() > 1.7);
    }
    // Scenes of the book: ours of order 8 is the cheapest everywhere, twice as quick as dop853 on the strip; the yo-yo pays it most.
    let csv = std::fs::read_to_string(file("accuracy-scenes.csv")).unwrap();
    let rows = measured::rows(&csv);
    for target in [1e-3, 1e-6, 1e-9, 1e-12] {
        for (scene, least) in [
            ("strip", 1.8),
            ("sliding-ball", 1.29),
            ("yo-yo-asleep", 4.0),
        ] {
            let ranked = measured::ranking(&rows, scene, target);
            assert_eq!(ranked[0].0, "dormand-prince-8", "{scene} {target:e}");
            let peer = factor(&ranked, |method| method == "dop853");
            let near = peer.is_none_or(|factor| (least..7.1).contains(&factor));
            assert!(near, "{scene} {target:e}: {peer:?}");
        }
    }
}
