//! The values of keys, and the macros that declare tables of them, once for the reader and for the page of keys.

use toml::de::DeValue;

use super::keys::Key;
use super::reader::{Place, Table, Value, meant};
use crate::error::Number;
use crate::frame::{Attitude, BodyVector};
use crate::scene::effects::*;
use crate::scene::{Choice, Solver};

/// Declares a table: a struct, with a line for each key, `name: type, "the expected value, with its unit", bound;`, without the bound where any number
/// will do. An `Option` may be absent; `name: type = number` gives a default. The type of a line without a text is a table whose keys are read from this
/// one; an `Option` of such a type is read from a table of its own.
macro_rules! section {
    ($name:ident $($field:ident: $type:ty $(= $default:expr)? $(, $what:expr $(, $bound:expr)?)?;)*) => {
        pub(super) struct $name {
            $(pub $field: $type,)*
        }

        keys! { $name $($field: $type $(= $default)? $(, $what $(, $bound)?)?;)* }
    };
}
pub(super) use section;

/// Declares the keys of a struct that exists already, named like its fields.
macro_rules! keys {
    ($name:ident $($field:ident: $type:ty $(= $default:expr)? $(, $what:expr $(, $bound:expr)?)?;)*) => {
        impl Section for $name {
            fn fields(table: &Table<'_>) -> Option<Self> {
                $(let $field = key!(table, $field: $type $(= $default)? $(, $what $(, $bound)?)?);)*
                Some(Self { $($field: $field?,)* })
            }
        }

        impl Value for $name {
            fn read(place: &Place<'_>) -> Option<Self> {
                place.table.reader.section(place.path(), Self::fields)
            }

            /// Lists its keys, without a mistake.
            fn absent(table: &Table<'_>, key: &Key) -> Option<(Self, String)> {
                Self::fields(&Table::new(table.reader, table.path_of(key.name)));
                None
            }
        }
    };
}
pub(super) use keys;

/// Declares all keys of a kind of scene as one struct, those of each main table below its name.
macro_rules! tables {
    ($name:ident $([$part:ident] $($field:ident: $type:ty $(= $default:expr)? $(, $what:expr $(, $bound:expr)?)?;)*)*) => {
        pub(super) struct $name {
            $($(pub $field: $type,)*)*
        }

        impl Section for $name {
            fn fields(whole: &Table<'_>) -> Option<Self> {
                $(let $part = whole.part(stringify!($part), |_table| {
                    $(let $field = key!(_table, $field: $type $(= $default)? $(, $what $(, $bound)?)?);)*
                    Some(($($field?,)*))
                });)*
                $(let ($($field,)*) = $part?;)*
                Some(Self { $($($field,)*)* })
            }
        }
    };
}
pub(super) use tables;

/// Reads one key of a table, or all keys of a table in it.
macro_rules! key {
    ($table:ident, $field:ident: $type:ty) => {
        <$type as Section>::fields($table)
    };
    ($table:ident, $field:ident: $type:ty $(= $default:expr)?, $what:expr $(, $bound:expr)?) => {
        $table.value::<$type>(&Key {
            name: stringify!($field),
            what: $what,
            bounds: &[$($bound)?],
            default: &[$($default)?],
        })
    };
}
pub(super) use key;

impl<T: Value> Value for Option<T> {
    fn expected(key: &Key) -> String {
        T::expected(key)
    }

    fn read(place: &Place<'_>) -> Option<Self> {
        T::read(place).map(Some)
    }

    fn absent(table: &Table<'_>, key: &Key) -> Option<(Self, String)> {
        T::absent(table, key);
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
    fn read(place: &Place<'_>) -> Option<Self> {
        match number(place.value.get_ref()) {
            None => place.unexpected(),
            Some(number) if !number.is_finite() => {
                place.wrong(&format!(", and finite, got {number}"))
            }
            Some(number) if !place.key.bounds.iter().all(|bound| bound.holds(number)) => {
                place.wrong(&format!(", got {}", place.shown()))
            }
            number => number,
        }
    }

    fn absent(_: &Table<'_>, key: &Key) -> Option<(Self, String)> {
        let &default = key.default.first()?;
        Some((default, format!("{default:?}")))
    }
}

impl<T: Value> Value for Vec<T> {
    /// The members of a list; each is read before the first mistake ends the reading.
    fn read(place: &Place<'_>) -> Option<Self> {
        let DeValue::Array(values) = place.value.get_ref() else {
            return place.unexpected();
        };
        let expected = &T::expected(place.key);
        let place = |value| Place {
            value,
            expected,
            ..*place
        };
        let read = values.iter().filter_map(|value| T::read(&place(value)));
        let read: Vec<T> = read.collect();
        (read.len() == values.len()).then_some(read)
    }
}

impl<const N: usize> Value for [f64; N] {
    fn expected(key: &Key) -> String {
        key.expected(&format!(", a list of {N} numbers"))
    }

