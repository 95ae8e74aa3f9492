//! The command line: what it prints, and the exit status it leaves with.

use super::{refused, text};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn book(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_book"))
        .args(arguments)
        .output()
        .unwrap()
}

#[test]
fn wrong_usage_is_told_in_one_line_and_status_2() {
    for (arguments, word) in [
        (&["figure"][..], "'figure'"),
        (&["figures", "--lits"], "'--lits'"),
        (&["figures", "no-such-figure"], "'no-such-figure'"),
        (&["figures", "--list", "no-such-figure"], "'no-such-figure'"),
        (&["figures", "--out"], "--out"),
        (&["figures", "--list", "--check"], "--check"),
        (&["book", "extra"], "'extra'"),
        (&["claims", "--all"], "'--all'"),
    ] {
        let output = book(arguments);
        let told = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        assert_eq!(told.lines().count(), 1, "{arguments:?}: {told}");
        assert!(
            told.starts_with("error: ") && told.contains(word),
            "{arguments:?}: {told}"
        );
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
}

#[test]
fn an_unknown_figure_is_answered_with_the_nearest_name() {
    if let Some(entry) = figures::all().first() {
        let output = book(&["figures", &format!("{}x", entry.name)]);
        assert!(text(&output.stderr).contains(&format!("`{}`", entry.name)));
    }
}

#[test]
fn an_unwritable_folder_is_named_and_status_1() {
    if figures::all().is_empty() {
        return;
    }
    // A file where a folder is wanted fails for everyone, root included.
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("a-file");
    std::fs::write(&file, "").unwrap();
    let output = book(&[
        "figures",
        figures::all()[0].name,
        "--out",
        file.to_str().unwrap(),
    ]);
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(
        told.lines()
            .last()
            .is_some_and(|line| line.contains("a-file")),
        "{told}"
    );
}

#[test]
fn help_teaches_and_is_no_error() {
    for arguments in [
        &["--help"][..],
        &["figures", "--help"],
        &["book", "--help"],
        &["help"],
    ] {
        let output = book(arguments);
        assert_eq!(output.status.code(), Some(0));
        assert!(
            text(&output.stdout).contains("cargo run --"),
            "{arguments:?}"
        );
        assert!(output.stderr.is_empty());
    }
}

#[test]
fn figures_are_listed_with_their_chapters() {
    let output = book(&["figures", "--list"]);
    assert_eq!(output.status.code(), Some(0));
    let listed = text(&output.stdout);
    assert_eq!(listed.lines().count(), figures::all().len());
    for (line, entry) in listed.lines().zip(figures::all()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        assert_eq!(words[..2], [entry.name, &format!("{}.md", entry.chapter)]);
        let numbers = words.get(2).map_or(Ok(0), |count| count.parse());
        assert_eq!(numbers, Ok(entry.parameters.len()));
    }
}

#[test]
fn a_figure_is_drawn_as_it_is_wanted() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let [out, table] = ["svg", "dial.csv"].map(|name| folder.path().join(name));
    let [out_name, table_name] = [&out, &table].map(|path| path.to_str().unwrap());
    let listed = text(&book(&["figures", "--list", "spool-dial"]).stdout);
    assert!(listed.contains("axle = 0.4 (0.05 to 0.95): "), "{listed}");
    let wanted = ["figures", "spool-dial", "--set", "axle=0.6,tension=0.2"];
    let rest = ["--theme", "dark", "--out", out_name, "--data", table_name];
    let output = book(&[&wanted[..], &rest].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    // arccos 0.6, and the caption says so.
    assert!(text(&output.stdout).contains("lower than 53.13 degrees"));
    let svg = std::fs::read_to_string(out.join("spool-dial.svg")).unwrap();
    assert!(svg.contains("53.13°") && svg.contains("background:#161923"));
    let rows = std::fs::read_to_string(table).unwrap();
    let mut lines = rows.lines();
    assert_eq!(lines.next(), Some("curve,angle (°),acceleration (m/s²)"));
    // a = T(R cos θ − r)/(R(M + I/R²)) = 0.2 · (1 − 0.6)/(1.5 · 0.2)
    let level: f64 = lines
        .next()
        .unwrap()
        .split(',')
        .nth(2)
        .unwrap()
        .parse()
        .unwrap();
    assert!((level - 0.08 / 0.3).abs() < 1e-15, "{level}");
}

#[test]
fn a_motion_is_drawn() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let path = folder.path().join("racket.svg");
    let output = ["--output", path.to_str().unwrap()];
    let wanted = ["scene", "racket", "--plot", "omega1:omega2,energy"];
    let done = book(&[&wanted[..], &output].concat());
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let svg = std::fs::read_to_string(&path).unwrap();
    for label in ["omega1, rad/s", "omega2, rad/s", "t, s", "change of energy"] {
        assert!(svg.contains(&format!(">{label}")), "{label}");
    }
    // The polhode is smooth and the colour of Ω, although the file asks for a hundred times.
    let polhode = svg.split("<polyline").find(|line| line.contains("#0b6bcb"));
    assert!(polhode.unwrap().split(' ').count() > 1000);
    for (wrong, told) in [
        (&["--plot", "omg1"][..], "has no column `omg1` to tell"),
        (&["--plot", "omega1:"], "expected COLUMN, or X:Y"),
        (
            &["--plot", "tilt", "--format", "csv"],
            "cannot be used with",
        ),
        (
            &["--plot", "tilt", "--output", "x.csv"],
            "`.svg` or `.pdf` or `.png`",
        ),
    ] {
        let refused = book(&[&["scene", "racket"], wrong].concat());
        let refusal = text(&refused.stderr);
        assert_eq!(refused.status.code(), Some(2));
        assert!(
            refusal.contains(told) && refusal.lines().count() == 1,
            "{refusal}"
        );
    }
}

