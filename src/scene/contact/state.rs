//! The state of a body on a table, with what the contact does there.

use nalgebra::Vector3;

use super::run::{Place, Support};
use crate::frame::{Attitude, BodyVector, SpaceVector};
use crate::scene::Tabulated;
use crate::tippe_top::equations::{Ground, Pose, attitude};

/// A body on a table at one time. The third axis of space points up, the table is the plane z = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// From the body's axes to those of space.
    pub attitude: Attitude,
    /// Angular velocity, rad/s.
    pub omega: BodyVector,
    /// Position of the centre of mass, m; at the start above the origin.
    pub position: SpaceVector,
    /// Velocity of the centre of mass, m/s.
    pub velocity: SpaceVector,
    /// Sliding, rolling or in the air.
    pub support: Support,
    /// Velocity of the point in contact, m/s; zero in the air.
    pub slip: SpaceVector,
    /// Normal reaction of the table, N; never negative.
    pub reaction: f64,
    /// Kinetic energy and M g times the height of C, J.
    pub energy: f64,
    /// What friction, resistance and landings have taken since the start, J.
    pub dissipated: f64,
    /// −⟨L, CO⟩ with O the lowest point, J s m: Jellett's integral where there is one.
    pub jellett: f64,
    /// Vertical component of the angular momentum about C, J s.
    pub vertical_angular_momentum: f64,
}

impl State {
    pub(super) fn of(ground: &dyn Ground, place: &Place) -> Self {
        let y = &place.numbers;
        let pose = Pose::of(y);
        let body = ground.body();
        let velocity = Vector3::new(y[7], y[8], place.climb);
        let (slip, reaction) = match place.support {
            Support::Airborne => (Vector3::zeros(), 0.0),
            Support::Rolling => {
                let contact = ground.rolls(&pose);
                (contact.slip, contact.reaction)
            }
            Support::Sliding => {
                let contact = ground.slides(&pose);
                (contact.slip, contact.reaction)
            }
        };
        let omega = BodyVector::from_components(pose.omega);
        let up = BodyVector::from_components(pose.up);
        let l = body.inertia().angular_momentum(omega);
        let potential = body.mass() * ground.gravity() * place.height;
        Self {
            attitude: attitude(&pose),
            omega,
            position: SpaceVector::new(y[9], y[10], place.height),
            velocity: SpaceVector::from_components(velocity),
            support: place.support,
            slip: SpaceVector::from_components(pose.turn * slip),
            reaction: reaction.max(0.0),
            energy: body.kinetic_energy(&pose.omega, &velocity) + potential,
            dissipated: y[11],
            jellett: body.jellett(up, omega),
            vertical_angular_momentum: l.dot(&up),
        }
    }

    /// The upward vertical in the body's axes.
    pub fn up(&self) -> BodyVector {
        self.attitude.to_body(SpaceVector::new(0.0, 0.0, 1.0))
    }

    /// Angle between the body's third axis and the vertical, rad, 0…π; accurate at both ends.
    pub fn tilt(&self) -> f64 {
        let up = self.up();
        up.x().hypot(up.y()).atan2(up.z())
    }

    /// Angular velocity about the vertical, rad/s.
    pub fn spin(&self) -> f64 {
        self.omega.dot(&self.up())
    }
}

/// When `quantity` first rises through `level` (s), by linear interpolation between rows in ascending order of time, if it does.
pub fn passage(rows: &[(f64, State)], quantity: impl Fn(&State) -> f64, level: f64) -> Option<f64> {
    rows.windows(2).find_map(|pair| {
        let [(t0, a), (t1, b)] = pair else {
            return None;
        };
        let (low, high) = (quantity(a), quantity(b));
        (low < level && high >= level).then(|| t0 + (t1 - t0) * (level - low) / (high - low))
    })
}

impl Tabulated for State {
    const COLUMNS: &'static [&'static str] = &[
        "qw",
        "qx",
        "qy",
        "qz",
        "omega1",
        "omega2",
        "omega3",
        "x",
        "y",
        "z",
        "vx",
        "vy",
        "vz",
        "slip",
        "reaction",
        "energy",
        "dissipated",
    ];

    fn row(&self) -> Vec<f64> {
        let q = self.attitude.quaternion();
        let (omega, x, v) = (self.omega, self.position, self.velocity);
        vec![
            q.w,
            q.i,
            q.j,
            q.k,
            omega.x(),
            omega.y(),
            omega.z(),
            x.x(),
            x.y(),
            x.z(),
            v.x(),
            v.y(),
            v.z(),
            self.slip.norm(),
            self.reaction,
            self.energy,
            self.dissipated,
        ]
    }
}