    fn read(place: &Place<'_>) -> Option<Self> {
        let list = Vec::<f64>::read(place)?;
        let got = format!(", got {}", list.len());
        list.try_into().ok().or_else(|| place.wrong(&got))
    }

    fn absent(_: &Table<'_>, key: &Key) -> Option<(Self, String)> {
        let default = [*key.default.first()?; N];
        Some((default, format!("{default:?}")))
    }
}

/// A unit quaternion: normalised, if its length is within 1e-3 of 1.
impl Value for Attitude {
    fn expected(key: &Key) -> String {
        <[f64; 4]>::expected(key)
    }

    fn read(place: &Place<'_>) -> Option<Self> {
        let [w, x, y, z] = <[f64; 4]>::read(place)?;
        let length = w.hypot(x).hypot(y.hypot(z));
        if (length - 1.0).abs() > 1e-3 {
            let expected = place.key.what;
            let got = format!(", got one of length {}", Number(length));
            return Place { expected, ..*place }.wrong(&got);
        }
        place.right(Self::from_quaternion(w, x, y, z))
    }

    fn absent(_: &Table<'_>, _: &Key) -> Option<(Self, String)> {
        Some((Self::identity(), "[1, 0, 0, 0]".to_owned()))
    }
}

impl Value for usize {
    fn read(place: &Place<'_>) -> Option<Self> {
        match place.value.get_ref() {
            DeValue::Integer(_) => f64::read(place).map(|number| number as Self),
            _ => place.unexpected(),
        }
    }
}

impl Value for String {
    fn read(place: &Place<'_>) -> Option<Self> {
        match place.value.get_ref() {
            DeValue::String(text) => Some(text.clone().into_owned()),
            _ => place.unexpected(),
        }
    }
}

/// A value that is one of several words; the first is the default.
pub(super) trait Word: Sized {
    fn words() -> Vec<(&'static str, Self)>;

    fn names() -> Vec<&'static str> {
        Self::words().into_iter().map(|(name, _)| name).collect()
    }
}

impl<T: Word> Value for T {
    fn expected(key: &Key) -> String {
        key.expected(&format!("one of {}", T::names().join(", ")))
    }

    fn read(place: &Place<'_>) -> Option<Self> {
        let text = String::read(place)?;
        let found = T::words().into_iter().find(|(name, _)| *name == text);
        found.map(|(_, word)| word).or_else(|| {
            let near = meant(&text, T::names().into_iter());
            place.wrong(&format!(", got {}{near}", place.shown()))
        })
    }

    fn absent(_: &Table<'_>, _: &Key) -> Option<(Self, String)> {
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

/// Values that are made from numbers.
macro_rules! made {
    ($($from:ty => $($made:ident)+, $make:expr;)*) => {$($(
        impl Value for $made {
            fn expected(key: &Key) -> String {
                <$from>::expected(key)
            }

            fn read(place: &Place<'_>) -> Option<Self> {
                let make: fn($from) -> crate::Result<Self> = $make;
                place.right(make(<$from>::read(place)?))
            }
        }
    )+)*};
}

made! {
    f64 => Air AirDrag AxleFriction BearingFriction Coulomb Gravity Hand PivotFriction RollingResistance Sleep TipFriction TurnLoss, Self::new;
    f64 => AddedMass, |factor| Ok(Self { factor });
    [f64; 2] => Lift, |[translational, rotational]| Ok(Self { translational, rotational });
    [f64; 2] => Drag, |[mean, contrast]| Ok(Self { mean, contrast });
    [f64; 2] => RotationalDamping, |[linear, quadratic]| Ok(Self { linear, quadratic });
    [f64; 3] => BodyVector, |vector| Ok(vector.into());
}
