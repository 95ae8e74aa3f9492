//! LaTeX to HTML, at build time: no script in the page, no network.

use katex::{KatexContext, Settings};
use regex::{Captures, Regex};
use std::sync::LazyLock;

/// HTML and hidden MathML of a formula, or a message of what is wrong with it.
pub fn html(latex: &str, settings: &Settings) -> Result<String, String> {
    static CONTEXT: LazyLock<KatexContext> = LazyLock::new(KatexContext::default);
    if has_bare_root(latex) {
        return Err(
            "write \\sqrt{…}, with braces: without them the root is set over its sign".into(),
        );
    }
    let html = katex::render_to_string(&CONTEXT, latex, settings);
    Ok(sort_attributes(&html.map_err(|error| error.to_string())?))
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
