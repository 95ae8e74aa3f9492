//! A body on a table, as long as it does not leave it: Newton and Euler at the contact, the unknown force found from what it must bring about.

use super::super::door::held;
use super::super::extrapolation::{Place, followed, pieced};
use super::super::number::{Matrix, Vector, inverse, root, rotation};
use super::super::random::Random;
use super::{Scene, Sort, line, told};
use nalgebra::Matrix3;
use support::double_double::Dd;
use support::{euler, turned};

/// Attitude, Ω, velocity and place of C in the plane, and the work done against friction.
type State = [Dd; 12];

#[derive(Clone, Copy)]
enum Law {
    None,
    Viscous(Dd),
    Smoothed(Dd, Dd),
    Rolling,
}

#[derive(Clone, Copy)]
struct Body {
    mass: Dd,
    inertia: Matrix,
    inverse: Matrix,
    /// From C to the centre of the surface, and the squares of its half axes.
    centre: Vector,
    squares: Vector,
    gravity: Dd,
    law: Law,
    /// Resistance to rolling and pivoting.
    resistance: [Dd; 2],
}

fn turn_of(y: &State) -> Matrix {
    rotation([y[0], y[1], y[2], y[3]])
}

fn omega_of(y: &State) -> Vector {
    Vector::new(y[4], y[5], y[6])
}

/// What is known of the contact at a state, in body axes.
struct Contact {
    up: Vector,
    arm: Vector,
    slip: Vector,
    force: Vector,
    /// Of the normal force.
    reaction: Dd,
    omega_rate: Vector,
    couple: Vector,
}

impl Body {
    /// From C to the lowest point, and its rate, seen from the body, while the vertical turns.
    fn arm(&self, up: Vector, rate: Vector) -> [Vector; 2] {
        let size = up.dot(&self.squares.component_mul(&up)).sqrt();
        let support = self.squares.component_mul(&up) / size;
        let moved = self.squares.component_mul(&rate) / size;
        let shift = support * (support.dot(&rate) / size);
        [self.centre - support, shift - moved]
    }

    fn contact(&self, y: &State) -> Contact {
        let turn = turn_of(y);
        let (omega, up) = (omega_of(y), turn.row(2).transpose());
        let level = turn.transpose() * Vector::new(y[7], y[8], Dd::ZERO);
        let [arm, arm_rate] = self.arm(up, up.cross(&omega));
        let swing = omega.cross(&arm);
        let slip = level + swing - up * up.dot(&swing);
        let whirl = omega.cross(&swing) + omega.cross(&arm_rate);
        // Accelerations under a force at the contact and a couple: of Ω, and of the point of the body that touches.
        let free = omega.cross(&(self.inertia * omega));
        let under = |force: Vector, couple: Vector| {
            let rate = self.inverse * (arm.cross(&force) + couple - free);
            let centre = force / self.mass - up * self.gravity;
            (rate, centre + rate.cross(&arm) + whirl)
        };
        let vertical = up * up.dot(&omega);
        let [rolling, pivoting] = self.resistance;
        let resisting = -((omega - vertical) * rolling + vertical * pivoting);
        let sliding = |rubbing: Vector| {
            let per = up + rubbing;
            let rises = |n: Dd| up.dot(&under(per * n, resisting * n).1);
            let (rest, one) = (rises(Dd::ZERO), rises(Dd::from(1.0)));
            let reaction = rest / (rest - one);
            (per * reaction, reaction)
        };
        let (force, reaction) = match self.law {
            // The velocity of the point stays nil: C moves as it must. Without resistance three linear equations for the force; the couple is in proportion to its normal part.
            Law::Rolling => {
                let force = root(|force| under(force, resisting * force.dot(&up)).1);
                (force, force.dot(&up))
            }
            Law::None => sliding(Vector::zeros()),
            Law::Viscous(c) => sliding(slip * -c),
            Law::Smoothed(mu, width) => {
                sliding(slip * -(mu / (slip.dot(&slip) + width * width).sqrt()))
            }
        };
        let couple = resisting * reaction;
        Contact {
            up,
            arm,
            slip,
            force,
            reaction,
            omega_rate: under(force, couple).0,
            couple,
        }
    }

    fn rate(&self, y: &State) -> State {
        let contact = self.contact(y);
        let omega = omega_of(y);
        let [a, b, c, d] = turned([y[0], y[1], y[2], y[3]], omega.into());
        let level = contact.force - contact.up * contact.reaction;
        let [p, q, r] = contact.omega_rate.into();
        let v = self.velocity(y, &contact);
        let rolls = matches!(self.law, Law::Rolling);
        let slip = if rolls { Vector::zeros() } else { contact.slip };
        let power = level.dot(&slip) + contact.couple.dot(&omega);
        let push = turn_of(y) * level / self.mass;
        [a, b, c, d, p, q, r, push.x, push.y, v.x, v.y, -power]
    }

