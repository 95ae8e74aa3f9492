//! What the files of Section 7 share. The unit top has I₁ = Mgl = 1.

use super::*;

/// The axial moment of the unit top: with it L₃ = Ω₃/2.
pub const AXIAL: f64 = 0.5;

/// The vertical.
pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// x₃ tilted by θ, x₁ horizontal: the vertical is (0, sin θ, cos θ) in the body.
pub fn tilted(theta: f64) -> Attitude {
    Attitude::about_axis(vector([1.0, 0.0, 0.0]), theta).unwrap()
}

/// The unit top from its Ω and attitude.
pub fn started(omega: [f64; 3], attitude: Attitude) -> LagrangeTop {
    LagrangeTop::new(1.0, AXIAL, 1.0, vector(omega), attitude).unwrap()
}

/// The unit top at tilt θ with rates θ', φ' and angular momentum L₃.
pub fn spun(theta: f64, tilting: f64, precessing: f64, l3: f64) -> LagrangeTop {
    started(
        [tilting, precessing * theta.sin(), l3 / AXIAL],
        tilted(theta),
    )
}

/// Upright with L₃ and a kick across the axis.
pub fn kicked(l3: f64, kick: f64) -> LagrangeTop {
    started([kick, 0.0, l3 / AXIAL], tilted(0.0))
}

/// The axis level, exactly: cos θ = 0.
pub fn level() -> Attitude {
    Attitude::from_quaternion(1.0, 1.0, 0.0, 0.0).unwrap()
}

/// The axis straight down, exactly: cos θ = −1.
pub fn hanging() -> Attitude {
    Attitude::from_quaternion(0.0, 1.0, 0.0, 0.0).unwrap()
}

/// The unit top at a turning point cos θ = h: θ' = 0 and φ' = (L_vert − L₃h)/(1 − h²).
pub fn turning(h: f64, l3: f64, vertical: f64) -> LagrangeTop {
    spun(h.acos(), 0.0, (vertical - l3 * h) / (1.0 - h * h), l3)
}

/// Released from rest at tilt θ with L₃: the cusps are exact, Ω has no part across the axis.
pub fn released(theta: f64, l3: f64) -> LagrangeTop {
    started([0.0, 0.0, l3 / AXIAL], tilted(theta))
}

/// L₃ = 2, L_vert = 1, E' = ½: cusps, roots 0, ½, 2. From the lowest point.
pub fn cusp() -> LagrangeTop {
    turning(0.0, 2.0, 1.0)
}

/// L₃ = 1, L_vert = 2, E' = 2: a wave with the same roots.
pub fn wave() -> LagrangeTop {
    turning(0.0, 1.0, 2.0)
}

/// L₃ = 3/2, L_vert = ½, E' = 13/24: loops, roots −½, ½, 5/3.
pub fn swirl() -> LagrangeTop {
    turning(-0.5, 1.5, 0.5)
}

pub fn at(top: &LagrangeTop, t: f64) -> State {
    top.at(t).unwrap()
}

/// The roots h₁ ≤ h₂ ≤ h₃ of f.
pub fn roots(top: &LagrangeTop) -> [f64; 3] {
    let roots = top.roots();
    [roots.h1, roots.h2, roots.h3]
}

/// h₂ − h₁, the band in which the height swings.
pub fn band(top: &LagrangeTop) -> f64 {
    let [h1, h2, _] = roots(top);
    h2 - h1
}

/// The axis x₃ in space.
pub fn axis(state: &State) -> [f64; 3] {
    let axis = vector([0.0, 0.0, 1.0]);
    state.attitude.to_space(axis).components().into()
}

/// Azimuth of the axis, −π…π.
pub fn azimuth(state: &State) -> f64 {
    let [x, y, _] = axis(state);
    y.atan2(x)
}

/// The azimuth gained from 0 to t, followed in steps that are less than half a turn.
pub fn gained_azimuth(top: &LagrangeTop, t: f64, steps: u32) -> f64 {
    let mut total = 0.0;
    let mut before = azimuth(&at(top, 0.0));
    for k in 1..=steps {
        let now = azimuth(&at(top, t * f64::from(k) / f64::from(steps)));
        total += wrapped(now - before);
        before = now;
    }
    total
}

/// L₃ and L_vert.
pub fn spins(top: &LagrangeTop) -> (f64, f64) {
    let axial = at(top, 0.0).angular_momentum.z();
    (axial, top.vertical_angular_momentum())
}

/// I₁ and Mgl, as squares: positive.
pub fn body(numbers: &mut Uniform) -> [R; 2] {
    [0; 2].map(|_| ration(numbers)).map(|x| x * x)
}

/// The rate φ' = (L_vert − L₃h)/(I₁(1 − h²)) of the unit top.
pub fn precession(top: &LagrangeTop, state: &State) -> f64 {
    let (l3, vertical) = spins(top);
    (vertical - l3 * state.height) / (state.one_less * state.one_more)
}

/// f(h) = 2I₁(E' − Mgl h)(1 − h²) − (L_vert − L₃h)², with I₁ and Mgl.
pub fn cubic([i1, weight]: [R; 2], energy: R, l3: R, vertical: R, h: R) -> R {
    TWO * i1 * (energy - weight * h) * (ONE - h * h) - (vertical - l3 * h) * (vertical - l3 * h)
}

/// f(h) of the unit top.
pub fn f(top: &LagrangeTop, h: f64) -> f64 {
    let (l3, vertical) = spins(top);
    let energy = top.energy() - l3 * l3 / (2.0 * AXIAL);
    2.0 * (energy - h) * (1.0 - h * h) - (vertical - l3 * h) * (vertical - l3 * h)
}

/// A rational unit vector: a quaternion of small whole numbers turns the third axis there.
pub fn unit_vector(numbers: &mut Uniform) -> [R; 3] {
    let mut whole = || (numbers.next() * 9.0) as i128 - 4;
    let mut quaternions = std::iter::repeat_with(|| [0; 4].map(|_| whole()));
    let [a, b, c, d] = quaternions.find(|q| *q != [0; 4]).unwrap();
    let n = a * a + b * b + c * c + d * d;
    [
        rational(2 * (b * d - a * c), n),
        rational(2 * (c * d + a * b), n),
        rational(a * a - b * b - c * c + d * d, n),
    ]
}

/// Whether the motion is of this kind.
pub fn is(top: &LagrangeTop, kind: Nutation) -> bool {
    top.kind() == kind
}
