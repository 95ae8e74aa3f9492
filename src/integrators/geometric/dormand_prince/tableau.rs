//! The coefficients, and one step with them.

use crate::integrators::System;

/// What a step adds to the state, and the two estimates of its error, each a rate.
pub(super) struct Step<const N: usize> {
    pub change: [f64; N],
    fifth: [f64; N],
    third: [f64; N],
    after: [f64; N],
}

impl<const N: usize> Step<N> {
    /// The error as a multiple of what is allowed: both estimates in one (Hairer, Nørsett, Wanner, II.10).
    #[inline(always)]
    pub fn error(&self, state: &[f64; N], scales: &[f64; N], tolerance: f64, h: f64) -> f64 {
        let weights: [f64; N] = core::array::from_fn(|n| {
            let size = state[n].abs().max(self.after[n].abs());
            1.0 / (tolerance * (size + scales[n]))
        });
        let (mut fifth, mut third) = (0.0, 0.0);
        for ((five, three), weight) in self.fifth.iter().zip(&self.third).zip(weights) {
            let (five, three) = (five * weight, three * weight);
            fifth += five * five;
            third += three * three;
        }
        let denominator = fifth + 0.01 * third;
        if denominator == 0.0 {
            return 0.0;
        }
        h.abs() * fifth / (denominator * N as f64).sqrt()
    }
}

/// One step of length h from a state where the rate is known: eleven evaluations.
#[inline(always)]
pub(super) fn step<const N: usize, S: System<N> + ?Sized>(
    system: &S,
    t: f64,
    y: &[f64; N],
    k1: &[f64; N],
    h: f64,
) -> Step<N> {
    use coefficients::*;
    let rate = |stage: usize, sum: [f64; N]| {
        system.rate(
            t + C[stage] * h,
            &core::array::from_fn(|n| y[n] + h * sum[n]),
        )
    };
    let k2 = rate(1, mean(A2, [k1]));
    let k3 = rate(2, mean(A3, [k1, &k2]));
    let k4 = rate(3, mean(A4, [k1, &k3]));
    let k5 = rate(4, mean(A5, [k1, &k3, &k4]));
    let k6 = rate(5, mean(A6, [k1, &k4, &k5]));
    let k7 = rate(6, mean(A7, [k1, &k4, &k5, &k6]));
    let k8 = rate(7, mean(A8, [k1, &k4, &k5, &k6, &k7]));
    let k9 = rate(8, mean(A9, [k1, &k4, &k5, &k6, &k7, &k8]));
    let k10 = rate(9, mean(A10, [k1, &k4, &k5, &k6, &k7, &k8, &k9]));
    let k11 = rate(10, mean(A11, [k1, &k4, &k5, &k6, &k7, &k8, &k9, &k10]));
    let k12 = rate(
        11,
        mean(A12, [k1, &k4, &k5, &k6, &k7, &k8, &k9, &k10, &k11]),
    );
    let used = [k1, &k6, &k7, &k8, &k9, &k10, &k11, &k12];
    let slope = mean(B, used);
    let low = mean(E3, [k1, &k9, &k12]);
    let change: [f64; N] = core::array::from_fn(|n| h * slope[n]);
    Step {
        after: core::array::from_fn(|n| y[n] + change[n]),
        change,
        fifth: mean(E5, used),
        third: core::array::from_fn(|n| slope[n] - low[n]),
    }
}

#[inline(always)]
fn mean<const N: usize, const M: usize>(weights: [f64; M], rates: [&[f64; N]; M]) -> [f64; N] {
    core::array::from_fn(|n| {
        let mut sum = weights[0] * rates[0][n];
        for m in 1..M {
            sum += weights[m] * rates[m][n];
        }
        sum
    })
}

