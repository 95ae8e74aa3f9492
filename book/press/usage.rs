//! The command line: commands and options; what `--help` adds to them is in `help/`.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{ArgAction, Args, Parser, Subcommand};
use figures::on_your_table::Paper;
use spinning_bodies::scene::{Solver, files};

use crate::pictures::Form;
use crate::scenes::output::Format;
use crate::scenes::plot::{self, Panel};
use crate::scenes::scan::{self, Over, Tell};

/// Spinning Bodies, the executable edition: draws the figures and builds the book.
#[derive(Debug, Parser)]
#[command(name = "book", bin_name = "cargo run --", version, after_help = include_str!("help/book.txt"))]
pub struct Cli {
    /// What to do; without it, the whole job.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// The help text of `scene` after the options: a scene file, and every kind and solver.
fn scene_help() -> String {
    let kinds = Vec::from_iter(files::kinds()).join(", ");
    let solvers = Vec::from_iter(Solver::all().map(Solver::name)).join(", ");
    let help = include_str!("help/scene.txt");
    help.replace("KINDS", &kinds).replace("SOLVERS", &solvers)
}

/// The subcommands.
#[derive(Debug, Subcommand)]
pub enum Command {
    Figures(Figures),
    Sheets(Sheets),
    Book(Book),
    /// Renders the book for mdBook: `mdbook build book` and `mdbook serve book` call it
    Render,
    Scene(Scene),
    Scan(Scan),
    Accuracy(Accuracy),
    /// Rebuilds the module of the live pages, which redraws a figure when its reader moves a slider
    Live,
    /// Lists every claim of the tutorial, its verdict, and where it is computed
    Claims,
}

/// Draws all figures, or those named, as SVG
#[derive(Debug, Default, Args)]
#[command(after_help = include_str!("help/figures.txt"))]
pub struct Figures {
    /// Names of figures; all if none is given
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
    /// Lists the figures instead of drawing them; for those named, with their parameters
    #[arg(long, conflicts_with_all = ["out", "check", "set", "data", "theme", "transparent", "form", "width"])]
    pub list: bool,
    /// Form of the list; JSON has the claim and the parameters of each figure, for programs
    #[arg(long, value_parser = ["text", "json"], default_value = "text", requires = "list", conflicts_with_all = ["out", "check", "set", "data", "theme", "transparent", "form", "width"])]
    pub format: String,
    /// Parameters of one figure with other values than the book's
    #[arg(long, value_name = "KEY=VALUE,…", value_delimiter = ',')]
    pub set: Vec<String>,
    /// Writes the numbers that one figure draws, as CSV
    #[arg(long, value_name = "FILE")]
    pub data: Option<PathBuf>,
    /// Colours for light paper or dark
    #[arg(long, value_parser = ["light", "dark"], default_value = "light")]
    pub theme: String,
    /// Leaves the background transparent
    #[arg(long)]
    pub transparent: bool,
    /// Form of the files; all but svg need a build with `--features book/pictures`
    #[arg(long = "as", value_enum, value_name = "FORM", default_value_t)]
    pub form: Form,
    /// Width of a PDF in points [default: 432], or of a PNG in pixels [default: 1200]
    #[arg(long, value_name = "N", allow_negative_numbers = true, requires = "form", value_parser = clap::value_parser!(u16).range(16..=16384))]
    pub width: Option<u16>,
    /// Folder for the files [default: figures/svg in the workspace; the current folder for a drawing that differs from the book's]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Writes nothing; compares fresh drawings with the files, to within one canvas unit
    #[arg(long, conflicts_with_all = ["set", "data", "theme", "transparent", "form", "width"])]
    pub check: bool,
}

/// Writes paper strips and a paper cat to cut out, at true size, as SVG, and a chiral top for a 3D printer, as STL
#[derive(Debug, Args)]
pub struct Sheets {
    /// The size of the paper
    #[arg(long, value_parser = Paper::ALL.map(Paper::name), default_value = "a4")]
    pub paper: String,
    /// Folder for the files
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub out: PathBuf,
}

/// Builds the book only
#[derive(Debug, Args)]
pub struct Book {
    /// Opens the first page in the browser
    #[arg(long)]
    pub open: bool,
    /// Also prints all of it to book/build/spinning-bodies.pdf, by an installed Chromium, Chrome or Edge
    #[arg(long)]
    pub pdf: bool,
    /// Also writes book/build/spinning-bodies.epub, for e-readers
    #[arg(long)]
    pub epub: bool,
    /// Keeps running, and prints a page again whenever its chapter is saved; the figures are not drawn again
    #[arg(long)]
    pub watch: bool,
}

/// Simulates a scene file: a body, how it starts, and only the effects it names
#[derive(Debug, Args)]
#[command(after_help = scene_help())]
pub struct Scene {
    /// The scene file, or the name of one in book/scenes; `-` reads standard input
    #[arg(required_unless_present = "keys")]
    pub file: Option<PathBuf>,
    /// Prints the keys of a kind of scene, and reads no file
    #[arg(long, value_name = "KIND", exclusive = true)]
    pub keys: Option<String>,
    /// The columns of a row after the time; an unknown name prints the list of all [default: the usual ones of the kind]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub columns: Vec<String>,
    /// Draws a picture instead: a panel for each COLUMN against time, or X:Y for one column against another
    #[arg(long, value_name = "WHAT,…", value_delimiter = ',', value_parser = plot::panel, conflicts_with_all = ["columns", "format"])]
    pub plot: Vec<Panel>,
    /// Films the moving body instead: one SVG that plays in any browser
    #[arg(long, conflicts_with_all = ["columns", "plot", "format"])]
    pub film: bool,
    /// Seconds of the motion in a second of the film [default: such that the film takes ten seconds]
    #[arg(long, value_name = "RATE", allow_negative_numbers = true, requires = "film", conflicts_with_all = ["plot", "frames"])]
    pub speed: Option<f64>,
    /// Draws N pictures of the moving body into a new folder, at equal steps of time
    #[arg(long, num_args = 2, action = ArgAction::Set, allow_negative_numbers = true, value_names = ["DIR", "N"], conflicts_with_all = ["columns", "plot", "film", "format", "output"])]
    pub frames: Vec<OsString>,
    /// Form of these pictures; all but svg need a build with `--features book/pictures`
    #[arg(long = "as", value_enum, value_name = "FORM", default_value_t, requires = "frames", conflicts_with_all = ["plot", "film"])]
    pub form: Form,
    #[command(flatten)]
    pub written: Written,
}

/// Simulates a scene file over a grid of its numbers, on all cores; a line for each point
#[derive(Debug, Args)]
#[command(after_help = include_str!("help/scan.txt"))]
pub struct Scan {
    /// The scene file, or the name of one in book/scenes; `-` reads standard input
    pub file: PathBuf,
    /// A number of the file, its range, and how many values; :log after these for equal ratios; KEY=FROM..TO,KEY=FROM..TO:COUNT varies two
    /// together. May be given more than once
    #[arg(long, value_name = "KEY=FROM..TO:COUNT", value_parser = scan::over, required = true)]
    pub over: Vec<Over>,
    /// What to write of each motion: COLUMN, first:COLUMN, least:COLUMN, greatest:COLUMN, crossing:COLUMN=LEVEL [default: its last row]
    #[arg(long, value_name = "WHAT,…", value_delimiter = ',', value_parser = scan::asked)]
    pub tell: Vec<Tell>,
    /// Draws one number instead, named as for --tell: a line over one --over, a map over two
    #[arg(long, value_name = "WHAT", value_parser = scan::asked, conflicts_with_all = ["tell", "format"])]
    pub plot: Option<Tell>,
    #[command(flatten)]
    pub written: Written,
}

// The destination and form of the rows or the picture of a scene. A doc comment here would appear in `--help`.
#[derive(Debug, Args)]
pub struct Written {
    /// Form of the rows [default: by the ending of the output's name, otherwise csv]
    #[arg(long, value_enum)]
    pub format: Option<Format>,
    /// File to write; without it, or for `-`, standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Measures error against time for every method that can run a motion, on this machine
#[derive(Debug, Args)]
#[command(after_help = include_str!("help/accuracy.txt"))]
pub struct Accuracy {
    /// A problem, one of its lengths, or a scene file; without it, all problems
    #[arg(long, value_name = "NAME")]
    pub scene: Option<String>,
    /// Also writes a CSV file, with one row for each measurement
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Draws error against time instead, for the one motion that --scene names; without a FILE, to standard output
    #[arg(long, value_name = "FILE", requires = "scene")]
    pub plot: Option<Option<PathBuf>>,
    /// The same as the FILE of --plot
    #[arg(short, long, value_name = "FILE", requires = "plot")]
    pub output: Option<PathBuf>,
}
