//! The press: everything between the Markdown of the chapters and the printed book.
//!
//! | module | what it does |
//! |---|---|
//! | [`chapters`] | the list of chapters; includes them as doctests |
//! | [`paths`] | where the workspace is |
//! | `writer` | writes files whole or not at all |
//! | `interrupt` | removes half-written files when a signal ends the command |
//! | `progress` | shows the progress of a long run |
//! | [`drawings`] | draws the figures, writes and compares their files |
//! | [`pictures`] | figures as PDF and PNG |
//! | `formulas` | LaTeX to HTML, at build time |
//! | `pieces` | HTML that is put into the pages after mdBook has written them |
//! | `typesetter` | formulas, figures and claim tags of one chapter |
//! | `live` | the parameters of a figure on its page, and the module that redraws it there |
//! | [`ledger`] | the claims of the tutorial, and where each is computed |
//! | [`appendix`] | the ledger as a page and as a table |
//! | [`binding`] | builds the book, whole or not at all |
//! | [`ebook`] | the book as one file, EPUB or PDF |
//! | `watch` | prints the book again when a file of it is saved |
//! | [`accuracy`] | every method on every kind of top, timed on this machine |
//! | [`scenes`] | scene files: read, run, written |
//! | [`command`] | the command line |

pub mod accuracy;
pub mod appendix;
pub mod binding;
pub mod chapters;
pub mod command;
pub mod drawings;
pub mod ebook;
pub mod error;
mod formulas;
mod interrupt;
pub mod ledger;
mod live;
pub mod paths;
pub mod pictures;
mod pieces;
mod progress;
pub mod scenes;
mod typesetter;
mod usage;
mod watch;
mod writer;

pub use error::{Error, Result};
