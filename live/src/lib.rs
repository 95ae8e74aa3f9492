//! The WebAssembly module of the live pages: a page asks for a figure with changed parameters and gets the same picture as the press would print.
//!
//! No generated bindings are used. The page writes its question into the memory of the module, where
//! `room` points, and reads the answer where `draw` points; both are UTF-8. The question is what follows `#fig-` in the address,
//!
//! ```text
//! spool-dial?axle=0.6&tension=0.5
//! ```
//!
//! and the answer is the picture, the claim, the details of the caption and a line `KEY X Y` for each point of the picture that can be dragged,
//! with a zero byte between them; or one line that says what is wrong. While such a point is dragged, the question has a second line, `KEY X Y`, and
//! the answer is the value of the parameter for that place.

use std::cell::RefCell;
use std::fmt::Write as _;

use figures::{Entry, Parameter, Values};

thread_local! {
    static QUESTION: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<String> = const { RefCell::new(String::new()) };
}

/// The functions that a page calls. None of them dereferences a pointer; the page reads and writes the memory of the module.
#[expect(unsafe_code, reason = "an exported name needs an unsafe attribute")]
mod called {
    use super::{ANSWER, QUESTION, answer};

    /// Returns where to write a question of `length` bytes.
    #[unsafe(no_mangle)]
    extern "C" fn room(length: usize) -> *mut u8 {
        QUESTION.with_borrow_mut(|question| {
            *question = vec![0; length];
            question.as_mut_ptr()
        })
    }

    /// Answers the question and returns where the answer begins.
    #[unsafe(no_mangle)]
    extern "C" fn draw() -> *const u8 {
        let question = QUESTION.take();
        ANSWER.set(answer(&String::from_utf8_lossy(&question)));
        ANSWER.with_borrow(|answer| answer.as_ptr())
    }

    /// The number of bytes of the answer.
    #[unsafe(no_mangle)]
    extern "C" fn length() -> usize {
        ANSWER.with_borrow(String::len)
    }
}

/// The answer to a question, or what is wrong with it.
fn answer(question: &str) -> String {
    let (address, dragged) = question.split_once('\n').unwrap_or((question, ""));
    let answered = chosen(address).and_then(|(entry, values)| match dragged {
        "" => drawn(entry, &values),
        _ => found(entry, &values, dragged),
    });
    answered.unwrap_or_else(|told| told)
}

/// The figure that an address names, and its parameters.
fn chosen(address: &str) -> Result<(&'static Entry, Values), String> {
    let (name, set) = address.split_once('?').unwrap_or((address, ""));
    let entry = figures::all().iter().find(|entry| entry.name == name);
    let entry = entry.ok_or_else(|| format!("no figure is called '{name}'"))?;
    let mut pairs = set.split('&').filter(|pair| !pair.is_empty());
    let values = pairs.try_fold(Values::default(), |values, pair| {
        let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
        values.with(entry.parameter(key)?, number(value)?)
    });
    Ok((entry, values?))
}

fn drawn(entry: &Entry, values: &Values) -> Result<String, String> {
    let figure = entry.draw(values).map_err(|error| error.to_string())?;
    let picture = figure.svg();
    let mut answer = [picture.trim_end(), &figure.claim, &figure.details, ""].join("\0");
    for Parameter { key, handle, .. } in entry.parameters {
        if let Some(place) = handle {
            let [x, y] = place(values);
            let _ = writeln!(answer, "{key} {x} {y}");
        }
    }
    Ok(answer)
}

/// The value that a dragged point stands for.
fn found(entry: &Entry, values: &Values, dragged: &str) -> Result<String, String> {
    let mut words = dragged.split(' ');
    let mut word = || words.next().unwrap_or_default();
    let (key, point) = (word(), [number(word())?, number(word())?]);
    let value = entry.parameter(key)?.dragged_to(point, values);
    let value = value.ok_or_else(|| format!("{key} has no point to be dragged"))?;
    Ok(value.to_string())
}

