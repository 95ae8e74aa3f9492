//! Section 7 of the tutorial: Lagrange's top. The truths it is held against: the register's numbers to twenty digits, exact
//! rationals for identities, quadratures, and an integrator of its own that knows neither angles nor elliptic functions.

mod axes;
mod common;
mod integrals;
mod integrator;
mod nutation;
mod pendulum;
mod precession;
mod release;
mod sleeping;
mod special;
mod traces;
