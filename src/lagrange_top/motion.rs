//! The exact motion of Lagrange's top (tutorial 7.2): attitude and angular velocity at any time.

use nalgebra::Quaternion;

use super::roots::{Cubic, Distances};
use super::turning::{Complex, Parameter};
use crate::double_double::{DoubleDouble, power_of_two_below};
use crate::elliptic::landen::{Landen, right_angle};
use crate::elliptic::local::sine_cosine;
use crate::elliptic::theta::{Elevation, Which};
use crate::elliptic::{Modulus, Parameter as EllipticParameter, Side};
use crate::error::{Error, Result, finite, not_negative, positive};
use crate::extended::{Extended, Scalar, exponent_of, shifted};
use crate::frame::{Attitude, BodyVector};
use crate::words::{Arithmetic, Words};

/// The top at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Ω along the body's axes, rad/s.
    pub omega: BodyVector,
    /// How the body stands in space.
    pub attitude: Attitude,
    /// h = cos θ, the height of the axis.
    pub height: f64,
    /// 1 − h, without cancellation.
    pub one_less: f64,
    /// 1 + h, without cancellation.
    pub one_more: f64,
}

/// What kind of motion the axis makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Nutation {
    /// φ' keeps its sign (7.2, picture k).
    Waves,
    /// φ' vanishes at the upper turning point: released from rest, say (7.4, picture l).
    Cusps,
    /// φ' changes its sign in between (7.2, picture m).
    Loops,
    /// The tilt stays (7.3, picture n).
    PurePrecession,
    /// Upright (7.5).
    Sleeping {
        /// Whether it stays so when disturbed: L₃² ≥ 4I₁Mgl.
        stable: bool,
    },
    /// Falls from the upright position, or rises to it, in infinite time (7.5).
    Waking,
    /// Hanging straight down.
    Hanging,
    /// L₃ = 0: a spherical pendulum (7.6).
    SphericalPendulum,
    /// L₃ = L_vert = 0: a pendulum in one plane (7.6).
    PlanePendulum,
    /// No gravity and no swing: the body turns about its own axis.
    Spinning,
}

/// The roots of the cubic, h₁ ≤ h₂ ≤ 1 ≤ h₃, with their distances from ±1 (7.2). With gravity upwards, those of −h.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roots {
    /// h₁, the lower turning point of cos θ.
    pub h1: f64,
    /// h₂, the upper one.
    pub h2: f64,
    /// h₃; infinite without gravity.
    pub h3: f64,
    /// 1 − h₁ and 1 − h₂.
    pub one_less: [f64; 2],
    /// 1 + h₁ and 1 + h₂.
    pub one_more: [f64; 2],
    /// h₃ − 1; infinite without gravity.
    pub third_less_one: f64,
}

/// A symmetric body that turns about a fixed point of its axis under gravity, its motion prepared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LagrangeTop {
    transverse: f64,
    axial: f64,
    weight_moment: f64,
    omega: BodyVector,
    attitude: Attitude,
    kind: Nutation,
    roots: Roots,
    motion: Motion,
}

#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(
    clippy::large_enum_variant,
    reason = "a top is one value without allocation; most tops move"
)]
enum Motion {
    /// The axis stays: upright, hanging, or at rest without gravity.
    Still,
    Moving(Constants),
}

/// Which way gravity pulls along space z; up is solved as down, upside down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pull {
    Down,
    Up,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Constants {
    pull: Pull,
    modulus: Modulus,
    start: DoubleDouble,
    rate: DoubleDouble,
    /// α and β without their phases.
    parameters: [Parameter; 2],
    /// Their phases, radians a second.
    rates: [DoubleDouble; 2],
    /// Their constant factors.
    factors: [Complex; 2],
    /// 1 − h₂, 1 + h₁ and h₂ − h₁: what 1 − h and 1 + h are made of.
    top2: f64,
    bottom1: f64,
    band: f64,
}

