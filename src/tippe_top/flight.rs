//! Off the table and back: the free body in closed form, and the impact with which it lands.

use nalgebra::Vector3;

use super::body::ConvexBody;
use super::equations::{Numbers, Pose, Table, Yielding};
use super::friction::Friction;
use crate::error::{Result, stopped};
use crate::euler_top::FreeBody;
use crate::frame::BodyVector;
use crate::integrators::{Effort, Kept, Leg, System, Watched};
use crate::search::halved;

/// A free body whose centre of mass moves on a parabola.
#[derive(Debug, Clone)]
pub(crate) struct Flight {
    table: Table,
    /// `None` where the body is at rest, which a free top cannot be.
    turning: Option<FreeBody>,
    start: Numbers,
    takeoff: TakeOff,
}

/// The take-off of a body: what its flight needs besides the numbers of the state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TakeOff {
    /// Time, s.
    pub(crate) time: f64,
    /// Height of C, m.
    pub(crate) height: f64,
    /// Vertical velocity of C, m/s.
    pub(crate) climb: f64,
}

impl TakeOff {
    /// Height and vertical velocity of C at a time.
    pub(crate) fn at(&self, time: f64, gravity: f64) -> (f64, f64) {
        let t = time - self.time;
        let height = self.height + t * (self.climb - 0.5 * gravity * t);
        (height, self.climb - gravity * t)
    }
}

impl Flight {
    /// The flight from a state that leaves the table.
    pub(crate) fn from(table: &Table, start: &Numbers, takeoff: TakeOff) -> Result<Self> {
        let pose = Pose::of(start);
        let omega = BodyVector::from_components(pose.omega);
        let free = || FreeBody::new(table.body.inertia(), omega, pose.attitude());
        let turning = (pose.omega.amax() != 0.0).then(free).transpose()?;
        Ok(Self {
            table: *table,
            turning,
            start: *start,
            takeoff,
        })
    }

    /// The numbers of the state at a time.
    pub(crate) fn at(&self, time: f64) -> Result<Numbers> {
        let t = time - self.takeoff.time;
        let mut y = self.start;
        if let Some(turning) = &self.turning {
            let state = turning.at(t)?;
            let (q, omega) = (state.attitude.quaternion(), state.omega);
            (y[0], y[1], y[2], y[3]) = (q.w, q.i, q.j, q.k);
            (y[4], y[5], y[6]) = (omega.x(), omega.y(), omega.z());
        }
        y[9] += y[7] * t;
        y[10] += y[8] * t;
        Ok(y)
    }

    /// Height of the lowest point.
    fn gap(&self, time: f64) -> Result<f64> {
        let pose = Pose::of(&self.at(time)?);
        let (height, _) = self.takeoff.at(time, self.table.gravity);
        Ok(height + pose.up.dot(&self.table.body.arm(&pose.up)))
    }

    /// The time at which the body lands on the table, to rounding, if it does so before `until`.
    ///
    /// The speed of C and the rotation bound the speed of every point of the body, so it cannot touch before the gap would be closed at that speed. A touch
    /// that is over within a thousandth of a radian is missed.
    ///
    /// # Errors
    /// Those of `looked`, which is called with every time that the search examines; [`Error::Integration`](crate::Error::Integration) where the next time is the same double.
    pub(crate) fn landing(
        &self,
        until: f64,
        looked: impl Fn(f64) -> Result<()>,
    ) -> Result<Option<f64>> {
        let Table { body, gravity, .. } = self.table;
        // By the conservation of energy |Ω| grows by no more than the root of the ratio of the moments.
        let [least, _, greatest] = body.inertia.principal_axes().moments;
        let turning = Pose::of(&self.start).omega.norm() * (greatest / least).sqrt();
        // The greatest distance of the surface from C.
        let reach = body.center.norm() + body.surface.greatest();
        let natural = (gravity / reach).sqrt();
        let stride = 0.1 / (turning + natural);
        let start = self.takeoff.time;
        let (mut before, mut after) = (start, (start + stride).min(until));
        loop {
            looked(after)?;
            let gap = self.gap(after)?;
            // Just after the start the gap is none but for rounding.
            if gap < -16.0 * f64::EPSILON * reach {
                let open = |t| {
                    looked(t)?;
                    Ok(self.gap(t)? > 0.0)
                };
                let [_, touches] = halved([before, after], 0.0, open)?;
                return Ok(Some(touches));
            }
            if after >= until {
                return Ok(None);
            }
            before = after;
            let (height, climb) = self.takeoff.at(before, gravity);
            let squared = |drop: f64| 2.0 * gravity * drop.max(0.0) + climb * climb;
            // Nor before the parabola has brought C down to a height at which a point could touch.
            let falls = || (climb + squared(height - reach).sqrt()) / gravity;
            let aloft = (height > reach).then(falls).unwrap_or(0.0);
            let nearing = gap / (squared(height).sqrt() + turning * reach);
            after = (before + nearing.max(aloft).max(0.01 * stride)).min(until);
            if after == before {
                let reason = "the body moves so fast that doubles do not resolve its time; end the run earlier";
                return stopped(reason, before);
            }
        }
    }
}

