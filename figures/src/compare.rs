//! Comparison of a committed figure with a fresh drawing of it.

/// Attributes whose numbers are canvas coordinates.
const COORDINATES: [&str; 10] = ["points", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r"];

/// Compares two SVG documents token by token.
///
/// Coordinates on the canvas may differ by one unit (a tenth of a design unit), because the last bit of a
/// sine may turn a rounding; everything else, numbers in labels included, must be equal.
///
/// # Errors
/// The first difference, on one line: the figure's name, the number of the token, and what stands there in both.
pub fn compare(figure: &str, committed: &str, drawn: &str) -> Result<(), String> {
    let (mut old, mut new) = (tokens(committed).into_iter(), tokens(drawn).into_iter());
    let mut place = 0;
    loop {
        place += 1;
        let (a, b) = match (old.next(), new.next()) {
            (None, None) => return Ok(()),
            (Some(a), Some(b)) if a == b || a.within_one_unit(&b) => continue,
            differ => differ,
        };
        let shown = |token: Option<Token<'_>>| match token {
            Some(Token::Coordinate(text) | Token::Other(text)) => format!("`{text}`"),
            None => "the end".to_owned(),
        };
        return Err(format!(
            "figure {figure}: token {place} is {} in the committed file and {} when drawn; `cargo run -- figures {figure}` draws it afresh",
            shown(a),
            shown(b)
        ));
    }
}

/// A piece of a document: a coordinate, or anything else.
#[derive(Debug, PartialEq, Eq)]
enum Token<'a> {
    Coordinate(&'a str),
    Other(&'a str),
}

impl Token<'_> {
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
        found.extend(rest[..start].split_ascii_whitespace().map(Token::Other));
        let end = rest[start..]
            .find('>')
            .map_or(rest.len(), |k| start + k + 1);
        tag_tokens(&rest[start..end], &mut found);
        rest = &rest[end..];
    }
    found.extend(rest.split_ascii_whitespace().map(Token::Other));
    found
}

fn tag_tokens<'a>(tag: &'a str, found: &mut Vec<Token<'a>>) {
    let mut pieces = tag.split('"');
    while let Some(before) = pieces.next() {
        found.extend(before.split_ascii_whitespace().map(Token::Other));
        let name = before.trim().trim_end_matches('=');
        let name = name.rsplit(char::is_whitespace).next().unwrap_or(name);
        let Some(value) = pieces.next() else {
            continue;
        };
        if COORDINATES.contains(&name) {
            let coordinates = value.split([' ', ',']).filter(|n| !n.is_empty());
            found.extend(coordinates.map(Token::Coordinate));
        } else {
            found.extend(value.split_ascii_whitespace().map(Token::Other));
        }
    }
}
