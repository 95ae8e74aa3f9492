//! What is told of an error: never less than the error, nor much less of a longer way, and the same whoever asks.

use super::units::files;
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

#[test]
fn no_times_at_all_are_refused() {
    let request = Request::at([1.0]).unwrap();
    refused!(request.of_times(&[]), Empty);
    refused!(request.of_times(&[f64::NAN]), NotFinite);
}
