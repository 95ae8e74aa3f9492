//! What accuracy costs: every method on every kind of top, against motions known to 36 digits.
//!
//! | question | answer |
//! |---|---|
//! | which motions? | [`problems`]: eight, each over several lengths, with [`Sample`]s of the truth |
//! | which methods can run one, at which efforts? | [`candidates`]: closed form, geometric and general methods, each from coarse to the rounding floor |
//! | what is the error, and the cost? | [`measure`] one run, [`Trial::sweep`] a method: [`Measurement`]s |
//! | which method was cheapest when measured? | [`measured`]: the committed sweep |
//! | and for a scene of any kind? | [`JudgedScene`]: two methods of different families judge the others |
//!
//! Every method is called through [`Follow`](crate::follow::Follow). The truth is never the same code with a finer step: it is
//! the committed table `tests/reference/accuracy.csv`, by two independent routes of 45 and more digits that agree to 30.
//!
//! ```
//! use lab::accuracy::{Status, along_the_run, candidates, measure, named};
//! let problem = &named("free-top/10")?[0];
//! let methods = candidates(problem)?;
//! let exact = methods.iter().find(|m| m.name == "exact").expect("a free top has a closed form");
//! let found = measure(problem, exact, exact.efforts[0]);
//! assert!(found.status == Status::Ok && found.error_attitude < 1e-14);
//! assert!(along_the_run(problem, exact, exact.efforts[0])?.attitude < 1e-14);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod candidate;
mod closed_form;
mod listed;
mod measure;
pub mod measured;
mod order;
mod problem;
mod sample;
mod scene;
mod table_top;

pub use candidate::{Candidate, candidates};
pub use closed_form::ClosedForm;
pub use listed::{NAMES, named, problems};
pub use measure::{Measurement, Status, Trial, along_the_run, measure};
pub use order::measured_order;
pub use problem::{Model, Problem};
pub use sample::{Apart, Sample};
pub use scene::JudgedScene;
pub use table_top::SlidingBall;
