//! The one binary: `cargo run` draws the figures and builds the book.

fn main() -> std::process::ExitCode {
    press::command::run(std::env::args_os())
}
