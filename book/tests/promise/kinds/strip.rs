//! A strip that falls through a fluid: the equations of Andersen, Pesavento and Wang, from one turning back to the next.

use super::super::extrapolation::{Place, followed};
use super::super::number::{Angle, PI};
use super::super::random::Random;
use super::{Scene, Sort, told};
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
        let one = Dd::from(1.0);
        let (fluid, square) = (self.added * self.displaced(), self.a * self.a);
        let own = self.factor * self.mass * square * (one + self.flat * self.flat);
        let bent = one - self.flat * self.flat;
        [
            self.mass + self.flat * self.flat * fluid,
            self.mass + fluid,
            own + fluid * square * bent * bent / Dd::from(8.0),
        ]
    }

    /// With |ω| read as `sense`·ω.
    fn rate(&self, sense: f64, y: &State) -> State {
        let [_, _, angle, u, w, omega, _] = *y;
        let (sine, cosine) = angle.sine_cosine();
        let (two, zero) = (Dd::from(2.0), Dd::ZERO);
        let [along, across, moment] = self.masses();
        let speed = (u * u + w * w).sqrt();
        let moves = speed.hi > 0.0;
        let attack = if moves { u * w / speed } else { zero };
        let circulation = two * self.a * (self.lift[1] * self.a * omega - self.lift[0] * attack);
        let aspect = if moves {
            self.drag[0] - self.drag[1] * (u * u - w * w) / (speed * speed)
        } else {
            zero
        };
        let brake = self.fluid * self.a * speed * aspect;
        let lift = self.fluid * circulation;
        let weight = self.mass * self.gravity;
        let spin = self.displaced()
            * self.a
            * self.a
            * (self.damping[0] + self.damping[1] * Dd::from(sense) * omega)
            * omega;
        let force = [
            -(weight * sine) - lift * w - brake * u,
            -(weight * cosine) + lift * u - brake * w,
        ];
        // What the added masses differ by turns the strip broadside.
        let broadside =
            (self.added * self.displaced()) * (Dd::from(1.0) - self.flat * self.flat) * u * w;
        [
            u * cosine - w * sine,
            u * sine + w * cosine,
            omega,
            (across * omega * w + force[0]) / along,
            (force[1] - along * omega * u) / across,
            -(broadside + spin) / moment,
            brake * speed * speed + spin * omega,
        ]
    }

    fn rows(&self, start: &[Dd], times: &[f64], scales: &[f64; 7]) -> Vec<Vec<Dd>> {
        let [angle, right, up, omega] = [start[0], start[1], start[2], start[3]];
        let (sine, cosine) = angle.sine_cosine();
        let zero = Dd::ZERO;
        let [u, w] = [right * cosine + up * sine, up * cosine - right * sine];
        let mut here = Place {
            time: zero,
            state: [zero, zero, angle, u, w, omega, zero],
        };
        let end = Dd::from(times[times.len() - 1]);
        let longest = scales[0] / scales[3];
        let mut rows: Vec<State> = Vec::new();
        let mut sense = omega.hi.signum();
        if omega == zero {
            // Whichever way it begins to turn.
            let short = Dd::from(1e-6 * longest);
            let begun = followed(
                |_, y| self.rate(1.0, y),
                here,
                scales,
                &[],
                short,
                longest,
                |_| Dd::from(1.0),
            );
            sense = begun.end.state[5].hi.signum();
        }
        loop {
            let way = Dd::from(sense);
            let leg = followed(
                |_, y| self.rate(sense, y),
                here,
                scales,
                &times[rows.len()..],
                end,
                longest,
                |y| y[5] * way,
            );
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
            let kinetic = Dd::from(0.5) * (along * u * u + across * w * w + moment * omega * omega);
            let energy = kinetic + self.mass * self.gravity * height;
            vec![x, height, angle, vx, vy, omega, energy, heat]
        };
        rows.iter().map(row).collect()
    }
}

fn falling(r: &mut Random, air: bool) -> Scene {
    let width = r.scaled(5e-3, 0.2);
    let area = r.scaled(2e-2, 2.0);
    let fluid = if air { r.scaled(0.3, 3.0) } else { 0.0 };
    let flat = if r.percent(50) {
        0.0
    } else {
        r.within(0.0, 0.5)
    };
    let factor = if r.percent(50) {
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
    let omega = if rest || r.percent(30) {
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
        text += &format!("{name} = {values:?}\n");
        values.map(Dd::from)
    };
    let lift = pair(r, "lift", 85, [1.7, 1.1]);
    let drag = pair(r, "drag", 85, [1.7, 1.0]);
    let damping = pair(r, "rotational_damping", 75, [0.05 * speed / a, 0.04]);
    let added = if air && r.percent(75) {
        text += "added_mass = 1.0\n";
        1.0
    } else {
        0.0
    };
    let strip = Strip {
        a: Dd::from(width) * Dd::from(0.5),
        mass: Dd::from(area) * Dd::from(width),
        fluid: Dd::from(fluid),
        flat: Dd::from(flat),
        factor: Dd::from(factor),
        gravity: Dd::from(g),
        lift,
        drag,
        damping,
        added: Dd::from(added),
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
        columns: told(&[
            (Sort::Length, "x y"),
            (Sort::Angle, "angle"),
            (Sort::Speed, "vx vy"),
            (Sort::Rate, "omega"),
            (Sort::Energy, "energy heat"),
        ]),
        truth: Box::new(move |start, times| strip.rows(start, times, &scales)),
    }
}

pub fn vacuum(r: &mut Random) -> Scene {
    falling(r, false)
}

pub fn in_air(r: &mut Random) -> Scene {
    falling(r, true)
}
