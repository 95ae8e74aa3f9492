//! `figures`: listed, drawn as they are wanted, written where they are wanted.

use super::*;
use crate::DRAWINGS;

#[test]
fn an_unknown_figure_is_answered_with_the_nearest_name() {
    if let Some(entry) = ::figures::all().first() {
        let output = book(&["figures", &format!("{}x", entry.name)]);
        assert!(text(&output.stderr).contains(&format!("`{}`", entry.name)));
    }
}

#[test]
fn figures_are_listed_with_their_chapters() {
    let listed = printed(&book(&["figures", "--list"]));
    assert_eq!(listed.lines().count(), ::figures::all().len());
    for (line, entry) in listed.lines().zip(::figures::all()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        assert_eq!(words[..2], [entry.name, &format!("{}.md", entry.chapter)]);
        let numbers = words.get(2).map_or(Ok(0), |count| count.parse());
        assert_eq!(numbers, Ok(entry.parameters.len()));
    }
}

#[test]
fn a_program_is_told_what_a_figure_claims_and_takes() {
    let output = typed("figures --list --format json spool-dial cat-film");
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let named = ["spool-dial", "cat-film"];
    assert_eq!([&told[0]["name"], &told[1]["name"]], named);
    assert_eq!(told[1]["parameters"], serde_json::json!([]));
    let (dial, axle) = (&told[0], &told[0]["parameters"][0]);
    assert_eq!(dial["chapter"], "spool");
    // arccos 0.4
    assert!(dial["claim"].as_str().unwrap().contains("66.42 degrees"));
    let keys = ["key", "unit", "least", "greatest", "scale", "default"].map(|key| &axle[key]);
    let expected = serde_json::json!(["axle", "", 0.05, 0.95, "linear", 0.4]);
    assert_eq!(serde_json::json!(keys), expected);
    // A form is that of the list, whatever else is asked for.
    let drawn = text(&typed("figures spool-dial --format json --out nowhere").stderr);
    assert!(drawn.contains("cannot be used with"), "{drawn}");
}

#[test]
fn a_figure_is_drawn_as_it_is_wanted() {
    let folder = scratch();
    let [out, table] = ["svg", "dial.csv"].map(|name| folder.path().join(name));
    let [out_name, table_name] = [&out, &table].map(|path| path.to_str().unwrap());
    let listed = text(&book(&["figures", "--list", "spool-dial"]).stdout);
    assert!(listed.contains("axle = 0.4 (0.05 to 0.95): "), "{listed}");
    let wanted = ["figures", "spool-dial", "--set", "axle=0.6,tension=0.2"];
    let rest = ["--theme", "dark", "--out", out_name, "--data", table_name];
    // arccos 0.6, and the caption says so.
    let told = printed(&book(&[&wanted[..], &rest].concat()));
    assert!(told.contains("lower than 53.13 degrees"));
    let svg = std::fs::read_to_string(out.join("spool-dial.svg")).unwrap();
    assert!(svg.contains("53.13°") && svg.contains("background:#161923"));
    let rows = std::fs::read_to_string(&table).unwrap();
    let mut lines = rows.lines();
    assert_eq!(lines.next(), Some("curve,angle (°),acceleration (m/s²)"));
    // a = T(R cos θ − r)/(R(M + I/R²)) = 0.2 · (1 − 0.6)/(1.5 · 0.2)
    let level = lines.next().unwrap().split(',').nth(2).unwrap();
    let level: f64 = level.parse().unwrap();
    assert!((level - 0.08 / 0.3).abs() < 1e-15, "{level}");
    // On standard output they stand alone.
    let alone = ["--out", out_name, "--data", "-"];
    assert_eq!(printed(&book(&[&wanted[..], &alone].concat())), rows);
}

#[test]
fn a_folder_that_is_not_there_is_told_before_any_drawing() {
    let output = typed("figures --check --out nowhere");
    let told = text(&output.stderr);
    let at_once = told.starts_with("error: nowhere: ") && told.lines().count() == 1;
    assert!(output.status.code() == Some(1) && at_once, "{told}");
}

#[test]
fn every_row_of_numbers_is_as_wide_as_its_head() {
    let drawn = |one: &&press::drawings::Drawing| !one.figure.data.rows.is_empty();
    for drawing in DRAWINGS.iter().filter(drawn) {
        let table = press::drawings::data(std::slice::from_ref(drawing)).unwrap();
        for line in table.lines() {
            // A comma between quotes is part of a name.
            let apart = line.split('"').step_by(2);
            let commas: usize = apart.map(|part| part.matches(',').count()).sum();
            assert_eq!(commas, drawing.figure.data.columns.len(), "{line}");
        }
    }
}

#[test]
fn a_wrong_number_of_a_figure_is_refused_by_name() {
    let axel = "figure spool-dial has no parameter 'axel': expected one of [axle, tension]; did you mean `axle`?";
    let beyond = "axle is 1e300, expected a number from 0.05 to 0.95";
    for (set, told) in [
        ("axle=1e300", beyond),
        ("axel=0.5", axel),
        ("axle", "'axle' has no value, expected KEY=VALUE"),
        ("axle=x", "axle is 'x', expected a number"),
    ] {
        let output = book(&["figures", "spool-dial", "--set", set]);
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(text(&output.stderr), format!("error: --set: {told}\n"));
    }
    for wrong in ["figures --set axle=0.5", "figures ice spool --data x"] {
        assert_eq!(typed(wrong).status.code(), Some(2));
    }
}

#[test]
fn figures_are_written_to_the_folder_asked_for() {
    let folder = scratch();
    let out = folder.path().join("svg");
    for entry in ::figures::all().iter().take(1) {
        let into = out.to_str().unwrap();
        let check = || book(&["figures", entry.name, "--check", "--out", into]);
        let told = printed(&book(&["figures", entry.name, entry.name, "--out", into]));
        assert!(told.starts_with("1 figure in "), "{told}");
        let names = names(&out);
        assert_eq!(names, [format!("{}.svg", entry.name)]);
        printed(&check());

        let path = out.join(&names[0]);
        let svg = std::fs::read_to_string(&path).unwrap();
        // A coordinate that another processor may round so is no reason to write the file again, two units are.
        let (before, after) = svg.split_once(" x=\"").unwrap();
        let (x, after) = after.split_once('"').unwrap();
        let moved = |by: i64| {
            let x = x.parse::<i64>().unwrap() + by;
            std::fs::write(&path, format!("{before} x=\"{x}\"{after}")).unwrap();
            printed(&book(&["figures", entry.name, "--out", into]));
            std::fs::read_to_string(&path).unwrap() == svg
        };
        assert!(!moved(1) && moved(2));
        let spoilt = svg.replacen("viewBox=\"0 0 6", "viewBox=\"0 0 7", 1);
        std::fs::write(&path, spoilt).unwrap();
        let output = check();
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stderr).contains(entry.name));
    }
}
