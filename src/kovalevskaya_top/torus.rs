//! The torus of a motion, and a direction across z that is nowhere broken off (8.2).

use core::f64::consts::TAU;

use nalgebra::{Complex, Vector3};

use super::constants::{Constants, Phase};
use super::exact::Exact;
use super::fourier::Grid;

type Vector = Vector3<f64>;

/// States over u₁ and u₂, the *halves* of the two uniform phases: everything returns when one of these goes round.
pub(super) struct Torus {
    pub grid: Grid,
    states: Vec<Phase>,
    /// du/dt.
    pub rates: [f64; 2],
}

impl Torus {
    /// States at every place of a grid. Those of a coarser grid before it are taken over, and half of them follow from the other half
    /// where a whole turn of a phase, half of one of u, gives the same state or its mirror image.
    pub fn sample(
        constants: &Constants,
        exact: &Exact,
        grid: Grid,
        coarser: Option<&Self>,
    ) -> Self {
        let [rows, columns] = grid.size;
        let known = |i: usize, j: usize| {
            let coarser = coarser?;
            let [above, below] = [rows / coarser.grid.size[0], columns / coarser.grid.size[1]];
            let there = i.is_multiple_of(above) && j.is_multiple_of(below);
            there.then(|| coarser.states[coarser.grid.place(i / above, j / below)])
        };
        let turn = Turn::of(&exact.separation.ends);
        let mut states: Vec<Phase> = Vec::with_capacity(grid.count());
        for place in 0..grid.count() {
            let [i, j] = [place / columns, place % columns];
            let twin = turn.and_then(|Turn { turned, reversed }| {
                let [down, right] = [
                    rows / 2 * usize::from(turned[0]),
                    columns / 2 * usize::from(turned[1]),
                ];
                let [p, q, r, z1, z2, z3] = *states.get(grid.place(i + down, j + right))?;
                Some(if reversed {
                    [p, -q, -r, z1, -z2, -z3]
                } else {
                    [p, q, r, z1, z2, z3]
                })
            });
            let phase = |i: usize, n: usize| 2.0 * TAU * i as f64 / n as f64;
            let fresh = || exact.state_on_torus(constants, [phase(i, rows), phase(j, columns)]);
            states.push(twin.or_else(|| known(i, j)).unwrap_or_else(fresh));
        }
        Self {
            grid,
            states,
            rates: exact.separation.frequencies().map(|n| 0.5 * TAU * n),
        }
    }

    fn up(&self, place: usize) -> Vector {
        let [.., x, y, z] = self.states[place];
        Vector::new(x, y, z)
    }

    // ANCHOR: directions
    /// A unit vector e ⟂ z at every place, smooth all round; none if the grid is too coarse to tell.
    ///
    /// A direction fixed in the body, less its part along z, would break off wherever z comes upon it. So e is carried: from place to
    /// place by the shortest turn that brings z along, once round u₁, and from there once round u₂ for each u₁. It comes back
    /// turned by some angle about z; that angle is spread evenly over the way.
    ///
    /// It can always be done. The angle of the second way must return to itself as u₁ goes round, not 2π further: it is the area that z
    /// encloses on the sphere, and the area that the whole torus covers, counted with its sign, is zero. (The torus is Lagrangian
    /// for the symplectic form dα + L_vert·area, α being single-valued.)
    pub fn directions(&self) -> Option<Vec<Vector>> {
        let [rows, columns] = self.grid.size;
        let column: Vec<usize> = (0..rows).map(|i| self.grid.place(i, 0)).collect();
        let (mut starts, missing) = self.carried_round(&column, any_across(&self.up(0)));
        self.spread(&column, &mut starts, missing);
        let mut directions = Vec::with_capacity(self.grid.count());
        let mut angles: Vec<f64> = Vec::with_capacity(rows);
        for (i, start) in starts.into_iter().enumerate() {
            let row: Vec<usize> = (0..columns).map(|j| self.grid.place(i, j)).collect();
            let (mut carried, missing) = self.carried_round(&row, start);
            // The branch of the angle that continues the row before.
            let missing = missing + nearest_turns(angles.last().unwrap_or(&missing) - missing);
            self.spread(&row, &mut carried, missing);
            angles.push(missing);
            directions.append(&mut carried);
        }
        let round = angles.windows(2).map(|pair| pair[1] - pair[0]);
        let closes = nearest_turns(angles[rows - 1] - angles[0]) == 0.0;
        (closes && round.fold(0.0, |m: f64, x| m.max(x.abs())) < 2.0).then_some(directions)
    }
    // ANCHOR_END: directions

    /// A vector carried along a closed way: what it is at each place, and by what angle it has to be turned back in the end.
    fn carried_round(&self, way: &[usize], start: Vector) -> (Vec<Vector>, f64) {
        let mut carried = vec![start];
        for pair in way.windows(2) {
            let next = transported(
                &carried[carried.len() - 1],
                &self.up(pair[0]),
                &self.up(pair[1]),
            );
            carried.push(next);
        }
        let (home, last) = (self.up(way[0]), self.up(way[way.len() - 1]));
        let back = transported(&carried[carried.len() - 1], &last, &home);
        (carried, angle_about(&home, &back, &start))
    }

    fn spread(&self, way: &[usize], carried: &mut [Vector], missing: f64) {
        let share = missing / way.len() as f64;
        for (n, (place, e)) in way.iter().zip(carried).enumerate() {
            *e = turned(e, &self.up(*place), share * n as f64);
        }
    }

