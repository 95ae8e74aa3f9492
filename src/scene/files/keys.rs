//! The declaration of a key: its name, the expected value, its bounds, and its row on the page of keys.

use core::f64::consts::PI;

use crate::error::Number;

/// The bounds of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Bound {
    Positive,
    NotNegative,
    /// Positive, and at most this.
    UpTo(f64),
    /// With both bounds included.
    From(f64, f64),
}

impl Bound {
    pub fn holds(self, number: f64) -> bool {
        match self {
            Self::Positive => number > 0.0,
            Self::NotNegative => number >= 0.0,
            Self::UpTo(most) => number > 0.0 && number <= most,
            Self::From(least, most) => (least..=most).contains(&number),
        }
    }
}

/// A declared key.
pub(super) struct Key {
    pub name: &'static str,
    /// The expected value: "a mass in kg".
    pub what: &'static str,
    /// One at most.
    pub bounds: &'static [Bound],
    /// One number at most: that which stands for an absent one, or for each of a list.
    pub default: &'static [f64],
}

impl Key {
    /// The expected value in words: its description, then `shape`, then the bounds.
    pub fn expected(&self, shape: &str) -> String {
        let bound = match *self.bounds {
            [Bound::Positive] => ", positive".to_owned(),
            [Bound::NotNegative] => ", not negative".to_owned(),
            [Bound::UpTo(most)] => format!(", positive, at most {most}"),
            [Bound::From(least, most)] => {
                let told = |bound: f64| match bound {
                    PI => "π".to_owned(),
                    // Counts are written without an exponent.
                    _ if bound.fract() == 0.0 => bound.to_string(),
                    _ => Number(bound).to_string(),
                };
                format!(" from {} to {}", told(least), told(most))
            }
            _ => String::new(),
        };
        format!("{}{shape}{bound}", self.what)
    }
}

/// A key as a row on the page of keys.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyRow {
    /// The table it belongs to, such as `body` or `effects.draw`; empty for the top of the file.
    pub section: String,
    /// The key.
    pub key: &'static str,
    /// The expected value: "a mass in kg, positive".
    pub expected: String,
    /// The default; `None` if the key must be given.
    pub absent: Option<String>,
}
