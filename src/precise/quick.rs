//! Elementary steps without branches, so that several numbers can be computed side by side: two-word arithmetic far from the ends of
//! the range, angles reduced by right angles, sine and cosine, sinh and cosh, the arctangent, powers of two.

/// The upper 26 bits of a number below 10³⁰⁰, and the remainder (Veltkamp).
#[inline(always)]
pub(crate) fn halves(x: f64) -> (f64, f64) {
    let y = 134_217_729.0 * x;
    let upper = y - (y - x);
    (upper, x - upper)
}

/// The product and its rounding error. Without a fused multiplication of the processor by Dekker's splitting, which is faster than
/// a library call.
#[inline(always)]
pub(crate) fn exact_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if cfg!(target_feature = "fma") {
        return (product, a.mul_add(b, -product));
    }
    let (a1, a2) = halves(a);
    let (b1, b2) = halves(b);
    let error = ((a1 * b1 - product) + (a1 * b2 + a2 * b1)) + a2 * b2;
    (product, error)
}

/// The sum of two numbers and its rounding error (Knuth).
#[inline(always)]
pub(crate) fn exact_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The same for a first number not the smaller in size (Dekker).
#[inline(always)]
pub(crate) fn ordered_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The square root of a positive `high + low`, to 105 bits.
#[inline(always)]
pub(crate) fn root(high: f64, low: f64) -> (f64, f64) {
    let root = high.sqrt();
    let (square, error) = exact_product(root, root);
    (root, (((high - square) - error) + low) * (0.5 / root))
}

/// 2²⁵: its product with the leading 27 bits of K fits into 53 bits.
pub(crate) const EXACT_COUNT: f64 = 33_554_432.0;

/// π/2 in three words, the first two so short that their products with a count are exact.
pub(crate) const QUARTER_PARTS: [f64; 3] = [
    1.570_796_310_901_641_8,
    1.589_325_471_229_585_7e-8,
    6.123_233_995_736_766e-17,
];

/// `high + low` less the nearest multiple of a unit given in three words; and the multiple's count, at most [`EXACT_COUNT`], with [`ROUNDER`] added.
#[inline(always)]
pub(crate) fn reduced([high, low]: [f64; 2], inverse: f64, parts: [f64; 3]) -> (f64, [f64; 2]) {
    let rounded = high * inverse + ROUNDER;
    let count = rounded - ROUNDER;
    // The first difference is exact: its terms are within a factor of two, or the count is zero.
    let first = high - count * parts[0];
    let (rest, error) = exact_sum(first, -(count * parts[1]));
    let low = error + (low - count * parts[2]);
    // The terms are in order of size, unless the remainder is so small that it does not matter.
    let (high, low) = ordered_sum(rest, low);
    (rounded, [high, low])
}

/// Sine and cosine of an angle in two words, at most [`EXACT_COUNT`] right angles.
#[inline(always)]
pub(crate) fn sine_cosine(angle: [f64; 2]) -> (f64, f64) {
    let (rounded, [high, low]) = reduced(angle, core::f64::consts::FRAC_2_PI, QUARTER_PARTS);
    let (sine, cosine) = small_sine_cosine(high, low);
    in_quadrant(rounded.to_bits(), sine, cosine)
}

/// Sine and cosine advanced by the quarter turns that the lowest two bits count.
#[inline(always)]
pub(crate) fn in_quadrant(bits: u64, sine: f64, cosine: f64) -> (f64, f64) {
    let odd = (bits & 1).wrapping_neg();
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    // Odd quadrants exchange sine and cosine: the bits in which they differ are flipped in both.
    let exchange = (s ^ c) & odd;
    // The sine is negative in quadrants 2 and 3, the cosine in 1 and 2.
    let sign = (bits << 62) & (1 << 63);
    (
        f64::from_bits(s ^ exchange ^ sign),
        f64::from_bits(c ^ exchange ^ sign ^ (bits << 63)),
    )
}

/// Chebyshev fit of (sin x − x)/x³ in x² for |x| ≤ 0.789, error 1.3·10⁻¹⁷ of x.
#[rustfmt::skip]
pub(crate) const SINE: [f64; 6] = [
    -0.166_666_666_666_666_66,    0.008_333_333_333_330_837, -0.000_198_412_698_365_912_97,
     2.755_731_601_618_121_8e-6, -2.505_111_392_607_282e-8,   1.591_684_419_161_689e-10,
];

/// Chebyshev fit of (cos x − 1 + x²/2)/x⁴ in x² for |x| ≤ 0.789, error 5·10⁻¹⁹.
#[rustfmt::skip]
pub(crate) const COSINE: [f64; 6] = [
     0.041_666_666_666_666_664,  -0.001_388_888_888_888_732_8,  2.480_158_729_866_104_3e-5,
    -2.755_731_721_769_733_4e-7,  2.087_613_505_850_708e-9,    -1.138_182_847_267_891_7e-11,
];