/// A ball with a weight, free of gravity: its axis goes round L at the rate L/I₁.
const FREE: &str = "[body]\nshape = \"ball-with-weight\"\nmass = 2.0\nradius = 1.0\nweight = 0.25\n\
     weight_at = [0.0, 0.0, 0.8]\n[initial]\nomega = [1.0, 0.0, 3.0]\n[run]\nuntil = 7.0\nsamples = 2\n";

#[test]
fn a_film_shows_the_axis_where_the_closed_form_has_it() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let [scene, film] = ["free.toml", "free.svg"].map(|name| folder.path().join(name));
    std::fs::write(&scene, FREE).unwrap();
    let arguments = [
        "--film",
        "--speed",
        "0.7",
        "--output",
        film.to_str().unwrap(),
    ];
    let done = book(&[&["scene", scene.to_str().unwrap()][..], &arguments].concat());
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let svg = std::fs::read_to_string(&film).unwrap();
    assert!(svg.contains("prefers-reduced-motion") && svg.contains("prefers-color-scheme"));
    assert!(svg.contains("0.7 × real time"));
    let frames: Vec<&str> = svg.split("<g class=\"fig-film").skip(1).collect();
    assert!(frames.len() > 100 && svg.matches("<g ").count() == svg.matches("</g>").count());
    // From the centre of the ball to the weight, on the paper, right and down.
    let bar = |frame: &str| {
        let line = frame.split("stroke-width=\"20\" points=\"").nth(1).unwrap();
        let ends = line.split('"').next().unwrap().split([' ', ',']);
        let ends: Vec<f64> = ends.map(|number| number.parse().unwrap()).collect();
        [ends[2] - ends[0], ends[3] - ends[1]]
    };
    let spin = 0.4 * 0.75 * 2.0;
    let across = spin + 2.0 * 0.25 * 0.75 * 0.64;
    let l = nalgebra::Vector3::new(across, 0.0, 3.0 * spin);
    // Seen from 1.2 rad before the x axis and 0.3 rad above.
    let (se, ce) = 0.3_f64.sin_cos();
    let (sa, ca) = (-1.2_f64).sin_cos();
    let right = nalgebra::Vector3::new(-sa, ca, 0.0);
    let up = nalgebra::Vector3::new(-se * ca, -se * sa, ce);
    let length = -bar(frames[0])[1] / ce;
    let mut farthest = 0.0_f64;
    for (k, frame) in frames.iter().enumerate() {
        let t = 7.0 * k as f64 / (frames.len() - 1) as f64;
        let turn = nalgebra::UnitQuaternion::from_scaled_axis(l * (t / across));
        let axis = turn * nalgebra::Vector3::z() * length;
        let [x, y] = bar(frame);
        farthest = farthest.max((x - right.dot(&axis)).hypot(y + up.dot(&axis)));
    }
    // Four ends rounded to whole units.
    assert!(farthest > 0.1 && farthest < 2.5, "{farthest}");
}

