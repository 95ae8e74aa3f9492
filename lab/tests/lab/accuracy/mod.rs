//! What accuracy costs: the table of the truth, the distances from it, and what a sweep says of a method.

mod refusals;
mod scene;
mod statuses;
mod sweep;
mod truth;
