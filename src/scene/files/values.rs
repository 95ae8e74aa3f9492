//! The values of keys, and the macros that declare tables of them, once for the reader and for the page of keys.

use toml::de::DeValue;

use super::keys::Key;
use super::reader::{Place, Toml, Value, meant};

use crate::error::Number;
use crate::frame::{Attitude, BodyVector};
use crate::scene::effects::*;
use crate::scene::{Choice, Solver};

/// Declares tables: a struct each, with a line for each key, `name: type, "the expected value, with its unit", bound;`, without the bound where any number
/// will do. An `Option` may be absent; `name: type = value` gives a default. The keys of a nested table are read from the outer one, those of an
/// `Option` from a table of their own.
macro_rules! section {
    ($($(#[$doc:meta])* $name:ident {
        $($field:ident: $type:ty $(= $default:expr)?, $what:expr $(, $bound:expr)?;)*
    })*) => {$(
        $(#[$doc])*
        pub(super) struct $name {
            $(pub $field: $type,)*
        }

        $crate::scene::files::values::keys! { $name {
            $($field: $type $(= $default)?, $what $(, $bound)?;)*
        }}
    )*};
}
pub(super) use section;

/// Declares the keys of a struct that exists already, named like its fields.
macro_rules! keys {
    ($name:ty {
        $($field:ident: $type:ty $(= $default:expr)?, $what:expr $(, $bound:expr)?;)*
    }) => {
        const _: () = {
            use toml::de::DeValue;
            use $crate::scene::files::keys::Key;
            use $crate::scene::files::reader::{Place, Section, Table, Toml, Value};

            impl Section for $name {
                #[allow(unused_variables, reason = "a table may have no keys")]
                fn fields(table: &Table<'_>) -> Option<Self> {
                    $(
                        let bound = None $(.or(Some($bound)))?;
                        let key = Key::new(stringify!($field), $what, bound);
                        let $field = <$type as Value>::take(table, &key, None $(.or(Some(($default, format!("{:?}", $default)))))?);
                    )*
                    Some(Self { $($field: $field?,)* })
                }
            }

            impl Value for $name {
                const IS_TABLE: bool = true;

                fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
                    match value.get_ref() {
                        DeValue::Table(entries) => {
                            Table::new(place.table.reader, place.path(), Some(entries)).section()
                        }
                        _ => place.unexpected(value, "a table"),
                    }
                }

                fn take(table: &Table<'_>, _: &Key, _: Option<(Self, String)>) -> Option<Self> {
                    Self::fields(table)
                }
            }
        };
    };
}
pub(super) use keys;

impl<T: Value> Value for Option<T> {
    const IS_TABLE: bool = T::IS_TABLE;

    fn expected(key: &Key) -> String {
        T::expected(key)
    }

    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        T::read(place, value).map(Some)
    }

    fn absent() -> Option<(Self, String)> {
        Some((None, String::new()))
    }
}

/// The number, if the value is one.
pub(super) fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Float(number) => number.as_str().parse().ok(),
        DeValue::Integer(number) if number.radix() == 10 => number.as_str().parse().ok(),
        DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix())
            .ok()
            .map(|number| number as f64),
        _ => None,
    }
}

impl Value for f64 {
    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        let expected = place.key.expected("");
        match number(value.get_ref()) {
            None => place.unexpected(value, &expected),
            Some(number) if !number.is_finite() => {
                place.wrong(value, format_args!("{expected}, and finite, got {number}"))
            }
            Some(number) if place.key.bound.is_some_and(|bound| !bound.holds(number)) => {
                let shown = place.table.reader.shown(value);
                place.wrong(value, format_args!("{expected}, got {shown}"))
            }
            number => number,
        }
    }
}

/// The members of a list; each is read before the first mistake ends the reading.
fn members<T: Value>(place: &Place<'_>, value: &Toml<'_>, expected: &str) -> Option<Vec<T>> {
    let DeValue::Array(values) = value.get_ref() else {
        return place.unexpected(value, expected);
    };
    let read: Vec<Option<T>> = values.iter().map(|value| T::read(place, value)).collect();
    read.into_iter().collect()
}

