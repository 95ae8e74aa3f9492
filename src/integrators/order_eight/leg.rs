//! The equations, initial state and requested times of a run.

/// What is restored to its conserved value after every step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kept {
    /// Nothing: for any system of equations.
    Nothing,
    /// The norm 1 of the quaternion that begins with this component.
    UnitQuaternion(usize),
}

impl Kept {
    /// The correction to the state that restores the conserved value.
    #[inline(always)]
    pub(in crate::integrators) fn excess<const N: usize>(self, state: &[f64; N]) -> [f64; N] {
        let mut excess = [0.0; N];
        if let Self::UnitQuaternion(first) = self
            && let Some(&[w, x, y, z]) = state[first.min(N)..].first_chunk()
        {
            // 1/|q| - 1, from 1 - |q|².
            let square = w * w + x * x + y * y + z * z;
            let share = (1.0 - square) / (square + square.sqrt());
            for (n, component) in [w, x, y, z].into_iter().enumerate() {
                excess[first + n] = component * share;
            }
        }
        excess
    }
}

/// Equations, initial state, scales, samples and end of a run.
#[derive(Debug, Clone, Copy)]
pub struct Leg<'a, const N: usize, S: ?Sized> {
    /// The equations.
    pub system: &'a S,
    /// What is restored after every step.
    pub kept: Kept,
    /// Initial time, s, and state.
    pub start: (f64, &'a [f64; N]),
    /// Sizes below which a component counts as small: the error of a step is judged relative to |y| + scale.
    pub scales: &'a [f64; N],
    /// Times of the samples, s, ordered from the start to the end.
    pub times: &'a [f64],
    /// End time, s, before or after the start.
    pub end: f64,
}
