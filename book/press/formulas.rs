//! LaTeX to HTML, at build time: no script in the page, no network.

use katex::{KatexContext, Settings};
use regex::{Captures, Regex};
use std::collections::HashMap;
use std::sync::LazyLock;

/// The style in which a formula is typeset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Style {
    /// In the line.
    Inline,
    /// On a line of its own.
    Display,
}

/// Typesets formulas, each of them only once.
#[derive(Default)]
pub struct Formulas {
    context: KatexContext,
    known: HashMap<(String, Style), String>,
}

impl Formulas {
    /// HTML and hidden MathML of a formula, or a message of what is wrong with it.
    pub fn set(&mut self, latex: &str, style: Style) -> Result<String, String> {
        let key = (latex.to_owned(), style);
        if let Some(html) = self.known.get(&key) {
            return Ok(html.clone());
        }
        if has_bare_root(latex) {
            return Err(
                "write \\sqrt{…}, with braces: without them the root is set over its sign".into(),
            );
        }
        let display = style == Style::Display;
        let settings = Settings::builder().display_mode(display).build();
        let html = katex::render_to_string(&self.context, latex, &settings);
        let html = sort_attributes(&html.map_err(|error| error.to_string())?);
        self.known.insert(key, html.clone());
        Ok(html)
    }
}

/// Whether a root lacks the braces without which the renderer leaves no room for its sign.
fn has_bare_root(latex: &str) -> bool {
    let mut behind = latex.split("\\sqrt").skip(1);
    behind.any(|after| !after.trim_start().starts_with(['{', '[']))
}

/// The attributes of a tag; in text a quote is an entity.
static ATTRIBUTES: LazyLock<Regex> =
    LazyLock::new(|| Regex::new(r#"(?: [^ =<>"]+="[^"]*")+"#).expect("it is well formed"));

/// The renderer keeps attributes in a hash map, so that their order changes from run to run; sorted, equal input
/// gives equal bytes.
fn sort_attributes(html: &str) -> String {
    let sorted = |found: &Captures<'_>| {
        let names_and_values: Vec<&str> = found[0].split_inclusive('"').collect();
        let mut attributes: Vec<&[&str]> = names_and_values.chunks(2).collect();
        attributes.sort_unstable();
        attributes.concat().concat()
    };
    ATTRIBUTES.replace_all(html, sorted).into_owned()
}