/// Of Dormand and Prince (1980, 1989) as in DOP853, the zeros left out: row 6 multiplies rates 1, 4 and 5, every row from there on rates 1 and
/// 4 to its own; rows 3, 4 and 5 rates 1 and 2; 1 and 3; 1, 3 and 4. The last rows multiply rates 1 and 6 to 12; `E3` rates 1, 9 and 12.
mod coefficients {
    pub const A2: [f64; 1] = [5.260_015_195_876_773e-2];
    pub const A3: [f64; 2] = [1.972_505_698_453_79e-2, 5.917_517_095_361_37e-2];
    pub const A4: [f64; 2] = [2.958_758_547_680_685e-2, 8.876_275_643_042_054e-2];
    pub const A5: [f64; 3] = [
        2.413_651_341_592_667e-1,
        -8.845_494_793_282_861e-1,
        9.248_340_032_617_92e-1,
    ];
    pub const A6: [f64; 3] = [
        3.703_703_703_703_703_5e-2,
        1.708_286_087_294_738_6e-1,
        1.254_676_875_668_224_2e-1,
    ];
    pub const A7: [f64; 4] = [
        3.7109375e-2,
        1.702_522_110_195_440_5e-1,
        6.021_653_898_045_596e-2,
        -1.7578125e-2,
    ];
    pub const A8: [f64; 5] = [
        3.709_200_011_850_479e-2,
        1.703_839_257_122_399_8e-1,
        1.072_620_304_463_732_8e-1,
        -1.531_943_774_862_440_2e-2,
        8.273_789_163_814_023e-3,
    ];
    pub const A9: [f64; 6] = [
        6.241_109_587_160_757e-1,
        -3.360_892_629_446_941_4,
        -8.682_193_468_417_26e-1,
        2.759_209_969_944_671e1,
        2.015_406_755_047_789_4e1,
        -4.348_988_418_106_996e1,
    ];
    pub const A10: [f64; 7] = [
        4.776_625_364_382_643_4e-1,
        -2.488_114_619_971_667_7,
        -5.902_908_268_368_43e-1,
        2.123_005_144_818_119_3e1,
        1.527_923_363_288_242_3e1,
        -3.328_821_096_898_486e1,
        -2.033_120_170_850_862_7e-2,
    ];
    pub const A11: [f64; 8] = [
        -9.371_424_300_859_873e-1,
        5.186_372_428_844_064,
        1.091_437_348_996_729_5,
        -8.149_787_010_746_927,
        -1.852_006_565_999_696e1,
        2.273_948_709_935_050_5e1,
        2.493_605_552_679_652_3,
        -3.046_764_471_898_219_6,
    ];
    pub const A12: [f64; 9] = [
        2.273_310_147_516_538,
        -1.053_449_546_673_725e1,
        -2.000_872_058_224_862_5,
        -1.795_893_186_311_88e1,
        2.794_888_452_941_996e1,
        -2.858_998_277_135_023_5,
        -8.872_856_933_530_63,
        1.236_056_717_579_430_3e1,
        6.433_927_460_157_636e-1,
    ];
    pub const B: [f64; 8] = [
        5.429_373_411_656_876_5e-2,
        4.450_312_892_752_409,
        1.891_517_899_314_500_3,
        -5.801_203_960_010_585,
        3.111_643_669_578_199e-1,
        -1.521_609_496_625_161e-1,
        2.013_654_008_040_303_4e-1,
        4.471_061_572_777_259e-2,
    ];
    pub const E5: [f64; 8] = [
        1.312_004_499_419_488e-2,
        -1.225_156_446_376_204_4,
        -4.957_589_496_572_502e-1,
        1.664_377_182_454_986_4,
        -3.503_288_487_499_736_6e-1,
        3.341_791_187_130_175e-1,
        8.192_320_648_511_571e-2,
        -2.235_530_786_388_629_4e-2,
    ];
    pub const E3: [f64; 3] = [
        2.440_944_881_889_764e-1,
        7.338_466_882_816_118e-1,
        2.205_882_352_941_176_6e-2,
    ];
    pub const C: [f64; 12] = [
        0.0,
        5.260_015_195_876_773e-2,
        7.890_022_793_815_16e-2,
        1.183_503_419_072_274e-1,
        2.816_496_580_927_726e-1,
        3.333_333_333_333_333e-1,
        0.25,
        3.076_923_076_923_077e-1,
        6.512_820_512_820_513e-1,
        0.6,
        8.571_428_571_428_571e-1,
        1.0,
    ];
}

#[cfg(test)]
mod tests {
    use super::coefficients::*;
    use super::{mean, step};

