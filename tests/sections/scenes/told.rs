//! What is told of an error: never less than the error, nor much less of a longer way, and the same whoever asks.

use super::film::file_of_the_book;
use super::top::amplified;
use super::units::{changed, files};
use super::*;
use spinning_bodies::scene::Table;
use spinning_bodies::scene::files::parse;

/// The greatest difference of a number in two tables, in units of the greatest with the same unit.
fn apart(a: &Table, b: &Table) -> f64 {
    let size = |unit: &str| {
        let numbers = b.rows().flat_map(|(_, row)| b.columns.iter().zip(row));
        let alike = numbers.filter(|(column, _)| column.unit == unit);
        let most = greatest(alike.map(|(_, x)| x.abs()));
        // What is zero but for errors, as the slip of what spins in its place, has no size to judge it by.
        if most > 1e-3 { most } else { f64::INFINITY }
    };
    let sizes: Vec<f64> = b.columns.iter().map(|c| size(c.unit)).collect();
    let rows = a.rows().zip(b.rows());
    let numbers = rows.flat_map(|((_, a), (_, b))| a.into_iter().zip(b).zip(sizes.clone()));
    greatest(numbers.map(|((a, b), size)| (a - b).abs() / size))
}

/// Closed forms are judged by steps, steps by finer ones.
#[test]
fn no_error_is_more_than_is_told() {
    let mut better = 0;
    for (name, text) in files() {
        let (scene, request) = parse(&name, &text).unwrap();
        let all = request.times();
        let some = all.iter().copied().step_by(all.len().div_ceil(6));
        let times: Vec<f64> = some.chain([all[all.len() - 1]]).collect();
        let request = request.of_times(&times).unwrap();
        let run = |accuracy: f64, solver: Choice| {
            let request = request.clone().to_accuracy(accuracy).unwrap();
            scene.simulate(&request.by(solver))
        };
        let rough = run(1e-5, Choice::Auto).unwrap();
        let steps = Choice::Use(OURS);
        // A planet is struck in no time, and a ball may slide on ice for ever.
        if let Ok(fine) = run(1e-9, steps) {
            let rougher = run(1e-2, Choice::Auto).unwrap();
            // Sizes at seven times are less than those of the whole way: observed 1.05 to two digits.
            for (table, most) in [(&rough, 1.0), (&rougher, 2.0)] {
                let (told, error) = (table.error_estimate, apart(table, &fine));
                let said = error <= most * told + 1e-9;
                assert!(said, "{name}: {error:e} {told:e}\n{text}");
            }
        }
        if rough.error_estimate < 1e-5 && rough.cost.evaluations > 0 {
            better += 1;
        }
        // Of steps twice ten tolerances are told, and something of every step: a tolerance is a fortieth of the accuracy over the angle.
        let strict = request.clone().to_accuracy(1e-15).unwrap().within(1000);
        let refused = scene.simulate(&strict.by(steps));
        if let (Err(Error::Amplified { reached, .. }), 1..) = (refused, rough.cost.evaluations) {
            let angle = (reached / 4e-16 - 10.0).max(2.0);
            let (told, least) = (rough.error_estimate, 20.5 * 2.5e-7 / angle);
            assert!(told > least, "{name}: {told:e} {least:e}\n{text}");
        }
        let half = request.of_times(&times[..4]).unwrap();
        let half = half.to_accuracy(1e-5).unwrap();
        let sooner = scene.simulate(&half).unwrap().error_estimate;
        let asked = scene.simulate(&asking(&times[..4], 1e-5)).unwrap();
        assert_eq!(sooner, asked.error_estimate, "{name}");
        if rough.cost.evaluations == 0 {
            assert!(sooner <= 1.1 * rough.error_estimate, "{name}\n{text}");
        }
    }
    // Most are better than the accuracy, and say so.
    assert!(better > 10, "{better}");
}

/// Scenes with closed forms: one of the book, the time for which it is asked, and changes.
const CLOSED: &str = r#"cat | 1000.0
cat | 0.3 | n = 0.3 => n = 0.3; pace = "late" #
crawler | 3450.0 | [effects.ground_friction]; coefficient = 0.1; gravity = 9.81 => #
skater | 2.0
skater | 2.0 | to = 0.2 => to = 2.0
swivel | 4.0
swivel | 4.0 | momentum = 0.0 => momentum = -2.6
strip | 0.5 | [initial] => [initial]; velocity = [3.0, -4.0]; omega = -20.0 | lift = [1.7, 1.1] => # | drag => # | rotational => # | added => #
paper-cat | 1.0 | air = 1.2 => # | [initial] => [body]; lever = -0.02; gyration = 0.05; [initial]
egg | 1.0 | gravity = 9.81 => #
yo-yo | 0.5
yo-yo | 1.912"#;

