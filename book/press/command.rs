//! The command line: what is done at each command.

use crate::drawings::{self, Drawing};
use crate::error::one_line;
use crate::ledger::Ledger;
use crate::paths::workspace_root;
use crate::pictures::{self, Copying, Form};
use crate::progress::counted;
use crate::scenes::film::{self, Stills};
use crate::scenes::output::{Format, Motion};
use crate::scenes::plot;
use crate::scenes::scan::Scan;
use crate::usage::{Cli, Command};
use crate::writer::{Target, can_be_written_into, folder_of, say};
use crate::{Error, Result, accuracy, appendix, binding, ebook, interrupt, live, scenes, watch};
use clap::Parser;
use figures::on_your_table::Paper;
use figures::{Entry, Figure, Look, Theme, Values};
use spinning_bodies::scene::{Progress, files};

use std::ffi::OsString;
use std::io::Write;
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
    format!("{}; see `cargo run -- --help`", told.trim()).replace(" tip: ", "; ")
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
            list: true,
            names,
            format,
            ..
        }) => {
            let entries = drawings::chosen(&names)?;
            if format.as_deref() == Some("json") {
                let drawings = draw(&entries, &Values::default())?;
                return say(&format!("{:#}\n", drawings::described(&drawings)));
            }
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
        Some(Command::Book {
            open,
            pdf,
            epub,
            watch,
        }) => {
            can_be_written_into(&root.join("book"))?;
            let printer = pdf.then(ebook::browser).transpose()?;
            let drawings = draw(&drawings::chosen(&[])?, &Values::default())?;
            let page = print_book(&root, &drawings)?;
            if epub {
                let file = page.with_file_name("spinning-bodies.epub");
                ebook::epub(&root, &drawings, &file)?;
                say(&format!("{}\n", file.display()))?;
            }
            if let Some(browser) = printer {
                let file = page.with_file_name("spinning-bodies.pdf");
                ebook::pdf(browser, folder_of(&page), &file)?;
                say(&format!("{}\n", file.display()))?;
            }
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
            let (Some(scene), Some(file)) = (scene.as_deref(), plot) else {
                return say(&accuracy::run(&root, scene.as_deref(), csv)?.text);
            };
            if let (Some(_), Some(output)) = (&file, &output) {
                let told = "--plot has a FILE already, expected no --output";
                return Err(Error::Input(format!("{told}, got {}", output.display())));
            }
            let output = file.or(output);
            let form = plot::form(output.as_deref(), &Form::ALL)?;
            let target = Target::new(
                output.as_deref(),
                scenes::file(&root, Path::new(scene)).as_deref(),
            )?;
            let figure = accuracy::picture(&root, scene, csv)?;
            let picture = pictures::file(&figure, Copying::of(form))?;
            target.write(|to| to.write_all(&picture))
        }
        Some(Command::Live) => {
            let (module, size) = live::build(&root)?;
            say(&format!(
                "{}: a module of {} kB\n",
                module.display(),
                size / 1000
            ))
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
