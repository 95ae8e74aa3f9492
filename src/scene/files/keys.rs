//! What a key is: its name, what is expected after it, and its line on the page of keys.

use core::fmt::Display;

use crate::error::Number;

/// Between what bounds a number must lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Bound {
    Positive,
    NotNegative,
    /// Both included.
    From(f64, f64),
}

impl Bound {
    pub fn holds(self, number: f64) -> bool {
        match self {
            Self::Positive => number > 0.0,
            Self::NotNegative => number >= 0.0,
            Self::From(least, most) => (least..=most).contains(&number),
        }
    }
}

/// A key as it is declared.
pub(super) struct Key {
    pub name: &'static str,
    /// What is expected: "a mass in kg".
    pub what: &'static str,
    pub bound: Option<Bound>,
}

impl Key {
    pub const fn new(name: &'static str, what: &'static str) -> Self {
        Self {
            name,
            what,
            bound: None,
        }
    }

    pub const fn within(self, bound: Bound) -> Self {
        Self {
            bound: Some(bound),
            ..self
        }
    }

    /// What is expected, `shape` said after it, and the bound.
    pub fn expected(&self, shape: impl Display) -> String {
        let bound = match self.bound {
            None => String::new(),
            Some(Bound::Positive) => ", positive".to_owned(),
            Some(Bound::NotNegative) => ", not negative".to_owned(),
            Some(Bound::From(least, most)) => {
                // Counts are not told by an exponent.
                let told = |bound: f64| match bound.fract() {
                    0.0 => bound.to_string(),
                    _ => Number(bound).to_string(),
                };
                format!(" from {} to {}", told(least), told(most))
            }
        };
        format!("{}{shape}{bound}", self.what)
    }
}

/// A key, for a page of keys.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeyRow {
    /// The table it stands in, such as `body` or `effects.draw`; nothing for the file itself.
    pub section: String,
    /// The key.
    pub key: &'static str,
    /// What is expected: "a mass in kg, positive".
    pub expected: String,
    /// What stands for it where it is absent; nothing if it must be there.
    pub absent: Option<String>,
}
