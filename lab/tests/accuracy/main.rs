//! What accuracy costs: the table of the truth, the distances from it, and what a sweep says of a method.

#[path = "../../../tests/reference/double_double.rs"]
mod double_double;
mod refusals;
mod scene;
mod statuses;
mod sweep;
mod truth;
