//! Corrections of the moments of inertia by which the discrete free top keeps the time of the continuous one.
//!
//! 1/Ĩ_j = (1 + h²s₃ + h⁴s₅ + h⁶s₇ + h⁸s₉)/I_j + h²d₃ + h⁴d₅ + h⁶d₇ + h⁸d₉: Hairer and Vilmart (2006), "Preprocessed discrete Moser–Veselov algorithm
//! for the full dynamics of a rigid body", J. Phys. A 39. s and d are polynomials in H, C = ½|L|² and e₁, e₂, e₃, the elementary symmetric
//! functions of 1/I₁, 1/I₂, 1/I₃. s₃ and d₃ agree with that paper; all are derived in `tests/reference/moser_veselov.py` by matching power series in
//! rationals. The algorithm conserves H and C, so the moments are corrected once a run.

use crate::integrators::real::Real;

/// Powers of H, C, e₁, e₂, e₃; numerator and denominator of the coefficient.
type Term = ([u8; 5], f64, f64);

/// s₃ and d₃, s₅ and d₅, s₇ and d₇, s₉ and d₉.
#[rustfmt::skip]
const TABLES: [[&[Term]; 2]; 4] = [
    [&[
        ([1, 0, 1, 0, 0], -1.0, 3.0), ([0, 1, 0, 1, 0], 1.0, 6.0),
    ], &[
        ([1, 0, 0, 1, 0], 1.0, 6.0), ([0, 1, 0, 0, 1], -1.0, 3.0),
    ]],
    [&[
        ([2, 0, 2, 0, 0], 1.0, 30.0), ([2, 0, 0, 1, 0], -1.0, 60.0), ([1, 1, 1, 1, 0], -1.0, 30.0), ([1, 1, 0, 0, 1], 2.0, 15.0),
        ([0, 2, 0, 2, 0], 1.0, 30.0), ([0, 2, 1, 0, 1], -1.0, 10.0),
    ], &[
        ([2, 0, 1, 1, 0], -1.0, 60.0), ([2, 0, 0, 0, 1], -1.0, 10.0), ([1, 1, 0, 2, 0], -1.0, 60.0), ([1, 1, 1, 0, 1], 2.0, 15.0),
        ([0, 2, 0, 1, 1], -1.0, 60.0),
    ]],
    [&[
        ([3, 0, 3, 0, 0], -1.0, 630.0), ([3, 0, 1, 1, 0], 1.0, 630.0), ([3, 0, 0, 0, 1], 1.0, 35.0), ([2, 1, 2, 1, 0], 1.0, 420.0),
        ([2, 1, 0, 2, 0], 41.0, 2520.0), ([2, 1, 1, 0, 1], -53.0, 630.0), ([1, 2, 1, 2, 0], -1.0, 70.0),
        ([1, 2, 2, 0, 1], 11.0, 210.0), ([1, 2, 0, 1, 1], -1.0, 84.0), ([0, 3, 0, 3, 0], 17.0, 2520.0),
        ([0, 3, 1, 1, 1], -11.0, 420.0), ([0, 3, 0, 0, 2], 5.0, 126.0),
    ], &[
        ([3, 0, 2, 1, 0], 1.0, 1260.0), ([3, 0, 0, 2, 0], -13.0, 1260.0), ([3, 0, 1, 0, 1], 1.0, 42.0),
        ([2, 1, 1, 2, 0], 13.0, 2520.0), ([2, 1, 2, 0, 1], -8.0, 315.0), ([2, 1, 0, 1, 1], 11.0, 252.0),
        ([1, 2, 0, 3, 0], 1.0, 1260.0), ([1, 2, 1, 1, 1], -1.0, 1260.0), ([1, 2, 0, 0, 2], -22.0, 315.0),
        ([0, 3, 0, 2, 1], -19.0, 2520.0), ([0, 3, 1, 0, 2], 1.0, 35.0),
    ]],
    [&[
        ([4, 0, 4, 0, 0], 1.0, 22680.0), ([4, 0, 2, 1, 0], -1.0, 15120.0), ([4, 0, 0, 2, 0], 17.0, 5040.0),
        ([4, 0, 1, 0, 1], -3.0, 280.0), ([3, 1, 3, 1, 0], -1.0, 11340.0), ([3, 1, 1, 2, 0], -11.0, 1890.0),
        ([3, 1, 2, 0, 1], 23.0, 945.0), ([3, 1, 0, 1, 1], -23.0, 1260.0), ([2, 2, 2, 2, 0], 13.0, 3780.0),
        ([2, 2, 0, 3, 0], 1.0, 2520.0), ([2, 2, 3, 0, 1], -17.0, 1260.0), ([2, 2, 1, 1, 1], 1.0, 252.0),
        ([2, 2, 0, 0, 2], 53.0, 1260.0), ([1, 3, 1, 3, 0], -11.0, 3240.0), ([1, 3, 2, 1, 1], 17.0, 1260.0),
        ([1, 3, 0, 2, 1], 47.0, 7560.0), ([1, 3, 1, 0, 2], -47.0, 945.0), ([0, 4, 0, 4, 0], 31.0, 22680.0),
        ([0, 4, 1, 2, 1], -19.0, 2520.0), ([0, 4, 2, 0, 2], 1.0, 120.0), ([0, 4, 0, 1, 2], 97.0, 15120.0),
    ], &[
        ([4, 0, 3, 1, 0], -1.0, 45360.0), ([4, 0, 1, 2, 0], -1.0, 7560.0), ([4, 0, 2, 0, 1], -1.0, 360.0),
        ([4, 0, 0, 1, 1], 17.0, 1680.0), ([3, 1, 2, 2, 0], -1.0, 1512.0), ([3, 1, 0, 3, 0], 97.0, 22680.0),
        ([3, 1, 3, 0, 1], 8.0, 2835.0), ([3, 1, 1, 1, 1], -23.0, 1890.0), ([3, 1, 0, 0, 2], -1.0, 35.0),
        ([2, 2, 1, 3, 0], -1.0, 1512.0), ([2, 2, 2, 1, 1], 19.0, 7560.0), ([2, 2, 0, 2, 1], -19.0, 1080.0),
        ([2, 2, 1, 0, 2], 89.0, 1890.0), ([1, 3, 0, 4, 0], -1.0, 45360.0), ([1, 3, 1, 2, 1], 37.0, 7560.0),
        ([1, 3, 2, 0, 2], -2.0, 105.0), ([1, 3, 0, 1, 2], 19.0, 1260.0), ([0, 4, 0, 3, 1], -61.0, 45360.0),
        ([0, 4, 1, 1, 2], 3.0, 560.0), ([0, 4, 0, 0, 3], -61.0, 4536.0),
    ]],
];

