//! The Jacobi functions of many arguments of one modulus, in loops that the compiler lays out side by side.

use super::crest::hyperbolic;
use super::jacobi::circular;
use super::modulus::{Modulus, Side};
use super::series::Corrections;
use crate::error::{Error, Result};

/// So many arguments are worked on before those are looked for that need more than the common path.
const CHUNK: usize = 64;

impl Modulus {
    /// sn, cn and dn of every argument, into slices of the same length.
    ///
    /// The values are those of [`Modulus::jacobi`] to the last bit, and so is the error.
    ///
    /// Cost: 8–18 ns an argument, for any number of them from about 64 on, with the instructions every processor of
    /// the kind has. A chunk of 64 in which one argument lies beyond 2²⁵ quarter periods, or unluckily close to a
    /// multiple of K, costs what single calls do.
    ///
    /// # Errors
    ///
    /// If the slices differ in length, or at the first argument that [`Modulus::jacobi`] refuses; the slices are
    /// then partly written.
    ///
    /// ```
    /// use spinning_bodies::elliptic::{Modulus, Parameter};
    /// let modulus = Modulus::new(Parameter::from_complement(1e-3)?);
    /// let u = [0.0, 0.5, 1.0, 1.5];
    /// let [mut sn, mut cn, mut dn] = [[0.0; 4]; 3];
    /// modulus.jacobi_batch(&u, &mut sn, &mut cn, &mut dn)?;
    /// assert_eq!(sn[2], modulus.jacobi(1.0)?.sn);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn jacobi_batch(
        &self,
        u: &[f64],
        sn: &mut [f64],
        cn: &mut [f64],
        dn: &mut [f64],
    ) -> Result<()> {
        for length in [sn.len(), cn.len(), dn.len()] {
            if length != u.len() {
                return Err(Error::Condition {
                    condition: "sn, cn and dn must be as long as u",
                    value: length as f64,
                });
            }
        }
        for start in (0..u.len()).step_by(CHUNK) {
            let range = start..u.len().min(start + CHUNK);
            let (u, sn) = (&u[range.clone()], &mut sn[range.clone()]);
            let (cn, dn) = (&mut cn[range.clone()], &mut dn[range]);
            let rare = match self.side {
                Side::Circular => self.circular_chunk(u, sn, cn, dn),
                Side::Hyperbolic => self.hyperbolic_chunk(u, sn, cn, dn),
            };
            if rare {
                for (i, &u) in u.iter().enumerate() {
                    let value = self.jacobi(u)?;
                    (sn[i], cn[i], dn[i]) = (value.sn, value.cn, value.dn);
                }
            }
        }
        Ok(())
    }

    /// Whether some argument needs more than this.
    fn circular_chunk(&self, u: &[f64], sn: &mut [f64], cn: &mut [f64], dn: &mut [f64]) -> bool {
        let mut rare = 0_u64;
        for (((&u, sn), cn), dn) in u.iter().zip(sn).zip(cn).zip(dn) {
            let reduced = self.reduction.apply(u);
            rare |= u64::from(reduced.unlucky | self.reduction.refuses(u));
            let (v, v_low) = self.turned_by(reduced.high, reduced.low);
            let value = circular(&self.series, reduced.rounded.to_bits(), v, v_low);
            (*sn, *cn, *dn) = (value.sn, value.cn, value.dn);
        }
        rare != 0
    }

    fn hyperbolic_chunk(&self, u: &[f64], sn: &mut [f64], cn: &mut [f64], dn: &mut [f64]) -> bool {
        let mut rare = 0_u64;
        for (((&u, sn), cn), dn) in u.iter().zip(sn).zip(cn).zip(dn) {
            let reduced = self.reduction.apply(u);
            rare |= u64::from(reduced.unlucky | self.reduction.refuses(u));
            let (v, v_low) = self.multiplied(reduced.high, reduced.low);
            let bits = reduced.rounded.to_bits();
            let set = Corrections::chosen(&self.series, bits);
            let value = hyperbolic(&self.series, &set, bits, v, v_low);
            (*sn, *cn, *dn) = (value.sn, value.cn, value.dn);
        }
        rare != 0
    }
}
