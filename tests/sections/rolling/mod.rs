//! Paragraph 4.3: the billiard shot, and what the cloth does to it.

mod billiard_shot;
mod cloth;