impl Table {
    /// The state after the inelastic impact of a landing with this vertical velocity of C: the point in contact loses its normal velocity,
    /// and as much of its level velocity as friction takes.
    ///
    /// During the impact the level force is N f(v) as at any time, with v changing as the impulse p grows (Routh 1905): dv/dp = K (n + f(v)) until
    /// v·n = 0, where K is the inverse effective mass of the point in contact. So an impact can only lose energy.
    ///
    /// # Errors
    /// [`Error::Integration`](crate::Error::Integration), with the time `t`, for a point that only a pull of the table would bring to rest, and for an impact that
    /// is not finite; those of `spent`, which receives the evaluations of every step.
    pub(crate) fn landed(
        &self,
        t: f64,
        y: &Numbers,
        climb: f64,
        spent: Spent<'_>,
    ) -> Result<Numbers> {
        let pose = Pose::of(y);
        let arm = self.body.arm(&pose.up);
        let contact = pose.level + pose.up * climb + pose.omega.cross(&arm);
        // An approach of 1: what follows from it is in proportion.
        let (matrix, free, up) = (self.body.yielding(&arm), -pose.up, pose.up);
        let contact =
            Yielding { matrix, free, up }.after_impact(t, self.friction, &contact, spent)?;
        Ok(self.body.struck(y, &pose, climb, contact))
    }

    /// The state after an impact without approach: friction presses a sliding point into the table by more than the reaction lifts it (Painlevé 1895), so no
    /// reaction is great enough until the impulse has slowed the slip. The approach is rounding, and grows before it ends.
    ///
    /// # Errors
    /// As for [`landed`](Self::landed).
    pub(crate) fn jammed(&self, t: f64, y: &Numbers, spent: Spent<'_>) -> Result<Numbers> {
        let pose = Pose::of(y);
        let (_, climb) = self.body.height(&pose);
        let reach = self.body.center.norm() + self.body.surface.greatest();
        let speed = pose.level.norm() + pose.omega.norm() * reach;
        self.landed(t, y, climb - NO_SLIP * speed, spent)
    }

    /// The state after an impulse that brings the point in contact to rest.
    pub(crate) fn held(&self, y: &Numbers) -> Numbers {
        let pose = Pose::of(y);
        let (_, climb) = self.body.height(&pose);
        self.body.struck(y, &pose, climb, Vector3::zeros())
    }
}

