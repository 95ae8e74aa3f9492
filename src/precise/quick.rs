//! Two words without a branch, for numbers whose size is known to be far from the ends of the doubles: for one as for several side by side.

/// Upper 26 bits and the rest, for numbers below 10³⁰⁰ (Veltkamp).
#[inline(always)]
pub(crate) fn halves(x: f64) -> (f64, f64) {
    let y = 134_217_729.0 * x;
    let upper = y - (y - x);
    (upper, x - upper)
}

/// Product and its rounding error, without a call into the mathematical library where the processor has no fused
/// multiplication (Dekker).
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

/// Sum of two numbers, the first not the smaller in size.
#[inline(always)]
pub(crate) fn ordered_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Square root of a positive `high + low`, to 105 bits.
#[inline(always)]
pub(crate) fn root(high: f64, low: f64) -> (f64, f64) {
    let root = high.sqrt();
    let (square, error) = exact_product(root, root);
    (root, (((high - square) - error) + low) * (0.5 / root))
}
