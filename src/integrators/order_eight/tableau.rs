//! The coefficients, one step with them, and the polynomials within it.

use crate::integrators::System;

/// A step: where it begins, its length, the increment of the state, two estimates of its error, each as a rate, and the rates it used.
pub(super) struct Step<const N: usize> {
    pub time: f64,
    pub state: [f64; N],
    pub length: f64,
    pub change: [f64; N],
    fifth: [f64; N],
    third: [f64; N],
    /// Rates 1 and 6 to 12.
    pub used: [[f64; N]; 8],
}

/// The states within a step: a polynomial of order 7, or a cubic (Hairer, Nørsett, Wanner, II.6).
pub(super) struct Between<const N: usize>([[f64; N]; 8]);

impl<const N: usize> Between<N> {
    /// The polynomial of order 7, by three more evaluations, from the rate at the end of the step too.
    pub fn of<S: System<N> + ?Sized>(system: &S, step: &Step<N>, k13: &[f64; N]) -> Self {
        use coefficients::*;
        let [k1, k6, k7, k8, k9, k10, k11, k12] = &step.used;
        let (y, h) = (&step.state, step.length);
        let rate = |stage: usize, rates: [&[f64; N]; 8]| {
            let slope = sum(A_WITHIN[stage], rates);
            system.rate(step.at(C_WITHIN[stage]), &sum([1.0, h], [y, &slope]))
        };
        let k14 = rate(0, [k1, k7, k8, k9, k10, k11, k12, k13]);
        let k15 = rate(1, [k1, k6, k7, k8, k11, k12, k13, &k14]);
        let k16 = rate(2, [k1, k6, k7, k8, k9, k13, &k14, &k15]);
        let all = [k1, k6, k7, k8, k9, k10, k11, k12, k13, &k14, &k15, &k16];
        let mut between = Self::cubic(step, k13);
        for (row, term) in D.iter().zip(&mut between.0[4..]) {
            *term = sum([h], [&sum(*row, all)]);
        }
        between
    }

    /// The cubic through the states at both ends with the rates there, `after` at the end.
    pub fn cubic(step: &Step<N>, after: &[f64; N]) -> Self {
        let (h, change, before) = (step.length, step.change, &step.used[0]);
        let bend = sum([h, -1.0], [before, &change]);
        let last = sum([1.0, -h, -1.0], [&change, after, &bend]);
        let none = [0.0; N];
        Self([step.state, change, bend, last, none, none, none, none])
    }

    /// The last coefficient. No value of its term is more than a 119th of it.
    pub const fn last(&self) -> &[f64; N] {
        &self.0[7]
    }

    /// The state after this fraction of the step, 0…1.
    pub fn at(&self, part: f64) -> [f64; N] {
        let (s, left) = (part, 1.0 - part);
        let [mut state, c1, c2, c3, c4, c5, c6, c7] = self.0;
        for (n, y) in state.iter_mut().enumerate() {
            let inner = c4[n] + s * (c5[n] + left * (c6[n] + s * c7[n]));
            *y += s * (c1[n] + left * (c2[n] + s * (c3[n] + left * inner)));
        }
        state
    }
}

impl<const N: usize> Step<N> {
    /// The time after this fraction of it, 0…1.
    pub fn at(&self, part: f64) -> f64 {
        self.time + part * self.length
    }

    /// The error as a multiple of the allowed one, from both estimates (Hairer, Nørsett, Wanner, II.10).
    ///
    /// In few components the fifth-order estimate may pass through zero, where it says nothing. Then the square of the third-order estimate, also of
    /// order 8, counts: usually it is less than a twentieth of what the two say together, and the greater of both is returned.
    #[inline(always)]
    pub fn error(&self, scales: &[f64; N], tolerance: f64) -> f64 {
        let (state, h) = (self.state, self.length);
        let (mut fifth, mut third) = (0.0, 0.0);
        for (n, scale) in scales.iter().enumerate() {
            let size = state[n].abs().max((state[n] + self.change[n]).abs());
            let weight = match size + scale {
                // Zero at both ends and without a scale: there is nothing to be relative to.
                0.0 => 0.0,
                room => 1.0 / (tolerance * room),
            };
            let (five, three) = (self.fifth[n] * weight, self.third[n] * weight);
            fifth += five * five;
            third += three * three;
        }
        let denominator = fifth + 0.01 * third;
        if denominator == 0.0 {
            return 0.0;
        }
        let both = h.abs() * fifth / (denominator * N as f64).sqrt();
        let third_alone = OF_THE_THIRD * tolerance * h * h * third / N as f64;
        both.max(third_alone)
    }
}

