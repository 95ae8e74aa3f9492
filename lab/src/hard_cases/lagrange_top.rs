//! Lagrange's top by its cubic as printed, and by [`LagrangeTop`] and its neighbours.

use core::f64::consts::TAU;

use super::family::{Family, numbers};
use spinning_bodies::frame::{Attitude, BodyVector};
use spinning_bodies::lagrange_top::{LagrangeTop, PurePrecession, dip, pure_precession};

pub(super) const SLEEPING_TOP: Family = Family {
    name: "sleeping-top",
    paragraph: "7.5",
    quantity: "1 − cos *θ* at both turning points of a top that is almost upright",
    lost: "1 − *h*, *h* being a root of the cubic",
    printed: r"1-h_1,\;1-h_2",
    cure: r"(1-h_1)(1-h_2)=\tfrac{(L_{\text{vert}}-L_3)^2}{2I_1Mg\ell\,(h_3-1)}",
    textbook: |inputs| {
        let top = Almost::upright(numbers(inputs)?);
        let [low, high, _] = top.roots();
        Ok(vec![1.0 - low, 1.0 - high])
    },
    ours: |inputs| {
        let [i1, i3, weight, o1, o2, o3, half] = numbers(inputs)?;
        let attitude = Attitude::from_quaternion(1.0, half, 0.0, 0.0)?;
        let omega = BodyVector::new(o1, o2, o3);
        let roots = LagrangeTop::new(i1, i3, weight, omega, attitude)?.roots();
        Ok(roots.one_less.to_vec())
    },
};

pub(super) const FAST_TOP: Family = Family {
    name: "fast-top",
    paragraph: "7.4",
    quantity: "how far a fast top sinks that is let go at rest",
    lost: "the difference of two angles",
    printed: r"\arccos h_1-\theta_0",
    cure: r"2\arcsin\tfrac{h_0-h_1}{2\sin\frac12(\theta_0+\theta_1)},\;h_0-h_1=\tfrac{\sin^2\theta_0}{a+\sqrt{a^2+\sin^2\theta_0}}",
    textbook: |inputs| {
        let [i1, weight, l3, tilt] = numbers(inputs)?;
        let height = tilt.cos();
        let square = l3 * l3 / (2.0 * i1 * weight);
        // The root below h₀ of 1 − h² = l(h₀ − h).
        let low = (square - (square * square - 4.0 * (square * height - 1.0)).sqrt()) / 2.0;
        Ok(vec![low.acos() - tilt])
    },
    ours: |inputs| {
        let [i1, weight, l3, tilt] = numbers(inputs)?;
        Ok(vec![dip(i1, weight, l3, tilt)?.depth])
    },
};

pub(super) const SLOW_PRECESSION: Family = Family {
    name: "slow-precession",
    paragraph: "7.3",
    quantity: "the slow rate of pure precession of a fast top",
    lost: "*L*₃ less almost *L*₃",
    printed: r"\tfrac{L_3-\sqrt{L_3^2-4I_1Mg\ell\,h}}{2I_1h}",
    cure: r"\tfrac{2Mg\ell}{L_3+\sqrt{L_3^2-4I_1Mg\ell\,h}}",
    textbook: |inputs| {
        let [i1, weight, l3, height] = numbers(inputs)?;
        let root = (l3 * l3 - 4.0 * i1 * weight * height).sqrt();
        Ok(vec![(l3 - root) / (2.0 * i1 * height)])
    },
    ours: |inputs| {
        let [i1, weight, l3, height] = numbers(inputs)?;
        Ok(match pure_precession(i1, weight, l3, height)? {
            PurePrecession::Two { slow, .. } => vec![slow],
            _ => vec![f64::NAN],
        })
    },
};

/// A top whose quaternion (1, half, 0, 0) does not have length 1, and the constants of 7.2.
struct Almost {
    i1: f64,
    weight: f64,
    l3: f64,
    vertical: f64,
    /// E − L₃²/2I₃.
    energy: f64,
}

impl Almost {
    fn upright([i1, i3, weight, o1, o2, o3, half]: [f64; 7]) -> Self {
        let length = 1.0 + half * half;
        let (sine, cosine) = (2.0 * half / length, (1.0 - half * half) / length);
        let l3 = i3 * o3;
        Self {
            i1,
            weight,
            l3,
            vertical: i1 * o2 * sine + l3 * cosine,
            energy: 0.5 * i1 * (o1 * o1 + o2 * o2) + weight * cosine,
        }
    }

    /// The roots of (E − Mgl h)(1 − h²)2I₁ = (L_vert − L₃h)², ascending, by cosines.
    fn roots(&self) -> [f64; 3] {
        let lead = 2.0 * self.i1 * self.weight;
        let b = -(2.0 * self.i1 * self.energy + self.l3 * self.l3) / lead;
        let c = 2.0 * self.vertical * self.l3 / lead - 1.0;
        let d = (2.0 * self.i1 * self.energy - self.vertical * self.vertical) / lead;
        let p = b * b / 9.0 - c / 3.0;
        let q = b * b * b / 27.0 - b * c / 6.0 + d / 2.0;
        let third = (-q / (p * p * p).sqrt()).clamp(-1.0, 1.0).acos() / 3.0;
        [1.0, 2.0, 0.0].map(|n| 2.0 * p.sqrt() * (third + n * TAU / 3.0).cos() - b / 3.0)
    }
}
