//! Kovalevskaya's top (tutorial 8): held off its centre, with just the moments that allow one more conserved quantity.
//!
//! I₁ = I₂ = 2I₃ and the centre of mass on the plane of the two equal moments. Then (Ω₁+iΩ₂)² − (MgC₁/I₃)(z₁+iz₂) moves on a
//! circle, and with E, L_vert and |K| known, the motion can be had by quadratures. This module follows the road that
//! Kovalevskaya took in 1889, one file a step:
//!
//! * `constants`: E, L_vert and |K|, and the five roots e₁ … e₅ of a polynomial P that they determine;
//! * `separation`: variables s₁, s₂ with (s₁−s₂)²(ds/dt)² = P(s) for each, and the integrals ∫ds/√P and ∫s ds/√P, of which two phases are made that advance evenly;
//! * `periods`, `theta`: the rest of the curve w² = P(s), and Riemann's theta functions of two variables with all their half periods;
//! * `solution`: from the phases back to Ω and z by a linear system, which is Kötter's of 1893, solved by quotients of theta functions; where two roots of the cubic meet their distance is taken out
//!   of its sums by algebra, and where s₁ or s₂ passes between two roots that meet these are theta functions after the modular transformation in one direction;
//! * `exact`: phases and signs of a start, and the trial at a later time;
//! * `pendulum`: motions that keep to a plane, which are Lagrange's;
//! * `taylor`: the same motion by power series in 106 bits, where her road is closed or loses digits;
//! * `precession`: the attitude, which takes one more quadrature, by theta functions at any time at the same cost;
//! * `attitude`: the state at any time, by one of these ways, and where s₁ or s₂ passes between two roots that 106 bits do not tell apart, or another root lies between the two, walked from stretch to stretch;
//! * [`Kind`], [`Diagram`]: the motions with a double root.
//!
//! Error of Ω and z, observed over 400 random starts with |Ω_i| ≤ 1.5, c = 1, at time 10, against power series with 24 digits: half
//! below 1e-15, 95 per cent below 3e-15, the worst 1.2e-14. At time 50 half below 3.4e-15, the worst 2e-14: errors grow in proportion to time. They are greater where gravity is weak against the spin, since z is had by a
//! division by c, (eps |Ω|²/c).
//!
//! z exactly along axis 3 at the start makes e₅ a root of the cubic by algebra, and closes a handle of the curve. The two roots are taken apart by 10⁻²⁸, which shows in no digit, and of theta functions in the
//! direction in which s₁ or s₂ would pass between them those terms are left that compete near the start: the others belong to times that never come.
//!
//! Next to a double root the motion itself amplifies what is rounded, on it like e^{λt}. So the constants and both phases follow from the very doubles given in 106 bits; where
//! her road loses digits all the same, Ω and z are walked in 106 bits, and beside them goes what a walk in doubles would be off by, which shows how much is amplified: beyond 10¹⁷ times the answer is an error
//! that says when. [`KovalevskayaTop::stated_error`] is the error stated for every answer.
//!
//! What is prepared has bounds: 4096 terms of a theta function, 4096 units of time of a walk.
//!
//! Attitude ([`KovalevskayaTop::at`]), over the same starts: at time 10 half below 1.7e-15 rad, 95 per cent below 4.5e-15, the worst 1.6e-14; at time 50 half below 7.1e-15, the worst 7e-14: in proportion to time, for the frequencies are rounded.
//! 0.12 ms to prepare in the median, Ω, z and attitude; then 1.6 µs a state.
//!
//! z exactly along axis 3 at the start, against a table of 30 digits for 39 starts up to time 60: the worst 9e-14 for Ω and z and 8.5e-14 rad; a quarter of a millisecond to prepare and 2.7 µs a state.
//! Beside Appelrot's second and third class, 74 of a hundred starts that keep 2l² = 3l₁ ± k to the last digit of a double have the theta functions, the worst at time 60 5e-14 and 5e-13 rad; beside the fourth all of a
//! hundred, 1.4e-13 and 1.7e-13 rad. The others are walked. 28 starts of these classes, exactly by algebra or to the last digit of a double, against a table of 30 digits up to time 60: none refused, and 6e-14 at most.
//! In a plane (`pendulum`), 13 starts, next to the separatrix and on it: 9e-16 and 7e-16 rad.
//!
//! [`toda`] is the lattice that came next (8.3).

mod attitude;
mod classes;
mod constants;
mod exact;
mod pendulum;
mod periods;
mod precession;
mod separation;
mod solution;
mod taylor;
mod theta;
pub mod toda;
mod top;

pub use classes::{Diagram, Kind};
pub use exact::Reason;
pub use top::{Integrals, KovalevskayaTop, Method, State, ellipsoid};
