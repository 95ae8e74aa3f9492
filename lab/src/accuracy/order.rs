//! The measured order of a method.

use super::measure::{Measurement, Status};

/// Errors above this may belong to steps too long for the order to show.
const SMALL: f64 = 1e-2;

/// The slope of log error against log step over the finest runs of a sweep that rounding has not touched, four at most; `None` for fewer than three.
///
/// For methods with a step; the error of those with a tolerance has no order. Rows are in the order of [`Trial::sweep`](super::Trial::sweep), from coarse to fine.
/// The runs next to the floor are left out as well: errors below a hundred times the smallest of the sweep.
pub fn measured_order(rows: &[Measurement]) -> Option<f64> {
    let least = rows
        .iter()
        .map(|row| row.error_attitude)
        .fold(f64::INFINITY, f64::min);
    let clear = |row: &&Measurement| {
        row.status == Status::Ok && row.error_attitude < SMALL && row.error_attitude > 100.0 * least
    };
    let points: Vec<(f64, f64)> = rows
        .iter()
        .filter(clear)
        .map(|row| (row.parameter.ln(), row.error_attitude.ln()))
        .collect();
    let points = &points[points.len().saturating_sub(4)..];
    (points.len() >= 3).then(|| slope(points))
}

/// The slope of the straight line of least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let products: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let squares: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    products / squares
}

#[cfg(test)]
mod tests {
    use super::measured_order;
    use crate::accuracy::{Measurement, Status};

    fn row(step: f64, error: f64) -> Measurement {
        Measurement {
            problem: String::new(),
            method: String::new(),
            parameter: step,
            error_attitude: error,
            error_omega: error,
            evaluations: 1,
            steps: 1,
            seconds: None,
            status: Status::Ok,
            failure: None,
        }
    }

    #[test]
    fn a_cube_has_order_three_and_its_floor_none() {
        let steps = [0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
        let rows: Vec<Measurement> = steps
            .iter()
            .map(|&h| row(h, (0.7 * h * h * h).max(3e-9)))
            .collect();
        let order = measured_order(&rows).unwrap();
        assert!((order - 3.0).abs() < 1e-12, "{order}");
        assert_eq!(measured_order(&rows[6..]), None);
    }
}
