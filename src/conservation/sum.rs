//! A sum that loses nothing.

/// A running sum whose rounding error does not grow with the number of terms (Neumaier 1974).
///
/// For what a run accumulates in small instalments: heat, work, impulse, time. A plain sum of n equal terms
/// loses up to n/2 units in the last place; this one keeps the lost parts and is right to about one, as long as
/// n stays below 2⁵².
///
/// A term that is not finite makes the sum not finite, and [`Ledger::record`](super::Ledger::record) refuses it.
/// Cost: four additions a term.
///
/// ```
/// use spinning_bodies::conservation::CompensatedSum;
///
/// let mut heat = CompensatedSum::new();
/// for _ in 0..10_000_000 {
///     heat.add(1e-7);
/// }
/// assert_eq!(heat.value(), 1.0);
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CompensatedSum {
    sum: f64,
    lost: f64,
}

impl CompensatedSum {
    /// The empty sum, zero.
    ///
    /// ```
    /// use spinning_bodies::conservation::CompensatedSum;
    /// assert_eq!(CompensatedSum::new().value(), 0.0);
    /// ```
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a term.
    ///
    /// ```
    /// use spinning_bodies::conservation::CompensatedSum;
    /// let mut sum = CompensatedSum::new();
    /// for term in [1.0, 1e100, 1.0, -1e100] {
    ///     sum.add(term);
    /// }
    /// assert_eq!(sum.value(), 2.0);
    /// sum.add(f64::INFINITY);
    /// assert_eq!(sum.value(), f64::INFINITY);
    /// ```
    pub fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        // The smaller summand is the one whose digits are lost.
        self.lost += if self.sum.abs() >= term.abs() {
            (self.sum - sum) + term
        } else {
            (term - sum) + self.sum
        };
        self.sum = sum;
    }

    /// The sum so far.
    ///
    /// ```
    /// use spinning_bodies::conservation::CompensatedSum;
    /// let tenths = || std::iter::repeat_n(0.1, 1_000_000);
    /// let mut sum = CompensatedSum::new();
    /// sum.extend(tenths());
    /// assert_eq!(sum.value(), 100_000.0);
    /// assert!((tenths().sum::<f64>() - 100_000.0).abs() > 1e-6);
    /// ```
    pub fn value(&self) -> f64 {
        if self.sum.is_finite() {
            self.sum + self.lost
        } else {
            // Once infinite, the lost part is infinity − infinity and means nothing.
            self.sum
        }
    }
}

impl Extend<f64> for CompensatedSum {
    fn extend<T: IntoIterator<Item = f64>>(&mut self, terms: T) {
        for term in terms {
            self.add(term);
        }
    }
}
