//! Reads a scene file table by table; every refusal names the file, the key and what was expected.

use std::cell::RefCell;
use std::rc::Rc;

use spinning_bodies::error::Number;
use spinning_bodies::frame::{Attitude, BodyVector};
use toml::{Table, Value};

use crate::{Error, Result};

/// A scene file, or a table in it.
#[derive(Debug)]
pub struct Section<'a> {
    file: &'a str,
    /// `body`, or nothing for the file itself.
    name: &'static str,
    table: Option<&'a Table>,
    /// The keys that someone has asked for: those that the section may have.
    known: RefCell<Vec<&'static str>>,
    /// The same with what was expected, of the whole file.
    asked: Rc<RefCell<Vec<Key>>>,
}

/// A key that a reader has asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// The table it stands in; nothing for the file itself.
    pub section: &'static str,
    /// The key.
    pub key: &'static str,
    /// What was expected: "a mass in kg".
    pub what: String,
}

impl<'a> Section<'a> {
    /// The file itself.
    pub fn whole(file: &'a str, table: &'a Table) -> Self {
        Self {
            file,
            name: "",
            table: Some(table),
            known: RefCell::default(),
            asked: Rc::default(),
        }
    }

    /// The keys that have been asked for so far, in the whole file, in this order.
    pub fn asked(&self) -> Vec<Key> {
        self.asked.borrow().clone()
    }

