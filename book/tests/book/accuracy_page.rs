//! The measured table of the chapter "What accuracy costs" is that of the committed measurements.

use std::path::Path;

use press::accuracy::{HEADER, winners};

fn file(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("src/tables")
        .join(name)
}

/// `UPDATE_TABLES=1 cargo test -p book --test accuracy_page` writes them.
#[test]
fn the_tables_are_those_of_the_measurements() {
    let [csv, scenes] = ["accuracy.csv", "accuracy-scenes.csv"]
        .map(|name| std::fs::read_to_string(file(name)).unwrap());
    for (name, table) in [
        ("accuracy.md", winners::markdown(&csv, &winners::RUNS)),
        (
            "accuracy-scenes.md",
            winners::markdown(&scenes, &winners::SCENES),
        ),
        ("accuracy-crossover.md", winners::crossover(&csv)),
    ] {
        if std::env::var_os("UPDATE_TABLES").is_some() {
            std::fs::write(file(name), &table).unwrap();
        }
        assert_eq!(
            std::fs::read_to_string(file(name)).unwrap(),
            table,
            "{name}"
        );
    }
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
    assert!(
        first.starts_with("# ") && first.contains("Rust 1."),
        "{first}"
    );
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
    let rows = winners::rows(&csv);
    let ranked = |problem: &str, target: f64| winners::ranking(&rows, problem, target);
    // A thousand turns of a free or symmetric top: the closed form, and the next best takes at least a hundred times as long.
    for problem in ["free-top", "near-separatrix", "cusped-top", "near-sleeping"] {
        for target in [1e-3, 1e-6, 1e-9, 1e-12] {
            let ranked = ranked(&format!("{problem}/1000"), target);
            assert_eq!(ranked[0].0, "exact");
            let next = factor(&ranked, |method| method != "exact");
            assert!(
                next.is_none_or(|factor| factor > 100.0),
                "{problem} {target:e}"
            );
        }
    }
    // Kovalevskaya's from an ordinary start, too, at the same price for one turn and a thousand; from the upright one never.
    let exact = |problem: &str| {
        let ranked = ranked(problem, 1e-9);
        ranked
            .iter()
            .find(|(method, _)| *method == "exact")
            .unwrap()
            .1
    };
    assert_eq!(ranked("kovalevskaya-level/1000", 1e-12)[0].0, "exact");
    let [once, far] = [1, 1000].map(|turns| exact(&format!("kovalevskaya-level/{turns}")));
    assert!((far / once - 1.0).abs() < 0.2);
    assert!((30.0..50.0).contains(&(far / exact("cusped-top/1000"))));
    for turns in [1, 10, 1000] {
        let upright = ranked(&format!("kovalevskaya/{turns}"), 1e-9);
        assert_ne!(upright[0].0, "exact");
    }
    // Next to the separatrix and next to sleep nothing that steps has nine digits left after a thousand turns.
    for problem in ["near-separatrix/1000", "near-sleeping/1000"] {
        assert_eq!(ranked(problem, 1e-9).len(), 1, "{problem}");
    }
    // One turn of a free body to six digits is cheaper by steps, to twelve it is a tie; ten turns never are.
    assert_ne!(ranked("free-top/1", 1e-6)[0].0, "exact");
    assert!(factor(&ranked("free-top/1", 1e-12), |m| m == "exact").unwrap() < 1.2);
    for target in [1e-3, 1e-6, 1e-9, 1e-12] {
        assert_eq!(ranked("free-top/10", target)[0].0, "exact");
    }
    // Where there is no closed form, ours of order 8 is more than twice as quick as dop853; on the tippe top 1.7 times at least.
    for target in [1e-3, 1e-6, 1e-9] {
        let heavy = ranked("heavy-body/1000", target);
        let ours = heavy.iter().position(|row| row.0 == "dormand-prince-8");
        let ours = &heavy[ours.unwrap()..];
        // To three digits, kicks and drifts of order 4 are as quick.
        assert!(ours[0].1 < 1.2 * heavy[0].1);
        assert!(factor(ours, |m| m == "dop853").unwrap() > 2.0);
        let tippe = ranked("tippe-top/100", target);
        assert_eq!(tippe[0].0, "dormand-prince-8");
        assert!(factor(&tippe, |m| m == "dop853").unwrap() > 1.7);
    }
    // Scenes of the book: ours of order 8 is the cheapest everywhere, twice as quick as dop853 on the strip; the yo-yo pays it most.
    let csv = std::fs::read_to_string(file("accuracy-scenes.csv")).unwrap();
    let rows = winners::rows(&csv);
    for target in [1e-3, 1e-6, 1e-9, 1e-12] {
        for (scene, least) in [("strip", 1.8), ("sliding-ball", 1.2), ("yo-yo-asleep", 4.0)] {
            let ranked = winners::ranking(&rows, scene, target);
            assert_eq!(ranked[0].0, "dormand-prince-8", "{scene} {target:e}");
            let peer = factor(&ranked, |method| method == "dop853");
            assert!(
                peer.is_none_or(|factor| factor > least),
                "{scene} {target:e}: {peer:?}"
            );
        }
    }
}
