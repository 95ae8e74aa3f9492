//! The inertia matrix (tutorial 2): what mass is to a push, nine numbers are to a twist.
//!
//! A body resists being turned differently about different axes, so one number does not do. The map
//! from angular velocity Ω to angular momentum L is linear, hence a matrix; it is symmetric, hence it
//! has three orthogonal principal axes. All that dynamics can notice of a rigid body is its mass,
//! its centre of mass and this matrix. They are the three fields of [`MassProperties`].
//!
//! | want | have |
//! |---|---|
//! | the inertia of a ball, a box, a torus … | [`shapes`] |
//! | of one of the five Platonic solids | [`shapes::platonic`], [`PlatonicSolid`] |
//! | of any closed surface of triangles | [`mesh_mass_properties`] |
//! | of several bodies glued together | [`MassProperties::compose`] |
//! | principal moments and axes | [`InertiaMatrix::principal_axes`] |
//! | about another point | [`MassProperties::about`] |
//! | Routh's rule, and where it fails | [`routh`] |
//! | the ellipsoid that no dynamics can tell from the body | [`ellipsoid_of_inertia`] |
//!
//! ```
//! use spinning_bodies::inertia::shapes;
//!
//! // A box with semi-axes 2, 3, 5 and mass 1: 34/3, 29/3, 13/3 (2.1).
//! let box_235 = shapes::cuboid(1.0, [4.0, 6.0, 10.0])?;
//! let moments = box_235.inertia().principal_axes().moments;
//! assert!((moments[2] - 34.0 / 3.0).abs() < 1e-14);
//! # Ok::<(), spinning_bodies::Error>(())
//! ```

mod body;
mod ellipsoid;
mod matrix;
mod mesh;
mod moments;
mod motion;
mod platonic;
pub(crate) mod principal;
pub mod routh;
pub mod shapes;

pub use body::MassProperties;
pub use ellipsoid::ellipsoid_of_inertia;
pub use matrix::InertiaMatrix;
pub use mesh::{Mesh, icosphere, mesh_mass_properties, mesh_of_obj, mesh_of_stl};
pub use moments::PrincipalMoments;
pub(crate) use moments::possible;
pub use motion::{AngularMomentumSplit, EnergySplit, RigidMotion};
pub use platonic::PlatonicSolid;
pub use principal::{PrincipalAxes, principal_axes_of};
