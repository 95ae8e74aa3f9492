//! The billiard shot (tutorial 4.3): the blow of the cue and the sliding that follows it.

use crate::error::{Result, finite, not_negative, positive, within};

/// A body that rolls on a circle about its centre of mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundBody {
    /// Mass, kg.
    pub(crate) mass: f64,
    /// Radius of the rolling circle, m.
    pub(crate) radius: f64,
    /// κ = I/(MR²), dimensionless.
    pub(crate) inertia_factor: f64,
}

/// How the body leaves the cue, compared with rolling (4.3).
///
/// "Backward" is relative: between heights R and (1+κ)R the ball does turn forward, only too slowly for rolling. True backspin
/// needs a stroke below the centre.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// Struck below (1+κ)R: it turns too slowly, and the contact point slides forward over the cloth.
    SkidsBackward,
    /// Struck at (1+κ)R: the contact point is at rest.
    PureRolling,
    /// Struck above (1+κ)R: it turns too fast, and the contact point slides backward over the cloth.
    SkidsForward,
}

/// A body just after a level stroke of the cue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shot {
    /// The body that was struck.
    pub(crate) body: RoundBody,
    height_over_radius: f64,
    /// Velocity of the centre V', m/s.
    pub velocity: f64,
    /// Rim speed RΩ' = (H−R)V'/(κR), m/s; negative for a stroke below the centre.
    pub rim_speed: f64,
    /// Velocity of the contact point V' − RΩ', m/s, from the height of the stroke.
    pub slip: f64,
    /// How the body leaves the cue.
    pub regime: Regime,
}

/// The sliding that precedes rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlideToRoll {
    /// Time until rolling sets in, s.
    pub time: f64,
    /// Displacement of the centre in that time, m; negative if the body has backed up.
    pub distance: f64,
    /// Velocity of rolling, m/s; negative if spin has turned the body round.
    pub speed: f64,
    /// Heat produced in cloth and body, J.
    pub heat: f64,
}

