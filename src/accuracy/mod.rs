//! What accuracy costs: every method on every kind of top, against motions known to 30 digits.
//!
//! | question | answer |
//! |---|---|
//! | which motions? | [`problems`]: eight, each over several lengths, with [`Sample`]s of the truth |
//! | which methods can run one, how hard? | [`candidates`]: closed form, geometric and general methods, each from coarse to the rounding floor |
//! | how wrong was that, and what did it cost? | [`measure`] one, [`sweep`] a method: [`Measurement`]s |
//!
//! Every method is asked through [`Follow`](crate::integrators::geometric::Follow). The truth is never the same code with a finer step: it is
//! a committed table, two independent routes of 45 and more digits that agree to 30 (`tests/reference/accuracy.py`). The library holds no
//! clock: whoever has one lends it.
//!
//! ```
//! use spinning_bodies::accuracy::{Judged, Status, candidates, measure, named};
//! let problem = &named("free-top/10")?[0];
//! let methods = candidates(problem)?;
//! let exact = methods.iter().find(|m| m.name() == "exact").expect("a free top has a closed form");
//! let found = measure(problem, exact, exact.efforts()[0], Judged::AlongTheRun, &mut |_| None);
//! assert!(found.status == Status::Ok && found.largest_attitude < Some(1e-14));
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod candidate;
mod listed;
mod measure;
mod order;
mod problem;
mod sample;
mod table_top;
#[rustfmt::skip]
mod truth;

pub use candidate::{Candidate, candidates};
pub use listed::{NAMES, named, problems};
pub use measure::{Clock, Judged, Measurement, Status, measure, sweep};
pub use order::measured_order;
pub use problem::{Problem, Setting};
pub use sample::{Apart, Sample};
pub use table_top::OnTable;
