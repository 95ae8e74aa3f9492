//! Comparison of a committed figure with a fresh drawing of it.

/// Attributes whose numbers are canvas coordinates.
const COORDINATES: [&str; 10] = ["points", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r"];

/// Compares two SVG documents token by token.
///
/// Coordinates on the canvas may differ by one unit (a tenth of a design unit), and the numbers of a film by one in their last digit, because the last
/// bit of a sine may turn a rounding; everything else, numbers in labels included, must be equal.
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
        let unit = |unit: &&str| a.ends_with(unit);
        let unit = ["px", "deg", "rad"].into_iter().find(unit).unwrap_or("");
        let (Some(a), Some(b)) = (a.strip_suffix(unit), b.strip_suffix(unit)) else {
            return false;
        };
        let digits = |text: &str| text.split_once('.').map_or(0, |(_, digits)| digits.len());
        let one = 0.1_f64.powi(digits(a).max(digits(b)) as i32);
        let near = |a: f64, b: f64| (a - b).abs() < 1.5 * one;
        matches!((a.parse(), b.parse()), (Ok(a), Ok(b)) if near(a, b))
    }
}

/// Words of the text, names and values of attributes; coordinates and the numbers of a film singly.
fn tokens(document: &str) -> Vec<Token<'_>> {
    let (mut found, mut film) = (Vec::new(), false);
    let mut rest = document;
    while let Some(start) = rest.find('<') {
        let text = &rest[..start];
        match film {
            true => found.extend(text.split(['{', '}', '(', ')', ',']).map(Token::Coordinate)),
            false => found.extend(text.split_ascii_whitespace().map(Token::Other)),
        }
        film = rest[start..].starts_with("<style");
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
