//! From the start to the constants of the motion, in 106 bits (tutorial 7.2).

use nalgebra::Quaternion;

use super::evaluation::{Constants, Pull};
use super::kinds::{Nutation, Roots, kind};
use super::motion::{FASTEST, Motion};
use super::roots::{Cubic, Distances};
use super::turning::{Complex, Parameter};
use crate::double_double::{DoubleDouble, power_of_two_below};
use crate::elliptic::descent::{Descent, Squares};
use crate::elliptic::theta::{Elevation, Which};
use crate::error::{Result, finite, within};
use crate::extended::{Extended, Scalar, exponent_of, shifted};
use crate::frame::{Attitude, BodyVector};
use crate::words::{Arithmetic, Words};

/// What does not move.
#[derive(Debug, Clone, Copy)]
pub(super) struct Body {
    pub(super) transverse: f64,
    pub(super) axial: f64,
    pub(super) weight_moment: f64,
}

/// Whether the fourth power of every number that counts is far above underflow.
pub(super) fn moderate(body: Body, omega: BodyVector, attitude: &Attitude) -> bool {
    let q = attitude.quaternion();
    let near = |x: f64, unit: f64| x == 0.0 || x.abs() > 1e-60 * unit;
    let swing = (body.weight_moment.abs() / body.transverse).sqrt();
    let fastest = omega.components().amax().max(swing);
    let still = omega.components().iter().all(|x| near(*x, fastest));
    // A quotient that underflows is gravity still.
    let gone = swing == 0.0 && body.weight_moment != 0.0;
    still && !gone && near(swing, fastest) && [q.w, q.i, q.j, q.k].iter().all(|x| near(*x, 1.0))
}

/// The constants, everything in units of time in which rates are moderate.
pub(super) fn prepare<N: Scalar<Narrow = DoubleDouble>>(
    Body {
        transverse,
        axial,
        weight_moment,
    }: Body,
    omega: BodyVector,
    attitude: &Attitude,
) -> Result<(Nutation, Roots, Motion)> {
    // Gravity that pulls up is gravity that pulls down, seen upside down.
    let q = attitude.quaternion().into_inner();
    let (pull, q) = if weight_moment < 0.0 {
        (Pull::Up, Quaternion::new(-q.i, q.w, -q.k, q.j))
    } else {
        (Pull::Down, q)
    };
    let gravity =
        Extended::from_double(weight_moment.abs()).divide(Extended::from_double(transverse));
    let fastest = omega
        .components()
        .amax()
        .max(gravity.square_root().narrow().value());
    // What the fall adds to Ω counts like Ω.
    within("the greater of |Ω| and √(Mgl/I1)", fastest, 0.0, FASTEST)?;
    if fastest == 0.0 {
        let upper = 2.0 * (q.w * q.w + q.k * q.k);
        let lower = 2.0 * (q.i * q.i + q.j * q.j);
        let roots = Roots::new([lower; 2], [upper; 2], f64::INFINITY);
        return Ok((Nutation::Spinning, roots, Motion::Still));
    }
    let unit = power_of_two_below(fastest);
    let exponent = exponent_of(unit);
    let mut scaled_gravity = gravity;
    scaled_gravity.exponent -= 2 * exponent;
    let gravity = N::from_extended(scaled_gravity);
    let [o1, o2, o3] = [omega.x() / unit, omega.y() / unit, omega.z() / unit].map(N::from_double);
    let [w, x, y, z] = [q.w, q.i, q.j, q.k].map(N::from_double);
    let (upper, lower) = (w.square().add(z.square()), x.square().add(y.square()));
    let norm = upper.add(lower);
    let above_bottom = upper.divide(norm).times(2.0);
    let below_top = lower.divide(norm).times(2.0);
    let z1 = x
        .multiply(z)
        .subtract(w.multiply(y))
        .divide(norm)
        .times(2.0);
    let z2 = y
        .multiply(z)
        .subtract(w.multiply(x).negated())
        .divide(norm)
        .times(2.0);
    let swing = o1.square().add(o2.square());
    let drift = o1.multiply(z1).subtract(o2.multiply(z2).negated());
    let rise = o2.multiply(z1).subtract(o1.multiply(z2));
    let ratio = Extended::from_double(axial).divide(Extended::from_double(transverse));
    let spin = N::from_extended(ratio).multiply(o3);
    let still = if swing.is_zero() {
        let threshold = gravity.times(4.0);
        if gravity.is_zero() {
            Some(Nutation::Spinning)
        } else if above_bottom.is_zero() {
            Some(Nutation::Hanging)
        } else if below_top.is_zero() {
            Some(Nutation::Sleeping {
                stable: !threshold.exceeds(spin.square()),
            })
        } else {
            None
        }
    } else {
        None
    };
    let cubic = Cubic {
        gravity,
        below_top,
        above_bottom,
        swing,
        rise,
        drift,
        spin,
    };
    let d = cubic.solve();
    let roots = Roots::of(&d, gravity);
    if let Some(kind) = still {
        return Ok((kind, roots, Motion::Still));
    }
    let mut constants = constants(&d, spin, o3, &cubic)?;
    let scale = |x: &mut DoubleDouble| {
        *x = DoubleDouble::sum(shifted(x.high(), exponent), shifted(x.low(), exponent));
    };
    scale(&mut constants.rate);
    constants.rates.iter_mut().for_each(scale);
    finite("the rate of nutation", constants.rate.value())?;
    constants.fit(q, omega)?;
    constants.pull = pull;
    Ok((kind(&cubic, &d), roots, Motion::Moving(constants)))
}

