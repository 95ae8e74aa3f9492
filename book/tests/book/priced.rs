//! Every kind of scene, with each of its effects and without it: what is priced by `cargo bench -p book --bench prices`, and what tests run.
//!
//! The solver and the evaluations of the right-hand side are the same on every machine; the bench measures the time beside them, and the table
//! it writes is the source of the figure and of the book's tables.

use std::sync::LazyLock;

use serde::Deserialize;

/// A kind of scene, for the table of prices.
#[derive(Debug, Clone, Deserialize)]
pub struct Priced {
    /// The word after `kind`.
    pub kind: String,
    /// The scene without its effects.
    body: String,
    /// The effects that act in any case while others are priced.
    usual: Vec<String>,
    /// The effects that the scene cannot do without.
    #[serde(default)]
    pub needed: Vec<String>,
    /// The effects: name, and the lines of the file that set it.
    pub effects: Vec<(String, String)>,
}

/// All kinds that a scene file can name, each with all its effects.
pub static PRICED: LazyLock<Vec<Priced>> = LazyLock::new(|| {
    #[derive(Deserialize)]
    struct Prices {
        priced: Vec<Priced>,
    }
    let prices: Prices = toml::from_str(include_str!("priced.toml")).expect("it is compiled in");
    prices.priced
});

impl Priced {
    /// The file with these effects, over one second, to 1e-9.
    pub fn file(&self, listed: impl Fn(&str) -> bool) -> String {
        let listed = self.effects.iter().filter(|(name, _)| listed(name));
        let lines: Vec<&str> = listed.map(|(_, lines)| lines.as_str()).collect();
        format!(
            "kind = \"{}\"\n{}[effects]\n{}\n[run]\nuntil = 1.0\nsamples = 11\naccuracy = 1e-9\n",
            self.kind,
            self.body,
            lines.join("\n")
        )
    }

    /// The files without and with one effect, both with the usual ones; the first is `None` if the scene needs the effect.
    pub fn pair(&self, effect: &str) -> (Option<String>, String) {
        let is_in = |list: &[String], name: &str| list.iter().any(|listed| listed == name);
        let usual = |name: &str| is_in(&self.usual, name);
        let without =
            (!is_in(&self.needed, effect)).then(|| self.file(|name| usual(name) && name != effect));
        (without, self.file(|name| usual(name) || name == effect))
    }
}
