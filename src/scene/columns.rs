//! Numbers that a scene tells of its states, each by its name, with its unit and what it means.

use nalgebra::Vector3;

use crate::frame::{Attitude, BodyVector, SpaceVector};

/// What a number is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// `omega1`, `tilt`, …
    pub name: &'static str,
    /// `rad/s`; `1` for a pure number.
    pub unit: &'static str,
    /// In a few words.
    pub meaning: &'static str,
    /// Whether it is told if nobody says which numbers are.
    pub usual: bool,
    /// Whether it is an angle that goes round, told between −π and π.
    pub goes_round: bool,
}

/// One number of a state.
type Teller<S> = Box<dyn Fn(&S) -> f64 + Send + Sync>;

/// The numbers of a state, in the order of a row.
pub struct Columns<S>(Vec<(Column, Teller<S>)>);

impl<S: 'static> core::fmt::Debug for Columns<S> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_list().entries(self.columns()).finish()
    }
}

impl<S> Default for Columns<S> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<S: 'static> Columns<S> {
    /// The same with another number.
    pub fn with(
        mut self,
        [name, unit, meaning]: [&'static str; 3],
        of: impl Fn(&S) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let column = Column {
            name,
            unit,
            meaning,
            usual: false,
            goes_round: false,
        };
        self.0.push((column, Box::new(of)));
        self
    }

    /// The same with three components of one vector.
    pub fn vector(
        self,
        names: [&'static str; 3],
        [unit, meaning]: [&'static str; 2],
        of: impl Fn(&S) -> Vector3<f64> + Clone + Send + Sync + 'static,
    ) -> Self {
        (0..3).fold(self, |columns, k| {
            let of = of.clone();
            columns.with([names[k], unit, meaning], move |state| of(state)[k])
        })
    }

    /// The same with the quaternion of an attitude.
    pub fn attitude(self, of: fn(&S) -> Attitude) -> Self {
        let meaning = "attitude, a unit quaternion that turns body axes into space axes";
        let of = move |state: &S| of(state).quaternion().into_inner();
        self.with(["qw", "1", meaning], move |state| of(state).w)
            .vector(["qx", "qy", "qz"], ["1", meaning], move |state| {
                of(state).imag()
            })
    }

    /// The same with an angular velocity, along the body's axes.
    pub fn omega(self, of: fn(&S) -> BodyVector) -> Self {
        let names = ["omega1", "omega2", "omega3"];
        let what = ["rad/s", "angular velocity, along the body's axes"];
        self.vector(names, what, move |state| of(state).components())
    }

    /// The same with the angles of an attitude: tilt, precession, nutation, spin.
    pub fn angles(self, of: fn(&S) -> Attitude) -> Self {
        let nutation = move |state: &S| of(state).euler_angles().theta;
        let tilt = ["tilt", "rad", "angle of axis 3 to the vertical"];
        let theta = [
            "nutation",
            "rad",
            "Euler's angle of axis 3 to the vertical: the tilt",
        ];
        let phi = [
            "precession",
            "rad",
            "Euler's angle about the vertical, from x to the line of nodes, −π … π",
        ];
        let psi = [
            "spin",
            "rad",
            "Euler's angle about axis 3, from the line of nodes to axis 1, −π … π",
        ];
        self.with(tilt, nutation)
            .with(theta, nutation)
            .with(phi, move |state| of(state).euler_angles().phi)
            .going_round()
            .with(psi, move |state| of(state).euler_angles().psi)
            .going_round()
    }

    /// The same, the last of them an angle that goes round.
    fn going_round(mut self) -> Self {
        if let Some((column, _)) = self.0.last_mut() {
            column.goes_round = true;
        }
        self
    }

    /// The same with an angular momentum (kg m²/s, along the axes of space), its size, and its angle to axis 3.
    pub fn angular_momentum(
        self,
        attitude: fn(&S) -> Attitude,
        l: impl Fn(&S) -> SpaceVector + Clone + Send + Sync + 'static,
    ) -> Self {
        let unit = "kg m²/s";
        let (size, leaning) = (l.clone(), l.clone());
        self.vector(
            ["lx", "ly", "lz"],
            [unit, "angular momentum, along the axes of space"],
            move |state| l(state).components(),
        )
        .with(["l", unit, "size of the angular momentum"], move |state| {
            size(state).norm()
        })
        .with(
            [
                "l_to_axis",
                "rad",
                "angle between angular momentum and axis 3",
            ],
            move |state| {
                let along = attitude(state).to_body(leaning(state));
                along.x().hypot(along.y()).atan2(along.z())
            },
        )
    }

    /// These numbers and those.
    pub fn and(mut self, further: Self) -> Self {
        self.0.extend(further.0);
        self
    }

    /// The same, all of them told if nobody says which.
    pub(crate) fn usual(mut self) -> Self {
        for (column, _) in &mut self.0 {
            column.usual = true;
        }
        self
    }

    /// What the numbers are.
    pub fn columns(&self) -> impl Iterator<Item = Column> {
        self.0.iter().map(|(column, _)| *column)
    }

    /// The number at this place.
    ///
    /// # Panics
    /// If there are not so many.
    pub(crate) fn number(&self, place: usize, state: &S) -> f64 {
        (self.0[place].1)(state)
    }

    /// All numbers of a state.
    pub fn row(&self, state: &S) -> Vec<f64> {
        self.0.iter().map(|(_, of)| of(state)).collect()
    }
}
