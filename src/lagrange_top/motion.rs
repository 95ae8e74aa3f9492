//! The exact motion of Lagrange's top (tutorial 7.1, 7.2): attitude and angular velocity at any time, periods and mean rates.

use nalgebra::Quaternion;

use super::evaluation::{Body, Pull, State};
use super::preparation::{
    Exact, FASTEST, Prepared, Start, moderate, prepare, prepare_from_integrals,
};
use super::roots::{Nutation, Roots};
use crate::elliptic::Parameter;
use crate::elliptic::lanes::{Course, fill, turned};
use crate::error::{Error, Result, finite, refused, within};
use crate::precise::{DoubleDouble, Extended, Number, power_of_two_below, sum_of_products};

use crate::frame::{Attitude, BodyVector, finite_vector};

/// A symmetric body that turns about a fixed point of its axis under gravity, with its motion prepared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LagrangeTop {
    body: Body,
    start: Start,
    prepared: Prepared,
}

impl LagrangeTop {
    /// The top with moments I₁ = I₂ = `transverse` about the pivot and I₃ = `axial`, kg m², and Mgl = `weight_moment`, N m,
    /// the centre of mass at +l on x₃; with this angular velocity (rad/s) and attitude at time 0. The space axis z points up.
    ///
    /// Domain: any such body. No gravity (the pivot at the centre of mass), gravity upwards (Mgl < 0) and a needle (I₃ = 0, so that
    /// L₃ is zero whatever Ω₃) are allowed. An axis exactly upright or hanging stays there, spinning or not, unless Ω has a part across it.
    /// Only the direction of the attitude's quaternion counts. An upright or hanging axis, a plane pendulum and the sleeping threshold are recognised exactly for
    /// the numbers given, pure precession and cusps up to their rounding. A tilted start on the separatrix can rarely be given in doubles; rounded, it lies beside it, and
    /// [`kind`](Self::kind) says so. [`from_integrals`](Self::from_integrals) and [`above_upright`](Self::above_upright) reach the separatrix. Cost: some thirty evaluations of
    /// [`at`](Self::at).
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::NotPositive`] for I₁, [`Error::Negative`] for I₃, [`Error::TriangleInequality`] for
    /// I₃ > 2I₁, which no body has (2.4), [`Error::OutOfRange`] for |Ω| or √(Mgl/I₁) above 10³⁰⁷, [`Error::NotPositive`] if the rate of nutation is below the
    /// smallest double.
    ///
    /// ```
    /// use spinning_bodies::frame::{Attitude, BodyVector};
    /// use spinning_bodies::lagrange_top::{LagrangeTop, Nutation};
    /// // Released from rest at 60°, spinning: it dips, and comes back to rest (7.4).
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), std::f64::consts::FRAC_PI_3)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 4.0), tilted)?;
    /// assert_eq!(top.kind(), Nutation::Cusps);
    /// assert!((top.roots().h1 - 0.0).abs() < 1e-15); // as far as the horizontal
    /// let back = top.at(top.period())?;
    /// assert!(back.omega.x().hypot(back.omega.y()) < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(
        transverse: f64,
        axial: f64,
        weight_moment: f64,
        omega: BodyVector,
        attitude: Attitude,
    ) -> Result<Self> {
        let body = Body::new(transverse, axial, weight_moment)?;
        let start = Start { omega, attitude };
        Self::prepared(body, start, &Exact::of(body, start))
    }

    /// The same from numbers that have not been rounded to doubles.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub(crate) fn exactly(transverse: f64, axial: f64, exact: &Exact) -> Result<Self> {
        let body = Body::new(transverse, axial, exact.weight_moment.value())?;
        let [x, y, z] = exact.omega.map(Extended::value);
        let [qw, qx, qy, qz] = exact.quaternion.map(Extended::value);
        let quaternion = nalgebra::Quaternion::new(qw, qx, qy, qz);
        let start = Start {
            omega: BodyVector::new(x, y, z),
            attitude: Attitude::from_unit(quaternion),
        };
        Self::prepared(body, start, exact)
    }

    fn prepared(body: Body, start: Start, exact: &Exact) -> Result<Self> {
        let omega = finite_vector("a component of the angular velocity", start.omega)?;
        within("the angular velocity", omega.norm(), 0.0, FASTEST)?;
        let prepared = if moderate(body, start) {
            prepare::<DoubleDouble>(body, start, exact)?
        } else {
            prepare::<Extended>(body, start, exact)?
        };
        Ok(Self {
            body,
            start,
            prepared,
        })
    }

    /// The top with these integrals (7.2): L₃ and L_vert, the components of L along the axis and along the vertical (kg m²/s), and the energy
    /// E = ½⟨Ω, L⟩ + Mgl cos θ (J). It starts where C is lowest, with φ = ψ = 0, so that the axis leans towards −y of space.
    ///
    /// The separatrix, L_vert = L₃ and E = L₃²/2I₃ + Mgl for L₃² < 4I₁Mgl, is recognised by exact products and sums of the doubles given. There the top wakes,
    /// 1 − h = (1 − h₁) sech²(λt) with λ² = Mgl (1 − h₁)/2I₁. Where that energy is not a double, [`above_upright`](Self::above_upright) reaches it.
    /// Domain: bodies as for [`new`](Self::new), every L₃ and L_vert, every energy that a motion can have. A tilt that would change by less than 10⁻¹⁴ of the smaller
    /// of 1 − h and 1 + h counts as constant; for the least energy, pure precession, [`pure_precession`](super::pure_precession) is easier to use.
    /// If these integrals are those of an unstable upright top, the motion is the waking one. Error: that of [`at`](Self::at), for the integrals given.
    /// Cost: some fifty evaluations of [`at`](Self::at).
    ///
    /// # Errors
    /// Those of [`new`](Self::new) for the body; [`Error::NotFinite`]; [`Error::Condition`] for an energy below that of every motion with
    /// these L₃ and L_vert, for L₃ ≠ 0 of a needle (I₃ = 0), and at rest without gravity, where the integrals leave the tilt open; [`Error::OutOfRange`] for
    /// |Ω| or √(Mgl/I₁) above 10³⁰⁷.
    ///
    /// ```
    /// use spinning_bodies::lagrange_top::{LagrangeTop, Nutation};
    /// // L₃ = L_vert = 1 and E = L₃²/2I₃ + Mgl: 1 − h = 1.5 sech²(√0.75 t).
    /// let waking = LagrangeTop::from_integrals(1.0, 0.5, 1.0, 1.0, 1.0, 2.0)?;
    /// assert_eq!(waking.kind(), Nutation::Waking);
    /// let (state, t) = (waking.at(300.0)?, 300.0 * 0.75f64.sqrt());
    /// assert!((state.one_less / (1.5 / t.cosh().powi(2)) - 1.0).abs() < 1e-12, "10⁻²²⁵");
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn from_integrals(
        transverse: f64,
        axial: f64,
        weight_moment: f64,
        l3: f64,
        l_vert: f64,
        energy: f64,
    ) -> Result<Self> {
        let body = Body::new(transverse, axial, weight_moment)?;
        let energy = finite("the energy", energy)?;
        // 2 (E − L₃²/2I₃ + `weight`).
        let twice_above = |weight: f64| {
            if axial == 0.0 {
                return sum_of_products(&[[2.0, energy], [2.0, weight]]);
            }
            let [spin, fall] = [[l3, -l3], [axial, weight]];
            sum_of_products(&[[axial, energy], [axial, energy], spin, fall, fall])
                .quotient(Extended::from_double(axial))
        };
        Self::from_energies(body, [l3, l_vert], energy, twice_above)
    }

    /// The same as [`from_integrals`](Self::from_integrals), from the energy above that of the top spinning with this L₃ and with C right above the pivot,
    /// E − L₃²/2I₃ − |Mgl| (J). Zero is the separatrix if L_vert = L₃ (−L₃ for Mgl < 0), for every body, and next to it no digit is lost.
    ///
    /// # Errors
    /// As for [`from_integrals`](Self::from_integrals).
    ///
    /// ```
    /// use spinning_bodies::lagrange_top::{LagrangeTop, Nutation};
    /// // The sum L₃²/2I₃ + Mgl of these numbers is not a double.
    /// let at = |excess| LagrangeTop::above_upright(0.3, 0.1, 0.7, 0.2, 0.2, excess);
    /// assert_eq!(at(0.0)?.kind(), Nutation::Waking);
    /// // The period grows by ln 10¹⁰⁰/λ for each hundred zeros.
    /// let (near, nearer) = (at(1e-100)?, at(1e-200)?);
    /// let rate = (0.7 * at(0.0)?.roots().one_less[0] / 0.6).sqrt();
    /// assert!((nearer.period() - near.period() - 100.0 * 10f64.ln() / rate).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn above_upright(
        transverse: f64,
        axial: f64,
        weight_moment: f64,
        l3: f64,
        l_vert: f64,
        excess: f64,
    ) -> Result<Self> {
        let body = Body::new(transverse, axial, weight_moment)?;
        let excess = finite("the energy above the upright position", excess)?;
        let size = weight_moment.abs();
        // Twice the energy above the upright position for `weight` = −|Mgl|, above the hanging one for |Mgl|.
        let twice_above =
            |weight: f64| sum_of_products(&[[2.0, excess], [2.0, size], [2.0, weight]]);
        Self::from_energies(body, [l3, l_vert], excess, twice_above)
    }

    /// From a function that gives twice the energy above the upright position (for −|Mgl|) and above the hanging one (for |Mgl|); `given` is the
    /// energy for the error message.
    fn from_energies(
        body: Body,
        [l3, l_vert]: [f64; 2],
        given: f64,
        twice_above: impl Fn(f64) -> Extended,
    ) -> Result<Self> {
        finite("L3", l3)?;
        finite("the vertical angular momentum", l_vert)?;
        if body.axial == 0.0 && l3 != 0.0 {
            let condition = "the angular momentum L3 of a needle about its own axis must be zero";
            return refused(condition, l3);
        }
        let weight = body.weight_moment.abs();
        let above = [-weight, weight].map(twice_above);
        let found = prepare_from_integrals(body, [l3, l_vert], above)?;
        let (start, prepared) = found.ok_or(Error::Condition {
            condition: "the energy must be at least the least that a motion with these L3 and L_vert can have",
            value: given,
        })?;
        Ok(Self {
            body,
            start,
            prepared,
        })
    }

    /// The kind of motion that the axis makes, decided once. With gravity upwards it is the kind of the same motion seen upside down:
    /// an axis that points down is then asleep.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::{LagrangeTop, Nutation}};
    /// // Spun, and released with its axis at rest.
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// assert_eq!(top.kind(), Nutation::Cusps);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn kind(&self) -> Nutation {
        self.prepared.kind
    }

    /// L_vert, the component of L along the vertical, kg m²/s: constant (7.2).
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// assert!((top.vertical_angular_momentum() - 4.5 * 0.5_f64.cos()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn vertical_angular_momentum(&self) -> f64 {
        // Over a power of two: products of components may overflow where the result does not.
        let unit = 8.0 * power_of_two_below(self.start.omega.components().amax());
        let l = self.body.angular_momentum(self.start.omega / unit);
        self.start.attitude.to_space(l).z() * unit
    }

    /// E = ½⟨Ω, L⟩ + Mgl cos θ, J: constant (7.2).
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// // ½I₃Ω₃² + Mgl cos θ.
    /// assert!((top.energy() - 20.25 - 0.5_f64.cos()).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn energy(&self) -> f64 {
        let [x, y, z]: [f64; 3] = self.start.omega.components().into();
        let q = self.start.attitude.quaternion();
        let height = (q.w * q.w + q.k * q.k) - (q.i * q.i + q.j * q.j);
        let Body {
            transverse,
            axial,
            weight_moment,
        } = self.body;
        let spin = (transverse * x) * x + (transverse * y) * y + (axial * z) * z;
        0.5 * spin + weight_moment * height
    }

    /// The roots of the cubic.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// // The upper turning point is where it was released.
    /// assert!((top.roots().h2 - 0.5_f64.cos()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub const fn roots(&self) -> Roots {
        self.prepared.roots
    }

    /// Ω, L, attitude and height at time t (s), before or after the start (7.2).
    ///
    /// Attitude and Ω come from two theta functions, which are regular in the upright and the hanging position too. Error observed against 857
    /// references of 32 digits, hard cases included: attitude at most 9e-16 rad, Ω 1.2e-15 of its greatest value, 1 ∓ h 8e-16 of itself, without growth up to
    /// 10³ nutations; over 5000 random starts attitude 2.5e-15 rad at worst. L follows Ω: of a needle its part across the axis has fewer digits, by I₁/I₃. Of a top
    /// that tilts by less than 10⁻¹⁰ next to the spin at which it falls, 1 ∓ h has fewer as well, 8 of 16 at worst. Cost: the same at every time, that of five triples of Jacobi functions, prepared.
    ///
    /// # Errors
    /// [`Error::NotFinite`]; [`Error::OutOfRange`] beyond 2⁵³ quarter periods or 2⁶² radians.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// // I₃Ω₃ is constant, and after a period the axis is as high as before.
    /// let later = top.at(top.period())?;
    /// assert_eq!(later.omega.z(), 9.0);
    /// assert!((later.up.z() - 0.5_f64.cos()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, t: f64) -> Result<State> {
        let t = finite("the time", t)?;
        match &self.prepared.motion {
            None => {
                let half = DoubleDouble::from(0.5 * self.start.omega.z());
                let (sine, cosine) = turned(half, t, DoubleDouble::from(0.0))?;
                let turn = Quaternion::new(cosine, 0.0, 0.0, sine);
                let q = self.start.attitude.quaternion().into_inner() * turn;
                let upper = q.w * q.w + q.k * q.k;
                let lower = q.i * q.i + q.j * q.j;
                let heights = [lower, upper].map(|part| 2.0 * (part / (upper + lower)));
                let omega = BodyVector::new(0.0, 0.0, self.start.omega.z());
                Ok(State::new(&self.body, omega, q, heights))
            }
            Some(constants) => constants.at(t, &self.body, self.start.omega.z()),
        }
    }

    /// The states at these times, one after another.
    ///
    /// # Errors
    /// Each as for [`at`](Self::at).
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// let heights = top.states([0.0, 0.1, 0.2]).map(|state| Ok(state?.up.z()));
    /// let heights: Vec<f64> = heights.collect::<Result<_, spinning_bodies::Error>>()?;
    /// // Released, it falls.
    /// assert!(heights[0] > heights[1]);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states(
        &self,
        times: impl IntoIterator<Item = f64>,
    ) -> impl Iterator<Item = Result<State>> {
        times.into_iter().map(|t| self.at(t))
    }

    /// Fills a slice with the states at these times (s), which may be in any order; the slices have one length (7.2).
    ///
    /// The states are those of [`at`](Self::at) to the last bit, with its domain and error. Eight times are computed side by side up to some 4·10⁶ turns from the start. Cost a state, relative to [`at`](Self::at) in the same run: 0.6; 1.15 for a
    /// batch of one time.
    ///
    /// # Errors
    /// [`Error::Condition`] if the slices differ in length; otherwise that of the first time that [`at`](Self::at) refuses, with some of the states written.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// let times = [0.0, 0.1, 0.2, 0.3, 0.4];
    /// let mut states = [top.at(0.0)?; 5];
    /// top.states_at(&times, &mut states)?;
    /// assert_eq!(states[3], top.at(0.3)?);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn states_at(&self, times: &[f64], states: &mut [State]) -> Result<()> {
        let (body, axial_rate) = (&self.body, self.start.omega.z());
        let moving = self.prepared.motion.as_ref();
        let moving = moving.map(|constants| (constants, constants.reach));
        let one = |t| self.at(t);
        fill(times, states, moving, one, |constants, times, states| {
            constants.side_by_side(times, body, axial_rate, states);
        })
    }

    /// Period of the nutation, 2K/λ, s; infinite where the tilt is constant or never returns.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// // A fast top nods at nearly the rate L₃/I₁.
    /// assert!((top.period() * 4.5 / std::f64::consts::TAU - 1.0).abs() < 0.1);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn period(&self) -> f64 {
        let moving = self.prepared.motion.as_ref();
        moving.map_or(f64::INFINITY, |constants| {
            let Course { modulus, rate, .. } = &constants.course;
            2.0 * modulus.quarter_period() / rate.high().abs()
        })
    }
}

