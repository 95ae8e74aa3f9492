//! The motion of any top by power series in double-doubles: the truth by which scenes are judged.
//!
//! Weight, pivot friction −cΩ, bearing friction −c(Ω₁, Ω₂, 0), air drag −k|Ω|Ω and a dry tip −N sgn Ω₃, each if it is there. The coefficients
//! of all series follow from one another, product by product; a step is as long as its last terms allow, and samples are taken inside
//! it. Nothing here is the library's: not the arithmetic, not the equations, not the method.

use support::double_double::Dd;
use support::multiplied;
use support::power_series::Number;

/// Highest power of a step.
const ORDER: usize = 30;
/// The last terms that are taken, as parts of the fastest rate and of 1: so small that a truth stands even where the motion amplifies it by 1e18.
const LAST: f64 = 1e-29;

/// One coefficient: a number of two words, the first also in two halves whose products are exact.
#[derive(Clone, Copy, Default)]
struct Term {
    hi: f64,
    lo: f64,
    head: f64,
    tail: f64,
}

/// The power series of one quantity.
#[derive(Clone, Copy)]
struct Series([Term; ORDER + 1]);

impl Series {
    fn new(first: Dd) -> Self {
        let mut series = Self([Term::default(); ORDER + 1]);
        series.set(0, first);
        series
    }

    fn set(&mut self, n: usize, value: Dd) {
        let scaled = 134_217_729.0 * value.hi;
        let head = scaled - (scaled - value.hi);
        self.0[n] = Term {
            hi: value.hi,
            lo: value.lo,
            head,
            tail: value.hi - head,
        };
    }

    fn get(&self, n: usize) -> Dd {
        let Term { hi, lo, .. } = self.0[n];
        Dd { hi, lo }
    }

    /// The value at a time from the start of the step.
    fn at(&self, t: Dd) -> Dd {
        (0..=ORDER)
            .rev()
            .fold(Dd::ZERO, |sum, n| sum * t + self.get(n))
    }
}

/// Σ aₘ bₙ₋ₘ over m = from … n − from: products exact, their sum with what rounding leaves of it.
fn product_from(from: usize, a: &Series, b: &Series, n: usize) -> Dd {
    let (mut sum, mut left) = (0.0, 0.0);
    let forward = a.0[from..=n - from].iter();
    for (x, y) in forward.zip(b.0[from..=n - from].iter().rev()) {
        let product = x.hi * y.hi;
        let exact =
            ((x.head * y.head - product) + x.head * y.tail + x.tail * y.head) + x.tail * y.tail;
        let next = sum + product;
        let carried = next - sum;
        let lost = (sum - (next - carried)) + (product - carried);
        left += lost + (exact + (x.hi * y.lo + x.lo * y.hi));
        sum = next;
    }
    let hi = sum + left;
    Dd {
        hi,
        lo: left - (hi - sum),
    }
}

fn product(a: &Series, b: &Series, n: usize) -> Dd {
    product_from(0, a, b, n)
}

/// A top, all its numbers as they were given.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Top {
    pub moments: [f64; 3],
    pub mass: f64,
    pub center: [f64; 3],
    pub gravity: Option<f64>,
    pub frictions: Frictions,
}

pub type Frictions = [Option<f64>; 4];

pub const PIVOT: usize = 0;
pub const BEARING: usize = 1;
pub const AIR: usize = 2;
pub const TIP: usize = 3;

/// Ω along the body's axes and the quaternion of the attitude.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Whole {
    pub omega: [Dd; 3],
    pub attitude: [Dd; 4],
}

impl Whole {
    /// From Ω and from a quaternion, which is brought to norm 1.
    pub fn new(omega: [Dd; 3], attitude: [f64; 4]) -> Self {
        let attitude = attitude.map(Dd::from);
        let norm = attitude.map(|x| x * x).into_iter().sum::<Dd>().sqrt();
        Self {
            omega,
            attitude: attitude.map(|x| x / norm),
        }
    }

    pub fn speed(&self) -> f64 {
        norm(self.omega.map(Dd::value))
    }

