//! The ledger: what should have been conserved, and by how much it was not.

use core::fmt;
use core::marker::PhantomData;
use core::mem::discriminant;

use crate::error::{Error, Result, each_finite, finite, not_negative, positive};
use crate::frame::FrameVector;

/// What a quantity is allowed to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Law {
    /// It keeps its first value. Drift: the largest distance from the first value.
    Conserved,
    /// It may fall, never rise (kinetic energy under friction).
    /// Drift: the largest rise above the least value so far.
    NonIncreasing,
    /// It may rise, never fall (heat). Drift: the largest fall below the greatest value so far.
    NonDecreasing,
}

/// Names a quantity of one [`Ledger`], a number or a vector, to record its values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Account<V>(usize, PhantomData<V>);

/// One line of a [`Ledger`].
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Name of the quantity.
    pub name: &'static str,
    /// What the quantity is allowed to do.
    pub law: Law,
    /// One component for a scalar, three for a vector: vectors are conserved or not, never monotone.
    first: Value,
    last: Value,
    /// For a monotone scalar the extreme value so far; unused otherwise.
    extreme: f64,
    scale: f64,
    drift: f64,
}

/// A scalar, or the components of a vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A scalar.
    Scalar(f64),
    /// A vector.
    Vector([f64; 3]),
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::Scalar(value)
    }
}

impl<Axes> From<FrameVector<Axes>> for Value {
    fn from(vector: FrameVector<Axes>) -> Self {
        Self::Vector(vector.components().into())
    }
}

impl Value {
    fn magnitude(self) -> f64 {
        let [x, y, z] = self.components();
        x.hypot(y).hypot(z)
    }

    /// A scalar itself, a vector's magnitude.
    fn shown(self) -> f64 {
        match self {
            Self::Scalar(value) => value,
            vector => vector.magnitude(),
        }
    }

    fn components(self) -> [f64; 3] {
        match self {
            Self::Scalar(value) => [value, 0.0, 0.0],
            Self::Vector(components) => components,
        }
    }
}

impl Entry {
    /// First value recorded: the quantity itself, for a vector its length. Unit of the quantity.
    ///
    /// ```
    /// use spinning_bodies::conservation::{Law, Ledger};
    /// let mut ledger = Ledger::new();
    /// let energy = ledger.open("energy", Law::Conserved, 4.0)?;
    /// ledger.record(energy, 5.0)?;
    /// assert_eq!(ledger.entries()[0].first(), 4.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn first(&self) -> f64 {
        self.first.shown()
    }

    /// Latest value recorded, as [`Entry::first`]; not finite if a record was refused.
    pub(crate) fn last(&self) -> f64 {
        self.last.shown()
    }

    /// Largest violation so far, as [`Law`] counts it, over the scale of the quantity, dimensionless. Never NaN: a value that was not finite
    /// makes it infinite for good. A quantity that starts at zero and was given no scale has drift 0 until it moves, infinite drift after.
    ///
    /// ```
    /// use spinning_bodies::conservation::{Law, Ledger};
    /// let mut ledger = Ledger::new();
    /// let energy = ledger.open("energy", Law::Conserved, 4.0)?;
    /// ledger.record(energy, 5.0)?;
    /// assert_eq!(ledger.entries()[0].relative_drift(), 0.25);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn relative_drift(&self) -> f64 {
        if self.drift == 0.0 {
            0.0
        } else {
            self.drift / self.scale
        }
    }

    /// Books `value`. One that is not finite makes the drift infinite before the error is returned, so that a caller
    /// who drops the error still cannot report a clean run.
    fn book(&mut self, value: Value) -> Result<()> {
        self.last = value;
        let checked = each_finite(self.name, value.components());
        let drift = match checked {
            Ok(()) => self.violation(value),
            Err(_) => f64::INFINITY,
        };
        self.drift = self.drift.max(drift);
        checked
    }

    fn violation(&mut self, value: Value) -> f64 {
        let [x, y, z] = value.components();
        let [x0, y0, z0] = self.first.components();
        match self.law {
            // Differences before squares: two long vectors that nearly agree have a small difference,
            // which would be lost in the rounding of their lengths.
            Law::Conserved => (x - x0).hypot(y - y0).hypot(z - z0),
            law => {
                let change = x - self.extreme;
                let wrong = if law == Law::NonIncreasing {
                    change
                } else {
                    -change
                };
                if wrong < 0.0 {
                    self.extreme = x;
                }
                wrong.max(0.0)
            }
        }
    }
}

