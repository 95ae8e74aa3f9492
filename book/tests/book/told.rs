//! What scenes tell of their errors where it has a closed form: of events, of the pace of steps, of how a change of the start grows; and what they cost and keep.

use press::scenes::parse;
use spinning_bodies::Error;
use spinning_bodies::integrators::{Effort, Method};
use spinning_bodies::scene::{Choice, Geometric, Request, Solver, Table};
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

/// These numbers of the scene of such a line at its time, asked for like this.
fn run(line: &str, names: &[&str], asked: impl Fn(Request) -> Request) -> Result<Table, Error> {
    let (time, text) = changed(line);
    let (scene, request) = parse("mine.toml", &text).unwrap();
    let request = asked(request.of_times(&[time]).unwrap());
    scene.telling(names).unwrap().simulate(&request)
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
0.8 | superball | gravity = 9.81 => tangential_restitution = 0.6 | climb = -5.0 => climb = -3.0; rim_speed = 9.0
0.9 | superball | climb = -5.0 => climb = -0.5 | velocity = 2.0 => velocity = 9.0
2.0 | billiard-shot | cue_height = 0.7 => rim_speed = 0.0 | friction = 0.2 => #"#;

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
                    "gravity" => 1.0,
                    "climb" => sense,
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
        // What a ball in flight reaches, seen or not.
        let [high, climb, weight] =
            ["height", "climb", "gravity"].map(|key| of(key).unwrap_or(0.0));
        let fast = climb.hypot((2.0 * weight * high).sqrt());
        let highest = (0.5 * fast * fast / weight).min(of("ceiling").unwrap_or(f64::INFINITY));
        let (least, slowest) = match bounces {
            true => (highest, fast),
            false => (turned.max(radius), pull / mass * t),
        };
        let (length, speed) = (most("m", least), most("m/s", slowest));
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
        // Twins of a superball differ by roundings, and so are no nearer to the derivative.
        let (unit, near) = [(8.0 * f64::EPSILON, 0.01), (1e-15, 0.2)][usize::from(bounces)];
        let events = here.cost.steps as f64 + f64::from(u8::from(bounces));
        let off = relative(here.error_estimate / unit - events, stretched);
        assert!(off < near, "{line}: {off}");
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
1.0 | yo-yo
1.0 | yo-yo | turn_loss = 0.9 => hand = 0.05";

/// To 10⁻¹⁵ no steps will do, for of every radian at the pace of the motion 4·10⁻¹⁶ are told, and of ten more.
#[test]
fn what_is_told_where_no_steps_will_do() {
    // √(2 |z∧MgC/I|), the greatest over all ways to stand.
    let fall = |a: f64, b: f64, moment: f64| (a.hypot(b) / moment).powi(2);
    let fall = fall(0.02, 0.06, 0.010) + fall(0.06, 0.03, 0.014) + fall(0.03, 0.02, 0.020);
    let (heavy, free) = ((86.0 + 9.80665 * fall.sqrt()).sqrt(), 86.0_f64.sqrt());
    let (tippe, even) = (155.0 + (9.82_f64 / 0.02).sqrt(), 16.0 / 5.0);
    let bounce = (25.0 + 2.0 * 9.81 * 0.3_f64).sqrt();
    let (under, open, level) = (bounce / 0.6, 2.0 * 9.81 / bounce, 5.0 / 0.6);
    let spun = (2.0 * 9.81 / (0.5 * 0.029_f64.powi(2) + 25e-6)).sqrt();
    let yo_yo = FRAC_PI_2 * spun * YoYo::disc(0.055, 0.029, 1.0, 0.005).unwrap().radius(0.0);
    // The hand adds to the energy of the fall.
    let hand = yo_yo * (1.0 + 0.05 / (0.055 * 9.81_f64)).sqrt();
    let paces = [heavy, free, tippe, under, open, level, even, yo_yo, hand];
    for (line, pace) in PACED.lines().zip(paces) {
        let (until, text) = changed(line);
        let [reached, _] = refused(&text, &[0.5 * until, until, 0.1 * until]);
        let off = relative(reached, 4e-16 * (10.0 + pace * until));
        assert!(off < 1e-14, "{line}: {reached:e}");
    }
}

/// A ball that glides: of a change of its start by 10⁻¹⁰ of the scales in the direction sin 2, sin 3, …, the speeds become places, which are compared in
/// their own size, at nine times.
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
        let compared = [1, 2, 4, 6, 8, 10, 12, 14, 16].map(|n| apart(t * f64::from(n) / 16.0));
        let expected = greatest(compared) / apart(0.0);
        let off = relative(growth, expected);
        assert!(off < 1e-4, "{velocity} {rim}: {off}");
    }
}

