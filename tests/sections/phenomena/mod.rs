//! Section 1: what a body does to itself. Sliding, swivelling, falling cats of flesh and of paper, the skater.

mod cat;
mod paper_cat;
mod skater;
mod sliding;
mod swivelling;