impl LagrangeTop {
    /// The parameter m = k² of the elliptic functions in the tilt, and its complement (7.2); `None` where the tilt is constant.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// let m = top.parameter().unwrap();
    /// assert!(m.m() > 0.0 && m.m() < 0.1 && (m.m() + m.mc() - 1.0).abs() < 1e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn parameter(&self) -> Option<Parameter> {
        let constants = self.prepared.motion.as_ref()?;
        Some(constants.course.modulus.parameter)
    }

    /// The angle by which the axis goes round the vertical in one period of nutation, radians (7.2); `None` where there is no period.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// let (turn, rate) = (top.precession_per_nutation().unwrap(), top.mean_precession_rate().unwrap());
    /// assert!((turn / top.period() - rate).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn precession_per_nutation(&self) -> Option<f64> {
        let constants = self.prepared.motion.as_ref()?;
        let returns = constants.course.modulus.quarter_period().is_finite();
        let precession = constants.precession_per_nutation().value();
        returns.then_some(match constants.pull {
            Pull::Down => precession,
            Pull::Up => -precession,
        })
    }

    /// Mean rate at which the axis goes round the vertical, rad/s (7.2); `None` where there is no period.
    ///
    /// ```
    /// use spinning_bodies::{frame::{Attitude, BodyVector}, lagrange_top::LagrangeTop};
    /// let tilted = Attitude::about_axis(BodyVector::new(1.0, 0.0, 0.0), 0.5)?;
    /// let top = LagrangeTop::new(1.0, 0.5, 1.0, BodyVector::new(0.0, 0.0, 9.0), tilted)?;
    /// // Mgl/L₃ for a fast top.
    /// assert!((top.mean_precession_rate().unwrap() * 4.5 - 1.0).abs() < 0.1);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn mean_precession_rate(&self) -> Option<f64> {
        Some(self.precession_per_nutation()? / self.period())
    }
}