    /// The table `[name]`; if it is not there, one without keys.
    ///
    /// # Errors
    /// If `name` is not a table.
    pub fn section(&self, name: &'static str) -> Result<Section<'a>> {
        let table = match self.value(name) {
            None => None,
            Some(Value::Table(table)) => Some(table),
            Some(other) => {
                return Err(self.expected(name, "a table", other));
            }
        };
        Ok(Section {
            file: self.file,
            name,
            table,
            known: RefCell::default(),
            asked: Rc::clone(&self.asked),
        })
    }

    /// A number, if the key is there.
    ///
    /// # Errors
    /// If it is not a finite number.
    pub fn optional(&self, key: &'static str, what: &str) -> Result<Option<f64>> {
        self.note(key, what);
        self.value(key)
            .map(|value| self.to_number(key, what, value))
            .transpose()
    }

    /// A number.
    ///
    /// # Errors
    /// If it is missing, or not a finite number. `what` says what was expected: "a mass in kg".
    pub fn number(&self, key: &'static str, what: &str) -> Result<f64> {
        self.optional(key, what)?
            .ok_or_else(|| self.missing(key, what))
    }

    /// A number, or another if the key is not there.
    ///
    /// # Errors
    /// If it is not a finite number.
    pub fn number_or(&self, key: &'static str, what: &str, other: f64) -> Result<f64> {
        Ok(self.optional(key, what)?.unwrap_or(other))
    }

    /// A number greater than zero, if the key is there.
    ///
    /// # Errors
    /// If it is not a finite number, or not positive.
    pub fn optional_positive(&self, key: &'static str, what: &str) -> Result<Option<f64>> {
        let held = |number| self.held(key, what, number, number > 0.0, "positive");
        self.optional(key, what)?.map(held).transpose()
    }

    /// A number greater than zero.
    ///
    /// # Errors
    /// As for [`optional_positive`](Self::optional_positive), or if it is missing.
    pub fn positive(&self, key: &'static str, what: &str) -> Result<f64> {
        let number = self.optional_positive(key, what)?;
        number.ok_or_else(|| self.missing(key, what))
    }

    /// A number that may be zero but not less, if the key is there.
    ///
    /// # Errors
    /// If it is not a finite number, or negative.
    pub fn optional_not_negative(&self, key: &'static str, what: &str) -> Result<Option<f64>> {
        let held = |number| self.held(key, what, number, number >= 0.0, "not negative");
        self.optional(key, what)?.map(held).transpose()
    }

    /// N numbers greater than zero.
    ///
    /// # Errors
    /// As for [`list`](Self::list), or if one of them is not positive.
    pub fn positives<const N: usize>(&self, key: &'static str, what: &str) -> Result<[f64; N]> {
        let list = self.list(key, what)?;
        for number in list {
            self.held(key, what, number, number > 0.0, "all of them positive")?;
        }
        Ok(list)
    }

    /// The number of a key, if it is `right`; `rule` says what it should be besides `what`.
    ///
    /// # Errors
    /// If it is not.
    pub fn held(&self, key: &str, what: &str, number: f64, right: bool, rule: &str) -> Result<f64> {
        if right {
            Ok(number)
        } else {
            Err(self.refused(key, format!("must be {what}, {rule}, got {number:?}")))
        }
    }

    /// N numbers, if the key is there.
    ///
    /// # Errors
    /// If it is not a list of N finite numbers.
    pub fn optional_list<const N: usize>(
        &self,
        key: &'static str,
        what: &str,
    ) -> Result<Option<[f64; N]>> {
        let what = format!("{what}, a list of {N} numbers");
        let Some(list) = self.optional_numbers(key, &what)? else {
            return Ok(None);
        };
        let length = list.len();
        let list = <[f64; N]>::try_from(list);
        list.map(Some)
            .map_err(|_| self.refused(key, format!("must be {what}, got {length}")))
    }

    /// N numbers.
    ///
    /// # Errors
    /// If it is missing, or not a list of N finite numbers.
    pub fn list<const N: usize>(&self, key: &'static str, what: &str) -> Result<[f64; N]> {
        let list = self.optional_list(key, what)?;
        list.ok_or_else(|| self.missing(key, &format!("{what}, a list of {N} numbers")))
    }

    /// Numbers, any count of them, if the key is there.
    ///
    /// # Errors
    /// If it is not a list of finite numbers.
    pub fn optional_numbers(&self, key: &'static str, what: &str) -> Result<Option<Vec<f64>>> {
        self.note(key, what);
        match self.value(key) {
            None => Ok(None),
            Some(Value::Array(values)) => {
                let numbers = values.iter().map(|value| self.to_number(key, what, value));
                numbers.collect::<Result<Vec<f64>>>().map(Some)
            }
            Some(other) => Err(self.expected(key, what, other)),
        }
    }

    /// A whole number between two bounds, if the key is there.
    ///
    /// # Errors
    /// If it is no whole number, or beyond the bounds.
    pub fn optional_count(
        &self,
        key: &'static str,
        least: usize,
        most: usize,
    ) -> Result<Option<usize>> {
        let what = format!("a whole number from {least} to {most}");
        self.note(key, &what);
        match self.value(key) {
            None => Ok(None),
            Some(Value::Integer(count)) => match usize::try_from(*count) {
                Ok(count) if (least..=most).contains(&count) => Ok(Some(count)),
                _ => Err(self.refused(key, format!("must be {what}, got {count}"))),
            },
            Some(other) => Err(self.expected(key, &what, other)),
        }
    }

    /// A text, if the key is there.
    ///
    /// # Errors
    /// If it is not a string.
    pub fn optional_text(&self, key: &'static str, what: &str) -> Result<Option<&'a str>> {
        self.note(key, what);
        match self.value(key) {
            None => Ok(None),
            Some(Value::String(text)) => Ok(Some(text)),
            Some(other) => Err(self.expected(key, what, other)),
        }
    }

    /// A list of texts, if the key is there.
    ///
    /// # Errors
    /// If it is not a list of strings, or an empty one.
    pub fn optional_words(&self, key: &'static str, what: &str) -> Result<Option<Vec<&'a str>>> {
        self.note(key, what);
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        let words = value.as_array().filter(|words| !words.is_empty());
        let words = words.and_then(|words| words.iter().map(Value::as_str).collect());
        words.map_or_else(
            || Err(self.expected(key, what, value)),
            |words| Ok(Some(words)),
        )
    }

    /// One of several words; the first of them if the key is not there.
    ///
    /// # Errors
    /// If it is none of them; all are listed.
    pub fn word<T: Copy>(&self, key: &'static str, words: &[(&str, T)]) -> Result<T> {
        let names: Vec<&str> = words.iter().map(|(name, _)| *name).collect();
        let what = format!("one of {}", names.join(", "));
        let text = self.optional_text(key, &what)?.unwrap_or(names[0]);
        match words.iter().find(|(name, _)| *name == text) {
            Some((_, word)) => Ok(*word),
            None => {
                let meant = meant(text, names.into_iter());
                Err(self.refused(key, format!("must be {what}, got \"{text}\"{meant}")))
            }
        }
    }

    /// Components along the body's axes.
    ///
    /// # Errors
    /// As for [`optional_list`](Self::optional_list).
    pub fn optional_vector(&self, key: &'static str, what: &str) -> Result<Option<BodyVector>> {
        let list = self.optional_list(key, what)?;
        Ok(list.map(|[x, y, z]| BodyVector::new(x, y, z)))
    }

    /// The key `attitude`, a unit quaternion; the identity if it is not there. Rounding is forgiven, and divided out.
    ///
    /// # Errors
    /// If it is not a list of four numbers with |q| between 0.999 and 1.001.
    pub fn attitude(&self) -> Result<Attitude> {
        const KEY: &str = "attitude";
        let Some([w, x, y, z]) = self.optional_list(KEY, "a unit quaternion w x y z")? else {
            return Ok(Attitude::identity());
        };
        let length = w.hypot(x).hypot(y.hypot(z));
        if (length - 1.0).abs() > 1e-3 {
            let told = format!(
                "must be a unit quaternion w x y z, got one of length {}",
                Number(length)
            );
            return Err(self.refused(KEY, told));
        }
        Attitude::from_quaternion(w, x, y, z).map_err(self.about(KEY))
    }

    /// Turns a refusal of the library into one that names the file and the key; several keys, with commas between them, where they are to blame together.
    pub fn about(&self, key: &str) -> impl FnOnce(spinning_bodies::Error) -> Error + '_ {
        let place = self.place(key);
        move |error| Error::Input(format!("{place}: {error}"))
    }

    /// A refusal of a key.
    pub fn refused(&self, key: &str, told: impl std::fmt::Display) -> Error {
        Error::Input(format!("{} {told}", self.place(key)))
    }

    /// Whether the key is there.
    pub fn has(&self, key: &'static str) -> bool {
        self.value(key).is_some()
    }

    /// Ends the reading of this section.
    ///
    /// # Errors
    /// If it has a key that nobody has asked for.
    pub fn done(self) -> Result<()> {
        let known = self.known.borrow();
        let Some(table) = self.table else {
            return Ok(());
        };
        match table.keys().find(|key| !known.contains(&key.as_str())) {
            None => Ok(()),
            Some(key) if known.is_empty() => {
                Err(self.refused(key, "is unknown: no key is allowed here"))
            }
            Some(key) => {
                let (allowed, meant) = (known.join(", "), meant(key, known.iter().copied()));
                Err(self.refused(key, format!("is unknown; allowed are {allowed}{meant}")))
            }
        }
    }

    fn note(&self, key: &'static str, what: &str) {
        let mut asked = self.asked.borrow_mut();
        if !asked.iter().any(|a| a.section == self.name && a.key == key) {
            asked.push(Key {
                section: self.name,
                key,
                what: what.to_owned(),
            });
        }
    }

    fn value(&self, key: &'static str) -> Option<&'a Value> {
        let mut known = self.known.borrow_mut();
        if !known.contains(&key) {
            known.push(key);
        }
        self.table?.get(key)
    }

    fn to_number(&self, key: &str, what: &str, value: &Value) -> Result<f64> {
        let number = match value {
            Value::Float(number) => *number,
            Value::Integer(number) => *number as f64,
            other => return Err(self.expected(key, what, other)),
        };
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.refused(key, format!("must be {what}, and finite, got {number}")))
        }
    }

    /// A refusal of a key that is not there.
    pub fn missing(&self, key: &str, what: &str) -> Error {
        let known = self.known.borrow();
        let strange = self.table.into_iter().flat_map(Table::keys);
        let strange = strange
            .map(String::as_str)
            .filter(|key| !known.contains(key));
        let meant = match nearest(key, strange) {
            Some(slip) => format!("; is `{slip}` a slip for it?"),
            None => String::new(),
        };
        self.refused(key, format!("is missing: {what} is expected{meant}"))
    }

    fn expected(&self, key: &str, what: &str, got: &Value) -> Error {
        let shown: String = got.to_string().chars().take(40).collect();
        let kind = got.type_str();
        self.refused(key, format!("must be {what}, got the {kind} {shown}"))
    }

    fn place(&self, key: &str) -> String {
        let key = key.replace(", ", "`, `");
        match self.name {
            "" => format!("{}: key `{key}`", self.file),
            name => format!("{}: key `{key}` in [{name}]", self.file),
        }
    }
}

/// A question whether one of these was meant, where one is near.
pub fn meant<'a>(word: &str, among: impl Iterator<Item = &'a str>) -> String {
    nearest(word, among).map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
}

/// The word that shares at least half of its letters, in their order, with another; hyphens do not count.
fn nearest<'a>(word: &str, among: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let bare = |word: &str| word.to_lowercase().replace(['-', '_'], "");
    let word = bare(word);
    let alike = |other| strsim::normalized_damerau_levenshtein(&word, &bare(other));
    let all = among.map(|other| (alike(other), other));
    let near = all.filter(|(likeness, _)| *likeness >= 0.5);
    near.max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, other)| other)
}
