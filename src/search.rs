//! Order and bisection, for whoever needs them.

/// These places in ascending order of the numbers that stand there.
pub(crate) fn ascending<P: AsMut<[usize]>>(mut places: P, numbers: &[f64]) -> P {
    let order = |i: &usize, j: &usize| numbers[*i].total_cmp(&numbers[*j]);
    places.as_mut().sort_by(order);
    places
}

/// The last number found for which a condition holds and the first for which it fails, by bisection between two such numbers: no further apart
/// than `width`, or neighbouring doubles.
pub(crate) fn halved<E>(
    [mut holds, mut fails]: [f64; 2],
    width: f64,
    condition: impl Fn(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    while (fails - holds).abs() > width {
        let middle = 0.5 * (holds + fails);
        if middle == holds || middle == fails {
            break;
        }
        if condition(middle)? {
            holds = middle;
        } else {
            fails = middle;
        }
    }
    Ok([holds, fails])
}
