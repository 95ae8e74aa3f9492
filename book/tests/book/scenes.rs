//! Scene files: every one in `book/scenes` runs, their keys may stand in any order, and what is wrong is refused in one line.

use super::RACKET;
use super::priced::{PRICED, Priced};
use std::path::Path;

use press::chapters::{self, CHAPTERS};
use press::paths::files_below;
use press::scenes::{Motion, output, parse, run, simulate};
use spinning_bodies::integrators::Method;
use spinning_bodies::scene::files::{KeyRow, keys};
use spinning_bodies::scene::{Progress, Solver};

#[test]
fn every_scene_of_the_book_runs_and_its_ledger_balances() {
    let mut count = 0;
    for path in files_below(Path::new("scenes")).unwrap() {
        let table = simulate(&path).unwrap_or_else(|error| panic!("{error}"));
        assert!(!table.ledger.entries().is_empty(), "{}", path.display());
        let width = table.columns.len();
        let wide = table.rows().all(|(_, row)| row.len() == width);
        assert!(wide, "{}", path.display());
        count += 1;
    }
    assert!(count >= 4);
}

/// Places and speeds that outgrow what they began with by hundreds are no reason for it to refuse.
#[test]
fn gauss_follows_what_rolls() {
    for name in ["withdrawn-sheet", "billiard-shot"] {
        let text = std::fs::read_to_string(format!("scenes/{name}.toml")).unwrap();
        let [known, stepped] = ["auto", "gauss"].map(|solver| {
            let told = format!("accuracy = 1e-6\nsolver = \"{solver}\"");
            let (scene, request) = parse(name, &text.replace("accuracy = 1e-9", &told)).unwrap();
            scene.simulate(&request).unwrap()
        });
        for ((t, a), (_, b)) in known.rows().zip(stepped.rows()) {
            for (a, b) in a.iter().zip(b) {
                let off = (a - b).abs() / (1.0 + a.abs());
                assert!(off <= 1e-6, "{name} at {t}: {a} {b}");
            }
        }
    }
}

/// A chapter that is not the page on scenes runs it: its name stands in a Rust block that simulates a file.
#[test]
fn every_scene_of_the_book_is_run_by_a_chapter() {
    let mut idle = Vec::new();
    let others = CHAPTERS.iter().filter(|chapter| **chapter != "scenes");
    let sources = others.map(|chapter| chapters::source(Path::new(".."), chapter).unwrap());
    let sources: Vec<_> = sources.collect();
    for path in files_below(Path::new("scenes")).unwrap() {
        let name = path.file_stem().unwrap().to_str().unwrap();
        let told = |block: &str| {
            let whole = block.contains(&format!("\"scenes/{name}.toml\""));
            whole || (block.contains("scenes/{") && block.contains(&format!("(\"{name}\"")))
        };
        let blocks = sources
            .iter()
            .flat_map(|source| source.split("```").skip(1).step_by(2));
        let mut rust = blocks.filter(|block| block.starts_with("rust\n"));
        if !rust.any(|block| block.contains("simulate(") && told(block)) {
            idle.push(name.to_owned());
        }
    }
    assert!(idle.is_empty(), "no chapter runs {}", idle.join(", "));
}

#[test]
fn the_columns_of_a_table_are_found_by_name() {
    let table = simulate("scenes/racket.toml").unwrap();
    let rows = table.numbers(["omega2", "t"]).unwrap();
    for ([omega2, t], (time, row)) in rows.into_iter().zip(table.rows()) {
        assert_eq!((t, omega2), (time, row[5]));
    }
    let error = table.numbers(["omega4"]).unwrap_err().to_string();
    for name in ["omega4", "omega3"] {
        assert!(error.contains(name), "{error}");
    }
}

/// What is written of the scene that a text describes.
fn written(text: &str, format: output::Format) -> String {
    let motion = Motion::of("scene", text).unwrap();
    let mut written = Vec::new();
    format.write(&motion, &mut written).unwrap();
    String::from_utf8(written).unwrap()
}

