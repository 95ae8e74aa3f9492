//! A figure's file in other forms than SVG: PDF and PNG.
//!
//! They are made by resvg and svg2pdf, behind the feature `pictures`, so that building the book does not require these crates.

use figures::{Figure, Look};

use crate::writer::ending;
use crate::{Error, Result};

/// The form of a figure's file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Form {
    /// Lines and letters, for the web and for drawing programs.
    #[default]
    Svg,
    /// Lines and letters, for print; the width is in points.
    Pdf,
    /// Dots, for slides; the width is in dots.
    Png,
}

/// The way a figure is written: its look, its form, and its width unless it is SVG, which scales.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Copying {
    /// Colours and paper.
    pub look: Look,
    /// Form of the file.
    pub form: Form,
    /// Width in points or dots; by default 432 points, six inches, or 1200 dots.
    pub width: Option<u16>,
}

impl From<Form> for Copying {
    /// On light paper.
    fn from(form: Form) -> Self {
        Self {
            form,
            ..Self::default()
        }
    }
}

/// Checks that this build can make pictures of this form, before any work is done for them.
///
/// # Errors
/// [`Error::Input`] for another form than SVG in a build without the feature `pictures`.
pub fn can_be_made(form: Form) -> Result<()> {
    if form == Form::Svg || cfg!(feature = "pictures") {
        return Ok(());
    }
    let form = ending(&form);
    Err(Error::Input(format!(
        "{form}: this build writes SVG only, expected one with the feature: `cargo run --features book/pictures -- …`"
    )))
}

/// The file of a figure.
///
/// # Errors
/// As for [`can_be_made`]; [`Error::Failed`] where no font is installed.
pub fn file(figure: &Figure, copying: Copying) -> Result<Vec<u8>> {
    can_be_made(copying.form)?;
    let svg = figure.file(copying.look);
    #[cfg(feature = "pictures")]
    if copying.form != Form::Svg {
        return converted(&svg, copying);
    }
    Ok(svg.into_bytes())
}

/// Fonts with serifs, the book's first.
#[cfg(feature = "pictures")]
const SERIFS: [&str; 6] = [
    "Latin Modern Roman",
    "CMU Serif",
    "Times New Roman",
    "Liberation Serif",
    "DejaVu Serif",
    "FreeSerif",
];

#[cfg(feature = "pictures")]
fn converted(svg: &str, copying: Copying) -> Result<Vec<u8>> {
    use resvg::tiny_skia::{Pixmap, Transform};
    use svg2pdf::usvg::{Options, Tree};

    let failed = |told: String| Error::Failed(format!("--as {}: {told}", ending(&copying.form)));
    let paper = copying.look.theme.color(figures::style::Role::Paper);
    // The background of an SVG is a style of the page that shows it; these forms need a rectangle.
    let sheet = format!("</title>\n<rect width=\"100%\" height=\"100%\" fill=\"{paper}\"/>\n");
    let svg = match copying.look.transparent {
        true => svg.to_owned(),
        false => svg.replacen("</title>\n", &sheet, 1),
    };
    let mut options = Options::default();
    let fonts = options.fontdb_mut();
    fonts.load_system_fonts();
    // The figure asks for the typeface of the book, or else for any with serifs that is installed.
    let there = |name: &&str| {
        let mut families = fonts.faces().flat_map(|face| &face.families);
        families.any(|(family, _)| family == name)
    };
    let serif = SERIFS.into_iter().find(there).map(str::to_owned);
    let any = || Some(fonts.faces().next()?.families.first()?.0.clone());
    let serif = serif.or_else(any);
    fonts.set_serif_family(
        serif.ok_or_else(|| failed("no font is installed, so letters would be missing".into()))?,
    );
    let tree = Tree::from_str(&svg, &options).map_err(|error| failed(error.to_string()))?;
    let size = tree.size();
    match copying.form {
        Form::Pdf => {
            let width = f32::from(copying.width.unwrap_or(432));
            // A page has 72 points to the inch.
            let page = svg2pdf::PageOptions {
                dpi: 72.0 * size.width() / width,
            };
            let settings = svg2pdf::ConversionOptions::default();
            svg2pdf::to_pdf(&tree, settings, page).map_err(|error| failed(error.to_string()))
        }
        _ => {
            let width = f32::from(copying.width.unwrap_or(1200));
            let scale = width / size.width();
            let height = (scale * size.height()).round() as u32;
            let mut dots = Pixmap::new(width as u32, height)
                .ok_or_else(|| failed(format!("a picture {width} dots wide cannot be made")))?;
            let scaled = Transform::from_scale(scale, scale);
            resvg::render(&tree, scaled, &mut dots.as_mut());
            dots.encode_png().map_err(|error| failed(error.to_string()))
        }
    }
}
