//! The columns of a top beside its usual ones.

use super::effects::{State, Top};
use super::equations::Turning;
use super::ledger::{Conserved, up};
use crate::scene::prelude::*;

/// The further columns of a top's states. The force at the pivot is a column of every body with mass, with gravity or without.
pub(super) fn columns(top: &Top) -> Columns<State> {
    let body = top.body;
    // Moments, lever and centre of mass are along the principal axes, the states along the body's own axes.
    let momentum = move |state: &State| {
        let l = (body.axis_moments()).angular_momentum(body.inward(state.omega));
        body.attitude_inward(state.attitude).to_space(l)
    };
    let columns = Columns::default()
        .angles(|state: &State| state.attitude)
        .and(columns! { |state: &State|
            "omega", "rad/s", "size of the angular velocity" => state.omega.norm();
        })
        .vector(
            ["omega_x", "omega_y", "omega_z"],
            ["rad/s", "angular velocity, along the axes of space"],
            |state| state.attitude.to_space(state.omega),
        )
        .angular_momentum(|state| state.attitude, momentum)
        .and(columns! { |state: &State|
            "kinetic", "J", "kinetic energy" => body.axis_moments().energy(body.inward(state.omega));
        });
    let Ok(conserved) = Conserved::of(top) else {
        return columns;
    };
    let lever = BodyVector::from(top.lever());
    let first = conserved.start.energy;
    let up = move |state: &State| up(&body.attitude_inward(state.attitude));
    let columns = columns.and(columns! { |state: &State|
        "potential", "J", "energy of the weight above the pivot" => lever.dot(&up(state));
        "lost", "J", "energy that resistance has taken since time 0" => first - state.energy;
    });
    if body.mass == 0.0 {
        return columns;
    }
    let center = BodyVector::from(body.center);
    let columns = columns.and(columns! { |state: &State|
        "height", "m", "centre of mass above the pivot" => center.dot(&up(state));
    });
    let Ok(turning) = Turning::new(top, conserved.energy_scale) else {
        return columns;
    };
    let (mass, g) = (body.mass, top.g());
    let force = move |state: &State| {
        let attitude = body.attitude_inward(state.attitude);
        let omega = body.inward(state.omega);
        let turned = turning.acceleration(&attitude, omega);
        let acceleration = turned.cross(&center) + omega.cross(&omega.cross(&center));
        let weightless = attitude.to_space(mass * acceleration);
        weightless + SpaceVector::new(0.0, 0.0, mass * g)
    };
    let size = force.clone();
    let pushes = "force of the pivot on the body, along the axes of space";
    columns
        .vector(["force_x", "force_y", "force_z"], ["N", pushes], force)
        .and(columns! { |state: &State|
            "force", "N", "size of the force of the pivot" => size(state).components().norm();
        })
}
