//! The laboratory: its tables, its general methods, the textbook's formulas beside ours.

#[cfg(feature = "general")]
mod accuracy;
#[cfg(feature = "general")]
mod general;
mod hard_cases;