/// The books of a run (tutorial 3): named quantities, what each is allowed to do, and its largest drift.
///
/// Open an account with the first value, record the value as often as you like, and ask at the end.
/// The ledger never decides how much drift is too much: the bound is an argument.
///
/// Robustness: a NaN or an infinity is refused by [`Ledger::record`] *and* leaves the account with infinite
/// drift, so it can be neither overlooked nor averaged away. Drift is one subtraction of stored values;
/// it is exact whenever the two agree within a factor of two.
///
/// Cost of a record: a few additions and comparisons (for a vector two `hypot`), no allocation.
///
/// ```
/// use spinning_bodies::conservation::{Law, Ledger};
///
/// let mut ledger = Ledger::new();
/// let kinetic = ledger.open("kinetic energy", Law::NonIncreasing, 10.0)?;
/// for joules in [8.0, 5.0, 5.5, 3.0] {
///     ledger.record(kinetic, joules)?;
/// }
/// // 5.5 J is below the first value, but a violation all the same: half a joule has appeared.
/// assert_eq!(ledger.entries()[0].relative_drift(), 0.05);
/// # Ok::<(), spinning_bodies::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Ledger {
    entries: Vec<Entry>,
}

impl Ledger {
    /// A ledger without accounts.
    ///
    /// ```
    /// use spinning_bodies::conservation::Ledger;
    /// assert!(Ledger::new().entries().is_empty());
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Opens an account for a scalar. Relative drift is measured against |`first`|; use
    /// [`Ledger::open_scaled`] for a quantity that starts at or near zero.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the name of the quantity.
    ///
    /// ```
    /// use spinning_bodies::conservation::{Law, Ledger};
    /// let mut ledger = Ledger::new();
    /// let energy = ledger.open("energy", Law::Conserved, 4.0)?;
    /// ledger.record(energy, 5.0)?;
    /// assert!(ledger.is_kept_within(0.25)? && !ledger.is_kept_within(0.2)?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn open(&mut self, name: &'static str, law: Law, first: f64) -> Result<Account<f64>> {
        self.push(name, law, first, first.abs())
    }

    /// Opens an account for a scalar whose relative drift is measured against `scale`, in the unit of the
    /// quantity: the energy of a run for a heat that starts at zero, say.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for `first`, [`Error::NotPositive`] for the scale.
    ///
    /// ```
    /// use spinning_bodies::conservation::{Law, Ledger};
    /// let mut ledger = Ledger::new();
    /// // Heat starts at zero and is compared with the 4 J of the run.
    /// let heat = ledger.open_scaled("heat", Law::NonDecreasing, 0.0, 4.0)?;
    /// ledger.record(heat, 1.0)?;
    /// ledger.record(heat, 0.5)?;
    /// assert_eq!(ledger.entries()[0].relative_drift(), 0.125);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn open_scaled(
        &mut self,
        name: &'static str,
        law: Law,
        first: f64,
        scale: f64,
    ) -> Result<Account<f64>> {
        let scale = positive("the scale of a ledger account", scale)?;
        self.push(name, law, first, scale)
    }

    /// Opens an account for a conserved vector; drift is the length of the difference, relative to the length
    /// of `first`.
    ///
    /// # Errors
    /// [`Error::NotFinite`], also if its length overflows.
    ///
    /// ```
    /// use spinning_bodies::{conservation::Ledger, frame::SpaceVector};
    /// let mut ledger = Ledger::new();
    /// let l = ledger.open_vector("angular momentum", SpaceVector::new(3.0, 0.0, 4.0))?;
    /// ledger.record(l, SpaceVector::new(3.0, 1.0, 4.0))?;
    /// assert_eq!(ledger.entries()[0].relative_drift(), 0.2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn open_vector<Axes: Copy>(
        &mut self,
        name: &'static str,
        first: FrameVector<Axes>,
    ) -> Result<Account<FrameVector<Axes>>> {
        let scale = Value::from(first).magnitude();
        self.push(name, Law::Conserved, first, scale)
    }

    /// Records a value of a scalar or of a conserved vector.
    ///
    /// # Errors
    /// [`Error::NotFinite`] for such a value, and the account keeps an infinite drift;
    /// [`Error::Condition`] if this ledger has no such account. One of another ledger is not told from its own in the same place, if both are
    /// numbers or both are vectors.
    ///
    /// ```
    /// use spinning_bodies::{conservation::{Law, Ledger}, frame::SpaceVector};
    /// let mut ledger = Ledger::new();
    /// let energy = ledger.open("energy", Law::Conserved, 4.0)?;
    /// ledger.record(energy, 5.0)?;
    /// // A value that is not finite is refused, and the drift stays infinite.
    /// assert!(ledger.record(energy, f64::NAN).is_err());
    /// assert_eq!(ledger.entries()[0].relative_drift(), f64::INFINITY);
    /// let l = ledger.open_vector("angular momentum", SpaceVector::new(1.0, 0.0, 0.0))?;
    /// // It has turned without changing its length, which is a drift too.
    /// ledger.record(l, SpaceVector::new(0.0, 1.0, 0.0))?;
    /// assert!((ledger.entries()[1].relative_drift() - 2.0_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn record<V: Into<Value> + Copy>(&mut self, account: Account<V>, value: V) -> Result<()> {
        let (place, value) = (account.0, value.into());
        let same = |entry: &&mut Entry| discriminant(&entry.first) == discriminant(&value);
        let entry = self.entries.get_mut(place).filter(same);
        let entry = entry.ok_or(Error::Condition {
            condition: "an account must belong to the ledger it is recorded in",
            value: place as f64,
        })?;
        entry.book(value)
    }

    /// All lines, in the order of opening.
    ///
    /// ```
    /// use spinning_bodies::conservation::{Law, Ledger};
    /// let mut ledger = Ledger::new();
    /// ledger.open("energy", Law::Conserved, 4.0)?;
    /// assert_eq!(ledger.entries().len(), 1);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Whether every quantity obeyed its law to within the relative drift `bound`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] or [`Error::Negative`] for the bound: "within NaN" is not an answer.
    ///
    /// ```
    /// use spinning_bodies::conservation::{Law, Ledger};
    /// let mut ledger = Ledger::new();
    /// let energy = ledger.open("energy", Law::Conserved, 4.0)?;
    /// ledger.record(energy, 4.0 + 4e-15)?;
    /// assert!(ledger.is_kept_within(1e-14)? && !ledger.is_kept_within(0.0)?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn is_kept_within(&self, bound: f64) -> Result<bool> {
        let bound = not_negative("the bound on relative drift", bound)?;
        let mut entries = self.entries.iter();
        Ok(entries.all(|entry| entry.relative_drift() <= bound))
    }

    /// Opens an account for a scalar, or for a vector that is conserved.
    ///
    /// # Errors
    /// [`Error::NotFinite`].
    pub(crate) fn push<V: Into<Value>>(
        &mut self,
        name: &'static str,
        law: Law,
        first: V,
        scale: f64,
    ) -> Result<Account<V>> {
        let first = first.into();
        each_finite(name, first.components())?;
        finite("the scale of a ledger account", scale)?;
        self.entries.push(Entry {
            name,
            law,
            first,
            last: first,
            extreme: first.components()[0],
            scale,
            drift: 0.0,
        });
        Ok(Account(self.entries.len() - 1, PhantomData))
    }
}

impl fmt::Display for Ledger {
    /// One line an account: name, first value, last value, largest relative drift.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for entry in &self.entries {
            writeln!(
                f,
                "{:<28} {:>13.6e} -> {:>13.6e}   drift {:.1e}",
                entry.name,
                entry.first(),
                entry.last(),
                entry.relative_drift()
            )?;
        }
        Ok(())
    }
}