#[test]
fn every_scene_of_the_book_is_filmed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut filmed = 0;
    for scene in std::fs::read_dir(root.join("scenes")).unwrap() {
        let path = scene.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let done = book(&["scene", path.to_str().unwrap(), "--film"]);
        filmed += 1;
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        let svg = text(&done.stdout);
        assert!(svg.len() < 400_000 && svg.ends_with("</svg>\n"), "{path:?}");
        // What is no number is drawn far outside.
        assert!(
            !svg.contains("NaN") && !svg.contains("2147483648"),
            "{path:?}"
        );
    }
    assert!(filmed >= 24, "{filmed}");
    for (wrong, told) in [
        (&["--film", "--speed=-1"][..], "expected a speed from"),
        (
            &["--film", "--speed", "1e3"],
            "expected a speed from 1.667e-1 to 1.000e1",
        ),
        (&["--speed", "1"], "--film"),
        (&["--speed", "1", "--plot", "tilt"], "--speed"),
        (&["--film", "--as", "png"], "--as"),
        (&["--plot", "tlit"], "did you mean `tilt`?"),
        (&["--plot", "x:x"], "has no column `x`"),
        (&["--film", "--plot", "tilt"], "cannot be used with"),
        (&["--film", "--speed", "0"], "expected a speed from"),
        (&["--film", "--output", "x.png"], "should end with `.svg`"),
        (
            &["--frames", "src", "10"],
            "expected an empty folder or a new one",
        ),
        (
            &["--frames", "stills", "0"],
            "expected a whole number from 1 to 10000",
        ),
    ] {
        refused(&book(&[&["scene", "racket"], wrong].concat()), &[told]);
    }
    // A single time is no motion.
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let scene = folder.path().join("once.toml");
    std::fs::write(
        &scene,
        FREE.replace("until = 7.0\nsamples = 2", "times = [1.0, 1.0]"),
    )
    .unwrap();
    for (option, more) in [
        ("--film", &[][..]),
        ("--plot", &["tilt"]),
        ("--frames", &["stills", "2"]),
    ] {
        let done = book(&[&["scene", scene.to_str().unwrap(), option], more].concat());
        let told = "once.toml: key `until` or `times` in [run]: expected times that go on";
        refused(&done, &[option, told]);
    }
}

/// Numbers of an attribute, in the order of the elements that have it.
fn attributes(svg: &str, element: &str, attribute: &str) -> Vec<f64> {
    let begin = format!("<{element} ");
    let elements = svg.split(&begin).skip(1);
    let value = |element: &str| {
        let value = element.split(&format!("{attribute}=\"")).nth(1)?;
        value.split('"').next()?.parse().ok()
    };
    elements.filter_map(value).collect()
}

#[test]
fn a_scan_is_drawn_over_one_range_or_two() {
    // What is told is what is varied, so the points stand on a straight line, in equal steps.
    let over = ["scan", "racket", "--over", "initial.omega.0=0.1..0.5:5"];
    let done = book(&[&over[..], &["--plot", "first:omega1"]].concat());
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let svg = text(&done.stdout);
    assert!(svg.contains(">initial.omega.0<") && svg.contains(">first:omega1, rad/s<"));
    for attribute in ["cx", "cy"] {
        let places = attributes(&svg, "circle", attribute);
        let steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        assert!(steps.len() == 4 && steps.iter().all(|step| step.abs() > 300.0));
        assert!(
            steps.iter().all(|step| (step - steps[0]).abs() <= 1.0),
            "{steps:?}"
        );
    }
    let second = ["--over", "initial.omega.1=1..2:3"];
    let first = ["scan", "racket", "--over", "initial.omega.0=0.1..0.4:4"];
    let done = book(&[&first[..], &second, &["--plot", "first:omega1"]].concat());
    let svg = text(&done.stdout);
    // Four columns of three fields each, the darker the further to the right; then the scale.
    let shades = attributes(&svg, "polygon", "opacity");
    assert_eq!(shades.len(), 12 + 8, "{}", text(&done.stderr));
    let columns: Vec<&[f64]> = shades[..12].chunks(3).collect();
    assert!(
        columns
            .iter()
            .all(|fields| fields.iter().all(|shade| *shade == fields[0]))
    );
    assert!(
        columns.windows(2).all(|pair| pair[0][0] < pair[1][0]),
        "{shades:?}"
    );
    let third = ["--over", "initial.omega.2=1..2:2"];
    let plot = ["--plot", "tilt"];
    let told = "--plot: expected one --over, or two for a map, got 3";
    refused(
        &book(&[&over[..], &second, &third, &plot].concat()),
        &[told],
    );
    refused(
        &book(&[&over[..], &["--plot", "tlt"]].concat()),
        &["has no column `tlt` to tell"],
    );
}

