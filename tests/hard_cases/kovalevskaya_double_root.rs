//! Kovalevskaya's top on a double root and beside it, against a table of 30 digits.
//!
//! `tests/reference/kovalevskaya_double_root.py` says how the table was made: by power series of 66 and 72 digits.

use spinning_bodies::kovalevskaya_top::Method;
use support::observed;
use support::table::lines;

use super::kovalevskaya::row;
use support::kovalevskaya::errors;

#[test]
fn on_a_double_root_and_beside_it() {
    let table = include_str!("../reference/kovalevskaya_double_root.csv");
    let mut worst = [[0.0_f64; 2]; 4];
    let mut seen = [0; 4];
    let mut separated = 0;
    for cells in lines(table) {
        let (kind, top, t, expected) = row(&cells);
        let group = match kind {
            "beside it" => 0,
            "on it" => 1,
            "in its plane" => 3,
            _ => 2,
        };
        if group % 2 == 1 {
            assert_eq!(top.method(), Method::Elliptic, "{kind} {t}");
        }
        let found = errors(&top.at(t).expect("a state"), &expected);
        println!("{kind} {t} {:?}: {found:?}", top.method());
        // Others are walked: with axis 1 upright, for one, e₁ and e₄ or e₅ meet besides.
        separated += usize::from(group == 2 && top.method() == Method::Separation);
        worst[group] = [0, 1].map(|i| worst[group][i].max(found[i]));
        seen[group] += 1;
    }
    println!("{seen:?} {worst:?} {separated}");
    let [
        [motion, attitude],
        [motion_on_it, attitude_on_it],
        [motion_passing, attitude_passing],
        [motion_in_plane, attitude_in_plane],
    ] = worst;
    assert_eq!(seen, [72, 117, 72, 39]);
    // 63 here; of those next to what is trusted the last bits decide.
    assert!(separated >= 60, "{separated}");
    observed!(motion_in_plane, 4e-16..=2e-15);
    observed!(attitude_in_plane, 3e-16..=2e-15);
    observed!(motion_passing, 8e-15..=6e-14);
    observed!(attitude_passing, 2e-14..=2e-13);
    observed!(motion_on_it, 2e-14..=4e-13);
    observed!(attitude_on_it, 6e-14..=3e-13);
    observed!(motion, 2e-14..=1e-13);
    // 4e-14 as long as those nearest to the double root were walked, at 0.4 ms a unit of time.
    observed!(attitude, 2e-14..=1.2e-13);
}
