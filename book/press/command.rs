//! The command line.

use crate::drawings::{self, Drawing};
use crate::error::one_line;
use crate::ledger::Ledger;
use crate::paths::workspace_root;
use crate::pictures::{self, Copying, Form};
use crate::progress::counted;
use crate::scenes::film::{self, Stills};
use crate::scenes::output::{Format, Motion};
use crate::scenes::plot::{self, Panel};
use crate::scenes::scan::{Over, Scan, Tell};
use crate::writer::{Target, can_be_written_into, folder_of, say};
use crate::{Error, Result, accuracy, appendix, binding, interrupt, scenes, watch};
use clap::{Parser, Subcommand};
use figures::on_your_table::Paper;
use figures::{Entry, Figure, Look, Theme, Values};
use spinning_bodies::scene::{Progress, Solver, files};

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Spinning Bodies, the executable edition: draws the figures and builds the book.
#[derive(Debug, Parser)]
#[command(name = "book", bin_name = "cargo run --", version, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

const EXAMPLES: &str = "\
Without a command it draws every figure, builds the book, and prints where it is.

Examples:
  cargo run                              the whole job: figures/svg/*.svg and book/build/index.html
  cargo run -- figures --list            the names of the figures and their chapters
  cargo run -- figures --out my-figs     every figure into another folder
  cargo run -- figures --check           do the committed figures still look the same?
  cargo run -- book --open               builds the book and opens it in the browser
  cargo run -- book --watch              prints the pages again whenever a chapter is saved
  cargo run -- sheets --paper letter     things to cut out and to print, at true size
  cargo run -- scene book/scenes/racket.toml    simulates a scene file; `scene --help` shows one
  cargo run --release -- accuracy --scene free-top    error against time, on your machine
  cargo run -- claims                    every claim of the tutorial and where it is computed
  cargo test                             runs every example of the book

Exit status: 0 success, 2 wrong usage or a wrong source (one line says which), 1 anything else.";

/// What `scene --help` says after the options: a file, and every kind and solver.
fn scene_help() -> String {
    let names =
        |names: &mut dyn Iterator<Item = &'static str>| names.collect::<Vec<_>>().join(", ");
    let kinds = names(&mut files::kinds());
    let solvers = names(&mut Solver::all().map(Solver::name));
    format!(
        "\
A scene file, in TOML and SI units; nothing acts that [effects] does not name:

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
  columns = [\"tilt\", \"energy\"]  # what a row tells after the time; the usual numbers of the kind if it is not there

A run gives up after 200 million evaluations of its equations, and has ten million rows at most; one that takes more than a
moment tells how far it is. A body under gravity also needs mass and center_of_mass. Other kinds of scene name their kind at the top;
book/scenes has a file for each scene of the book.

Kinds: {kinds}.
Solvers: {solvers}.

Examples:
  cargo run -- scene book/scenes/racket.toml
  cargo run -- scene --keys roller    the keys of a kind; `--keys shapes` those of bodies by what they are
  cargo run -- scene sleeping-top --columns tilt,lz,force --format json --output motion.json
  cargo run -- scene tippe-top --plot tilt,energy --output motion.svg
  cargo run -- scene racket --plot omega1:omega2 --output polhode.svg
  cargo run -- scene racket --film --speed 0.5 --output racket.svg
  cargo run --features book/pictures -- scene racket --frames stills 250 --as png
  ffmpeg -framerate 25 -i stills/%03d.png -pix_fmt yuv420p racket.mp4    makes a video of them"
    )
}

const SCAN: &str = "\
A line for each point of the grid: the varied numbers, the last row of the motion, and `ok`, or why there is none. Numbers are named as
in the file, joined by dots, places in a list from 0. --tell asks for other numbers than the last row: of any column (`scene --columns`) its
first, last, least or greatest value, or the time (s) when it is first at a level, to the accuracy of the scene. In JSON the
refused points stand apart, with their reasons. Exit status 1 if no point could be run.

Examples:
  cargo run -- scan racket --over initial.omega.0=0.001..0.1:25
  cargo run -- scan heavy-body --over effects.gravity=0..20:21 --over initial.omega.2=1..20:20
  cargo run -- scan racket --over initial.omega.0=1e-8..1e-1:8:log --tell crossing:omega2=0
  cargo run -- scan tippe-top --over body.mass=0.01..0.04,body.radius=0.01..0.04:4 --tell greatest:tilt,last:energy
  cargo run -- scan racket --over initial.omega.0=1e-8..1e-1:40:log --plot crossing:omega2=0 --output flip.svg
  cargo run -- scan strip --over initial.angle=0..1.5:30 --over body.width=0.01..0.05:30 --plot x --output map.svg";

const FIGURES: &str = "\
Many figures are functions of numbers that may be chosen: `--list NAME` tells them, their ranges and what the book shows. The caption
is computed from the same numbers, and printed. Files have plain colours, for any program.

Examples:
  cargo run -- figures
  cargo run -- figures --list spool-dial
  cargo run -- figures spool-dial --set axle=0.6,tension=0.5 --theme dark
  cargo run -- figures spool-dial --set axle=0.6 --data dial.csv --out elsewhere
  cargo run --features book/pictures -- figures polhodes nutations --as pdf --out elsewhere";

const ACCURACY: &str = "\
Errors are those at the end of the run: the angle between the attitudes in radians, and the relative error of the
angular velocity. Times are the least of repeated runs. Below each table stand, for 1e-3, 1e-6, 1e-9 and 1e-12, the
cheapest method, the next one, and dop853. Efforts that would take much of a second a run are left out, and counted.
Times need a release build; a debug build tells errors and evaluations.

Problems: free-top, near-separatrix, cusped-top, near-sleeping, kovalevskaya, kovalevskaya-level, heavy-body,
tippe-top; each over 1, 10 and 1000 turns, the first four over 1000000 (the tippe top: 1, 10, 100): free-top/1000 is one of them.
They are judged by motions known to 30 digits, and all together take about ten minutes.

Or a scene file of any kind, by its path or by its name in book/scenes, over its whole run; it takes seconds. Every solver
runs that can, the others say why not. Two methods of different families judge at their tightest: the closed form if there
is one, order 8, verner98. Where they agree no better than to 1e-3 the scene is refused; errors that their disagreement
does not let be told from none are marked `floor`. Of a kind without an attitude the errors are those of its rates, angular
velocities or else velocities, over the greatest of the motion.

Examples:
  cargo run --release -- accuracy --scene near-separatrix/1000
  cargo run --release -- accuracy --csv mine.csv
  cargo run --release -- accuracy --scene strip
  cargo run --release -- accuracy --scene racket --plot --output racket.svg";

#[derive(Debug, Subcommand)]
enum Command {
    /// Draws all figures, or those named, as SVG
    #[command(after_help = FIGURES)]
    Figures {
        /// Names of figures; none means all
        #[arg(value_name = "NAME")]
        names: Vec<String>,
        /// Lists the figures instead of drawing them; of those named, what may be chosen
        #[arg(long, conflicts_with_all = ["out", "check", "set", "data", "theme", "transparent", "form"])]
        list: bool,
        /// Numbers of one figure, other than the book's
        #[arg(
            long,
            value_name = "KEY=VALUE,…",
            value_delimiter = ',',
            conflicts_with = "check"
        )]
        set: Vec<String>,
        /// Writes the numbers that one figure draws, as CSV
        #[arg(long, value_name = "FILE", conflicts_with = "check")]
        data: Option<PathBuf>,
        /// Colours for light paper or dark [default: light]
        #[arg(long, value_parser = ["light", "dark"], conflicts_with = "check")]
        theme: Option<String>,
        /// No paper behind the drawing
        #[arg(long, conflicts_with = "check")]
        transparent: bool,
        /// Form of the files; all but svg need a build with `--features book/pictures` [default: svg]
        #[arg(long = "as", value_enum, value_name = "FORM", conflicts_with = "check")]
        form: Option<Form>,
        /// Width of a PDF in points, 432 by itself, or of a PNG in dots, 1200 by itself
        #[arg(long, value_name = "N", requires = "form", value_parser = clap::value_parser!(u16).range(16..=16384))]
        width: Option<u16>,
        /// Folder for the files [default: figures/svg in the workspace; the current folder for a drawing unlike the book's]
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Writes nothing; compares fresh drawings with the files, one canvas unit allowed
        #[arg(long)]
        check: bool,
    },
    /// Writes strips and a cat of paper to cut out at true size, as SVG, and a chiral top for a printer of solids, as STL
    Sheets {
        /// The size of the paper
        #[arg(long, value_parser = ["a4", "letter"], default_value = "a4")]
        paper: String,
        /// Folder for the files
        #[arg(long, value_name = "DIR", default_value = ".")]
        out: PathBuf,
    },
    /// Builds the book only
    Book {
        /// Opens the first page in the browser
        #[arg(long)]
        open: bool,
        /// Goes on, and prints it again whenever a chapter is saved; the figures stay those of the start
        #[arg(long)]
        watch: bool,
    },
    /// Renders the book for mdBook: `mdbook build book` and `mdbook serve book` call it
    Render,
    /// Simulates a scene file: a body, how it starts, and only the effects it names
    #[command(after_help = scene_help())]
    Scene {
        /// The scene file, or the name of one in book/scenes; `-` reads standard input
        #[arg(required_unless_present = "keys")]
        file: Option<PathBuf>,
        /// Prints the keys that a kind of scene has, and reads no file
        #[arg(long, value_name = "KIND", conflicts_with_all = ["file", "columns", "plot", "film", "frames", "format", "output"])]
        keys: Option<String>,
        /// The numbers of a row after the time; a name that is none has them all listed [default: the usual ones of the kind]
        #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
        columns: Vec<String>,
        /// Draws a picture instead: a panel for each COLUMN against time, or X:Y for one column against another
        #[arg(long, value_name = "WHAT,…", value_delimiter = ',', conflicts_with_all = ["columns", "format"])]
        plot: Vec<Panel>,
        /// Films the moving body instead: one SVG that plays wherever a browser shows it
        #[arg(long, conflicts_with_all = ["columns", "plot", "format"])]
        film: bool,
        /// Seconds of the motion in a second of the film [default: so that it takes ten seconds]
        #[arg(long, value_name = "RATE", requires = "film", conflicts_with_all = ["plot", "frames"])]
        speed: Option<f64>,
        /// Draws N pictures of the moving body into a new folder, at equal steps of time
        #[arg(long, num_args = 2, value_names = ["DIR", "N"], conflicts_with_all = ["columns", "plot", "film", "format", "output"])]
        frames: Vec<OsString>,
        /// Form of these pictures; all but svg need a build with `--features book/pictures` [default: svg]
        #[arg(long = "as", value_enum, value_name = "FORM", requires = "frames", conflicts_with_all = ["plot", "film"])]
        form: Option<Form>,
        /// How the motion is written [default: as the name of the output ends; csv]
        #[arg(long, value_enum)]
        format: Option<Format>,
        /// Where to; without it, standard output
        #[arg(long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Simulates a scene file over a grid of its numbers, on all cores; a line for each point
    #[command(after_help = SCAN)]
    Scan {
        /// The scene file, or the name of one in book/scenes; `-` reads standard input
        file: PathBuf,
        /// A number of the file, its range, and how many values, :log behind them for equal ratios; KEY=FROM..TO,KEY=FROM..TO:COUNT varies two
        /// together. May be given more than once
        #[arg(long, value_name = "KEY=FROM..TO:COUNT", required = true)]
        over: Vec<Over>,
        /// What is told of a motion: COLUMN, first:COLUMN, least:COLUMN, greatest:COLUMN, crossing:COLUMN=LEVEL [default: its last row]
        #[arg(long, value_name = "WHAT,…", value_delimiter = ',')]
        tell: Vec<Tell>,
        /// Draws one number instead, told as for --tell: a line over one --over, a map over two
        #[arg(long, value_name = "WHAT", conflicts_with_all = ["tell", "format"])]
        plot: Option<Tell>,
        /// How it is written [default: as the name of the output ends; csv]
        #[arg(long, value_enum)]
        format: Option<Format>,
        /// Where to; without it, standard output
        #[arg(long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Measures error against time for every method that can run a motion, on this machine
    #[command(after_help = ACCURACY)]
    Accuracy {
        /// A problem, one of its lengths, or a scene file; without it, all problems
        #[arg(long, value_name = "NAME")]
        scene: Option<String>,
        /// Also writes one row a measurement
        #[arg(long, value_name = "FILE")]
        csv: Option<PathBuf>,
        /// Draws the errors against what they cost instead, of the one motion that --scene names
        #[arg(long, requires = "scene")]
        plot: bool,
        /// Where to draw; without it, standard output
        #[arg(long, value_name = "FILE", requires = "plot")]
        output: Option<PathBuf>,
    },
    /// Lists every claim of the tutorial, its verdict, and where it is computed
    Claims,
}

/// Runs the command line and returns the exit status.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    interrupt::tidy_up_when_interrupted();
    let outcome = match Cli::try_parse_from(arguments) {
        Ok(cli) => obey(cli.command),
        // Help and version are not errors.
        Err(error) if !error.use_stderr() => say(&error.to_string()),
        Err(error) => Err(Error::Input(condensed(&error.to_string()))),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            if error.status() != 0 {
                // Nothing is left to be done if standard error is closed as well.
                let _ = writeln!(std::io::stderr(), "error: {error}");
            }
            ExitCode::from(error.status())
        }
    }
}

/// Clap tells an error in paragraphs; its first one and its tips, on one line.
fn condensed(message: &str) -> String {
    let told = message.split("\nUsage:").next().unwrap_or_default();
    let told = one_line(told.trim_start_matches("error:"));
    let told = told.replace("For more information, try '--help'.", "");
    format!("{}; `cargo run -- --help` teaches", told.trim()).replace(" tip: ", "; ")
}

fn obey(command: Option<Command>) -> Result<()> {
    let root = workspace_root()?;
    let svg = root.join("figures/svg");
    match command {
        None => {
            can_be_written_into(&svg)?;
            can_be_written_into(&root.join("book"))?;
            let drawings = draw(&drawings::chosen(&[])?, &Values::default())?;
            let changed = drawings::write(&drawings, Copying::default(), &svg)?;
            say(&report(&drawings, changed, &svg))?;
            print_book(&root, &drawings).map(drop)
        }
        Some(Command::Figures {
            list: true, names, ..
        }) => {
            let entries = drawings::chosen(&names)?;
            say(&drawings::list(&entries, !names.is_empty()))
        }
        Some(Command::Figures {
            names,
            set,
            data,
            theme,
            transparent,
            form,
            width,
            out,
            check,
            ..
        }) => {
            let entries = drawings::chosen(&names)?;
            let copying = Copying {
                look: Look {
                    theme: match theme.as_deref() {
                        Some("dark") => Theme::Dark,
                        _ => Theme::Light,
                    },
                    transparent,
                },
                form: form.unwrap_or_default(),
                width,
            };
            let values = drawings::values(&entries, &set)?;
            let as_in_the_book = values == Values::default() && copying == Copying::default();
            let standard = if as_in_the_book {
                svg
            } else {
                PathBuf::from(".")
            };
            let folder = out.unwrap_or(standard);
            if !check {
                can_be_written_into(&folder)?;
            }
            let table = data
                .map(|file| Target::new(Some(&file), None))
                .transpose()?;
            let drawings = draw(&entries, &values)?;
            if let Some(table) = table {
                let text = drawings::data(&drawings)?;
                table.write(|to| to.write_all(text.as_bytes()))?;
            }
            if check {
                drawings::check(&drawings, &folder)?;
                return say(&format!(
                    "{} figures agree with {}\n",
                    drawings.len(),
                    folder.display()
                ));
            }
            let changed = drawings::write(&drawings, copying, &folder)?;
            if let ([drawing], false) = (&drawings[..], set.is_empty()) {
                let Figure { claim, details, .. } = &drawing.figure;
                say(&format!("{claim} {details}\n"))?;
            }
            say(&report(&drawings, changed, &folder))
        }
        Some(Command::Sheets { paper, out }) => {
            can_be_written_into(&out)?;
            let paper = match paper.as_str() {
                "letter" => Paper::Letter,
                _ => Paper::A4,
            };
            drawings::sheets(paper, &out)?
                .iter()
                .try_for_each(|path| say(&format!("{}\n", path.display())))
        }
        Some(Command::Book { open, watch }) => {
            can_be_written_into(&root.join("book"))?;
            let drawings = draw(&drawings::chosen(&[])?, &Values::default())?;
            let page = print_book(&root, &drawings)?;
            if open {
                open_page(&page)?;
            }
            if watch {
                watch::watch(&root, folder_of(&page), &drawings)?;
            }
            Ok(())
        }
        Some(Command::Render) => {
            let told = binding::told_by_mdbook(std::io::stdin())?;
            let drawings = draw(&drawings::chosen(&[])?, &Values::default())?;
            binding::render(&told, &drawings)
        }
        Some(Command::Scene {
            keys: Some(kind), ..
        }) => say(&scenes::keys(&kind)?),
        Some(Command::Scene {
            file,
            columns,
            plot,
            film,
            speed,
            frames,
            form: as_form,
            format,
            output,
            ..
        }) => {
            let file = scene_file(&root, file.unwrap_or_default())?;
            let (format, form) = match (film, plot.is_empty()) {
                (true, _) => (Format::Csv, plot::form(output.as_deref(), &[Form::Svg])?),
                (false, true) => (Format::of(format, output.as_deref())?, Form::Svg),
                (false, false) => (Format::Csv, plot::form(output.as_deref(), &Form::ALL)?),
            };
            let stills = Stills::of(&frames)?;
            let target = Target::new(output.as_deref(), Some(&file))?;
            let (name, text) = scenes::source(&file)?;
            let (mut scene, request) = scenes::parse(&name, &text)?;
            let filmed = film || stills.is_some();
            let (option, columns) = match (filmed, plot.is_empty()) {
                (true, _) => {
                    let all = scene.columns().iter().map(|column| column.name.to_owned());
                    ("--film", all.collect())
                }
                (false, true) => ("--columns", columns),
                (false, false) => ("--plot", plot::columns(&plot)),
            };
            if !columns.is_empty() {
                let told = files::telling(scene, &columns);
                scene = told.map_err(|told| Error::Input(format!("{option}: {name} {told}")))?;
            }
            let motion = Motion {
                name: &name,
                scene: &scene,
                request: &request,
                progress: &Progress::default(),
            };
            if let Some(stills) = stills {
                return say(&stills.draw(&motion, as_form.unwrap_or_default())?);
            }
            let picture = match (film, plot.is_empty()) {
                (true, _) => film::film(&motion, speed)?,
                (false, true) => return target.write(|to| format.write(&motion, to)),
                (false, false) => plot::plot(&motion, &plot, form)?,
            };
            target.write(|to| to.write_all(&picture))
        }
        Some(Command::Scan {
            file,
            over,
            tell,
            plot,
            format,
            output,
        }) => {
            let file = scene_file(&root, file)?;
            let (format, form) = match plot {
                None => (Format::of(format, output.as_deref())?, None),
                Some(_) => (
                    Format::Csv,
                    Some(plot::form(output.as_deref(), &Form::ALL)?),
                ),
            };
            let target = Target::new(output.as_deref(), Some(&file))?;
            let tell = plot.map_or(tell, |plot| vec![plot]);
            let scan = Scan::new(&file, over, tell)?;
            let points = scan.points();
            if let Some(form) = form {
                let figure = counted(points, "scenes", |done| scan.picture(done))?;
                let picture = pictures::file(&figure, Copying::of(form))?;
                return target.write(|to| to.write_all(&picture));
            }
            let (text, ran) = counted(points, "scenes", |done| scan.run(format, done));
            target.write(|to| to.write_all(text.as_bytes()))?;
            ran
        }
        Some(Command::Accuracy {
            scene,
            csv,
            plot,
            output,
        }) => {
            let csv = csv.as_deref();
            let Some(scene) = scene.as_deref().filter(|_| plot) else {
                return say(&accuracy::run(&root, scene.as_deref(), csv)?.text);
            };
            let form = plot::form(output.as_deref(), &Form::ALL)?;
            let target = Target::new(
                output.as_deref(),
                scenes::file(&root, Path::new(scene)).as_deref(),
            )?;
            let figure = accuracy::picture(&root, scene, csv)?;
            let picture = pictures::file(&figure, Copying::of(form))?;
            target.write(|to| to.write_all(&picture))
        }
        Some(Command::Claims) => say(&appendix::table(&Ledger::read(&root)?)),
    }
}

fn print_book(root: &Path, drawings: &[Drawing]) -> Result<PathBuf> {
    let page = binding::bind(root, &root.join("book/build"), drawings)?;
    say(&format!("{}\n", page.display()))?;
    Ok(page)
}

fn report(drawings: &[Drawing], changed: usize, folder: &Path) -> String {
    format!(
        "{} figure{} in {}, {changed} changed\n",
        drawings.len(),
        if drawings.len() == 1 { "" } else { "s" },
        folder.display()
    )
}

/// Draws, and tells how far it is.
fn draw(entries: &[Entry], values: &Values) -> Result<Vec<Drawing>> {
    counted(entries.len(), "figures", |done| {
        drawings::draw(entries, values, done)
    })
}

/// The file that is meant.
fn scene_file(root: &Path, name: PathBuf) -> Result<PathBuf> {
    match scenes::file(root, &name) {
        _ if name == Path::new("-") => Ok(name),
        Some(file) => Ok(file),
        // Whoever reads it says what it is.
        None if name.exists() => Ok(name),
        None => Err(Error::Input(scenes::not_found(root, &name, &[]))),
    }
}

fn open_page(page: &Path) -> Result<()> {
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    match std::process::Command::new(opener).arg(page).status() {
        Ok(_) => Ok(()),
        Err(error) => Err(Error::Failed(format!(
            "{opener} cannot be started ({error}): open {} yourself",
            page.display()
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        <Cli as clap::CommandFactory>::command().debug_assert();
    }

    #[test]
    fn an_error_of_the_command_line_is_one_line() {
        for wrong in [
            &["book", "figure"][..],
            &["book", "figures", "--lst"],
            &["book", "book", "x"],
        ] {
            let error = Cli::try_parse_from(wrong).unwrap_err().to_string();
            let told = condensed(&error);
            assert_eq!(told.lines().count(), 1, "{told}");
            assert!(
                !told.contains("Usage") && told.contains(wrong[wrong.len() - 1]),
                "{told}"
            );
        }
    }
}
