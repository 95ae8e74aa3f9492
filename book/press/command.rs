//! The command line: carries out each command.

use crate::drawings::{self, Drawing};
use crate::error::one_line;
use crate::ledger::Ledger;
use crate::paths::workspace_root;
use crate::pictures::{self, Copying, Form};
use crate::progress::counted;
use crate::scenes::output::Format;
use crate::scenes::scan::Scan;
use crate::scenes::{Motion, film, plot};
use crate::usage::{self, Cli, Command};
use crate::writer::{
    Target, by_ending, can_be_written_into, folder_of, is_standard_output, say, say_beside,
    several, tell,
};
use crate::{Error, Result, accuracy, appendix, binding, ebook, interrupt, live, scenes, watch};
use clap::{Parser, ValueEnum};
use figures::on_your_table::Paper;
use figures::{Entry, Figure, Look, Theme, Values};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Runs the command line and returns the exit status.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    interrupt::tidy_up_when_interrupted();
    let outcome = match Cli::try_parse_from(arguments) {
        Ok(cli) => obey(cli.command),
        // Help and version are not errors.
        Err(error) if !error.use_stderr() => say(&error.to_string()),
        Err(error) => Err(Error::Input(condensed(&error.to_string()))),
    };
    let Err(error) = outcome else {
        return ExitCode::SUCCESS;
    };
    if error.status() != 0 {
        tell(format_args!("error: {error}"));
    }
    ExitCode::from(error.status())
}

/// The first paragraph of clap's error message and its tips, on one line.
fn condensed(message: &str) -> String {
    let told = message.split("\nUsage:").next().unwrap_or_default();
    let told = one_line(told.trim_start_matches("error:"));
    let told = told.replace("For more information, try '--help'.", "");
    format!("{}; see `cargo run -- --help`", told.trim()).replace(" tip: ", "; ")
}

fn obey(command: Option<Command>) -> Result<()> {
    let root = &workspace_root()?;
    match command {
        None => {
            can_be_written_into(&root.join("book"))?;
            let drawings = figures(root, usage::Figures::default())?;
            print_book(root, &drawings).map(drop)
        }
        Some(Command::Figures(asked)) if asked.list => listed(&asked),
        Some(Command::Figures(asked)) if asked.check => compared(root, asked),
        Some(Command::Figures(asked)) => figures(root, asked).map(drop),
        Some(Command::Sheets(asked)) => {
            can_be_written_into(&asked.out)?;
            let paper = Paper::ALL.into_iter().find(|one| one.name() == asked.paper);
            let sheets = drawings::sheets(paper.unwrap_or(Paper::A4), &asked.out)?;
            sheets.iter().try_for_each(|sheet| say_where(sheet))
        }
        Some(Command::Book(asked)) => book(root, &asked),
        Some(Command::Render) => binding::render(std::io::stdin(), draw_all),
        Some(Command::Scene(asked)) => match asked.keys {
            Some(kind) => say(&scenes::keys(&kind)?),
            None => scene(root, asked),
        },
        Some(Command::Scan(asked)) => scan(root, asked),
        Some(Command::Accuracy(asked)) => accuracy(root, asked),
        Some(Command::Live) => {
            let (module, size) = live::build(root)?;
            let (module, size) = (module.display(), size / 1000);
            say(&format!("{module}: a module of {size} kB\n"))
        }
        Some(Command::Claims) => say(&appendix::table(&Ledger::read(root)?)),
    }
}

fn listed(asked: &usage::Figures) -> Result<()> {
    let entries = drawings::chosen(&asked.names)?;
    if asked.format == "json" {
        let drawings = draw(&entries, &Values::default())?;
        return say(&format!("{:#}\n", drawings::described(&drawings)));
    }
    say(&drawings::list(&entries, !asked.names.is_empty()))
}

