//! What scenes tell of their errors where it has a closed form: of events, of the pace of steps, of how a change of the start grows.

use press::scenes::parse;
use spinning_bodies::Error;
use spinning_bodies::scene::{Choice, Geometric, Request, Solver};
use spinning_bodies::yo_yo::YoYo;
use std::f64::consts::FRAC_PI_2;
use support::{greatest, relative};

/// The time, s, and the text of "3.0 | spool | axle = 0.02 => axle = 0.01; mass = 0.3": a scene of the book with changes, in which semicolons stand for ends of lines.
fn changed(line: &str) -> (f64, String) {
    let mut parts = line.split(" | ");
    let [time, name] = [(); 2].map(|()| parts.next().unwrap());
    let text = std::fs::read_to_string(format!("scenes/{name}.toml")).unwrap();
    let change = |text: String, change: &str| {
        let (piece, other) = change.split_once(" => ").unwrap();
        assert!(text.contains(piece), "{change}");
        text.replacen(piece, &other.replace("; ", "\n"), 1)
    };
    (time.parse().unwrap(), parts.fold(text, change))
}

/// The error that steps tell where 10⁻¹⁵ is asked, and by how much a change of the start grows.
fn refused(text: &str, times: &[f64]) -> [f64; 2] {
    let (scene, _) = parse("mine.toml", text).unwrap();
    let asked = Request::at(times).unwrap().to_accuracy(1e-15).unwrap();
    let steps = Choice::Use(Solver::Geometric(Geometric::DormandPrince8));
    match scene.simulate(&asked.by(steps)) {
        Err(Error::Amplified {
            reached, growth, ..
        }) => [reached, growth],
        other => panic!("{other:?}"),
    }
}

/// What rolls and what bounces: the time for which it is asked, the scene of the book, and changes.
const STRETCHED: &str = r#"
3.0 | billiard-shot | cue_height = 0.7 => rim_speed = -4.0 | shape = "ball" => inertia_factor = 0.4 | rolling_resistance = 0.01 => #
0.2 | billiard-shot | cue_height = 0.7 => rim_speed = 9.0 | shape = "ball" => inertia_factor = 0.6 | velocity = 2.0 => velocity = -0.3
2.0 | spool | tug_angle = 0.5235987755982988 => tug_angle = 0.0 | [effects] => [initial]; velocity = 1.5; rim_speed = 0.3; [effects]
0.7 | spool | tug_angle = 0.5235987755982988 => tug_angle = 0.0 | friction = 0.5 => friction = 0.1; rolling_resistance = 0.02
1.0 | superball | velocity = 2.0 => velocity = 2.0; rim_speed = 0.7
2.0 | superball | ceiling = 0.6 => restitution = 0.9; tangential_restitution = 0.8 | climb = -5.0 => climb = 4.0; rim_speed = 0.7
0.9 | superball | gravity = 9.81 => tangential_restitution = 0.6 | climb = -5.0 => climb = -3.0; rim_speed = 9.0"#;

/// From event to event all is known but for rounding: 8 ε of a stretch or 10⁻¹⁵ of a bounce are told, and of the start and the laws as many times what the motion
/// makes of a change of each of them by its own fraction of one.
#[test]
fn what_is_told_between_events() {
    for line in STRETCHED.lines().skip(1) {
        let ((t, text), bounces) = (changed(line), line.contains("superball"));
        let of = |key: &str| {
            let mut values = text.lines().filter_map(|line| line.split_once(" = "));
            let value = values.find(|(own, _)| *own == key)?.1.split(' ').next();
            value?.parse::<f64>().ok()
        };
        let rolls = "x velocity rim_speed slip turned heat driven";
        let names = [rolls, "x height velocity climb rim_speed"][usize::from(bounces)];
        let names: Vec<_> = names.split(' ').collect();
        let run = |h: f64, sense: f64| {
            let moved = |line: &str| {
                let key = line.split(" = ").next().unwrap();
                // Of a spool, whose string pulls 0.7 h less, the couple is 0.6 h more.
                let fraction = match key {
                    "gravity" if bounces => -0.6,
                    "gravity" | "climb" => 1.0,
                    "inertia_factor" if !bounces => 0.5 * sense,
                    "velocity" => 0.8 * sense,
                    "rim_speed" => -0.9,
                    "height" | "tension" => -0.7,
                    "axle" => 1.3,
                    _ => return format!("{line}\n"),
                };
                format!("{key} = {:?}\n", of(key).unwrap() * (1.0 + fraction * h))
            };
            let text: String = text.lines().map(moved).collect();
            let (scene, _) = parse(line, &text).unwrap();
            let asked = Request::at([0.0, 0.3 * t, t]).unwrap();
            let asked = asked.by(Choice::Use(Solver::Events));
            scene.telling(&names).unwrap().simulate(&asked).unwrap()
        };
        let here = run(0.0, 1.0);
        let most = |kind: &str, least: f64| {
            let rows = here.rows().map(|(_, row)| here.columns.iter().zip(row));
            let alike = rows.flatten().filter(|(column, _)| column.unit == kind);
            alike.fold(least, |most, (_, x)| most.max(x.abs()))
        };
        let [mass, radius] = ["mass", "radius"].map(|key| of(key).unwrap_or(0.0));
        let turned = most("rad", 0.0) * radius;
        // The string pulls along the table, and at the axle.
        let pull = of("tension").map_or(0.0, |pull| pull * (1.0 + of("axle").unwrap() / radius));
        let (length, speed) = (most("m", turned.max(radius)), most("m/s", pull / mass * t));
        let size = |unit: &str| match unit {
            "m" => length,
            "rad" => length / radius,
            "m/s" => speed,
            _ => most("J", mass * 0.5 * speed * speed),
        };
        let sizes = here.columns.iter().map(|column| size(column.unit));
        let stretched = greatest([1.0, -1.0].map(|sense| {
            let moved = run(1e-7, sense);
            let rows = here.rows().zip(moved.rows());
            let pairs = rows.flat_map(|((_, a), (_, b))| a.into_iter().zip(b).zip(sizes.clone()));
            greatest(pairs.map(|((a, b), size)| (a - b).abs() / 1e-7 / size))
        }));
        let unit = [8.0 * f64::EPSILON, 1e-15][usize::from(bounces)];
        let events = here.cost.steps as f64 + f64::from(u8::from(bounces));
        let off = relative(here.error_estimate / unit - events, stretched);
        assert!(off < 0.01, "{line}: {off}");
    }
}

