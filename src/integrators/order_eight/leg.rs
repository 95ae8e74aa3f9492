//! What is asked of a run.

/// What every step gives back to the state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kept {
    /// Nothing: any system of equations.
    Nothing,
    /// Norm 1 of the quaternion that begins with this component.
    UnitQuaternion(usize),
}

impl Kept {
    /// What the state lacks of what is kept.
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

/// Equations, where they start, and what is asked of them.
#[derive(Debug, Clone, Copy)]
pub struct Leg<'a, const N: usize, S: ?Sized> {
    /// The equations.
    pub system: &'a S,
    /// What every step gives back to the state.
    pub kept: Kept,
    /// When it starts, s, and with what.
    pub start: (f64, &'a [f64; N]),
    /// Sizes below which a component counts as small: the error of a step is judged relative to |y| + scale.
    pub scales: &'a [f64; N],
    /// Samples, ordered from the start to the end, s.
    pub times: &'a [f64],
    /// When it ends, before or after the start, s.
    pub end: f64,
}