impl<T: Value> Value for Vec<T> {
    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        members(place, value, &Self::expected(place.key))
    }
}

impl<T: Value, const N: usize> Value for [T; N] {
    fn expected(key: &Key) -> String {
        key.expected(format_args!(", a list of {N} numbers"))
    }

    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        let expected = Self::expected(place.key);
        let list = members(place, value, &expected)?;
        let told = format!("{expected}, got {}", list.len());
        list.try_into().ok().or_else(|| place.wrong(value, told))
    }
}

/// Components along the body's axes.
impl Value for BodyVector {
    fn expected(key: &Key) -> String {
        <[f64; 3]>::expected(key)
    }

    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        <[f64; 3]>::read(place, value).map(Self::from)
    }
}

/// A unit quaternion: normalised, if its length is within 1e-3 of 1.
impl Value for Attitude {
    fn expected(key: &Key) -> String {
        <[f64; 4]>::expected(key)
    }

    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        let [w, x, y, z] = <[f64; 4]>::read(place, value)?;
        let length = w.hypot(x).hypot(y.hypot(z));
        if (length - 1.0).abs() > 1e-3 {
            let (what, length) = (place.key.what, Number(length));
            return place.wrong(value, format_args!("{what}, got one of length {length}"));
        }
        let attitude = Self::from_quaternion(w, x, y, z);
        place.table.reader.right(&place.path(), attitude)
    }

    fn absent() -> Option<(Self, String)> {
        Some((Self::identity(), "[1, 0, 0, 0]".to_owned()))
    }
}

impl Value for usize {
    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        let expected = place.key.expected("");
        let DeValue::Integer(_) = value.get_ref() else {
            return place.unexpected(value, &expected);
        };
        f64::read(place, value).map(|number| number as Self)
    }
}

impl Value for String {
    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.clone().into_owned()),
            _ => place.unexpected(value, place.key.what),
        }
    }
}

/// A value that is one of several words; the first is the default.
pub(super) trait Word: Sized {
    fn words() -> Vec<(&'static str, Self)>;
}

impl<T: Word> Value for T {
    fn expected(key: &Key) -> String {
        let names: Vec<&str> = T::words().into_iter().map(|(name, _)| name).collect();
        key.expected(format_args!("one of {}", names.join(", ")))
    }

    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
        let expected = Self::expected(place.key);
        let DeValue::String(text) = value.get_ref() else {
            return place.unexpected(value, &expected);
        };
        let words = T::words();
        let near = meant(text, words.iter().map(|(name, _)| *name));
        let found = words.into_iter().find(|(name, _)| name == text);
        let told = format!("{expected}, got {text:?}{near}");
        found.map_or_else(|| place.wrong(value, told), |(_, word)| Some(word))
    }

    fn absent() -> Option<(Self, String)> {
        let (name, word) = T::words().into_iter().next()?;
        Some((word, name.to_owned()))
    }
}

impl Word for Pace {
    fn words() -> Vec<(&'static str, Self)> {
        vec![("even", Self::Even), ("late", Self::Late)]
    }
}

impl Word for Choice {
    fn words() -> Vec<(&'static str, Self)> {
        let solvers = Solver::all().map(|solver| (solver.name(), Self::Use(solver)));
        core::iter::once(("auto", Self::Auto))
            .chain(solvers)
            .collect()
    }
}

/// Effects that are given by one number.
macro_rules! numbers {
    ($($effect:ident)*) => {$(
        impl Value for $effect {
            fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self> {
                let made = $effect::new(f64::read(place, value)?);
                place.table.reader.right(&place.path(), made)
            }
        }
    )*};
}

numbers! {
    Air AirDrag AxleFriction BearingFriction Coulomb Gravity Hand PivotFriction RollingResistance Sleep TipFriction TurnLoss
}