#[test]
fn what_a_method_pays_is_drawn() {
    let done = book(&["accuracy", "--scene", "racket", "--plot"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let svg = text(&done.stdout);
    let named = |method: &&str| svg.contains(&format!(">{method}</text>"));
    for method in [
        "exact",
        "dormand-prince-8",
        "dop853",
        "rk4",
        "moser-veselov-10",
    ] {
        assert!(named(&method), "{method}");
    }
    assert!(!svg.contains("NaN") && svg.contains(">error<"));
    for (wrong, told) in [
        (
            &["--scene", "free-top", "--plot"][..],
            "expected one, such as free-top/10",
        ),
        (&["--plot"], "--scene"),
        (
            &["--scene", "racket", "--plot", "--output", "x.csv"],
            "`.svg` or `.pdf` or `.png`",
        ),
    ] {
        refused(&book(&[&["accuracy"], wrong].concat()), &[told]);
    }
}

#[test]
fn stills_are_whole_and_numbered() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let stills = folder.path().join("stills");
    let wanted = ["scene", "spool", "--frames", stills.to_str().unwrap(), "12"];
    let done = book(&wanted);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let names = std::fs::read_dir(&stills).unwrap();
    let mut names: Vec<_> = names.map(|file| file.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(
        (names.len(), &names[0], &names[11]),
        (12, &"01.svg".into(), &"12.svg".into())
    );
    let last = std::fs::read_to_string(stills.join("12.svg")).unwrap();
    assert!(last.contains(">1.00 s<") && last.ends_with("</svg>\n"));
    assert_eq!(
        book(&wanted).status.code(),
        Some(2),
        "there are stills already"
    );
}

#[test]
fn a_wrong_number_of_a_figure_is_refused_by_name() {
    for (set, told) in [
        (
            "axle=1.5",
            "axle is 1.5, expected a number from 0.05 to 0.95",
        ),
        (
            "axel=0.5",
            "figure spool-dial has no parameter 'axel': expected one of [axle, tension]",
        ),
        ("axle", "'axle' is no KEY=VALUE"),
        ("axle=x", "'axle=x' is no KEY=VALUE"),
    ] {
        let output = book(&["figures", "spool-dial", "--set", set]);
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(text(&output.stderr), format!("error: --set: {told}\n"));
    }
    for wrong in [
        &["figures", "--set", "axle=0.5"][..],
        &["figures", "ice", "spool", "--data", "x"],
    ] {
        assert_eq!(book(wrong).status.code(), Some(2));
    }
}

#[test]
fn figures_are_written_to_the_folder_asked_for() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let out = folder.path().join("svg");
    for entry in figures::all().iter().take(1) {
        let into = out.to_str().unwrap();
        let check = || book(&["figures", entry.name, "--check", "--out", into]);
        let output = book(&["figures", entry.name, "--out", into]);
        assert_eq!(output.status.code(), Some(0));
        let names: Vec<_> = std::fs::read_dir(&out)
            .unwrap()
            .map(|file| file.unwrap().file_name().into_string().unwrap())
            .collect();
        assert_eq!(names, [format!("{}.svg", entry.name)]);
        let output = check();
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));

        let path = out.join(&names[0]);
        let spoilt = std::fs::read_to_string(&path).unwrap().replacen(
            "viewBox=\"0 0 6",
            "viewBox=\"0 0 7",
            1,
        );
        std::fs::write(&path, spoilt).unwrap();
        let output = check();
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stderr).contains(entry.name));
    }
}

