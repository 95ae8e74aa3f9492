//! Stand-in until the exact motion is there; deleted then.
#![allow(missing_docs, dead_code)]
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use spinning_bodies::Result;
use spinning_bodies::frame::{Attitude, BodyVector};

#[derive(Debug, Clone, Copy)]
pub struct State {
    pub omega: BodyVector,
    pub angular_momentum: BodyVector,
    pub attitude: Attitude,
}

#[derive(Debug, Clone, Copy)]
pub struct EulerTop {
    moments: Vector3<f64>,
    l: Vector3<f64>,
    attitude: Attitude,
}

impl EulerTop {
    pub fn from_omega(moments: [f64; 3], omega: BodyVector, attitude: Attitude) -> Result<Self> {
        let moments: Vector3<f64> = moments.into();
        Ok(Self {
            moments,
            l: moments.component_mul(&omega.components()),
            attitude,
        })
    }

    fn rate(&self, l: &Vector3<f64>, q: &Quaternion<f64>) -> (Vector3<f64>, Quaternion<f64>) {
        let w = l.component_div(&self.moments);
        (l.cross(&w), q * Quaternion::from_imag(w) * 0.5)
    }

    pub fn at(&self, t: f64) -> Result<State> {
        let n = (t.abs() / 3e-2).ceil().max(1.0);
        let h = t / n;
        let (mut l, mut q) = (self.l, self.attitude.quaternion().into_inner());
        for _ in 0..n as usize {
            let (a, qa) = self.rate(&l, &q);
            let (b, qb) = self.rate(&(l + a * (h / 2.0)), &(q + qa * (h / 2.0)));
            let (c, qc) = self.rate(&(l + b * (h / 2.0)), &(q + qb * (h / 2.0)));
            let (d, qd) = self.rate(&(l + c * h), &(q + qc * h));
            l += (a + b * 2.0 + c * 2.0 + d) * (h / 6.0);
            q += (qa + qb * 2.0 + qc * 2.0 + qd) * (h / 6.0);
        }
        let q = UnitQuaternion::from_quaternion(q);
        Ok(State {
            omega: BodyVector::from_components(l.component_div(&self.moments)),
            angular_momentum: BodyVector::from_components(l),
            attitude: Attitude::from_quaternion(q.w, q.i, q.j, q.k)?,
        })
    }

    pub fn states(
        &self,
        times: impl IntoIterator<Item = f64>,
    ) -> impl Iterator<Item = Result<State>> {
        let top = *self;
        times.into_iter().map(move |t| top.at(t))
    }

    pub fn energy(&self) -> f64 {
        self.l.component_div(&self.moments).dot(&self.l) / 2.0
    }

    pub fn period(&self) -> f64 {
        let [i1, i2, i3]: [f64; 3] = self.moments.into();
        let s = self.l.component_mul(&self.l);
        let d1 = s.y * (i2 - i1) / i2 + s.z * (i3 - i1) / i3;
        let d3 = s.x * (i3 - i1) / i1 + s.y * (i3 - i2) / i2;
        let d2 = s.z * (i3 - i2) / i3 - s.x * (i2 - i1) / i1;
        let (rate, mc) = if d2 > 0.0 {
            (
                ((i3 - i2) * d1 / (i1 * i2 * i3)).sqrt(),
                (i3 - i1) * d2 / ((i3 - i2) * d1),
            )
        } else {
            (
                ((i2 - i1) * d3 / (i1 * i2 * i3)).sqrt(),
                (i3 - i1) * -d2 / ((i2 - i1) * d3),
            )
        };
        let (mut a, mut g) = (1.0_f64, mc.sqrt());
        for _ in 0..12 {
            (a, g) = ((a + g) / 2.0, (a * g).sqrt());
        }
        4.0 * (core::f64::consts::FRAC_PI_2 / a) / rate
    }

    pub fn mean_precession_rate(&self) -> f64 {
        // The azimuth about L of the axis that stays nearest to it, over a period.
        let period = self.period();
        let (n, e) = (400, 2.0 * self.energy());
        let s = |k: usize| {
            let state = self.at(period * k as f64 / n as f64).expect("finite");
            let (l, w) = (state.angular_momentum, state.omega);
            let l2 = l.dot(&l);
            l2.sqrt() * (e - l.z() * w.z()) / (l2 - l.z() * l.z())
        };
        (0..n).map(s).sum::<f64>() / n as f64
    }
}
