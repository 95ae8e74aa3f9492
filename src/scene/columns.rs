//! Columns: the numbers that a scene returns for each state, with name, unit and meaning.

use std::sync::Arc;

use crate::frame::{Attitude, BodyVector, FrameVector, SpaceVector};

/// Columns of a state, one line each: name, unit, meaning, and the expression of the number.
macro_rules! columns {
    (|$state:ident: &$type:ty| $($name:literal, $unit:literal, $meaning:literal => $number:expr;)*) => {
        $crate::scene::Columns::default().with(
            &[$([$name, $unit, $meaning]),*],
            std::sync::Arc::new(move |$state: &$type, place| [$($number),*][place]),
        )
    };
}

pub(crate) use columns;

/// The description of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// The name: `omega1`, `tilt`, …
    pub name: &'static str,
    /// The unit: `rad/s`; `1` for a pure number.
    pub unit: &'static str,
    /// The meaning in a few words.
    pub meaning: &'static str,
    /// Whether it is output by default.
    pub usual: bool,
    /// Whether it is an angle modulo 2π, given between −π and π, as its meaning says at the end.
    pub goes_round: bool,
}

/// Computes the number of a state at a place among several.
type Teller<S> = Arc<dyn Fn(&S, usize) -> f64 + Send + Sync>;

/// The columns of a state, in the order of a row.
pub struct Columns<S>(
    /// Each with the function that computes its number, and its place there.
    pub(super) Vec<(Column, Teller<S>, usize)>,
);

impl<S: 'static> core::fmt::Debug for Columns<S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let columns = self.0.iter().map(|(column, ..)| column);
        f.debug_list().entries(columns).finish()
    }
}

impl<S> Default for Columns<S> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<S: 'static> Columns<S> {
    /// With these columns added: name, unit and meaning of each.
    pub(crate) fn with(mut self, numbers: &[[&'static str; 3]], of: Teller<S>) -> Self {
        for (place, &[name, unit, meaning]) in numbers.iter().enumerate() {
            let column = Column {
                name,
                unit,
                meaning,
                usual: false,
                goes_round: meaning.ends_with("−π … π"),
            };
            self.0.push((column, of.clone(), place));
        }
        self
    }

    /// With the three components of a vector added.
    pub(crate) fn vector<Axes>(
        self,
        [x, y, z]: [&'static str; 3],
        [unit, meaning]: [&'static str; 2],
        of: impl Fn(&S) -> FrameVector<Axes> + Send + Sync + 'static,
    ) -> Self {
        let numbers = [[x, unit, meaning], [y, unit, meaning], [z, unit, meaning]];
        let of = move |state: &S, place| of(state).components()[place];
        self.with(&numbers, Arc::new(of))
    }

    /// With the quaternion of an attitude added.
    pub(crate) fn attitude(self, of: fn(&S) -> Attitude) -> Self {
        let meaning = "attitude, a unit quaternion that turns body axes into space axes";
        let numbers = ["qw", "qx", "qy", "qz"].map(|name| [name, "1", meaning]);
        let of = move |state: &S, place| <[f64; 4]>::from(of(state))[place];
        self.with(&numbers, Arc::new(of))
    }

    /// With an angular velocity along the body's axes added.
    pub(crate) fn omega(self, of: fn(&S) -> BodyVector) -> Self {
        let names = ["omega1", "omega2", "omega3"];
        let what = ["rad/s", "angular velocity, along the body's axes"];
        self.vector(names, what, of)
    }

    /// With the angles of an attitude added: tilt, precession, nutation, spin.
    pub(crate) fn angles(self, of: fn(&S) -> Attitude) -> Self {
        self.and(columns! { |state: &S|
            "tilt", "rad", "angle of axis 3 to the vertical" => of(state).euler_angles().theta;
            "nutation", "rad", "Euler's angle of axis 3 to the vertical: the tilt" => of(state).euler_angles().theta;
            "precession", "rad", "Euler's angle about the vertical, from x to the line of nodes, −π … π" => of(state).euler_angles().phi;
            "spin", "rad", "Euler's angle about axis 3, from the line of nodes to axis 1, −π … π" => of(state).euler_angles().psi;
        })
    }

    /// With an angular momentum (kg m²/s, along the axes of space) added, its size, and its angle to axis 3.
    pub(crate) fn angular_momentum(
        self,
        attitude: fn(&S) -> Attitude,
        l: impl Fn(&S) -> SpaceVector + Clone + Send + Sync + 'static,
    ) -> Self {
        let along = [
            "kg m²/s",
            "angular momentum about the fixed point, or else the centre of mass, along the axes of space",
        ];
        let columns = self.vector(["lx", "ly", "lz"], along, l.clone());
        columns.and(columns! { |state: &S|
            "l", "kg m²/s", "size of the angular momentum" => l(state).norm();
            "l_to_axis", "rad", "angle between angular momentum and axis 3" => {
                let along = attitude(state).to_body(l(state));
                along.x().hypot(along.y()).atan2(along.z())
            };
        })
    }

    /// These columns followed by `further`.
    pub(crate) fn and(mut self, further: Self) -> Self {
        self.0.extend(further.0);
        self
    }

    /// The numbers of a state in the columns at these places.
    ///
    /// # Panics
    /// If there are not that many columns.
    pub(crate) fn row(&self, places: &[usize], state: &S) -> Vec<f64> {
        let number = |&place: &usize| {
            let (_, of, place) = &self.0[place];
            // Nothing is told as −0.
            of(state, *place) + 0.0
        };
        places.iter().map(number).collect()
    }
}

/// Name, unit and meaning of a column, from its name and its doc comment.
pub(crate) fn described(name: &'static str, text: &'static str) -> [&'static str; 3] {
    let text = text.trim().trim_end_matches('.');
    let (meaning, unit) = text.rsplit_once(", ").unwrap_or((text, "1"));
    [name, unit, meaning]
}

/// Declares a state whose fields are its columns, after those in parentheses: the doc comment of each is its meaning and, after the last comma, its unit.
macro_rules! state {
    (
        $(#[$about:meta])*
        $name:ident $(($before:expr))? { $(#[doc = $text:literal] $number:ident,)* }
        $(#[doc = $more:literal] $field:ident: $type:ty,)*
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        pub struct $name {
            $(#[doc = $text] pub $number: f64,)*
            $(#[doc = $more] pub $field: $type,)*
        }

        impl $name {
            /// The state with these numbers, in the order of a row.
            pub(crate) const fn of(
                [$($number),*]: [f64; [$($text),*].len()],
                $($field: $type,)*
            ) -> Self {
                Self { $($number,)* $($field,)* }
            }
        }

        impl $crate::scene::Tabulated for $name {
            fn columns() -> $crate::scene::Columns<Self> {
                let told = [$($crate::scene::columns::described(stringify!($number), $text)),*];
                let number = |state: &Self, place| [$(state.$number),*][place];
                let columns = $crate::scene::Columns::default()$(.and($before))?;
                columns.with(&told, std::sync::Arc::new(number))
            }
        }
    };
}

pub(crate) use state;