impl LagrangeTop {
    /// The top with moments I₁ = I₂ = `transverse` about the pivot and I₃ = `axial`, kg m², and Mgl = `weight_moment`, N m,
    /// the centre of mass at +l on x₃; with this angular velocity (rad/s) and attitude at time 0. The space axis z points up.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`] for I₁, [`Error::Negative`] for I₃.
    pub fn new(
        transverse: f64,
        axial: f64,
        weight_moment: f64,
        omega: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        positive("the transverse moment", transverse)?;
        not_negative("the axial moment", axial)?;
        if axial * 0.5 > transverse * (1.0 + 4.0 * f64::EPSILON) {
            return Err(Error::TriangleInequality {
                smallest: transverse,
                middle: transverse,
                largest: axial,
            });
        }
        finite("the weight moment Mgl", weight_moment)?;
        for component in omega.components().iter() {
            finite("a component of the angular velocity", *component)?;
        }
        if omega.norm() > FASTEST {
            return Err(Error::OutOfRange {
                quantity: "the angular velocity",
                value: omega.norm(),
                least: 0.0,
                greatest: FASTEST,
            });
        }
        let body = Body {
            transverse,
            axial,
            weight_moment,
        };
        let (kind, roots, motion) = if moderate(body, omega, &attitude) {
            prepare::<DoubleDouble>(body, omega, &attitude)?
        } else {
            prepare::<Extended>(body, omega, &attitude)?
        };
        Ok(Self {
            transverse,
            axial,
            weight_moment,
            omega,
            attitude,
            kind,
            roots,
            motion,
        })
    }

    /// What kind of motion the axis makes, decided once.
    pub const fn kind(&self) -> Nutation {
        self.kind
    }

    /// L₃ = I₃Ω₃, kg m²/s: constant (7.2).
    pub fn axial_angular_momentum(&self) -> f64 {
        self.axial * self.omega.z()
    }

    /// L_vert, the component of L along the vertical, kg m²/s: constant (7.2).
    pub fn vertical_angular_momentum(&self) -> f64 {
        let l = BodyVector::new(
            self.transverse * self.omega.x(),
            self.transverse * self.omega.y(),
            self.axial * self.omega.z(),
        );
        self.attitude.to_space(l).z()
    }

    /// E = ½⟨Ω, L⟩ + Mgl cos θ, J: constant (7.2).
    pub fn energy(&self) -> f64 {
        let [x, y, z]: [f64; 3] = self.omega.components().into();
        let q = self.attitude.quaternion();
        let height = (q.w * q.w + q.k * q.k) - (q.i * q.i + q.j * q.j);
        0.5 * (self.transverse * (x * x + y * y) + self.axial * z * z) + self.weight_moment * height
    }

    /// The roots of the cubic.
    pub const fn roots(&self) -> Roots {
        self.roots
    }