/// Draws figures and compares them with their files.
fn compared(root: &Path, asked: usage::Figures) -> Result<()> {
    let entries = drawings::chosen(&asked.names)?;
    let folder = asked.out.unwrap_or_else(|| root.join("figures/svg"));
    std::fs::read_dir(&folder).map_err(Error::file(&folder))?;
    let drawings = draw(&entries, &Values::default())?;
    drawings::check(&drawings, &folder)?;
    let (all, folder) = (several(drawings.len(), "figure"), folder.display());
    say(&format!("{all} compared with {folder}: no difference\n"))
}

/// Draws figures, writes their files, and returns them.
fn figures(root: &Path, asked: usage::Figures) -> Result<Vec<Drawing>> {
    let entries = drawings::chosen(&asked.names)?;
    pictures::can_be_made(asked.form)?;
    if let (Form::Svg, Some(width)) = (asked.form, asked.width) {
        let told =
            format!("--width: an SVG has any width, expected --as pdf or --as png, got {width}");
        return Err(Error::Input(told));
    }
    let copying = Copying {
        look: Look {
            theme: match asked.theme.as_str() {
                "dark" => Theme::Dark,
                _ => Theme::Light,
            },
            transparent: asked.transparent,
        },
        form: asked.form,
        width: asked.width,
    };
    let values = drawings::values(&entries, &asked.set)?;
    let as_in_the_book = values == Values::default() && copying == Copying::default();
    let folder = asked.out.unwrap_or_else(|| match as_in_the_book {
        true => root.join("figures/svg"),
        false => PathBuf::from("."),
    });
    can_be_written_into(&folder)?;
    let data = asked.data.as_deref();
    if data.is_some() {
        drawings::only(&entries, "--data")?;
        Format::of(Some(Format::Csv), data)?;
    }
    let table = Target::new(data, None)?;
    let drawings = draw(&entries, &values)?;
    if data.is_some() {
        table.put(drawings::data(&drawings)?)?;
    }
    let changed = drawings::write(&drawings, copying, &folder)?;
    if let ([drawing], false) = (&drawings[..], asked.set.is_empty()) {
        let Figure { claim, details, .. } = &drawing.figure;
        say_beside(data, &format!("{claim} {details}\n"))?;
    }
    let (all, folder) = (several(drawings.len(), "figure"), folder.display());
    let told = format!("{all} in {folder}, {changed} changed\n");
    say_beside(data, &told)?;
    Ok(drawings)
}

fn book(root: &Path, asked: &usage::Book) -> Result<()> {
    can_be_written_into(&root.join("book"))?;
    let printer = asked.pdf.then(ebook::browser).transpose()?;
    let drawings = draw_all()?;
    let page = print_book(root, &drawings)?;
    if asked.epub {
        let file = page.with_file_name("spinning-bodies.epub");
        ebook::epub(root, &drawings, &file)?;
        say_where(&file)?;
    }
    if let Some(browser) = printer {
        let file = page.with_file_name("spinning-bodies.pdf");
        ebook::pdf(browser, folder_of(&page), &file)?;
        say_where(&file)?;
    }
    if asked.open {
        open_page(&page)?;
    }
    match asked.watch {
        true => watch::watch(root, folder_of(&page), &drawings),
        false => Ok(()),
    }
}

fn scene(root: &Path, asked: usage::Scene) -> Result<()> {
    let file = scene_file(root, asked.file.unwrap_or_default())?;
    let output = asked.written.output.as_deref();
    let motion = || Motion::read(&file);
    if let [folder, count] = &asked.frames[..] {
        let motion = || motion()?.telling_all();
        return say(&film::stills(Path::new(folder), count, asked.form, motion)?);
    }
    if asked.film {
        by_ending(output, DRAWN, &[Form::Svg])?;
        let target = Target::new(output, Some(&file))?;
        return target.put(film::film(&motion()?.telling_all()?, asked.speed)?);
    }
    if !asked.plot.is_empty() {
        return drawn(output, Some(&file), || {
            let motion = motion()?.telling("--plot", &plot::columns(&asked.plot))?;
            plot::plot(&motion, &asked.plot)
        });
    }
    let format = Format::of(asked.written.format, output)?;
    let target = Target::new(output, Some(&file))?;
    let motion = motion()?.telling("--columns", &asked.columns)?;
    target.write(|to| format.write(&motion, to))
}