    /// Velocity of C in space.
    fn velocity(&self, y: &State, contact: &Contact) -> Vector {
        let swing = turn_of(y) * omega_of(y).cross(&contact.arm);
        match self.law {
            Law::Rolling => -swing,
            _ => Vector::new(y[7], y[8], -swing.z),
        }
    }

    fn row(&self, y: &State) -> Vec<Dd> {
        let contact = self.contact(y);
        let v = self.velocity(y, &contact);
        let height = -contact.up.dot(&contact.arm);
        let omega = omega_of(y);
        let kinetic = omega.dot(&(self.inertia * omega)) + self.mass * v.dot(&v);
        let energy = 0.5 * kinetic + self.mass * self.gravity * height;
        let mut row = y[..7].to_vec();
        row.extend([y[9], y[10], height, v.x, v.y, v.z, energy, y[11]]);
        row
    }

    /// The state of a start: quaternion, Ω, level velocity.
    fn state(&self, start: &[Dd]) -> State {
        let mut y = [Dd::ZERO; 12];
        y[..9].copy_from_slice(&start[..9]);
        let size = y[..4].iter().map(|&q| q * q).sum::<Dd>().sqrt();
        for q in &mut y[..4] {
            *q /= size;
        }
        y
    }

    fn rows(&self, start: &[Dd], times: &[f64], rate: f64) -> Vec<State> {
        let (start, moves) = (self.state(start), |_, _, y: &_| self.rate(y));
        pieced(moves, start, &self.scales(rate), &[], times, 1.0 / rate)
    }

    /// How long it is pressed to the table by at least a tenth of its weight; no further, for a table that pulls lets friction push.
    fn pressed(&self, start: &[Dd], until: f64, rate: f64) -> f64 {
        let times: Vec<f64> = (0..=40).map(|k| until * f64::from(k) / 40.0).collect();
        let (time, state) = (Dd::ZERO, self.state(start));
        let (scales, moves) = (self.scales(rate), |_, y: &_| self.rate(y));
        let (end, weight) = (Dd::from(until), self.mass * self.gravity);
        let lifts = |y: &State| self.contact(y).reaction / weight - 0.1;
        let from = Place { time, state };
        let leg = followed(moves, from, &scales, &times, end, 1.0 / rate, lifts);
        match leg.met {
            true => times[leg.samples.len().saturating_sub(2)],
            false => until,
        }
    }

    fn scales(&self, rate: f64) -> [f64; 12] {
        let size = self.squares[0].sqrt().value();
        let (v, energy) = (rate * size, self.mass.value() * rate * rate * size * size);
        scales(rate, v, size, energy)
    }
}

/// Those of a state.
fn scales(rate: f64, v: f64, size: f64, energy: f64) -> [f64; 12] {
    [
        1.0, 1.0, 1.0, 1.0, rate, rate, rate, v, v, size, size, energy,
    ]
}

const COLUMNS: &str = "attitude qw qx qy qz, rate omega1 omega2 omega3, length x y z, speed vx vy vz, energy energy dissipated";

/// Those of a body of this size that turns at this rate.
fn sizes(mass: f64, size: f64, rate: f64) -> Vec<(Sort, f64)> {
    vec![
        (Sort::Length, size),
        (Sort::Speed, size * rate),
        (Sort::Rate, rate),
        (Sort::Energy, mass * size * size * rate * rate),
    ]
}

/// A sphere or an ellipsoid, with its centre of mass in its middle or not.
pub fn put(r: &mut Random, law: u8) -> Scene {
    core::iter::repeat_with(|| tried(r, law))
        .flatten()
        .next()
        .expect("one that stays")
}

/// The numbers of the start, and the rate and the speed that are natural there.
fn begun(q: [f64; 4], omega: [f64; 3], rate: f64, v: [f64; 2], fast: f64) -> Vec<(f64, f64)> {
    let (q, omega, v) = (
        q.map(|q| (q, 1.0)),
        omega.map(|o| (o, rate)),
        v.map(|v| (v, fast)),
    );
    [&q[..], &omega, &v].concat()
}

