//! The angle about the vertical as a double Fourier series, where two roots that s₁ and s₂ do not come to are one or nearly (8.2).
//!
//! The periods of the curve are infinite there or nearly so, and its theta functions out of reach; the motion is as smooth as any.

use nalgebra::{Complex, Quaternion, Vector3};

use super::constants::Constants;
use super::exact::Exact;
use super::fourier::{DoubleSeries, Grid};
use super::taylor::{Carried, about_third, shortest};
use super::torus::Torus;

/// The four functions of u₁, u₂ that are needed besides z, and the rates: all that the angle about the vertical depends on.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct OnGrid {
    /// e₁, e₂, e₃, and the sum S over the terms c_k e^{ik·u}/(ik·u′) that are not slow.
    functions: DoubleSeries<4>,
    /// k·u′ and 2c_k e^{ik·u(0)} where the quotient would be of a small divisor.
    slow: Vec<(f64, Complex<f64>)>,
    /// c₀, the mean of χ′.
    mean: f64,
    /// χ − S at time 0.
    angle: f64,
}

/// Directions are told to this much.
const TAIL: f64 = 1e-15;

/// The most places of a grid times terms of the series that each state sums, half a second's work, and the most places along one angle.
const LARGEST: [usize; 2] = [1 << 23, 1 << 10];

impl OnGrid {
    /// The grid is refined along whichever angle the coefficients of e have not died away.
    pub fn prepare(constants: &Constants, exact: &Exact, start: &Carried) -> Option<Self> {
        let places = LARGEST[0] / exact.separation.terms().max(128);
        let mut grid = Grid { size: [32, 32] };
        let mut torus = Torus::sample(constants, exact, grid, None);
        loop {
            let mut finer = [true; 2];
            if let Some(mut directions) = torus.directions() {
                torus.following_the_third_axis(&mut directions);
                let list = |f: fn(&Vector3<f64>) -> Complex<f64>| {
                    grid.coefficients(directions.iter().map(f).collect())
                };
                let coefficients = [
                    list(|e| Complex::new(e.x, e.y)),
                    list(|e| Complex::new(e.z, 0.0)),
                ];
                let tails = coefficients.each_ref().map(|list| grid.tails(list));
                let tails = [0, 1].map(|axis| tails[0][axis].max(tails[1][axis]));
                finer = tails.map(|tail| tail > TAIL);
                // Coefficients die away exponentially: by far too few of them can be told early.
                let needed = [0, 1].map(|axis| {
                    let share = TAIL.ln() / tails[axis].min(0.99).ln();
                    grid.size[axis] as f64 * share.max(1.0)
                });
                if needed[0] * needed[1] > 4.0 * places as f64 {
                    return None;
                }
                if finer == [false; 2] {
                    let precession = torus.precession(&directions, &coefficients);
                    let c = grid
                        .coefficients(precession.iter().map(|x| Complex::new(*x, 0.0)).collect());
                    let origin = exact.uniform_phases(0.0).map(|f| 0.5 * f);
                    let mut series = Self::collect(&torus, &coefficients, &c, origin);
                    series.set_out(origin, start);
                    return Some(series);
                }
            }
            for axis in [0, 1] {
                grid.size[axis] <<= usize::from(finer[axis]);
            }
            if grid.count() > places || grid.size.into_iter().any(|n| n > LARGEST[1]) {
                return None;
            }
            torus = Torus::sample(constants, exact, grid, Some(&torus));
        }
    }

