//! Reads the tables and keys of one file and collects its mistakes, each in one line with file, line and key.

use core::cell::{Cell, RefCell};
use core::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::keys::{Key, KeyRow};

/// All mistakes in a file, but a hundred unknown keys of a table at most, in the order of its lines; each is one line with the file, the line, the key, and the expected value.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}", .0.join("\n"))]
pub struct Mistakes(Vec<String>);

/// Most unknown keys of a table that are told.
const MOST: usize = 100;

/// A file being read. A method that returns `None` has recorded the mistake.
pub(super) struct Reader<'a> {
    name: &'a str,
    text: &'a str,
    entries: DeTable<'a>,
    /// Line, counted from 1, and message, in this order; messages without a line come last.
    mistakes: RefCell<Vec<(usize, String)>>,
    /// Reads another file, named in this one.
    pub open: &'a Open<'a>,
    /// The keys that were looked for and are absent.
    pub absent: RefCell<Vec<KeyRow>>,
}

/// Returns the bytes of a file named in a scene file, or the reason why it cannot.
pub(super) type Open<'a> = dyn Fn(&str) -> Result<Vec<u8>, String> + 'a;

impl<'a> Reader<'a> {
    /// # Errors
    /// A message if the text is not TOML.
    pub fn new(name: &'a str, text: &'a str, open: &'a Open<'a>) -> Result<Self, Mistakes> {
        let (entries, errors) = DeTable::parse_recoverable(text);
        let reader = Self {
            name,
            text,
            entries: entries.into_inner(),
            mistakes: RefCell::default(),
            open,
            absent: RefCell::default(),
        };
        let Some(error) = errors.first() else {
            return Ok(reader);
        };
        let mut told = error.message().to_owned();
        if told == "duplicate key" {
            let key = error.span().and_then(|place| text.get(place));
            told = format!("key `{}` stands twice", key.unwrap_or_default());
        }
        reader.add(error.span(), &[&told]);
        reader.finish(None)
    }

    /// The value made from the file, if there were no mistakes.
    pub fn finish<T>(self, made: Option<T>) -> Result<T, Mistakes> {
        let told = self.mistakes.into_inner().into_iter().map(|(_, told)| told);
        let told: Vec<String> = told.collect();
        made.filter(|_| told.is_empty()).ok_or(Mistakes(told))
    }

    /// Records a mistake at this place of the text.
    fn add(&self, place: Option<Range<usize>>, told: &[&str]) {
        let before = |place: Range<usize>| self.text.get(..place.start).unwrap_or_default();
        let line = place.map(|place| before(place).matches('\n').count() + 1);
        let at = line.map_or_else(String::new, |line| format!(":{line}"));
        let told = format!("{}{at}: {}", self.name, told.concat());
        // A key in quotes may have anything in it, and so may the name of a file.
        let told = told.replace(char::is_control, " ");
        let mistake = (line.unwrap_or(usize::MAX), told);
        let mut mistakes = self.mistakes.borrow_mut();
        // A key that is read for two purposes is reported once.
        if !mistakes.contains(&mistake) {
            let after = mistakes.partition_point(|told| told.0 <= mistake.0);
            mistakes.insert(after, mistake);
        }
    }

    /// Records a mistake in these keys, given by their paths, separated by commas: "body.mass, body.radius". It has the place of the first of them that
    /// is there, or of the table.
    pub fn wrong<T>(&self, keys: &str, told: &str) -> Option<T> {
        let mut paths = keys.split(", ").chain(keys.split('.').take(1));
        let first = paths.find_map(|path| find(&self.entries, path));
        self.add(first.map(Spanned::span), &[&named(keys), told]);
        None
    }

    /// Records that a key is missing.
    pub fn missing<T>(&self, key: &str, expected: &str) -> Option<T> {
        self.wrong(key, &format!(" is missing: {expected} is expected"))
    }

    /// Records that a key and another of its table exclude each other.
    pub fn exclude<T>(&self, key: &str, other: &str) -> Option<T> {
        self.wrong(key, &format!(" and `{other}` exclude each other"))
    }

    /// The values of keys of which either all or none must be there.
    pub fn together<T>(&self, keys: &str, all: Option<T>) -> Option<Option<T>> {
        let is_there = |path| find(&self.entries, path).is_some();
        if all.is_none() && keys.split(", ").any(is_there) {
            return self.wrong(keys, " belong together");
        }
        Some(all)
    }

    /// The result of a constructor; its error is recorded for these keys.
    pub fn right<T>(&self, keys: &str, given: crate::Result<T>) -> Option<T> {
        given.map_or_else(|error| self.wrong(keys, &format!(": {error}")), Some)
    }

