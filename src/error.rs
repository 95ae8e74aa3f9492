//! One error type: each variant names the violated condition and the value that violated it.

use core::fmt;

/// What a constructor or a function refuses, and why.
///
/// Every variant prints as one line that names the quantity, the condition and the offending value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A quantity is infinite or not a number.
    #[error("{quantity} must be finite, got {}", Number(*value))]
    NotFinite {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A quantity that must be greater than zero is not.
    #[error("{quantity} must be positive, got {}", Number(*value))]
    NotPositive {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A quantity that may be zero is negative.
    #[error("{quantity} must not be negative, got {}", Number(*value))]
    Negative {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// A quantity lies outside the interval on which the formula holds.
    #[error(
        "{quantity} must lie between {} and {}, got {}", Number(*least), Number(*greatest), Number(*value)
    )]
    OutOfRange {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given.
        value: f64,
        /// Least admissible value.
        least: f64,
        /// Greatest admissible value.
        greatest: f64,
    },
    /// The zero vector was given where a direction is needed.
    #[error("{quantity} must not be the zero vector")]
    ZeroVector {
        /// Name of the vector.
        quantity: &'static str,
    },
    /// Moments of inertia that no body has (tutorial 2.4: `I1 + I2 >= I3`).
    #[error(
        "principal moments must satisfy I1 + I2 >= I3, got {} + {} < {}; no body has these",
        Number(*smallest), Number(*middle), Number(*largest)
    )]
    TriangleInequality {
        /// Smallest moment, kg m².
        smallest: f64,
        /// Middle moment, kg m².
        middle: f64,
        /// Largest moment, kg m².
        largest: f64,
    },
    /// A matrix that should be symmetric is not.
    #[error(
        "the inertia matrix must be symmetric, got {} above and {} below the diagonal in row {row}, column {column}",
        Number(*upper), Number(*lower)
    )]
    NotSymmetric {
        /// Row of the entry above the diagonal, counted from 0.
        row: usize,
        /// Column of the entry above the diagonal, counted from 0.
        column: usize,
        /// Entry above the diagonal.
        upper: f64,
        /// Its mirror image.
        lower: f64,
    },
    /// A list that must not be empty is.
    #[error("{quantity} must not be empty")]
    Empty {
        /// Name of the list.
        quantity: &'static str,
    },
    /// A triangle names a vertex that the mesh does not have.
    #[error(
        "triangle {triangle} names vertex {index}, but the mesh has {vertices} vertices, numbered from 0"
    )]
    VertexIndex {
        /// Number of the triangle, from 0.
        triangle: usize,
        /// The vertex it names.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// Some edge of a mesh is not run along equally often in both directions.
    #[error(
        "the mesh is open or inconsistently oriented: its triangles must run along every edge equally often in both directions"
    )]
    OpenMesh,
    /// A mesh encloses no volume, or a negative one.
    #[error("the mesh must enclose a positive volume, got {} m³{hint}", Number(*volume))]
    NoVolume {
        /// Signed volume, m³.
        volume: f64,
        /// The cause, and what to try.
        hint: &'static str,
    },
    /// Routh's rule was applied to a body that it does not cover.
    #[error("Routh's rule does not hold for {body}")]
    RouthDoesNotApply {
        /// The kind of body.
        body: &'static str,
    },
    /// A numerical integration stopped before its end.
    #[error("the integration stopped at t = {} s: {reason}", Number(*time))]
    Integration {
        /// Why.
        reason: &'static str,
        /// How far it came, s.
        time: f64,
    },
    /// A motion lost a quantity that its scene conserves, or let one rise that can only fall.
    #[error(
        "the ledger is violated: {quantity} drifted by {} relative to its scale, more than the {} allowed",
        estimated(*drift), estimated(*allowed)
    )]
    Ledger {
        /// Name of the quantity.
        quantity: &'static str,
        /// Largest relative drift.
        drift: f64,
        /// What the accuracy asked for allows.
        allowed: f64,
    },
    /// An integral is not found to within the difference of two estimates that it asks for.
    #[error(
        "an integral is not found to within {}, for two estimates of it still differ by {}",
        estimated(*asked), estimated(*reached)
    )]
    Accuracy {
        /// Difference that is allowed.
        asked: f64,
        /// Difference of the last two estimates.
        reached: f64,
    },
    /// A run has used up its budget of evaluations, or would need it many times over.
    #[error(
        "after {spent} of the {most} evaluations allowed, the motion has come to t = {time:?} s; at this pace the run would take {} of them: ask for a looser accuracy, an earlier end, fewer effects or another solver",
        estimated(*whole)
    )]
    Budget {
        /// Evaluations used.
        spent: u64,
        /// Evaluations allowed.
        most: u64,
        /// How far it came, s.
        time: f64,
        /// Evaluations that a run to the end would take at the pace so far.
        whole: f64,
    },
    /// An item of a list is refused.
    #[error("item {place} of the list, counted from 0: {reason}")]
    AtPlace {
        /// Its place in the list, counted from 0.
        place: usize,
        /// What is wrong with it.
        reason: Box<Error>,
    },
    /// A condition that has no variant of its own; the text states it.
    #[error("{condition}, got {}", Number(*value))]
    Condition {
        /// The condition, as "x must ...".
        condition: &'static str,
        /// The value that violates it.
        value: f64,
    },
    /// A motion that amplifies rounding beyond the accuracy asked for.
    ///
    /// ```
    /// use spinning_bodies::Error;
    /// let told = |reached, growth| Error::Amplified { asked: 1e-10, reached, growth }.to_string();
    /// assert!(told(1e-9, 7.0).contains("out of reach, 1e-9 was reached: ") && told(3.0, 7.0).contains("no digit is certain"));
    /// assert!(told(1e-9, 7.0).contains("the start grows 7 times;"));
    /// assert!(told(1e-9, 0.5).contains("the start does not grow;"));
    /// assert!(told(1e-9, f64::NAN).contains("may grow"));
    /// ```
    #[error(
        "accuracy {} is out of reach, {}: rounding adds up, and in this motion a small change of the start {}; a looser accuracy or an earlier end may do",
        Number(*asked), known(*reached), grown(*growth)
    )]
    Amplified {
        /// Accuracy asked for.
        asked: f64,
        /// Error estimate of the best run.
        reached: f64,
        /// By what factor a small change of the start was seen to grow; not a number where measuring it would take too long.
        growth: f64,
    },
    /// An effect that has no meaning for a kind of scene.
    #[error("`{effect}` has no meaning for {kind}, which takes {takes}")]
    Effect {
        /// The effect, as scene files call it.
        effect: &'static str,
        /// The kind of scene.
        kind: &'static str,
        /// The effects that it takes.
        takes: &'static str,
    },
    /// The solver asked for cannot run this scene or top; the text says which can.
    #[error("{condition}")]
    Solver {
        /// The condition, as "the solver must ...".
        condition: &'static str,
    },
}

