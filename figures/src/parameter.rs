//! The parameters of a figure: numbers that its reader may choose.

use core::fmt;

use crate::canvas::Point;

/// The spacing of the values in a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// By equal differences.
    Linear,
    /// By equal ratios.
    Logarithmic,
    /// Whole numbers.
    Whole,
}

/// The spacing in one word.
impl fmt::Display for Spacing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Linear => "linear",
            Self::Logarithmic => "logarithmic",
            Self::Whole => "whole",
        })
    }
}

/// A parameter of a figure: its name on the command line, its meaning, and its range.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    /// Its name on the command line, in `snake_case`.
    pub key: &'static str,
    /// Its letter, as LaTeX.
    pub symbol: &'static str,
    /// Its meaning, without the unit.
    pub meaning: &'static str,
    /// Its unit; empty for a ratio or a count.
    pub unit: &'static str,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// The spacing between them.
    pub spacing: Spacing,
    /// The value in the book.
    pub default: f64,
    /// The position of the point in the picture that can be dragged, if there is one; units of the design.
    pub handle: Option<fn(&Values) -> Point>,
}

impl Parameter {
    /// A parameter with this meaning and unit, spaced by equal differences unless said otherwise; its range is still to be set.
    pub const fn new(
        key: &'static str,
        symbol: &'static str,
        unit: &'static str,
        meaning: &'static str,
    ) -> Self {
        Self {
            key,
            symbol,
            meaning,
            unit,
            range: [0.0, 1.0],
            spacing: Spacing::Linear,
            default: 0.0,
            handle: None,
        }
    }

    /// The same with values from `range[0]` to `range[1]`, `default` in the book; it may be used again by figures that share a meaning.
    pub const fn between(mut self, range: [f64; 2], default: f64) -> Self {
        self.range = range;
        self.default = default;
        self
    }

    /// The same, spaced by equal ratios.
    pub const fn logarithmic(mut self) -> Self {
        self.spacing = Spacing::Logarithmic;
        self
    }

    /// The same in whole numbers.
    pub const fn whole(mut self) -> Self {
        self.spacing = Spacing::Whole;
        self
    }

    /// The same with a point of the picture to drag, whose position `at` gives.
    pub const fn dragged(mut self, place: fn(&Values) -> Point) -> Self {
        self.handle = Some(place);
        self
    }

    /// The value for which the point to be dragged is nearest to a given place; `None` if there is no such point.
    pub fn dragged_to(&self, [x, y]: Point, values: &Values) -> Option<f64> {
        const FEW: u32 = 32;
        let place = self.handle?;
        let away = |share: f64| {
            let there = values.clone().with(self, self.at(share));
            let [a, b] = there.map_or([f64::INFINITY; 2], |values| place(&values));
            (a - x).hypot(b - y)
        };
        let few = (0..=FEW).map(|k| f64::from(k) / f64::from(FEW));
        let (_, near) = few
            .map(|share| (away(share), share))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        // Between its neighbours by the golden section.
        let step = 1.0 / f64::from(FEW);
        let (mut low, mut high) = ((near - step).max(0.0), (near + step).min(1.0));
        for _ in 0..32 {
            let part = 0.382 * (high - low);
            match away(low + part) < away(high - part) {
                true => high -= part,
                false => low += part,
            }
        }
        let between = 0.5 * (low + high);
        // The golden section comes close to an end but does not reach it.
        let kept = away(near) <= away(between);
        Some(self.at(if kept { near } else { between }))
    }

    /// The value at a fraction from 0 to 1 of the range.
    pub fn at(&self, share: f64) -> f64 {
        let [low, high] = self.range;
        let value = match self.spacing {
            Spacing::Linear => low + share * (high - low),
            Spacing::Logarithmic => low * (high / low).powf(share),
            Spacing::Whole => (low + share * (high - low)).round(),
        };
        value.clamp(low, high)
    }

    /// Whether it may have this value.
    fn takes(&self, value: f64) -> bool {
        let [low, high] = self.range;
        (low..=high).contains(&value) && (self.spacing != Spacing::Whole || value.fract() == 0.0)
    }
}

