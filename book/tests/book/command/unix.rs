//! Links, pipes, devices, rights and signals.

use super::*;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
use std::time::{Duration, Instant};

fn shell(script: &str) -> Output {
    Command::new("sh").args(["-c", script]).output().unwrap()
}

fn quoted(path: &Path) -> String {
    format!("'{}'", path.to_str().unwrap())
}

const BOOK: &str = env!("CARGO_BIN_EXE_book");

#[test]
fn a_link_is_followed() {
    let (folder, file) = racket(3);
    let [other, link, dangling] =
        ["other", "link.csv", "dangling.csv"].map(|name| folder.path().join(name));
    std::fs::create_dir(&other).unwrap();
    std::fs::write(other.join("rows.csv"), "old").unwrap();
    symlink("other/rows.csv", &link).unwrap();
    symlink("other/new.csv", &dangling).unwrap();
    for path in [&link, &dangling] {
        printed(&scene(&file, &["--output", path.to_str().unwrap()]));
        assert!(path.is_symlink());
        assert!(std::fs::read(path).unwrap().starts_with(b"t,qw"));
    }
    assert_eq!(names(&other), ["new.csv", "rows.csv"]);
    let round = folder.path().join("round.csv");
    symlink("round.csv", &round).unwrap();
    let output = scene(&file, &["--output", round.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(round.is_symlink() && text(&output.stderr).contains("round.csv"));
    // So is one to a folder, empty or not there, and a slash behind it changes nothing.
    std::fs::create_dir(other.join("empty")).unwrap();
    for (link, to) in [("stills", "empty"), ("pictures", "none")] {
        symlink(other.join(to), folder.path().join(link)).unwrap();
        let link = folder.path().join(link).join("");
        printed(&scene(&file, &["--frames", link.to_str().unwrap(), "2"]));
        assert_eq!(names(&other.join(to)), ["1.svg", "2.svg"]);
    }
}

#[test]
fn the_module_of_the_live_pages_wants_a_compiler_for_browsers() {
    let mut command = Command::new(BOOK);
    let output = command.arg("live").env("RUSTC", "true").output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    let told = text(&output.stderr);
    let cure = "`rustup target add wasm32-unknown-unknown`";
    assert!(told.lines().last().unwrap().contains(cure), "{told}");
}

#[test]
fn pipes_and_devices_stay_what_they_are() {
    let (folder, file) = racket(3);
    let plain = scene(&file, &[]).stdout;
    let picture = scene(&file, &["--plot", "energy"]).stdout;
    let (pipe, link) = (folder.path().join("pipe"), folder.path().join("link"));
    assert!(shell(&format!("mkfifo {}", quoted(&pipe))).status.success());
    symlink(&pipe, &link).unwrap();
    for path in [&pipe, &link] {
        let mut reader = Command::new("cat");
        let reader = reader.arg(&pipe).stdout(Stdio::piped()).spawn().unwrap();
        printed(&scene(&file, &["--output", path.to_str().unwrap()]));
        assert_eq!(reader.wait_with_output().unwrap().stdout, plain);
        let kind = std::fs::metadata(&pipe).unwrap().file_type();
        assert!(kind.is_fifo() && link.is_symlink());
    }
    assert_eq!(names(folder.path()), ["link", "mine.toml", "pipe"]);
    for device in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"] {
        let output = scene(&file, &["--output", device]);
        assert_eq!(output.stdout, plain, "{device}");
        let drawn = scene(&file, &["--plot", "energy", "--output", device]);
        assert_eq!(drawn.stdout, picture, "{device}");
    }
    // A file that the standard output leads to goes on where it was.
    let rows = folder.path().join("rows");
    let command = format!("{BOOK} scene {} --output /dev/stdout", quoted(&file));
    let into = quoted(&rows);
    shell(&format!("(echo before; {command}; echo after) > {into}"));
    let expected = [b"before\n", plain.as_slice(), b"after\n"].concat();
    assert_eq!(std::fs::read(&rows).unwrap(), expected);
    let full = scene(&file, &["--output", "/dev/full"]);
    assert_eq!(full.status.code(), Some(1));
    assert!(text(&full.stderr).contains("/dev/full"));
    let full = shell(&format!("{BOOK} scene {} > /dev/full", quoted(&file)));
    assert_eq!(full.status.code(), Some(1), "{}", text(&full.stderr));
}

#[test]
fn a_picture_without_room_is_told_by_the_name_asked_for() {
    let folder = scratch();
    let stills = quoted(&folder.path().join("stills"));
    // A file may have one block, which no picture is content with.
    let limit = "trap '' XFSZ; ulimit -f 1";
    let output = shell(&format!("{limit}; {BOOK} scene spool --frames {stills} 2"));
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.contains("/stills/1.svg: "), "{told}");
    assert!(names(folder.path()).is_empty());
}

