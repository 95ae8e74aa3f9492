//! Kovalevskaya's top on a double root and beside it, against a table of 30 digits.
//!
//! `tests/reference/kovalevskaya_double_root.py` says how the table was made: by power series of 66 and 72 digits.

use spinning_bodies::frame::BodyVector;
use spinning_bodies::kovalevskaya_top::{AttitudeMethod, KovalevskayaTop, Method};
use support::decimal::hexadecimal;
use support::observed;
use support::power_series::Whole;

use super::kovalevskaya::errors;

#[test]
fn starts_with_z_along_axis_three_and_nearly_so() {
    let table = include_str!("../reference/kovalevskaya_double_root.csv");
    let mut worst = [[0.0_f64; 2]; 2];
    let mut seen = [0, 0];
    let mut refused = 0;
    for line in table.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let given: Vec<f64> = cells[1..11].iter().map(|x| hexadecimal(x)).collect();
        let &[axial, c1, c2, o1, o2, o3, u1, u2, u3, t] = &given[..] else {
            panic!("{line}");
        };
        let top = KovalevskayaTop::with_up(
            [2.0 * axial, 2.0 * axial, axial],
            BodyVector::new(c1, c2, 0.0),
            BodyVector::new(o1, o2, o3),
            BodyVector::new(u1, u2, u3),
        )
        .expect("a top");
        let decimals: Vec<f64> = cells[11..]
            .iter()
            .map(|x| x.parse().expect("a decimal"))
            .collect();
        let expected: Whole = decimals.try_into().expect("ten numbers");
        let on_it = cells[0] == "on it";
        if on_it {
            assert_eq!(top.method(), Method::Elliptic, "{line}");
            assert_eq!(top.attitude_method(), AttitudeMethod::Algebraic, "{line}");
        }
        let Ok(state) = top.at(t) else {
            assert!(!on_it, "{line}");
            refused += 1;
            continue;
        };
        let found = errors(&state, &expected);
        println!(
            "{} {t} {:?}: {found:?} {o1} {o2} {o3}",
            cells[0],
            top.method()
        );
        let group = usize::from(on_it);
        worst[group] = [0, 1].map(|i| worst[group][i].max(found[i]));
        seen[group] += 1;
    }
    println!("{seen:?} {refused} {worst:?}");
    let [[motion, attitude], [motion_on_it, attitude_on_it]] = worst;
    assert_eq!(seen[1], 117);
    assert_eq!((seen[0], refused), (72, 0));
    observed!(motion_on_it, 1e-13..=4e-13);
    observed!(attitude_on_it, 6e-14..=3e-13);
    observed!(motion, 7e-15..=4e-14);
    observed!(attitude, 8e-15..=4e-14);
}