/// Scenes that are asked of steps.
const PACED: &str = "2.0 | heavy-body
2.0 | heavy-body | gravity = 9.80665 => #
0.5 | tippe-top
0.7 | superball
0.7 | superball | ceiling = 0.6 => #
0.7 | superball | gravity = 9.81 => #
5.0 | billiard-shot
1.0 | yo-yo";

/// To 10⁻¹⁵ no steps will do, for of every radian at the pace of the motion 4·10⁻¹⁶ are told, and of ten more.
#[test]
fn what_is_told_where_no_steps_will_do() {
    // √(2 |z∧MgC/I|), the greatest over all ways to stand.
    let fall = |a: f64, b: f64, moment: f64| (a.hypot(b) / moment).powi(2);
    let fall = fall(0.02, 0.06, 0.010) + fall(0.06, 0.03, 0.014) + fall(0.03, 0.02, 0.020);
    let (heavy, free) = ((86.0 + 9.80665 * fall.sqrt()).sqrt(), 86.0_f64.sqrt());
    let (tippe, glides) = (155.0 + (9.82_f64 / 0.02).sqrt(), 16.0 / 5.0);
    let bounce = (25.0 + 2.0 * 9.81 * 0.3_f64).sqrt();
    let (under, open, straight) = (bounce / 0.6, 2.0 * 9.81 / bounce, 5.0 / 0.6);
    let spun = (2.0 * 9.81 / (0.5 * 0.029_f64.powi(2) + 25e-6)).sqrt();
    let yo_yo = FRAC_PI_2 * spun * YoYo::disc(0.055, 0.029, 1.0, 0.005).unwrap().radius(0.0);
    let paces = [heavy, free, tippe, under, open, straight, glides, yo_yo];
    for (line, pace) in PACED.lines().zip(paces) {
        let (until, text) = changed(line);
        let [reached, _] = refused(&text, &[0.5 * until, until, 0.1 * until]);
        let off = relative(reached, 4e-16 * (10.0 + pace * until));
        assert!(off < 1e-14, "{line}: {reached:e}");
    }
}

/// A ball that glides: of a change of its start by 10⁻¹⁰ of the scales in the direction sin 2, sin 3, …, the speeds become places, which are compared in
/// their own size, at eight times.
#[test]
fn how_a_change_of_what_glides_grows() {
    for (velocity, rim, t) in [(2.0_f64, 0.7_f64, 3.0), (0.01, -3.0, 0.2), (0.0, 0.1, 1.0)] {
        let text = format!(
            "kind = \"roller\"\n[body]\nmass = 0.17\nradius = 0.03\n[initial]\nvelocity = {velocity:?}\nrim_speed = {rim:?}\n[effects]\ngravity = 9.81\n\
             [run]\nuntil = 1.0\n"
        );
        let [_, growth] = refused(&text, &[t]);
        let speed = greatest([velocity.abs(), rim.abs(), (9.81_f64 * 0.03).sqrt()]);
        let moved = |n: i32| f64::from(2 + n).sin();
        // Those of the slip, of heat, work and the distance from a sheet stay.
        let slip = moved(3).abs() / ((velocity - rim).abs() / speed).max(1.0);
        let same = greatest([slip, moved(5).abs(), moved(6).abs(), moved(7).abs()]);
        let apart = |t: f64| {
            let places = [(0, 1, velocity), (4, 2, rim)].map(|(place, faster, own)| {
                let off = moved(place) * 0.03 + t * moved(faster) * speed;
                let off = off.abs() / (own * t).abs().max(0.03);
                off.max(moved(faster).abs() / (own.abs() / speed).max(1.0))
            });
            greatest(places).max(same)
        };
        let expected = greatest((1..9).map(|n| apart(t * f64::from(n) / 8.0))) / apart(0.0);
        let off = relative(growth, expected);
        assert!(off < 1e-4, "{velocity} {rim}: {off}");
    }
}