impl Yielding {
    /// The velocity of the point in contact after an impact on the table, at the time `t`; before it, it is `contact`.
    fn after_impact(
        &self,
        t: f64,
        friction: Option<Friction>,
        contact: &Vector3<f64>,
        spent: Spent<'_>,
    ) -> Result<Vector3<f64>> {
        let Self { matrix, up, .. } = self;
        let fall = -up.dot(contact);
        let slip = contact + up * fall;
        if fall <= 0.0 {
            return Ok(slip);
        }
        match friction {
            None => {
                let push = matrix * up;
                Ok(slip + (push / up.dot(&push) - up) * fall)
            }
            Some(Friction::NoSlip) => {
                let free = *contact;
                let reason = "a landing without slip takes a level impulse where none presses the body to the table; let it slide by Coulomb's law";
                let push = Self { free, ..*self }.holding();
                match push.dot(up) < 0.0 {
                    true => stopped(reason, t),
                    false => Ok(Vector3::zeros()),
                }
            }
            Some(friction @ Friction::Coulomb(law)) => {
                let (slip, left) = self.slowed(friction, &slip, fall, spent)?;
                if left <= 0.0 {
                    return Ok(slip);
                }
                let push = self.holding();
                let normal = up.dot(&push);
                if (push - up * normal).norm() <= law.grip * normal {
                    return Ok(Vector3::zeros());
                }
                let along = self.gives_way(law.kinetic);
                let push = matrix * (up - along * law.kinetic);
                Ok(along * (push.dot(&along) / up.dot(&push) * left))
            }
            Some(friction) => Ok(self.slowed(friction, &slip, fall, spent)?.0),
        }
    }

    /// The level slip at the end of an impact, or when by Coulomb's law it vanishes, and the velocity of approach left then.
    ///
    /// The independent variable is the impulse, in units of velocity. It grows to the end, although the approach may even quicken for a time, where friction presses the body into
    /// the table: the energy at the contact only falls, and by more than the approach times the impulse. Under Coulomb's law the variable is the impulse over the
    /// slip, so that the direction of a vanishing slip turns at a finite rate, and the slip is followed by its logarithm and its direction. Once a smooth law holds
    /// the slip constant, the rest is skipped: steps short enough for a sharp law would take minutes there.
    fn slowed(
        &self,
        friction: Friction,
        slip: &Vector3<f64>,
        fall: f64,
        spent: Spent<'_>,
    ) -> Result<(Vector3<f64>, f64)> {
        let (Self { matrix, up, .. }, size) = (self, slip.norm());
        let sudden = matches!(friction, Friction::Coulomb(_));
        if sudden && size <= NO_SLIP * fall {
            return Ok((Vector3::zeros(), fall));
        }
        let across = up.cross(slip).try_normalize(0.0);
        let second = across.unwrap_or_else(|| up.cross(&Vector3::ith(up.iamin(), 1.0)).normalize());
        let first = second.cross(up);
        let unit = up.dot(&(matrix * up));
        // The remaining slip along two level directions, or its logarithm and angle; and the remaining approach.
        let level = |y: &[f64; 3]| match sudden {
            true => (first * y[1].cos() + second * y[1].sin()) * (size * y[0].exp()),
            false => first * y[0] + second * y[1],
        };
        let rate = |_: f64, y: &[f64; 3]| {
            let slip = level(y);
            let pushed = matrix * (up + friction.traction(&slip)) / unit;
            let (along, pace) = match sudden {
                true => (slip / slip.norm(), slip.norm()),
                false => (first, 1.0),
            };
            let (across, approach) = (up.cross(&along), -pushed.dot(up) * pace);
            [pushed.dot(&along), pushed.dot(&across), approach]
        };
        let margin = |_: f64, y: &[f64; 3]| {
            let slips = if sudden {
                y[0] - NO_SLIP.ln()
            } else {
                let [a, b, normal] = rate(0.0, y);
                a.hypot(b) / normal.abs() - SETTLED
            };
            (y[2] / fall).min(slips)
        };
        let least = NO_SLIP * (size + fall);
        let (from, scale) = if sudden { (0.0, 1.0) } else { (size, least) };
        let start = [from, 0.0, fall];
        if margin(0.0, &start) <= 0.0 {
            return Ok((*slip, 0.0));
        }
        let leg = Leg {
            system: &Watched(&rate, |_| spent(A_STEP), 0.0) as &dyn System<3>,
            kept: Kept::Nothing,
            start: (0.0, &start),
            scales: &[scale, scale, fall.max(SMALL * size)],
            times: &[],
            // The event ends it.
            end: f64::MAX.sqrt(),
        };
        let end = leg.follow(Some(&margin), Effort::Tolerance(IN_A_BLOW))?.end;
        let slip = level(&end);
        let over = !sudden || slip.norm() > 2.0 * NO_SLIP * size;
        Ok((slip, if over { 0.0 } else { end[2] }))
    }
}