    /// What is read from the table with this path, if all of it is right; an absent table is empty.
    pub fn section<T>(&self, path: String, read: fn(&Table<'_>) -> Option<T>) -> Option<T> {
        let found = find(&self.entries, &path);
        if let Some(value) = found.filter(|value| !value.get_ref().is_table()) {
            let (kind, shown) = (value.get_ref().type_str(), self.shown(value));
            let told = format!(" must be a table, got the {kind} {shown}");
            return self.wrong(&path, &told);
        }
        let mistakes = || self.mistakes.borrow().len();
        let (before, table) = (mistakes(), Table::new(self, path));
        let section = read(&table);
        table.done();
        section.filter(|_| mistakes() == before)
    }

    /// A value as it is written, shortened.
    fn shown(&self, value: &Toml<'_>) -> String {
        let text = self.text.get(value.span()).unwrap_or_default();
        let words: Vec<&str> = text.split_whitespace().collect();
        words.join(" ").chars().take(40).collect()
    }
}

/// The value with this path: "body.moments", or "body.moments.2" with places in a list counted from 0.
pub(super) fn find<'t, 'a>(entries: &'t DeTable<'a>, path: &str) -> Option<&'t Toml<'a>> {
    let mut steps = path.split('.');
    let first = entries.get(steps.next()?)?;
    steps.try_fold(first, |value, step| {
        let place = step.parse().unwrap_or(usize::MAX);
        // A number has one path: "00" is no place.
        let member = value.get_ref().get(place);
        let member = member.filter(|_| place.to_string() == step);
        member.or_else(|| value.get_ref().get(step))
    })
}

/// The path of a key or of a place in a list, from the path of its table or list; that of the file is empty.
pub(super) fn joined(path: &str, step: &str) -> String {
    match path {
        "" => step.to_owned(),
        path => format!("{path}.{step}"),
    }
}

/// The names of keys in a message, those of one table together.
fn named(keys: &str) -> String {
    let parted = |path| str::rsplit_once(path, '.').unwrap_or(("", path));
    let paths: Vec<(&str, &str)> = keys.split(", ").map(parted).collect();
    let tables = paths.chunk_by(|a, b| a.0 == b.0).map(|keys| {
        let names: Vec<String> = keys.iter().map(|(_, key)| format!("`{key}`")).collect();
        match keys[0].0 {
            "" => names.join(", "),
            table => format!("{} in [{table}]", names.join(", ")),
        }
    });
    format!("key {}", tables.collect::<Vec<_>>().join(", "))
}

/// A TOML value and its place in the text.
pub(super) type Toml<'v> = Spanned<DeValue<'v>>;

/// A type that can be the value of a key.
pub(super) trait Value: Sized {
    /// The expected value in words; empty for a table, whose keys have words of their own.
    fn expected(key: &Key) -> String {
        key.expected("")
    }

    /// The value as it is written in the file.
    fn read(place: &Place<'_>) -> Option<Self>;

    /// The default and its text; `None` if the key must be given.
    fn absent(_: &Table<'_>, _: &Key) -> Option<(Self, String)> {
        None
    }
}

/// What is made from a table with declared keys.
pub(super) trait Section: Sized {
    /// Reads all keys.
    fn fields(table: &Table<'_>) -> Option<Self>;
}

/// A table of the file, or the file itself.
pub(super) struct Table<'r> {
    pub reader: &'r Reader<'r>,
    path: String,
    entries: Option<&'r DeTable<'r>>,
    /// The keys that were looked for, which are those that the table may have.
    known: RefCell<Vec<&'static str>>,
    /// Whether unknown keys are allowed: the key that decides which there may be is wrong.
    pub takes_any: Cell<bool>,
}

impl<'r> Table<'r> {
    /// The table with this path; that of the file itself is empty.
    pub fn new(reader: &'r Reader<'r>, path: String) -> Self {
        let entries = match path.as_str() {
            "" => Some(&reader.entries),
            path => find(&reader.entries, path).and_then(|value| value.get_ref().as_table()),
        };
        Self {
            reader,
            path,
            entries,
            known: RefCell::default(),
            takes_any: Cell::default(),
        }
    }

    pub fn path_of(&self, key: &str) -> String {
        joined(&self.path, key)
    }

    /// The TOML value of a key.
    pub fn entry(&self, key: &'static str) -> Option<&'r Toml<'r>> {
        let mut known = self.known.borrow_mut();
        // Some keys are looked for twice, because others depend on them.
        if !known.contains(&key) {
            known.push(key);
        }
        self.entries?.get(key)
    }

