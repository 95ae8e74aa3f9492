//! Sliding in any direction over the cloth (tutorial 4.3, beyond the plane case): the massé shot.

use super::shot::RoundBody;
use crate::error::{Result, each_finite, finite, positive};

/// Velocities along the two directions of the table, m/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InPlane {
    /// Velocity V of the centre.
    pub velocity: [f64; 2],
    /// Velocity W that the centre would have if the ball rolled with its spin: (RΩ_y, −RΩ_x).
    pub rim_velocity: [f64; 2],
}

/// A slide over the cloth and the rolling that follows.
///
/// The slip u = V − W, with W the rim's velocity (rolling: W = V), keeps its direction while it decays, because friction changes
/// both V and W along it. So friction is a constant vector, and the path is a parabola that ends in a straight line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slide {
    start: InPlane,
    /// Friction per mass, m/s².
    friction: [f64; 2],
    /// Time at which rolling begins, s.
    pub time: f64,
    kappa: f64,
    /// The velocity of rolling, m/s.
    pub rolling: [f64; 2],
}

impl InPlane {
    /// Velocity of the contact point over the cloth, V − W.
    ///
    /// ```
    /// use spinning_bodies::rolling::InPlane;
    /// assert_eq!(InPlane { velocity: [7.0, 0.0], rim_velocity: [0.0, 7.0] }.slip(), [7.0, -7.0]);
    /// ```
    pub fn slip(&self) -> [f64; 2] {
        [0, 1].map(|i| self.velocity[i] - self.rim_velocity[i])
    }
}

impl RoundBody {
    /// The slide in any direction until the body rolls, under Coulomb friction, in closed form: a parabola for κ|u|/((1+κ)μg) seconds.
    ///
    /// # Errors
    /// [`Error::NotFinite`](crate::Error::NotFinite), also if a result overflows; [`Error::NotPositive`](crate::Error::NotPositive) for μ or g.
    ///
    /// ```
    /// use spinning_bodies::rolling::{InPlane, RoundBody};
    /// let ball = RoundBody::new(0.17, 0.028, 0.4)?;
    /// let start = InPlane { velocity: [7.0, 0.0], rim_velocity: [0.0, 7.0] };
    /// let slide = ball.slide_in_plane(start, 0.2, 10.0)?;
    /// // 2|u|/(7μg).
    /// assert!((slide.time - 2.0_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn slide_in_plane(&self, start: InPlane, friction: f64, gravity: f64) -> Result<Slide> {
        let strength = positive("the coefficient of friction", friction)?
            * positive("the acceleration of gravity", gravity)?;
        let strength = finite("the deceleration by friction", strength)?;
        each_finite("a velocity", start.velocity)?;
        each_finite("a velocity", start.rim_velocity)?;
        let [x, y] = start.slip();
        let size = x.hypot(y);
        let friction = match size {
            0.0 => [0.0; 2],
            size => [x, y].map(|part| -strength * (part / size)),
        };
        let kappa = self.inertia_factor;
        let rolling = [0, 1].map(|i| {
            (start.velocity[i] + kappa * start.rim_velocity[i]) / self.pure_rolling_height()
        });
        each_finite("the velocity of rolling", rolling)?;
        let time = kappa / self.pure_rolling_height() * size / strength;
        Ok(Slide {
            start,
            friction,
            time: finite("the sliding time", time)?,
            kappa,
            rolling,
        })
    }
}

impl Slide {
    /// Position of the centre, m, and the motion, at a time (s, 0 or later) after the stroke.
    ///
    /// ```
    /// use spinning_bodies::rolling::{InPlane, RoundBody};
    /// let ball = RoundBody::new(0.17, 0.028, 0.4)?;
    /// let start = InPlane { velocity: [7.0, 0.0], rim_velocity: [0.0, 7.0] };
    /// let slide = ball.slide_in_plane(start, 0.2, 10.0)?;
    /// // On a parabola the mean velocity is the mean of the first and the last.
    /// let (place, motion) = slide.at(slide.time);
    /// assert!((place[0] - 6.0 * slide.time).abs() < 1e-14 && motion.slip()[0].abs() < 1e-14);
    /// # Ok::<(), spinning_bodies::Error>(())
    /// ```
    pub fn at(&self, t: f64) -> ([f64; 2], InPlane) {
        let sliding = t.min(self.time);
        let (v, f) = (self.start.velocity, self.friction);
        let place = [0, 1]
            .map(|i| sliding * (v[i] + 0.5 * sliding * f[i]) + (t - sliding) * self.rolling[i]);
        let (mut velocity, mut rim_velocity) = (self.rolling, self.rolling);
        if t < self.time {
            velocity = [0, 1].map(|i| v[i] + t * f[i]);
            rim_velocity = [0, 1].map(|i| self.start.rim_velocity[i] - t * f[i] / self.kappa);
        }
        let motion = InPlane {
            velocity,
            rim_velocity,
        };
        (place, motion)
    }
}
