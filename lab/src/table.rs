//! Reads the committed reference tables: a heading, then rows of cells; doubles in C's hexadecimal notation, true values as decimals.

use spinning_bodies::{Error, Result};

use crate::finite;

/// The rows whose first cell is `wanted`, each converted by `of`.
///
/// # Errors
/// [`Error::AtPlace`] with the number of the line below the heading, for a line with more or fewer cells than N, or one that `of` rejects.
pub(crate) fn rows<const N: usize, T>(
    table: &'static str,
    wanted: impl Fn(&str) -> bool,
    of: impl Fn([&'static str; N]) -> Result<T>,
) -> Result<Vec<T>> {
    let lines = table.lines().skip(1).enumerate();
    let named = lines.filter(|(_, line)| wanted(line.split(',').next().unwrap_or(line)));
    let row = |(place, line): (usize, &'static str)| {
        let cells: Vec<&str> = line.split(',').collect();
        let count = cells.len() as f64;
        let cells = <[&str; N]>::try_from(cells).map_err(|_| Error::Condition {
            condition: "a row must have as many cells as the heading of its table",
            value: count,
        });
        cells.and_then(&of).map_err(|reason| Error::AtPlace {
            place,
            reason: Box::new(reason),
        })
    };
    named.map(row).collect()
}

/// A double, exactly: ±0x1.hhhp±e.
///
/// # Errors
/// [`Error::NotFinite`] for any other text.
pub(crate) fn exact(cell: &str) -> Result<f64> {
    let read = || {
        let (sign, digits) = cell.strip_prefix('-').map_or((1.0, cell), |d| (-1.0, d));
        let (mantissa, exponent) = digits.strip_prefix("0x")?.split_once('p')?;
        let (whole, fraction) = mantissa.split_once('.')?;
        let bits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).ok()?;
        let exponent = exponent.parse::<i32>().ok()? - 4 * i32::try_from(fraction.len()).ok()?;
        let exact = bits < 1 << f64::MANTISSA_DIGITS && (-1000..900).contains(&exponent);
        exact.then(|| sign * bits as f64 * f64::from(exponent).exp2())
    };
    number(read())
}

/// A decimal with a point and up to 38 digits, as the two doubles whose sum is nearest to it.
///
/// # Errors
/// [`Error::NotFinite`] for any other text.
pub(crate) fn decimal(cell: &str) -> Result<[f64; 2]> {
    let read = || {
        let (mantissa, exponent) = cell.split_once('e').unwrap_or((cell, "0"));
        let (_, fraction) = mantissa.split_once('.')?;
        let places = i32::try_from(fraction.len()).ok()? - exponent.parse::<i32>().ok()?;
        let places = usize::try_from(places).ok()?;
        let high: f64 = cell.parse().ok()?;
        // The remainder after the first double, in units of the last decimal place: exact, but for less than one unit.
        let units = |text: &str| text.replacen('.', "", 1).parse::<i128>().ok();
        let rest = units(mantissa)?.checked_sub(units(&format!("{high:.places$}"))?)?;
        let low: f64 = format!("{rest}e-{places}").parse().ok()?;
        Some([high, low])
    };
    let [high, low] = read().unwrap_or([f64::NAN; 2]);
    Ok([number(Some(high))?, number(Some(low))?])
}

fn number(read: Option<f64>) -> Result<f64> {
    finite("a number of a table", read.unwrap_or(f64::NAN))
}

#[cfg(test)]
mod tests {
    use super::{decimal, exact, rows};
    use spinning_bodies::Error;

    #[test]
    fn doubles_and_decimals_are_read_to_the_last_digit() {
        assert_eq!(exact("0x1.8p+0"), Ok(1.5));
        assert_eq!(
            exact("-0x1.fffffffffffffp+10"),
            Ok(-2048.0 * (1.0 - f64::EPSILON / 2.0))
        );
        assert_eq!(exact("0x0.0p+0"), Ok(0.0));
        // 0.1, and what its double lacks: the double is 2⁻⁵⁵ × 3602879701896397, which is 0.2 units of 2⁻⁵⁵ too much.
        assert_eq!(
            decimal("0.1000000000000000000000000000000000"),
            Ok([0.1, -0.4 * 2.0_f64.powi(-56)])
        );
        assert_eq!(decimal("-2.5e-1"), Ok([-0.25, 0.0]));
        assert_eq!(decimal("3.0e0"), Ok([3.0, 0.0]));
    }

    #[test]
    fn other_text_is_refused() {
        for text in [
            "",
            "1.5",
            "0x1.8",
            "0x1p+0",
            "0x1.gp+0",
            "0x1.8p",
            "0x1.123456789abcdef0p+0",
            "0x1.8p+5000",
        ] {
            assert!(
                matches!(exact(text), Err(Error::NotFinite { .. })),
                "{text}"
            );
        }
        for text in [
            "", "1", "inf", "nan", "1.5e", "1.5e40", "1..5", "1.5 ", "0x1.8p+0",
        ] {
            assert!(
                matches!(decimal(text), Err(Error::NotFinite { .. })),
                "{text}"
            );
        }
        let read = |table| rows(table, |name| name == "a", |[_, x]| decimal(x));
        assert_eq!(
            read("name,number\na,1.5\nb,none\na,2.5\n").map(|rows| rows.len()),
            Ok(2)
        );
        for table in [
            "name,number\nb,0.5\na,1.5,2.5",
            "name,number\nb,0.5\na",
            "name,number\nb,0.5\na,none",
        ] {
            assert!(
                matches!(read(table), Err(Error::AtPlace { place: 1, .. })),
                "{table}"
            );
        }
    }
}