    // ANCHOR: quadrature
    /// The one more quadrature: χ = c₀t + Σ c_k e^{ik·u}/(ik·u′), from the coefficients c_k of χ′.
    ///
    /// A divisor k·u′ may be small, or zero if the two frequencies are commensurable. Such a term is kept apart and integrated over the time
    /// itself, to c_k e^{ik·u(0)} t sinc; nothing is divided by it.
    fn collect(
        torus: &Torus,
        [across, along]: &[Vec<Complex<f64>>; 2],
        c: &[Complex<f64>],
        origin: [f64; 2],
    ) -> Self {
        let grid = torus.grid;
        let fastest = torus.rates[0].abs().max(torus.rates[1].abs());
        let counts =
            |place: usize| c[place].norm() > 0.5 * f64::EPSILON * fastest.max(c[0].re.abs());
        // The rates are rounded: what the quotient loses by it, |c| eps |k| |u′|/(k·u′)², is not to show.
        let is_slow = |place: usize| {
            let [k1, k2] = grid.waves(place).map(f64::from);
            let rate = torus.rate(place);
            c[place].norm() * k1.hypot(k2) * fastest > rate * rate
        };
        let functions = DoubleSeries::collect(
            grid,
            [across[0].re, across[0].im, along[0].re, 0.0],
            |place| {
                let opposite = grid.opposite(place);
                let i = Complex::new(0.0, 1.0);
                // Two real functions were transformed as one complex: e₁ = (f + f̄)/2, e₂ = (f − f̄)/2i.
                let (f, conjugate) = (across[place], across[opposite].conj());
                let quotient = if counts(place) && !is_slow(place) {
                    2.0 * c[place] / (i * torus.rate(place))
                } else {
                    Complex::default()
                };
                let term = [
                    f + conjugate,
                    (f - conjugate) / i,
                    2.0 * along[place],
                    quotient,
                ];
                term.iter()
                    .any(|x| x.norm() > 0.25 * f64::EPSILON)
                    .then_some(term)
            },
        );
        let slow = (1..grid.count())
            .filter(|&place| grid.waves(place) > [0, 0] && counts(place) && is_slow(place))
            .map(|place| {
                let [k1, k2] = grid.waves(place).map(f64::from);
                let (sine, cosine) = (k1 * origin[0] + k2 * origin[1]).sin_cos();
                (
                    torus.rate(place),
                    2.0 * c[place] * Complex::new(cosine, sine),
                )
            })
            .collect();
        Self {
            functions,
            slow,
            mean: c[0].re,
            angle: 0.0,
        }
    }
    // ANCHOR_END: quadrature

    /// χ at time 0, at which e is seen in the attitude of the start.
    fn set_out(&mut self, origin: [f64; 2], &(_, [w, x, y, z]): &Carried) {
        let [e1, e2, e3, sum] = self.functions.at(origin);
        let e = turned(Quaternion::new(w, x, y, z), [e1, e2, e3]);
        self.angle = e.j.atan2(e.i) - sum;
    }

    /// How many terms the series have.
    pub fn terms(&self) -> usize {
        self.functions.len()
    }

    /// c₀.
    pub const fn mean(&self) -> f64 {
        self.mean
    }

    /// The state and how it stands, from the exact Ω and z: e must be seen at the angle χ, z upright.
    pub fn carried(&self, constants: &Constants, exact: &Exact, t: f64) -> Carried {
        let state = exact.state(constants, t);
        let [.., z1, z2, z3] = state;
        let [e1, e2, e3, sum] = self.functions.at(exact.uniform_phases(t).map(|f| 0.5 * f));
        let slow: f64 = self
            .slow
            .iter()
            .map(|(rate, c)| {
                let half = 0.5 * rate * t;
                let (sine, cosine) = half.sin_cos();
                let sinc = if half == 0.0 { 1.0 } else { sine / half };
                t * sinc * (c * Complex::new(cosine, sine)).re
            })
            .sum();
        let angle = self.angle + self.mean * t + sum + slow;
        let upright = shortest([z1, z2, z3]);
        let e = turned(upright, [e1, e2, e3]);
        let Quaternion { coords } = about_third(angle - e.j.atan2(e.i)) * upright;
        (state, [coords.w, coords.x, coords.y, coords.z])
    }
}

/// A vector along the body's axes as it is seen from space.
fn turned(attitude: Quaternion<f64>, [x, y, z]: [f64; 3]) -> Quaternion<f64> {
    attitude * Quaternion::new(0.0, x, y, z) * attitude.conjugate()
}
