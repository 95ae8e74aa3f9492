//! The constants of the motion from its start or its integrals, in 106 bits (tutorial 7.2).

use nalgebra::Quaternion;

use super::evaluation::{Body, Complex, Constants, Parameter, Pull};
use super::roots::{Distances, Integrals, Nutation, Place, Roots};
use crate::elliptic::lanes::Course;
use crate::elliptic::modulus::{Descent, Squares};
use crate::elliptic::theta::{Elevation, Turning};
use crate::error::{Result, positive, refused, within};
use crate::frame::{Attitude, BodyVector};
use crate::precise::{
    DoubleDouble, Extended, Number, exponent_of, power_of_two_below, shifted, sum_of_products,
};

/// Above this, in rad/s, sums of rates could overflow.
pub(super) const FASTEST: f64 = 1e307;

/// The kind of motion, the roots and the constants, decided once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Prepared {
    pub(super) kind: Nutation,
    pub(super) roots: Roots,
    /// None where the axis stays: upright, hanging, or at rest without gravity.
    pub(super) motion: Option<Constants>,
}

/// Ω and attitude at time 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Start {
    pub(super) omega: BodyVector,
    pub(super) attitude: Attitude,
}

/// A start and a weight before they are rounded to doubles: next to a separatrix the motion would amplify the rounding.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exact {
    /// Mgl, N m.
    pub weight_moment: Extended,
    /// Ω along the body's axes, rad/s.
    pub omega: [Extended; 3],
    /// The quaternion w, x, y, z, of any norm.
    pub quaternion: [Extended; 4],
}

impl Exact {
    pub(super) fn of(body: Body, Start { omega, attitude }: Start) -> Self {
        let q = attitude.quaternion();
        Self {
            weight_moment: Extended::from_double(body.weight_moment),
            omega: [omega.x(), omega.y(), omega.z()].map(Extended::from_double),
            quaternion: [q.w, q.i, q.j, q.k].map(Extended::from_double),
        }
    }
}

/// Whether the fourth power of every number that matters stays far above underflow.
pub(super) fn moderate(body: Body, Start { omega, attitude }: Start) -> bool {
    let q = attitude.quaternion();
    let near = |x: f64, unit: f64| x == 0.0 || x.abs() > 1e-60 * unit;
    let swing = (body.weight_moment.abs() / body.transverse).sqrt();
    let fastest = omega.components().amax().max(swing);
    let still = omega.components().iter().all(|x| near(*x, fastest));
    // A quotient that underflows stands for gravity all the same.
    let gone = swing == 0.0 && body.weight_moment != 0.0;
    still && !gone && near(swing, fastest) && [q.w, q.i, q.j, q.k].iter().all(|x| near(*x, 1.0))
}

/// The kind, roots and constants of the motion, computed in a unit of time in which the rates are moderate.
pub(super) fn prepare<N: Number>(body: Body, start: Start, exact: &Exact) -> Result<Prepared> {
    let pull = Pull::of(body.weight_moment);
    let q = with_gravity_down(pull, start.attitude.quaternion().into_inner());
    let over_transverse = |x: Extended| x.quotient(Extended::from_double(body.transverse));
    let gravity = over_transverse(exact.weight_moment.magnitude());
    let fastest = start
        .omega
        .components()
        .amax()
        .max(gravity.square_root().narrow().value());
    // √(Mgl/I₁) bounds what falling adds to Ω.
    within("the greater of |Ω| and √(Mgl/I1)", fastest, 0.0, FASTEST)?;
    if fastest == 0.0 {
        let upper = 2.0 * (q.w * q.w + q.k * q.k);
        let lower = 2.0 * (q.i * q.i + q.j * q.j);
        return Ok(Prepared {
            kind: Nutation::Spinning,
            roots: Roots::new([lower; 2], [upper; 2], f64::INFINITY),
            motion: None,
        });
    }
    let unit = power_of_two_below(fastest);
    let exponent = exponent_of(unit);
    let gravity: N = gravity.raised(-2 * exponent).as_number();
    let [o1, o2, o3] = exact
        .omega
        .map(|rate| rate.raised(-exponent).as_number::<N>());
    let [w, x, y, z] = match (pull, exact.quaternion) {
        (Pull::Down, q) => q,
        (Pull::Up, [w, x, y, z]) => [-x, w, -z, y],
    }
    .map(Extended::as_number::<N>);
    let upper = w.square().add_alike(z.square());
    let lower = x.square().add_alike(y.square());
    let norm = upper.add_alike(lower);
    let twice = |part: N| part.quotient(norm).times(2.0);
    let (z1, z2) = (twice(x * z - w * y), twice(y * z + w * x));
    let spin = over_transverse(Extended::from_double(body.axial)).as_number::<N>() * o3;
    let place = Place {
        below_top: twice(lower),
        above_bottom: twice(upper),
        swing: o1.square().add_alike(o2.square()),
        rise: o2 * z1 - o1 * z2,
        drift: o1 * z1 + o2 * z2,
    };
    let still = if !place.swing.is_zero() {
        None
    } else if gravity.is_zero() {
        Some(Nutation::Spinning)
    } else if upper.is_zero() {
        Some(Nutation::Hanging)
    } else if lower.is_zero() {
        Some(Nutation::Sleeping {
            stable: !gravity.times(4.0).exceeds(spin.square()),
        })
    } else {
        None
    };
    let integrals = Integrals::of(gravity, spin, &place);
    let (distances, drifts) = integrals.solve_from(&place);
    let top = Top {
        pull,
        exponent,
        integrals,
        distances,
        axial_rate: o3,
        rise: place.rise,
    };
    top.prepared(still, drifts, (q, start.omega / unit))
}

