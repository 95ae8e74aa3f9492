//! Reads the tables and keys of one file and collects its mistakes, each in one line with file, line and key.

use core::cell::{Cell, RefCell};
use core::fmt::Display;
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
    /// Line, counted from 1, and message; messages without a line come last.
    mistakes: RefCell<Vec<(usize, String)>>,
    /// Reads another file, named in this one.
    pub open: &'a Open<'a>,
    /// Whether the file serves only to list the keys; then optional tables are read as well.
    pub lists: bool,
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
            lists: false,
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
        reader.add(error.span(), told);
        reader.finish(None)
    }

    /// The value made from the file, if there were no mistakes.
    pub fn finish<T>(self, made: Option<T>) -> Result<T, Mistakes> {
        let mut mistakes = self.mistakes.into_inner();
        mistakes.sort_by_key(|mistake| mistake.0);
        let is_right = mistakes.is_empty();
        let told = mistakes.into_iter().map(|(_, told)| told);
        made.filter(|_| is_right)
            .ok_or_else(|| Mistakes(told.collect()))
    }

    /// Records a mistake at this place of the text.
    fn add(&self, place: Option<Range<usize>>, told: String) {
        // A key in quotes may have anything in it.
        let told = told.replace(char::is_control, " ");
        let before = |place: Range<usize>| self.text.get(..place.start).unwrap_or_default();
        let line = place.map(|place| before(place).matches('\n').count() + 1);
        let mistake = match line {
            Some(line) => (line, format!("{}:{line}: {told}", self.name)),
            None => (usize::MAX, format!("{}: {told}", self.name)),
        };
        let mut mistakes = self.mistakes.borrow_mut();
        // A key that is read for two purposes is reported once.
        if !mistakes.contains(&mistake) {
            mistakes.push(mistake);
        }
    }

    /// Records a mistake in these keys, given by their paths, separated by commas: "body.mass, body.radius".
    pub fn wrong<T>(&self, keys: &str, told: impl Display) -> Option<T> {
        self.add(self.place(keys), format!("{}{told}", named(keys)));
        None
    }

    /// The place of the first of these keys that is there, or of the table.
    fn place(&self, keys: &str) -> Option<Range<usize>> {
        let mut paths = keys.split(", ").chain(keys.split('.').take(1));
        Some(paths.find_map(|path| find(&self.entries, path))?.0)
    }

    /// Records that a key is missing.
    pub fn missing<T>(&self, key: &str, expected: &str) -> Option<T> {
        self.wrong(key, format_args!(" is missing: {expected} is expected"))
    }

    /// Records that a key and another of its table exclude each other.
    pub fn exclude<T>(&self, key: &str, other: &str) -> Option<T> {
        self.wrong(key, format_args!(" and `{other}` exclude each other"))
    }

    /// The result of a constructor; its error is recorded for these keys.
    pub fn right<T, E: Display>(&self, keys: &str, given: Result<T, E>) -> Option<T> {
        given.map_or_else(|error| self.wrong(keys, format_args!(": {error}")), Some)
    }

    /// A value as written in the file, shortened.
    pub fn shown(&self, value: &Toml<'_>) -> String {
        let text = self.text.get(value.span()).unwrap_or_default();
        let words: Vec<&str> = text.split_whitespace().collect();
        words.join(" ").chars().take(40).collect()
    }
}

/// A key and its value, by the path: "body.moments", or "body.moments.2" with places in a list counted from 0.
pub(super) fn find<'t, 'a>(
    entries: &'t DeTable<'a>,
    path: &str,
) -> Option<(Range<usize>, &'t Toml<'a>)> {
    let mut steps = path.split('.');
    let (key, value) = entries.get_key_value(steps.next()?)?;
    let mut found = (key.span(), value);
    for step in steps {
        found = match found.1.get_ref() {
            DeValue::Table(table) => {
                let (key, value) = table.get_key_value(step)?;
                (key.span(), value)
            }
            DeValue::Array(list) => {
                let value = list.get(step.parse::<usize>().ok()?)?;
                (value.span(), value)
            }
            _ => return None,
        };
    }
    Some(found)
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
    /// Whether the value is a table with keys of its own.
    const IS_TABLE: bool = false;

    /// The expected value in words.
    fn expected(key: &Key) -> String {
        key.expected("")
    }

    /// The value from the TOML value written there.
    fn read(place: &Place<'_>, value: &Toml<'_>) -> Option<Self>;

    /// The default and its text; `None` if the key must be given.
    fn absent() -> Option<(Self, String)> {
        None
    }

    /// The value from its table; one made from several keys takes them itself.
    fn take(table: &Table<'_>, key: &Key, default: Option<(Self, String)>) -> Option<Self> {
        table.value(key, default)
    }
}

/// A table with declared keys.
pub(super) trait Section: Value {
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
    /// Whether unknown keys are allowed.
    takes_any: Cell<bool>,
}

impl<'r> Table<'r> {
    /// The file itself.
    pub fn whole(reader: &'r Reader<'r>) -> Self {
        Self::new(reader, String::new(), Some(&reader.entries))
    }

