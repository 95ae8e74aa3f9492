//! The press: everything between the Markdown of the chapters and the printed book.

pub mod chapters;
