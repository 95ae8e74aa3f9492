//! The marks of a drawing, and how a backend of plotters draws them.
//!
//! A mark knows its role, not its colour; the finisher puts colours in. The backend is called directly, so that a page in a
//! browser needs `plotters-svg` and nothing else of plotters.

use core::convert::Infallible;

use plotters_backend::text_anchor::{HPos, Pos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontFamily,
};

/// A point of the design, units.
pub type Point = [f64; 2];

/// The meaning of a colour. A hue belongs to a quantity, never to a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The colour of the text around the figure.
    Ink,
    /// Fainter ink: remarks, construction lines.
    Muted,
    /// Angular velocity.
    Omega,
    /// Angular momentum.
    AngularMomentum,
    /// Torque.
    Torque,
    /// The shading of a round body: a radial gradient of ink.
    Shade,
    /// The page: the fill of a nearer body that hides what is behind it.
    Paper,
}

impl Role {
    /// All roles.
    pub const ALL: [Role; 7] = [
        Role::Ink,
        Role::Muted,
        Role::Omega,
        Role::AngularMomentum,
        Role::Torque,
        Role::Shade,
        Role::Paper,
    ];

    /// The colour that stands for the role on the canvas, until the finisher replaces it.
    pub const fn stand_in(self) -> (u8, u8, u8) {
        (self as u8, 0, 0)
    }

    /// The paint of the finished figure: a variable of the page with a fallback.
    pub const fn paint(self) -> &'static str {
        match self {
            Role::Ink | Role::Shade => "currentColor",
            Role::Muted => "var(--muted-ink, #61667a)",
            Role::Omega => "var(--omega, #0b6bcb)",
            Role::AngularMomentum => "var(--angular-momentum, #b85300)",
            Role::Torque => "var(--torque, #6b1a6b)",
            Role::Paper => "var(--bg, Canvas)",
        }
    }
}

/// Which side of its point a text stands on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at the point.
    Start,
    /// The text is centred on the point.
    Middle,
    /// The text ends at the point.
    End,
}

/// The paint of a mark: a role, its opacity in 0…1, and the width of its stroke, canvas units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paint {
    /// What the colour means.
    pub role: Role,
    /// Opacity, from 0 to 1.
    pub alpha: f64,
    /// Width of the stroke.
    pub width: u32,
}

impl BackendStyle for Paint {
    fn color(&self) -> BackendColor {
        BackendColor {
            alpha: self.alpha,
            rgb: self.role.stand_in(),
        }
    }

    fn stroke_width(&self) -> u32 {
        self.width
    }
}

/// One element of a picture, in whole canvas units.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// A line through points.
    Path(Vec<BackendCoord>, Paint),
    /// A filled polygon.
    Polygon(Vec<BackendCoord>, Paint),
    /// A disc, or a circle of the paint's width.
    Circle {
        /// Its middle.
        center: BackendCoord,
        /// Its radius.
        radius: u32,
        /// Its paint.
        paint: Paint,
        /// Whether it is a disc.
        filled: bool,
    },
    /// Words.
    Text {
        /// The point at which their base line starts, is centred or ends.
        at: BackendCoord,
        /// Its alignment.
        anchor: Anchor,
        /// The text, with the markup `*x*`, `_{…}` and `^{…}`.
        body: String,
        /// Their paint; the width is not used.
        paint: Paint,
        /// Their size.
        size: f64,
    },
}

impl Mark {
    /// Its paint.
    pub fn paint(&self) -> &Paint {
        let (Self::Path(_, paint)
        | Self::Polygon(_, paint)
        | Self::Circle { paint, .. }
        | Self::Text { paint, .. }) = self;
        paint
    }
}

/// Draws marks in their order.
///
/// # Errors
/// Those of the backend.
pub fn draw<'a, B: DrawingBackend>(
    marks: impl Iterator<Item = &'a Mark>,
    backend: &mut B,
) -> Result<(), DrawingErrorKind<B::ErrorType>> {
    for mark in marks {
        match mark {
            Mark::Path(points, paint) => backend.draw_path(points.iter().copied(), paint)?,
            Mark::Polygon(points, paint) => backend.fill_polygon(points.iter().copied(), paint)?,
            Mark::Circle {
                center,
                radius,
                paint,
                filled,
            } => backend.draw_circle(*center, *radius, paint, *filled)?,
            Mark::Text {
                at,
                anchor,
                body,
                paint,
                size,
            } => backend.draw_text(body, &Letters(*anchor, *paint, *size), *at)?,
        }
    }
    backend.present()
}

/// Where a text stands, its paint and its size.
struct Letters(Anchor, Paint, f64);

impl BackendTextStyle for Letters {
    type FontError = Infallible;

    fn color(&self) -> BackendColor {
        self.1.color()
    }

    fn size(&self) -> f64 {
        self.2
    }

    fn anchor(&self) -> Pos {
        let horizontal = match self.0 {
            Anchor::Start => HPos::Left,
            Anchor::Middle => HPos::Center,
            Anchor::End => HPos::Right,
        };
        Pos::new(horizontal, VPos::Bottom)
    }

    fn family(&self) -> FontFamily<'_> {
        FontFamily::SansSerif
    }

    // The letters are laid out by the program that shows the picture.
    fn layout_box(&self, _: &str) -> Result<(BackendCoord, BackendCoord), Infallible> {
        Ok(((0, 0), (0, 0)))
    }

    fn draw<E, F: FnMut(i32, i32, BackendColor) -> Result<(), E>>(
        &self,
        _: &str,
        _: BackendCoord,
        _: F,
    ) -> Result<Result<(), E>, Infallible> {
        Ok(Ok(()))
    }
}