#[test]
fn the_input_is_not_overwritten() {
    let (folder, file) = racket(3);
    let at = |name: &str| folder.path().join(name);
    std::fs::rename(&file, at("mine.csv")).unwrap();
    let before = std::fs::read(at("mine.csv")).unwrap();
    std::fs::hard_link(at("mine.csv"), at("hard.csv")).unwrap();
    symlink("mine.csv", at("soft.csv")).unwrap();
    let output = at("mine.csv");
    let name = folder.path().file_name().unwrap();
    let spared = |output: &Output| refused(output, &["this is the input file"]);
    for out in ["mine.csv", "hard.csv", "soft.csv", "./mine.csv"] {
        spared(&scene(&output, &["--output", at(out).to_str().unwrap()]));
    }
    let other = at("..").join(name).join("mine.csv");
    let out = ["--output", other.to_str().unwrap()];
    spared(&scene(&at("soft.csv"), &out));
    let (from, over) = (quoted(&output), "--over initial.omega.0=0..1:2");
    for command in [
        format!("scene - --output {from} < {from}"),
        format!("scan {from} {over} --output {from}"),
        format!("accuracy --scene {from} --csv {from}"),
    ] {
        spared(&shell(&format!("{BOOK} {command}")));
    }
    assert_eq!(std::fs::read(&output).unwrap(), before);
    assert_eq!(names(folder.path()), ["hard.csv", "mine.csv", "soft.csv"]);
}

#[test]
fn files_get_the_rights_that_the_umask_leaves() {
    let (folder, file) = racket(3);
    let mode = |path: &Path| std::fs::metadata(path).unwrap().mode() & 0o777;
    let masks = ["022", "027", "002", "077"];
    for (umask, rights) in masks.into_iter().zip([0o644, 0o640, 0o664, 0o600]) {
        let out = folder.path().join(format!("{umask}.csv"));
        let svg = folder.path().join(umask);
        let figure = ::figures::all()[0].name;
        let [file, to, into] = [&file, &out, &svg].map(|path| quoted(path));
        printed(&shell(&format!(
            "umask {umask}; {BOOK} scene {file} --output {to} && {BOOK} figures {figure} --out {into}"
        )));
        assert_eq!(mode(&out), rights, "{umask}");
        assert_eq!(mode(&svg.join(format!("{figure}.svg"))), rights, "{umask}");
    }
    // What is there keeps its own.
    let out = folder.path().join("022.csv");
    std::fs::set_permissions(&out, std::fs::Permissions::from_mode(0o604)).unwrap();
    printed(&scene(&file, &["--output", out.to_str().unwrap()]));
    assert_eq!(mode(&out), 0o604);
}

/// Starts a long run, waits until it has made something beside its output, and sends the signal.
fn interrupted(signal: &str, status: i32) {
    let (folder, _) = mine(CHIRAL);
    let out = folder.path().join("rows.csv");
    std::fs::write(&out, "old").unwrap();
    let arguments = ["scene", "mine.toml", "--output", "rows.csv"];
    let mut child = started(folder.path(), &arguments);
    let begin = Instant::now();
    while names(folder.path()).len() < 3 {
        assert!(begin.elapsed() < Duration::from_secs(20) && child.try_wait().unwrap().is_none());
        std::thread::sleep(Duration::from_millis(20));
    }
    let kill = format!("kill -{signal} {}", child.id());
    assert!(shell(&kill).status.success());
    assert_eq!(child.wait().unwrap().code(), Some(status));
    assert_eq!(names(folder.path()), ["mine.toml", "rows.csv"]);
    assert_eq!(std::fs::read_to_string(&out).unwrap(), "old");
}

#[test]
fn an_interrupted_run_leaves_nothing_behind() {
    interrupted("INT", 130);
    interrupted("TERM", 143);
}

