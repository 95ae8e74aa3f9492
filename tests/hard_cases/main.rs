//! Hard cases: inputs on which textbook formulas lose their digits. A bug in a limit starts with a test here.

mod euler_equations;
mod free_top;
mod inertia;
mod kovalevskaya;
mod kovalevskaya_attitude;
mod kovalevskaya_double_root;
mod lagrange_top;