/// The same from L₃, L_vert, and twice the energy above that of the same spin with C right above the pivot and right below; with the start at the lower
/// turning point of C and φ = ψ = 0. `None` if no motion has these integrals.
pub(super) fn prepare_from_integrals(
    body: Body,
    [l3, l_vert]: [f64; 2],
    [above_top, above_bottom]: [Extended; 2],
) -> Result<Option<(Start, Prepared)>> {
    let number = Extended::from_double;
    let pull = Pull::of(body.weight_moment);
    // Seen upside down, the vertical has the opposite sign.
    let side = match pull {
        Pull::Down => 1.0,
        Pull::Up => -1.0,
    };
    let over_transverse = |x: Extended| x.quotient(number(body.transverse));
    let sum = |l3: f64| sum_of_products(&[[side, l_vert], [1.0, l3]]);
    let weight = number(body.weight_moment.abs());
    let squares = [weight, above_top, above_bottom].map(over_transverse);
    let rates = [number(l3), sum(-l3), sum(l3)].map(over_transverse);
    // Zero for a needle.
    let axial_rate = number(l3).quotient(number(body.axial));
    let [gravity, _, above_bottom] = squares;
    if above_bottom.leading() < 0.0 {
        return Ok(None);
    }
    let fastest = axial_rate
        .magnitude()
        .greater(above_bottom.greater(gravity).square_root());
    let value = fastest.value();
    within("the greatest of |Ω| and √(Mgl/I1)", value, 0.0, FASTEST)?;
    // A unit of time in which the rates are moderate.
    let exponent = fastest.exponent;
    let [gravity, above_top, above_bottom] = squares.map(|x| x.raised(-2 * exponent));
    let [spin, difference, sum] = rates.map(|x| x.raised(-exponent));
    let axial_rate = axial_rate.raised(-exponent);
    let integrals = Integrals {
        gravity,
        spin,
        difference,
        sum,
        above_top,
        above_bottom,
    };
    let still_without_gravity = gravity.is_zero() && above_top.is_zero();
    if still_without_gravity && spin.is_zero() {
        let condition = "without gravity and spin the energy must be positive: a body at rest may have any tilt";
        return refused(condition, 0.0);
    }
    let Some(distances) = integrals.solve() else {
        return Ok(None);
    };
    let drifts = integrals.drifts(&distances);
    let ([top1, _], [bottom1, _]) = (distances.top, distances.bottom);
    // Ω₁² + Ω₂² at the lower turning point: (L_vert − L₃h)²/(I₁ sin θ)².
    let swing = if top1.is_zero() {
        above_top
    } else if bottom1.is_zero() {
        above_bottom
    } else {
        drifts[0].square().quotient(top1 * bottom1)
    };
    // Upright with less than the energy of the upright top.
    if swing.leading() < 0.0 {
        return Ok(None);
    }
    // Upside down, the vertical lies on the other side of the axis.
    let across = swing.square_root().signed(drifts[0].leading()).signed(side);
    let halves = [bottom1, top1].map(|x| x.times(0.5).square_root().narrow().value());
    let omega = [Extended::zero(), across, axial_rate];
    let scaled = omega.map(|x| x.narrow().value());
    let [cosine, sine] = match pull {
        Pull::Down => halves,
        Pull::Up => [halves[1], halves[0]],
    };
    let start = Start {
        omega: BodyVector::from_components(scaled.map(|x| shifted(x, exponent)).into()),
        attitude: Attitude::from_quaternion(cosine, sine, 0.0, 0.0)?,
    };
    let still = if still_without_gravity {
        Some(Nutation::Spinning)
    } else if sum.is_zero() && above_bottom.is_zero() {
        Some(Nutation::Hanging)
    } else if difference.is_zero() && above_top.is_zero() && top1.is_zero() {
        Some(Nutation::Sleeping { stable: true })
    } else {
        None
    };
    let top = Top {
        pull,
        exponent,
        integrals,
        distances,
        axial_rate,
        rise: Extended::zero(),
    };
    let q = with_gravity_down(pull, start.attitude.quaternion().into_inner());
    let scaled = BodyVector::from_components(scaled.into());
    Ok(Some((start, top.prepared(still, drifts, (q, scaled))?)))
}

