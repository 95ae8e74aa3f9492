//! The angle that a body has turned: by the cosine, and by sine and cosine.

use super::family::{Family, numbers};
use spinning_bodies::Result;
use spinning_bodies::frame::Attitude;

pub(super) const SMALL_TURN: Family = Family {
    name: "small-turn",
    paragraph: "2.2",
    quantity: "the angle between two attitudes that are almost the same",
    lost: "the arc cosine of almost 1",
    printed: r"2\arccos q_0",
    cure: r"2\arctan\tfrac{\lVert\mathbf q\rVert}{\lvert q_0\rvert}",
    textbook: |inputs| {
        let q = turned(inputs)?.quaternion();
        Ok(vec![2.0 * q.w.abs().acos()])
    },
    ours: |inputs| Ok(vec![Attitude::identity().angle_to(&turned(inputs)?)]),
};

/// The attitude in the direction of this quaternion.
fn turned(inputs: &[f64]) -> Result<Attitude> {
    let [w, x, y, z] = numbers(inputs)?;
    let length = (w * w + x * x + y * y + z * z).sqrt();
    Attitude::from_quaternion(w / length, x / length, y / length, z / length)
}