    /// The same directions, turned about z by such whole multiples of u₁ and u₂ that the body's third axis, seen from e, goes round as little as can be.
    ///
    /// Any multiples would leave them smooth; this settles which rate is the mean precession.
    pub fn following_the_third_axis(&self, directions: &mut [Vector]) {
        let grid = self.grid;
        let [rows, columns] = grid.size;
        let bearing: Vec<Complex<f64>> = directions
            .iter()
            .enumerate()
            .map(|(place, e)| Complex::new(e.z, self.up(place).cross(e).z))
            .collect();
        let change = |from: usize, to: usize| (bearing[to] * bearing[from].conj()).arg();
        let turns = |sum: f64, ways: usize| (sum / (TAU * ways as f64)).round();
        let places = || (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
        let along_first: f64 = places()
            .map(|(i, j)| change(grid.place(i, j), grid.place(i + 1, j)))
            .sum();
        let along_second: f64 = places()
            .map(|(i, j)| change(grid.place(i, j), grid.place(i, j + 1)))
            .sum();
        let [m1, m2] = [turns(along_first, columns), turns(along_second, rows)];
        for (i, j) in places() {
            let place = grid.place(i, j);
            let ahead = m1 * i as f64 / rows as f64 + m2 * j as f64 / columns as f64;
            directions[place] = turned(&directions[place], &self.up(place), TAU * ahead);
        }
    }

    // ANCHOR: precession
    /// dχ/dt at every place, χ being the angle about the vertical at which e is seen from space: ⟨z×e, de/dt⟩ + ⟨Ω, z⟩.
    ///
    /// de/dt along the body's axes from its Fourier series, e₁ + ie₂ and e₃: ik·du/dt times each coefficient.
    pub fn precession(
        &self,
        directions: &[Vector],
        coefficients: &[Vec<Complex<f64>>; 2],
    ) -> Vec<f64> {
        let rates = coefficients.each_ref().map(|list| {
            let derivative: Vec<_> = list
                .iter()
                .enumerate()
                .map(|(place, c)| c * Complex::new(0.0, self.rate(place)))
                .collect();
            self.grid.ordinates(&derivative)
        });
        directions
            .iter()
            .enumerate()
            .map(|(place, e)| {
                let [p, q, r, ..] = self.states[place];
                let up = self.up(place);
                let rate = Vector::new(rates[0][place].re, rates[0][place].im, rates[1][place].re);
                up.cross(e).dot(&rate) + up.dot(&Vector::new(p, q, r))
            })
            .collect()
    }
    // ANCHOR_END: precession

    /// k·du/dt of the coefficient at a place.
    pub fn rate(&self, place: usize) -> f64 {
        let [k1, k2] = self.grid.waves(place).map(f64::from);
        k1 * self.rates[0] + k2 * self.rates[1]
    }
}

/// The multiple of 2π next to an angle.
fn nearest_turns(angle: f64) -> f64 {
    TAU * (angle / TAU).round()
}

/// A turn of the first or the second phase or both after which a state is the same, or `reversed`: (p, −q, −r, z₁, −z₂, −z₃), the body
/// half a turn further about axis 1.
#[derive(Clone, Copy)]
struct Turn {
    turned: [bool; 2],
    reversed: bool,
}

impl Turn {
    // ANCHOR: turns
    /// The first such turn, if there is one, from which roots are A, B and C.
    ///
    /// A turn of f₁ changes the sign of √(s₁−A) and √(s₁−B), a turn of f₂ those of √(s₂−C) and of cos(f₂/2). In the linear system for
    /// p and q only the three roots of the cubic count, and all three signs together are the sign of q.
    fn of(&[a, b, c]: &[usize; 3]) -> Option<Self> {
        let of = |turned: [bool; 2]| {
            let mut signs = [false; 3];
            for (end, turns) in [(a, turned[0]), (b, turned[0]), (c, turned[1])] {
                if end < 3 {
                    signs[end] ^= turns;
                }
            }
            let even = signs.iter().all(|sign| *sign == signs[0]);
            even.then_some(Self {
                turned,
                reversed: signs[0] != turned[1],
            })
        };
        [[false, true], [true, false], [true, true]]
            .into_iter()
            .find_map(of)
    }
    // ANCHOR_END: turns
}

/// A unit vector across z.
fn any_across(z: &Vector) -> Vector {
    let axis = if z.z.abs() < 0.7 {
        Vector::z()
    } else {
        Vector::x()
    };
    (axis - z * z.dot(&axis)).normalize()
}

/// A unit vector across `from`, after the shortest turn of `from` to `to`.
fn transported(e: &Vector, from: &Vector, to: &Vector) -> Vector {
    let e = e - (from + to) * (to.dot(e) / (1.0 + from.dot(to)));
    // Rounding would let it lean and grow.
    (e - to * to.dot(&e)).normalize()
}

/// The angle about z from a to b.
fn angle_about(z: &Vector, a: &Vector, b: &Vector) -> f64 {
    z.dot(&a.cross(b)).atan2(a.dot(b))
}

/// A vector across z, turned about z.
fn turned(e: &Vector, z: &Vector, angle: f64) -> Vector {
    let (sine, cosine) = angle.sin_cos();
    e * cosine + z.cross(e) * sine
}
