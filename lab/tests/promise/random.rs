//! Numbers that look random and are the same on every machine. Other cases: `SEED=2 cargo test …`.

use support::Uniform;

/// Of one case.
pub struct Random(Uniform);

impl Random {
    /// For one case of one stratum: the cases do not depend on how many there are.
    pub fn of(stratum: usize, number: usize) -> Self {
        let others =
            std::env::var("SEED").map_or(0, |seed| seed.parse().expect("SEED is a number"));
        let mut seed = Uniform((others << 48) ^ ((stratum as u64) << 32 | number as u64));
        Self(Uniform(seed.bits()))
    }

    /// In 0..1.
    pub fn unit(&mut self) -> f64 {
        self.0.next()
    }

    pub fn within(&mut self, least: f64, greatest: f64) -> f64 {
        least + (greatest - least) * self.unit()
    }

    /// Evenly in the logarithm.
    pub fn scaled(&mut self, least: f64, greatest: f64) -> f64 {
        self.within(least.ln(), greatest.ln()).exp()
    }

    pub fn whole(&mut self, below: usize) -> usize {
        (self.0.bits() % below as u64) as usize
    }

    /// So often out of a hundred.
    pub fn percent(&mut self, often: u64) -> bool {
        self.0.bits() % 100 < often
    }

    /// So often out of a hundred nil, otherwise drawn.
    pub fn nil_or(&mut self, often: u64, drawn: impl FnOnce(&mut Self) -> f64) -> f64 {
        if self.percent(often) {
            0.0
        } else {
            drawn(self)
        }
    }

    pub fn sign(&mut self) -> f64 {
        if self.percent(50) { 1.0 } else { -1.0 }
    }

    pub fn direction(&mut self) -> [f64; 3] {
        loop {
            let v: [f64; 3] = core::array::from_fn(|_| self.within(-1.0, 1.0));
            let square: f64 = v.iter().map(|x| x * x).sum();
            if (0.01..1.0).contains(&square) {
                return v.map(|x| x / square.sqrt());
            }
        }
    }

    /// A quaternion of any attitude.
    pub fn attitude(&mut self) -> [f64; 4] {
        let axis = self.direction();
        let half = self.within(0.0, core::f64::consts::PI);
        let [x, y, z] = axis.map(|a| a * half.sin());
        [half.cos(), x, y, z]
    }

    /// 1e-3 … 1e-12: whole decades, or anything between.
    pub fn accuracy(&mut self) -> f64 {
        let decades = self.within(3.0, 12.0);
        if self.percent(50) {
            10.0_f64.powf(-decades)
        } else {
            10.0_f64.powi(-(decades.round() as i32))
        }
    }
}