fn tried(r: &mut Random, law: u8) -> Option<Scene> {
    let mass = r.scaled(1e-2, 1.0);
    let size = r.scaled(1e-2, 0.1);
    let round = r.percent(50);
    let axes = [0; 3].map(|_| {
        if round {
            size
        } else {
            size * r.within(0.7, 1.3)
        }
    });
    let centre = r.direction().map(|x| x * size * r.within(0.0, 0.25));
    let scale = mass * size * size;
    let [a, b, c] = [0; 3].map(|_| scale * r.within(0.3, 0.5));
    let skew = r.percent(40);
    let [d, e, f] = [0; 3].map(|_| {
        if skew {
            scale * r.within(-0.03, 0.03)
        } else {
            0.0
        }
    });
    let g = r.scaled(3.0, 20.0);
    let pace = (g / size).sqrt();
    let attitude = held(r.attitude());
    let spin = pace * r.scaled(0.1, 3.0);
    let omega = r.direction().map(|x| x * spin);
    // Of what rolls it follows.
    let slides = if law > 1 { 0.0 } else { size * pace };
    let [vx, vy] = [0; 2].map(|_| r.nil_or(50, |r| slides * r.within(-0.5, 0.5)));
    let mut text = format!("kind = \"table-top\"\n[body]\nmass = {mass:?}\n");
    line(&mut text, "radius", round.then_some(size));
    line(&mut text, "semi_axes", (!round).then_some(axes));
    text += &format!(
        "surface_center = {centre:?}\ninertia = [{a:?}, {b:?}, {c:?}, {d:?}, {e:?}, {f:?}]\n[initial]\nattitude = {attitude:?}\nomega = {omega:?}\nvelocity = [{vx:?}, {vy:?}, 0.0]\n[effects]\ngravity = {g:?}\n"
    );
    let law = match law {
        0 => Law::None,
        1 if r.percent(50) => {
            let c = r.scaled(1e-2, 1.0) / (size * pace);
            text += &format!("friction_law = \"viscous\"\nfriction = {c:?}\n");
            Law::Viscous(Dd::from(c))
        }
        1 => {
            let (mu, width) = (r.scaled(0.03, 0.5), size * pace * r.scaled(1e-2, 0.3));
            text += &format!(
                "friction_law = \"smoothed\"\nfriction = {mu:?}\nfriction_slip = {width:?}\n"
            );
            Law::Smoothed(Dd::from(mu), Dd::from(width))
        }
        _ => {
            text += "friction_law = \"no-slip\"\n";
            Law::Rolling
        }
    };
    let mut resistance = [0.0; 2];
    if r.percent(25) {
        resistance = [0; 2].map(|_| size / pace * r.scaled(1e-3, 0.1));
        let [rolling, pivoting] = resistance;
        text += &format!("rolling_resistance = {rolling:?}\npivoting_resistance = {pivoting:?}\n");
    }
    let inertia = Matrix3::new(a, d, e, d, b, f, e, f, c).map(Dd::from);
    let body = Body {
        mass: Dd::from(mass),
        inertia,
        inverse: inverse(&inertia),
        centre: centre.map(Dd::from).into(),
        squares: axes.map(|x| Dd::from(x) * x).into(),
        gravity: Dd::from(g),
        law,
        resistance: resistance.map(Dd::from),
    };
    let rate = pace.max(spin);
    let start = begun(attitude, omega, rate, [vx, vy], size * rate);
    let numbers: Vec<Dd> = start.iter().map(|&(x, _)| Dd::from(x)).collect();
    let until = r.scaled(0.3, 20.0) / rate;
    let span = body.pressed(&numbers, until, rate);
    if span < 0.2 / rate {
        return None;
    }
    Some(Scene {
        text,
        span,
        start,
        sizes: sizes(mass, size, rate),
        columns: told(COLUMNS),
        truth: Box::new(move |start, times| {
            let rows = body.rows(start, times, rate);
            rows.iter().map(|y| body.row(y)).collect()
        }),
    })
}

