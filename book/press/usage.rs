//! The command line: commands, options and their help texts.

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
#[command(name = "book", bin_name = "cargo run --", version, after_help = EXAMPLES)]
pub struct Cli {
    /// What to do; without it, the whole job.
    #[command(subcommand)]
    pub command: Option<Command>,
}

const EXAMPLES: &str = "\
Without a command it draws every figure, builds the book, and prints where it is.

Examples:
  cargo run                              the whole job: figures/svg/*.svg and book/build/index.html
  cargo run -- book --open               builds the book and opens it in the browser
  cargo run -- figures --list            the names of the figures and their chapters
  cargo run -- scene book/scenes/racket.toml    simulates a scene file
  cargo run -- help scene                what a scene file may contain; most commands have examples
  cargo test                             runs every example of the book

Exit status: 0 success, 2 an error in the command line or in a source file (one line says which), 1 any other error.";

/// The help text of `scene` after the options: a scene file, and every kind and solver.
fn scene_help() -> String {
    let kinds = Vec::from_iter(files::kinds()).join(", ");
    let solvers = Vec::from_iter(Solver::all().map(Solver::name)).join(", ");
    format!(
        "\
A scene file, in TOML and SI units; only the effects that [effects] names act:

  title = \"A racket\"
  [body]
  moments = [1.0, 2.0, 3.0]        # principal moments, kg m2; or inertia, or a shape with its sizes and mass
  [initial]
  omega = [0.01, 1.0, 0.01]        # rad/s, along the body's axes; or angular_momentum
  attitude = [1.0, 0.0, 0.0, 0.0]  # w x y z, from body to space; the default
  [effects]                        # gravity = 9.80665, pivot_friction = 0.001, ...
  [run]
  until = 10.0                     # s; or times = [0.0, 2.5, 10.0]
  samples = 101
  accuracy = 1e-10                 # relative
  solver = \"auto\"                  # or one of those below
  columns = [\"tilt\", \"energy\"]     # the columns of a row after the time; if absent, the usual ones of the kind

A run stops after 200 million evaluations of its equations and has at most ten million rows; if it takes more than a moment,
it shows its progress. A body under gravity also needs mass and center_of_mass. Other kinds of scene name their kind at the top;
book/scenes has a file for each scene of the book.

Kinds: {kinds}.
Solvers: {solvers}.

Examples:
  cargo run -- scene book/scenes/racket.toml
  cargo run -- scene --keys roller    the keys of a kind; `--keys shapes` has the shapes that a body can have
  cargo run -- scene sleeping-top --columns tilt,lz,force --format json --output motion.json
  cargo run -- scene tippe-top --plot tilt,energy --output motion.svg
  cargo run -- scene racket --plot omega1:omega2 --output polhode.svg
  cargo run -- scene racket --film --speed 0.5 --output racket.svg
  cargo run --features book/pictures -- scene racket --frames stills 250 --as png
  ffmpeg -framerate 25 -i stills/%03d.png -pix_fmt yuv420p racket.mp4    makes a video of these stills"
    )
}

const SCAN: &str = "\
Each point of the grid gives one line: the varied numbers, the last row of the motion, and `ok`, or the reason why there is none. A
number is named by its keys, joined by dots; places in a list count from 0. --tell asks for other numbers than the last row: the first,
last, least or greatest value of any column (`scene --columns`), or the time (s) at which it first reaches a level, to the accuracy of
the scene. In JSON refused points are listed separately, with their reasons. Exit status 1 if no point could be run.

Examples:
  cargo run -- scan racket --over initial.omega.0=0.001..0.1:25
  cargo run -- scan heavy-body --over effects.gravity=0..20:21 --over initial.omega.2=1..20:20
  cargo run -- scan racket --over initial.omega.0=1e-8..1e-1:8:log --tell crossing:omega2=0
  cargo run -- scan tippe-top --over body.mass=0.01..0.04,body.radius=0.01..0.04:4 --tell greatest:tilt,last:energy
  cargo run -- scan racket --over initial.omega.0=1e-8..1e-1:40:log --plot crossing:omega2=0 --output flip.svg
  cargo run -- scan strip --over initial.angle=0..1.5:30 --over body.width=0.01..0.05:30 --plot x --output map.svg";

const FIGURES: &str = "\
Many figures have parameters: `--list NAME` shows them, with their ranges and the values of the book. The caption is computed
from the same numbers, and printed. Files have plain colours that any program can read.

Examples:
  cargo run -- figures
  cargo run -- figures --list spool-dial
  cargo run -- figures --list --format json
  cargo run -- figures spool-dial --set axle=0.6,tension=0.5 --theme dark
  cargo run -- figures spool-dial --set axle=0.6 --data dial.csv --out elsewhere
  cargo run --features book/pictures -- figures polhodes nutations --as pdf --out elsewhere";

const ACCURACY: &str = "\
Errors are those at the end of the run: the angle between the attitudes in radians, and the relative error of the
angular velocity. Times are the least of repeated runs. Below each table, for errors of 1e-3, 1e-6, 1e-9 and 1e-12, are the
cheapest method, the next one, and dop853. Efforts for which a run would take much of a second are left out, and counted.
Times need a release build; a debug build gives only errors and evaluations.

Problems: free-top, near-separatrix, cusped-top, near-sleeping, kovalevskaya, kovalevskaya-level, heavy-body,
tippe-top; each over 1, 10 and 1000 turns, the first four also over 1000000 (the tippe top: 1, 10, 100). free-top/1000 is one
length of one. They are judged by motions known to 30 digits; all together they take about ten minutes.

Or a scene file of any kind, by its path or by its name in book/scenes, over its whole run; this takes seconds. Every solver
that can run it does; the others give the reason why they cannot. Two methods of different families, at their tightest
tolerances, are the judges: the closed form if there is one, order 8, verner98. If they disagree by more than 1e-3 the scene
is refused; errors too small to be distinguished from their disagreement are marked `floor`. For a kind without an attitude
the errors are those of its angular velocities, or else of its velocities, over the greatest in the motion.

Examples:
  cargo run --release -- accuracy --scene near-separatrix/1000
  cargo run --release -- accuracy --csv mine.csv
  cargo run --release -- accuracy --scene strip
  cargo run --release -- accuracy --scene racket --plot racket.svg";

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
#[command(after_help = FIGURES)]
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
#[command(after_help = SCAN)]
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
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Measures error against time for every method that can run a motion, on this machine
#[derive(Debug, Args)]
#[command(after_help = ACCURACY)]
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
    #[arg(long, value_name = "FILE", requires = "plot")]
    pub output: Option<PathBuf>,
}