    /// Everything at time t (s).
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::OutOfRange`] beyond 2⁵³ quarter periods.
    pub fn at(&self, t: f64) -> Result<State> {
        let t = finite("the time", t)?;
        match &self.motion {
            Motion::Still => {
                let half = DoubleDouble::product(self.omega.z(), t).scaled(0.5);
                let (sine, cosine) = turned(half, t)?;
                let turn = Quaternion::new(cosine, 0.0, 0.0, sine);
                let q = self.attitude.quaternion().into_inner() * turn;
                let upper = q.w * q.w + q.k * q.k;
                let lower = q.i * q.i + q.j * q.j;
                let (alpha, beta) = (upper / (upper + lower), lower / (upper + lower));
                Ok(State {
                    omega: BodyVector::new(0.0, 0.0, self.omega.z()),
                    attitude: Attitude::from_unit(q),
                    height: alpha - beta,
                    one_less: 2.0 * beta,
                    one_more: 2.0 * alpha,
                })
            }
            Motion::Moving(constants) => constants.at(t, self.omega.z()),
        }
    }

    /// The states at these times, one after another.
    pub fn states(
        &self,
        times: impl IntoIterator<Item = f64>,
    ) -> impl Iterator<Item = Result<State>> {
        times.into_iter().map(|t| self.at(t))
    }

    /// Period of the nutation, 2K/λ, s; infinite where the tilt stays or never returns.
    pub fn period(&self) -> f64 {
        match &self.motion {
            Motion::Still => f64::INFINITY,
            Motion::Moving(constants) => {
                2.0 * constants.modulus.quarter_period() / constants.rate.high().abs()
            }
        }
    }
}

impl LagrangeTop {
    /// By how much the axis goes round the vertical in one period of nutation, radians (7.2); none where there is no period.
    pub fn precession_per_nutation(&self) -> Option<f64> {
        match &self.motion {
            Motion::Moving(constants) if constants.modulus.quarter_period().is_finite() => {
                let [alpha, beta] = constants.turns_per_nutation();
                let precession = alpha.add(beta).value();
                Some(match constants.pull {
                    Pull::Down => precession,
                    Pull::Up => -precession,
                })
            }
            _ => None,
        }
    }

    /// Mean rate at which the axis goes round the vertical, rad/s.
    pub fn mean_precession_rate(&self) -> Option<f64> {
        Some(self.precession_per_nutation()? / self.period())
    }
}

impl Constants {
    /// By how much the arguments of α and β grow in one period of nutation.
    fn turns_per_nutation(&self) -> [DoubleDouble; 2] {
        let quarter = self.modulus.quarter_period_dd();
        let period = quarter.scaled(2.0).divide(self.rate);
        core::array::from_fn(|k| {
            let parameter = &self.parameters[k];
            let lag = match self.modulus.side() {
                Side::Circular => right_angle(),
                Side::Hyperbolic => parameter.lag,
            };
            let lag = lag.scaled(2.0 * parameter.sense);
            self.rates[k].multiply(period).subtract(lag)
        })
    }

    /// α and β at a place, with their derivatives by time.
    fn pair(&self, t: f64, u: DoubleDouble) -> Result<([f64; 3], [Complex; 4])> {
        let place = self.modulus.place(u);
        let triple = self.modulus.triple(&place);
        let root = self.modulus.root();
        let odd = (place.quarters as i64) & 1 != 0;
        let weight = match (self.modulus.side(), &place.local) {
            (Side::Hyperbolic, crate::elliptic::local::Local::Hyperbolic(crest)) => {
                if odd {
                    root * root * crest.wave.growth
                } else {
                    crest.wave.decay(1.0)
                }
            }
            _ => 1.0,
        };
        let pace = self.modulus.pace() * self.rate.high();
        let mut out = [Complex::new(0.0, 0.0); 4];
        for k in 0..2 {
            let parameter = &self.parameters[k];
            let quarters = place.quarters + k as f64;
            let phase = self.rates[k].multiply(DoubleDouble::from(t)).subtract(
                parameter
                    .lag
                    .multiply(DoubleDouble::from(quarters * parameter.sense)),
            );
            let (sine, cosine) = turned(phase, t)?;
            let factor = self.factors[k] * Complex::new(cosine, sine);
            let [value, slope] = parameter.at(&place, k == 1, root);
            let weight = if k == 1 { weight } else { 1.0 };
            let slope = slope * pace + value * Complex::new(0.0, self.rates[k].high());
            out[k] = factor * value * weight;
            out[k + 2] = factor * slope * weight;
        }
        Ok((triple, out))
    }

    fn at(&self, t: f64, axial_rate: f64) -> Result<State> {
        let u = self.rate.multiply(DoubleDouble::from(t)).add(self.start);
        let greatest = self.modulus.greatest_argument();
        if !(u.high().abs() <= greatest) {
            let limit = greatest / self.rate.high().abs();
            return Err(Error::OutOfRange {
                quantity: "the time",
                value: t,
                least: -limit,
                greatest: limit,
            });
        }
        let ([sn, cn, _], [alpha, beta, alpha_rate, beta_rate]) = self.pair(t, u)?;
        let size = alpha.norm_sqr() + beta.norm_sqr();
        let transverse = (alpha.conj() * beta_rate - beta * alpha_rate.conj()) * (2.0 / size);
        let scale = 1.0 / size.sqrt();
        let (a, b) = (alpha * scale, beta * scale);
        let (one_less, one_more) = (
            self.top2 + self.band * cn * cn,
            self.bottom1 + self.band * sn * sn,
        );
        let (a, b, one_less, one_more) = match self.pull {
            Pull::Down => (a, b, one_less, one_more),
            Pull::Up => (b.conj(), -a.conj(), one_more, one_less),
        };
        Ok(State {
            omega: BodyVector::new(transverse.re, transverse.im, axial_rate),
            attitude: Attitude::from_unit(Quaternion::new(a.re, b.re, b.im, a.im)),
            height: 0.5 * (one_more - one_less),
            one_less,
            one_more,
        })
    }
}

impl Roots {
    fn new(one_less: [f64; 2], one_more: [f64; 2], third_less_one: f64) -> Self {
        let root = |k: usize| 0.5 * (one_more[k] - one_less[k]);
        Self {
            h1: root(0),
            h2: root(1),
            h3: 1.0 + third_less_one,
            one_less,
            one_more,
            third_less_one,
        }
    }

    fn of<N: Scalar>(d: &Distances<N>, gravity: N) -> Self {
        let value = |x: N| x.narrow().value();
        let third = if gravity.is_zero() {
            f64::INFINITY
        } else {
            value(d.third[0].divide(gravity.times(2.0)))
        };
        Self::new(d.top.map(value), d.bottom.map(value), third)
    }
}

/// Sine and cosine of an angle at a time, if it is one that its digits tell from its neighbours.
fn turned(angle: DoubleDouble, t: f64) -> Result<(f64, f64)> {
    const GREATEST: f64 = 4.6e18;
    if angle.high().abs() <= GREATEST {
        return Ok(sine_cosine(angle));
    }
    let limit = GREATEST / (angle.high() / t).abs();
    Err(Error::OutOfRange {
        quantity: "the time",
        value: t,
        least: -limit,
        greatest: limit,
    })
}

/// Beyond this, in rad/s, sums of rates overflow.
const FASTEST: f64 = 1e307;

/// What does not move.
#[derive(Debug, Clone, Copy)]
struct Body {
    transverse: f64,
    axial: f64,
    weight_moment: f64,
}

/// Whether the fourth power of every number that counts is far above underflow.
fn moderate(body: Body, omega: BodyVector, attitude: &Attitude) -> bool {
    let q = attitude.quaternion();
    let near = |x: f64, unit: f64| x == 0.0 || x.abs() > 1e-60 * unit;
    let swing = (body.weight_moment.abs() / body.transverse).sqrt();
    let fastest = omega.components().amax().max(swing);
    let still = omega.components().iter().all(|x| near(*x, fastest));
    still && near(swing, fastest) && [q.w, q.i, q.j, q.k].iter().all(|x| near(*x, 1.0))
}

/// The constants, everything in units of time in which rates are moderate.
fn prepare<N: Scalar<Narrow = DoubleDouble>>(
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
    let gravity = N::from_narrow(scaled_gravity.narrow());
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
    let spin = N::from_narrow(ratio.narrow()).multiply(o3);
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
    let scale = |x: DoubleDouble| {
        DoubleDouble::sum(shifted(x.high(), exponent), shifted(x.low(), exponent))
    };
    constants.rate = scale(constants.rate);
    constants.rates = constants.rates.map(scale);
    finite("the rate of nutation", constants.rate.value())?;
    constants.fit(q, omega)?;
    constants.pull = pull;
    Ok((kind(&cubic, &d), roots, Motion::Moving(constants)))
}

/// Decided by exact zeros and signs.
fn kind<N: Scalar>(cubic: &Cubic<N>, d: &Distances<N>) -> Nutation {
    // φ' has the sign of (L_vert − L₃h)/I₁: here at both turning points.
    let upper = cubic.drift.subtract(cubic.spin.multiply(d.to_upper));
    let lower = cubic
        .drift
        .subtract(cubic.spin.multiply(d.to_lower).negated());
    if d.third[3].is_zero() {
        Nutation::Waking
    } else if cubic.spin.is_zero() && d.sum.is_zero() {
        Nutation::PlanePendulum
    } else if d.band.is_zero() {
        Nutation::PurePrecession
    } else if cubic.spin.is_zero() {
        Nutation::SphericalPendulum
    } else if upper.is_zero() {
        Nutation::Cusps
    } else if upper.leading() * lower.leading() < 0.0 {
        Nutation::Loops
    } else {
        Nutation::Waves
    }
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
    let side = if m.exceeds(mc) {
        Side::Hyperbolic
    } else {
        Side::Circular
    };
    let (lesser, greater) = match side {
        Side::Circular => (m, mc),
        Side::Hyperbolic => (mc, m),
    };
    let landen = Landen::new(lesser, greater.narrow().square_root());
    let one = N::from_double(1.0);
    let k_prime = mc.root_of_quotient(one);
    let parameter = EllipticParameter::from_both(m.narrow().two(), mc.narrow().two());
    let modulus = Modulus::from_landen(side, parameter, k_prime, &landen);
    let [top1, top2] = d.top;
    let [bottom1, bottom2] = d.bottom;
    let choose = |eta: [N; 3], xi: [N; 3]| {
        let [rise, run, slope] = eta;
        if xi[0].multiply(run).exceeds(rise.multiply(xi[1])) {
            Elevation {
                which: Which::Eta,
                rise,
                run,
                slope,
            }
        } else {
            Elevation {
                which: Which::Xi,
                rise: xi[0],
                run: xi[1],
                slope: xi[2],
            }
        }
    };
    let lower = choose(
        [bottom1, d.band, bottom2],
        [whole, two_g.multiply(bottom1), from_bottom],
    );
    let upper = choose(
        [
            top2.multiply(whole),
            beyond.multiply(d.band),
            top1.multiply(rest),
        ],
        [beyond, two_g.multiply(top2), rest],
    );
    let sense = |x: N| if x.leading() > 0.0 { -1.0 } else { 1.0 };
    let senses = [sense(d.sum), sense(d.difference)];
    let parameters = match side {
        Side::Circular => [
            Parameter::circular(&landen, &lower, m, senses[0]),
            Parameter::circular(&landen, &upper, m, senses[1]),
        ],
        Side::Hyperbolic => [
            Parameter::hyperbolic(&landen, &lower, mc, senses[0]),
            Parameter::hyperbolic(&landen, &upper, mc, senses[1]),
        ],
    };
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
    let start = start(d, cubic, m, mc, &modulus, &landen);
    let rate = lambda.narrow().two();
    Ok(Constants {
        pull: Pull::Down,
        modulus,
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

/// u at time 0: sn² = (h − h₁)/(h₂ − h₁), rising if h rises.
fn start<N: Scalar<Narrow = DoubleDouble>>(
    d: &Distances<N>,
    cubic: &Cubic<N>,
    _m: N,
    mc: N,
    modulus: &Modulus,
    landen: &Landen<N>,
) -> DoubleDouble {
    if d.band.is_zero() {
        return DoubleDouble::from(0.0);
    }
    let [_, _, whole, rest] = d.third;
    let (sn2, cn2) = (d.to_lower, d.to_upper);
    // dn² = (h₃ − h)/(h₃ − h₁), over the band like the others.
    let two_g = cubic.gravity.times(2.0);
    let dn2 = rest
        .add(two_g.multiply(d.to_upper))
        .divide(whole)
        .multiply(d.band);
    let from_end = mc.multiply(sn2.square()).exceeds(cn2.square());
    let fraction = match modulus.side() {
        Side::Circular => {
            let [s, c] = if from_end {
                [
                    cn2.root_of_quotient(dn2),
                    mc.multiply(d.band).root_of_quotient(dn2),
                ]
            } else {
                [sn2.root_of_quotient(d.band), dn2.root_of_quotient(d.band)]
            };
            N::from_double(landen.nearest_sine(s, c, 1.0).asin())
        }
        Side::Hyperbolic => {
            let [s, c] = if from_end {
                [
                    cn2.root_of_quotient(mc.multiply(sn2)),
                    d.band.root_of_quotient(sn2),
                ]
            } else {
                [sn2.root_of_quotient(cn2), dn2.root_of_quotient(cn2)]
            };
            let sinh = landen.nearest_sine(s, c, -1.0);
            N::from_narrow(N::from_double(sinh + sinh.hypot(1.0)).logarithm())
        }
    }
    .divide(N::from_narrow(landen.mean))
    .narrow();
    let u = if from_end {
        modulus.quarter_period_dd().subtract(fraction)
    } else {
        fraction
    };
    if cubic.rise.leading() < 0.0 {
        u.negated()
    } else {
        u
    }
}

impl Constants {
    /// The constant factors of α and β from the start: their sizes from the tilt at a place between the turning points, their phases from
    /// the vertical and Ω, which never vanish together.
    fn fit(&mut self, q: Quaternion<f64>, omega: BodyVector) -> Result<()> {
        let middle = self.modulus.quarter_period() * 0.5;
        let middle = if middle.is_finite() { middle } else { 1.0 };
        let ([sn, cn, _], [alpha, beta, ..]) = self.pair(0.0, DoubleDouble::from(middle))?;
        let above = self.bottom1 + self.band * sn * sn;
        let below = self.top2 + self.band * cn * cn;
        self.factors[0] = Complex::new(above.sqrt() / alpha.norm(), 0.0);
        self.factors[1] = Complex::new(below.sqrt() / beta.norm(), 0.0);
        let (_, [alpha, beta, alpha_rate, beta_rate]) = self.pair(0.0, self.start)?;
        let size = alpha.norm_sqr() + beta.norm_sqr();
        let i = Complex::new(0.0, 1.0);
        // z₁ + iz₂ = 2i ᾱβ and Ω₁ + iΩ₂ = 2 (ᾱβ′ − βᾱ′).
        let vertical = i * alpha.conj() * beta * (2.0 / size);
        let turning = (alpha.conj() * beta_rate - beta * alpha_rate.conj()) * (2.0 / size);
        let (a, b) = (Complex::new(q.w, q.k), Complex::new(q.i, q.j));
        let wanted_vertical = i * a.conj() * b * 2.0;
        let wanted = Complex::new(omega.x(), omega.y());
        let time = 1.0 / self.rate.high();
        // Both pairs in their own size, so that the smallest kick has a direction.
        let unit = |x: Complex, y: Complex| {
            let size = x.re.abs().max(x.im.abs()).max(y.re.abs()).max(y.im.abs());
            if size > 0.0 {
                (x / size, y / size)
            } else {
                (x, y)
            }
        };
        let (vertical, turning) = unit(vertical, turning * time);
        let (wanted_vertical, wanted) = unit(wanted_vertical, wanted * time);
        let relative = wanted_vertical * vertical.conj() + wanted * turning.conj();
        let relative = if relative.norm() > 0.0 {
            relative / relative.norm()
        } else {
            Complex::new(1.0, 0.0)
        };
        let common = alpha.conj() * a + beta.conj() * b * relative.conj();
        let common = common / common.norm();
        self.factors[0] *= common;
        self.factors[1] *= common * relative;
        Ok(())
    }
}
