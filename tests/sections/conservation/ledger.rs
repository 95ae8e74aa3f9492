//! The ledger of conserved quantities: what it measures, and what it refuses.

use super::*;
use spinning_bodies::conservation::Entry;
use spinning_bodies::frame::SpaceVector as V;

#[test]
fn ledger_takes_no_nan_for_an_answer() {
    let mut ledger = Ledger::new();
    let e = ledger.open("energy", Law::Conserved, 1.0).unwrap();
    assert!(ledger.is_kept_within(0.0).unwrap());
    refused!(ledger.record(e, f64::NAN), NotFinite, "energy");
    ledger.record(e, 1.0).unwrap();
    // The stain stays.
    assert_eq!(ledger.entries()[0].relative_drift(), f64::INFINITY);
    assert!(!ledger.is_kept_within(1e300).unwrap());
    assert!(ledger.is_kept_within(f64::NAN).is_err());
    assert!(ledger.is_kept_within(-1.0).is_err());
    assert!(ledger.open("nothing", Law::Conserved, f64::NAN).is_err());
    let unscaled = ledger.open_scaled("nothing", Law::Conserved, 0.0, 0.0);
    assert!(unscaled.is_err());
    assert_eq!(ledger.entries().len(), 1, "a refused account is not opened");

    // Accounts of another ledger are refused, not indexed.
    let mut other = Ledger::new();
    refused!(other.record(e, 1.0), Condition);
    other.open_vector("L", V::new(3.0, 0.0, 4.0)).unwrap();
    refused!(other.record(e, 1.0), Condition);
}

#[test]
fn ledger_measures_each_law_its_own_way() {
    let mut ledger = Ledger::new();
    let up = ledger.open("heat", Law::NonDecreasing, 2.0).unwrap();
    let down = ledger.open("energy", Law::NonIncreasing, 2.0).unwrap();
    let same = ledger.open("charge", Law::Conserved, 2.0).unwrap();
    let zero = ledger.open("spin", Law::Conserved, 0.0).unwrap();
    for value in [2.0, 3.0, 2.5, 1.0] {
        ledger.record(up, value).unwrap();
        ledger.record(down, value).unwrap();
        ledger.record(same, value).unwrap();
        ledger.record(zero, 0.0).unwrap();
    }
    let lines: Vec<_> = ledger.entries().iter().map(Entry::relative_drift).collect();
    // The energy's rise from 2 to 3 is a violation; the later fall is not. The heat fell from 3 to 1.
    assert_eq!(lines, [1.0, 0.5, 0.5, 0.0]);
    assert!(ledger.is_kept_within(1.0).unwrap() && !ledger.is_kept_within(0.99).unwrap());
    ledger.record(zero, 1e-300).unwrap();
    // No scale to compare with.
    assert_eq!(ledger.entries()[3].relative_drift(), f64::INFINITY);

    // A vector that turns without changing its length has drifted all the same.
    let mut turning = Ledger::new();
    let l = turning.open_vector("L", V::new(1.0, 0.0, 0.0)).unwrap();
    turning.record_vector(l, V::new(0.0, 1.0, 0.0)).unwrap();
    close!(turning.entries()[0].relative_drift(), 2.0_f64.sqrt(), 3e-16);
    assert!(turning.to_string().starts_with("L "));
}
