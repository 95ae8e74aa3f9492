//! The tools with which the tables of a kind are declared and its scene is made.

pub(super) use super::keys::Bound::{From, NotNegative, Positive, UpTo};
pub(super) use super::keys::Key;
pub(super) use super::look::{Outline, about, posed, rolling, still};
pub(super) use super::reader::{Place, Reader, Section, Table, Value};
pub(super) use super::values::{Word, key, keys, section, tables};
pub(super) use crate::frame::{Attitude, BodyVector};
pub(super) use crate::scene::effects::*;
pub(super) use crate::scene::path::MOST_TURNED;
pub(super) use crate::scene::sight::Told;
pub(super) use crate::scene::{AnyScene, Around, Sight, Solid};

use crate::scene::Scene;

/// An effect that may be present, and its keys.
pub(super) type Acting = (&'static str, Option<Effect>);

/// The effects with these keys.
macro_rules! acting {
    ($given:ident: $($effect:ident),*) => {
        vec![$((concat!("effects.", stringify!($effect)), $given.$effect.map(Effect::from))),*]
    };
}
pub(super) use acting;

/// The scene with those effects that are present.
pub(super) fn with<S>(
    file: &Reader<'_>,
    scene: S,
    acting: Vec<Acting>,
    add: fn(S, Effect) -> crate::Result<S>,
) -> Option<S> {
    let mut acting = acting.into_iter();
    acting.try_fold(scene, |scene, (keys, effect)| match effect {
        Some(effect) => file.right(keys, add(scene, effect)),
        None => Some(scene),
    })
}

/// The scene of a file, and how it is drawn.
pub(super) fn drawn<S: Scene<State: Send + 'static> + 'static>(
    scene: S,
    look: impl Fn(&Told<'_>) -> Sight + Send + Sync + 'static,
) -> Option<AnyScene> {
    let mut scene = AnyScene::scene(Box::new(scene));
    scene.look = Some(Box::new(look));
    Some(scene)
}