    /// Where the other is, seen from here: the angle between the attitudes about each axis of the body (radians), and the difference of Ω.
    pub fn to(&self, other: &Self) -> [f64; 6] {
        let [a, b, c, d] = self.attitude;
        let turn = multiplied([a, -b, -c, -d], other.attitude).map(Dd::value);
        let [even, x, y, z] = if turn[0] < 0.0 {
            turn.map(|x| -x)
        } else {
            turn
        };
        let sin = norm([x, y, z]);
        let stretch = if sin > 0.0 {
            2.0 * sin.atan2(even) / sin
        } else {
            2.0
        };
        let [u, v, w] = [0, 1, 2].map(|k| (other.omega[k] - self.omega[k]).value());
        [x * stretch, y * stretch, z * stretch, u, v, w]
    }
}

fn norm(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}

/// A motion at the times asked for.
#[derive(Debug, Clone)]
pub struct Motion {
    /// In the order of the times.
    pub states: Vec<Whole>,
    /// The greatest |Ω| from the first of the times to the last, the start among them.
    pub fastest: f64,
}

impl Top {
    /// MgC, exactly.
    fn lever(&self) -> [Dd; 3] {
        let g = Dd::from(self.gravity.unwrap_or(0.0));
        self.center.map(|c| Dd::from(self.mass) * c * g)
    }

    /// Ω with this angular momentum; none about an axis without moment.
    pub fn omega_of(&self, l: [f64; 3]) -> [Dd; 3] {
        core::array::from_fn(|k| match self.moments[k] {
            0.0 => Dd::ZERO,
            moment => Dd::from(l[k]) / moment,
        })
    }

    pub fn lossy(&self) -> bool {
        self.frictions.iter().any(Option::is_some)
    }

    /// The rate that the weight alone would give, rad/s.
    pub fn fall(&self) -> f64 {
        let least = self.moments.iter().fold(f64::INFINITY, |a, &b| a.min(b));
        (2.0 * norm(self.lever().map(Dd::value)) / least).sqrt()
    }

    /// The motion at these times (s, in any order, before and after 0).
    pub fn motion(&self, start: &Whole, times: &[f64]) -> Motion {
        self.motion_to(start, times, LAST)
    }

    /// By how much the motion may be off, radians or parts of `unit`: three times as much as steps of other lengths make of the roundings, at these times
    /// or on the way. Runs that have parted may meet again, as beside a separatrix, where all of them rest for most of the time.
    pub fn doubt(&self, start: &Whole, times: &[f64], unit: f64) -> f64 {
        const ON_THE_WAY: u32 = 256;
        let parts = (1..=ON_THE_WAY).map(|k| f64::from(k) / f64::from(ON_THE_WAY));
        let times: Vec<f64> = parts
            .flat_map(|part| times.iter().map(move |t| t * part))
            .collect();
        let fine = self.motion(start, &times);
        let apart = [5.0, 30.0, 180.0].map(|longer| {
            let other = self.motion_to(start, &times, longer * LAST);
            let pairs = fine.states.iter().zip(&other.states);
            let apart = pairs.map(|(a, b)| {
                let [x, y, z, u, v, w] = a.to(b);
                norm([x, y, z]).max(norm([u, v, w]) / unit)
            });
            apart.fold(0.0, f64::max)
        });
        3.0 * apart.into_iter().fold(0.0, f64::max)
    }

    fn motion_to(&self, start: &Whole, times: &[f64], last: f64) -> Motion {
        let mut states = vec![*start; times.len()];
        let mut fastest = start.speed();
        let mut order: Vec<usize> = (0..times.len()).filter(|&i| times[i] != 0.0).collect();
        order.sort_by(|&i, &j| times[i].abs().total_cmp(&times[j].abs()));
        let (after, before): (Vec<usize>, Vec<usize>) =
            order.into_iter().partition(|&i| times[i] > 0.0);
        for side in [after, before] {
            let mut walk = Walk::new(self, start, last);
            for i in side {
                states[i] = walk.to(times[i]);
                fastest = fastest.max(states[i].speed());
            }
            fastest = fastest.max(walk.fastest);
        }
        Motion { states, fastest }
    }

