//! What the feature `serde` writes is read again, to the bit; what is no body, attitude or top is refused.

use proptest::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use spinning_bodies::euler_top::EulerTop;
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::inertia::{InertiaMatrix, MassProperties, PrincipalMoments, shapes};
use spinning_bodies::scene::top::{AirDrag, Body, Gravity, Start, Top};
use spinning_bodies::scene::{Request, Scene};

fn returns<T: Serialize + DeserializeOwned + PartialEq + core::fmt::Debug>(value: T) {
    let written = serde_json::to_value(&value).expect("anything can be written");
    let read: T = serde_json::from_value(written.clone()).expect("what was written can be read");
    assert_eq!(read, value, "{written}");
}

fn three(size: f64) -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-size..size)
}

proptest! {
    #[test]
    fn what_is_written_is_read_to_the_bit(
        sizes in prop::array::uniform3(1e-6..1.0_f64),
        place in three(2.0),
        axis in three(1.0),
        omega in three(9.0),
    ) {
        let attitude = Attitude::about_axis(axis.into(), 2.0)?;
        let box_ = shapes::cuboid(0.7, sizes)?.turned(&attitude).moved(place.into())?;
        // Two particles are a rod: one of its moments is nothing but rounding.
        let rod = [axis, place].map(|end| MassProperties::particle(0.3, end.into()));
        let [one, other] = rod;
        let rod = MassProperties::compose(&[one?, other?])?;
        for body in [box_, rod] {
            returns(body);
            returns(body.inertia().principal_axes().principal_moments());
        }
        returns(attitude);

        let moments = box_.inertia().principal_axes().moments;
        returns(EulerTop::from_omega(moments, omega.into(), attitude)?.at(3.0)?);

        let held = Body::held_at(&box_, BodyVector::zero())?;
        let top = Top::new(held, Start::with_omega(omega.into(), attitude))?;
        let top = top.with(Gravity::new(9.81)?)?.with(AirDrag::new(1e-3)?)?;
        returns(top);
        returns(top.simulate(&Request::at([0.01])?)?.rows[0].1);
    }
}

fn refused<T: DeserializeOwned + core::fmt::Debug>(written: Value, word: &str) {
    let told = serde_json::from_value::<T>(written)
        .unwrap_err()
        .to_string();
    assert!(told.contains(word), "{told}");
}

#[test]
fn what_is_none_is_refused_by_name() {
    refused::<PrincipalMoments>(json!([1.0, 1.0, 3.0]), "I1 + I2");
    refused::<Attitude>(json!([0.0, 0.0, 0.0, 0.0]), "quaternion");
    let lopsided = json!([[2.0, 1.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]);
    refused::<InertiaMatrix>(lopsided, "symmetric");
    let inertia = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
    let body = |mass: f64| json!({ "mass": mass, "center": [0.0, 0.0, 0.0], "inertia": inertia });
    refused::<MassProperties>(body(0.0), "mass");
    assert!(serde_json::from_value::<MassProperties>(body(1.0)).is_ok());
    refused::<AirDrag>(json!(-1.0), "air drag");

    let top = |moment: f64, effect: &str| {
        json!({
            "body": { "mass": 1.0, "moments": [moment, 2.0, 3.0], "center": [0.0, 0.0, 1.0], "own": null },
            "start": { "attitude": [1.0, 0.0, 0.0, 0.0], "spin": { "omega": [0.0, 0.0, 1.0] } },
            effect: 1e-3,
        })
    };
    assert!(serde_json::from_value::<Top>(top(2.0, "tip_friction")).is_ok());
    refused::<Top>(top(1.5, "tip_friction"), "tip friction");
    refused::<Top>(top(0.5, "gravity"), "I1 + I2");
    refused::<Top>(top(2.0, "gravitty"), "gravitty");
}

#[test]
fn a_quaternion_of_another_norm_is_an_attitude() {
    let read: Attitude = serde_json::from_value(json!([0.0, 0.0, 3.0, 0.0])).unwrap();
    assert_eq!(read, Attitude::from_quaternion(0.0, 0.0, 1.0, 0.0).unwrap());
}
