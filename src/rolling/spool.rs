//! The spool whose string is tugged (tutorial 4.4): friction has no moment about the point of contact, so the moment of the tug decides.

use super::shot::RoundBody;
use super::{Coulomb, Course, Load, Moment, RollingResistance};
use crate::error::{Result, not_negative, positive, within};

/// A spool on a table: discs with the radius of a [`RoundBody`] and an axle between them.
///
/// The string leaves the axle from below; the tug has tension T at the angle θ above the horizontal, 0 towards +x. Its moment about
/// the centre is −rT at every angle, about the point of contact T(R cos θ − r), whose sign decides which way the spool rolls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spool {
    /// The body that rolls on the table.
    pub(crate) body: RoundBody,
    ratio: f64,
    /// 1 − r/R, of which the rounded ratio has lost the last digits.
    gap: f64,
}

/// A constant tug on the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tug {
    tension: f64,
    angle: f64,
}

/// The way a spool rolls when it is tugged gently, described by its string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// Along +x, winding string up.
    WindsUp,
    /// Not at all: the line of force goes through the point of contact.
    Stays,
    /// Along −x, paying string out: away from a hand that tugs forward, towards one that tugs back over the axle (past 90°).
    PaysOut,
}

impl Tug {
    /// A tension (N) at an angle (rad) above the horizontal, 0…π.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::Negative`](crate::Error::Negative); [`Error::OutOfRange`](crate::Error::OutOfRange) for the angle.
    ///
    /// ```
    /// use spinning_bodies::rolling::Tug;
    /// assert!(Tug::new(1.2, 0.5).is_ok() && Tug::new(1.2, 4.0).is_err());
    /// ```
    pub fn new(tension: f64, angle: f64) -> Result<Self> {
        let (tension, angle) = (not_negative("the tension", tension)?, tug_angle(angle)?);
        Ok(Self { tension, angle })
    }

    /// Angle above the horizontal, rad.
    ///
    /// ```
    /// use spinning_bodies::rolling::Tug;
    /// assert_eq!(Tug::new(1.2, 0.5)?.angle(), 0.5);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn angle(&self) -> f64 {
        self.angle
    }
}

fn tug_angle(angle: f64) -> Result<f64> {
    within("the angle of the tug", angle, 0.0, core::f64::consts::PI)
}