    /// By how much a small change of the start has grown at the times asked for: the largest singular value of the six by six matrix, angles in
    /// radians, Ω as parts of `unit`; from motions that start a little beside this one.
    pub fn growth(&self, start: &Whole, times: &[f64], unit: f64) -> f64 {
        const BESIDE: f64 = 1e-22;
        let here = self.motion(start, times);
        let columns: Vec<Vec<[f64; 6]>> = (0..6)
            .map(|k| {
                let mut other = *start;
                if k < 3 {
                    let mut turn = [1.0, 0.0, 0.0, 0.0].map(Dd::from);
                    turn[k + 1] = Dd::from(0.5 * BESIDE);
                    other.attitude = multiplied(start.attitude, turn);
                } else {
                    other.omega[k - 3] = other.omega[k - 3] + BESIDE * unit;
                }
                let there = self.motion(&other, times);
                let pairs = here.states.iter().zip(&there.states);
                pairs
                    .map(|(a, b)| {
                        let [x, y, z, u, v, w] = a.to(b);
                        // Beside rest air drag is not smooth, and its series tell nothing: the other directions do.
                        let grown = [x, y, z, u / unit, v / unit, w / unit].map(|x| x / BESIDE);
                        grown.map(|x| if x.is_nan() { 0.0 } else { x })
                    })
                    .collect()
            })
            .collect();
        let grown = (0..times.len()).map(|n| {
            let matrix: [[f64; 6]; 6] = core::array::from_fn(|k| columns[k][n]);
            largest_singular(&matrix)
        });
        grown.fold(1.0, f64::max)
    }
}

/// By the power method on MᵀM; the rows of `matrix` are the columns of M.
fn largest_singular(matrix: &[[f64; 6]; 6]) -> f64 {
    let mut v = [1.0_f64, 0.9, 1.1, 0.8, 1.2, 0.7];
    let mut size = 0.0;
    for _ in 0..200 {
        let image: [f64; 6] = core::array::from_fn(|i| (0..6).map(|k| matrix[k][i] * v[k]).sum());
        let back: [f64; 6] =
            core::array::from_fn(|k| (0..6).map(|i| matrix[k][i] * image[i]).sum());
        let length = |v: &[f64; 6]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        size = length(&image) / length(&v);
        let whole = length(&back);
        if whole == 0.0 || !whole.is_finite() {
            return size;
        }
        v = back.map(|x| x / whole);
    }
    size
}

/// A motion on its way in one direction of time.
struct Walk<'a> {
    top: &'a Top,
    lever: [Dd; 3],
    inverse: [Dd; 3],
    /// The rate by which terms are judged, and the last that are taken.
    unit: f64,
    last: f64,
    /// The step that is being walked: from when, how far, and the series. Their time is `pace` times as fast, a power of two near the rate.
    begin: Dd,
    reach: Dd,
    pace: Dd,
    terms: Terms,
    /// The dry tip has stopped the spin, or will at the end of this step.
    stopped: bool,
    stopping: bool,
    fastest: f64,
}

struct Terms {
    l: [Series; 3],
    omega: [Series; 3],
    up: [Series; 3],
    q: [Series; 4],
    /// |Ω|², |Ω|; for a body that starts from rest those of Ω/t.
    square: Series,
    speed: Series,
}

impl<'a> Walk<'a> {
    fn new(top: &'a Top, start: &Whole, last: f64) -> Self {
        let l = core::array::from_fn(|k| start.omega[k] * top.moments[k]);
        Self {
            top,
            lever: top.lever(),
            inverse: top.omega_of([1.0; 3]),
            unit: start.speed().hypot(top.fall()),
            last,
            begin: Dd::ZERO,
            reach: Dd::ZERO,
            pace: Dd::from(1.0),
            terms: Terms::at(start, l),
            stopped: start.omega[2] == Dd::ZERO,
            stopping: false,
            fastest: start.speed(),
        }
    }

    /// The state at this time, further than those before.
    fn to(&mut self, time: f64) -> Whole {
        if self.unit == 0.0 {
            return self.terms.whole(Dd::ZERO);
        }
        loop {
            if self.reach == Dd::ZERO {
                self.expand(time.signum());
            }
            let along = (Dd::from(time) - self.begin) * self.pace;
            if along.abs() <= self.reach {
                return self.terms.whole(along);
            }
            self.advance(if time < 0.0 { -self.reach } else { self.reach });
        }
    }

