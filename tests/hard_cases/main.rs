//! Hard cases: inputs on which textbook formulas lose their digits. A bug in a limit starts with a test here.

#[path = "../support/decimal.rs"]
mod decimal;
mod euler_equations;
mod free_top;
mod inertia;
mod kovalevskaya;
mod kovalevskaya_attitude;
mod lagrange_top;
#[path = "../support/power_series.rs"]
mod power_series;
#[path = "../support/table.rs"]
mod table;
