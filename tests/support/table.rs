//! What the tests against the tables of 32 digits share: cells that are read once and exactly, and the angle between attitudes.

use spinning_bodies::frame::{Attitude, BodyVector};

use crate::decimal::{decimal, hexadecimal};
use crate::double_double::Dd;
use crate::multiplied;

/// One line of a table, its cells by number.
pub struct Cells(Vec<&'static str>);

/// The lines below the head.
pub fn lines(table: &'static str) -> impl Iterator<Item = Cells> {
    let lines = table.lines().skip(1);
    lines.map(|line| Cells(line.split(',').collect()))
}

impl Cells {
    pub fn text(&self, cell: usize) -> &'static str {
        self.0[cell]
    }

    /// The doubles next to decimals, from this cell on.
    pub fn numbers<const N: usize>(&self, from: usize) -> [f64; N] {
        core::array::from_fn(|k| self.0[from + k].parse().expect("a number"))
    }

    /// Floats that were printed exactly, from this cell on.
    pub fn exact<const N: usize>(&self, from: usize) -> [f64; N] {
        core::array::from_fn(|k| hexadecimal(self.0[from + k]))
    }

    /// Decimals of 32 digits, from this cell on.
    pub fn decimals<const N: usize>(&self, from: usize) -> [Dd; N] {
        core::array::from_fn(|k| decimal(self.0[from + k]))
    }
}

/// The length of what a vector is off by, the differences taken in 106 bits.
pub fn apart(found: BodyVector, exact: [Dd; 3]) -> f64 {
    let found = found.components();
    let [x, y, z] = [0, 1, 2].map(|k| (Dd::from(found[k]) - exact[k]).value());
    x.hypot(y).hypot(z)
}

/// Twice the vector part of q⁻¹p in 106 bits: the angle between the attitudes without a subtraction from 1.
pub fn angle(found: &Attitude, exact: [Dd; 4]) -> f64 {
    let p = found.quaternion();
    let [a, b, c, d] = exact;
    let turn = multiplied([a, -b, -c, -d], [p.w, p.i, p.j, p.k].map(Dd::from));
    let [_, x, y, z] = turn.map(Dd::value);
    2.0 * x.hypot(y).hypot(z)
}
