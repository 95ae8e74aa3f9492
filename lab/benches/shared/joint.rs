//! The same top as a body on a joint in the physics engine rapier3d.

use rapier3d_f64::prelude::{
    AngVector, MassProperties, PhysicsWorld, Pose, RigidBodyBuilder, RigidBodyHandle, Rotation,
    SphericalJointBuilder, Vector,
};

/// A body of mass 1 whose pivot rests at the origin, z up.
pub struct Engine {
    world: PhysicsWorld,
    body: RigidBodyHandle,
}

impl Engine {
    /// I₁, I₃ about the pivot, Mgl; Ω along the body's axes and the attitude.
    pub fn new(
        [transverse, axial, weight]: [f64; 3],
        omega: [f64; 3],
        attitude: [f64; 4],
        step: f64,
    ) -> Self {
        // Far enough from the pivot to matter, near enough for a body: I₃ ≤ 2(I₁ − Ml²).
        let length = (0.4 * (transverse - 0.5 * axial).max(0.1 * transverse)).sqrt();
        let about_center = transverse - length * length;
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::new(0.0, 0.0, -weight / length);
        world.integration_parameters.dt = step;
        let [w, x, y, z] = attitude;
        let rotation = Rotation::from_xyzw(x, y, z, w).normalize();
        let center = Vector::new(0.0, 0.0, length);
        let [a, b, c] = omega;
        let omega = rotation * Vector::new(a, b, c);
        let body = RigidBodyBuilder::dynamic()
            .pose(Pose::from_parts(Vector::ZERO, rotation))
            .linvel(omega.cross(rotation * center))
            .angvel(omega)
            .additional_mass_properties(MassProperties::new(
                center,
                1.0,
                AngVector::new(about_center, about_center, axial),
            ))
            .can_sleep(false);
        let ground = world.insert_body(RigidBodyBuilder::fixed());
        let body = world.insert_body(body);
        world.insert_impulse_joint(ground, body, SphericalJointBuilder::new());
        Self { world, body }
    }

    /// The attitude so many steps later.
    pub fn after(&mut self, steps: u32) -> [f64; 4] {
        for _ in 0..steps {
            self.world.step();
        }
        let q = self.world.bodies[self.body].rotation();
        [q.w, q.x, q.y, q.z]
    }
}
