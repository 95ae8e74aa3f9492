//! What the files of Section 6 share.

use super::*;

pub const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];

/// 2E = 6, L² = 14, k² = 1/2, moments 1, 2, 3: Ω = (√2, 0, 2/√3).
pub fn example() -> EulerTop {
    tilted(MOMENTS, [2f64.sqrt(), 0.0, 2.0 / 3f64.sqrt()])
}

/// From Ω, body axes and space axes together at t = 0.
pub fn tilted(moments: [f64; 3], omega: [f64; 3]) -> EulerTop {
    EulerTop::from_omega(moments, vector(omega), Attitude::identity()).unwrap()
}

/// From L, body axes and space axes together at t = 0.
pub fn thrown(moments: [f64; 3], l: [f64; 3]) -> EulerTop {
    EulerTop::new(moments, vector(l), Attitude::identity()).unwrap()
}

/// The axes in the order of their moments.
pub fn ascending(moments: [f64; 3]) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| moments[*a].total_cmp(&moments[*b]));
    order
}

pub fn sorted(mut i: [f64; 3]) -> [f64; 3] {
    i.sort_by(f64::total_cmp);
    i
}

/// Poinsot's picture of the motion, as it is at the time t.
pub fn picture(top: &EulerTop, t: f64) -> Poinsot {
    Poinsot::new(top.moments(), at(top, t).angular_momentum).unwrap()
}

/// Jacobi's functions of the parameter m.
pub fn jacobi(m: f64, u: f64) -> Jacobi {
    let modulus = Modulus::new(Parameter::from_parameter(m).unwrap());
    modulus.jacobi(u).unwrap()
}

/// The axis whose component of Ω keeps its sign.
pub fn kept_axis(top: &EulerTop) -> usize {
    let order = ascending(top.moments());
    match top.regime() {
        Regime::AroundLargest => order[2],
        _ => order[0],
    }
}

pub fn at(top: &EulerTop, t: f64) -> State {
    top.at(t).unwrap()
}

pub fn omega(top: &EulerTop, t: f64) -> [f64; 3] {
    top.at(t).unwrap().omega.components().into()
}

/// Ω along the axes of space.
pub fn omega_in_space(top: &EulerTop, t: f64) -> SpaceVector {
    let state = at(top, t);
    state.attitude.to_space(state.omega)
}

/// Length of the difference between Ω and its expected components.
pub fn distance(actual: BodyVector, expected: [f64; 3]) -> f64 {
    (actual - vector(expected)).norm()
}

/// A step for [`derivative`], a power of two, a fourteenth to a seventh of the time in which the fastest rotation of this energy turns by
/// one radian; times that are multiples of it are exact.
pub fn step(top: &EulerTop) -> f64 {
    2f64.powf((0.14 / fastest(top)).log2().floor())
}

/// √(2E/I₁), the greatest |Ω| at this energy.
pub fn fastest(top: &EulerTop) -> f64 {
    let [least, ..] = sorted(top.moments());
    (2.0 * top.energy() / least).sqrt()
}

pub fn norm<const N: usize>(v: [f64; N]) -> f64 {
    v.iter().fold(0.0, |m: f64, x| m.hypot(*x))
}

pub fn difference<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
    std::array::from_fn(|k| a[k] - b[k])
}

pub fn in_space(v: SpaceVector) -> [f64; 3] {
    v.components().into()
}

/// Three rational moments, strictly ascending, that a body can have.
pub fn rational_moments(numbers: &mut Uniform) -> [R; 3] {
    let mut part = || rational(1 + (numbers.next() * 30.0) as i128, 8);
    // Second moments s₁ > s₂ > s₃, I₁ = s₂ + s₃ and so on.
    let (s3, d2, d1) = (part(), part(), part());
    let (s2, s1) = (s3 + d2, s3 + d2 + d1);
    [s2 + s3, s1 + s3, s1 + s2]
}

/// E doubled and L squared, exactly.
pub fn integrals(i: [R; 3], o: [R; 3]) -> (R, R) {
    let l = [0, 1, 2].map(|k| i[k] * o[k]);
    (dot(l, o), dot(l, l))
}

/// So many bodies of rational moments, strictly ascending, and their Ω.
pub fn rational_starts(seed: u64, count: usize) -> impl Iterator<Item = ([R; 3], [R; 3])> {
    let mut numbers = Uniform(seed);
    (0..count).map(move |_| {
        let moments = rational_moments(&mut numbers);
        (moments, [0; 3].map(|_| ration(&mut numbers)))
    })
}

/// So many random bodies, their Ω at the start, and their motions.
pub fn random_tops(seed: u64, n: usize) -> impl Iterator<Item = ([f64; 3], [f64; 3], EulerTop)> {
    let mut numbers = Uniform(seed);
    (0..n).map(move |_| {
        let (moments, omega) = random_start(&mut numbers);
        (moments, omega, tilted(moments, omega))
    })
}

/// Three moments of a random body, in any order, and a random Ω.
pub fn random_start(numbers: &mut Uniform) -> ([f64; 3], [f64; 3]) {
    let moments = random_moments(numbers);
    (moments, [0; 3].map(|_| 2.0 * numbers.signed()))
}

pub fn random_moments(numbers: &mut Uniform) -> [f64; 3] {
    let [a, b, c] = [0; 3].map(|_| 0.05 + numbers.next());
    [b + c, c + a, a + b]
}