/// A body with three equal moments, of whose rate 2, −1.5, 1.8 parts along its axes are doubted, and of its attitude twice −1.2, 1, 0.8 parts of a radian in space.
#[test]
fn how_the_doubt_of_a_top_grows() {
    let body = "[body]\nmoments = [1.7, 1.7, 1.7]\n[initial]\nomega = [0.0, 0.0, 3.0]\n[effects]\n[run]\nuntil = 1.0\n";
    let [_, growth] = refused(body, &[0.4, 0.9]);
    let turned = |t: f64| {
        let (sine, cosine) = (3.0 * t).sin_cos();
        let x = 2.0 * sine + 1.5 * (1.0 - cosine) - 2.4;
        let y = 2.0 * (1.0 - cosine) - 1.5 * sine + 2.0;
        x.hypot(y).hypot(5.4 * t + 1.6)
    };
    let expected = turned(0.4).max(turned(0.9)) / turned(0.0);
    assert!(relative(growth, expected) < 1e-4, "{growth} {expected}");
}

/// Bounces between floor and ceiling: their cost is extrapolated whenever it has doubled, from a million on. A steady pace ends the run where it exceeds the budget
/// by as much as the budget exceeds what is spent; between two such times the pace may change by a quarter of the part of the budget spent at the first.
#[test]
fn a_steady_run_ends_early() {
    for (slower, bounces, last) in [(1.2, 1e7, 2e6), (1.3, 1e7, 4e6 + 1.0), (1.2, 8.5e6, 4e6)] {
        let (keep, end): (f64, f64) = (1.0 - 1e-7 * slower, 0.6 * bounces);
        let start = "height = 0.3 => height = 0.6 | climb = -5.0 => climb = -1.0";
        let line =
            format!("{end} | superball | gravity = 9.81 => restitution = {keep:?} | {start}");
        // Each flight takes longer by the factor 1/keep.
        let expected = 0.6 * (-last * keep.ln()).exp_m1() / (-keep.ln()).exp_m1();
        match run(&line, &[], |asked| asked.within(4_000_000)) {
            Err(Error::Budget { spent, time, .. }) => {
                assert_eq!(spent as f64, f64::min(last, 4e6), "{line}");
                assert!(relative(time, expected) < 1e-7, "{line}: {time}");
            }
            other => panic!("{line}: {other:?}"),
        }
    }
}

/// The weight and the air turn a strip at rest one way: with that sense from the start it costs as much, with the other it does not.
#[test]
fn a_strip_at_rest_begins_to_turn_as_the_air_turns_it() {
    let starts = "0.2 | -0.2 | 0.2; velocity = [0.3, -0.2] | 0.2; velocity = [-0.3, -0.2] | 0.0; velocity = [0.3, 0.0] | 0.0; velocity = [-0.3, 0.0]";
    for start in starts.split(" | ") {
        let turned = |omega: f64| {
            let change = format!("angle = {start}; omega = {omega:?}");
            let line = format!("0.01 | strip | angle = 0.2 => {change}");
            run(&line, &["omega"], |asked| asked).unwrap()
        };
        let rest = turned(0.0);
        let little = 1e-200_f64.copysign(rest.row(0).1[0]);
        let [with, against] = [little, -little].map(|omega| turned(omega).cost);
        assert!(rest.cost == with && with != against, "{start}");
    }
}

/// Four evaluations a step tell of RK4.
#[test]
fn the_method_asked_for_is_the_one_that_runs() {
    let rk4 = Choice::Use(Solver::General(Method::Rk4));
    let evenly = |asked: Request| asked.by(rk4).in_one_run(Effort::Step(1e-3));
    let cost = run("0.1 | heavy-body", &[], evenly).unwrap().cost;
    assert_eq!(cost.evaluations / 4, cost.steps);
}

/// Scenes, and the quantities in their ledgers.
const KEPT: &str = r#"tippe-top | friction = 0.3 => friction = 0.3; rolling_resistance = 1e-4: energy, energy and what contact has taken
tippe-top | friction_law = "viscous" => # | friction = 0.3 => #: energy, energy and what contact has taken, Jellett's integral, vertical angular momentum
strip | lift => # | drag => #: energy and heat, heat, horizontal impulse, vertical impulse and that of the weight
billiard-shot | rolling_resistance = 0.01 => #: angular momentum about the table, energy plus heat less work, kinetic energy
nutation-dies | gravity => #: energy, energy and what resistance took, size of the angular momentum
sleeping-top | tip_friction => #: energy, angular momentum about the vertical, angular momentum about the axis of symmetry"#;

