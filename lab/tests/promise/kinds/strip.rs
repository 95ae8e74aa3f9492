//! A strip that falls through a fluid: the equations of Andersen, Pesavento and Wang, from one turning back to the next.

use super::super::extrapolation::{Place, followed, pieced};
use super::super::number::{Angle, PI};
use super::super::random::Random;
use super::{Scene, Sort, line, told};
use support::double_double::Dd;

#[derive(Clone, Copy)]
struct Strip {
    /// Half the width, mass and density of the fluid, per length.
    a: Dd,
    mass: Dd,
    fluid: Dd,
    /// β, and the moment of inertia over m a²(1 + β²).
    flat: Dd,
    factor: Dd,
    gravity: Dd,
    lift: [Dd; 2],
    drag: [Dd; 2],
    damping: [Dd; 2],
    added: Dd,
}

/// x, y, θ, u, w, ω, heat.
type State = [Dd; 7];

impl Strip {
    fn displaced(&self) -> Dd {
        PI * self.fluid * self.a * self.a
    }

    /// Masses along the chord and across it, and the moment.
    fn masses(&self) -> [Dd; 3] {
        let (fluid, square) = (self.added * self.displaced(), self.a * self.a);
        let flat = self.flat * self.flat;
        let own = self.factor * self.mass * square * (1.0 + flat);
        let bent = 1.0 - flat;
        let moment = own + fluid * square * bent * bent / 8.0;
        [self.mass + flat * fluid, self.mass + fluid, moment]
    }

    /// With |ω| read as `sense`·ω.
    fn rate(&self, sense: f64, y: &State) -> State {
        let [_, _, angle, u, w, omega, _] = *y;
        let (sine, cosine) = angle.sine_cosine();
        let [along, across, moment] = self.masses();
        let speed = (u * u + w * w).sqrt();
        let (mut attack, mut aspect) = (Dd::ZERO, Dd::ZERO);
        if speed.hi > 0.0 {
            attack = u * w / speed;
            aspect = self.drag[0] - self.drag[1] * (u * u - w * w) / (speed * speed);
        }
        let circulation = 2.0 * self.a * (self.lift[1] * self.a * omega - self.lift[0] * attack);
        let brake = self.fluid * self.a * speed * aspect;
        let lift = self.fluid * circulation;
        let weight = self.mass * self.gravity;
        let damping = self.damping[0] + self.damping[1] * sense * omega;
        let spin = self.displaced() * self.a * self.a * damping * omega;
        let push = -(weight * sine) - lift * w - brake * u;
        let rise = -(weight * cosine) + lift * u - brake * w;
        // What the added masses differ by turns the strip broadside.
        let broadside = self.added * self.displaced() * (1.0 - self.flat * self.flat) * u * w;
        [
            u * cosine - w * sine,
            u * sine + w * cosine,
            omega,
            (across * omega * w + push) / along,
            (rise - along * omega * u) / across,
            -(broadside + spin) / moment,
            brake * speed * speed + spin * omega,
        ]
    }

    fn rows(&self, start: &[Dd], times: &[f64], scales: &[f64; 7]) -> Vec<Vec<Dd>> {
        let [angle, right, up, omega] = [start[0], start[1], start[2], start[3]];
        let (sine, cosine) = angle.sine_cosine();
        let zero = Dd::ZERO;
        let [u, w] = [right * cosine + up * sine, up * cosine - right * sine];
        let state = [zero, zero, angle, u, w, omega, zero];
        let mut here = Place { time: zero, state };
        let end = Dd::from(times[times.len() - 1]);
        let longest = scales[0] / scales[3];
        let mut rows: Vec<State> = Vec::new();
        let mut sense = omega.hi.signum();
        if omega == zero {
            // Whichever way it begins to turn.
            let begins = |_: usize, _: Dd, y: &State| self.rate(1.0, y);
            let soon = [1e-6 * longest];
            let begun = pieced(begins, here.state, scales, &[], &soon, longest);
            sense = begun[0][5].hi.signum();
        }
        loop {
            let (left, way) = (&times[rows.len()..], sense);
            let (rate, turns) = (|_, y: &_| self.rate(way, y), |y: &State| y[5] * way);
            let leg = followed(rate, here, scales, left, end, longest, turns);
            rows.extend(leg.samples);
            if !leg.met {
                break;
            }
            here = leg.end;
            here.state[5] = zero;
            sense = -sense;
        }
        let [along, across, moment] = self.masses();
        let row = |y: &State| {
            let [x, height, angle, u, w, omega, heat] = *y;
            let [vx, vy] = [self.rate(1.0, y)[0], self.rate(1.0, y)[1]];
            let kinetic = 0.5 * (along * u * u + across * w * w + moment * omega * omega);
            let energy = kinetic + self.mass * self.gravity * height;
            vec![x, height, angle, vx, vy, omega, energy, heat]
        };
        rows.iter().map(row).collect()
    }
}