/// A ball with its centre of mass in its middle: it slides in a parabola until it rolls.
pub fn ball(r: &mut Random) -> Scene {
    let mass = r.scaled(1e-2, 1.0);
    let size = r.scaled(1e-2, 0.1);
    let kappa = r.within(0.2, 0.66);
    let g = r.scaled(3.0, 20.0);
    let mu = r.scaled(0.03, 0.6);
    let fast = (g * size).sqrt() * r.scaled(0.3, 5.0);
    let moment = kappa * mass * size * size;
    let attitude = held(r.attitude());
    let omega = r.direction().map(|x| x * fast / size);
    let [vx, vy] = [0; 2].map(|_| fast * r.within(-1.0, 1.0));
    let text = format!(
        "kind = \"table-top\"\n[body]\nmass = {mass:?}\nradius = {size:?}\ninertia = [{moment:?}, {moment:?}, {moment:?}, 0.0, 0.0, 0.0]\n[initial]\nattitude = {attitude:?}\nomega = {omega:?}\nvelocity = [{vx:?}, {vy:?}, 0.0]\n[effects]\ngravity = {g:?}\nfriction_law = \"coulomb\"\nfriction = {mu:?}\n"
    );
    let rate = fast / size;
    let start = begun(attitude, omega, rate, [vx, vy], fast);
    let [m, r_, i, g, mu] = [mass, size, moment, g, mu].map(Dd::from);
    let scales = scales(rate, fast, size, mass * fast * fast);
    let level = fast / (g * mu).value();
    Scene {
        text,
        span: level * r.scaled(0.05, 3.0),
        start,
        sizes: sizes(mass, size, rate),
        columns: told(COLUMNS),
        truth: Box::new(move |start, times| {
            let zero = Dd::ZERO;
            let body = Body {
                mass: m,
                inertia: Matrix::from_diagonal_element(i),
                inverse: Matrix::zeros(),
                centre: Vector::zeros(),
                squares: Vector::repeat(r_ * r_),
                gravity: g,
                law: Law::None,
                resistance: [zero; 2],
            };
            // Everything in the axes of space: Ω, V, x, y and the attitude.
            let begun = body.state(start);
            let spin = turn_of(&begun) * omega_of(&begun);
            let level = Vector::new(begun[7], begun[8], zero);
            let down = Vector::z() * -r_;
            let slip = level + spin.cross(&down);
            let speed = slip.dot(&slip).sqrt();
            let push = slip * -(mu * g / speed);
            let spun = down.cross(&push) * (m / i);
            // Slip falls at μg(1 + mR²/I).
            let rest = speed / (mu * g * (1.0 + m * r_ * r_ / i));
            let moves = |piece: usize, t: Dd, y: &State| {
                let (since, slides) = if piece == 0 { (t, 1.0) } else { (rest, 0.0) };
                let omega = turn_of(y).transpose() * (spin + spun * since);
                let [a, b, c, d] = turned([y[0], y[1], y[2], y[3]], omega.into());
                let v = level + push * since;
                let power = m * mu * g * (speed - speed * since / rest) * slides;
                [a, b, c, d, zero, zero, zero, zero, zero, v.x, v.y, power]
            };
            let rows = pieced(moves, begun, &scales, &[rest], times, 1.0 / rate);
            let row = |(&t, y): (&f64, &State)| {
                let t = Dd::from(t);
                let since = if t > rest { rest } else { t };
                let omega = turn_of(y).transpose() * (spin + spun * since);
                let mut y = *y;
                y[4..7].copy_from_slice(omega.as_slice());
                (y[7], y[8]) = (begun[7] + since * push.x, begun[8] + since * push.y);
                body.row(&y)
            };
            times.iter().zip(&rows).map(row).collect()
        }),
    }
}

/// Without gravity nothing presses: the free body, and C on a straight line.
pub fn free(r: &mut Random) -> Scene {
    let mass = r.scaled(1e-2, 1.0);
    let size = r.scaled(1e-2, 0.1);
    let scale = mass * size * size;
    let [a, b, c] = [0; 3].map(|_| scale * r.within(0.3, 0.5));
    let attitude = held(r.attitude());
    let omega = r.direction().map(|x| x * 10.0);
    let [vx, vy] = [0; 2].map(|_| r.within(-1.0, 1.0));
    let text = format!(
        "kind = \"table-top\"\n[body]\nmass = {mass:?}\nradius = {size:?}\ninertia = [{a:?}, {b:?}, {c:?}, 0.0, 0.0, 0.0]\n[initial]\nattitude = {attitude:?}\nomega = {omega:?}\nvelocity = [{vx:?}, {vy:?}, 0.0]\n[effects]\n"
    );
    let moments = [a, b, c].map(Dd::from);
    Scene {
        text,
        span: r.scaled(0.01, 30.0),
        start: begun(attitude, omega, 10.0, [vx, vy], 1.0),
        sizes: sizes(mass, size, 10.0),
        columns: told("attitude qw qx qy qz, rate omega1 omega2 omega3, length x y"),
        truth: Box::new(move |start, times| {
            let moves = |_: usize, _: Dd, y: &[Dd; 7]| {
                let omega = [y[4], y[5], y[6]];
                let [a, b, c, d] = turned([y[0], y[1], y[2], y[3]], omega);
                let [x, y, z] = euler(moments, omega);
                [a, b, c, d, x, y, z]
            };
            let state = core::array::from_fn(|k| start[k]);
            let scales = [1.0, 1.0, 1.0, 1.0, 10.0, 10.0, 10.0];
            let rows = pieced(moves, state, &scales, &[], times, 0.1);
            let row = |(t, y): (&f64, &[Dd; 7])| [&y[..], &[start[7] * *t, start[8] * *t]].concat();
            times.iter().zip(&rows).map(row).collect()
        }),
    }
}