/// Receives counts of evaluations, and may refuse them as too many.
type Spent<'a> = &'a dyn Fn(u64) -> Result<()>;

/// Evaluations of a step within an impact.
const A_STEP: u64 = 12;
/// Tolerance of a step within an impact.
const IN_A_BLOW: f64 = 1e-13;
/// A slip that changes by less than this fraction of the change in approach is held constant by a smooth law.
const SETTLED: f64 = 1e-12;
/// An approach below this fraction of the slip is known no better than to the rounding of the slip, and followed to no more.
const SMALL: f64 = 1e-2;
/// A slip below this fraction of the velocity at the beginning of an impact counts as rest.
const NO_SLIP: f64 = 1e-15;

impl ConvexBody {
    /// The state after the impulse that gives the point in contact the velocity `contact`; before it, the vertical velocity of C was `climb`.
    fn struck(&self, y: &Numbers, pose: &Pose, climb: f64, contact: Vector3<f64>) -> Numbers {
        let velocity = pose.level + pose.up * climb;
        let arm = self.arm(&pose.up);
        let change = contact - (velocity + pose.omega.cross(&arm));
        let (matrix, free, up) = (self.yielding(&arm), -change, pose.up);
        let impulse = Yielding { matrix, free, up }.holding();
        let omega = pose.omega + self.inverse * arm.cross(&impulse);
        let after = velocity + impulse / self.mass;
        let level = pose.turn * after;
        let lost =
            self.kinetic_energy(&pose.omega, &velocity) - self.kinetic_energy(&omega, &after);
        let mut y = *y;
        (y[4], y[5], y[6]) = (omega.x, omega.y, omega.z);
        (y[7], y[8]) = (level.x, level.y);
        y[11] += lost;
        y
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::{Friction, Yielding};
    use crate::rolling::Coulomb;
    use crate::tippe_top::{Regularised, Viscous};

    /// The velocity of the contact after a plane impact with this slip and approach: of a mass of 1 with the moment 1/20 about C, the contact 1 below C and 0.8 to the side.
    fn after(law: impl Into<Friction>, slip: f64, approach: f64) -> [f64; 3] {
        let yielding = Yielding {
            matrix: Matrix3::new(A, 0.0, B, 0.0, 30.0, 0.0, B, 0.0, C),
            free: -Vector3::z(),
            up: Vector3::z(),
        };
        let contact = Vector3::new(slip, 0.0, -approach);
        let after = yielding.after_impact(0.0, Some(law.into()), &contact, &|_| Ok(()));
        after.unwrap().into()
    }

    /// Entries of the inverse effective mass: along the table, mixed, and vertical.
    const A: f64 = 21.0;
    const B: f64 = 16.0;
    const C: f64 = 13.8;

    /// Routh's diagram: the slip falls by μA − B and the approach by C − μB for every unit of impulse.
    #[test]
    fn a_blow_is_followed_by_its_impulse() {
        // Without jamming: it ends still slipping.
        let mu = 0.8;
        let impulse = 0.3 / (C - mu * B);
        let [slip, ..] = after(Coulomb::new(mu).unwrap(), 5.0, 0.3);
        let off = slip - (5.0 - (mu * A - B) * impulse);
        assert!(off.abs() < 1e-14 * 5.0, "{slip}");
        // Friction presses it into the table until the slip is over; then the contact sticks.
        assert_eq!(after(Coulomb::new(1.0).unwrap(), 5.0, 1e-3), [0.0; 3]);
        // A smooth law holds the slip at the value at which its force along the table is B/A of the upward one.
        let ratio = B / A;
        for epsilon in [1e-2, 1e-7] {
            let held = epsilon * ratio / (1.0 - ratio * ratio).sqrt();
            for approach in [1e-9, 0.3, 50.0] {
                let [slip, ..] = after(Regularised::new(1.0, epsilon).unwrap(), 5.0, approach);
                let off = slip / held - 1.0;
                assert!(off.abs() < 1e-9, "{epsilon} {approach} {slip}");
            }
        }
        let [slip, ..] = after(Viscous::new(2.0).unwrap(), 5.0, 0.3);
        assert!((slip / (0.5 * ratio) - 1.0).abs() < 1e-9, "{slip}");
    }
}