/// For hL, h the step, and `terms` powers of h²: the factor of the reciprocal moments, less 1, and the summand added to them.
pub(super) fn corrections<T: Real>(inverse: [T; 3], l: [T; 3], terms: usize) -> (T, T) {
    let [a, b, c] = inverse;
    let half = T::from_double(0.5);
    let square = l.map(|x| x * x);
    let arguments = [
        half * (a * square[0] + b * square[1] + c * square[2]),
        half * (square[0] + square[1] + square[2]),
        a + b + c,
        a * b + b * c + c * a,
        a * b * c,
    ];
    // From the highest power of h² down; it stands in H and C.
    let series = |which: usize| {
        let mut sum = T::from_double(0.0);
        for (powers, numerator, denominator) in TABLES[..terms].iter().rev().flat_map(|t| t[which])
        {
            let mut term = T::from_double(*numerator) * T::from_double(*denominator).reciprocal();
            for (&power, argument) in powers.iter().zip(arguments) {
                for _ in 0..power {
                    term = term * argument;
                }
            }
            sum = sum + term;
        }
        sum
    };
    (series(0), series(1))
}

#[cfg(test)]
mod tests {
    use super::TABLES;

    #[test]
    fn the_tables_are_those_of_the_script() {
        let names = ["s3", "d3", "s5", "d5", "s7", "d7", "s9", "d9"];
        let tables = names.into_iter().zip(TABLES.as_flattened());
        let mut expected = tables.flat_map(|(name, table)| {
            table.iter().map(move |(powers, numerator, denominator)| {
                let powers = powers.map(|power| power.to_string()).join(",");
                format!("{name},{powers},{numerator},{denominator}")
            })
        });
        let text = include_str!("../../../tests/reference/moser_veselov.csv");
        for line in text.lines().skip(1) {
            assert_eq!(expected.next().as_deref(), Some(line));
        }
        assert_eq!(expected.next(), None);
    }
}
