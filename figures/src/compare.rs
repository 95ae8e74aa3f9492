//! Comparison of a committed figure with a fresh drawing of it.

/// Where two drawings of a figure differ.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Name of the figure.
    pub figure: String,
    /// Number of the token, from 1.
    pub token: usize,
    /// The token in the committed file; empty where it has ended.
    pub committed: String,
    /// The token in the fresh drawing; empty where it has ended.
    pub drawn: String,
}

impl core::fmt::Display for Difference {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let shown = |token: &str| {
            if token.is_empty() {
                "the end".to_owned()
            } else {
                format!("`{token}`")
            }
        };
        write!(
            f,
            "figure {}: token {} is {} in the committed file and {} when drawn; `cargo run -- figures {}` draws it afresh",
            self.figure,
            self.token,
            shown(&self.committed),
            shown(&self.drawn),
            self.figure
        )
    }
}

impl core::error::Error for Difference {}

/// Attributes whose numbers are canvas coordinates.
const COORDINATES: [&str; 10] = ["points", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r"];

/// Compares two SVG documents token by token.
///
/// Coordinates on the canvas may differ by one unit (a tenth of a design unit), because the last bit of a
/// sine may turn a rounding; everything else, numbers in labels included, must be equal.
///
/// # Errors
/// The first [`Difference`], with the figure's name, the token and both values.
pub fn compare(figure: &str, committed: &str, drawn: &str) -> Result<(), Difference> {
    let (mut old, mut new) = (tokens(committed).into_iter(), tokens(drawn).into_iter());
    let mut token = 0;
    loop {
        token += 1;
        let (a, b) = (old.next(), new.next());
        let agree = match (&a, &b) {
            (None, None) => return Ok(()),
            (Some(a), Some(b)) => a == b || a.within_one_unit(b),
            _ => false,
        };
        if !agree {
            return Err(Difference {
                figure: figure.to_owned(),
                token,
                committed: a.map_or_else(String::new, |t| t.text().to_owned()),
                drawn: b.map_or_else(String::new, |t| t.text().to_owned()),
            });
        }
    }
}

/// A piece of a document: a coordinate, or anything else.
#[derive(Debug, PartialEq, Eq)]
enum Token<'a> {
    Coordinate(&'a str),
    Other(&'a str),
}

impl<'a> Token<'a> {
    fn text(&self) -> &'a str {
        match self {
            Token::Coordinate(text) | Token::Other(text) => text,
        }
    }

    fn within_one_unit(&self, other: &Token<'_>) -> bool {
        let (Token::Coordinate(a), Token::Coordinate(b)) = (self, other) else {
            return false;
        };
        match (a.parse::<i64>(), b.parse::<i64>()) {
            (Ok(a), Ok(b)) => a.abs_diff(b) <= 1,
            _ => false,
        }
    }
}

/// Words of the text, names and values of attributes; coordinates singly.
fn tokens(document: &str) -> Vec<Token<'_>> {
    let mut found = Vec::new();
    let mut rest = document;
    while let Some(start) = rest.find('<') {
        found.extend(rest[..start].split_whitespace().map(Token::Other));
        let end = rest[start..]
            .find('>')
            .map_or(rest.len(), |k| start + k + 1);
        tag_tokens(&rest[start..end], &mut found);
        rest = &rest[end..];
    }
    found.extend(rest.split_whitespace().map(Token::Other));
    found
}

fn tag_tokens<'a>(tag: &'a str, found: &mut Vec<Token<'a>>) {
    let mut pieces = tag.split('"');
    while let Some(before) = pieces.next() {
        found.extend(before.split_whitespace().map(Token::Other));
        let name = before.trim().trim_end_matches('=');
        let name = name.rsplit(char::is_whitespace).next().unwrap_or(name);
        let Some(value) = pieces.next() else {
            continue;
        };
        if COORDINATES.contains(&name) {
            found.extend(
                value
                    .split([' ', ','])
                    .filter(|n| !n.is_empty())
                    .map(Token::Coordinate),
            );
        } else {
            found.extend(value.split_whitespace().map(Token::Other));
        }
    }
}