pub fn falling(r: &mut Random, air: bool) -> Scene {
    let width = r.scaled(5e-3, 0.2);
    let area = r.scaled(2e-2, 2.0);
    let fluid = if air { r.scaled(0.3, 3.0) } else { 0.0 };
    let flat = r.nil_or(50, |r| r.within(0.0, 0.5));
    let uniform = r.percent(50);
    let factor = if uniform {
        1.0 / 3.0
    } else {
        r.within(0.2, 0.5)
    };
    let g = r.scaled(1.0, 20.0);
    let a = 0.5 * width;
    let mass = area * width;
    let speed = if air {
        (mass * g / (core::f64::consts::PI * fluid * a)).sqrt()
    } else {
        (g * a).sqrt()
    };
    let rest = r.percent(25);
    let angle = r.within(-3.0, 3.0);
    let [right, up] = [0; 2].map(|_| {
        if rest {
            0.0
        } else {
            speed * r.within(-1.0, 1.0)
        }
    });
    let still = rest || r.percent(30);
    let omega = if still {
        0.0
    } else {
        speed / a * r.within(-0.5, 0.5)
    };
    let mut text = format!(
        "kind = \"strip\"\n[body]\nwidth = {width:?}\nareal_density = {area:?}\nfluid_density = {fluid:?}\nthickness_ratio = {flat:?}\ninertia_factor = {factor:?}\n[initial]\nangle = {angle:?}\nvelocity = [{right:?}, {up:?}]\nomega = {omega:?}\n[effects]\ngravity = {g:?}\n"
    );
    let mut pair = |r: &mut Random, name: &str, often: u64, values: [f64; 2]| {
        if !air || !r.percent(often) {
            return [Dd::ZERO; 2];
        }
        line(&mut text, name, Some(values));
        values.map(Dd::from)
    };
    let lift = pair(r, "lift", 85, [1.7, 1.1]);
    let drag = pair(r, "drag", 85, [1.7, 1.0]);
    let damping = pair(r, "rotational_damping", 75, [0.05 * speed / a, 0.04]);
    let added = (air && r.percent(75)).then_some(1.0);
    line(&mut text, "added_mass", added);
    let strip = Strip {
        a: Dd::from(width) * 0.5,
        mass: Dd::from(area) * width,
        fluid: Dd::from(fluid),
        flat: Dd::from(flat),
        factor: Dd::from(factor),
        gravity: Dd::from(g),
        lift,
        drag,
        damping,
        added: Dd::from(added.unwrap_or(0.0)),
    };
    let spin = speed / a;
    let scales = [a, a, 1.0, speed, speed, spin, mass * speed * speed];
    Scene {
        text,
        span: a / speed * r.scaled(0.1, 60.0),
        start: vec![(angle, 1.0), (right, speed), (up, speed), (omega, spin)],
        sizes: vec![
            (Sort::Length, a),
            (Sort::Speed, speed),
            (Sort::Rate, spin),
            (Sort::Energy, mass * speed * speed),
        ],
        columns: told("length x y, angle angle, speed vx vy, rate omega, energy energy heat"),
        truth: Box::new(move |start, times| strip.rows(start, times, &scales)),
    }
}