/// Parameters as a table, one a row: key, letter, unit and meaning, range and the book's value; then how it is spaced, and whether it can be dragged.
macro_rules! parameters {
    ($(
        $(#[$doc:meta])* $visible:vis $name:ident: $key:literal, $symbol:literal, $unit:literal, $meaning:literal, $range:expr, $default:expr
        $(, $how:ident $(($($by:expr),+))?)*;
    )+) => {
        $($(#[$doc])* $visible const $name: $crate::parameter::Parameter = $crate::parameter::Parameter::new($key, $symbol, $unit, $meaning)
            .between($range, $default)
            $(.$how($($($by),+)?))*;)+
    };
}

/// One line: name, range, value in the book, meaning.
impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [low, high] = self.range;
        let spaced = match self.spacing {
            Spacing::Linear => String::new(),
            other => format!(", {other}"),
        };
        let unit = if self.unit.is_empty() { "" } else { " " };
        write!(
            f,
            "{} = {} ({low} to {high}{unit}{}{spaced}): {}",
            self.key, self.default, self.unit, self.meaning
        )
    }
}

/// The numbers chosen for a figure; what is not chosen is as in the book.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Values(Vec<(&'static str, f64)>);

impl Values {
    /// The value of a parameter.
    pub fn of(&self, parameter: &Parameter) -> f64 {
        let chosen = self.0.iter().rfind(|(key, _)| *key == parameter.key);
        chosen.map_or(parameter.default, |&(_, value)| value)
    }

    /// The values of several.
    pub fn each<const N: usize>(&self, parameters: [Parameter; N]) -> [f64; N] {
        parameters.map(|parameter| self.of(&parameter))
    }

    /// The same with another value of a parameter, which must be one that it may have.
    ///
    /// # Errors
    /// What was expected, on one line.
    pub fn with(mut self, parameter: &Parameter, value: f64) -> Result<Self, String> {
        if parameter.takes(value) {
            self.0.retain(|(key, _)| *key != parameter.key);
            self.0.push((parameter.key, value));
            return Ok(self);
        }
        let [low, high] = parameter.range;
        let kind = match parameter.spacing {
            Spacing::Whole => "a whole number",
            Spacing::Linear | Spacing::Logarithmic => "a number",
        };
        let unit = if parameter.unit.is_empty() { "" } else { " " };
        // Far from 1 with an exponent, not with three hundred zeros.
        let value = format!("{value:?}");
        Err(format!(
            "{} is {}, expected {kind} from {low} to {high}{unit}{}",
            parameter.key,
            value.trim_end_matches(".0"),
            parameter.unit
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATIO: Parameter = Parameter::new("ratio", "r", "", "a ratio").between([0.5, 8.0], 2.0);

    #[test]
    fn a_value_is_the_default_until_it_is_chosen() {
        let values = Values::default();
        assert_eq!(values.of(&RATIO), 2.0);
        let values = values.with(&RATIO, 3.0).and_then(|v| v.with(&RATIO, 4.0));
        assert_eq!(values.map(|v| v.of(&RATIO)), Ok(4.0));
    }

    #[test]
    fn a_value_outside_is_refused_by_name() {
        for (parameter, value, told) in [
            (RATIO, 8.5, "ratio is 8.5, expected a number from 0.5 to 8"),
            (
                Parameter { unit: "m", ..RATIO },
                f64::NAN,
                "ratio is NaN, expected a number from 0.5 to 8 m",
            ),
            (
                RATIO.whole(),
                2.5,
                "ratio is 2.5, expected a whole number from 0.5 to 8",
            ),
        ] {
            let refused = Values::default().with(&parameter, value);
            assert_eq!(refused, Err(told.to_owned()));
        }
    }

    #[test]
    fn shares_run_through_the_range() {
        assert_eq!([0.0, 0.5, 1.0].map(|s| RATIO.at(s)), [0.5, 4.25, 8.0]);
        let logarithmic = RATIO.logarithmic();
        assert_eq!([0.0, 0.5, 1.0].map(|s| logarithmic.at(s)), [0.5, 2.0, 8.0]);
        assert_eq!(RATIO.whole().at(0.3), 3.0);
    }
}