#[test]
fn the_order_in_which_keys_and_effects_are_listed_changes_nothing() {
    let head = "[body]\nmass = 1.0\nmoments = [1.0, 1.5, 2.0]\ncenter_of_mass = [0.1, 0.0, 0.1]\n";
    let tail = "[run]\ntimes = [2.0, 0.5]\n[initial]\nomega = [0.0, 1.0, 5.0]\n";
    let effects = ["gravity = 9.8", "pivot_friction = 0.05", "air_drag = 0.01"];
    let run = |order: [usize; 3]| {
        let listed: Vec<&str> = order.iter().map(|&i| effects[i]).collect();
        let text = format!("{tail}{head}[effects]\n{}\n", listed.join("\n"));
        written(&text, output::Format::Csv)
    };
    let first = run([0, 1, 2]);
    for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        assert_eq!(run(order), first);
    }
}

#[test]
fn numbers_are_read_back_exactly() {
    let table = simulate(super::saved(RACKET).path()).unwrap();
    let text = written(RACKET, output::Format::Csv);
    let mut lines = text.lines();
    let head = "t,qw,qx,qy,qz,omega1,omega2,omega3,energy";
    assert_eq!(lines.next(), Some(head));
    for ((t, row), line) in table.rows().zip(lines) {
        let read: Vec<f64> = line.split(',').map(|n| n.parse().unwrap()).collect();
        assert_eq!((t, row.as_slice()), (read[0], &read[1..]));
    }
    let json = written(RACKET, output::Format::Json);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(json["plan"]["solver"], "exact");
    let omega = json["rows"][10]["omega2"].as_f64();
    assert_eq!(omega, Some(table.row(10).1[5]));
    assert!(json["ledger"][0]["drift"].as_f64().unwrap() < 1e-15);
}