/// The error by the third-order estimate alone is this times its square, both relative.
const OF_THE_THIRD: f64 = 0.005;

/// One step of length h from a state whose rate is known: eleven evaluations.
pub(super) fn step<const N: usize, S: System<N> + ?Sized>(
    system: &S,
    t: f64,
    y: &[f64; N],
    k1: &[f64; N],
    h: f64,
) -> Step<N> {
    use coefficients::*;
    let rate =
        |stage: usize, slope: [f64; N]| system.rate(t + C[stage] * h, &sum([1.0, h], [y, &slope]));
    let k2 = rate(1, sum(A2, [k1]));
    let k3 = rate(2, sum(A3, [k1, &k2]));
    let k4 = rate(3, sum(A4, [k1, &k3]));
    let k5 = rate(4, sum(A5, [k1, &k3, &k4]));
    let k6 = rate(5, sum(A6, [k1, &k4, &k5]));
    let k7 = rate(6, sum(A7, [k1, &k4, &k5, &k6]));
    let k8 = rate(7, sum(A8, [k1, &k4, &k5, &k6, &k7]));
    let k9 = rate(8, sum(A9, [k1, &k4, &k5, &k6, &k7, &k8]));
    let k10 = rate(9, sum(A10, [k1, &k4, &k5, &k6, &k7, &k8, &k9]));
    let k11 = rate(10, sum(A11, [k1, &k4, &k5, &k6, &k7, &k8, &k9, &k10]));
    let last = sum(A12, [k1, &k4, &k5, &k6, &k7, &k8, &k9, &k10, &k11]);
    let k12 = rate(11, last);
    let used = [k1, &k6, &k7, &k8, &k9, &k10, &k11, &k12];
    let slope = sum(B, used);
    let low = sum(E3, [k1, &k9, &k12]);
    Step {
        time: t,
        state: *y,
        length: h,
        change: sum([h], [&slope]),
        fifth: sum(E5, used),
        third: sum([1.0, -1.0], [&slope, &low]),
        used: [*k1, k6, k7, k8, k9, k10, k11, k12],
    }
}

/// The sum of as many vectors, each times its weight.
#[inline(always)]
pub(super) fn sum<const N: usize, const M: usize>(
    weights: [f64; M],
    vectors: [&[f64; N]; M],
) -> [f64; N] {
    let mut sums = [0.0; N];
    for (n, sum) in sums.iter_mut().enumerate() {
        *sum = weights[0] * vectors[0][n];
        for m in 1..M {
            *sum += weights[m] * vectors[m][n];
        }
    }
    sums
}

