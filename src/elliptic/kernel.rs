//! Sine, cosine and their hyperbolic sisters on a short interval, without a branch, for an argument of two words.

/// Taylor coefficients of (sin x − x)/x³ in x²; the first one left out is 10⁻¹⁹ at π/4.
const SINE: [f64; 8] = [
    -1.0 / 6.0,
    1.0 / 120.0,
    -1.0 / 5040.0,
    1.0 / 362_880.0,
    -1.0 / 39_916_800.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 1_307_674_368_000.0,
    1.0 / 355_687_428_096_000.0,
];

/// Taylor coefficients of (cos x − 1 + x²/2)/x⁴ in x².
const COSINE: [f64; 7] = [
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
];

#[inline(always)]
fn polynomial<const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let mut sum = coefficients[N - 1];
    for i in (0..N - 1).rev() {
        sum = sum * x + coefficients[i];
    }
    sum
}

/// Sine and cosine of `high + low`, for |high| ≤ 0.8 and `low` below an ulp of it.
#[inline(always)]
pub(super) fn sine_cosine(high: f64, low: f64) -> (f64, f64) {
    let x2 = high * high;
    let half = 0.5 * x2;
    let sine = high + (high * x2 * polynomial(&SINE, x2) + low * (1.0 - half));
    let leading = 1.0 - half;
    let trailing = ((1.0 - leading) - half) + (x2 * x2 * polynomial(&COSINE, x2) - high * low);
    (sine, leading + trailing)
}

/// Hyperbolic sine and cosine of `high + low`, for |high| ≤ 0.4; the cosine less 1.
#[inline(always)]
pub(super) fn hyperbolic(high: f64, low: f64) -> (f64, f64) {
    let x2 = high * high;
    let mut sine = -SINE[5];
    let mut cosine = COSINE[4];
    sine = sine.abs();
    for i in (0..5).rev() {
        sine = sine * x2 + SINE[i].abs();
    }
    for i in (0..4).rev() {
        cosine = cosine * x2 + COSINE[i].abs();
    }
    let half = 0.5 * x2;
    let sine = high + (high * x2 * sine + low * (1.0 + half));
    (sine, half + (x2 * x2 * cosine + high * low))
}
