//! Paragraph 4.6: the superball, in exact fractions wherever a fraction will do.

mod bounce;
mod common;
mod long_runs;
mod losses;
mod refusals;
mod spring;
mod under_the_table;