    pub fn new(reader: &'r Reader<'r>, path: String, entries: Option<&'r DeTable<'r>>) -> Self {
        Self {
            reader,
            path,
            entries,
            known: RefCell::default(),
            takes_any: Cell::default(),
        }
    }

    /// Allows unknown keys: the key that decides which there may be is wrong.
    pub fn takes_any(&self) {
        self.takes_any.set(true);
    }

    fn path_of(&self, key: &str) -> String {
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
    pub fn value<T: Value>(&self, key: &Key, default: Option<(T, String)>) -> Option<T> {
        let place = Place { table: self, key };
        if let Some(value) = self.entry(key.name) {
            return T::read(&place, value);
        }
        if T::IS_TABLE && self.reader.lists {
            let empty = DeValue::Table(DeTable::new());
            return T::read(&place, &Spanned::new(0..0, empty));
        }
        let (value, absent) = default.or_else(T::absent).unzip();
        self.reader.absent.borrow_mut().push(KeyRow {
            section: self.path.clone(),
            key: key.name,
            expected: T::expected(key),
            absent,
        });
        value
    }

    /// One of the main tables, such as `[body]`: read as empty if it is absent, unless its name seems to be misspelt.
    pub fn part<S: Section>(&self, name: &'static str) -> Option<S> {
        let key = &Key::new(name, "a table", None);
        match self.entry(name) {
            Some(value) => S::read(&Place { table: self, key }, value),
            None if self.slip(name).is_some() => None,
            None => Self::new(self.reader, name.to_owned(), None).section(),
        }
    }

    /// All keys of the table; each is read before the first mistake ends the reading.
    pub fn section<S: Section>(self) -> Option<S> {
        let before = self.reader.mistakes.borrow().len();
        let section = S::fields(&self);
        self.done();
        let told = self.reader.mistakes.borrow().len();
        section.filter(|_| told == before)
    }

    fn strangers(&self) -> impl Iterator<Item = &'r str> {
        let known = self.known.borrow().clone();
        let keys = self.entries.into_iter().flat_map(DeTable::keys);
        keys.map(|key| key.get_ref().as_ref())
            .filter(move |key| !known.contains(key))
    }

    /// An unknown key that may be a misspelling of this one.
    fn slip(&self, key: &str) -> Option<&'r str> {
        nearest(key, self.strangers())
    }

    /// Records the unknown and the missing keys; a misspelt one is reported once.
    pub fn done(&self) {
        let absent = self.reader.absent.borrow();
        let needed = |row: &&KeyRow| row.section == self.path && row.absent.is_none();
        for row in absent.iter().filter(needed) {
            if self.slip(row.key).is_none() {
                (self.reader).missing::<()>(&self.path_of(row.key), &row.expected);
            }
        }
        let known = self.known.borrow();
        let strangers = self.strangers().filter(|_| !self.takes_any.get());
        for key in strangers.take(MOST) {
            let meant = meant(key, known.iter().copied());
            let told = match known.join(", ") {
                all if all.is_empty() => " is unknown: no key is allowed here".to_owned(),
                all => format!(" is unknown; allowed are {all}{meant}"),
            };
            self.reader.wrong::<()>(&self.path_of(key), told);
        }
    }
}

/// A key of a table.
pub(super) struct Place<'p> {
    pub table: &'p Table<'p>,
    pub key: &'p Key,
}

impl<'p> Place<'p> {
    /// The path of the key: "body.mass".
    pub fn path(&self) -> String {
        self.table.path_of(self.key.name)
    }

    /// Records that the value is of the wrong type.
    pub fn unexpected<T>(&self, value: &Toml<'_>, expected: &str) -> Option<T> {
        let (kind, shown) = (value.get_ref().type_str(), self.table.reader.shown(value));
        self.wrong(value, format_args!("{expected}, got the {kind} {shown}"))
    }

    /// Records that the value is not as it must be.
    pub fn wrong<T>(&self, value: &Toml<'_>, must_be: impl Display) -> Option<T> {
        let told = format!("{} must be {must_be}", named(&self.path()));
        self.table.reader.add(Some(value.span()), told);
        None
    }
}

/// The question whether one of these was meant, `; did you mean ...?`, if one is similar; otherwise empty.
///
/// ```
/// use spinning_bodies::scene::files::meant;
/// let known = ["gravity", "friction"].into_iter();
/// assert_eq!(meant("gravty", known), "; did you mean `gravity`?");
/// ```
pub fn meant<'a>(word: &str, among: impl Iterator<Item = &'a str>) -> String {
    nearest(word, among).map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
}

/// The word that shares at least half of its letters, in their order, with another; hyphens do not count.
pub(super) fn nearest<'a>(word: &str, among: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let bare = |word: &str| word.to_lowercase().replace(['-', '_'], "");
    let word = bare(word);
    let alike = |other| strsim::normalized_damerau_levenshtein(&word, &bare(other));
    let all = among.map(|other| (alike(other), other));
    let near = all.filter(|(likeness, _)| *likeness >= 0.5);
    near.max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, other)| other)
}
