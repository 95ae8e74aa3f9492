//! Toda's lattice (tutorial 8.3): particles on a line, each pushed by its neighbours with an exponential force.
//!
//! q_i′ = p_i, p_i′ = e^{−(q_i−q_{i−1})} − e^{−(q_{i+1}−q_i)}. Flaschka (1974): the symmetric matrix L with b_i = p_i/2 on the diagonal and
//! a_i = ½e^{−(q_{i+1}−q_i)/2} beside it obeys dL/dt = BL − LB with an antisymmetric B, so that its eigenvalues are constant.

use nalgebra::DMatrix;

use crate::error::{Result, each_finite, finite, refused};

/// The ends of the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// The first and last particle have one neighbour each; eventually all fly apart.
    Open,
    /// The last particle is a neighbour of the first.
    Periodic,
}

/// Positions and momenta of the particles of a Toda lattice, in units where all masses and forces are 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Lattice {
    ends: Ends,
    positions: Vec<f64>,
    momenta: Vec<f64>,
}

impl Lattice {
    /// The lattice with these positions and momenta.
    ///
    /// # Errors
    /// [`Error::Condition`](crate::Error::Condition) for fewer than two particles (three if periodic) or lists of different length, [`Error::NotFinite`](crate::Error::NotFinite).
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};
    /// assert!(Lattice::new(Ends::Periodic, &[0.0, 0.0], &[1.0, -1.0]).is_err());
    /// let lattice = Lattice::new(Ends::Open, &[0.0, 0.0], &[1.0, -1.0])?;
    /// assert_eq!(lattice.energy(), 2.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(ends: Ends, positions: &[f64], momenta: &[f64]) -> Result<Self> {
        let least = match ends {
            Ends::Open => 2,
            Ends::Periodic => 3,
        };
        if positions.len() < least {
            let condition =
                "a Toda lattice must have at least two particles, three if it is periodic";
            return refused(condition, positions.len() as f64);
        }
        if positions.len() != momenta.len() {
            let condition = "there must be as many momenta as positions";
            return refused(condition, momenta.len() as f64);
        }
        let all = positions.iter().chain(momenta);
        each_finite("a position or momentum", all.copied())?;
        Ok(Self {
            ends,
            positions: positions.to_vec(),
            momenta: momenta.to_vec(),
        })
    }

    /// Positions q_i.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};
    /// let lattice = Lattice::new(Ends::Open, &[0.0, 0.0], &[1.0, -1.0])?;
    /// assert_eq!(lattice.positions(), [0.0, 0.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }

    /// Momenta p_i.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};
    /// let lattice = Lattice::new(Ends::Open, &[0.0, 0.0], &[1.0, -1.0])?;
    /// assert_eq!(lattice.momenta(), [1.0, -1.0]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn momenta(&self) -> &[f64] {
        &self.momenta
    }

    /// Gap from each particle to the next; in a periodic lattice also from the last to the first.
    fn gaps(&self) -> impl Iterator<Item = f64> {
        let q = &self.positions;
        let n = q.len();
        let bonds = match self.ends {
            Ends::Open => n - 1,
            Ends::Periodic => n,
        };
        (0..bonds).map(move |i| q[(i + 1) % n] - q[i])
    }

    /// H = ½Σp² + Σe^{−gap}.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};
    /// let lattice = Lattice::new(Ends::Open, &[0.0, 0.0], &[1.0, -1.0])?;
    /// // ½ + ½ + e⁰.
    /// assert_eq!(lattice.energy(), 2.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy(&self) -> f64 {
        let kinetic = self.momenta.iter().map(|p| 0.5 * p * p).sum::<f64>();
        kinetic + self.gaps().map(|gap| (-gap).exp()).sum::<f64>()
    }

    // ANCHOR: lax
    /// The matrix L: p_i/2 on the diagonal, ½e^{−gap/2} beside it, and for a periodic lattice in the far corners too.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};
    /// let lattice = Lattice::new(Ends::Open, &[0.0, 0.0], &[1.0, -1.0])?;
    /// let l = lattice.lax_matrix();
    /// assert_eq!((l[(0, 0)], l[(0, 1)], l[(1, 1)]), (0.5, 0.5, -0.5));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn lax_matrix(&self) -> DMatrix<f64> {
        let n = self.momenta.len();
        let mut matrix = DMatrix::zeros(n, n);
        for (i, p) in self.momenta.iter().enumerate() {
            matrix[(i, i)] = 0.5 * p;
        }
        for (i, gap) in self.gaps().enumerate() {
            let (a, j) = (0.5 * (-0.5 * gap).exp(), (i + 1) % n);
            matrix[(i, j)] += a;
            matrix[(j, i)] += a;
        }
        matrix
    }

    /// The eigenvalues of L in ascending order: as many constants of motion as particles.
    ///
    /// Error: a few eps times the greatest, and what the rounding of a gap of size q makes of its exponential, q/2 eps. Cost: one symmetric eigenvalue problem.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) if an exponential overflows.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};
    /// let lattice = Lattice::new(Ends::Open, &[0.0, 0.0], &[1.0, -1.0])?;
    /// // ±√(¼ + ¼); twice these are the velocities with which the two particles separate.
    /// let [a, b] = lattice.eigenvalues()?[..] else { panic!("two") };
    /// assert!((a + 0.5_f64.sqrt()).abs() < 1e-15 && (b - 0.5_f64.sqrt()).abs() < 1e-15);
    /// // Beside one bond of 10³⁸ and momenta of 10⁻³⁰⁰ all four are numbers.
    /// let wide = Lattice::new(Ends::Open, &[-176.95, -357.0, 156.0, 196.0], &[1e-300; 4])?.eigenvalues()?;
    /// assert!((wide[3] / (0.5 * 90.025_f64.exp()) - 1.0).abs() < 1e-13 && wide[1].abs() < 1e-13 * wide[3]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn eigenvalues(&self) -> Result<Vec<f64>> {
        let matrix = self.lax_matrix();
        each_finite("an entry of the Lax matrix", matrix.iter().copied())?;
        // Powers of entries still smaller would underflow, and give no number.
        let least = 1e-75 * matrix.amax();
        let matrix = matrix.map(|entry| if entry.abs() < least { 0.0 } else { entry });
        let mut values: Vec<f64> = matrix.symmetric_eigenvalues().iter().copied().collect();
        values.sort_by(f64::total_cmp);
        Ok(values)
    }
    // ANCHOR_END: lax

    /// Advances the lattice by `steps` steps of length `step`, by Yoshida's symplectic method of order 8 in 15 stages.
    ///
    /// It does not use the Lax matrix. Error O(step⁸); energy does not drift. Cost: 15 exponentials a bond and step.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for the step, or if positions or momenta overflow.
    ///
    /// ```
    /// # use spinning_bodies::kovalevskaya_top::toda::{Ends, Lattice};
    /// let mut lattice = Lattice::new(Ends::Open, &[0.0, 0.0], &[1.0, -1.0])?;
    /// lattice.advance(0.01, 4000)?;
    /// // Once they are far apart, each momentum is twice an eigenvalue.
    /// assert!((lattice.momenta()[1] - 2.0_f64.sqrt()).abs() < 1e-9);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn advance(&mut self, step: f64, steps: usize) -> Result<()> {
        finite("the step", step)?;
        for _ in 0..steps {
            for n in 0_usize..15 {
                let weight = WEIGHTS[n.abs_diff(7)];
                self.drift(0.5 * weight * step);
                self.kick(weight * step);
                self.drift(0.5 * weight * step);
            }
        }
        let all = self.positions.iter().chain(&self.momenta);
        each_finite("a position or momentum", all.copied())
    }

    fn drift(&mut self, h: f64) {
        for (q, p) in self.positions.iter_mut().zip(&self.momenta) {
            *q += h * p;
        }
    }

    fn kick(&mut self, h: f64) {
        let n = self.momenta.len();
        let pushes: Vec<f64> = self.gaps().map(|gap| h * (-gap).exp()).collect();
        for (i, push) in pushes.into_iter().enumerate() {
            self.momenta[i] -= push;
            self.momenta[(i + 1) % n] += push;
        }
    }
}

/// Yoshida's solution A for order 8 (1990): weights w₀ … w₇ of the leapfrogs w₇ … w₁, w₀, w₁ … w₇, all of which add up to 1.
const WEIGHTS: [f64; 8] = [
    -1.780_828_626_589_451_5,
    -0.161_582_374_150_097e1,
    -0.244_699_182_370_524e1,
    -0.716_989_419_708_120e-2,
    0.244_002_732_616_735e1,
    0.157_739_928_123_617,
    0.182_020_630_970_714e1,
    0.104_242_620_869_991e1,
];