/// What is right, what is wrong instead, and what the one line must name.
const WRONG: &str = r#"
omega = [0.01, 1.0, 0.01] | omega = [0.01, 1.0] | omega | 3 numbers | got 2
omega = [0.01, 1.0, 0.01] | omega = [0.01, 1.0, inf] | omega | finite | inf
omega = [0.01, 1.0, 0.01] | omega = "fast" | omega | rad/s | string
omega = [0.01, 1.0, 0.01] |  | omega | missing | angular_momentum
omega = | angular_momentum = [1, 0, 0]\nomega = | omega | angular_momentum | exclude
omega = | attitude = [1, 1, 0, 0]\nomega = | attitude | unit quaternion | 1.414
moments = [1.0, 2.0, 3.0] | moments = [1.0, 1.0, 3.0] | moments | I1 + I2 >= I3
moments = [1.0, 2.0, 3.0] | moments = [-1.0, 1.0, 1.0] | moments | negative | -1
moments | mass = 0.0\nmoments | mass | positive | 0
moments | colour = "red"\nmoments | colour | unknown | moments
[effects] | [effects]\ngravity = true | gravity | m/s² | boolean
[effects] | [effects]\npivot_friction = -1.0 | pivot_friction | negative
[effects] | [effects]\ntip_friction = 1.0 | tip_friction | I2/I1 = 1
[effects] | [efects] | efects | unknown | effects
until = 10.0\nsamples = 11 | times = [] | times | 1 to
until = 10.0\nsamples = 11 |  | times | until | missing
samples = 11 | samples = 1000000000 | samples | whole number | 1000000000
samples = 11 | samples = 11.5 | samples | whole number | 11.5
samples = 11 | times = [1.0] | times | until | exclude
samples = 11 | accuracy = 0.0 | accuracy | from 1e-15 to 0.1
samples = 11 | solver = "magic" | solver | exact | dop853 | magic
title = "A racket" | kind = "toop" | kind | top | toop
title = "A racket" | title = 7 | title | quotes | 7
[body] | [body | 3
[effects] | [effects]\ngravity = 9.81 | mass | missing | gravity
[effects] | [[effects]] | effects | must be a table
omega = [0.01 | omega = ["a" | rad/s, got the string
moments = [1.0, 2.0, 3.0] | moments = [0, 0, 0] | moments | zero
until = 10.0 | until = 0 | until | not 0
"#;

/// The same of the other kinds: a file of the book, what is right, what is wrong instead, and the key that the line names first.
const WRONG_KEY: &str = r#"
yo-yo | axle = 0.005 | axle = 0.03 | axle
spool | axle = 0.02 | axle = 0.06 | axle
spool | mass = 0.2 | mass = -1 | mass
spool | tug_angle = 0.5235987755982988 | tug_angle = 4 | tug_angle
spool | tension = 0.3  | tension = 30.0  | tension
superball | height = 0.3 | height = -1 | height
superball | inertia_factor = 0.4 | inertia_factor = 2 | inertia_factor
billiard-shot | gravity = 9.81 | gravity = 0 | gravity
billiard-shot | mass = 0.17 | mass = 0 | mass
billiard-shot | velocity = 2.0 | velocity = -2.0 | velocity
billiard-shot | cue_height = 0.7 | cue_height = 7 | cue_height
billiard-shot | friction = 0.2 | friction = 0.2\nstatic_friction = 0.1 | static_friction
billiard-shot | friction = 0.2 | friction = 0.2\nstatic_friction = -1 | static_friction
tippe-top | inertia = [2.99 | inertia = [-2.99 | inertia
tippe-top | mass = 0.02 | mass = 0.0 | mass
tippe-top | friction = 0.3 | friction = 0.3\npivoting_resistance = -1 | pivoting_resistance
cat | forward = 1.0 | forward = 4.0 | forward
skater | hand = 2.5 | hand = -2.5 | hand
strip | areal_density = 0.08 | areal_density = 0 | areal_density
strip | added_mass = 1.0 | added_mass = -1.0 | added_mass
superball | until = 1.0 | until = 1e20 | times`, `until
superball | ceiling = 0.6 | restitution = 0.1 | tangential_restitution`, `restitution
strip | until = 1.0 | until = -1.0 | times`, `until
crawler | until = 5.75 | until = 1e9 | times`, `until
swivel | until = 4.0 | until = 1e9\nsolver = "dormand-prince-8" | times`, `until
nutation-dies | moments = [2.0e-4, 2.0e-4, 7.0e-5] | moments = [2.0e-4, 2.0e-4, 0.0] | moments
"#;

/// The parts of each row of such a table; `\n` begins a line.
fn parts(table: &str) -> impl Iterator<Item = Vec<String>> {
    let part = |part: &str| part.replace("\\n", "\n");
    let rows = table.trim().lines();
    rows.map(move |row| row.split(" | ").map(part).collect())
}

#[test]
fn a_wrong_number_is_refused_at_its_own_key() {
    for row in parts(WRONG_KEY) {
        let [file, right, wrong, key] = row.as_slice() else {
            panic!("{row:?}")
        };
        let name = format!("scenes/{file}.toml");
        let text = std::fs::read_to_string(&name).unwrap();
        let changed = text.replacen(right, wrong, 1);
        assert_ne!(text, changed, "{right}");
        let error = run(&name, &changed).unwrap_err();
        assert_eq!(error.status(), 2, "{error}");
        let told = error.to_string();
        let (_, from) = told.split_once('`').unwrap();
        let line = told
            .strip_prefix(&format!("{name}:"))
            .and_then(|at| at.split(':').next());
        assert!(
            line.is_some_and(|line| line.parse::<usize>().is_ok()),
            "{told}"
        );
        assert!(from.starts_with(&format!("{key}`")), "{told}");
    }
}

/// Two keys of which a file has one.
const INSTEAD: [(&str, &str, &str); 10] = [
    ("top", "inertia", "moments"),
    ("meteorite", "inertia", "moments"),
    ("table-top", "moments", "inertia"),
    ("roller", "rim_speed", "cue_height"),
    ("roller", "cue_height", "rim_speed"),
    ("top", "angular_momentum", "omega"),
    ("table-top", "semi_axes", "radius"),
    ("table-top", "vertical_spin", "axial_spin"),
    ("yo-yo", "inertia", "radius"),
    ("", "times", "until"),
];

/// A table by its path; some stand within [effects], such as the draw of a skater's arms.
fn section_of<'t>(whole: &'t mut toml::Table, path: &str) -> &'t mut toml::Table {
    path.split('.').fold(whole, |table, step| {
        let empty = || toml::Value::Table(toml::Table::new());
        let inner = table.entry(step).or_insert_with(empty);
        inner.as_table_mut().unwrap()
    })
}

/// A scene with all effects in which one number of a key is set to this, for each place if the key has a list.
fn with_number(priced: &Priced, asked: &KeyRow, number: &str) -> Vec<String> {
    let mut table: toml::Table = priced.file(|_| true).parse().unwrap();
    table["run"] = toml::Value::Table("until = 0.1\naccuracy = 1e-6".parse().unwrap());
    let section = section_of(&mut table, &asked.section);
    for (kind, key, other) in INSTEAD {
        if [priced.kind.as_str(), ""].contains(&kind)
            && key == asked.key
            && !section.contains_key(key)
        {
            section.remove(other);
        }
    }
    let listed = asked.expected.split("list of ").nth(1);
    let length = listed.map(|rest| rest.split(' ').next().and_then(|n| n.parse().ok()));
    let numbers: Vec<String> = match section.get(asked.key) {
        Some(toml::Value::Array(list)) => list.iter().map(ToString::to_string).collect(),
        _ => vec!["0.5".to_owned(); length.flatten().unwrap_or(1)],
    };
    let mut texts = Vec::new();
    for place in 0..numbers.len() {
        let mut numbers = numbers.clone();
        number.clone_into(&mut numbers[place]);
        let text = match length {
            Some(_) => format!("x = [{}]", numbers.join(", ")),
            None => format!("x = {number}"),
        };
        let value: toml::Table = text.parse().unwrap();
        let mut whole = table.clone();
        section_of(&mut whole, &asked.section).insert(asked.key.to_owned(), value["x"].clone());
        texts.push(whole.to_string());
    }
    texts
}

/// Every key of every kind set to what a number can be at worst, one after the other: read, and where the motion is in closed form, followed.
/// Steps through a motion of such sizes may take their time before they are refused.
#[test]
fn no_number_of_any_key_panics_or_goes_unnoticed() {
    const NUMBERS: [&str; 7] = ["-1", "0", "1e308", "1e-308", "nan", "inf", "\"some\""];
    const CLOSED: [&str; 5] = ["meteorite", "roller", "spool", "superball", "swivel"];
    // What is told of follows from a time and a duration, each of them right by itself.
    const TOGETHER: &str = "the time of a run by steps, 100000 cycles at most,";
    let (mut wrong, mut count) = (Vec::new(), 0);
    for priced in PRICED.iter() {
        let asked = [priced.kind.as_str(), "run"]
            .map(|name| keys(name).unwrap())
            .concat();
        for asked in asked {
            // What stands at the top, and words.
            let words = asked.expected.starts_with("one of") || asked.key == "columns";
            if asked.section.is_empty() || words {
                continue;
            }
            for text in NUMBERS
                .iter()
                .flat_map(|number| with_number(priced, &asked, number))
            {
                count += 1;
                let outcome = std::panic::catch_unwind(|| {
                    let (_, _) = parse("a.toml", &text)?;
                    if CLOSED.contains(&priced.kind.as_str()) {
                        let table = run("a.toml", &text)?;
                        let mut numbers = table.rows().flat_map(|(_, row)| row);
                        return Ok(numbers.all(f64::is_finite));
                    }
                    Ok::<_, press::Error>(true)
                });
                let told = match outcome {
                    Err(_) => "panics".to_owned(),
                    Ok(Ok(true)) => continue,
                    Ok(Ok(false)) => "is not finite".to_owned(),
                    Ok(Err(error)) => {
                        let (told, key) = (error.to_string(), format!("`{}`", asked.key));
                        let named = told.contains(&key) || told.contains(TOGETHER);
                        let named = named || error.status() == 1;
                        if named && told.starts_with("a.toml:") {
                            continue;
                        }
                        told
                    }
                };
                wrong.push(format!("{text}{} {told}", asked.key));
            }
        }
    }
    assert!(count > 1000, "{count}");
    super::none(&wrong);
}

#[test]
fn what_is_wrong_is_refused_in_one_line_that_names_it() {
    assert!(parse("racket.toml", RACKET).is_ok());
    for row in parts(WRONG) {
        let [right, wrong, named @ ..] = row.as_slice() else {
            panic!("{row:?}")
        };
        let text = RACKET.replacen(right, wrong, 1);
        assert_ne!(text, RACKET, "{right}");
        let error = parse("racket.toml", &text).unwrap_err();
        assert_eq!(error.status(), 2, "{error}");
        let told = error.to_string();
        assert!(told.starts_with("racket.toml"), "{told}");
        assert_eq!(told.lines().count(), 1, "{told}");
        for name in named {
            assert!(told.contains(name.as_str()), "{told} does not name {name}");
        }
    }
    // A key in quotes may have anything in it, as may a name, and a file may have any number of keys.
    let told = |keys: &str| {
        parse("a\n.toml", &format!("{keys}{RACKET}"))
            .unwrap_err()
            .to_string()
    };
    assert!(told("\"a\\n\\u001b\" = 1\n").starts_with("a .toml:1: key `a  ` is unknown"));
    let many: String = (0..1000).map(|k| format!("k{k} = 1\n")).collect();
    assert_eq!(told(&many).lines().count(), 100);
    // However long a wrong word is, its message is not.
    let long = format!("kind = \"{}\"\n", "x".repeat(10_000));
    assert!(told(&long).len() < 300, "{}", told(&long));
}

/// Numbers that are right one by one, but not together: the file has no mistake, and what is told of the accuracy is what was asked for.
#[test]
fn what_no_double_holds_is_no_mistake_of_a_key() {
    let refused = |name: &str, changes: &[[&str; 2]], named: &str| {
        let mut text = std::fs::read_to_string(format!("scenes/{name}.toml")).unwrap();
        for [right, wrong] in changes {
            assert!(text.contains(right), "{right}");
            text = text.replace(right, wrong);
        }
        let error = run(name, &text).unwrap_err();
        let told = error.to_string();
        assert_eq!(error.status(), 1, "{told}");
        assert!(told.contains(named) && !told.contains("accuracy"), "{told}");
    };
    let tiny = ["[0.01, 6.0, 0.01]", "[0.0, 1e-319, 0.0]"];
    refused("racket", &[tiny], "underflow");
    // A peak that halvings do not resolve, and one whose height no double tells.
    refused("skater", &[["to = 0.2", "to = 1e100"]], "integral");
    let turning = ["momentum = 0.0", "momentum = 1.0"];
    let arms = ["arms_out = 2.0", "arms_out = 2e12"];
    refused("swivel", &[turning, arms], "integral");
}

/// By a friction of −0 a yo-yo would stop before it falls asleep.
#[test]
fn a_zero_has_no_sign() {
    let text = std::fs::read_to_string("scenes/yo-yo-asleep.toml").unwrap();
    let text = text.replace("air_drag = 1.0e-8", "");
    let by = |friction| {
        text.replace(
            "axle_friction = 2.0e-4",
            &format!("axle_friction = {friction}"),
        )
    };
    let [plain, signed] = ["0.0", "-0.0"].map(|zero| written(&by(zero), output::Format::Csv));
    assert_eq!(plain, signed);
}

/// Kinds whose motions are known from event to event: no equations to be followed.
const KNOWN: [&str; 5] = ["meteorite", "roller", "spool", "superball", "crawler"];

#[test]
fn a_run_ends_with_its_budget_and_tells_how_far_it_came() {
    const FEW: u64 = 50;
    let ends = |name: &str, text: &str| {
        let motion = Motion::of(name, text).unwrap();
        let progress = Progress::default();
        let request = motion.request.clone().within(FEW).watched(&progress);
        let told = match motion.run(&request) {
            Ok(table) => panic!("{name}: {table:?}"),
            Err(error) => {
                assert_eq!(error.status(), 1, "{error}");
                error.to_string()
            }
        };
        let after = format!("after {FEW} of the {FEW} evaluations");
        assert!(told.contains(&after), "{told}");
        let (_, time) = told.split_once("t = ").unwrap();
        let time: f64 = time.split(' ').next().unwrap().parse().unwrap();
        let reached = progress.reached();
        assert!((0.0..1.0).contains(&time), "{told}");
        assert_eq!((reached.time, reached.until), (time, 1.0), "{name}");
        assert_eq!(reached.most, FEW);
        assert!(reached.evaluations > FEW, "{name}");
    };
    for priced in PRICED.iter() {
        let text = priced.file(|_| true);
        if KNOWN.contains(&priced.kind.as_str()) {
            let motion = Motion::of(&priced.kind, &text).unwrap();
            let request = motion.request.clone().within(FEW);
            assert!(motion.run(&request).is_ok());
        } else {
            ends(&priced.kind, &text);
        }
    }
    // The other engines: closed forms row by row, steps of one length, and of another method's choice.
    let heavy = PRICED[0].file(|effect| effect == "gravity");
    for (lines, solver) in [
        ("samples = 301", "exact"),
        ("samples = 11", "kick-drift-2"),
        ("samples = 11", "rk4"),
        ("samples = 11", "dopri5"),
        ("samples = 11", "dormand-prince-8"),
    ] {
        let lines = format!("{lines}\nsolver = \"{solver}\"");
        ends(solver, &heavy.replace("samples = 11", &lines));
    }
}

#[test]
fn every_solver_is_found_by_its_name() {
    let all: Vec<Solver> = Solver::all().collect();
    for solver in &all {
        let found = all.iter().find(|other| other.name() == solver.name());
        assert_eq!(found, Some(solver));
        let lines = format!("samples = 11\nsolver = \"{solver}\"");
        let text = RACKET.replace("samples = 11", &lines);
        assert!(parse("racket.toml", &text).is_ok(), "{solver}");
    }
    let names: std::collections::BTreeSet<&str> = all.iter().map(|solver| solver.name()).collect();
    assert_eq!(names.len(), all.len());
    for method in Method::ALL {
        assert!(all.contains(&Solver::General(method)), "{}", method.name());
    }
    let is_geometric = |solver: &&Solver| matches!(solver, Solver::Geometric(_));
    assert_eq!(all.iter().filter(is_geometric).count(), 13);
}

/// Every scene but the free body's refuses a method for free bodies: it names the key, and no number stands where there is none to tell.
#[test]
fn a_solver_that_cannot_run_a_scene_is_refused_by_its_key() {
    let scratch = super::scratch();
    for path in files_below(Path::new("scenes")).unwrap() {
        let name = path.file_name().unwrap();
        if name == "racket.toml" {
            continue;
        }
        let scene = std::fs::read_to_string(&path).unwrap();
        let asked = scene.replace("[run]", "[run]\nsolver = \"moser-veselov-4\"");
        let file = scratch.path().join(name);
        std::fs::write(&file, &asked).unwrap();
        let error = simulate(&file).unwrap_err();
        let told = error.to_string();
        assert_eq!(error.status(), 2, "{told}");
        let line = asked.lines().position(|line| line == "[run]").unwrap() + 2;
        let named = format!(":{line}: key `solver` in [run]: ");
        assert!(told.contains(&named), "{told}");
        assert!(!told.contains("NaN") && !told.contains("got"), "{told}");
    }
}

#[test]
fn a_slip_of_the_pen_is_answered_with_what_was_meant() {
    let told = |text: &str| parse("mine.toml", text).unwrap_err().to_string();
    let line = told(&RACKET.replace("moments", "momnts"));
    let place = "mine.toml:4: key `momnts` in [body] is unknown";
    assert!(line.starts_with(place), "{line}");
    assert!(line.ends_with("did you mean `moments`?"), "{line}");
    let line = told(&RACKET.replace("[effects]", "[effects]\ngravitty = 9.81"));
    assert!(line.ends_with("did you mean `gravity`?"), "{line}");
    let line = told(&format!("kind = \"tippetop\"{RACKET}"));
    assert!(line.ends_with("did you mean `table-top`?"), "{line}");
    // What resembles nothing is not guessed at.
    let line = told(&RACKET.replace("[effects]", "[effects]\nzzz = 1"));
    assert!(!line.contains("did you mean"), "{line}");
}

/// All of them were refused: an integral below the rounding of an angle, an energy below the doubles.
#[test]
fn what_hardly_moves_is_followed() {
    let cat = "kind = \"cat\"\n[body]\nmass = [1, 1]\naxial = [1e-3, 1e-3]\ntransverse = [0.02, 0.02]\nto_joint = [0.2, 0.2]\n\
        [effects.turnover]\nforward = 0\nback = 1\nduration = 1\n[run]\nuntil = 1\nsamples = 1001\n";
    let roller = "kind = \"roller\"\n[body]\nmass = 1\nradius = 1e-60\n[initial]\nvelocity = 1e-120\n\
        [effects]\ngravity = 1e-180\nfriction = 0.2\n[run]\ntimes = [1e60]\n";
    let swivel = "kind = \"swivel\"\n[body]\nlower = 1e-61\nupper = 1e-60\n[effects]\nbearing_friction = 1e-62\n[run]\ntimes = [1]\n";
    let strip = "kind = \"strip\"\n[body]\nwidth = 1e-62\nareal_density = 1e59\nfluid_density = 1e120\n[initial]\nangle = 1\n\
        [effects]\ndrag = [2, 0.5]\n[run]\ntimes = [1e-61]\n";
    let top = "[body]\nmoments = [1e16, 1e16, 1e16]\n[initial]\nomega = [0, 0, 0]\n[effects]\npivot_friction = 1\n[run]\ntimes = [1]\n";
    for (text, rows) in [(cat, 1001), (roller, 1), (swivel, 1), (strip, 1), (top, 1)] {
        let table = simulate(super::saved(text).path());
        let table = table.unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(table.rows().count(), rows);
    }
    // A paper cat that nothing turns costs the same in minutes as in seconds, but for their number.
    let cost = |text: &str| simulate(super::saved(text).path()).unwrap().cost;
    let cat = "kind = \"paper-cat\"\n[body]\nlever = 0\n[initial]\ntilt = 1\n[effects]\nair = 1.2\ngravity = 9.5\n[run]\ntimes = [1]\n";
    let otherwise = cat.replace("9.5", "0.0023193359375").replace("[1]", "[64]");
    assert_eq!(cost(cat), cost(&otherwise));
}

/// A level top that is let go turns at first by Mglt/I about a level axis, less a part of 10⁻²⁴. What rounding leaves of it was 1.18 times what was told.
#[test]
fn what_was_just_let_go_is_as_exact_as_is_told() {
    let text = "[body]\nmass = 1\nmoments = [1.3455248877508177, 1.845483212876755, 1.3455248877508177]\n\
        center_of_mass = [0, -0.013484916288211324, 0]\n[initial]\nomega = [0, 0, 0]\nattitude = [0.5, -0.5, 0.5, 0.5]\n\
        [effects]\ngravity = 2.251315555490974\n[run]\ntimes = [-3.595389843693187e-05]\n";
    let table = simulate(super::saved(text).path()).unwrap();
    let [x, y, z] = table.numbers(["omega1", "omega2", "omega3"]).unwrap()[0];
    let falls =
        0.013484916288211324 * 2.251315555490974 * -3.595389843693187e-5 / 1.3455248877508177;
    let off = x.hypot(y).hypot(z - falls) / f64::abs(falls);
    assert!(
        off <= table.error_estimate,
        "{off:e}, told {:e}",
        table.error_estimate
    );
}

/// What is seen only after it has come to rest is measured by what moved before; an event that nobody asks for is not followed; and how far a sheet has gone
/// matters to no one.
#[test]
fn what_has_come_to_rest_is_told() {
    let damped = "[body]\nmoments = [0.1, 0.1, 0.02]\nmass = 1.0\ncenter_of_mass = [0, 0, -0.3]\n[initial]\nattitude = [0.8, 0.6, 0, 0]\nomega = [0, 0, 0]\n\
                  [effects]\ngravity = 9.81\npivot_friction = 1.0\n[run]\ntimes = [30.0, 60.0]";
    let ball = "kind = \"superball\"\n[body]\nmass = 1.0\n[initial]\nheight = 0.0\nclimb = 1.0\nrim_speed = 3.0\n[effects]\ngravity = 9.81\n\
                restitution = 0.8\ntangential_restitution = -1.0\n[run]\ntimes = [3.0]";
    let lively = "kind = \"superball\"\n[body]\nmass = 1.0\n[initial]\nheight = 0.3\nclimb = -5.0\n[effects]\ngravity = 9.81\nceiling = 0.6\n\
                  restitution = 0.99999999\n[run]\ntimes = [1.0]";
    let sheet = std::fs::read_to_string("scenes/withdrawn-sheet.toml").unwrap();
    let sheet = format!(
        "{}[run]\ntimes = [10000.0]\naccuracy = 1e-12",
        sheet.split("[run]").next().unwrap()
    );
    for (text, column, rest) in [
        (damped, "energy", -0.3 * 9.81),
        (ball, "rim_speed", 3.0),
        (ball, "x", 0.0),
        (lively, "bounces", 8.0),
        (&sheet, "velocity", 0.0),
    ] {
        let (scene, request) = parse(column, text).unwrap();
        let told = scene.simulate(&request).unwrap();
        let [last] = *told.numbers([column]).unwrap().last().unwrap();
        assert!((last - rest).abs() < 2e-15, "{column}: {last:?}");
    }
}

/// A ball that loses a hundred-thousand-millionth of its speed at each of two thousand bounces is where 40 digits have it: its speed is rounded alike each time.
#[test]
fn a_ball_that_hardly_loses_speed_keeps_its_digits() {
    let text = "kind = \"superball\"\n[body]\nmass = 1.0\n[initial]\nheight = 0.05\n[effects]\ngravity = 9.81\nrestitution = 0.99999999999\n\
                [run]\ntimes = [400.0]\naccuracy = 1e-11\ncolumns = [\"climb\"]";
    let (scene, request) = parse("lively", text).unwrap();
    let told = scene.simulate(&request).unwrap();
    let [climb] = told.numbers(["climb"]).unwrap()[0];
    assert!(
        (climb - 0.180_456_979_772_186_02).abs() < 2e-16,
        "{climb:?}"
    );
}

/// Both ends are on the page of keys.
#[test]
fn an_inertia_factor_is_more_than_nil_and_at_most_one() {
    for kind in ["roller", "spool", "superball"] {
        for (factor, fits) in [("0", false), ("1", true), ("1.1", false)] {
            let text = format!("kind = \"{kind}\"\n[body]\ninertia_factor = {factor}\n");
            let told = parse("mine.toml", &text).unwrap_err().to_string();
            let refused = told.contains("positive, at most 1, got ");
            assert_eq!(refused, !fits, "{kind} {factor}: {told}");
        }
    }
}