fn scan(root: &Path, asked: usage::Scan) -> Result<()> {
    let file = scene_file(root, asked.file)?;
    let output = asked.written.output.as_deref();
    if let Some(plot) = asked.plot {
        return drawn(output, Some(&file), || {
            let scan = Scan::new(&file, asked.over, vec![plot])?;
            counted(scan.points(), "scenes", |done| scan.picture(done))
        });
    }
    let format = Format::of(asked.written.format, output)?;
    let target = Target::new(output, Some(&file))?;
    let scan = Scan::new(&file, asked.over, asked.tell)?;
    let (text, ran) = counted(scan.points(), "scenes", |done| scan.run(format, done));
    target.put(text)?;
    ran
}

/// The word for such output in messages.
const DRAWN: &str = "a picture";

/// Draws a picture into a file, in the form that its ending names. Place and form are checked before anything is computed.
fn drawn(
    output: Option<&Path>,
    input: Option<&Path>,
    figure: impl FnOnce() -> Result<Figure>,
) -> Result<()> {
    let form = by_ending(output, DRAWN, Form::value_variants())?;
    pictures::can_be_made(form)?;
    let target = Target::new(output, input)?;
    target.put(pictures::file(&figure()?, form.into())?)
}

fn accuracy(root: &Path, asked: usage::Accuracy) -> Result<()> {
    let csv = asked.csv.as_deref();
    let (Some(scene), Some(file)) = (&asked.scene, asked.plot) else {
        let report = accuracy::run(root, asked.scene.as_deref(), csv)?;
        return say_beside(csv, &report.text);
    };
    if let (Some(_), Some(output)) = (&file, &asked.output) {
        let told = "--plot has a FILE already, expected no --output";
        return Err(Error::Input(format!("{told}, got {}", output.display())));
    }
    let output = file.or(asked.output).unwrap_or_else(|| "-".into());
    if is_standard_output(&output) && csv.is_some_and(is_standard_output) {
        let told = "--csv and --plot: both on standard output, expected a FILE for one of them";
        return Err(Error::Input(told.to_owned()));
    }
    let input = scenes::file(root, Path::new(scene));
    let picture = || accuracy::picture(root, scene, csv);
    drawn(Some(&output), input.as_deref(), picture)
}

fn print_book(root: &Path, drawings: &[Drawing]) -> Result<PathBuf> {
    let page = binding::bind(root, &root.join("book/build"), drawings)?;
    say_where(&page)?;
    Ok(page)
}

/// Prints where a file is.
fn say_where(file: &Path) -> Result<()> {
    say(&format!("{}\n", file.display()))
}

/// Draws figures, showing the progress.
fn draw(entries: &[Entry], values: &Values) -> Result<Vec<Drawing>> {
    let draw = |done: &(dyn Fn() + Sync)| drawings::draw(entries, values, done);
    counted(entries.len(), "figures", draw)
}

/// All figures, as in the book.
fn draw_all() -> Result<Vec<Drawing>> {
    draw(figures::all(), &Values::default())
}

/// The scene file that a name stands for.
fn scene_file(root: &Path, name: PathBuf) -> Result<PathBuf> {
    match scenes::file(root, &name) {
        _ if name == Path::new("-") => Ok(name),
        Some(file) => Ok(file),
        // Reading what is no file will report what is wrong.
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
    let opened = std::process::Command::new(opener).arg(page).status();
    opened.map(drop).map_err(|error| {
        let page = page.display();
        let told = format!("{opener} cannot be started ({error}): open {page} yourself");
        Error::Failed(told)
    })
}