#[test]
fn a_saved_chapter_is_printed_again() {
    let root = press::paths::workspace_root().unwrap();
    let copy = scratch();
    for linked in ["src", "lab", "tests", "figures"] {
        symlink(root.join(linked), copy.path().join(linked)).unwrap();
    }
    let (from, book) = (root.join("book"), copy.path().join("book"));
    std::fs::create_dir(&book).unwrap();
    let copied = ["src", "scenes", "theme", "book.toml"].map(|name| quoted(&from.join(name)));
    let script = format!("cp -r {} {}", copied.join(" "), quoted(&book));
    assert!(shell(&script).status.success());

    // Two chapters suffice.
    let chapters = "# Summary\n\n- [Spinning Bodies](index.md)\n- [The superball](superball.md)\n";
    std::fs::write(book.join("src/SUMMARY.md"), chapters).unwrap();
    let settings = std::fs::read_to_string(book.join("book.toml")).unwrap();
    let settings = settings.replace("\"gallery.md\" = ", "\"superball.md\" = ");
    std::fs::write(book.join("book.toml"), settings).unwrap();

    let mut child = started(copy.path(), &["book", "--watch"]);
    let mut told = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut told = || told.next().unwrap().unwrap();
    let complaints = BufReader::new(child.stderr.take().unwrap()).lines();
    let mut complaints = complaints.map(Result::unwrap);
    assert!(told().ends_with("book/build/index.html"));
    assert!(told().starts_with("watching"));

    // What is wrong is told, and the next change mends it; an example is computed elsewhere.
    let chapter = book.join("src/superball.md");
    let before = std::fs::read_to_string(&chapter).unwrap();
    std::fs::write(&chapter, format!("{before}\n{{{{figure nope}}}}\n")).unwrap();
    let error = complaints.find(|line| line.starts_with("error: "));
    assert!(error.unwrap().contains("'nope'"));
    let changed = before.replacen("```rust\n", "```rust\n// Changed.\n", 1);
    std::fs::write(&chapter, changed).unwrap();
    let page = || std::fs::read_to_string(book.join("build/superball.html")).unwrap();
    // Half-saved, the file may have no examples, and be printed twice.
    let mut again = false;
    loop {
        let line = told();
        again |= line.starts_with("book/src/superball.md: printed again in ");
        if line.contains("`cargo test -p book --doc -- superball`")
            && page().contains("// Changed.")
        {
            break;
        }
    }
    assert!(again);

    let kill = format!("kill -INT {}", child.id());
    assert!(shell(&kill).status.success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

#[test]
fn an_early_end_of_the_reader_is_quiet() {
    let (_folder, file) = racket(100_000);
    let file = quoted(&file);
    let output = shell(&format!(
        "{{ {BOOK} scene {file}; echo $? >&2; }} | head -n 2"
    ));
    assert_eq!(text(&output.stderr), "0\n");
    assert_eq!(text(&output.stdout).lines().count(), 2);
}

#[test]
fn a_file_without_end_is_refused() {
    for endless in ["/dev/zero", "-"] {
        let output = shell(&format!("{BOOK} scene {endless} < /dev/zero"));
        refused(&output, &["4000000 bytes"]);
    }
}

/// Peak of resident memory, kB, asked for until the process is gone.
#[cfg(target_os = "linux")]
fn peak(arguments: &[&str]) -> u64 {
    let mut child = Command::new(BOOK)
        .args(arguments)
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    while child.try_wait().unwrap().is_none() {
        let told = std::fs::read_to_string(&status).unwrap_or_default();
        let line = told.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let now = line.and_then(|line| line.trim().trim_end_matches("kB").trim().parse().ok());
        peak = now.unwrap_or(0).max(peak);
        std::thread::sleep(Duration::from_millis(2));
    }
    assert!(child.wait().unwrap().success());
    peak
}

#[test]
#[cfg(target_os = "linux")]
fn memory_stays_small_up_to_the_largest_output() {
    // Observed: 42 MB; of five million rows 132 MB. As one JSON value half a million took 1.5 GB.
    let (_folder, file) = racket(600_000);
    let peak = peak(&["scene", file.to_str().unwrap(), "--format", "json"]);
    assert!((20_000..80_000).contains(&peak), "{peak} kB");
    let (_folder, file) = racket(10_000_001);
    refused(&scene(&file, &[]), &["samples", "10000000"]);
}

#[test]
fn a_long_run_tells_how_far_it_is() {
    let (folder, _) = mine(CHIRAL);
    let mut child = started(folder.path(), &["scene", "mine.toml"]);
    let mut told = String::new();
    let mut lines = BufReader::new(child.stderr.take().unwrap());
    // After one second and a half; a run that is over by then says nothing.
    lines.read_line(&mut told).unwrap();
    child.kill().unwrap();
    child.wait().unwrap();
    let said = ["simulating: t = ", "of at most 200 million"].map(|words| told.find(words));
    assert!(said[0] == Some(0) && said[1].is_some(), "{told}");
}