#[test]
fn what_a_scene_keeps_is_in_its_ledger() {
    for line in KEPT.lines() {
        let (scene, names) = line.split_once(": ").unwrap();
        let table = run(&format!("0.1 | {scene}"), &[], |asked| asked).unwrap();
        let kept: Vec<_> = table
            .ledger
            .entries()
            .iter()
            .map(|entry| entry.name)
            .collect();
        assert_eq!(kept.join(", "), names, "{line}");
    }
}

/// Numbers that are known, and where: dry friction at the tip takes the spin evenly, to the last of it, and gives none; the centre of mass of a cone is above the
/// place on its axis, from the tip, where it is held; a planet that nothing strikes flies straight on; half-way through a phase the arms, or the twist, have gone half the way.
const KNOWN: &str = r#"
38.19594760547381 omega3 0.3 | sleeping-top | tip_friction = 6.54e-5 => tip_friction = 0.01
0.0 omega3 0.6 | sleeping-top | tip_friction = 6.54e-5 => tip_friction = 0.01
0.0 omega3 0.7 | sleeping-top | omega = [0.0, 0.0, 81.05309046261666] => omega = [0.5, 0.0, 0.0]
0.89999955 height 0.0 | sleeping-top | moments => shape = "cone"; radius = 0.3; height = 0.8; pivot = [0.0, 0.0, -0.3] # | center_of_mass => #
6.0 x 2.0 | meteorite | [initial] => [initial]; velocity = [3.0, 0.0, 0.0] | impact_mass => # | impact_velocity => # | impact_at => #
1.35 upper_moment 1.5 | swivel
0.7853981633974483 twist 2.5 | swivel"#;

#[test]
fn numbers_that_are_known() {
    for line in KNOWN.lines().skip(1) {
        let [known, name, line] = line.splitn(3, ' ').collect::<Vec<_>>().try_into().unwrap();
        let told = run(line, &[name], |asked| asked).unwrap().row(0).1[0];
        let off = told - known.parse::<f64>().unwrap();
        assert!(off.abs() <= 1e-7 * told.abs(), "{line}: {off}");
    }
}

/// Where neither the closed form nor steps keep the accuracy asked, the better of the two errors is told.
#[test]
fn of_two_errors_the_better_one_is_told() {
    let upright = "[body]\nmoments = [2.0, 2.0, 1.0]\nmass = 1.0\ncenter_of_mass = [1.0, 0.0, 0.0]\n[initial]\nomega = [0.1, 0.2, 0.3]\n\
         [effects]\ngravity = 1.0\n[run]\ntimes = [1000.0]\n";
    // Over half a radian there is next to no rounding in steps.
    let briefly = upright
        .replace("[1.0, 0.0, 0.0]", "[0.0, 0.0, 1.0]")
        .replace("[1000.0]", "[0.5]\naccuracy = 1e-15");
    let steps = Solver::Geometric(Geometric::DormandPrince8);
    for (text, better, worse, size) in [
        (upright, Solver::Exact, steps, 1e-10),
        (&briefly, steps, Solver::Exact, 1e-15),
    ] {
        let (scene, request) = parse("mine.toml", text).unwrap();
        let told = |choice| match scene.simulate(&request.clone().by(choice)) {
            Err(Error::Amplified { reached, .. }) => reached,
            other => panic!("{other:?}"),
        };
        let [less, more] = [better, worse].map(|solver| told(Choice::Use(solver)));
        assert_eq!(told(Choice::Auto), less);
        assert!(
            less < 10.0 * size && size < less && less < more,
            "{less:e} {more:e}"
        );
    }
}

#[test]
fn tip_friction_wants_axes_without_products() {
    let askew = "[body]\ninertia = [1.0, 1.1, 1.2, 0.1, 0.0, 0.0]\nmass = 1.0\ncenter_of_mass = [0.0, 0.0, 0.1]\n[initial]\nomega = [0.0, 0.0, 3.0]\n\
         [effects]\ngravity = 1.0\ntip_friction = 1e-3\n[run]\nuntil = 1.0\n";
    let told = parse("mine.toml", askew).unwrap_err().to_string();
    assert!(
        told.contains("without products of inertia in kg m², got 0.1"),
        "{told}"
    );
}

/// The slip jumps there, and may be that on the sheet or that on the table.
#[test]
fn a_row_on_the_edge_of_a_sheet_is_given() {
    // In that time the sheet goes 0.12 m, and the ball ½ × 0.3 × 9.81 × 0.05² after it.
    let edge = "0.05 | withdrawn-sheet | sheet_margin = 0.15 => sheet_margin = 0.11632125";
    let table = run(edge, &["x", "velocity"], |request| request).unwrap();
    let [x, velocity] = table.numbers(["x", "velocity"]).unwrap()[0];
    assert!(relative(x, 0.003_678_75) < 1e-12 && relative(velocity, 0.147_15) < 1e-12);
    assert!(table.error_estimate < 1e-10);
}