    /// The matrix with its zeros.
    fn rows() -> [[f64; 12]; 12] {
        let mut a = [[0.0; 12]; 12];
        let mut fill = |row: usize, from: &[usize], weights: &[f64]| {
            for (&column, &weight) in from.iter().zip(weights) {
                a[row][column] = weight;
            }
        };
        fill(1, &[0], &A2);
        fill(2, &[0, 1], &A3);
        fill(3, &[0, 2], &A4);
        fill(4, &[0, 2, 3], &A5);
        let late = [0, 3, 4, 5, 6, 7, 8, 9, 10];
        let others: [&[f64]; 7] = [&A6, &A7, &A8, &A9, &A10, &A11, &A12];
        for (n, weights) in others.into_iter().enumerate() {
            fill(5 + n, &late[..3 + n], weights);
        }
        a
    }

    /// Conditions for order 8: those of the quadrature, and those that say the stages are good to orders 2, 3 and 4.
    #[test]
    fn the_coefficients_satisfy_the_conditions_of_their_order() {
        let a = rows();
        for (n, row) in a.iter().enumerate() {
            let sum: f64 = row.iter().sum();
            // Observed 6.2e-15, with summands as great as 43.
            assert!((sum - C[n]).abs() < 8e-15, "{n}: {sum} {}", C[n]);
        }
        let mut b = [0.0; 12];
        b[0] = B[0];
        b[5..].copy_from_slice(&B[1..]);
        for power in 0..8 {
            let sum: f64 = (0..12).map(|i| b[i] * C[i].powi(power)).sum();
            // Observed 4.5e-16.
            assert!(
                (sum - 1.0 / f64::from(power + 1)).abs() < 6e-16,
                "{power}: {sum}"
            );
        }
        // Σ a c^k = c^(k+1)/(k+1) for every stage that counts: k up to 3 from the sixth stage on.
        for (n, row) in a.iter().enumerate().skip(5) {
            for power in 1..4 {
                let sum: f64 = (0..12).map(|j| row[j] * C[j].powi(power)).sum();
                let exact = C[n].powi(power + 1) / f64::from(power + 1);
                // Rounding of summands as great as 43.
                assert!((sum - exact).abs() < 5e-15, "{n} {power}: {sum} {exact}");
            }
        }
        // Nested conditions of order 8 with what is left: Σ b c a c^5 and Σ b a a c^5.
        let inner: [f64; 12] =
            core::array::from_fn(|i| (0..12).map(|j| a[i][j] * C[j].powi(5)).sum());
        let outer: f64 = (0..12).map(|i| b[i] * C[i] * inner[i]).sum();
        assert!((outer - 1.0 / 48.0).abs() < 1e-15, "{outer}");
        let second: f64 = (0..12)
            .map(|i| b[i] * (0..12).map(|j| a[i][j] * inner[j]).sum::<f64>())
            .sum();
        assert!((second - 1.0 / 336.0).abs() < 1e-15, "{second}");
    }

    /// The estimates belong to formulas of orders 5 and 3: they vanish for polynomials below, and not above.
    #[test]
    fn the_estimates_are_of_their_orders() {
        let of = |power: i32| {
            let rates: [[f64; 1]; 12] = core::array::from_fn(|n| [C[n].powi(power)]);
            let [a, _, _, _, _, f, g, h, i, j, k, l] = &rates;
            let used = [a, f, g, h, i, j, k, l];
            let [five] = mean(E5, used);
            let [three] = mean(E3, [a, i, l]);
            [five, mean(B, used)[0] - three]
        };
        for power in 0..5 {
            assert!(of(power)[0].abs() < 1e-15, "{power}: {:?}", of(power));
        }
        for power in 0..3 {
            assert!(of(power)[1].abs() < 1e-15, "{power}: {:?}", of(power));
        }
        assert!(of(5)[0].abs() > 1e-4 && of(3)[1].abs() > 1e-3);
    }

    /// y' = t⁷ is summed exactly; the rate at the start is not asked for again.
    #[test]
    fn a_step_integrates_powers_up_to_the_seventh() {
        let power = |t: f64, _: &[f64; 1]| [8.0 * t.powi(7)];
        let taken = step(&power, 1.0, &[1.0], &[8.0], 0.5);
        let error = (1.0 + taken.change[0]) / 1.5_f64.powi(8) - 1.0;
        // Observed: 2.4e-15 at most; the weights reach 6 and change their signs, and how `powi` rounds depends on the level of optimisation.
        assert!(error.abs() < 5e-15, "{error:e}");
    }
}