impl Spool {
    /// A spool that rolls on `body` and whose string is wound on radius `axle` (m), which may be the larger of the two, for a
    /// spool that rolls on rails.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive), [`Error::NotFinite`](crate::Error::NotFinite) for the axle.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool};
    /// let body = RoundBody::new(2.0, 1.0, 0.5)?;
    /// assert!(Spool::new(body, 1.5).is_ok() && Spool::new(body, 0.0).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn new(body: RoundBody, axle: f64) -> Result<Self> {
        let axle = positive("the radius of the axle", axle)?;
        let ratio = positive("the ratio of the radii", axle / body.radius)?;
        let gap = (body.radius - axle) / body.radius;
        Ok(Self { body, ratio, gap })
    }

    /// The tug's moment about the centre, −rT, N m, the same at every angle; positive in the sense of rolling forward (4.4).
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool, Tug};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tug = Tug::new(1.2, 0.0)?;
    /// assert_eq!(spool.moment_about_centre(tug), -0.6);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn moment_about_centre(&self, tug: Tug) -> f64 {
        -self.ratio * self.body.radius * tug.tension
    }

    /// The tug's moment about the point of contact, T(R cos θ − r), N m (4.4); friction has no moment there.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool, Tug};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tug = Tug::new(1.2, 0.0)?;
    /// assert_eq!(spool.moment_about_contact(tug), 0.6);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn moment_about_contact(&self, tug: Tug) -> f64 {
        self.body.radius * tug.tension * self.lead(tug.angle)
    }

    /// The angle at which the line of force goes through the point of contact, cos θ = r/R, rad; `None` if r > R (4.4). Formed as
    /// 2 arctan √((R − r)/(R + r)), accurate down to θ = 0.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// assert!((spool.critical_angle().unwrap() - std::f64::consts::FRAC_PI_3).abs() < 1e-15);
    /// // An axle 2·10⁻¹² m thinner than the discs of 3 m: √(2·⅔·10⁻¹²) rad, of which r/R alone tells four digits.
    /// let axle = 3.0 - 2e-12;
    /// let nearly = Spool::new(RoundBody::new(2.0, 3.0, 0.5)?, axle)?;
    /// assert!((nearly.critical_angle().unwrap() / ((3.0 - axle) / 1.5).sqrt() - 1.0).abs() < 1e-12);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn critical_angle(&self) -> Option<f64> {
        (self.gap >= 0.0).then(|| 2.0 * (self.gap / (1.0 + self.ratio)).sqrt().atan())
    }

    /// The way it rolls when tugged gently at this angle (rad), decided by [`Self::critical_angle`] to the last bit (4.4).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) outside 0…π.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool, Way};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// assert_eq!((spool.way(1.0)?, spool.way(1.1)?), (Way::WindsUp, Way::PaysOut));
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn way(&self, angle: f64) -> Result<Way> {
        let angle = tug_angle(angle)?;
        Ok(match self.critical_angle() {
            Some(critical) if angle < critical => Way::WindsUp,
            Some(critical) if angle == critical => Way::Stays,
            _ => Way::PaysOut,
        })
    }

    /// Acceleration while it rolls, T(cos θ − r/R)/(M(1+κ)), m/s², positive along +x (4.4); to its own digits for an axle nearly as thick as the discs, too.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool, Tug};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tug = Tug::new(1.2, 0.0)?;
    /// assert!((spool.rolling_acceleration(tug) - 0.2).abs() < 1e-16);
    /// // An axle 2·10⁻¹² m thinner than the discs of 3 m.
    /// let axle = 3.0 - 2e-12;
    /// let nearly = Spool::new(RoundBody::new(2.0, 3.0, 0.5)?, axle)?;
    /// assert!((nearly.rolling_acceleration(tug) / (0.4 * (3.0 - axle) / 3.0) - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    // ANCHOR: rolling-acceleration
    pub fn rolling_acceleration(&self, tug: Tug) -> f64 {
        let whole = self.body.mass * self.body.pure_rolling_height();
        tug.tension * self.lead(tug.angle) / whole
    }
    // ANCHOR_END: rolling-acceleration

    /// Friction on the spool while it rolls, −T(r/R + κ cos θ)/(1+κ), N, positive along +x (4.4).
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool, Tug};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tug = Tug::new(1.2, 0.0)?;
    /// // Tug and friction together make it roll: 1.2 N − 0.8 N = 2 kg · 0.2 m/s².
    /// assert!((spool.rolling_friction(tug) + 0.8).abs() < 2e-16);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn rolling_friction(&self, tug: Tug) -> f64 {
        -tug.tension * self.needed(tug.angle)
    }

    /// −f/T while it rolls: the friction needed.
    fn needed(&self, angle: f64) -> f64 {
        (self.ratio + self.body.inertia_factor * angle.cos()) / self.body.pure_rolling_height()
    }

    /// Reaction of the table, Mg − T sin θ, N; if negative, the spool lifts off.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool, Tug};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// // Straight up.
    /// let tug = Tug::new(5.0, std::f64::consts::FRAC_PI_2)?;
    /// assert_eq!(spool.reaction(tug, 10.0), 15.0);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn reaction(&self, tug: Tug, gravity: f64) -> f64 {
        self.body.mass * gravity - tug.tension * tug.angle.sin()
    }

    /// The largest tension (N) at which the spool rolls without slipping, with friction μ (dimensionless), at this angle (rad), under gravity g (m/s²): what "gently"
    /// means (4.4). |f| ≤ μ(Mg − T sin θ), solved for T. Never more than [`Self::lift_off_tension`], and equal to it where no friction is needed.
    ///
    /// # Errors
    /// As [`Self::way`]; [`Error::Negative`](crate::Error::Negative) for μ; [`Error::NotPositive`](crate::Error::NotPositive) for g.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// // f = T/1.5 at most 0.2 · 20 N.
    /// assert!((spool.largest_gentle_tension(0.0, 0.2, 10.0)? - 6.0).abs() < 1e-14);
    /// // No weight that a double holds.
    /// let light = Spool::new(RoundBody::new(5e-324, 1e160, 1e-300)?, 1.0)?;
    /// assert!(light.largest_gentle_tension(0.0, 1e300, 0.1).is_err());
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn largest_gentle_tension(&self, angle: f64, friction: f64, gravity: f64) -> Result<f64> {
        let angle = tug_angle(angle)?;
        let friction = not_negative("the coefficient of friction", friction)?;
        let weight = self.weight(gravity)?;
        let needed = self.needed(angle).abs();
        if needed == 0.0 {
            return self.lift_off_tension(angle, gravity);
        }
        Ok(weight / (needed / friction + angle.sin()))
    }

    /// The tension (N) that lifts the spool off the table, Mg/sin θ; infinite for a level tug (4.4).
    ///
    /// # Errors
    /// As [`Self::way`]; [`Error::NotPositive`](crate::Error::NotPositive) for g.
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// assert_eq!(spool.lift_off_tension(std::f64::consts::FRAC_PI_2, 10.0)?, 20.0);
    /// assert_eq!(spool.lift_off_tension(0.0, 10.0)?, f64::INFINITY);
    /// assert_eq!(spool.lift_off_tension(0.0, 5e-324)?, f64::INFINITY);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn lift_off_tension(&self, angle: f64, gravity: f64) -> Result<f64> {
        let weight = self.weight(gravity)?;
        Ok(match tug_angle(angle)?.sin() {
            0.0 => f64::INFINITY,
            sine => weight / sine,
        })
    }

    fn weight(&self, gravity: f64) -> Result<f64> {
        let gravity = positive("the acceleration of gravity", gravity)?;
        positive("the weight", self.body.mass * gravity)
    }

    /// Distance in front of the point of contact (+x), m, at which the line of force meets the table; infinite for a level tug, but 0 if R = r, when the line
    /// lies in the table (4.4, pictures e–g).
    ///
    /// The string touches the axle at r(sin θ, −cos θ) from the centre.
    ///
    /// # Errors
    /// As [`Self::way`].
    ///
    /// ```
    /// use spinning_bodies::rolling::{RoundBody, Spool};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// // Straight up: the line of force touches the side of the axle.
    /// assert!((spool.foot_of_the_line(std::f64::consts::FRAC_PI_2)? - 0.5).abs() < 1e-15);
    /// // An axle as thick as the discs: R tan θ/2.
    /// let even = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 1.0)?;
    /// assert!((even.foot_of_the_line(1e-9)? / 5e-10 - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn foot_of_the_line(&self, angle: f64) -> Result<f64> {
        let sin = tug_angle(angle)?.sin();
        let lead = self.lead(angle);
        if lead == 0.0 {
            return Ok(0.0);
        }
        Ok(-self.body.radius * lead / sin)
    }

    /// cos θ − r/R; for small angles from 1 − cos θ, for the cosine is rounded to 1 and r/R to as many digits.
    fn lead(&self, angle: f64) -> f64 {
        let half = (0.5 * angle).sin();
        match angle < 1.0 {
            true => self.gap - 2.0 * half * half,
            false => angle.cos() - self.ratio,
        }
    }

    /// The load that the tug puts on the spool, per mass.
    ///
    /// # Errors
    /// [`Error::NotPositive`](crate::Error::NotPositive) for the reaction: the tug lifts the spool.
    pub(crate) fn load(&self, tug: Tug, gravity: f64) -> Result<Load> {
        let gravity = positive("the acceleration of gravity", gravity)?;
        let pull = tug.tension / self.body.mass;
        let (sin, cos) = tug.angle.sin_cos();
        let reaction = gravity - pull * sin;
        Ok(Load {
            push: pull * cos,
            twist: -pull * self.ratio,
            reaction: positive("the reaction of the table under the tug", reaction)?,
        })
    }

    /// The motion from rest under a constant tug, up to `until` (s): rolling, or slipping if friction cannot hold against the tug. From the load T cos θ and −Tr/R,
    /// each rounded: where the two nearly balance, [`rolling_acceleration`](Self::rolling_acceleration) has more digits.
    ///
    /// # Errors
    /// As [`Course::new`].
    ///
    /// ```
    /// use spinning_bodies::rolling::{Coulomb, RoundBody, Spool, Tug};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tug = Tug::new(1.2, 0.0)?;
    /// let course = spool.course(tug, 10.0, Some(Coulomb::new(0.3)?), None, 2.0)?;
    /// // 0.2 m/s² for two seconds.
    /// assert!((course.at(2.0).velocity - 0.4).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn course(
        &self,
        tug: Tug,
        gravity: f64,
        friction: Option<Coulomb>,
        resistance: Option<RollingResistance>,
        until: f64,
    ) -> Result<Course> {
        let load = self.load(tug, gravity)?;
        let effects = (friction, resistance, None);
        let kappa = self.body.inertia_factor;
        Course::new(kappa, load, effects, Moment::default(), until)
    }

    /// Length of string wound up since the start, m; negative if it was paid out.
    ///
    /// ```
    /// use spinning_bodies::rolling::{Moment, RoundBody, Spool};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let moment = Moment { turned: 0.4, ..Moment::default() };
    /// assert_eq!(spool.wound(&moment), 0.2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn wound(&self, moment: &Moment) -> f64 {
        self.ratio * moment.turned
    }

    /// Speed of the hand along the tug, V cos θ − (r/R)RΩ, m/s; T times this is the power of the tug (4.4).
    ///
    /// ```
    /// use spinning_bodies::rolling::{Moment, RoundBody, Spool, Tug};
    /// let spool = Spool::new(RoundBody::new(2.0, 1.0, 0.5)?, 0.5)?;
    /// let tug = Tug::new(1.2, 0.0)?;
    /// // Rolling at 0.4 m/s, it winds up string at half that speed.
    /// assert_eq!(spool.hand_speed(tug, &Moment::moving(0.4, 0.4)), 0.2);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn hand_speed(&self, tug: Tug, moment: &Moment) -> f64 {
        moment.velocity * tug.angle.cos() - self.ratio * moment.rim_speed
    }
}