fn constants<N: Scalar<Narrow = DoubleDouble>>(
    d: &Distances<N>,
    spin: N,
    axial_rate: N,
    cubic: &Cubic<N>,
) -> Result<Constants> {
    let two_g = cubic.gravity.times(2.0);
    let [beyond, from_bottom, whole, rest] = d.third;
    // 4λ² = 2g (h₃ − h₁).
    let m = two_g.multiply(d.band).divide(whole);
    let mc = rest.divide(whole);
    let lambda = whole.square_root().times(0.5);
    let descent = Descent::new(m, mc);
    let [top1, top2] = d.top;
    let [bottom1, bottom2] = d.bottom;
    let lower = Elevation::smaller(
        [bottom1, d.band],
        [whole, two_g.multiply(bottom1)],
        |which| match which {
            Which::Eta => bottom2,
            Which::Xi => from_bottom,
        },
    );
    let upper = Elevation::smaller(
        [top2.multiply(whole), beyond.multiply(d.band)],
        [beyond, two_g.multiply(top2)],
        |which| match which {
            Which::Eta => top1.multiply(rest),
            Which::Xi => rest,
        },
    );
    let sense = |x: N| if x.leading() > 0.0 { -1.0 } else { 1.0 };
    let senses = [sense(d.sum), sense(d.difference)];
    let parameters = [
        Parameter::new(&descent, &lower, senses[0]),
        Parameter::new(&descent, &upper, senses[1]),
    ];
    // The phases: α at u = K, where 1 + h is greatest, β at u = 0.
    let over = |x: N, y: N| if x.is_zero() { x } else { x.divide(y) };
    let excess = axial_rate.subtract(spin);
    let halves = [
        excess.subtract(over(d.sum, bottom2).negated()).times(0.5),
        over(d.difference, top1).subtract(excess).times(0.5),
    ];
    let turning = lambda.narrow();
    let rates = core::array::from_fn(|k| {
        let own = turning
            .multiply(parameters[k].slope)
            .scaled(parameters[k].sense);
        halves[k].narrow().subtract(own)
    });
    let start = start(d, cubic, &descent);
    let rate = lambda.narrow().two();
    Ok(Constants {
        pull: Pull::Down,
        modulus: descent.modulus,
        start,
        rate,
        parameters,
        rates,
        factors: [Complex::new(1.0, 0.0); 2],
        top2: top2.narrow().value(),
        bottom1: bottom1.narrow().value(),
        band: d.band.narrow().value(),
    })
}

/// u at time 0: sn² = (h − h₁)/(h₂ − h₁), dn² = (h₃ − h)/(h₃ − h₁), rising if h rises.
fn start<N: Scalar<Narrow = DoubleDouble>>(
    d: &Distances<N>,
    cubic: &Cubic<N>,
    descent: &Descent<N>,
) -> DoubleDouble {
    if d.band.is_zero() {
        return DoubleDouble::from(0.0);
    }
    let [_, _, whole, rest] = d.third;
    let two_g = cubic.gravity.times(2.0);
    let u = descent.argument(&Squares {
        sn: d.to_lower,
        cn: d.to_upper,
        whole: d.band,
        dn: rest.add(two_g.multiply(d.to_upper)),
        dn_whole: whole,
    });
    if cubic.rise.leading() < 0.0 {
        u.negated()
    } else {
        u
    }
}