    /// The value of a key, or its default if it is absent.
    pub fn value<T: Value>(&self, key: &Key) -> Option<T> {
        let (table, expected) = (self, &T::expected(key));
        if let Some(value) = self.entry(key.name) {
            return T::read(&Place {
                table,
                key,
                value,
                expected,
            });
        }
        let (value, absent) = T::absent(self, key).unzip();
        if !expected.is_empty() {
            self.reader.absent.borrow_mut().push(KeyRow {
                section: self.path.clone(),
                key: key.name,
                expected: expected.clone(),
                absent,
            });
        }
        value
    }

    /// What is read from one of the main tables, such as `[body]`: empty if it is absent, unless its name seems to be misspelt.
    pub fn part<T>(&self, name: &'static str, read: fn(&Table<'_>) -> Option<T>) -> Option<T> {
        if self.entry(name).is_none() && self.slip(name).is_some() {
            return None;
        }
        self.reader.section(name.to_owned(), read)
    }

    fn strangers(&self) -> impl Iterator<Item = &'r str> {
        let known = self.known.borrow().clone();
        let keys = self.entries.into_iter().flat_map(DeTable::keys);
        keys.map(|key| key.get_ref().as_ref())
            .filter(move |key| !known.contains(key))
    }

    /// An unknown key that may be a misspelling of this one.
    fn slip(&self, key: &str) -> Option<&'r str> {
        nearest(key, &mut self.strangers())
    }

    /// Records the unknown and the missing keys; a misspelt one is reported once.
    pub fn done(&self) {
        let reader = self.reader;
        let absent = reader.absent.borrow();
        let needed = |row: &&KeyRow| row.section == self.path && row.absent.is_none();
        for row in absent.iter().filter(needed) {
            if self.slip(row.key).is_none() {
                reader.missing::<()>(&self.path_of(row.key), &row.expected);
            }
        }
        let known = self.known.borrow();
        let strangers = self.strangers().filter(|_| !self.takes_any.get());
        for key in strangers.take(MOST) {
            let told = match known.join(", ") {
                all if all.is_empty() => " is unknown: no key is allowed here".to_owned(),
                all => {
                    let meant = meant(key, known.iter().copied());
                    format!(" is unknown; allowed are {all}{meant}")
                }
            };
            reader.wrong::<()>(&self.path_of(key), &told);
        }
    }
}

/// A value in the file, and the key that it belongs to.
#[derive(Clone, Copy)]
pub(super) struct Place<'p> {
    pub table: &'p Table<'p>,
    pub key: &'p Key,
    pub value: &'p Toml<'p>,
    pub expected: &'p str,
}

impl<'p> Place<'p> {
    /// The path of the key: "body.mass".
    pub fn path(&self) -> String {
        self.table.path_of(self.key.name)
    }

    /// The value as it is written, shortened.
    pub fn shown(&self) -> String {
        self.table.reader.shown(self.value)
    }

    /// Records that the value is of the wrong type.
    pub fn unexpected<T>(&self) -> Option<T> {
        let kind = self.value.get_ref().type_str();
        self.wrong(&format!(", got the {kind} {}", self.shown()))
    }

    /// Records that the value is not as it must be.
    pub fn wrong<T>(&self, got: &str) -> Option<T> {
        let told = [&named(&self.path()), " must be ", self.expected, got];
        self.table.reader.add(Some(self.value.span()), &told);
        None
    }

    /// The result of a constructor; its error is recorded for this key.
    pub fn right<T>(&self, given: crate::Result<T>) -> Option<T> {
        self.table.reader.right(&self.path(), given)
    }
}

/// The question whether one of these was meant, `; did you mean ...?`, if one is similar; otherwise empty.
///
/// ```
/// use spinning_bodies::scene::files::meant;
/// let known = ["gravity", "friction"].into_iter();
/// assert_eq!(meant("gravty", known), "; did you mean `gravity`?");
/// ```
pub fn meant<'a>(word: &str, mut among: impl Iterator<Item = &'a str>) -> String {
    nearest(word, &mut among).map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
}

/// The word that shares at least half of its letters, in their order, with another; hyphens do not count.
fn nearest<'a>(word: &str, among: &mut dyn Iterator<Item = &'a str>) -> Option<&'a str> {
    let bare = |word: &str| word.to_lowercase().replace(['-', '_'], "");
    let word = bare(word);
    let alike = |other| strsim::normalized_damerau_levenshtein(&word, &bare(other));
    let all = among.map(|other| (alike(other), other));
    let near = all.filter(|(likeness, _)| *likeness >= 0.5);
    near.max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, other)| other)
}