    /// On to the end of the step.
    fn advance(&mut self, step: Dd) {
        let mut state = self.terms.whole(step);
        let mut l = core::array::from_fn(|k| self.terms.l[k].at(step));
        if self.stopping {
            (l[2], state.omega[2]) = (Dd::ZERO, Dd::ZERO);
            (self.stopping, self.stopped) = (false, true);
        }
        self.terms = Terms::at(&state, l);
        self.begin += step / self.pace;
        self.reach = Dd::ZERO;
        self.fastest = self.fastest.max(state.speed());
        self.unit = self.unit.max(state.speed());
    }

    /// All the series from where the motion is, and how far they reach.
    fn expand(&mut self, sense: f64) {
        let top = self.top;
        let [i1, i2, i3] = self.inverse;
        let [pivot, bearing, air, tip] = top.frictions;
        let dry = match tip {
            Some(torque) if !self.stopped => torque.copysign(self.terms.l[2].get(0).hi),
            _ => 0.0,
        };
        let [c1, c2, c3] = self.lever;
        let heavy = top.gravity.is_some();
        self.pace = Dd::from(self.unit.log2().round().exp2());
        let pace = self.pace;
        let Terms {
            l,
            omega,
            up,
            q,
            square,
            speed,
        } = &mut self.terms;
        // From rest |Ω| is |t| times a smooth function: the series of Ω/t, one place lower.
        let rest = air.is_some() && omega.iter().all(|o| o.get(0) == Dd::ZERO);
        for n in 0..ORDER {
            for (o, (l, i)) in omega.iter_mut().zip(l.iter().zip(self.inverse)) {
                o.set(n, l.get(n) * i);
            }
            let mut torque = [
                product(&l[1], &l[2], n) * (i3 - i2),
                product(&l[2], &l[0], n) * (i1 - i3),
                product(&l[0], &l[1], n) * (i2 - i1),
            ];
            if heavy {
                let [z1, z2, z3] = [0, 1, 2].map(|k| up[k].get(n));
                let weight = [z2 * c3 - z3 * c2, z3 * c1 - z1 * c3, z1 * c2 - z2 * c1];
                torque = core::array::from_fn(|k| torque[k] + weight[k]);
                let cross = |a: usize, b: usize| {
                    product(&up[a], &omega[b], n) - product(&up[b], &omega[a], n)
                };
                let turned = [cross(1, 2), cross(2, 0), cross(0, 1)];
                for (z, turned) in up.iter_mut().zip(turned) {
                    z.set(n + 1, turned / (pace * (n + 1) as f64));
                }
            }
            for (friction, axes) in [(pivot, 3), (bearing, 2)] {
                if let Some(c) = friction {
                    for (t, o) in torque.iter_mut().zip(omega.iter()).take(axes) {
                        *t -= c * o.get(n);
                    }
                }
            }
            if n == 0 {
                torque[2] = torque[2] - dry;
            }
            if let Some(k) = air {
                let drag = if rest {
                    drag_from_rest(omega, square, speed, n).map(|d| d * sense)
                } else {
                    drag(omega, square, speed, n)
                };
                torque = core::array::from_fn(|j| torque[j] - k * drag[j]);
            }
            let p = |a: usize, b: usize| product(&q[a], &omega[b], n);
            let spun = [
                -p(1, 0) - p(2, 1) - p(3, 2),
                p(0, 0) + p(2, 2) - p(3, 1),
                p(0, 1) + p(3, 0) - p(1, 2),
                p(0, 2) + p(1, 1) - p(2, 0),
            ];
            let part = 1.0 / (pace * (n + 1) as f64);
            for (l, t) in l.iter_mut().zip(torque) {
                l.set(n + 1, t * part);
            }
            for (q, s) in q.iter_mut().zip(spun) {
                q.set(n + 1, s * part * 0.5);
            }
        }
        for (o, (l, i)) in omega.iter_mut().zip(l.iter().zip(self.inverse)) {
            o.set(ORDER, l.get(ORDER) * i);
        }
        let unit = self.unit;
        let last = |n: usize| {
            let rates = omega.iter().map(|o| o.get(n).hi.abs() / unit);
            let turns = q.iter().map(|q| q.get(n).hi.abs());
            rates.chain(turns).fold(0.0, f64::max)
        };
        let reach = [ORDER - 1, ORDER].map(|n| (self.last / last(n)).powf(1.0 / n as f64));
        // Of a body at rest in balance there are no terms.
        let reach = reach[0].min(reach[1]).min(1e300);
        assert!(reach > 0.0, "the series have no reach: {top:?}");
        self.reach = Dd::from(reach);
        if dry != 0.0 {
            self.stop_within(sense);
        }
    }