/// Coefficients of Dormand and Prince (1980, 1989) as in DOP853, without the zeros. Row 6 multiplies rates 1, 4 and 5, every later row rates 1 and
/// 4 up to its own; rows 3, 4 and 5 multiply rates 1 and 2; 1 and 3; 1, 3 and 4. `B` and `E5` multiply rates 1 and 6 to 12; `E3` rates 1, 9 and 12;
/// the rows of `A_WITHIN` rates 1 and 7 to 13; 1, 6 to 8 and 11 to 14; 1, 6 to 9 and 13 to 15; `D` rates 1 and 6 to 16.
#[rustfmt::skip]
mod coefficients {
    pub const A2: [f64; 1] = [5.260_015_195_876_773e-2];
    pub const A3: [f64; 2] = [1.972_505_698_453_79e-2, 5.917_517_095_361_37e-2];
    pub const A4: [f64; 2] = [2.958_758_547_680_685e-2, 8.876_275_643_042_054e-2];
    pub const A5: [f64; 3] = [
         2.413_651_341_592_667e-1, -8.845_494_793_282_861e-1,  9.248_340_032_617_92e-1,
    ];
    pub const A6: [f64; 3] = [
        3.703_703_703_703_703_5e-2, 1.708_286_087_294_738_6e-1, 1.254_676_875_668_224_2e-1,
    ];
    pub const A7: [f64; 4] = [
         3.7109375e-2,  1.702_522_110_195_440_5e-1,  6.021_653_898_045_596e-2,
        -1.7578125e-2,
    ];
    pub const A8: [f64; 5] = [
         3.709_200_011_850_479e-2,    1.703_839_257_122_399_8e-1,  1.072_620_304_463_732_8e-1,
        -1.531_943_774_862_440_2e-2,  8.273_789_163_814_023e-3,
    ];
    pub const A9: [f64; 6] = [
         6.241_109_587_160_757e-1, -3.360_892_629_446_941_4,   -8.682_193_468_417_26e-1,
         2.759_209_969_944_671e1,   2.015_406_755_047_789_4e1, -4.348_988_418_106_996e1,
    ];
    pub const A10: [f64; 7] = [
         4.776_625_364_382_643_4e-1, -2.488_114_619_971_667_7,   -5.902_908_268_368_43e-1,
         2.123_005_144_818_119_3e1,   1.527_923_363_288_242_3e1, -3.328_821_096_898_486e1,
        -2.033_120_170_850_862_7e-2,
    ];
    pub const A11: [f64; 8] = [
        -9.371_424_300_859_873e-1,  5.186_372_428_844_064,    1.091_437_348_996_729_5,
        -8.149_787_010_746_927,    -1.852_006_565_999_696e1,  2.273_948_709_935_050_5e1,
         2.493_605_552_679_652_3,  -3.046_764_471_898_219_6,
    ];
    pub const A12: [f64; 9] = [
         2.273_310_147_516_538,  -1.053_449_546_673_725e1,   -2.000_872_058_224_862_5,
        -1.795_893_186_311_88e1,  2.794_888_452_941_996e1,   -2.858_998_277_135_023_5,
        -8.872_856_933_530_63,    1.236_056_717_579_430_3e1,  6.433_927_460_157_636e-1,
    ];
    pub const B: [f64; 8] = [
         5.429_373_411_656_876_5e-2,  4.450_312_892_752_409,     1.891_517_899_314_500_3,
        -5.801_203_960_010_585,       3.111_643_669_578_199e-1, -1.521_609_496_625_161e-1,
         2.013_654_008_040_303_4e-1,  4.471_061_572_777_259e-2,
    ];
    pub const E5: [f64; 8] = [
         1.312_004_499_419_488e-2, -1.225_156_446_376_204_4,    -4.957_589_496_572_502e-1,
         1.664_377_182_454_986_4,  -3.503_288_487_499_736_6e-1,  3.341_791_187_130_175e-1,
         8.192_320_648_511_571e-2, -2.235_530_786_388_629_4e-2,
    ];
    pub const E3: [f64; 3] = [
        2.440_944_881_889_764e-1, 7.338_466_882_816_118e-1, 2.205_882_352_941_176_6e-2,
    ];
    pub const C: [f64; 12] = [
        0.0,                      5.260_015_195_876_773e-2, 7.890_022_793_815_16e-2,
        1.183_503_419_072_274e-1, 2.816_496_580_927_726e-1, 3.333_333_333_333_333e-1,
        0.25,                     3.076_923_076_923_077e-1, 6.512_820_512_820_513e-1,
        0.6,                      8.571_428_571_428_571e-1, 1.0,
    ];
    pub const C_WITHIN: [f64; 3] = [0.1, 0.2, 7.777_777_777_777_778e-1];
    pub const A_WITHIN: [[f64; 8]; 3] = [
        [ 0.056_167_502_283_047_954,  0.253_500_210_216_624_83, -0.246_239_037_470_802_5,
         -0.124_191_423_263_816_37,   0.153_291_798_278_765_68,  0.008_201_052_295_634_69,
          0.007_567_897_660_545_699, -0.008_298],
        [ 0.031_834_648_163_502_14,    0.028_300_909_672_366_776,   0.053_541_988_307_438_566,
         -0.054_923_748_571_390_99,   -1.083_473_286_972_493_2e-4,  3.825_710_908_356_584e-4,
         -3.404_650_086_874_045_6e-4,  0.141_312_443_674_632_5],
        [-0.428_896_301_583_791_94, -4.697_621_415_361_164,    7.683_421_196_062_599,
          4.068_989_818_397_11,      0.356_727_187_455_281_1, -0.001_399_024_165_159_014_5,
          2.947_514_789_152_772_4,  -9.150_958_472_179_87],
    ];
    pub const D: [[f64; 12]; 4] = [
        [-8.428_938_276_109_013,    0.566_714_953_519_377_7, -3.068_949_945_949_891_7,
          2.384_667_656_512_07,     2.117_034_582_445_028,   -0.871_391_583_777_973,
          2.240_437_430_260_788_3,  0.631_578_778_769_468_8, -0.088_990_336_451_333_31,
         18.148_505_520_854_727,   -9.194_632_392_478_356,   -4.436_036_387_594_894],
        [  10.427_508_642_579_134,  242.283_491_775_258_17,   165.200_451_717_270_28,
         -374.546_754_722_690_2,    -22.113_666_853_125_306,    7.733_432_668_472_264,
          -30.674_084_731_089_398,   -9.332_130_526_430_229,   15.697_238_121_770_845,
          -31.139_403_219_565_178,   -9.352_924_358_844_48,    35.816_841_486_394_08],
        [  19.985_053_242_002_433,   -387.037_308_749_351_8,     -189.178_138_195_167_58,
          527.808_159_205_423_6,      -11.573_902_539_959_63,       6.881_232_694_696_3,
           -1.000_605_096_691_083_8,    0.777_713_779_805_344_3,   -2.778_205_752_353_508,
          -60.196_695_231_264_12,      84.320_405_506_677_16,      11.992_291_136_182_79],
        [ -25.693_933_462_703_75, -154.189_748_690_236_43, -231.529_379_176_045_5,
          357.639_117_910_614_1,    93.405_324_183_624_32,  -37.458_323_136_451_63,
          104.099_649_508_962_3,    29.840_293_426_660_5,   -43.533_456_590_011_14,
           96.324_553_959_188_28,  -39.177_261_675_615_44, -149.726_836_257_985_64],
    ];
}

