//! Bodies, methods, distances.

use super::*;
use std::fmt::Debug;

/// The asymmetric body of Hairer and Vilmart (2006), and the start there.
pub const MOMENTS: [f64; 3] = [0.6, 0.8, 1.0];
pub const L: [f64; 3] = [1.8, 0.4, -0.9];

/// A symmetric top whose axis nods with loops, its lever along the axis.
pub const TOP: [f64; 3] = [1.0, 1.0, 0.6];
pub const LEVER: [f64; 3] = [0.0, 0.0, 1.5];

/// Neither special nor upright.
pub fn tilted() -> Attitude {
    Attitude::from_quaternion(0.8, 0.4, -0.3, 0.2).unwrap()
}

pub fn start() -> Phase {
    Phase::new(vector(L), &tilted())
}

pub fn free_methods() -> Vec<Box<dyn Follow>> {
    free_methods_of(MOMENTS)
}

fn boxed(method: Result<impl Follow + 'static>) -> Box<dyn Follow> {
    Box::new(method.unwrap())
}

pub fn free_methods_of(moments: [f64; 3]) -> Vec<Box<dyn Follow>> {
    let splittings = Order::ALL.map(|order| boxed(FreeSplitting::new(moments, order)));
    let discrete = VeselovOrder::ALL.map(|order| boxed(MoserVeselov::new(moments, order)));
    let others = [
        boxed(GroupMidpoint::new(moments)),
        boxed(MuntheKaas::new(moments, ())),
        boxed(GeneralMethod::new(moments, (), Method::Rk4)),
    ];
    let all = splittings.into_iter().chain(discrete);
    all.chain(others).collect()
}

/// Those of a free body, of a heavy top, and of a heavy body without symmetry.
pub fn all_methods() -> Vec<Box<dyn Follow>> {
    let mut all = free_methods();
    all.extend(heavy_methods_of(TOP, LEVER));
    all.extend(heavy_methods_of(MOMENTS, LEVER));
    all
}

/// Splittings first, of orders 2, 4 and 6.
pub fn heavy_methods_of(moments: [f64; 3], lever: [f64; 3]) -> Vec<Box<dyn Follow>> {
    let weight = Weight::new(lever).unwrap();
    let splitting = |order| boxed(HeavySplitting::new(moments, weight, order));
    let others = [
        boxed(MuntheKaas::new(moments, weight)),
        boxed(GeneralMethod::new(moments, weight, Method::Rk4)),
    ];
    let splittings = Order::ALL.map(splitting).into_iter();
    splittings.chain(others).collect()
}

/// One sample after steps no longer than these.
pub fn after(method: &dyn Follow, phase: &Phase, t: f64, step: f64) -> Phase {
    let course = method.follow(phase, &[t], Effort::Step(step * (1.0 + 1e-12)));
    course.unwrap().states[0]
}

/// The free body's phase in closed form.
pub fn free(moments: [f64; 3], phase: &Phase, t: f64) -> Phase {
    let attitude = phase.attitude().unwrap();
    let top = EulerTop::new(moments, phase.angular_momentum(), attitude).unwrap();
    let state = top.at(t).unwrap();
    Phase::new(state.angular_momentum, &state.attitude)
}

/// The angle between the attitudes, and |ΔL|/|L|.
pub fn distance(a: &Phase, b: &Phase) -> [f64; 2] {
    let angle = a.attitude().unwrap().angle_to(&b.attitude().unwrap());
    let gap = (a.angular_momentum() - b.angular_momentum()).norm();
    [angle, gap / b.angular_momentum().norm()]
}

/// Fails, with the numbers and what they are of, unless both are closer than this.
#[track_caller]
pub fn close_to(a: &Phase, b: &Phase, most: f64, of: impl Debug) {
    let [angle, momentum] = distance(a, b);
    let kept = angle < most && momentum < most;
    assert!(kept, "{of:?} {angle:e} {momentum:e}");
}
