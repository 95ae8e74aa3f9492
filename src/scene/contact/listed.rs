//! From effects that a list names at run time to a scene of the type they make.

use super::{Coulomb, Gravity, Grip, NoSlip, Pull, Regularised, Resist, Resistance, State};
use super::{TableTop, Viscous};
use crate::error::Result;
use crate::scene::{Absent, Motion, Request, Scene, choose};

/// Any of the laws of friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Friction {
    /// Coulomb's law as it is, with sliding and rolling as phases.
    Coulomb(Coulomb),
    /// Coulomb's law smoothed over a small slip.
    Regularised(Regularised),
    /// In proportion to the slip.
    Viscous(Viscous),
    /// Pure rolling.
    NoSlip,
}

/// Simulates `scene` with those of the effects that are listed: one compiled scene a combination.
///
/// The combinations are compiled with the library, so a caller that is not optimised runs them at the library's speed.
///
/// # Errors
/// As for [`Scene::simulate`].
pub fn listed(
    scene: TableTop,
    gravity: Option<Gravity>,
    friction: Option<Friction>,
    resistance: Option<Resistance>,
    request: &Request,
) -> Result<Motion<State>> {
    choose!((gravity = gravity) (resistance = resistance) =>
        rubbing(scene.with_gravity(gravity).with_resistance(resistance), friction, request))
}

fn rubbing<G: Pull, R: Resist>(
    scene: TableTop<G, Absent, R>,
    friction: Option<Friction>,
    request: &Request,
) -> Result<Motion<State>> {
    fn run<G: Pull, F: Grip, R: Resist>(
        scene: &TableTop<G, F, R>,
        request: &Request,
    ) -> Result<Motion<State>> {
        scene.simulate(request)
    }
    match friction {
        None => run(&scene, request),
        Some(Friction::Coulomb(law)) => run(&scene.with_friction(law), request),
        Some(Friction::Regularised(law)) => run(&scene.with_friction(law), request),
        Some(Friction::Viscous(law)) => run(&scene.with_friction(law), request),
        Some(Friction::NoSlip) => run(&scene.with_friction(NoSlip), request),
    }
}