#[cfg(test)]
mod tests {
    use super::coefficients::*;
    use super::sum;

    /// The full matrix, zeros included.
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

    /// Conditions of order 8: those of the quadrature, and those by which the stages have orders 2, 3 and 4.
    #[test]
    fn the_coefficients_satisfy_the_conditions_of_their_order() {
        let a = rows();
        let mut b = [0.0; 12];
        b[0] = B[0];
        b[5..].copy_from_slice(&B[1..]);
        let sum = |row: &[f64; 12], of: &dyn Fn(usize) -> f64| -> f64 {
            (0..12).map(|j| row[j] * of(j)).sum()
        };
        for power in 0..8 {
            let sum = sum(&b, &|j| C[j].powi(power));
            let exact = 1.0 / f64::from(power + 1);
            // Observed 4.5e-16.
            assert!((sum - exact).abs() < 6e-16, "{power}: {sum}");
        }
        // Σ a c^k = c^(k+1)/(k+1): k up to 3 for every stage with a weight, from the sixth on.
        for (n, row) in a.iter().enumerate() {
            for power in 0..if n < 5 { 1 } else { 4 } {
                let sum = sum(row, &|j| C[j].powi(power));
                let exact = C[n].powi(power + 1) / f64::from(power + 1);
                // Observed 6.2e-15 for k = 0, with summands as great as 43.
                let allowed = if power == 0 { 8e-15 } else { 5e-15 };
                assert!((sum - exact).abs() < allowed, "{n} {power}: {sum} {exact}");
            }
        }
        // The nested conditions of order 8 that remain: Σ b c a c^5 and Σ b a a c^5.
        let inner = |i: usize| sum(&a[i], &|j| C[j].powi(5));
        let outer = sum(&b, &|i| C[i] * inner(i));
        assert!((outer - 1.0 / 48.0).abs() < 1e-15, "{outer}");
        let second = sum(&b, &|i| sum(&a[i], &inner));
        assert!((second - 1.0 / 336.0).abs() < 1e-15, "{second}");
    }

    /// The estimates belong to formulas of orders 5 and 3: they vanish for rates t^k below that power, and not at it.
    #[test]
    fn the_estimates_are_of_their_orders() {
        let of = |power: i32| {
            let rates: [[f64; 1]; 12] = core::array::from_fn(|n| [C[n].powi(power)]);
            let [a, _, _, _, _, f, g, h, i, j, k, l] = &rates;
            let used = [a, f, g, h, i, j, k, l];
            let [five] = sum(E5, used);
            let [three] = sum(E3, [a, i, l]);
            [five, sum(B, used)[0] - three]
        };
        for power in 0..5 {
            assert!(of(power)[0].abs() < 1e-15, "{power}: {:?}", of(power));
        }
        for power in 0..3 {
            assert!(of(power)[1].abs() < 1e-15, "{power}: {:?}", of(power));
        }
        assert!(of(5)[0].abs() > 1e-4 && of(3)[1].abs() > 1e-3);
    }
}