impl RoundBody {
    /// A body of `mass` (kg), rolling `radius` (m) and inertia factor κ = I/(MR²) (dimensionless: 2/5 for a ball, 2/3 for its shell, 1/2 for a disc, 1 for a hoop).
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), [`Error::NotPositive`](crate::Error::NotPositive); [`Error::OutOfRange`](crate::Error::OutOfRange) if κ > 1, more than if all mass were at the rim.
    ///
    /// ```
    /// use spinning_bodies::rolling::RoundBody;
    /// assert!(RoundBody::new(1.0, 0.03, 1.0).is_ok());
    /// assert!(RoundBody::new(1.0, 0.0, 1.0).is_err());
    /// ```
    pub fn new(mass: f64, radius: f64, inertia_factor: f64) -> Result<Self> {
        positive("the inertia factor", inertia_factor)?;
        let inertia_factor = within("the inertia factor", inertia_factor, 0.0, 1.0)?;
        Ok(Self {
            mass: positive("the mass", mass)?,
            radius: positive("the radius", radius)?,
            inertia_factor,
        })
    }

    /// Height of the stroke that gives pure rolling, in radii: H/R = 1 + κ (4.3). Error: half a unit in the last place.
    ///
    /// ```
    /// use spinning_bodies::rolling::RoundBody;
    /// let ball = RoundBody::new(1.0, 0.03, 0.4)?;
    /// assert_eq!(ball.pure_rolling_height(), 1.4);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn pure_rolling_height(&self) -> f64 {
        1.0 + self.inertia_factor
    }

    /// Slip of the contact point after a level stroke at height H, in units of V': (V' − RΩ')/V' = 1 − (H−R)/(κR) (4.3).
    ///
    /// Formed as ((1+κ) − H/R)/κ: zero exactly at [`Self::pure_rolling_height`], elsewhere with two roundings. That of 1+κ changes the slip by ε/2κ,
    /// which is large for a body of very small inertia.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite); [`Error::OutOfRange`](crate::Error::OutOfRange) if the cue misses, H outside 0…2R.
    ///
    /// ```
    /// use spinning_bodies::rolling::RoundBody;
    /// let ball = RoundBody::new(1.0, 0.03, 0.4)?;
    /// // Struck through the centre it does not turn at all.
    /// assert!((ball.cue_slip(1.0)? - 1.0).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    // ANCHOR: cue-slip
    pub fn cue_slip(&self, height_over_radius: f64) -> Result<f64> {
        let height = height_on_body(height_over_radius)?;
        Ok((self.pure_rolling_height() - height) / self.inertia_factor)
    }
    // ANCHOR_END: cue-slip

    /// Eventual rolling speed in units of V': V_f/V' = (H/R)/(1+κ), whatever the friction (4.3).
    ///
    /// It follows from the angular momentum about a point of the table, which friction cannot change.
    ///
    /// # Errors
    /// As [`Self::cue_slip`].
    ///
    /// ```
    /// use spinning_bodies::rolling::RoundBody;
    /// let ball = RoundBody::new(1.0, 0.03, 0.4)?;
    /// assert!((ball.eventual_speed(0.7)? - 0.5).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn eventual_speed(&self, height_over_radius: f64) -> Result<f64> {
        Ok(height_on_body(height_over_radius)? / self.pure_rolling_height())
    }

    /// The body after a level stroke at height H that gives its centre the velocity V' (m/s); the regime is decided here.
    ///
    /// # Errors
    /// As [`Self::cue_slip`]; [`Error::NotPositive`](crate::Error::NotPositive) if the velocity is not.
    ///
    /// ```
    /// use spinning_bodies::rolling::{Regime, RoundBody};
    /// let ball = RoundBody::new(1.0, 0.03, 0.4)?;
    /// assert_eq!(ball.strike(1.0, 7.0)?.regime, Regime::SkidsBackward);
    /// assert!((ball.strike(1.2, 7.0)?.rim_speed - 3.5).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn strike(&self, height_over_radius: f64, velocity: f64) -> Result<Shot> {
        let velocity = positive("the velocity after the stroke", velocity)?;
        let relative = self.cue_slip(height_over_radius)?;
        let regime = match relative {
            0.0 => Regime::PureRolling,
            back if back > 0.0 => Regime::SkidsBackward,
            _ => Regime::SkidsForward,
        };
        let slip = finite("the slip of the contact point", relative * velocity)?;
        Ok(Shot {
            body: *self,
            height_over_radius,
            velocity,
            rim_speed: (height_over_radius - 1.0) / self.inertia_factor * velocity,
            slip,
            regime,
        })
    }

    /// Time, distance, speed and heat of the sliding under Coulomb friction until the body rolls (4.3, continued).
    ///
    /// `velocity` and `rim_speed` in m/s, `friction` the coefficient μ, `gravity` in m/s². With u = velocity − rim speed,
    /// t = κ|u|/((1+κ)μg), which is 2|u|/(7μg) for the ball; V_f = (V + κRΩ)/(1+κ), exactly 0 if the product κRΩ rounds to −V;
    /// heat = ½ M κu²/(1+κ).
    ///
    /// The only subtraction forms u from the two numbers given and is backward stable. If the rim speed comes from a cue
    /// stroke near 7R/5, use [`Shot::slide`], where u comes from the height and nothing cancels; if it comes from an angular
    /// velocity, use [`Self::slide_of_spin`]. For μg in the range of doubles.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite) for an argument that is not, or a result that overflows; [`Error::NotPositive`](crate::Error::NotPositive) for μ or g.
    ///
    /// ```
    /// use spinning_bodies::rolling::RoundBody;
    /// let ball = RoundBody::new(1.0, 0.03, 0.4)?;
    /// let slide = ball.slide_to_roll(7.0, 0.0, 0.2, 10.0)?;
    /// assert!((slide.time - 1.0).abs() + (slide.speed - 5.0).abs() + (slide.distance - 6.0).abs() + (slide.heat - 7.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn slide_to_roll(
        &self,
        velocity: f64,
        rim_speed: f64,
        friction: f64,
        gravity: f64,
    ) -> Result<SlideToRoll> {
        let velocity = finite("the velocity", velocity)?;
        let rim_speed = finite("the rim speed", rim_speed)?;
        let speed = (velocity + self.inertia_factor * rim_speed) / self.pure_rolling_height();
        self.slide([velocity, velocity - rim_speed, speed], friction, gravity)
    }

    /// [`Self::slide_to_roll`] for a body that turns at Ω (`omega`, rad/s). V − RΩ is formed by one fused multiplication, so that close to rolling the slip is
    /// that of the three numbers given; with RΩ rounded first it could come out as zero.
    ///
    /// # Errors
    /// As [`Self::slide_to_roll`].
    ///
    /// ```
    /// use spinning_bodies::rolling::RoundBody;
    /// let ball = RoundBody::new(1.0, 0.03, 0.4)?;
    /// // Back spin of 100 rad/s.
    /// let slide = ball.slide_of_spin(4.0, -100.0, 0.2, 10.0)?;
    /// assert!((slide.time - 1.0).abs() + (slide.speed - 2.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn slide_of_spin(
        &self,
        velocity: f64,
        omega: f64,
        friction: f64,
        gravity: f64,
    ) -> Result<SlideToRoll> {
        let velocity = finite("the velocity", velocity)?;
        let omega = finite("the angular velocity", omega)?;
        let slip = (-self.radius).mul_add(omega, velocity);
        let spin = self.inertia_factor * self.radius * omega;
        let speed = (velocity + spin) / self.pure_rolling_height();
        self.slide([velocity, slip, speed], friction, gravity)
    }

    fn slide(&self, speeds: [f64; 3], friction: f64, gravity: f64) -> Result<SlideToRoll> {
        let [velocity, slip, speed] = speeds;
        let deceleration = positive("the coefficient of friction", friction)?
            * positive("the acceleration of gravity", gravity)?;
        // Friction takes κ/(1+κ) of the slip from the velocity, and the rest goes to the rim.
        let change = self.inertia_factor / self.pure_rolling_height() * finite("the slip", slip)?;
        let time = match change {
            0.0 => 0.0,
            _ => change.abs() / deceleration,
        };
        Ok(SlideToRoll {
            time: finite("the sliding time", time)?,
            distance: finite("the sliding distance", (velocity - 0.5 * change) * time)?,
            speed: finite("the speed of rolling", speed)?,
            heat: not_negative("the heat", 0.5 * self.mass * change * slip)?,
        })
    }
}

impl Shot {
    /// The sliding that follows, as [`RoundBody::slide_to_roll`], but with the slip from the height of the stroke: nothing cancels however
    /// near the stroke is to pure rolling.
    ///
    /// # Errors
    /// As [`RoundBody::slide_to_roll`].
    ///
    /// ```
    /// use spinning_bodies::rolling::RoundBody;
    /// let ball = RoundBody::new(1.0, 0.03, 0.4)?;
    /// let slide = ball.strike(1.0, 7.0)?.slide(0.2, 10.0)?;
    /// assert!((slide.time - 1.0).abs() + (slide.speed - 5.0).abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn slide(&self, friction: f64, gravity: f64) -> Result<SlideToRoll> {
        // From the angular momentum of the stroke about the table: struck at table level, the body stops dead.
        let speed = self.velocity * self.height_over_radius / self.body.pure_rolling_height();
        let speeds = [self.velocity, self.slip, speed];
        self.body.slide(speeds, friction, gravity)
    }
}

/// The height of a stroke over the radius, if a level cue there meets the body.
fn height_on_body(height: f64) -> Result<f64> {
    within("the height of the stroke in radii", height, 0.0, 2.0)
}
