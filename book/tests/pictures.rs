//! Figures as PDF and PNG, in a build that asks for them; elsewhere a refusal that says how.

use figures::{Look, Theme, Values};
use press::pictures::{Copying, Form, file};

fn dial() -> figures::Figure {
    let entry = figures::all()
        .iter()
        .find(|entry| entry.name == "spool-dial");
    entry.unwrap().draw(&Values::default()).unwrap()
}

fn copying(form: Form) -> Copying {
    let look = Look {
        theme: Theme::Dark,
        transparent: false,
    };
    Copying {
        look,
        form,
        width: Some(600),
    }
}

#[cfg(not(feature = "pictures"))]
#[test]
fn a_plain_build_says_how_to_get_them() {
    for (form, name) in [(Form::Pdf, "pdf"), (Form::Png, "png")] {
        let told = file(&dial(), copying(form)).unwrap_err().to_string();
        assert!(told.starts_with(&format!("{name}: ")), "{told}");
        assert!(
            told.contains("`cargo run --features book/pictures"),
            "{told}"
        );
    }
    let svg = file(&dial(), copying(Form::Svg)).unwrap();
    assert!(svg.starts_with(b"<svg"));
}

/// The letters, too: without a font nothing would stand in their places.
#[cfg(feature = "pictures")]
#[test]
fn a_picture_has_its_size_its_paper_and_its_letters() {
    let pdf = file(&dial(), copying(Form::Pdf)).unwrap();
    let text = String::from_utf8_lossy(&pdf);
    assert!(
        text.starts_with("%PDF-") && text.contains("/MediaBox [0 0 600 330]"),
        "{text:.600}"
    );
    let bytes = file(&dial(), copying(Form::Png)).unwrap();
    let dots = resvg::tiny_skia::Pixmap::decode_png(&bytes).unwrap();
    assert_eq!((dots.width(), dots.height()), (600, 330));
    let color = |dot: &resvg::tiny_skia::PremultipliedColorU8| [dot.red(), dot.green(), dot.blue()];
    let at = |x: u32, y: u32| color(&dots.pixel(x, y).unwrap());
    assert_eq!(at(1, 1), [0x16, 0x19, 0x23]);
    // Here stands "cos θ = r/R" and nothing else.
    let dots = (150..232).flat_map(|x| (100..120).map(move |y| (x, y)));
    let bright = dots.filter(|&(x, y)| at(x, y)[0] > 90);
    assert!(bright.count() > 100);
}