#[test]
fn every_claim_is_a_line_of_the_table() {
    let output = book(&["claims"]);
    assert_eq!(output.status.code(), Some(0));
    let table = text(&output.stdout);
    assert!(table.lines().filter(|line| line.starts_with('C')).count() > 200);
    assert!(table.lines().any(|line| line.starts_with("C4.6-7 ")));
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_book"))
        .arg("claims")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "{}", text(&output.stderr));
}

/// A scene file of this many rows, in a folder of its own.
fn racket(rows: usize) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let file = folder.path().join("mine.toml");
    let text = format!(
        "[body]\nmoments = [1.0, 2.0, 3.0]\n[initial]\nomega = [0.01, 1.0, 0.01]\n[run]\nuntil = 10.0\nsamples = {rows}\n"
    );
    std::fs::write(&file, text).unwrap();
    (folder, file)
}

fn scene(file: &Path, arguments: &[&str]) -> Output {
    book(&[&["scene", file.to_str().unwrap()], arguments].concat())
}

fn names(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = files
        .map(|file| file.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn the_name_of_the_output_tells_its_format() {
    let (folder, file) = racket(3);
    let out = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let read = |name: &str| std::fs::read_to_string(out(name)).unwrap();
    for (name, format) in [
        ("a.csv", None),
        ("a.txt", None),
        ("a", None),
        ("b.txt", Some("csv")),
        ("a.json", None),
        ("b.json", Some("json")),
        ("c.txt", Some("json")),
    ] {
        let path = out(name);
        let mut arguments = vec!["--output", &path];
        arguments.extend(format.iter().flat_map(|format| ["--format", format]));
        let output = scene(&file, &arguments);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert!(output.stdout.is_empty() && output.stderr.is_empty());
        let json = name.ends_with("json") || format == Some("json");
        assert!(
            read(name).starts_with(if json { "{" } else { "t,qw" }),
            "{name}"
        );
    }
    let before = names(folder.path());
    for arguments in [
        &["--output", &out("x.svg")][..],
        &["--output", &out("x.svg"), "--format", "csv"],
        &["--output", &out("x.json"), "--format", "csv"],
        &["--output", &out("x.csv"), "--format", "json"],
    ] {
        refused(&scene(&file, arguments), &["x.", "should end with"]);
    }
    let over = [
        "--over",
        "initial.omega.0=0..1:2",
        "--output",
        &out("x.svg"),
    ];
    let scan = book(&[&["scan", file.to_str().unwrap()], &over[..]].concat());
    refused(&scan, &["x.svg", ".csv"]);
    assert_eq!(names(folder.path()), before);
}

#[test]
fn what_cannot_be_written_is_refused_before_any_work() {
    // Half a minute of work, if it were begun.
    let (folder, file) = racket(500_000);
    for (name, words) in [
        ("missing/rows.csv", "no such folder"),
        (".", "not a folder"),
        ("mine.toml", "should end with"),
    ] {
        let path = folder.path().join(name);
        refused(
            &scene(&file, &["--output", path.to_str().unwrap()]),
            &[words],
        );
    }
    assert_eq!(names(folder.path()), ["mine.toml"]);

    let file = folder.path().join("a-file");
    std::fs::write(&file, "").unwrap();
    let output = book(&["figures", "--out", file.join("svg").to_str().unwrap()]);
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert_eq!(told.lines().count(), 1, "{told}");
    assert!(told.contains("a-file"), "{told}");
}

#[test]
fn a_scene_of_the_book_is_found_by_its_name() {
    for name in ["racket", "racket.toml"] {
        let output = book(&["scene", name]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert!(output.stdout.starts_with(b"t,qw"));
    }
    refused(
        &book(&["scene", "racked"]),
        &["racked", "did you mean `racket`?"],
    );
}

#[test]
fn numbers_beyond_the_doubles_are_no_rows() {
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let file = folder.path().join("swivel.toml");
    let text_of = "kind = \"swivel\"\n[body]\nlower = 0.6\nupper = 2.0\n[initial]\nangular_momentum = 1e308\n[run]\nuntil = 1e3\n";
    std::fs::write(&file, text_of).unwrap();
    let output = scene(&file, &[]);
    let told = text(&output.stderr);
    assert_ne!(output.status.code(), Some(0), "{told}");
    assert_eq!(told.lines().count(), 1, "{told}");
    assert!(output.stdout.is_empty());
}

/// A run that takes long, and ends.
const CHIRAL: &str = "kind = \"table-top\"\n[body]\nmass = 0.02\nradius = 0.02\nsurface_center = [0.0, 0.0, 0.006]\n\
    inertia = [3.0e-6, 3.0e-6, 3.2e-6, 0.0, 0.0, 0.0]\n[initial]\ntilt = 0.1\naxial_spin = 155.0\n\
    [effects]\ngravity = 9.82\nfriction_law = \"viscous\"\nfriction = 0.3\n[run]\nuntil = 1e5\nsamples = 11\naccuracy = 1e-6\n";

#[cfg(unix)]
mod unix {
    use super::*;
    use std::io::{BufRead, BufReader};
    use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
    use std::time::{Duration, Instant};

    fn shell(script: &str) -> Output {
        Command::new("sh").args(["-c", script]).output().unwrap()
    }

    fn quoted(path: &Path) -> String {
        format!("'{}'", path.to_str().unwrap())
    }

    const BOOK: &str = env!("CARGO_BIN_EXE_book");

    #[test]
    fn a_link_is_followed() {
        let (folder, file) = racket(3);
        let (other, link, dangling) = (
            folder.path().join("other"),
            folder.path().join("link.csv"),
            folder.path().join("dangling.csv"),
        );
        std::fs::create_dir(&other).unwrap();
        std::fs::write(other.join("rows.csv"), "old").unwrap();
        symlink("other/rows.csv", &link).unwrap();
        symlink("other/new.csv", &dangling).unwrap();
        for path in [&link, &dangling] {
            let output = scene(&file, &["--output", path.to_str().unwrap()]);
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            assert!(path.is_symlink());
            assert!(std::fs::read(path).unwrap().starts_with(b"t,qw"));
        }
        assert_eq!(names(&other), ["new.csv", "rows.csv"]);
        let round = folder.path().join("round.csv");
        symlink("round.csv", &round).unwrap();
        let output = scene(&file, &["--output", round.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(1));
        assert!(round.is_symlink() && text(&output.stderr).contains("round.csv"));
    }

    #[test]
    fn pipes_and_devices_stay_what_they_are() {
        let (folder, file) = racket(3);
        let plain = scene(&file, &[]).stdout;
        let (pipe, link) = (folder.path().join("pipe"), folder.path().join("link"));
        assert!(shell(&format!("mkfifo {}", quoted(&pipe))).status.success());
        symlink(&pipe, &link).unwrap();
        for path in [&pipe, &link] {
            let reader = Command::new("cat")
                .arg(&pipe)
                .stdout(Stdio::piped())
                .spawn()
                .unwrap();
            let output = scene(&file, &["--output", path.to_str().unwrap()]);
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            assert_eq!(reader.wait_with_output().unwrap().stdout, plain);
            let kind = std::fs::metadata(&pipe).unwrap().file_type();
            assert!(kind.is_fifo() && link.is_symlink());
        }
        assert_eq!(names(folder.path()), ["link", "mine.toml", "pipe"]);
        for device in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"] {
            assert_eq!(
                scene(&file, &["--output", device]).stdout,
                plain,
                "{device}"
            );
        }
        // A file that the standard output leads to goes on where it was.
        let rows = folder.path().join("rows");
        let command = format!("{BOOK} scene {} --output /dev/stdout", quoted(&file));
        shell(&format!(
            "(echo before; {command}; echo after) > {}",
            quoted(&rows)
        ));
        let expected = [b"before\n", plain.as_slice(), b"after\n"].concat();
        assert_eq!(std::fs::read(&rows).unwrap(), expected);
        let full = scene(&file, &["--output", "/dev/full"]);
        assert_eq!(full.status.code(), Some(1));
        assert!(text(&full.stderr).contains("/dev/full"));
        let full = shell(&format!("{BOOK} scene {} > /dev/full", quoted(&file)));
        assert_eq!(full.status.code(), Some(1), "{}", text(&full.stderr));
    }

    #[test]
    fn the_input_is_not_overwritten() {
        let (folder, file) = racket(3);
        let at = |name: &str| folder.path().join(name);
        std::fs::rename(&file, at("mine.csv")).unwrap();
        let before = std::fs::read(at("mine.csv")).unwrap();
        std::fs::hard_link(at("mine.csv"), at("hard.csv")).unwrap();
        symlink("mine.csv", at("soft.csv")).unwrap();
        let output = at("mine.csv");
        let name = folder.path().file_name().unwrap();
        for out in ["mine.csv", "hard.csv", "soft.csv", "./mine.csv"] {
            let out = at(out);
            refused(
                &scene(&output, &["--output", out.to_str().unwrap()]),
                &["that is the input"],
            );
        }
        let other = at("..").join(name).join("mine.csv");
        refused(
            &scene(&at("soft.csv"), &["--output", other.to_str().unwrap()]),
            &["that is the input"],
        );
        let from = quoted(&output);
        refused(
            &shell(&format!("{BOOK} scene - --output {from} < {from}")),
            &["that is the input"],
        );
        refused(
            &shell(&format!(
                "{BOOK} scan {from} --over initial.omega.0=0..1:2 --output {from}"
            )),
            &["that is the input"],
        );
        refused(
            &shell(&format!("{BOOK} accuracy --scene {from} --csv {from}")),
            &["that is the input"],
        );
        assert_eq!(std::fs::read(&output).unwrap(), before);
        assert_eq!(names(folder.path()), ["hard.csv", "mine.csv", "soft.csv"]);
    }

    #[test]
    fn files_get_the_rights_that_the_umask_leaves() {
        let (folder, file) = racket(3);
        let mode = |path: &Path| std::fs::metadata(path).unwrap().mode() & 0o777;
        for (umask, rights) in [
            ("022", 0o644),
            ("027", 0o640),
            ("002", 0o664),
            ("077", 0o600),
        ] {
            let out = folder.path().join(format!("{umask}.csv"));
            let svg = folder.path().join(umask);
            let figure = figures::all()[0].name;
            let script = format!(
                "umask {umask}; {BOOK} scene {} --output {} && {BOOK} figures {figure} --out {}",
                quoted(&file),
                quoted(&out),
                quoted(&svg)
            );
            let output = shell(&script);
            assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
            assert_eq!(mode(&out), rights, "{umask}");
            assert_eq!(mode(&svg.join(format!("{figure}.svg"))), rights, "{umask}");
        }
        // What is there keeps its own.
        let out = folder.path().join("022.csv");
        std::fs::set_permissions(&out, std::fs::Permissions::from_mode(0o604)).unwrap();
        assert!(
            scene(&file, &["--output", out.to_str().unwrap()])
                .status
                .success()
        );
        assert_eq!(mode(&out), 0o604);
    }

    /// Starts a long run, waits until it has made something beside its output, and sends the signal.
    fn interrupted(signal: &str, status: i32) {
        let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
        let file = folder.path().join("long.toml");
        std::fs::write(&file, CHIRAL).unwrap();
        let out = folder.path().join("rows.csv");
        std::fs::write(&out, "old").unwrap();
        let mut child = Command::new(BOOK)
            .args(["scene", file.to_str().unwrap()])
            .args(["--output", out.to_str().unwrap()])
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let begin = Instant::now();
        while names(folder.path()).len() < 3 {
            assert!(
                begin.elapsed() < Duration::from_secs(20) && child.try_wait().unwrap().is_none()
            );
            std::thread::sleep(Duration::from_millis(20));
        }
        let kill = format!("kill -{signal} {}", child.id());
        assert!(shell(&kill).status.success());
        assert_eq!(child.wait().unwrap().code(), Some(status));
        assert_eq!(names(folder.path()), ["long.toml", "rows.csv"]);
        assert_eq!(std::fs::read_to_string(&out).unwrap(), "old");
    }

    #[test]
    fn an_interrupted_run_leaves_nothing_behind() {
        interrupted("INT", 130);
        interrupted("TERM", 143);
    }

    #[test]
    fn a_saved_chapter_is_printed_again() {
        let root = press::paths::workspace_root().unwrap();
        let copy = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
        for linked in ["src", "lab", "tests", "figures"] {
            symlink(root.join(linked), copy.path().join(linked)).unwrap();
        }
        let (from, book) = (root.join("book"), copy.path().join("book"));
        std::fs::create_dir(&book).unwrap();
        let copied = ["src", "scenes", "theme", "book.toml"].map(|name| quoted(&from.join(name)));
        let script = format!("cp -r {} {}", copied.join(" "), quoted(&book));
        assert!(shell(&script).status.success());

        let mut child = Command::new(BOOK)
            .args(["book", "--watch"])
            .current_dir(copy.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut told = BufReader::new(child.stdout.take().unwrap()).lines();
        let mut told = || told.next().unwrap().unwrap();
        let complaints = BufReader::new(child.stderr.take().unwrap()).lines();
        let mut complaints = complaints.map(Result::unwrap);
        assert!(told().ends_with("book/build/index.html"));
        assert!(told().starts_with("watching"));

        let chapter = book.join("src/superball.md");
        let before = std::fs::read_to_string(&chapter).unwrap();
        std::fs::write(&chapter, format!("{before}\nA sentence of its own.\n")).unwrap();
        // A file that is still being written may be printed twice.
        let page = || std::fs::read_to_string(book.join("build/superball.html")).unwrap();
        loop {
            assert!(told().starts_with("book/src/superball.md: printed again in "));
            if page().contains("A sentence of its own.") {
                break;
            }
        }

        // What is wrong is told, and the next change mends it; an example is computed elsewhere.
        std::fs::write(&chapter, format!("{before}\n{{{{figure nope}}}}\n")).unwrap();
        let error = complaints.find(|line| line.starts_with("error: "));
        assert!(error.unwrap().contains("'nope'"));
        let changed = before.replacen("```rust\n", "```rust\n// Changed.\n", 1);
        std::fs::write(&chapter, changed).unwrap();
        // Half-saved, the file has no examples: that too is told.
        loop {
            while !told().contains("`cargo test -p book --doc -- superball`") {}
            if page().contains("// Changed.") {
                break;
            }
        }

        let kill = format!("kill -INT {}", child.id());
        assert!(shell(&kill).status.success());
        assert_eq!(child.wait().unwrap().code(), Some(130));
    }

    #[test]
    fn an_early_end_of_the_reader_is_quiet() {
        let (_folder, file) = racket(100_000);
        let script = format!(
            "{{ {BOOK} scene {}; echo $? >&2; }} | head -n 2",
            quoted(&file)
        );
        let output = shell(&script);
        assert_eq!(text(&output.stderr), "0\n");
        assert_eq!(text(&output.stdout).lines().count(), 2);
    }

    #[test]
    fn a_file_without_end_is_refused() {
        for endless in ["/dev/zero", "-"] {
            let output = shell(&format!("{BOOK} scene {endless} < /dev/zero"));
            refused(&output, &["4000000 bytes"]);
        }
    }

    /// Peak of resident memory, kB, asked for until the process is gone.
    #[cfg(target_os = "linux")]
    fn peak(arguments: &[&str]) -> u64 {
        let mut child = Command::new(BOOK)
            .args(arguments)
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let status = format!("/proc/{}/status", child.id());
        let mut peak = 0;
        while child.try_wait().unwrap().is_none() {
            let told = std::fs::read_to_string(&status).unwrap_or_default();
            let line = told.lines().find_map(|line| line.strip_prefix("VmHWM:"));
            let now = line.and_then(|line| line.trim().trim_end_matches("kB").trim().parse().ok());
            peak = now.unwrap_or(0).max(peak);
            std::thread::sleep(Duration::from_millis(2));
        }
        assert!(child.wait().unwrap().success());
        peak
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn memory_stays_small_up_to_the_largest_output() {
        // Observed: 42 MB; of five million rows 63 MB, where a motion is stepped 102 MB. As one JSON value half a million took 1.5 GB.
        let (_folder, file) = racket(600_000);
        let peak = peak(&["scene", file.to_str().unwrap(), "--format", "json"]);
        assert!((20_000..80_000).contains(&peak), "{peak} kB");
        let (_folder, file) = racket(10_000_001);
        refused(&scene(&file, &[]), &["samples", "10000000"]);
    }

    #[test]
    fn a_long_run_tells_how_far_it_is() {
        let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
        let file = folder.path().join("long.toml");
        std::fs::write(&file, CHIRAL).unwrap();
        let mut child = Command::new(BOOK)
            .args(["scene", file.to_str().unwrap()])
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut told = String::new();
        let mut lines = BufReader::new(child.stderr.take().unwrap());
        // After one second and a half; a run that is over by then says nothing.
        lines.read_line(&mut told).unwrap();
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(
            told.starts_with("simulating: t = ") && told.contains("of at most 200 million"),
            "{told}"
        );
    }
}