/// A number as a message shows it: the fewest digits from which it can be read back, with an exponent where there would be a row of
/// zeros.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = self;
        if *value == 0.0 || (1e-4..1e6).contains(&value.abs()) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// A number that is known to a digit or two, rounded to three.
fn estimated(value: f64) -> Number {
    Number(format!("{value:.2e}").parse().unwrap_or(value))
}

/// What is known at this error estimate.
fn known(error: f64) -> String {
    match error {
        less if less < 1.0 => format!("{} was reached", estimated(less)),
        _ => "no digit is certain".to_owned(),
    }
}

/// What a small change of the start does in a motion that has this growth.
fn grown(growth: f64) -> String {
    match growth {
        more if more > 1.0 => format!("grows {} times", estimated(more)),
        _ if growth.is_nan() => "may grow, which would take too long to measure".to_owned(),
        _ => "does not grow".to_owned(),
    }
}

/// The result of every function in this library that can fail.
pub type Result<T> = core::result::Result<T, Error>;

/// `value`, if it is accepted.
fn accepted(value: f64, holds: bool, refusal: impl FnOnce() -> Error) -> Result<f64> {
    if holds { Ok(value) } else { Err(refusal()) }
}

/// `value`, if it is finite.
pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<f64> {
    accepted(value, value.is_finite(), || Error::NotFinite {
        quantity,
        value,
    })
}

/// Refuses the first of these values that does not pass this check.
pub(crate) fn each(
    check: fn(&'static str, f64) -> Result<f64>,
    quantity: &'static str,
    values: impl IntoIterator<Item = f64>,
) -> Result<()> {
    let mut values = values.into_iter();
    values.try_for_each(|value| check(quantity, value).map(drop))
}

/// Refuses the first of these values that is not finite.
pub(crate) fn each_finite(
    quantity: &'static str,
    values: impl IntoIterator<Item = f64>,
) -> Result<()> {
    each(finite, quantity, values)
}

/// `value`, if it is finite and greater than zero.
pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<f64> {
    let holds = finite(quantity, value)? > 0.0;
    accepted(value, holds, || Error::NotPositive { quantity, value })
}

/// `value`, if it is finite and not less than zero; −0 becomes 0, by which a quotient is not negative.
pub(crate) fn not_negative(quantity: &'static str, value: f64) -> Result<f64> {
    let holds = finite(quantity, value)? >= 0.0;
    accepted(value + 0.0, holds, || Error::Negative { quantity, value })
}

/// `value`, if it is finite and lies between `least` and `greatest`, both included.
pub(crate) fn within(quantity: &'static str, value: f64, least: f64, greatest: f64) -> Result<f64> {
    let holds = (least..=greatest).contains(&finite(quantity, value)?);
    accepted(value, holds, || {
        out_of_range(quantity, value, [least, greatest])
    })
}

/// The error of a value outside this range.
pub(crate) const fn out_of_range(quantity: &'static str, value: f64, range: [f64; 2]) -> Error {
    let [least, greatest] = range;
    Error::OutOfRange {
        quantity,
        value,
        least,
        greatest,
    }
}

/// The size of a vector, if that is not zero.
pub(crate) fn not_zero(quantity: &'static str, size: f64) -> Result<f64> {
    accepted(size, size != 0.0, || Error::ZeroVector { quantity })
}

/// Refuses an empty list.
pub(crate) fn not_empty<T>(quantity: &'static str, list: &[T]) -> Result<()> {
    match list.is_empty() {
        true => Err(Error::Empty { quantity }),
        false => Ok(()),
    }
}

/// The error of a condition that does not hold, with the value that breaks it.
pub(crate) const fn refused<T>(condition: &'static str, value: f64) -> Result<T> {
    Err(Error::Condition { condition, value })
}

/// The error of a motion that could be followed only up to this time.
pub(crate) const fn stopped<T>(reason: &'static str, time: f64) -> Result<T> {
    Err(Error::Integration { reason, time })
}

/// Refuses an output slice whose length is not the number of results.
pub(crate) fn same_length(wanted: usize, found: usize) -> Result<()> {
    if wanted == found {
        return Ok(());
    }
    refused("the slice must have a place for each result", found as f64)
}

/// The refusal of a time so far from 0 that no digit of the phase would be left; `limit` is the greatest time at which some are.
pub(crate) const fn too_long(t: f64, limit: f64) -> Error {
    out_of_range("the time", t, [-limit, limit])
}
