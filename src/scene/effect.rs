//! What it means that an effect is there, or is not.

/// An effect of a scene: its presence is part of the scene's type, so what is absent leaves no instruction behind.
///
/// Each kind of scene has its own slots, one an effect, and asks of a type in a slot what that effect does; [`Absent`] answers
/// with nothing at all, not with zero. Slots are filled by name, so the order in which effects are listed cannot matter.
pub trait Effect: Copy + core::fmt::Debug {
    /// Whether the effect acts.
    const PRESENT: bool;
    /// Its name in a scene file.
    const NAME: &'static str;
}

/// The effect that is not there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Absent;

impl Effect for Absent {
    const PRESENT: bool = false;
    const NAME: &'static str = "absent";
}

/// From values that may be there at run time to types that are: one match an effect, and the last argument is compiled once for every
/// combination.
///
/// `choose!((gravity = a) (friction = b) => body)` evaluates `body` with `gravity` bound to what is in the option `a`, or to
/// [`Absent`].
macro_rules! choose {
    (=> $body:expr) => {
        $body
    };
    (($name:ident = $option:expr) $($rest:tt)*) => {
        match $option {
            Some($name) => $crate::scene::choose!($($rest)*),
            None => {
                let $name = $crate::scene::Absent;
                $crate::scene::choose!($($rest)*)
            }
        }
    };
}
pub(crate) use choose;