/// Taylor coefficients of (sinh x − x)/x³ in x²; the first term left out is 10⁻¹⁷ at 0.36.
#[rustfmt::skip]
const HYPERBOLIC_SINE: [f64; 6] = [
    1.0 / 6.0,       1.0 / 120.0,        1.0 / 5040.0,
    1.0 / 362_880.0, 1.0 / 39_916_800.0, 1.0 / 6_227_020_800.0,
];

/// Taylor coefficients of (cosh x − 1 − x²/2)/x⁴ in x².
#[rustfmt::skip]
const HYPERBOLIC_COSINE: [f64; 5] = [
    1.0 / 24.0, 1.0 / 720.0, 1.0 / 40_320.0, 1.0 / 3_628_800.0, 1.0 / 479_001_600.0,
];

/// Chebyshev fit of (atan t − t)/t³ in t² for t up to tan π/8, error 6·10⁻¹⁸ of t.
#[rustfmt::skip]
const ARCTANGENT: [f64; 11] = [
    -0.333_333_333_333_333_3,   0.199_999_999_999_955_16,  -0.142_857_142_846_656_8,
     0.111_111_110_151_870_2,  -0.090_909_045_753_064_9,    0.076_921_831_253_768_92,
    -0.066_645_105_255_089_38,  0.058_581_409_048_663_28,  -0.050_854_078_345_894_84,
     0.039_230_447_784_793_09, -0.019_175_404_711_104_935,
];

/// Chebyshev fit of (asin x − x)/x³ in x² for |x| ≤ 0.0871, error 7·10⁻¹⁸ of x.
#[rustfmt::skip]
const ARCSINE: [f64; 5] = [
    0.166_666_666_666_667_55, 0.074_999_999_994_259_78,  0.044_642_863_181_299_57,
    0.030_379_722_913_968_35, 0.022_705_166_415_250_826,
];

/// Horner's rule; for more than four coefficients applied to the even and the odd ones side by side, because each
/// operation of a single chain would wait for the one before.
#[inline(always)]
pub(crate) fn polynomial<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let chain = |first: usize, step: usize, x: f64| {
        let each = coefficients[first..].iter().step_by(step).rev();
        each.copied()
            .reduce(|sum, next| sum * x + next)
            .unwrap_or(0.0)
    };
    match N {
        0..=4 => chain(0, 1, x),
        _ => chain(0, 2, x * x) + chain(1, 2, x * x) * x,
    }
}

/// Sine and cosine of `high + low`, for |high| ≤ 0.789 and `low` below an ulp of it.
#[inline(always)]
pub(crate) fn small_sine_cosine(high: f64, low: f64) -> (f64, f64) {
    let x2 = high * high;
    let half = 0.5 * x2;
    let sine = high + (high * x2 * polynomial(&SINE, x2) + low * (1.0 - half));
    let leading = 1.0 - half;
    let trailing = ((1.0 - leading) - half) + (x2 * x2 * polynomial(&COSINE, x2) - high * low);
    (sine, leading + trailing)
}

/// sinh and cosh − 1 of `high + low`, for |high| ≤ 0.36.
#[inline(always)]
pub(crate) fn small_hyperbolic(high: f64, low: f64) -> (f64, f64) {
    let x2 = high * high;
    let half = 0.5 * x2;
    let sine = high + (high * x2 * polynomial(&HYPERBOLIC_SINE, x2) + low * (1.0 + half));
    let cosine = half + (x2 * x2 * polynomial(&HYPERBOLIC_COSINE, x2) + high * low);
    (sine, cosine)
}

/// The angle in 0…π/2 with this sine and cosine, neither of them negative.
#[inline(always)]
pub(crate) fn angle(sine: f64, cosine: f64) -> f64 {
    // The tangent of half the angle, or of half its complement if that is smaller.
    let t = lesser(sine, cosine) / (1.0 + greater(sine, cosine));
    let t2 = t * t;
    let twice = 2.0 * t + 2.0 * (t * t2) * polynomial(&ARCTANGENT, t2);
    if sine <= cosine {
        twice
    } else {
        core::f64::consts::FRAC_PI_2 - twice
    }
}

/// The arcsine of |x| ≤ 0.087.
#[inline(always)]
pub(crate) fn small_arcsine(x: f64) -> f64 {
    let x2 = x * x;
    x + x * x2 * polynomial(&ARCSINE, x2)
}

/// 1.5·2⁵²: adding it rounds a number below 2⁵¹ to an integer, which then stands in the lowest bits.
pub(crate) const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// 2^n for an integer n in −1022…1023, given with [`ROUNDER`] added.
#[inline(always)]
pub(crate) fn power_of_two(rounded: f64) -> f64 {
    f64::from_bits((rounded.to_bits().wrapping_add(1023)) << 52)
}

/// The lesser of two numbers, neither of them not-a-number: one instruction.
#[inline(always)]
pub(crate) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers, neither of them not-a-number.
#[inline(always)]
pub(crate) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// `a` where the bits of `mask` are ones, `b` where they are zeros.
#[inline(always)]
pub(crate) fn select(mask: u64, a: f64, b: f64) -> f64 {
    f64::from_bits((a.to_bits() & mask) | (b.to_bits() & !mask))
}