/// Of closed forms two units of 10⁻¹⁵ are told, and as many for each phase and each radian at the fastest rate of the motion, of a path of shapes up to its end.
#[test]
fn what_is_told_of_closed_forms() {
    // In its turn, too, where its angle is as fast as its spin and the time is rounded: 4e-16 of it.
    let spin = (2.0 * 9.81 / (0.5 * 0.029_f64.powi(2) + 0.005_f64.powi(2))).sqrt();
    // Parts of a path of shapes have their greatest rates, 15/8 or 2.73 of the mean, in their middle.
    let strip = 0.5 * ((0.01_f64 * 9.81).sqrt() + 5.0 + 0.2) / 0.01;
    let angles = [
        [3.75 * TAU, 5.46 * TAU, TAU / 0.3 * 1.15].as_slice(),
        &[28.0 * PI, 8.0 * PI, 1.875 * TAU, 1.875 * TAU + 8.0],
        &[strip * (1.0 + 0.2 * strip), (9.81_f64 * 0.02).sqrt() / 0.05],
        &[40.0 * PI, 1.0, 2.0 + 0.2 * spin * 1.912],
    ];
    for (line, angle) in CLOSED.lines().zip(angles.concat()) {
        let mut parts = line.split(" | ");
        let [name, until] = [(); 2].map(|()| parts.next().unwrap());
        let text = file_of_the_book(&format!("{name}.toml"));
        let text = parts.fold(text, |text, change| changed(&text, change));
        let (scene, request) = parse(name, &text).unwrap();
        let request = request.of_times(&[until.parse().unwrap()]).unwrap();
        let told = scene.simulate(&request).unwrap().error_estimate;
        let growth = amplified(scene.simulate(&request.to_accuracy(1e-15).unwrap()))[0];
        let off = [told, growth * f64::EPSILON].map(|x| relative(x, 2e-15 * (1.0 + angle)));
        assert!(greatest(off) < 1e-15, "{line}: {told:e} {growth:e}");
    }
    // From event to event, a rounding for each radian and each phase besides: ten strokes in halves, and more where a foot comes to rest.
    let rough = parse("", &file_of_the_book("crawler.toml")).unwrap();
    let request = rough.1.of_times(&[5.75]).unwrap();
    let told = rough.0.simulate(&request).unwrap().error_estimate;
    let phases = (told - 2e-15 * (1.0 + TAU / 0.3 * 1.15)) / f64::EPSILON - TAU / 0.3 * 5.75;
    assert!((20.0..41.0).contains(&phases), "{phases}");
}

/// The spin of a skater whose arms are still falls as e^−λt. What becomes of a change of its start, in the direction sin 2, sin 3, …, is told with the refusal of more
/// digits than there are.
#[test]
fn what_is_told_of_the_growth_of_a_change() {
    let (spin, lambda, t) = (12.0, 0.3 / 2.0, 3.0);
    let body = spinning_bodies::phenomena::Skater::new(0.8, 2.5).unwrap();
    let reach = 0.24_f64.sqrt();
    let skater = spinning_bodies::scene::shape::Skater::new(body, reach, spin).unwrap();
    let skater = skater.with(BearingFriction::new(0.3).unwrap()).unwrap();
    let [growth, _] = amplified(skater.simulate(&asking([t], 1e-15)));
    let turned = 2.0_f64.sin() + 3.0_f64.sin() * spin * (1.0 - (-lambda * t).exp()) / lambda;
    near!(growth, turned / 5.0_f64.sin().abs(), 7e-6..=3e-4); // observed 4e-5
}

/// Two runs that agree cost what each does alone, by tolerances of half the accuracy over the angle and of a twentieth of that.
#[test]
fn what_two_runs_cost_is_what_each_costs() {
    let fall = [0.02_f64.hypot(0.06) / 0.010, 0.06_f64.hypot(0.03) / 0.014];
    let fall = vector([fall[0], fall[1], 0.03_f64.hypot(0.02) / 0.020]).norm();
    let heavy = 2.0 * (86.0 + 9.80665 * fall).sqrt();
    let tippe = 0.4 * (155.0 + (9.82_f64 / 0.02).sqrt());
    for (name, t, angle) in [("heavy-body", 2.0, heavy), ("tippe-top", 0.4, tippe)] {
        let (scene, _) = parse(name, &file_of_the_book(&format!("{name}.toml"))).unwrap();
        let times: Vec<f64> = (1..9).map(|k| t * f64::from(k) / 8.0).collect();
        let asked = using(&asking(times, 1e-6), OURS);
        let cost = |asked| scene.simulate(&asked).unwrap().cost.evaluations as f64;
        let alone = |part: f64| Effort::Tolerance(part * 0.5e-6 / angle);
        let alone = [1.0, 0.05].map(|part| cost(asked.clone().in_one_run(alone(part))));
        // Each looks at one time more, a radian after the start: eleven evaluations.
        near!(cost(asked), alone[0] + alone[1] + 22.0, 0.01 * alone[0]);
    }
    // Of a ball that glides steps err by nothing: told are four times ten tolerances, and four of each step of the better run, which takes half or two thirds of all.
    let ball = RoundBody::new(0.17, 0.03, 0.4).unwrap();
    let ball = spinning_bodies::scene::Roller::new(ball, 9.81, 2.0, 0.7).unwrap();
    let motion = ball.simulate(&using(&asking([3.0], 1e-2), OURS)).unwrap();
    let told = motion.error_estimate / (2.5e-4 / 16.0) - 40.0;
    let part = told / (4.0 * motion.cost.steps as f64);
    assert!((0.49..0.7).contains(&part), "{part}");
}

#[test]
fn no_times_at_all_are_refused() {
    let request = Request::at([1.0]).unwrap();
    refused!(request.of_times(&[]), Empty);
    refused!(request.of_times(&[f64::NAN]), NotFinite);
}