/// The attitude, seen upside down if gravity pulls upwards: then it pulls downwards there.
fn with_gravity_down(pull: Pull, q: Quaternion<f64>) -> Quaternion<f64> {
    match pull {
        Pull::Down => q,
        Pull::Up => Quaternion::new(-q.i, q.w, -q.k, q.j),
    }
}

/// A top whose roots are known, with 2^−`exponent` s as the unit of time.
struct Top<N> {
    pull: Pull,
    exponent: i32,
    integrals: Integrals<N>,
    distances: Distances<N>,
    axial_rate: N,
    rise: N,
}

impl<N: Number> Top<N> {
    /// The kind, roots and constants, from the drifts at the turning points and from attitude (gravity downwards) and Ω at time 0.
    fn prepared(
        &self,
        still: Option<Nutation>,
        drifts: [N; 2],
        (q, omega): (Quaternion<f64>, BodyVector),
    ) -> Result<Prepared> {
        let motion = match still {
            Some(_) => None,
            None => Some(self.constants(q, omega)?),
        };
        Ok(Prepared {
            kind: still.unwrap_or_else(|| self.integrals.kind(drifts, &self.distances)),
            roots: Roots::of(&self.distances, self.integrals.gravity),
            motion,
        })
    }

    /// The constants in seconds, from attitude (gravity downwards) and Ω at time 0.
    fn constants(&self, q: Quaternion<f64>, omega: BodyVector) -> Result<Constants> {
        let mut constants = self.without_factors();
        constants.fit(q, omega)?;
        let rates = constants.rates.iter_mut();
        for rate in rates.chain([&mut constants.course.rate]) {
            *rate = DoubleDouble::from_parts(*rate, self.exponent);
        }
        positive("the rate of nutation", constants.course.rate.value())?;
        constants.pull = self.pull;
        constants.reach = constants.course.reach(1.0, &constants.rates);
        Ok(constants)
    }

    /// The constants in this unit of time, the factors of α and β still to be fitted.
    fn without_factors(&self) -> Constants {
        let (d, two_g) = (&self.distances, self.integrals.gravity.times(2.0));
        let [beyond, from_bottom, whole, rest] = d.third;
        // 4λ² = 2g (h₃ − h₁).
        let m = (two_g * d.band).quotient(whole);
        let mc = rest.quotient(whole);
        let lambda = whole.square_root().times(0.5);
        let descent = Descent::new(m, mc);
        let [top1, top2] = d.top;
        let [bottom1, bottom2] = d.bottom;
        let lower = Elevation::smaller(
            [bottom1, d.band, bottom2],
            [whole, two_g * bottom1, from_bottom],
        );
        let upper = Elevation::smaller(
            [top2 * whole, beyond * d.band, top1 * rest],
            [beyond, two_g * top2, rest],
        );
        let Integrals {
            difference, sum, ..
        } = self.integrals;
        let parameter = |x: N, elevation| Parameter {
            sense: if x.leading() > 0.0 { -1.0 } else { 1.0 },
            turning: Turning::new(descent.modulus.side(), &descent.landen, elevation),
        };
        let parameters = [parameter(sum, &lower), parameter(difference, &upper)];
        // The phases: α at u = K, where 1 + h is greatest, β at u = 0.
        let excess = self.axial_rate - self.integrals.spin;
        let halves = [
            (excess + sum.quotient(bottom2)).times(0.5),
            (difference.quotient(top1) - excess).times(0.5),
        ];
        let rates = core::array::from_fn(|k| {
            let Parameter { sense, turning } = parameters[k];
            let own = (lambda.narrow() * turning.slope).scaled(sense);
            halves[k].narrow() - own
        });
        Constants {
            pull: Pull::Down,
            course: Course {
                modulus: descent.modulus,
                start: self.start(&descent),
                rate: lambda.narrow(),
            },
            reach: -1.0,
            parameters,
            rates,
            factors: [Complex::new(1.0, 0.0); 2],
            top2: top2.narrow().value(),
            bottom1: bottom1.narrow().value(),
            band: d.band.narrow().value(),
        }
    }

    /// u at time 0: sn² = (h − h₁)/(h₂ − h₁), dn² = (h₃ − h)/(h₃ − h₁), rising if h rises.
    fn start(&self, descent: &Descent<N>) -> DoubleDouble {
        let d = &self.distances;
        if d.band.is_zero() {
            return DoubleDouble::from(0.0);
        }
        let [_, _, whole, rest] = d.third;
        let two_g = self.integrals.gravity.times(2.0);
        let u = descent.argument(&Squares {
            sn: d.to_lower,
            cn: d.to_upper,
            whole: d.band,
            dn: rest.add_alike(two_g * d.to_upper),
            dn_whole: whole,
        });
        u.signed(self.rise.leading())
    }
}