    /// Where the spin comes to rest within the step, the step ends.
    fn stop_within(&mut self, sense: f64) {
        let spin = &self.terms.l[2];
        let end = spin.at(self.reach * sense).hi;
        if spin.get(0).hi * end > 0.0 {
            return;
        }
        // The spin falls at least as fast as the dry torque makes it: Newton's rule finds where.
        let mut root = Dd::ZERO;
        for _ in 0..12 {
            let slope = (1..=ORDER)
                .rev()
                .fold(Dd::ZERO, |sum, n| sum * root + n as f64 * spin.get(n));
            root -= spin.at(root) / slope;
        }
        self.reach = root.abs();
        self.stopping = true;
    }
}

/// The nth coefficient of |Ω|Ω.
fn drag(omega: &[Series; 3], square: &mut Series, speed: &mut Series, n: usize) -> [Dd; 3] {
    let sum = omega.iter().fold(Dd::ZERO, |s, o| s + product(o, o, n));
    square.set(n, sum);
    root_term(square, speed, n);
    [0, 1, 2].map(|k| product(speed, &omega[k], n))
}

/// The same of a motion that starts from rest: with Ω = t w it is t²|w|w, for positive t.
fn drag_from_rest(w: &[Series; 3], square: &mut Series, speed: &mut Series, n: usize) -> [Dd; 3] {
    if n < 2 {
        return [Dd::ZERO; 3];
    }
    // The nth coefficient needs those of w up to n - 2, which are those of Ω up to n - 1.
    let w = w.map(|o| {
        let mut shifted = Series::new(Dd::ZERO);
        for m in 0..n - 1 {
            shifted.set(m, o.get(m + 1));
        }
        shifted
    });
    let sum = w.iter().fold(Dd::ZERO, |s, o| s + product(o, o, n - 2));
    square.set(n - 2, sum);
    root_term(square, speed, n - 2);
    [0, 1, 2].map(|k| product(speed, &w[k], n - 2))
}

/// The nth coefficient of the root of a series.
fn root_term(square: &Series, root: &mut Series, n: usize) {
    if n == 0 {
        root.set(0, square.get(0).sqrt());
        return;
    }
    let first = root.get(0);
    if first == Dd::ZERO {
        root.set(n, Dd::ZERO);
        return;
    }
    let inner = if n > 1 {
        product_from(1, root, root, n)
    } else {
        Dd::ZERO
    };
    root.set(n, (square.get(n) - inner) / (first + first));
}

/// The vertical, seen from the body, of a quaternion of length 1.
pub fn vertical<T: Number>([w, x, y, z]: [T; 4]) -> [T; 3] {
    let two = T::from(2.0);
    [
        two * (x * z - w * y),
        two * (y * z + w * x),
        (w * w + z * z) - (x * x + y * y),
    ]
}

impl Terms {
    fn at(state: &Whole, l: [Dd; 3]) -> Self {
        Self {
            l: l.map(Series::new),
            omega: state.omega.map(Series::new),
            up: vertical(state.attitude).map(Series::new),
            q: state.attitude.map(Series::new),
            square: Series::new(Dd::ZERO),
            speed: Series::new(Dd::ZERO),
        }
    }

    fn whole(&self, along: Dd) -> Whole {
        Whole {
            omega: [0, 1, 2].map(|k| self.omega[k].at(along)),
            attitude: [0, 1, 2, 3].map(|k| self.q[k].at(along)),
        }
    }
}