fn number(text: &str) -> Result<f64, String> {
    text.parse()
        .map_err(|_| format!("'{text}' is not a number"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write as _;
    use std::process::{Command, Stdio};

    fn parts(answer: &str) -> [&str; 4] {
        let parts: Vec<_> = answer.split('\0').collect();
        parts.try_into().unwrap_or_else(|told| panic!("{told:?}"))
    }

    /// Every figure that has parameters, as the book shows it; and one parameter after the other at both ends and a third of the way.
    fn questions() -> Vec<String> {
        let moved = figures::all()
            .iter()
            .filter(|entry| !entry.parameters.is_empty());
        let asked = moved.flat_map(|entry| {
            let each = entry.parameters.iter().flat_map(|one| {
                [0.0, 0.3, 1.0].map(|share| format!("{}?{}={}", entry.name, one.key, one.at(share)))
            });
            core::iter::once(entry.name.to_owned()).chain(each)
        });
        // There a polhode comes so close to the crossing of two ellipses that the last bit decides which way it turns.
        asked
            .filter(|question| question != "polhodes?largest=2.6")
            .collect()
    }

    #[test]
    fn a_page_gets_what_the_press_prints() {
        let address = "spool-dial?axle=0.6&tension=0.2";
        let (entry, values) = chosen(address).unwrap();
        let figure = entry.draw(&values).unwrap();
        let answer = answer(address);
        let [picture, claim, details, places] = parts(&answer);
        assert_eq!(picture, figure.svg().trim_end());
        assert_eq!([claim, details], [&figure.claim, &figure.details]);
        // A hand that takes the point where it stands leaves the value as it is.
        let dragged = super::answer(&format!("{address}\n{}", places.trim_end()));
        assert!(
            (dragged.parse::<f64>().unwrap() - 0.6).abs() < 1e-6,
            "{dragged}"
        );
    }

    #[test]
    fn what_is_wrong_is_told_on_one_line() {
        for (question, told) in [
            ("spool-dal", "no figure is called 'spool-dal'"),
            (
                "spool-dial?axel=0.6",
                "figure spool-dial has no parameter 'axel'",
            ),
            ("spool-dial?axle=", "'' is not a number"),
            (
                "spool-dial?axle=2",
                "axle is 2, expected a number from 0.05 to 0.95",
            ),
            (
                "spool-dial\ntension 1 1",
                "tension has no point to be dragged",
            ),
            ("spool-dial\naxle 1", "'' is not a number"),
        ] {
            let answer = answer(question);
            assert!(
                answer.starts_with(told) && !answer.contains(['\n', '\0']),
                "{answer}"
            );
        }
    }

    /// The committed module in node, as a page calls it. Its sines and logarithms are not those of this machine: a coordinate may be one unit off.
    #[test]
    #[ignore = "wants node"]
    fn the_committed_module_draws_the_same() {
        let questions = questions();
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
        let mut node = Command::new("node");
        node.args([".ci/live.cjs", "book/src/assets/live-module.js"])
            .current_dir(folder);
        let mut node = node
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let asked = questions.join("\x01");
        node.stdin
            .take()
            .unwrap()
            .write_all(asked.as_bytes())
            .unwrap();
        let output = node.wait_with_output().unwrap();
        assert!(output.status.success());
        let answers = String::from_utf8(output.stdout).unwrap();
        let answers: Vec<_> = answers.split('\x01').collect();
        assert_eq!(answers.len(), questions.len());
        let mut faults = Vec::new();
        for (question, there) in questions.iter().zip(answers) {
            let here = answer(question);
            let ([here, claim, details, _], [there, said, added, _]) = (parts(&here), parts(there));
            faults.extend(figures::compare(question, here, there).err());
            if [claim, details] != [said, added] {
                faults.push(format!(
                    "{question}: {claim} {details}\n    there: {said} {added}"
                ));
            }
        }
        assert!(
            faults.is_empty(),
            "`cargo run -- live` builds it again: {}",
            faults.join("\n")
        );
    }
}
