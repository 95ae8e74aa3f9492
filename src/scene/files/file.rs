//! The tables of one kind of scene, and the effects in them; and the tools with which a kind is read.

use core::ops::Deref;

pub(super) use super::keys::Bound::{From, NotNegative, Positive, UpTo};
pub(super) use super::look::{Outline, about, free, posed, rolling, still};
pub(super) use super::reader::Reader;
pub(super) use super::values::{Word, keys, section};
pub(super) use crate::frame::{Attitude, BodyVector};
pub(super) use crate::scene::effects::*;
pub(super) use crate::scene::sight::Look;
pub(super) use crate::scene::{Around, Sight, Solid};

/// The optional effects of a scene, as an array of [`Effect`]s.
macro_rules! listed {
    ($($effect:expr),* $(,)?) => {
        [$($effect.map($crate::scene::effects::Effect::from)),*]
    };
}
pub(super) use listed;

/// The contents of a file: the three tables of its kind.
pub(super) struct File<'a, B, I, E> {
    pub reader: &'a Reader<'a>,
    pub body: B,
    pub initial: I,
    pub effects: E,
}

impl<'a, B, I, E> Deref for File<'a, B, I, E> {
    type Target = Reader<'a>;

    fn deref(&self) -> &Reader<'a> {
        self.reader
    }
}

/// A scene made from a file, with its picture.
pub(super) type Made<S> = Option<(S, Look)>;

/// The scene with those of the listed effects that are present.
pub(super) fn with<S>(
    file: &Reader<'_>,
    mut scene: S,
    listed: impl IntoIterator<Item = Option<Effect>>,
    add: impl Fn(S, Effect) -> crate::Result<S>,
) -> Option<S> {
    for effect in listed.into_iter().flatten() {
        let keys = match effect {
            Effect::TipFriction(_) => "effects.tip_friction, body.moments, body.center_of_mass",
            Effect::Tug(_) => "effects.tension, effects.tug_angle, effects.gravity, body.mass",
            _ => &format!("effects.{}", effect.name()),
        };
        scene = file.right(keys, add(scene, effect))?;
    }
    Some(scene)
}
