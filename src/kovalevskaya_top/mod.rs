//! Kovalevskaya's top (tutorial 8): the heavy top with the moments of inertia that allow one more conserved quantity.
//!
//! I₁ = I₂ = 2I₃ and the centre of mass in the plane of the two equal moments. Then K = (Ω₁+iΩ₂)² − (MgC₁/I₃)(z₁+iz₂) moves on a
//! circle, and with E, L_vert and |K| constant, the motion can be found by quadratures. This module follows
//! Kovalevskaya's solution of 1889, one file a step:
//!
//! * `constants`: E, L_vert and |K|, and the five roots e₁ … e₅ of a polynomial P that they determine;
//! * `separation`: variables s₁, s₂ with (s₁−s₂)²(ds/dt)² = P(s) for each, and the integrals ∫ds/√P and ∫s ds/√P, which give two phases that advance uniformly in time;
//! * `periods`, `theta`: the period matrix of the curve w² = P(s), and Riemann's theta functions of two variables with all their half periods;
//! * `solution`: from the phases back to Ω and z by Kötter's linear system of 1893, solved by quotients of theta functions. Where two roots of the cubic are close, their distance is divided out
//!   of its sums by algebra; where s₁ or s₂ passes between two close roots, the theta functions are those after the modular transformation in one direction;
//! * `exact`: phases and signs of a start, and a trial of the solution at a later time;
//! * `pendulum`: motions in a vertical plane, which are those of Lagrange's top;
//! * `taylor`: the same motion by power series, where the separation fails or loses digits, and what keeps a state on the surface of its constants;
//! * `precession`: the attitude, which takes one more quadrature, by theta functions at any time at the same cost;
//! * `attitude`: the state at any time, by one of these methods; power series are used step by step where s₁ or s₂ passes between two roots that 106 bits do not tell apart, or where another root lies between the two;
//! * [`Kind`], [`Diagram`]: the motions with a double root.
//!
//! Error of Ω and z, observed over 400 random starts with |Ω_i| ≤ 1.5, c = 1, at time 10, against power series with 24 digits: half
//! below 1e-15, 95 per cent below 3e-15, the worst 1.2e-14. At time 50: half below 3.4e-15, the worst 2e-14; errors grow in proportion to time. They are greater (eps |Ω|²/c) where gravity is weak compared with the spin, since z
//! comes from a division by c.
//!
//! If z is exactly along axis 3 at the start, e₅ is identically a root of the cubic, and the genus of the curve drops. The two equal roots are separated by 10⁻²⁸, too little to show in any digit. Of the theta functions, in the
//! direction in which s₁ or s₂ would pass between the two, only the terms that matter near the start are kept: the others belong to times that are never reached.
//!
//! Near a double root the motion itself amplifies rounding, on it like e^{λt}. So the constants and both phases are computed in 106 bits from the exact doubles given. Where
//! the separation loses digits all the same, Ω and z are followed by power series in 106 bits, together with the error that the same steps in doubles would have, which shows the amplification: beyond 10¹⁷ the answer is an error
//! that says when. [`KovalevskayaTop::stated_error`] is the error stated for every answer.
//!
//! The preparation is bounded: at most 4096 terms of a theta function, at most 4096 units of time by power series.
//!
//! Error of the attitude ([`KovalevskayaTop::at`]), over the same starts: at time 10 half below 1.7e-15 rad, 95 per cent below 4.5e-15, the worst 1.6e-14; at time 50 half below 7.1e-15, the worst 7e-14: it grows in proportion to time, for the frequencies are rounded.
//! Cost: 0.12 ms to prepare Ω, z and attitude in the median; then 1.6 µs a state.
//!
//! For z exactly along axis 3 at the start, against a table of 30 digits for 39 starts up to time 60: the worst 9e-14 for Ω and z and 8.5e-14 rad; a quarter of a millisecond to prepare and 2.7 µs a state.
//! Near Appelrot's second and third class, 74 of a hundred starts that satisfy 2l² = 3l₁ ± k to the last digit of a double are solved by theta functions, the worst at time 60 5e-14 and 5e-13 rad; near the fourth all of a
//! hundred, 1.4e-13 and 1.7e-13 rad. The others are followed by power series. 28 starts of these classes, exactly by algebra or to the last digit of a double, against a table of 30 digits up to time 60: none refused, and 6e-14 at most.
//! In a vertical plane (`pendulum`), 13 starts, near the separatrix and on it: 9e-16 and 7e-16 rad.
//!
//! [`toda`] is the next system that was found to be integrable (8.3).

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
